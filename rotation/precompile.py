"""Compile all functions that are otherwise compiled on first use."""

from collections.abc import Iterable
from itertools import product

import numpy as np

from rotation import action, euler, jacobians, kernels, rigid_motions, rotation, rowwise
from rotation.array_types import Array
from rotation.curves import spline

_PRECISIONS = ((np.float64, np.float64), (np.float32, np.float64), (np.float32, np.float32))
_ROOMS = (jacobians, rigid_motions, rotation, spline)  # whose formulas are made on import
# For the points and for the rotations: whether there are many, or one for all.
_MANY_OR_ONE = ((True, True), (True, False), (False, True))


def warm_up(sequences: str | Iterable[str] = ("ZYX", "xyz")) -> None:
    """Compile now everything that would be compiled on first use, and cache it on disk if possible.

    This covers each formula, and each loop over contiguous points (…, 3) and (3, …), in both precisions. Each
    takes some hundredths of a second, all of them some seconds, once per machine. None of this is required:
    calls compile what they need, such as a loop for arrays with other strides.

    Parameters
    ----------
    sequences : str or iterable of str
        The Euler sequences that will be used; each takes almost a second, and "all" means the 24 sequences of
        three letters.

    Raises
    ------
    RotationError
        No such sequence.

    Examples
    --------
    >>> import rotation
    >>> rotation.warm_up("XYZ")  # doctest: +SKIP
    """
    if isinstance(sequences, str):
        sequences = euler.SEQUENCES if sequences == "all" else (sequences,)
    turns = []
    for seq in sequences:
        euler.prepare(seq)
        axes, intrinsic = euler.sequence(seq)
        turns.append((axes[::-1] if intrinsic else axes, intrinsic))
        for degrees in (False, True):
            action.by_euler(*turns[-1], degrees)
    rowwise.compile_all()
    for (kind, finer), columns in product(_PRECISIONS, (False, True)):
        _loops(np.dtype(kind), np.dtype(finer), columns, turns)
    kernels.cumulative(np.eye(4))


def _loops(
    kind: np.dtype, finer: np.dtype, columns: bool, turns: list[tuple[tuple[int, ...], bool]]
) -> None:
    """Compile the loops for points of one precision and rotations of either."""

    def rows(width: int, many: bool, of: np.dtype) -> Array:
        a = np.ones((3 if many else 1, width), of, order="F" if columns and many else "C")
        return np.broadcast_to(a, (3, width)) if not many else a

    out = rows(3, True, kind)
    for several, each in _MANY_OR_ONE:
        v = rows(3, several, kind)
        kernels.quaternions(v, rows(4, each, finer), out)
        for degrees in (False, True):
            for axes, backward in turns:
                kernels.euler(v, rows(len(axes), each, finer), axes, backward, out, degrees)
            for other in (True, False):
                if each or other:
                    angles = rows(1, other, finer)[:, 0]
                    kernels.axis_angle(v, rows(3, each, finer), angles, out, degrees)
    kernels.one(rows(3, True, kind), np.eye(3), out)
    for width in (3, 4):
        kernels.contains_zero(rows(width, True, kind))
