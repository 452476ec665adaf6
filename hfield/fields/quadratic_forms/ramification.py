"""Places, Hilbert symbols and ramification over global fields."""

from collections.abc import Hashable, Iterator

from hfield.core.factorisation import Factors, known_primes
from hfield.core.product import Constants, Scalar
from hfield.errors import RingError, UndecidedError
from hfield.fields.base.ring import Ring, WithPlaces
from hfield.fields.quadratic_forms.global_field import field_named_by, global_field, known_field
from hfield.fields.quadratic_forms.normal_forms import discriminant, normal_form
from hfield.fields.rationals.ring import QQ


def hilbert_symbol(
    a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None = None
) -> int:
    """Return the Hilbert symbol ``(a, b)`` at a place: 1 if ``(a, b | F)`` splits there, else −1.

    Over ℚ, a and b are nonzero ints, Fractions, elements of QQ or their texts, and the place is a prime or
    ``"inf"``. Over a number field or GF(q)(t), a and b are elements of the field, and the place is one of the
    field's places or its text. In characteristic 2 the symbol is that of [a, b | F), where a may be 0.
    ``factors`` may contain primes of the norms of a and b, which are needed over a quadratic field with only
    one place above 2.

    A local field has only one place; there the place may also be None.

    Raises :class:`RingError` for a 0 and for an invalid place, and :class:`UndecidedError` over QQ(x), whose
    completions are not local fields.

    >>> hilbert_symbol(-1, -1, 2), hilbert_symbol(-1, -1, 3), hilbert_symbol(-1, -1, "inf")
    (-1, 1, -1)
    """
    field = field_named_by(a, b, place) or QQ
    return known_field(field).hilbert_symbol(a, b, place, factors)


def places(ring: WithPlaces) -> Iterator[Hashable]:
    """Yield the places of a global field without end: infinite ones first, then by size.

    Raises :class:`UndecidedError` for a ring without such a list.

    >>> from itertools import islice
    >>> from hfield import QQ
    >>> list(islice(places(QQ), 4))
    ['inf', 2, 3, 5]
    """
    return ring.places()


def place(ring: Ring, text: object) -> Hashable:
    """Return a place of a global field, given by its text or as an object. Raises :class:`RingError`."""
    field = global_field(ring)
    if field is None:
        raise RingError(f"{ring.name} is not a global field: it has no places here")
    return field.read_place(text)


def ramified_places(
    ring: Ring, c: Constants, factors: Factors | None = None
) -> tuple[Hashable, ...]:
    """Return the places at which the algebra does not split: primes in ascending order, infinite places last.

    ``factors`` may contain primes of a and b (over ℚ) or of their norms. A finite field has no places, so the
    result is (). Raises :class:`RingError` for a degenerate algebra, and :class:`UndecidedError` over a ring
    without a theory of places.
    """
    if not ring.is_field:
        raise UndecidedError(f"{ring.no_field}: use its field of fractions")
    if ring.is_zero(discriminant(ring, c)):
        raise RingError(
            "a degenerate algebra, (t² + 4a)·b = 0, has no ramified places: it is not simple"
        )
    if ring.order is not None:
        return ()
    with known_primes(factors):
        return known_field(ring).ramified(normal_form(ring, c))


def reduced_discriminant(ring: Ring, c: Constants, factors: Factors | None = None) -> object:
    """Return the product of the finite ramified places: an int over ℚ, a polynomial over k(t).

    Over a quadratic field, where it is an ideal, it is the tuple of its prime ideals. Raises errors as
    :func:`ramified_places` does.
    """
    found = ramified_places(ring, c, factors)
    field = global_field(ring)
    return 1 if field is None else field.discriminant(found)
