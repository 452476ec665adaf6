"""A search that goes further tries no place twice, and finds what a fresh one finds."""

import pytest

from hfield.prover.counterexamples.candidates import prime_search
from hfield.prover.evaluation.searcher import Searcher
from hfield.prover.problem import Memory, Problem
from hfield.prover.statements.language import read_statement
from hfield.prover.statements.setting import read_setting


def problem(text: str) -> Problem:
    """Return a problem over all fields that remembers nothing of others."""
    return Problem(read_statement(text), read_setting(), memory=Memory())


@pytest.fixture
def tests_made(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    made: list[object] = []
    test = Searcher.test
    monkeypatch.setattr(Searcher, "test", lambda self, x: made.append(x) or test(self, x))
    return made


def test_no_place_is_tried_twice(tests_made: list[object]) -> None:
    statement = problem("p*conj(p) == norm(p)")
    for limit in (5, 40, 40, 20, 170):
        assert prime_search(statement, 0, limit) is None
    assert len(tests_made) == 170


def test_a_statement_without_unknowns_is_tried_once(tests_made: list[object]) -> None:
    assert prime_search(problem("2 == 2"), 0, 100) is None
    assert len(tests_made) == 1


@pytest.mark.parametrize("text", ["p[0] != 3", "p[0]*p[1] != q[2]", "s*t != 4", "p*q == q*p"])
def test_what_is_found_is_what_a_fresh_search_finds(text: str) -> None:
    again = problem(text)
    for limit in (1, 3, 10, 60, 400, 10, 3000):
        assert prime_search(again, 0, limit) == prime_search(problem(text), 0, limit)
