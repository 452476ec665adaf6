"""What is true of the words of the ledger's vocabulary over the fields known here, from the literature.

The level of a field is the least number of squares with the sum −1: of ℚ(√−m) it is 1, 2 or 4 (Lam,
*Introduction to Quadratic Forms over Fields*, XI.2.4), of GF(q) 1 or 2, of F(t) that of F.
"""

import re
from collections.abc import Callable

from tests.adversary.meaning import read_claim
from tests.adversary.scalars import named
from tests.adversary.small_rings import Table

INFINITE = 10**9
LEVELS = {
    "QQ": INFINITE,
    "RR": INFINITE,
    "QQ(sqrt(2))": INFINITE,
    "QQ(sqrt(5))": INFINITE,
    "QQ(x)": INFINITE,
    "CC": 1,
    "QQ(I)": 1,
    "QQ(I)(x)": 1,
    "QQ(sqrt(-2))": 2,
    "QQ(sqrt(-3))": 2,
    "QQ(sqrt(-5))": 2,
    "QQ(sqrt(-6))": 2,
    "QQ(sqrt(-7))": 4,
    "QQ(sqrt(-15))": 4,
}


def order(field: str) -> int | None:
    """Return the number of elements of GF(q), None for other fields."""
    m = re.fullmatch(r"GF\((\d+)\)", field)
    return None if m is None else int(m[1])


def characteristic(field: str) -> int | None:
    """Return the characteristic of a field known here."""
    m = re.match(r"GF\((\d+)\)", field)
    if m is None:
        return 0 if field in LEVELS else None
    q = int(m[1])
    return next(p for p in range(2, q + 1) if q % p == 0)


def level(field: str) -> int | None:
    """Return the level."""
    m = re.fullmatch(r"GF\((\d+)\)(\([a-z]\))?", field)
    if m is None:
        return LEVELS.get(field)
    return 2 if int(m[1]) % 4 == 3 else 1


def _division(field: str, parts: list[str]) -> bool | None:
    found = level(field)
    return None if found is None else found > 2


def _level_above(field: str, parts: list[str]) -> bool | None:
    found = level(field)
    return None if found is None or not parts[0].isdigit() else found > int(parts[0])


def _formally_real(field: str, parts: list[str]) -> bool | None:
    found = level(field)
    return None if found is None else found == INFINITE


def _norm_criterion(field: str, parts: list[str]) -> bool | None:
    if parts == ["<"]:
        return False if characteristic(field) == 0 else None
    return True if level(field) == INFINITE else None


def _modulus_exists(field: str, parts: list[str]) -> bool | None:
    p = characteristic(field)
    if p is None:
        return None
    return p == 2 or field in ("RR", "CC")  # elsewhere some sum of four squares is not a square


def _modulus_law(field: str, parts: list[str]) -> bool | None:
    p, s = characteristic(field), level(field)
    if parts == ["+"]:  # √1 would be 2·√1
        return False
    return None if p is None or s is None else p == 2 or s > 1


def _centre(field: str, parts: list[str]) -> bool | None:
    p = characteristic(field)
    if p is None or not parts[0].isdigit():
        return None
    return (p == int(parts[0])) == (p == 2)


def _basis(field: str, parts: list[str]) -> bool | None:
    p = characteristic(field)
    rows = [[int(x) for x in part.split(",")] for part in parts[1:]]
    n = int(parts[0])
    if p is None:
        return None
    if len(rows) != n or any(len(r) != n for r in rows):
        return False
    det = _determinant(rows)
    return det % p != 0 if p else det != 0


def _determinant(rows: list[list[int]]) -> int:
    if not rows:
        return 1
    total = 0
    for n, c in enumerate(rows[0]):
        total += (-1) ** n * c * _determinant([r[:n] + r[n + 1 :] for r in rows[1:]])
    return total


def _determined(field: str, parts: list[str]) -> bool | None:
    return parts[0] == "all" or (parts[0] == "constant" and parts[1] == "1")


def _last_argument(field: str, parts: list[str]) -> bool | None:
    return parts[0] == "4"


WORDS: dict[str, Callable[[str, list[str]], bool | None]] = {
    "division": _division,
    "level-above": _level_above,
    "formally-real": _formally_real,
    "norm-criterion": _norm_criterion,
    "modulus-exists": _modulus_exists,
    "modulus-law": _modulus_law,
    "centre": _centre,
    "basis": _basis,
    "determined-by": _determined,
    "curried-linear": lambda field, parts: True,
    "last-argument": _last_argument,
}
SOME_FIELDS = ("QQ", "GF(2)", "GF(3)", "GF(5)", "RR", "CC", "QQ(sqrt(-7))")


def split(text: str) -> tuple[str, list[str]]:
    """Return a word and the parts between its braces."""
    word, _, rest = text.strip().partition("{")
    if not rest:
        return word.strip(), []
    parts, depth = [""], 0
    for char in rest.rstrip()[:-1]:
        depth += (char in "{([") - (char in "])}")
        if char == ";" and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return word.strip(), [part.strip() for part in parts]


def is_word(text: str) -> bool:
    """Tell whether a text is one of the ledger's vocabulary."""
    word = split(text)[0]
    return word in WORDS or word in (
        *("every", "implies", "iff", "not-everywhere", "over", "angles", "citing"),
    )


def truth_over(text: str, field: str) -> bool | None:
    """Tell whether a statement of any kind is true of H over a field; None where it is not known here."""
    if not is_word(text):
        return _truth_of_statement(text, field)
    word, parts = split(text)
    if word in WORDS:
        return WORDS[word](field, parts)
    if word == "over":
        return truth_over(parts[1], "".join(parts[0].split()))
    if word == "citing":
        return truth_over(parts[1], field)
    if word == "not-everywhere":
        fails = truth_over(parts[0], field)
        return None if fails is None else not fails
    found = [truth_over(part, field) for part in parts]
    if word == "angles" and field != "RR":
        return found[0]
    if word in ("every", "angles"):
        return _all(found)
    if None in found:
        return None
    return (not found[0] or found[1]) if word == "implies" else found[0] == found[1]


def _truth_of_statement(text: str, field: str) -> bool | None:
    from tests.adversary.falsify import is_true, one_place, sampled, true_at

    ring = named(field)
    if ring is None:
        return None
    if isinstance(ring, Table):
        return is_true(read_claim(text, None, one_place(ring)), ring)
    import random

    claim = read_claim(text, None, ring)
    if not claim.given and not claim.bound:
        return true_at(claim, ring, {})
    return False if sampled(claim, ring, random.Random(0), 40) is not None else None


def truth_everywhere(text: str) -> bool | None:
    """Tell whether a statement is true of all fields at once, as far as the fields known here tell."""
    word, parts = split(text) if is_word(text) else ("", [])
    if word == "not-everywhere":
        return True if truth_everywhere(parts[0]) is False else None
    if word == "every":
        return _all([truth_everywhere(part) for part in parts])
    if word == "angles":  # of all fields at once what is said of RR is said
        return _all([truth_everywhere(parts[0]), *(truth_over(part, "RR") for part in parts[1:])])
    if word == "over":
        return truth_over(text, "")
    return False if False in [truth_over(text, f) for f in SOME_FIELDS] else None


def _all(found: list[bool | None]) -> bool | None:
    return False if False in found else (None if None in found else True)
