"""Rotations at random, uniform by Haar measure, the same for the same seed."""

import operator
from collections.abc import Sequence
from typing import Any

import numpy as np

from rotation.arrays import Array
from rotation.errors import RotationError


def as_shape(shape: int | Sequence[int] | None) -> tuple[int, ...]:
    """Return a batch shape: ``()`` for None, ``(n,)`` for a number."""
    try:
        batch = () if shape is None else tuple(map(operator.index, _listed(shape)))
    except TypeError:
        batch = (-1,)
    if any(n < 0 for n in batch):
        raise RotationError(
            f"shape {shape!r}: a number of rotations or a tuple of such numbers is expected"
        )
    return batch


def _listed(shape: int | Sequence[int]) -> Sequence[int]:
    return shape if isinstance(shape, Sequence) else (shape,)


def generator(rng: Any, seed: Any) -> "np.random.Generator":
    """Return the generator that one of the two stands for; raises RotationError where none can be."""
    if rng is not None and seed is not None:
        raise RotationError("rng and seed are two names of one thing; give one of them")
    given = seed if rng is None else rng
    try:
        return np.random.default_rng(given)
    except (TypeError, ValueError) as error:
        raise RotationError(
            f"seed {given!r}: a nonnegative whole number or a numpy Generator is expected ({error})"
        ) from error


def uniform(shape: tuple[int, ...], rng: "np.random.Generator") -> Array:
    """Return unit quaternions (…, 4) uniform on the sphere: normal coordinates, normalised."""
    q = rng.standard_normal((*shape, 4))
    q /= np.sqrt(np.sum(q * q, axis=-1, keepdims=True))
    return q
