"""Forgeries drawn, checked, and what passes judged by its meaning.

A forgery that passes is a break when its claim is one of the false targets, or when an independent
evaluation finds a place where what the checker says it establishes is false.
"""

import json
import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from hfield.checker.check import Established, ExpectedClaim, check_text
from hfield.checker.rejection import Rejected
from tests.adversary.forging.kinds import forged
from tests.adversary.forging.mutants import mutated
from tests.adversary.forging.sight import seen_false, witness
from tests.adversary.forging.spelling import SPELLINGS
from tests.adversary.forging.targets import NO_FIELDS, TARGETS, Certificate, Target
from tests.adversary.forging.validity import same_target, why_valid
from tests.adversary.forging.wholes import forged as forged_whole
from tests.adversary.grammar import NotRead
from tests.adversary.judgement import judge
from tests.adversary.ring_names import name_of
from tests.adversary.words import is_word, truth_everywhere, truth_over

FAMILIES = ("evidence", "evidence", "evidence", "spelling", "wholes", "mutants", "pins")


@dataclass
class Outcome:
    """What became of some forgeries; ``breaks`` are pairs of a reason and the file."""

    tally: Counter[str] = field(default_factory=Counter)
    breaks: list[tuple[str, str]] = field(default_factory=list)


def false_claim(data: Certificate, established: Established, seed: int = 0) -> str:
    """Return why what was established is false, '' where nothing says so."""
    statement, where, verdict = data["statement"], data["field"], data["verdict"]
    if any("".join(str(where).split()) == "".join(n.split()) for n in NO_FIELDS):
        return f"there is no ring {where!r}"
    try:
        if where is not None and name_of(data["ring"]) != where:
            return f"the data are not those of {where!r}"
    except NotRead as error:
        return str(error)
    if is_word(statement):
        return _false_whole(statement, where, verdict)
    if statement.lstrip().startswith("associative"):
        return ""
    try:
        shown = witness(data["evidence"])
        found = {"verdict": verdict, "scope": established.scope, "witness": shown}
        wrong = judge(statement, where, data["algebra"], found, seed)
        return "; ".join(wrong) or seen_false(data)
    except NotRead as error:
        return f"the judge reads no statement: {error}"


def _false_whole(statement: str, where: str | None, verdict: str) -> str:
    """Say what a statement of the vocabulary is; over all fields only a false one settles it."""
    field = "".join((where or "").split())
    truth = truth_over(statement, field) if field else truth_everywhere(statement)
    return f"that is {truth}" if truth is not None and truth != (verdict != "refuted") else ""


@dataclass(frozen=True)
class Forgery:
    """A file; ``target`` is the false claim it is about, ``original`` the certificate it was made from."""

    name: str
    text: str
    target: Target | None = None
    expected: ExpectedClaim | None = None
    original: Certificate | None = None


def draw(rng: random.Random, pool: Sequence[Certificate]) -> Forgery:
    """Return a forgery of some family."""
    family = rng.choice(FAMILIES)
    target, true = rng.choice(TARGETS), rng.choice(pool)
    if family == "evidence":
        name, data = forged(target, rng, pool)
        return Forgery(name, json.dumps(data), target)
    if family == "spelling":
        spelling = rng.choice(SPELLINGS)
        return Forgery(spelling.__name__, spelling(target, true, rng))
    if family == "wholes":
        return Forgery("wholes", json.dumps(forged_whole(rng)))
    if family == "mutants":
        return Forgery("mutants", json.dumps(mutated(true, pool, rng)), original=true)
    return _pinned(rng)


def _pinned(rng: random.Random) -> Forgery:
    """A true statement that looks like, begins like or is made from the false one expected."""
    target = rng.choice(
        [t for t in TARGETS if t.verdict == "proved" and "exists" not in t.statement]
    )
    s = target.statement
    wider = rng.choice((
        f"{s}{' ' * 300}or 0 == 0", f"{s} or 1 == 1", f"1 == 1 or {s}", f"1 == 2 => ({s})",
        f"every{{{s} or 0 == 0}}", f"implies{{1 == 2; {s}}}", f"({s}) <=> ({s})",
        f"over{{ZZ/6; {s} or 0 == 0}}", f"not-everywhere{{{s}}}", f"angles{{{s} or 0 == 0}}",
        f"citing{{limits; {s} or 0 == 0}}", s.replace("==", "!=") + " or 1 == 1",
    ))  # fmt: skip
    data = target.certificate({"kind": "identity"}, "identity", statement=wider)
    other = ExpectedClaim((s,), target.field, target.algebra, any_field=rng.random() < 0.3)
    return Forgery("pins", json.dumps(data), target, other)


def _checked(text: str, expected: ExpectedClaim | None) -> Established:
    """Check; a forger mends what the checker says of ``method`` and ``assumes``, and checks again."""
    try:
        return check_text(text, expected)
    except Rejected as error:
        said = str(error)
    _, methods, wanted = said.partition("is not that of the evidence: ")
    _, assumes, cites = said.partition("exactly what the evidence cites: ")
    if not (methods or assumes):
        raise Rejected(said)
    data = json.loads(text)
    if methods and data["method"] != wanted:
        return _checked(json.dumps({**data, "method": wanted}), expected)
    if assumes and not data["assumes"]:
        own = [] if cites == "nothing" else cites.split("; ")
        return _checked(json.dumps({**data, "assumes": own}), expected)
    raise Rejected(said)


def run(count: int, seed: int, pool: Sequence[Certificate]) -> Outcome:
    """Draw so many forgeries and judge them."""
    rng, out = random.Random(seed), Outcome()
    for _ in range(count):
        made = draw(rng, pool)
        out.tally[made.name] += 1
        try:
            established = _checked(made.text, made.expected)
        except Rejected:
            out.tally["rejected"] += 1
            continue
        except Exception as error:  # the checker promises Rejected and nothing else
            out.breaks.append((f"{made.name}: {type(error).__name__}: {error}", made.text))
            continue
        reason = _judged(made, established, rng.randrange(1 << 30))
        if reason:
            out.breaks.append((f"{made.name}: {reason}", made.text))
        else:
            out.tally[f"passed, and may: {made.name}"] += 1
    return out


def _judged(made: Forgery, established: Established, seed: int) -> str:
    if established.assumptions:  # what rests on an assumption is no break if that is false
        return ""
    if made.target is not None:
        return f"a false claim passes, as {established}"
    data: Any = json.loads(made.text)
    if made.original is not None and same_target(data, made.original):
        # The claim is as before; but then the evidence has to show it still.
        return "" if why_valid(data, made.original) else f"why is it valid? {made.original}"
    return false_claim(data, established, seed)
