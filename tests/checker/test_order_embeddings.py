"""Certificates of optimal embeddings in indefinite orders: all orbits, none, and what is refused."""

from contextlib import suppress
from itertools import product
from typing import Any

import pytest

from hfield import LatticeError, Order, QuaternionAlgebra, ring
from hfield.checker.check import Rejected
from hfield.checker.orders.embeddings import (
    _class_number,
    _is_square,
    _lifted,
    _local_number,
    _roots,
)
from hfield.core.factorisation import factorise
from hfield.orders.local_squares import is_square_modulo
from tests.checker.cases import Certificate
from tests.checker.order_certificates import changed_and_passed, established, rejects
from tests.subcases import subcases

DISCRIMINANTS = [d for d in range(-60, 0) if d % 4 < 2]


def order(D: int, N: int = 1) -> Order:
    A = QuaternionAlgebra.from_ramification("QQ", list(factorise(D)) if D > 1 else [])
    return A.eichler_order(N)


def certificate(O: Order, d: int) -> Certificate:
    found = O.embeddings(d).claim_of_orbits()
    assert found.why_no_certificate is None, d
    assert found.certificate is not None
    return found.certificate


@subcases("D, N", [(6, 1), (6, 5), (10, 9), (1, 1), (1, 8)])
def test_all_orbits_are_certified(D: int, N: int) -> None:
    """The formula of the checker and the enumeration agree, at powers of primes and for conductors too."""
    O = order(D, N)
    for d in DISCRIMINANTS[-12:] if D > 1 else (-3, -4, -12, -16):
        data = certificate(O, d)
        word, _, inside = data["statement"].partition("{")
        if not O.embeddings(d):
            assert (word, data["verdict"]) == ("embedding", "refuted")
            assert (D, N) != (1, 1)
        else:
            assert word == "embedding-orbits"
            assert inside[:-1].split("; ")[1:] == [str(d), str(O.embeddings(d).orbits)]
        assert established(data)


def test_false_numbers_and_points_are_refused() -> None:
    O = order(6, 5)
    data, G = certificate(O, -24), O.norm_one_group()
    evidence = data["evidence"]
    elements = evidence["elements"]
    assert len(elements) == 4

    def forged(**changes: Any) -> Certificate:
        return {**data, "evidence": {**evidence, **changes}}

    def written(q: Any) -> list[str]:
        return [str(c) for c in q.coordinates]

    first = O.algebra([*elements[0]])
    for n in (0, 2, 4, 16, -8):
        rejects(
            {**data, "statement": data["statement"].replace("; 8}", f"; {n}}}")}, "another number"
        )
    for d in (-19, -4, -3, 5, -6):
        rejects({**data, "statement": data["statement"].replace("; -24;", f"; {d};")})
    rejects(forged(elements=elements[1:]), "not half of the number")
    rejects(forged(elements=[*elements[:3], elements[0]]), "to that of another one")
    rejects(forged(elements=[written(first.conjugate()), *elements[1:]]), "on the sheet")
    rejects(forged(elements=[written(first / 2), *elements[1:]]), "not in the order")
    rejects(forged(elements=[written(2 * first), *elements[1:]]), "another discriminant")
    g = next(g for g in G.generators if g * first != first * g)
    rejects(forged(elements=[written(g * first * g.conjugate()), *elements[1:]]), "in the domain")
    shifted = [[str(q) for q in (O.algebra(x) + 7).coordinates] for x in map(tuple, elements)]
    assert established(forged(elements=shifted))  # the same embeddings
    rejects(forged(units=evidence["units"][1:]))
    sector = G.domain(G.cm_points(-4)[0])
    center, units = written(sector.center_element), list(map(written, sector.polygon.units))
    rejects(forged(center=center, units=units), "this is a sector")
    rejects({**data, "assumes": data["assumes"][:1]}, "assumes")
    other = QuaternionAlgebra(6).maximal_order()
    rows = data["statement"].partition("{")[2].split(";")[0]
    rejects({**data, "statement": data["statement"].replace(rows, str(other)[2:-1])})


def test_points_on_sides_are_compared_with_their_images() -> None:
    """The images of a point on the boundary are no further orbits."""
    O = order(6)
    D = O.norm_one_group().domain()
    found = [d for d in DISCRIMINANTS if O.embeddings(d)]
    compared = 0
    for d in found:
        data = certificate(O, d)
        elements = [O.algebra(tuple(x)) for x in data["evidence"]["elements"]]
        for x, side in product(elements, D.sides):
            y = side.element * x * side.element.conjugate()
            v = D.polygon.plane.vector(y - y.trace() / 2)
            if y != x and D.polygon.beyond(v) is None and len(elements) > 1:
                others = [z for z in elements if z != x][: len(elements) - 2]
                forged = [[str(c) for c in z.coordinates] for z in (x, y, *others)]
                rejects(
                    {**data, "evidence": {**data["evidence"], "elements": forged}},
                    "to that of another one",
                )
                compared += 1
    assert compared


def test_a_prime_that_rules_nothing_out_is_refused() -> None:
    """What the checker accepts of all primes is that there is none: it agrees with the enumeration."""
    for D, N in ((6, 5), (10, 9), (1, 8)):
        O = order(D, N)
        genuine = next(certificate(O, d) for d in (-11, -3, -7, -15) if not O.embeddings(d))
        start = genuine["statement"].rpartition(";")[0]
        assert genuine["verdict"] == "refuted"
        for d in DISCRIMINANTS[-14:]:
            ruled_out = False
            for p in (2, 3, 5, 7, 4, 1):
                data = {**genuine, "statement": f"{start}; {d}}}"}
                data["evidence"] = {"kind": "embedding", "prime": p}
                with suppress(Rejected):
                    ruled_out |= bool(established(data))
            assert ruled_out == (not O.embeddings(d)), (D, N, d)
        rejects({**genuine, "evidence": {"kind": "embedding"}}, "'prime' or 'basis'")
    # an order that is not maximal at 3, where its symbol is −1
    maximal = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    smaller = maximal.algebra.order(["i", *(3 * q for q in maximal.basis)])
    data = smaller.embeddings(-4).certificate
    forged = {"kind": "embedding", "prime": 3}
    for d in (-4, -3, -8):
        statement = data["statement"].replace("; -4}", f"; {d}}}")
        rejects({**data, "statement": statement, "verdict": "refuted", "evidence": forged})


def test_no_number_can_be_changed() -> None:
    files = [certificate(order(6), -24), certificate(order(1, 8), -7)]
    tried, passed = changed_and_passed(3, files, 40)
    assert passed < tried / 5


def test_numbers_of_the_checker_against_lists() -> None:
    for p, e in ((2, 1), (2, 2), (2, 3), (2, 4), (3, 1), (3, 2), (3, 3), (5, 2)):
        for d in (d for d in range(-80, 80) if d % 4 < 2 and d):
            t = d % 2
            listed = [x for x in range(p**e) if (x * x - t * x + (t - d) // 4) % p**e == 0]
            assert sorted(_roots(d, p, e)) == listed
            assert _is_square(d, p, e) == bool(listed)
            assert sorted(_lifted(d, p, e, _roots(d, p, e))) == sorted(_roots(d, p, e + 1))
            squares = {x * x % p**e for x in range(p**e)}
            assert is_square_modulo(d, p, e) == (d % p**e in squares)
    # where the algebra ramifies: split, ramified, inert, and with a conductor
    assert [_local_number(d, 2, 1, -1) for d in (-7, -8, -3, -12, -28)] == [0, 1, 2, 0, 0]
    assert [_local_number(d, 3, 1, -1) for d in (-8, -3, -4, -27, -36)] == [0, 1, 2, 0, 0]
    # h(−163) = 1, h(−23) = 3, h(−47) = 5, h(−84) = 4, h(−12) = h(−27) = h(−28) = 1, h(−63) = 4
    known = {-3: 1, -4: 1, -12: 1, -27: 1, -28: 1, -23: 3, -47: 5, -84: 4, -163: 1, -63: 4}
    assert {d: _class_number(d) for d in known} == known


def test_where_there_is_no_certificate() -> None:
    """Orders that are not Eichler, definite algebras, and other bases."""
    A = QuaternionAlgebra(6)
    O = A.maximal_order()
    smaller = A.order([2 * q for q in O.basis])
    found = smaller.embeddings(-96).claim_of_orbits()
    assert found.certificate is None
    assert "in Eichler orders" in str(found.why_no_certificate)
    definite = QuaternionAlgebra("QQ", -1, -11).maximal_order().embeddings(-4)
    with pytest.raises(LatticeError, match="in indefinite algebras only"):
        definite.claim_of_orbits()
    K = ring("QQ(sqrt(5))")
    B = QuaternionAlgebra.from_ramification(K, [K.real_places()[0], K.primes_above(2)[0]])
    with pytest.raises(LatticeError, match="over ℤ only"):
        B.maximal_order().embeddings(-3).claim_of_orbits()
