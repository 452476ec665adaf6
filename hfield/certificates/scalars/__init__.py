"""The base rings of the checker, on plain, hashable values: ℤ, ℚ, ℤ/n, GF(q), square roots, F(t), R[x, y]."""
