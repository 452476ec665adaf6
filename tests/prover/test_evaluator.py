"""The evaluator over all kinds of scalars against that of the checker, which has nothing of it."""

import random
from collections.abc import Iterator, Sequence
from typing import Any

import pytest

from hfield.checker.evidence.exhaustion import truth_at
from hfield.checker.scalars.fields import read_ring
from hfield.checker.statement import read_setting as setting_of_checker
from hfield.checker.statement import read_statement as statement_of_checker
from hfield.checker.values import read_values
from hfield.errors import UndecidedError
from hfield.prover.counterexamples.candidates import prime_scalars, small_scalars, witness_texts
from hfield.prover.decide import read_question
from hfield.prover.evaluation.all_cases import counterexample
from hfield.prover.evaluation.scalars import PrimeScalars, RingScalars
from hfield.prover.evaluation.searcher import Assignment, Searcher
from hfield.prover.problem import Memory, Problem
from hfield.prover.statements.language import Sort
from tests.adversary.statement_generator import plain_statements
from tests.subcases import first_quick, subcases

WRITTEN = (
    "q*inv(q) == e",
    "not (1/s == s) <=> s**-2 == 1 or norm(q) == 1/2",
    "p**0 == e and p**-1*p == 1 => comm(p, q) == q - q",
    "conj(p)[2] == -p[2] and vector(p) == p - scalar(p) and trace(k*p) == -2*p[3]",
    "s*p == p*s and 0.5*p + 0.5*p == p",
    "p/norm(p) != 0",
    "1/0 != 1/0 or inv(s - s) == inv(s - s)",
)
DRAWN = tuple(plain_statements(0, 60))
ALGEBRAS = ("(-1,-1|{})", "[1,2|{})", "(s,1/t|{})")


def problem_of(text: str, field: str, algebra: str) -> Problem:
    return read_question(text, field, (), algebra.format(field)).problem


def places(problem: Problem, scalars: Sequence[Any], rng: random.Random) -> Iterator[Assignment]:
    for _ in range(8):
        yield {
            name: rng.choice(scalars)
            if sort is Sort.SCALAR
            else tuple(rng.choice(scalars) for _ in range(4))
            for name, sort in problem.statement.unknowns
        }


def agree(problem: Problem, scalars: Any, elements: Sequence[Any]) -> int:
    """Compare at some places; return at how many of them the algebra exists."""
    ring = problem.ring
    searcher = Searcher(problem, scalars, True)
    field, exist = read_ring(ring.data), 0
    setting = setting_of_checker(problem.setting.algebra, field)
    statement = statement_of_checker(problem.statement.text, setting)
    for place in places(problem, elements, random.Random(problem.statement.text)):
        texts = witness_texts(ring, {n: _lifted(ring, x) for n, x in place.items()})
        values = read_values(field, texts, statement.unknowns)
        true = truth_at(field, setting, statement, values)
        assert searcher.test(place) is bool(true), (problem.statement.text, texts)
        exist += true is not None
    return exist


def _lifted(ring: Any, x: Any) -> Any:
    return tuple(map(ring, x)) if isinstance(x, tuple) else ring(x)


@subcases("algebra", ALGEBRAS)
@pytest.mark.parametrize("field", first_quick(["GF(3)", "GF(2)", "GF(7)", "QQ"], 2))
def test_over_prime_fields(field: str, algebra: str) -> None:
    exist = 0
    for text in (*WRITTEN, *DRAWN):
        problem = problem_of(text, field, algebra)
        p = problem.ring.characteristic
        exist += agree(problem, PrimeScalars(p), prime_scalars(p))
    assert exist > 50


@pytest.mark.parametrize("field", ["GF(4)", "GF(2)(t)", "QQ(sqrt(2))", "ZZ/6"])
def test_over_other_rings(field: str) -> None:
    for text in (*WRITTEN, *DRAWN[:20]):
        problem = problem_of(text, field, ALGEBRAS[0])
        agree(problem, RingScalars(problem.ring), small_scalars(problem.ring)[:5])


@pytest.mark.parametrize("field", ["GF(4)", "ZZ/6", "GF(5)"])
def test_over_tables(field: str) -> None:
    """What all cases in tables find is what one place after the other finds."""
    found = 0
    for text in (*WRITTEN, *DRAWN):
        problem = problem_of(text, field, ALGEBRAS[0])
        if sum(1 if s is Sort.SCALAR else 4 for _, s in problem.statement.unknowns) > 6:
            continue
        try:
            place, _ = counterexample(problem.within(5.0), None)
        except UndecidedError:
            continue
        if place is None:
            false = Searcher(problem, RingScalars(problem.ring))
            elements = small_scalars(problem.ring)
            assert not any(map(false.test, places(problem, elements, random.Random(1)))), text
        else:
            found += 1
            assert Searcher(problem, RingScalars(problem.ring)).test(place), (text, place)
    assert found


def test_memories_are_apart() -> None:
    """A problem remembers in its own memory, if it has one, and forgets on demand."""
    memory = Memory()
    calls = []
    for _ in range(2):
        memory.recall("kind", "key", lambda: calls.append(1), lambda: True)
    assert calls == [1]
    memory.cache_clear()
    memory.recall("kind", "key", lambda: calls.append(2), lambda: False)
    memory.recall("kind", "key", lambda: calls.append(3), lambda: True)
    assert calls == [1, 2, 3]
