"""The places of k(t): monic irreducible polynomials and infinity, listed and read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import flint

from hfield.errors import HFieldError, RingError, UndecidedError, shorten
from hfield.fields.rationals.places import INFINITE_NAMES

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Coefficient, Polynomial
    from hfield.fields.function_fields.ring import FunctionField


@dataclass(frozen=True)
class FunctionPlace:
    """A place of k(t): a monic irreducible polynomial, or infinity (``poly`` is None).

    Its text is the polynomial, or ``"inf"``; :func:`place_of_functions` reads it back.
    """

    field: FunctionField
    poly: Polynomial | None = None

    def __str__(self) -> str:
        if self.poly is None:
            return "inf"
        return self.field.text(self.field.quotient(self.poly, self.field.one.num))

    def __repr__(self) -> str:
        return str(self)

    def __hash__(self) -> int:
        return hash((self.field.name, str(self)))

    @property
    def data(self) -> dict[str, object]:
        """The place as JSON data; coefficients low degree first, integers or lists of them."""
        if self.poly is None:
            return {"kind": "infinity"}
        return {"kind": "prime polynomial", "coefficients": [_json(c) for c in self.poly.coeffs()]}

    def norm(self) -> int:
        """Return the order of the residue field. Raises :class:`UndecidedError` if it is infinite."""
        q = self.field.base.order
        if q is None:
            raise UndecidedError(f"the residue field at {self} is infinite")
        return int(q**self.degree)

    @property
    def degree(self) -> int:
        """The degree of the residue field over k."""
        return 1 if self.poly is None else int(self.poly.degree())


def _json(c: Coefficient) -> object:
    """Return a coefficient as JSON data: an integer, a list of integers over GF(pⁿ), else a text."""
    if isinstance(c, flint.fq_default):
        digits = c.to_list()
        return [int(x) for x in digits] if len(digits) > 1 else int(digits[0])
    return int(c) if isinstance(c, (flint.nmod, flint.fmpz_mod)) else str(c)


def place_of_functions(field: FunctionField, place: object) -> FunctionPlace:
    """Read a place: a :class:`FunctionPlace`, an irreducible polynomial of the field, or its text."""
    if isinstance(place, FunctionPlace) and place.field == field:
        return place
    if isinstance(place, str) and place.strip().lower() in INFINITE_NAMES:
        return FunctionPlace(field)
    try:
        x = field(place)
    except HFieldError:
        x = field.zero
    if x.num != 0 and field.is_one(x.den) and x.num.degree() > 0:
        factors = x.num.factor()[1]
        if len(factors) == 1 and factors[0][1] == 1:
            return FunctionPlace(field, field.quotient(field.one.num, x.num).den)
    raise RingError(
        f'{shorten(place)} is not a place of {field}: expected an irreducible polynomial or "inf"'
    )


def prime_divisors(field: FunctionField, polynomials: Iterable[Polynomial]) -> list[FunctionPlace]:
    """Return the distinct monic irreducible factors of some polynomials."""
    factors = (p for poly in polynomials for p, _ in poly.factor()[1])
    monic = (field.quotient(field.one.num, p).den for p in factors)
    return list(dict.fromkeys(FunctionPlace(field, p) for p in monic))


def all_places(field: FunctionField) -> Iterator[FunctionPlace]:
    """Yield the places of k(t), k finite: infinity, then irreducible polynomials by degree."""
    if field.base.order is None:
        raise UndecidedError(
            f"the places of {field} are not listed; its elements name those that matter"
        )
    yield FunctionPlace(field)
    one, t = field.one.num, field.gen.num
    digits = [field.constant(x).num for x in field.base.elements()]
    layer = [one]
    while True:
        layer = [p * t + d for p in layer for d in digits]
        for p in layer:
            factors = p.factor()[1]
            if len(factors) == 1 and factors[0][1] == 1:
                yield FunctionPlace(field, p)
