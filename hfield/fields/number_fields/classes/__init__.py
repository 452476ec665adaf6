"""Ideal classes and units of number fields: S-units, class groups, and ζ_K(−1), which is computed
from them.
"""
