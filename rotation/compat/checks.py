"""Check arguments as scipy does, with its error messages."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from rotation import hints
from rotation.array_types import Array, ArrayLike, Axes
from rotation.arrays import expect_unmasked
from rotation.errors import DTypeError, RotationError
from rotation.namespaces import expect_numpy, number
from rotation.rigid import RigidTransform
from rotation.rotation import Rotation


def doubles(value: object, name: str) -> Array:
    """Return a float64 array, with numpy's own errors; masked arrays are rejected."""
    expect_unmasked(value, name)
    return np.asarray(value, dtype=np.float64)


def quaternions(value: Any) -> Array | None:
    """Return the quaternions, scalar first, of rotations of this package, rotation.compat or scipy; else
    None.
    """
    found = hints.kind(value)
    if found is None or found.name != "Rotation":
        return None
    if found.home == hints.COMPAT:
        stored: Array = value._q
        return stored
    q = value._double if found.home == hints.OURS else Rotation.from_scipy(value)._q
    expect_numpy("rotation.compat", q)
    return np.array(q)


def matrices(value: Any) -> Array | None:
    """Return the matrices (…, 4, 4) of transforms of this package, rotation.compat or scipy; else None."""
    found = hints.kind(value)
    if found is None or found.name != "RigidTransform":
        return None
    if found.home == hints.COMPAT:
        stored: Array = value._matrix
        return stored
    m = value.as_matrix()
    expect_numpy("rotation.compat", m)
    return np.array(m)


def motions(value: object) -> Array | None:
    """Return the matrices of transforms, and of rotations as transforms without translation; else None."""
    q = quaternions(value)
    if q is None:
        return matrices(value)
    return RigidTransform.from_rotation(Rotation(q)).as_matrix()


def expected(array: Array | None, value: object, words: str) -> Array:
    """Return the result of `quaternions` or `matrices`; raise DTypeError, with ``words``, if it is None."""
    if array is None:
        raise DTypeError(f"{words}; this is {hints.described(value)}")
    return array


def refuse_factor(value: object, other: object) -> None:
    """Raise DTypeError, with advice, for a product of a rotation with an unsupported transform."""
    if hints.kind(other) == (hints.COMPAT, "RigidTransform"):
        return
    found = {getattr(hints.kind(x), "name", None) for x in (value, other)}
    if found == set(hints.NAMES):
        raise DTypeError(
            "a Rotation beside a RigidTransform: write RigidTransform.from_rotation(r)"
        )


def numbers(value: object, name: str, shape: str, last: tuple[int, ...]) -> Array:
    """Return ``value`` as float64; its last axes have the lengths ``last``."""
    array = doubles(value, name)
    if array.ndim < len(last) or array.shape[array.ndim - len(last) :] != last:
        raise RotationError(f"Expected `{name}` to have shape {shape}, got {array.shape}.")
    return array


def common(one: tuple[int, ...], other: tuple[int, ...], what: str = "Cannot broadcast") -> None:
    """Raise RotationError unless two batch shapes broadcast."""
    try:
        np.broadcast_shapes(one, other)
    except ValueError:
        raise RotationError(f"{what} in both rotations, got {one} and {other}.") from None


def batch(num: int | None, shape: object) -> tuple[int, ...]:
    """Return the batch shape given by scipy's ``num`` or ``shape``."""
    if num is not None and shape is not None:
        raise RotationError("Only one of `num` or `shape` can be given.")
    if shape is None:
        return () if num is None else (int(num),)
    given = (shape,) if isinstance(shape, int) else shape
    if not isinstance(given, Iterable) or not all(isinstance(n, int) for n in given):
        raise RotationError("`shape` must be an int or a tuple of ints or None.")
    return tuple(given)


def weighted(weights: ArrayLike | None, shape: tuple[int, ...]) -> Array | None:
    """Return weights that broadcast to ``shape``; they must be nonnegative."""
    if weights is None:
        return None
    w = doubles(weights, "weights")
    try:
        fits = np.broadcast_shapes(w.shape, shape) == shape
    except ValueError:
        fits = False
    if not fits:
        raise RotationError(
            f"Expected `weights` to have number of values equal to number of rotations, "
            f"or a shape that broadcasts: got {w.shape} values and {shape} rotations."
        )
    if np.any(w < 0.0):
        raise RotationError("`weights` must be non-negative.")
    return w


def averaged(axis: Axes | None, ndim: int) -> tuple[int, ...]:
    """Return the axes to average over."""
    if axis is None:
        return tuple(range(ndim))
    axes = axis if isinstance(axis, tuple) else (axis,)
    if not all(isinstance(a, int | np.integer) for a in axes):
        raise RotationError("`axis` must be None, int, or tuple of ints.")
    if any(not -ndim <= a < ndim for a in axes):
        raise RotationError(f"axis {axis} is out of bounds for rotation with shape of {ndim} axes.")
    return tuple({int(a) % ndim for a in axes})


def exponent(n: npt.ArrayLike, modulus: object) -> float:
    """Return an exponent as a number, as scipy accepts it."""
    if modulus is not None:
        raise NotImplementedError("modulus not supported")
    if np.ndim(n) and np.shape(n) != (1,):
        raise RotationError("Array exponent must be a scalar")
    return number(np.reshape(n, ()).item(), "exponent")
