"""Enumerate the vectors of bounded length in a positive definite integral form, exactly (Fincke and Pohst).

Let dᵢ be the leading minors of the Gram matrix (d₀ = 1), and Lᵢ the integral linear forms that are the rows
of Bareiss' elimination. Then ``Q(x) = Σ Lᵢ(x)²/(dᵢ₋₁·dᵢ)``. Once the last coordinates are chosen, the
remaining bound is a fraction over dᵢ₋₁. So the search uses only integers, and no vector is lost by rounding,
however long the entries are (Fincke and Pohst, *Math. Comp.* 44, 1985; Bareiss, 1968).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice
from math import exp, gamma, isqrt, log, pi

from flint import fmpz_mat

from hfield.errors import TooLargeError

Vector = tuple[int, ...]
Gram = Sequence[Sequence[int]]
MAX_STEPS = 2 * 10**7
"""The largest number of vectors that are enumerated."""
MIN_FLINT_SIZE = 14
"""From so many rows on flint eliminates more quickly."""


def bareiss(gram: Gram) -> tuple[list[int], list[list[int]]]:
    """Return the leading minors ``[1, d₁, …, dₙ]`` and the rows of the fraction-free elimination."""
    rows = [list(row) for row in gram]
    n = len(rows)
    if n >= MIN_FLINT_SIZE:  # pivots of a definite form are not 0, so that flint moves no row
        forms = [list(map(int, row)) for row in fmpz_mat(rows).fflu()[3].tolist()]
        return [1, *(forms[k][k] for k in range(n))], forms
    minors = [1]
    for k in range(n):
        pivot, before = rows[k][k], minors[-1]
        for i in range(k + 1, n):
            head = rows[i][k]
            row, top = rows[i], rows[k]
            for j in range(k + 1, n):
                row[j] = (row[j] * pivot - head * top[j]) // before
        minors.append(pivot)
    return minors, rows


def short_vectors(
    gram: Gram, bound: int, expected: str | None = None
) -> Iterator[tuple[Vector, int]]:
    """Yield one of ±x for every x ≠ 0 with ``x·gram·x ≤ bound``, with this value.

    Raises :class:`TooLargeError` if there are too many; ``expected`` describes the vectors in the message.
    """
    minors, forms = bareiss(gram)
    n = len(minors) - 1
    if expected is not None:
        _expect_affordable(_volume(minors, bound, n), expected)
    if bound <= 0 or n == 0:
        return
    x = [0] * n
    first, head = forms[0], minors[1]
    for zero, left in _heads(minors, forms, n, minors[n] * bound, x, True):
        shift = 0
        for j in range(1, n):
            shift += first[j] * x[j]
        radius = isqrt(left)
        low = 1 if zero else -((radius + shift) // head)
        for value in range(low, (radius - shift) // head + 1):
            line = head * value + shift
            yield (value, *x[1:]), bound - (left - line * line) // head


def least_vectors(gram: Gram) -> tuple[int, list[Vector]]:
    """Return the least value of a form, preferably reduced, and one of ±x for each x with this value."""
    least = min(row[n] for n, row in enumerate(gram))
    found: list[Vector] = []
    for x, value in short_vectors(gram, least):
        if value < least:
            found, least = [], value
        if value == least:
            found.append(x)
    return least, found


def vectors_of_length(gram: Gram, length: int, expected: str | None = None) -> Iterator[Vector]:
    """Yield one of ±x for every x ≠ 0 with ``x·gram·x = length``, solving for the last coordinate.

    Raises :class:`TooLargeError` as :func:`short_vectors` does.
    """
    minors, forms = bareiss(gram)
    n = len(minors) - 1
    if expected is not None:
        _expect_affordable(_volume(minors, length, n - 1), expected)
    if length <= 0:
        return
    x = [0] * n
    first, head = forms[0], minors[1]
    for zero, left in _heads(minors, forms, n, minors[n] * length, x, True):
        # (head·x₀ + shift)² = left
        root = isqrt(left)
        if root * root != left:
            continue
        shift = sum(first[j] * x[j] for j in range(1, n))
        for line in {root, -root}:
            value, odd = divmod(line - shift, head)
            if not odd and not (zero and value <= 0):
                yield (value, *x[1:])


def _heads(
    minors: list[int], forms: list[list[int]], i: int, left: int, x: list[int], zero: bool
) -> Iterator[tuple[bool, int]]:
    """Choose all coordinates of x but the first; yield whether all are zero, and the remaining bound.

    ``left`` is minors[i] times the remaining bound before coordinate i − 1 is chosen. As long as all chosen
    coordinates are zero, only values ≥ 0 are tried.
    """
    if i == 1:
        yield zero, left
        return
    k = i - 1
    form, low, high = forms[k], minors[k], minors[i]
    shift = 0
    for j in range(i, len(x)):
        shift += form[j] * x[j]
    reach = low * left
    radius = isqrt(reach)
    for value in range(0 if zero else -((radius + shift) // high), (radius - shift) // high + 1):
        line = high * value + shift
        x[k] = value
        yield from _heads(minors, forms, k, (reach - line * line) // high, x, zero and value == 0)
    x[k] = 0


def volume(gram: Gram, bound: int, dimension: int) -> float:
    """Return approximately the number of integer points of the ellipsoid, or of its projection to the last
    coordinates.
    """
    return _volume(bareiss(gram)[0], bound, dimension)


def _volume(minors: list[int], bound: int, dimension: int) -> float:
    n = len(minors) - 1
    ball: float = pi ** (dimension / 2) / gamma(dimension / 2 + 1)
    # logarithms, as the numbers may be too long for a float
    size = dimension * log(max(bound, 1)) - log(minors[n]) + log(minors[n - dimension])
    return ball * exp(min(size / 2, 700.0))


def _expect_affordable(vectors: float, what: str) -> None:
    if vectors > MAX_STEPS:
        raise TooLargeError(
            f"about {vectors:.0e} {what} the wanted one would have to be enumerated, more than the limit of "
            f"{MAX_STEPS:.0e}; O.represent_integer(n) finds one element of large norm"
        )


def theta_series(gram: Gram, n: int, expected: str | None = None) -> list[int]:
    """Return [r(0), …, r(n)], where r(m) is the number of vectors with value 2m of an even form.

    Raises :class:`TooLargeError` as :func:`short_vectors` does.
    """
    vectors = short_vectors(gram, 2 * n, expected)
    first = list(islice(vectors, 1))  # the error precedes a list that is too long
    counts = [1] + [0] * n
    for _, value in chain(first, vectors):
        counts[value // 2] += 2
    return counts
