"""The places with a residue field, of every kind: what conics and norm forms are made small at."""

from typing import TypeAlias

from hfield.fields.function_fields.residues import ResidueField
from hfield.fields.rationals.residues import PrimePlace

FinitePlace: TypeAlias = PrimePlace | ResidueField
