"""Arrays over ℚ as five rows of 64-bit integers: four numerators and their common denominator, in lowest
terms.

The basis is scaled as for single elements, so that the structure constants are integers.
"""

from __future__ import annotations

from math import lcm
from typing import TYPE_CHECKING

import flint
import numpy as np

from hfield.compiling.lowest_terms import lowest
from hfield.compiling.memory import Rows
from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import FIRST, SECOND, Program
from hfield.errors import CoercionError
from hfield.fields.base.array_storage import programs
from hfield.fields.base.array_storage.programs import Sides
from hfield.fields.base.array_storage.words import WORD, WordArrays
from hfield.fields.base.arrays import objects, one_shape
from hfield.fields.base.coercion import is_plain_array

if TYPE_CHECKING:
    from hfield.fields.base.ring import Ring


class FractionArrays(WordArrays):
    """Arrays over ℚ: ``(w, x, y, z, d)`` for (w + x·i′ + y·j′ + z·k′)/d, or one row of objects if a number is
    larger than a word.
    """

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        a, t, b = constants
        m, k = lcm(int(a.q), int(t.q)), int(b.q)  # i′ = m·i and j′ = k·j have integral constants
        self.integral = Constants(int(a * m**2), int(t * m), int(b * k**2))
        self._is_unscaled = m == k == 1

    def program(self, name: str) -> tuple[Program, Sides]:
        """Return the program of an operation, and the names of its operands in it."""
        if name in programs.FRACTIONS:
            return programs.FRACTIONS[name]
        program, sides = super().program(name)
        if name == "product":
            return programs.with_denominators(program), _BOTH
        return program, sides

    def in_words(self, name: str, *operands: Rows) -> Rows | None:
        """Run an operation, and reduce results other than norms and traces to lowest terms."""
        if name in ("norm", "trace", "adjoint", "conjugate", "negative"):
            rows = super().in_words(name, *(p[:4] for p in operands))
            if rows is not None and name in ("conjugate", "negative"):
                return (*rows, operands[0][4])
            return rows
        rows = super().in_words(name, *operands)
        return rows if rows is None or lowest(rows) else None

    # --- in and out ----------------------------------------------------------------------------

    def encode(self, coordinates: Coordinates) -> Rows:
        """Encode four arrays of rational numbers, as words if they fit."""
        return self.packed(self.plain.encode(coordinates))

    def read(self, values: tuple[object, ...]) -> Rows:
        """Encode four values that ℚ reads. Raises :class:`CoercionError`."""
        if self._is_unscaled and all(is_whole(v) for v in values):
            rows = one_shape([np.array(v, WORD) for v in values])
            return (*rows, np.ones(rows[0].shape, WORD))
        w, x, y, z = one_shape([self.ring.array(v) for v in values])
        return self.encode((w, x, y, z))

    def lift(self, coordinates: Coordinates) -> Rows:
        """Encode one element as an array of no dimensions."""
        w, x, y, z = map(self.ring.array, coordinates)
        return self.encode((w, x, y, z))

    def from_array(self, values: object, copy: bool = True) -> Rows:
        """Encode a copy of an array of shape (5, …), made by ``to_array``. Raises :class:`CoercionError`."""
        rows = self.checked_block(values, 5)
        if not rows[4].all():
            raise CoercionError("a denominator is 0: the last of the five rows must not contain 0")
        if not lowest(rows):
            raise CoercionError("−2^63 has no negative in 64 bits; expected numbers above it")
        return rows

    # --- arithmetic ----------------------------------------------------------------------------

    def norm(self, p: Rows) -> np.ndarray:
        """Return the reduced norms, an array of flint's rational numbers."""
        return self._ratios("norm", p, 2)

    def trace(self, p: Rows) -> np.ndarray:
        """Return the reduced traces, an array of flint's rational numbers."""
        return self._ratios("trace", p, 1)

    def _ratios(self, name: str, p: Rows, power: int) -> np.ndarray:
        rows = self.in_words(name, p)
        if rows is None:
            return self.by_arrays(name, p)
        pairs = zip(rows[0].ravel().tolist(), p[4].ravel().tolist(), strict=True)
        made = [flint.fmpq(n, d**power) for n, d in pairs]
        return objects(made, self.ring).reshape(rows[0].shape)

    def inverse(self, p: Rows) -> Rows | None:
        """Return the inverses ``d·conj/N``, or None if some norm is 0."""
        rows = self.in_words("adjoint", p)
        if rows is not None:
            if not rows[4].all():
                return None
            rows = super().in_words("inverse", rows, (p[4],))
        if rows is not None and lowest(rows):
            return rows
        found = self.plain.inverse(self.values(p))
        return None if found is None else self.packed(found)

    def units(self, p: Rows) -> np.ndarray:
        """Return a bool array that marks the invertible elements."""
        rows = self.in_words("norm", p)
        units: np.ndarray = self.by_arrays("units", p) if rows is None else rows[0] != 0
        return units

    def prepare(self) -> None:
        """Compile every loop, or load it from the disk."""
        super().prepare()
        for kernel in self.kernels("inverse"):
            kernel.prepare()
        lowest(tuple(np.ones((5, 1), WORD)))


_BOTH = ((*FIRST, "d1"), (*SECOND, "d2"))


def is_whole(values: object) -> bool:
    """Return whether a value is an int that fits into 64 bits, or a numpy array of such."""
    if type(values) is int:
        return -(2**63) < values < 2**63
    return is_plain_array(values) and values.dtype.kind in "ib"
