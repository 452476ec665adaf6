"""Arrays of ring elements as numpy object arrays, safe for elements that numpy takes for sequences.

numpy multiplies an object array by a polynomial by running through the polynomial's coefficients,
and turns the product of two 0-dimensional arrays into a bare element, which it would misread in the
next step. :class:`Objects` wraps every operand that is not an array, and keeps 0-dimensional results.
"""

from collections.abc import Callable
from typing import Any

import numpy as np


class Objects(np.ndarray[Any, np.dtype[Any]]):
    """An object array whose entries are ring elements; arithmetic is elementwise."""

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **kwargs: Any) -> Any:
        operands = [_plain(x) for x in inputs]
        if "out" in kwargs:
            kwargs["out"] = tuple(_plain(x) for x in kwargs["out"])
        result = getattr(ufunc, method)(*operands, **kwargs)
        if isinstance(result, tuple):
            return tuple(_dress(x) for x in result)
        return _dress(result)


def objects(values: Any, convert: Callable[[Any], Any]) -> Objects:
    """Return an array of ``convert(x)`` for each x; lists, tuples and arrays nest, all else is one x."""
    if isinstance(values, np.ndarray):
        source = values
    elif isinstance(values, (list, tuple)):
        source = _from_nested(values)
    else:
        source = wrap(values)
    out = np.empty(source.shape, dtype=object)
    for index in np.ndindex(*source.shape):
        out[index] = convert(source[index])
    return out.view(Objects)


def wrap(x: Any) -> np.ndarray[Any, np.dtype[Any]]:
    """Return a 0-dimensional object array that holds x, whatever x is."""
    out = np.empty((), dtype=object)
    out[()] = x
    return out


def _from_nested(values: Any) -> np.ndarray[Any, np.dtype[Any]]:
    """Like np.array(values, dtype=object), but never looking into what is not a list or an array."""
    parts = []
    for x in values:
        if isinstance(x, np.ndarray):
            parts.append(x.astype(object) if not isinstance(x, Objects) else x.view(np.ndarray))
        else:
            parts.append(_from_nested(x) if isinstance(x, (list, tuple)) else wrap(x))
    if not parts:
        return np.empty((0,), dtype=object)
    return np.stack(parts)


def _plain(x: Any) -> Any:
    if isinstance(x, Objects):
        return x.view(np.ndarray)
    return x if isinstance(x, np.ndarray) else wrap(x)


def _dress(x: Any) -> Any:
    if isinstance(x, np.ndarray):
        return x.view(Objects) if x.dtype == object else x
    return x if isinstance(x, (bool, np.bool_)) else wrap(x).view(Objects)
