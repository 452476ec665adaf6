"""Find the order that elements generate, and check that a lattice is an order."""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent
from hfield.errors import LatticeError, shorten
from hfield.orders import hermite
from hfield.orders.basis import AlgebraBasis, basis_of
from hfield.orders.lattice_values import LatticeValue, contains
from hfield.orders.validation import listed


def checked_ring(lattice: LatticeValue) -> LatticeValue:
    """Return a lattice that is a ring with 1. Raises :class:`LatticeError` for another one."""
    if not contains(lattice, 1):
        raise LatticeError("this lattice is not an order: 1 is not in it")
    for p, row in zip(lattice.basis, lattice.rows.tolist(), strict=True):
        products = lattice.rows * lattice.ambient.times(row, "left") * lattice.inverse_rows
        if products.numer_denom()[1] == 1:
            continue
        entries = products.tolist()
        q = next(
            q
            for q, x in zip(lattice.basis, entries, strict=True)
            if any(lattice.ambient.domain.denominator(c) != 1 for c in x)
        )
        raise LatticeError(
            f"this lattice is not an order: the product of {shorten(p)} and {shorten(q)} is not in it; "
            "A.order(elements) returns the ring that they generate"
        )
    return lattice


def generated(algebra: Parent, elements: Iterable[object]) -> LatticeValue:
    """Return the algebra over the integers that elements generate.

    Raises :class:`LatticeError` where its rank is below 4, or where it has elements that are not integral.
    """
    ambient = basis_of(algebra)
    generators = hermite.rational(ambient.rows(listed(elements)))
    below, letters = hermite.joined(*hermite.rational(ambient.one), *generators)
    span = hermite.span(below, hermite.stacked(*(letters * m for m in ambient.scalars)))
    while True:
        den, words = span
        _check_integral(ambient, den, words)
        wider = hermite.span(den * below * ambient.scale, ambient.products(words, letters))
        if wider == span:
            break
        span = wider
    if words.nrows() < ambient.size:
        raise LatticeError(
            f"these elements generate a ring of rank {words.nrows() // ambient.degree}, and orders have "
            "rank 4: give elements that lie in no smaller algebra, such as two that do not commute"
        )
    return LatticeValue(ambient, den, words)


def _check_integral(ambient: AlgebraBasis, den: int, rows: fmpz_mat) -> None:
    """Raise :class:`LatticeError` unless all combinations of rows have integral trace and norm."""
    one = ambient.one.numer_denom()[0].entries()
    last = rows.nrows()
    # traces are those of x·conj(1)
    whole = hermite.stacked(rows, ambient.domain.matrix([one]) * den)
    forms = ambient.forms(whole)
    grams = list(map(ambient.domain.polar, forms))
    scale = ambient.scale * den * den
    twice = ambient.domain.form_factor * scale
    for n in range(last):
        norms = (f[n, n] % twice for f in forms)
        if any(norms) or any(g[n, last] % scale for g in grams):
            q = ambient.element(rows.tolist()[n], den)
            raise LatticeError(
                f"these elements generate no order: {shorten(q)} has trace {q.trace()} and norm "
                f"{q.norm()}, which are not both integers"
            )
        for m in range(n):
            if any(g[n, m] % scale for g in grams):
                p, q = (ambient.element(rows.tolist()[k], den) for k in (m, n))
                raise LatticeError(
                    f"these elements generate no order: the sum of {shorten(p)} and {shorten(q)} has a norm "
                    "that is not an integer"
                )
