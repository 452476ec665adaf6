"""Lattice reduction by LLL, and isotropic vectors of forms by random majorants.

A form that is minimal at every prime has a zero among the small vectors of a lattice. The lattice is reduced
with respect to the sum of the absolute values of the form's terms, or with respect to an image of this
majorant under automorphisms of the form over ℝ and ℂ.
"""

from __future__ import annotations

import cmath
import itertools
import math
import random
from collections.abc import Iterable, Sequence
from typing import TypeVar

import flint

from hfield.core.product import IntegerMultiple

S = TypeVar("S", bound=IntegerMultiple)

Integers = list[list[int]]


def combination(coefficients: Sequence[int], rows: Sequence[Sequence[S]]) -> list[S]:
    """Return the linear combination of rows with integer coefficients; the entries of the rows may be in any
    field.
    """
    terms = [[x * n for x in row] for n, row in zip(coefficients, rows, strict=True) if n]
    if not terms:
        return [x * 0 for x in rows[0]]
    return [sum(column[1:], column[0]) for column in zip(*terms, strict=True)]


def reduced(rows: Integers) -> tuple[Integers, Integers]:
    """Return a reduced basis of the lattice that independent integer rows span, and the steps to it."""
    short, steps = flint.fmpz_mat(rows).lll(transform=True)
    return _integers(short), _integers(steps)


def steps_of_gram(gram: Integers) -> Integers:
    """Return the steps to a basis that is reduced for a positive definite Gram matrix."""
    n = len(gram)
    matrix = flint.fmpz_mat(n, n, [x for row in gram for x in row])
    return _integers(matrix.lll(transform=True, rep="gram", gram="exact")[1])


def _integers(matrix: flint.fmpz_mat) -> Integers:
    return [[int(x) for x in row] for row in matrix.tolist()]


def turned(
    points: list[list[complex]],
    places: Iterable[Sequence[object] | None],
    size: float,
    rng: random.Random,
    width: int = 3,
) -> list[list[complex]]:
    """Return vectors, with ``width`` coordinates for each place, after random rotations in all coordinate
    planes.

    ``places`` contains the signs of the form at each real place, and None for a complex one. The angle is
    real if the form is definite on the plane, imaginary if it is indefinite, and complex at a complex place.
    """
    for k, signs in enumerate(places):
        for i, j in itertools.combinations(range(width), 2):
            turn, boost = rng.uniform(-math.pi, math.pi), rng.gauss(0, size)
            if signs is None:
                angle = complex(turn, boost)
            else:
                angle = complex(turn) if signs[i] == signs[j] else complex(0, boost)
            points = [_turned(v, width * k + i, width * k + j, angle) for v in points]
    return points


def _turned(v: list[complex], i: int, j: int, angle: complex) -> list[complex]:
    c, s = cmath.cos(angle), cmath.sin(angle)
    v = list(v)
    v[i], v[j] = c * v[i] + s * v[j], c * v[j] - s * v[i]
    return v


def real_coordinates(v: Sequence[complex], real: int) -> list[float]:
    """Return one real number for each of the first ``real`` coordinates, and two for each of the others."""
    return [
        t for k, z in enumerate(v) for t in ([z.real + z.imag] if k < real else [z.real, z.imag])
    ]
