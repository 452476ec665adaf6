"""Radical, simplicity, derivations and the opposite algebra, over a field."""

from hfield.errors import UndecidedError
from hfield.product import Constants, Coordinates, multiply, norm
from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField
from hfield.structure.commutators import basis_of
from hfield.structure.fields import square_parts
from hfield.structure.forms import discriminant
from hfield.structure.linear import Row, kernel


def is_central_simple(ring: Ring, c: Constants) -> bool:
    """Tell whether the algebra is central simple: whether ``(t² + 4a)·b ≠ 0``, over a field."""
    return ring.is_field and not ring.is_zero(discriminant(c))


def radical(ring: Ring, c: Constants) -> tuple[Coordinates, ...]:
    """Return a basis of the Jacobson radical, () for a central simple algebra. The ring must be a field.

    Where the trace is not 0 the radical is the kernel of the bilinear form of the norm. In characteristic 2
    with t = 0 it is the kernel of the norm, which is additive: linear over the field after taking roots.
    """
    if not ring.is_field:
        raise UndecidedError(
            f"{ring.name} is not a field: the radical is computed over fields only"
        )
    if is_central_simple(ring, c):
        return ()
    basis = basis_of(ring)
    if ring.characteristic == 2 and ring.is_zero(c.t):
        rows = _roots(ring, c)
    else:
        rows = [[_pairing(c, u, v) for v in basis] for u in basis]
    return tuple((w, x, y, z) for w, x, y, z in kernel(ring, rows, 4))


def _pairing(c: Constants, u: Coordinates, v: Coordinates) -> object:
    """Return ``N(u + v) − N(u) − N(v)``."""
    w, x, y, z = (p + q for p, q in zip(u, v, strict=True))
    return norm(c, (w, x, y, z)) - norm(c, u) - norm(c, v)


def _roots(ring: Ring, c: Constants) -> list[Row]:
    """Return linear equations for ``w² + a·x² + b·y² + ab·z² = 0`` in characteristic 2."""
    squares = [ring.one, c.a, c.b, c.a * c.b]
    if isinstance(ring, FunctionField):
        return [list(row) for row in zip(*(square_parts(ring, x) for x in squares), strict=True)]
    roots = [ring.sqrt(x) for x in squares]
    if None in roots:
        raise UndecidedError(
            f"{ring.name} is not perfect, and its square roots are not split up here"
        )
    return [roots]


def derivations(ring: Ring, c: Constants) -> tuple[tuple[Row, ...], ...]:
    """Return a basis of the derivations, each a 4 × 4 matrix whose columns are the images of e, i, j, k.

    A central simple algebra has only inner ones, ``x ↦ qx − xq``, a space of dimension 3. Raises
    :class:`UndecidedError` over a ring where the kernel has no evident basis.
    """
    basis = basis_of(ring)
    products = [(r, s, multiply(c, basis[r], basis[s])) for r in range(4) for s in range(4)]
    columns = []
    for row in range(4):
        for column in range(4):  # the map that sends basis[column] to basis[row] and the rest to 0
            defect: Row = []
            for r, s, product in products:
                value = [product[column] if n == row else ring.zero for n in range(4)]
                for hit, term in (
                    (r == column, multiply(c, basis[row], basis[s])),
                    (s == column, multiply(c, basis[r], basis[row])),
                ):
                    if hit:
                        value = [x - y for x, y in zip(value, term, strict=True)]
                defect += value
            columns.append(defect)
    maps = kernel(ring, [list(row) for row in zip(*columns, strict=True)], 16)
    return tuple(tuple(v[4 * n : 4 * n + 4] for n in range(4)) for v in maps)


def to_opposite(c: Constants, q: Coordinates) -> Coordinates:
    """Return the image of q under the isomorphism with the opposite algebra that fixes i and j.

    It turns products round, φ(pq) = φ(q)φ(p), sends k = ij to ``ji = t·j − k``, and is its own inverse.
    So the opposite algebra has the same constants.
    """
    w, x, y, z = q
    return w, x, y + c.t * z, -z
