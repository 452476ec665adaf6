"""Choose the arithmetic for arrays over a finite ring, by its order and degree."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.compiling import machine_code
from hfield.compiling.arithmetic import Arithmetic
from hfield.compiling.arithmetics.binary_fields import binary_field
from hfield.compiling.arithmetics.extension_fields import PolynomialArithmetic
from hfield.compiling.arithmetics.logarithms import LogarithmicField
from hfield.compiling.arithmetics.register_tables import (
    ORDER,
    PROCESSOR,
    BinaryRegisterField,
    RegisterField,
)
from hfield.compiling.arithmetics.residues import ResidueArithmetic
from hfield.compiling.calling import ArrayProgram
from hfield.core.factorisation import factorise
from hfield.core.product import Constants
from hfield.fields.base.array_storage import programs
from hfield.fields.base.array_storage.labels import LabelArrays, has_labels, is_extension
from hfield.fields.base.array_storage.object_arrays import ObjectArrays
from hfield.fields.base.array_storage.rows import Row
from hfield.fields.base.storage.base import BatchStorage

if TYPE_CHECKING:
    from hfield.fields.base.array_storage.labels import LabelledRing
    from hfield.fields.base.ring import Ring
    from hfield.fields.finite.ring import FiniteField

WORD = 1 << 32  # the largest modulus whose residues multiply in one word
BITS = 64  # the largest degree over GF(2) whose elements do
LOGARITHMS_FROM = 4  # degrees: below, products of polynomials are quicker
LOGARITHMS_UP_TO = 1 << 16  # elements: beyond, tables leave the caches
POLYNOMIALS_UP_TO = 6  # degrees: beyond, compiling takes seconds


def array_storage(ring: LabelledRing, constants: Constants) -> BatchStorage:
    """Return the storage of arrays over ℤ/n or a finite field: as labels if an arithmetic for them is
    available.
    """
    arithmetic = arithmetic_of(ring)
    if arithmetic is not None:
        return LabelArrays(ring, constants, arithmetic)
    return ObjectArrays(ring, constants)


def arithmetic_of(ring: LabelledRing) -> Arithmetic | None:
    """Return the arithmetic of the labels of a finite ring, or None if the ring is too large."""
    q, p = ring.order, ring.characteristic
    if not is_extension(ring):
        return ResidueArithmetic.modulo(q) if q <= WORD else None
    n, coefficients = ring.degree, tuple(ring.coefficients)
    if q <= ORDER and machine_code.available() and machine_code.processor_has(PROCESSOR):
        kind = BinaryRegisterField if p == 2 else RegisterField
        return kind(p, coefficients, primitive(ring))
    if p == 2:
        bits = sum(c << m for m, c in enumerate(ring.coefficients))
        instruction = machine_code.available() and machine_code.processor_has("pclmul")
        return binary_field(bits, instruction) if n <= BITS else None
    if n >= LOGARITHMS_FROM and q <= LOGARITHMS_UP_TO:
        return LogarithmicField(p, coefficients, primitive(ring))
    if q <= WORD and n <= POLYNOMIALS_UP_TO:
        return PolynomialArithmetic(p, coefficients)
    return None


def primitive(F: FiniteField) -> int:
    """Return the label of a generator of the multiplicative group of GF(pⁿ), n > 1; that of x if x generates
    it.
    """
    primes = factorise(F.order - 1)
    for label in range(F.characteristic, F.order):
        x = F.from_label(label)
        if all(x ** ((F.order - 1) // p) != F.one for p in primes):
            return label
    raise AssertionError("the multiplicative group of a finite field is cyclic")


class ScalarArrays:
    """The arithmetic of arrays of labels 0 … q − 1 of type ``dtype``; shapes are broadcast."""

    def __init__(self, arithmetic: Arithmetic) -> None:
        self.dtype: str = arithmetic.dtype
        self._kernels = {
            name: ArrayProgram(program, arithmetic, sides, {})
            for name, (program, sides) in programs.SCALARS.items()
        }

    def __call__(self, operation: str, *rows: Row) -> Row:
        """Return the ``sum``, ``difference`` or ``product`` of two arrays, or the ``negative`` of one."""
        return self._kernels[operation](*((row,) for row in rows))[0][0]


def scalar_arrays(ring: Ring) -> ScalarArrays | None:
    """Return the arithmetic of arrays over a finite ring with labels; None if no loop supports it."""
    if not has_labels(ring) or not machine_code.available():
        return None
    arithmetic = arithmetic_of(ring)
    return None if arithmetic is None else ScalarArrays(arithmetic)
