"""All short vectors of a positive definite form, in integer arithmetic (Fincke and Pohst)."""

from collections.abc import Iterator
from math import isqrt, lcm

from hfield.checker.budget import spend
from hfield.checker.number_fields.matrices import Row, Rows, longest
from hfield.checker.rejection import reject


def short_vectors(gram: Rows, bound: int) -> Iterator[tuple[Row, int]]:
    """Yield one of ±x for every x ≠ 0 with x·G·xᵀ ≤ bound, and the value.

    With the leading minors d of G, x·G·xᵀ = Σ yₘ²/(dₘ₋₁·dₘ), where yₘ is dₘ·xₘ plus a contribution of later
    coordinates.
    """
    size, lines = len(gram), _triangle(gram)
    minors = [1, *(lines[m][m] for m in range(size))]
    common = lcm(*(minors[m] * minors[m + 1] for m in range(size)))
    weights = [common // (minors[m] * minors[m + 1]) for m in range(size)]
    long, total = longest(lines), (bound * common).bit_length()
    entry = long * long // 200_000 + total * total // 1_000_000
    cost = 4 + (long + total) // 1_000 + total * total // 1_000_000
    x = [0] * size

    def level(m: int, left: int, zero: bool) -> Iterator[tuple[Row, int]]:
        if m < 0:
            if not zero:
                yield tuple(x), bound - left // common
            return
        line, d = lines[m], lines[m][m]
        shift = sum(line[n] * x[n] for n in range(m + 1, size))
        reach = isqrt(left // weights[m])
        first = 0 if zero else -((reach + shift) // d)
        last = (reach - shift) // d
        spend(entry + cost * (1 + max(last - first + 1, 0)))
        for value in range(first, last + 1):
            x[m] = value
            y = d * value + shift
            yield from level(m - 1, left - y * y * weights[m], zero and not value)
        x[m] = 0

    if bound >= 0:
        yield from level(size - 1, bound * common, True)


def _triangle(gram: Rows) -> list[list[int]]:
    """Eliminate without fractions; the diagonal has the leading minors, which must be positive."""
    m, size = [list(row) for row in gram], len(gram)
    spend(size**3 * (64 + longest(m) ** 2 // 2_500) // 64)
    before = 1
    for c in range(size):
        if m[c][c] <= 0:
            reject("nothing is exhausted where the norm is indefinite, as it is in this algebra")
        for r in range(c + 1, size):
            f = m[r][c]
            m[r] = [(m[c][c] * x - f * y) // before for x, y in zip(m[r], m[c], strict=True)]
        before = m[c][c]
    return m
