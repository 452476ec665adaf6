"""Roots of polynomials of norm 0 over M₂(F): polynomials with matrices for coefficients and determinant 0.

Such a polynomial, not 0, is a column of polynomials without common factor times a row w, and q is its root
where Σ wₙ·qⁿ = 0. Modulo x² − t·x + n the row is a + b·x; where a and b are independent, the q with b·q = −a
and a·q = t·a + n·b is the one root of trace t and norm n.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, product
from typing import Any

from hfield.rings.roots import common_divisor, divided, multiplied, stripped

Row = list[list[Any]]
Matrix = tuple[tuple[Any, Any], tuple[Any, Any]]


def other_root(F: Any, f: Sequence[Matrix], spheres: Sequence[tuple[Any, Any]]) -> Matrix | None:
    """Return a root whose trace and norm are none of ``spheres``, those of which all are roots, or None."""
    rows = [[[c[r][s] for c in f] for s in (0, 1)] for r in (0, 1)]
    row = next(row for row in rows if any(not F.is_zero(c) for entry in row for c in entry))
    content = common_divisor(F, *row)
    whole: list[Any] = []
    for entry in (*rows[0], *rows[1]):
        whole = common_divisor(F, whole, entry)
    primitive = [stripped(F, divided(F, entry, content)[0]) for entry in row]
    if all(len(entry) < 2 for entry in primitive):
        v = [(*entry, F.zero)[0] for entry in primitive]
        return _with_a_left_eigenvector(F, whole, v, spheres)
    w = [multiplied(F, entry, whole) for entry in primitive]
    known = {(F.key(t), F.key(n)) for t, n in spheres}
    for t, n in _traces_and_norms(F, 2 * max(map(len, w))):
        a, b = zip(*(_reduced(F, entry, t, n) for entry in w), strict=True)
        if (F.key(t), F.key(n)) in known:
            continue
        det = a[0] * b[1] - a[1] * b[0]
        if not F.is_zero(det):
            # rows b, a; in their basis q is ((0, −1), (n, t))
            return _in_basis(F, b, a, ((F.zero, -F.one), (n, t)))
        at = next((s for s in (0, 1) if not F.is_zero(b[s])), None)
        if at is not None:  # b·q = −λ·b
            eigenvalue = -F.divide(a[at], b[at])
            if F.is_zero(eigenvalue * eigenvalue - t * eigenvalue + n):
                return _with_eigenvector(F, b, eigenvalue, t - eigenvalue)
    return None


def _with_a_left_eigenvector(
    F: Any, g: list[Any], v: list[Any], spheres: Sequence[tuple[Any, Any]]
) -> Matrix | None:
    """Return a q with v·g(q) = 0 outside the spheres: v is an eigenvector to a root of g; or None."""
    for factor in F.irreducible_factors(g):
        if len(factor) == 2:
            r = -factor[0]
            for s in _elements(F, len(spheres) + 1):
                if not any(F.equal(n, r * s) and F.equal(t, r + s) for t, n in spheres):
                    return _with_eigenvector(F, v, r, s)
    return None


def _with_eigenvector(F: Any, v: Sequence[Any], r: Any, s: Any) -> Matrix:
    """Return a matrix with v·q = r·v and trace r + s."""
    other = (F.zero, F.one) if not F.is_zero(v[0]) else (F.one, F.zero)
    return _in_basis(F, v, other, ((r, F.zero), (F.zero, s)))


def _in_basis(F: Any, u: Sequence[Any], v: Sequence[Any], m: Matrix) -> Matrix:
    """Return the q with u·q = m₀₀·u + m₀₁·v and v·q = m₁₀·u + m₁₁·v."""
    back = F.inverse(u[0] * v[1] - u[1] * v[0])
    inverse = ((v[1] * back, -u[1] * back), (-v[0] * back, u[0] * back))
    images = [[m[r][0] * u[s] + m[r][1] * v[s] for s in (0, 1)] for r in (0, 1)]
    rows = [
        tuple(inverse[r][0] * images[0][s] + inverse[r][1] * images[1][s] for s in (0, 1))
        for r in (0, 1)
    ]
    return rows[0], rows[1]


def _traces_and_norms(F: Any, size: int) -> Iterator[tuple[Any, Any]]:
    """Run through enough pairs: det(a, b) is a polynomial in t and n, not 0, of degrees below ``size``."""
    return product(list(_elements(F, size)), repeat=2)


def _elements(F: Any, count: int) -> Iterator[Any]:
    """Run through so many elements, or all."""
    if not F.characteristic or F.characteristic >= count:
        yield from map(F, range(count))
    elif F.order is None:
        yield from (F.gen**n for n in range(count))
    else:
        yield from islice(F.elements(), count)


def _reduced(F: Any, f: list[Any], t: Any, n: Any) -> tuple[Any, Any]:
    rest = [*divided(F, f, [n, -t, F.one])[1], F.zero, F.zero]
    return rest[0], rest[1]
