"""Rings whose elements are values that compare, hash and pickle by themselves."""

from collections.abc import Hashable
from typing import Any

from hfield.product import Scalar
from hfield.rings.base import Ring


class ValueRing(Ring):
    """A ring of such values: each stands for itself."""

    def is_zero(self, x: Any) -> bool:
        """Tell whether x is 0."""
        return bool(x == 0)

    def equal(self, x: Any, y: Any) -> bool:
        """Tell whether x = y."""
        return bool(x == y)

    def key(self, x: Any) -> Hashable:
        """Return x itself."""
        key: Hashable = x
        return key

    def state(self, x: Scalar) -> object:
        """Return x itself."""
        return x
