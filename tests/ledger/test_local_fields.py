"""Claims about squares over ℚ_p, where roots are known to some digits and levels by theorems."""

import pytest

from hfield import ring
from hfield.fields.base.ring import INFINITY
from hfield.ledger.base_field import IsDivisionAlgebra, LevelAbove, PositiveNorm
from hfield.ledger.modulus import ModulusLaw

LEVELS = {2: 4, 3: 2, 5: 1, 7: 2, 13: 1, 41: 1}


@pytest.mark.parametrize(("p", "level"), LEVELS.items())
def test_what_depends_on_the_level_is_decided(p, level):
    F = ring(f"Qp({p})")
    for bound in (1, 2, 3, 4, INFINITY):
        found = LevelAbove(bound).decide(F)
        assert found.verdict == ("proved" if level > bound else "refuted")
        if found.verdict == "refuted":
            values = [F(text) for (text,) in found.witness.values()]
            assert len(values) == level
            total = sum((x * x for x in values), F(1))
            assert F.text(total).startswith(("0", "O("))
            assert found.evidence is None or "O(" not in str(found.evidence)
    assert PositiveNorm().decide(F).verdict == "refuted"
    assert ModulusLaw().decide(F).verdict == ("refuted" if level == 1 else "proved")
    assert IsDivisionAlgebra().decide(F).verdict == ("proved" if p == 2 else "refuted")


def test_a_sum_that_is_known_to_differ_is_no_witness(monkeypatch):
    F = ring("Qp(5)")
    monkeypatch.setattr(type(F), "minus_one_as_squares", lambda self: (self(2),))
    assert LevelAbove(2).decide(F).verdict == "undecided"
