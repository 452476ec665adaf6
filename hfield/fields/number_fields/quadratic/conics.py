"""Points on conics ``a·x² + b·y² = z²`` over quadratic fields, however large a and b.

The form ``z² − a·x² − b·y²`` is put on a lattice where it is good at every prime ideal. The volume of
this lattice for the majorant |z|² + |a||x|² + |b||y|², summed over the infinite places, depends on the scale
of the form and the discriminant of the field alone; so after reduction (LLL) nothing is left of the size
of a and b, and a zero is among small combinations. How small depends on the majorant, which is
therefore changed by automorphisms of the form over ℝ or ℂ, picked with a seed, until a zero turns up: a
walk on a Hilbert modular surface, or a Bianchi threefold, whose cusps are the zeros.

Compare Cremona and Rusin, "Efficient solution of rational conics", Math. Comp. 72 (2003).
"""

from __future__ import annotations

import itertools
import math
import operator
import random
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import flint

from hfield.errors import UndecidedError
from hfield.fields.number_fields.quadratic.good_lattice import bad_primes, good_lattice
from hfield.fields.number_fields.quadratic.residues import coordinates
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.rings.balls import precision
from hfield.rings.whole_numbers import fraction
from hfield.structure.lattice_reduction import (
    Integers,
    combination,
    real_coordinates,
    reduced,
    turned,
)
from hfield.structure.minimal_conics import Vector

if TYPE_CHECKING:
    from hfield.rings.closed_fields.surds import Surd


TRIALS = 10_000
_PAIRS = list(itertools.combinations_with_replacement(range(6), 2))
_MONOMIALS = [  # vectors of coefficients, one of v and −v, with their products in pairs
    (v, [v[i] * v[j] for i, j in _PAIRS])
    for v in itertools.product((0, 1, -1), repeat=6)
    if next((x for x in v if x), 0) == 1
]


def solve_conic_quadratic(
    field: QuadraticField, a: Surd, b: Surd, known: Iterable[int] = ()
) -> tuple[Surd, Surd, Surd]:
    """Return ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``, for nonzero a and b in ℚ(√d).

    The conic must have a point, that is, ``(a, b | ℚ(√d))`` must ramify nowhere. ``known`` may name
    primes of the norms of a and b. Raises :class:`UndecidedError` where a norm is too hard to factor,
    or where no point was met on the walk, which takes a discriminant of ten digits or so.
    """
    r, s = (math.lcm(*(u.denominator for u in coordinates(field, x))) for x in (a, b))
    a, b = a * (r * r), b * (s * s)
    form = [field.one, -a, -b]
    walk = Walk(field, form, good_lattice(field, form, bad_primes(field, (a, b), known)))
    rng = random.Random(1)
    steps = [[int(i == j) for j in range(6)] for i in range(6)]
    for _ in range(TRIALS):
        for z, x, y in walk.zeros(steps):
            return x * r, y * s, z
        steps = walk.moved(rng)
    raise UndecidedError(
        f"a conic over {field.name} has points, but none was found on {TRIALS} reduced bases"
    )


class Walk:
    """A lattice in F³ with a diagonal form, and as many reduced bases of it as one likes.

    At a real place the coordinates, times the square roots of the coefficients, are three numbers
    that are real or imaginary, at a complex place three complex ones. The form is the sum of their
    squares, the majorant that of the squares of their absolute values.
    """

    def __init__(self, field: QuadraticField, form: Vector, basis: list[Vector]) -> None:
        self.real = field.d > 0
        self.signs: list[list[complex] | None]
        rows, steps = reduced(_embedded(field, form, basis))
        self.basis = [combination(row, basis) for row in steps]
        largest = max(abs(t) for row in rows for t in row)
        numbers = [[t / largest for t in row] for row in rows]
        if self.real:
            unit = [1 if field.sign(f, n) > 0 else 1j for n in (0, 1) for f in form]
            self.points = [[t * u for t, u in zip(row, unit, strict=True)] for row in numbers]
            self.signs = [unit[:3], unit[3:]]
        else:
            self.signs = [None]
            self.points = [
                [complex(s, t) for s, t in zip(row[::2], row[1::2], strict=True)] for row in numbers
            ]
        self.grams = _grams(field, form, self.basis)

    def zeros(self, steps: Integers) -> Iterator[Vector]:
        """Run through the zeros of the form with coefficients 0, ±1 on the basis that the steps make."""
        change = flint.fmpz_mat(6, 6, [n for row in steps for n in row])
        first, second = (
            [int(g[i, j]) * (1 + (i != j)) for i, j in _PAIRS]
            for g in (change * gram * change.transpose() for gram in self.grams)
        )
        for v, monomials in _MONOMIALS:
            if not (
                sum(map(operator.mul, first, monomials))
                or sum(map(operator.mul, second, monomials))
            ):
                row = [sum(map(operator.mul, v, column)) for column in zip(*steps, strict=True)]
                yield combination(row, self.basis)

    def moved(self, rng: random.Random) -> Integers:
        """Return the steps to a basis that is reduced for another majorant, at random."""
        points = turned(self.points, self.signs, rng.uniform(0, 8), rng)
        real = 6 if self.real else 0
        return reduced([[round(t * 2**60) for t in real_coordinates(v, real)] for v in points])[1]


def _grams(field: QuadraticField, form: Vector, basis: list[Vector]) -> list[flint.fmpz_mat]:
    """Return integer matrices G, H: up to a factor the bilinear form is G + √d·H on the basis."""
    entries = [
        sum((f * x * y for f, x, y in zip(form, u, v, strict=True)), field.zero)
        for u in basis
        for v in basis
    ]
    both = [[fraction(x.terms.get(n, 0)) for x in entries] for n in (1, field.d)]
    bottom = math.lcm(*(u.denominator for row in both for u in row))
    top = math.gcd(*(int(u * bottom) for row in both for u in row))
    return [flint.fmpz_mat(6, 6, [int(u * bottom) // top for u in row]) for row in both]


def _embedded(field: QuadraticField, form: Vector, basis: list[Vector]) -> Integers:
    """Return the real coordinates of vectors at the infinite places, scaled and rounded."""
    numbers = [x for v in (form, *basis) for x in v]
    bits = 64 + 2 * max(abs(int(u.p)).bit_length() for x in numbers for u in x.terms.values())
    scale = flint.arb(2) ** bits
    with precision(2 * bits + 64):
        root = flint.acb(field.d).sqrt()
        places = [root, -root] if field.d > 0 else [root]

        def embed(x: Surd, place: flint.acb) -> flint.acb:
            return flint.acb(x.terms.get(1, 0)) + flint.acb(x.terms.get(field.d, 0)) * place

        roots = [[embed(f, place).sqrt() * scale for f in form] for place in places]
        rows = []
        for v in basis:
            row = [
                embed(x, place) * r
                for place, column in zip(places, roots, strict=True)
                for x, r in zip(v, column, strict=True)
            ]
            numbers = real_coordinates(row, len(row) if field.d > 0 else 0)
            rows.append([int(t.mid().floor().unique_fmpz()) for t in numbers])
    return rows
