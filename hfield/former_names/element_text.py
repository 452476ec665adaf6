"""Functions referred to by pickles of arrays of elements from version 0.2."""

from typing import Any

from hfield.algebra.quaternion import Parent, Quaternion, _from_states

__all__ = ["_from_array", "_from_states"]


def _from_array(algebra: Parent, block: Any) -> Quaternion:
    return algebra.from_array(block)
