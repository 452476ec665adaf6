"""Lower bounds of regulators, lists of short integers, and constants of Zimmert and Hermite, recomputed."""

import itertools
import json
import math
from fractions import Fraction
from random import Random

import flint
import pytest

from hfield import ring
from hfield.checker.number_fields import regulator
from hfield.checker.number_fields.bounds import (
    HERMITE_POWERS,
    ZIMMERT_FACTORS,
    short_length,
)
from hfield.checker.number_fields.integers import RingOfIntegers as CheckedIntegers
from hfield.checker.number_fields.logarithms import DIGITS, Places
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.number_fields import NumberField
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.number_fields.classes.short_integers import shortest_logarithm
from hfield.fields.number_fields.ideals import integers
from tests.subcases import share_quick

FIELDS = (
    "QQ[s]/(s^3-2)", "QQ[s]/(s^3-s^2-2*s+1)", "QQ[s]/(2*s^3-3*s-7)", "QQ(zeta5)", "QQ[s]/(s^4-s-1)",
    "QQ[s]/(s^4-5*s^2+5)", "QQ[s]/(s^5-4*s^4-s^3+5*s-3)", "QQ[s]/(s^6-2*s^5+s^4+2*s^3-2*s^2-3*s+4)",
    "QQ[s]/(s^6-s^5-5*s^4+4*s^3+6*s^2-3*s-1)",
)  # fmt: skip


@pytest.mark.parametrize("name", share_quick(FIELDS, 3))
def test_bounds_are_below_regulators(name: str) -> None:
    """The prover's bound is below the checker's, that below the regulator, by less than a thousand."""
    K = ring(name)
    s = s_units(K)
    mine = s.short_integers.least_regulator(s.order_of_torsion)
    field = read_ring(json.loads(json.dumps(K.data)))
    assert isinstance(field, NumberField)
    rows = [[Fraction(c) for c in K.coordinates(w)] for w in K.integral_basis()]
    places = Places(field.whole)
    units = regulator.ShortUnits(CheckedIntegers(field, rows), places)
    roots = [K.power(s.torsion, k) for k in range(s.order_of_torsion)]
    torsion = [tuple(Fraction(c) for c in K.coordinates(x)) for x in roots]
    checked = units.least_volume(torsion) / 2 ** (DIGITS * places.rank)
    found = float(K.unit_group().regulator.mid())
    assert float(mine) <= checked <= found * (1 + 1e-9)
    assert checked > found / 1000


@pytest.mark.parametrize("name", FIELDS[:5])
def test_short_integers_are_all(name: str) -> None:
    """A box of coordinates has no others, and norms are those of the elements."""
    K = ring(name)
    found = s_units(K).short_integers
    frame, embeddings = integers(K), K.embeddings
    listed = {tuple(map(int, row)) for row in found.coordinates}
    assert len(listed) == len(found.coordinates)
    values = [
        [complex(embeddings.value(w.poly, k, 64)) for k in range(embeddings.count)]
        for w in frame.basis
    ]
    weights = [1 if k < embeddings.real_count else 2 for k in range(embeddings.count)]
    for c in itertools.product(range(-3, 4), repeat=frame.n):
        places = [
            sum(a * v[k] for a, v in zip(c, values, strict=True)) for k in range(len(weights))
        ]
        length = sum(w * abs(z) ** 2 for w, z in zip(weights, places, strict=True))
        opposite = tuple(-a for a in c)
        if any(c) and abs(length - found.length) > 1e-3:
            assert (length < found.length) == (c in listed or opposite in listed)
            assert not (c in listed and opposite in listed)
    for k in range(0, len(listed), 7):
        assert abs(found.element(k).norm()) == int(found.norms[k])


def test_logarithms_of_long_units() -> None:
    """Vectors of sum 0 for which both sums of exponentials are large are as long as is said."""
    rng = Random(1)
    for turn in range(3_000):
        n, e = rng.choice([(2, 1), (3, 1), (4, 1), (6, 1), (4, 2), (6, 2)])
        x = [rng.gauss(0, rng.choice([1, 3])) for _ in range(n // e)]
        if rng.random() < 0.5:  # near the extreme
            x = [rng.gauss(0, 0.1) for _ in x]
            x[0], x[-1] = x[0] + 3, x[-1] - 3
        mean = sum(x) / len(x)
        x = [c - mean for c in x] * e
        length = min(sum(map(math.exp, x)), sum(math.exp(-c) for c in x))
        square = sum(c * c for c in x) / 4
        assert shortest_logarithm(n, e, length) <= square * (1 + 1e-9)
        if turn % 100 == 0 and length > n + 1:
            low = regulator.shortest_logarithm(n, e, math.floor(length)) / 2**DIGITS
            assert 0 < low <= square * (1 + 1e-9)


def test_both_sides_bound_long_units_alike() -> None:
    for n, e, length in itertools.product((3, 6, 12), (1, 2), (20, 111, 4000)):
        low = regulator.shortest_logarithm(n, e, length) / 2**DIGITS
        assert math.isclose(low, shortest_logarithm(n, e, length), rel_tol=1e-4)
    assert regulator.shortest_logarithm(6, 1, 6) == regulator.shortest_logarithm(6, 1, 3) == 0


def test_lengths_are_roots() -> None:
    for n, d in ((3, -23), (5, 10**12), (12, -(10**30))):
        ball = math.pi ** (n / 2) / math.gamma(n / 2 + 1)
        count = {3: 100, 5: 600}.get(n, 1000)
        wanted = (2 * count * math.sqrt(abs(d)) / ball) ** (2 / n)
        assert short_length(n, d) == math.floor(wanted)


def test_hermite_constants() -> None:
    """Root lattices A₂, A₃, D₄, D₅, E₆, E₇, E₈ attain them; Blichfeldt's bounds follow."""
    determinants = {2: 3, 3: 4, 4: 4, 5: 4, 6: 3, 7: 2, 8: 1}
    for r, d in determinants.items():
        assert HERMITE_POWERS[r] == Fraction(2**r, d)
    for r in (9, 10, 11):
        bound = (2 / math.pi) ** r * math.gamma(2 + r / 2) ** 2
        assert 0 < HERMITE_POWERS[r] - bound < 1


@pytest.mark.slow
@pytest.mark.parametrize(("n", "gamma"), [(3, 1.52), (4, 1.16), (6, 0.981), (12, 0.561)])
def test_zimmert_constants(n: int, gamma: float) -> None:
    """The corollary's function at one γ gives no more than a hundredth less; none is below 1 for |D| = 1."""
    from mpmath import inf, mp, mpf, nsum, pi, psi

    with mp.workdps(15):
        g = mpf(gamma) + mpf(1) / 1001
        below, k = 2 * (1 + 2 * g), 2 / (1 + 2 * g)

        def difference(a: mpf, b: mpf) -> mpf:
            return k * (psi(0, a / below) - psi(0, b / below))

        real = nsum(
            lambda m: (
                difference(2 * m + 3 * g, 2 * m - 1 + g) - 1 / (2 * m - 2 - g) - 1 / (2 * m - 1 + g)
            ),
            [1, inf],
        )
        real -= (psi(0, (1 + g) / 2) + psi(0, -g / 2)) / 2
        other = nsum(
            lambda m: (
                difference(2 * m + 1 + 3 * g, 2 * m + g) - 1 / (2 * m - 1 - g) - 1 / (2 * m + g)
            ),
            [1, inf],
        )
        other -= (psi(0, 1 + g / 2) + psi(0, (1 - g) / 2)) / 2
        rest = -4 / g + difference(1 + g, 1 + 3 * g) + difference(2 + 5 * g, 2 + 3 * g)
        for r2, factor in enumerate(ZIMMERT_FACTORS[n]):
            c = ((n - r2) * real + r2 * other + rest + n * mp.log(pi)) / 2
            assert float(factor) < float(mp.exp(-c)) * 1.0006
            assert float(factor) > float(mp.exp(-c)) * 0.9


def test_values_at_embeddings_agree() -> None:
    """Values of elements, by one call of FLINT, are those of Horner's scheme."""
    K = ring("QQ[s]/(s^5-4*s^4-s^3+5*s-3)")
    x = K("1/3-2*s+7/5*s^4")
    for k in range(K.embeddings.count):
        root, total = K.embeddings.at(128)[k], flint.acb(0)
        for c in reversed(x.poly.coeffs()):
            total = total * root + flint.acb(c)
        assert total.overlaps(K.embeddings.value(x.poly, k, 128))
