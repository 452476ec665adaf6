"""What is asked: the words of whoever asks, and the problem that they are."""

from collections.abc import Iterable
from dataclasses import dataclass

from hfield.proving.problem import Problem
from hfield.proving.statements.language import read_statement
from hfield.proving.statements.setting import read_setting
from hfield.rings.base import Ring

TIMEOUT = 30.0


@dataclass(frozen=True)
class Question:
    """A ``problem``, whose clock does not run yet, and the texts from which it was read.

    ``given`` are the hypotheses that were named apart, ``algebra`` is None for H, ``timeout`` in seconds.
    """

    text: str
    given: tuple[str, ...]
    algebra: str | None
    timeout: float
    problem: Problem


def read_question(
    statement: str,
    field: Ring | str | None = None,
    given: Iterable[str] = (),
    algebra: str | None = None,
    timeout: float = TIMEOUT,
) -> Question:
    """Read a question. Raises :class:`NotationError` or :class:`RingError` for what cannot be read."""
    hypotheses, setting = tuple(given), read_setting(field, algebra)
    read = read_statement(statement, setting.field, hypotheses, setting.letters, setting.constants)
    return Question(statement, hypotheses, algebra, timeout, Problem(read, setting))
