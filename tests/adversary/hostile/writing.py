"""How hostile certificates are written: long numbers, long terms, and a file around them."""

import json
from collections.abc import Callable, Iterable
from random import Random
from typing import Any

from tests.certificates.cases import certified

Hostile = tuple[Callable[[int], str], int, int]  # a file of a size, a small one, and a large one

IDENTITY = {"kind": "identity"}
LONG = 3_900  # digits, as many as are read with some room
LENGTH = 19_000  # characters of a statement, likewise


def number(digits: int, seed: int = 0) -> int:
    """Return a number of that many digits."""
    return Random(f"{seed} {digits}").randrange(10 ** (digits - 1), 10**digits)


def ratio(digits: int, seed: int = 0) -> str:
    """Return a fraction of two such numbers."""
    return f"{number(digits, seed)}/{number(digits, -1 - seed)}"


def joined(terms: Iterable[str], sign: str = "+") -> str:
    """Return terms joined by a sign, with parentheses so that the tree is not high."""
    parts = list(terms)
    while len(parts) > 50:
        parts = [f"({sign.join(parts[k : k + 50])})" for k in range(0, len(parts), 50)]
    return sign.join(parts)


def repeated(text: str, sign: str, n: int, most: int = LENGTH) -> str:
    """Return terms joined by a sign, n of them or as many as a statement holds."""
    return joined([f"({text})"] * max(1, min(n, most // (len(text) + len(sign) + 3))), sign)


def written(data: Any) -> str:
    return json.dumps(data, separators=(",", ":"))


def proved(statement: str, evidence: Any, field: str | None = None, **changes: Any) -> str:
    algebra = changes.pop("algebra", None)
    method = changes.pop("method", evidence["kind"])
    return written({**certified(statement, field, method, evidence, algebra), **changes})
