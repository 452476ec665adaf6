"""Decide a statement: read the text, choose a method, apply it, return the decision.

Nearly everything is decided in this process, since the procedures estimate the work in advance. Two tasks
cannot be estimated: factoring structure constants with many digits, and comparing nested roots. They run in a
subprocess, which is terminated when its time or memory runs out.
"""

import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace

from hfield.checker.glossary import LINEAR_ALGEBRA, NONE
from hfield.errors import HFieldError
from hfield.fields.base.ring import Ring
from hfield.fields.names import RingName, ring
from hfield.prover.attempts import Attempts, Method
from hfield.prover.clock import Clock
from hfield.prover.decision import (
    FIELD,
    NOT_APPLICABLE,
    PROVED,
    UNDECIDED,
    VACUOUS,
    Decision,
    undecided,
)
from hfield.prover.definedness import algebra_exists
from hfield.prover.evaluation.scalars import constant
from hfield.prover.existence import quantifiers
from hfield.prover.existence.closed_equations import closed_solutions
from hfield.prover.methods import ordered, universal
from hfield.prover.methods.subfields import decide_in_subfields
from hfield.prover.problem import Problem, remembered
from hfield.prover.statements.language import read_statement, statement_words
from hfield.prover.statements.setting import read_setting
from hfield.prover.steps import say
from hfield.syntax import Not, Typed, reported_as_typed, spell

TIMEOUT = 30.0


@dataclass(frozen=True)
class Question:
    """A ``problem`` whose time limit has not started, and the texts from which it was read.

    ``given`` are the separate hypotheses, ``algebra`` is None for H, ``timeout`` is in seconds. ``remarks``
    describe how ambiguous words were read.
    """

    text: str
    given: tuple[str, ...]
    algebra: str | None
    timeout: float
    problem: Problem
    remarks: tuple[str, ...] = ()


def read_question(
    statement: str,
    field: RingName | None = None,
    given: Iterable[str] = (),
    algebra: str | None = None,
    timeout: float = TIMEOUT,
) -> Question:
    """Read a question. Raises :class:`NotationError` or :class:`RingError` if it cannot be read."""
    setting = read_setting(field, algebra)
    words = statement_words(setting.field, setting.letters, setting.table)
    typed = [spell(text, words) for text in (*given, statement)]
    *hypotheses, text = (part.text for part in typed)
    where = (tuple(hypotheses), setting.letters, setting.constants, setting.table)
    with reported_as_typed(*typed, Typed.implication(typed)):
        read = read_statement(text, setting.field, *where)
    remarks = tuple(remark for part in typed for remark in part.remarks)
    problem = Problem(read, setting)
    return Question(text, tuple(hypotheses), algebra, timeout, problem, remarks)


def decide(
    statement: str,
    field: RingName | None = None,
    given: Iterable[str] = (),
    algebra: str | None = None,
    timeout: float = TIMEOUT,
) -> Decision:
    """Decide a statement about the quaternions over a field; see docs/reference/language.md for the language.

    ``field`` is a ring, its text, or None for all fields at once. ``given`` are hypotheses, added in front of
    the statement. ``algebra`` is None for H, or a text such as ``(-1,-3|QQ)``, or ``(a,b|F)`` with unknown
    constants. ``timeout`` is the time limit in seconds. Raises :class:`NotationError` or :class:`RingError`
    for unreadable input. It never guesses: a statement that no procedure decides is ``undecided``, with the
    methods that were tried.
    """
    return answer(read_question(statement, field, given, algebra, timeout))


def answer(question: Question) -> Decision:
    """Answer a question, in a subprocess if a single step may take long."""
    if is_risky(question.problem):
        decision = decide_in_subprocess(question)
        if decision is not None:
            return decision
    return decide_in_process(question)


def decide_in_process(question: Question) -> Decision:
    """Answer a question in this process, whatever the risk."""
    problem = replace(question.problem, clock=Clock.of(question.timeout))
    return _decided(problem, problem.field, question.timeout)


@remembered
def _decided(problem: Problem, ring: Ring | None, timeout: float) -> Decision:
    """Apply the methods where the algebra exists; ``ring`` and ``timeout`` are parts of the cache key."""
    exists, attempts = algebra_exists(problem), Attempts()
    if exists is False:
        return _no_algebra(problem)
    if problem.statement.ordered is not None:
        return ordered.decide(problem, _tried)
    attempts.answer(_evaluate_constants, problem)
    if attempts.refusals:
        return undecided(*attempts.refusals)
    decision = attempts.answer(_tried, problem)
    if decision is None or decision.verdict == UNDECIDED:
        others: Iterable[Method] = (
            lambda: decide_in_subfields(problem, _tried),
            lambda: _never_false(problem),
            lambda: decision,
        )
        decision = attempts.decide(others)
    if exists is None and decision.verdict in (PROVED, VACUOUS):
        tried = ("values of the letters for which the structure constants are defined",)
        return undecided(*tried)
    return decision


def _evaluate_constants(problem: Problem) -> None:
    """Evaluate the constants of the field. Raises :class:`UndecidedError` if one may not exist."""
    if problem.field is not None:
        for text in problem.statement.constants:
            constant(problem.field, text)


def _never_false(problem: Problem) -> Decision | None:
    """Prove, without certificate, a statement that fails only at solutions of unsolvable equations."""
    field = problem.field
    if problem.statement.exists or field is None or not (field.is_exact and field.is_field):
        return None
    if not closed_solutions(problem.for_formula(Not(problem.matrix))).none:
        return None
    steps = (say("no-counterexample", F=field.name),)
    return Decision(PROVED, LINEAR_ALGEBRA, steps=steps, scope=FIELD)


def _tried(problem: Problem) -> Decision:
    """Decide by the methods for existential or universal statements; unsatisfiable hypotheses are vacuous."""
    statement = problem.statement
    method = quantifiers.decide if statement.exists else universal.decide
    decision = method(problem)
    if decision.verdict == PROVED and statement.hypotheses:
        return Attempts().answer(quantifiers.vacuous, problem) or decision
    return decision


def _no_algebra(problem: Problem) -> Decision:
    """Return the decision about an algebra whose structure constants are never defined."""
    setting = problem.setting
    where = say("any-field") if setting.field is None else setting.field.name
    named = "no-algebra-for" if setting.letters else "no-algebra"
    why = say(named, A=setting.algebra, F=where, letters=", ".join(setting.letters))
    return Decision(NOT_APPLICABLE, NONE, steps=(why,), tried=(why,))


MEMORY = 1 << 30
GRACE = 1.0  # seconds beyond the time limit for starting and answering
MAX_DIGITS = 12
MAX_WEIGHT = 300
SLOW_WEIGHT = 60  # if roots of numbers are compared
MAX_NAME, MAX_NAME_DIGITS = 60, 20  # of a field: long names and long numbers make slow arithmetic


def is_risky(problem: Problem) -> bool:
    """Return whether a single step may take long, which a time limit could not interrupt."""
    statement, field = problem.statement, problem.field
    digits = sum(map(_digits, problem.setting.constants))
    if digits > MAX_DIGITS or statement.weight > MAX_WEIGHT:
        return True
    if field is None:
        return False
    slow = field.closure is not None and statement.weight > SLOW_WEIGHT
    return slow or len(field.name) > MAX_NAME or _digits(field.name) > MAX_NAME_DIGITS


def _digits(text: str) -> int:
    return sum(c.isdigit() for c in text)


def decide_in_subprocess(question: Question) -> Decision | None:
    """Decide in a subprocess; None for a user-defined field, which has no name in the subprocess."""
    import json
    import pickle
    import subprocess

    field = question.problem.field
    if field is not None and not _is_ours(field):
        return None
    request = {
        "statement": question.text,
        "field": None if field is None else field.name,
        "given": question.given,
        "algebra": question.algebra,
        "timeout": question.timeout,
    }
    try:
        done = subprocess.run(
            [sys.executable, "-m", "hfield.prover.subprocess_worker", str(MEMORY)],
            input=json.dumps(request).encode(),
            capture_output=True,
            timeout=question.timeout + GRACE,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return _given_up(f"the time of {question.timeout:g} s was over")
    if done.returncode:
        return _given_up(f"the work needed more than {MEMORY >> 20} MiB of memory, or failed")
    answer: Decision = pickle.loads(done.stdout)
    return answer


def _is_ours(field: Ring) -> bool:
    try:
        return type(ring(field.name)) is type(field)
    except HFieldError:
        return False


def _given_up(why: str) -> Decision:
    return undecided(f"{why}, in a process of its own")
