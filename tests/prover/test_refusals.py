"""What one method refuses, a later one still decides: too large, undecided, or whatever else it raises."""

import pytest

from hfield import prove
from hfield.errors import NotInvertibleError, TooLargeError, UndecidedError
from hfield.prover.existence import quantifiers, witnesses
from hfield.prover.methods import all_fields, one_field, over_rings
from hfield.prover.problem import MEMORY


@pytest.fixture(autouse=True)
def nothing_is_remembered():
    MEMORY.cache_clear()
    yield
    MEMORY.cache_clear()


@pytest.mark.parametrize(
    ("statement", "field", "verdict"),
    [
        ("norm(q) != 0 => q**48 == 1", "GF3", "proved"),
        ("norm(q) != 0 => q**48 == 1", "GF7", "refuted"),
        ("norm(q) != 0 => q**48 == 1", None, "refuted"),
        ("q**81 == q", "GF3", "refuted"),
        ("norm(q)**24 == norm(q)**48", "GF(5)", "proved"),
        ("q**60 == 0 => q**2 == 0", "ZZ/2", "proved"),
        ("not q**60 == i and not q**60 == j", "GF(2)", "proved"),
    ],
)  # fmt: skip
def test_powers_that_are_too_large_to_expand(statement, field, verdict):
    assert prove(statement, field).verdict == verdict


METHODS = {
    one_field: ("expand", "quick_search", "prove_clauses", "search_counterexample", "solve_clauses"),
    over_rings: ("expand", "_proved", "search_counterexample"),
    all_fields: ("expand", "_proof"),
    quantifiers: ("by_isolating", "by_terms", "by_linear_algebra", "by_roots", "by_zero_or_not", "at_zero",
                  "refuted_at", "vacuous"),
    witnesses: ("true_place", "_solved", "closed_solutions", "by_roots"),
}  # fmt: skip
CASES = {  # each decided by the last method, too
    one_field: [("norm(p) != 0 => p**8 == p", "GF(2)", "refuted"), ("s**3 == s", "GF(3)", "proved"),
                ("s**2 == s => s == 0 or s == 1", "GF(5)", "proved")],
    over_rings: [("s**3 == s", "ZZ/6", "proved"), ("s*s == 0 => s == 0", "ZZ/4", "refuted")],
    all_fields: [("p*q == q*p", None, "refuted"), ("s*t == 0 => s == 0", None, "refuted")],
    quantifiers: [("exists q: q*q == p*p", "GF(2)", "proved"), ("exists s: s*x == 1", "GF(3)", "refuted"),
                  ("x == 1 => (exists s: s*x == 1)", "GF(3)", "proved")],
    witnesses: [("exists s: s*s == 2", "GF(3)", "refuted"), ("exists s: s*s == 2", "GF(7)", "proved")],
}  # fmt: skip


@pytest.mark.parametrize("error", [TooLargeError, UndecidedError, NotInvertibleError])
@pytest.mark.parametrize(
    ("module", "name"), [(module, name) for module, names in METHODS.items() for name in names]
)
def test_no_method_stops_the_next(monkeypatch, module, name, error):
    def refuse(*args, **kwargs):
        raise error("this is refused")

    monkeypatch.setattr(module, name, refuse)
    for statement, field, verdict in CASES[module]:
        MEMORY.cache_clear()
        assert prove(statement, field).verdict == verdict, (statement, field)


def test_every_reason_is_reported_where_nothing_decides():
    tried = prove("x == 1+O(5) => x == 1+O(5^2)", "Qp(5)").decision.tried
    assert len(tried) == len(set(tried)) > 1
