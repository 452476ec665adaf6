"""Isomorphisms of two algebras, and splittings."""
