"""Rotations at random, uniform by Haar measure, the same for the same seed."""

import operator
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

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


def uniform(shape: tuple[int, ...], rng: Any = None) -> npt.NDArray[np.float64]:
    """Return unit quaternions (…, 4) uniform on the sphere: normal coordinates, normalised."""
    q = np.random.default_rng(rng).standard_normal((*shape, 4))
    q /= np.sqrt(np.sum(q * q, axis=-1, keepdims=True))
    return q
