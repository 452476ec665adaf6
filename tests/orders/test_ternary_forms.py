"""Ternary forms and orders, against Clifford's table, PARI, and all forms of small discriminant."""

import random
from collections.abc import Iterator
from itertools import product
from typing import Any

import pytest

from hfield import (
    IndefiniteError,
    LatticeError,
    MixedParentsError,
    QuaternionAlgebra,
    RingError,
    ring,
    ternary_form,
)
from tests.orders.random_lattices import moved, random_step
from tests.subcases import first_quick

pari = pytest.importorskip("cypari", reason="cypari is not installed (extra 'oracles')").pari
FIELDS = "QQ", "QQ(sqrt(5))", "QQ(sqrt(-5))", "QQ[s]/(s^3-s^2-2*s+1)"


def random_forms(field: str, count: int, seed: int) -> Iterator[Any]:
    """Forms with small random coefficients."""
    rng, F = random.Random(seed), ring(field)
    basis = F.integral_basis()
    while count:
        coefficients = [sum((w * rng.randint(-3, 3) for w in basis), F(0)) for _ in range(6)]
        try:
            yield ternary_form(coefficients, F)
            count -= 1
        except LatticeError:
            continue


def maps(f: Any, g: Any, m: Any) -> bool:
    """Whether f(v) = g(v·m)."""
    return bool(moved(g, m) == f)


def even_matrix(f: Any) -> Any:
    return pari.matrix(3, 3, [int(x) for row in f.gram_matrix() for x in row])


@pytest.mark.parametrize("field", FIELDS)
def test_the_products_multiply_as_in_the_clifford_algebra(field: str) -> None:
    for f in random_forms(field, 6, 1):
        a, b, c, r, s, t = f.coefficients
        i, j, k = f._clifford
        assert i * i == i * r - b * c
        assert j * j == j * s - a * c
        assert k * k == k * t - a * b
        assert j * k == i.conjugate() * a
        assert k * i == j.conjugate() * b
        assert i * j == k.conjugate() * c
        order = f.order()
        assert i in order
        found = order.discriminant()
        assert found == (abs(f.discriminant()) if field == "QQ" else f.ring.ideal(f.discriminant()))


def test_all_definite_forms_of_small_discriminant() -> None:
    """One from each class, as PARI distinguishes them, in as many genera as there are; orders agree."""
    for disc in (2, 3, 5, 11, 16, 23, 30):
        forms = all_forms(disc)
        keys = {f.reduced() for f in forms}
        apart: list[Any] = []
        for f in forms:
            if not any(pari.qfisom(even_matrix(f), even_matrix(g)) for g in apart):
                apart.append(f)
        assert len(apart) == len(keys)
        assert {f.reduced() for f in apart} == keys
        left = set(keys)
        while left:
            genus = set(next(iter(left)).genus())
            assert genus <= left  # the genera are disjoint, and each is complete
            left -= genus
        for f in keys:
            assert f.reduced() == f
            assert f.automorphism_count() == int(pari.qfauto(even_matrix(f))[0])
            assert f.order().ternary_form() == f
            g = next(iter(keys))
            assert bool(f.order().algebra.isomorphism(g.order().algebra)) or not f.equivalence(g)
            assert bool(f.equivalence(g)) == (f == g)


def all_forms(disc: int) -> list[Any]:
    """All positive forms with a ≤ b ≤ c, |t|, |s| ≤ a, |r| ≤ b, so that abc ≤ disc/2 (Gauss, Seeber)."""
    found = []
    for a in range(1, disc + 1):
        for b in range(a, disc + 1):
            for c in range(b, disc // (a * b) + 1):
                for r, s, t in product(range(-b, b + 1), range(-a, a + 1), range(-a, a + 1)):
                    if 4 * a * b * c + r * s * t - a * r * r - b * s * s - c * t * t == disc:
                        f = ternary_form([a, b, c, r, s, t])
                        if f.is_definite():
                            found.append(f)
    return found


def test_classes_of_forms_are_types_of_orders() -> None:
    for disc, level in ((11, 1), (37, 1), (2, 15), (30, 7)):
        O = QuaternionAlgebra("QQ", *QuaternionAlgebra(disc).constants[::2]).eichler_order(level)
        genus = O.ternary_form().genus()
        assert len(genus) == len(set(genus)) == O.class_set().type_number
        theta = {tuple(T.ternary_theta_series(60)) for T in O.class_set().left_orders()}
        assert {tuple(f.order().ternary_theta_series(60)) for f in genus} == theta


def test_forms_and_their_negatives() -> None:
    f = ternary_form([1, 1, 11, 1, 0, 0])
    other = ternary_form([-x for x in f.coefficients])
    assert other.order() == f.order()
    assert other.is_definite() is f.is_definite() is True
    assert {str(g.reduced()) for g in other.genus()} == {
        str(ternary_form([-x for x in g.coefficients])) for g in f.genus()
    }
    assert not other.equivalence(f)


def test_the_genus_is_what_neighbours_reach() -> None:
    """Neighbours at 3: a lattice and one with an intersection of index 3 are of one genus."""
    f = ternary_form([1, 1, 23, 1, 0, 0])
    genus, seen, todo = f.genus(), {f.reduced()}, [f]
    while todo:
        g = todo.pop()
        for x in product(range(3), repeat=3):
            if any(x) and int(g(*x)) % 3 == 0:
                h = neighbour(g, x)
                if h is not None and h.reduced() not in seen:
                    seen.add(h.reduced())
                    todo.append(h)
    assert seen == set(genus)


def neighbour(f: Any, x: tuple[int, ...]) -> Any:
    """The lattice {v : B(v, x) ≡ 0 mod 3} + ℤ·x/3, with x changed by 3·y to f(x) ≡ 0 mod 9."""
    gram = [[int(c) for c in row] for row in f.gram_matrix()]
    for y in product(range(3), repeat=3):
        z = [a + 3 * b for a, b in zip(x, y, strict=True)]
        if int(f(*z)) % 9 == 0:
            break
    else:
        return None
    pairing = [sum(z[m] * gram[m][n] for m in range(3)) % 3 for n in range(3)]
    if not any(pairing):
        return None
    inside = [v for v in product(range(3), repeat=3) if sum(map(int.__mul__, v, pairing)) % 3 == 0]
    rows = [[3 * c for c in v] for v in inside] + [
        [9 * int(m == n) for n in range(3)] for m in range(3)
    ]
    hermite = pari.mathnf(
        pari.matrix(3, len(rows) + 1, [row[n] for n in range(3) for row in [*rows, z]])
    )
    basis = [[int(hermite[m, n]) for m in range(3)] for n in range(3)]
    values = [int(f(*v)) // 9 for v in basis]
    mixed = [
        sum(u[m] * gram[m][n] * v[n] for m in range(3) for n in range(3)) // 9
        for u, v in ((basis[1], basis[2]), (basis[0], basis[2]), (basis[0], basis[1]))
    ]
    return ternary_form([*values, *mixed])


@pytest.mark.parametrize("field", first_quick([*FIELDS[:2], FIELDS[3]], 2))
def test_equivalence_shows_the_matrix(field: str) -> None:
    rng = random.Random(5)
    F = ring(field)
    w = F.integral_basis()[-1]
    definite = [ternary_form([1, 1, n, 1, 0, 0], F) for n in (w * w + 1, 3)]
    for f in definite:
        assert f.is_definite()
        g = moved(f, random_step(F, rng))
        answer = f.equivalence(g)
        assert answer
        assert maps(f, g, answer.matrix)
        assert not f.equivalence(ternary_form([-x for x in f.coefficients], F))
        if field == "QQ(sqrt(5))":  # units change forms within their class
            g = ternary_form([x * (w * w) for x in f.coefficients], F)
            answer = f.equivalence(g)
            assert answer
            assert maps(f, g, answer.matrix)
    f, g = definite[-2:]
    assert not f.is_equivalent(g)
    assert "discriminants" in f.equivalence(g).reason


def test_indefinite_forms() -> None:
    rng = random.Random(2)
    f = ternary_form([1, 1, -2, 1, 1, 0])
    g = moved(f, random_step(f.ring, rng))
    answer = f.equivalence(g)
    assert answer
    assert answer.matrix is None or maps(f, g, answer.matrix)
    with pytest.raises(IndefiniteError):
        f.reduced()
    assert not f.is_definite()
    assert abs(f.order().ternary_form().discriminant()) == abs(f.discriminant())


def test_forms_are_reduced_over_the_integers_alone() -> None:
    f = ternary_form([1, 1, 1, 0, 0, 0], "QQ(sqrt(2))")
    for act in (f.reduced, f.automorphism_count):
        with pytest.raises(IndefiniteError, match="definite and over ℤ"):
            act()


@pytest.mark.parametrize(
    "field", first_quick(["QQ(sqrt(5))", "QQ(sqrt(-23))", "QQ(sqrt(10))", "QQ(sqrt(-5))"], 2)
)
def test_orders_over_number_fields_and_back(field: str) -> None:
    for f in random_forms(field, 3, 7):
        O = f.order()
        g = O.ternary_form()
        assert g.order().discriminant() == O.discriminant()
        ratio = g.discriminant() / f.discriminant()
        assert f.ring.ideal(ratio) == 1
        assert QuaternionAlgebra.isomorphism(g.order().algebra, O.algebra) is not None
    A = QuaternionAlgebra(field, -1, -1)
    O = A.maximal_order()
    if A.ring.class_group().order == 1 or field == "QQ(sqrt(10))":
        back = O.ternary_form().order()
        assert back.is_maximal()
        if O.is_definite():
            onto = back.algebra.isomorphism(A)
            same = A.order_from_basis([onto(x) for x in back.basis])
            assert O.class_set().type_number == len(O.ternary_form().genus())
            assert any(same.isomorphism(L) for L in O.class_set().left_orders())
            assert same.isomorphism(O)


def test_orders_that_are_not_free() -> None:
    """A suborder ℤ_K·1 + P·x + P·y + P·z has the Steinitz class of P³."""
    K = ring("QQ(sqrt(-5))")
    P = K.primes_above(2)[0]
    A = QuaternionAlgebra(K, -1, -1)
    e, i, j, k = A.basis
    ideal = K.ideal(P)
    O = A.order_from_basis([(K.ideal(1), e), (ideal, i), (ideal, j), (ideal, k)])
    with pytest.raises(LatticeError, match="not a free module"):
        O.ternary_form()
    two = A.order_from_basis([(K.ideal(1), e), (ideal, i), (ideal, j), (ideal * ideal, k)])
    f = two.ternary_form()
    assert K.ideal(f.discriminant()) == two.discriminant()


def test_what_is_no_form() -> None:
    with pytest.raises(LatticeError, match="six"):
        ternary_form([1, 1, 1])
    with pytest.raises(LatticeError, match="degenerate"):
        ternary_form([1, 1, 0, 0, 0, 1])
    with pytest.raises(LatticeError, match="not an integer"):
        ternary_form(["1/2", 1, 1, 0, 0, 0])
    with pytest.raises(RingError, match="integers"):
        ternary_form([1, 1, 1, 0, 0, 0], "GF(7)")
    with pytest.raises(MixedParentsError):
        ternary_form([1, 1, 1, 0, 0, 0]).equivalence(
            ternary_form([1, 1, 1, 0, 0, 0], "QQ(sqrt(2))")
        )
    f = ternary_form([1, 2, 3, -1, 0, 1])
    assert str(f) == "x²+2·y²+3·z²−y·z+x·y"
    assert f.latex() == "x^{2}+2y^{2}+3z^{2}-yz+xy"


@pytest.mark.parametrize("field", [*FIELDS, "QQ[s]/(s-1)", "QQ[s]/(s^3-s-1)"])
def test_forms_are_definite_where_their_orders_are(field: str) -> None:
    F = ring(field)
    found = set()
    for f in (ternary_form([1, 1, 1, 1, 1, 1], F), *random_forms(field, 12, 3)):
        assert f.is_definite() == f.order().is_definite()
        found.add(f.is_definite())
    real = field not in ("QQ(sqrt(-5))", "QQ[s]/(s^3-s-1)")
    assert found == ({True, False} if real else {False})
