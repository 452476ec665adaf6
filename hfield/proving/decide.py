"""The way from a text to a verdict: read, choose, try, answer."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from hfield.certificates.glossary import LINEAR_ALGEBRA, NONE
from hfield.errors import TooLargeError, UndecidedError
from hfield.proving.clock import Clock
from hfield.proving.decision import (
    FIELD,
    NOT_APPLICABLE,
    PROVED,
    UNDECIDED,
    VACUOUS,
    Decision,
    undecided,
)
from hfield.proving.definedness import algebra_exists
from hfield.proving.existence import quantifiers
from hfield.proving.existence.closed_equations import closed_solutions
from hfield.proving.methods import universal
from hfield.proving.methods.subfields import decide_in_subfields
from hfield.proving.problem import Problem, remembered
from hfield.proving.question import TIMEOUT, Question, read_question
from hfield.proving.steps import say
from hfield.proving.subprocess_limits import decide_apart, is_risky
from hfield.rings.base import Ring
from hfield.syntax import Not


def decide(
    statement: str,
    field: Ring | str | None = None,
    given: Iterable[str] = (),
    algebra: str | None = None,
    timeout: float = TIMEOUT,
) -> Decision:
    """Decide a statement about the quaternions over a field; see docs/language.md for the language.

    ``field`` is a ring, its text, or None for all fields at once. ``given`` are hypotheses that are
    put in front of the statement. ``algebra`` is H if None, else a text such as ``(-1,-3|QQ)``, or
    ``(a,b|F)`` with unknown constants. ``timeout`` bounds the time in seconds. Raises
    :class:`NotationError` or :class:`RingError` for what cannot be read; never guesses: what no
    procedure settles is ``undecided``, with what was tried.
    """
    return answer(read_question(statement, field, given, algebra, timeout))


def answer(question: Question) -> Decision:
    """Answer a question, in a process of its own where a single step may take long."""
    if is_risky(question.problem):
        decision = decide_apart(question)
        if decision is not None:
            return decision
    return answer_here(question)


def answer_here(question: Question) -> Decision:
    """Answer a question in this process, whatever the risk."""
    problem = replace(question.problem, clock=Clock.of(question.timeout))
    return _decided(problem, problem.field, question.timeout)


@remembered
def _decided(problem: Problem, ring: Ring | None, timeout: float) -> Decision:
    """Try the method chosen, where the algebra exists; ``ring`` and ``timeout`` are for the memory."""
    exists = algebra_exists(problem)
    if exists is False:
        return _no_algebra(problem)
    try:
        decision = chosen(problem)(problem)
        if decision.verdict == UNDECIDED:
            found = decide_in_subfields(problem, lambda p: chosen(p)(p))
            found = _never_false(problem) if found is None else found
            decision = decision if found is None else found
    except (TooLargeError, UndecidedError) as error:  # such as digits that are not known
        return undecided(str(error))
    if exists is None and decision.verdict in (PROVED, VACUOUS):
        tried = ("values of the letters for which the structure constants are defined",)
        return undecided(*tried)
    return decision


def _never_false(problem: Problem) -> Decision | None:
    """Prove, without certificate, what fails only at solutions of equations that have none."""
    field = problem.field
    if problem.statement.exists or field is None or not (field.is_exact and field.is_field):
        return None
    if not closed_solutions(problem.about(Not(problem.matrix))).none:
        return None
    steps = (say("no-counterexample", F=field.name),)
    return Decision(PROVED, LINEAR_ALGEBRA, steps=steps, scope=FIELD)


def chosen(problem: Problem) -> Callable[[Problem], Decision]:
    """Return the method for a problem: by whether something is said to exist, and what is assumed."""
    if problem.statement.hypotheses:
        return _with_hypotheses
    return _plainly(problem)


def _plainly(problem: Problem) -> Callable[[Problem], Decision]:
    return quantifiers.decide if problem.statement.exists else universal.decide


def _with_hypotheses(problem: Problem) -> Decision:
    """Decide what assumes something; what nothing satisfies is vacuous."""
    decision = _plainly(problem)(problem)
    if decision.verdict != PROVED:
        return decision
    vacuous = quantifiers.vacuous(problem)
    return decision if vacuous is None else vacuous


def _no_algebra(problem: Problem) -> Decision:
    """Return the decision about an algebra whose structure constants are never defined."""
    setting = problem.setting
    where = say("any-field") if setting.field is None else setting.field.name
    named = "no-algebra-for" if setting.letters else "no-algebra"
    why = say(named, A=setting.algebra, F=where, letters=", ".join(setting.letters))
    return Decision(NOT_APPLICABLE, NONE, steps=(why,), tried=(why,))
