"""How a quaternion, or an array of them, is written and pickled."""

from __future__ import annotations

from typing import Any

from hfield.batches import BatchMethods
from hfield.errors import CoercionError
from hfield.notation import element_text


class ElementText(BatchMethods):
    """The part of a quaternion's methods that write it down."""

    __slots__ = ()

    algebra: Any
    ring: Any
    coordinates: Any
    is_batch: Any

    def text(self, style: str = "plain") -> str:
        """Write q in the style ``plain`` (which the algebra reads back), ``unicode`` or ``latex``."""
        if not self.is_batch:
            return element_text(self.ring, self.coordinates, style)
        shown = (
            ", ".join(self[n].text(style) for n in range(min(len(self), 3))) if self.shape else ""
        )
        more = ", …" if self.shape and len(self) > 3 else ""
        return f"<array of shape {self.shape} over {self.algebra}: {shown}{more}>"

    def __str__(self) -> str:
        return self.text("plain")

    def __repr__(self) -> str:
        return self.text("unicode")

    def __format__(self, spec: str) -> str:
        return format(str(self), spec)

    def _repr_latex_(self) -> str | None:
        return None if self.is_batch else f"${self.text('latex')}$"  # an array has its repr

    def __reduce__(self) -> tuple[object, ...]:
        state = self.ring.state
        if not self.is_batch:
            return self.algebra, tuple(map(state, self.coordinates))
        try:
            return _from_array, (self.algebra, self.to_array())
        except CoercionError:
            coordinates = self.coordinates
        if coordinates[0].dtype != object:  # numpy's arrays pickle as they are
            return type(self), (self.algebra, coordinates)
        rows = tuple([state(x) for x in c.ravel().tolist()] for c in coordinates)
        return _from_states, (type(self), self.algebra, self.shape, rows)


def _from_array(algebra: Any, block: Any) -> Any:
    """Make an array of quaternions again from its integers."""
    return algebra.from_array(block)


def _from_states(
    element: Any, algebra: Any, shape: tuple[int, ...], rows: tuple[list[Any], ...]
) -> Any:
    """Make an array of quaternions again from what stood for its entries."""
    w, x, y, z = (algebra.ring.array(row).reshape(shape) for row in rows)
    return element(algebra, (w, x, y, z))
