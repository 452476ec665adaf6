"""The kernels' work by their plain twins, for where numba is told not to compile (NUMBA_DISABLE_JIT).

The kernels contain machine instructions, which Python cannot run as it runs other functions of numba.
"""

from typing import Any

import numpy as np

from rotation.arrays import Array
from rotation.kernels import twins


def run(name: str, operands: tuple[Array, ...], arguments: tuple[Any, ...]) -> bool:
    """Do what the kernel ``name`` does with these operands and arguments, and answer as it does."""
    if name == "contains_zero":
        return _contains_zero(operands[0])
    points, *parameters, out = operands
    v, *given = (a.astype(np.float64) for a in (points, *parameters))
    with np.errstate(all="ignore"):
        if name == "one":
            turned = twins.one(v, np.reshape(arguments[1], (3, 3)))
        elif name == "axis_angle":
            turned = twins.axis_angle(v, given[0], given[1][..., 0])
        elif name == "quaternions":
            turned = twins.quaternions(v, given[0])
        else:
            turned = twins.euler(v, given[0], arguments[2], arguments[3])
        out[...] = turned + 0.0 * np.sum(v, axis=-1, keepdims=True)  # inf gives NaN, as in kernels
    return name in ("axis_angle", "quaternions") and _contains_zero(parameters[0])


def _contains_zero(array: Array) -> bool:
    return not bool(array.any(axis=-1).all())
