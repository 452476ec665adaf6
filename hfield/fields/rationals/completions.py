"""The completions of ℚ: the p-adic numbers, and RR."""

from __future__ import annotations

from hfield.core.factorisation import factorise
from hfield.errors import RingError, shorten
from hfield.fields.algebraic.ring import RR
from hfield.fields.base.printing import SUBSCRIPTS
from hfield.fields.base.ring import Ring
from hfield.fields.local.field import LocalField
from hfield.fields.rationals.places import INFINITE, place_of_q
from hfield.fields.rationals.residues import PrimePlace


def p_adic_numbers(rationals: Ring, p: str) -> LocalField:
    """Return ℚ_p, given ℚ and the text of a prime p. Raises :class:`RingError`."""
    if not p.isdecimal() or not p.isascii():
        raise RingError(f"Qp({shorten(p)}): expected a prime number, as in Qp(5)")
    number = int(p)
    try:
        place = place_of_q(number)
    except RingError:
        shown = " * ".join(f"{q}^{n}" if n > 1 else f"{q}" for q, n in factorise(number).items())
        why = f"{number} = {shown} is not a prime" if number > 1 else f"{number} is not a prime"
        raise RingError(f"Qp({number}): {why}; expected one, as in Qp(5)") from None
    words = f"the {place}-adic numbers ℚ{str(place).translate(SUBSCRIPTS)}"
    return LocalField(f"Qp({place})", words, rationals, place, PrimePlace(number))


def completion_of_rationals(rationals: Ring, place: object) -> Ring:
    """Return ℚ_p, or RR: the real algebraic numbers satisfy the same first-order statements as the real
    numbers.
    """
    v = place_of_q(place)
    return RR if v == INFINITE else p_adic_numbers(rationals, str(v))
