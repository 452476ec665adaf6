"""The algebra and its elements: the parent, the quaternion (one or an array of them), and their maps."""

from hfield.algebra.quaternion_algebra import H, QuaternionAlgebra, ternary_form

__all__ = ["H", "QuaternionAlgebra", "ternary_form"]
