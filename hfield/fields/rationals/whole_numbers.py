"""Arithmetic of integers: Chinese remainders, roots modulo n, square classes and squarefree parts."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import factorise
from hfield.errors import CoercionError, RingError, shorten
from hfield.fields.base.coercion import rational

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Rational


def fraction(x: Rational) -> Fraction:
    """Convert an int, a Fraction, or a flint integer or rational to a Fraction."""
    number = rational(x)
    if number is not None:
        return Fraction(number)
    raise CoercionError(
        f"{shorten(repr(x))} ({type(x).__name__}) is not a rational number: "
        "expected an int, a Fraction, or an element of QQ"
    )


def square_class(x: Rational) -> int:
    """Return a nonzero integer equal to the rational x up to a square: numerator · denominator."""
    if type(x) is int:
        n = x
    elif isinstance(x, flint.fmpq):
        n = int(x.p * x.q)
    else:
        f = fraction(x)
        n = f.numerator * f.denominator
    if not n:
        raise RingError(
            "a Hilbert symbol is defined for nonzero numbers only, and one of these is 0"
        )
    return n


def square_root(x: Fraction) -> Fraction | None:
    """Return the nonnegative square root of a rational number, or None if it is not in ℚ."""
    if x < 0:
        return None
    p, q = math.isqrt(x.numerator), math.isqrt(x.denominator)
    return Fraction(p, q) if (p * p, q * q) == (x.numerator, x.denominator) else None


def squarefree(n: int) -> tuple[int, int, list[int]]:
    """Return ``(m, s, primes)`` with ``n = m·s²``, m squarefree, and the primes of m.

    Raises :class:`UnfactoredError`.
    """
    m, s, primes = (1 if n > 0 else -1), 1, []
    for p, e in factorise(n).items():
        s *= p ** (e // 2)
        if e % 2:
            m *= p
            primes.append(p)
    return m, s, sorted(primes)


def sqrt_mod(x: int, p: int) -> int:
    """Return a square root of x modulo the prime p; x must have one."""
    return x % 2 if p == 2 else int(flint.fmpz(x % p).sqrtmod(p))


def crt(residues: Iterable[tuple[int, int]]) -> tuple[int, int]:
    """Return ``(x, m)``, where x has the given residues, for ``(residue, modulus)`` pairs with coprime
    moduli, and m is their product.
    """
    x, m = 0, 1
    for r, n in residues:
        x += m * ((r - x) * pow(m, -1, n) % n)
        m *= n
    return x % m, m
