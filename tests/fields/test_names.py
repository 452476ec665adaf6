"""From text to ring: canonical names, spellings, and errors that say what to mend."""

import copy
import pickle

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield.errors import CoercionError, HFieldError, RingError
from hfield.fields import CC, GF, QQ, RDF, RR, ZZ, Zmod
from hfield.fields.finite.ring import ExtensionField
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.names import ring
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.polynomial_rings import PolynomialRing
from tests.steps import steps
from tests.subcases import subcases

CANONICAL = {
    "QQ": ["Q", " Q Q ", "ℚ"],
    "ZZ": ["Z", "ℤ"],
    "RR": ["R", "ℝ"],
    "CC": ["C"],
    "RDF": ["RDF "],
    "ZZ/6": ["ZZ / 6", "Z6", "ZZ6", "Z/6", "Zmod(6)", "ZZ/(6)", "Z/6Z", "ZZ/6ZZ"],
    "ZZ/8589934592": ["ZZ/2^33", "Z/2**33", "ZZ/(2^33)", "Zmod(2^32+2^32)", "ZZ/2³³", "Z/2^33Z"],
    "GF(1000000007)": ["GF(10^9+7)", "GF(10**9 + 7)", "GF(10⁹+7)", "GF(2*5*10^8+7)"],
    "GF(7)": ["GF7", "F7", "F_7", "GF( 7 )", "GF(7^1)"],
    "GF(9)": ["GF9", "F9", "GF(3^2)", "GF(3**2)", "GF( 9, x^2+2*x+2)", "GF(9, x**2 - x - 1)"],
    "GF(256)": ["GF(2^8)", "GF(2**8)", "GF 256", "GF2^8", "GF(2⁸)"],
    "GF(9, x^2+1)": [
        "GF(9,x^2+1)",
        "GF(9, 1*x^0+0*x+1*x^2)",
        "GF(9, 2*x^2+2)",
        "GF(3^2, x² + 1)",
        "GF(9, x*x+1)",
        "GF(9, x^2-2)",
        "GF(9, (x+1)*(x-1)+2)",
    ],
    "QQ(sqrt(2))": ["Qsqrt2", "QQ(sqrt(8))", "QQ(sqrt2)", "QQ(sqrt(1/2))", "QQ(√2)", "ℚ(√2)"],
    "QQ(sqrt(-7))": ["Qsqrt-7", "QQ(sqrt(-28))", "QQ(sqrt(−7))"],
    "QQ(I)": ["QI", "QQ(sqrt(-1))", "Q(I)", "QQ(sqrt(-4))"],
    "QQ(x)": ["Qx", "Q(x)", "QQ( x )"],
    "GF(2)(t)": ["GF2t", "F2t", "GF(2) (t)"],
    "GF(4)(t)": ["GF4t", "GF(2^2)(t)"],
    "GF(9, x^2+1)(t)": ["GF(9,x^2+1)(t)"],
    "ZZ[a,b,c]": ["ZZ[ a, b, c ]", "Z[a,b,c]"],
    "QQ[x,y]": ["Q[x,y]"],
    "QQ(x,y)": ["Q(x, y)"],
    "GF(4)(s,t)": ["GF4(s,t)", "GF(2^2)( s , t )"],
    "GF(3)(t)[u]/(u^2+2*t^3+t)": ["GF(3)(t)[u]/(u^2-t^3+t)", "GF3t[u]/(-u²+t^3-t)"],
    "QQ(x)[u]/(u^2-1/x*u-x)": ["QQ(x)[u]/(x*u^2 - u - x^2)"],
    "Qp(5)": ["QQ_5", "Q_5", "Qp( 5 )", "QQp(5)", "ℚ_5"],
    "GF(9)((t))": ["GF9((t))", "GF(9)(t)_t", "GF(9)(t)_(t)"],
    "QQ(I)_(5, I-2)": ["QI_(5,I-2)"],
    "QQ(sqrt(2))_inf-": ["QQ(√2)_inf-"],
    "QQ[s]/(s^3-2)_inf1": ["QQ[s]/(s^3 - 2)_(inf1)"],
    "QQ(sqrt(2))_(3)": ["QQ(sqrt(2))_3", "QQ(sqrt(8))_3"],
    "GF(3)(t)_(t^2+1)": ["GF3t_(t^2+1)"],
    "GF(3)(t)_inf": ["GF(3)(t)_∞"],
    "GF(5)[x,y]": ["GF5[x,y]"],
}


@subcases("name", CANONICAL)
def test_canonical(name):
    F = ring(name)
    assert F.name == repr(F) == str(F) == name
    assert ring(F) is F
    for spelling in CANONICAL[name]:
        assert ring(spelling) == F, spelling
        assert hash(ring(spelling)) == hash(F)
    again = pickle.loads(pickle.dumps(F))
    assert again == copy.deepcopy(F) == F
    assert type(again) is type(F)
    assert again is pickle.loads(pickle.dumps(F)) is pickle.loads(pickle.dumps(again))


MADE = [
    QuadraticField(2), NumberField("x^2-x-1", "s"), FunctionField(ring("GF(4)"), "t"),
    ExtensionField(3, 2, [1, 0, 1]), ExtensionField(3, 2), PolynomialRing(ZZ, ("a", "b")),
    NumberField("s^3-2").completion("inf1"),
]  # fmt: skip


@pytest.mark.parametrize("F", MADE, ids=str)
def test_rings_that_no_name_made_pickle(F):
    again = pickle.loads(pickle.dumps(F))
    assert again == F == ring(F.name)
    assert type(again) is type(F)
    assert again is pickle.loads(pickle.dumps(F))


def test_fractions_of_polynomials():
    assert ring("ZZ[x]").fractions == ring("QQ[x]").fractions == ring("QQ(x)")
    assert ring("GF(5)[t]").fractions == ring("GF(5)(t)")
    assert ring("QQ[x,y]").fractions is None


def test_constructors():
    assert GF(9) == GF("9") == GF("3^2") == GF(9, "x^2+2*x+2") == ring("GF(9)")
    assert GF(9, "x^2+1") == ring("GF(9, x^2+1)") != GF(9)
    assert ZZ / 6 == Zmod(6) == ring("ZZ/6")
    assert [ring(F.name) for F in (QQ, ZZ, RR, CC, RDF)] == [QQ, ZZ, RR, CC, RDF]
    assert ring("ZZ/7") != ring("GF(7)")
    assert ring("ZZ/7").is_field
    assert not ring("ZZ/6").is_field


REFUSED = {
    "": "empty",
    "FOO": "known rings: QQ",
    "QC": "there is no ring",
    "GG(9)": r"did you mean GF\(9\)",
    "qq": "did you mean QQ",
    "GF(6)": r"6 = 2 \* 3 is not a prime power.* nearest are GF\(5\) and GF\(7\)",
    "GF(0)": "not a prime power",
    "GF(1)": r"smallest is GF\(2\)",
    "GF(-3)": "not a prime power",
    "GF(1000000)": r"2\^6 \* 5\^6",
    "GF(10^30)": "not a prime power",
    "GF(10^9+8)": "GF\\(1000000008\\).* not a prime power",
    "GF(2^100000+1)": "too large",
    "GF(18/2)": "expected the number of elements",
    "GF()": "expected the number of elements",
    "GF": "there is no ring",
    "GF(x)": "expected the number of elements",
    "GF(2.0)": "expected the number of elements",
    "GF(3^-2)": "expected a prime power",
    "GF(2^100000)": "too large",
    "GF(2^600)": "degree 512",
    "GF(" + "9" * 5000 + ")": "too large",
    "GF(2^9999999999999999999)": "too large",
    "GF(4, x^2)": r"x\^2 = \(x\)\^2 is reducible.*x\^2\+x\+1",
    "GF(4, x^2+1)": r"\(x\+1\)\^2 is reducible",
    "GF(25, x^2+1)": r"\(x\+2\)\*\(x\+3\)|\(x\+3\)\*\(x\+2\)",
    "GF(4, x^3+x+1)": "needs a modulus of degree 2.*of degree 3",
    "GF(4, 0)": "zero polynomial",
    "GF(4, 2*x^2+x)": "of degree 1",
    "GF(4, y^2+y+1)": "'y' means nothing",
    "GF(4, x^2+x+1/2)": "integers",
    "GF(4, x^-2)": "degree -2",
    "GF(4, x^999999)": "too large",
    "GF(4,)": "cannot be read",
    "GF(4, x^2+)": "cannot be read",
    "GF(5, x)": "prime field",
    "GF(9": "closing",
    "GF(9))": "there is no ring|brackets",
    "GF(9]": "brackets",
    "ZZ/0": "write ZZ",
    "ZZ/1": "zero ring",
    "ZZ/-6": "write ZZ/6",
    "ZZ/x": "there is no ring",
    "ZZ/(12/2)": "there is no ring",
    "ZZ/2^3-1": "there is no ring",
    "ZZ/2^5000": "n of 5001 bits is too large",
    "ZZ/2^500000": "too large",
    "ZZ/" + "9" * 5000: "too large",
    "QQ(sqrt(4))": "write QQ",
    "QQ(sqrt(0))": "write QQ",
    "QQ(sqrt(4/9))": "write QQ",
    "QQ(sqrt(x))": "expected an integer",
    "QQ(sqrt())": "sqrt",
    "QQ(sqrt(2),x)": "write its polynomial",
    "GF(3)(sqrt(2))": "QQ only",
    "QQ(x)(y)": "rational functions",
    "RR(x,y)": "rational functions are over",
    "QQ(x,x)": "twice",
    "QQ(x,zeta5)": "reads like a constant",
    "QQ[zeta5]": r"the field that it generates is QQ\(zeta5\)",
    "ZZ[x,zeta_5]": "zeta_5 is a number",
    "GF(4)(s,x)": "already names the generator",
    "GF(3)(t)[u]/(u^2-t^2)": r"reducible.*t \+ u",
    "GF(3)(t)[u]/(u)": "degree from 2",
    "GF(3)(t)[u]/(t)": "degree from 2",
    "GF(3)(t)[u]/(u^2-1/u)": "no u in a denominator",
    "GF(3)(t)[u]/(u^2-w)": "cannot be read",
    "GF(9)(t)[u]/(u^2-t^2)": "its discriminant is a square",
    "GF(4)(t)[u]/(u^3-t)": "not decided over",
    "ZZ[u]/(2*u^2-2)": "leading coefficient has no inverse",
    "Qp": r"write Qp\(5\)",
    "QQp": r"write Qp\(5\)",
    "Qp(6)": r"6 = 2 \* 3 is not a prime",
    "Qp(1)": "1 is not a prime",
    "Qp(x)": "expected a prime number",
    "Qp(-5)": "expected a prime number",
    "QQ_6": "not a place of QQ",
    "QQ(x)_x": "not a local field",
    "QQ(I)_5": "is not a single place",
    "GF(3)(t)_(t^2-1)": "not a place of GF",
    "GF(9)((x))": "already names the generator",
    "GF(9)((zeta))": "reads like a constant",
    "GF(4)(x)": "already names the generator",
    "ZZ(x)": "rational functions are over",
    "RR(x)": "rational functions are over",
    "QQ(e)": "clash",
    "QQ(i)": r"clash.*QQ\(I\)",
    "QQ[i]": "clash",
    "QQ[x,k]": "clash",
    "Qj": "clash",
    "QQ[I]": "imaginary unit",
    "QQ[norm]": "word of the language",
    "QQ[x,x]": "twice",
    "QQ[]": "not the name of a variable",
    "QQ[2]": "not the name of a variable",
    "QQ[x+y]": "not the name of a variable",
    "GF(4)[y]": "polynomials are over",
    "ZZ/6[x]": "polynomials are over",
    "QQ[x][y]": "polynomials are over",
    "ZZ[" + ",".join(f"x{n}" for n in range(100)) + "]": "at most 64",
    "x" * 20_000: "at most",
    "QQ(" * 500: "closing",
    "__import__('os')": "there is no ring|brackets|variable",
}


READ_LIKE_CONSTANTS = [
    "zeta5",
    "zeta_5",
    "omega",
    "alpha",
    "beta2",
    "pi",
    "phi",
    "tau",
    "Qp",
    "QQ5",
    "Q5",
    "GF9",
    "F9",
    "Z6",
    "i5",
    "i_5",
    "j2",
    "e1",
    "E",
    "I5",
    "root2",
    "sqrt_2",
    "golden",
    "inf",
    "oo",
    "exp",
    "lambda",
    "R",
    "Q",
    "Zmod",
    "π",
    "ω",
    "ζ5",
]


@subcases("name", READ_LIKE_CONSTANTS)
@subcases("base", ["QQ", "GF(5)"])
def test_what_reads_like_a_constant_is_no_variable_in_round_brackets(base, name):
    if base == "QQ" and name in ("zeta5", "zeta_5", "ζ5"):
        assert ring(f"{base}({name})").degree == 4
        return
    with pytest.raises(RingError, match="reads like a constant") as error:
        ring(f"{base}({name})")
    assert f"{base}(t)" in str(error.value)


@subcases(
    "name",
    [
        "x",
        "t",
        "z",
        "u_2",
        "x1",
        "a",
        "b",
        "abc",
        "y",
        "z2",
        "p",
        "q",
        "T",
        "X",
        "w",
        "pt",
        "factor",
    ],
)
def test_what_reads_like_a_variable_is_one(name):
    assert ring(f"QQ({name})").gen_name == name


def test_square_brackets_hold_variables_also_if_they_read_like_constants():
    assert ring("QQ[alpha,pi]").variables == ("alpha", "pi")
    assert ring("ZZ[alpha]").fractions.names()["alpha"]


@subcases("text", REFUSED)
def test_refused(text):
    with pytest.raises(RingError, match=REFUSED[text]) as error:
        ring(text)
    assert len(str(error.value)) < 400
    assert "\n" not in str(error.value)


def str_of(value):
    return repr(value) if not isinstance(value, int) or abs(value) < 10**9 else "large"


@subcases("q", [6, 0, 1, -3, 10**5000, 2**5000, "x", 2.0, None, [9], "9,x"])
def test_field_constructor_refuses(q):
    with pytest.raises(RingError):
        GF(q)


@pytest.mark.parametrize("n", [0, 1, -6, "x", 2.5, None, 10**5000, -(10**5000)], ids=str_of)
def test_residue_constructor_refuses(n):
    with pytest.raises(RingError):
        Zmod(n)


@pytest.mark.parametrize("spec", [None, 7, ["QQ"], b"QQ"])
def test_only_texts_name_rings(spec):
    with pytest.raises(RingError, match="not the name of a ring"):
        ring(spec)


def test_large_primes_take_few_steps():
    p = 10**100 + 267
    F = GF(p)
    x = F(3)
    assert x * F.inverse(x) == 1
    assert sum((y * y for y in F.minus_one_as_squares()), F.one) == 0
    assert steps(F.minus_one_as_squares) < 1_000


MIXED = ("GF(4)", "GF(8)", "GF(9)", "GF(9, x^2+1)", "GF(9, x^2+x+2)", "GF(25)", "QQ(sqrt(2))",
         "QQ(sqrt(3))", "QQ(x)", "QQ(t)", "GF(2)(t)", "GF(4)(t)", "ZZ[a,b]", "ZZ[b,a]", "QQ[a,b]",
         "GF(5)[a,b]", "GF(7)[a,b]")  # fmt: skip


@subcases("name", MIXED)
def test_elements_of_other_rings_are_refused(name):
    F = ring(name)
    for other in MIXED:
        if other == name or other == f"{name[:5]}" or F.name.startswith(other + "("):
            continue
        with pytest.raises(CoercionError) as error:
            F(ring(other).gen)
        assert name in str(error.value)


def test_both_fields_are_named():
    with pytest.raises(CoercionError, match=r"x of GF\(4\) is not an element of GF\(8\)"):
        GF(8)(GF(4).gen)
    with pytest.raises(
        CoercionError, match=r"GF\(9\), with another modulus.*not an element of GF\(9\)"
    ):
        GF(9)(GF(9, "x^2+1").gen)
    with pytest.raises(CoercionError, match=r"1 of GF\(5\) is not an element of GF\(7\)"):
        GF(7)(GF(5)(1))
    with pytest.raises(CoercionError, match=r"GF\(5\)"):
        GF(25)(GF(5)(1))
    with pytest.raises(CoercionError, match=r"QQ\(t\) is not an element of QQ\(x\)"):
        ring("QQ(x)")(ring("QQ(t)").gen)


def test_subrings_enter():
    assert ring("QQ(sqrt(2))")(QQ("1/2")) == ring("QQ(sqrt(2))")("1/2")
    assert ring("GF(4)(t)")(GF(4).gen) == ring("GF(4)(t)")("x")
    assert ring("QQ(x)")(QQ("1/2")) * 2 == 1
    assert ring("QQ[x,y]")(QQ("1/2")) * 2 == 1
    assert RR(ring("QQ(sqrt(2))").gen) ** 2 == 2
    assert CC(RR("sqrt(2)")) == RR("sqrt(2)")
    assert QQ(ZZ(3)) == 3


def test_denominators_that_vanish():
    for name in ("GF(2)", "GF(4)", "ZZ/6", "GF(2)(t)", "GF(4)(t)"):
        with pytest.raises(HFieldError, match=r"1/2|denominator|divide"):
            ring(name)("1/2")
    from fractions import Fraction

    with pytest.raises(
        ZeroDivisionError, match=r"1/2 is not an element of GF\(4\): .* characteristic is 2"
    ):
        GF(4)(Fraction(1, 2))
    with pytest.raises(CoercionError, match="1/2 is not an integer"):
        ZZ(Fraction(1, 2))


PIECES = st.sampled_from(
    ["GF", "QQ", "ZZ", "RR", "F", "Q", "Z", "(", ")", "[", "]", ",", "2", "9", "4", "x", "t", "^", "+",
     "-", "*", "/", "sqrt", "I", "i", "e", " ", "−", "²", "√", "1.5", "==", "and", "'", "\\", "\n", "é"]
)  # fmt: skip


@given(st.lists(PIECES, max_size=9).map("".join))
@settings(max_examples=400, deadline=None)
def test_any_text_is_a_ring_or_a_clear_error(text):
    try:
        F = ring(text)
    except RingError:
        return
    assert ring(F.name) == F


@given(
    st.lists(PIECES, max_size=9).map("".join),
    st.sampled_from(
        ["GF(9)", "QQ", "RR", "CC", "RDF", "QQ(sqrt(2))", "GF(4)(t)", "ZZ[a,b]", "ZZ/6"]
    ),
)
@settings(max_examples=400, deadline=None)
def test_any_text_is_an_element_or_a_clear_error(text, name):
    F = ring(name)
    try:
        x = F(text)
    except HFieldError:
        return
    assert F.equal(F(F.text(x)), x)
