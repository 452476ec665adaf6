"""Many cases of a test in one item, which names the case that fails."""

import functools
import inspect
from collections.abc import Callable, Iterable
from typing import Any

import pytest


def subcases(names: str | tuple[str, ...], values: Iterable[Any]) -> Callable[..., Any]:
    """Return a decorator like ``pytest.mark.parametrize`` that runs all cases in one test.

    Thousands of items cost more to collect than to run. Fixtures are shared by the cases. Cases
    that skip are passed over; the test skips if all of them do.

    >>> @subcases("n", [2, 4])
    ... def is_even(n):
    ...     assert n % 2 == 0
    >>> is_even()
    """
    keys = tuple(names.replace(",", " ").split()) if isinstance(names, str) else names
    cases = [dict(zip(keys, (v,) if len(keys) == 1 else v, strict=True)) for v in values]

    def decorate(test: Callable[..., None]) -> Callable[..., None]:
        @functools.wraps(test)
        def run(**fixtures: Any) -> None:
            skipped = []
            for case in cases:
                try:
                    test(**case, **fixtures)
                except pytest.skip.Exception as reason:
                    skipped.append(reason)
                except BaseException as error:
                    error.add_note(f"the case is {case!r}")
                    raise
            if cases and len(skipped) == len(cases):
                raise skipped[0]

        signature = inspect.signature(test)
        rest = [p for name, p in signature.parameters.items() if name not in keys]
        run.__signature__ = signature.replace(parameters=rest)  # type: ignore[attr-defined]
        return run

    return decorate


def first_quick(cases: Iterable[Any], count: int) -> list[Any]:
    """Return cases for ``pytest.mark.parametrize``, all but the first so many marked slow."""
    return [case if n < count else _slow(case) for n, case in enumerate(cases)]


def share_quick(cases: Iterable[Any], step: int) -> list[Any]:
    """Return cases for ``pytest.mark.parametrize``, all but every so-many-th marked slow."""
    return [_slow(case) if n % step else case for n, case in enumerate(cases)]


def pairs_quick(firsts: Iterable[Any], seconds: Iterable[Any], step: int) -> list[Any]:
    """Return all pairs for ``pytest.mark.parametrize``, one of so many quick, so that all values come.

    >>> [pair for pair in pairs_quick("ab", (1, 2), 2) if not hasattr(pair, "marks")]
    [('a', 1), ('b', 2)]
    """
    others = list(seconds)
    return [
        slow(x, y) if (m + n) % step else (x, y)
        for m, x in enumerate(firsts)
        for n, y in enumerate(others)
    ]


def _slow(case: Any) -> Any:
    return slow(*case) if isinstance(case, tuple) else slow(case)


def slow(*values: Any) -> Any:
    """Return one case for ``pytest.mark.parametrize`` that is marked slow."""
    return pytest.param(*values, marks=pytest.mark.slow)
