"""Pickle and copy values of flint; flint itself pickles only integers and rational numbers.

Objects keep such values in caches, and must be picklable in every state. Importing this module registers the
functions; pickle, copy and multiprocessing then find them.
"""

from __future__ import annotations

import copyreg
from functools import lru_cache
from typing import Any

import flint

Pickled = tuple[Any, tuple[Any, ...]]
"""A function, and the arguments from which it makes the value again."""


def _whole_matrix(m: flint.fmpz_mat) -> Pickled:
    return flint.fmpz_mat, (m.nrows(), m.ncols(), list(map(int, m.entries())))


def _fraction_matrix(m: flint.fmpq_mat) -> Pickled:
    whole, den = m.numer_denom()
    return _over, (whole, int(den))


def _over(whole: Any, den: int) -> Any:
    """Return an integer matrix or polynomial over a denominator."""
    if isinstance(whole, flint.fmpz_mat):
        return flint.fmpq_mat(whole) / den
    return flint.fmpq_poly(whole, den)


def _whole_polynomial(f: flint.fmpz_poly) -> Pickled:
    return flint.fmpz_poly, (list(map(int, f.coeffs())),)


def _fraction_polynomial(f: flint.fmpq_poly) -> Pickled:
    return _over, (f.numer(), int(f.denom()))


def _residue(x: flint.nmod) -> Pickled:
    return flint.nmod, (int(x), int(x.modulus()))


def _residue_polynomial(f: flint.nmod_poly) -> Pickled:
    return flint.nmod_poly, (list(map(int, f.coeffs())), int(f.modulus()))


def _residue_matrix(m: flint.nmod_mat) -> Pickled:
    return flint.nmod_mat, (m.nrows(), m.ncols(), list(map(int, m.entries())), int(m.modulus()))


def _large_residue(x: flint.fmpz_mod) -> Pickled:
    return _of_large_residue, (int(0 * x - 1) + 1, int(x))


def _of_large_residue(n: int, x: int) -> flint.fmpz_mod:
    return flint.fmpz_mod_ctx(n)(x)


def _large_residue_polynomial(f: flint.fmpz_mod_poly) -> Pickled:
    return _of_large_residues, (int(f.modulus()), *map(int, f.coeffs()))


def _of_large_residues(n: int, *coefficients: int) -> flint.fmpz_mod_poly:
    return flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(n))(list(coefficients))


def _finite_field(field: flint.fq_default_ctx) -> Pickled:
    modulus = field.modulus()
    return _with_modulus, (int(field.prime()), str(field.gen()), *map(int, modulus.coeffs()))


@lru_cache(maxsize=64)
def _with_modulus(p: int, variable: str, *coefficients: int) -> flint.fq_default_ctx:
    return flint.fq_default_ctx(modulus=_of_large_residues(p, *coefficients), var=variable)


def _finite_field_element(x: flint.fq_default) -> Pickled:
    """Compute the field from the powers of its generator, because flint does not give it."""
    polynomials = x.polynomial().context()
    generator = 0 * x + polynomials([0, 1])
    coefficients = x.to_list()
    below = (generator ** len(coefficients)).to_list()
    modulus = polynomials([-c for c in below] + [1])
    made = int(modulus.modulus()), str(generator), *map(int, modulus.coeffs())
    return _of_finite_field, (made, *map(int, coefficients))


def _of_finite_field(field: tuple[Any, ...], *coefficients: int) -> flint.fq_default:
    return _with_modulus(*field)(list(coefficients))


def _finite_field_polynomial(f: flint.fq_default_poly) -> Pickled:
    return _over_finite_field, (f.context().base_field(), f.coeffs())


def _over_finite_field(
    field: flint.fq_default_ctx, coefficients: list[flint.fq_default]
) -> flint.fq_default_poly:
    return flint.fq_default_poly_ctx(field)(coefficients)


def _in_variables(f: Any) -> Pickled:
    ring = f.context()
    modulus = (int(ring.modulus()),) if hasattr(ring, "modulus") else ()
    ring_arguments = ring.names(), *modulus, ring.ordering().name
    return _of_terms, (type(ring), ring_arguments, f.to_dict())


def _of_terms(ring: Any, arguments: tuple[Any, ...], terms: dict[tuple[int, ...], Any]) -> Any:
    return ring.get(*arguments).from_dict(terms)


def _ball(x: flint.arb) -> Pickled:
    if not x.is_finite():
        return flint.arb, (str(x),)
    return flint.arb, tuple(tuple(map(int, part.man_exp())) for part in (x.mid(), x.rad()))


def _complex_ball(z: flint.acb) -> Pickled:
    return flint.acb, (z.real, z.imag)


for kind, pickled in {
    flint.fmpz_mat: _whole_matrix,
    flint.fmpq_mat: _fraction_matrix,
    flint.fmpz_poly: _whole_polynomial,
    flint.fmpq_poly: _fraction_polynomial,
    flint.nmod: _residue,
    flint.nmod_poly: _residue_polynomial,
    flint.nmod_mat: _residue_matrix,
    flint.fmpz_mod: _large_residue,
    flint.fmpz_mod_poly: _large_residue_polynomial,
    flint.fq_default_ctx: _finite_field,
    flint.fq_default: _finite_field_element,
    flint.fq_default_poly: _finite_field_polynomial,
    flint.fmpz_mpoly: _in_variables,
    flint.fmpq_mpoly: _in_variables,
    flint.nmod_mpoly: _in_variables,
    flint.fmpz_mod_mpoly: _in_variables,
    flint.arb: _ball,
    flint.acb: _complex_ball,
}.items():
    copyreg.pickle(kind, pickled)
