"""k(t): Hilbert symbols, residue fields, conics, common slots, what is inseparable."""
