"""The centre, by linear algebra in the base ring: q is central when it commutes with i and j."""

from hfield.core.product import Constants, Coordinates, multiply
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.linear_algebra.kernels import kernel
from hfield.fields.linear_algebra.syzygies import Row
from hfield.fields.quadratic_forms.normal_forms import basis_of, discriminant


def centre(ring: Ring, c: Constants) -> tuple[Coordinates, ...]:
    """Return coordinates of a basis of the centre, e first; generators if the centre is not free.

    Over ℤ/n the centre is the direct sum of the submodules that they generate; for H over ZZ/4 the generators
    are e, 2i, 2j and 2k. Raises :class:`UndecidedError` over other rings if no generators are found.
    """
    zero, e = ring.zero, basis_of(ring)[0]
    try:
        basis = kernel(ring, [row[1:] for row in commutator_rows(ring, c)], 3)
    except UndecidedError:  # with O() it is not decided that a pivot is 0
        if not ring.is_field or ring.is_zero(discriminant(ring, c)):
            raise
        return (e,)  # the algebra is central simple
    return (e, *((zero, x, y, z) for x, y, z in basis))


def commutator_rows(ring: Ring, c: Constants) -> list[Row]:
    """Return the matrix of ``q ↦ (qi − iq, qj − jq)`` on coordinates, one row per component."""
    columns = []
    basis = basis_of(ring)
    for u in basis:
        column: Row = []
        for v in basis[1:3]:
            if u is v:  # a difference of equal numbers that are known to some digits is not 0
                column += [ring.zero] * 4
                continue
            left, right = multiply(c, u, v), multiply(c, v, u)
            column += [x - y for x, y in zip(left, right, strict=True)]
        columns.append(column)
    return [list(row) for row in zip(*columns, strict=True)]


def is_commutative(ring: Ring, c: Constants) -> bool:
    """Return whether the algebra is commutative: whether i and j commute, ``ij − ji = 2k − t·j = 0``."""
    return ring.is_zero(ring(2)) and ring.is_zero(c.t)
