"""Is an answer of the prover right? Judged by the meaning of the statement and nothing of the prover's.

A verdict is a claim about one ring or about many (its scope); each is tried in all rings at hand. A
witness is evaluated again where it says it lives, and the certificate has to pass the checker, which
has to say the same.
"""

import json
import random
import re
from collections.abc import Sequence
from typing import Any

from hfield.checker.check import ExpectedClaim, check_text
from hfield.checker.rejection import Rejected
from tests.adversary.falsify import (
    counterexample,
    is_defined,
    is_true,
    one_place,
    sampled,
    somewhere_satisfied,
    true_at,
)
from tests.adversary.grammar import NotRead, Tree, read
from tests.adversary.meaning import Claim, read_claim, substituted
from tests.adversary.scalars import Exact, Integers, named, value_of
from tests.adversary.small_rings import Table, rings

VERDICTS = ("proved", "refuted", "vacuous", "undecided", "not-applicable")
SAMPLED = [Integers(), *(named(f) for f in ("QQ", "QQ(sqrt(2))", "QQ(I)", "QQ(x)", "GF(2)(t)"))]


def rings_of(scope: str | None) -> list[Table]:
    """Return the rings at hand that a scope speaks of."""
    if scope == "commutative rings":
        return list(rings())
    if scope == "reduced rings":
        return [r for r in rings() if r.is_reduced]
    if scope == "fields":
        return [r for r in rings() if r.is_field]
    if scope is not None and (m := re.fullmatch(r"characteristics \[([\d, ]*)\]", scope)):
        wanted = {int(n) for n in m[1].split(",")}
        return [r for r in rings() if r.characteristic in wanted]
    return []


def judge(
    statement: str, field: str | None, algebra: str | None, found: dict[str, Any], seed: int
) -> list[str]:
    """Return what is wrong with ``verdict``, ``scope`` and ``witness`` in ``found``."""
    rng = random.Random(seed)
    verdict, scope = found["verdict"], found["scope"]
    if verdict not in VERDICTS:
        return [f"there is no verdict {verdict!r}"]
    here = None if field is None else named(field)
    scalars = one_place(here) if isinstance(here, Table) else here
    claim = read_claim(statement, algebra, scalars)
    out = []
    positive = verdict in ("proved", "vacuous")
    if field is None:
        anywhere = rings_of(scope if scope and scope != "field" else "fields")
    elif scope in (None, "field"):
        anywhere = []
    else:  # what is claimed of other rings is claimed of the statement without constants of this one
        anywhere = rings_of(scope)
    out += _claimed(claim, verdict, scope, field, anywhere, rng)
    if verdict != "undecided":
        everywhere = (
            rings_of("fields") if field is None else [here] if isinstance(here, Table) else []
        )
        if is_defined(claim, everywhere, here, rng) == (verdict == "not-applicable"):
            nowhere = verdict != "not-applicable"
            out.append(f"{verdict}, but the algebra exists {'nowhere' if nowhere else 'somewhere'}")
    if isinstance(here, Table):
        out += _in_finite(claim, here, verdict, positive)
    elif isinstance(here, Exact) and positive:
        false = sampled(claim, here, rng)
        if false is not None:
            out.append(f"{verdict} over {field}, but false at {false}")
    if found.get("witness"):
        out += _witnessed(statement, algebra, field, found, anywhere, rng)
    return out


def _claimed(
    claim: Claim,
    verdict: str,
    scope: str | None,
    field: str | None,
    tables: Sequence[Table],
    rng: random.Random,
) -> list[str]:
    """Try what a scope claims in all of its rings."""
    positive = verdict in ("proved", "vacuous")
    narrowed = verdict == "refuted" and scope is not None and scope.startswith("characteristics")
    if not tables or not (positive or narrowed):
        return []
    try:
        false = counterexample(claim, tables, rng)
    except NotRead:
        return [f"scope {scope!r} though the statement has constants of {field}"]
    if false is None and verdict == "vacuous":
        false = somewhere_satisfied(claim, tables, rng)
    if false is None and positive and scope in ("commutative rings", "reduced rings", "fields"):
        for large in SAMPLED if field is None else []:
            if scope == "fields" and isinstance(large, Integers):
                continue
            value = sampled(claim, large, rng, 2)
            if value is not None:
                false = f"false over a {type(large).__name__} at {value}"
    return [] if false is None else [f"{verdict}, scope {scope}, but {false}"]


def _in_finite(claim: Claim, here: Table, verdict: str, positive: bool) -> list[str]:
    if verdict in ("undecided", "not-applicable"):
        return []
    truth = is_true(claim, here)
    if truth is not None and truth != positive:
        return [f"{verdict}, but all cases over {here.name} say {truth}"]
    if truth is None and positive:
        false = counterexample(claim, [here], random.Random(1), 2_000)
        return [] if false is None else [f"{verdict}, but {false}"]
    if verdict == "vacuous":
        found = somewhere_satisfied(claim, [here], random.Random(1))
        return [] if found is None else [f"vacuous, but the hypotheses are true: {found}"]
    return []


def _witnessed(
    statement: str,
    algebra: str | None,
    field: str | None,
    found: dict[str, Any],
    tables: Sequence[Table],
    rng: random.Random,
) -> list[str]:
    """Evaluate a witness again: values at one place, or terms for what exists at all places."""
    verdict, witness = found["verdict"], found["witness"]
    where = witness.get("F", [field])[0]
    if field is not None and where != field:
        return [f"a witness over {where} for a statement over {field}"]
    ring = None if where is None else named(where)
    scalars = one_place(ring) if isinstance(ring, Table) else ring
    # Without a field the names of the statement mean unknowns, whatever the field of the witness is.
    claim = read_claim(statement, algebra, scalars if field is not None else None)
    trees = {n: tuple(map(read, texts)) for n, texts in witness.items() if n != "F"}
    given = {n for n, _ in claim.given}
    if verdict == "proved" and claim.bound and not given <= set(trees):
        chosen = {n: _term(trees[n]) for n, _ in claim.bound if n in trees}
        if len(chosen) < len(claim.bound):
            return [f"the witness {witness} does not give all that exists"]
        places = tables or ([ring] if isinstance(ring, Table) else [])
        false = counterexample(substituted(claim, chosen), places, rng)
        return [] if false is None else [f"the witness {witness}: {false}"]
    if where is None:
        return [f"the witness {witness} names no field"]
    if ring is None:
        return []
    values: dict[str, Any] = {}
    for name, own in trees.items():
        read_ = [value_of(tree, scalars) for tree in own]
        if any(v is None for v in read_):
            return [f"the witness {witness} cannot be read over {where}"]
        values[name] = tuple(read_) if len(read_) == 4 else read_[0]
    missing = [n for n, _ in (*claim.given, *claim.bound) if n not in values]
    if missing and verdict == "refuted" and not given & set(missing):
        return []  # nothing exists there: that is for all cases to say
    if missing:
        return [f"the witness {witness} does not give {missing}"]
    truth = true_at(claim, scalars, values)
    if truth is None:
        return [f"the witness {witness} is where the algebra is not defined"]
    if truth != (verdict == "proved"):
        return [f"{verdict}, but the statement is {truth} at its witness {witness}"]
    return []


def _term(trees: tuple[Tree, ...]) -> Tree:
    if len(trees) == 1:
        return trees[0]
    parts = [("*", c, ("name", u)) for c, u in zip(trees, "eijk", strict=True)]
    return ("+", ("+", parts[0], parts[1]), ("+", parts[2], parts[3]))


def judge_certificate(
    found: dict[str, Any] | None,
    verdict: str,
    statement: str,
    field: str | None,
    algebra: str | None,
) -> tuple[list[str], str | None]:
    """Check the certificate, pinned; return what is wrong and the scope that the checker states."""
    if found is None:
        # Over rings that are no fields, and for numbers of high degree, the checker does less.
        may_be = verdict in ("undecided", "not-applicable") or (field or "")[:2] in (
            "ZZ",
            "RR",
            "CC",
        )
        return ([] if may_be else ["decided without a certificate"]), None
    if verdict in ("undecided", "not-applicable"):
        return [f"{verdict}, and yet there is a certificate"], None
    try:
        expected = ExpectedClaim((statement,), field, algebra)
        established = check_text(json.dumps(found), expected)
    except Rejected as error:
        return [f"its certificate is rejected: {error}"], None
    if established.verdict != verdict:
        return [f"its certificate is about {established.verdict}"], None
    return [], established.scope
