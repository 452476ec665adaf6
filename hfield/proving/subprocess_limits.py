"""Deciding in a process of its own, which is ended when its time is over or its memory full.

Nearly everything is decided where it is asked, since the procedures estimate before they begin. Some
things cannot be estimated: factoring structure constants of many digits, or comparing nested roots.
"""

import json
import subprocess
import sys
from collections.abc import Iterable
from typing import Any

from hfield.errors import HFieldError
from hfield.proving.decision import UNDECIDED, Decision
from hfield.proving.statements.language import Statement
from hfield.proving.statements.setting import Setting
from hfield.rings import ring
from hfield.syntax import weight

MEMORY = 1 << 30
GRACE = 1.0  # seconds beyond the time limit for starting and answering
MAX_DIGITS = 12
MAX_WEIGHT = 300
SLOW_WEIGHT = 60  # where roots of numbers are compared
MAX_NAME = 24


def is_risky(statement: Statement, setting: Setting) -> bool:
    """Tell whether deciding may take long in a single step, which no time limit could end."""
    heaviest = max(weight(n) for n in (*statement.hypotheses, statement.conclusion))
    digits = sum(c.isdigit() for text in setting.constants for c in text)
    field = setting.field
    if digits > MAX_DIGITS or heaviest > MAX_WEIGHT:
        return True
    if field is None:
        return False
    slow = field.name in ("RR", "CC") and heaviest > SLOW_WEIGHT
    return slow or len(field.name) > MAX_NAME


def decide_apart(
    statement: str,
    setting: Setting,
    given: Iterable[str],
    algebra: str | None,
    timeout: float,
) -> Decision | None:
    """Decide in another process; None when the field is a user's own, which has no name there."""
    field = None if setting.field is None else setting.field.name
    if field is not None and not _is_ours(field, setting):
        return None
    request = {
        "statement": statement,
        "field": field,
        "given": list(given),
        "algebra": algebra,
        "timeout": timeout,
    }
    try:
        done = subprocess.run(
            [sys.executable, "-m", "hfield.proving.subprocess_worker", str(MEMORY)],
            input=json.dumps(request),
            capture_output=True,
            text=True,
            timeout=timeout + GRACE,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return _given_up(f"the time of {timeout:g} s was over")
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        return _given_up(f"the work needed more than {MEMORY >> 20} MiB of memory, or failed")
    return from_json(answer)


def _is_ours(name: str, setting: Setting) -> bool:
    try:
        return type(ring(name)) is type(setting.field)
    except HFieldError:
        return False


def _given_up(why: str) -> Decision:
    return Decision(UNDECIDED, "none", tried=(f"{why}, in a process of its own",))


def from_json(data: dict[str, Any]) -> Decision:
    """Return a decision from what :func:`dataclasses.asdict` made of it."""
    tuples = {name: tuple(data[name]) for name in ("steps", "assumes", "tried")}
    return Decision(**{**data, **tuples})
