"""The kernels' work by their plain twins: without LLVM, or where nothing shall be compiled."""

from typing import Any

import numpy as np

from rotation.arrays import Array
from rotation.kernels import twins


def run(name: tuple[Any, ...], read: tuple[Array, ...], out: Array | None) -> bool:
    """Do what the kernel ``name`` does with these operands, and answer as it does."""
    if out is None:
        return _contains_zero(read[0])
    v, *parameters = (a.astype(np.float64) for a in read)
    with np.errstate(all="ignore"):
        if name[0] == "one":
            turned = twins.one(v, parameters[0].reshape(3, 3))
        elif name[0] == "axis_angle":
            turned = twins.axis_angle(v, parameters[0], parameters[1][..., 0], *name[1:])
        elif name[0] == "quaternions":
            turned = twins.quaternions(v, parameters[0])
        else:
            turned = twins.euler(v, parameters[0], *name[1:])
        out[...] = turned + 0.0 * np.sum(v, axis=-1, keepdims=True)  # inf gives NaN, as in kernels
    return name[0] in ("axis_angle", "quaternions") and _contains_zero(read[1])


def _contains_zero(array: Array) -> bool:
    return not bool(array.any(axis=-1).all())
