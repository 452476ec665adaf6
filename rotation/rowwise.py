"""Formulas on whole arrays, row by row the same: long numpy arrays in pieces, one row by itself.

A formula of a hundred operations on a million rows reads and writes memory a hundred times; on pieces
that stay in the processor's cache it does so once. On one row it is a hundred calls of numpy; with
Python's own floats it takes a tenth of the time.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from rotation.namespaces import Array
from rotation.scalars import Row

MANY = 50_000  # rows for which it pays to import numba, where there is a kernel
_ROWS = 16384


def in_pieces(formula: Callable[..., Array], *arrays: Array, rank: int = 1) -> Array:
    """Return ``formula(*arrays)``, computed piece by piece, or with Python's floats, where faster.

    Parameters
    ----------
    formula : callable
        Treats every row alike and on its own. It asks its arguments for their namespace.
    *arrays : array, shapes (…, *components)
        Of one array library; their batch shapes broadcast.
    rank : int
        The number of axes of one row.
    """
    for a in arrays:
        if type(a) is not np.ndarray or a.ndim != rank:
            break
    else:
        return _on_one_row(formula, arrays)
    batches = {a.shape[: a.ndim - rank] for a in arrays}
    rows = max(int(np.prod(b, dtype=np.int64)) for b in batches)
    if rows <= _ROWS or not all(isinstance(a, np.ndarray) for a in arrays):
        return formula(*arrays)
    batch = np.broadcast_shapes(*batches)
    if len(batches) > 1 and any(b and b != batch for b in batches):
        return formula(*arrays)
    flat = [a if a.ndim == rank else a.reshape(rows, *a.shape[a.ndim - rank :]) for a in arrays]
    result: Any = None
    for start in range(0, rows, _ROWS):
        piece = slice(start, start + _ROWS)
        part = formula(*(a if a.ndim == rank else a[piece] for a in flat))
        if result is None:
            result = np.empty((rows, *part.shape[1:]), part.dtype)
        result[piece] = part
    return result.reshape(*batch, *result.shape[1:])


def _on_one_row(formula: Callable[..., Array], arrays: tuple[Array, ...]) -> Array:
    """Compute with Python's floats, unless there is inf or NaN, or they come up: numpy has rules for them."""
    rows = [Row(a) for a in arrays]
    for row in rows:
        if not row.finite:
            return formula(*arrays)
    try:
        result = formula(*rows)
    except (ArithmeticError, ValueError):
        return formula(*arrays)
    return result if isinstance(result, np.ndarray) else np.float64(result)
