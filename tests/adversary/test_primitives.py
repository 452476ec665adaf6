"""Each primitive of the checker against flint, on hostile sizes.

Results are compared as the checker reads flint's texts, so that nothing depends on how either of them
keeps its numbers.
"""

import random
from fractions import Fraction
from math import gcd, isqrt, prod

import flint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield.checker.polynomials import (
    MAX_EXPONENT,
    MAX_TEXT,
    Names,
    add,
    divide,
    is_constant,
    modulo,
    multiply,
)
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.finite import is_prime
from tests.checker.ring_data import finite, read_field
from tests.subcases import subcases

SETTINGS = settings(max_examples=40, derandomize=True, deadline=None, database=None)
VARIABLES = ("q[0]", "q[3]", "s", "sqrt(2)", "x")
TREES = (
    *(("index", ("name", "q"), n) for n in (0, 3)),
    ("name", "s"),
    ("call", "sqrt", (("num", 2),)),
    ("name", "x"),
)
NAMES = Names(TREES)
CONTEXT = flint.fmpz_mpoly_ctx.get([f"v{n}" for n in range(5)], flint.Ordering.degrevlex)

numbers = st.one_of(
    st.integers(-9, 9), st.integers(-(2**70), 2**70), st.sampled_from([2**64, -(2**63), 10**60])
)
exponents = st.tuples(*[st.sampled_from([0, 0, 0, 1, 2, 3, 17, 255, 256, 4095, 32767])] * 5)
polynomials = st.dictionaries(exponents, numbers, max_size=6)


def flinted(f):
    return CONTEXT.from_dict({m: c for m, c in f.items() if c})


def text(f):
    """A polynomial of flint's as the checker reads it."""
    out = []
    for m, c in f.to_dict().items():
        factors = [f"{v}**{e}" for v, e in zip(VARIABLES, m, strict=True) if e]
        out.append(f"{'-' if c < 0 else '+'} {abs(int(c))}" + "".join(f"*{x}" for x in factors))
    return " ".join(out) or "0"


def checkers(f):
    return NAMES.read(text(flinted(f)), "f")


@SETTINGS
@given(polynomials, polynomials, numbers, st.sampled_from([2, 3, 4, 15, 2**61 - 1]))
def test_polynomials_add_multiply_and_reduce(f, g, c, p):
    x, y, u, v = flinted(f), flinted(g), checkers(f), checkers(g)
    assert add(u, v, c) == NAMES.read(text(x + c * y), "sum")
    assert multiply(u, v) == NAMES.read(text(x * y), "product")
    reduced = CONTEXT.from_dict({m: int(k) % p for m, k in x.to_dict().items() if int(k) % p})
    assert modulo(u, p) == NAMES.read(text(reduced), "reduced")
    assert modulo(u, 0) == u
    assert is_constant(u) == (x.is_constant() and x != 0)


@SETTINGS
@given(polynomials, polynomials, polynomials)
def test_polynomials_divide_exactly_or_not_at_all(f, g, h):
    x, y, z = flinted(f), flinted(g), flinted(h)
    if y == 0:
        return
    v = checkers(g)
    assert divide(NAMES.read(text(x * y), "f"), v) == checkers(f)
    quotient, rest = divmod(x * y + z, y)
    mine = divide(NAMES.read(text(x * y + z), "f"), v)
    assert mine == (NAMES.read(text(quotient), "quotient") if rest == 0 else None)


@pytest.mark.parametrize("variable", VARIABLES)
def test_no_product_carries_into_another_variable(variable):
    for bits in (8, 10, 12, 15, 16):
        power = NAMES.read(f"{variable}**{2**bits}", "f")
        for other in VARIABLES:
            assert power != NAMES.read(other, "g")
        assert power != NAMES.read("1", "one")
    top = NAMES.read(f"{variable}**{MAX_EXPONENT}", "f")
    for f in (top, NAMES.read(variable, "f"), NAMES.read(f"x*{variable} + 1", "f")):
        with pytest.raises(Rejected, match="degree"):
            multiply(top, f)
    for written in (
        f"{variable}**{MAX_EXPONENT + 1}",
        f"{variable}**{2**24}",
        f"{variable}**{2**32}",
        "*".join([f"{variable}**65536"] * 256),
        f"1 + 0*{variable}**65536*{variable}",
    ):
        with pytest.raises(Rejected):
            NAMES.read(written, "f")


@subcases(
    "written",
    [
        *(
            "",
            " ",
            "+",
            "s s",
            "s**",
            "s**-1",
            "s**+1",
            "s**1.0",
            "s**٣",
            "٣*s",
            "²",
            "1e3",
            "0x1",
            "1_0",
        ),
        *(
            "s^2",
            "s/2",
            "(s)",
            "2**3",
            "s**2**2",
            "--s",
            "+-s",
            "s*",
            "*s",
            "s**0",
            "q",
            "q[4]",
            "q[0][0]",
        ),
        *("q[٠]", "sqrt(3)", "sqrt(2", "S", "ｓ", "T1", "s;x", "s,x", "s\x00", "s +", "9" * 4001),
    ],
)
def test_texts_that_are_no_polynomials(written):
    with pytest.raises(Rejected):
        NAMES.read(written, "f")


def element(rng, p, n):
    coefficients = [rng.choice((0, 1, p - 1, rng.randrange(p))) for _ in range(n)]
    return coefficients, " + ".join(f"{c}*x**{m}" for m, c in enumerate(coefficients))


@pytest.mark.parametrize(
    ("name", "p", "modulus"),
    [
        ("GF(4)", 2, [1, 1, 1]),
        ("GF(9)", 3, [2, 2, 1]),
        ("GF(9, x^2+1)", 3, [1, 0, 1]),
        ("GF(27)", 3, [1, 2, 0, 1]),
        ("GF(1000006000009, x^2+1)", 1000003, [1, 0, 1]),
        (f"GF({(2**61 - 1) ** 2}, x^2+1)", 2**61 - 1, [1, 0, 1]),
        ("GF(2401)", 7, [3, 4, 5, 0, 1]),
    ],
)
def test_finite_fields(name, p, modulus):
    rng, ring = random.Random(name), read_ring(finite(p, len(modulus) - 1, modulus))
    assert ring.name == name
    field = flint.fq_default_ctx(modulus=flint.fmpz_mod_poly_ctx(p)(modulus))
    n = field.degree()
    for _ in range(40):
        (a, s), (b, t) = element(rng, p, n), element(rng, p, n)
        x, y, u, v = field(a), field(b), ring.read(s), ring.read(t)
        for mine, other in (
            (ring.add(u, v), x + y),
            (ring.mul(u, v), x * y),
            (ring.neg(u), -x),
            (ring.power(u, 12345), x**12345),
            (ring.number(-7), field(-7)),
        ):
            assert ring.equal(mine, read_back(ring, other))
        if x == 0:
            assert ring.inverse(u) is None
        else:
            assert ring.equal(ring.inverse(u), read_back(ring, 1 / x))
        assert ring.is_square(u) == x.is_square()


def read_back(ring, x):
    return ring.read(" + ".join(f"{int(c)}*x**{m}" for m, c in enumerate(x.to_list())) or "0")


@pytest.mark.parametrize("n", [2, 4, 6, 12, 561, 10**40 + 120, 2**61 - 1, 2**64])
def test_residues(n):
    rng, ring = random.Random(n), read_field(f"ZZ/{n}")
    for _ in range(50):
        x, y = rng.randrange(-(n**2), n**2), rng.randrange(n)
        assert ring.mul(ring.number(x), ring.number(y)) == x * y % n
        assert ring.add(ring.number(x), ring.neg(ring.number(y))) == (x - y) % n
        inverse = ring.inverse(ring.number(x))
        assert (inverse is not None) == (gcd(x, n) == 1)
        assert inverse is None or x * inverse % n == 1 % n


PSEUDOPRIMES = [
    *(
        561,
        1729,
        2047,
        1373653,
        25326001,
        3215031751,
        2152302898747,
        3474749660383,
        341550071728321,
    ),
    *(
        3825123056546413051,
        318665857834031151167461,
        1195068768795265792518361315725116351898245581,
    ),
]


def test_primality():
    rng = random.Random(0)
    candidates = [*range(-5, 5_000), *PSEUDOPRIMES[:-1], 2**61 - 1, 2**64 + 13, 10**24 + 7]
    for bits in (20, 40, 62, 64, 70, 81):
        p = [rng.getrandbits(bits) | 1 for _ in range(60)]
        p = [n for n in p if flint.fmpz(n).is_prime()] or p[:5]
        candidates += [*p, *(n + 2 for n in p)]
        small = [n for n in p if n.bit_length() <= 40]
        candidates += [a * b for a in small for b in small]
    for n in candidates:
        if n < 3317044064679887385961981:
            assert is_prime(n) == (n > 1 and flint.fmpz(n).is_prime()), n
    for n in (3317044064679887385961981, PSEUDOPRIMES[-1], 2**89 - 1, 10**40 + 121):
        with pytest.raises(Rejected, match="too large"):
            is_prime(n)


@pytest.mark.parametrize(
    ("p", "n"), [(2, 2), (2, 3), (2, 4), (2, 6), (3, 2), (3, 4), (5, 2), (7, 3), (101, 2)]
)
def test_irreducibility(p, n):
    rng, context = random.Random(p * n), flint.fmpz_mod_poly_ctx(p)
    seen = set()
    for _ in range(60):
        modulus = [rng.randrange(p) for _ in range(n)] + [1]
        if rng.random() < 0.3 and n % 2 == 0:
            half = context([rng.randrange(p) for _ in range(n // 2)] + [1])
            modulus = [int(c) for c in (half * half).coeffs()]
        irreducible = [(len(f.coeffs()) - 1, m) for f, m in context(modulus).factor()[1]] == [
            (n, 1)
        ]
        seen.add(irreducible)
        if irreducible:
            assert read_ring(finite(p, n, modulus)).is_field
        else:
            with pytest.raises(Rejected):
                read_ring(finite(p, n, modulus))
    assert seen == {True, False}


@pytest.mark.parametrize("d", [2, -1, -7, 5, 10007, -999_983])
def test_quadratic_fields(d):
    name = "QQ(I)" if d == -1 else f"QQ(sqrt({d}))"
    root = "I" if d == -1 else f"sqrt({d})"
    rng, ring = random.Random(d), read_field(name)

    def some():
        return [
            Fraction(rng.randint(-(10**9), 10**9), rng.choice((1, 2, 3, 10**6))) * rng.randint(0, 2)
            for _ in "ab"
        ]

    def read(a, b):
        return ring.read(f"({a}) + ({b})*{root}")

    for _ in range(40):
        (a, b), (c, e) = some(), some()
        x, y = read(a, b), read(c, e)
        assert ring.equal(ring.mul(x, y), read(a * c + d * b * e, a * e + b * c))
        assert ring.equal(ring.add(x, ring.neg(y)), read(a - c, b - e))
        norm = a * a - d * b * b
        if norm:
            assert ring.equal(ring.inverse(x), read(a / norm, -b / norm))
            assert ring.is_square(ring.mul(x, x))
            if abs(norm.numerator) > 1:
                non_square = ring.is_square(ring.mul(ring.mul(x, x), ring.number(3)))
                assert non_square == (d == -3)
        else:
            assert ring.inverse(x) is None
        if d > 0:
            value = (
                flint.arb(flint.fmpq(a.numerator, a.denominator))
                + flint.arb(flint.fmpq(b.numerator, b.denominator)) * flint.arb(d).sqrt()
            )
            assert ring.sign(x) == (0 if a == b == 0 else 1 if value > 0 else -1)


def test_sums_of_roots_are_as_large_as_they_should_be():
    rng, ring = random.Random(5), read_field("RR")
    with flint.ctx.workdps(200):
        for _ in range(40):
            terms = [
                (rng.randint(-5, 5), rng.choice((1, 2, 3, 6, 8, 10, 12, 999_983, 720720)))
                for _ in range(4)
            ]
            x = ring.read(" + ".join(f"({c})*sqrt({n})" for c, n in terms))
            square = ring.mul(ring.mul(x, x), x)
            value = sum((flint.arb(c) * flint.arb(n).sqrt() for c, n in terms), flint.arb(0)) ** 3
            total = flint.arb(0)
            for key, c in square:
                total += (
                    flint.arb(flint.fmpq(c.numerator, c.denominator)) * flint.arb(prod(key)).sqrt()
                )
            assert total.overlaps(value)
            if x:
                one = ring.mul(x, ring.inverse(x))
                assert ring.equal(one, ring.one)


@pytest.mark.parametrize("name", ["QQ(x)", "GF(5)(x)", "GF(2)(x)", "GF(1000003)(x)"])
def test_rational_functions(name):
    rng, ring = random.Random(name), read_field(name)
    p = ring.characteristic
    make = flint.fmpq_poly if not p else flint.fmpz_mod_poly_ctx(p)

    def some():
        size = rng.randint(0, 4)
        return make([rng.choice((0, 1, -1, rng.randint(-(10**6), 10**6))) for _ in range(size)])

    def read(f, g):
        return ring.read(f"({written(f)})/({written(g)})")

    def written(f):
        return " + ".join(f"({c})*x**{n}" for n, c in enumerate(f.coeffs())) or "0"

    for _ in range(40):
        f, g, u, v = some(), some(), some(), some()
        if g == 0 or v == 0:
            continue
        x, y = read(f, g), read(u, v)
        assert ring.equal(ring.add(x, y), read(f * v + u * g, g * v))
        assert ring.equal(ring.mul(x, y), read(f * u, g * v))
        assert ring.is_zero(x) == (f == 0)
        assert f == 0 or ring.equal(ring.inverse(x), read(g, f))
        if p != 2 and f != 0:
            assert ring.is_square(ring.mul(x, x))
            assert not ring.is_square(ring.mul(ring.mul(x, x), ring.read("x")))


def test_squares_of_rational_numbers():
    rng, ring = random.Random(1), read_field("QQ")
    for _ in range(200):
        a, b = rng.randint(-(10**30), 10**30), rng.randint(1, 10**30)
        x = Fraction(a, b)
        expected = all(isqrt(abs(n)) ** 2 == n for n in (x.numerator, x.denominator))
        assert ring.is_square(x) == expected
        assert ring.is_square(x * x)
        assert not ring.is_square(-x * x) or not x
        assert ring.is_square(x * x + Fraction(1, b**2)) is (a == 0)


def test_bounds_are_where_they_are_said_to_be():
    """What is as large as allowed is read, and one more is not."""
    top = 1 << 16_000
    for written, fine in (
        ("9" * 4_000, True),
        ("9" * 4_001, False),
        (f"{1 << 8_000}*{(1 << 8_000) - 1}", True),
        (f"{1 << 8_000}*{1 << 8_000}", False),
        ("s**65536", True),
        ("s**65537", False),
        ("s**000001", True),
        ("s**0000001", False),
        (" " * (MAX_TEXT - 1) + "s", True),
        (" " * MAX_TEXT + "s", False),
    ):
        if fine:
            assert NAMES.read(written, "f")
        else:
            with pytest.raises(Rejected):
                NAMES.read(written, "f")
    one = NAMES.read("1", "f")
    assert add({}, one, top - 1) == {next(iter(one)): top - 1}
    with pytest.raises(Rejected):
        add({}, one, top)
    assert divide({}, one) == {}
