"""Finite extensions F[u]/(f) of rational function fields: arithmetic and names."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from random import Random
from typing import TYPE_CHECKING, TypeAlias

from hfield import syntax
from hfield.errors import (
    CoercionError,
    HFieldError,
    NotInvertibleError,
    RingError,
    UndecidedError,
    shorten,
)
from hfield.fields.base.operators import Element, Overfield
from hfield.fields.base.printing import blackboard, from_unicode, sum_text
from hfield.fields.base.ring import Embedding, Fact, Ring, S, shared
from hfield.fields.base.roots import horner, multiplied, stripped
from hfield.fields.base.to_sympy import polynomial_in, symbol
from hfield.fields.function_fields.quotients import FractionField, RationalFunction
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.polynomial_rings import build as build_polynomials
from hfield.fields.several_variables.ring import RationalFunctions

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import AnyPolynomial, Coefficient, SparsePolynomial

ElementBelow: TypeAlias = "RationalFunction | SparsePolynomial | Coefficient"
"""An element of the field below: a rational function; in subclasses a polynomial or a number, too."""

MAX_DEGREE = 20


class ExtensionElement(Element):
    """An immutable element Σ cₙ·uⁿ of F[u]/(f), with deg f coefficients in F."""

    __slots__ = ("coefficients",)

    field: SimpleExtension
    coefficients: tuple[ElementBelow, ...]

    def __init__(self, field: SimpleExtension, coefficients: Sequence[ElementBelow]) -> None:
        object.__setattr__(self, "field", field)
        object.__setattr__(self, "coefficients", tuple(coefficients))

    def plus(self, other: ExtensionElement) -> ExtensionElement:
        """Return the sum."""
        pairs = zip(self.coefficients, other.coefficients, strict=True)
        return ExtensionElement(self.field, [x + y for x, y in pairs])

    def __neg__(self) -> ExtensionElement:
        return ExtensionElement(self.field, [-x for x in self.coefficients])

    def times(self, other: ExtensionElement) -> ExtensionElement:
        """Return the product."""
        product = multiplied(self.field.base, self.coefficients, other.coefficients)
        return self.field.reduced(product)

    def same(self, other: ExtensionElement) -> bool:
        """Return whether both are the same element."""
        return self.coefficients == other.coefficients


class SimpleExtension(Overfield[ExtensionElement]):
    """F[u]/(f) for a field F of rational functions and an irreducible f; ``gen`` is the class of u.

    >>> from hfield import ring
    >>> F = ring("GF(3)(t)[u]/(u^2-t^3+t)")
    >>> F("1/u"), F("u^2")
    (1/(t^3+2*t)*u, t^3+2*t)
    """

    def __init__(
        self, name: str, words: str, base: Ring, gen_name: str, modulus: Sequence[ElementBelow]
    ) -> None:
        self.name, self._words, self.base, self.gen_name = name, words, base, gen_name
        self.characteristic = base.characteristic
        self.parse_limit = base.parse_limit
        self.modulus_coefficients = tuple(modulus)  # monic, low degree first
        self.degree = len(modulus) - 1

    def __reduce__(self) -> tuple[object, ...]:
        below = self.base, self.gen_name, self.modulus_coefficients
        return shared, (type(self), self.name, self._words, *below)

    @property
    def expanded_in(self) -> tuple[str, ...]:
        """The variables of k(x, y, …), if the root belongs to a polynomial over k."""
        if not isinstance(self.base, RationalFunctions):
            return ()
        c = self.modulus_coefficients
        constant = all(x.num.is_constant() and x.den.is_constant() for x in c)
        return self.base.variables if constant else ()

    def parts(self, x: ExtensionElement) -> list[RationalFunction]:
        """Return the nonzero coefficients of x."""
        return [c for c in x.coefficients if c.num != 0]

    @property
    def data(self) -> dict[str, object]:
        """The field by the field below, the polynomial (low degree first) and the name of the root, as JSON
        data.
        """
        modulus = [self.base.text(c) for c in self.modulus_coefficients]
        own = {"modulus": modulus, "variable": self.gen_name}
        return {"kind": "extension", "base": self.base.data, **own}

    def in_words(self) -> str:
        """Return a description of the field."""
        return self._words

    @property
    def gen(self) -> ExtensionElement:
        """The class of u."""
        return self.reduced([self.base.zero, self.base.one])

    def names(self) -> dict[str, ExtensionElement]:
        """The names of the field below, and u."""
        below = {name: self._constant(x) for name, x in self.base.names().items()}
        return {**below, str(self.gen_name): self.gen}

    def _constant(self, c: ElementBelow) -> ExtensionElement:
        return self.reduced([c])

    def reduced(self, coefficients: Sequence[ElementBelow]) -> ExtensionElement:
        """Return the class of a polynomial in u, low degree first."""
        out, n = list(coefficients), self.degree
        while len(out) > n:
            top = out.pop()
            if not self.base.is_zero(top):
                shift = len(out) - n
                for m, c in enumerate(self.modulus_coefficients[:-1]):
                    out[shift + m] = out[shift + m] - top * c
        return ExtensionElement(self, [*out, *[self.base.zero] * (n - len(out))])

    def from_below(self, x: object) -> ExtensionElement:
        """Convert a number or an element of F to an element. Raises :class:`CoercionError`."""
        return self._constant(self.base(x))

    def is_zero(self, x: ExtensionElement) -> bool:
        """Return whether x is 0."""
        return all(map(self.base.is_zero, x.coefficients))

    def equal(self, x: ExtensionElement, y: ExtensionElement) -> bool:
        """Return whether x = y."""
        return bool(x == y)

    def key(self, x: ExtensionElement) -> Hashable:
        """Return the keys of the coefficients."""
        return tuple(map(self.base.key, x.coefficients))

    def inverse(self, x: ExtensionElement) -> ExtensionElement:
        """Return 1/x, by the extended Euclidean algorithm. Raises :class:`NotInvertibleError` for 0."""
        if self.is_zero(x):
            raise NotInvertibleError(f"cannot divide by 0 in {self.name}")
        f, _ = self._over_common_denominator(self.modulus_coefficients)
        g, den = self._over_common_denominator(x.coefficients)
        base = self.base
        assert isinstance(base, FractionField), "other rings have an inverse of their own"
        v, c = _inverse_modulo(f, g, base.one.num)
        return self.reduced([base.quotient(den * a, c) for a in v])

    def _over_common_denominator(
        self, fractions: Sequence[RationalFunction]
    ) -> tuple[list[AnyPolynomial], AnyPolynomial]:
        """Return the numerators of fractions over a common denominator, without zeros at the end, and the
        denominator.
        """
        den = self.base.one.num
        for c in fractions:
            den = den * (c.den // den.gcd(c.den))
        return _without_zeros([c.num * (den // c.den) for c in fractions]), den

    @property
    def level(self) -> Fact:
        """The level: 1 if it is 1 in F; otherwise not known."""
        known = self.base.level
        if known.value == 1:
            return Fact(1, f"it is that of {self.base.name}; there {known.reason}")
        return Fact(None, f"nothing is known of the squares of {self.name}")

    def minus_one_as_squares(self) -> tuple[ExtensionElement, ...]:
        """Return the elements of the smaller field whose squares add up to −1."""
        return (
            tuple(map(self._constant, self.base.minus_one_as_squares())) if self.level.value else ()
        )

    def sqrt(self, x: ExtensionElement) -> ExtensionElement | None:
        """Return a root of an element of F that has one in F. Raises :class:`UndecidedError` for others."""
        if all(map(self.base.is_zero, x.coefficients[1:])):
            root = self.base.sqrt(x.coefficients[0])
            if root is not None:
                return self._constant(root)
        raise UndecidedError(f"square roots in {self.name} are not decided")

    def random(self, rng: Random) -> ExtensionElement:
        """Return a random element; the same for the same seed."""
        return ExtensionElement(self, [self.base.random(rng) for _ in range(self.degree)])

    @property
    def variables(self) -> tuple[str, ...]:  # type: ignore[override]
        """The variables below, and u unless it is a constant."""
        own = (str(self.gen_name),) if self._modulus_variables else ()
        return (*self.base.variables, *own)

    @property
    def _modulus_variables(self) -> set[str]:
        """The variables below on which u depends."""
        return set().union(*map(self.base.variables_in, self.modulus_coefficients))

    @property
    def values_ring(self) -> Ring | None:
        """The ring of constants of the field below, if u is not a constant."""
        return self.base.values_ring if self._modulus_variables else None

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[ExtensionElement], S]:
        """Return the homomorphism that maps the variables, and u, to these images."""
        coefficient = self.base.evaluation(target, images, below)
        root = images.get(str(self.gen_name))
        if root is None:
            root = target.generators().get(str(self.gen_name))
        modulus = [*map(coefficient, self.modulus_coefficients)]
        if root is None or not target.is_zero(horner(modulus, root, target.zero)):
            raise CoercionError(
                f"{self.gen_name} in {shorten(self.name)} is a root of a polynomial over {self.base}: "
                "give it a value, too, that is a root where the others have theirs"
            )
        return lambda x: horner([*map(coefficient, x.coefficients)], root, target.zero)

    def derivative(self, x: ExtensionElement, variable: str) -> ExtensionElement:
        """Return the derivative that extends the one below: u′ = −∂f(u)/f′(u)."""
        if variable not in self.base.variables:
            return super().derivative(x, variable)
        d = self.base.derivative
        outer = self.reduced([d(c, variable) for c in x.coefficients])
        moved = self.reduced([d(c, variable) for c in self.modulus_coefficients])
        if self.is_zero(moved):
            return outer
        inner, slope = (
            self.reduced([self.base(n) * c for n, c in enumerate(f) if n])
            for f in (x.coefficients, self.modulus_coefficients)
        )
        if self.is_zero(slope):
            raise CoercionError(
                f"{self} has no derivative by {variable}: it is inseparable over {self.base}"
            )
        return outer - inner * moved * self.inverse(slope)

    def variables_in(self, x: ExtensionElement) -> set[str]:
        """Return the variables in the coefficients, and u if it occurs and is not a constant."""
        found = set().union(*map(self.base.variables_in, x.coefficients))
        alone = all(map(self.base.is_zero, x.coefficients[1:]))
        return found if alone else found | ({str(self.gen_name)} & {*self.variables})

    def generators(self) -> dict[str, ExtensionElement]:
        """Return the generators of the field below, and u."""
        below = {name: self._constant(x) for name, x in self.base.generators().items()}
        return {**below, str(self.gen_name): self.gen}

    def to_sympy(self, x: ExtensionElement, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the element as a polynomial in u."""
        below = (self.base.to_sympy(c, symbols) for c in x.coefficients)
        return polynomial_in(symbol(str(self.gen_name), symbols), below)

    def text(self, x: ExtensionElement, style: str = "plain") -> str:
        """Write x as a polynomial in u."""
        terms = (
            (self.base.text(c, style), [(str(self.gen_name), n)])
            for n, c in enumerate(x.coefficients)
            if not self.base.is_zero(c)
        )
        return sum_text(reversed(list(terms)), style)


def _inverse_modulo(
    f: list[AnyPolynomial], g: list[AnyPolynomial], one: AnyPolynomial
) -> tuple[list[AnyPolynomial], AnyPolynomial]:
    """For coprime polynomials f and g, return v and a constant c ≠ 0 with v·g = c modulo f.

    All coefficients are polynomials over a field, low degree in u first, and stay polynomials: with
    subresultants all divisions are exact (G. E. Collins, J. ACM 14, 1967), and no fraction is reduced.
    """
    zero = one - one
    u, v = [zero] * len(f), [one] + [zero] * (len(f) - 1)  # g = v·(the given g) modulo f throughout
    lead = scale = one
    while len(g) > 1:
        drop = len(f) - len(g)
        for shift in range(drop, -1, -1):
            top = f[-1]
            f = _pseudo_reduced(f, g, g[-1], top, shift)[:-1]
            u = _pseudo_reduced(u, v, g[-1], top, shift)
        divisor = lead * scale**drop
        f, g = g, _without_zeros([c // divisor for c in f])
        u, v = v, [c // divisor for c in u]
        lead = f[-1]
        scale = lead**drop // scale ** (drop - 1)
    return v, g[0]


def _pseudo_reduced(
    f: list[AnyPolynomial],
    g: list[AnyPolynomial],
    a: AnyPolynomial,
    b: AnyPolynomial,
    shift: int,
) -> list[AnyPolynomial]:
    """Return a·f − b·uⁿ·g, where n is the shift, with as many coefficients as f has."""
    out = [a * c for c in f]
    for n, c in enumerate(g[: len(f) - shift], shift):
        out[n] = out[n] - b * c
    return out


def _without_zeros(f: list[AnyPolynomial]) -> list[AnyPolynomial]:
    """Return the coefficients up to the last nonzero one."""
    size = next((n for n in range(len(f), 0, -1) if f[n - 1] != 0), 0)
    return f[:size]


def build(base: Ring, variable: str, text: str) -> SimpleExtension:
    """Return F[u]/(f) for the text of an irreducible f. Raises :class:`RingError` if f is not irreducible."""
    what = f"{base}[{variable}]/({shorten(text)})"
    if not isinstance(base, (FunctionField, RationalFunctions)):
        raise RingError(
            f"{what}: extensions are taken of fields such as QQ(x), GF(3)(t) and QQ(x,y)"
        )
    f = read_polynomial(base, variable, text, what)
    if not 2 <= len(f) - 1 <= MAX_DEGREE:
        raise RingError(
            f"{what}: expected a polynomial in {variable} of a degree from 2 to {MAX_DEGREE}"
        )
    scale = base.inverse(f[-1])
    f = [scale * c for c in f]
    _check_irreducible(base, variable, f, what)
    nameless = SimpleExtension("", "", base, variable, f)
    shown = nameless.text(ExtensionElement(nameless, f))  # one coefficient more than an element has
    name = f"{base}[{variable}]/({shown})"
    words = f"the extension of degree {len(f) - 1} of {blackboard(base.name)} by a root of {shown}"
    return shared(SimpleExtension, name, words, base, variable, tuple(f))


def read_polynomial(base: Ring, variable: str, text: str, what: str) -> list[RationalFunction]:
    """Read a polynomial in the variable over a ring, low degree first. Raises :class:`RingError`."""
    free = SimpleExtension(what, "", base, variable, [base.zero] * (MAX_DEGREE + 1) + [base.one])

    def divided(x: ExtensionElement, y: ExtensionElement) -> ExtensionElement:
        if not all(map(base.is_zero, y.coefficients[1:])):
            raise CoercionError(f"a polynomial in {variable} has no {variable} in a denominator")
        return x * free(base.inverse(y.coefficients[0]))

    def power(x: ExtensionElement, n: int) -> ExtensionElement:
        size = len(stripped(base, x.coefficients)) - 1
        if n < 0 or size * n > MAX_DEGREE:
            raise CoercionError(f"its degree is not from 2 to {MAX_DEGREE}")
        return free.power(x, n)

    reader = syntax.Reader(free, free.names(), {"/": divided, "**": power}, what, base.parse_limit)
    try:
        return stripped(base, reader.read(from_unicode(text)).coefficients)
    except HFieldError as error:
        raise RingError(f"{what} cannot be read: {error}") from error


def _check_irreducible(
    base: FractionField, variable: str, f: list[RationalFunction], what: str
) -> None:
    """Raise :class:`RingError` unless f is irreducible over the field of rational functions."""
    if base.characteristic == 0 or (
        isinstance(base.base, Ring) and base.base.order == base.characteristic
    ):
        factors = _factors(base, variable, f)
        if len(factors) == 1 and factors[0][1] == 1:
            return
        parts = "*".join(f"({p})" + (f"^{n}" if n > 1 else "") for p, n in factors)
        raise RingError(f"{what}: the polynomial is reducible, {shorten(parts)} up to a constant")
    if len(f) == 3 and base.characteristic != 2:
        if base.sqrt(f[1] * f[1] - f[0] * 4) is None:
            return
        raise RingError(f"{what}: the polynomial is reducible, for its discriminant is a square")
    raise RingError(
        f"{what}: whether the polynomial is irreducible is not decided over {base}; over GF(p) and QQ it is"
    )


def _factors(
    base: FractionField, variable: str, f: list[RationalFunction]
) -> list[tuple[SparsePolynomial, int]]:
    """Return those factors of f times its denominators that contain the variable, by Gauss's lemma."""
    several = isinstance(base, RationalFunctions)
    names = base.variables if several else (base.gen_name,)
    R = build_polynomials(base.base, (*names, variable))
    below, total = R.one, R.zero
    parts = []
    for c in f:
        top, under = (R(base.text(base.quotient(p, base.one.num))) for p in (c.num, c.den))
        parts.append((top, under))
        below = R.divide(below * under, below.gcd(under))
    for n, (top, under) in enumerate(parts):
        total = total + top * R.divide(below, under) * R.power(R(variable), n)
    return [(p, int(n)) for p, n in total.factor()[1] if int(p.degrees()[-1]) > 0]
