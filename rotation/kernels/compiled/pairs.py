"""Sums and products with what rounding cut off, exact with fused multiply-add and without."""

from typing import Any

from rotation.kernels.compiled.compiling import inlined

SPLIT = 2.0**27 + 1.0


@inlined
def two_sum(a: Any, b: Any) -> Any:
    """Return the rounded sum and its error (Knuth 1969)."""
    s = a + b
    v = s - a
    return s, (a - (s - v)) + (b - v)


@inlined
def two_product(a: Any, b: Any) -> Any:
    """Return the rounded product and its error (Dekker 1971)."""
    p = a * b
    t = SPLIT * a
    ah = t - (t - a)
    t = SPLIT * b
    bh = t - (t - b)
    al, bl = a - ah, b - bh
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl
