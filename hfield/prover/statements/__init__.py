"""Statements: their names and sorts, their setting, their trees, and how they are printed."""
