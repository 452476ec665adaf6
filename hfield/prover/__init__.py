"""Statements about quaternion algebras and the procedures that decide them, with evidence."""
