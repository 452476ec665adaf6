"""Arrays of elements of a finite ring, as labels, added and multiplied by compiled loops."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from hfield.compiling import machine_code
from hfield.compiling.calling import Kernel
from hfield.rings.array_held import programs
from hfield.rings.array_held.finite import arithmetic_of
from hfield.rings.array_held.rows import Row

if TYPE_CHECKING:
    from hfield.compiling.arithmetic import Arithmetic


class ScalarArrays:
    """The arithmetic of arrays of labels 0 … q − 1, which are of the type ``dtype`` and broadcast."""

    def __init__(self, arithmetic: Arithmetic) -> None:
        self.dtype: str = arithmetic.dtype
        one, both = (programs.SCALAR,), (programs.SCALAR, programs.OTHER_SCALAR)
        self._sum = Kernel(programs.SCALAR_SUM, arithmetic, both, {})
        self._difference = Kernel(programs.SCALAR_DIFFERENCE, arithmetic, both, {})
        self._product = Kernel(programs.SCALAR_PRODUCT, arithmetic, both, {})
        self._negative = Kernel(programs.SCALAR_NEGATIVE, arithmetic, one, {})

    def sum(self, x: Row, y: Row) -> Row:
        """Return x + y."""
        return self._sum((x,), (y,))[0][0]

    def difference(self, x: Row, y: Row) -> Row:
        """Return x − y."""
        return self._difference((x,), (y,))[0][0]

    def product(self, x: Row, y: Row) -> Row:
        """Return x·y."""
        return self._product((x,), (y,))[0][0]

    def negative(self, x: Row) -> Row:
        """Return −x."""
        return self._negative((x,))[0][0]


def scalar_arrays(ring: Any) -> ScalarArrays | None:
    """Return the arithmetic of arrays over a finite ring with labels; None where no loop serves it."""
    if not hasattr(ring, "label") or not machine_code.available():
        return None
    arithmetic = arithmetic_of(ring)
    return None if arithmetic is None else ScalarArrays(arithmetic)
