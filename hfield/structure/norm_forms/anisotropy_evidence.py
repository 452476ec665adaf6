"""Why a norm form is 0 only at 0, as evidence that the checker of certificates accepts."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from typing import Any

from hfield.certificates.anisotropy import is_certified
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.structure.global_field import global_field
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm

Evidence = Mapping[str, Any]


def norm_evidence(algebra: str, ring: Ring, c: Constants, answer: ZeroNorm) -> Evidence | None:
    """Return the evidence for an answer without element, or None where there is none that is checked."""
    by = ({"by": answer.method},) if answer.method in ("ordering", "level") else ()
    candidates: Iterable[Evidence] = chain(by, evidence_at(ring, c, answer.places))
    return next((data for data in candidates if is_certified(algebra, ring.data, data)), None)


def evidence_at(ring: Ring, c: Constants, places: Iterable[object]) -> Iterator[Evidence]:
    """Yield the evidence at those places where the algebra is ramified and residues are finite."""
    field = global_field(ring)
    return iter(()) if field is None else field.evidence(c, places)
