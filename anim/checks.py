"""Checks of numbers in user input."""

from collections.abc import Collection
from math import isfinite
from operator import index
from typing import Any

from anim.errors import AnimationError


def whole(name: str, value: Any, least: int, most: int) -> int:
    """Return ``value`` as an int between ``least`` and ``most``, inclusive."""
    try:
        number = index(value)
    except TypeError:
        raise AnimationError(f"{name} must be a whole number, not {value!r}") from None
    if not least <= number <= most:
        raise AnimationError(f"{name} is {number}; expected a number from {least} to {most}")
    return number


def real(name: str, value: Any, *, above: float | None = None, least: float | None = None) -> float:
    """Return ``value`` as a finite float that is greater than ``above`` and at least ``least``."""
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        raise AnimationError(f"{name} must be a real number, not {value!r}") from None
    if not isfinite(number):
        raise AnimationError(f"{name} is {number}; expected a finite number")
    if above is not None and not number > above:
        raise AnimationError(f"{name} is {number:g}; expected a number greater than {above:g}")
    if least is not None and not number >= least:
        raise AnimationError(f"{name} is {number:g}; expected {least:g} or more")
    return number


def one_of(name: str, value: object, choices: Collection[str]) -> str:
    """Return ``value``, which must be one of ``choices``."""
    if not isinstance(value, str) or value not in choices:
        raise AnimationError(f"{name} is {value!r}; expected one of {', '.join(choices)}")
    return value
