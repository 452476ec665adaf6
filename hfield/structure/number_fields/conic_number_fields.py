"""Points on conics ``a·x² + b·y² = z²`` over number fields, searched within a bound.

The form ``z² − a·x² − b·y²`` is put on a module where it is good at every prime ideal. The volume of this
lattice of rank 3n for the majorant |z|² + |a||x|² + |b||y|², summed over the infinite places, depends on
the discriminant of the field alone, so after reduction (LLL) a zero is among small combinations, if the
field is small. The majorant is changed at random by automorphisms of the form at the infinite places until
a zero turns up, as over quadratic fields (:mod:`hfield.structure.quadratic_fields.conic_quadratic`).
"""

from __future__ import annotations

import cmath
import itertools
import math
import random
from collections.abc import Iterator
from typing import Any

import flint

from hfield.errors import UndecidedError
from hfield.rings.number_elements import FieldElement
from hfield.rings.number_field import NumberField
from hfield.rings.number_orders import integral_generator
from hfield.structure.minimal_conics import Vector
from hfield.structure.number_fields.good_module import good_module
from hfield.structure.number_fields.hilbert_number_fields import candidates

MAX_DEGREE = 12
WALKED = 60
COMBINATIONS = 60_000
CLOSE = 1e-5
MOST = 50  # of the combinations at which the form is nearly 0: at so many it is computed exactly
SCALE = 2.0**40


def solve_conic_number_field(
    field: NumberField, a: FieldElement, b: FieldElement
) -> tuple[FieldElement, FieldElement, FieldElement]:
    """Return ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``, for nonzero a and b.

    The conic must have a point, that is, ``(a, b | K)`` must ramify nowhere. Raises
    :class:`UndecidedError` where none was met, and where a norm or the discriminant is too hard to factor.
    """
    n = field.degree
    if n > MAX_DEGREE:
        raise UndecidedError(
            f"a conic over {field.name} has points, but none was sought: the degree is over {MAX_DEGREE}"
        )
    primes = sorted({2} | candidates(field, a) | candidates(field, b))
    r, s = (integral_multiple(x) for x in (a, b))
    form = [field.one, -a * (r * r), -b * (s * s)]
    walk = Walk(field, form, good_module(field, form, primes))
    rng = random.Random(1)
    for z, x, y in itertools.chain.from_iterable(walk.zeros(rng, k) for k in range(WALKED)):
        return x * r, y * s, z
    raise UndecidedError(
        f"a conic over {field.name} has points, but none was found among {COMBINATIONS} combinations of each "
        f"of {WALKED} reduced bases"
    )


def integral_multiple(x: FieldElement) -> int:
    """Return a positive integer m for which m·x is an algebraic integer."""
    scale, _ = integral_generator(x.field)
    return math.lcm(*(int((c / flint.fmpq(scale) ** k).q) for k, c in enumerate(x.poly.coeffs())))


class Walk:
    """A lattice in K³ with a diagonal form, and as many reduced bases of it as one likes.

    ``points`` are the basis at the infinite places, where the form is a sum of squares of three complex
    numbers, three after three.
    """

    def __init__(self, field: NumberField, form: Vector, basis: list[Vector]) -> None:
        self.field, self.form, self.basis = field, form, basis
        self.rank = 3 * field.degree
        self.real = field.signature[0]
        self.points = self._embedded(*self._first())

    def _first(self) -> tuple[list[Vector], int]:
        """Reduce the basis exactly; return it, and how many bits its numbers need."""
        size = max(
            abs(int(c.p)).bit_length() + int(c.q).bit_length()
            for v in (self.form, *self.basis)
            for x in v
            for c in x.poly.coeffs()
        )
        bits = 4 * size + 128
        with flint.ctx.workprec(bits):
            scale = flint.arb(2) ** (2 * size + 64)
            rows = [
                [int((t * scale).mid().floor().unique_fmpz()) for t in row]
                for row in self._real_rows(self.basis, bits)
            ]
        self.basis = [_combine(u, self.basis) for u in _lll(rows)]
        return self.basis, bits

    def _values(self, basis: list[Vector], bits: int) -> list[list[Any]]:
        """Return √f·x for the coordinates x of each vector at each infinite place."""
        embeddings, out = self.field.embeddings, []
        with flint.ctx.workprec(bits):
            roots = [
                [embeddings.value(f.poly, k, bits).sqrt() for f in self.form]
                for k in range(embeddings.count)
            ]
            for v in basis:
                out.append(
                    [
                        embeddings.value(x.poly, k, bits) * root
                        for k, at in enumerate(roots)
                        for x, root in zip(v, at, strict=True)
                    ]
                )
        return out

    def _real_rows(self, basis: list[Vector], bits: int) -> list[list[Any]]:
        with flint.ctx.workprec(bits):
            return [
                [
                    t
                    for k, z in enumerate(row)
                    for t in ([z.real + z.imag] if k < 3 * self.real else [z.real, z.imag])
                ]
                for row in self._values(basis, bits)
            ]

    def _embedded(self, basis: list[Vector], bits: int) -> list[list[complex]]:
        return [
            [complex(float(z.real.mid()), float(z.imag.mid())) for z in row]
            for row in self._values(basis, bits)
        ]

    def zeros(self, rng: random.Random, step: int) -> Iterator[Vector]:
        """Run through the zeros of the form that are met among small combinations of a reduced basis.

        The basis is the first one, or, after step 0, one reduced for another majorant, at random.
        """
        import numpy as np

        points, steps = self.points, None
        if step:
            steps = _lll(self._rounded(self._turned(rng)))
            points = [_combine_points(u, points) for u in steps]
        values = np.array(points)
        chosen = _small_combinations(self.rank)
        at = chosen @ values.real + 1j * (chosen @ values.imag)
        form = np.abs((at**2).reshape(len(chosen), -1, 3).sum(axis=2)).sum(axis=1)
        scale = max(1.0, float(np.abs(values).max()) ** 2)
        nearest = np.argpartition(form, MOST)[:MOST] if len(form) > MOST else np.arange(len(form))
        for index in sorted(nearest[form[nearest] < CLOSE * scale], key=form.__getitem__):
            u = [int(x) for x in chosen[index]]
            if steps is not None:
                u = [sum(x * s[j] for x, s in zip(u, steps, strict=True)) for j in range(self.rank)]
            v = _combine(u, self.basis)
            total = sum((f * x * x for f, x in zip(self.form, v, strict=True)), self.field.zero)
            if not total:
                yield v

    def _turned(self, rng: random.Random) -> list[list[complex]]:
        """Return the points after planes of two axes are turned at every place.

        By a real angle where the form is definite, an imaginary one where it is not, a complex one at a
        complex place.
        """
        size = rng.uniform(0, 3)
        points = self.points
        for k in range(self.field.embeddings.count):
            real = k < self.real
            signs = [self.field.embeddings.sign(f.poly, k) for f in self.form] if real else []
            for i, j in ((0, 1), (0, 2), (1, 2)):
                turn, boost = rng.uniform(-math.pi, math.pi), rng.gauss(0, size)
                if not real:
                    angle = complex(turn, boost)
                else:
                    angle = complex(turn) if signs[i] == signs[j] else complex(0, boost)
                points = [_turn(v, 3 * k + i, 3 * k + j, angle) for v in points]
        return points

    def _rounded(self, points: list[list[complex]]) -> list[list[int]]:
        real = 3 * self.real
        largest = max(abs(z) for v in points for z in v)
        scale = SCALE / largest
        return [
            [
                round(t * scale)
                for k, z in enumerate(v)
                for t in ([z.real + z.imag] if k < real else [z.real, z.imag])
            ]
            for v in points
        ]


def _turn(v: list[complex], i: int, j: int, angle: complex) -> list[complex]:
    c, s = cmath.cos(angle), cmath.sin(angle)
    v = list(v)
    v[i], v[j] = c * v[i] + s * v[j], c * v[j] - s * v[i]
    return v


def _lll(rows: list[list[int]]) -> list[list[int]]:
    """Return the transformation to a reduced basis."""
    n = len(rows)
    _, steps = flint.fmpz_mat(n, n, [t for row in rows for t in row]).lll(transform=True)
    return [[int(t) for t in row] for row in steps.tolist()]


def _combine(coefficients: list[int], basis: list[Vector]) -> Vector:
    terms = [[x * n for x in v] for n, v in zip(coefficients, basis, strict=True) if n]
    return [sum(column[1:], column[0]) for column in zip(*terms, strict=True)]


def _combine_points(coefficients: list[int], points: list[list[complex]]) -> list[complex]:
    return [
        sum(n * v[k] for n, v in zip(coefficients, points, strict=True))
        for k in range(len(points[0]))
    ]


_KNOWN: dict[int, Any] = {}


def _small_combinations(rank: int) -> Any:
    """Return vectors of entries 0, 1, −1, the first of them 1: those with few entries first."""
    import numpy as np

    if rank not in _KNOWN:
        rows: list[list[int]] = []
        for size in range(1, rank + 1):
            for support in itertools.combinations(range(rank), size):
                for signs in itertools.product((1, -1), repeat=size - 1):
                    row = [0] * rank
                    for k, sign in zip(support, (1, *signs), strict=True):
                        row[k] = sign
                    rows.append(row)
                if len(rows) >= COMBINATIONS:
                    break
            if len(rows) >= COMBINATIONS:
                break
        _KNOWN[rank] = np.array(rows, dtype=np.float64)
    return _KNOWN[rank]
