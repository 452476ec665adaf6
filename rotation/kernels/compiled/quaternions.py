"""The kernel for points with their own quaternions."""

from typing import Any

from rotation.kernels.compiled.compiling import SOURCES, inlined, kernel
from rotation.kernels.compiled.ranges import measured, safe, scaled, turned, zero
from rotation.kernels.compiled.rows import apart, quadruples
from rotation.kernels.compiled.sweep import sweep


@inlined
def fast(q: Any, extra: Any, point: Any) -> Any:
    """Rotate eight points; see `sweep`."""
    w, a, b, c = q
    poison, fine = measured(point)
    return turned(q, point, poison), fine & safe((w * w + a * a) + (b * b + c * c))


@inlined
def careful(q: Any, extra: Any, point: Any) -> Any:
    """Rotate a point by a quaternion of any length; see `sweep`."""
    return turned(scaled(q)[0], point, 0.0), not zero(q)


@kernel
def quaternions(
    counter: Any, outer: Any, inner: Any, table: Any, p: Any, t: Any, sources: int = SOURCES
) -> Any:
    """Rotate points by quaternions (operand 1); return whether one is zero."""
    operands = table[0], table[1], table[1], table[2]
    kinds = p, t, 0.0
    return sweep(
        fast, careful, None, apart, quadruples, counter, outer, inner, operands, (4, 0), kinds
    )
