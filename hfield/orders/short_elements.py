"""The norm on a lattice of a definite algebra: short elements, elements of given norm, theta series."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, TooLargeError
from hfield.orders import enumeration, hermite
from hfield.orders.checked_arguments import natural
from hfield.orders.z_lattice import ZLattice
from hfield.rings.whole_numbers import fraction

Row = tuple[int, ...]
MANY = 10**6
"""More vectors than this are not listed."""
MOST_STEPS = 2 * 10**7
"""More vectors than this are not run through."""


def expect_definite(lattice: ZLattice, what: str) -> None:
    """Raise :class:`IndefiniteError` unless the algebra is definite."""
    if not lattice.regular.definite:
        raise IndefiniteError(
            f"{lattice.algebra} is indefinite, so infinitely many elements may have one norm: "
            f"{what} asks for a definite algebra, a < 0 and b < 0 where t = 0"
        )


def expect_affordable(vectors: float, what: str) -> None:
    """Raise :class:`TooLargeError` where so many vectors are not run through."""
    if vectors > MOST_STEPS:
        raise TooLargeError(
            f"about {vectors:.0e} {what} the one asked for would have to be run through, and at most "
            f"{MOST_STEPS:.0e} are; O.represent_integer(n) finds one element of large norm"
        )


def up_to(lattice: ZLattice, bound: int) -> Iterator[tuple[Row, int]]:
    """Yield one of ±x for the nonzero elements of norm at most ``bound·norm``, and their multiples.

    Elements are rows over the denominator of the lattice.
    """
    rows, gram = lattice.reduced
    a, b, c, d = hermite.tuples(rows)
    for (p, q, r, s), value in enumeration.short_vectors(gram, 2 * bound):
        yield tuple(p * a[n] + q * b[n] + r * c[n] + s * d[n] for n in range(4)), value // 2


def least_norm(lattice: ZLattice) -> int:
    """Return the least norm of a nonzero element, as a multiple of the norm of the lattice."""
    return enumeration.least_vectors(lattice.reduced[1])[0] // 2


def shortest(lattice: ZLattice) -> tuple[Quaternion, ...]:
    """Return the nonzero elements of least norm, x and −x."""
    rows, gram = lattice.reduced
    return _signed(
        lattice, (hermite.combination(x, rows) for x in enumeration.least_vectors(gram)[1])
    )


def of_norm(lattice: ZLattice, n: Fraction) -> tuple[Quaternion, ...]:
    """Return all elements of norm n. Raises :class:`TooLargeError`."""
    multiple = n / lattice.norm
    if multiple.denominator != 1 or multiple < 0:
        return ()
    if not multiple:
        return (lattice.algebra(0, 0, 0, 0),)
    rows, gram = lattice.reduced
    wanted = 2 * multiple.numerator
    expect_affordable(enumeration.volume(gram, wanted, 3), "elements of norm at most")
    vectors = enumeration.vectors_of_length(gram, wanted)
    return _signed(lattice, (hermite.combination(x, rows) for x in vectors))


def of_norm_at_most(lattice: ZLattice, n: Fraction) -> tuple[Quaternion, ...]:
    """Return all elements of norm at most n, 0 too, by ascending norm. Raises :class:`TooLargeError`."""
    bound = math.floor(n / lattice.norm)
    if bound < 0:
        return ()
    found = _signed(lattice, (row for row, _ in up_to(lattice, bound)))
    zero = lattice.algebra(0, 0, 0, 0)
    return (zero, *sorted(found, key=lambda q: fraction(q.norm())))


def _signed(lattice: ZLattice, rows: Iterable[Row]) -> tuple[Quaternion, ...]:
    """Return the elements of some rows and their negatives, in a fixed order."""
    both: list[Row] = []
    for row in rows:
        both += (row, tuple(-x for x in row))
        if len(both) > MANY:
            raise TooLargeError(
                f"more than {MANY} elements have so small a norm; theta_series(n) counts them"
            )
    return tuple(lattice.element(row) for row in sorted(both, reverse=True))


def theta_series(lattice: ZLattice, n: object) -> list[int]:
    """Return [r(0), …, r(n)], where r(m) elements have the norm ``m·norm``. Raises :class:`TooLargeError`."""
    return theta_series_of_form(lattice.reduced[1], n)


def theta_series_of_form(gram: enumeration.Gram, n: object) -> list[int]:
    """Return [r(0), …, r(n)], where r(m) vectors have the value 2m. Raises :class:`TooLargeError`."""
    m = natural(n, "a theta series goes up to")
    expect_affordable(enumeration.volume(gram, 2 * m, len(gram)), "elements as short as")
    return enumeration.theta_series(gram, m)
