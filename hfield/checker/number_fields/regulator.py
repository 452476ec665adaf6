"""A lower bound for the regulator, from all short integers of the field (docs/explanation/trust.md)."""

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt

from hfield.checker.number_fields.bounds import HERMITE_POWERS, short_length
from hfield.checker.number_fields.enumeration import short_vectors
from hfield.checker.number_fields.integers import RingOfIntegers
from hfield.checker.number_fields.logarithms import DIGITS, Places, log
from hfield.checker.number_fields.matrices import Rows
from hfield.checker.rejection import reject
from hfield.checker.scalars.number_fields import Element
from hfield.checker.scalars.rationals import over_one_denominator

FORM_BITS = 48
"""Binary digits of the form Σ|xᵥ|² over the integral basis."""
STEP_BITS = 20
"""Binary digits of the logarithms to which lengths of units are bounded."""


class ShortUnits:
    """The units among the integers x with Σ|xᵥ|² ≤ K over the embeddings, one of ±x."""

    def __init__(self, integers: RingOfIntegers, places: Places) -> None:
        self.integers, self.places = integers, places
        self.length = short_length(integers.n, integers.discriminant)
        bound = self.length << FORM_BITS
        vectors = (x for x, _ in short_vectors(self._form(), bound))
        self.units = [self.number(x) for x in vectors if abs(integers.norm(x)) == 1]

    def number(self, row: Sequence[int]) -> Element:
        """Return an integer of the field with given coordinates."""
        return self.integers.number([Fraction(c) for c in row])

    def _form(self) -> Rows:
        """Return integers for a form that is at most 2^FORM_BITS·Σ|xᵥ|².

        Entries have an error below 2, which changes the form by at most 2·(Σ|xᵢ|)² ≤ 2n·Σxᵢ².
        """
        n, scale = self.integers.n, self.integers.field.scale
        numerators = [
            over_one_denominator([a / scale**k for k, a in enumerate(row)])
            for row in self.integers.rows
        ]
        values = [self.places.values(c, den, 2 * FORM_BITS) for c, den in numerators]
        if any(abs(part) >> 3 * FORM_BITS - 16 for value in values for z in value for part in z):
            reject("the conjugates of the integral basis are too large to list short integers")
        form = [[0] * n for _ in range(n)]
        for i in range(n):
            for j in range(n):
                total = 0
                for k, (z, w) in enumerate(zip(values[i], values[j], strict=True)):
                    part = z[0] * w[0] + z[1] * w[1]
                    total += part if k < self.places.real else 2 * part
                form[i][j] = (total >> 3 * FORM_BITS) - (2 * n if i == j else 0)
        return tuple(map(tuple, form))

    def least_volume(self, torsion: Sequence[Element]) -> int:
        """Return a lower bound for the regulator over 2^(DIGITS·r), where r > 0 is the rank of the units.

        ``torsion`` holds all roots of unity.
        """
        n, rank, complex_ = self.integers.n, self.places.rank, self.places.complex
        if rank >= len(HERMITE_POWERS):
            return 0
        least = shortest_logarithm(n, 1 if self.places.real else 2, self.length)
        roots = set(torsion)
        for x in self.units:
            if x not in roots:
                least = min(least, self._square(x))
        power = Fraction(HERMITE_POWERS[rank]) * n / 2**complex_
        square = (least**rank << DIGITS * rank) * power.denominator // power.numerator
        return isqrt(square)

    def _square(self, x: Element) -> int:
        """Return a lower bound for Σ log²|xᵥ| over the embeddings, over 2^DIGITS."""
        scale = self.integers.field.scale
        c, den = over_one_denominator([a / scale**k for k, a in enumerate(x)])
        total = 0
        for k, (low, high) in enumerate(self.places.logarithms(c, den)):
            least = max(low, -high, 0)
            total += least * least if k < self.places.real else least * least // 2
        return total >> DIGITS


def shortest_logarithm(n: int, e: int, length: int) -> int:
    """Return a lower bound for Σ log²|εᵥ|, over 2^DIGITS, for units ε with Σ|xᵥ|² > ``length`` at ε and 1/ε.

    It is e·u²/2 with e·(eᵘ − 1 − u + u²/2) = length − n, where the coefficient e is 2 if all places are
    complex, else 1.
    """
    low, high = 0, 1 << STEP_BITS + 6
    while high - low > 1:
        middle = (low + high) // 2
        u = Fraction(middle, 1 << STEP_BITS)
        top = Fraction(length - n, e) + 1 + u - u * u / 2
        reach = 0
        if top >= 1:  # eᵘ ≤ top
            reach = log(top.numerator)[0] - log(top.denominator)[1]
        if top >= 1 and middle << DIGITS - STEP_BITS <= reach:
            low = middle
        else:
            high = middle
    return e * low * low << DIGITS - 2 * STEP_BITS - 1
