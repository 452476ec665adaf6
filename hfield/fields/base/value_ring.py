"""Rings whose elements are plain values that compare, hash and pickle."""

from collections.abc import Hashable

from hfield.core.product import Scalar
from hfield.fields.base.ring import E, Ring


class ValueRing(Ring[E]):
    """A ring whose elements are stored as they are."""

    def is_zero(self, x: E) -> bool:
        """Return whether x is 0."""
        return bool(x == 0)

    def equal(self, x: E, y: E) -> bool:
        """Return whether x = y."""
        return bool(x == y)

    def key(self, x: E) -> Hashable:
        """Return x itself."""
        return x  # type: ignore[return-value]  # these values are hashable

    def state(self, x: Scalar) -> object:
        """Return x itself."""
        return x
