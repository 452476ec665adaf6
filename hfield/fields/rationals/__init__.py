"""ℚ: Hilbert symbols, conics, quadratic forms, embeddings by lattices."""
