"""How hostile certificates are written: long numbers, long terms, and a file around them."""

import json
from collections.abc import Callable, Iterable, Sequence
from random import Random
from typing import Any

from hfield.checker.budget import bounded
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from tests.checker.cases import Field, certified
from tests.checker.ring_data import Data

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


def proved(statement: str, evidence: Any, field: Field = None, **changes: Any) -> str:
    """Return a file about one ring, by its data or a name that the package reads, or about all."""
    algebra = changes.pop("algebra", None)
    method = changes.pop("method", evidence["kind"])
    with bounded():  # the data may be too dear to be read; then any name will do
        data = certified(statement, field, method, evidence, algebra)
    return written({**data, **changes})


def certificate(statement: str, evidence: Any, method: str = "identity", **changes: Any) -> str:
    """Return a file about all fields, whatever rings the statement names."""
    data = certified("s == s", None, method, evidence)
    return written({**data, "statement": statement, **changes})


def fact_about_norms(reasons: Sequence[Data], data: Data, constant: str = "0") -> str:
    """Return an implication with facts about the norms of some algebras over a ring."""
    facts = [{"form": "norm", **reason} for reason in reasons]
    own = {"characteristic": 0, "zero": ["s"], "relations": [], "member": "0"}
    items = [{**own, "cofactors": ["0"], "denominator": 1}]
    evidence = {"kind": "implication", "facts": facts, "items": items}
    return proved(f"s == {constant} => t == 0", evidence, data)


def name_of(data: Data) -> str:
    """Return the name that the checker writes; any, if these are the data of no ring or are too dear."""
    try:
        with bounded():
            return read_ring(data).name
    except Rejected:
        return "F"
