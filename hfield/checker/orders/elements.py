"""All elements of a lattice with a given norm, or a given trace and norm, in a totally definite algebra."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from hfield.checker.number_fields.enumeration import short_vectors
from hfield.checker.number_fields.matrices import Row, times
from hfield.checker.orders.algebra import Algebra
from hfield.checker.orders.lattice import Lattice, LatticeElement
from hfield.checker.scalars.number_fields import Element as Number


def of_norm(lattice: Lattice, inverse: Number) -> Iterator[Row]:
    """Yield one of ±x for each x of totally positive norm ν; 1/ν is given.

    For such x, Tr(N(x)/ν) is the degree of the field. The elements are rows over the denominator of the
    lattice.
    """
    integers = lattice.algebra.integers
    den, part = integers.coordinates(inverse)
    bound = 2 * lattice.unit * integers.n * den
    one = tuple(2 * lattice.unit * den * c for c in integers.one)
    for x, value in short_vectors(lattice.form(integers.traces(part)), bound):
        if value == bound and integers.mul(lattice.norm_of(x), part) == one:
            yield times([x], lattice.rows)[0]


def with_trace_and_norm(lattice: Lattice, trace: Sequence[Fraction], norm: Number) -> list[Row]:
    """Return the nonzero elements as rows over the denominator; the trace is given in the integral basis."""
    algebra = lattice.algebra
    field = algebra.integers.field
    if any(sign != 1 for sign in field.signs(norm)):
        need_definite(lattice)
        return []
    inverse = field.inverse(norm)
    assert inverse is not None, "a number with signs is not 0"
    wanted = tuple(c * algebra.scale * lattice.den for c in trace)
    both = (y for x in of_norm(lattice, inverse) for y in (x, tuple(-c for c in x)))
    return [x for x in both if algebra.trace(x) == wanted]


def trace_and_norm(algebra: Algebra, x: LatticeElement) -> tuple[list[Fraction], Number]:
    """Return the trace in the integral basis, and the norm as a number of the field."""
    trace = [Fraction(c, x.den * algebra.scale) for c in algebra.trace(x.row)]
    twice = 2 * x.den * x.den * algebra.scale
    return trace, algebra.integers.number(
        [Fraction(c, twice) for c in algebra.pairing(x.row, x.row)]
    )


def need_definite(lattice: Lattice) -> None:
    """Reject unless the norm is totally definite over a totally real field, so that Tr(N(x)) is positive."""
    integers = lattice.algebra.integers
    any(short_vectors(lattice.form(integers.traces(integers.one)), 0))
