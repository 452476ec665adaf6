"""The places with a residue field, of every kind: what conics and norm forms are made small at."""

from typing import TypeAlias

from hfield.rings.residues.prime_numbers import PrimePlace
from hfield.rings.residues.prime_polynomials import ResidueField

FinitePlace: TypeAlias = PrimePlace | ResidueField
