"""Read and check the arguments of lattices, orders and ideals: elements, numbers, sides."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import flint

from hfield.algebra.quaternion import Quaternion
from hfield.core.primality import is_prime
from hfield.errors import HFieldError, LatticeError, shorten
from hfield.fields.base.coercion import rational

if TYPE_CHECKING:
    from hfield.orders.base import Base


def expect_rational(base: Base, error: HFieldError) -> None:
    """Raise an error over bases other than ℤ; the message names the feature that needs ℤ."""
    if not base.is_rational:
        raise error


def expect_number_field(base: Base, error: HFieldError) -> None:
    """Raise an error over 𝔽_q[t]; the message names the feature that needs ℤ or the integers of a number
    field.
    """
    if base.is_polynomial:
        raise error


def listed(elements: object) -> list[object]:
    """Return elements as a list. Raises :class:`LatticeError` for a single element or another value."""
    if isinstance(elements, (str, Quaternion)) or not isinstance(elements, Iterable):
        raise LatticeError(
            f"{shorten(repr(elements))} is not a list of elements: expected one, such as [e, i, j, k]"
        )
    return list(elements)


def checked_side(side: str) -> str:
    """Return the side. Raises :class:`LatticeError` unless it is ``"left"`` or ``"right"``."""
    if side not in ("left", "right"):
        raise LatticeError(f"the side {side!r} does not exist: expected 'left' or 'right'")
    return side


def positive(n: object, what: str) -> int:
    """Return a positive integer. Raises :class:`LatticeError` for anything else."""
    value = _whole(n)
    if value is None or value < 1:
        raise LatticeError(f"the {what} {shorten(repr(n))} is not a positive integer")
    return value


def _whole(n: object) -> int | None:
    value = rational(n)
    return value if isinstance(value, int) and not isinstance(n, bool) else None


def expect_coprime(level: int, discriminant: int) -> None:
    """Raise :class:`LatticeError` unless a level is prime to the discriminant of the algebra."""
    common = math.gcd(level, discriminant)
    if common > 1:
        raise LatticeError(
            f"the level {level} and the discriminant {discriminant} have the factor {common} in common: "
            "Eichler orders have a level prime to the discriminant"
        )


def integer(n: object, what: str) -> int:
    """Return an integer. Raises :class:`LatticeError` for anything else."""
    value = rational(n)
    if not isinstance(value, int):
        raise LatticeError(f"the {what} {shorten(repr(n))} is not an integer")
    return value


def prime(p: object) -> int:
    """Return a prime as an int. Raises :class:`LatticeError` for another value."""
    if not isinstance(p, (int, flint.fmpz)) or isinstance(p, bool) or not is_prime(int(p)):
        raise LatticeError(f"{shorten(repr(p))} is not a prime number")
    return int(p)


def natural(n: object, what: str) -> int:
    """Return an integer ≥ 0. Raises :class:`LatticeError` for anything else."""
    value = _whole(n)
    if value is None or value < 0:
        raise LatticeError(f"{what} an integer ≥ 0, found {shorten(repr(n))}")
    return value


def weight(k: object) -> int:
    """Return the weight of modular forms, 2, 4, 6, … Raises :class:`LatticeError` for any other."""
    value = _whole(k)
    if value is None or value < 2 or value % 2:
        raise LatticeError(
            f"the weight {shorten(repr(k))} is not one of 2, 4, 6, …: forms with trivial character have an "
            "even weight, the same at all real places"
        )
    return value
