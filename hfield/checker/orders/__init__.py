"""Check certificates about lattices, orders and ideals in quaternion algebras."""
