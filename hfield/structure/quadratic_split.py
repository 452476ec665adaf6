"""A zero divisor of a split quaternion algebra over ℚ(√d), by descent to ℚ.

P. Kutas, "Splitting quaternion algebras over quadratic number fields", J. Symbolic Comput. 94
(2019): a split algebra comes from a quaternion algebra over ℚ that contains a square root of d. Each of
the three steps (a pure u with u² rational, a v that anticommutes with it and has v² rational, a
square root of d among their combinations) is a zero of a quadratic form over ℚ, in six, four and
four variables.
"""

import itertools
import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from hfield.errors import UndecidedError
from hfield.product import Constants, Coordinates, multiply
from hfield.structure.integers import squarefree
from hfield.structure.qforms import isotropic_vector
from hfield.structure.quadratic import Pair


@dataclass(frozen=True, slots=True)
class Quad:
    """The number ``u + v√d``, with just the arithmetic that the product formula needs."""

    u: Fraction
    v: Fraction
    d: int

    def __add__(self, other: "Quad") -> "Quad":
        return Quad(self.u + other.u, self.v + other.v, self.d)

    def __sub__(self, other: "Quad") -> "Quad":
        return Quad(self.u - other.u, self.v - other.v, self.d)

    def __mul__(self, other: "Quad") -> "Quad":
        u, v = self.u, self.v
        return Quad(u * other.u + self.d * v * other.v, u * other.v + v * other.u, self.d)

    def __neg__(self) -> "Quad":
        return Quad(-self.u, -self.v, self.d)

    def __bool__(self) -> bool:
        return bool(self.u or self.v)


def zero_divisor_quadratic(d: int, a: Pair, b: Pair) -> tuple[Pair, Pair, Pair, Pair]:
    """Return a nonzero element of norm 0 of ``(a, b | ℚ(√d))``, which must ramify nowhere.

    The presentations by two of i, j, k are tried in turn, rational squares removed. Raises
    :class:`UndecidedError` when a number came up in each that is too hard to factor.
    """
    first, second = Quad(*a, d), Quad(*b, d)
    zero, one = _number(0, d), _number(1, d)
    # the squares of two generators, and what they and their product are over i, j, k
    i, j, k = ((one, zero, zero), (zero, one, zero), (zero, zero, one))
    presentations = [
        (first, second, (i, j, k)),
        (first, -(first * second), (i, k, (zero, first, zero))),
        (second, -(first * second), (j, k, (-second, zero, zero))),
    ]
    for attempt, (p, q, units) in enumerate(presentations):
        r, s = _square_content(p), _square_content(q)
        try:
            w, *vector = _search(d, _number(1 / r**2, d) * p, _number(1 / s**2, d) * q)
        except UndecidedError:
            if attempt == 2:
                raise
            continue
        scales = (1 / r, 1 / s, 1 / (r * s))
        terms = [
            tuple(_number(scale, d) * x * u for u in unit)
            for scale, x, unit in zip(scales, vector, units, strict=True)
        ]
        x, y, z = (column[0] + column[1] + column[2] for column in zip(*terms, strict=True))
        return (w.u, w.v), (x.u, x.v), (y.u, y.v), (z.u, z.v)
    raise AssertionError("the last attempt returned or raised")


def _square_content(x: Quad) -> Fraction:
    """Return the greatest rational r for which x/r² is integral in ℤ + ℤ√d."""
    bottom = math.lcm(x.u.denominator, x.v.denominator)
    whole = math.gcd(int(x.u * bottom * bottom), int(x.v * bottom * bottom))
    return Fraction(squarefree(whole)[1], bottom)


def _search(d: int, a: Quad, b: Quad) -> Coordinates:
    zero, one = _number(0, d), _number(1, d)
    c = Constants(a, zero, b)
    units = ((zero, one, zero, zero), (zero, zero, one, zero), (zero, zero, zero, one))
    u = _rational_square(c, [a, b, -(a * b)], list(units))
    alpha = multiply(c, u, u)[0]
    if not alpha:
        return u
    first = next(p for p in (_commutator(c, u, p) for p in units) if any(p))
    beta = multiply(c, first, first)[0]
    if not beta:
        return first
    # (m + n·u)·first has the square (m² − α·n²)·β
    v = _rational_square(c, [beta, -(alpha * beta)], [first, multiply(c, u, first)])
    beta = multiply(c, v, v)[0]
    if not beta:
        return v
    root = isotropic_vector([alpha.u, beta.u, -alpha.u * beta.u, Fraction(-d)])
    assert root is not None, "a split algebra contains a square root of d in its rational part"
    x, y, z, w = root
    q = _combine(d, [(x, u), (y, v), (z, multiply(c, u, v))])
    return (Quad(q[0].u, q[0].v - w, d), *q[1:])


def _number(x: int | Fraction, d: int) -> Quad:
    return Quad(Fraction(x), Fraction(0), d)


def _combine(d: int, terms: list[tuple[Fraction, Coordinates]]) -> Coordinates:
    """Return the combination of quaternions with rational coefficients."""
    columns = [[_number(x, d) * p[i] for x, p in terms] for i in range(4)]
    return _sum(tuple(column) for column in zip(*columns, strict=True))


def _commutator(c: Constants, p: Coordinates, q: Coordinates) -> Coordinates:
    w, x, y, z = (s - t for s, t in zip(multiply(c, p, q), multiply(c, q, p), strict=True))
    return w, x, y, z


def _rational_square(c: Constants, values: list[Quad], vectors: list[Coordinates]) -> Coordinates:
    """Return a nonzero combination over ℚ(√d) of orthogonal vectors whose square is rational.

    ``values`` are the squares of the vectors. The √d-part of ``f·(x₀ + x₁√d)²`` is the binary
    form ``f₁·x₀² + 2·f₀·x₀x₁ + d·f₁·x₁²``, and the sum of these has to vanish.
    """
    for f, vector in zip(values, vectors, strict=True):
        if not f.v:
            return vector
    d = c.a.d
    small = _small_combination(d, values)
    if small is not None:
        return _sum([tuple(x * t for t in p) for x, p in zip(small, vectors, strict=True)])
    form = [g for f in values for g in (f.v, d * f.v - f.u * f.u / f.v)]
    solution = isotropic_vector(form)
    assert solution is not None, "the corestriction of a split algebra is trivial"
    terms = []
    for index, f in enumerate(values):
        shifted, x1 = solution[2 * index], solution[2 * index + 1]
        x = Quad(shifted - f.u / f.v * x1, x1, d)
        terms.append(tuple(x * t for t in vectors[index]))
    return _sum(terms)


def _small_combination(d: int, values: list[Quad]) -> list[Quad] | None:
    """Look for small integral x with ``Σ f·x²`` rational, the first summands against the last."""
    scale = math.lcm(*(t.denominator for f in values for t in (f.u, f.v)))
    blocks = [(int(f.u * scale), int(f.v * scale)) for f in values]
    for radius in (2, 5, 10) if len(values) == 3 else (3, 10, 30):
        points = [(m, n) for m in range(radius + 1) for n in range(-radius, radius + 1)]
        tables = [
            {q * (m * m + d * n * n) + 2 * p * m * n: (m, n) for m, n in reversed(points)}
            for p, q in blocks
        ]
        sums: dict[int, list[tuple[tuple[int, int], ...]]] = {}
        for head in itertools.product(*(table.items() for table in tables[:-1])):
            chosen = tuple(point for _, point in head)
            sums.setdefault(sum(value for value, _ in head), []).append(chosen)
        for value, point in tables[-1].items():
            for chosen in sums.get(-value, ()):
                if any(map(any, (*chosen, point))):
                    return [Quad(Fraction(m), Fraction(n), d) for m, n in (*chosen, point)]
    return None


def _sum(terms: Iterable[tuple[Quad, ...]]) -> Coordinates:
    w, x, y, z = (sum(column[1:], column[0]) for column in zip(*terms, strict=True))
    return w, x, y, z
