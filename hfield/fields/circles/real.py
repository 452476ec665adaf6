"""RR(cos(t), sin(t), …): functions on circles whose coefficients are real algebraic numbers.

It is the union of the fields K(cos(t), sin(t), …) over all real number fields K. An element is stored over
the field that its coefficients generate; sums and products are computed over the compositum. Elements have
the normal form P/Q, as over ℚ, with rational coefficients in Q.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import prod
from random import Random
from typing import TYPE_CHECKING, TypeAlias

import flint

from hfield.core.factorisation import factorise
from hfield.errors import CoercionError, TooLargeError, UndecidedError, shorten
from hfield.fields.algebraic.ring import RR
from hfield.fields.algebraic.surds import Surd
from hfield.fields.base.operators import Element, Overfield
from hfield.fields.base.printing import quotient_text, sum_text
from hfield.fields.base.ring import INFINITY, Fact, Ring, shared
from hfield.fields.base.to_sympy import symbol
from hfield.fields.circles.angles import PI, Angle, WithAngles, rotated
from hfield.fields.circles.ring import (
    CircleFunctions,
    CirclesOverNumberField,
    in_latex,
    over_number_field,
)
from hfield.fields.function_fields.extensions import ExtensionElement
from hfield.fields.function_fields.quotients import value_of_fraction
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.number_fields.spelled_names import NamedNumber, SpelledField

if TYPE_CHECKING:
    import sympy

    from hfield.fields.algebraic.closed_forms import Closed
    from hfield.fields.base.flint_types import SparsePolynomial
    from hfield.fields.base.ring import E, Embedding, S
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.number_fields.elements import FieldElement

Inner: TypeAlias = "RationalFunction | ExtensionElement"
Terms = list[tuple[flint.fmpq, dict[str, int]]]  # coefficients of products of powers of numbers
MAX_DEGREE = 16  # of the number field of an element; an inverse takes seconds at 12
Texts = tuple[str, ...]  # the numbers that generate a field, as RR writes them, sorted


# --- real number fields -------------------------------------------------------------------------------


def in_generators(x: Surd | Closed) -> Terms:
    """Write a real algebraic number in terms of square roots of primes, roots, and other numbers given by
    their texts.

    Raises :class:`CoercionError` for a number that is not recognised as algebraic.
    """
    if isinstance(x, Surd):
        return [_in_primes(c, factorise(n)) for n, c in x.terms.items()]
    if x.bounds is None:
        raise CoercionError(
            f"{shorten(x)} is not recognised as algebraic: coefficients are real algebraic numbers"
        )
    import sympy

    terms: Terms = []
    for term in sympy.Add.make_args(x.expr):
        rational, rest = term.as_coeff_Mul()
        powers: dict[str, int] = {}
        for factor in sympy.Mul.make_args(rest) if rest != 1 else ():
            base, exponent = factor.as_base_exp()
            if not (rational.is_Rational and factor.is_real):
                return [(flint.fmpq(1), {RR.text(x): 1})]
            if exponent.is_Rational and base.is_Rational and base > 0:
                base, exponent = sympy.root(base, exponent.q), exponent.p
            elif not (exponent.is_Integer and exponent > 0):
                base, exponent = factor, 1
            text = RR.text(RR(base))
            powers[text] = powers.get(text, 0) + int(exponent)
        terms.append((flint.fmpq(int(rational.p), int(rational.q)), powers))
    return terms


def _in_primes(c: flint.fmpq, primes: Mapping[int, int]) -> tuple[flint.fmpq, dict[str, int]]:
    """Write c·√n in terms of the square roots of the primes that divide n, with exponents."""
    outside = prod(p ** (e // 2) for p, e in primes.items())
    return c * outside, {f"sqrt({p})": 1 for p, e in primes.items() if e % 2}


@cache
def number_field(texts: Texts) -> SpelledField:
    """Return the field that numbers generate. Raises :class:`TooLargeError` above ``MAX_DEGREE``."""
    K = SpelledField(f"QQ({','.join(texts)})", list(map(_number, texts)))
    if K.degree > MAX_DEGREE:
        raise TooLargeError(
            f"the coefficients generate {shorten(K)}, of degree {K.degree}; functions on circles over RR are "
            f"computed up to degree {MAX_DEGREE}"
        )
    return K


@cache
def _number(text: str) -> NamedNumber:
    import sympy

    x = RR(text)
    polynomial = sympy.Poly(sympy.minimal_polynomial(RR.to_sympy(x, {}), sympy.Symbol("x")))
    rationals = [flint.fmpq(int(c.p), int(c.q)) for c in reversed(polynomial.monic().all_coeffs())]
    return NamedNumber(text, flint.fmpq_poly(rationals), x.ball)


@cache
def _image_of_generator(texts: Texts, target: Texts) -> FieldElement:
    """Return the generator of a field, as an element of a larger one."""
    K, L = number_field(texts), number_field(target)
    return _product_sum(L, K.products(K.gen), [L.parts[text] for text in texts])


def _real_number(texts: Texts, coefficients: list[flint.fmpq]) -> Surd | Closed:
    """Return the real number with these coefficients in the powers of the generator of a field."""
    if not texts:
        return RR(coefficients[0])
    K = number_field(texts)
    products = K.products(K.of_coefficients(coefficients))
    number: Surd | Closed = _product_sum(RR, products, [RR(t) for t in texts])
    return number


def _product_sum(
    ring: Ring[E], terms: Iterable[tuple[flint.fmpq, Sequence[int]]], numbers: list[E]
) -> E:
    """Return the sum of coefficients times products of powers of the numbers."""
    total = ring.zero
    for c, powers in terms:
        term = ring(Fraction(int(c.p), int(c.q)))
        for x, n in zip(numbers, powers, strict=True):
            term = term * ring.power(x, n)
        total = total + term
    return total


# --- the functions ------------------------------------------------------------------------------------


class RealCircleElement(Element):
    """An immutable function on circles: ``inner`` is over the field that the numbers ``texts`` generate."""

    __slots__ = ("inner", "texts")

    field: RealCircles
    inner: Inner
    texts: Texts

    def __init__(self, field: RealCircles, inner: Inner, texts: Texts) -> None:
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "inner", inner)
        object.__setattr__(self, "texts", texts)

    def _with(
        self, other: RealCircleElement, operation: Callable[[Inner, Inner], Inner]
    ) -> RealCircleElement:
        x, y, texts = self.field.together(self, other)
        return self.field.element(operation(x, y), texts)

    def plus(self, other: RealCircleElement) -> RealCircleElement:
        """Return the sum."""
        return self._with(other, lambda x, y: x + y)

    def __neg__(self) -> RealCircleElement:
        return RealCircleElement(self.field, -self.inner, self.texts)

    def times(self, other: RealCircleElement) -> RealCircleElement:
        """Return the product."""
        return self._with(other, lambda x, y: x * y)

    def same(self, other: RealCircleElement) -> bool:
        """Return whether both are the same function."""
        x, y, _ = self.field.together(self, other)
        return bool(x == y)

    def __hash__(self) -> int:
        terms, den = self.field.in_cosines(self)
        return hash((frozenset(terms.items()), str(den)))


def _parts(inner: Inner) -> Sequence[RationalFunction]:
    """Return the coefficients, over ℚ, at the powers of the generator of the number field."""
    return inner.coefficients if isinstance(inner, ExtensionElement) else (inner,)


class RealCircles(WithAngles[RealCircleElement], Overfield[RealCircleElement]):
    """The field of functions on circles over the real algebraic numbers; ``base`` is the one over ℚ.

    >>> from hfield import ring
    >>> F = ring("RR(cos(t),sin(t))")
    >>> F("cos(t + pi/4)"), F("sqrt(2)*sqrt(3)*cos(t)") == F("sqrt(6)*cos(t)"), F("1/(cos(t) - sqrt(2))")
    (1/2*sqrt(2)*cos(t)-1/2*sqrt(2)*sin(t), True, (cos(t)+sqrt(2))/(cos(t)^2-2))
    """

    characteristic = 0

    def __init__(self, base: CircleFunctions) -> None:
        self.base, self.variables = base, base.variables
        self.name = f"RR{base.name.removeprefix('QQ')}"
        self.gen_name, self.parse_limit = base.gen_name, base.parse_limit

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (RealCircles, self.base)

    def in_words(self) -> str:
        """Return a description of the field."""
        return self.base.in_words().replace("over ℚ", "over the real algebraic numbers")

    # --- elements ------------------------------------------------------------------------------

    def over(self, texts: Texts) -> WithAngles:
        """Return the field over the number field that numbers generate, or over ℚ."""
        return self.over_number_field(texts) if texts else self.base

    def over_number_field(self, texts: Texts) -> CirclesOverNumberField:
        """Return the field over the number field that numbers, at least one, generate."""
        return over_number_field(number_field(texts), self.base.angles, self.base.plain)

    def element(self, inner: Inner, texts: Texts = ()) -> RealCircleElement:
        """Return an element of the field :meth:`over` as an element of this field."""
        if isinstance(inner, ExtensionElement) and all(
            map(self.base.is_zero, inner.coefficients[1:])
        ):
            inner, texts = inner.coefficients[0], ()
        return RealCircleElement(self, inner, texts)

    def together(self, x: RealCircleElement, y: RealCircleElement) -> tuple[Inner, Inner, Texts]:
        """Return both elements over one number field, and the numbers that generate it."""
        texts = tuple(sorted({*x.texts, *y.texts}))
        return self._lifted(x, texts), self._lifted(y, texts), texts

    def _lifted(self, x: RealCircleElement, texts: Texts) -> Inner:
        if x.texts == texts:
            return x.inner
        F = self.over_number_field(texts)
        if not isinstance(x.inner, ExtensionElement):
            return F.reduced([x.inner])
        theta, total = F.constant(_image_of_generator(x.texts, texts)), F.zero
        for c in reversed(x.inner.coefficients):
            total = total * theta + F.reduced([c])
        return total

    @property
    def gen(self) -> RealCircleElement:
        """The cosine of the first angle."""
        return self.element(self.base.gen)

    @property
    def constants(self) -> Ring:
        """The real algebraic numbers."""
        return RR

    def constant(self, c: Surd | Closed) -> RealCircleElement:
        """Return a real algebraic number as a constant. Raises :class:`CoercionError` for other values."""
        terms = in_generators(c)
        texts = tuple(sorted({text for _, powers in terms for text in powers}))
        if not texts:
            return self.element(self.base(sum((c for c, _ in terms), flint.fmpq(0))))
        K = number_field(texts)
        rows = [(c, [powers.get(text, 0) for text in texts]) for c, powers in terms]
        inner = _product_sum(K, rows, [K.parts[text] for text in texts])
        return self.element(self.over_number_field(texts).constant(inner), texts)

    def as_constant(self, x: RealCircleElement) -> Surd | Closed | None:
        """Return x as a real number if it is constant; else None."""
        terms, den = self.in_cosines(x)
        none = (0,) * len(self.base.written.variables)
        if not (den.is_constant() and terms.keys() <= {none}):
            return None
        zero: Surd | Closed = RR.zero
        return terms.get(none, zero)

    def from_below(self, x: object) -> RealCircleElement:
        """Convert a real number, or an element over ℚ, to an element. Raises :class:`CoercionError`."""
        if isinstance(x, Element):
            return self.element(self.base(x))
        return self.constant(RR(x))

    def closed_form(self, x: sympy.Expr) -> RealCircleElement:
        """Return a number as a constant."""
        return self.constant(RR.closed_form(x))

    def names(self) -> dict[str, RealCircleElement]:
        """The tangents of half the angles and the other variables."""
        return {name: self.element(x) for name, x in self.base.names().items()}

    def generators(self) -> dict[str, RealCircleElement]:
        """Return the other variables."""
        return {name: self.element(x) for name, x in self.base.generators().items()}

    def functions(self) -> dict[str, Callable[..., RealCircleElement]]:
        """Cosines, sines and tangents of angles, and the functions of RR applied to constants."""
        numbers = {name: self._of_constants(name, f) for name, f in RR.functions().items()}
        return {**numbers, **super().functions()}

    def _of_constants(
        self, name: str, f: Callable[..., Surd | Closed | None]
    ) -> Callable[..., RealCircleElement]:
        def value(*arguments: object) -> RealCircleElement:
            constants = [self.as_constant(self(x)) for x in arguments]
            if None in constants:
                raise CoercionError(f"{name} takes real numbers, found {shorten(arguments[0])}")
            return self.constant(RR(f(*constants)))

        return value

    # --- arithmetic ----------------------------------------------------------------------------

    def is_zero(self, x: RealCircleElement) -> bool:
        """Return whether x is 0."""
        return bool(self.over(x.texts).is_zero(x.inner))

    def equal(self, x: RealCircleElement, y: RealCircleElement) -> bool:
        """Return whether x = y."""
        return x.same(y)

    def key(self, x: RealCircleElement) -> Hashable:
        """Return x itself."""
        return x

    def inverse(self, x: RealCircleElement) -> RealCircleElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        return self.element(self.over(x.texts).inverse(x.inner), x.texts)

    def sqrt(self, x: RealCircleElement) -> RealCircleElement | None:
        """Return some y with y² = x, or None.

        With several angles or variables, only real multiples of a function over ℚ are supported; others raise
        :class:`UndecidedError`.
        """
        if self.is_zero(x):
            return x
        lead, root = self._leading_and_root(x)
        number = RR.sqrt(lead)
        return None if number is None or root is None else self.constant(number) * root

    def _leading_and_root(
        self, x: RealCircleElement
    ) -> tuple[Surd | Closed, RealCircleElement | None]:
        """Return a real number c and some y with x = c·y²; y is None if there is none."""
        if isinstance(x.inner, ExtensionElement) and isinstance(self.base, FunctionField):
            c, y = self.over_number_field(x.texts).leading_and_root(x.inner)
            number = _real_number(x.texts, number_field(x.texts).coefficients_of(c))
            return number, None if y is None else self.element(y, x.texts)
        base = self.base
        f = next(part for part in _parts(x.inner) if not base.is_zero(part))
        ratio = self.as_constant(x / self.element(f))
        if ratio is None:
            raise UndecidedError(
                f"square roots in {self.name} are decided of real multiples of functions over ℚ"
            )
        c = f.num.leading_coefficient()
        root = base.sqrt(f / base(c))
        return ratio * RR(c), None if root is None else self.element(root)

    @property
    def level(self) -> Fact:
        """∞: values are real numbers."""
        return Fact(
            INFINITY, f"{self.name} has an ordering, where all angles are small and positive"
        )

    @property
    def orderings(self) -> Fact:
        """Infinitely many."""
        return Fact(INFINITY, "each angle may be near any point of the circle")

    def sign(self, x: RealCircleElement, ordering: int = 0) -> int:
        """Return the sign of x if all angles are small and positive. Raises :class:`RingError`."""
        return super().sign(x, ordering) if ordering else self.sign_near_zero(x)

    def sign_near_zero(self, x: RealCircleElement) -> int:
        """Return the sign of x if all angles are positive and small, each much smaller than the one
        before.
        """
        sign: int = self.over(x.texts).sign_near_zero(x.inner)
        return sign

    def random(self, rng: Random) -> RealCircleElement:
        """Return a small random element; the same for the same seed."""
        return self.element(self.base.random(rng)) + self.constant(RR.random(rng))

    # --- cosines and sines ---------------------------------------------------------------------

    def cosine_and_sine(self, angle: Angle) -> tuple[RealCircleElement, RealCircleElement]:
        """Return the cosine and sine; all rational multiples of π are supported."""
        rest = {name: c for name, c in angle.items() if name != PI}
        cosine, sine = map(self.element, self.base.cosine_and_sine(rest))
        return rotated(self, (cosine, sine), angle)

    def tangent(self, angle: Angle) -> RealCircleElement:
        """Return the tangent; half the angles of the field are also supported."""
        if PI not in angle:
            return self.element(self.base.tangent(angle))
        cosine, sine = self.cosine_and_sine(angle)
        return sine / cosine

    def in_cosines(
        self, x: RealCircleElement
    ) -> tuple[dict[tuple[int, ...], Surd | Closed], SparsePolynomial]:
        """Return the real coefficients of the numerator, by exponents, and the denominator, which
        is over ℚ.
        """
        pairs = [self.base.in_cosines(c) for c in _parts(x.inner)]
        common = pairs[0][1]
        for _, den in pairs[1:]:
            common = common * (den // common.gcd(den))
        rows: dict[tuple[int, ...], list[flint.fmpq]] = {}
        for n, (num, den) in enumerate(pairs):
            for exponents, c in (num * (common // den)).to_dict().items():
                rows.setdefault(exponents, [flint.fmpq(0)] * len(pairs))[n] = c
        return {m: _real_number(x.texts, c) for m, c in rows.items()}, common

    def text(self, x: RealCircleElement, style: str = "plain") -> str:
        """Write x, such as ``(cos(t)+sqrt(2))/(cos(t)^2-2)``."""
        terms, den = self.in_cosines(x)
        written = self.base.written
        order = sorted(terms, key=lambda m: (sum(m), m), reverse=True)
        rows = (
            (RR.text(terms[m], style), list(zip(written.variables, m, strict=True))) for m in order
        )
        shown = quotient_text(sum_text(rows, style), written.text(den, style), style)
        return in_latex(shown) if style == "latex" else shown

    def to_sympy(self, x: RealCircleElement, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return x as an expression in cosines and sines."""
        import sympy

        terms, den = self.in_cosines(x)
        known = self.base.in_sympy(symbols)
        names = [symbol(name, known) for name in self.base.written.variables]
        num = sympy.Add(
            *(
                RR.to_sympy(c, symbols) * sympy.Mul(*(y**n for y, n in zip(names, m, strict=True)))
                for m, c in terms.items()
            )
        )
        return num / self.base.written.to_sympy(den, known)

    # --- values and derivatives ----------------------------------------------------------------

    @property
    def variable_names(self) -> tuple[str, ...]:
        """The angles and the other variables."""
        return self.base.variable_names

    @property
    def values_ring(self) -> Ring:
        """The real algebraic numbers."""
        return RR

    def images_of(self, values: Mapping[str, object], target: Ring[S]) -> dict[str, S]:
        """Return the images of cosines, sines and variables; values of angles are angles, such as π/3."""
        return self.base.images_of(values, target)

    def images_in(self, target: Ring[S]) -> dict[str, S]:
        """Return nothing: cosines and sines are mapped by their texts."""
        return {}

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[RealCircleElement], S]:
        """Return the homomorphism that maps cosines, sines and variables to these images."""
        given = self.base.images_of_cosines(target, images)
        number, polynomial = below(RR, target), self.base.written.evaluation(target, given, below)
        values = [given[name] for name in self.base.written.variables]

        def value(x: RealCircleElement) -> S:
            terms, den = self.in_cosines(x)
            total = target.zero
            for m, c in terms.items():
                term = number(c)
                for y, n in zip(values, m, strict=True):
                    term = term * target.power(y, n)
                total = total + term
            found: S = value_of_fraction(self, x, target, total, polynomial(den))
            return found

        return value

    def derivative(self, x: RealCircleElement, variable: str) -> RealCircleElement:
        """Return the derivative by an angle, d/dt, or by another variable."""
        if variable not in self.variable_names:
            return Ring.derivative(self, x, variable)
        return self.element(self.over(x.texts).derivative(x.inner, variable), x.texts)

    def variables_in(self, x: RealCircleElement) -> set[str]:
        """Return the angles and variables on which x depends."""
        found: set[str] = self.over(x.texts).variables_in(x.inner)
        return found
