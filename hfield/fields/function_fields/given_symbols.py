"""Algebras over GF(q)(t), q odd or even, that ramify exactly at given places.

Let D be the product of the polynomials among the places. For odd q the algebra is (a, b) with b = D or ε·D
for a constant ε that is not a square. If all these polynomials have odd degree, a = ε works. Otherwise a =
c·ℓ for a constant c and an irreducible ℓ of odd degree that is not a square modulo any factor of D. Outside ℓ
and infinity all symbols are then right, and at ℓ and infinity they are right for one of the two b.
Dirichlet's theorem provides ℓ; the rest follows from reciprocity. In characteristic 2 the algebra is [a, D)
with a polynomial a of trace 1 modulo every factor of D.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import count, islice
from typing import TYPE_CHECKING

from hfield.core.product import Constants
from hfield.errors import RingError, UndecidedError, shorten
from hfield.fields.finite.ring import FiniteField
from hfield.fields.function_fields.places import place_of_functions
from hfield.fields.function_fields.residues import residues_at
from hfield.fields.function_fields.symbols import ramified_places_functions
from hfield.fields.quadratic_forms.normal_forms import normal_form

if TYPE_CHECKING:
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.function_fields.ring import FunctionField

TRIALS = 100_000
"""The largest number of constants that are tried."""


def from_ramification_functions(
    field: FunctionField, named: Sequence[object]
) -> tuple[RationalFunction, RationalFunction, RationalFunction]:
    """Return (a, b, t) of an algebra that ramifies exactly at the given places; t = 1 in characteristic 2.

    Raises :class:`RingError` unless they are distinct and even in number, and :class:`UndecidedError` if no
    constants were found.
    """
    places = [place_of_functions(field, v) for v in named]
    if len(set(places)) < len(places):
        raise RingError("the same place was named twice among the ramified places")
    if len(places) % 2:
        raise RingError(
            f"an algebra over {shorten(field.name)} ramifies at an even number of places, and {len(places)} "
            'were named: add or drop one, such as "inf"'
        )
    even = field.characteristic == 2
    t = field.one if even else field.zero
    if not places:
        return (field.zero if even else field.one), field.one, t
    finite = [v for v in places if v.poly is not None]
    D = field.product_of(v.poly for v in finite)
    residues = [residues_at(v) for v in finite]
    wanted = set(places)
    for a in islice(_candidates(field), TRIALS):
        if even:
            fits = all(at.artin_schreier(at.reduce(a)) is None for at in residues)
        else:
            fits = not any(at.is_square(at.reduce(a)) for at in residues)
        if not fits:
            continue
        for b in (D,) if even else (D, D * _nonsquare(field)):
            form = normal_form(field, Constants(a, t, b))
            if set(ramified_places_functions(field, form)) == wanted:
                return a, b, t
    raise UndecidedError(
        f"no constants were found among {TRIALS} for an algebra over {shorten(field.name)} that ramifies at "
        f"{shorten(', '.join(map(str, places)))}"
    )


def _nonsquare(field: FunctionField) -> RationalFunction:
    """Return a constant that is not a square; q is odd."""
    k = field.base
    return field.constant(next(c for c in k.elements() if k.sqrt(c) is None))


def _candidates(field: FunctionField) -> Iterator[RationalFunction]:
    """Yield some constants, at least one of which works if any constant does, and all polynomials
    by degree.
    """
    k = field.base
    assert isinstance(k, FiniteField)
    if field.characteristic == 2:  # one element of a basis over GF(2) has trace 1
        yield from (field.constant(k.from_label(2**n)) for n in range(k.degree))
    else:
        yield _nonsquare(field)
    for number in count(k.order):  # its digits are labels of coefficients
        polynomial, power = field.zero, field.one
        while number:
            number, label = divmod(number, k.order)
            polynomial = polynomial + power * field.constant(k.from_label(label))
            power = power * field.gen
        yield polynomial
