"""The integers of a number field as real numbers, ordered by a real place.

The sign of a nonzero integer follows from bounds of the integral basis at the place. The bounds are refined
until they decide.
"""

from fractions import Fraction
from math import ceil, floor

from hfield.checker.budget import spend
from hfield.checker.number_fields.integers import RingOfIntegers
from hfield.checker.number_fields.modular import Vector
from hfield.checker.scalars.real_roots import RealRoot

FIRST_BITS = 128
"""The precision of the first bounds, in bits."""


class RealPlace:
    """The integers of a field, ordered by a real root of its polynomial.

    ``zero`` is the product of each real number with 0; sums and products with it cost nothing.
    """

    def __init__(self, integers: RingOfIntegers, root: RealRoot) -> None:
        self.integers, self._root = integers, root
        self._bounds: list[list[tuple[int, int]]] = []
        self.zero = Real(self, (0,) * integers.n)

    def sign(self, x: Vector) -> int:
        """Return the sign of an integer."""
        if not any(x):
            return 0
        n = 0
        while True:
            if n == len(self._bounds):
                self._refine()
            bounds = self._bounds[n]
            spend(2 * len(x) + sum(map(int.bit_length, x)) * (FIRST_BITS << n) // 500_000)
            least = sum(c * ends[c < 0] for c, ends in zip(x, bounds, strict=True))
            most = sum(c * ends[c > 0] for c, ends in zip(x, bounds, strict=True))
            if least > 0 or most < 0:
                return 1 if least > 0 else -1
            n += 1

    def _refine(self) -> None:
        """Compute bounds of the basis with twice the precision."""
        bits = FIRST_BITS << len(self._bounds)
        self._root = self._root.within(Fraction(1, 1 << bits))
        values = map(self._root.bounds, self.integers.rows)
        self._bounds.append([(floor(a * 2**bits), ceil(b * 2**bits)) for a, b in values])


class Real:
    """An integer of a field, as a real number through a real place."""

    __slots__ = ("place", "row")

    def __init__(self, place: RealPlace, row: Vector) -> None:
        self.place, self.row = place, row

    def _row(self, other: "Real | int") -> Vector:
        if isinstance(other, Real):
            return other.row
        return tuple(other * c for c in self.place.integers.one)

    def __add__(self, other: "Real | int") -> "Real":
        if other is self.place.zero or (isinstance(other, int) and not other):
            return self
        if self is self.place.zero and isinstance(other, Real):
            return other
        return Real(
            self.place, tuple(a + b for a, b in zip(self.row, self._row(other), strict=True))
        )

    __radd__ = __add__

    def __neg__(self) -> "Real":
        return Real(self.place, tuple(-a for a in self.row))

    def __sub__(self, other: "Real | int") -> "Real":
        return self.__add__(-other)

    def __rsub__(self, other: "Real | int") -> "Real":
        return (-self).__add__(other)

    def __mul__(self, other: "Real | int") -> "Real":
        zero = self.place.zero
        if self is zero or other is zero:
            return zero
        if isinstance(other, int):
            return Real(self.place, tuple(other * a for a in self.row)) if other else zero
        return Real(self.place, self.place.integers.mul(self.row, other.row))

    __rmul__ = __mul__

    def __floordiv__(self, n: int) -> "Real":
        return Real(self.place, tuple(a // n for a in self.row))

    def __bool__(self) -> bool:
        return any(self.row)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Real | int) and self.row == self._row(other)

    def __hash__(self) -> int:
        return hash(self.row)

    def __lt__(self, other: "Real | int") -> bool:
        return self.place.sign((self - other).row) < 0

    def __gt__(self, other: "Real | int") -> bool:
        return self.place.sign((self - other).row) > 0

    def __le__(self, other: "Real | int") -> bool:
        return not self > other

    def __ge__(self, other: "Real | int") -> bool:
        return not self < other

    def bit_length(self) -> int:
        """Return the bit length of its longest coordinate."""
        return max(map(int.bit_length, self.row))


RealNumber = Real | int
RealRow = tuple[RealNumber, ...]
