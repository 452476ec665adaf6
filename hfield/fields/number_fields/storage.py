"""Storage of elements over a number field: ints for small degrees, else polynomials over a common
denominator.
"""

from __future__ import annotations

from collections.abc import Hashable
from math import gcd, lcm
from typing import TYPE_CHECKING, TypeAlias

import flint

from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import named
from hfield.fields.base.roots import integral
from hfield.fields.base.storage.common_denominator import CommonDenominatorStorage
from hfield.fields.base.storage.compact import Compact
from hfield.fields.base.storage.fractions import FractionStorage
from hfield.fields.number_fields.elements import FieldElement

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField

Polynomials: TypeAlias = tuple[
    flint.fmpz_poly, flint.fmpz_poly, flint.fmpz_poly, flint.fmpz_poly, int
]
"""The numerators of w, x, y, z, and the denominator."""

UNROLLED = 3  # up to this degree, the product is written out in ints


def storage(field: NumberField, constants: Constants) -> Compact:
    """Return the storage of elements over the field, by its degree."""
    if field.degree > UNROLLED:
        return IntegralPolynomials(field, constants)
    scale = int(field.polynomial.denom())  # scale·s is an algebraic integer
    powers = [scale**k for k in range(field.degree)]

    def vector(x: FieldElement) -> tuple[flint.fmpq, ...]:
        return tuple(x.poly[k] / c for k, c in enumerate(powers))

    def element(*parts: int) -> FieldElement:
        numerators, d = parts[: field.degree], parts[field.degree :]
        scaled = [n * c for n, c in zip(numerators, powers, strict=True)]
        return FieldElement(field, flint.fmpq_poly(scaled, *d))

    relation = [-int(c) for c in integral(field.polynomial).coeffs()[:-1]]
    return FractionStorage(field, constants, tuple(relation), vector, element)


class IntegralPolynomials(CommonDenominatorStorage[Polynomials, FieldElement]):
    """Elements over ℚ(s) as four polynomials in c·s, an algebraic integer, over one denominator."""

    relation = ("0",)

    def __init__(self, ring: NumberField, constants: Constants) -> None:
        super().__init__(ring, constants)
        self._field, self._scale = ring, int(ring.polynomial.denom())
        self._modulus = integral(ring.polynomial)
        to_integral, back = flint.fmpq_poly([0, flint.fmpq(1, self._scale)]), [0, self._scale]
        self._to_integral, self._back = to_integral, flint.fmpq_poly(back)
        a, t, b = map(self._polynomial, constants)
        self._m, self._k = lcm(int(a.denom()), int(t.denom())), int(b.denom())
        whole = (a * self._m**2).numer(), (t * self._m).numer(), (b * self._k**2).numer()
        self._constants = dict(zip("atb", whole, strict=True))
        self.pattern = tuple(
            (named(c, name, lambda x, n: x == n),) for name, c in self._constants.items()
        )

    def _polynomial(self, x: FieldElement) -> flint.fmpq_poly:
        """Return x as a polynomial in c·s."""
        return x.poly if self._scale == 1 else x.poly(self._to_integral)

    def _element(self, numerator: flint.fmpz_poly, denominator: int) -> FieldElement:
        poly = flint.fmpq_poly(numerator % self._modulus, denominator)
        return FieldElement(self._field, poly if self._scale == 1 else poly(self._back))

    def encode(self, coordinates: Coordinates) -> Polynomials:
        """Return the element with these coordinates in the field."""
        scales = 1, self._m, self._k, self._m * self._k
        every = [self._polynomial(c) / s for c, s in zip(coordinates, scales, strict=True)]
        d = lcm(*(int(c.denom()) for c in every))
        w, x, y, z = (c.numer() * (d // int(c.denom())) for c in every)
        return self._lowest(w, x, y, z, d)

    def whole(self, w: int, x: int, y: int, z: int) -> Polynomials:
        """Encode four ints."""
        if self._m != 1 or self._k != 1:
            stored: Polynomials = super().whole(w, x, y, z)
            return stored
        return (*(flint.fmpz_poly([c]) for c in (w, x, y, z)), 1)

    def scalar(self, s: FieldElement) -> Polynomials:
        """Encode s·e for an element s of the field."""
        zero = flint.fmpz_poly()
        numerator, d = self.fraction(s)
        return numerator, zero, zero, zero, d

    def fraction(self, s: FieldElement) -> tuple[flint.fmpz_poly, int]:
        """Return s as a polynomial in c·s over ℤ, and its denominator."""
        poly = self._polynomial(s)
        return poly.numer(), int(poly.denom())

    def coordinates(self, stored: Polynomials) -> Coordinates:
        """Return the four coordinates, elements of the field."""
        w, x, y, z, d = stored
        m, k, element = self._m, self._k, self._element
        return element(w, d), element(x * m, d), element(y * k, d), element(z * (m * k), d)

    def names(self) -> dict[str, object]:
        """Return the constants, and the function that reduces fractions to lowest terms."""
        tools = {"n": self._modulus, "element": self._element, "lowest": self._lowest}
        return super().names() | self._constants | tools

    def settle(self, names: list[str]) -> list[str]:
        """Return code that reduces polynomials and returns them over d in lowest terms."""
        reduced = ", ".join(f"{name} % n" for name in names)
        return [f"return lowest({reduced}, d)"]

    def _lowest(
        self, w: flint.fmpz_poly, x: flint.fmpz_poly, y: flint.fmpz_poly, z: flint.fmpz_poly, d: int
    ) -> Polynomials:
        g = d
        for f in (w, x, y, z):
            if g == 1:
                return w, x, y, z, d
            g = gcd(g, int(f.content()))
        return (w, x, y, z, d) if g == 1 else (w // g, x // g, y // g, z // g, d // g)

    def source(self, operation: str) -> str:
        """Return the source text of an operation; the inverse is computed from the inverse of the norm."""
        if operation == "inverse":
            return "def inverse(p):\n    return by_norm(p)"
        return super().source(operation)

    def key(self, p: Polynomials) -> tuple[Hashable, ...]:
        """Return the coefficients and the denominator."""
        return (*(tuple(map(int, f.coeffs())) for f in p[:4]), p[4])
