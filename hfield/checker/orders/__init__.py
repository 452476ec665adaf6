"""Lattices, orders and ideals in quaternion algebras over ℚ: what certificates say of them, checked."""
