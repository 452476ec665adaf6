"""Where a claim over an infinite ring is false: at small values, or at those that its own evidence gives.

Random samples miss the zeros of q[0]² + q[1]² over ℚ(i); these are among the values tried here.
"""

import random
from collections.abc import Iterator
from itertools import islice, product
from typing import Any

import mpmath

from tests.adversary.falsify import Widths, assigned, one_place, true_at, width
from tests.adversary.forging.targets import Certificate
from tests.adversary.grammar import read
from tests.adversary.meaning import Claim, read_claim
from tests.adversary.ring_names import name_of
from tests.adversary.scalars import Exact, Integers, Numbers, Quotients, named, value_of
from tests.adversary.small_rings import Table

TRIED = 700
NEVER = ("!=", ("number", 0), ("number", 0))
SHOWN_BY_VALUES = (
    *("witness", "subfield", "terms", "cases", "real root", "complex root", "quaternion root"),
    "exhaustion",
)
ROOTS = {"RR": ("2",), "CC": ("-1", "2")}


def small(scalars: Exact) -> list[Any]:
    """Return 0, ±1, ±2, a half, and what generates the ring, with both signs."""
    found = [scalars.number(n) for n in (0, 1, -1)]
    if isinstance(scalars, Numbers):
        for text in ROOTS.get(scalars.name) or scalars.roots or ():
            root = mpmath.mpc(mpmath.sqrt(-1 if text == "I" else int(text)))
            found += [root, -root]
    if isinstance(scalars, Quotients):
        found += [(scalars.x, scalars.unit), scalars.neg((scalars.x, scalars.unit))]
    found += [scalars.number(2), scalars.number(-2)]
    return (
        found if isinstance(scalars, Integers) else [*found, scalars.inverse(scalars.number(2))[0]]
    )


def places(unknowns: Widths, scalars: Exact) -> Iterator[dict[str, Any]]:
    """Run through small values of all unknowns: all, or as many drawn as are tried."""
    values, count = small(scalars), width(unknowns)
    least, rng = values[:5], random.Random(1)
    rows: Any = ([rng.choice(least) for _ in range(count)] for _ in range(TRIED))
    if len(least) ** count <= TRIED:
        rows = product(values if len(values) ** count <= TRIED else least, repeat=count)
    for row in rows:
        yield assigned(unknowns, row)


def every_place(table: Table, unknowns: Widths) -> Iterator[dict[str, Any]]:
    """Run through all values in a finite ring, or as many as are tried."""
    for row in islice(product(range(table.order), repeat=width(unknowns)), 4 * TRIED):
        yield assigned(unknowns, row)


def witness(evidence: Any) -> dict[str, Any] | None:
    """Return what evidence gives to show its claim over a field by, as the judge reads it."""
    kind = evidence.get("kind") if isinstance(evidence, dict) else None
    if kind == "witness":
        return {"F": [name_of(evidence["ring"])], **evidence["values"]}
    if kind == "terms":
        return {name: [text] for name, text in evidence["terms"].items()}
    return None


def seen_false(data: Certificate) -> str:
    """Return why a claim is false, by small values or those of the evidence; '' where nothing says so."""
    where, verdict, evidence = data["field"], data["verdict"], data["evidence"]
    kind = evidence.get("kind") if isinstance(evidence, dict) else None
    here = None if where is None else named(where)
    claim = read_claim(data["statement"], data["algebra"], _constants(here))
    if verdict == "refuted" and claim.bound:
        return _something_exists(claim, here, evidence, where is None)
    needs = verdict == "refuted" or (verdict == "proved" and claim.bound and not claim.given)
    if needs and kind not in SHOWN_BY_VALUES:
        return f"{verdict}, and no values that show it"
    if not isinstance(here, Exact) or needs or (claim.bound and verdict == "proved"):
        return ""
    if verdict == "vacuous":
        claim = Claim(claim.hypotheses, NEVER, (*claim.given, *claim.bound), (), claim.constants)
    for values in places(claim.given, here):
        if true_at(claim, here, values) is False:
            return f"{verdict} over {where}, but not at {values}"
    return ""


def _constants(ring: Any) -> Any:
    return one_place(ring) if isinstance(ring, Table) else ring


def _something_exists(claim: Claim, here: Any, evidence: Any, anywhere: bool) -> str:
    """Return what exists all the same, where the evidence says that nothing does."""
    evidence = evidence if isinstance(evidence, dict) else {}
    if anywhere:
        here = named(name_of(evidence.get("ring")))
    scalars = _constants(here)
    if scalars is None:
        return f"nothing is known of the field {evidence.get('ring')}" if anywhere else ""
    if any(scalars.constant(("name", name)) is not None for name, _ in claim.bound):
        return "what 'exists' binds has a value in that field"
    given: dict[str, Any] = {}
    for name, texts in evidence.get("values", {}).items():
        values = [value_of(read(text), scalars) for text in texts]
        given[name] = values[0] if len(values) == 1 else tuple(values)
    if claim.given and set(given) != {name for name, _ in claim.given}:
        return "refuted, and no values that show it"
    if isinstance(here, Table):
        rows: Any = every_place(here, claim.bound)
    else:
        rows = places(claim.bound, here)
    for values in rows:
        truth = true_at(claim, scalars, given | values)
        if truth is not False:
            return f"refuted, but {truth} at {given | values}"
    return ""
