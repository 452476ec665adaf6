"""Quaternion algebras over local fields: the completions of global fields."""
