"""Types of flint's values: numbers, coefficients, polynomials in one or several variables."""

from fractions import Fraction
from typing import TypeAlias

import flint

Rational: TypeAlias = int | Fraction | flint.fmpz | flint.fmpq
Coefficient: TypeAlias = flint.fmpz | flint.fmpq | flint.nmod | flint.fmpz_mod | flint.fq_default
Polynomial: TypeAlias = (
    flint.fmpz_poly
    | flint.fmpq_poly
    | flint.nmod_poly
    | flint.fmpz_mod_poly
    | flint.fq_default_poly
)
SparsePolynomial: TypeAlias = (
    flint.fmpz_mpoly | flint.fmpq_mpoly | flint.nmod_mpoly | flint.fmpz_mod_mpoly
)
SparseContext: TypeAlias = (
    flint.fmpz_mpoly_ctx | flint.fmpq_mpoly_ctx | flint.nmod_mpoly_ctx | flint.fmpz_mod_mpoly_ctx
)
AnyPolynomial: TypeAlias = Polynomial | SparsePolynomial
