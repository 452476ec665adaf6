"""Real roots of a polynomial over ℚ, as intervals with rational ends at which it has opposite signs."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil, gcd

from hfield.checker.budget import spend, spend_products
from hfield.checker.rejection import reject
from hfield.checker.scalars.rationals import over_one_denominator

MAX_HALVINGS = 4_000


class RealRoot:
    """A root of f in an interval at whose ends f has opposite signs; bisection refines the interval."""

    def __init__(self, f: Sequence[int], low: Fraction, high: Fraction) -> None:
        self.f, self.low, self.high = f, low, high
        self.rising = _value(f, low) < 0

    def sign(self, x: Sequence[Fraction]) -> int:
        """Return the sign of a polynomial x ≠ 0 at the root; f must be irreducible and not divide x."""
        if not any(x):
            return 0
        low, high = self.low, self.high
        for _ in range(MAX_HALVINGS):
            numbers = [n for c in (low, high, *x) for n in (c.numerator, c.denominator)]
            bits = 2 * len(x) * max(map(int.bit_length, numbers))
            spend(len(x) * (20 + bits * bits // 200_000))
            least, most = _bounds(x, low, high)
            if least > 0 or most < 0:
                return 1 if least > 0 else -1
            low, high = self._halved(low, high)
        reject("a sign at a real root takes too many halvings")

    def within(self, width: Fraction) -> "RealRoot":
        """Return the root with an interval of at most this width."""
        low, high = self.low, self.high
        for _ in range(MAX_HALVINGS):
            if high - low <= width:
                return RealRoot(self.f, low, high)
            low, high = self._halved(low, high)
        reject("a real root takes too many halvings")

    def _halved(self, low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
        middle = (low + high) / 2
        return (middle, high) if (_value(self.f, middle) < 0) == self.rising else (low, middle)

    def bounds(self, x: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
        """Return bounds of the value of a polynomial at the root."""
        return _bounds(x, self.low, self.high)


def real_roots(f: Sequence[Fraction]) -> list[RealRoot]:
    """Return all real roots, ascending, of a monic squarefree polynomial without rational roots.

    Sturm's sequence counts them, and intervals are halved until each contains exactly one.
    """
    bound = Fraction(2 + ceil(max(abs(c) for c in f)))
    own = _primitive(over_one_denominator(f)[0])
    chain = [own, _primitive([n * c for n, c in enumerate(own)][1:])]
    while len(chain[-1]) > 1:
        rest = [-c for c in _remainder(chain[-2], chain[-1])]
        if not rest:
            reject("a modulus has a double root")
        chain.append(_primitive(rest))
    out: list[RealRoot] = []
    waiting = [(-bound, bound)]
    while waiting:
        low, high = waiting.pop()
        count = _changes(chain, low) - _changes(chain, high)
        if count == 1:
            out.append(RealRoot(own, low, high))
        elif count > 1:
            middle = (low + high) / 2
            waiting += [(middle, high), (low, middle)]
    return out


def _changes(chain: list[list[int]], x: Fraction) -> int:
    signs = [v > 0 for f in chain if (v := _value(f, x))]
    return sum(a != b for a, b in pairwise(signs))


def _value(f: Sequence[int], x: Fraction) -> int:
    """Return f(x) times a power of the denominator of x, which has the same sign."""
    step = max(x.numerator.bit_length(), x.denominator.bit_length())
    bits = max(c.bit_length() for c in f) + len(f) * step
    spend(len(f) * (1 + bits // 1_000 + bits * step // 500_000))
    total, power = 0, 1
    for c in reversed(f):
        total = total * x.numerator + c * power
        power *= x.denominator
    return total


def _primitive(f: Sequence[int]) -> list[int]:
    """Divide by the positive content, which keeps the signs."""
    bits = max(c.bit_length() for c in f)
    spend(len(f) * (5 + bits * bits // 500_000))
    content = gcd(*f)
    return [c // content for c in f]


def _bounds(f: Sequence[Fraction], low: Fraction, high: Fraction) -> tuple[Fraction, Fraction]:
    """Return bounds of the values of a polynomial on an interval, by Horner's scheme."""
    a = b = Fraction(0)
    for c in reversed(f):
        ends = (a * low, a * high, b * low, b * high)
        a, b = min(ends) + c, max(ends) + c
    return a, b


def _remainder(f: list[int], g: list[int]) -> list[int]:
    """Return the remainder of f by g, times a positive number."""
    f, sign, lead = list(f), 1 if g[-1] > 0 else -1, abs(g[-1])
    while len(f) >= len(g):
        spend_products([lead, f[-1]], [*f, *g])
        top, shift = sign * f[-1], len(f) - len(g)
        f = [lead * c for c in f]
        for k, d in enumerate(g):
            f[shift + k] -= top * d
        f.pop()
    while f and not f[-1]:
        f.pop()
    return f
