"""One row of Python floats as an array namespace: a formula on one rotation, without arrays' overhead.

The formulas of this package take their functions from a namespace. Given a `Row` they get those here,
and compute with Python's floats, some ten times faster than with arrays of one entry, to the same
bits: what is not rounded correctly by rule, such as the sine, is asked of numpy. Only what the
formulas use is here. Rows are finite; what Python's floats refuse, such as 1/0, raises.
"""

import math
from types import SimpleNamespace
from typing import Any, Final

import numpy as np

_INFO = np.finfo(np.float64)
_FLOAT64 = SimpleNamespace(
    bits=64,
    eps=float(_INFO.eps),
    smallest_normal=float(_INFO.smallest_normal),
    max=float(_INFO.max),
)

nan: Final = math.nan
abs = math.fabs
sqrt = math.sqrt


class Row:
    """The numbers of one row: of a small array of one axis or two."""

    __slots__ = ("finite", "shape", "values")
    dtype = np.dtype(np.float64)

    def __init__(self, array: np.ndarray[Any, Any]) -> None:
        self.shape = array.shape
        self.values: list[float] = array.ravel().tolist()
        self.finite = math.isfinite(sum(self.values))  # if so, each is

    def __getitem__(self, index: tuple[Any, ...]) -> float:
        """Return the number at ``[..., n]`` or ``[..., r, c]``."""
        row = index[1] * self.shape[-1] if len(index) == 3 else 0
        number: float = self.values[row + index[-1]]
        return number


def sin(x: float) -> float:
    """Return the sine, as numpy rounds it."""
    return float(np.sin(x))


def cos(x: float) -> float:
    """Return the cosine, as numpy rounds it."""
    return float(np.cos(x))


def atan2(y: float, x: float) -> float:
    """Return the angle of the point (x, y), as numpy rounds it."""
    return float(np.arctan2(y, x))


def atan(x: float) -> float:
    """Return the arc tangent, as numpy rounds it."""
    return float(np.arctan(x))


def remainder(x: float, y: float) -> float:
    """Return ``x`` modulo ``y``, with the sign of ``y``."""
    return x % y


def maximum(x: float, y: float) -> float:
    """Return the larger of two numbers."""
    return y if y > x else x


def where(condition: Any, yes: Any, no: Any) -> Any:
    """Return one of two values."""
    return yes if condition else no


def any(condition: Any) -> bool:
    """Return whether the condition holds in the one row."""
    return bool(condition)


def all(condition: Any, axis: Any = None) -> bool:
    """Return whether the condition holds in the one row."""
    return bool(condition)


def isfinite(values: Any) -> bool:
    """Return True: rows are finite."""
    return True


def finfo(dtype: Any) -> Any:
    """Return the limits of float64."""
    return _FLOAT64


def ones_like(values: Any) -> float:
    """Return 1."""
    return 1.0


def zeros_like(values: Any) -> float:
    """Return 0."""
    return 0.0


def full_like(values: Any, number: float) -> float:
    """Return the number."""
    return number


def broadcast_arrays(*values: Any) -> tuple[Any, ...]:
    """Return the numbers: they have one shape already."""
    return values


def stack(values: Any, axis: int = 0) -> np.ndarray[Any, Any]:
    """Return numbers, or arrays made of them, as the array they are the rows of."""
    return np.array(values, np.float64)
