"""Which ring some data mean, by the package's reader of names and nothing of the checker's."""

import json
from typing import Any

from hfield.errors import HFieldError
from hfield.fields.names import ring
from tests.adversary.grammar import NotRead

PLAIN = {
    "rationals": "QQ",
    "integers": "ZZ",
    "reals": "RR",
    "complexes": "CC",
    "floats": "RDF",
    "complex floats": "CDF",
}


def name_of(data: Any) -> str:
    """Return the name of the ring. Raises :class:`NotRead` for data of none."""
    try:
        found = ring(_written(data))
    except (HFieldError, KeyError, TypeError, ValueError) as error:
        raise NotRead(f"{data} are not the data of a ring: {error}") from error
    if json.dumps(found.data, sort_keys=True) != json.dumps(data, sort_keys=True):  # 2.0 is not 2
        raise NotRead(f"{data} are not those of {found.name}")
    return found.name


def _written(data: Any) -> str:
    """Write a name that the package reads."""
    kind = data["kind"]
    if kind in PLAIN:
        return PLAIN[kind]
    if kind == "residues":
        return f"ZZ/{data['modulus']}"
    if kind == "quadratic field":
        return f"QQ(sqrt({data['d']}))"
    if kind == "finite field":
        modulus = data["modulus"] or ()
        shape = "+".join(f"{c}*x^{n}" for n, c in enumerate(modulus))
        return f"GF({data['characteristic'] ** data['degree']}{', ' * bool(shape)}{shape})"
    brackets = {"rational functions": "()", "polynomials": "[]"}[kind]
    return _written(data["base"]) + ",".join(data["variables"]).join(brackets)
