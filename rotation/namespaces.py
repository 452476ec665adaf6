"""Choose the array library of a call: numpy for plain arguments, else the library of the array.

The conversions of this package are written against the Python array API standard, so arrays of JAX, CuPy,
torch or array-api-strict keep their library and device. numpy warnings are disabled inside them: a NaN in the
input gives a NaN in the output without a warning.
"""

import contextlib
from collections.abc import Sequence
from importlib import import_module
from typing import cast

import numpy as np

from rotation.array_types import NUMPY, Array, Limits, Namespace
from rotation.arrays import expect_numbers, real
from rotation.errors import DTypeError, ForeignArrayError, RotationError, ZeroRotationError
from rotation.native import tracing
from rotation.native.symbols import LaneMask, Lanes, Rows

quiet = np.errstate(all="ignore")

_FLOAT64 = np.dtype(np.float64)
_PLAIN = (int, float, list, tuple, type(None))


def namespace(*values: object) -> Namespace:
    """Return the common array namespace of all ``values``; numbers and lists fit every namespace.

    Raises
    ------
    ForeignArrayError
        The values are arrays of two libraries.
    """
    if len(values) == 1:
        return _own_namespace(values[0]) or NUMPY
    found: list[Namespace] = []
    for value in values:
        xp = _own_namespace(value)
        if xp is not None and all(xp is not other for other in found):
            found.append(xp)
    if len(found) > 1:
        first, *_, last = names = sorted(
            (xp.__name__.removeprefix("array_api_compat.") for xp in found), key="numpy".__eq__
        )
        way = (
            ""
            if last != "numpy"
            else (
                f"; a rotation r of numpy's becomes one of theirs as Rotation({first}.asarray(r.as_quat())), "
                f"a motion as RigidTransform({first}.asarray(t.as_matrix()))"
            )
        )
        raise ForeignArrayError(
            f"arrays of {' and '.join(names)} in one operation; convert one of them, for example with "
            f"{last}.asarray{way}"
        )
    return found[0] if found else NUMPY


def is_numpy(xp: object) -> bool:
    """Return whether a namespace is numpy's own."""
    return xp is NUMPY


def finfo(xp: Namespace, number: Array) -> Limits:
    """Return the limits of the float type of a coordinate."""
    return xp.finfo(getattr(number, "dtype", None))


def expect_numpy(what: str, *values: object) -> None:
    """Raise `ForeignArrayError` unless all ``values`` are numpy arrays or plain numbers and lists."""
    for xp in map(namespace, values):
        if not is_numpy(xp):
            raise ForeignArrayError(f"{what} takes numpy arrays only, not those of {xp.__name__}")


def _own_namespace(value: object) -> Namespace | None:
    kind = type(value)
    if kind is np.ndarray or isinstance(value, np.ndarray | np.generic):
        return NUMPY
    if kind in (Lanes, LaneMask, Rows):
        return tracing.NAMESPACE
    if kind in _PLAIN or isinstance(value, int | float | complex | str | bytes | Sequence):
        return None
    if hasattr(value, "__array_namespace__"):
        return cast(Namespace, value.__array_namespace__())
    # torch and older CuPy do not provide their namespace; the compatibility package does.
    if type(value).__module__.partition(".")[0] in ("torch", "cupy"):
        with contextlib.suppress(ImportError):
            return cast(Namespace, import_module("array_api_compat").array_namespace(value))
        raise ForeignArrayError(
            f"{type(value).__name__} does not say which array namespace it has; install array-api-compat to "
            "have it recognised"
        )
    return None


def floats(value: object, what: str, xp: Namespace | None = None) -> Array:
    """Return ``value`` as an array of floats: float64 in numpy, the array's own precision in other libraries.

    Parameters
    ----------
    value : array_like
        Integers or real floats.
    what : str
        What the value is, for the message.
    xp : namespace, optional
        The device for the array; by default its present device.

    Raises
    ------
    DTypeError
        The numbers are of another type (complex, object, text, boolean).
    RotationError
        Nested lists of unequal lengths.
    """
    if type(value) is np.ndarray and value.dtype is _FLOAT64 and (xp is None or xp is NUMPY):
        return value
    xp = namespace(value) if xp is None else xp
    if is_numpy(xp):
        return real(value, what).astype(np.float64, copy=False)
    array = cast(Array, value) if _own_namespace(value) else _as_array(xp, value, what)
    if xp.isdtype(array.dtype, "real floating"):
        if xp.finfo(array.dtype).bits < 32:
            raise DTypeError(
                f"{what} has dtype {array.dtype}, too coarse for rotations; convert to float32 or float64"
            )
        return array
    if xp.isdtype(array.dtype, "integral"):
        return xp.astype(array, xp.zeros(()).dtype)  # the library's default precision
    raise DTypeError(f"{what} has dtype {array.dtype}; expected integers or real floats")


def points_of(value: object, xp: Namespace) -> Array:
    """Return points (…, 3) in their own precision; integers become the library's default floats."""
    points: Array = real(value, "points") if is_numpy(xp) else floats(value, "points", xp)
    expect_last(points, (3,), "points")
    return points


def number(value: int | float, what: str) -> float:
    """Return a plain number as a float.

    Raises
    ------
    RotationError
        A whole number beyond the largest float.
    """
    try:
        return float(value)
    except OverflowError as error:
        raise RotationError(
            f"{what} is a whole number of {int(value).bit_length()} bits, beyond the largest float, "
            "1.8e308; where the rotation has a finite order, take the remainder by it"
        ) from error


def _as_array(xp: Namespace, value: object, what: str) -> Array:
    """Return numbers or nested lists as an array of a library, with our error messages instead of the
    library's.
    """
    expect_numbers(value, what)
    try:
        return xp.asarray(value)
    except (TypeError, ValueError, RuntimeError) as error:
        numbers = real(value, what)
        try:
            return xp.asarray(numbers.tolist())  # of sympy
        except (TypeError, ValueError, RuntimeError):
            raise RotationError(f"{what} is not an array of numbers: {error}") from error


def copied(array: Array) -> Array:
    """Return a copy that derivatives pass through."""
    return (
        array.copy() if is_numpy(namespace(array)) else namespace(array).astype(array, array.dtype)
    )


def expect_last(array: Array, shape: tuple[int, ...], what: str) -> None:
    """Raise `RotationError` unless the last axes of ``array`` have ``shape``."""
    if tuple(array.shape[-len(shape) :]) != shape:
        wanted = ", ".join(map(str, shape))
        raise RotationError(f"{what} has shape {tuple(array.shape)}; expected (…, {wanted})")


def spread(xp: Namespace, array: Array, shape: tuple[int, ...], what: str) -> Array:
    """Return ``array`` broadcast to ``shape``; raises `RotationError` if it does not broadcast, in any
    library.
    """
    own = tuple(array.shape)
    try:
        fits = np.broadcast_shapes(own, shape) == shape
    except ValueError:
        fits = False
    if not fits:
        raise RotationError(f"{what} of shape {own} do not broadcast to {shape}")
    return xp.broadcast_to(array, shape)


def certainly(condition: Array) -> bool:
    """Return the truth value of a condition on one number; False if it is traced.

    While JAX traces a function, or torch maps one over a batch, values are unknown and no argument can be
    rejected; then the result is False.
    """
    try:
        return bool(condition)
    except TypeError:  # a tracer has no truth
        return False
    except RuntimeError:  # nor has torch's
        if type(condition).__module__.partition(".")[0] != "torch":
            raise
        return False


def first_row(bad: Array) -> tuple[int, ...] | None:
    """Return the index of the first row where ``bad`` is true, or None."""
    xp = namespace(bad)
    if not certainly(xp.any(bad) if bad.ndim else bad):
        return None
    return tuple(int(axis[0]) for axis in xp.nonzero(bad)) if bad.ndim else ()


def refuse_zeros(vectors: Array, what: str) -> None:
    """Raise `ZeroRotationError` with the index of the first zero row of ``vectors``."""
    xp = namespace(vectors)
    if is_numpy(xp) and not (vectors[..., 0] == 0.0).any():  # which clears most arrays, for little
        return
    row = first_row(xp.all(vectors == 0.0, axis=-1))
    if row is not None:
        raise ZeroRotationError(what, row)


def refuse_rows(bad: Array, subject: str, fault: str) -> None:
    """Raise `RotationError`, "``subject`` in row 3 ``fault``", for the first row where ``bad`` is true."""
    row = first_row(bad)
    if row is not None:
        where = f" in row {row[0] if len(row) == 1 else row}" if row else ""
        raise RotationError(f"{subject}{where} {fault}")
