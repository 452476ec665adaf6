"""Quaternion algebras over rational functions in several variables: residues at prime polynomials."""
