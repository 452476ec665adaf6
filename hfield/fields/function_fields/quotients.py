"""Rational functions as quotients of two flint polynomials, and their fields."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from math import prod
from typing import TYPE_CHECKING

from hfield.checker.glossary import reads_like_a_constant
from hfield.errors import NotInvertibleError, shorten
from hfield.fields.base.operators import Element, Overfield
from hfield.fields.base.powers import polynomial_power
from hfield.fields.base.ring import INFINITY, Fact, S
from hfield.fields.base.roots import monic

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import AnyPolynomial, Coefficient
    from hfield.fields.base.ring import E, Embedding, Ring


class RationalFunction(Element):
    """An immutable rational function: two flint polynomials in lowest terms, ``den`` monic."""

    __slots__ = ("den", "num")

    field: FractionField
    num: AnyPolynomial
    den: AnyPolynomial

    def __init__(self, field: FractionField, num: AnyPolynomial, den: AnyPolynomial) -> None:
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "num", num)
        object.__setattr__(self, "den", den)

    def plus(self, other: RationalFunction) -> RationalFunction:
        """Return the sum."""
        if self.den == other.den:
            if self.field.is_one(self.den):
                return RationalFunction(self.field, self.num + other.num, self.den)
            return self.quotient(self.num + other.num, self.den)
        # A common factor divides the common divisor of the denominators (Henrici, J. ACM 3, 1956).
        common = self.den.gcd(other.den)
        if self.field.is_one(common):
            num = self.num * other.den + other.num * self.den
            return RationalFunction(self.field, num, self.den * other.den)
        rest = self.den // common
        num = self.num * (other.den // common) + other.num * rest
        num, den = self._cancelled(num, common)
        return RationalFunction(self.field, num, rest * (other.den // common) * den)

    def __neg__(self) -> RationalFunction:
        return RationalFunction(self.field, -self.num, self.den)

    def times(self, other: RationalFunction) -> RationalFunction:
        """Return the product."""
        if self.field.is_one(self.den) and self.field.is_one(other.den):
            return RationalFunction(self.field, self.num * other.num, self.den)
        first, below = self._cancelled(self.num, other.den)
        second, den = self._cancelled(other.num, self.den)
        return RationalFunction(self.field, first * second, below * den)

    def _cancelled(
        self, num: AnyPolynomial, den: AnyPolynomial
    ) -> tuple[AnyPolynomial, AnyPolynomial]:
        """Return num and den, where den is monic, without their common factor."""
        if self.field.is_one(den):
            return num, den
        common = num.gcd(den)
        return (num, den) if self.field.is_one(common) else (num // common, den // common)

    def quotient(self, num: AnyPolynomial, den: AnyPolynomial) -> RationalFunction:
        """Return num/den in lowest terms."""
        return self.field.quotient(num, den)

    def __pow__(self, n: int) -> RationalFunction:
        base = self if n >= 0 else self.field.inverse(self)
        one = self.field.one.num
        num, den = (polynomial_power(one, x, abs(n)) for x in (base.num, base.den))
        return RationalFunction(self.field, num, den)

    def __bool__(self) -> bool:
        return bool(self.num != 0)

    def same(self, other: RationalFunction) -> bool:
        """Return whether both are the same function."""
        return bool(self.num == other.num and self.den == other.den)


def _terms(x: AnyPolynomial) -> dict[tuple[int, ...], Coefficient]:
    """Return the coefficients of a flint polynomial, in one variable or several, by exponents."""
    if hasattr(x, "to_dict"):
        found: dict[tuple[int, ...], Coefficient] = x.to_dict()
        return found
    return {(n,): c for n, c in enumerate(x.coeffs()) if c != 0}


class FractionField(Overfield[RationalFunction]):
    """The fractions of polynomials over ``base``, in one variable or several; ``_one`` is the
    polynomial 1.
    """

    base: Ring
    variables: tuple[str, ...]
    _one: AnyPolynomial

    @abstractmethod
    def quotient(self, num: AnyPolynomial, den: AnyPolynomial) -> RationalFunction:
        """Return num/den in lowest terms; den is not 0."""

    def product_of(self, polynomials: Iterable[AnyPolynomial | None]) -> RationalFunction:
        """Return the product of the polynomials in a list of places."""
        product = prod((p for p in polynomials if p is not None), start=self._one)
        return self.quotient(product, self._one)

    def is_one(self, poly: AnyPolynomial) -> bool:
        """Return whether a polynomial is 1."""
        return bool(poly == self._one)

    def is_zero(self, x: RationalFunction) -> bool:
        """Return whether x is 0."""
        return bool(x.num == 0)

    def equal(self, x: RationalFunction, y: RationalFunction) -> bool:
        """Return whether x = y."""
        return bool(x == y)

    def inverse(self, x: RationalFunction) -> RationalFunction:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        if x.num == 0:
            raise NotInvertibleError(f"cannot divide by 0 in {self.name}")
        return self.quotient(x.den, x.num)

    def power(self, x: RationalFunction, n: int) -> RationalFunction:
        """Return xⁿ; for n < 0, x is inverted first."""
        return x**n

    def irreducible_factors(
        self, coefficients: Sequence[RationalFunction]
    ) -> list[list[RationalFunction]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial.

        Over k = QQ and GF(p) they are found from those of a polynomial in one more variable (Gauss's lemma);
        over other fields as in :meth:`hfield.fields.base.ring.Ring.irreducible_factors`.
        """
        from hfield.fields.polynomial_rings import flint_context

        if self.base.order not in (None, self.characteristic):
            return super().irreducible_factors(coefficients)
        common = self._one
        for c in coefficients:
            common = common * (c.den // common.gcd(c.den))
        whole = flint_context(self.base, (*self.variables, "over them")).from_dict(
            {
                (*exponents, n): x if self.base.order is None else int(x)
                for n, c in enumerate(coefficients)
                for exponents, x in _terms(c.num * (common // c.den)).items()
            }
        )
        named = self.names()
        gens = [named[name] for name in self.variables]
        out = []
        for factor, _ in whole.factor()[1]:
            found: list[RationalFunction] = []
            for (*exponents, n), x in sorted(
                factor.to_dict().items(), key=lambda term: term[0][-1]
            ):
                found += [self.zero] * (n + 1 - len(found))
                term = prod((g**m for g, m in zip(gens, exponents, strict=True)), start=self(x))
                found[n] = found[n] + term
            if len(found) > 1:
                out.append(monic(self, found))
        return out

    @property
    def values_ring(self) -> Ring:
        """The field of constants."""
        return self.base

    @abstractmethod
    def polynomial_evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[AnyPolynomial], S]:
        """Return :meth:`evaluation` for numerators and denominators."""

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[RationalFunction], S]:
        """Return the homomorphism that maps the variables to these images, if there is no pole."""
        polynomial = self.polynomial_evaluation(target, images, below)

        def value(x: RationalFunction) -> S:
            if self.is_one(x.den):
                return polynomial(x.num)
            return value_of_fraction(self, x, target, polynomial(x.num), polynomial(x.den))

        return value

    @abstractmethod
    def partial(self, poly: AnyPolynomial, variable: str) -> AnyPolynomial:
        """Return the derivative of a numerator or denominator by a variable."""

    def derivative(self, x: RationalFunction, variable: str) -> RationalFunction:
        """Return the partial derivative, by the quotient rule."""
        if variable not in self.variables:
            return super().derivative(x, variable)
        num, den = (self.partial(p, variable) for p in (x.num, x.den))
        return self.quotient(num * x.den - x.num * den, x.den * x.den)

    @property
    def level(self) -> Fact:
        """The level of the field k of constants, because squares with sum −1 have such values wherever they
        have no pole.
        """
        known, *several = self.base.level, *self.variables[1:]
        large = "the variables" if several else self.variables[0]
        if known.value == INFINITY:
            return Fact(INFINITY, f"{self.name} has an ordering, with {large} infinitely large")
        there = (self.name, "there") if several else ("F(t)", "in F")
        shown = f"it is the level of {self.base.name}, for −1 is as many squares in {' as '.join(there)}"
        return Fact(known.value, f"{shown}; there {known.reason}")

    def minus_one_as_squares(self) -> tuple[RationalFunction, ...]:
        """Return constants whose squares add up to −1."""
        return tuple(self(c) for c in self.base.minus_one_as_squares())


def value_of_fraction(field: Ring[E], x: E, target: Ring[S], num: S, den: S) -> S:
    """Return the value num/den of a function x of the field.

    Raises :class:`NotInvertibleError` if x has a pole.
    """
    if target.is_zero(den):
        raise NotInvertibleError(f"{shorten(field.text(x))} has a pole there: its denominator is 0")
    return target.divide(num, den)


def functions_name(base: Ring, names: tuple[str, ...]) -> str:
    """Return the name of the field of rational functions: ``QQ(x,y)``, or ``Frac(QQ[pi])`` if a variable
    could be taken for a number.
    """
    inside = ",".join(names)
    if any(map(reads_like_a_constant, names)):
        return f"Frac({base.name}[{inside}])"
    return f"{base.name}({inside})"
