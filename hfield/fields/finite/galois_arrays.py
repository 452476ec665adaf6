"""Arrays of finite field elements: galois arrays for small fields, numpy object arrays for large ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

import galois
import numpy as np

from hfield.compiling.machine_code import available, lock
from hfield.errors import CoercionError
from hfield.fields.base.array_storage.finite import primitive
from hfield.fields.base.array_storage.labels import check_galois, is_extension, labels
from hfield.fields.base.arrays import Objects, objects
from hfield.fields.base.foreign_values import is_galois
from hfield.fields.base.ring import Ring

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Coefficient
    from hfield.fields.finite.ring import FiniteField


GALOIS_BELOW = 2**31  # from here on galois would compute with Python objects, slower than flint's
TABLES_BELOW = 2**16  # from here on its tables would take seconds to build
_classes: dict[FiniteField, type[galois.FieldArray]] = {}


def field_class(F: FiniteField) -> type[galois.FieldArray] | None:
    """Return galois's array class for the finite field F with F's modulus; None if F is too large."""
    if F.order >= GALOIS_BELOW:
        return None
    found = _classes.get(F)
    if found is None:
        with (
            lock
        ):  # with two classes for one field, arrays of one could not be combined with the others
            found = _classes.get(F)
            if found is None:
                found = _classes[F] = _made_class(F)
    return found


def _made_class(F: FiniteField) -> type[galois.FieldArray]:
    # Each new class evaluates its polynomial once, for which galois otherwise compiles a loop,
    # which takes a second. Without numba's compiler galois uses another method.
    options: dict[str, object] = {"compile": "python-calculate" if available() else "auto"}
    subfield = galois.GF(F.characteristic, **options)
    if is_extension(F):
        # With a primitive element given, galois does not search for one, which may take seconds.
        poly = galois.Poly(F.coefficients[::-1], field=subfield)
        options |= {"irreducible_poly": poly, "primitive_element": primitive(F), "verify": False}
    cls: type[galois.FieldArray] = galois.GF(F.order, **options)
    for made in (subfield, cls):
        made.compile("auto" if made.order < TABLES_BELOW else "jit-calculate")
    if cls.ufunc_mode == "jit-lookup":
        one = cls.Ones(1)
        one * one - one  # builds galois's tables now, and not inside somebody's first product
    return cls


def array(F: FiniteField, values: object) -> np.ndarray:
    """Convert an element, a nested sequence or an array to an array over F of the same shape.

    An integer n means n·1, never galois's label. A galois array must be over this very field, including the
    modulus. Raises :class:`CoercionError`.
    """
    cls = field_class(F)
    if cls is None:
        return objects(values, F)
    return of_labels(F, labels(F, values, cls.dtypes[0].__name__))


def of_labels(F: FiniteField, row: np.ndarray) -> np.ndarray:
    """Return labels as an array over F, without a copy if galois accepts their type."""
    cls = field_class(F)
    if cls is None:
        return objects(row, lambda n: F.from_label(int(n)))
    return row.astype(cls.dtypes[0], copy=False).view(cls)


def from_galois(F: FiniteField, x: galois.FieldArray) -> Coefficient:
    """Convert a galois scalar over F to an element. Raises :class:`CoercionError`."""
    check_galois(F, x)
    if x.ndim:
        raise CoercionError(
            f"an array of shape {x.shape} is not one element of {F.name}: use {F.name}.array"
        )
    return F.from_label(int(x))


def scalar(F: FiniteField, x: object) -> Coefficient:
    """Convert an entry of an array over F to an element."""
    if isinstance(x, Objects):
        return x[()]
    return from_galois(F, x) if is_galois(x) else x


def units(F: FiniteField, values: np.ndarray) -> np.ndarray:
    """Return a bool array that marks the nonzero entries."""
    if isinstance(values, Objects):
        return Ring.array_units(F, values)
    return np.asarray(values.view(np.ndarray) != 0)


def inverse(F: FiniteField, values: np.ndarray) -> np.ndarray:
    """Invert an array of nonzero entries elementwise."""
    if isinstance(values, Objects):
        return Ring.array_inverse(F, values)
    inverses: np.ndarray = np.reciprocal(values)
    return inverses


def conway(p: int, n: int) -> list[int] | None:
    """Return Conway's polynomial from galois's table, low degree first; None if the table does not contain
    it.
    """
    try:
        return [int(c) for c in galois.conway_poly(p, n, search=False).coeffs][::-1]
    except LookupError:
        return None
