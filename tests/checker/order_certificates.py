"""Certificates about lattices: one of every kind, and ways to write and to judge them."""

import json
import random
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from typing import Any

import pytest

from hfield import QuaternionAlgebra
from hfield.checker.check import Budget, Established, ExpectedClaim, check, check_text
from hfield.checker.rejection import Rejected
from tests.checker.cases import Certificate, certified

ALGEBRAS = ((-1, -11, 0), (-1, -1, 0), ("-1/2", "-5/3", 0), (-1, -3, 1), (2, 3, 0), (-7, -1, 0))
LIPSCHITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"
HURWITZ = "1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1/2,1/2,1/2,1/2"
TWICE = "2,0,0,0 | 0,1,0,0 | 0,0,1,0 | 0,0,0,1"


def established(data: Certificate, expected: ExpectedClaim | None = None) -> Established:
    return check_text(json.dumps(data), expected)


def rejects(data: Certificate, why: str = ".") -> None:
    with pytest.raises(Rejected, match=why):
        established(data)


@cache
def true_ones() -> list[Certificate]:
    """One certificate of every kind, verdict and method, and of different algebras."""
    found: list[Certificate | None] = []
    for a, b, t in ALGEBRAS:
        A = QuaternionAlgebra("QQ", a, b, t)
        O = A.maximal_order()
        x = A(1, 2, 0, 1)
        p = next(p for p in (5, 7, 13) if O.discriminant() % p)
        I, J = O.ideals_of_norm(p)[:2]
        E = A.eichler_order(p)
        found += [O.certificate, E.certificate, I.certificate, J.conjugate().certificate]
        found += [I.equivalence(I * x).certificate, O.isomorphism(x * O * x.inverse()).certificate]
        found += [O.isomorphism(E).certificate]
        R = I.conjugate()
        found.append(R.equivalence(x * R).certificate)
        if "inf" in A.ramified_places():
            found += [E.class_set().certificate, O.class_set().certificate]
            found += [E.embeddings(d).certificate for d in (-3, -4, -7, -8, -15)]
    O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    I, J = O.ideals_of_norm(2)[:2]
    for side in (I, I.conjugate()):
        found += [side.is_principal().certificate, (2 * side).is_principal().certificate]
    found.append(O.isomorphism(I.right_order()).certificate)
    found.append(O.left_ideal([3, "1 + j"]).equivalence(O.left_ideal([9])).certificate)
    assert None not in found
    return [data for data in found if data is not None]


def about(statement: str, evidence: Any, **changes: Any) -> Certificate:
    kind = statement.partition("{")[0]
    return {**certified(statement, "QQ", kind, {"kind": kind, **evidence}), **changes}


def order(rows: str, n: int | str, algebra: str = "(-1,-1|QQ)", more: str = "") -> Certificate:
    return about(f"order{{{rows}; {n}{more}}}", {}, algebra=algebra)


def mutated(rng: random.Random, value: Any) -> Any:
    """Return a copy of JSON data with one change at one place."""
    if isinstance(value, dict):
        key = rng.choice([k for k in value if k != "kind"])
        return {**value, key: mutated(rng, value[key])}
    if isinstance(value, list) and value:
        n, how = rng.randrange(len(value)), rng.randrange(8)
        if how == 0:
            return [*value[:n], *value[n + 1 :]]
        if how == 1:
            return [*value, value[n]]
        return [*value[:n], mutated(rng, value[n]), *value[n + 1 :]]
    if isinstance(value, int):
        return rng.choice([value + 1, value - 1, -value, 2 * value, 0])
    return "1/2" if isinstance(value, str) else [0]


def changed_and_passed(
    seed: int, files: Iterable[Any], each: int, millions: float | None = None
) -> list[int]:
    """Change evidence in one to three places, so often each file; return how many were tried, and passed."""
    rng, found = random.Random(seed), [0, 0]
    for data in files:
        for _ in range(each):
            evidence = data["evidence"]
            for _ in range(rng.randint(1, 3)):
                evidence = mutated(rng, evidence)
            found[0] += 1
            with suppress(Rejected):
                work = Budget(millions) if millions else None
                check({**data, "evidence": evidence}, None, work)
                found[1] += 1
    return found
