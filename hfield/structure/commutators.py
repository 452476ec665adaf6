"""The centre, by linear algebra in the base ring: q is central when it commutes with i and j."""

from hfield.product import Constants, Coordinates, multiply
from hfield.rings.base import Ring
from hfield.structure.linear import Row, kernel


def basis_of(ring: Ring) -> tuple[Coordinates, Coordinates, Coordinates, Coordinates]:
    """Return the coordinates of e, i, j, k."""
    o, e = ring.zero, ring.one
    return (e, o, o, o), (o, e, o, o), (o, o, e, o), (o, o, o, e)


def centre(ring: Ring, c: Constants) -> tuple[Coordinates, ...]:
    """Return a basis of the centre of the algebra, as coordinates, e first.

    Raises :class:`UndecidedError` over a ring that is not a field where no basis is found: over ZZ/4
    the centre of H is not a free module.
    """
    rows = commutator_rows(ring, c)
    basis = kernel(ring, [row[1:] for row in rows], 3)
    zero = ring.zero
    return (basis_of(ring)[0], *((zero, x, y, z) for x, y, z in basis))


def commutator_rows(ring: Ring, c: Constants) -> list[Row]:
    """Return the matrix of ``q ↦ (qi − iq, qj − jq)`` on coordinates, one row a component."""
    columns = []
    basis = basis_of(ring)
    for u in basis:
        column: Row = []
        for v in basis[1:3]:
            left, right = multiply(c, u, v), multiply(c, v, u)
            column += [x - y for x, y in zip(left, right, strict=True)]
        columns.append(column)
    return [list(row) for row in zip(*columns, strict=True)]


def is_commutative(ring: Ring, c: Constants) -> bool:
    """Tell whether the algebra is commutative: whether i, j and k commute with i and j."""
    return all(ring.is_zero(x) for row in commutator_rows(ring, c) for x in row)
