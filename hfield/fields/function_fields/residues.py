"""Residue fields k[t]/π of a rational function field k(t), and the computation of roots in them.

Elements are polynomials of FLINT reduced modulo π; k is a finite field or ℚ.
"""

from __future__ import annotations

from functools import cached_property
from random import Random
from typing import TYPE_CHECKING

from hfield.core.product import Scalar
from hfield.fields.base.ring import Ring
from hfield.fields.finite.ring import FiniteField
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.embeddings import square_root
from hfield.fields.number_fields.ring import NumberField

if TYPE_CHECKING:
    import flint

    from hfield.fields.base.flint_types import Polynomial, SparsePolynomial
    from hfield.fields.function_fields.places import FunctionPlace
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.function_fields.ring import FunctionField


def valuation(x: RationalFunction, p: Polynomial) -> int:
    """Return the valuation of a nonzero rational function at the irreducible polynomial p."""
    return multiplicity(x.num, p) if x.num % p == 0 else -multiplicity(x.den, p)


def multiplicity(poly: Polynomial | SparsePolynomial, p: Polynomial | SparsePolynomial) -> int:
    """Return the multiplicity of an irreducible polynomial in a nonzero polynomial."""
    n = 0
    while True:
        quotient, rest = divmod(poly, p)
        if rest != 0:
            return n
        poly, n = quotient, n + 1


class ResidueField:
    """k[t]/π for a monic irreducible π; for π = t this is the field k itself.

    ``field`` is the ring k(t) (its elements have ``num`` and ``den``, its ``base`` is k).
    """

    def __init__(self, field: FunctionField, modulus: Polynomial) -> None:
        self.field, self.modulus = field, modulus
        self.base: Ring = field.base
        self.degree = int(modulus.degree())
        self.zero, self.one = self.scalar(self.base.zero), self.scalar(self.base.one)

    @cached_property
    def order(self) -> int | None:
        """The number of elements; None if it is infinite."""
        return None if self.base.order is None else int(self.base.order) ** self.degree

    @property
    def even(self) -> bool:
        """Whether the characteristic is 2."""
        return self.base.characteristic == 2

    def over_prime_field(self) -> list[Polynomial]:
        """Return a basis over the prime field, if k is finite."""
        k, t = self.base, self.field.gen.num
        assert isinstance(k, FiniteField)
        return [
            self.scalar(k.power(k.gen, m) if m else k.one) * t**n
            for m in range(k.degree)
            for n in range(self.degree)
        ]

    def scalar(self, x: Scalar) -> Polynomial:
        """Return an element of k as a polynomial."""
        return self.field.constant(x).num

    def multiply(self, x: Polynomial, y: Polynomial) -> Polynomial:
        """Return x·y."""
        return x * y % self.modulus

    def inverse(self, x: Polynomial) -> Polynomial:
        """Return 1/x for x ≠ 0."""
        if self.is_one(x):
            return x
        return x.xgcd(self.modulus)[1] % self.modulus

    def is_one(self, x: Polynomial) -> bool:
        """Return whether x = 1."""
        return bool(x == self.one)

    def power(self, x: Polynomial, n: int) -> Polynomial:
        """Return xⁿ for n ≥ 0."""
        result = self.one
        for bit in bin(n)[2:]:
            result = self.multiply(result, result)
            if bit == "1":
                result = self.multiply(result, x)
        return result

    def is_square(self, x: Polynomial) -> bool:
        """Return whether x is a square."""
        if self.order is None:
            return self.sqrt(x) is not None
        if self.order % 2 == 0 or x == 0:
            return True
        return self.is_one(self.power(x, (self.order - 1) // 2))

    def sqrt(self, x: Polynomial) -> Polynomial | None:
        """Return a square root of x, or None if there is none."""
        if x == 0 or self.is_one(x):
            return x
        if self.order is None:
            return _root_over_q(self, x)
        if self.order % 2 == 0:
            return self.power(x, self.order // 2)
        return self._cipolla(x) if self.is_square(x) else None

    def _cipolla(self, x: Polynomial) -> Polynomial:
        """Return the square root of a nonzero square, as a power in the quadratic extension (Cipolla)."""
        rng = Random(1)
        while True:
            r = self.random(rng)
            n = (r * r - x) % self.modulus
            if n == 0:
                return r
            if not self.is_square(n):
                break
        # (r + w)^((Q + 1)/2) with w² = n is a square root of r² − n = x
        u, v, s, w = self.one, self.zero, r, self.one
        assert self.order is not None
        exponent = (self.order + 1) // 2
        while exponent:
            if exponent & 1:
                u, v = (
                    (u * s + v * w % self.modulus * n) % self.modulus,
                    (u * w + v * s) % self.modulus,
                )
            s, w = (s * s + w * w % self.modulus * n) % self.modulus, (s * w + w * s) % self.modulus
            exponent >>= 1
        return u

    def artin_schreier(self, x: Polynomial) -> Polynomial | None:
        """Return y with y² + y = x in a finite field of characteristic 2, or None."""
        assert self.order is not None
        n = self.order.bit_length() - 1
        conjugates = [x]
        for _ in range(n - 1):
            conjugates.append(self.multiply(conjugates[-1], conjugates[-1]))
        if sum(conjugates[1:], conjugates[0]) != 0:
            return None
        rng = Random(1)
        while True:
            u = self.random(rng)
            traces = [u]
            for _ in range(n - 1):
                traces.append(self.multiply(traces[-1], traces[-1]))
            if sum(traces[1:], traces[0]) == self.one:
                break
        # Σ over i < j of u^(2^j)·x^(2^i), for u of trace 1
        y, tail = self.zero, self.zero
        for i in range(n - 2, -1, -1):
            tail = tail + traces[i + 1]
            y = (y + tail * conjugates[i]) % self.modulus
        return y

    def quadratic_root(
        self, a: Polynomial, b: Polynomial, c: Polynomial
    ) -> tuple[Polynomial, Polynomial] | None:
        """Return ``(x, y)`` ≠ (0, 0) with ``a·x² + b·xy + c·y² = 0``, or None."""
        if a == 0:
            return self.one, self.zero
        if not self.even:
            half = self.scalar(self.base.inverse(self.base(2)))
            h = b * half % self.modulus
            root = self.sqrt((h * h - a * c) % self.modulus)
            return None if root is None else ((root - h) % self.modulus, a)
        if b == 0:
            return self.sqrt(self.multiply(c, self.inverse(a))), self.one
        # x = (b/a)·y·z:  z² + z = ac/b²
        inverse = self.inverse(b)
        z = self.artin_schreier(
            a * c % self.modulus * inverse % self.modulus * inverse % self.modulus
        )
        return None if z is None else (b * z % self.modulus, a)

    def random(self, rng: Random) -> Polynomial:
        """Return a random element."""
        t = self.field.gen.num
        x = self.zero
        for _ in range(self.degree):
            x = x * t + self.scalar(self.base.random(rng))
        return x


class FunctionResidues(ResidueField):
    """A place of k(t), a monic irreducible π, with its residue field k[t]/π."""

    @property
    def uniformiser(self) -> RationalFunction:
        """π as an element of k(t)."""
        return self.lift(self.modulus)

    @property
    def inverse_uniformiser(self) -> RationalFunction:
        """1/π."""
        return self.field.quotient(self.field.one.num, self.modulus)

    def lift(self, x: Polynomial) -> RationalFunction:
        """Return a polynomial as an element of k(t)."""
        return self.field.quotient(x, self.field.one.num)

    def valuation(self, x: RationalFunction) -> int:
        """Return the valuation of a nonzero rational function at π."""
        return valuation(x, self.modulus)

    def leading(self, x: RationalFunction) -> tuple[int, Polynomial]:
        """Return the valuation of x ≠ 0, and the class of x divided by that power of the uniformiser."""
        n = self.valuation(x)
        return n, self.reduce(x * self.uniformiser**-n if n else x)

    def reduce(self, x: RationalFunction) -> Polynomial:
        """Return the class of a rational function without a pole at π."""
        return self.multiply(x.num % self.modulus, self.inverse(x.den % self.modulus))

    def truncated(self, x: RationalFunction, n: int) -> RationalFunction:
        """Return the polynomial of least degree over a power of π that is congruent to x modulo πⁿ."""
        k = -min(self.valuation(x), 0) if x.num != 0 else 0
        if n + k <= 0:
            return self.field.zero
        power, scale = self.modulus ** (n + k), self.modulus**k
        below = x.den // scale
        return self.field.quotient(x.num * (below.xgcd(power)[1] % power) % power, scale)


class AtInfinity(FunctionResidues):
    """The place of k(t) at infinity, with residue field k and uniformiser 1/t."""

    def __init__(self, field: FunctionField) -> None:
        super().__init__(field, field.gen.num)

    @property
    def uniformiser(self) -> RationalFunction:
        """1/t."""
        return super().inverse_uniformiser

    @property
    def inverse_uniformiser(self) -> RationalFunction:
        """The variable t."""
        return super().uniformiser

    def valuation(self, x: RationalFunction) -> int:
        """Return the degree of the denominator minus the degree of the numerator."""
        return int(x.den.degree()) - int(x.num.degree())

    def reduce(self, x: RationalFunction) -> Polynomial:
        """Return the value at infinity of a rational function without a pole there."""
        return self.zero if x.num == 0 or self.valuation(x) > 0 else self.leading(x)[1]

    def leading(self, x: RationalFunction) -> tuple[int, Polynomial]:
        """Return the valuation of x ≠ 0, and the first coefficient of x as a series in 1/t."""
        lead = self.field.base_element(x.num.leading_coefficient())
        return self.valuation(x), self.scalar(lead)

    def truncated(self, x: RationalFunction, n: int) -> RationalFunction:
        """Return the sum of the terms of x, a series in 1/t, before (1/t)ⁿ."""
        t = self.field.gen.num
        up, down = t ** max(n - 1, 0), t ** max(1 - n, 0)
        return self.field.quotient(x.num * up // (x.den * down) * down, up)


def residues_at(place: FunctionPlace) -> FunctionResidues:
    """Return a place of k(t) with its residue field."""
    if place.poly is None:
        return AtInfinity(place.field)
    return FunctionResidues(place.field, place.poly)


def _root_over_q(kappa: ResidueField, x: flint.fmpq_poly) -> flint.fmpq_poly | None:
    """Return a square root in a number field ℚ[t]/π, or None."""
    if kappa.degree == 1:
        root = kappa.base.sqrt(x[0])
        return None if root is None else kappa.scalar(root)
    K = NumberField(kappa.modulus)
    y = square_root(K, FieldElement(K, x))
    return None if y is None else y.poly
