"""The checker's rings: units, signs, squares and roots, against values and products."""

from fractions import Fraction
from itertools import product

import pytest

from hfield.checker.budget import Budget, bounded
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.rationals import has_no_rational_root
from tests.checker import ring_data as data
from tests.checker.ring_data import Data, read_field
from tests.subcases import slow, subcases

NEAR = (Fraction(10**6), Fraction(-(10**6)), Fraction(1, 10**6), Fraction(-1, 10**6))


@pytest.mark.parametrize(
    ("text", "numerator", "denominator"),
    [
        ("x", [0, 1], [1]),
        ("-x", [0, -1], [1]),
        ("1/x", [1], [0, 1]),
        ("-7", [-7], [1]),
        ("x**2 - 5*x**3", [0, 0, 1, -5], [1]),
        ("(x - 1)/(x**3 + 2)", [-1, 1], [2, 0, 0, 1]),
        ("(3 - x**2)/(x - x**2)", [3, 0, -1], [0, 1, -1]),
    ],
)
def test_signs_of_functions_are_those_of_values(
    text: str, numerator: list[int], denominator: list[int]
) -> None:
    field = read_field("QQ(x)")
    values = []
    for x in NEAR:
        top, below = (sum(c * x**n for n, c in enumerate(f)) for f in (numerator, denominator))
        values.append((top / below > 0) - (top / below < 0))
    signs = [sign for sign in field.signs(field.read(text)) if sign is not None]
    assert sorted(signs) == sorted(values)
    assert field.sign(field.read(text)) == values[0]


def test_signs_of_pairs_stand_together() -> None:
    field = read_field("QQ(x)")
    pairs = list(zip(field.signs(field.read("x")), field.signs(field.read("x - 1")), strict=True))
    assert sorted(pairs) == sorted([(1, 1), (-1, -1), (1, -1), (-1, -1)])
    assert field.signs(field.zero) == (0,) * 4
    assert set(read_field("GF(3)(t)").signs(read_field("GF(3)(t)").one)) == {None}


def test_signs_in_quadratic_fields() -> None:
    for text, found in (("1 - sqrt(2)", (-1, 1)), ("3 + sqrt(2)", (1, 1)), ("0", (0, 0))):
        field = read_field("QQ(sqrt(2))")
        assert field.signs(field.read(text)) == found
    real = read_field("RR")
    assert real.signs(real.read("sqrt(2) - sqrt(3)")) == (-1,)
    assert read_field("QQ(I)").signs(read_field("QQ(I)").one) == (None, None)
    assert read_field("CC").sign(read_field("CC").one) is None


def test_units() -> None:
    integers, rationals = read_field("ZZ"), read_field("QQ")
    assert [integers.inverse(Fraction(n)) for n in (-2, -1, 0, 1, 2)] == [None, -1, None, 1, None]
    assert rationals.inverse(Fraction(-2)) == Fraction(-1, 2)
    assert rationals.inverse(Fraction(0)) is None
    polynomials, integral = read_field("QQ[x]"), read_field("ZZ[x,y]")
    assert polynomials.inverse(polynomials.read("2")) == polynomials.read("1/2")
    assert integral.inverse(integral.read("-1")) == integral.read("-1")
    for ring, text in ((polynomials, "x"), (polynomials, "x + 1"), (integral, "2")):
        assert ring.inverse(ring.read(text)) is None
    assert polynomials.inverse(polynomials.zero) is None
    assert polynomials.characteristic == 0
    assert read_field("GF(3)[x]").characteristic == 3


@subcases(
    ("field", "text", "same"),
    [
        ("RR", "sqrt(1/2)", "1/2*sqrt(2)"),
        ("RR", "sqrt(12) - sqrt(27)", "-sqrt(3)"),
        ("RR", "sqrt(0)", "0"),
        ("CC", "sqrt(-4)", "2*I"),
        ("CC", "sqrt(-2)*sqrt(-3)", "-sqrt(6)"),
        ("QQ(sqrt(5))", "sqrt(4/5)", "2/5*sqrt(5)"),
        ("RR", "1/(1 + sqrt(2) + sqrt(3))", "(2 + sqrt(2) - sqrt(6))/4"),
        ("QQ", "2 - 3 - 4", "-5"),
        ("QQ", "2**-3 - 1/4", "-1/8"),
        ("QQ", "1**10000", "1"),
        ("GF(9, x^2+1)", "(1 - x)*(1 + x)", "2"),
        ("GF(9)", "x*x", "x + 1"),
        ("GF(9, x^2+x+2)", "x*x", "2*x + 1"),
        ("QQ[x]", "(x - 1)*(x + 1) - x**2", "-1"),
        ("GF(4)(t)", "(t**2 - 1)/(t - 1)", "t + 1"),
    ],
)
def test_elements_as_texts(field: str, text: str, same: str) -> None:
    ring = read_field(field)
    assert ring.equal(ring.read(text), ring.read(same))
    assert not ring.equal(ring.read(text), ring.add(ring.read(same), ring.one))


@subcases(
    ("field", "text"),
    [
        *(("QQ", "1**10001"), ("QQ", "1**-10001"), ("QQ", "1/0"), ("QQ", "x"), ("QQ", "I")),
        *(("ZZ", "1/2"), ("RR", "sqrt(-1)"), ("RR", "I"), ("QQ(sqrt(2))", "sqrt(3)")),
        *(("QQ(I)", "sqrt(2)"), ("QQ", "1 == 1"), ("QQ", "q[0]"), ("GF(9)", "1/(x - x)")),
        *(("QQ[x]", "1/x"), ("ZZ/6", "1/2"), ("QQ(x)", "1/(x - x)"), ("QQ", "2**10000**2")),
    ],
)
def test_texts_that_name_no_element(field: str, text: str) -> None:
    ring = read_field(field)
    with pytest.raises(Rejected):
        ring.read(text)


@subcases(
    "ring",
    [
        *(data.finite(3, 2, f) for f in ([2, 0, 1], [0, 1], [1, 0, 0, 1], [1, 0, 3], [1, 0, 1, 0], [])),
        *(data.finite(3, 2, f) for f in ([1, 0, 4], [-2, 0, 1], [2, 3, 1], ["1", 0, 1], [1.0, 0, 1], "101")),
        *(data.finite(2, 2, f) for f in (None, [1, 1, True], [1, "1/2", 1], [[1], 0, 1])),
        *(data.finite(p) for p in (6, 9, -5, 0, "5", 5.0, True)),
        *(data.finite(p, n, f) for p, n, f in ((3, 1, [0, 1]), (5, 0, None), (5, -1, None), (9, 1, None))),
        *(data.residues(n) for n in (1, 0, -3, "7", None, 7.0)),
        *(data.quadratic(d) for d in (0, 1, 4, 8, 12, -4, "2", "-1", 2.0, None)),
        *(data.multiquadratic(*d) for d in ((), (2,), (2, "3"), (2, 2), (2, 4), (-1, 2))),
        data.multiquadratic(2, 3, 5, 7, 11, 13),
        *(data.functions(base, "x") for base in (data.ZZ, data.RR, data.CC, data.RDF, data.residues(4))),
        *(data.functions(base, "y") for base in (data.functions(data.QQ, "x"), "QQ", 2)),
        *(data.functions(data.QQ, *names) for names in ((), ("or",), ("i",), ("x", "x"))),
        data.functions(data.finite(2, 2, [1, 1, 1]), "x"),
        *(data.polynomials(base, "x") for base in (data.residues(4), data.finite(3, 2, [2, 2, 1]), data.RR)),
        *(data.polynomials(data.QQ, *names) for names in (("x", "x"), ("e",), (), ("x,y",), ("x ",))),
        {**data.polynomials(data.QQ, "x"), "variables": "x"},
        *({**data.QQ, key: None} for key in ("name", "characteristic", "modulus", "")),
        *({"kind": kind} for kind in ("QQ", "Rationals", " rationals", "", None, 1, ["rationals"])),
        *({"kind": kind} for kind in ("finite field", "residues", "completion", "number field")),
        *("QQ", None, 7, [], [data.QQ], {}, {"Kind": "rationals"}),
    ],
)  # fmt: skip
def test_data_of_no_ring(ring: object) -> None:
    with pytest.raises(Rejected), bounded():
        read_ring(ring)


@pytest.mark.parametrize(
    "name", ["QQ(x)", "GF(3)(t)", "QQ(I)", "QQ(sqrt(2))", "QQ(sqrt(-3))", "GF(9)", "GF(7)", "QQ"]
)
def test_products_of_an_element_with_itself_are_squares(name: str) -> None:
    field = read_field(name)
    letter = {"QQ(x)": "x", "GF(3)(t)": "t", "QQ(I)": "I", "GF(9)": "x"}.get(name, "2")
    letter = name[3:-1] if "sqrt" in name else letter
    elements = [
        field.read(f"({a} + {b}*{letter})/{c}")
        for a, b, c in product((0, 1, 2, -5), (0, 1, -3), (1, 2))
    ]
    squares = [field.mul(x, x) for x in elements]
    assert all(map(field.is_square, squares))
    if field.order is None:
        prime = field.read("7" if field.characteristic == 0 else "2")
        assert not any(
            field.is_square(field.mul(prime, x)) for x in squares if not field.is_zero(x)
        )
    else:
        roots = {field.mul(x, x) for x in field.elements()}
        assert all(field.is_square(x) == (x in roots) for x in field.elements())


def test_squares_of_other_fields() -> None:
    for name, text, square in (
        *(("RR", "2 - sqrt(3)", True), ("RR", "1 - sqrt(3)", False), ("RR", "0", True)),
        *(("CC", "-2", True), ("CC", "sqrt(2) - I", True)),
        *(("QQ(sqrt(2))", "2", True), ("QQ(sqrt(2))", "8", True), ("QQ(sqrt(2))", "-2", False)),
        *(("QQ(sqrt(2))", "1 + sqrt(2)", False), ("QQ(sqrt(2))", "3 + 2*sqrt(2)", True)),
        *(("QQ(I)", "-1", True), ("QQ(I)", "I", False), ("QQ(I)", "2*I", True)),
        *(("QQ(x)", "x", False), ("QQ(x)", "x**3", False), ("QQ(x)", "(x**2 + 1)/4", False)),
        *(("QQ(x)", "(x - 1)**4/(x + 1)**2", True), ("QQ(x)", "2*(x - 1)**2", False)),
        *(("QQ", "4/9", True), ("QQ", "4/8", False), ("QQ", "-4", False), ("QQ", "8/4", False)),
    ):
        field = read_field(name)
        assert field.is_square(field.read(text)) == square, (name, text)
    for name in ("GF(2)(t)", "ZZ/9", "QQ[x]"):
        ring = read_field(name)
        with pytest.raises(Rejected):
            ring.is_square(ring.read("1 + 1 + 1"))


def times(*factors: list[int]) -> list[int]:
    out = [1]
    for f in factors:
        new = [0] * (len(out) + len(f) - 1)
        for (m, a), (n, b) in product(enumerate(out), enumerate(f)):
            new[m + n] += a * b
        out = new
    return out


EVERYWHERE = times([-2, 0, 1], [-3, 0, 1], [-6, 0, 1])  # a root modulo every prime, and none in ℚ


@pytest.mark.parametrize("linear", [(1, 1), (6, 1), (-6, 1), (3, 2), (-5, 6), (7, 4), (36, 1)])
def test_rational_roots_are_found_behind_roots_modulo_every_prime(linear: tuple[int, int]) -> None:
    top, below = linear
    assert has_no_rational_root(EVERYWHERE)
    assert has_no_rational_root(times(EVERYWHERE, [2, 0, 5]))
    assert not has_no_rational_root(times(EVERYWHERE, [-top, below]))
    assert not has_no_rational_root(times([1, 0, 1], [-top, below]))
    assert not has_no_rational_root([0, *EVERYWHERE])


def test_levels() -> None:
    for name, above in (
        *(("GF(3)", 1), ("GF(7)", 1), ("GF(5)", 0), ("GF(9)", 0), ("GF(4)", 0), ("GF(27)", 1)),
        *(("QQ(sqrt(-7))", 3), ("QQ(sqrt(-3))", 1), ("QQ(I)", 0), ("QQ(sqrt(-15))", 3)),
        *(("GF(3)(t)", 1), ("GF(5)(t)", 0), ("QQ(sqrt(-2))", 1)),
    ):
        field = read_field(name)
        assert [field.level_above(n) for n in range(1, 6)] == [n <= above for n in range(1, 6)], (
            name
        )
    for name in ("QQ", "RR", "QQ(sqrt(2))", "QQ(x)"):
        assert all(read_field(name).level_above(n) for n in (0, 1, 4, 1000))


def square_often(name: str, text: str) -> None:
    field = read_field(name)
    x = field.read(text)
    with bounded(Budget(20)):
        for _ in range(40):  # numbers of 2⁴⁰ digits, if nothing bounded them
            x = field.mul(x, x)


@pytest.mark.parametrize(
    ("name", "text"), [("QQ", "2"), ("QQ", "1/2"), ("RR", "sqrt(2)/3"), slow("QQ(x)", "x/2 + 1/3")]
)
def test_numbers_do_not_grow_without_end(name: str, text: str) -> None:
    with pytest.raises(Rejected):
        square_often(name, text)


@subcases(
    ("ring", "text", "why"),
    [
        (data.finite(2, 2), None, "GF.4. has to say its modulus"),
        (data.finite(5, 1, [0, 1]), None, "GF.5. takes no modulus"),
        (data.finite(2, 65), None, "of degree 65 over .* is too large"),
        (data.finite(2, 600), None, "of degree 600 over .* is too large"),
        (data.finite(10**200, 1), None, "of degree 1 over .* is too large"),
        (data.finite(2, 2, [1, 1, 0, 0, 1]), None, "is monic, of the degree 2"),
        (data.finite(2, 2, [1, 1, 2]), None, "is monic, of the degree 2, reduced modulo 2"),
        (data.functions(data.QQ, "x" * 101), None, "a variable has 101 characters"),
        (data.generated([1, *[10**3990] * 6, 1]), None, "at most 20000 are read"),
        (data.residues(10**5000), None, "a number in them is too long"),
        (data.finite(3, 40), "x", "what x is in GF.* is not known here"),
        (data.functions(data.QQ, "x"), "1/(x^2001 + x + 1) + x", "a degree above 2000"),
        (data.RR, "sqrt(1000000007)", "is not taken apart here"),
        (data.RR, "*".join(f"(1+sqrt({p}))" for p in (2, 3, 5, 7, 11, 13)), "too many square roots"),
        (data.RDF, "1/2", "."),
        (data.RDF, "9007199254740992", "below 2.53"),
    ],
)  # fmt: skip
def test_what_is_too_large_or_unknown(ring: Data, text: str | None, why: str) -> None:
    def reads() -> None:
        with bounded():
            read_ring(ring).read(text or "0")

    with pytest.raises(Rejected, match=why):
        reads()


def test_bounds_of_single_rings() -> None:
    floats, real, rationals = read_field("RDF"), read_field("RR"), read_field("QQ")
    assert floats.number(5) == 5
    assert real.sign(real.read("99/70 - sqrt(2)")) == 1
    # √2 = 1.41421356237309504880168872420969807…: these differ in the 33rd digit
    assert real.sign(real.read("1414213562373095048801688724209698/10**33 - sqrt(2)")) == -1
    assert real.sign(real.read("1414213562373095048801688724209699/10**33 - sqrt(2)")) == 1
    with pytest.raises(Rejected, match="infinitely many elements"):
        rationals.elements()
    functions = read_field("QQ(x)")
    with pytest.raises(Rejected, match="above the degree 2000"):
        functions.is_square(functions.read("x^2002"))
    with pytest.raises(Rejected, match="neither divides 15 nor is prime to it"):
        read_field("QQ(sqrt(15))").place(data.number(9))
