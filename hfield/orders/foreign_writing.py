"""Write lattices, orders and ideals as code for Sage, Magma and PARI."""

from __future__ import annotations

from collections.abc import Sequence

from hfield.core.product import Coordinates
from hfield.errors import LatticeError, RingError
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.pseudo_bases import free_basis, pseudo_basis
from hfield.orders.validation import expect_rational
from hfield.syntax.other_systems import OtherSystemWriter

Basis = list[Coordinates]


def lattice_text(lattice: LatticeValue, system: str) -> str:
    """Write a lattice by its basis."""
    writer = _writer(lattice, system)
    _expect_rational(lattice, writer, "fractional ideals")
    return writer.lattice(_basis(lattice, writer))


def order_text(order: LatticeValue, system: str) -> str:
    """Write an order by its basis."""
    writer = _writer(order, system)
    return writer.order(_basis(order, writer))


def ideal_text(ideal: LatticeValue, order: LatticeValue, side: str, system: str) -> str:
    """Write an ideal of an order."""
    writer = _writer(ideal, system)
    _expect_rational(ideal, writer, "ideals of orders")
    return writer.ideal(_basis(order, writer), _basis(ideal, writer), side)


def ideals_text(ideals: Sequence[LatticeValue], order: LatticeValue, side: str, system: str) -> str:
    """Write a list of ideals of one order."""
    writer = _writer(order, system)
    _expect_rational(order, writer, "ideals of orders")
    return writer.ideals(_basis(order, writer), [_basis(I, writer) for I in ideals], side)


def _writer(lattice: LatticeValue, system: str) -> OtherSystemWriter:
    """Return the writer for a system. Raises :class:`RingError` for Sage over ℚ unless the constants are
    integers.
    """
    writer = OtherSystemWriter(lattice.algebra.ring, lattice.algebra.constants, system)
    base = lattice.ambient.base
    integral = all(base.is_integral(base.principal(x)) for x in lattice.ambient.constants if x)
    if writer.system == "sage" and base.is_rational and not integral:
        raise RingError(
            f"Sage has lattices in algebras with integers a and b, and not in {lattice.algebra}: "
            "isomorphism() leads to one"
        )
    return writer


def _basis(lattice: LatticeValue, writer: OtherSystemWriter) -> Basis:
    """Return a ℤ-basis as coordinates; for Sage, four elements that are a basis over the integers of the
    field.

    Raises :class:`RingError` for Sage if there is no such basis.
    """
    basis = lattice.basis
    if writer.system == "sage" and len(basis) > 4:
        try:
            basis = free_basis(lattice.ambient, pseudo_basis(lattice))
        except LatticeError as error:
            raise RingError(f"orders in Sage have a basis of four elements: {error}") from None
    return [q.coordinates for q in basis]


def _expect_rational(lattice: LatticeValue, writer: OtherSystemWriter, what: str) -> None:
    """Raise :class:`RingError` for Sage over fields other than ℚ."""
    error = RingError(
        f"{what} are not written for Sage over {lattice.algebra.ring.name}: Sage has them over QQ; "
        "text_for('magma') writes them, and so does text_for('pari') by a basis over ZZ"
    )
    if writer.system == "sage":
        expect_rational(lattice.ambient.base, error)
