"""Bounds of rounding errors of the entries of a rotation's matrix, which rest on differences that are exact.

An `Entry` is a number that is computed from a quaternion of norm 1: a polynomial in the coordinates and in
what the grid of `rotation.matrices` cuts off each, over boxes. Sums of multiples of a power of two that are
small enough are floats; every other rounding costs half a unit in the last place.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from tests.rotation.roundings import U, _out, _plus, _times, _up, half_ulp

_RING = fmpq_mpoly_ctx.get(("w", "x", "y", "z", "dw", "dx", "dy", "dz"), Ordering.lex)
COORDINATES, CUT_OFF = _RING.gens()[:4], _RING.gens()[4:]
_W, _X, _Y, _Z = COORDINATES
MATRIX = (  # times N(q)
    (_W**2 + _X**2 - _Y**2 - _Z**2, 2 * (_X * _Y - _W * _Z), 2 * (_X * _Z + _W * _Y)),
    (2 * (_X * _Y + _W * _Z), _W**2 - _X**2 + _Y**2 - _Z**2, 2 * (_Y * _Z - _W * _X)),
    (2 * (_X * _Z - _W * _Y), 2 * (_Y * _Z + _W * _X), _W**2 - _X**2 - _Y**2 + _Z**2),
)
OFF = sum(c * c for c in COORDINATES) - 1
MOST_OFF = 16.0 * U  # of quaternions that count as units
COARSE = -26  # the grid: multiples of 2⁻²⁶, from which a coordinate is at most half of that away


def small(exact: fmpq_mpoly) -> float:
    """Return a bound of a polynomial, inf unless something that was cut off is in each of its terms."""
    terms = [(int(sum(m[4:])), abs(float(c))) for m, c in exact.terms()]
    if any(cut == 0 for cut, _ in terms):
        return float("inf")
    return 1.01 * sum(size * 2.0 ** (cut * (COARSE - 1)) for cut, size in terms)


class Entry:
    """A number on the way to an entry.

    Parameters
    ----------
    exact : polynomial
        What it is without rounding.
    low, high : arrays
        Enclosures of that over boxes.
    error : array
        How far what is computed may be off, in units of U.
    grid : int, optional
        It is a multiple of 2 to this power, and not off.
    """

    def __init__(
        self, exact: fmpq_mpoly, low: Any, high: Any, error: Any = 0.0, grid: int | None = None
    ) -> None:
        most = MOST_OFF if exact in (OFF, -OFF) else small(exact)
        self.low, self.high = np.maximum(low, -most), np.minimum(high, most)
        self.exact, self.error, self.grid = exact, error, grid

    @property
    def size(self) -> Any:
        """The largest absolute value of what is computed."""
        return np.maximum(np.abs(self.low), np.abs(self.high)) + U * self.error

    def _rounded(self, grid: int | None) -> Entry:
        cut_off = self.exact in CUT_OFF or -self.exact in CUT_OFF  # a multiple of what is below
        if cut_off or (grid is not None and bool((self.size <= 2.0 ** (grid + 53)).all())):
            return Entry(self.exact, self.low, self.high, 0.0, grid)
        return Entry(self.exact, self.low, self.high, _up(self.error + half_ulp(self.size)))

    def __add__(self, other: Any) -> Entry:
        if other is self:
            return Entry(2 * self.exact, 2.0 * self.low, 2.0 * self.high, 2.0 * self.error)
        if not isinstance(other, Entry):
            if abs(other) > 2.0 ** (COARSE + 52) and self.grid is None:  # on to the grid
                half, moved = 2.0 ** (COARSE - 1), CUT_OFF[COORDINATES.index(self.exact)]
                ends = _out(self.low - half + other, self.high + half + other)
                return Entry(self.exact - moved + int(other), *ends, 0.0, COARSE)
            same = other + 0.0 * self.low
            other = Entry(_RING.constant(int(other)), same, same, 0.0, 0)
        ends = _plus((self.low, self.high), (other.low, other.high))
        total = Entry(self.exact + other.exact, *ends, _up(self.error + other.error))
        off = None in (self.grid, other.grid)
        return total._rounded(None if off else min(self.grid, other.grid))

    def __neg__(self) -> Entry:
        return Entry(-self.exact, -self.high, -self.low, self.error, self.grid)

    def __sub__(self, other: Any) -> Entry:
        return self + -other

    def product(self, other: Entry) -> Entry:
        """Return the product before it is rounded."""
        error = _up(_up(self.size * other.error) + _up(other.size * self.error))
        ends = _times((self.low, self.high), (other.low, other.high))
        return Entry(self.exact * other.exact, *ends, error)

    def __mul__(self, other: Entry) -> Entry:
        off = None in (self.grid, other.grid)
        return self.product(other)._rounded(None if off else self.grid + other.grid)  # type: ignore[operator]


def fma(a: Entry, b: Entry, c: Entry) -> Entry:
    """Return ``a·b + c``, rounded once."""
    p = a.product(b)
    ends = _plus((p.low, p.high), (c.low, c.high))
    return Entry(p.exact + c.exact, *ends, _up(p.error + c.error))._rounded(None)


def beside(entry: Entry, wanted: fmpq_mpoly) -> Any:
    """Return how far what is computed may be from wanted/N(q), in units of U.

    Without rounding it is wanted·(2 − N), and so wanted·(N − 1)²/N off; what it takes N − 1 times may be
    without what was cut off.
    """
    left, rest = divmod(entry.exact - wanted * (1 - OFF), OFF)
    assert rest == 0, rest
    second = 1.01 * (MOST_OFF**2 + (small(left) if left != 0 else 0.0) * MOST_OFF) / U
    return _up(entry.error + second)
