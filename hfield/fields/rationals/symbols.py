"""Hilbert symbols over ℚ, ramified places and the discriminant.

The symbol ``(a, b)_v`` is 1 if ``z² = a·x² + b·y²`` has a nonzero solution in the completion at v, and −1
otherwise. The formulas are those of Serre, *A Course in Arithmetic*, chapter III, theorem 1. A rational
quaternion algebra is determined by the even set of places at which the symbol is −1 (Voight, *Quaternion
Algebras*, main theorem 14.1.3).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from flint import fmpz

from hfield.core.factorisation import Factors, factorise, known_primes, remove
from hfield.core.primality import WORD, is_prime
from hfield.errors import RingError
from hfield.fields.rationals.places import INFINITE, Place, place_of_q
from hfield.fields.rationals.whole_numbers import crt, square_class

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Rational


_LEAST = -WORD


def hilbert_symbol_q(a: Rational, b: Rational, place: object) -> int:
    """Return the Hilbert symbol of two nonzero rationals at a place of ℚ: 1 or −1.

    Raises :class:`RingError` for a 0 or an invalid place, :class:`CoercionError` for arguments that are not
    rational. Nothing is factored.
    """
    v = place_of_q(place)
    m, n = square_class(a), square_class(b)
    if v == INFINITE:
        return -1 if m < 0 and n < 0 else 1
    assert isinstance(v, int)
    return symbol_of_parts(v, *remove(m, v), *remove(n, v))


def symbol_of_parts(p: int, alpha: int, u: int, beta: int, v: int) -> int:
    """Return the symbol of ``pᵅ·u`` and ``pᵝ·v`` at p, for u and v prime to p."""
    if p == 2:
        sign = (u & v) >> 1 & 1
        if alpha & 1:
            sign ^= v % 8 in (3, 5)
        if beta & 1:
            sign ^= u % 8 in (3, 5)
        return -1 if sign else 1
    if alpha & 1:
        u = -u * v if beta & 1 else v
    elif not beta & 1:
        return 1
    return int(fmpz(u).jacobi(p))


def ramified_places_q(
    a: Rational, b: Rational, factors: Factors | None = None
) -> tuple[Place, ...]:
    """Return the places of ℚ at which ``(a, b | ℚ)`` is a division algebra: primes in ascending order, then
    infinity.

    ``factors`` may contain primes of numerators and denominators, which then need not be found. Raises
    :class:`UnfactoredError`.
    """
    m = a if type(a) is int and a else square_class(a)
    n = b if type(b) is int and b else square_class(b)
    m_, n_ = fmpz(m), fmpz(n)
    if factors is None and _LEAST < m < WORD and _LEAST < n < WORD:
        in_m, in_n = m_.factor(), n_.factor()
    else:
        with known_primes(factors, ""):
            in_m, in_n = _prime_powers(m), _prime_powers(n)
    # the odd primes p; the number of ramified places is even (reciprocity), which decides about 2
    if not m & 1:
        del in_m[0]
    if not n & 1:
        del in_n[0]
    primes = []
    symbol = n_.jacobi
    for p, alpha in in_m:
        sign = symbol(p)
        if sign < 0:
            if alpha & 1:
                primes.append(int(p))
        elif not sign:  # p divides both
            p = int(p)
            if symbol_of_parts(p, *remove(m, p), *remove(n, p)) < 0:
                primes.append(p)
    symbol = m_.jacobi
    for p, beta in in_n:
        if beta & 1 and symbol(p) < 0:
            primes.append(int(p))
    infinite = m < 0 and n < 0
    if len(primes) & 1 != infinite:
        primes.append(2)
    primes.sort()
    return (*primes, INFINITE) if infinite else tuple(primes)


def _prime_powers(n: int) -> list[tuple[fmpz, int]]:
    """Return the primes of n, as flint integers, with their exponents, in ascending order."""
    return [(fmpz(p), e) for p, e in sorted(factorise(n).items())]


def is_isotropic(form: Sequence[Rational]) -> bool:
    """Return whether a diagonal form over ℚ with at most four variables and nonzero coefficients has a
    nontrivial zero.

    Up to scale, three of its terms form the norm form on the elements of trace 0 of an algebra. A fourth term
    matters only if the product of all coefficients is not a square (Hasse and Minkowski; Serre, chapter IV,
    theorems 6 and 8).
    """
    if len(form) < 2:
        return False
    product = square_class(math.prod(form[1:], start=form[0]))
    if len(form) == 2:
        return product < 0 and math.isqrt(-product) ** 2 == -product
    a, b, c, *_ = form
    places = ramified_places_q(-a * b, -a * c)
    return not any(len(form) == 3 or _is_square(product, v) for v in places)


def _is_square(n: int, v: Place) -> bool:
    """Return whether an integer is a square in the completion at a place of ℚ."""
    if v == INFINITE:
        return n > 0
    p = int(v)
    alpha, unit = remove(n, p)
    return alpha % 2 == 0 and (unit % 8 == 1 if p == 2 else fmpz(unit).jacobi(p) == 1)


def discriminant_q(places: Iterable[Place]) -> int:
    """Return the product of the ramified primes, the reduced discriminant over ℚ."""
    return math.prod(p for p in places if isinstance(p, int))


def from_ramification_q(primes: Iterable[object], infinite: bool | None) -> tuple[int, int]:
    """Return integers (a, b) such that ``(a, b | ℚ)`` ramifies exactly at the given places.

    ∞ is one of the places if ``infinite`` says so or it is listed; if neither is given, parity decides.
    Raises :class:`RingError` unless the primes are distinct primes and the places even in number. The
    construction is that of Voight, *Quaternion Algebras*, section 14.2: up to sign, b is the product of the
    primes, and a is 1 or a prime in a suitable residue class.
    """
    places = [place_of_q(p) for p in primes]
    wanted = [p for p in places if p != INFINITE]
    if len(places) > len(wanted):
        if infinite is False or len(places) > len(wanted) + 1:
            raise RingError(
                "the infinite place is among the places and also denied, or named twice"
            )
        infinite = True
    elif infinite is None:
        infinite = len(wanted) % 2 == 1
    if len(set(wanted)) != len(wanted):
        raise RingError("the same prime was named twice among the ramified places")
    if (len(wanted) + bool(infinite)) % 2:
        raise RingError(
            f"an algebra over QQ ramifies at an even number of places, and {len(wanted) + infinite} were "
            "named: add or drop one (infinite=True counts as one)"
        )
    ps = sorted(int(p) for p in wanted)
    target = (*ps, *((INFINITE,) if infinite else ()))
    sign = -1 if infinite else 1
    b = sign * math.prod(ps)
    for size in (1, 2, 3, 5, 7, 11, 13):
        for a in (-size, size):
            if (a < 0) == infinite and ramified_places_q(a, b, [*ps, 2]) == target:
                return a, b
    # a is a non-residue at each odd prime, and modulo 8 unramified or not at 2 as wanted
    conditions = [(5 if 2 in ps else 1, 8)]
    conditions += [(non_residue(p), p) for p in ps if p != 2]
    start, step = crt(conditions)
    q = start if sign > 0 else step - start
    while not is_prime(q) or q in ps:
        q += step
    return sign * q, b


def non_residue(p: int) -> int:
    """Return the least quadratic non-residue modulo an odd prime."""
    return next(r for r in range(2, p) if fmpz(r).jacobi(p) == -1)
