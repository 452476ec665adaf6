"""Rings that elements generate, and lattices that are asked whether they are rings."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING, Any

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent
from hfield.errors import LatticeError, shorten
from hfield.lattices import hermite
from hfield.lattices.checked_arguments import element_row, listed
from hfield.lattices.regular_representation import Regular, regular

if TYPE_CHECKING:
    from hfield.lattices.lattice import Lattice


def generated(algebra: Parent, elements: Iterable[object]) -> tuple[int, Any]:
    """Return the ring that elements generate, a denominator and a matrix. Raises :class:`LatticeError`."""
    r = regular(algebra)
    found = [element_row(algebra, x) for x in (1, *listed(elements))]
    den = math.lcm(*(d for d, _ in found))
    letters = fmpz_mat([[x * (den // d) for x in row] for d, row in found])
    span = hermite.span(den, letters)
    while True:
        words_den, words = span
        _check_integral(algebra, r, words_den, words)
        longer = r.products(words, letters)
        scale = den * r.scale
        rows = (words * scale).entries() + longer.entries()
        wider = hermite.span(words_den * scale, fmpz_mat(len(rows) // 4, 4, rows))
        if wider == span:
            break
        span = wider
    if words.nrows() < 4:
        raise LatticeError(
            f"these elements generate a ring of rank {words.nrows()}, and orders have rank 4: give "
            "elements that lie in no smaller algebra, such as two that do not commute"
        )
    return words_den, words


def check_ring(lattice: Lattice) -> None:
    """Raise :class:`LatticeError` unless a lattice is a ring with 1."""
    if 1 not in lattice:
        raise LatticeError("this lattice is no order: 1 is not in it")
    for p, q in product(lattice.basis, repeat=2):
        if p * q not in lattice:
            raise LatticeError(
                f"this lattice is no order: the product of {shorten(p)} and {shorten(q)} is not in "
                "it; A.order(elements) returns the ring that they generate"
            )


def _check_integral(algebra: Parent, r: Regular, den: int, rows: Any) -> None:
    """Raise :class:`LatticeError` unless all combinations of the rows have integral trace and norm."""
    gram = r.gram(rows)
    traces = (rows * r.form).entries()[::4]
    scale = r.scale * den * den
    for n in range(rows.nrows()):
        whole = int(traces[n]) % (r.scale * den) == 0 and int(gram[n, n]) % (2 * scale) == 0
        if not whole:
            q = algebra(*(Fraction(int(rows[n, m]), den) for m in range(4)))
            raise LatticeError(
                f"these elements generate no order: {shorten(q)} has trace {q.trace()} and norm "
                f"{q.norm()}, which are not both integers"
            )
        for m in range(n):
            if int(gram[n, m]) % scale:
                p, q = (
                    algebra(*(Fraction(int(rows[x, c]), den) for c in range(4))) for x in (m, n)
                )
                raise LatticeError(
                    f"these elements generate no order: the sum of {shorten(p)} and {shorten(q)} has a "
                    "norm that is no integer"
                )
