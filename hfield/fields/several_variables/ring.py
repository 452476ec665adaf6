"""Fields of rational functions in several variables over QQ and GF(p), on flint's ``mpoly`` types."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from random import Random
from typing import TYPE_CHECKING

from hfield.fields.base.printing import blackboard, quotient_text
from hfield.fields.base.ring import Embedding, Fact, Ring, S, shared
from hfield.fields.function_fields.quotients import FractionField, RationalFunction, functions_name
from hfield.fields.polynomial_rings import PolynomialRing

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import Coefficient, SparsePolynomial


class RationalFunctions(FractionField):
    """k(x, y, …), the fractions of k[x, y, …] for k = QQ or GF(p); elements are :class:`RationalFunction`.

    Numerator and denominator are flint polynomials without common factor; the denominator has leading
    coefficient 1.

    >>> from hfield import ring
    >>> F = ring("QQ(x,y)")
    >>> F("(x^2-y^2)/(2*x+2*y)"), F("x/y + y/x")
    (1/2*x-1/2*y, (x^2+y^2)/(x*y))
    """

    theory = "several variables"

    def __init__(self, polynomials: PolynomialRing) -> None:
        self.polynomials, self.base = polynomials, polynomials.base
        self.variables = polynomials.variables
        self.name = functions_name(self.base, self.variables)
        self.characteristic = self.base.characteristic
        self.gen_name = self.variables[0]
        self.parse_limit = polynomials.parse_limit
        self._one = polynomials.one

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.polynomials)

    @property
    def data(self) -> dict[str, object]:
        """The constants and the variables of the field, as JSON data."""
        variables = list(self.variables)
        return {"kind": "rational functions", "base": self.base.data, "variables": variables}

    def in_words(self) -> str:
        """Return a description of the field."""
        return f"rational functions in {listed(self.variables)} over {blackboard(self.base.name)}"

    @property
    def gen(self) -> RationalFunction:
        """The first variable."""
        return RationalFunction(self, self.polynomials.gen, self._one)

    @property
    def expanded_in(self) -> tuple[str, ...]:
        """The variables, in which elements have leading terms."""
        return self.variables

    def parts(self, x: RationalFunction) -> list[RationalFunction]:
        """Return x as the only summand; leading terms are those of x itself."""
        return [x]

    def as_constant(self, x: RationalFunction) -> Coefficient | None:
        """Return x as an element of k, or None if it is not constant."""
        if not (x.num.is_constant() and x.den.is_constant()):
            return None
        return self.polynomials.constant_part(x.num)

    def names(self) -> dict[str, RationalFunction]:
        """The variables."""
        gens = self.polynomials.names()
        return {name: RationalFunction(self, x, self._one) for name, x in gens.items()}

    def quotient(self, num: SparsePolynomial, den: SparsePolynomial) -> RationalFunction:
        """Return num/den in lowest terms; den is not 0."""
        common = num.gcd(den)
        if not self.is_one(common):
            num, den = num // common, den // common
        lead = den.leading_coefficient()
        if lead != 1:
            scale = self.polynomials.inverse(self.polynomials.constant(lead))
            num, den = num * scale, den * scale
        return RationalFunction(self, num, den)

    def from_below(self, x: object) -> RationalFunction:
        """Convert a number, or an element of k or k[x, y, …], to an element. Raises
        :class:`CoercionError`.
        """
        return RationalFunction(self, self.polynomials(x), self._one)

    def key(self, x: RationalFunction) -> Hashable:
        """Return the terms of numerator and denominator."""
        return self.polynomials.key(x.num), self.polynomials.key(x.den)

    def sqrt(self, x: RationalFunction) -> RationalFunction | None:
        """Return some y with y² = x, or None; numerator times denominator must be a square."""
        root = self.polynomials.sqrt(x.num * x.den)
        return None if root is None else self.quotient(root, x.den)

    @property
    def orderings(self) -> Fact:
        """Infinitely many over QQ, none over GF(p)."""
        return super().orderings if self.characteristic else self.polynomials.orderings

    def sign(self, x: RationalFunction, ordering: int = 0) -> int:
        """Return the sign in the ordering by leading coefficients, where the first variable is the
        largest.
        """
        if self.characteristic or ordering:
            return super().sign(x, ordering)
        return self.polynomials.sign(x.num)

    def random(self, rng: Random) -> RationalFunction:
        """Return a random fraction of polynomials of few terms; the same for the same seed."""
        num, den = self.polynomials.random(rng), self.polynomials.random(rng)
        return self.quotient(num, den if den != 0 else self._one)

    def polynomial_evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[SparsePolynomial], S]:
        """Return the homomorphism on polynomials that substitutes values."""
        return self.polynomials.evaluation(target, images, below)

    def partial(self, poly: SparsePolynomial, variable: str) -> SparsePolynomial:
        """Return the derivative of a polynomial."""
        return self.polynomials.derivative(poly, variable)

    def closed_form(self, x: sympy.Expr) -> RationalFunction:
        """Return a number as a constant."""
        return RationalFunction(
            self, self.polynomials.constant(self.base.closed_form(x)), self._one
        )

    def variables_in(self, x: RationalFunction) -> set[str]:
        """Return the variables of numerator and denominator."""
        return self.polynomials.variables_in(x.num) | self.polynomials.variables_in(x.den)

    def to_sympy(self, x: RationalFunction, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the fraction as an expression with expanded numerator and denominator."""
        num, den = (self.polynomials.to_sympy(p, symbols) for p in (x.num, x.den))
        return num / den

    def text(self, x: RationalFunction, style: str = "plain") -> str:
        """Write x, such as ``(x+y)/(x^2+2)``."""
        return quotient_text(
            self.polynomials.text(x.num, style), self.polynomials.text(x.den, style), style
        )


def listed(names: tuple[str, ...]) -> str:
    """Return ``x, y and z``."""
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else last
