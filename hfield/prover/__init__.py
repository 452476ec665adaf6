"""Decide statements about quaternion algebras, with evidence."""
