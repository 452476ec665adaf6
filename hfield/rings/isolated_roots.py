"""The complex roots of a polynomial over ℚ, each in a ball of its own, at any precision."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import flint

from hfield.rings.balls import precision

START = 64


class IsolatedRoots:
    """The roots of a polynomial over ℚ without double roots: real ones ascending, then complex ones.

    Of two conjugate roots the one above the real axis counts. Roots are complex balls of flint that contain
    one root each, and keep their number at every precision.
    """

    def __init__(self, polynomial: flint.fmpq_poly) -> None:
        self._whole = polynomial.numer()
        first = self._isolated(START)
        real = sorted((z for z in first if z.imag == 0), key=lambda z: float(z.real.mid()))
        upper = [z for z in first if z.imag > 0]
        upper.sort(key=lambda z: (float(z.real.mid()), float(z.imag.mid())))
        self.real_count, self.count = len(real), len(real) + len(upper)
        self._at: dict[int, list[Any]] = {START: real + upper}

    def _isolated(self, bits: int) -> list[flint.acb]:
        with precision(bits):
            return [flint.acb(z) for z, _ in self._whole.complex_roots()]

    def at(self, bits: int) -> list[flint.acb]:
        """Return the roots with so many bits."""
        if bits not in self._at:
            finer = self._isolated(bits)
            self._at[bits] = [
                next(z for z in finer if z.overlaps(known)) for known in self._at[START]
            ]
        return self._at[bits]


@lru_cache(maxsize=256)
def isolated_roots(coefficients: tuple[int, ...]) -> IsolatedRoots:
    """Return the roots of a polynomial over ℤ, low degree first; the same object for the same polynomial."""
    return IsolatedRoots(flint.fmpq_poly(list(coefficients)))
