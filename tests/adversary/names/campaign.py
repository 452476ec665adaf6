"""Names and data of rings, many, judged by three: the prover, the checker, and the reader of the page.

A complaint is a name that two of them take differently, something that one of them says of a ring and that
is not so, data that do not come back from their name, or two data of one name.
"""

import json
import re
from collections import Counter
from dataclasses import dataclass, field
from math import prod
from random import Random
from typing import Any

from hfield.checker.budget import bounded
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import read_ring
from hfield.errors import HFieldError
from hfield.fields.names import ring, ring_of_data
from tests.adversary.names import composed, some_data
from tests.adversary.names.expressions import Refused, Unsure
from tests.adversary.names.facts import facts
from tests.adversary.names.numbers import Data
from tests.adversary.names.reader import read
from tests.adversary.names.voices import checker_contradicts, prover_contradicts

LARGEST = 12  # the degree of a field of several numbers up to which the prover makes one


@dataclass
class Outcome:
    """What became of names or data, and what is wrong."""

    tally: Counter[str] = field(default_factory=Counter)
    complaints: list[str] = field(default_factory=list)
    judged: set[str] = field(default_factory=set)
    names: dict[str, str] = field(default_factory=dict)

    def complain(self, what: str, about: object) -> None:
        """Note what is wrong."""
        self.complaints.append(f"{about!r}: {what}")


def run_names(count: int, seed: int) -> Outcome:
    """Judge so many different names."""
    rng, out, seen = Random(seed), Outcome(), set[str]()
    while len(seen) < count:
        text = composed.name(rng)
        if text not in seen:
            seen.add(text)
            judge_name(text, out)
    return out


def judge_name(text: str, out: Outcome) -> None:
    """See that the prover takes a name as the page does, and that all that is said of the ring is so."""
    if _is_large(text):
        out.tally["too large to ask for"] += 1
        return
    meant: Data | None = None
    unsure = False
    try:
        meant = read(text)
    except Unsure:
        unsure = True
    except Refused as error:
        why = str(error)
    try:
        R: Any = ring(text)
    except HFieldError as error:
        out.tally["refused" if meant is None else "refused by the prover alone"] += 1
        if meant is not None:
            out.complain(f"means {meant}, but the prover says: {str(error)[:150]}", text)
        return
    if ring(R.name) != R:
        out.complain(f"{R.name} does not read back", text)
    if unsure:
        out.tally["read by the prover alone, without facts that contradict it"] += 1
    elif meant is None:
        out.complain(f"the prover reads {R.name}, which the page does not allow: {why}", text)
    elif meant != R.data:
        out.complain(f"means {meant}, but the prover takes it for {R.data}", text)
    else:
        out.tally["read alike"] += 1
        judge_data(R.data, R, out, text)


def _is_large(text: str) -> bool:
    """Tell whether a name is of several numbers of large degree together, with which the prover is slow."""
    degrees = [int(n) for n in re.findall(r"(?:zeta[_(]?|ζ_?|,)([0-9]{1,4})(?=[^0-9])", text)]
    roots = len(re.findall("sqrt|√|I", text)) + 2 * len(re.findall("cbrt", text))
    return len(degrees) + roots > 1 and prod(degrees) * 2**roots > LARGEST**2


def judge_data(data: Data, R: Any, out: Outcome, about: object) -> None:
    """See that prover and checker say of a ring what is so, and that they call it the same."""
    key = json.dumps(data, sort_keys=True)
    if key in out.judged:
        return
    out.judged.add(key)
    try:
        known = facts(data)
    except Unsure:
        known = None
        out.tally["rings without facts"] += 1
    try:
        if known is not None:
            for wrong in prover_contradicts(R, known):
                out.complain(f"the prover says {wrong}", about)
        with bounded():
            C = read_ring(data)
            if C.name != R.name:
                out.complain(f"the prover calls it {R.name}, the checker {C.name}", about)
            if known is not None:
                for wrong in checker_contradicts(C, known):
                    out.complain(f"the checker says {wrong}", about)
        out.tally["rings asked about"] += 1
    except Rejected as error:
        out.tally[f"the checker knows none: {re.sub('[^ a-z]', '', str(error))[-40:]}"] += 1
    except HFieldError as error:
        out.complain(f"{type(error).__name__}: {error}", about)


def run_data(count: int, seed: int) -> Outcome:
    """Judge so many different data, half of them near others."""
    rng, out = Random(seed), Outcome()
    before: list[Data] = []
    while len(out.names) < count:
        near = bool(before) and rng.random() < 0.5
        data = some_data.near(rng.choice(before), rng) if near else some_data.data(rng)
        if judge_name_of(data, out, near=near):
            before = [*before[-200:], data]
    return out


def judge_name_of(data: Any, out: Outcome, *, near: bool) -> bool:
    """See that the name of data has no other data, and goes back to them; tell whether there is one."""
    try:
        with bounded():
            name = read_ring(data).name
    except Rejected:
        out.tally["rejected"] += 1
        if not near:
            out.complain("the checker does not know data that are in order", data)
        return False
    key = json.dumps(data, sort_keys=True)
    if out.names.setdefault(name, key) != key:
        out.complain(f"{name} is the name of {out.names[name]} too", data)
    try:
        R: Any = ring_of_data(data)
    except HFieldError as error:
        out.tally["rings of the checker alone"] += 1
        if not near:
            out.complain(f"the prover does not read {name}: {error}", data)
        return True
    if R.data == data:
        out.tally["went there and back"] += 1
        judge_data(data, R, out, data)
    elif near:
        _means_the_same(data, R.data, out)
    else:
        out.complain(f"came back as {R.data}", data)
    return True


def _means_the_same(data: Data, other: Data, out: Outcome) -> None:
    """See that data that the prover writes in another way say the same."""
    try:
        wrong = facts(data) != facts(other) and [
            *checker_contradicts(read_ring(other), facts(data))
        ]
        if wrong:
            out.complain(f"came back as {other}, of which it is not so: {wrong}", data)
        out.tally["came back in other words"] += 1
    except (Unsure, Rejected, AssertionError):
        out.tally["came back in other words, not compared"] += 1
