"""Lattices and elements as JSON data, in evidence and certificates."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.lattices.hermite import tuples

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.lattices.lattice import Lattice


def rows_json(lattice: Lattice) -> dict[str, object]:
    """Return a lattice as JSON: its denominator and Hermite rows."""
    den, rows = lattice.hnf
    return {"den": den, "rows": [list(row) for row in rows]}


def element_json(q: Quaternion) -> list[str]:
    """Return an element as four texts."""
    return [q.ring.text(x) for x in q.coordinates]


def basis_json(lattice: Lattice) -> dict[str, object]:
    """Return a reduced basis of a lattice: what is run through quickly."""
    rows, _ = lattice._reduced
    return {"den": lattice._den, "rows": [list(row) for row in tuples(rows)]}
