"""Clauses about polynomials, and ideals with cofactors, commutative and free."""
