"""Storage of single elements: every compact form computes what the formula does on coordinates."""

import pickle
from itertools import product as tuples
from random import Random

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield import QuaternionAlgebra, ring
from hfield.core import product
from hfield.core.product import Constants
from hfield.errors import NotInvertibleError
from hfield.fields.base.ring import Ring
from hfield.fields.base.storage.base import Storage
from hfield.fields.base.storage.compact import LARGE
from hfield.fields.base.storage.plain import Plain
from tests.conformance import CONSTANTS, RINGS
from tests.subcases import share_quick, subcases

FIELDS = ("QQ[s]/(s^3-1/2*s-1/3)", "QQ[s]/(s^4-s-1)", "QQ[s]/(s^5-1/3*s+2/5)")


def is_compact(name):
    return not isinstance(QuaternionAlgebra(ring(name), -1, -1).storage, Plain)


# Of the rings that store tuples of coordinates, a few will do; conformance has them all.
EXACT = [
    *(name for name in (*RINGS, *FIELDS) if is_compact(name)),
    *("RR", "CC", "ZZ[a,b,c]", "QQ[x]", "GF(5)[x,y]"),
]
# Constants with denominators, and of the ring's own.
FRACTIONS = {
    "QQ": [("-1/2", "3/5", "2/3"), ("1/4", "-1/9", 0)],
    "QQ(sqrt(-7))": [("1/2+sqrt(-7)/3", "sqrt(-7)", "1/5")],
    "QQ(I)": [("I", "1/2-I/3", 0)],
    "QQ[s]/(s^3-1/2*s-1/3)": [("s/2", "1/3-s^2/5", "s"), ("s", -1, 0)],
    "QQ[s]/(s^5-1/3*s+2/5)": [("s/2", "1/3-s^4/5", "s"), ("s", -1, 0)],
    "QQ(x)": [("1/x", "(x+1)/(x^2+2)", "x/(x-1)"), ("x", "-1", 0)],
    "GF(4)(t)": [("x/t", "t/(t+x)", 1)],
    "GF(9)": [("x", "x+1", "2*x"), ("x", -1, 0)],
    "GF(4)": [("x", "x+1", 1)],
    "GF(2^100)": [("x", "x^99+1", "x^50")],
}
ALGEBRAS = [
    (name, c)
    for name in EXACT
    for c in [(a, b, t) for a, b, t in CONSTANTS] + FRACTIONS.get(name, [])
]


def algebra(name, constants):
    a, b, t = constants
    return QuaternionAlgebra(ring(name), a, b, t)


@pytest.mark.parametrize("name", share_quick(EXACT, 2))
@settings(max_examples=2, deadline=None, derandomize=True)
@given(seed=st.integers(0, 999))
def test_every_operation_is_the_formula(name, seed) -> None:
    F = ring(name)
    for _, constants in (pair for pair in ALGEBRAS if pair[0] == name):
        A = algebra(name, constants)
        how, plain = A.storage, Storage(F, A.constants)
        u, v = (A.random_element(seed + n).coordinates for n in (0, 1))
        p, q = how.encode(u), how.encode(v)
        s = u[0] + v[1]
        found = [
            how.coordinates(x)
            for x in (
                how.product(p, q), how.sum(p, q), how.difference(p, q),
                how.negative(p), how.conjugate(p), how.scaled(p, s),
            )
        ]  # fmt: skip
        expected = [
            plain.product(u, v), plain.sum(u, v), plain.difference(u, v),
            plain.negative(u), plain.conjugate(u), plain.scaled(u, s),
        ]  # fmt: skip
        for x, y in zip(found, expected, strict=True):
            assert all(map(F.equal, x, y))
            assert all(map(same_type, x, y))
        assert F.equal(how.norm(p), product.norm(A.constants, u))
        assert F.equal(how.trace(p), product.trace(A.constants, u))
        assert how.equal(p, q) == plain.equal(u, v)
        scalar, quotient = how.scalar(s), how.divided(p, s)
        assert scalar == how.encode((s, F.zero, F.zero, F.zero)) or not how.is_unique
        assert how.equal(scalar, how.encode((s, F.zero, F.zero, F.zero)))
        assert how.equal(how.whole(5, -3, 0, 2**300), how.encode(tuple(map(F, (5, -3, 0, 2**300)))))
        assert (quotient is None) == (not F.is_unit(s))
        if quotient is not None:
            expected = how.encode(tuple(F.divide(x, s) for x in u))
            assert quotient == expected or not how.is_unique
            assert how.equal(quotient, expected)
        assert how.divided(p, F.zero) is None or F.is_unit(F.zero)
        inverse = how.inverse(p)
        assert (inverse is None) == (not F.is_unit(how.norm(p)))
        if inverse is not None:
            assert how.equal(how.product(p, inverse), how.read((1, 0, 0, 0)))


def same_type(x, y):
    return type(x) is type(y)


@pytest.mark.parametrize("q", [2, 3])
def test_all_elements_and_constants_of_prime_fields(q) -> None:
    elements = list(tuples(range(q), repeat=4))
    for a, t, b in tuples(range(q), repeat=3):
        how = QuaternionAlgebra(f"GF({q})", a, b, t).storage
        c = Constants(a, t, b)
        for u in elements:
            for v in elements:
                expected = tuple(x % q for x in product.multiply(c, u, v))
                assert how.product(u, v) == expected


TIMES = [
    [0, 0, 0, 0],
    [0, 1, 2, 3],
    [0, 2, 3, 1],
    [0, 3, 1, 2],
]  # labels: x is 2 and x² = x + 1 is 3


class Four:
    """Arrays over GF(4), by the table that one writes down by hand."""

    def __init__(self, labels):
        self.labels = np.asarray(labels, dtype=np.uint8)

    def __add__(self, other):
        return Four(self.labels ^ other.labels)

    __sub__ = __add__

    def __mul__(self, other):
        return Four(np.array(TIMES)[self.labels, other.labels])


@pytest.mark.slow
def test_all_elements_and_constants_of_four() -> None:
    """All 64 algebras over GF(4), all 65 536 pairs."""
    F = ring("GF(4)")
    elements = list(tuples(range(4), repeat=4))
    columns = np.array(elements, dtype=np.uint8).T
    left, right = ([Four(c.reshape(shape)) for c in columns] for shape in ((-1, 1), (1, -1)))
    for a, t, b in tuples(range(4), repeat=3):
        how = QuaternionAlgebra(F, *map(F.from_label, (a, b, t))).storage
        expected = product.multiply(Constants(Four(a), Four(t), Four(b)), left, right)
        how.product(elements[0], elements[0])  # the first call makes what the others call
        multiply = how.product
        found = bytes(c for u in elements for v in elements for c in multiply(u, v))
        by_formula = np.stack([x.labels.ravel() for x in expected], axis=1)
        assert found == by_formula.tobytes()


@pytest.mark.parametrize("name", share_quick(EXACT, 4))
@settings(max_examples=2, deadline=None, derandomize=True)
@given(seed=st.integers(0, 999))
def test_equal_elements_made_in_different_ways(name, seed) -> None:
    for _, constants in (pair for pair in ALGEBRAS if pair[0] == name):
        A = algebra(name, constants)
        p, q = A.random_element(seed), A.random_element(seed + 1)
        ways = [
            p, A(*p.coordinates), A(str(p)), (p + q) - q, p.algebra.zero - (-p), p * 1, 1 * p, p + 0,
            (p.conjugate()).conjugate(), p * q - p * (q - 1), pickle.loads(pickle.dumps(p)),
        ]  # fmt: skip
        if q.is_unit():
            ways += [p * q / q, q * (q.inverse() * p)]
        assert all(x == p for x in ways)
        assert len({hash(x) for x in ways}) == 1
        assert len(set(ways)) == 1
        assert (p == q) == all(map(A.ring.equal, p.coordinates, q.coordinates))


NEAR = [LARGE, LARGE - 1, LARGE + 1, 2**255, 2**511, 2**30, 2**62, 1, 0]
NUMBERS = st.builds(
    lambda n, sign, d: sign * n + d,
    st.sampled_from(NEAR),
    st.sampled_from((1, -1)),
    st.integers(-2, 2),
)
DENOMINATORS = st.one_of(st.integers(1, 9), st.sampled_from([LARGE, LARGE + 1, LARGE - 1, 3**200]))


@settings(max_examples=60, deadline=None)
@given(
    numbers=st.tuples(*[NUMBERS] * 8),
    denominators=st.tuples(*[DENOMINATORS] * 8),
    constants=st.sampled_from([(-1, -1, 0), ("-1/2", 3, 1), (LARGE, f"1/{LARGE}", 0)]),
)
def test_where_large_numbers_begin(numbers, denominators, constants) -> None:
    """Python's ints and flint's take turns; the values do not show it."""
    A = algebra("QQ", constants)
    how, plain = A.storage, Storage(A.ring, A.constants)
    u, v = (
        tuple(
            flint.fmpq(n, d)
            for n, d in zip(numbers[k : k + 4], denominators[k : k + 4], strict=True)
        )
        for k in (0, 4)
    )
    p, q = how.encode(u), how.encode(v)
    for operation in ("product", "sum", "difference"):
        found = getattr(how, operation)(p, q)
        expected = getattr(plain, operation)(u, v)
        assert how.coordinates(found) == expected
        assert how.key(found) == how.key(how.encode(expected))
        assert hash(how.key(found)) == hash(how.key(how.encode(expected)))
    assert how.norm(p) == plain.norm(u)
    if plain.norm(u) != 0:
        assert how.coordinates(how.inverse(p)) == plain.inverse(u)
        assert how.product(p, how.inverse(p)) == (1, 0, 0, 0, 1)
        assert {type(x) for x in how.product(p, how.inverse(p))} == {int}
    back = how.difference(how.sum(p, q), q)
    assert how.equal(back, p)
    assert hash(how.key(back)) == hash(how.key(p))


def test_a_ring_whose_elements_know_no_equality() -> None:
    """Only + − × and is_zero are asked of a user's own ring."""

    class Bit:
        def __init__(self, n):
            self.n = n % 2

        def __add__(self, other):
            return Bit(self.n + other.n)

        def __sub__(self, other):
            return Bit(self.n - other.n)

        def __mul__(self, other):
            return Bit(self.n * other.n)

        def __neg__(self):
            return Bit(-self.n)

    class Bits(Ring):
        name, characteristic = "bits", 2

        def __call__(self, x):
            return x if isinstance(x, Bit) else Bit(x)

        def is_zero(self, x):
            return x.n == 0

        def text(self, x, style="plain"):
            return str(x.n)

    A = QuaternionAlgebra(Bits(), 1, 1, 1)
    p, q = A(1, 0, 1, 1), A(0, 1, 1, 0)
    assert p == A(1, 0, 1, 1) != q
    assert hash(p) == hash(p + q - q)
    B = algebra("GF(2)", (1, 1, 1))
    same = B(1, 0, 1, 1) * B(0, 1, 1, 0)
    assert [x.n for x in (p * q).coordinates] == [int(x) for x in same.coordinates]


def test_two_objects_that_are_one_algebra() -> None:
    for name in ("QQ", "GF(9)", "GF(7)", "QQ(x)", "RR", "QQ(I)", "GF(2^100)"):
        A, B = algebra(name, (-1, -1, 0)), algebra(name, (-1, -1, 0))
        p, q = A(1, 2, 3, 4), B(5, 6, 7, 8)
        assert A is not B
        assert p * q == A(1, 2, 3, 4) * A(5, 6, 7, 8)
        assert p + q == q + p == B(6, 8, 10, 12)
        assert hash(p) == hash(B(1, 2, 3, 4))


@pytest.mark.parametrize("name", ["GF(4)", "GF(9)", "GF(25, x^2+2)", "GF(256)", "GF(243)"])
def test_tables_are_the_arithmetic_of_the_field(name) -> None:
    F = ring(name)
    t = F.tables
    assert [F.label(x) for x in t.elements] == list(range(F.order))
    step = 1 if F.order < 30 else 7
    for u in range(0, F.order, step):
        x = t.elements[u]
        assert t.elements[t.negative[u]] == -x
        assert u == 0 or t.elements[t.inverse[u]] == F.inverse(x)
        for v in range(0, F.order, step):
            y = t.elements[v]
            assert t.elements[t.times[u][v]] == x * y
            assert t.elements[t.plus[u][v]] == x + y
            assert t.elements[t.minus[u][v]] == x - y


def test_explain_product(capsys) -> None:
    for name in EXACT:
        algebra(name, (2, 3, 1)).explain_product()
        assert "def product(p, q):" in capsys.readouterr().out
    algebra("QQ", ("-1/2", -1, 0)).explain_product()
    out = capsys.readouterr().out
    assert "a = -2" in out
    assert "b*" not in out


@subcases(
    "name",
    [
        *("QQ", "QQ(sqrt(-7))", "QQ(I)", "QQ[s]/(s^3-2)", "QQ[s]/(s^3+s^2-4*s-1/2)"),
        *(
            "QQ(zeta5)",
            "QQ[s]/(s^5-1/3*s+2/5)",
            "GF(7)",
            "GF(9)",
            "GF(65537)",
            "QQ(x)",
            "ZZ/6",
            "ZZ",
        ),
    ],
)
def test_multiples_and_inverses_are_stored_as_products_are(name) -> None:
    F, rng = ring(name), Random(5)
    A = QuaternionAlgebra(F, -1, F.random(rng) + F(7))
    for _ in range(5):
        p, s = A(*(F.random(rng) for _ in range(4))), F.random(rng)
        assert (s * p)._stored == (p * s)._stored == (A.scalar(s) * p)._stored
        large = s + F(2) ** 300
        assert ((p * large) + large)._stored == (p * A.scalar(large) + A(large, 0, 0, 0))._stored
        if F.is_unit(s):
            assert (p / s)._stored == (p * A.scalar(s).inverse())._stored
        else:
            with pytest.raises(NotInvertibleError, match="cannot invert"):
                p / s
        if p.is_unit():
            assert p * p.inverse() == A.one
            assert p.inverse()._stored == (p.conjugate() * A.scalar(F.inverse(p.norm())))._stored
