"""Heights, enclosures and sums of roots against sympy's numbers and bounds worked out by hand."""

import threading
from fractions import Fraction
from itertools import product
from math import inf, isclose, isqrt, log

import flint
import pytest
import sympy
from sympy import I, Pow, Rational, cos, exp, pi, sin, sqrt, tan

from hfield.errors import HFieldError, NotInvertibleError
from hfield.fields.algebraic.evaluate import evaluate, is_known
from hfield.fields.algebraic.heights import bounds
from hfield.fields.algebraic.radicals import surd_of
from hfield.fields.algebraic.surds import (
    Surd,
    as_surd,
    from_rational,
    principal,
    root_near,
    sqrt_rational,
    sympy_of,
)
from hfield.fields.base.balls import fingerprint, precision
from hfield.fields.names import ring
from tests.subcases import subcases

L2, L3, L5, L7 = log(2), log(3), log(5), log(7)


@subcases(
    ("expr", "height", "roots", "order", "degree"),
    [
        (Rational(-7, 3), L7, {}, 1, 1),
        (Rational(2, 9), log(9), {}, 1, 1),
        (Rational(0), 0.0, {}, 1, 1),
        (I, 0.0, {}, 4, 2),
        (sqrt(2), L2 / 2, {(2, 2): 2}, 1, 2),
        (sqrt(2) + sqrt(3), L2 / 2 + L3 / 2 + L2, {(2, 2): 2, (3, 2): 2}, 1, 4),
        (1 + sqrt(2) + I, L2 / 2 + L3, {(2, 2): 2}, 4, 4),
        (3 * sqrt(2), L3 + L2 / 2, {(2, 2): 2}, 1, 2),
        (Pow(3, Rational(2, 5)), 2 * L3 / 5, {(3, 5): 5}, 1, 5),
        (Pow(1 + sqrt(2), -2), 2 * (L2 / 2 + L2), {(2, 2): 2}, 1, 2),
        (Pow(sqrt(5) + 1, Rational(-1, 3)), (L5 / 2 + L2) / 3, {(5, 2): 2, (sqrt(5) + 1, 3): 3}, 1, 6),
        (cos(pi / 7), 2 * L2, {}, 28, 12),
        (sin(pi / 7), 2 * L2, {}, 28, 12),
        (tan(pi / 7), 4 * L2, {}, 28, 12),
        (exp(2 * I * pi / 7), 0.0, {}, 28, 12),
        (cos(pi / 7) + I, 3 * L2, {}, 28, 12),
        (I * cos(pi / 9) * cos(pi / 7), 4 * L2, {}, 252, 72),
        (sympy.GoldenRatio, L2 + L5 / 2, {(5, 2): 2}, 1, 2),
    ],
)  # fmt: skip
def test_heights(expr, height, roots, order, degree) -> None:
    found = bounds(expr)
    assert isclose(found.height, height, abs_tol=1e-12)
    assert (found.roots, found.order, found.degree) == (roots, order, degree)


@subcases("expr", [
    pi, sympy.E, sympy.log(2), cos(1), exp(1 + I * pi / 3), Pow(2, sqrt(2)), sqrt(pi), pi + 1, 2 * pi,
    cos(sqrt(2) * pi), sympy.cosh(1), exp(pi / 3), sin(I * pi / 2), sqrt(sympy.log(3) + 1),
])  # fmt: skip
def test_what_is_not_seen_to_be_algebraic(expr) -> None:
    assert bounds(expr) is None


def test_heights_bound_those_of_the_minimal_polynomials() -> None:
    for expr, polynomial in (
        (sqrt(2) + sqrt(3), [1, 0, -10, 0, 1]),
        (Rational(3, 2) * sqrt(5) - 7, [151, 56, 4]),
        (Pow(2, Rational(1, 3)) + 1, [-3, 3, -3, 1]),
        (2 * cos(2 * pi / 7), [-1, -2, 1, 1]),
    ):
        roots = flint.fmpz_poly(polynomial).complex_roots()
        sizes = [max(1.0, abs(complex(z))) for z, _ in roots]
        true = (log(abs(polynomial[-1])) + sum(map(log, sizes))) / len(sizes)
        found = bounds(expr)
        assert true <= found.height
        assert len(sizes) <= found.degree


POWERS = [
    Pow(exp(I * pi / 7) + exp(-I * pi / 7), Rational(1, 3)),
    Pow(sqrt(2) * (1 + I) * (1 - I) - 5, Rational(1, 3)),
    Pow((2 + sqrt(3) * I) * (2 - sqrt(3) * I) - 9, Rational(2, 3)),
    *(Pow(b, Rational(*e)) for b in (Rational(-2), Rational(5, 3), sqrt(2) - 2, cos(pi / 7), 1 + I, -I)
      for e in ((1, 3), (2, 3), (-1, 2), (-5, 4), (-3, 1), (2, 1), (0, 1))),
    Pow(2, sqrt(2)), Pow(I, I), Pow(sqrt(3), sqrt(2)), Pow(-2, sqrt(2)), Pow(pi, Rational(-2, 3)),
    Pow(Rational(1, 2), I), Pow(1 + sqrt(2), 5), Pow(sympy.log(2), 3), Pow(sympy.log(2), -1),
]  # fmt: skip
OTHERS = [
    Rational(-7, 3), I, pi, sympy.E, 1 + sqrt(2) - I * pi, 2 * sqrt(3) * pi, exp(2), exp(I * pi / 3),
    cos(1), sin(2), tan(3), sympy.cosh(1), sympy.sinh(1), sympy.tanh(1), sympy.log(3), sympy.log(-2),
    sympy.Integer(0), pi - 3,
]  # fmt: skip


@subcases("expr", [*POWERS, *OTHERS])
def test_enclosures_are_those_of_sympy(expr) -> None:
    assert is_known(expr)
    with flint.ctx.workprec(120):
        ball = evaluate(expr)
        re, im = (flint.arb(str(part)) for part in sympy.N(expr, 30).as_real_imag())
        assert abs(ball.real - re) < 1e-25
        assert abs(ball.imag - im) < 1e-25
        assert ball.real.rad() < 1e-30
        assert ball.imag.rad() < 1e-30


def test_what_cannot_be_enclosed() -> None:
    x = sympy.Symbol("x")
    for expr in (
        x,
        x + 1,
        sqrt(x),
        2 * x,
        sympy.Float(0.5),
        sympy.zeta(3),
        cos(x),
        sympy.oo,
        sympy.nan,
    ):
        assert not is_known(expr)


# --- sums of square roots ---------------------------------------------------------------------------

ROOTS = [(1, 2), (1, -1), (2, 3), (1, -3, 5), (1, 2, 3, 6), (7,), (1,), (-1,), (-2, 3), (-2, -3)]
SURDS = [
    Surd(
        {n: flint.fmpq(c, 1 + (k + m) % 3) for k, (n, c) in enumerate(zip(roots, cs, strict=False))}
    )
    for roots in ROOTS
    for m, cs in enumerate([(1, 1, 1, 1), (-3, 2, 5, 1), (2, -7, -1, 4), (-1, -1, -1, -2)])
]


def value(x: Surd) -> complex:
    return sum(float(c.p) / float(c.q) * complex(n) ** 0.5 for n, c in x.terms.items())


@subcases("x", SURDS)
def test_powers_and_inverses_of_surds(x) -> None:
    one = from_rational(1)
    inverse = x.inverse()
    assert x * inverse == one
    assert x**0 == one
    for n in (1, 2, 3, 5):
        power = one
        for _ in range(n):
            power = power * x
        assert x**n == power
        assert x**-n * power == one
        assert x**-n == inverse**n
    assert 3 / x == 3 * inverse
    assert x / Fraction(2, 3) == x * Fraction(3, 2)
    assert (x - 5, 5 - x, +x) == (-(5 - x), -(x - 5), x)
    assert (x / x, x - x) == (1, 0)
    assert hash(x * x / x) == hash(x)
    if x.is_rational():
        assert hash(x) == hash(Fraction(int(x.terms[1].p), int(x.terms[1].q)))
    assert abs(value(x * x) - value(x) ** 2) < 1e-9
    assert sympy.expand(sympy_of(x) - sympy.N(value(x))).evalf(5).__abs__() < 1e-6
    assert surd_of(sympy.expand(sympy_of(x))) == x


@subcases("x", SURDS)
def test_parts_and_signs_of_surds(x) -> None:
    z = value(x)
    real, imaginary = x.real(), x.imaginary()
    assert real.is_real()
    assert imaginary.is_real()
    assert isclose(value(real).real, z.real, abs_tol=1e-9)
    assert isclose(value(imaginary).real, z.imag, abs_tol=1e-9)
    assert real + imaginary * Surd({-1: flint.fmpq(1)}) == x
    assert x.is_real() == (not imaginary.terms)
    assert x.conjugate_at(-1) == real - imaginary * Surd({-1: flint.fmpq(1)})
    assert real.sign() == (value(real).real > 1e-12) - (value(real).real < -1e-12)
    flipped = sum(
        (-1 if n == 2 else 1) * float(c.p) / float(c.q) * n**0.5 for n, c in real.terms.items()
    )
    assert real.sign(2) == (flipped > 1e-12) - (flipped < -1e-12)
    better = principal(x)
    assert better in (x, -x)
    w = value(better)
    assert w.real > 1e-12 or (abs(w.real) < 1e-12 and w.imag > -1e-12)
    for bits in (40, 200):
        ball = x.ball(bits)
        assert abs(complex(ball) - z) < 1e-8
        assert ball.real.rad() < 2.0 ** (20 - bits)
        assert ball.imag.rad() < 2.0 ** (20 - bits)
    assert fingerprint(x.ball) == tuple(
        int(sympy.floor(2**30 * p + pi)) for p in sympy_of(x).as_real_imag()
    )


def test_numbers_near_0_have_signs() -> None:
    root = isqrt(2 * 10**80)
    below = Surd({1: flint.fmpq(root, 10**40), 2: flint.fmpq(-1)})
    above = Surd({1: flint.fmpq(root + 1, 10**40), 2: flint.fmpq(-1)})
    assert (below.sign(), above.sign(), (-below).sign()) == (-1, 1, 1)
    assert (below.sign(2), Surd({}).sign(), Surd({5: flint.fmpq(-1)}).sign(5)) == (1, 0, 1)


@pytest.mark.parametrize("d", [2, 3, 5, -1, -3])
def test_square_roots_in_quadratic_fields_are_all_and_only_these(d: int) -> None:
    F = ring("QQ(I)" if d == -1 else f"QQ(sqrt({d}))")
    small = [Fraction(n, m) for n in range(-4, 5) for m in (1, 2)]
    squares = {}
    for a, b in product(small, small):
        y = a + b * F.gen
        squares[F.key(F(y * y))] = y
    for a, b in product(range(-4, 5), range(-4, 5)):
        x = F(a + b * F.gen)
        root = F.sqrt(x)
        norm = a * a - d * b * b
        # (u + v·√d)² = a + b·√d: the norm is a square, and u² = (a ± √norm)/2 one of a rational number
        fits = (
            norm >= 0
            and isqrt(norm) ** 2 == norm
            and any(square(Fraction(a + s * isqrt(norm), 2)) for s in (1, -1))
        )
        if b == 0:
            fits = square(Fraction(a)) or square(Fraction(a, d))
        assert (root is not None) == fits
        if root is not None:
            assert root * root == x
            assert root.as_surd() == principal(root.as_surd())
        assert F.key(x) not in squares or root is not None


def square(x: Fraction) -> bool:
    return x >= 0 and all(isqrt(n) ** 2 == n for n in (x.numerator, x.denominator))


def test_roots_of_rational_numbers() -> None:
    for p, q in product(range(-12, 13), range(1, 7)):
        x = flint.fmpq(p, q)
        root = sqrt_rational(x)
        assert root * root == x
        assert root == principal(root)
        near = root_near(x, 3)
        assert (near is not None) == square(Fraction(p, q) / 3)
        assert near is None or near == root
        for n in (1, 2, -1):
            assert sqrt_rational(x, n) == root


def test_real_roots_with_two_terms() -> None:
    R = ring("RR")
    for a, b, n in product(range(-6, 7), (-3, -2, -1, 1, 2, 3), (2, 3, 5)):
        x = R(f"{a}+{b}*sqrt({n})")
        if x.sign() <= 0:
            assert R.sqrt(x) is None or x == 0
            continue
        root = x.sqrt()
        s = a * a - b * b * n
        assert (root is not None) == (s >= 0 and isqrt(s) ** 2 == s)
        if root is not None:
            assert root * root == x
            assert root.sign() == 1
        closed = R.sqrt(x)
        assert closed * closed == x
        assert closed.sign() == 1


def test_surds_over_one_root() -> None:
    x = Surd({1: flint.fmpq(1, 2), 8: flint.fmpq(3)})
    assert x.over(2).terms == {1: flint.fmpq(1, 2), 2: flint.fmpq(6)}
    assert x.over(3) is None
    assert Surd({2: flint.fmpq(1), 3: flint.fmpq(1)}).over(2) is None
    assert Surd({5: flint.fmpq(2)}).over(5).terms == {5: flint.fmpq(2)}
    assert from_rational(Fraction(2, 3)).over(7).terms == {1: flint.fmpq(2, 3)}
    assert Surd({-8: flint.fmpq(1)}).over(2) is None


def test_surds_are_values() -> None:
    x = Surd({2: flint.fmpq(1)})
    with pytest.raises(AttributeError, match="are immutable"):
        x.terms = {}
    with pytest.raises(NotInvertibleError, match="cannot divide by 0"):
        Surd({}).inverse()
    assert as_surd(0.5) is None
    assert as_surd("1") is None
    for operation in ("__add__", "__sub__", "__rsub__", "__mul__", "__truediv__", "__rtruediv__"):
        assert getattr(x, operation)("1") is NotImplemented
    assert x != "1"
    assert x != 1
    assert repr(
        Surd({1: flint.fmpq(-1, 2), 2: flint.fmpq(1), -1: flint.fmpq(3), -7: flint.fmpq(-2)})
    ) == ("-1/2+sqrt(2)+3*I-2*I*sqrt(7)")
    y = Surd({1: flint.fmpq(1), -7: flint.fmpq(-2, 3)})
    assert [y.text(style, False) for style in ("plain", "unicode", "latex")] == [
        "1-2/3*sqrt(-7)", "1−2/3·√(−7)", r"1-\frac{2}{3}\sqrt{-7}"
    ]  # fmt: skip
    assert [y.text(style) for style in ("plain", "unicode", "latex")] == [
        "1-2/3*I*sqrt(7)", "1−2/3·I·√7", r"1-\frac{2}{3}I\sqrt{7}"
    ]  # fmt: skip


# --- closed forms -----------------------------------------------------------------------------------


@subcases(
    ("text", "plain", "unicode", "latex"),
    [
        ("pi", "pi", "π", r"\pi"),
        ("-pi/2", "-1/2*pi", "−1/2·π", None),
        ("root(2,3)^2+1", "1+root(2,3)^2", "1+root(2,3)^2", None),
        ("1/(1+pi)", "1/(1+pi)", "1/(1+π)", None),
        ("1/pi", "1/pi", "1/π", None),
        ("1/(2*pi)", "1/2*1/pi", "1/2·1/π", None),
        ("pi^3", "pi^3", "π^3", r"\pi^{3}"),
        ("(1+pi)^2", "1+2*pi+pi^2", "1+2·π+π^2", None),
        ("cos(pi/7)^2", "cos(1/7*pi)^2", "cos(1/7·π)^2", None),
        ("sqrt(1+sqrt(2))", "sqrt(1+sqrt(2))", "√(1+√(2))", r"\sqrt{1 + \sqrt{2}}"),
        ("exp(1)", "exp(1)", "exp(1)", "e"),
        ("exp(sqrt(2)*log(2))", "exp(sqrt(2)*log(2))", "exp(√(2)·log(2))", None),
        ("log(2)*sin(1)", "log(2)*sin(1)", "log(2)·sin(1)", None),
        ("3*root(5,4)", "3*root(5,4)", "3·root(5,4)", None),
        ("1/root(2,3)", None, None, None),
        ("2-pi", "2-pi", "2−π", None),
    ],
)
def test_closed_texts(text, plain, unicode, latex) -> None:
    R = ring("RR")
    x = R(text)
    shown = [R.text(x, style) for style in ("plain", "unicode", "latex")]
    for found, wanted in zip(shown, (plain, unicode, latex), strict=True):
        assert wanted is None or found == wanted
    assert R(R.text(x)) == x


@pytest.mark.parametrize(
    ("text", "sign", "is_zero"),
    [
        ("pi-355/113", -1, False),
        ("root(2,3)-5/4", 1, False),
        ("root(2,3)*root(4,3)-2", 0, True),
        ("cos(pi/7)*cos(2*pi/7)*cos(3*pi/7)-1/8", 0, True),
        ("root(7,3)+root(7,3)-root(56,3)", 0, True),
        ("sqrt(1+sqrt(2))^2-1-sqrt(2)", 0, True),
        ("sin(1)^2+cos(1)^2-1", 0, True),
        ("root(2,5)-root(3,8)", 1, False),
    ],
)
def test_signs_of_closed_forms(text, sign, is_zero) -> None:
    R, C = ring("RR"), ring("CC")
    x = R(text)
    assert R.sign(x) == sign
    assert R.is_zero(x) == is_zero
    assert R.sign(-x) == -sign
    assert C.equal(C(text), 0) == is_zero


def test_hidden_rational_numbers() -> None:
    R = ring("RR")
    for text, value in (
        ("root(2,3)^3/5", Fraction(2, 5)),
        ("cos(pi/5)-cos(2*pi/5)", Fraction(1, 2)),
        ("root(5*sqrt(2)+7,3)-root(5*sqrt(2)-7,3)", Fraction(2)),
    ):
        x = R(text)
        assert x == value
        assert hash(x) == hash(value)
        assert not R.equal(x, value + Fraction(1, 10**30))
    assert hash(R("cos(1)^2+sin(1)^2")) == hash(1)
    assert R("root(2,3)").rational(inf) is None


def test_numbers_that_are_refused() -> None:
    R, C = ring("RR"), ring("CC")
    for text, said in (
        ("root(2,65)", r"root\(x, n\) takes an integer n from 1 to 64, not 65"),
        ("root(2,0)", "takes an integer n from 1 to 64, not 0"),
        ("root(2,1/2)", "takes an integer n from 1 to 64, not 1/2"),
        ("sqrt(-2)", "is not an element of RR: it is not real; CC has it"),
        ("exp(10**7)", r"exp\(10000000\) is too large; at most exp\(10\^6\) is taken"),
        ("1/(sqrt(2)-sqrt(2))", "cannot divide by 0"),
        ("log(0)", "not a number"),
        ("root(2,x)", "'x' means nothing"),
    ):
        with pytest.raises(HFieldError, match=said):
            R(text)
    z = C("exp(I*pi/3)*root(2,3)")  # principal; root(-2,3) is real
    assert z != C("root(-2,3)") == R("root(-2,3)")
    assert R("root(-2,3)") == -R("root(2,3)")
    assert R("root(-2,1)") == -2
    assert R("root(2,64)") ** 64 == 2
    assert z * z * z == -2
    assert not z.is_real()
    assert (z * C("exp(I*pi/3)*root(4,3)") / C("exp(2*I*pi/3)") - 2).is_real()
    assert R("root(2,3)") / C("1/2") == R("2*root(2,3)")
    assert 2 / R("root(2,3)") == R("root(4,3)")
    assert (3 - R("pi")).sign() == -1
    assert R("pi") ** -2 * R("pi") ** 2 == 1
    assert +R("pi") == R("pi")
    assert R("pi").__add__("1") is NotImplemented
    assert R("pi").__truediv__("1") is NotImplemented
    assert (R("pi") == "pi") is False


def test_what_has_a_square_root() -> None:
    from hfield.fields.number_fields.embeddings import _is_square

    for p, q in product(range(-30, 31), range(1, 31)):
        assert _is_square(flint.fmpq(p, q)) == (p > 0 and square(Fraction(p, q)))


def test_one_thread_at_a_time_has_the_precision_of_flint() -> None:
    """It is one number for all threads: who comes in later would have another's, or leave it behind."""
    inside, before = threading.Event(), flint.ctx.prec
    found: list[int] = []

    def work() -> None:
        with precision(800):
            inside.set()
            found.append(flint.ctx.prec)

    thread = threading.Thread(target=work)
    with precision(64):
        thread.start()
        assert not inside.wait(0.1)
        assert flint.ctx.prec == 64
    thread.join()
    assert found == [800]
    assert flint.ctx.prec == before
