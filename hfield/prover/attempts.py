"""Try methods in turn; a method that raises does not stop the next."""

from collections.abc import Callable, Iterable
from typing import ParamSpec, TypeAlias, TypeVar

from hfield.errors import HFieldError
from hfield.prover.decision import Decision, undecided

Method: TypeAlias = Callable[[], Decision | None]

P = ParamSpec("P")
T = TypeVar("T")


class Attempts:
    """Calls methods, and collects the reasons of those that raise.

    >>> from hfield import QQ
    >>> attempts = Attempts()
    >>> attempts.answer(QQ.inverse, QQ(2)), attempts.answer(QQ.inverse, QQ(0)), attempts.refusals
    (1/2, None, ('cannot divide by 0 in QQ',))
    """

    def __init__(self) -> None:
        self._refusals: dict[str, None] = {}

    @property
    def refusals(self) -> tuple[str, ...]:
        """The reasons, each once."""
        return tuple(self._refusals)

    def answer(self, method: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T | None:
        """Return the result of a method, or None if the work is too large or the question undecided."""
        try:
            return method(*args, **kwargs)
        except HFieldError as error:
            self._refusals.setdefault(str(error))
            return None

    def decide(self, methods: Iterable[Method], *tried: str) -> Decision:
        """Return the answer of the first method that has one, else "undecided" with the reasons."""
        decision = self.first(methods)
        return undecided(*self.refusals, *tried) if decision is None else decision

    def first(self, methods: Iterable[Method]) -> Decision | None:
        """Return the answer of the first method that has one."""
        for method in methods:
            decision = self.answer(method)
            if decision is not None:
                return decision
        return None
