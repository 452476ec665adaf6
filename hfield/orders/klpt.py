"""Equivalent ideals of small prime norm, or whose norm divides a smooth number or is a power of a prime.

The latter by the algorithm of Kohel, Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny path problem"
(2014). Let I be a left ideal of a p-extremal order, of prime norm N. Three elements are found: γ of norm N·T₁
(RepresentInteger), μ₀ = (C + D·s)·β with γ·μ₀ in I (IdealModConstraint), and μ = λ·μ₀ + N·μ₁ of norm T₂
(StrongApproximation). Then γ·μ lies in I and has the norm N·T₁·T₂. With the last coordinates of μ₁ the
closest in a lattice, T₂ is about p·N³ and T₁·T₂ about p³.

From another maximal order O the way leads through an extremal order E and the ideal K that connects E to O.
With x in K and y in K·I the element conj(x)·y/N(K) is in I.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from itertools import chain, islice

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import factor
from hfield.core.primality import is_prime, is_probable_prime
from hfield.errors import LatticeError, UndecidedError, shorten
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders import enumeration, hermite
from hfield.orders.allowed_norms import AllowedNorms, Divisors, Powers
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.lattice_values import (
    LatticeValue,
    contains,
    discriminant,
    includes,
    multiple,
    product,
)
from hfield.orders.quadratic_frames import QuadraticFrame, extremal_frame, frame, in_frame
from hfield.orders.related_orders import connecting
from hfield.orders.short_elements import expect_definite, first_of_norm, least_norm, up_to
from hfield.orders.standard_orders import extremal_order
from hfield.orders.strong_approximation import (
    MAX_FRAME_DISCRIMINANT,
    expect_maximal,
    least_second,
    ratio_in,
    strong_approximation,
)

DOUBLINGS = 12
MAX_TRIALS = 20_000


def to_prime_norm(ideal: LatticeValue, avoid: frozenset[int]) -> Quaternion:
    """Return x in an ideal for which N(x)/N(I) is the least prime not in ``avoid``.

    Raises :class:`IndefiniteError`, and :class:`UndecidedError` when no such norm was found.
    """
    expect_definite(ideal.ambient, "equivalent_of_prime_norm()")
    for row, m in by_norm(ideal):
        if m not in avoid and is_prime(m):
            return ideal.element(row)
    raise UndecidedError(
        f"no equivalent ideal of prime norm was found among the short elements, in {DOUBLINGS} doublings"
    )


def by_norm(ideal: LatticeValue) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield elements as rows, and their norms as multiples of the norm of the ideal, by ascending norm."""
    low, high = 0, 2 * least_norm(ideal)
    for _ in range(DOUBLINGS):
        found = sorted((m, row) for row, m in up_to(ideal, high) if m > low)
        for m, row in found:
            yield row, m
        low, high = high, 2 * high


def random_elements(
    ideal: LatticeValue, rng: random.Random
) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield random elements and their norms, as :func:`by_norm` does, of no small subspace.

    All that are short may lie in a plane, where the norms have a common divisor, such as that of ``O·R·n``, R
    a quadratic order and n inert in it.
    """
    rows, _ = ideal.reduced
    for trial in range(MAX_TRIALS):
        size = 1 + trial // 50
        row = hermite.combination([rng.randint(-size, size) for _ in range(4)], rows)
        if any(row):
            yield row, ideal.multiple(row)


ATTEMPTS = 60


# --- KLPT --------------------------------------------------------------------------------------------


def to_power_norm(
    ideal: LatticeValue, order: LatticeValue, prime: int, seed: int
) -> tuple[Quaternion, int]:
    """Return (x, e) with x in a left ideal of a maximal order and N(x) = N(I)·primeᵉ.

    Raises :class:`LatticeError` for another order, :class:`UndecidedError`.
    """
    p = expect_maximal(order, "equivalent_of_power_norm()")
    if prime == p:
        raise LatticeError(f"the norm is to be a power of a prime other than the discriminant {p}")
    x = _klpt(ideal, order, Powers(prime), random.Random(seed))
    if x is None:
        raise UndecidedError(
            f"no equivalent ideal of norm a power of {prime} was found in {ATTEMPTS} attempts"
        )
    return x, round(math.log(_relative_norm(ideal, x), prime))


def _relative_norm(ideal: LatticeValue, x: Quaternion) -> int:
    return int(x.norm() / ideal.norm)


def _klpt(
    ideal: LatticeValue, order: LatticeValue, norms: AllowedNorms, rng: random.Random
) -> Quaternion | None:
    """Return x in a left ideal of a maximal order with an allowed N(x)/N(I), or None."""
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT)
    if f is not None:
        return _from_extremal(ideal, f, norms, rng)
    if len(order.ambient.ramified) > 1:
        return None
    start = extremal_order(order.ambient.algebra)
    connection = connecting(start, order)
    x = _klpt(connection, start, norms, rng)
    if x is None:
        return None
    rest = norms.without(_relative_norm(connection, x))
    y = _klpt(product(connection, ideal), start, rest, rng)
    return None if y is None else x.conjugate() * y / connection.norm


def _from_extremal(
    ideal: LatticeValue, f: QuadraticFrame, norms: AllowedNorms, rng: random.Random
) -> Quaternion | None:
    """Return the same for a left ideal of an order with a p-extremal frame."""
    tried = 0
    for row, norm in chain(by_norm(ideal), random_elements(ideal, rng)):
        if norm in (f.norm, 2) or norms.divisible_by(norm) or not is_probable_prime(norm):
            continue
        x = ideal.element(row)
        start = multiple(ideal, x.conjugate() / ideal.norm, "right")
        # no γ leads to an ideal of the quadratic order, extended
        if includes(start, multiple(start, f.alpha, "right")):
            continue
        tried += 1
        if tried > ATTEMPTS:
            break
        beta = _from_prime(start, f, norm, norms, rng)
        if beta is not None:
            return beta * x / norm
    return None


def _from_prime(
    ideal: LatticeValue, f: QuadraticFrame, norm: int, norms: AllowedNorms, rng: random.Random
) -> Quaternion | None:
    """Return an element in a left ideal of prime norm N whose norm is N times an allowed one."""
    supply = norms.above(_least_first(f, norm), rng)
    first = next(supply, None)
    for _ in range(6):
        if first is None:
            return None
        targets = list(norms.without(first).above(least_second(f, norm), rng))
        gamma = in_frame(f, norm * first, rng, 3000) if targets else None
        if gamma is None:
            first = next(supply, None)
            continue
        ratio = ratio_in(ideal, gamma * f.beta, gamma * f.root * f.beta, norm)
        if ratio is None:
            continue
        mu = strong_approximation(f, norm, targets, ratio)
        if mu is not None:
            return gamma * mu
    return None


def _least_first(f: QuadraticFrame, norm: int) -> int:
    """Return about the least T₁ for which N·T₁ is likely to be represented by the order."""
    return max(2, (f.norm << 8) * f.norm.bit_length() // norm)


# --- norms that divide a number ------------------------------------------------------------------------

MAX_SHORT, MAX_SHORT_OF_LARGE = 10_000, 300
"""So many elements of an ideal are listed, the shortest ones, for small and for large discriminants."""
MAX_HEADS = 2_000_000
"""So many choices of three coordinates are tried for one norm, and ten times as many for all norms."""
MAX_DIVISORS = 200_000
SMALL_DISCRIMINANT = 2**24
"""Below this discriminant the norms of all sizes are searched."""


def to_norm_dividing(
    ideal: LatticeValue, order: LatticeValue, number: int, seed: int
) -> Quaternion:
    """Return x in a left ideal of a maximal order for which N(x)/N(I) divides a smooth number T.

    The shortest elements are tried first, then each divisor of moderate size by an enumeration, then KLPT.
    Raises :class:`LatticeError` for another order, and :class:`UndecidedError`.
    """
    p = expect_maximal(order, "equivalent_of_norm_dividing()")
    rng = random.Random(seed)
    variants = [(ideal, number)]
    if number % p == 0:
        # the elements of norms that p divides are those of P·I, for the two-sided prime P
        radical = two_sided_prime(order, p)
        variants = [(ideal, _without(number, p)), (product(radical, ideal), number // p)]
    complete = True
    for lattice, allowed in variants:
        x, bound = _among_short(
            lattice, allowed, MAX_SHORT if p < SMALL_DISCRIMINANT else MAX_SHORT_OF_LARGE
        )
        complete = complete and bound >= allowed
        if x is not None:
            return x
    for lattice, allowed in variants:
        divisors = Divisors(tuple(factor(_without(allowed, p)).primes.items()))
        x = _of_smooth_norm(lattice, order, divisors, rng)
        if x is not None:
            return x
    bits = _needed_bits(ideal, order)
    shown = shorten(number)
    known = (
        f"no equivalent ideal has a norm that divides {shown}: all short elements were listed"
        if complete
        else f"no equivalent ideal whose norm divides {shown} was found"
    )
    raise UndecidedError(
        f"{known}; this number has {number.bit_length()} bits, and a smooth number prime to {shorten(p)} of "
        f"about {bits} bits is needed, T > 2^{bits}"
    )


def _without(number: int, p: int) -> int:
    while number % p == 0:
        number //= p
    return number


def _among_short(ideal: LatticeValue, number: int, most: int) -> tuple[Quaternion | None, int]:
    """Return an element of least N(x)/N(I) that divides a number, among the shortest ones.

    With it the bound up to which all were tried, at most so many of them.
    """
    tried, bound = 0, least_norm(ideal)
    while True:
        bound = min(bound, number)
        short = list(islice(up_to(ideal, bound), most + 1))
        if len(short) > most:
            return None, tried
        tried = bound
        found = min(((m, row) for row, m in short if number % m == 0), default=None)
        if found is not None:
            return ideal.element(found[1]), tried
        if tried == number:
            return None, tried
        bound *= 2


def _of_smooth_norm(
    ideal: LatticeValue, order: LatticeValue, divisors: Divisors, rng: random.Random
) -> Quaternion | None:
    p = order.ambient.base.absolute_norm(discriminant(order))
    x, tried = _by_enumeration(ideal, divisors, p)
    if x is None and divisors.product > tried:
        x = _klpt(ideal, order, divisors, rng)
        if x is None and p < SMALL_DISCRIMINANT:
            x = _by_representing(ideal, order, divisors, tried, rng)
    return x


def _by_enumeration(
    ideal: LatticeValue, divisors: Divisors, p: int
) -> tuple[Quaternion | None, int]:
    """Return an element of norm n·N(I) for the least divisor n with one, among those of moderate size.

    With it the largest divisor up to which all were decided.
    """
    spent, tried, gram = 0.0, 0, ideal.reduced[1]
    # an element of norm n is expected from n = p/24 on
    least = p >> 8 if p > SMALL_DISCRIMINANT else 1
    if enumeration.volume(gram, 2 * least, 3) > MAX_HEADS:
        return None, tried
    for n in islice(divisors.ascending(), MAX_DIVISORS):
        if n < least:
            continue
        heads = enumeration.volume(gram, 2 * n, 3)
        if heads > MAX_HEADS or spent > 10 * MAX_HEADS:
            break
        spent += heads
        row = first_of_norm(ideal, ideal.ambient.base.inside(fraction(ideal.norm) * n))
        if row is not None:
            return ideal.element(hermite.tuples(row)[0]), n
        tried = n
    return None, tried


def _by_representing(
    ideal: LatticeValue,
    order: LatticeValue,
    divisors: Divisors,
    tried: int,
    rng: random.Random,
) -> Quaternion | None:
    """Return the same for divisors above those that were tried.

    Of the elements of norm n·N one in N + 1 lies in an ideal of prime norm N. The quadratic order may
    represent n·N for some N only.
    """
    f = frame(order)
    above = [n for n in divisors.above(max(tried + 1, f.norm), rng) if n > tried]
    primes = ((row, m) for row, m in by_norm(ideal) if m > 2 and m != f.norm and is_prime(m))
    for row, norm in islice(primes, 10):
        x = ideal.element(row)
        start = multiple(ideal, x.conjugate() / ideal.norm, "right")
        for n in dict.fromkeys([*above[-1:], *above[:2]]):
            for _ in range(8 * (norm + 1)):
                gamma = in_frame(f, norm * n, rng, 2000)
                if gamma is None:
                    break
                if contains(start, gamma):
                    return gamma * x / norm
    return None


def _needed_bits(ideal: LatticeValue, order: LatticeValue) -> int:
    """Return about how many bits T has for which KLPT is likely to succeed."""
    p = order.ambient.base.absolute_norm(discriminant(order))
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT)
    norm = max(math.isqrt(p), 3) if f is None else max(int(least_norm(ideal)), math.isqrt(p), 3)
    slack = 18 + p.bit_length().bit_length() + (4 if f is None else (-f.discriminant).bit_length())
    once = 2 * p.bit_length() + 2 * norm.bit_length() + slack
    return once if f is not None else 2 * once
