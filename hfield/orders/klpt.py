"""Find equivalent ideals of small prime norm, of norm dividing a smooth number, or of prime power norm.

The last two use the algorithm of Kohel, Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny path problem"
(2014). Let I be a left ideal of prime norm N of a p-extremal order. Three elements are found: γ of norm N·T₁
(RepresentInteger), μ₀ = (C + D·s)·β with γ·μ₀ in I (IdealModConstraint), and μ = λ·μ₀ + N·μ₁ of norm T₂
(StrongApproximation). Then γ·μ lies in I and has the norm N·T₁·T₂. The last coordinates of μ₁ are chosen by a
closest vector in a lattice; then T₂ is about p·N³ and T₁·T₂ about p³.

Another maximal order O is connected to an extremal order E by an ideal K. If x is in K and y in K·I, then
conj(x)·y/N(K) is in I.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from itertools import chain, islice

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import factor, remove
from hfield.core.primality import is_prime, is_probable_prime
from hfield.errors import LatticeError, NoEquivalentIdealError, UndecidedError, shorten
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders import hermite
from hfield.orders.allowed_norms import AllowedNorms, Divisors, Powers
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    includes,
    multiple,
    product,
)
from hfield.orders.norm_search import SMALL_VOLUME, norm_dividing, of_norm
from hfield.orders.quadratic_frames import QuadraticFrame, extremal_frame
from hfield.orders.related_orders import connecting
from hfield.orders.represent_integer import in_frame
from hfield.orders.short_elements import expect_definite, least_norm, up_to
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

    Raises :class:`IndefiniteError`, and :class:`UndecidedError` if no such norm was found.
    """
    expect_definite(ideal.ambient, "equivalent_of_prime_norm()")
    for row, m in by_norm(ideal):
        if m not in avoid and is_prime(m):
            return ideal.element(row)
    raise UndecidedError(
        f"no equivalent ideal of prime norm was found among the short elements, in {DOUBLINGS} doublings"
    )


def by_norm(ideal: LatticeValue) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield elements as rows, and their norms as multiples of the norm of the ideal, in ascending order."""
    low, high = 0, 2 * least_norm(ideal)
    for _ in range(DOUBLINGS):
        found = sorted((m, row) for row, m in up_to(ideal, high) if m > low)
        for m, row in found:
            yield row, m
        low, high = high, 2 * high


def random_elements(
    ideal: LatticeValue, rng: random.Random
) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield random elements and their norms, as :func:`by_norm` does, that do not lie in a small subspace.

    All short elements may lie in a plane on which the norms have a common divisor; an example is the ideal
    ``O·R·n`` for a quadratic order R in which n is inert.
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
    rng, powers = random.Random(seed), Powers(prime)
    x = _klpt(ideal, order, powers, rng)
    if x is None and p < SMALL_VOLUME:
        x = _of_large_norm(ideal, powers, p, rng)
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
    """Return such an x for a left ideal of an order with a p-extremal frame."""
    for x, start, norm in islice(_prime_starts(ideal, f, norms, rng), ATTEMPTS):
        beta = _from_prime(start, f, norm, norms, rng)
        if beta is not None:
            return beta * x / norm
    return None


def _prime_starts(
    ideal: LatticeValue, f: QuadraticFrame, norms: AllowedNorms, rng: random.Random
) -> Iterator[tuple[Quaternion, LatticeValue, int]]:
    """Yield x in I, the equivalent ideal I·conj(x)/N(I), and its norm, an odd prime that divides no allowed
    norm.
    """
    for row, norm in chain(by_norm(ideal), random_elements(ideal, rng)):
        if norm in (f.norm, 2) or norms.divisible_by(norm) or not is_probable_prime(norm):
            continue
        x = ideal.element(row)
        start = multiple(ideal, x.conjugate() / ideal.norm, "right")
        # no γ leads to an ideal of the quadratic order, extended
        if not includes(start, multiple(start, f.alpha, "right")):
            yield x, start, norm


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
    """Return about the least T₁ for which the order is likely to represent N·T₁."""
    return max(2, (f.norm << 8) * f.norm.bit_length() // norm)


# --- norms that divide a number ------------------------------------------------------------------------


def to_norm_dividing(
    ideal: LatticeValue, order: LatticeValue, number: int, seed: int
) -> Quaternion:
    """Return x in a left ideal of a maximal order for which N(x)/N(I) divides a smooth number T.

    Norms of moderate size are tried first, and the least one is returned; then KLPT is used. Raises
    :class:`LatticeError` for another order, :class:`NoEquivalentIdealError` if all divisors were tried, and
    :class:`UndecidedError`.
    """
    p = expect_maximal(order, "equivalent_of_norm_dividing()")
    rng, allowed = random.Random(seed), number
    variants = [ideal]
    # the elements whose norm a ramified prime divides are those of P·I, for the two-sided prime P
    for prime in (int(fraction(P)) for P in order.ambient.ramified):
        if number % prime == 0:
            allowed = remove(allowed, prime)[1]
            above = two_sided_prime(order, prime)
            variants += [product(above, lattice) for lattice in variants]
    found, larger, proved = list[Quaternion](), list[tuple[LatticeValue, AllowedNorms, int]](), True
    for lattice in variants:
        x, decided, tried = norm_dividing(lattice, allowed, rng)
        proved = proved and decided
        if x is not None:
            found.append(x)
        elif not decided:
            larger.append((lattice, Divisors(tuple(factor(allowed).primes.items())), tried))
    if found:
        return min(found, key=lambda x: _relative_norm(ideal, x))
    for lattice, divisors, tried in larger:
        x = _klpt(lattice, order, divisors, rng)
        if x is None and p < SMALL_VOLUME:
            x = _of_large_norm(lattice, divisors, max(tried + 1, p), rng)
        if x is not None:
            return x
    shown = shorten(number)
    if proved:
        raise NoEquivalentIdealError(
            f"no equivalent ideal has a norm that divides {shown}: all its divisors were tried. "
            + _needed(ideal, order, number)
        )
    raise UndecidedError(
        f"no equivalent ideal whose norm divides {shown} was found. "
        + _needed(ideal, order, number)
    )


def _of_large_norm(
    ideal: LatticeValue, norms: AllowedNorms, least: int, rng: random.Random
) -> Quaternion | None:
    """Return x such that N(x)/N(I) is allowed and has at least some size, for small discriminants."""
    above = list(norms.above(least, rng))
    for n in dict.fromkeys([*above[-2:], *above[:4]]):
        x, _ = of_norm(ideal, n, rng)
        if x is not None:
            return x
    return None


def _needed(ideal: LatticeValue, order: LatticeValue, number: int) -> str:
    """Return a sentence on the size of T from which KLPT is likely to succeed."""
    p = order.ambient.base.absolute_norm(discriminant(order))
    if len(order.ambient.ramified) > 1 and extremal_frame(order, MAX_FRAME_DISCRIMINANT) is None:
        return f"KLPT, for larger numbers, is for algebras of prime discriminant, and this is {shorten(p)}"
    bits = _needed_bits(ideal, order, Divisors(tuple(factor(number).primes.items())))
    return (
        f"This number has {number.bit_length()} bits, and a smooth number prime to {shorten(p)} of about "
        f"{bits} bits is needed, T > 2^{bits}"
    )


def _needed_bits(ideal: LatticeValue, order: LatticeValue, norms: AllowedNorms) -> int:
    """Return approximately the number of bits of an allowed norm that KLPT needs."""
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT)
    if f is None:
        start = extremal_order(order.ambient.algebra)
        connection = connecting(start, order)
        parts = connection, product(connection, ideal)
        return sum(_needed_bits(part, start, norms) for part in parts)
    p = f.norm
    # all short elements may lie in a plane that contains no element of prime norm
    norm = next((n for _, _, n in _prime_starts(ideal, f, norms, random.Random(0))), p)
    slack = 18 + p.bit_length().bit_length() + (-f.discriminant).bit_length()
    return 2 * p.bit_length() + 2 * norm.bit_length() + slack
