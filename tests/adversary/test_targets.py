"""The claims that are forged for are false, each by an independent evaluation."""

import random

from tests.adversary.falsify import counterexample, is_true, one_place, sampled, somewhere_satisfied
from tests.adversary.forging.targets import CLAUSES, OTHERS, Target
from tests.adversary.judgement import rings_of
from tests.adversary.meaning import read_claim
from tests.adversary.scalars import named
from tests.adversary.small_rings import Table, rings
from tests.subcases import subcases

# False over these fields by theorems that no sampling shows.
KNOWN = {
    ("exists s: s**2 == -1", "QQ"): "a sum of squares is not negative",
    ("exists q: q != 0 and norm(q) == 0", "QQ"): "a sum of four squares is 0 only at 0",
    ("exists q: p*q == e", None): "p = 0",
    ("exists y: not (y == y)", "QQ"): "y = y",
    ("exists y: not (s*y == 1) and s*y == 1", "QQ"): "a contradiction",
    ("s**2 + y**2 == 0 => s == 0", "GF(2)(t)"): "s = y = 1",
    ("s**2 == 2 => s == 0", "RR"): "s = sqrt(2)",
    ("s**2 == 2 => s == 0", "CC"): "s = sqrt(2)",
    ("s**2 != 2", "RR"): "s = sqrt(2)",
    ("s**2 + y**2 == 0 => s == 0", "CC"): "s = I, y = 1",
    ("norm(q) == 0 => q == 0", "CC"): "q = I + i",
    ("norm(q) == 0 => q == 0", "QQ(I)"): "q = I + i",
    ("norm(q) == 0 => q == 0", "QQ(sqrt(-2))"): "q = sqrt(-2) + i + j",
    ("norm(q) == 0 => q == 0", "QQ(sqrt(-3))"): "q = sqrt(-3) + i + j + k",
    ("norm(q) == 0 => q == 0", "GF(3)(t)"): "q = e + i + j",
    ("p*q == 0 => p == 0", "QQ(sqrt(-3))"): "q = 0",
    ("exists s: s**2 == 2", "RR"): "s = sqrt(2)",
    ("exists q: q*q == -1", "QQ"): "q = i",
}


@subcases("target", [*CLAUSES, *OTHERS])
def test_the_target_is_false(target: Target) -> None:
    rng = random.Random(1)
    ring = None if target.field is None else named(target.field)
    scalars = one_place(ring) if isinstance(ring, Table) else ring
    claim = read_claim(target.statement, target.algebra_text, scalars)
    if target.verdict == "vacuous":
        tables = [ring] if isinstance(ring, Table) else rings_of("fields")
        assert not claim.hypotheses or somewhere_satisfied(claim, tables, rng)
        return
    proved = target.verdict == "proved"
    if isinstance(ring, Table):
        assert is_true(claim, ring) is not proved
    elif (target.statement, target.field) in KNOWN:
        pass
    elif ring is not None and proved:
        assert sampled(claim, ring, rng, 2_000) is not None
    elif proved:
        assert counterexample(claim, rings_of("fields"), rng, 200) is not None
    elif ring is not None:  # refuted, and true as far as samples show
        assert sampled(claim, ring, rng, 100) is None
    else:  # refuted, and true in every small ring, or field
        everywhere = rings_of("fields") if claim.bound else rings()
        assert counterexample(claim, everywhere, rng, 100) is None
