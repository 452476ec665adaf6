"""Exact sums and products of floats as pairs (high, low).

T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971). Only
+ − × are used, so they run on every array library; fused multiply-add is used if available.
"""

from collections.abc import Callable

from rotation.array_types import Array, Namespace, Operand

Pair = tuple[Array, Array]
PairLike = tuple[Array, Operand]  # the low part may be one float for all
FMA = Callable[[Operand, Operand, Operand], Array]  # a·b + c, rounded once


def two_sum(a: Array, b: Operand) -> Pair:
    """Return ``a + b`` rounded, and the rounding error."""
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def quick_two_sum(a: Operand, b: Array) -> Pair:
    """Return ``a + b`` rounded, and the rounding error, if |a| ≥ |b| or a is 0."""
    s = a + b
    return s, b - (s - a)


def two_product(xp: Namespace, a: Array, b: Operand) -> Pair:
    """Return ``a·b`` rounded, and the rounding error, for factors far from overflow and underflow."""
    p = a * b
    fma: FMA | None = getattr(
        xp, "fma", None
    )  # the error is a float: either way it is found exactly
    if fma is not None:
        return p, fma(a, b, -p)
    a1, a2 = _halves(xp, a)
    b1, b2 = _halves(xp, b)
    return p, ((a1 * b1 - p) + (a1 * b2 + a2 * b1)) + a2 * b2


def plus_product(xp: Namespace, c: Operand, a: Array, b: Operand) -> Array:
    """Return ``c + a·b``, rounded once if fused multiply-add is available."""
    fma: FMA | None = getattr(xp, "fma", None)
    return c + a * b if fma is None else fma(a, b, c)


def _halves(xp: Namespace, a: Operand) -> tuple[Operand, Operand]:
    """Return two halves of the digits of each float."""
    single = not isinstance(a, float) and hasattr(a, "dtype") and xp.finfo(a.dtype).bits == 32
    t = (4097.0 if single else 134217729.0) * a  # 2¹² + 1, 2²⁷ + 1
    high = t - (t - a)
    return high, a - high
