"""Places, Hilbert symbols and ramification, over every field that has them here."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from hfield.errors import RingError, UndecidedError, shorten
from hfield.factorisation import Factors, factorise, is_prime, known_primes
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField, Quotient
from hfield.rings.integers import QQ
from hfield.rings.quadratic import QuadraticField
from hfield.rings.surds import Surd
from hfield.structure.forms import NormalForm, discriminant, normal_form
from hfield.structure.function_fields import hilbert_functions
from hfield.structure.quadratic_fields import hilbert_quadratic
from hfield.structure.rationals.hilbert_rationals import (
    INFINITE,
    discriminant_q,
    hilbert_symbol_q,
    place_of_q,
    ramified_places_q,
)
from hfield.structure.rationals.whole_numbers import fraction


def hilbert_symbol(a: Any, b: Any, place: Any, factors: Factors | None = None) -> int:
    """Return the Hilbert symbol ``(a, b)`` at a place: 1 if ``(a, b | F)`` splits there, else −1.

    Over ℚ, a and b are nonzero ints, Fractions, elements of QQ or their texts, and the place is a
    prime or ``"inf"``. Over a quadratic field or GF(q)(t) they are its elements, and the place is one of the
    field's or its text. In characteristic 2 the symbol is that of [a, b | F), where a may be 0. ``factors``
    may name primes of the norms of a and b, which a quadratic field needs at a lone place above 2.

    Raises :class:`RingError` for a 0 and for a place that is none, and :class:`UndecidedError` over
    QQ(x), whose completions are not local fields.

    >>> hilbert_symbol(-1, -1, 2), hilbert_symbol(-1, -1, 3), hilbert_symbol(-1, -1, "inf")
    (-1, 1, -1)
    """
    field = _field_of(a, b, place)
    if field is None:
        a, b = (QQ(x) if isinstance(x, str) else x for x in (a, b))
    if isinstance(field, FunctionField):
        return _symbol_functions(field, field(a), field(b), place)
    if isinstance(field, QuadraticField):
        x, y = pair(field, field(a)), pair(field, field(b))
        with known_primes(factors):
            return hilbert_quadratic.hilbert_symbol_quadratic(field.d, x, y, place)
    return hilbert_symbol_q(a, b, place)


def _field_of(a: Any, b: Any, place: Any) -> Ring | None:
    """Return the field that the arguments of a symbol belong to; None for ℚ."""
    if isinstance(place, hilbert_quadratic.QuadraticPlace):
        return QuadraticField(place.d)
    if isinstance(place, hilbert_functions.FunctionPlace):
        return place.field
    for x in (a, b):
        if isinstance(x, Quotient):
            return x.field  # type: ignore[no-any-return,attr-defined,unused-ignore]
    roots = {n for x in (a, b) if isinstance(x, Surd) for n in x.terms if n != 1}
    if len(roots) > 1:
        raise RingError(f"{shorten(a)} and {shorten(b)} lie in no common quadratic field")
    if not roots:
        return None
    d = roots.pop()
    factorise(d)  # the theory of places asks for a squarefree d
    return QuadraticField(d)


def _symbol_functions(field: FunctionField, a: Any, b: Any, place: Any) -> int:
    even = field.characteristic == 2
    if field.is_zero(b) or (field.is_zero(a) and not even):
        raise RingError(
            "a Hilbert symbol is defined for nonzero elements only, and one of these is 0"
        )
    v = hilbert_functions.place_of_functions(field, place)
    if field.base.order is None:
        raise UndecidedError(
            f"the completions of {field} are not local fields: the residue alone does not decide there"
        )
    form = normal_form(field, Constants(a, field.one if even else field.zero, b))
    return hilbert_functions.symbol(field, form, v)


def places(ring: Ring) -> Iterator[Any]:
    """Run through the places of a global field, without end: infinite ones, then by size.

    Raises :class:`UndecidedError` for a ring that has no such list.
    """
    if isinstance(ring, QuadraticField):
        return hilbert_quadratic.all_places(ring.d)
    if isinstance(ring, FunctionField):
        return hilbert_functions.all_places(ring)
    if ring.name == "QQ":
        return _places_of_q()
    raise UndecidedError(f"{ring.name} is not a global field: its places are not listed")


def _places_of_q() -> Iterator[Any]:
    yield INFINITE
    p = 1
    while True:
        p += 1
        if is_prime(p):
            yield p


def place(ring: Ring, text: Any) -> Any:
    """Read a place of a global field, as its text or as it is. Raises :class:`RingError`."""
    if isinstance(ring, QuadraticField):
        return hilbert_quadratic.place_of_quadratic(ring.d, text)
    if isinstance(ring, FunctionField):
        return hilbert_functions.place_of_functions(ring, text)
    if ring.name == "QQ":
        return place_of_q(text)
    raise RingError(f"{ring.name} is not a global field: it has no places here")


def pair(ring: QuadraticField, x: Any) -> tuple[Fraction, Fraction]:
    """Return the coordinates of u + v√d."""
    terms = ring(x).terms
    return fraction(terms.get(1, 0)), fraction(terms.get(ring.d, 0))


def ramification(ring: Ring, form: NormalForm) -> tuple[Any, ...] | None:
    """Return the ramified places of a nondegenerate normal form; None where there is no theory.

    Over ℚ(x) these are the places with a residue; without any, the algebra is constant.
    """
    if isinstance(ring, FunctionField):
        return hilbert_functions.ramified_places_functions(ring, form)
    if isinstance(ring, QuadraticField):
        a, b = (pair(ring, x) for x in form.constants)
        return hilbert_quadratic.ramified_places_quadratic(ring.d, a, b)
    if ring.name == "QQ":
        return ramified_places_q(form.a, form.b)
    return None


def ramified_places(ring: Ring, c: Constants, factors: Factors | None = None) -> tuple[Any, ...]:
    """Return the places where the algebra does not split: primes ascending, infinite ones last.

    ``factors`` may name primes of a and b (over ℚ) or of their norms. A finite field has no places, so
    the answer is (). Raises :class:`RingError` for a degenerate algebra, and
    :class:`UndecidedError` over a ring without a theory of places.
    """
    if ring.name == "QQ" and c.a and c.b and not c.t:  # already normal: the short way, for surveys
        with known_primes(factors):
            return ramified_places_q(c.a, c.b)
    if not ring.is_field:
        raise UndecidedError(f"{ring.name} is not a field: ask over its field of fractions")
    if ring.is_zero(discriminant(c)):
        raise RingError(
            "a degenerate algebra, (t² + 4a)·b = 0, has no ramified places: it is not simple"
        )
    if ring.order is not None:
        return ()
    with known_primes(factors):
        found = ramification(ring, normal_form(ring, c))
    if found is None:
        raise UndecidedError(f"{ring.name} has no theory of places here")
    return found


def reduced_discriminant(ring: Ring, c: Constants, factors: Factors | None = None) -> Any:
    """Return the product of the finite ramified places: an int over ℚ, a polynomial over k(t).

    Over a quadratic field, where it is an ideal, the tuple of its prime ideals. Raises as
    :func:`ramified_places` does.
    """
    found = ramified_places(ring, c, factors)
    if isinstance(ring, FunctionField):
        product = ring.one
        for v in found:
            if v.poly is not None:
                product = product * ring.quotient(v.poly, ring.one.num)
        return product
    if isinstance(ring, QuadraticField):
        return tuple(v for v in found if v.prime)
    return discriminant_q(found)
