"""Arrays of ring elements as numpy object arrays, safe also for elements that numpy would take for sequences.

If an object array is multiplied by a polynomial, numpy iterates over the polynomial's coefficients. The
product of two 0-dimensional arrays becomes a bare element, which numpy would misread in the next step.
:class:`Objects` wraps every operand that is not an array, and keeps results 0-dimensional.
"""

from collections.abc import Callable, Sequence
from types import EllipsisType
from typing import Any, SupportsIndex, TypeAlias

import numpy as np

from hfield.errors import CoercionError

One: TypeAlias = SupportsIndex | slice | EllipsisType | Sequence[int] | np.ndarray | None
Index: TypeAlias = One | tuple[One, ...]  # the indices that numpy accepts in brackets


class Objects(np.ndarray[tuple[int, ...], np.dtype[np.object_]]):
    """An object array whose entries are ring elements; arithmetic is elementwise."""

    def __array_ufunc__(
        self, ufunc: np.ufunc, method: str, *inputs: object, **kwargs: Any
    ) -> object:
        operands = [_plain(x) for x in inputs]
        if "out" in kwargs:
            kwargs["out"] = tuple(_plain(x) for x in kwargs["out"])
        result = getattr(ufunc, method)(*operands, **kwargs)
        if isinstance(result, tuple):
            return tuple(_dress(x) for x in result)
        return _dress(result)


def objects(values: object, convert: Callable[[Any], object]) -> Objects:
    """Return an array of ``convert(x)`` for each x; lists, tuples and arrays nest, anything else is one x.

    Raises :class:`CoercionError` if the parts of a list differ in shape.
    """
    return _converted(values, convert).view(Objects)


def _converted(values: object, convert: Callable[[Any], object]) -> np.ndarray:
    if isinstance(values, (list, tuple)):
        parts = [_converted(x, convert) for x in values]
        shapes = sorted({x.shape for x in parts})
        if len(shapes) > 1:
            shown = ", ".join(map(str, shapes))
            raise CoercionError(
                f"the parts of the list have the shapes {shown}; expected the same shape for all"
            )
        return np.stack(parts) if parts else np.empty((0,), dtype=object)
    if isinstance(values, np.ndarray) and values.ndim:
        out = np.empty(values.shape, dtype=object)
        for index in np.ndindex(*values.shape):
            out[index] = convert(values[index])
        return out
    return wrap(convert(values))


def wrap(x: object) -> np.ndarray:
    """Return a 0-dimensional object array that contains x, whatever x is."""
    out = np.empty((), dtype=object)
    out[()] = x
    return out


def owned(array: np.ndarray, source: object) -> np.ndarray:
    """Return the result, copied if it shares memory with the source."""
    shared = isinstance(source, np.ndarray) and np.may_share_memory(array, source)
    return array.copy() if shared else array


def read_only(array: np.ndarray) -> np.ndarray:
    """Return a read-only view whose flag cannot be reset."""
    view = array.view()
    base: object = view
    while isinstance(base, np.ndarray):
        base.setflags(write=False)
        base = base.base
    return view


def one_shape(arrays: list[np.ndarray]) -> list[np.ndarray]:
    """Broadcast the coordinate arrays to one shape. Raises :class:`CoercionError` if that is impossible."""
    try:
        shape = np.broadcast_shapes(*(a.shape for a in arrays))
    except ValueError:
        shapes = ", ".join(str(a.shape) for a in arrays)
        raise CoercionError(
            f"the four coordinate arrays have shapes {shapes}; expected one shape for all"
        ) from None
    return [a if a.shape == shape else np.broadcast_to(a, shape, subok=True).copy() for a in arrays]


def check_shapes(left: tuple[int, ...], right: tuple[int, ...], operation: str) -> None:
    """Raise :class:`CoercionError` if the shapes of two arrays do not broadcast."""
    try:
        np.broadcast_shapes(left, right)
    except ValueError:
        raise CoercionError(
            f"cannot {operation} arrays of quaternions of the shapes {left} and {right}: expected one shape "
            "for both, or shapes that broadcast as numpy's do"
        ) from None


def _plain(x: object) -> np.ndarray:
    if isinstance(x, Objects):
        return x.view(np.ndarray)
    return x if isinstance(x, np.ndarray) else wrap(x)


def _dress(x: object) -> object:
    if isinstance(x, np.ndarray):
        return x.view(Objects) if x.dtype == object else x
    return x if isinstance(x, (bool, np.bool_)) else wrap(x).view(Objects)
