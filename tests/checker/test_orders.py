"""Certificates about lattices: what is true is accepted, what is forged is rejected."""

import random
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest

from hfield import QuaternionAlgebra
from hfield.checker.check import ExpectedClaim
from hfield.checker.rejection import Rejected
from tests.checker.cases import Certificate
from tests.checker.order_certificates import established, rejects, true_ones

BOTH = (("proved", "element"), ("refuted", "enumeration"))


def test_the_true_ones_are_accepted() -> None:
    seen = set()
    for data in true_ones():
        found = established(data)
        assert (found.statement, found.verdict, found.field) == (
            data["statement"],
            data["verdict"],
            "QQ",
        )
        assert not found.assumptions
        seen.add((data["evidence"]["kind"], data["verdict"], data["method"]))
        assert established(data, ExpectedClaim((data["statement"],), "QQ", data["algebra"]))
    kinds = ("equivalent", "isomorphic-orders", "embedding")
    assert seen >= {(kind, verdict, how) for kind in kinds for verdict, how in BOTH}
    assert {kind for kind, _, _ in seen} == {"order", "ideal", "class-set", *kinds}


def test_only_the_mass_is_cited() -> None:
    for data in true_ones():
        cited = established(data).theorems
        assert bool(cited) == (data["evidence"]["kind"] == "class-set")


def changed(value: Any) -> Iterator[Any]:
    """Yield copies of JSON data with one number changed, in texts too."""
    if isinstance(value, int):
        yield from (value + 1, -value)
    elif isinstance(value, str):
        for m in re.finditer(r"\d+", value):
            for other in (int(m[0]) + 1, 2 * int(m[0]) + 3, 0):
                yield value[: m.start()] + str(other) + value[m.end() :]
        yield value.replace("left", "right") if "left" in value else value.replace("right", "left")
    elif isinstance(value, list):
        for n, item in enumerate(value):
            yield from ([*value[:n], new, *value[n + 1 :]] for new in changed(item))
        if value:
            yield from (value[1:], [*value, value[0]])
    elif isinstance(value, dict):
        for key, item in value.items():
            if key != "kind":
                yield from ({**value, key: new} for new in changed(item))
            yield {k: v for k, v in value.items() if k != key}


def read(A: QuaternionAlgebra, text: str) -> Any:
    return A.lattice([[Fraction(x) for x in row.split(",")] for row in text.split("|")])


def is_true(data: Certificate) -> bool:
    """Decide the statement of a certificate with the lattices of the package."""
    A = QuaternionAlgebra.from_text(data["algebra"])
    m = re.fullmatch(r"([a-z-]+)\{(.*)\}", data["statement"])
    assert m is not None
    parts = [part.strip() for part in m[2].split(";")]
    lattices = [read(A, part) for part in parts if "|" in part]
    proved = data["verdict"] == "proved"
    if m[1] == "equivalent":
        first, second = lattices
        c = second.colon(first, "right" if parts[0] == "left" else "left")
        sizes = [
            q
            for q in c.reduced_basis()
            if (first * q if parts[0] == "left" else q * first) == second
        ]
        return bool(sizes) == proved
    orders = [L.left_order() for L in (lattices if m[1] != "ideal" else lattices[1:])]
    if orders != (lattices if m[1] != "ideal" else lattices[1:]):
        return False
    O = orders[0]
    if m[1] == "order":
        return O.discriminant() == int(parts[1]) and (len(parts) == 2 or O.is_maximal())
    if m[1] == "ideal":
        I = lattices[0]
        same = (I.left_order() if parts[1] == "left" else I.right_order()) == O
        return bool(same and I.is_invertible() and str(I.norm()) == str(Fraction(parts[3])))
    if m[1] == "isomorphic-orders":
        return bool(O.isomorphism(orders[1])) == proved
    if m[1] == "embedding":
        return bool(O.embeddings(int(parts[1]))) == proved
    return len(O.class_set()) == int(parts[1])


@pytest.mark.slow
def test_no_number_can_be_changed() -> None:
    """Whatever statement is accepted after a change is true; other keys are given away by any change."""
    rng, tried, accepted = random.Random(4), 0, []
    for data in true_ones():
        for key in ("statement", "algebra", "method", "verdict", "assumes", "evidence"):
            every = [new for new in changed(data[key]) if new != data[key]]
            for new in rng.sample(every, min(len(every), 25)):
                forged, tried = {**data, key: new}, tried + 1
                try:
                    established(forged)
                except Rejected:
                    continue
                accepted.append((key, forged))
    assert tried > 2000
    for key, forged in accepted:
        assert key in ("statement", "algebra", "evidence")
        assert key == "evidence" or is_true(forged), forged
    assert sum(key != "evidence" for key, _ in accepted) < tried / 10


def class_set() -> Certificate:
    A = QuaternionAlgebra.from_ramification("QQ", [2, 3, 5])
    data = A.eichler_order(7).class_set().certificate
    assert data is not None
    return data


def restated(data: Certificate, number: int, classes: list[Any]) -> Certificate:
    statement = re.sub(r"; \d+\}$", f"; {number}}}", data["statement"])
    evidence = {"kind": "class-set", "classes": classes}
    return {**data, "statement": statement, "evidence": evidence}


def test_forged_class_sets() -> None:
    data = class_set()
    classes = data["evidence"]["classes"]
    assert established(restated(data, 8, classes[::-1]))
    rejects(restated(data, 8, classes[1:]), "which is not the number")
    rejects(restated(data, 7, classes[1:]), "do not have the mass")
    rejects(restated(data, 9, [*classes, classes[0]]), "in one class")
    rejects(restated(data, 8, [*classes[1:], classes[1]]), "in one class")
    doubled = {
        "den": classes[0]["den"],
        "rows": [[2 * x for x in row] for row in classes[0]["rows"]],
    }
    rejects(restated(data, 9, [*classes, doubled]), "in one class")
    # an ideal of another order, and one that is not locally principal
    A = QuaternionAlgebra.from_text(data["algebra"])
    O = A.eichler_order(7)
    foreign = O.ideals_of_norm(11)[0].hnf
    fat = (O.maximal_overorder() * 1).hnf
    for (den, rows), why in ((foreign, "no right ideal"), (fat, "not locally principal")):
        other = {"den": den, "rows": [list(row) for row in rows]}
        rejects(restated(data, 8, [other, *classes[1:]]), why)
    rejects({**data, "algebra": "(-3,-10|QQ)"})
    rejects({**data, "algebra": "(3,30|QQ)"}, ".")
    rejects({**data, "assumes": []}, "assumes")


def test_large_numbers() -> None:
    p = 5 * 2**248 - 1
    A = QuaternionAlgebra("QQ", -1, -p)
    O = A.extremal_order()
    I = O.random_ideal(2**127 - 1, seed=1)
    P = I.right_order()
    answers = (I.is_principal(), I.equivalence(I.equivalent_of_prime_norm()[0]), O.isomorphism(P))
    for source in (O, I, *answers):
        assert source.certificate is not None
        established(source.certificate)
    assert "maximal" not in O.certificate["statement"]  # the checker proves no such prime
