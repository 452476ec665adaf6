"""Matrices over a quaternion algebra, and linear equations in it."""
