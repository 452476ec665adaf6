"""The decision: which procedure is tried when, over one field or over all at once."""

from collections.abc import Iterable
from functools import lru_cache
from time import monotonic

from hfield.errors import TooLargeError
from hfield.proving.decision import NOT_APPLICABLE, PROVED, UNDECIDED, VACUOUS, Decision
from hfield.proving.existence import quantifiers
from hfield.proving.methods import all_fields, one_ring
from hfield.proving.statements.definedness import algebra_exists
from hfield.proving.statements.language import Statement, read_statement
from hfield.proving.statements.setting import Setting, read_setting
from hfield.proving.subprocess_limits import decide_apart, is_risky
from hfield.rings.base import Ring

TIMEOUT = 30.0


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
    return read_and_decide(statement, field, tuple(given), algebra, timeout)[2]


def read_and_decide(
    statement: str,
    field: Ring | str | None,
    given: tuple[str, ...],
    algebra: str | None,
    timeout: float,
) -> tuple[Statement, Setting, Decision]:
    """Decide as :func:`decide` does; return the statement and the setting as they were read too."""
    setting = read_setting(field, algebra)
    read = read_statement(statement, setting.field, given, setting.letters, setting.constants)
    if is_risky(read, setting):
        decision = decide_apart(statement, setting, given, algebra, timeout)
        if decision is not None:
            return read, setting, decision
    return read, setting, decide_statement(read, setting, timeout)


@lru_cache(maxsize=8192)
def decide_statement(statement: Statement, setting: Setting, timeout: float = TIMEOUT) -> Decision:
    """Decide a statement that has been read."""
    deadline = monotonic() + timeout
    decide_one = all_fields.decide if setting.field is None else one_ring.decide
    exists = algebra_exists(statement, setting, deadline)
    if exists is False:
        return _no_algebra(setting)
    try:
        if statement.exists:
            decision = quantifiers.decide(statement, setting, deadline, decide_one)
        else:
            decision = decide_one(statement, setting, deadline)
            if decision.verdict == PROVED and statement.hypotheses:
                vacuous = quantifiers.vacuous(statement, setting, deadline, decide_one)
                decision = decision if vacuous is None else vacuous
    except TooLargeError as error:
        return Decision(UNDECIDED, "none", tried=(str(error),))
    if exists is None and decision.verdict in (PROVED, VACUOUS):
        tried = ("values of the letters for which the structure constants are defined",)
        return Decision(UNDECIDED, "none", tried=tried)
    return decision


def _no_algebra(setting: Setting) -> Decision:
    """Return the decision about an algebra whose structure constants are never defined."""
    where = "any field" if setting.field is None else setting.field.name
    values = f" for any {', '.join(setting.letters)}" if setting.letters else ""
    why = f"there is no algebra {setting.algebra}: its constants are not defined in {where}{values}"
    return Decision(NOT_APPLICABLE, "none", steps=(why,), tried=(why,))
