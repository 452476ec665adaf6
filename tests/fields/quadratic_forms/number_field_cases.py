"""What tests of number fields share: the vectors, and PARI's prime ideals and places among ours."""

import json
from functools import cache
from pathlib import Path
from typing import Any

from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.ring import NumberField

VECTORS = Path(__file__).parents[2] / "vectors"


def cases(name: str) -> list[dict[str, Any]]:
    return json.loads((VECTORS / f"{name}.json").read_text(encoding="utf-8"))["cases"]


@cache
def field(polynomial: str) -> NumberField:
    return NumberField(polynomial, "x")


def prime(K: NumberField, p: int, generator: str) -> PrimeIdeal:
    """The only prime ideal above p that contains a second generator."""
    (P,) = (P for P in K.primes_above(p) if K(generator) in P)
    return P
