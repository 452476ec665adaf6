"""The meaning of names in texts of polynomials, equations and matrices."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.product import Scalar
from hfield.errors import CoercionError, shorten
from hfield.syntax import OfTrees

T = TypeVar("T")


def vocabulary(
    algebra: Parent, wrap: Callable[[Quaternion], T], constant: Callable[[T], Quaternion]
) -> tuple[dict[str, T], dict[str, Callable[..., T]]]:
    """Return the names of constants, and the ring's functions, such as sqrt, on scalars.

    ``wrap`` converts an element to the reader's values, and ``constant`` converts it back, or raises an
    error.
    """
    F = algebra.ring

    def lifted(f: Callable[..., Scalar]) -> Callable[..., T]:
        if isinstance(f, OfTrees):
            return f.then(lambda x: wrap(algebra.scalar(x)))

        def apply(*arguments: T) -> T:
            elements = [constant(x) for x in arguments]
            for q in elements:
                if q.vector_part:
                    raise CoercionError(f"functions of {F.name} take scalars, found {shorten(q)}")
            return wrap(algebra.scalar(f(*(q.coordinates[0] for q in elements))))

        return apply

    names = {name: wrap(algebra.scalar(x)) for name, x in F.names().items()}
    names |= {name: wrap(q) for name, q in zip("eijk", algebra.basis, strict=True)}
    return names, {name: lifted(f) for name, f in F.functions().items()}
