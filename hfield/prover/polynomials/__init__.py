"""Clauses about polynomials, and ideals with cofactors, in commutative and free algebras."""
