"""Which ring a text means, and what is said where it means none; names that fit are read back."""

import json
import re
from random import Random

import pytest

from hfield import GF, NumberField, Zmod
from hfield.errors import CoercionError, RingError
from hfield.fields.base.printing import (
    blackboard,
    from_unicode,
    is_sum,
    number_text,
    parentheses,
    power_text,
    quotient_text,
    sum_text,
)
from hfield.fields.names import ring
from hfield.fields.number_fields.places import place_of_number_field
from tests.fields.words import FILE, named
from tests.subcases import subcases

BEFORE = json.loads(FILE.read_text(encoding="utf-8"))


@pytest.mark.parametrize("chunk", range(8))
def test_what_a_name_means(chunk: int) -> None:
    for text in list(BEFORE)[chunk::8]:
        assert named(text) == BEFORE[text]
        if "Error: " not in BEFORE[text]:
            again = ring(BEFORE[text])
            assert again is ring(text) or again == ring(text)
            assert again.name == BEFORE[text]


def test_lengths() -> None:
    with pytest.raises(RingError) as caught:
        ring("Q" * 10_001)
    assert str(caught.value) == "the name of a ring has at most 10000 characters, not 10001"
    with pytest.raises(RingError, match="there is no ring"):
        ring("Q" * 10_000)
    assert Zmod(2**4096 - 1).order == 2**4096 - 1
    with pytest.raises(RingError, match="n of 4097 bits is too large; at most 4096 bits are taken"):
        Zmod(2**4096)
    assert GF(2**512).degree == 512
    for q in (2**513, "2^513"):
        with pytest.raises(
            RingError, match=r"2\^513 is too large; at most 4096 bits and degree 512"
        ):
            GF(q)
    with pytest.raises(RingError, match="q of 4097 bits is too large"):
        GF(2**4096)


def test_constructors_of_finite_fields() -> None:
    assert GF(9) is ring("GF(9)")
    assert GF("3^2", "x^2+1") == ring("GF(9, x^2+1)")
    assert (GF(9).modulus_origin, GF(9, "x^2+1").modulus_origin) == ("Conway", "given")
    for q in (6, "x", 2.5, None, "", "9.0", "3^", "^2", "3^2^1", "٩"):
        with pytest.raises(RingError):
            GF(q)
    for n in (0, 1, -6, 2.5, "x", None):
        with pytest.raises(RingError):
            Zmod(n)


# Small fields, element by element, against sums of digits and products of polynomials.
@pytest.mark.parametrize(
    ("p", "n", "modulus"), [(2, 2, "x^2+x+1"), (3, 2, "x^2+1"), (2, 3, "x^3+x+1"), (5, 2, "x^2+2")]
)
def test_finite_fields_by_polynomials(p: int, n: int, modulus: str) -> None:
    F = GF(p**n, modulus)
    m = F.coefficients
    assert len(m) == n + 1
    assert m[n] == 1

    def digits(label):
        return [label // p**k % p for k in range(n)]

    def label(c):
        return sum(x % p * p**k for k, x in enumerate(c))

    elements = list(F.elements())
    assert [F.label(x) for x in elements] == list(range(p**n))
    assert [F.from_label(k) for k in range(p**n)] == elements
    for a, x in enumerate(elements):
        assert F(F.text(x)) == x
        assert F.text(x) == sum_text(
            [(str(c), [("x", k)]) for k, c in reversed(list(enumerate(digits(a)))) if c], "plain"
        )
        for b, y in enumerate(elements):
            u, v = digits(a), digits(b)
            assert F.label(x + y) == label([s + t for s, t in zip(u, v, strict=True)])
            product = [0] * (2 * n - 1)
            for i, s in enumerate(u):
                for j, t in enumerate(v):
                    product[i + j] += s * t
            for k in range(2 * n - 2, n - 1, -1):
                top = product[k]
                for j in range(n + 1):
                    product[k - n + j] -= top * m[j]
            assert F.label(x * y) == label(product[:n])
        if a:
            assert F.inverse(x) * x == 1
            assert F.power(x, -3) * x * x * x == 1
        assert F.power(x, p**n) == x
    roots = F.roots([F(0), F(-1), *[F(0)] * (p**n - 2), F(1)])
    assert sorted(map(F.label, roots)) == list(range(p**n))


def test_words_of_printing() -> None:
    assert blackboard("QQ(x)+ZZ[a]") == "ℚ(x)+ℤ[a]"
    assert blackboard("aQQ ZZ/6") == "aQQ ℤ/6"
    for style, half, minus in (
        ("plain", "-1/2", "-"),
        ("unicode", "−1/2", "−"),
        ("latex", r"-\frac{1}{2}", "-"),
    ):
        R = ring("QQ")
        assert number_text(R("-1/2"), style) == half
        assert number_text(R(-3), style) == f"{minus}3"
        assert number_text(R(0), style) == "0"
    assert [power_text("x", n, "plain") for n in (1, 0, 2, -3, 12)] == [
        "x",
        "x^0",
        "x^2",
        "x^-3",
        "x^12",
    ]
    assert [power_text("x", n, "unicode") for n in (1, 2, -30)] == ["x", "x²", "x⁻³⁰"]
    assert power_text("x", 10, "latex") == "x^{10}"
    for text, wanted in (
        ("1+x", True), ("-x", False), ("(1+x)", False), ("x-1", True), ("−x", False), ("x−1", True),
        ("[1+x]", False), ("{1+x}y", False), ("x^-1", False), ("(1)+(2)", True), ("", False),
        ("f(1+x)*2", False), ("(x)-[y]", True),
    ):  # fmt: skip
        assert is_sum(text) == wanted, text
    assert (parentheses("x", "plain"), parentheses("x", "latex")) == ("(x)", r"\left(x\right)")
    for n, d, plain, latex in (
        ("x", "1", "x", "x"), ("x+1", "y", "(x+1)/y", r"\frac{x+1}{y}"),
        ("1", "2*y", "1/(2*y)", r"\frac{1}{2*y}"),
        ("x/2", "y", "(x/2)/y", r"\frac{x/2}{y}"), ("x", "y^2", "x/y^2", None), ("x", "12", "x/12", None),
        ("x", "2y", "x/(2y)", None), ("x", "y+1", "x/(y+1)", None), ("-x", "y", "-x/y", None),
    ):  # fmt: skip
        assert quotient_text(n, d, "plain") == plain
        assert latex is None or quotient_text(n, d, "latex") == latex
    terms = [
        ("1", [("x", 2)]),
        ("-1", [("x", 1), ("y", 1)]),
        ("3", [("y", 0)]),
        ("a+b", [("z", 1)]),
        ("-2", []),
    ]
    assert sum_text(terms, "plain") == "x^2-x*y+3+(a+b)*z-2"
    assert sum_text(terms, "latex") == r"x^{2}-xy+3+\left(a+b\right)z-2"
    assert sum_text([("−1", [("x", 3)]), ("2", [("x", 1)])], "unicode") == "−x³+2·x"
    assert sum_text([], "plain") == "0"
    assert sum_text([("2", [("3z", 1)])], "latex") == "2 3z"
    assert from_unicode("x²·√2+√(3)+π−x⁻¹²") == "x^(2)·sqrt(2)+sqrt(3)+pi−x^(-12)"


def test_floats() -> None:
    R = ring("RDF")
    for text, value in (("1/4", 0.25), ("sqrt(2)^2", 2.0000000000000004), ("cos(0)", 1.0),
                        ("-1.5e3", -1500.0),
                        ("pi-pi", 0.0), ("exp(0)+log(1)", 1.0), ("tan(0)+sin(0)", 0.0)):  # fmt: skip
        assert R(text) == value
    assert [R.text(x, "latex") for x in (1e300, -2e-30, 1.5)] == [
        r"1 \cdot 10^{300}",
        r"-2 \cdot 10^{-30}",
        "1.5",
    ]
    assert [R.text(-1e-20, style) for style in ("plain", "unicode")] == ["-1e-20", "−1e−20"]
    assert (R.sqrt(4.0), R.sqrt(-1.0), R.sqrt(0.0)) == (2.0, None, 0.0)
    assert (R.power(2.0, -2), R.power(0.0, 0), R.inverse(-4.0), R.divide(1.0, 4.0)) == (
        0.25,
        1.0,
        -0.25,
        0.25,
    )
    for work, said in (
        (lambda: R.power(0.0, -1), "cannot divide by 0 in RDF"),
        (lambda: R.power(1e300, 2), r"1e\+300\*\*2 is too large for RDF"),
        (lambda: R.inverse(5e-324), "1/5e-324 is too large for RDF"),
        (lambda: R.divide(1.0, 0.0), "cannot divide by 0 in RDF"),
        (lambda: R("log(0)"), r"log\(0.0\) is not a finite real number"),
        (lambda: R("sqrt(-1)"), r"sqrt\(-1.0\) is not a finite real number"),
        (lambda: R("exp(1000)"), r"exp\(1000.0\) is not a finite real number"),
        (lambda: R(10**400), "is not an element of RDF: expected a finite float64"),
        (lambda: R(float("inf")), "inf is not an element of RDF: expected a finite float64"),
        (lambda: R("-inf"), "-inf is not an element of RDF: expected a finite float64"),
        (lambda: R("−nan"), "nan is not an element of RDF: expected a finite float64"),
        (lambda: R(1j), "expected a real number or its text"),
        (lambda: R.array([[1.0, float("nan")]]), "nan is not an element of RDF"),
        (lambda: R.sign(1.0, 1), "RDF has no ordering number 1, only the usual one, 0"),
    ):  # fmt: skip
        with pytest.raises(Exception, match=said):
            work()
    assert [R.sign(x) for x in (2.0, -3.0, 0.0)] == [1, -1, 0]
    assert list(R.array([1, "1/2", 2.5])) == [1.0, 0.5, 2.5]
    assert list(R.array_units(R.array([0.0, 2.0]))) == [False, True]
    assert list(R.array_inverse(R.array([4.0, -2.0]))) == [0.25, -0.5]
    assert R.random(Random(3)) == R.random(Random(3))
    assert type(R.scalar(R.array([1.0])[0])) is float


@pytest.mark.parametrize("name", ["RR", "CC"])
def test_closed_fields_say_so(name: str) -> None:
    from hfield.fields.algebraic.ring import AlgebraicNumbers

    made = AlgebraicNumbers(name)
    assert made.closure == {"RR": "real closed", "CC": "algebraically closed"}[name]
    assert (made.is_real, made.gen_name) == ((True, None) if name == "RR" else (False, "I"))
    assert made == ring(name)


def test_roots_in_the_names_of_fields_are_read() -> None:
    K = ring("QQ(root(2,3),root(5,4))")
    a, b = (K.parts[text] for text in ("root(2,3)", "root(5,4)"))
    for text, wanted in (
        ("cbrt(2)", a), ("root(2,3)", a), ("cbrt(16)", 2 * a), ("cbrt(1/4)", a / 2), ("root(5,4)", b),
        ("root(80,4)", 2 * b), ("root(5/81,4)", b / 3), ("sqrt(5)", b * b), ("root(5,2)", b * b),
        ("root(9,2)", K(3)), ("sqrt(20)", 2 * b * b),
    ):  # fmt: skip
        assert K(text) == wanted, text
    for text in (
        "cbrt(3)",
        "root(2,4)",
        "root(5,3)",
        "cbrt(root(2,3))",
        "root(-5,4)",
        "root(7,2)",
        "root(2,5)",
    ):
        with pytest.raises(CoercionError):
            K(text)


@subcases("n", [4, 6, 8, 9, 10, 12, 14, 15, 16, 20, 21, 24, 25, 28, 32, 33, 36, 45, 49, 64, 77, 99])
def test_as_few_squares_as_can_be(n: int) -> None:
    R = ring(f"ZZ/{n}")
    squares = {x * x % n for x in range(n)}
    sums, count = {0}, 0
    while n - 1 not in sums:
        sums, count = {(x + y) % n for x in sums for y in squares}, count + 1
    found = R.minus_one_as_squares()
    assert len(found) == R.level.value == count
    assert sum((x * x for x in found), R.zero) == -1


@subcases(
    ("name", "text"),
    [
        ("QQ(sqrt(2))", "sqrt(2)"), ("RR", "pi"), ("QQ(x)", "1/x"), ("QQ(x,y)", "x/y"),
        ("QQ[s]/(s^3-2)", "s"),
        ("QQ(x)[u]/(u^2-x)", "u"), ("Qp(5)", "1/5"), ("GF(4)(t)", "x*t"), ("ZZ[a]", "a"), ("ZZ/6", "5"),
        ("GF(9)", "x"),
    ],
)  # fmt: skip
def test_elements_and_what_is_no_number(name: str, text: str) -> None:
    R = ring(name)
    x = R(text)
    for other in ("1", None, [1], object()):
        for work in (
            lambda y: x + y, lambda y: y + x, lambda y: x - y, lambda y: y - x, lambda y: x / y,
            lambda y: y / x,
            lambda y: x * (y if y != [1] else object()),
        ):  # fmt: skip
            with pytest.raises(TypeError):
                work(other)
        assert x != other
        assert not x == other  # noqa: SIM201  that the other method says so too
    assert (x + 1 - 1, 1 + x - 1, 1 - (1 - x), 2 * x - x, x * 2 - x) == (x,) * 5
    assert x + x - x == +x
    assert -x + x + x == x


@pytest.mark.parametrize(
    "name",
    [
        "QQ(sqrt(2))",
        "QQ[s]/(s^3-2)",
        "QQ(x)",
        "QQ(x,y)",
        "QQ[x]/(x^2)",
        "Qp(5)",
        "QQ(I)(x)",
        "GF(9)",
    ],
)
def test_errors_name_the_ring_of_a_foreign_element(name: str) -> None:
    with pytest.raises(CoercionError, match=re.escape(f"2 of {name} is not an element of GF(7)")):
        ring("GF(7)")(ring(name)(2))


def test_places_and_ideals_are_no_elements() -> None:
    K = ring("QQ(sqrt(2))")
    for x in (*K.real_places(), *K.primes_above(2), K.ideal(2)):
        with pytest.raises(CoercionError, match="expected an int, a Fraction, an element"):
            K(x)


def test_equal_fields_are_one_field() -> None:
    K, L = NumberField("x^3-2", "s"), NumberField("s^3-2", "s")
    assert K is not L
    assert K == L
    assert K.gen == L.gen
    assert hash(K.gen) == hash(L.gen)
    assert (K.gen + L.gen, K.gen - L.gen, K.gen * L.gen) == (2 * K.gen, 0, K.gen**2)
    assert K.gen / L.gen == 1
    assert K(L.gen) == K.gen
    other = NumberField("x^3-3", "s")
    assert K.gen != other.gen
    with pytest.raises(TypeError):
        K.gen + other.gen
    for place, said in (
        ("(2, w)", "the place '(2, w)' cannot be read"),
        ("(4, s)", "'(4, s)' is not a place of QQ[s]/(s^3-2): expected a prime"),
        ("(5, 1)", "'(5, 1)' is not a single place of QQ[s]/(s^3-2): the places above it are"),
        (
            "inf7",
            '\'inf7\' is not a single place of QQ[s]/(s^3-2): the places above it are "inf0", "inf1"',
        ),
        (other.primes_above(2)[0], "is a place of QQ[s]/(s^3-3), not of QQ[s]/(s^3-2)"),
    ):
        with pytest.raises(RingError) as caught:
            place_of_number_field(K, place)
        assert said in str(caught.value)
