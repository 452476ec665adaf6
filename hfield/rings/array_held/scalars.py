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
        self._kernels = {
            name: Kernel(program, arithmetic, sides, {})
            for name, (program, sides) in programs.SCALARS.items()
        }

    def __call__(self, operation: str, *rows: Row) -> Row:
        """Return the ``sum``, ``difference`` or ``product`` of two arrays, or the ``negative`` of one."""
        return self._kernels[operation](*((row,) for row in rows))[0][0]


def scalar_arrays(ring: Any) -> ScalarArrays | None:
    """Return the arithmetic of arrays over a finite ring with labels; None where no loop serves it."""
    if not hasattr(ring, "label") or not machine_code.available():
        return None
    arithmetic = arithmetic_of(ring)
    return None if arithmetic is None else ScalarArrays(arithmetic)
