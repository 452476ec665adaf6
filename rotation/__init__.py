"""Rotations of the plane and of space: the algebra of `hfield` on floats."""
