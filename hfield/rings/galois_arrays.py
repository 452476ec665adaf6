"""Arrays of finite field elements: galois where it is quick, numpy objects where the field is large."""

from functools import lru_cache
from typing import Any

import galois
import numpy as np

from hfield.errors import CoercionError, shorten
from hfield.factorisation import factorise
from hfield.rings.arrays import Objects, objects
from hfield.rings.base import Ring
from hfield.rings.rational import is_plain_array

GALOIS_BELOW = 2**31  # from here on galois would compute with Python objects, slower than flint's
TABLES_BELOW = 2**16  # from here on its tables would take seconds to build


@lru_cache(maxsize=256)
def field_class(F: Any) -> Any:
    """Return galois's array class for the finite field F, with F's modulus; None if F is too large."""
    if F.order >= GALOIS_BELOW:
        return None
    options: dict[str, Any] = {} if F.order < TABLES_BELOW else {"compile": "jit-calculate"}
    if F.degree > 1:
        # Told a primitive element, galois need not search for one, which may take it seconds.
        poly = galois.Poly(F.coefficients[::-1], field=galois.GF(F.characteristic))
        options |= {"irreducible_poly": poly, "primitive_element": _primitive(F), "verify": False}
    cls = galois.GF(F.order, **options)
    one = cls.Ones(1)
    one * one - one  # builds galois's tables now, and not inside somebody's first product
    return cls


def _primitive(F: Any) -> int:
    """Return the label of a generator of the multiplicative group; x itself if it is one."""
    primes = factorise(F.order - 1)
    for label in range(F.characteristic, F.order):
        x = F.from_label(label)
        if all(x ** ((F.order - 1) // p) != F.one for p in primes):
            return label
    raise AssertionError("the multiplicative group of a finite field is cyclic")


def array(F: Any, values: Any) -> Any:
    """Turn an element, a nested sequence or an array into an array over F, keeping its shape.

    Integers n become n·1, never galois's label; a galois array must be over this very field, modulus
    included. Raises :class:`CoercionError`.
    """
    cls = field_class(F)
    if cls is None:
        return objects(values, F)
    if hasattr(type(values), "irreducible_poly"):
        _check(F, values)
        return (
            values
            if type(values) is cls
            else cls._view(values.view(np.ndarray).astype(cls.dtypes[0]))
        )
    if is_plain_array(values) and values.dtype != object:
        if values.dtype.kind not in "iub":
            raise CoercionError(
                f"an array of {values.dtype} is not an array over {F.name}: expected integers, "
                "elements of the field, or an array of galois over it"
            )
        wide = values if values.dtype == np.uint64 else values.astype(np.int64)
        residues = np.asarray(wide % wide.dtype.type(F.characteristic))  # or 0 dimensions get lost
        return residues.astype(cls.dtypes[0]).view(cls)
    elements = objects(values, F)
    labels = [F.label(elements[n]) for n in np.ndindex(*elements.shape)]
    return np.array(labels, dtype=cls.dtypes[0]).reshape(elements.shape).view(cls)


def _check(F: Any, values: Any) -> None:
    cls = type(values)
    same = (cls.characteristic, cls.degree) == (F.characteristic, F.degree)
    modulus = [int(c) for c in cls.irreducible_poly.coeffs][::-1]
    if not same or (F.degree > 1 and modulus != F.coefficients):
        raise CoercionError(
            f"galois values of {cls.name} modulo {cls.irreducible_poly} are not of {F.name}"
            + (f" modulo {shorten(F.modulus)}" if F.degree > 1 else "")
        )


def from_galois(F: Any, x: Any) -> Any:
    """Turn a galois scalar over F into an element. Raises :class:`CoercionError`."""
    _check(F, x)
    if x.ndim:
        raise CoercionError(
            f"an array of shape {x.shape} is not one element of {F.name}: use {F.name}.array"
        )
    return F.from_label(int(x))


def scalar(F: Any, x: Any) -> Any:
    """Turn an entry of an array over F into an element."""
    if isinstance(x, Objects):
        return x[()]
    return from_galois(F, x) if hasattr(type(x), "irreducible_poly") else x


def units(F: Any, values: Any) -> Any:
    """Return a bool array: which entries are not 0."""
    if isinstance(values, Objects):
        return Ring.array_units(F, values)
    return np.asarray(values.view(np.ndarray) != 0)


def inverse(F: Any, values: Any) -> Any:
    """Invert an array of nonzero entries elementwise."""
    if isinstance(values, Objects):
        return Ring.array_inverse(F, values)
    return np.reciprocal(values)


def conway(p: int, n: int) -> list[int] | None:
    """Return Conway's polynomial from galois's table, low degree first; None where it has none."""
    try:
        return [int(c) for c in galois.conway_poly(p, n, search=False).coeffs][::-1]
    except LookupError:
        return None
