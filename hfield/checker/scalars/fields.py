"""Build rings from their data, each kind with the module that implements it."""

import json

from hfield.checker.budget import Remembered
from hfield.checker.rejection import a_text, keyed, reject, shown
from hfield.checker.scalars import (
    circles,
    completions,
    finite,
    functions,
    number_fields,
    polynomials,
    quadratic,
    quotient_rings,
    rationals,
    surds,
)
from hfield.checker.scalars.ring import AnyRing, Kind

MAX_DATA = 20_000
KINDS: dict[str, Kind] = {
    **rationals.KINDS,
    **finite.KINDS,
    **surds.KINDS,
    **quadratic.KINDS,
    **number_fields.KINDS,
    **functions.KINDS,
    **circles.KINDS,
    **polynomials.KINDS,
    **completions.KINDS,
    **quotient_rings.KINDS,
}


def read_ring(data: object) -> AnyRing:
    """Return the ring of some data."""
    try:
        text = json.dumps(data, sort_keys=True)
    except (TypeError, ValueError):
        reject("the data of a ring are no JSON data, or a number in them is too long")
    if len(text) > MAX_DATA:
        reject(f"the data of a ring have {len(text)} characters; at most {MAX_DATA} are read")
    return _read(text)


@Remembered
def _read(text: str) -> AnyRing:
    data = keyed(json.loads(text), "the data of a ring")
    kind = a_text(data.get("kind"), "the kind of a ring")
    make = KINDS.get(kind)
    if make is None:
        reject(f"rings of the kind {shown(kind)!r} are not known here")
    return make(data, read_ring)
