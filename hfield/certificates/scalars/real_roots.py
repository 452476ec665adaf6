"""Real roots of a polynomial over ℚ: intervals with rational ends at which it has different signs."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil

from hfield.certificates.rejection import reject
from hfield.certificates.work import charge

MAX_HALVINGS = 4_000


class RealRoot:
    """A root of f in an interval at whose ends f has different signs; bisection goes for one root."""

    def __init__(self, f: Sequence[Fraction], low: Fraction, high: Fraction) -> None:
        self.f, self.low, self.high = f, low, high
        self.rising = _value(f, low) < 0

    def sign(self, x: Sequence[Fraction]) -> int:
        """Return the sign of a polynomial at the root; f is irreducible and no divisor of x ≠ 0."""
        if not any(x):
            return 0
        for _ in range(MAX_HALVINGS):
            low, high = _bounds(x, self.low, self.high)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            self._halve()
        reject("a sign at a real root takes too many halvings")

    def _halve(self) -> None:
        middle = (self.low + self.high) / 2
        charge(10 + middle.denominator.bit_length() // 10)
        if (_value(self.f, middle) < 0) == self.rising:
            self.low = middle
        else:
            self.high = middle


def real_roots(f: Sequence[Fraction]) -> list[RealRoot]:
    """Return all real roots of a monic polynomial without rational and without double roots, ascending.

    Sturm's sequence counts them, and intervals are halved until each has one.
    """
    bound = Fraction(2 + ceil(max(abs(c) for c in f)))
    chain = [list(f), [n * c for n, c in enumerate(f)][1:]]
    charge(100 * len(f) ** 2)
    while len(chain[-1]) > 1:
        chain.append([-c for c in _remainder(chain[-2], chain[-1])])
        if not chain[-1]:
            reject("a modulus has a double root")
    out: list[RealRoot] = []
    waiting = [(-bound, bound)]
    while waiting:
        low, high = waiting.pop()
        charge(10 * len(f) ** 2)
        count = _changes(chain, low) - _changes(chain, high)
        if count == 1:
            out.append(RealRoot(f, low, high))
        elif count > 1:
            middle = (low + high) / 2
            waiting += [(middle, high), (low, middle)]
    return out


def _changes(chain: list[list[Fraction]], x: Fraction) -> int:
    signs = [v > 0 for f in chain if (v := _value(f, x))]
    return sum(a != b for a, b in pairwise(signs))


def _value(f: Sequence[Fraction], x: Fraction) -> Fraction:
    total = Fraction(0)
    for c in reversed(f):
        total = total * x + c
    return total


def _bounds(f: Sequence[Fraction], low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
    """Return bounds of the values of a polynomial on an interval, by Horner's scheme."""
    a = b = Fraction(0)
    for c in reversed(f):
        ends = (a * low, a * high, b * low, b * high)
        a, b = min(ends) + c, max(ends) + c
    return a, b


def _remainder(f: list[Fraction], g: list[Fraction]) -> list[Fraction]:
    f = list(f)
    while len(f) >= len(g):
        c, shift = f[-1] / g[-1], len(f) - len(g)
        for k, d in enumerate(g[:-1]):
            f[shift + k] -= c * d
        f.pop()
    while f and not f[-1]:
        f.pop()
    return f
