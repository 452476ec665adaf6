"""Polynomials over a quaternion algebra and their roots."""
