"""Elements over F(t) as four polynomials over one monic denominator, in lowest terms."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import named
from hfield.fields.base.storage.common_denominator import CommonDenominatorStorage, FractionTuple

if TYPE_CHECKING:
    from collections.abc import Hashable

    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.function_fields.ring import FunctionField


class FunctionStorage(CommonDenominatorStorage):
    """Elements over F(t) as four polynomials over one denominator."""

    relation = ("0",)

    def __init__(self, ring: FunctionField, constants: Constants) -> None:
        super().__init__(ring, constants)
        self._field, self._one = ring, ring.one.num
        a, t, b = constants
        self._m, self._k = self._common(a.den, t.den), b.den
        integral = Constants(
            a.num * (self._m * self._m // a.den), t.num * (self._m // t.den), b.num * self._k
        )
        self._constants = integral._asdict()
        self.pattern = tuple(
            (named(c, name, lambda x, n: x == n),) for name, c in self._constants.items()
        )

    def _common(self, *polynomials: Polynomial) -> Polynomial:
        """Return the least common multiple of monic polynomials."""
        common = self._one
        for f in polynomials:
            common = common * (f // common.gcd(f))
        return common

    def encode(self, coordinates: Coordinates) -> FractionTuple:
        """Return the element with these coordinates, rational functions."""
        scales = self._one, self._m, self._k, self._m * self._k
        denominators = [c.den * s for c, s in zip(coordinates, scales, strict=True)]
        d = self._common(*denominators)
        w, x, y, z = (c.num * (d // e) for c, e in zip(coordinates, denominators, strict=True))
        return self._lowest(w, x, y, z, d)

    def fraction(self, s: RationalFunction) -> FractionTuple:
        """Return numerator and denominator of a rational function."""
        return s.num, s.den

    def coordinates(self, stored: FractionTuple) -> Coordinates:
        """Return the four coordinates, rational functions."""
        quotient, m, k = self._field.quotient, self._m, self._k
        w, x, y, z, d = stored
        return quotient(w, d), quotient(x * m, d), quotient(y * k, d), quotient(z * m * k, d)

    def names(self) -> dict[str, object]:
        """Return the constants, and the function that reduces fractions to lowest terms."""
        tools = {"element": self._field.quotient, "one": self._one, "lowest": self._lowest}
        return super().names() | self._constants | tools

    def settle(self, names: list[str]) -> list[str]:
        """Return code that returns polynomials over d in lowest terms."""
        listed = ", ".join(names)
        return [f"return ({listed}, d) if d == one else lowest({listed}, d)"]

    def _lowest(self, *fraction: Polynomial) -> FractionTuple:
        """Reduce polynomials over a common denominator, the last entry, to lowest terms, with monic
        denominator.
        """
        one = self._one
        common = fraction[-1]
        for f in fraction[:-1]:
            if common.degree() == 0:
                break
            common = common.gcd(f)
        lead = fraction[-1].leading_coefficient()
        common = common * lead if common.degree() else one * lead
        return fraction if common == one else tuple(f // common for f in fraction)

    def key(self, p: FractionTuple) -> tuple[tuple[Hashable, ...], ...]:
        """Return the coefficients."""
        F = self._field
        return tuple(tuple(F.base.key(F.base_element(c)) for c in f.coeffs()) for f in p)
