"""Polynomial rings in several variables over ZZ, QQ and GF(p), on flint's ``mpoly`` types."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from fractions import Fraction
from math import comb
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield import syntax
from hfield.core.primality import WORD
from hfield.errors import (
    CoercionError,
    NotInvertibleError,
    RingError,
    TooLargeError,
    shorten,
)
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.from_sympy import is_of_sympy
from hfield.fields.base.powers import polynomial_power
from hfield.fields.base.printing import blackboard, from_unicode, number_text, sum_text
from hfield.fields.base.registry import REGISTRY
from hfield.fields.base.ring import INFINITY, Fact, Ring, shared
from hfield.fields.finite.ring import PrimeField
from hfield.fields.rationals.ring import QQ, ZZ

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import Coefficient, SparseContext, SparsePolynomial
    from hfield.fields.base.ring import Embedding, S


MAX_VARIABLES = 64
MAX_TERMS = 200_000


class PolynomialRing(Ring):
    """R[x, y, …] for R = ZZ, QQ or GF(p); elements are flint polynomials, ordered by degree.

    >>> from hfield import ring
    >>> R = ring("ZZ[a,b]")
    >>> R.text(R("(a+b)^2"))
    'a^2+2*a*b+b^2'
    """

    is_field = False

    def __init__(self, base: Ring, variables: tuple[str, ...]) -> None:
        self.base, self.variables = base, variables
        self.name = f"{base.name}[{','.join(variables)}]"
        self.characteristic = base.characteristic
        self.gen_name = variables[0]
        # For texts of quaternions: (Σ of all variables)ⁿ then has fewer than 10⁵ terms.
        self.parse_limit = {1: 20_000, 2: 2_000, 3: 300, 4: 150}.get(len(variables), 100)
        self.context = flint_context(base, variables)
        self._gens = dict(zip(variables, self.context.gens(), strict=True))
        self._type = type(self.context.gens()[0])

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.base, self.variables)

    @property
    def data(self) -> dict[str, object]:
        """The ring of coefficients and the variables, as JSON data."""
        variables = list(self.variables)
        return {"kind": "polynomials", "base": self.base.data, "variables": variables}

    def in_words(self) -> str:
        """Return a description of the ring."""
        return f"polynomials in {', '.join(self.variables)} over {blackboard(self.base.name)}"

    @property
    def gen(self) -> SparsePolynomial:
        """The first variable."""
        return self._gens[self.variables[0]]

    @property
    def is_domain(self) -> bool:
        """True: the leading coefficient of a product is the product of the leading coefficients."""
        return True

    @property
    def fractions(self) -> Ring | None:
        """The field of rational functions, for one variable."""
        if len(self.variables) > 1:
            return None
        base, name = self.base.fractions or self.base, self.variables[0]
        return REGISTRY.functions.rational_functions(base, name)

    @property
    def constants(self) -> Ring:
        """The ring of coefficients."""
        return self.base

    def as_constant(self, x: SparsePolynomial) -> Coefficient | None:
        """Return x as an element of the ring of coefficients, or None if it is not constant."""
        return self.constant_part(x) if x.is_constant() else None

    def names(self) -> dict[str, SparsePolynomial]:
        """The variables."""
        return dict(self._gens)

    def __call__(self, x: object) -> SparsePolynomial:
        """Convert a number or an element of the base ring to a constant; read a text.

        Raises :class:`CoercionError` for an element of another polynomial ring.
        """
        x = unwrap(x)
        if isinstance(x, self._type):
            if x.context() is self.context:
                return x
            raise self.refuse(x)
        if isinstance(x, str):
            return self.parse(x)
        if is_of_sympy(x):
            return self.foreign(x)
        number = rational(x)
        if isinstance(number, Fraction) and self.base is ZZ:
            raise CoercionError(
                f"{shorten(number_text(number))} is not in {self.name}; QQ[…] has it"
            )
        try:
            return self.constant(self.base(x if number is None else number))
        except CoercionError:
            raise self.refuse(x) from None

    def parse(self, text: str) -> SparsePolynomial:
        """Read a polynomial. Raises :class:`TooLargeError` if its expansion is too long."""
        text = from_unicode(text)
        _Size(len(self.variables)).of(syntax.parse(text))
        functions = {"/": self.divide, "**": self.power}
        return syntax.Reader(self, self.names(), functions, self.name, 10**6).read(text)

    def constant(self, c: Coefficient) -> SparsePolynomial:
        """Return the constant polynomial of an element of the base ring, or of a flint coefficient."""
        return self.context.constant(int(c) if self.characteristic else c)

    def constant_part(self, x: SparsePolynomial) -> Coefficient:
        """Return the leading coefficient as an element of the base ring; for a constant, this is
        its value.
        """
        c = x.leading_coefficient()  # 0 of the polynomial 0
        return self.base(int(c) if self.characteristic else c)

    def is_zero(self, x: SparsePolynomial) -> bool:
        """Return whether x is 0."""
        return bool(x == 0)

    def equal(self, x: SparsePolynomial, y: SparsePolynomial) -> bool:
        """Return whether x = y."""
        return bool(x == y)

    def key(self, x: SparsePolynomial) -> Hashable:
        """Return the exponents and coefficients, in order."""
        return tuple(
            (exponents, int(c) if self.characteristic else c) for exponents, c in x.terms()
        )

    def inverse(self, x: SparsePolynomial) -> SparsePolynomial:
        """Return 1/x for a constant x. Raises :class:`NotInvertibleError` for all other polynomials."""
        if not x.is_constant():
            raise NotInvertibleError(
                f"{shorten(self.text(x))} is not constant, so it has no inverse in {self.name}"
            )
        try:
            return self.constant(self.base.inverse(self.constant_part(x)))
        except NotInvertibleError as error:
            raise NotInvertibleError(f"{error}, nor in {self.name}") from None

    def divide(self, x: SparsePolynomial, y: SparsePolynomial) -> SparsePolynomial:
        """Return x/y if y divides x. Raises :class:`NotInvertibleError`."""
        if y == 0:
            raise NotInvertibleError(f"cannot divide by 0 in {self.name}")
        quotient, remainder = divmod(x, y)
        if remainder != 0:
            raise NotInvertibleError(
                f"{shorten(self.text(y))} does not divide {shorten(self.text(x))} in {self.name}"
            )
        return quotient

    def euclid(
        self, x: SparsePolynomial, y: SparsePolynomial
    ) -> tuple[SparsePolynomial, SparsePolynomial]:
        """Return the quotient and the remainder of polynomials in one variable over a field."""
        if len(self.variables) > 1 or not self.base.is_field:
            return super().euclid(x, y)
        quotient, remainder = divmod(x, y)
        return quotient, remainder

    def power(self, x: SparsePolynomial, n: int) -> SparsePolynomial:
        """Return xⁿ; for n < 0, x is inverted first."""
        return polynomial_power(self.one, x if n >= 0 else self.inverse(x), abs(n))

    def sqrt(self, x: SparsePolynomial) -> SparsePolynomial | None:
        """Return some y with y² = x, or None."""
        if x == 0:
            return x
        try:
            root = x.sqrt()
        except (ValueError, flint.utils.flint_exceptions.DomainError):  # flint raises either
            return None
        return root if root * root == x else None

    @property
    def level(self) -> Fact:
        """The level of the base ring, because setting all variables to 0 preserves sums of squares."""
        known = self.base.level
        why = f"{known.reason}; setting all variables to 0 carries this from {self.base} to {self.name}"
        return Fact(known.value, why)

    def minus_one_as_squares(self) -> tuple[SparsePolynomial, ...]:
        """Return constants whose squares add up to −1."""
        return tuple(self.constant(c) for c in self.base.minus_one_as_squares())

    @property
    def orderings(self) -> Fact:
        """Infinitely many in characteristic 0, none otherwise."""
        if self.characteristic:
            return super().orderings
        return Fact(INFINITY, "each variable may be infinitely large or near any point")

    def sign(self, x: SparsePolynomial, ordering: int = 0) -> int:
        """Return the sign in the ordering by leading coefficients, where the first variable is the
        largest.
        """
        if self.characteristic or ordering:
            return super().sign(x, ordering)
        return self.base.sign(self.constant_part(x))

    def random(self, rng: Random) -> SparsePolynomial:
        """Return a random polynomial of at most 3 terms; the same for the same seed."""
        out = self.context.constant(0)
        for _ in range(3):
            exponents = tuple(rng.choice((0, 0, 1, 2)) for _ in self.variables)
            c = self.constant(self.base.random(rng))
            out += c * self.context.from_dict({exponents: 1})
        return out

    @property
    def values_ring(self) -> Ring:
        """The ring of coefficients."""
        return self.base

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[SparsePolynomial], S]:
        """Return the homomorphism that maps the variables to these images."""
        coefficient = below(self.base, target)
        gens = [images[name] for name in self.variables]
        powers: dict[tuple[int, int], S] = {}

        def power(n: int, exponent: int) -> S:
            if (n, exponent) not in powers:
                powers[n, exponent] = target.power(gens[n], exponent)
            return powers[n, exponent]

        def value(x: SparsePolynomial) -> S:
            total = target.zero
            for exponents, c in x.terms():
                term = coefficient(self.base(int(c) if self.characteristic else c))
                for n, exponent in enumerate(exponents):
                    if exponent:
                        term = term * power(n, int(exponent))
                total = total + term
            return total

        return value

    def derivative(self, x: SparsePolynomial, variable: str) -> SparsePolynomial:
        """Return the partial derivative."""
        if variable not in self.variables:
            return super().derivative(x, variable)
        return x.derivative(self.variables.index(variable))

    def variables_in(self, x: SparsePolynomial) -> set[str]:
        """Return the variables of positive degree."""
        return {name for name, n in zip(self.variables, x.degrees(), strict=True) if n > 0}

    def to_sympy(self, x: SparsePolynomial, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the polynomial as an expanded expression."""
        import sympy

        from hfield.fields.base.to_sympy import symbol

        gens = [symbol(name, symbols) for name in self.variables]
        return sympy.Add(
            *(
                sympy.Mul(
                    self.base.to_sympy(self.base(int(c) if self.characteristic else c), symbols),
                    *(g**n for g, n in zip(gens, exponents, strict=True)),
                )
                for exponents, c in x.terms()
            )
        )

    def text(self, x: SparsePolynomial, style: str = "plain") -> str:
        """Write x, such as ``a^2+2*a*b+b^2``."""
        return sum_text(
            (
                (
                    self.base.text(self.base(c), style),
                    list(zip(self.variables, exponents, strict=True)),
                )
                for exponents, c in x.terms()
            ),
            style,
        )


def build(base: Ring, variables: tuple[str, ...]) -> PolynomialRing:
    """Return the polynomial ring. Raises :class:`RingError` for other coefficients."""
    shown = shorten(f"{base}[{','.join(variables)}]")
    if base not in (ZZ, QQ) and not isinstance(base, PrimeField):
        raise RingError(
            f"{shown}: polynomials are over ZZ, QQ or GF(p) with p prime, as in QQ[x,y]"
        )
    if len(variables) > MAX_VARIABLES:
        raise RingError(f"{shown}: {len(variables)} variables; at most {MAX_VARIABLES} are taken")
    return shared(PolynomialRing, base, variables)


def flint_context(base: Ring, variables: tuple[str, ...]) -> SparseContext:
    """Return flint's context for polynomials in these variables over ZZ, QQ or GF(p)."""
    order = flint.Ordering.deglex
    if base == ZZ:
        return flint.fmpz_mpoly_ctx.get(variables, order)
    if base == QQ:
        return flint.fmpq_mpoly_ctx.get(variables, order)
    if base.characteristic < WORD:
        return flint.nmod_mpoly_ctx.get(variables, base.characteristic, order)
    return flint.fmpz_mod_mpoly_ctx.get(variables, base.characteristic, order)


class _Size:
    """Bounds for the number of terms and the degree of the expansion of a text."""

    def __init__(self, variables: int) -> None:
        self.variables = variables

    def of(self, node: syntax.Node) -> tuple[int, int]:
        """Return the two bounds. Raises :class:`TooLargeError` above ``MAX_TERMS``."""
        terms, degree = self._raw(node)
        if degree < 10**6:
            terms = min(terms, comb(degree + self.variables, self.variables))
        if terms > MAX_TERMS:
            raise TooLargeError(
                f"a part of the polynomial may have more than {MAX_TERMS} terms, which are not "
                "multiplied out; use smaller exponents"
            )
        return terms, degree

    def _raw(self, node: syntax.Node) -> tuple[int, int]:
        match node:
            case syntax.Name():
                return 1, 1
            case syntax.Negate(x):
                return self.of(x)
            case syntax.Binary("*" | "/", left, right):
                (t, d), (u, e) = self.of(left), self.of(right)
                return t * u, d + e
            case syntax.Binary(_, left, right):
                (t, d), (u, e) = self.of(left), self.of(right)
                return t + u, max(d, e)
            case syntax.Power(x, n):
                t, d = self.of(x)
                small = abs(n) <= 10**5
                return (
                    comb(t + abs(n) - 1, abs(n)) if small and t < 100 else t ** min(n, 64)
                ), d * abs(n)
        return 1, 0
