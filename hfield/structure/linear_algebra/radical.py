"""Radical, simplicity, derivations and the opposite algebra."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from hfield.errors import UndecidedError, shorten
from hfield.product import Constants, Coordinates, multiply
from hfield.rings.base import Ring
from hfield.rings.polynomials import PolynomialRing
from hfield.structure.forms import discriminant, pairing_matrix
from hfield.structure.global_field import global_field
from hfield.structure.linear_algebra.centre import basis_of
from hfield.structure.linear_algebra.finite_radical import finite_radical
from hfield.structure.linear_algebra.kernels import kernel
from hfield.structure.linear_algebra.syzygies import Row

if TYPE_CHECKING:
    import flint


def is_central_simple(ring: Ring, c: Constants) -> bool:
    """Tell whether the algebra is central simple: whether ``(t² + 4a)·b ≠ 0``, over a field."""
    return ring.is_field and not ring.is_zero(discriminant(c))


def radical(ring: Ring, c: Constants) -> tuple[Coordinates, ...]:
    """Return a basis of the Jacobson radical, () for a central simple algebra; generators over rings.

    Over a field it is the kernel of the bilinear form of the norm; in characteristic 2 with t = 0, where that
    is 0, of the norm, which is additive: linear over the field after taking roots. Over ℤ and polynomial
    rings the radical is nilpotent (they are Jacobson rings), so it is that over the field of fractions.
    Raises :class:`UndecidedError` over infinite rings of other kinds.
    """
    if is_central_simple(ring, c):
        return ()
    if not ring.is_field and ring.order is not None:
        return finite_radical(ring, c)
    if not (ring.is_field or ring.name == "ZZ" or isinstance(ring, PolynomialRing)):
        raise UndecidedError(
            f"the radical over {shorten(ring.name)} is not decided: expected a field, a finite ring, ZZ or "
            "a ring of polynomials"
        )
    additive = ring.characteristic == 2 and ring.is_zero(c.t)
    rows = _roots(ring, c) if additive else pairing_matrix(ring, c)
    return tuple((w, x, y, z) for w, x, y, z in kernel(ring, rows, 4))


def _roots(ring: Ring, c: Constants) -> list[Row]:
    """Return linear equations for ``w² + a·x² + b·y² + ab·z² = 0`` in characteristic 2."""
    squares = [ring.one, c.a, c.b, c.a * c.b]
    field = global_field(ring)
    if field is not None:
        return [list(row) for row in zip(*map(field.square_parts, squares), strict=True)]
    if isinstance(ring, PolynomialRing):
        return _monomial_roots(ring, squares)
    roots = [ring.sqrt(x) for x in squares]
    if None in roots:
        raise UndecidedError(
            f"{ring.name} is not perfect, and its square roots are not split up here"
        )
    return [roots]


def _monomial_roots(ring: PolynomialRing, squares: list[flint.nmod_mpoly]) -> list[Row]:
    """Write polynomials over GF(2) as ``Σ u²·m`` with squarefree monomials m: one row of u for each m."""
    rows: dict[tuple[int, ...], Row] = {}
    for n, x in enumerate(squares):
        for exponents, _ in x.terms():
            row = rows.setdefault(tuple(e % 2 for e in exponents), [ring.zero] * len(squares))
            row[n] = row[n] + ring.context.from_dict({tuple(e // 2 for e in exponents): 1})
    return list(rows.values())


def derivations(ring: Ring, c: Constants) -> tuple[tuple[Row, ...], ...]:
    """Return a basis of the derivations, each a 4 × 4 matrix whose columns are the images of e, i, j, k.

    A central simple algebra has only inner ones, ``x ↦ qx − xq`` (Jacobson and Noether), a space of
    dimension 3; then i, j and k are the q. Over a ring where derivations are no free module, such as ℤ/n,
    these are generators. Raises :class:`UndecidedError`.
    """
    basis = basis_of(ring)
    if is_central_simple(ring, c):
        return tuple(_inner(c, q, basis) for q in basis[1:])
    table = [[multiply(c, p, q) for q in basis] for p in basis]
    products = [(r, s, table[r][s]) for r in range(4) for s in range(4)]
    columns = []
    for row in range(4):
        for column in range(4):  # the map that sends basis[column] to basis[row] and the rest to 0
            defect: Row = []
            for r, s, product in products:
                value = [product[column] if n == row else ring.zero for n in range(4)]
                for hit, term in (
                    (r == column, table[row][s]),
                    (s == column, table[r][row]),
                ):
                    if hit:
                        value = [x - y for x, y in zip(value, term, strict=True)]
                defect += value
            columns.append(defect)
    maps = kernel(ring, [list(row) for row in zip(*columns, strict=True)], 16)
    return tuple(tuple(v[4 * n : 4 * n + 4] for n in range(4)) for v in maps)


def _inner(c: Constants, q: Coordinates, basis: Sequence[Coordinates]) -> tuple[Row, ...]:
    """Return the matrix of x ↦ qx − xq."""
    images = [
        [x - y for x, y in zip(multiply(c, q, p), multiply(c, p, q), strict=True)] for p in basis
    ]
    return tuple(list(row) for row in zip(*images, strict=True))


def to_opposite(c: Constants, q: Coordinates) -> Coordinates:
    """Return the image of q under the isomorphism with the opposite algebra that fixes i and j.

    It turns products round, φ(pq) = φ(q)φ(p), sends k = ij to ``ji = t·j − k``, and is its own inverse.
    So the opposite algebra has the same constants.
    """
    w, x, y, z = q
    return w, x, y + c.t * z, -z
