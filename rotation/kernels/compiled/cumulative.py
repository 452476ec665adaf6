"""The kernel for running products of unit quaternions, in twice the precision.

A plain product of a million quaternions drifts, at random or, for one factor repeated, steadily. Here
the running product is a sum of two floats a component, high and low, and so is each normalised
factor; rounding happens at the 106th bit, and once more when a result is stored.
"""

import math
from typing import Any

from rotation.kernels.compiled.compiling import SOURCES, inlined, kernel
from rotation.kernels.compiled.pairs import two_product, two_sum


@inlined
def add(a: Any, b: Any) -> Any:
    """Return the sum of two pairs."""
    s, e = two_sum(a[0], b[0])
    t, f = two_sum(a[1], b[1])
    e += t
    s, e = s + e, e - ((s + e) - s)
    e += f
    return s + e, e - ((s + e) - s)


@inlined
def times(a: Any, b: Any) -> Any:
    """Return the product of two pairs."""
    p, e = two_product(a[0], b[0])
    e += a[0] * b[1] + a[1] * b[0]
    return p + e, e - ((p + e) - p)


@inlined
def minus(a: Any) -> Any:
    """Return the negative of a pair."""
    return -a[0], -a[1]


@inlined
def normalised(w: Any, x: Any, y: Any, z: Any) -> Any:
    """Return four pairs divided by their length, which is first brought near 1."""
    largest = max(max(abs(w[0]), abs(x[0])), max(abs(y[0]), abs(z[0])))
    scale = (math.ldexp(1.0, -max(math.frexp(largest)[1], -1000)), 0.0)
    w, x, y, z = times(w, scale), times(x, scale), times(y, scale), times(z, scale)
    square = add(add(times(w, w), times(x, x)), add(times(y, y), times(z, z)))
    # Newton: from r ≈ 1/√square in one precision to twice that
    r = 1.0 / math.sqrt(square[0])
    guess = (r, 0.0)
    rest = add((1.0, 0.0), minus(times(square, times(guess, guess))))
    factor = add(guess, times((0.5 * r, 0.0), rest))
    return times(w, factor), times(x, factor), times(y, factor), times(z, factor)


@kernel
def cumulative(q: Any, out: Any, sources: int = SOURCES) -> Any:
    """Write the running products of the rows of ``q``, the newest on the left, normalised."""
    one, zero = (1.0, 0.0), (0.0, 0.0)
    w, x, y, z = one, zero, zero, zero
    for n in range(q.shape[0]):
        a, b, c, d = normalised((q[n, 0], 0.0), (q[n, 1], 0.0), (q[n, 2], 0.0), (q[n, 3], 0.0))
        w, x, y, z = normalised(
            add(add(times(a, w), minus(times(b, x))), minus(add(times(c, y), times(d, z)))),
            add(add(times(a, x), times(b, w)), add(times(c, z), minus(times(d, y)))),
            add(add(times(a, y), minus(times(b, z))), add(times(c, w), times(d, x))),
            add(add(times(a, z), times(b, y)), add(minus(times(c, x)), times(d, w))),
        )
        out[n, 0], out[n, 1], out[n, 2], out[n, 3] = w[0], x[0], y[0], z[0]
