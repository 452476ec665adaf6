"""Subspaces of 𝔽_pⁿ, by reduced echelon forms."""

from collections.abc import Iterable, Sequence

from hfield.checker.budget import spend

Vector = tuple[int, ...]


def echelon(rows: Iterable[Sequence[int]], p: int) -> list[Vector]:
    """Return the reduced echelon form of a span modulo p; it is unique, and its length is the dimension."""
    rest = [[x % p for x in row] for row in rows]
    found: list[list[int]] = []
    columns = len(rest[0]) if rest else 0
    spend(5 + len(rest) * columns)
    for c in range(columns):
        k = next((n for n, row in enumerate(rest) if row[c]), None)
        if k is None:
            continue
        pivot = rest.pop(k)
        below = pow(pivot[c], -1, p)
        pivot = [x * below % p for x in pivot]
        spend((len(rest) + len(found)) * columns // 2)
        for group in (rest, found):
            for row in group:
                if row[c]:
                    f = row[c]
                    row[:] = [(x - f * y) % p for x, y in zip(row, pivot, strict=True)]
        found.append(pivot)
    return [tuple(row) for row in found]


def kernel(rows: Sequence[Sequence[int]], p: int) -> list[Vector]:
    """Return a basis of all x with x·M = 0 modulo p, where M has these rows."""
    n = len(rows)
    wide = [[*row, *(int(k == m) for k in range(n))] for m, row in enumerate(rows)]
    width = len(rows[0])
    return [row[width:] for row in echelon(wide, p) if not any(row[:width])]


def remainder(row: Sequence[int], basis: Sequence[Vector], p: int) -> list[int]:
    """Return the remainder of a vector modulo a span in reduced echelon form."""
    rest = [x % p for x in row]
    for b in basis:
        f = rest[pivot(b)]
        if f:
            rest = [(x - f * y) % p for x, y in zip(rest, b, strict=True)]
    return rest


def pivot(row: Sequence[int]) -> int:
    """Return the position of the first nonzero entry."""
    return next(k for k, x in enumerate(row) if x)
