"""Rational functions in several variables: fields with residues, which decide most algebras."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from hfield.core.product import Constants, Scalar
from hfield.errors import RingError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.function_fields.artin_schreier import artin_schreier
from hfield.fields.function_fields.quotients import RationalFunction
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.quadratic_forms.global_field import GlobalField
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, none
from hfield.fields.quadratic_forms.normal_forms import NormalForm
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.several_variables.places import (
    PolynomialPlace,
    ResidueFieldElement,
    places_of,
    residue,
    unit_part,
    valuation,
)
from hfield.fields.several_variables.ring import RationalFunctions

if TYPE_CHECKING:
    import flint


POINTS = 12  # values of each variable, tried in a search for a point at which nothing vanishes


class SeveralArithmetic(GlobalField[RationalFunction, PolynomialPlace]):
    """The arithmetic of k(x, y, …): residues at prime polynomials (Gille and Szamuely, chapter 6).

    An algebra with a residue that is not a square is a division algebra. In characteristic not 2, an algebra
    without such residues comes from k (purity, Voight 14.6 and Colliot-Thélène's survey of it), and its value
    at a point decides.
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
        """Return the places with a nontrivial residue.

        Raises :class:`UndecidedError` if some residues are not decided.
        """
        found, left_open = self._residues(form)
        if not left_open:
            return found
        shown = ", ".join(map(str, left_open))
        raise UndecidedError(f"whether the residues at {shown} are squares is not decided")

    def ramified_at_small_places(self, form: NormalForm) -> tuple[PolynomialPlace, ...]:
        """Return the places at which a residue is known to be nontrivial."""
        return self._residues(form)[0]

    def _residues(
        self, form: NormalForm
    ) -> tuple[tuple[PolynomialPlace, ...], tuple[PolynomialPlace, ...]]:
        """Return the places with a nontrivial residue, and the places where that is not decided."""
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

    def _tame(self, form: NormalForm, place: PolynomialPlace) -> ResidueFieldElement | None:
        """Return the residue (−1)^{vw}·a^w/b^v up to squares; None if v and w are even."""
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
        """Return whether [a, b) is trivial at a place at which a has no pole: y² + y = a in the residue
        field, or v(b) is even.
        """
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

    def why_ramified(self, form: NormalForm, places: tuple[PolynomialPlace, ...]) -> str:
        """Return the residue at the first ramified place, in words."""
        place = places[0]
        at = f"the residue at {place}"
        if form.kind == "artin-schreier":
            r = residue(self.ring, form.a, place)
            why = f"{at} is [{r.field.text(r.value)}), and y² + y does not take that value in {r.field}"
        else:
            tame = self._tame(form, place)
            assert tame is not None, "the residue is not trivial"
            text = f"{tame.field.text(tame.value)}, which is not a square in {tame.field}"
            why = (
                f"{at} has the norm {text}, so it is not a square"
                if tame.is_norm
                else f"{at} is {text}"
            )
        return f"{why}; the algebra is ramified at {', '.join(map(str, places))}"

    def discriminant(self, ramified: tuple[PolynomialPlace, ...]) -> RationalFunction:
        """Return the product of the polynomials."""
        return self.ring.product_of(v.poly for v in ramified)

    def residue_forms(
        self, form: Sequence[RationalFunction]
    ) -> Iterator[tuple[object, Ring, Sequence[Scalar], Sequence[Scalar]]]:
        """Yield the prime polynomials in the coefficients, and the infinite places."""
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
        """Prove by a value that there is no zero; zeros themselves are not computed."""
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

    def _at(self, x: RationalFunction, n: int) -> flint.fmpq:
        """Return the value at a point that depends on n; None if it is 0 or there is a pole."""
        point = [n + 3 * m + m * m * n for m in range(len(self.ring.variables))]
        over, under = (p(*point) for p in (x.num, x.den))
        return over / under if over and under else None

    def same_class(self, form: NormalForm, other: NormalForm) -> bool:
        """Prove that two algebras are not isomorphic, by their ramified places."""
        (found, left_open), (others, other_open) = map(self._residues, (form, other))
        if not {*found} <= {*others, *other_open} or not {*others} <= {*found, *left_open}:
            return False
        raise UndecidedError(
            f"isomorphism over {self.ring} is not decided where the same places may ramify"
        )


def _has_odd_degree(x: RationalFunction) -> bool:
    """Return whether a rational function has a positive odd degree, and therefore is not of the
    form y² + y.
    """
    n = int(x.num.total_degree()) - int(x.den.total_degree())
    return n > 0 and n % 2 == 1
