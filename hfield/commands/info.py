"""``hfield info``: the page about an algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from functools import partial
from textwrap import wrap
from typing import TYPE_CHECKING

from hfield.commands.many import add_inputs, answer_all
from hfield.commands.output import Sink
from hfield.commands.parser import UsageError, add_output
from hfield.commands.status import Waiting
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.description import Description

HELP = (
    "Show what is known of an algebra: its table, centre, radical, whether it is a division algebra or "
    "split (with the isomorphism or the reason), where it ramifies, a maximal order, or counts."
)
DOING = "describing"
EXAMPLES = (
    "hfield info '(-1,-3|QQ)'",
    "hfield info 'H(GF(9))' '[1,t|GF(4)(t))'",
    "hfield info --from algebras.txt --format jsonl",
)
COLUMNS = (
    *("algebra", "field", "commutative", "central_simple", "division", "reason"),
    *("ramified_places", "discriminant", "undecided", "error"),
)
LABEL = 16  # the width of the first column


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    what = "such as '(-1,-3|QQ)', '[1,t|GF(4)(t))' or 'H(GF(9))'"
    add_inputs(parser, "ALGEBRA", what, "plain", "json")
    parser.add_argument(
        "--factors",
        metavar="P,…",
        help="primes of a and b (or of their norms) that you know, separated by commas",
    )
    add_output(parser)


def run(args: Namespace) -> int:
    """Ask everything, and print the pages."""
    from hfield.factorisation import known_primes

    with known_primes(_primes(args.factors), "--factors"):
        return answer_all(args, partial(_describe, args.format), COLUMNS)


def _describe(style: str, text: str) -> tuple[int, dict[str, object], Callable[[Sink], None]]:
    from hfield.algebra import QuaternionAlgebra
    from hfield.commands.count import count_lines, counts
    from hfield.description import describe

    Waiting.at(f"describing {text}")
    A = QuaternionAlgebra.from_text(text)
    description = describe(A)
    counted = counts(A, quick=True) if A.ring.order is not None else None
    data = {**description.to_json(), "counts": counted and counted.to_json()}

    def show(out: Sink) -> None:
        if style == "json":
            out.write_json(data)
            return
        lines = page(description, out.style().width)
        if counted is not None:
            lines += ["", "Counts", *count_lines(counted)]
        out.write("\n".join(lines))

    return 0, data, show


def _primes(text: str | None) -> list[int] | None:
    """Read ``--factors``. Raises :class:`UsageError`; that they are primes is found out later."""
    if text is None:
        return None
    words = [word.strip() for word in text.split(",")]
    if not all(word.isdecimal() and word.isascii() for word in words):
        raise UsageError(f"--factors {shorten(text)!r}: expected primes such as 3,5,1000003")
    return [int(word) for word in words]


def page(d: Description, width: int) -> list[str]:
    """Lay out the page in lines of at most ``width`` characters, tables apart."""
    A = d.algebra
    lines = [*_title(A.name, A.ring.in_words(), width), ""]
    lines += [f"  {',   '.join(shorten(relation, width // 2) for relation in d.relations)}", ""]
    table = [f" {line}" for line in A.table_text("unicode").splitlines()]
    if max(map(len, table)) > width:
        table = ["  The table is wider than this page; `hfield table` prints it."]
    lines += table
    for title, rows in (("Base ring", _field(d)), ("Algebra", _algebra(d)), ("Places", _places(d))):
        if rows:
            lines += ["", "Base field" if title == "Base ring" and A.ring.is_field else title]
            for label, text in rows:
                lines += row(label, text, width)
    return lines


def _title(name: str, ring: str, width: int) -> list[str]:
    """Lay out the first line, which says what the base ring is, in words, and a rule under it."""
    words = shorten(f"over {ring}", width - 20)
    title = f"{shorten(name, width - len(words) - 2)}  {words}"
    return [title, "─" * len(title)]


def row(label: str, text: str, width: int) -> list[str]:
    """Lay out one fact: a label, and its text wrapped beside it, words cut that are too long."""
    room = max(width - LABEL - 3, 24)
    text = " ".join(shorten(word, room) for word in text.split(" "))
    body = wrap(text, room, break_long_words=False, break_on_hyphens=False)
    labels = [label] + [""] * (len(body) - 1)
    return [f"  {head:<{LABEL}} {line}".rstrip() for head, line in zip(labels, body, strict=True)]


def _field(d: Description) -> list[tuple[str, str]]:
    F = d.algebra.ring
    size = "" if F.order is None else f", {F.order} elements"
    rows = [("name", f"{F.name}, characteristic {F.characteristic}{size}")]
    modulus = getattr(F, "modulus", None)
    if isinstance(modulus, str):
        rows.append(("modulus", f"{modulus} ({F.modulus_origin})"))  # type: ignore[attr-defined]
    if not F.is_exact:
        rows.append(("inexact", "floats: nothing is proved over this ring"))
    elif F.is_field:
        rows.append(("level", str(F.level)))
    return rows


def _algebra(d: Description) -> list[tuple[str, str]]:
    F = d.algebra.ring
    rows = []
    if d.normal_form is not None:
        rows.append(("isomorphic to", f"{d.normal_form}, {d.substitution}"))
    if _is_hamilton(d):
        rows.append(("known as", f"H({F.name}), Hamilton's quaternions over {F.name}"))
    rows.append(("commutative", "yes" if d.commutative else "no"))
    rows.append(("centre", _span(d, "center", d.center)))
    if d.radical is not None or "radical" in d.undecided:
        rows.append(("radical", _span(d, "radical", d.radical)))
    if d.central_simple is not None:
        degenerate = "no, it is degenerate: (t² + 4a)·b = 0"
        rows.append(("central simple", "yes" if d.central_simple else degenerate))
    rows.append(("derivations", _derivations(d)))
    rows.append(("division algebra", _division(d)))
    if d.assumes:
        rows.append(("cited", "; ".join(d.assumes)))
    if d.zero_norm is not None:
        rows.append(("zero norm", f"N({d.zero_norm.text('unicode')}) = 0"))
    elif d.division is None or "zero_norm_element" in d.undecided:
        rows.append(("zero norm", _undecided(d, "zero_norm_element", "division")))
    else:
        rows.append(("zero norm", "only 0 has norm 0" if d.division or d.reason else "not known"))
    if d.splitting is not None:
        from hfield.maps import matrix_text

        rows.append(("splitting", f"isomorphic to M₂({F.name}), checked by multiplying out:"))
        for name, matrix in (("i", d.splitting.i), ("j", d.splitting.j)):
            rows.append(("", f"{name} ↦ {matrix_text(F, matrix, 'unicode')}"))
    elif "splitting" in d.undecided:
        rows.append(("splitting", _undecided(d, "splitting")))
    return rows


def _is_hamilton(d: Description) -> bool:
    F, (a, t, b) = d.algebra.ring, d.algebra.constants
    return all(F.is_zero(x) for x in (a + F.one, t, b + F.one))


def _division(d: Description) -> str:
    if d.division is None:
        return _undecided(d, "division")
    level = d.algebra.ring.level
    reason = d.reason.replace(str(level), str(level.value))  # the base field's rows give its reason
    if d.division:
        return f"yes: {reason}" if reason else "yes"
    if not d.algebra.ring.is_field:
        return f"no: {d.algebra.ring.name} is not a field, and its scalars need inverses"
    if d.splitting is None and "splitting" in d.undecided:
        return "no"
    return f"no: {reason}" if reason else "no: it has zero divisors"


def _derivations(d: Description) -> str:
    if d.derivations is None or d.center is None:
        return _undecided(d, "derivations", "center")
    if not d.algebra.ring.is_field:
        return f"generated by {d.derivations}"
    inner = 4 - len(d.center)
    which = "all inner" if inner == d.derivations else f"the inner ones dimension {inner}"
    return f"dimension {d.derivations}, {which}"


def _span(d: Description, name: str, basis: object) -> str:
    from hfield.notation import element_text

    if basis is None:
        return _undecided(d, name)
    assert isinstance(basis, tuple)
    texts = [element_text(d.algebra.ring, q.coordinates, "unicode", "e") for q in basis]
    if not texts:
        return "0"
    if not d.algebra.ring.is_field:
        return f"generated by {', '.join(texts)}"
    return f"spanned by {', '.join(texts)} (dimension {len(texts)})"


def _undecided(d: Description, *names: str) -> str:
    return f"undecided: {next((d.undecided[n] for n in names if n in d.undecided), 'not tried')}"


def _number(d: Description) -> str:
    return str(d.units) if d.units is not None else _undecided(d, "units")


def _places(d: Description) -> list[tuple[str, str]]:
    if "ramified_places" in d.undecided:
        return [("ramified at", _undecided(d, "ramified_places"))]
    if d.ramified is None:
        return []
    rows = [("ramified at", ", ".join(map(str, d.ramified)) or "no place")]
    value = d.discriminant_json()
    shown = " · ".join(value) or "1" if isinstance(value, list) else value
    rows.append(("discriminant", str(shown)))
    if d.order is not None:
        basis = ", ".join(str(q) for q in d.order.basis)
        definite = "inf" in d.ramified
        count = f"{_number(d)} units" if definite else "infinitely many units"
        rows.append(
            ("maximal order", f"ℤ⟨{basis}⟩, discriminant {d.order.discriminant()}, {count}")
        )
    elif "maximal_order" in d.undecided:
        rows.append(("maximal order", _undecided(d, "maximal_order")))
    return rows
