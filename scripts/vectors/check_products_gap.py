"""Recompute products.json in GAP: python3 scripts/vectors/check_products_gap.py

Needs the Debian package gap-core. Two routes, neither of them that of make_products.py:
matrices: i and j as 4x4 block matrices over the ring, every case;
built in: GAP's own QuaternionAlgebra(F, a, b), where t = 0 and F is a finite or number field.
"""

import re
from collections.abc import Mapping
from typing import Any

from common import HERE, read_cases, run_gap
from rings import RINGS, Ring

UNITS = {  # when a determinant (the norm's square) makes a matrix invertible
    "integers": "AbsInt(d) = 1",
    "polynomials": "d = one or d = -one",
    "residues": "IsUnit(DefaultRing(one), d)",
}


def gap_text(text: str, ring: Ring) -> str:
    """Return the text for GAP: integers times one, but not exponents."""
    text = text.replace(ring.root, "s") if ring.root else text
    return "(" + re.sub(r"(?<![\^\d])\d+", r"(\g<0>*one)", text) + ")"


def call(case: Mapping[str, Any], ring: Ring) -> str:
    def text(name: str) -> str:
        value = case[name]
        if value is None:
            return "fail"
        if isinstance(value, str):
            return gap_text(value, ring)
        return "[" + ",".join(gap_text(x, ring) for x in value) + "]"

    names = ("a", "b", "t", "p", "q", "product", "norm_p", "trace_p", "conj_p", "inverse_p")
    return f"Check({','.join(text(name) for name in names)});"


def check(ring: Ring, cases: list[dict[str, Any]]) -> tuple[int, int, int]:
    """Return how many cases agreed by matrices, by the built-in algebra, and how many it had."""
    library = (HERE / "quat.g").read_text(encoding="utf-8")
    unit = UNITS.get(ring.kind, "d <> 0*one")
    field = "fail"
    if ring.kind == "finite":
        field = f"Field([one,{'x' if ring.modulus else 'one'}])"
    elif ring.kind == "number":
        field = "Field([s])" if ring.root else "Rationals"
    setup = f"IsUnitDet := d -> {unit};\nF := {field};"
    lines = run_gap("\n".join([library, ring.gap, setup, *(call(c, ring) for c in cases)]))
    if len(lines) != len(cases):
        raise RuntimeError("\n".join(lines[:20]))
    for case, line in zip(cases, lines, strict=True):
        if "false" in line:
            print("DISAGREES", line, case)
    first, second = zip(*(line.split() for line in lines), strict=True)
    return first.count("true"), second.count("true"), len(lines) - second.count("none")


if __name__ == "__main__":
    everything = read_cases("products.json")
    total = [0, 0, 0, 0]
    for ring in RINGS:
        cases = [case for case in everything if case["ring"] == ring.name]
        row = (len(cases), *check(ring, cases))
        total = [x + y for x, y in zip(total, row, strict=True)]
        print("{}: of {} cases, matrices agree in {}; built in {} of {}".format(ring.name, *row))
    print("all: of {} cases, matrices agree in {}; built in {} of {}".format(*total))
