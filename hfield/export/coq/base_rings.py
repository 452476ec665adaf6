"""The base ring of a theorem: all commutative rings, all fields, or one ring."""

import re
from dataclasses import dataclass
from fractions import Fraction

from hfield.errors import HFieldError, shorten
from hfield.export.coq.terms import NotCoveredError
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring

MAX_PRIME = 300  # of fields in which Coq computes; above it, any field of the characteristic
MAX_MODULUS = 5_000  # of a ring whose elements are listed
MAX_RESIDUE_BITS = 400


@dataclass(frozen=True)
class BaseRing:
    """A ring, or all rings of a kind; ``opening`` precedes a statement, ``names`` introduce the ring."""

    opening: str
    type: str
    is_field: bool
    names: str = ""
    characteristic: int = 0

    @property
    def is_one_ring(self) -> bool:
        """Whether this is a single ring; in a single ring Coq can compute."""
        return not self.opening


RINGS = BaseRing("every commutative ring R, ", "R", False, "R operations laws")
FIELDS = BaseRing("every field R, ", "R", True, "R operations inverse laws")
RATIONALS = BaseRing("", "Qc", True)
INTEGERS = BaseRing("", "Z", False)


def of_characteristic(p: int) -> BaseRing:
    """Return all fields of a characteristic."""
    opening = f"every field R, num (R := R) {p} = 0 -> "
    return BaseRing(opening, "R", True, "R operations inverse laws char", p)


def residues(n: int, is_field: bool) -> BaseRing:
    """Return the residues modulo n."""
    return BaseRing("", f"GF {n}", is_field, characteristic=n)


def base_ring_of(field: Ring) -> BaseRing:
    """Return a single ring in Coq's notation. Raises :class:`NotCoveredError`."""
    if field == ring("QQ"):
        return RATIONALS
    if field == ring("ZZ"):
        return INTEGERS
    n = field.characteristic
    if n and field.order == n and n.bit_length() <= MAX_RESIDUE_BITS:
        return residues(n, bool(field.is_field))
    raise NotCoveredError(f"the field {field.name}: Coq has ZZ, QQ, GF(p) and ZZ/n here")


def value_in(base_ring: BaseRing, text: str) -> str:
    """Return an element of a ring from its text in a certificate, in Coq's notation."""
    if not re.fullmatch(r"-?[0-9]{1,1000}(/[1-9][0-9]{0,999})?", text):
        raise NotCoveredError(f"the value {shorten(text)!r}")
    value = Fraction(text)
    if base_ring is RATIONALS:
        return f"(Q2Qc ({value.numerator} # {value.denominator}))"
    if base_ring is INTEGERS:
        if value.denominator != 1:
            raise HFieldError(f"{text!r} is not an integer")
        return f"({value.numerator})%Z"
    n = base_ring.characteristic
    try:
        return f"(reduce {n} {value.numerator * pow(value.denominator, -1, n) % n})"
    except ValueError as error:
        raise HFieldError(f"{text!r} has no value modulo {n}") from error
