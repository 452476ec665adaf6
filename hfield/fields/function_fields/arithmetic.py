"""Fields of rational functions k(t) as global fields; also ℚ(x), which is not a global field but has
residues.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from hfield.core.factorisation import Factors
from hfield.core.primality import primes
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.function_fields.artin_schreier import (
    artin_schreier,
    as_norm,
    embed_even,
    has_solution_at,
    of_trace_one,
    square_parts,
)
from hfield.fields.function_fields.common_slots import common_slot_functions, searched_slot
from hfield.fields.function_fields.conics import RamifiedError, solve_conic_functions
from hfield.fields.function_fields.given_symbols import from_ramification_functions
from hfield.fields.function_fields.places import FunctionPlace, place_of_functions, prime_divisors
from hfield.fields.function_fields.quotients import RationalFunction
from hfield.fields.function_fields.residues import FunctionResidues, residues_at
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.function_fields.symbols import (
    ramified_places_functions,
    same_class_rational_functions,
    symbol,
)
from hfield.fields.function_fields.traceless_roots import (
    _obstruction,
    _squarefree,
    traceless_root_functions,
)
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.quadratic_forms.global_field import GlobalField, known_field
from hfield.fields.quadratic_forms.isomorphisms.through_slots import (
    conic_point,
    generator_by_slot,
    through_slot,
)
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, found, none
from hfield.fields.quadratic_forms.normal_forms import NormalForm, discriminant, normal_form
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.symbols import hilbert_symbol_q, ramified_places_q
from hfield.fields.rationals.whole_numbers import square_class

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Polynomial


POINTS, FEW = 400, 5  # values tried for a specialisation; those for which all primes are found
PRIMES_TRIED = list(primes(1_000))

Evidence = Mapping[str, object]


class FunctionArithmetic(GlobalField[RationalFunction, FunctionPlace]):
    """The common arithmetic of k(t) for k = GF(q), q odd or even, and k = ℚ."""

    ring: FunctionField

    @classmethod
    def of(cls, ring: Ring) -> FunctionArithmetic:
        """Return the arithmetic of k(t) for its field of constants k."""
        assert isinstance(ring, FunctionField)
        if ring.base.order is None:
            return OverRationals(ring)
        return OverEven(ring) if ring.characteristic == 2 else OverOdd(ring)

    def read_place(self, text: object) -> FunctionPlace:
        """Return a monic irreducible polynomial or infinity."""
        return place_of_functions(self.ring, text)

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol, computed as a residue; in characteristic 2 the symbol of [a, b | F), where a may
        be 0.
        """
        field = self.ring
        x, y = self._nonzero(a, b)
        v = self.read_place(place)
        t = field.one if field.characteristic == 2 else field.zero
        form = normal_form(field, Constants(x, t, y))
        return self._symbol(form, v)

    def _symbol(self, form: NormalForm, v: FunctionPlace) -> int:
        return symbol(self.ring, form, v)

    def ramified(self, form: NormalForm) -> tuple[FunctionPlace, ...]:
        """Return the places with a nontrivial residue, by degree, infinity last."""
        return ramified_places_functions(self.ring, form)

    def discriminant(self, ramified: tuple[FunctionPlace, ...]) -> RationalFunction:
        """Return the product of the polynomials."""
        return self.ring.product_of(v.poly for v in ramified)

    def with_ramification(
        self, places: Sequence[FunctionPlace | str], infinite: bool | None = None
    ) -> tuple[Scalar, ...]:
        """Return (a, b, t) for a finite field of constants; t = 1 in characteristic 2."""
        if infinite is not None or self.ring.base.order is None:
            return super().with_ramification(places, infinite)
        return from_ramification_functions(self.ring, places)

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic, found by minimising the conic at all places."""
        w, x, y = solve_conic_functions(self.ring, c)
        reason = "no place is ramified, and this is a zero divisor"
        return found(self.ring, c, (w, x, y, self.ring.zero), "conic", reason)

    def residues(self, place: FunctionPlace) -> FunctionResidues | None:
        """Return k[t] modulo a polynomial, or k at infinity, for a finite k."""
        return None if self.ring.base.order is None else residues_at(place)

    def residue_forms(
        self, form: Sequence[RationalFunction]
    ) -> Iterator[tuple[object, Ring, Sequence[Scalar], Sequence[Scalar]]]:
        """Yield infinity and the prime divisors of the coefficients; over a finite k, only those of
        degree 1.
        """
        F = self.ring
        polynomials = (p for c in form for p in (c.num, c.den))
        for place in (FunctionPlace(F), *prime_divisors(F, polynomials)):
            at = residues_at(place)
            k: Ring
            element: Callable[[Polynomial], Scalar]
            if place.degree == 1:
                k, element = F.base, lambda x: F.base(x[0])
            elif F.base.order is None:
                K = NumberField(place.poly)
                k, element = K, functools.partial(FieldElement, K)
            else:
                continue
            parts: tuple[list[Scalar], list[Scalar]] = [], []
            for c in form:
                n, x = at.leading(c)
                parts[n % 2].append(element(x))
            yield place, k, *parts


class OverOdd(FunctionArithmetic):
    """The arithmetic of GF(q)(t), q odd: slots are built from local classes."""

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J, by a common slot and three conics."""
        e = common_slot_functions(self.ring, outer, [outer.a, inner.a])
        assert e is not None, "isomorphic algebras have a common slot"
        return through_slot(self.ring, outer, inner, e, self._conic_point)

    def traceless_root(self, form: NormalForm, s: RationalFunction) -> Coordinates | None:
        """Return x, from a common slot of (a, b) for a and s, which exists if x does."""
        c = Constants(form.a, self.ring.zero, form.b)
        e = common_slot_functions(self.ring, c, [c.a, s])
        return None if e is None else generator_by_slot(self.ring, s, c, e, self._conic_point)[0]

    def _conic_point(
        self, c: Constants
    ) -> tuple[RationalFunction, RationalFunction, RationalFunction]:
        return solve_conic_functions(self.ring, c)


class OverEven(FunctionArithmetic):
    """The arithmetic of GF(q)(t), q even: every algebra contains all inseparable square roots."""

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J, by a square root of b and one conic."""
        return embed_even(self.ring, outer, inner)

    def square_parts(self, x: RationalFunction) -> tuple[RationalFunction, RationalFunction]:
        """Return u and v with x = u² + g·v², the square roots of the even and the odd part of x."""
        return square_parts(self.ring, x)

    def as_norm(
        self, x: RationalFunction, s: RationalFunction
    ) -> tuple[RationalFunction, RationalFunction]:
        """Return w and r with x = w² + s·r², by comparing even and odd parts."""
        return as_norm(self.ring, x, s)

    def artin_schreier(self, x: RationalFunction) -> RationalFunction | None:
        """Return y with ``y² + y = x``, or None."""
        return artin_schreier(self.ring, x)

    def has_root_at(self, place: FunctionPlace, t: RationalFunction, n: RationalFunction) -> bool:
        """Return whether x² − t·x + n has a root in the completion; x² + n has a root in every division
        algebra.
        """
        return t.num != 0 and has_solution_at(residues_at(place), n / (t * t))

    def of_trace_one(self, form: NormalForm, n: RationalFunction) -> Coordinates | None:
        """Return x of trace 1 and norm n, or None if y² + y = n is soluble at a ramified place."""
        one = self.ring.one
        return None if self.obstruction(form, one, n) else of_trace_one(self.ring, form, n)


class OverRationals(FunctionArithmetic):
    """The arithmetic of ℚ(x): residues determine an algebra up to one over ℚ (Faddeev's exact sequence)."""

    splits_if_unramified = False

    def _symbol(self, form: NormalForm, v: FunctionPlace) -> int:
        raise UndecidedError(
            f"the completions of {self.ring} are not local fields: the residue alone does not decide there"
        )

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic, or the places of ℚ at which a specialisation of the algebra
        ramifies.
        """
        try:
            return super().unramified_zero(c, form)
        except RamifiedError as error:
            shown = ", ".join(map(str, error.places))
            reason = (
                "all residues are trivial, so the algebra comes from one over QQ, its value at a point of "
                f"the line, and that one is ramified at {shown}"
            )
            return none("specialisation", reason, error.places, "Faddeev's exact sequence")

    def evidence(
        self, c: Constants, places: Iterable[FunctionPlace]
    ) -> Iterator[Mapping[str, object]]:
        """Yield values of the variable at which the algebra is a division algebra over ℚ."""
        return specialised_evidence(c)

    def same_class(self, form: NormalForm, other: NormalForm) -> bool:
        """Compare the residues, and then the values at a point where both are unramified."""
        return same_class_rational_functions(self.ring, form, other)

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J, by a search for a common slot."""
        e = searched_slot(self.ring, outer, inner, self.same_class)
        return through_slot(self.ring, outer, inner, e, functools.partial(conic_point, self.ring))

    def traceless_root(self, form: NormalForm, s: RationalFunction) -> Coordinates | None:
        """Return x if no rational point of the line excludes it and the search finds it."""
        found = traceless_root_functions(self.ring, form, s)
        return None if found is None else (self.ring.zero, *found)

    def obstruction(
        self, form: NormalForm, t: RationalFunction, n: RationalFunction
    ) -> FunctionPlace | None:
        """Return a place at which the residue is not removed, or a rational place at which a form has no
        zero.
        """
        return _obstruction(self.ring, form, _squarefree(self.ring, t * t / 4 - n)[1])


def specialised_evidence(c: Constants) -> Iterator[Evidence]:
    """Yield values of the variable at which an algebra over ℚ(x) becomes a division algebra over ℚ.

    If the algebra is itself a division algebra, there are infinitely many: ℚ is Brauer–Hilbertian (Fein,
    Saltman and Schacher, *Trans. Amer. Math. Soc.* 334 (1992)). For most of them a small prime is ramified.
    """
    for n in range(POINTS):
        point = QQ((n + 1) // 2 * (-1) ** n)
        if any(x.den(point) == 0 for x in c):
            continue
        special = Constants(*(x.num(point) / x.den(point) for x in c))
        if not discriminant(QQ, special):
            continue
        proof = _rational(special, every=n < FEW)
        if proof is not None:
            yield {"by": "specialisation", "at": QQ.text(point), "proof": proof}


def _rational(c: Constants, every: bool) -> Evidence | None:
    """Return evidence over ℚ from small primes alone or, with ``every``, from all primes if these can be
    found.
    """
    form = normal_form(QQ, c)
    if form.a < 0 and form.b < 0:
        return {"by": "ordering"}
    whole = square_class(form.a) * square_class(form.b)
    primes: Iterable[Hashable] = (
        p
        for p in PRIMES_TRIED
        if (p == 2 or whole % p == 0) and hilbert_symbol_q(form.a, form.b, p) < 0
    )
    if every:
        with suppress(UndecidedError):
            primes = ramified_places_q(form.a, form.b)
    return next(known_field(QQ).evidence(c, primes), None)
