"""Lattices, orders and ideals over the integers ℤ_K of a number field."""
