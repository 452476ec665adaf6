"""Radical, simplicity, derivations and the opposite algebra."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from hfield.algebra.structure.counting.formulas_finite import count, has_formulas
from hfield.algebra.structure.invariants.finite_radical import finite_radical
from hfield.core.product import Constants, Coordinates, Scalar, multiply
from hfield.errors import UndecidedError, shorten
from hfield.fields.base.ring import Ring
from hfield.fields.linear_algebra.kernels import kernel
from hfield.fields.linear_algebra.syzygies import Row
from hfield.fields.polynomial_rings import PolynomialRing
from hfield.fields.quadratic_forms.global_field import global_field, known_field
from hfield.fields.quadratic_forms.norm_forms.zero_norms import is_division
from hfield.fields.quadratic_forms.normal_forms import basis_of, discriminant, pairing_matrix
from hfield.fields.rationals.ring import ZZ

if TYPE_CHECKING:
    import flint


def is_central_simple(ring: Ring, c: Constants) -> bool:
    """Return whether the algebra is central simple; over a field, whether ``(t² + 4a)·b ≠ 0``.

    Raises :class:`UndecidedError` if it is not known whether the ring is a field.
    """
    if ring.is_field is None:
        raise UndecidedError(
            f"{ring.no_field}: whether an algebra is central simple is decided over fields"
        )
    return ring.is_field and not ring.is_zero(discriminant(ring, c))


def is_semisimple(ring: Ring, c: Constants) -> bool:
    """Return whether the algebra is semisimple. Raises :class:`UndecidedError`.

    Over a field or a finite ring the algebra has finite length, so it is semisimple if and only if its
    radical is 0. Over ℤ and polynomial rings it has infinite length and is not semisimple.
    """
    if ring.is_field or ring.order is not None:
        return not radical(ring, c)
    if _is_domain(ring):
        return False
    raise UndecidedError(
        f"whether an algebra over {shorten(ring.name)} is semisimple is not decided"
    )


def is_local(ring: Ring, c: Constants) -> bool:
    """Return whether the elements that are not units form an ideal. Raises :class:`UndecidedError`.

    Over a finite ring the algebra is local if and only if 0 and 1 are its only idempotents. Over a field a
    central simple algebra is local if and only if it is a division algebra. A degenerate one is not local if
    X² − t·X − a (for b = 0), or X² − b, has two roots. Over ℤ or polynomials there is a maximal ideal above
    each maximal ideal of the ring.
    """
    if has_formulas(ring):
        return count(ring, c, "idempotent").value == 2
    if not ring.is_field:
        if _is_domain(ring):
            return False
        raise UndecidedError(
            f"whether an algebra over {shorten(ring.name)} is local is not decided"
        )
    if is_central_simple(ring, c):
        return is_division(ring, c)
    if ring.characteristic == 2:
        # y² + t·y = a has a solution when (y/t)² + y/t = a/t² has
        if ring.is_zero(c.t):
            return True
        x = ring.divide(c.a, c.t * c.t)
        return known_field(ring).artin_schreier(x) is None
    if ring.is_zero(c.b):
        square = c.t * c.t + ring(4) * c.a
        return ring.is_zero(square) or ring.sqrt(square) is None
    return ring.sqrt(c.b) is None


def _is_domain(ring: Ring) -> bool:
    return ring.name == "ZZ" or isinstance(ring, PolynomialRing)


def radical(ring: Ring, c: Constants) -> tuple[Coordinates, ...]:
    """Return a basis of the Jacobson radical, () for a central simple algebra; over rings, generators.

    Over a field it is the kernel of the bilinear form of the norm. In characteristic 2 with t = 0 that form
    is 0; then the radical is the kernel of the norm, which is additive and becomes linear over the field
    after taking roots. Over ℤ and polynomial rings the radical is nilpotent (they are Jacobson rings), so it
    is that over the field of fractions. Raises :class:`UndecidedError` over infinite rings of other kinds.
    """
    if ring.is_field and is_central_simple(ring, c):
        return ()
    if not ring.is_field and ring.order is not None:
        return finite_radical(ring, c)
    if not (ring.is_field or ring == ZZ or isinstance(ring, PolynomialRing)):
        raise UndecidedError(
            f"the radical over {shorten(ring.name)} is not decided: expected a field, a finite ring, ZZ or "
            "a ring of polynomials"
        )
    additive = ring.characteristic == 2 and ring.is_zero(c.t)
    rows = _roots(ring, c) if additive else pairing_matrix(ring, c)
    return tuple((w, x, y, z) for w, x, y, z in kernel(ring, rows, 4))


def _roots(ring: Ring, c: Constants) -> list[Row]:
    """Return linear equations equivalent to ``w² + a·x² + b·y² + ab·z² = 0`` in characteristic 2."""
    squares = [ring.one, c.a, c.b, c.a * c.b]
    if isinstance(ring, PolynomialRing):
        return _monomial_roots(ring, squares)
    return [list(row) for row in zip(*(square_parts(ring, x) for x in squares), strict=True)]


def square_parts(ring: Ring, x: Scalar) -> tuple[Scalar, ...]:
    """Return (u,) with x = u², or (u, v) with x = u² + g·v² for a nonsquare g, in a field of characteristic
    2.

    Raises :class:`UndecidedError` if neither is known.
    """
    field = global_field(ring)
    if field is not None:
        return field.square_parts(x)
    root = ring.sqrt(x)
    if root is None:
        raise UndecidedError(f"{ring.name} is not perfect, and its square roots are not found here")
    return (root,)


def _monomial_roots(ring: PolynomialRing, squares: list[flint.nmod_mpoly]) -> list[Row]:
    """Write polynomials over GF(2) as ``Σ u²·m`` with squarefree monomials m; the result has a row of u for
    each m.
    """
    rows: dict[tuple[int, ...], Row] = {}
    for n, x in enumerate(squares):
        for exponents, _ in x.terms():
            row = rows.setdefault(tuple(e % 2 for e in exponents), [ring.zero] * len(squares))
            row[n] = row[n] + ring.context.from_dict({tuple(e // 2 for e in exponents): 1})
    return list(rows.values())


def derivations(ring: Ring, c: Constants) -> tuple[tuple[Row, ...], ...]:
    """Return a basis of the derivations, each a 4 × 4 matrix whose columns are the images of e, i, j, k.

    A central simple algebra has only the inner derivations ``x ↦ qx − xq`` (Jacobson and Noether), a space of
    dimension 3, with the basis given by q = i, j and k. Over a ring such as ℤ/n, where the derivations are
    not a free module, the result is a list of generators. Raises :class:`UndecidedError`.
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

    The map reverses products, φ(pq) = φ(q)φ(p), sends k = ij to ``ji = t·j − k``, and is its own inverse. So
    the opposite algebra has the same constants.
    """
    w, x, y, z = q
    return w, x, y + c.t * z, -z
