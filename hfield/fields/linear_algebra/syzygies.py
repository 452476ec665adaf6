"""Kernels of matrices over rings that are not fields: generators, and a basis if one is found.

Over ℤ/n a matrix is diagonalised by invertible row and column operations (Smith normal form). Over ℤ and k[x]
columns are reduced by division with remainder. Over other polynomial rings, which are factorial, two columns
of rank 1 have one relation up to its gcd. Over a small finite ring all vectors are tried.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Hashable, Iterable
from typing import TYPE_CHECKING

from hfield.errors import UndecidedError, shorten
from hfield.fields.base.modular import Modular
from hfield.fields.base.ring import E, Ring
from hfield.fields.linear_algebra.vectors import dot
from hfield.fields.polynomial_rings import PolynomialRing
from hfield.fields.rationals.ring import ZZ

if TYPE_CHECKING:
    import flint

    from hfield.fields.base.flint_types import SparsePolynomial

Row = list[E]
TRIALS = 50_000
"""The greatest number of vectors over a finite ring that are tried."""


def relations(ring: Ring, rows: list[Row], width: int) -> list[Row]:
    """Return generators of ``{v : rows·v = 0}``. Raises :class:`UndecidedError` if none are found."""
    if isinstance(ring, Modular):
        whole = [[int(x) for x in row] for row in rows]
        return [[ring(x) for x in v] for v in modulo(ring.modulus, whole, width)]
    if ring == ZZ:
        return _euclidean(ring, rows, width, abs)
    if isinstance(ring, PolynomialRing) and ring.base.is_field and len(ring.variables) == 1:
        return _euclidean(ring, rows, width, lambda x: x.degrees()[0])
    found: list[Row] = []
    for columns in _blocks(ring, rows, width):
        part = [[row[n] for n in columns] for row in rows]
        for v in _block(ring, part, len(columns)):
            spread = [ring.zero] * width
            for n, x in zip(columns, v, strict=True):
                spread[n] = x
            found.append(spread)
    return found


# --- ℤ/n ------------------------------------------------------------------------------------------


def modulo(n: int, rows: list[list[int]], width: int) -> list[list[int]]:
    """Return generators of the kernel over ℤ/n; it is the direct sum of the cyclic modules that they
    generate.

    ``U·M·V = D`` is diagonal with V invertible. The solutions of ``d·y = 0`` are the multiples of ``n/gcd(d,
    n)``, so the columns of V times these numbers generate the kernel.
    """
    rows = [[x % n for x in row] for row in rows]
    columns = [[int(i == j) for j in range(width)] for i in range(width)]  # those of V
    diagonal = [0] * width
    for step in range(width):
        live = [(x, r, c) for r, row in enumerate(rows) for c, x in enumerate(row) if x]
        if not live:
            break
        _, r, c = min(live)
        columns[step], columns[c] = columns[c], columns[step]
        for row in rows:
            row[step], row[c] = row[c], row[step]
        diagonal[step] = _clear(n, rows, columns, rows.pop(r), step)
    scales = [n // math.gcd(d, n) for d in diagonal]
    found = [[s * x % n for x in v] for s, v in zip(scales, columns, strict=True) if s < n]
    return sorted(found, key=lambda v: [x == 0 for x in v])


def _clear(
    n: int, rows: list[list[int]], columns: list[list[int]], pivot: list[int], step: int
) -> int:
    """Clear the row and the column of the entry ``pivot[step]``; return the new entry."""
    while True:
        for c in range(step + 1, len(pivot)):
            if pivot[c]:
                x, y, u, v = _bezout(pivot[step], pivot[c])
                for row in (*rows, pivot):
                    p, q = row[step], row[c]
                    row[step], row[c] = (x * p + y * q) % n, (u * p + v * q) % n
                columns[step], columns[c] = _mixed(n, columns[step], columns[c], (x, y, u, v))
        if not any(row[step] for row in rows):
            return pivot[step]
        for row in rows:
            if row[step]:
                mix = _bezout(pivot[step], row[step])
                pivot[:], row[:] = _mixed(n, pivot, row, mix)


def _mixed(
    n: int, p: list[int], q: list[int], mix: tuple[int, int, int, int]
) -> tuple[list[int], list[int]]:
    x, y, u, v = mix
    pairs = list(zip(p, q, strict=True))
    return [(x * a + y * b) % n for a, b in pairs], [(u * a + v * b) % n for a, b in pairs]


def _bezout(a: int, b: int) -> tuple[int, int, int, int]:
    """Return (x, y, u, v) with ``xa + yb = gcd(a, b)``, ``ua + vb = 0``, ``xv − yu = 1``; x = 1 if a | b."""
    if b % a == 0:
        return 1, 0, -(b // a), 1
    (g, x), r, s = (a, 1), b, 0
    while r:
        g, x, r, s = r, s, g % r, x - (g // r) * s
    return x, (g - x * a) // b, -(b // g), a // g


# --- ℤ and k[x] -----------------------------------------------------------------------------------


def _euclidean(
    ring: Ring, rows: list[Row], width: int, size: Callable[[flint.fmpz | SparsePolynomial], int]
) -> list[Row]:
    """Return a basis of the kernel over a Euclidean ring, by invertible column operations."""
    height = len(rows)
    columns = [
        [row[i] for row in rows] + [ring.one if i == j else ring.zero for j in range(width)]
        for i in range(width)
    ]
    for h in range(height):
        live = [v for v in columns if v[h] != 0 and all(x == 0 for x in v[:h])]
        while len(live) > 1:
            live.sort(key=lambda v: size(v[h]))
            for v in live[1:]:
                factor, _ = divmod(v[h], live[0][h])
                v[:] = [x - factor * y for x, y in zip(v, live[0], strict=True)]
            live = [v for v in live if v[h] != 0]
    basis = [v[height:] for v in columns if all(x == 0 for x in v[:height])]
    return [_positive(ring, v) for v in basis]


def _positive(ring: Ring, v: Row) -> Row:
    """Return v or −v; over ℤ, the one whose first nonzero coordinate is positive."""
    lead = next(x for x in v if x != 0)
    return [ring.zero - x for x in v] if ring == ZZ and lead < 0 else v


# --- other rings ----------------------------------------------------------------------------------


def _blocks(ring: Ring[E], rows: list[Row[E]], width: int) -> list[list[int]]:
    """Return the columns in groups, such that no row has entries in two groups."""
    groups = [{n} for n in range(width)]
    for row in rows:
        support = {n for n, x in enumerate(row) if not ring.is_zero(x)}
        hit = [g for g in groups if g & support]
        groups = [g for g in groups if not g & support] + ([set().union(*hit)] if hit else [])
    return sorted(map(sorted, groups))


def _block(ring: Ring, rows: list[Row], width: int) -> list[Row]:
    rows = [row for row in rows if not all(map(ring.is_zero, row))]
    if not rows:
        return [[ring.one if m == n else ring.zero for m in range(width)] for n in range(width)]
    if isinstance(ring, PolynomialRing) and width <= 2:
        first = rows[0]
        if width == 1 or any(first[0] * row[1] != first[1] * row[0] for row in rows):
            return []
        common = first[0].gcd(first[1])
        return [[ring.divide(ring.zero - first[1], common), ring.divide(first[0], common)]]
    if ring.order is not None and ring.order**width <= TRIALS:
        solutions = (
            list(v)
            for v in itertools.product(list(ring.elements()), repeat=width)
            if all(ring.is_zero(dot(row, v)) for row in rows)
        )
        return generators(ring, solutions)
    raise UndecidedError(
        f"generators of a kernel over {shorten(ring.name)} are not found: elimination ends at entries that "
        "are not units; use the field of fractions or a residue field"
    )


def generators(
    ring: Ring[E], vectors: Iterable[Row[E]], key: Callable[[E], Hashable] | None = None
) -> list[Row[E]]:
    """Return a minimal subset of the vectors over a finite ring that generates the same module.

    ``key`` distinguishes scalars, by default ``ring.key``; another key makes the computation work modulo an
    ideal.
    """
    key = key or ring.key
    chosen: list[Row[E]] = []
    seen: dict[tuple[Hashable, ...], Row[E]] = {}
    for v in vectors:
        if tuple(map(key, v)) not in (seen or _span(ring, [], len(v), key)):
            chosen.append(v)
            seen = _span(ring, chosen, len(v), key)
    for v in list(chosen):
        others = [u for u in chosen if u is not v]
        if tuple(map(key, v)) in _span(ring, others, len(v), key):
            chosen = others
    return chosen


def _span(
    ring: Ring[E], vectors: list[Row[E]], width: int, key: Callable[[E], Hashable]
) -> dict[tuple[Hashable, ...], Row[E]]:
    zero = [ring.zero] * width
    span = {tuple(map(key, zero)): zero}
    for v in vectors:
        multiples = {tuple(map(key, w)): w for w in ([r * x for x in v] for r in ring.elements())}
        sums = (
            [x + y for x, y in zip(u, w, strict=True)]
            for u in list(span.values())
            for w in multiples.values()
        )
        span = {tuple(map(key, u)): u for u in sums}
    return span
