"""Hilbert symbols and ramified places over k(t), k a finite field of any characteristic, or ℚ.

A place is a monic irreducible polynomial or infinity. In characteristic not 2, the symbol at a place is the
class of the tame residue ``(−1)^{vw}·b^v/a^w`` in the residue field modulo squares (over ℚ this is Faddeev's
residue, which still decides ramification). In characteristic 2 the algebra [a, b) has the invariant
``Tr(Res(a·db/b))``, where the trace goes down to GF(2). Serre, *Local Fields*, chapter XIV, and Gille and
Szamuely, *Central Simple Algebras and Galois Cohomology*, chapter 6.
"""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

from hfield.core.product import Scalar
from hfield.fields.function_fields.places import FunctionPlace, prime_divisors
from hfield.fields.function_fields.residues import FunctionResidues, residues_at, valuation
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.quadratic_forms.normal_forms import NormalForm
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.rationals.whole_numbers import fraction

if TYPE_CHECKING:
    import flint

    from hfield.fields.base.flint_types import Coefficient, Polynomial
    from hfield.fields.function_fields.quotients import RationalFunction


def _poles_and_zeros(field: FunctionField, *elements: RationalFunction) -> list[FunctionPlace]:
    """Return the places at which some elements have zeros and poles, by degree, and infinity."""
    parts = (poly for x in elements for poly in (x.num, x.den))
    finite = sorted(prime_divisors(field, parts), key=lambda v: (v.degree, str(v)))
    return [*finite, FunctionPlace(field)]


def symbol(field: FunctionField, form: NormalForm, place: FunctionPlace) -> int:
    """Return 1 if the tame residue, or the invariant of [a, b), is trivial, else −1."""
    a, b = form.constants
    if form.kind == "artin-schreier":
        return 1 - 2 * _invariant(field, a, b, place)
    kappa, residue = tame_residue(a, b, place)
    return 1 if kappa.is_square(residue) else -1


def tame_residue(
    a: RationalFunction, b: RationalFunction, place: FunctionPlace
) -> tuple[FunctionResidues, Polynomial]:
    """Return the residue field and the tame residue of (a, b) at a place."""
    kappa = residues_at(place)
    (v, x), (w, y) = kappa.leading(a), kappa.leading(b)
    value = kappa.multiply(x if w % 2 else kappa.one, y if v % 2 else kappa.one)
    return kappa, kappa.zero - value if v % 2 and w % 2 else value


def _invariant(
    field: FunctionField, a: RationalFunction, b: RationalFunction, place: FunctionPlace
) -> int:
    """Return the trace to GF(2) of the residue of ``a·db/b``; it is 1 if [a, b) ramifies."""
    n, m = b.num, b.den
    differential = a * field.quotient(n.derivative() * m + n * m.derivative(), n * m)
    if differential.num == 0:
        return 0
    if place.poly is None:  # the residues of a differential add up to 0
        return _trace_to_prime(field, _coefficient_of_inverse(field, differential))
    pole = -valuation(differential, place.poly)
    if pole <= 0:
        return 0
    power = place.poly**pole
    cofactor = differential.den // power
    numerator = differential.num * (cofactor.xgcd(power)[1] % power) % power
    part = field.quotient(numerator, power)
    return _trace_to_prime(field, _coefficient_of_inverse(field, part))


def _coefficient_of_inverse(field: FunctionField, x: RationalFunction) -> Coefficient:
    """Return the coefficient of 1/t in the expansion at infinity: the sum of all finite residues."""
    rest = x.num % x.den
    return field.base(rest[int(x.den.degree()) - 1]) if rest != 0 else field.base.zero


def _trace_to_prime(field: FunctionField, x: Scalar) -> int:
    """Return the trace from k = GF(2ⁿ) to GF(2)."""
    assert field.base.order is not None
    total = x
    for _ in range(field.base.order.bit_length() - 2):
        x = x * x
        total = total + x
    return 0 if field.base.is_zero(total) else 1


def ramified_places_functions(field: FunctionField, form: NormalForm) -> tuple[FunctionPlace, ...]:
    """Return the places of k(t) with a nontrivial residue, by degree, infinity last.

    For finite k these are the ramified places. Over ℚ the algebra may also involve a constant division
    algebra, which the residues do not show.
    """
    candidates = _poles_and_zeros(field, *form.constants)
    return tuple(v for v in candidates if symbol(field, form, v) < 0)


def same_residues(field: FunctionField, form: NormalForm, other: NormalForm) -> bool:
    """Return whether two algebras of characteristic not 2 have the same residues at all places."""
    for v in _poles_and_zeros(field, *form.constants, *other.constants):
        kappa, x = tame_residue(form.a, form.b, v)
        _, y = tame_residue(other.a, other.b, v)
        if not kappa.is_square(kappa.multiply(x, y)):
            return False
    return True


def same_class_rational_functions(
    field: FunctionField, form: NormalForm, other: NormalForm
) -> bool:
    """Return whether two algebras over ℚ(x) are isomorphic, by their residues and then by a value."""
    return same_residues(field, form, other) and _same_at_a_point(field, form, other)


def _same_at_a_point(field: FunctionField, form: NormalForm, other: NormalForm) -> bool:
    """Compare two algebras over ℚ(x) with equal residues, at a point at which both are unramified.

    Their difference in the Brauer group comes from ℚ (Faddeev), so its value at one point decides.
    """
    values = [*form.constants, *other.constants]
    for n in itertools.count():
        point = field.base((n + 1) // 2 * (-1) ** n)
        if all(x.den(point) != 0 and x.num(point) != 0 for x in values):
            a, b, p, q = (fraction(_at(x, point)) for x in values)
            return ramified_places_q(a, b) == ramified_places_q(p, q)
    raise AssertionError("all but finitely many points are good")


def _at(x: RationalFunction, point: flint.fmpq) -> flint.fmpq:
    return x.num(point) / x.den(point)
