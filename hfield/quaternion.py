"""The element by the path that pickles of version 0.2 name."""

from hfield.algebra.quaternion import Quaternion

__all__ = ["Quaternion"]
