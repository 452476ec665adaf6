"""Lattices: the normal form, the arithmetic against plain ways of computing it, short vectors."""

import itertools
import math
import pickle
from collections import Counter
from fractions import Fraction
from random import Random

import pytest

from hfield import GF, H, QuaternionAlgebra
from hfield.errors import (
    IndefiniteError,
    LatticeError,
    MixedParentsError,
    RingError,
    TooLargeError,
)
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders import enumeration
from tests.orders.random_lattices import (
    algebra,
    box,
    coordinates,
    element,
    lattice,
    norm_by_gcd,
    volume,
)

HURWITZ = (2, ((1, 1, 1, 1), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 2)))


def is_hermite(den: int, rows) -> bool:
    entries = [x for row in rows for x in row]
    return (
        den > 0
        and math.gcd(den, *entries) == 1
        and all(rows[r][c] == 0 for r in range(4) for c in range(r))
        and all(rows[c][c] > 0 and 0 <= rows[r][c] < rows[c][c] for c in range(4) for r in range(c))
    )


def test_the_normal_form_is_canonical() -> None:
    rng = Random(1)
    for _ in range(100):
        A = algebra(rng)
        L = lattice(A, rng)
        assert is_hermite(*L.hnf)
        basis = list(L.basis)
        for _ in range(6):  # another basis, and more generators than needed
            m, n = rng.sample(range(4), 2)
            basis[m] = basis[m] + rng.randint(-5, 5) * basis[n]
        same = A.lattice([*basis, basis[0] + basis[1], 3 * basis[2]])
        assert same == L
        assert hash(same) == hash(L)
        assert same.hnf == L.hnf
        assert pickle.loads(pickle.dumps(L)) == L
        assert (
            volume(L)
            == abs(math.prod((fraction(r[n]) for n, r in enumerate(L.hnf[1])), start=Fraction(1)))
            / L.hnf[0] ** 4
        )
    assert H("QQ").lattice(["i", "j", "k", "1/2 + 1/2*i + 1/2*j + 1/2*k"]).hnf == HURWITZ


def test_membership_and_coordinates() -> None:
    rng = Random(2)
    for _ in range(60):
        A = algebra(rng)
        L = lattice(A, rng)
        c = [rng.randint(-20, 20) for _ in range(4)]
        q = sum((n * b for n, b in zip(c, L.basis, strict=True)), A(0))
        assert q in L
        assert [int(str(x)) for x in L.coordinates(q)] == c
        r = q + L.basis[rng.randrange(4)] / rng.choice((2, 3, 5))
        assert r not in L
        assert sum((x * b for x, b in zip(L.coordinates(r), L.basis, strict=True)), A(0)) == r


def test_sums_intersections_and_indices() -> None:
    rng = Random(3)
    for _ in range(60):
        A = algebra(rng)
        L, M = lattice(A, rng), lattice(A, rng)
        total, meet = L + M, L & M
        assert all(q in total for q in (*L.basis, *M.basis))
        assert all(q in L and q in M for q in meet.basis)
        # the second isomorphism theorem: nothing is too small or too large
        assert total.index(L) == M.index(meet)
        assert isinstance(total.index(L), int)
        assert volume(M) / volume(L) == L.index(M)
        assert meet <= L <= total
        assert not total <= meet or L == M


def test_products() -> None:
    rng = Random(4)
    for _ in range(40):
        A = algebra(rng)
        L, M = lattice(A, rng), lattice(A, rng)
        assert L * M == A.lattice([p * q for p in L.basis for q in M.basis])
        x = element(A, rng)
        assert x * L == A.lattice([x * p for p in L.basis])
        assert L * x == A.lattice([p * x for p in L.basis])
        assert L.conjugate() == A.lattice([p.conjugate() for p in L.basis])
        assert 3 * L == L * 3 == A.lattice([3 * p for p in L.basis])
        assert (L / 3) * 3 == L
        assert (L * x).index(L) == 1 / fraction(x.norm()) ** 2


def test_norms_duals_and_gram_matrices() -> None:
    rng = Random(5)
    for _ in range(60):
        A = algebra(rng)
        L = lattice(A, rng)
        assert fraction(L.norm()) == norm_by_gcd(L)
        assert L.gram_matrix() == tuple(
            tuple((p * q.conjugate()).trace() for q in L.basis) for p in L.basis
        )
        D = L.dual()
        pairs = [[fraction((p * q).trace()) for q in D.basis] for p in L.basis]
        assert all(x.denominator == 1 for row in pairs for x in row)
        assert abs(volume(A.lattice(pairs))) == 1
        assert D.dual() == L


def test_left_and_right_orders_and_colons() -> None:
    rng = Random(6)
    for _ in range(40):
        A = algebra(rng)
        L, M = lattice(A, rng), lattice(A, rng)
        left, right = L.left_order(), L.right_order()
        assert left * left == left
        assert left * L == L == L * right
        for side, C in (("left", L.colon(M)), ("right", L.colon(M, "right"))):
            assert (C * M if side == "left" else M * C) <= L
            # nothing larger does: an element that multiplies M into L, up to a prime, is in C
            for q in C.basis:
                for p in (2, 3):
                    x = q / p
                    inside = all((x * m if side == "left" else m * x) in L for m in M.basis)
                    assert inside == (x in C)
        x = element(A, rng)
        assert (x * L).left_order() == x * left * x.inverse()
        assert (x * L).right_order() == right


def test_orders_of_lattices_of_matrices() -> None:
    A = QuaternionAlgebra("QQ", 1, 1)  # M₂(ℚ), where others divide by zero
    O = A.maximal_order()
    assert O.left_order() == O == O.right_order()
    x = A(1, 2, 3, 1)
    assert (O * x).right_order() == x.inverse() * O * x
    e = (1 + A.basis[1]) / 2
    assert e.norm() == 0
    with pytest.raises(LatticeError, match="rank below 4"):
        O * e


def test_reduced_bases_and_short_vectors() -> None:
    rng = Random(7)
    for _ in range(25):
        A = algebra(rng, definite=True)
        L = lattice(A, rng)
        reduced = L.reduced_basis()
        assert A.lattice(reduced) == L
        norms = [fraction(q.norm()) for q in reduced]
        assert norms == sorted(norms)
        # every vector of the box that is short enough is found, with its norm
        n = fraction(L.norm())
        bound = min(norms) * 3
        found = L.elements_of_norm_at_most(bound)
        assert len(set(found)) == len(found)
        assert {q for q in box(L, 2) if fraction(q.norm()) <= bound} <= set(found)
        counts = Counter(fraction(q.norm()) / n for q in found)
        assert L.theta_series(math.floor(bound / n)) == [
            counts.get(m, 0) for m in range(math.floor(bound / n) + 1)
        ]
        least = min(fraction(q.norm()) for q in found if q)
        assert set(L.shortest()) == {q for q in found if fraction(q.norm()) == least}
        for m in sorted(counts)[:4]:
            assert set(L.elements_of_norm(m * n)) == {
                q for q in found if fraction(q.norm()) == m * n
            }
        assert L.elements_of_norm(n / 2) == ()


def test_the_enumeration_is_complete() -> None:
    """Against all vectors of a box that certainly holds the ellipsoid."""
    rng = Random(8)
    for n in (1, 2, 3, 4):
        for _ in range(12):
            m = [[rng.randint(-3, 3) for _ in range(n)] for _ in range(n)]
            gram = [
                [sum(x * y for x, y in zip(u, v, strict=True)) + 3 * (u is v) for v in m] for u in m
            ]
            bound = rng.randint(1, 12)
            box = itertools.product(range(-2, 3), repeat=n)  # gram ≥ 3
            want = {}
            for x in box:
                value = sum(x[r] * x[c] * gram[r][c] for r in range(n) for c in range(n))
                if value <= bound:
                    want[x] = value
            found = dict(enumeration.short_vectors(gram, bound))
            both = found | {tuple(-c for c in x): v for x, v in found.items()} | {(0,) * n: 0}
            assert both == want
            for length in range(1, bound + 1):
                exact = list(enumeration.vectors_of_length(gram, length))
                assert len({tuple(-c for c in x) for x in exact} | set(exact)) == 2 * len(exact)
                assert {x for x, v in want.items() if v == length} == {
                    tuple(s * c for c in x) for x in exact for s in (1, -1)
                }
            assert len(both) == 2 * len(found) + 1


def test_no_vector_is_lost_at_five_hundred_bits() -> None:
    rng = Random(9)
    p = 27 * 2**500 - 1
    A = QuaternionAlgebra("QQ", -1, -p)
    O = A.maximal_order()
    assert O.discriminant() == p
    I = O.random_ideal(2**255 - 19, seed=3)
    reduced = I.reduced_basis()
    assert A.lattice(reduced) == I
    # a vector planted in a lattice is found: x and x times others of much larger norm
    x = I.shortest()[0]
    planted = A.lattice([x, *(x * rng.randrange(2**200) + (2**300) * q for q in reduced[1:])])
    assert x in planted.shortest()
    # in a lattice without small vectors the least norm is that of an exhaustive box of a reduced basis
    least = I.shortest()[0].norm()
    assert all(fraction(q.norm()) >= fraction(least) for q in box(I, 2) if q)


def test_indefinite_lattices_are_reduced_for_a_majorant() -> None:
    A = QuaternionAlgebra("QQ", 3, -(10**20 + 39))
    L = A.maximal_order() * A(10**6, 10**5 + 1, 7, 1)
    assert A.lattice(L.reduced_basis()) == L
    for question in (L.shortest, lambda: L.theta_series(3), lambda: L.elements_of_norm(2)):
        with pytest.raises(IndefiniteError, match="definite algebra"):
            question()


def test_bad_input() -> None:
    A = H("QQ")
    e, i, j, _ = A.basis
    with pytest.raises(LatticeError, match="rank 3"):
        A.lattice([e, i, j, i + j])
    with pytest.raises(LatticeError, match="rank 0"):
        A.lattice([])
    for wrong in (None, "i", i, 3):
        with pytest.raises(LatticeError, match="not a list of elements"):
            A.lattice(wrong)
        with pytest.raises(LatticeError, match="not a list of elements"):
            A.order(wrong)
    for wrong in (-1, "3", None):
        with pytest.raises(LatticeError, match="theta series"):
            A.hurwitz_order().theta_series(wrong)
    with pytest.raises(RingError, match="over QQ"):
        H(GF(7)).lattice([1, 2, 3, 4])
    with pytest.raises(RingError, match="degenerate"):
        QuaternionAlgebra("QQ", 0, 1).lattice([1, 2, 3, 4])
    L = A.lattice(A.basis)
    with pytest.raises(MixedParentsError, match="different algebras"):
        L + QuaternionAlgebra("QQ", -1, -3).lipschitz_order()
    with pytest.raises(LatticeError, match="expected a lattice"):
        L & 3
    with pytest.raises(LatticeError, match="side"):
        L.colon(L, "top")
    with pytest.raises(LatticeError, match="divided by 0"):
        L / 0
    with pytest.raises(TooLargeError, match="represent_integer"):
        L.theta_series(10**5)
    assert all(
        isinstance(error, type) and issubclass(error, ValueError)
        for error in (LatticeError, IndefiniteError, RingError)
    )
    assert coordinates(i) == [0, 1, 0, 0]
