"""Ideals of the polynomials over a finite field, each by its monic generator; fractional ones too."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from hfield.errors import CoercionError, HFieldError, RingError, shorten
from hfield.fields.base.ring import shared
from hfield.fields.finite.ring import ExtensionField, FiniteField
from hfield.fields.function_fields.places import FunctionPlace
from hfield.fields.function_fields.quotients import RationalFunction
from hfield.fields.function_fields.residues import FunctionResidues, valuation

if TYPE_CHECKING:
    from collections.abc import Callable
    from fractions import Fraction

    from flint import fq_default_poly

    from hfield.fields.base.flint_types import Coefficient, Polynomial
    from hfield.fields.function_fields.ring import FunctionField


class PolynomialIntegers:
    """The ring GF(q)[t] in a field GF(q)(t).

    ``field`` is isomorphic to ``ring`` and computes with flint's ``fq_default_poly``, which has hashes.
    """

    def __init__(self, ring: FunctionField) -> None:
        k = ring.base
        assert isinstance(k, FiniteField), "ideals are those over finite fields"
        self.ring, self.order = ring, int(k.order or 0)
        self.field = ring
        if not isinstance(k, ExtensionField):
            below = shared(ExtensionField, k.characteristic, 1)
            self.field = type(ring)(below, str(ring.gen_name))

    def inside(self, x: object) -> RationalFunction:
        """Return an element of ``ring``, or what it reads, as one of ``field``."""
        if isinstance(x, RationalFunction) and x.field is self.field:
            return x
        found = self.ring(x)
        return found if self.field is self.ring else self._converted(found, self.ring, self.field)

    def outside(self, x: RationalFunction) -> RationalFunction:
        """Return an element of ``field`` as one of ``ring``."""
        return x if self.field is self.ring else self._converted(x, self.field, self.ring)

    def _converted(
        self, x: RationalFunction, source: FunctionField, target: FunctionField
    ) -> RationalFunction:
        label, k = labels(source), target.base
        parts = ([k(label(source.base_element(c))) for c in p.coeffs()] for p in (x.num, x.den))
        num, den = (sum_of_powers(target, found) for found in parts)
        return target.quotient(num, den)

    def ideal(self, x: object) -> FunctionFieldIdeal:
        """Return the ideal of a polynomial, a fraction, a text, a prime or generators.

        Raises :class:`CoercionError` for anything else, and for 0.
        """
        if isinstance(x, FunctionFieldIdeal):
            if x.integers.ring == self.ring:
                return x
            raise CoercionError(f"{x} is an ideal over {x.integers.ring}, not over {self.ring}")
        if isinstance(x, FunctionPlace):
            if x.poly is None:
                raise CoercionError(f"inf is not a prime of {self.text}: expected a polynomial")
            x = x.field.quotient(x.poly, x.field.one.num)
        if isinstance(x, list | tuple):
            some = [self.ideal(g) for g in x if not self.ring.is_zero(self.ring(g))]
            if not some:
                raise CoercionError("the zero ideal is not allowed: give a nonzero generator")
            found = some[0]
            for other in some[1:]:
                found = found + other
            return found
        if isinstance(x, str):
            x = x.strip().removeprefix("ideal")
        value = self.inside(x)
        if value.num == 0:
            raise CoercionError("the zero ideal is not allowed: give a nonzero generator")
        return self.principal(value)

    def principal(self, x: RationalFunction) -> FunctionFieldIdeal:
        """Return the ideal of an element of ``field`` that is not 0."""
        return FunctionFieldIdeal(self, self.field.quotient(x.num.monic(), x.den))

    @property
    def text(self) -> str:
        """How the ring is written: GF(3)[t]."""
        return f"{self.ring.base.name}[{self.ring.gen_name}]"


def sum_of_powers(field: FunctionField, coefficients: list[Coefficient]) -> Polynomial:
    """Return the polynomial with coefficients in the field of constants, low degree first."""
    found, t = field.zero.num, field.gen.num
    for c in reversed(coefficients):
        found = found * t + field.constant(c).num
    return found


def labels(field: FunctionField) -> Callable[[Coefficient], int]:
    """Return the map of the constants, which are a finite field, to their labels."""
    k = field.base
    assert isinstance(k, FiniteField)
    return k.label


@lru_cache(maxsize=64)
def polynomial_integers(ring: FunctionField) -> PolynomialIntegers:
    """Return the polynomials in a field of rational functions over a finite field."""
    return PolynomialIntegers(ring)


class FunctionFieldIdeal:
    """A fractional ideal of GF(q)[t], with the names that ideals of number fields have.

    >>> from hfield import QuaternionAlgebra
    >>> D = QuaternionAlgebra.from_ramification("GF(3)(t)", ["t^2+1", "inf"]).maximal_order().discriminant()
    >>> D, D.generator, D.norm(), D.is_prime()
    (ideal(t^2+1), t^2+1, 9, True)
    """

    def __init__(self, integers: PolynomialIntegers, x: RationalFunction) -> None:
        self.integers, self.x = integers, x

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (self.integers.ring, self.generator)

    @property
    def ring(self) -> FunctionField:
        """The field."""
        return self.integers.ring

    @property
    def generator(self) -> RationalFunction:
        """The monic generator, an element of the field."""
        return self.integers.outside(self.x)

    @property
    def generators(self) -> tuple[RationalFunction, ...]:
        """The monic generator alone."""
        return (self.generator,)

    @property
    def place(self) -> FunctionPlace:
        """The place of a prime ideal."""
        return FunctionPlace(self.ring, self.generator.num)

    @property
    def polynomial(self) -> fq_default_poly:
        """The generator of an integral ideal as a polynomial."""
        return self.x.num

    def _other(self, x: object) -> FunctionFieldIdeal | None:
        try:
            return self.integers.ideal(x)
        except HFieldError:
            return None

    def __mul__(self, other: object) -> FunctionFieldIdeal:
        o = self._other(other)
        return NotImplemented if o is None else FunctionFieldIdeal(self.integers, self.x * o.x)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> FunctionFieldIdeal:
        o = self._other(other)
        return NotImplemented if o is None else FunctionFieldIdeal(self.integers, self.x / o.x)

    def __rtruediv__(self, other: object) -> FunctionFieldIdeal:
        o = self._other(other)
        return NotImplemented if o is None else o / self

    def __add__(self, other: object) -> FunctionFieldIdeal:
        """Return the sum, which the greatest common divisor generates."""
        o = self._other(other)
        if o is None:
            return NotImplemented
        x, y = self.x, o.x
        common = (x.num * y.den).gcd(y.num * x.den)
        return self.integers.principal(self.integers.field.quotient(common, x.den * y.den))

    __radd__ = __add__

    def __and__(self, other: object) -> FunctionFieldIdeal:
        """Return the intersection."""
        o = self._other(other)
        return NotImplemented if o is None else self * o / (self + o)

    def __pow__(self, n: int) -> FunctionFieldIdeal:
        return FunctionFieldIdeal(self.integers, self.x**n)

    def inverse(self) -> FunctionFieldIdeal:
        """Return the inverse."""
        return self**-1

    def __eq__(self, other: object) -> bool:
        o = self._other(other)
        return o is not None and bool(self.x == o.x)

    def __hash__(self) -> int:
        return hash((self.x.num, self.x.den))

    def __contains__(self, x: object) -> bool:
        value = self.integers.inside(x)
        return bool(value.num == 0 or (value / self.x).den.degree() == 0)

    def is_integral(self) -> bool:
        """Return whether all elements are polynomials."""
        return bool(self.x.den.degree() == 0)

    def is_principal(self) -> bool:
        """Return True: all ideals are principal."""
        return True

    def norm(self) -> int | Fraction:
        """Return the number of residues, q to the degree of the generator."""
        from fractions import Fraction

        n = int(self.x.num.degree()) - int(self.x.den.degree())
        return int(self.integers.order**n) if n >= 0 else Fraction(1, self.integers.order**-n)

    @property
    def degree(self) -> int:
        """The degree of the generator."""
        return int(self.x.num.degree()) - int(self.x.den.degree())

    def valuation(self, prime: object) -> int:
        """Return the exponent of a prime ideal."""
        return valuation(self.x, self.integers.ideal(prime).polynomial)

    def factorisation(self) -> tuple[tuple[FunctionFieldIdeal, int], ...]:
        """Return the prime ideals with their exponents, by degree, then by coefficients."""
        field = self.integers.field
        found = [
            (
                FunctionFieldIdeal(self.integers, field.quotient(p.monic(), field.one.num)),
                sign * int(e),
            )
            for sign, part in ((1, self.x.num), (-1, self.x.den))
            for p, e in part.factor()[1]
        ]
        return tuple(sorted(found, key=lambda pair: pair[0].sort_key))

    @property
    def sort_key(self) -> tuple[object, ...]:
        """The sort key of ideals."""
        label = labels(self.integers.field)
        parts = ([label(c) for c in reversed(p.coeffs())] for p in (self.x.num, self.x.den))
        return self.degree, *parts

    def is_prime(self) -> bool:
        """Return whether the generator is an irreducible polynomial."""
        found = self.factorisation()
        return len(found) == 1 and found[0][1] == 1

    def __str__(self) -> str:
        return f"ideal({self.ring.text(self.generator)})"

    __repr__ = __str__


def _restored(ring: FunctionField, x: RationalFunction) -> FunctionFieldIdeal:
    return polynomial_integers(ring).ideal(x)


class PolynomialResidueField(FunctionResidues):
    """The residue field of a prime ideal; it is the prime field of the theory of orders over GF(q)[t]."""

    index = 1

    def __init__(self, prime: FunctionFieldIdeal) -> None:
        super().__init__(prime.integers.field, prime.polynomial)
        self.below = prime.polynomial


@lru_cache(maxsize=256)
def residue_field(prime: FunctionFieldIdeal) -> PolynomialResidueField:
    """Return the residue field of a prime ideal."""
    return PolynomialResidueField(prime)


def prime_ideal(integers: PolynomialIntegers, x: object) -> FunctionFieldIdeal:
    """Return a prime from user input. Raises :class:`RingError` for anything else."""
    found = integers.ideal(x)
    if not found.is_prime():
        raise RingError(
            f"{shorten(x)} is not a prime of {integers.text}: expected an irreducible polynomial"
        )
    return found
