"""Short integers of a number field: all that are small at all infinite places, and bounds for units derived
from them.

The length of x is T₂(x) = Σ |xᵥ|², summed over the n embeddings. Elements are enumerated in floating point,
with a tolerance that exceeds the rounding errors, and stored in arrays.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cached_property

import flint
import numpy as np
import numpy.typing as npt

from hfield.checker.number_fields.bounds import HERMITE_POWERS, short_length
from hfield.fields.base.balls import precision
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import MaximalOrder
from hfield.fields.number_fields.integral_basis import element_of

SLACK = 1e-6
"""Rounding changes lengths by less than this part of them."""
ROUNDED = 0.999
"""Sums of squares of logarithms are at least this part of what is computed."""
EXACT = 2.0**50
"""Norms below are known exactly, and those above are left out."""

Floats = npt.NDArray[np.float64]


class ShortIntegers:
    """The integers x ≠ 0 with T₂(x) ≤ ``length``, one of ±x, shortest first.

    ``length`` is chosen so that there are a few hundred. ``coordinates`` are the coordinates in the integral
    basis, ``norms`` the absolute values of the norms, with 0 in place of those above 2⁵⁰.
    """

    def __init__(self, frame: MaximalOrder, conjugates: flint.fmpz_mat) -> None:
        self.frame, self.field, n = frame, frame.field, frame.n
        change = conjugates.lll(transform=True)[1]
        self._reduced = np.array([[int(c) for c in row] for row in change.tolist()], dtype=object)
        self._values = self._conjugates(flint.fmpq_mat(change).tolist())
        gram = (self._values @ self._values.conj().T).real
        self._triangle: Floats = np.linalg.cholesky(gram).T.astype(np.float64)
        self.length = short_length(n, self.field.discriminant())
        found = self._enumerated(self.length * (1 + SLACK))
        values = found @ self._values
        lengths = (np.abs(values) ** 2).sum(axis=1)
        order = np.argsort(lengths, kind="stable")
        found, self._at_places = found[order], np.abs(values[order])
        with np.errstate(over="ignore"):
            norms = self._at_places.prod(axis=1)
        self.norms = np.rint(np.where(norms < EXACT, norms, 0)).astype(np.int64)
        self.coordinates = found.astype(np.int64).astype(object) @ self._reduced

    def _conjugates(self, rows: list[list[flint.fmpq]]) -> npt.NDArray[np.complex128]:
        """Return the values of a basis at all embeddings, conjugate ones too."""
        embeddings = self.field.embeddings
        out = []
        for row in rows:
            poly = element_of(self.field, row).poly
            values = []
            for k in range(embeddings.count):
                z = complex(embeddings.value(poly, k, 128))
                values += [z] if k < embeddings.real_count else [z, z.conjugate()]
            out.append(values)
        return np.array(out)

    def _enumerated(self, length: float) -> Floats:
        """Return the coordinates in the reduced basis of all elements of at most this length (Fincke and
        Pohst).
        """
        triangle, n = self._triangle, self.frame.n
        x, left = np.zeros((1, 0)), np.array([length])
        for k in reversed(range(n)):
            size = triangle[k, k]
            middle = x @ triangle[k, k + 1 :] / -size
            reach = np.sqrt(np.maximum(left, 0)) / size
            first = np.ceil(middle - reach)
            counts = np.maximum(np.floor(middle + reach) - first + 1, 0).astype(np.int64)
            parent = np.repeat(np.arange(len(x)), counts)
            number = np.arange(len(parent)) - np.repeat(np.cumsum(counts) - counts, counts)
            value = first[parent] + number
            left = left[parent] - (size * (value - middle[parent])) ** 2
            x = np.column_stack([value, x[parent]])
        first_sign = np.take_along_axis(x, (x != 0).argmax(axis=1)[:, None], axis=1)[:, 0]
        return x[first_sign > 0]

    @cached_property
    def is_exact(self) -> bool:
        """Whether rounding changes lengths by less than :data:`SLACK`, and the listed norms by less than ½.

        The error of a value is at most √K times ``error``. By the inequality of arithmetic and geometric
        means, the product of the n − 1 other values is at most (K/(n − 1))^((n − 1)/2).
        """
        n, length = self.frame.n, self.length
        error = n * float(np.linalg.cond(self._triangle)) * 2.0**-50
        others = (length / (n - 1)) ** ((n - 1) / 2)
        return error * math.sqrt(length) * n * others < 0.25 and error * error * 2.0**50 < SLACK

    def element(self, k: int) -> FieldElement:
        """Return the k-th element."""
        return element_of(self.field, [flint.fmpq(int(c)) for c in self.coordinates[k]])

    def least_regulator(self, torsion_order: int) -> flint.arb:
        """Return a proved lower bound for the regulator, or 0 if none is found. The unit rank is positive.

        If neither a unit nor its inverse is listed, T₂ is above K = ``length`` for both. Let x be the
        logarithms of the |εᵥ|² at the n embeddings, and let a and b be the sums of x² over the positive x and
        over the others. Then K − n ≤ e·ψ(√(a/e)) + b/2 and the same with a and b exchanged, for ψ(t) = eᵗ − 1
        − t, where e = 2 if all places are complex, else 1. So a + b is least for a = b
        (docs/explanation/trust.md). Together with the listed units this gives the least square in the lattice
        of units, which bounds the regulator from below by Hermite's inequality.
        """
        real, complex_ = self.field.signature
        rank, n = real + complex_ - 1, self.frame.n
        if not self.is_exact or rank >= len(HERMITE_POWERS):
            return flint.arb(0)
        least = shortest_logarithm(n, 1 if real else 2, self.length)
        units = np.flatnonzero(self.norms == 1)
        squares = (np.log(self._at_places[units]) ** 2).sum(axis=1)
        for k in np.argsort(squares):
            if squares[k] > 1e-3 or self._is_no_root_of_unity(int(units[k]), torsion_order):
                least = min(least, float(squares[k]))
                break
        with precision(64):
            power = Fraction(HERMITE_POWERS[rank]) * n / 2**complex_
            square = flint.arb(least * ROUNDED) ** rank
            return (square * flint.arb(power.denominator) / power.numerator).sqrt()

    def _is_no_root_of_unity(self, k: int, order: int) -> bool:
        return self.field.power(self.element(k), order) != self.field.one


def shortest_logarithm(n: int, e: int, length: float) -> float:
    """Return a lower bound for Σ log²|εᵥ| over n embeddings, for units ε with T₂(ε), T₂(1/ε) > ``length``."""
    low, high = 0.0, 64.0
    for _ in range(60):
        u = (low + high) / 2
        if e * (math.exp(u) - 1 - u + u * u / 2) < length - n:
            low = u
        else:
            high = u
    return e * low * low / 2
