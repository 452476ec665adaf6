"""Samples of rotations: uniformly random by Haar measure, or evenly spaced on a spiral."""

import operator
from collections.abc import Sequence

import numpy as np

from rotation.array_types import Array, Seed
from rotation.errors import RotationError

_PSI = 1.533751168755204288118041  # ψ⁴ = ψ + 4


def as_shape(shape: int | Sequence[int] | None) -> tuple[int, ...]:
    """Return a batch shape: ``()`` for None, ``(n,)`` for a number."""
    if shape is None:
        return ()
    try:
        batch = (
            (operator.index(shape),)
            if isinstance(shape, int) or not isinstance(shape, Sequence)
            else tuple(map(operator.index, shape))
        )
    except TypeError:
        batch = (-1,)
    if batch and min(batch) < 0:
        raise RotationError(
            f"shape {shape!r}: a number of rotations or a tuple of such numbers is expected"
        )
    return batch


def generator(rng: Seed | None, seed: Seed | None) -> "np.random.Generator":
    """Return the random generator given by one of two arguments. Raises RotationError for other values."""
    if rng is not None and seed is not None:
        raise RotationError("rng and seed are two names of the same argument; give only one")
    given = seed if rng is None else rng
    try:
        return np.random.default_rng(given)
    except (TypeError, ValueError) as error:
        raise RotationError(
            f"seed {given!r}: a nonnegative whole number or a numpy Generator is expected ({error})"
        ) from error


def super_fibonacci(n: int) -> Array:
    """Return n unit quaternions (n, 4) on a spiral that fills the sphere evenly.

    M. Alexa, "Super-Fibonacci spirals: fast, low-discrepancy sampling of SO(3)", CVPR 2022. Two angles grow
    by turns divided by √2 and by ψ, the positive root of ψ⁴ = ψ + 4, while the radii divide the volume
    evenly.
    """
    try:
        number = operator.index(n)
    except TypeError:
        number = -1
    if number < 0:
        raise RotationError(f"{n!r} rotations: a whole number, not negative, is expected")
    s = np.arange(number) + 0.5
    share = s / max(number, 1)
    inner, outer = np.sqrt(share), np.sqrt(1.0 - share)
    a, b = (2.0 * np.pi * np.remainder(s / turn, 1.0) for turn in (2.0**0.5, _PSI))
    return np.stack(
        [inner * np.sin(a), inner * np.cos(a), outer * np.sin(b), outer * np.cos(b)], axis=-1
    )


def uniform(shape: tuple[int, ...], rng: "np.random.Generator") -> Array:
    """Return uniformly distributed unit quaternions (…, 4): normal coordinates, normalised."""
    q = rng.standard_normal((*shape, 4))
    q /= np.sqrt(np.sum(q * q, axis=-1, keepdims=True))
    return q
