"""Logarithms of absolute values of algebraic numbers at the infinite places, with proved bounds.

All numbers are integers over a power of 2. The roots of the polynomial lie in discs (Smith 1970), which
Newton's iteration makes small: one of the n roots of f is within n·|f(z)/f′(z)| of z. The bounds add the
deviation of a polynomial on a disc from its value at the centre.
"""

from collections.abc import Sequence
from functools import lru_cache
from math import factorial, isqrt

from hfield.checker.budget import spend
from hfield.checker.number_fields.matrices import determinant
from hfield.checker.rejection import reject
from hfield.checker.scalars.number_fields import BITS, Disc, root_discs

DIGITS = 400
"""Binary digits of a logarithm."""
FINEST = 1 << 15
RELATIVE = 200  # binary digits to which an absolute value is known
SLACK = 12  # binary digits that rounding may spoil

Interval = tuple[int, int]


class Places:
    """The infinite places of ℚ[θ], where f(θ) = 0 for f monic over ℤ; real places first."""

    def __init__(self, f: Sequence[int]) -> None:
        self.f, self.n = list(f), len(f) - 1
        self._roots = root_discs(self.f)
        real = [d for d in self._roots if abs(d[1]) <= d[2]]  # they meet their own conjugates
        upper = [d for d in self._roots if d[1] > d[2]]
        self.real, self.complex = len(real), len(upper)
        self._discs: dict[int, list[Disc]] = {BITS: sorted(real) + sorted(upper)}

    @property
    def rank(self) -> int:
        """The rank of the group of units."""
        return self.real + self.complex - 1

    def _at(self, bits: int) -> list[Disc]:
        """Return, for each place, a disc over 2^bits around the root."""
        if bits not in self._discs:
            first = self._discs[BITS]
            self._discs[bits] = [self._refined(d, k < self.real, bits) for k, d in enumerate(first)]
        return self._discs[bits]

    def _refined(self, disc: Disc, real: bool, bits: int) -> Disc:
        """Return a smaller disc around the root in a disc."""
        shift = bits - BITS
        slope = [k * c for k, c in enumerate(self.f)][1:]
        x, y = disc[0] << shift, 0 if real else disc[1] << shift
        for _ in range(bits.bit_length()):
            spend(self.n * self.n * (4 + bits * bits // 100_000))
            step = _quotient(_value(self.f, x, y, bits), _value(slope, x, y, bits), bits)
            x, y = x - step[0], 0 if real else y - step[1]
        off = _quotient(_value(self.f, x, y, bits), _value(slope, x, y, bits), bits)
        r = self.n * (abs(off[0]) + abs(off[1]) + 2)
        near = [
            d
            for d in self._roots
            if max(abs(x - (d[0] << shift)), abs(y - (d[1] << shift))) <= r + (d[2] << shift)
        ]
        if near != [disc]:
            reject("a root of a modulus is not found here")
        return x, y, r

    def logarithms(self, c: Sequence[int], den: int) -> list[Interval]:
        """Return bounds of log|x| at each place (of 2·log|x| at complex places), for x = Σ cₖθᵏ/den ≠ 0."""
        bits = 2 * BITS
        while bits <= FINEST:
            spend(self.n * self.n * (20 + bits * bits // 50_000))
            found = [_size(c, disc, bits) for disc in self._at(bits)]
            if all(high - low << RELATIVE <= low for low, high in found):
                below = log(den << bits)
                out = []
                for k, (low, high) in enumerate(found):
                    times = 1 if k < self.real else 2
                    out.append(
                        (times * (log(low)[0] - below[1]), times * (log(high)[1] - below[0]))
                    )
                return out
            bits *= 2
        reject("an element has conjugates too small to be distinguished from 0 here")

    def values(self, c: Sequence[int], den: int, bits: int) -> list[tuple[int, int]]:
        """Return real and imaginary parts of Σ cₖθᵏ/den at each place, over 2^bits, with an error below 3."""
        work = 2 * BITS
        while work <= FINEST:
            spend(self.n * self.n * (20 + work * work // 50_000))
            discs = self._at(work)
            if all(_error(c, disc, work) >> work - bits < den for disc in discs):
                out = []
                for x, y, _ in discs:
                    re, im, power = _value(c, x, y, work)
                    below = den << power
                    out.append(((re << bits) // below, (im << bits) // below))
                return out
            work *= 2
        reject("the conjugates of an integral basis are not bounded here")


def _value(f: Sequence[int], x: int, y: int, bits: int) -> tuple[int, int, int]:
    """Return f(z) exactly, for z = (x + iy)/2^bits: both parts over a power of 2, and its exponent."""
    re, im, power = 0, 0, 0
    for c in reversed(f):
        re, im, power = re * x - im * y, re * y + im * x, power + bits
        re += c << power
    return re, im, power


def _quotient(a: tuple[int, int, int], b: tuple[int, int, int], bits: int) -> tuple[int, int]:
    """Return a/b over 2^bits, with an error below 1 in each part."""
    size = b[0] * b[0] + b[1] * b[1]
    if not size:
        reject("a root of a modulus is not found here")
    shift = bits + b[2] - a[2]
    parts = a[0] * b[0] + a[1] * b[1], a[1] * b[0] - a[0] * b[1]
    re, im = ((part << shift if shift >= 0 else part >> -shift) // size for part in parts)
    return re, im


def _size(c: Sequence[int], disc: Disc, bits: int) -> Interval:
    """Return bounds of |Σ cₖzᵏ| over 2^bits, for z in a disc."""
    re, im, power = _value(c, disc[0], disc[1], bits)
    middle, error = isqrt(re * re + im * im) >> power - bits, _error(c, disc, bits)
    return middle - error, middle + 1 + error


def _error(c: Sequence[int], disc: Disc, bits: int) -> int:
    """Return the maximal deviation over 2^bits of Σ cₖzᵏ on a disc from its value at the centre."""
    x, y, r = disc
    reach, slope = abs(x) + abs(y) + r, 0
    for k in range(len(c) - 1, 0, -1):
        slope = (slope * reach >> bits) + 1 + (k * abs(c[k]) << bits)
    return (slope * r >> bits) + 2


@lru_cache(maxsize=4)
def _log2(digits: int) -> Interval:
    found = 2 * _atanh(1, 3, digits)
    return found - (1 << SLACK), found + (1 << SLACK)


def _atanh(a: int, b: int, digits: int) -> int:
    """Return artanh(a/b), 0 ≤ a/b ≤ 1/3, over 2^digits, with an error below 2^(SLACK − 2).

    Each term has an error of at most 3, and there are fewer than ``digits`` terms.
    """
    t = (a << digits) // b
    square, power, total, k = t * t >> digits, t, 0, 1
    while power:
        total += power // k
        power, k = power * square >> digits, k + 2
    return total


def log(n: int) -> Interval:
    """Return bounds of the logarithm of a positive integer, over 2^DIGITS."""
    spend(60 + n.bit_length() // 100)
    e = n.bit_length() - 1
    top = 1 << e
    found, two = 2 * _atanh(n - top, n + top, DIGITS), _log2(DIGITS)
    return found - (1 << SLACK) + e * two[0], found + (1 << SLACK) + e * two[1]


def volume(rows: Sequence[Sequence[int]], logs: Sequence[Sequence[Interval]]) -> Interval:
    """Return bounds of |det| over 2^(DIGITS·r), for rows of integers followed by r logarithms."""
    whole = [
        [*row, *((low + high) // 2 for low, high in log)]
        for row, log in zip(rows, logs, strict=True)
    ]
    n, r = len(whole), len(logs[0]) if logs else 0
    middle = abs(determinant(whole))
    error = max((high - low for log in logs for low, high in log), default=0) + 1
    most = [1 + error * (k >= n - r) + max(abs(row[k]) for row in whole) for k in range(n)]
    product = factorial(n)
    for m in most:
        product *= m
    # |det(A + E) − det(A)|: n! products, of each in each one factor is replaced by an error
    off = sum(product // m * error for m in most[n - r :])
    return middle - off, middle + off
