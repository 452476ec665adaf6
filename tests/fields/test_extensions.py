"""Extensions of fields of rational functions: against polynomials, and by the laws of a field."""

import pickle
from itertools import product
from random import Random

import pytest

from hfield.errors import HFieldError, NotInvertibleError
from hfield.fields.base.roots import divided, stripped
from hfield.fields.function_fields.extensions import ExtensionElement
from hfield.fields.names import ring
from tests.subcases import subcases
from tests.thorough import quick_part

NAMES = (
    "GF(3)(t)[u]/(u^2-t^3+t)", "QQ(x)[u]/(u^3-x)", "QQ(x,y)[u]/(u^2-x*y)", "GF(4)(s,t)",
    "GF(5)(t)[u]/(u^3+t*u+1)", "GF(9)(t)[u]/(u^2-t)",
)  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_it_is_a_field(name: str) -> None:
    F = ring(name)
    rng = Random(7)
    drawn = [F.random(rng) for _ in range(3)]
    drawn += [F.gen, F.gen + 1, F.one, -F.gen * F.gen, F(F.names()[sorted(F.names())[0]])]
    for x, y in quick_part(list(product(drawn, drawn)), 3):
        assert x * (y + 1) == x * y + x
        assert (x - y, y - x) == (x + -y, -(x - y))
        if not F.is_zero(y):
            assert x / y * y == x
            assert F.inverse(y) * y == 1
            assert (3 / y) * y == 3
            assert y**-2 * y * y == 1
        assert (x == y) == F.equal(x, y) == F.is_zero(x - y)
        assert (F.key(x) == F.key(y)) == (x == y)
    for x in drawn:
        assert F(F.text(x)) == x
        assert pickle.loads(pickle.dumps(x)) == x
        assert hash(pickle.loads(pickle.dumps(x))) == hash(x)
        assert (x**3, x**0, +x, repr(x)) == (x * x * x, 1, x, F.text(x))
        assert (5 - x, 5 + x, x - 5) == (-(x - 5), x + 5, x + -5)
        assert len(x.coefficients) == F.degree
        assert x.__add__("1") is NotImplemented
        assert x.__mul__("1") is NotImplemented
        assert x.__sub__("1") is NotImplemented
        assert x.__truediv__("1") is NotImplemented
        assert x != "1"
        with pytest.raises(AttributeError, match="are immutable"):
            x.field = None
    total = sum((c * F.gen**n for n, c in enumerate(map(F, F.modulus_coefficients))), F.zero)
    assert F.is_zero(total)
    assert not any(F.is_zero(F.gen - c) for c in range(3))
    with pytest.raises(NotInvertibleError, match="cannot divide by 0 in"):
        F.inverse(F.zero)


@pytest.mark.parametrize("name", ["QQ(x)", "GF(5)(t)", "QQ(x,y)"])
def test_division_of_polynomials_over_functions(name: str) -> None:
    base = ring(name)
    rng = Random(3)
    for m, n in product(range(1, 6), range(1, 5)):
        f, g = ([base.random(rng) for _ in range(k - 1)] + [base.gen + k] for k in (m, n))
        quotient, rest = divided(base, f, g)
        back = [base.zero] * max(len(quotient) + len(g), len(f))
        for i, x in enumerate(quotient):
            for j, y in enumerate(g):
                back[i + j] = back[i + j] + x * y
        for i, x in enumerate(rest):
            back[i] = back[i] + x
        assert stripped(base, back) == stripped(base, f)
        assert len(rest) < len(g)
        assert not rest or not base.is_zero(rest[-1])
        assert len(quotient) == max(m - n + 1, 0)


def test_roots_from_below() -> None:
    F = ring("QQ(x)[u]/(u^2-x)")
    assert F.sqrt(F("x^2/4")) in (F("x/2"), -F("x/2"))
    for x in ("x", "u", "2"):
        with pytest.raises(
            HFieldError, match=r"square roots in QQ\(x\)\[u\]/\(u\^2-x\) are not decided"
        ):
            F.sqrt(F(x))
    G = ring("GF(5)(t)[u]/(u^2-t)")
    assert [x * x for x in G.minus_one_as_squares()] == [-1]
    assert ring("GF(3)(t)[u]/(u^2-t)").minus_one_as_squares() == ()


def test_elements_of_different_extensions_do_not_mix() -> None:
    F, G = ring("QQ(x)[u]/(u^2-x)"), ring("QQ(x)[u]/(u^2-x-1)")
    assert F.gen != G.gen
    with pytest.raises(HFieldError, match=r"cannot mix elements of .*u\^2-x\) and .*u\^2-x-1\)"):
        F.gen + G.gen
    with pytest.raises(HFieldError, match="is not an element of"):
        F(G.gen)
    with pytest.raises(HFieldError, match="is not an element of"):
        F(ring("QQ(y)").gen)
    assert F(ring("QQ(x)").gen) == F("x") == F.gen * F.gen
    assert F(F.gen) is not None
    assert isinstance(F(2), ExtensionElement)


@subcases(
    ("name", "said"),
    [
        ("QQ(x)[u]/(u^2-x^2)", "the polynomial is reducible, (x - u)*(x + u) up to a constant"),
        ("QQ(x)[u]/(u^2-2*x*u+x^2)", "the polynomial is reducible, (x - u)^2 up to a constant"),
        ("QQ(x)[u]/(2*u^2-2)", "reducible"),
        ("GF(3)(t)[u]/(u^3-t^3)", "reducible"),
        ("GF(9)(t)[u]/(u^2-t^2)", "reducible, for its discriminant is a square"),
        ("GF(9)(t)[u]/((u-1)*(u-t))", "reducible, for its discriminant is a square"),
        ("GF(9)(t)[u]/(u^2+2*u+1)", "reducible, for its discriminant is a square"),
        ("GF(9)(t)[u]/(u^3-t)", "whether the polynomial is irreducible is not decided over GF(9)(t)"),
        ("GF(4)(t)[u]/(u^2+u+t)", "whether the polynomial is irreducible is not decided over GF(4)(t)"),
        ("QQ(x)[u]/(u-x)", "expected a polynomial in u of a degree from 2 to 20"),
        ("QQ(x)[u]/(x)", "expected a polynomial in u of a degree from 2 to 20"),
        ("QQ(x)[u]/(u^21-x)", "its degree is not from 2 to 20"),
        ("QQ(x)[u]/(u^-1)", "its degree is not from 2 to 20"),
        ("QQ(x)[u]/(1/u)", "a polynomial in u has no u in a denominator"),
        ("QQ(x)[u]/(u^2-w)", "cannot be read: 'w' means nothing"),
        ("RR[u]/(u^2-2)", "extensions are taken of fields such as QQ(x), GF(3)(t) and QQ(x,y)"),
        ("GF(9)[u]/(u^2+1)", "extensions are taken of fields"),
        ("QQ(x)[x]/(x^2-2)", "already names the generator"),
    ],
)  # fmt: skip
def test_what_makes_no_extension(name: str, said: str) -> None:
    with pytest.raises(HFieldError) as caught:
        ring(name)
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("QQ(x)[u]/(2*x*u^2-1)", "QQ(x)[u]/(u^2+(-1/2)/x)"),
        ("QQ(x)[u]/(u^20-x)", "QQ(x)[u]/(u^20-x)"),
        ("QQ(x)[u]/((u+1)^2-x/(x+1))", "QQ(x)[u]/(u^2+2*u+1/(x+1))"),
        ("GF(9)(t)[u]/(u^2-x*t)", "GF(9)(t)[u]/(u^2+2*x*t)"),
        ("QQ(x,y)[u]/(u^2-x^2-y^2)", "QQ(x,y)[u]/(u^2-x^2-y^2)"),
        ("QQ(x)[u]/(u^2-1/(x^2*(x+1))-1/x^3)", None),
    ],
)
def test_names_of_extensions(name: str, words: str | None) -> None:
    F = ring(name)
    assert words is None or F.name == words
    assert ring(F.name) == F
    assert ring(F.name).modulus_coefficients == F.modulus_coefficients
