"""Coq proofs from values: counterexamples, and examples of what exists."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from hfield.coq.base_rings import (
    FIELDS,
    INTEGERS,
    MAX_MODULUS,
    MAX_PRIME,
    RATIONALS,
    BaseRing,
    base_ring_of,
    value_in,
)
from hfield.coq.cofactors import MismatchError
from hfield.coq.sentences import COMPUTED, Proved, Sentence, computed
from hfield.coq.terms import NotCoveredError
from hfield.fields.names import ring_of_data
from hfield.proving.statements.language import Sort, Statement

if TYPE_CHECKING:
    from hfield.coq.judgement import Judgement


def _values(
    j: Judgement,
    room: BaseRing,
    values: Mapping[str, Sequence[str]],
    sentence: Sentence,
    unknowns: Sequence[tuple[str, Sort]],
) -> tuple[str, str]:
    if set(values) != {n for n, _ in unknowns}:
        raise MismatchError("the witness is not one for these unknowns")
    quaternions, scalars = [], []
    for name, sort in sentence.terms.ordered:
        if (name, sort) not in unknowns:
            continue
        found = [value_in(room, text) for text in values[name]]
        if len(found) != (4 if sort is Sort.QUATERNION else 1):
            raise MismatchError(f"{name} has {len(found)} coordinates")
        if sort is Sort.QUATERNION:
            quaternions.append(f"Quaternion {' '.join(found)}")
        else:
            scalars += found
    return f"[{'; '.join(quaternions)}]", f"[{'; '.join(scalars)}]"


def counterexample(j: Judgement, evidence: Mapping[str, Any]) -> Proved:
    """Refute a statement by values, in its ring, or in one field what is said of all."""
    field = ring_of_data(evidence["ring"])
    if j.setting.field is not None and j.setting.field != field:
        raise MismatchError("the witness is from another field")
    room = base_ring_of(field)
    here = replace(j.setting, field=field)
    statement = j.read(j.statement.text, here)
    _check_listed(statement, room)
    sentence = Sentence(statement, here, room)
    values = _values(j, room, evidence["values"], sentence, sentence.order)
    call = f"({sentence.data})\n  {values[0]} {values[1]}"
    judge = _named(room, "residues_fail", "rationals_fail", "integers_fail", call)
    if j.setting.field is not None:
        return Proved(f"~ ({sentence.body})", (f"refine ({judge}).", f"all: {COMPUTED}"))
    if not room.is_field:
        raise MismatchError(f"{field.name} is no field")
    everywhere = Sentence(j.statement, j.setting, FIELDS)
    if room.characteristic > MAX_PRIME:
        raise NotCoveredError(f"a counterexample in GF(p) with p above {MAX_PRIME}")
    start, there = in_one_field(room)
    lines = [*start, f"unshelve refine ({judge} ({there})).", f"all: {COMPUTED}"]
    return Proved(f"~ ({everywhere.text})", tuple(lines))


def in_one_field(room: BaseRing) -> tuple[list[str], str]:
    """Return how a proof against all fields begins, and what they say of this one."""
    p = room.characteristic
    if not p:
        return ["intro F."], "F Qc _ _ rational_field"
    prime = f"assert (prime : is_prime {p} = true) by ({COMPUTED[:-1]})."
    return ["intro F.", prime], f"F (GF {p}) _ _ (GF_field {p} prime)"


def example(j: Judgement, evidence: Mapping[str, Any]) -> Proved:
    """Prove existence by values, where nothing is given."""
    room, sentence = j.one_ring()
    _check_listed(j.statement, room)
    values = _values(j, room, evidence["values"], sentence, sentence.found)
    call = f"({sentence.data})\n  {values[0]} {values[1]}"
    judge = _named(room, "residues_example", "rationals_example", "integers_example", call)
    return computed(sentence, judge)


def _named(room: BaseRing, residues: str, rationals: str, integers: str, call: str) -> str:
    if room is RATIONALS:
        return f"{rationals} {call} _"
    if room is INTEGERS:
        return f"{integers} {call} _"
    return f"{residues} {room.characteristic} {call} _ _"


def _check_listed(statement: Statement, room: BaseRing) -> None:
    if room.characteristic > MAX_MODULUS and statement.divides:
        raise NotCoveredError(f"division modulo a number above {MAX_MODULUS}")
