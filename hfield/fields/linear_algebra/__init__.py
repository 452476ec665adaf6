"""Matrices over base rings: echelon forms, kernels, syzygies; lattices reduced by LLL."""
