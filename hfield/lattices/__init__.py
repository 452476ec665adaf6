"""Lattices, orders and ideals in quaternion algebras over ℚ: their arithmetic and their classes.

``docs/orders.md`` shows what can be asked; each module says which theorem it stands on.
"""
