"""ℚ(√d): Hilbert symbols, prime ideals, conics, common slots."""
