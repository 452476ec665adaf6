"""Arrays over finite rings as rows of labels: residues, or numbers whose base-p digits are the element's
coefficients, as in galois.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias, TypeGuard

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.arithmetic import Arithmetic
from hfield.compiling.calling import ArrayProgram
from hfield.compiling.memory import Rows
from hfield.core.factorisation import factorise
from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import Program
from hfield.errors import CoercionError, shorten
from hfield.fields.base.array_storage import programs
from hfield.fields.base.array_storage.rows import Row, RowArrays, inverses
from hfield.fields.base.arrays import objects
from hfield.fields.base.coercion import is_plain_array
from hfield.fields.base.foreign_values import is_galois

if TYPE_CHECKING:
    import galois

    from hfield.fields.base.ring import Ring
    from hfield.fields.finite.ring import ExtensionField, FiniteField
    from hfield.fields.rationals.ring import Residues

    LabelledRing: TypeAlias = FiniteField | Residues


TABLE = 1 << 16  # rings up to this size have a table of their inverses


class LabelArrays(RowArrays):
    """Arrays over a finite ring whose elements have labels 0 … q − 1; zero has label 0 and one has label 1.

    The ring provides ``label(x)``, ``from_label(n)`` and ``array_of_labels(row)``; ``arithmetic`` is the
    arithmetic of its labels.
    """

    ring: LabelledRing

    def __init__(self, ring: LabelledRing, constants: Constants, arithmetic: Arithmetic) -> None:
        super().__init__(ring, constants)
        self.arithmetic = arithmetic
        self.dtype = arithmetic.dtype
        self.compiles = machine_code.available()
        self._kernels: dict[str, ArrayProgram] = {}

    # --- labels --------------------------------------------------------------------------------

    def row(self, values: object) -> Row:
        """Return the labels of an element, a nested sequence or an array. Raises :class:`CoercionError`."""
        return labels(self.ring, values, self.dtype)

    def ring_array(self, row: Row) -> np.ndarray:
        """Return a row as an array of the ring: a galois array, or an array of objects."""
        return self.ring.array_of_labels(row)

    def single(self, p: Rows) -> Coordinates:
        """Return the coordinates of an array of no dimensions."""
        w, x, y, z = (self.ring.from_label(int(row)) for row in p)
        return w, x, y, z

    def check_numbers(self, block: Row) -> None:
        """Raise an error for values that are not labels."""
        order = self.ring.order
        if block.size and not (int(block.min()) >= 0 and int(block.max()) < order):
            wrong = int(block.min()) if int(block.min()) < 0 else int(block.max())
            raise CoercionError(
                f"{wrong} is not a label of an element of {self.ring}: expected 0 to {shorten(order - 1)}"
            )

    # --- loops ---------------------------------------------------------------------------------

    def kernel(self, name: str) -> ArrayProgram:
        """Return the loop of an operation."""
        if name not in self._kernels:
            self._kernels[name] = self._made(name)
        return self._kernels[name]

    def _made(self, name: str) -> ArrayProgram:
        program, sides = self.program(name)
        given = zip(("a", "t", "b"), self.constants, strict=True)
        constants = {n: self.ring.label(x) for n, x in given if n in program.inputs}
        return ArrayProgram(program, self.arithmetic, sides, constants)

    def program(self, name: str) -> tuple[Program, programs.Sides]:
        """Return the program of an operation; besides the operations of all row storages, there is a product
        followed by a sum.
        """
        if name == "product plus":
            program, sides = super().program("product")
            return programs.with_sum(program), (*sides, programs.THIRD)
        return super().program(name)

    def product_plus(self, p: Rows, q: Rows, r: Rows) -> Rows:
        """Return p·q + r, in one loop."""
        if self.compiles:
            return self.kernel("product plus")(p, q, r)[0]
        return self.sum(self.product(p, q), r)

    def elementwise(self, name: str, *operands: Rows) -> Rows:
        """Run a loop that returns elements."""
        if self.compiles:
            return self.kernel(name)(*operands)[0]
        return self.encode(self.plain.elementwise(name, *map(self.coordinates, operands)))

    def _run_scalar(self, name: str, p: Rows) -> np.ndarray:
        """Run a loop that returns an array of the ring."""
        if self.compiles:
            return self.ring_array(self.kernel(name)(p)[0][0])
        return self.by_arrays(name, p)

    # --- arithmetic ----------------------------------------------------------------------------

    def norm(self, p: Rows) -> np.ndarray:
        """Return the reduced norms, an array of the ring."""
        return self._run_scalar("norm", p)

    def trace(self, p: Rows) -> np.ndarray:
        """Return the reduced traces, an array of the ring."""
        return self._run_scalar("trace", p)

    def units(self, p: Rows) -> np.ndarray:
        """Return a bool array that marks the invertible elements."""
        norms = self.kernel("norm")(p)[0][0] if self.compiles else None
        units: np.ndarray = self.by_arrays("units", p) if norms is None else self._units(norms)
        return units

    def inverse(self, p: Rows) -> Rows | None:
        """Return the inverses, or None if some norm is not a unit of the ring."""
        if not self.compiles:
            found = self.plain.inverse(self.coordinates(p))
            return None if found is None else self.encode(found)
        *conjugate, norms = self.kernel("adjoint")(p)[0]
        if not self._units(norms).all():
            return None
        return self.kernel("scaled")(tuple(conjugate), (self._scalar_inverses(norms),))[0]

    def _scalar_inverses(self, row: Row) -> Row:
        """Return the inverses of labels of units."""
        if self.ring.order <= TABLE:
            return np.asarray(self._inverse_table.take(row))
        return inverses(row.reshape(-1), self._multiplied, self._inverted).reshape(row.shape)

    @cached_property
    def _inverse_table(self) -> Row:
        every = np.arange(self.ring.order, dtype=self.dtype)
        units = every[self._units(every)]
        table = np.zeros_like(every)
        table[units] = inverses(units, self._multiplied, self._inverted)
        return table

    def _multiplied(self, x: Row, y: Row) -> Row:
        return self.kernel("scalar product")((x,), (y,))[0][0]

    def _inverted(self, row: Row) -> Row:
        F = self.ring
        found = [F.label(F.inverse(F.from_label(int(n)))) for n in row]
        return np.array(found, dtype=self.dtype)

    def _units(self, row: Row) -> np.ndarray:
        """Return which labels belong to units."""
        if self.ring.is_field:
            return np.asarray(row != 0)
        units: np.ndarray
        units = np.logical_and.reduce([row % row.dtype.type(p) != 0 for p in self._primes])
        return units

    @cached_property
    def _primes(self) -> tuple[int, ...]:
        """The primes that divide the modulus of a residue ring."""
        return tuple(factorise(self.ring.order))

    def prepare(self) -> None:
        """Compile every loop except that for matrices, or load it from the disk."""
        for name in (
            "product",
            "product plus",
            "conjugate",
            "norm",
            "trace",
            "adjoint",
            *programs.COORDINATEWISE,
        ):
            self.kernel(name).prepare()


def has_labels(ring: Ring) -> TypeGuard[LabelledRing]:
    """Return whether the elements of a ring have labels."""
    return hasattr(ring, "label")


def is_extension(ring: Ring) -> TypeGuard[ExtensionField]:
    """Return whether a ring with labels is a field GF(pⁿ), n > 1."""
    return getattr(ring, "degree", 1) > 1


def labels(F: LabelledRing, values: object, dtype: str) -> Row:
    """Return the labels of an element, a nested sequence or an array, in its shape.

    An integer n means n·1, never galois's label. A galois array must be over this very field, including the
    modulus; it is not copied if the types agree. Raises :class:`CoercionError`.
    """
    if is_galois(values):
        check_galois(F, values)
        return np.asarray(values.view(np.ndarray)).astype(dtype, copy=False)
    if is_plain_array(values) and values.dtype != object:
        if values.dtype.kind not in "iub":
            raise CoercionError(
                f"an array of {values.dtype} is not an array over {F.name}: expected integers, "
                "elements of the ring, or an array of galois over it"
            )
        values = values.copy()  # which nobody changes after it has been checked
        if values.dtype.kind == "u" and values.size and int(values.max()) < F.characteristic:
            return np.asarray(values.astype(dtype, copy=False))
        wide = values if values.dtype == np.uint64 else values.astype(np.int64)
        return np.asarray(wide % wide.dtype.type(F.characteristic)).astype(dtype)
    elements = objects(values, F)
    found = [F.label(elements[n]) for n in np.ndindex(*elements.shape)]
    return np.array(found, dtype=dtype).reshape(elements.shape)


def check_galois(F: LabelledRing, values: galois.FieldArray) -> None:
    """Raise an error for galois values over another field, or with another modulus."""
    cls = type(values)
    degree, coefficients = (F.degree, F.coefficients) if is_extension(F) else (1, None)
    same = F.is_field and (cls.characteristic, cls.degree) == (F.characteristic, degree)
    modulus = [int(c) for c in cls.irreducible_poly.coeffs][::-1]
    if not same or (coefficients is not None and modulus != coefficients):
        raise CoercionError(
            f"galois values of {cls.name} modulo {cls.irreducible_poly} are not of {F.name}"
            + (f" modulo {shorten(F.modulus)}" if is_extension(F) else "")
        )
