"""Compact forms of single elements: ints over one denominator, residues, labels, unreduced polynomials."""
