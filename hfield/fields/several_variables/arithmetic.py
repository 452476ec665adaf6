"""Rational functions in several variables: fields with residues, which decide most algebras.

Prime polynomials of k[x, y, …], and what rational functions leave modulo them.

Where P is linear in some variable, P = c·v + d, the residue field is k(…) in the other variables, with −d/c
for v. Elsewhere the norm down to the other variables may show that a residue is no square. At infinity of a
variable the leading coefficients stand for the residue.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from hfield.core.product import Constants
from hfield.errors import RingError, UndecidedError
from hfield.fields.function_fields.artin_schreier import artin_schreier
from hfield.fields.function_fields.rational_functions import rational_functions
from hfield.fields.function_fields.residues import multiplicity
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.several_variables.ring import RationalFunctions
from hfield.rings.base import Ring
from hfield.structure.forms import NormalForm
from hfield.structure.global_field import GlobalField
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm, none

if TYPE_CHECKING:
    import flint

    from hfield.fields.function_fields.quotients import Quotient
    from hfield.rings.flint_types import SparsePolynomial


POINTS = 12  # as many values of each variable are tried for a point where nothing vanishes


class SeveralArithmetic(GlobalField):
    """The arithmetic of k(x, y, …): residues at prime polynomials (Gille and Szamuely, chapter 6).

    An algebra with a residue that is no square is a division algebra. One without any comes from k, where the
    characteristic is not 2 (purity, Voight 14.6 and Colliot-Thélène's survey of it), and a value decides.
    """

    ring: RationalFunctions
    splits_if_unramified = False
    cited = "residues at prime polynomials (Gille and Szamuely, Central Simple Algebras, chapter 6)"

    def read_place(self, text: object) -> PolynomialPlace:
        """Return a place from a prime polynomial, its text, or ``1/x`` for infinity of x."""
        F = self.ring
        if isinstance(text, PolynomialPlace):
            return text
        infinite = {v.name: v for v in places_of(F)}
        name = str(text).replace(" ", "")
        if name in infinite:
            return infinite[name]
        x = F(text)
        finite = x.num.factor()[1] if x.num != 0 and F.is_one(x.den) else []
        if [int(n) for _, n in finite] != [1]:
            raise RingError(
                f"{text} is not a place of {F}: expected an irreducible polynomial, or 1/x"
            )
        return places_of(F, x)[0]

    # --- residues ------------------------------------------------------------------------------

    def ramified(self, form: NormalForm) -> tuple[PolynomialPlace, ...]:
        """Return the places where a residue is not trivial.

        Raises :class:`UndecidedError` where some residues are not decided.
        """
        found, left_open = self._residues(form)
        if not left_open:
            return found
        shown = ", ".join(map(str, left_open))
        raise UndecidedError(f"whether the residues at {shown} are squares is not decided")

    def ramified_at_small_places(self, form: NormalForm) -> tuple[PolynomialPlace, ...]:
        """Return the places where a residue is known not to be trivial."""
        return self._residues(form)[0]

    def _residues(
        self, form: NormalForm
    ) -> tuple[tuple[PolynomialPlace, ...], tuple[PolynomialPlace, ...]]:
        """Return the places with a residue that is not trivial, and those where that is not decided."""
        found, left_open = [], []
        for place in places_of(self.ring, *(x for x in form.constants if not self.ring.is_zero(x))):
            try:
                if not self._is_trivial(form, place):
                    found.append(place)
            except UndecidedError:
                left_open.append(place)
        return tuple(found), tuple(left_open)

    def _is_trivial(self, form: NormalForm, place: PolynomialPlace) -> bool:
        if form.kind == "artin-schreier":
            return self._is_trivial_even(form, place)
        r = self._tame(form, place)
        return r is None or r.is_square()

    def _tame(self, form: NormalForm, place: PolynomialPlace) -> Residue | None:
        """Return the residue (−1)^{vw}·a^w/b^v up to squares, None where v and w are even."""
        F = self.ring
        v, w = (valuation(F, x, place) for x in form.constants)
        if v % 2 == 0 and w % 2 == 0:
            return None
        unit = F(-1 if v % 2 and w % 2 else 1)
        for x, other in ((form.a, w), (form.b, v)):
            if other % 2:
                unit = unit * unit_part(F, x, place)
        return residue(F, unit, place)

    def _is_trivial_even(self, form: NormalForm, place: PolynomialPlace) -> bool:
        """Tell it for [a, b) where a has no pole: whether y² + y = a among the residues, or v(b) is even."""
        F = self.ring
        n = 0 if F.is_zero(form.a) else valuation(F, form.a, place)
        if n < 0:
            raise UndecidedError("residues at poles are not decided in characteristic 2")
        if n > 0 or F.is_zero(form.a) or valuation(F, form.b, place) % 2 == 0:
            return True
        r = residue(F, form.a, place)
        if r.is_norm or not isinstance(r.field, FunctionField):
            if not r.is_norm and _has_odd_degree(r.value):
                return False
            raise UndecidedError(f"y² + y = {r.field.text(r.value)} is not decided over {r.field}")
        return artin_schreier(r.field, r.value) is not None

    def why_ramified(self, form: NormalForm, places: tuple[Any, ...]) -> str:
        """Say what the residue at the first place is."""
        place = places[0]
        at = f"the residue at {place}"
        if form.kind == "artin-schreier":
            r = residue(self.ring, form.a, place)
            why = f"{at} is [{r.field.text(r.value)}), and y² + y does not take that value in {r.field}"
        else:
            tame = self._tame(form, place)
            assert tame is not None, "the residue is not trivial"
            text = f"{tame.field.text(tame.value)}, which is no square in {tame.field}"
            why = (
                f"{at} has the norm {text}, so it is no square"
                if tame.is_norm
                else f"{at} is {text}"
            )
        return f"{why}; the algebra is ramified at {', '.join(map(str, places))}"

    def discriminant(self, ramified: tuple[Any, ...]) -> Quotient:
        """Return the product of the polynomials."""
        return self.ring.product_of(v.poly for v in ramified)

    def residue_forms(
        self, form: Sequence[Quotient]
    ) -> Iterator[tuple[object, Ring, list[Any], list[Any]]]:
        """Run through the prime polynomials in the coefficients, and infinities."""
        F = self.ring
        for place in places_of(F, *form):
            try:
                found = [residue(F, unit_part(F, c, place), place) for c in form]
            except UndecidedError:
                continue
            if not any(r.is_norm for r in found) and found[0].field != F:
                odd = [valuation(F, c, place) % 2 for c in form]
                even, rest = (
                    [r.value for r, o in zip(found, odd, strict=True) if o == n] for n in (0, 1)
                )
                yield place, found[0].field, even, rest

    # --- what is not known -----------------------------------------------------------------------

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Tell by a value that there is no zero; where there is one, none is written down."""
        F = self.ring
        if F.characteristic == 0:
            for n in range(1, POINTS):
                values = [self._at(x, n) for x in form.constants]
                if all(values):
                    places = ramified_places_q(*values)
                    if places:
                        shown = ", ".join(map(str, places))
                        reason = (
                            "all residues are trivial, so the algebra comes from one over QQ, its value at a "
                            f"point, and that one is ramified at {shown}"
                        )
                        return none("specialisation", reason, places, "purity of the Brauer group")
                    break
        raise UndecidedError(
            f"no residue shows a division algebra, and no zero of norms over {F} is sought"
        )

    def _at(self, x: Quotient, n: int) -> flint.fmpq:
        """Return the value at a point that depends on n, None where it is 0 or has a pole."""
        point = [n + 3 * m + m * m * n for m in range(len(self.ring.variables))]
        over, under = (p(*point) for p in (x.num, x.den))
        return over / under if over and under else None

    def same_class(self, form: NormalForm, other: NormalForm) -> bool:
        """Tell that two algebras are different by the places where they ramify."""
        (found, left_open), (others, other_open) = map(self._residues, (form, other))
        if not {*found} <= {*others, *other_open} or not {*others} <= {*found, *left_open}:
            return False
        raise UndecidedError(
            f"isomorphism over {self.ring} is not decided where the same places may ramify"
        )


def _has_odd_degree(x: Quotient) -> bool:
    """Tell whether a rational function has a positive odd degree, so that it is no y² + y."""
    n = int(x.num.total_degree()) - int(x.den.total_degree())
    return n > 0 and n % 2 == 1


@dataclass(frozen=True)
class PolynomialPlace:
    """A prime polynomial of k[x, y, …], as flint has it, or infinity of the variable with that index."""

    name: str
    poly: Any = field(default=None, hash=False)
    infinite: int | None = None

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return self.name


@dataclass(frozen=True)
class Residue:
    """An element of the residue field at a place, or its norm down to the field given."""

    field: Ring
    value: Any
    is_norm: bool = False

    def is_square(self) -> bool:
        """Tell whether it is a square. Raises :class:`UndecidedError`."""
        root = self.field.sqrt(self.value)
        if root is not None and self.is_norm:
            raise UndecidedError("the norm of the residue is a square, which does not decide")
        return root is not None


def places_of(F: RationalFunctions, *elements: Quotient) -> list[PolynomialPlace]:
    """Return the prime polynomials in elements of k(x, y, …), and infinity of each variable."""
    found = {}
    for x in elements:
        for poly in (x.num, x.den):
            for p, _ in poly.factor()[1]:
                p = F.quotient(F.polynomials.one, p).den
                found[F.polynomials.text(p)] = p
    order = sorted(found.items(), key=lambda item: (int(item[1].total_degree()), item[0]))
    finite = [PolynomialPlace(name, p) for name, p in order]
    return finite + [PolynomialPlace(f"1/{name}", None, n) for n, name in enumerate(F.variables)]


def valuation(F: RationalFunctions, x: Quotient, place: PolynomialPlace) -> int:
    """Return the order of a nonzero rational function at a place."""
    if place.infinite is not None:
        over, under = (int(p.degrees()[place.infinite]) for p in (x.num, x.den))
        return under - over
    return multiplicity(x.num, place.poly) - multiplicity(x.den, place.poly)


def unit_part(F: RationalFunctions, x: Quotient, place: PolynomialPlace) -> Any:
    """Return x times a power of the prime, or of 1/v, without zero or pole at the place."""
    n = valuation(F, x, place)
    if place.infinite is not None:
        return x * F.power(F.names()[F.variables[place.infinite]], n)
    return x * F.power(F.quotient(place.poly, F.polynomials.one), -n)


def residue(F: RationalFunctions, unit: Quotient, place: PolynomialPlace) -> Residue:
    """Return the residue of a unit at a place, or a norm of it. Raises :class:`UndecidedError`."""
    if place.infinite is not None:
        target = _without(F, place.infinite)
        over, under = (_leading(F, p, place.infinite, target) for p in (unit.num, unit.den))
        return Residue(target, target.divide(over, under))
    for n in range(len(F.variables)):
        if int(place.poly.degrees()[n]) == 1:
            target = _without(F, n)
            slope, rest = (_coefficient(F, place.poly, n, e, target) for e in (1, 0))
            at = target.zero - target.divide(rest, slope)
            over, under = (_value(F, p, n, at, target) for p in (unit.num, unit.den))
            return Residue(target, target.divide(over, under))
    return Residue(F, unit) if F.sqrt(unit) is not None else _norm(F, unit, place)


def _norm(F: RationalFunctions, unit: Quotient, place: PolynomialPlace) -> Residue:
    """Return the norm of a residue down to the other variables, up to squares, by resultants."""
    degrees = {m: int(e) for m, e in enumerate(place.poly.degrees()) if int(e)}
    n = max(degrees, key=lambda m: degrees[m] % 2)  # in odd degree the norm of a constant tells
    target = _without(F, n)
    lead = _leading(F, place.poly, n, target)
    total = target.one
    for p in (unit.num, unit.den):
        size = _coefficient(F, place.poly.resultant(p, F.variables[n]), n, 0, target)
        total = total * size * (lead if int(p.degrees()[n]) % 2 else target.one)
    return Residue(target, total, is_norm=True)


def _without(F: RationalFunctions, n: int) -> Ring:
    """Return the rational functions in the variables other than the n-th."""
    return rational_functions(F.base, F.variables[:n] + F.variables[n + 1 :])


def _coefficient(
    F: RationalFunctions, poly: SparsePolynomial, n: int, exponent: int, target: Ring
) -> Any:
    """Return the coefficient of a power of the n-th variable."""
    gens = target.names()
    total = target.zero
    for exponents, c in poly.terms():
        if exponents[n] == exponent:
            term = target(F.base(int(c) if F.characteristic else c))
            for m, e in enumerate(exponents):
                if m != n and e:
                    term = term * target.power(gens[F.variables[m]], int(e))
            total = total + term
    return total


def _leading(F: RationalFunctions, poly: SparsePolynomial, n: int, target: Ring) -> Any:
    return _coefficient(F, poly, n, int(poly.degrees()[n]), target)


def _value(F: RationalFunctions, poly: SparsePolynomial, n: int, at: Quotient, target: Ring) -> Any:
    """Return the value with an element of the target for the n-th variable."""
    total = target.zero
    for e in range(int(poly.degrees()[n]), -1, -1):
        total = total * at + _coefficient(F, poly, n, e, target)
    return total
