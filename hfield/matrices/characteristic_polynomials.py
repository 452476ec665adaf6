"""Division-free characteristic polynomials over the commutative ring S = F[X]/(X² − tX − a)."""

from __future__ import annotations

from collections.abc import Sequence

from hfield.core.product import Scalar
from hfield.fields.base.ring import Ring

Pair = tuple[Scalar, Scalar]  # x + y·X


def characteristic_polynomial(
    ring: Ring, a: Scalar, t: Scalar, rows: Sequence[Sequence[Pair]]
) -> list[Pair]:
    """Return the coefficients of det(x − M), low degree first (S. Berkowitz, Inf. Proc. Letters 18 (1984)).

    Each leading block adds a column and a row to the previous one; products with powers of that block form a
    Toeplitz matrix, by which the coefficients are multiplied.
    """
    zero, one = (ring.zero, ring.zero), (ring.one, ring.zero)

    def times(p: Pair, q: Pair) -> Pair:
        both = p[1] * q[1]
        return p[0] * q[0] + a * both, p[0] * q[1] + p[1] * q[0] + t * both

    def dot(row: Sequence[Pair], column: Sequence[Pair]) -> Pair:
        total = zero
        for p, q in zip(row, column, strict=True):
            u, v = times(p, q)
            total = total[0] + u, total[1] + v
        return total

    coefficients = [one]  # high degree first
    for n in range(len(rows)):
        block = [row[:n] for row in rows[:n]]
        column, row = [rows[m][n] for m in range(n)], rows[n][:n]
        corner = rows[n][n]
        first = [one, (-corner[0], -corner[1])]
        for _ in range(n):
            value = dot(row, column)
            first.append((-value[0], -value[1]))
            column = [dot(line, column) for line in block]
        coefficients = [
            dot([first[m - k] for k in range(min(m, n) + 1)], coefficients[: min(m, n) + 1])
            for m in range(n + 2)
        ]
    return coefficients[::-1]
