"""K(cos(t), sin(t), …): rational functions on circles, one circle for each angle, and in additional
variables.

The field consists of the rational functions in τ = tan(t/2): cos(t) = (1 − τ²)/(1 + τ²), sin(t) = 2τ/(1 +
τ²). So it uses their arithmetic, and equality is decided. Elements are written as P/Q, where P is in cosines
and sines without squares of sines, and Q in cosines alone; in lowest terms this is unique.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import prod
from random import Random
from typing import TYPE_CHECKING

from hfield.errors import CoercionError, shorten
from hfield.fields.base.printing import blackboard, quotient_text
from hfield.fields.base.ring import Ring, shared
from hfield.fields.base.to_sympy import symbol
from hfield.fields.circles.angles import (
    PI,
    Angle,
    WithAngles,
    angle_text,
    cosine_and_sine_of,
    rotated,
)
from hfield.fields.function_fields.extensions import ExtensionElement
from hfield.fields.function_fields.over_number_fields import OverNumberField
from hfield.fields.function_fields.quotients import (
    FractionField,
    RationalFunction,
    value_of_fraction,
)
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.polynomial_rings import PolynomialRing
from hfield.fields.polynomial_rings import build as build_polynomials
from hfield.fields.rationals.ring import QQ
from hfield.fields.several_variables.ring import RationalFunctions, listed

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import AnyPolynomial, Coefficient, SparsePolynomial
    from hfield.fields.base.ring import E, Embedding, S

Angles = tuple[tuple[str, int], ...]  # (t, n) for cosine and sine of t/n


class CircleFunctions(WithAngles[RationalFunction], FractionField):
    """The common part of fields of functions on circles, which are fields of rational functions in half-angle
    tangents.

    >>> from hfield import ring
    >>> F = ring("QQ(cos(t),sin(t))")
    >>> F("cos(t)^2 + sin(t)^2"), F("sin(2*t)/(1 + cos(2*t))"), F("cos(3*t)")
    (1, sin(t)/cos(t), 4*cos(t)^3-3*cos(t))
    """

    angles: Angles
    plain: tuple[str, ...]  # the other variables

    def name_by_angles(self, base: Ring, angles: Angles, plain: tuple[str, ...]) -> None:
        """Store the angles and the other variables, and make the field's name from them."""
        self.angles, self.plain = angles, plain
        pairs = [f"{f}({angle_text(*a)})" for a in angles for f in ("cos", "sin")]
        self.name = f"{base.name}({','.join((*plain, *pairs))})"
        self.gen_name = pairs[0]
        self.written = build_polynomials(base, (*plain, *pairs))
        self._mixed = build_polynomials(base, (*self.variables, *pairs))

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (build, self.base, self.angles, self.plain)

    @property
    def data(self) -> dict[str, object]:
        """The constants, the angles with their divisors, and the variables of the field, as JSON data."""
        angles = [list(a) for a in self.angles]
        own = {"angles": angles, "variables": list(self.plain)}
        return {"kind": "circle functions", "base": self.base.data, **own}

    def in_words(self) -> str:
        """Return a description of the field."""
        pairs = tuple(f"{f}({angle_text(*a)})" for a in self.angles for f in ("cos", "sin"))
        return f"rational functions in {listed((*self.plain, *pairs))} over {blackboard(self.base.name)}"

    @property
    def gen(self) -> RationalFunction:
        """The cosine of the first angle."""
        name, parts = self.angles[0]
        return self.cosine_and_sine({name: Fraction(1, parts)})[0]

    def generators(self) -> dict[str, RationalFunction]:
        """Return the other variables and the generators of the constants."""
        below = {name: self(x) for name, x in self.base.generators().items()}
        return below | {name: x for name, x in self.names().items() if name in self.plain}

    def images_in(self, target: Ring[S]) -> dict[str, S]:
        """Return nothing: cosines and sines are mapped by their texts."""
        return {}

    # --- cosines and sines ---------------------------------------------------------------------

    def half_tangent_point(self, angle: Angle) -> tuple[RationalFunction, RationalFunction]:
        """Return x and y with (cos, sin) of half an angle = (x, y)/r, for some r that depends on the angle.

        Raises :class:`CoercionError` for an angle that is not a sum of multiples of the angles of the field.
        """
        units, tangents = dict(self.angles), self.names()
        x, y = self.one, self.zero
        for name, c in angle.items():
            if name == PI:
                continue
            count = c * units.get(name, 0)
            if name not in units or count.denominator != 1:
                known = ", ".join(angle_text(*a) for a in self.angles)
                raise CoercionError(
                    f"{c}*{shorten(name)} is not an integer multiple of an angle of {self}: these are {known}"
                )
            tangent = tangents[_tangent_name(name, units[name])]
            u, v = _power(self, tangent, int(abs(count)))
            v = v if count > 0 else -v
            x, y = x * u - y * v, x * v + y * u
        return x, y

    def cosine_and_sine(self, angle: Angle) -> tuple[RationalFunction, RationalFunction]:
        """Return the cosine and sine. Raises :class:`CoercionError`, for instance for π/3, whose sine is not
        rational.
        """
        x, y = self.half_tangent_point(angle)
        below = self.inverse(x * x + y * y)
        cosine, sine = (x * x - y * y) * below, x * y * 2 * below
        return rotated(self, (cosine, sine), angle)

    def tangent(self, angle: Angle) -> RationalFunction:
        """Return the tangent; half the angles of the field are also supported. Raises
        :class:`CoercionError`.
        """
        if PI in angle:
            cosine, sine = self.cosine_and_sine(angle)
            return sine / cosine
        x, y = self.half_tangent_point({name: 2 * c for name, c in angle.items()})
        return y / x

    def leading_near_zero(self, poly: AnyPolynomial) -> tuple[tuple[int, ...], Coefficient]:
        """Return the exponents and coefficient of the term that determines the sign for small angles.

        Tangents are small, each much smaller than the one before; other variables are large, each much larger
        than the next.
        """
        plain = len(self.plain)
        terms = poly.to_dict() if hasattr(poly, "to_dict") else dict(enumerate(poly.coeffs()))
        rows = {m if isinstance(m, tuple) else (m,): c for m, c in terms.items() if c != 0}

        def place(m: tuple[int, ...]) -> tuple[int, ...]:
            return (*(m[: plain - 1 : -1] if plain else m[::-1]), *(-n for n in m[:plain]))

        exponents = min(rows, key=place)
        return place(exponents), rows[exponents]

    def sign_near_zero(self, x: RationalFunction) -> int:
        """Return the sign of x if all angles are positive and small, each much smaller than the one
        before.
        """
        if self.is_zero(x):
            return 0
        signs = (self.base.sign(self.base(self.leading_near_zero(p)[1])) for p in (x.num, x.den))
        return prod(signs)

    # --- written in cosines and sines ----------------------------------------------------------

    def in_cosines(self, x: RationalFunction) -> tuple[SparsePolynomial, SparsePolynomial]:
        """Return numerator and denominator in cosines and variables; the numerator contains sines too."""
        num, den = (self._raised(p) for p in (x.num, x.den))
        plain = len(self.plain)
        for n in range(len(self.angles)):
            place = plain + n
            mirrored = _mirrored(self._mixed, den, place)
            if mirrored != den:
                num, den = num * mirrored, den * mirrored
            num, den = self._without_tangent(num, den, n)
            common = num.gcd(den)
            if not common.is_constant():
                num, den = num // common, den // common
        lead = self._mixed.constant(self._mixed.base.inverse(self._mixed.constant_part(den)))
        num, den = num * lead, den * lead
        return self._lowered(num), self._lowered(den)

    def _raised(self, poly: AnyPolynomial) -> SparsePolynomial:
        """Return a numerator or denominator as a polynomial in tangents, cosines and sines."""
        more = (0,) * (2 * len(self.angles))
        if hasattr(poly, "to_dict"):
            terms = {(*m, *more): c for m, c in poly.to_dict().items()}
        else:
            terms = {(n, *more): c for n, c in enumerate(poly.coeffs()) if c}
        found: SparsePolynomial = self._mixed.context.from_dict(terms)
        return found

    def _lowered(self, poly: SparsePolynomial) -> SparsePolynomial:
        plain, skipped = len(self.plain), len(self.variables)
        terms = {(*m[:plain], *m[skipped:]): c for m, c in poly.to_dict().items()}
        found: SparsePolynomial = self.written.context.from_dict(terms)
        return found

    def _without_tangent(
        self, num: SparsePolynomial, den: SparsePolynomial, n: int
    ) -> tuple[SparsePolynomial, SparsePolynomial]:
        """Substitute s/(1 + c) for the n-th half-angle tangent and (1 − c)/(1 + c) for its square; only
        ``num`` has odd powers of it.
        """
        place = len(self.plain) + n
        size = max((m[place] + 1) // 2 for p in (num, den) for m in p.to_dict())
        names = self._mixed.variables
        first = len(self.variables) + 2 * n
        gens = self._mixed.names()
        c, s, one = gens[names[first]], gens[names[first + 1]], self._mixed.one

        def replaced(poly: SparsePolynomial) -> SparsePolynomial:
            by_power: dict[int, dict[tuple[int, ...], Coefficient]] = {}
            for m, x in poly.to_dict().items():
                by_power.setdefault(m[place], {})[(*m[:place], 0, *m[place + 1 :])] = x
            total = self._mixed.zero
            for exponent, terms in by_power.items():
                k, odd = divmod(exponent, 2)
                factor = (one - c) ** k * (one + c) ** (size - k - odd)
                total = total + self._mixed.context.from_dict(terms) * (
                    factor * s if odd else factor
                )
            return total

        return replaced(num), replaced(den)

    def text(self, x: RationalFunction, style: str = "plain") -> str:
        """Write x, such as ``sin(t)/(cos(t)+1)``."""
        num, den = (self.written.text(p, style) for p in self.in_cosines(x))
        shown = quotient_text(num, den, style)
        return in_latex(shown) if style == "latex" else shown

    def to_sympy(self, x: RationalFunction, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return x as an expression in cosines and sines."""
        known = self.in_sympy(symbols)
        num, den = (self.written.to_sympy(p, known) for p in self.in_cosines(x))
        return num / den

    def in_sympy(self, symbols: Mapping[str, sympy.Symbol]) -> dict[str, sympy.Expr]:
        """Return the cosines and sines as sympy expressions, by their names in this field."""
        import sympy

        known: dict[str, sympy.Expr] = dict(symbols)
        for name, parts in self.angles:
            angle = symbol(name, symbols) / parts
            for f in ("cos", "sin"):
                known[f"{f}({angle_text(name, parts)})"] = getattr(sympy, f)(angle)
        return known

    # --- values and derivatives ----------------------------------------------------------------

    @property
    def variable_names(self) -> tuple[str, ...]:
        """The angles and the other variables."""
        return (*self.plain, *(name for name, _ in self.angles))

    def images_of(self, values: Mapping[str, object], target: Ring[S]) -> dict[str, S]:
        """Return the images of cosines, sines and variables; the values of angles are angles, such as π/3."""
        known = target.generators()
        found = {
            name: target(values[name]) if name in values else known[name]
            for name in self.plain
            if name in values or name in known
        }
        for name, parts in self.angles:
            pair = cosine_and_sine_of(target, values.get(name, name), parts)
            for f, value in zip(("cos", "sin"), pair, strict=True):
                found[f"{f}({angle_text(name, parts)})"] = value
        return found

    def evaluation(
        self,
        target: Ring[S],
        images: Mapping[str, S],
        below: Embedding[S],
    ) -> Callable[[RationalFunction], S]:
        """Return the homomorphism that maps cosines, sines and variables to these images."""
        given = self.images_of_cosines(target, images)
        polynomial = self.written.evaluation(target, given, below)

        def value(x: RationalFunction) -> S:
            num, den = self.in_cosines(x)
            found: S = value_of_fraction(self, x, target, polynomial(num), polynomial(den))
            return found

        return value

    def images_of_cosines(self, target: Ring[S], images: Mapping[str, S]) -> dict[str, S]:
        """Return the images of cosines, sines and variables; those without a given image stay fixed."""
        names = self.written.variables
        return {v: images[v] if v in images else target(v) for v in names}

    def derivative(self, x: RationalFunction, variable: str) -> RationalFunction:
        """Return the derivative by an angle, d/dt, or by another variable."""
        if variable in self.plain:
            return super().derivative(x, variable)
        parts = dict(self.angles).get(variable)
        if parts is None:
            return Ring.derivative(self, x, variable)
        name = _tangent_name(variable, parts)
        tangent = self.names()[name]
        return super().derivative(x, name) * (tangent * tangent + 1) * self(Fraction(1, 2 * parts))

    def variables_in(self, x: RationalFunction) -> set[str]:
        """Return the angles and variables on which x depends."""
        found = super().variables_in(x)
        angles = {name for name, parts in self.angles if _tangent_name(name, parts) in found}
        return angles | (found & {*self.plain})

    def random(self, rng: Random) -> RationalFunction:
        """Return a random quotient of polynomials with few terms in cosines and sines."""
        pairs = [v for a in self.angles for v in self.cosine_and_sine({a[0]: Fraction(1, a[1])})]
        values = [*pairs, *(x for n, x in self.names().items() if n in self.plain)]
        num, den = (
            self(self.base.random(rng)) + rng.choice(values) * self(self.base.random(rng))
            for _ in range(2)
        )
        return num if self.is_zero(den) else num / den + rng.choice(values)


class OneCircle(CircleFunctions, FunctionField):
    """K(cos(t), sin(t)): rational functions in tan(t/2)."""

    def __init__(self, base: Ring, angles: Angles) -> None:
        FunctionField.__init__(self, base, _tangent_name(*angles[0]))
        self.name_by_angles(base, angles, ())

    def names(self) -> dict[str, RationalFunction]:
        """The tangent of half the angle, and the generator of the constants."""
        return {**self.base_names(), self.variables[0]: self._gen}


class SeveralCircles(CircleFunctions, RationalFunctions):
    """K(x, …, cos(t), sin(t), …) with several angles, or with additional variables."""

    def __init__(self, base: Ring, angles: Angles, plain: tuple[str, ...]) -> None:
        tangents = (_tangent_name(*a) for a in angles)
        RationalFunctions.__init__(self, build_polynomials(base, (*plain, *tangents)))
        self.name_by_angles(base, angles, plain)


class CirclesOverNumberField(WithAngles[ExtensionElement], OverNumberField):
    """K(cos(t), sin(t), …) over a number field K; ``base`` is the corresponding field over ℚ."""

    base: CircleFunctions

    def cosine_and_sine(self, angle: Angle) -> tuple[ExtensionElement, ExtensionElement]:
        """Return the cosine and sine; K may contain those of some rational multiples of π."""
        rest = {name: c for name, c in angle.items() if name != PI}
        cosine, sine = (self.reduced([x]) for x in self.base.cosine_and_sine(rest))
        return rotated(self, (cosine, sine), angle)

    def sign_near_zero(self, x: ExtensionElement) -> int:
        """Return the sign if all angles are positive and small and θ has the value in the name of K."""
        if self.is_zero(x):
            return 0
        base, K = self.base, self._field
        common = prod((c.den for c in x.coefficients), start=base.one.num)
        leading = {
            n: base.leading_near_zero((c * base.quotient(common, base.one.num)).num)
            for n, c in enumerate(x.coefficients)
            if not base.is_zero(c)
        }
        first = min(place for place, _ in leading.values())
        zero = K.coefficients_of(K.zero)
        values = [
            leading[n][1] if n in leading and leading[n][0] == first else c
            for n, c in enumerate(zero)
        ]
        sign: int = K.sign_at(K.of_coefficients(values), K.principal)
        return sign * base.sign_near_zero(base.quotient(common, base.one.num))

    def tangent(self, angle: Angle) -> ExtensionElement:
        """Return the tangent."""
        if PI not in angle:
            return self.reduced([self.base.tangent(angle)])
        cosine, sine = self.cosine_and_sine(angle)
        return sine / cosine


def in_latex(text: str) -> str:
    """Return a text of LaTeX with its cosines and sines as functions."""
    return text.replace("cos(", r"\cos(").replace("sin(", r"\sin(")


def _power(field: Ring[E], tangent: E, n: int) -> tuple[E, E]:
    """Return the real and the imaginary part of (1 + τ·I)ⁿ."""
    x, y = field.one, field.zero
    for _ in range(n):
        x, y = x - y * tangent, x * tangent + y
    return x, y


def _tangent_name(name: str, parts: int) -> str:
    return f"tan({angle_text(name, 2 * parts)})"


def _mirrored(ring: PolynomialRing, poly: SparsePolynomial, place: int) -> SparsePolynomial:
    """Return a polynomial with x replaced by −x for the variable x in that place."""
    terms = {m: -c if m[place] % 2 else c for m, c in poly.to_dict().items()}
    found: SparsePolynomial = ring.context.from_dict(terms)
    return found


def over_number_field(
    field: Ring, angles: Angles, plain: tuple[str, ...]
) -> CirclesOverNumberField:
    """Return the field of functions on circles over a number field."""
    return shared(CirclesOverNumberField, build(QQ, angles, plain), field)


def build(base: Ring, angles: Angles, plain: tuple[str, ...]) -> Ring:
    """Return the field of functions on circles over QQ, a number field or GF(p)."""
    if hasattr(base, "modulus_over_rationals"):
        return over_number_field(base, angles, plain)
    if len(angles) == 1 and not plain:
        return shared(OneCircle, base, angles)
    return shared(SeveralCircles, base, angles, plain)
