"""Places with their residue fields: of ℚ, of quadratic number fields and of k(t), under the same names."""
