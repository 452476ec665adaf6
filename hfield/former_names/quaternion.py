"""The class of elements, for pickles of version 0.2."""

from hfield.algebra.quaternion import Quaternion

__all__ = ["Quaternion"]
