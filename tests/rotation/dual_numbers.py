"""Dual numbers ``a + b·ε`` with ``ε² = 0``, on arrays: what the product of `hfield` needs of a ring.

The same ring as QQ[ε]/(ε²), on floats. A unit quaternion over it is a rigid motion: W. K. Clifford,
"Preliminary sketch of biquaternions", Proc. London Math. Soc. 4 (1873); E. Study, "Geometrie der Dynamen"
(1903).
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from hfield.core import product as formula
from rotation.array_types import Array
from rotation.quaternions import HAMILTON


@dataclass(frozen=True, slots=True, eq=True)
class Dual:
    """A dual number: ``real + dual·ε``; floats count as those without ε."""

    real: Array
    dual: Array

    def __add__(self, other: Any) -> "Dual":
        a, b = _parts(other)
        return Dual(self.real + a, self.dual + b)

    def __radd__(self, other: Any) -> "Dual":
        return self.__add__(other)

    def __neg__(self) -> "Dual":
        return Dual(-self.real, -self.dual)

    def __sub__(self, other: Any) -> "Dual":
        a, b = _parts(other)
        return Dual(self.real - a, self.dual - b)

    def __rsub__(self, other: Any) -> "Dual":
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> "Dual":
        a, b = _parts(other)
        return Dual(self.real * a, self.real * b + self.dual * a)

    def __rmul__(self, other: Any) -> "Dual":
        return self.__mul__(other)


def _parts(value: Any) -> tuple[Array, Array]:
    return (value.real, value.dual) if isinstance(value, Dual) else (value, 0.0)


def dual_product(p: Array, q: Array) -> Array:
    """Return products of dual quaternions (…, 8): the one formula of `hfield`, over dual numbers."""
    a, b = (tuple(Dual(x[..., n], x[..., n + 4]) for n in range(4)) for x in (p, q))
    whole = formula.multiply(HAMILTON, a, b)
    return np.stack([*(c.real for c in whole), *(c.dual for c in whole)], axis=-1)
