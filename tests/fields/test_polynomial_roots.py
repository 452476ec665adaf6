"""Roots of polynomials as numbers, without radicals: against the polynomial, numpy, and their own texts."""

import pickle

import flint
import numpy as np
import pytest

from hfield import CC, RR, CoercionError
from hfield.fields.algebraic import conjugate_pairs
from hfield.fields.base.roots import divided
from tests.subcases import subcases

QUINTIC = (-1, -1, 0, 0, 0, 1)


def root(n, kind="rootof", c=QUINTIC, ring=CC):
    return ring(f"{kind}({n},{','.join(map(str, c))})")


def test_they_are_roots():
    roots = [root(n) for n in range(5)]
    for z in roots:
        assert z**5 - z - 1 == 0
        assert z**5 - z != 0
    assert sum(roots[1:], roots[0]) == 0
    near = [complex(z.ball(64).real.mid(), z.ball(64).imag.mid()) for z in roots]
    assert np.allclose(np.sort_complex(near), np.sort_complex(np.roots(QUINTIC[::-1])))
    assert [z.is_real() for z in roots] == [True, False, False, False, False]
    assert near[1].imag > 0 > near[2].imag


@pytest.mark.parametrize("n", [1, 3])
def test_pairs(n):
    t, norm = root(n, "rootof_trace", ring=RR), root(n, "rootof_norm", ring=RR)
    assert root(n) + root(n + 1) == t
    assert root(n) * root(n + 1) == norm
    assert root(n) ** 2 - t * root(n) + norm == 0


def test_texts_hashes_and_pickles():
    for z in (root(0), root(1) + 2, root(3, "rootof_trace") * root(0) - RR("sqrt(2)"), 1 / root(2)):
        again = CC(z.text())
        assert again == z
        assert hash(again) == hash(z)
        assert pickle.loads(pickle.dumps(z)) == z
    assert "operatorname" in root(0).text("latex")


def test_factors_over_the_reals():
    x6 = [1, 0, 1, 0, 0, 0, 1]  # x^6 + x^2 + 1, with two roots on the imaginary axis
    factors = RR.irreducible_factors([RR(c) for c in x6])
    assert sorted(map(len, factors)) == [3, 3, 3]
    product = [RR.one]
    for f in factors:
        product = [
            sum((product[k] * f[n - k] for k in range(len(product)) if 0 <= n - k < 3), RR.zero)
            for n in range(len(product) + 2)
        ]
    assert [float(c.ball(64).real.mid()) for c in product] == pytest.approx(x6)
    assert [len(f) for f in CC.irreducible_factors([CC(c) for c in QUINTIC])] == [2] * 5
    assert RR.irreducible_factors([RR(-2), RR(0), RR(0), RR(1)])[0][0] == -RR("root(2,3)")


@subcases(
    "text",
    [
        "rootof(5,-1,-1,0,0,0,1)",
        "rootof(-1,-1,-1,0,0,0,1)",
        "rootof(0,-2,0,1)",
        "rootof(0,-2,-2,0,0,0,2)",
        "rootof(0,-1,0,0,1)",
        "rootof(1/2,-1,-1,0,0,0,1)",
        "rootof_trace(0,-1,-1,0,0,0,1)",
        "rootof_norm(2,-1,-1,0,0,0,1)",
        "rootof(0)",
        "rootof(sqrt(2),1,2,3,4)",
    ],
)
def test_what_is_no_root(text):
    with pytest.raises(CoercionError, match="takes"):
        CC(text)
    with pytest.raises(CoercionError, match="not real"):
        RR("rootof(1,-1,-1,0,0,0,1)")


def test_bounds_hold_for_sums_and_products_of_two():
    """Of x⁵ − x − 1, with the symmetric group: all are integers, so that heights are means of logarithms."""
    roots = np.roots(QUINTIC[::-1])
    pairs = [(z, w) for n, z in enumerate(roots) for w in roots[:n]]
    for number, values in [
        (root(1, "rootof_trace"), [z + w for z, w in pairs]),
        (root(1, "rootof_norm"), [z * w for z, w in pairs]),
        (root(0) + 2 * root(1), [z + 2 * w for z in roots for w in roots if z != w]),
        (root(0) ** 3 * root(3) - 7, [z**3 * w - 7 for z in roots for w in roots if z != w]),
        (2 * root(2) ** 40 + 1, 2 * roots**40 + 1),
    ]:
        height = np.log(np.maximum(abs(np.array(values)), 1)).mean()
        assert 0 < height <= number.bounds.height
        assert len(values) <= number.bounds.degree
    assert (root(0) + 2 * root(1)).bounds.degree == 20


def test_numbers_of_one_field_are_polynomials_in_its_root():
    """Of degree 5, by identities that no enclosure of small precision would show, and by floats."""
    a, z = root(0, ring=RR), root(1)
    for x in (a, z):
        y = (3 * x**4 - x / 7 + 2) / (x * x + 1)
        assert y * (x * x + 1) == 3 * x**4 - x / 7 + 2
        assert y - y == 0
        assert 1 / (1 / y) == y
        value = complex(x.ball(64).real.mid(), x.ball(64).imag.mid())
        expected = (3 * value**4 - value / 7 + 2) / (value**2 + 1)
        assert complex(y.ball(64).real.mid(), y.ball(64).imag.mid()) == pytest.approx(expected)
        assert y.text().startswith("rootof(")
        assert CC(y.text()) == y
    assert (a + 1).text() in ("1+rootof(0,-1,-1,0,0,0,1)", "rootof(0,-1,-1,0,0,0,1)+1")
    assert a**20 + a != a**20 + z


def test_numbers_of_degree_2_in_larger_fields_are_written_with_roots():
    a = RR("rootof(3,1,0,-10,0,1)")  # √2 + √3
    cube = (a**3 - 9 * a) / 2
    assert cube.text() == "sqrt(2)"
    assert cube == RR("sqrt(2)")
    assert hash(cube) == hash(RR("sqrt(2)"))
    assert cube**2 == 2
    z = CC("rootof(0,1,0,0,0,1)")  # a primitive 8th root of unity
    assert (z + 1 / z).text().startswith("sqrt(2)") or (z + 1 / z).text() == "-sqrt(2)"
    assert (z * z).text() in ("I", "-I")
    assert (z + 1 / z).is_real()
    assert not z.is_real()
    assert not (z * z).is_real()


@pytest.mark.parametrize(
    "c",
    [
        QUINTIC,
        (3, 0, 1, 0, 2),  # in x^2: two pairs have the same sum
        (1, 0, 0, 0, 1),
        (2, 1, -1, 3, 0, 0, 5),
        (1, 1, 1, 1, 1, 1, 1),  # all of absolute value 1
        (1, 0, -1, 0, 0, 1, 0, 0, 7),
    ],
)
def test_sums_and_products_of_conjugate_roots(c):
    """Against numpy; x² − t·x + n divides the polynomial, in the field of t and n."""
    found = conjugate_pairs.factors(flint.fmpq_poly(list(c)), True, [])
    near = np.roots(c[::-1])
    pairs = sorted((2 * z.real, abs(z) ** 2) for z in near if z.imag > 1e-9)
    seen = []
    for f in found:
        rest = divided(RR, [RR(x) for x in c], f)[1]
        assert rest == []
        if len(f) == 3:
            seen.append((-float(f[1].ball(64).real.mid()), float(f[0].ball(64).real.mid())))
    assert np.allclose(sorted(seen), pairs)
    assert sum(len(f) - 1 for f in found) == len(c) - 1
