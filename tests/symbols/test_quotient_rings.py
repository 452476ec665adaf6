"""R[x]/(f) where f need not be irreducible: dual numbers, Gaussian integers."""

from itertools import product

import pytest
import sympy

from hfield import H, NotInvertibleError, RingError, ring
from hfield.errors import UndecidedError


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("QQ[x]/(x^2)", "QQ[x]/(x^2)"),
        ("QQ[x]/(2*x^2-2)", "QQ[x]/(x^2-1)"),
        ("ZZ[I]", "ZZ[I]"),
        ("ZZ[I]/(I^2+1)", None),
        ("ZZ[x]/(x^2-5)", "ZZ[x]/(x^2-5)"),
        ("GF(5)[e1]/(e1^2)", "GF(5)[e1]/(e1^2)"),
        ("QQ[x]/(x^3-2)", "QQ[x]/(x^3-2)"),
        ("ZZ[x]/(2*x^2)", None),
        ("QQ[x]/(x-1)", "QQ[x]/(x-1)"),
    ],
)
def test_names(text: str, name: str | None) -> None:
    if name is None:
        with pytest.raises(RingError):
            ring(text)
    else:
        assert ring(text).name == name


def test_dual_numbers_differentiate() -> None:
    R = ring("QQ[x]/(x^2)")
    f = R("(3 + x)^5 / (1 + (3 + x)^2)")
    y = sympy.Symbol("y")
    g = y**5 / (1 + y**2)
    assert f == R(g.subs(y, 3)) + R(sympy.diff(g, y).subs(y, 3)) * R.gen
    with pytest.raises(NotInvertibleError):
        R("1/x")
    assert H(R)("x*i").annihilator() is not None


def test_units_and_annihilators_of_a_finite_quotient_by_trying_all() -> None:
    R = ring("GF(3)[x]/(x^2-x)")
    elements = [R(a) + R(b) * R.gen for a, b in product(range(3), repeat=2)]
    for z in elements:
        assert R.is_unit(z) == any(z * w == R.one for w in elements)
        kills = [w for w in elements if w != R.zero and z * w == R.zero]
        assert (R.annihilator(z) in kills) if kills else R.annihilator(z) is None


def test_gaussian_integers() -> None:
    R = ring("ZZ[I]")
    assert ring(sympy.ZZ_I) is R
    assert R(2 + 3 * sympy.I) == R("2+3*I")
    assert [R.is_unit(R(text)) for text in ("1", "I", "-I", "1+I", "2")] == [True] * 3 + [False] * 2
    assert H(R)("1 + I*i").norm() == 0
    assert H(R)("1 + I*i").change_ring("QQ(I)") == H("QQ(I)")("1 + I*i")
    with pytest.raises(UndecidedError):
        R.sqrt(R(2))
