"""FLINT's polynomials over GF(p), p of any size, and idempotents modulo a polynomial."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

import flint

from hfield.core.primality import WORD

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Coefficient, Polynomial


def polynomials_modulo(p: int) -> Callable[[list[Coefficient]], Polynomial]:
    """Return a function that makes flint polynomials over GF(p) from coefficients, low degree first."""
    if p < WORD:
        return lambda coefficients: flint.nmod_poly(coefficients, p)
    return flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(p))  # type: ignore[no-any-return,unused-ignore]


def residues(p: int, coefficients: Iterable[Coefficient | int]) -> Polynomial:
    """Return the polynomial over GF(p) with integer coefficients, low degree first."""
    return polynomials_modulo(p)([int(c) % p for c in coefficients])


def coefficients(f: Polynomial) -> list[int]:
    """Return the coefficients as numbers from 0 to p − 1, low degree first."""
    return [int(c) for c in f.coeffs()]


def sorted_factors(f: flint.nmod_poly) -> list[tuple[flint.nmod_poly, int]]:
    """Return the monic irreducible factors with multiplicities, by degree, then by coefficients."""
    factors = [(g, int(e)) for g, e in f.factor()[1]]
    return sorted(factors, key=lambda pair: (pair[0].degree(), coefficients(pair[0])[::-1]))


def idempotent(f: flint.nmod_poly, part: flint.nmod_poly) -> flint.nmod_poly:
    """Return the polynomial that is 1 modulo a factor of f coprime to its cofactor, and 0 modulo the
    cofactor.
    """
    rest = f // part
    return rest * rest.xgcd(part)[1] % f if rest.degree() > 0 else rest - rest + 1
