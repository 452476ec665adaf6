"""Over ℚ_p: numbers that are known exactly, in subfields ℚ(√d) of ℚ_p.

A zero of a norm, or a root, that Hensel's lemma finds is known to some digits only, and no statement is
evaluated at it. But it lies in a quadratic extension of ℚ whose root Hensel's lemma finds in ℚ_p: there it is
exact. What is false somewhere in a subfield is false over ℚ_p, and what exists in a subfield exists.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from hfield.errors import HFieldError
from hfield.product import Constants, conjugate, multiply, norm, trace
from hfield.proving.decision import PROVED, REFUTED, Decision
from hfield.proving.problem import Problem
from hfield.rings import QQ, ring
from hfield.rings.base import Ring
from hfield.rings.local.field import LocalField
from hfield.rings.local.roots import square_root
from hfield.rings.radicands import reduced
from hfield.structure.forms import normal_form
from hfield.structure.global_field import known_field

Evidence = Mapping[str, Any]
NEAR = 6  # digits of a root
FIELDS, SECONDS = 3, 5.0  # so many subfields are tried, for so long each
SMALL = (-1, 2, -2, 3, -3, 5, -5, 6, -6, 7, -7, 10, -11, 17)


def decide_in_subfields(problem: Problem, decide: Callable[[Problem], Decision]) -> Decision | None:
    """Return what is decided over some ℚ(√d) in ℚ_p and carries over, or None."""
    F, statement = problem.field, problem.statement
    if not isinstance(F, LocalField) or F.global_field != QQ or problem.setting.letters:
        return None
    bound = set(statement.exists)
    if bound and any(name not in bound for name, _ in statement.unknowns):
        return None
    wanted = PROVED if bound else REFUTED
    for d in _radicands(F, problem):
        K: Ring = ring(f"QQ(sqrt({d}))")
        try:
            decision = decide(problem.within(SECONDS).over(K))
        except HFieldError:
            continue
        if decision.verdict == wanted:
            root = F.sqrt(F(d))
            step = f"{K} lies in {F}, where {d} is the square of {root} (Hensel's lemma)"
            return replace(
                decision,
                witness={
                    name: _read_back(texts) for name, texts in (decision.witness or {}).items()
                },
                steps=(step, *decision.steps),
                scope=None,
                evidence=_evidence(F, K, d, decision),
            )
    return None


def _evidence(F: LocalField, K: Ring, d: int, decision: Decision) -> Evidence | None:
    """Return the witness with a number so near a root of d that Hensel's lemma finds one."""
    if decision.evidence is None or decision.evidence.get("kind") != "witness":
        return None
    near = square_root(F, F(d), NEAR)
    assert near is not None, "d is a square"
    root = QQ.text(near.value)
    return {"kind": "subfield", "field": K.name, "root": root, "witness": decision.evidence}


def _read_back(texts: list[str]) -> list[str]:
    """Write I as the root that ℚ_p reads."""
    return [re.sub(r"\bI\b", "sqrt(-1)", text) for text in texts]


def _radicands(F: LocalField, problem: Problem) -> Iterator[int]:
    """Run through a few d that are squares in F, first one for which the algebra splits over ℚ(√d)."""
    found: list[int] = []
    for d in (*_of_the_algebra(F, problem), *SMALL):
        free = reduced(d)[1] if d else 1
        if free != 1 and free not in found and len(found) < FIELDS and F.is_square(F(free)):
            found.append(free)
            yield free


def _of_the_algebra(F: LocalField, problem: Problem) -> Iterator[int]:
    """Yield T² − 4·N(q)·N(u) for a plane of q and u on which the norm has a zero in ℚ_p."""
    a, t, b = (QQ(text) for text in problem.setting.constants)
    c = Constants(a, t, b)
    form = normal_form(QQ, c)
    if form.a == 0 or form.b == 0:
        return
    plane = known_field(QQ).hyperbolic_plane(c, F.place)
    if plane is not None:
        q, u = (tuple(QQ(x) for x in v) for v in plane)
        mixed = trace(c, multiply(c, q, conjugate(c, u)))
        d = mixed * mixed - 4 * norm(c, q) * norm(c, u)
        yield int(d.p * d.q)
