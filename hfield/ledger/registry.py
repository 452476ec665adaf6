"""The registry of claims: chapter 1, and claims of other packages by entry points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from importlib.metadata import entry_points

from hfield.errors import HFieldError
from hfield.ledger.chapter1 import CLAIMS
from hfield.ledger.claim import Claim
from hfield.ledger.selection import in_section

_POLISH = {
    "twierdzenie": "theorem",
    "lemat": "lemma",
    "definicja": "definition",
    "wniosek": "corollary",
}
_POLISH |= {"przykład": "example", "przyklad": "example", "tabela": "table", "tablica": "table"}


@lru_cache(maxsize=1)
def claims() -> tuple[Claim, ...]:
    """Return all claims by section, including those of other packages.

    Other packages add theirs as entry points ``hfield.claims``, in any order. Sections that are not numbers
    come last.
    """
    return tuple(sorted((*CLAIMS, *_foreign()), key=_place))


def _place(claim: Claim) -> tuple[bool, list[int]]:
    numbers = claim.section.split(".")
    known = all(number.isdigit() for number in numbers)
    return not known, [int(number) for number in numbers] if known else []


def _foreign() -> Iterator[Claim]:
    for point in entry_points(group="hfield.claims"):
        yield from point.load()


def find_all(name: str) -> list[Claim]:
    """Return the claims of the thesis with a name, which may be a claim's id, numbered words such as "theorem
    3", or a section.

    >>> [claim.id for claim in find_all("twierdzenie 3")]
    ['C1.3.1-z']
    >>> [claim.id for claim in find_all("definition 2")], len(find_all("1.3.1"))
    (['C1.3.1-b'], 27)

    Raises :class:`UnknownClaimError`.
    """
    wanted = _in_english(name)
    of_kind = [
        claim
        for claim in claims()
        if claim.kind.replace(" ", "-") == wanted and wanted[-1].isdigit()
    ]
    if wanted[:1].isdigit():
        return in_section(name, claims())
    return of_kind or [find(name)]


def _in_english(name: str) -> str:
    """Return a name in the ledger's spelling: lower case, hyphens, the thesis's words in English."""
    if not isinstance(name, str):
        raise UnknownClaimError(
            f"a claim is named by a text such as 'theorem-3', not {name!s}; fields are field=…"
        )
    words = name.strip().lower().replace(" ", "-").split("-")
    return "-".join([_POLISH.get(words[0], words[0]), *words[1:]])


def find(name: str, ledger: Sequence[Claim] | None = None) -> Claim:
    """Return the claim with this id or name, of the thesis if no ledger is given.

    Raises :class:`UnknownClaimError`.
    """
    wanted = name.strip().lower()
    among = claims() if ledger is None else ledger
    known_by = _spellings() if ledger is None else _by_spelling(ledger)
    places = [known_by[word] for word in (wanted, _in_english(name)) if word in known_by]
    if places:
        return among[min(places)]
    from difflib import get_close_matches

    known = [text for claim in among for text in (claim.id, claim.name)]
    close = get_close_matches(name, known, 5, 0.3) or get_close_matches(wanted, known, 5, 0)
    listed = "; `hfield claims` lists all" if ledger is None else ""
    raise UnknownClaimError(
        f"there is no claim {name!r}; the nearest are {', '.join(close)}{listed}"
    )


@lru_cache(maxsize=1)
def _spellings() -> dict[str, int]:
    return _by_spelling(claims())


def _by_spelling(ledger: Sequence[Claim]) -> dict[str, int]:
    """Return the position of the first claim with each id or name, in lower case."""
    out: dict[str, int] = {}
    for n, claim in enumerate(ledger):
        out.setdefault(claim.id.lower(), n)
        out.setdefault(claim.name.lower(), n)
    return out


class UnknownClaimError(HFieldError, LookupError):
    """A claim id or name that is not in the ledger; the message lists the nearest ones.

    >>> issubclass(UnknownClaimError, LookupError)
    True
    """
