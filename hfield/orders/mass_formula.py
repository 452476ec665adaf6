"""The mass formula, and Eichler's class number formula: class numbers without enumeration.

The mass is ``Σ 1/[O_L(I)^× : ±1]`` over the ideal classes (Voight, *Quaternion Algebras*, theorem 26.1.5).
Eichler's class number formula adds the contribution of orders with units other than ±1 (30.1.5).
"""

from __future__ import annotations

from fractions import Fraction

from hfield.core.factorisation import factorise
from hfield.errors import LatticeError
from hfield.orders import invariants
from hfield.orders.invariants import eichler_symbol
from hfield.orders.lattice_values import LatticeValue, discriminant
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.orders.short_elements import expect_definite
from hfield.orders.validation import expect_coprime


def eichler_mass(discriminant: int, level: int) -> Fraction:
    """Return the mass of an Eichler order: φ(D)·ψ(N)/12."""
    mass = Fraction(1, 12)
    for p in factorise(discriminant):
        mass *= p - 1
    for p, e in factorise(level).items():
        mass *= p ** (e - 1) * (p + 1)
    return mass


def mass(order: LatticeValue) -> Fraction:
    """Return Σ 1/[O_L(I)ˣ : Rˣ] over the invertible right ideal classes; R is the ring of integers of the
    base.

    It is 2^(1−n)·|ζ_K(−1)|·h_K·N(discrd)·Π λ(O, P), with λ from Eichler symbols (Voight, 26.1.5). Raises
    :class:`IndefiniteError`, :class:`TooLargeError`.
    """
    base, whole = order.ambient.base, discriminant(order)
    expect_definite(order.ambient, "the mass of ideal classes")
    found = base.mass_factor * base.absolute_norm(whole)
    for P, _ in base.factorisation(whole):
        norm = base.absolute_norm(base.prime_ideal(P))
        found *= local_factor(eichler_symbol(order, P), norm)
    return found


def local_factor(symbol: int | None, p: int) -> Fraction:
    """Return the local factor λ of the mass formula, from the Eichler symbol and the number p of residues."""
    return {1: 1 + Fraction(1, p), -1: 1 - Fraction(1, p), 0: 1 - Fraction(1, p * p)}[symbol or 0]


def class_number(discriminant: int, level: int) -> int:
    """Return the number of right ideal classes of an Eichler order of a definite algebra.

    Raises :class:`LatticeError` unless the discriminant is a product of an odd number of primes and the level
    is prime to it.
    """
    primes = factorise(discriminant)
    powers = factorise(level)
    if any(e > 1 for e in primes.values()) or len(primes) % 2 == 0:
        raise LatticeError(
            f"{discriminant} is not the discriminant of a definite algebra over QQ: expected a product of "
            "an odd number of different primes"
        )
    expect_coprime(level, discriminant)
    total = eichler_mass(discriminant, level)
    # elements of order 4 and of order 3 (or 6): the optimal embeddings of ℤ[i] and of ℤ[ω]
    for d, weight in ((-4, Fraction(1, 4)), (-3, Fraction(1, 3))):
        for p in primes:
            weight *= 1 - kronecker(d, p)
        for p, e in powers.items():
            weight *= _roots(d, p, e)
        total += weight
    if total.denominator != 1:
        raise AssertionError("Eichler's formula gives an integer")
    return total.numerator


def class_number_by_formula(order: LatticeValue) -> int | None:
    """Return the number of right ideal classes of a definite Eichler order, by Eichler's formula over ℤ.

    It returns None over other bases, where the formula needs class numbers of quadratic extensions.
    """
    return order.ambient.kernels.choose(_no_formula, rank4=_by_formula)(order)


def _no_formula(order: LatticeValue) -> int | None:
    return None


def _by_formula(order: LatticeValue) -> int | None:
    norm = order.ambient.base.absolute_norm
    return class_number(norm(order.ambient.discriminant), norm(invariants.level(order)))


def _roots(d: int, p: int, e: int) -> int:
    """Return the number of local optimal embeddings of the maximal order of discriminant d at level pᵉ."""
    if d % p:
        return 1 + kronecker(d, p)
    return 1 if e == 1 else 0
