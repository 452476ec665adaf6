"""Compact storage of single elements: ints over one denominator, residues, labels, polynomials."""
