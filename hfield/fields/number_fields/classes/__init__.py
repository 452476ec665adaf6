"""Classes of ideals and units of number fields: S-units, class groups, and ζ_K(−1) that counts with them."""
