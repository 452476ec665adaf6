"""The kernel for the matrices of quaternions: `rotation.matrices.to_matrix`, to its last bit."""

from typing import Any

from rotation.kernels.compiled.access import at, put, throughout
from rotation.kernels.compiled.compiling import SOURCES, kernel, strict
from rotation.kernels.compiled.pairs import two_product, two_sum


@strict
def entry(half: Any, more: Any) -> Any:
    """Return twice ``half``, times 1 + ``more``."""
    return 2.0 * half + (2.0 * half) * more


@strict
def cosine(plus: Any, minus: Any, more: Any) -> Any:
    """Return plus less minus, times 1 + ``more``, by the smaller of them."""
    return 1.0 - entry(minus, more) if minus < plus else entry(plus, more) - 1.0


@strict
def loop(quaternions: Any, out: Any, m: Any, zero: Any) -> Any:
    """Write the nine entries of ``m`` matrices, row after row; none is left."""
    for i in range(m):
        w, x = at(quaternions, 4, i, 0, zero), at(quaternions, 4, i, 1, zero)
        y, z = at(quaternions, 4, i, 2, zero), at(quaternions, 4, i, 3, zero)
        ww, we = two_product(w, w)
        xx, xe = two_product(x, x)
        yy, ye = two_product(y, y)
        zz, ze = two_product(z, z)
        high, f = two_sum(ww, xx)
        low = we + (xe + f)
        high, f = two_sum(high, yy)
        low = low + (ye + f)
        high, f = two_sum(high, zz)
        low = low + (ze + f)
        more = ((1.0 - high) - low) / high
        put(out, 9, i, 0, cosine((ww + xx) + (we + xe), (yy + zz) + (ye + ze), more))
        put(out, 9, i, 1, entry(x * y - w * z, more))
        put(out, 9, i, 2, entry(x * z + w * y, more))
        put(out, 9, i, 3, entry(x * y + w * z, more))
        put(out, 9, i, 4, cosine((ww + yy) + (we + ye), (xx + zz) + (xe + ze), more))
        put(out, 9, i, 5, entry(y * z - w * x, more))
        put(out, 9, i, 6, entry(x * z - w * y, more))
        put(out, 9, i, 7, entry(y * z + w * x, more))
        put(out, 9, i, 8, cosine((ww + zz) + (we + ze), (xx + yy) + (xe + ye), more))
    return False


@kernel
def matrices(
    counter: Any, outer: Any, inner: Any, table: Any, zero: Any, sources: int = SOURCES
) -> Any:
    """Write the matrices, nine numbers each, of quaternions in one piece."""
    return throughout(loop, counter, outer, inner, table, zero)
