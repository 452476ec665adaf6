"""Fields of rational functions in one variable over QQ and over finite fields, on flint's polynomials.

flint has polynomials over these fields but no fractions of them. :class:`RationalFunction` adds those, in
lowest terms with monic denominator, so that equal functions have equal parts.
"""

from __future__ import annotations

import atexit
import gc
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from itertools import count
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.product import Constants
from hfield.errors import CoercionError
from hfield.fields.base.printing import blackboard, quotient_text, sum_text
from hfield.fields.base.residue_polynomials import polynomials_modulo
from hfield.fields.base.ring import INFINITY, Embedding, Fact, Ring, S, shared
from hfield.fields.base.roots import common_divisor, horner, monic, multiplied, substituted
from hfield.fields.base.storage.base import Storage
from hfield.fields.base.to_sympy import polynomial_in, symbol
from hfield.fields.finite.ring import ExtensionField, PrimeField
from hfield.fields.function_fields.quotients import FractionField, RationalFunction, functions_name
from hfield.fields.function_fields.storage import FunctionStorage
from hfield.fields.rationals.ring import QQ

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import Coefficient, Polynomial
    from hfield.fields.function_fields.ideals import FunctionFieldIdeal


__all__ = ["FunctionField", "RationalFunction"]

# python-flint frees a polynomial over GF(q) through its context. If the garbage collector clears a
# cycle that contains both, the context may be freed first, and the process crashes. So contexts are
# never freed, and garbage collection stops at exit.
_CONTEXTS: dict[Ring, flint.fq_default_poly_ctx] = {}
atexit.register(gc.freeze)


def _number(c: flint.fq_default) -> int:
    """Return an element of GF(p) as a number."""
    first, *rest = c.to_list()
    assert not any(rest), "a norm lies in the field below"
    return int(first)


class FunctionField(FractionField):
    """F(t): the fractions of polynomials in one variable over QQ, GF(p) or GF(q).

    >>> from hfield import ring
    >>> F = ring("QQ(x)")
    >>> F("(x^2-1)/(2*x+2)")
    1/2*x-1/2
    """

    theory = "function field"

    def __init__(self, base: Ring, variable: str) -> None:
        self.base, self.gen_name, self.variables = base, variable, (variable,)
        self.name = functions_name(base, (variable,))
        self.characteristic = base.characteristic
        self._polynomial = _polynomials_over(base)
        self._one = self._polynomial([base.one])
        self._gen = RationalFunction(self, self._polynomial([base.zero, base.one]), self._one)

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.base, self.gen_name)

    @property
    def data(self) -> dict[str, object]:
        """The constants and the variable of the field, as JSON data."""
        return {"kind": "rational functions", "base": self.base.data, "variables": [self.gen_name]}

    def in_words(self) -> str:
        """Return a description of the field."""
        return f"rational functions in {self.gen_name} over {blackboard(self.base.name)}"

    @property
    def gen(self) -> RationalFunction:
        """The variable."""
        return self._gen

    @property
    def variable(self) -> RationalFunction:
        """The variable of the polynomials; for functions on a circle, the tangent of half the angle."""
        return self._gen

    def names(self) -> dict[str, RationalFunction]:
        """The variable and the generator of the base field."""
        return {**self.base_names(), self.gen_name or "": self._gen}

    def base_names(self) -> dict[str, RationalFunction]:
        """Return the names of the base field, as constants."""
        return {name: self.constant(x) for name, x in self.base.names().items()}

    def constant(self, c: Coefficient) -> RationalFunction:
        """Return the constant function of an element of the base field."""
        return RationalFunction(self, self._polynomial([c]), self._one)

    @property
    def constants(self) -> Ring:
        """The field below."""
        return self.base

    def as_constant(self, x: RationalFunction) -> Coefficient | None:
        """Return x as an element of the field below, or None if it is not constant."""
        if x.num.degree() > 0 or x.den.degree() > 0:
            return None
        return self.base.zero if x.num == 0 else self.base_element(x.num.leading_coefficient())

    def images_in(self, target: Ring[S]) -> dict[str, S]:
        """Return {}: the variable keeps its name. Raises :class:`CoercionError` if the other ring has no
        such name.
        """
        variable, kept = self.gen_name, target.names()
        same = not isinstance(target, FunctionField) or target.gen_name == variable
        if variable in kept and same and target.order is None:
            return {}
        raise CoercionError(f"{self} does not map into {target}, which has no variable {variable}")

    def quotient(self, num: Polynomial, den: Polynomial) -> RationalFunction:
        """Return num/den in lowest terms; den is not 0."""
        common = num.gcd(den)
        if not self.is_one(common):
            num, den = num // common, den // common
        lead = den.leading_coefficient()
        if lead != 1:
            scale = self._polynomial([self.base.inverse(self.base_element(lead))])
            num, den = num * scale, den * scale
        return RationalFunction(self, num, den)

    def base_element(self, c: Coefficient) -> Coefficient:
        """Convert a coefficient from flint to an element of the base field."""
        return c if isinstance(c, (flint.fq_default, flint.fmpq)) else self.base(int(c))

    def irreducible_factors(
        self, coefficients: Sequence[RationalFunction]
    ) -> list[list[RationalFunction]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial.

        Over GF(q)(t), q not prime, by the norm to GF(p)(t) of f(x − s·α), where α is the generator and s = 0,
        1, t, … (B. Trager, Proc. SYMSAC 1976). The common divisor of f and an irreducible factor of the norm
        is irreducible if the degree of the factor is [GF(q) : GF(p)] times its own.
        """
        if not isinstance(self.base, ExtensionField):
            return super().irreducible_factors(coefficients)
        below = shared(FunctionField, shared(PrimeField, self.characteristic), self.gen_name)
        n, alpha, f = self.base.degree, self.constant(self.base.gen), monic(self, coefficients)
        for k in count(-1):
            shift = alpha * self._gen**k if k >= 0 else self.zero
            moved = substituted(self, f, -shift)
            norm, conjugate = moved, moved
            for _ in range(n - 1):
                conjugate = [self._by_constants(c, self, self._frobenius) for c in conjugate]
                norm = multiplied(self, norm, conjugate)
            down = [self._by_constants(c, below, _number) for c in norm]
            factors = [
                [self._by_constants(c, self, lambda c: self.base(int(c))) for c in g]
                for g in below.irreducible_factors(down)
            ]
            found = [common_divisor(self, moved, g) for g in factors]
            if all((len(h) - 1) * n == len(g) - 1 for g, h in zip(factors, found, strict=True)):
                return [substituted(self, h, shift) for h in found]
        raise AssertionError("some shift of infinitely many serves")

    def _frobenius(self, c: flint.fq_default) -> flint.fq_default:
        return c**self.characteristic

    def _by_constants(
        self,
        x: RationalFunction,
        target: FunctionField,
        change: Callable[[Coefficient], Coefficient],
    ) -> RationalFunction:
        """Return x with its coefficients changed, as a function of another field."""
        num, den = (target._polynomial([change(c) for c in p.coeffs()]) for p in (x.num, x.den))
        return RationalFunction(target, num, den)

    def from_below(self, x: object) -> RationalFunction:
        """Convert a number or an element of the base field to a constant. Raises :class:`CoercionError`."""
        return self.constant(self.base(x))

    def closed_form(self, x: sympy.Expr) -> RationalFunction:
        """Return a number as a constant."""
        return self.constant(self.base.closed_form(x))

    def key(self, x: RationalFunction) -> Hashable:
        """Return the coefficients of numerator and denominator."""
        return tuple(
            tuple(self.base.key(self.base_element(c)) for c in p.coeffs()) for p in (x.num, x.den)
        )

    def sqrt(self, x: RationalFunction) -> RationalFunction | None:
        """Return some y with y² = x, or None: numerator, denominator and constant must be squares."""
        if self.is_zero(x):
            return x
        lead = self.base_element(x.num.leading_coefficient())
        c = self.base.sqrt(lead)
        if c is None:
            return None
        monic = x.num * self._polynomial([self.base.inverse(lead)])
        top, bottom = _root(monic), _root(x.den)
        if top is None or bottom is None:
            return None
        return self.quotient(
            top * self._polynomial([c]), bottom
        )  # flint's root may be −(a monic one)

    @property
    def orderings(self) -> Fact:
        """Infinitely many over QQ, none over a finite field."""
        if self.characteristic:
            return super().orderings
        return Fact(INFINITY, f"{self.gen_name} may lie infinitely near any point of the line")

    def sign(self, x: RationalFunction, ordering: int = 0) -> int:
        """Return the sign of x in the ordering in which the variable is infinitely large."""
        if self.characteristic or ordering:
            return super().sign(x, ordering)
        return 0 if x.num == 0 else self.base.sign(x.num.leading_coefficient())

    def random(self, rng: Random) -> RationalFunction:
        """Return a random fraction of polynomials of degree at most 2; the same for the same seed."""
        draw = [self._polynomial([self.base.random(rng) for _ in range(3)]) for _ in range(2)]
        return self.quotient(draw[0], draw[1] if draw[1] != 0 else self._one)

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements as four polynomials over a common denominator."""

        return FunctionStorage(self, constants)

    def ideal(self, x: object) -> FunctionFieldIdeal:
        """Return an ideal of GF(q)[t], given by a polynomial, a fraction, a prime, or several of them.

        Raises :class:`CoercionError` for anything else, and if the field of constants is not finite.

        >>> from hfield import ring
        >>> F = ring("GF(3)(t)"); F.ideal("t^2-1") + F.ideal("t+1"), F.ideal(["t^2", "2*t"]).norm()
        (ideal(t+1), 3)
        """
        from hfield.fields.function_fields.ideals import polynomial_integers

        if self.base.order is None:
            raise CoercionError(f"ideals are those of GF(q)[t], q finite, not of {self.name}")
        return polynomial_integers(self).ideal(x)

    def places(self) -> Iterator[Hashable]:
        """Yield the places over a finite field: infinity, then polynomials by degree."""
        from hfield.fields.function_fields.places import all_places

        return all_places(self)

    def polynomial_evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[Polynomial], S]:
        """Return the map of polynomials, by Horner's rule."""
        constant, point = below(self.base, target), images[self.gen_name or ""]

        def value(poly: Polynomial) -> S:
            coefficients = [constant(self.base_element(c)) for c in poly.coeffs()]
            found: S = horner(coefficients, point, target.zero)
            return found

        return value

    def partial(self, poly: Polynomial, variable: str) -> Polynomial:
        """Return the derivative of a polynomial."""
        return poly.derivative()

    def variables_in(self, x: RationalFunction) -> set[str]:
        """Return the variable, unless x is constant."""
        return set() if self.as_constant(x) is not None else {*self.variables}

    def to_sympy(self, x: RationalFunction, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the fraction as an expression, with expanded numerator and denominator."""
        gen = symbol(self.gen_name or "", symbols)

        def expression(poly: Polynomial) -> sympy.Expr:
            coefficients = map(self.base_element, poly.coeffs())
            return polynomial_in(gen, (self.base.to_sympy(c, symbols) for c in coefficients))

        return expression(x.num) / expression(x.den)

    def text(self, x: RationalFunction, style: str = "plain") -> str:
        """Write x, such as ``(x+1)/(x^2+2)``."""
        return quotient_text(self._sum(x.num, style), self._sum(x.den, style), style)

    def _sum(self, poly: Polynomial, style: str) -> str:
        terms = [
            (self.base.text(self.base_element(c), style), [(self.gen_name or "", n)])
            for n, c in enumerate(poly.coeffs())
            if c != 0
        ]
        return sum_text(reversed(terms), style)


def _polynomials_over(base: Ring) -> Callable[[list[Coefficient]], Polynomial]:
    """Return a function that makes flint polynomials over the field from coefficients, low degree first."""
    if base == QQ:
        return flint.fmpq_poly  # type: ignore[no-any-return,unused-ignore]
    if isinstance(base, ExtensionField):
        if base not in _CONTEXTS:
            _CONTEXTS[base] = flint.fq_default_poly_ctx(base.context)
        return _CONTEXTS[base]  # type: ignore[no-any-return,unused-ignore]
    return polynomials_modulo(base.characteristic)


def _root(poly: Polynomial) -> Polynomial | None:
    """Return the square root of a monic polynomial, or None."""
    if poly.degree() % 2:
        return None
    try:
        root = poly.sqrt()
    except (ValueError, flint.utils.flint_exceptions.DomainError):  # flint raises either
        return None
    return root if root * root == poly else None
