"""Deciding in a process of its own, which is ended when its time is over or its memory full.

Nearly everything is decided where it is asked, since the procedures estimate before they begin. Some
things cannot be estimated: factoring structure constants of many digits, or comparing nested roots.
"""

import sys

from hfield.errors import HFieldError
from hfield.fields.names import ring
from hfield.proving.decision import Decision, undecided
from hfield.proving.problem import Problem
from hfield.proving.question import Question
from hfield.rings.base import Ring

MEMORY = 1 << 30
GRACE = 1.0  # seconds beyond the time limit for starting and answering
MAX_DIGITS = 12
MAX_WEIGHT = 300
SLOW_WEIGHT = 60  # where roots of numbers are compared
MAX_NAME, MAX_NAME_DIGITS = 60, 20  # of a field: long names and long numbers make slow arithmetic


def is_risky(problem: Problem) -> bool:
    """Tell whether deciding may take long in a single step, which no time limit could end."""
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


def decide_apart(question: Question) -> Decision | None:
    """Decide in another process; None when the field is a user's own, which has no name there."""
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
            [sys.executable, "-m", "hfield.proving.subprocess_worker", str(MEMORY)],
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
