"""Exhaustion computes by loops where cases are many, and by tables where they are few: to the same end."""

import numpy as np
import pytest

from hfield import prove, ring
from hfield.fields.base.array_storage.finite import ScalarArrays
from hfield.prover.evaluation import all_cases
from hfield.prover.evaluation.all_cases import _Table
from hfield.prover.methods import one_field


@pytest.mark.parametrize("name", ["GF(2)", "GF(13)", "GF(257)", "GF(8)", "GF(9)", "ZZ/6"])
def test_loops_and_tables_compute_the_same(name):
    F = ring(name)
    tables, loops = (_Table(F, by_loops) for by_loops in (False, True))
    assert isinstance(loops.compute, ScalarArrays)
    assert not isinstance(tables.compute, ScalarArrays)
    assert [F.key(x) for x in loops.elements] == [F.key(x) for x in tables.elements]
    n = np.arange(F.order)
    x, y = (a.ravel() for a in np.meshgrid(n, n))
    for operation in (
        lambda u, v: u + v,
        lambda u, v: u - v,
        lambda u, v: u * v,
        lambda u, v: -u,
    ):
        found = [
            operation(*(t.entry(a.astype(t.kind)) for a in (x, y))).array for t in (tables, loops)
        ]
        assert (found[0] == found[1]).all()
    for one, other in zip(tables.units, loops.units, strict=True):
        assert (one == other).all()


@pytest.mark.parametrize(
    ("statement", "over_3", "over_4"),  # H(GF(4)) is commutative
    [
        ("q*q == 0 => norm(q) == 0", "proved", "proved"),
        ("p*q == 0 => q*p == 0", "refuted", "proved"),
        ("norm(q) == 0 => q == 0", "refuted", "refuted"),
    ],
)
def test_verdicts_do_not_depend_on_the_way(statement, over_3, over_4, monkeypatch):
    for many in (0, 10**9):
        monkeypatch.setattr(all_cases, "MANY_CASES", many)
        monkeypatch.setattr(all_cases, "FEW_CASES", 0)
        assert prove(statement, field="GF(3)").verdict == over_3
        assert prove(statement, field="GF(4)").verdict == over_4


@pytest.mark.slow
def test_all_cases_have_time_left_when_ideals_take_theirs(monkeypatch):
    prove_clauses = one_field.prove_clauses

    def slow(problem, p):
        while not problem.is_late:
            pass
        return prove_clauses(problem, p)

    monkeypatch.setattr(one_field, "prove_clauses", slow)
    monkeypatch.setattr(one_field, "FIRST_ATTEMPT_SECONDS", 0.1)
    text = "q*q*q == q => q*q == 1 or norm(q)*q == 0 or q[1] == 1 or trace(q) == 1"
    assert prove(text, "GF(3)", timeout=3).decision.method == "exhaustion"
