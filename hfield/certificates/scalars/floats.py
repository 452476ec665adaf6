"""Floats, on which nothing is proved: small integers, with which they compute exactly."""

from collections.abc import Mapping
from fractions import Fraction

from hfield.certificates.rejection import reject
from hfield.certificates.scalars.names import plain
from hfield.certificates.scalars.rationals import Rationals
from hfield.certificates.scalars.ring import Kind, ReadRing, Ring


class Floats(Rationals):
    """Floats, which are no ring: only integers below 2⁵³, on which they compute exactly."""

    is_exact = False

    def __init__(self) -> None:
        super().__init__(False)
        self.name, self.is_integral = "RDF", False
        self.words = "floating-point numbers"

    def number(self, n: int) -> Fraction:
        """Return n."""
        return self._exact(Fraction(n))

    def add(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x + y."""
        return self._exact(x + y)

    def mul(self, x: Fraction, y: Fraction) -> Fraction:
        """Return x·y."""
        return self._exact(x * y)

    def inverse(self, x: Fraction) -> Fraction | None:
        """Refuse: a quotient of floats is rounded."""
        reject("quotients of floats are not exact")

    def fraction(self, value: int | Fraction) -> Fraction:
        """Return an integer, perhaps written with a decimal point."""
        return self._exact(Fraction(value))

    def _exact(self, x: Fraction) -> Fraction:
        if x.denominator != 1 or abs(x) >= 1 << 53:
            reject("floats are taken only where they are integers below 2^53")
        return x


def _floats(data: Mapping[str, object], ring: ReadRing) -> Ring:
    plain(data, "")
    return Floats()


KINDS: dict[str, Kind] = {"floats": _floats}
