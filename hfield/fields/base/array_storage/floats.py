"""Arrays of quaternions over RDF and CDF as a single numpy array; its first axis is that of the
coordinates.
"""

from __future__ import annotations

from types import EllipsisType
from typing import TYPE_CHECKING

import numpy as np

from hfield.compiling import machine_code, memory
from hfield.compiling.arithmetics.doubles import Doubles
from hfield.compiling.calling import ArrayProgram
from hfield.compiling.memory import rows_of
from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import FIRST, SECOND, pattern, specialise
from hfield.errors import CoercionError
from hfield.fields.base.array_storage import programs
from hfield.fields.base.array_storage.rows import block_of
from hfield.fields.base.arrays import one_shape, read_only
from hfield.fields.base.storage.base import BatchStorage

if TYPE_CHECKING:
    from hfield.fields.base.arrays import Index
    from hfield.fields.base.ring import Ring

Block = np.ndarray
MIN_COMPILED = 1000  # quaternions from which on a loop is compiled for them


class FloatArrays(BatchStorage[Block]):
    """Storage of arrays over a ring of floats as one array of shape (4, …)."""

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        self.plain, self.dtype = BatchStorage(ring, constants), self.constants.a.dtype.str
        self._kernels: dict[str, ArrayProgram] = {}

    def kernel(self, name: str) -> ArrayProgram:
        """Return the loop of an operation on four rows of floats."""
        if name not in self._kernels:
            if name in programs.COORDINATEWISE:
                program, sides = programs.COORDINATEWISE[name]
            else:
                exact = Constants(*map(float, self.constants))
                program = specialise(name, pattern(exact, lambda x, n: x == n))
                sides = (FIRST, SECOND) if name == "product" else (FIRST,)
            given = {
                n: float(x) for n, x in self.constants._asdict().items() if n in program.inputs
            }
            self._kernels[name] = ArrayProgram(program, Doubles(), sides, given)
        return self._kernels[name]

    def _compiles(self, size: int) -> bool:
        """Return whether the loop is compiled for this number of elements."""
        return size >= MIN_COMPILED and self.dtype == "<f8" and machine_code.available()

    def elementwise(self, name: str, *operands: Block) -> Block:
        """Apply an operation, by a compiled loop if there are many elements."""
        if not self._compiles(max(p[0].size for p in operands)):
            return self.encode(self.plain.elementwise(name, *map(self.coordinates, operands)))
        (w, x, y, z), _ = self.kernel(name)(*map(rows_of, operands))
        return self.encode((w, x, y, z))

    def norm(self, p: Block, /) -> np.ndarray:
        """Return the norms, by a compiled loop if there are many elements."""
        if not self._compiles(p[0].size):
            return super().norm(p)
        (norms,), _ = self.kernel("norm")(rows_of(p))
        return norms

    # --- in and out ----------------------------------------------------------------------------

    def encode(self, coordinates: Coordinates) -> Block:
        """Encode four arrays of one shape; if they are the rows of one array, nothing is copied."""
        block = coordinates if isinstance(coordinates, np.ndarray) else block_of(coordinates)
        if block is None:
            block, _ = memory.block((4, *coordinates[0].shape), self.dtype)
            for row, numbers in zip(rows_of(block), coordinates, strict=True):
                row[...] = numbers
        return block

    def read(self, values: tuple[object, ...]) -> Block:
        """Encode copies of four arrays that the ring reads. Raises :class:`CoercionError`."""
        return np.stack(one_shape([self.ring.array(v) for v in values]))

    def coordinates(self, stored: Block) -> Coordinates:
        """Return the four rows."""
        w, x, y, z = stored[0, ...], stored[1, ...], stored[2, ...], stored[3, ...]
        return w, x, y, z

    def shape(self, p: Block) -> tuple[int, ...]:
        """Return the shape of the array."""
        shape: tuple[int, ...] = p.shape[1:]
        return shape

    def part(self, p: Block, index: Index) -> Block:
        """Return the elements at a numpy index, as a view if numpy makes one."""
        parts = index if isinstance(index, tuple) else (index,)
        if all(n is None or isinstance(n, (int, slice, EllipsisType)) for n in parts):
            view: Block = p[(slice(None), *parts)]
            return view
        return np.stack([row[index] for row in p])

    def reshaped(self, p: Block, shape: tuple[int, ...]) -> Block:
        """Return the elements in another shape."""
        return p.reshape(4, *((shape,) if isinstance(shape, int) else shape))

    def to_array(self, p: Block) -> Block:
        """Return the array itself, read-only."""
        return read_only(p)

    def from_array(self, values: object, copy: bool = True) -> Block:
        """Encode an array of floats of shape (4, …). Raises :class:`CoercionError`."""
        given = np.asarray(values)
        if given.ndim == 0 or given.shape[0] != 4 or given.dtype.kind not in "iufc":
            raise CoercionError(
                f"an array of {given.dtype} of shape {given.shape} does not hold quaternions over "
                f"{self.ring}: expected numbers of shape (4, …), or (…, 4) with axis=-1"
            )
        block: Block = self.ring.array(given)
        return block.copy() if copy and np.may_share_memory(block, given) else block
