"""Translate certificates ``hfield-cert/1`` to the current schema.

The checker accepts only the names in a table. ``hfield upgrade`` reads names as liberally as the prover does;
the certificate that it writes is checked without names.
"""

from collections.abc import Callable, Mapping
from functools import cache
from math import isqrt

from hfield.checker.glossary import KEYS, SCHEMA
from hfield.checker.rejection import a_text, an_object, reject, shown
from hfield.checker.scalars.conway import CONWAY
from hfield.checker.vocabulary.logic import names_of_rings

FIRST_SCHEMA = "hfield-cert/1"
MAX_DEPTH = 120
HINT = "`hfield upgrade` writes it as data"

ReadName = Callable[[str], Mapping[str, object]]
ReadPlace = Callable[[str, Mapping[str, object] | None], Mapping[str, object]]


def current(data: object) -> object:
    """Convert a certificate of the first schema to the current one; return anything else unchanged."""
    if isinstance(data, dict) and data.get("schema") == FIRST_SCHEMA:
        return upgraded(data, spelled, spelled_place)
    return data


def upgraded(data: Mapping[str, object], ring: ReadName, place: ReadPlace) -> dict[str, object]:
    """Return the certificate with data for the names of rings and places. Raises :class:`Rejected`."""
    keys = [key for key in KEYS if key != "ring"]
    c = an_object(data, " ".join(keys), "a certificate")
    statement = a_text(c["statement"], "statement")
    own = None if c["field"] is None else ring(a_text(c["field"], "field"))
    evidence = _with_data(c["evidence"], own, ring, place, 0)
    rings = [ring(name) for name in names_of_rings(statement)]
    if rings:
        evidence = {"kind": "rings", "rings": rings, "evidence": evidence}
    return {**c, "schema": SCHEMA, "ring": own, "evidence": evidence}


def _with_data(
    value: object, here: Mapping[str, object] | None, ring: ReadName, place: ReadPlace, depth: int
) -> object:
    """Replace names by data in evidence about a ring."""
    if depth > MAX_DEPTH:
        reject("the evidence nests too deeply")
    if isinstance(value, list):
        return [_with_data(x, here, ring, place, depth + 1) for x in value]
    if not isinstance(value, dict):
        return value
    out = dict(value)
    if "kind" in value and isinstance(value.get("field"), str):
        here = ring(out.pop("field"))
        out["ring"] = here
    if value.get("by") == "place" and isinstance(value.get("place"), str):
        out["place"] = place(value["place"], here)
    if value.get("by") == "specialisation" and here is not None:
        base = here.get("base")
        here = base if isinstance(base, Mapping) else None
    inside = {key: x for key, x in out.items() if isinstance(x, (dict, list))}
    inside = {key: x for key, x in inside.items() if key not in ("ring", "place")}
    return out | {key: _with_data(x, here, ring, place, depth + 1) for key, x in inside.items()}


def spelled(name: str) -> Mapping[str, object]:
    """Return the data of a ring by its name in the table. Raises :class:`Rejected` for other names."""
    if name not in _table():
        reject(f"{shown(name)!r} is no name that is read in a certificate {FIRST_SCHEMA}; {HINT}")
    return _table()[name]


def spelled_place(name: str, ring: Mapping[str, object] | None) -> Mapping[str, object]:
    """Return the data of a place of ℚ, a number. Raises :class:`Rejected` for any other place."""
    if ring != {"kind": "rationals"} or not (name.isascii() and name.isdigit() and len(name) < 20):
        reject(f"{shown(name)!r} is no place that is read in a certificate {FIRST_SCHEMA}; {HINT}")
    return {"kind": "number", "n": int(name)}


@cache
def _table() -> Mapping[str, Mapping[str, object]]:
    """ℚ, ℤ, ℝ, ℂ, floats; ℤ/n, n ≤ 100; GF(q) and GF(q)(t), q ≤ 256; ℚ(x), ℚ(t); ℚ(√d), |d| ≤ 100."""
    found: dict[str, Mapping[str, object]] = {
        "QQ": {"kind": "rationals"},
        "ZZ": {"kind": "integers"},
        "RR": {"kind": "reals"},
        "CC": {"kind": "complexes"},
        "RDF": {"kind": "floats"},
        "QQ(I)": {"kind": "quadratic field", "d": -1},
    }
    found |= {f"ZZ/{n}": {"kind": "residues", "modulus": n} for n in range(2, 101)}
    for q in range(2, 257):
        p = next(d for d in range(2, q + 1) if q % d == 0)
        n = next(n for n in range(1, 9) if p**n >= q)
        if p**n == q:
            modulus = [int(c) for c in CONWAY[q].split()] if n > 1 else None
            field = {"kind": "finite field", "characteristic": p, "degree": n, "modulus": modulus}
            found[f"GF({q})"] = field
    for name in [name for name in found if name == "QQ" or name[0] == "G"]:
        for variable in ("x", "t") if name == "QQ" else ("t",):
            functions = {"base": found[name], "variables": [variable]}
            found[f"{name}({variable})"] = {"kind": "rational functions", **functions}
    for d in range(-100, 101):
        squares = (n * n for n in range(2, isqrt(abs(d)) + 1))
        if d not in (-1, 0, 1) and all(d % n for n in squares):
            found[f"QQ(sqrt({d}))"] = {"kind": "quadratic field", "d": d}
    return found
