import itertools
import math
import random

import pytest

from hfield.algebra.structure.elements.properties import is_nilpotent
from hfield.algebra.structure.invariants.centre import centre
from hfield.algebra.structure.invariants.radical import (
    derivations,
    is_central_simple,
    radical,
    to_opposite,
)
from hfield.core.product import Constants, multiply, norm
from hfield.errors import UndecidedError
from hfield.fields.linear_algebra.kernels import apply
from hfield.fields.names import ring
from hfield.fields.quadratic_forms.normal_forms import basis_of
from tests.fields.algebra_cases import constants
from tests.subcases import first_quick, subcases

ALGEBRAS = [
    ("QQ", -1, 0, -1, 0, 3),
    ("QQ", 2, 0, 0, 2, None),
    ("QQ", 0, 0, 0, 3, None),
    ("QQ", "-1/4", 1, 3, 2, None),
    ("GF(2)", 1, 1, 1, 0, 3),
    ("GF(2)", 1, 0, 1, 3, None),
    ("GF(2)", 1, 1, 0, 2, None),
    ("GF(4)", "x", 0, "x+1", 3, None),
    ("GF(9)", 0, 0, "x", 2, None),
    ("GF(2)(t)", "t", 0, "t+1", 2, None),
    ("GF(2)(t)", "t^2", 0, 1, 3, None),
    ("GF(4)(t)", "t", 1, "x", 0, 3),
    ("RR", "sqrt(2)", 0, 0, 2, None),
]


@subcases(("name", "a", "t", "b", "size", "outer"), ALGEBRAS)
def test_the_radical_is_a_nilpotent_ideal(name, a, t, b, size, outer):
    F, c = ring(name), constants(name, a, t, b)
    basis = radical(F, c)
    assert len(basis) == size
    assert is_central_simple(F, c) == (size == 0)
    rng = random.Random(1)
    for q in basis:
        for u in (*basis_of(F), tuple(F.random(rng) for _ in range(4))):
            assert is_nilpotent(F, c, multiply(c, u, q))
            assert is_nilpotent(F, c, multiply(c, q, u))
    total = [sum((x[n] for x in basis[1:]), basis[0][n]) if basis else F.zero for n in range(4)]
    assert F.is_zero(norm(c, tuple(total)))


@subcases(("name", "a", "t", "b", "size", "outer"), ALGEBRAS[:10])
def test_derivations_satisfy_leibniz(name, a, t, b, size, outer):
    F, c = ring(name), constants(name, a, t, b)
    found = derivations(F, c)
    assert outer is None or len(found) == outer
    rng = random.Random(2)
    p, q = (tuple(F.random(rng) for _ in range(4)) for _ in range(2))

    def apply(matrix, v):
        return [
            sum((x * y for x, y in zip(row[1:], v[1:], strict=True)), row[0] * v[0])
            for row in matrix
        ]

    for d in found:
        left = apply(d, multiply(c, p, q))
        terms = zip(
            multiply(c, tuple(apply(d, p)), q), multiply(c, p, tuple(apply(d, q))), strict=True
        )
        assert all(F.equal(x, y + z) for x, (y, z) in zip(left, terms, strict=True))
        assert all(F.is_zero(row[0]) for row in d)  # D(1) = 0


@subcases(("name", "a", "t", "b", "size", "outer"), ALGEBRAS)
def test_the_opposite_algebra(name, a, t, b, size, outer):
    F, c = ring(name), constants(name, a, t, b)
    rng = random.Random(3)
    p, q = (tuple(F.random(rng) for _ in range(4)) for _ in range(2))
    left, right = (
        to_opposite(c, multiply(c, p, q)),
        multiply(c, to_opposite(c, q), to_opposite(c, p)),
    )
    assert all(F.equal(x, y) for x, y in zip(left, right, strict=True))
    assert all(F.equal(x, y) for x, y in zip(to_opposite(c, to_opposite(c, q)), q, strict=True))


def test_rings_that_are_not_fields():
    assert not is_central_simple(ring("ZZ"), constants("ZZ", -1, 0, -1))
    assert len(derivations(ring("ZZ"), constants("ZZ", -1, 0, -1))) == 3


def spanned(R, vectors):
    """Return the keys of all combinations of the vectors over a finite ring."""
    span = {tuple(map(R.key, (R.zero,) * 4)): (R.zero,) * 4}
    for v in vectors:
        sums = [
            tuple(x + r * y for x, y in zip(u, v, strict=True))
            for u in span.values()
            for r in R.elements()
        ]
        span = {tuple(map(R.key, u)): u for u in sums}
    return set(span)


def central(R, c):
    _, i, j, _ = basis_of(R)
    return {
        tuple(map(R.key, q))
        for q in itertools.product(list(R.elements()), repeat=4)
        if multiply(c, q, i) == multiply(c, i, q) and multiply(c, q, j) == multiply(c, j, q)
    }


def nilpotent_ideal(R, c):
    """Return the greatest ideal of nilpotent elements by its definition: q with q·u nilpotent for all u."""
    everyone = list(itertools.product(list(R.elements()), repeat=4))
    key = lambda q: tuple(map(R.key, q))  # noqa: E731
    null = {key(q) for q in everyone if is_nilpotent(R, c, q)}
    return {key(q) for q in everyone if all(key(multiply(c, q, u)) in null for u in everyone)}


@pytest.mark.parametrize("n", [4, 6, 8, 9])
def test_centres_over_residue_rings_by_exhaustion(n):
    R, rng = ring(f"ZZ/{n}"), random.Random(n)
    for _ in range(12 if n < 8 else 4):
        a, t, b = (rng.choice([rng.randrange(n), rng.randrange(0, n, 2), n // 2, 0]) for _ in "atb")
        c = constants(R.name, a, t, b)
        found = centre(R, c)
        assert found[0] == basis_of(R)[0]
        everything = central(R, c)
        assert spanned(R, found) == everything
        orders = (n // math.gcd(n, *(int(x) for x in q)) for q in found)
        assert math.prod(orders) == len(everything)  # a direct sum


@pytest.mark.parametrize("seed", first_quick(range(3), 1))
def test_radicals_over_finite_rings_by_exhaustion(dual_numbers, seed):
    rng = random.Random(seed)
    for R in (ring("ZZ/4"), dual_numbers(ring("GF(2)"))):
        everything = list(R.elements())
        c = Constants(*(rng.choice(everything) for _ in "atb"))
        assert spanned(R, radical(R, c)) == nilpotent_ideal(R, c)


@pytest.mark.parametrize(
    ("name", "a", "t", "b"), [("ZZ/12", -1, 0, -1), ("ZZ/90", 3, 1, 5), ("ZZ/90", 3, 2, 10),
     ("ZZ/1000", 2, 5, 6)],
)  # fmt: skip
def test_radicals_modulo_n_by_the_primes(name, a, t, b):
    """An element is in the radical exactly when its residues modulo the primes are in the radicals."""
    R, c = ring(name), constants(name, a, t, b)
    found = radical(R, c)
    size = math.prod(R.order // math.gcd(R.order, *(int(x) for x in q)) for q in found)
    expected = R.order**4
    for p in (2, 3, 5):
        if R.order % p == 0:
            field, special = ring(f"GF({p})"), constants(f"GF({p})", a, t, b)
            inside = radical(field, special)
            assert spanned(field, ([field(int(x)) for x in q] for q in found)) == spanned(
                field, inside
            )
            expected //= p ** (4 - len(inside))
    assert size == expected


def test_centres_and_radicals_over_domains():
    """A free module of rank one or two that no elimination with units finds."""
    for name, a, t, b, size in (
        ("ZZ", -9, 6, 0, 2),
        ("ZZ", -1, 2, 0, 2),
        ("ZZ", -1, 0, -1, 1),
        ("ZZ[a,b]", "-a^2", "2*a", 0, 2),
        ("QQ[x,y]", "x", "y", 0, 1),
        ("GF(3)[x]", "-x^2", "2*x", 0, 2),
    ):
        R, c = ring(name), constants(name, a, t, b)
        found = centre(R, c)
        assert len(found) == size
        for q in found:
            for u in basis_of(R):
                assert multiply(c, q, u) == multiply(c, u, q)
    # saturated: 3 − i, and not 6 − 2i
    assert [int(x) for x in radical(ring("ZZ"), constants("ZZ", -9, 6, 0))[0]] == [3, -1, 0, 0]
    assert radical(ring("ZZ"), constants("ZZ", -1, 0, -1)) == ()
    for name, a, t, b, size in (
        ("GF(2)[x]", "x", 0, "x+1", 2),
        ("GF(2)[x,y]", "x", 0, "y", 0),
        ("GF(2)[x,y]", "x", 0, "x*y^2", 2),
        ("ZZ[a,b]", "-a^2", "2*a", "b", 2),
    ):
        R, c = ring(name), constants(name, a, t, b)
        found = radical(R, c)
        assert len(found) == size
        for q in found:
            for u in basis_of(R):
                assert is_nilpotent(R, c, multiply(c, u, q))


def test_what_is_not_decided(dual_numbers):
    R = dual_numbers(ring("QQ"))
    with pytest.raises(UndecidedError, match=r"radical over .* is not decided"):
        radical(R, Constants(R.gen, R.zero, R.gen))
    with pytest.raises(UndecidedError, match="generators of a kernel"):
        centre(R, Constants(R.gen, R.zero, R.gen))
    assert len(centre(R, Constants(-R.one, R.zero, -R.one))) == 1
    large = dual_numbers(ring("GF(37)"))
    with pytest.raises(UndecidedError, match="too many"):
        radical(large, Constants(large.gen, large.zero, large.gen))


@pytest.mark.parametrize(("a", "t", "b"), [(-1, 0, -1), (2, 1, 2), (0, 2, 3)])
def test_derivations_modulo_4(a, t, b):
    """They satisfy Leibniz's rule, and are as many as the pairs (D(i), D(j)) that respect the relations."""
    R, c = ring("ZZ/4"), constants("ZZ/4", a, t, b)
    basis = basis_of(R)
    _, i, j, _ = basis
    found = derivations(R, c)
    for d in found:
        for p, q in itertools.product(basis, repeat=2):
            left = apply(d, multiply(c, p, q))
            terms = zip(multiply(c, apply(d, p), q), multiply(c, p, apply(d, q)), strict=True)
            assert left == [x + y for x, y in terms]
    everyone = list(itertools.product(list(R.elements()), repeat=4))

    def plus(*terms):
        return [sum(column[1:], column[0]) for column in zip(*terms, strict=True)]

    def respects_square(x, y, s):  # D(x² − s·x) = 0
        return plus(multiply(c, y, x), multiply(c, x, y)) == [s * v for v in y]

    first = [u for u in everyone if respects_square(i, u, c.t)]
    second = [v for v in everyone if respects_square(j, v, R.zero)]
    pairs = sum(
        # ji = t·j − ij
        plus(multiply(c, v, i), multiply(c, j, u), multiply(c, u, j), multiply(c, i, v))
        == [c.t * x for x in v]
        for u in first
        for v in second
    )
    orders = (4 // math.gcd(4, *(int(x) for row in d for x in row)) for d in found)
    assert math.prod(orders) == pairs
