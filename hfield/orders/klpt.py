"""Equivalent ideals of small prime norm, or whose norm is a power of a small prime.

The latter by the algorithm of Kohel, Lauter, Petit and Tignol, "On the quaternion ℓ-isogeny path problem"
(2014). Let I be a left ideal of a p-extremal order, of prime norm N. An element γ of norm N·ℓᵃ and a
μ₀ = (C + D·s)·β with γ·μ₀ in I are found, and μ = λ·μ₀ + N·μ₁ of norm ℓᵇ: then γ·μ is in I and has the norm
N·ℓᵃ⁺ᵇ. With the last coordinates of μ₁ the closest in a lattice, ℓᵇ is about p·N³ and the norm about p³.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from itertools import chain, count

from flint import fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.primality import is_prime, is_probable_prime
from hfield.errors import LatticeError, UndecidedError
from hfield.fields.rationals.whole_numbers import sqrt_mod
from hfield.orders import hermite
from hfield.orders.invariants import level
from hfield.orders.lattice_values import (
    LatticeValue,
    discriminant,
    includes,
    multiple,
    spanning_rows,
)
from hfield.orders.linear_algebra_mod_p import kernel
from hfield.orders.quadratic_frames import (
    QuadraticFrame,
    extremal_frame,
    in_frame,
    represent,
)
from hfield.orders.short_elements import expect_definite, least_norm, up_to

DOUBLINGS = 12
MAX_TRIALS = 20_000


def to_prime_norm(ideal: LatticeValue, avoid: frozenset[int]) -> Quaternion:
    """Return c by which an ideal becomes one of the least prime norm not in ``avoid``.

    Raises :class:`IndefiniteError`, and :class:`UndecidedError` when no such norm was found.
    """
    expect_definite(ideal.ambient, "equivalent_of_prime_norm()")
    for row, m in by_norm(ideal):
        if m not in avoid and is_prime(m):
            found: Quaternion = ideal.element(row).conjugate() / ideal.norm
            return found
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


MAX_FRAME_DISCRIMINANT = 1000
"""The largest discriminant of the quadratic order for which the norms are likely to be represented."""
ATTEMPTS = 60


def to_power_norm(
    ideal: LatticeValue, order: LatticeValue, side: str, prime: int, seed: int
) -> tuple[Quaternion, int]:
    """Return (c, e) with I·c of norm primeᵉ, for a left ideal of a p-extremal order.

    Raises :class:`LatticeError` for an order that is not p-extremal, :class:`UndecidedError`.
    """
    expect_definite(ideal.ambient, "equivalent_of_power_norm()")
    p = int(discriminant(order))
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT) if level(order) == 1 else None
    if prime == p:
        raise LatticeError(f"the norm is to be a power of a prime other than the discriminant {p}")
    if side == "right" or f is None:
        raise LatticeError(
            "KLPT starts from a left ideal of a p-extremal maximal order, such as A.extremal_order(): "
            "connect another order to that with connecting_ideal"
        )
    rng = random.Random(seed)
    tried = 0
    for row, norm in chain(by_norm(ideal), random_elements(ideal, rng)):
        if norm in (prime, p, 2) or not is_probable_prime(norm):
            continue
        x = ideal.element(row)
        first = x.conjugate() / ideal.norm
        start = multiple(ideal, first, "right")
        # no γ leads to an ideal of the quadratic order, extended
        if includes(start, multiple(start, f.alpha, "right")):
            continue
        tried += 1
        if tried > ATTEMPTS:
            break
        found = _from_prime(start, f, norm, prime, rng)
        if found is not None:
            beta, e = found
            return first * (beta.conjugate() / norm), e
    raise UndecidedError(
        f"no equivalent ideal of norm a power of {prime} was found in {tried} attempts"
    )


def _from_prime(
    ideal: LatticeValue, f: QuadraticFrame, norm: int, prime: int, rng: random.Random
) -> tuple[Quaternion, int] | None:
    """Return an element of norm N·primeᵉ in a left ideal of prime norm N, and e."""
    p = f.norm
    s = 2 * f.alpha - f.t
    a = max(
        1,
        math.ceil(
            (math.log2(p) - math.log2(norm) + 8 + math.log2(math.log2(p))) / math.log2(prime)
        ),
    )
    for _ in range(6):
        gamma = in_frame(f, norm * prime**a, rng, 3000)
        if gamma is None:
            a += 1
            continue
        ratio = _ratio(ideal, gamma * f.beta, gamma * s * f.beta, norm)
        found = ratio and _strong_approximation(f, norm, prime, ratio, rng)
        if found:
            mu, b = found
            return gamma * mu, a + b
    return None


def _ratio(ideal: LatticeValue, u: Quaternion, v: Quaternion, norm: int) -> tuple[int, int] | None:
    """Return (C, D) ≠ 0 modulo N with C·u + D·v in the ideal, which contains N·O."""
    den, both = spanning_rows(ideal.ambient, [u, v])
    inside, d = hermite.in_coordinates(ideal.matrix, both)
    # coordinates over the ideal have the denominator N
    rows = [[int(x) * ideal.den * norm // (d * den) for x in row] for row in inside.tolist()]
    found = kernel(list(zip(*rows, strict=True)), norm)
    return (found[0][0], found[0][1]) if len(found) == 1 else None


def _strong_approximation(
    f: QuadraticFrame, norm: int, prime: int, ratio: tuple[int, int], rng: random.Random
) -> tuple[Quaternion, int] | None:
    """Return μ ≡ λ·(C + D·s)·β modulo N of norm primeᵇ, and b."""
    n, p, d = norm, f.norm, -f.discriminant
    c0, d0 = ratio
    size = c0 * c0 + d * d0 * d0
    if size % n == 0:
        return None
    b = math.ceil((math.log2(p) + 3 * math.log2(n) + math.log2(d) + 6) / math.log2(prime))
    inverse = pow(p * size, -1, n)
    for _ in range(12):
        target = prime**b
        square = target * inverse % n
        if fmpz(square).jacobi(n) == 1:
            root = sqrt_mod(square, n)
            for x in (root, n - root):
                found = _lift(f, n, target, x * c0 % n, x * d0 % n)
                if found is not None:
                    return found, b
        elif fmpz(prime).jacobi(n) == 1 and b % 2:
            return None  # no power is a square times it: another γ
        b += 1
    return None


def _lift(f: QuadraticFrame, n: int, target: int, c0: int, d0: int) -> Quaternion | None:
    """Return ``N·(x + y·s) + (c₀ + N·c + (d₀ + N·e)·s)·β`` of norm ``target``.

    Modulo N² that is one linear condition on (c, e); they are taken close to −(c₀, d₀)/N.
    """
    p, d = f.norm, -f.discriminant
    rest = (target - p * (c0 * c0 + d * d0 * d0)) // n
    # 2p·(c₀·c + d·d₀·e) ≡ rest modulo N
    first, second = 2 * p * c0 % n, 2 * p * d * d0 % n
    if not first:
        return None
    inverse = pow(first, -1, n)
    slope, offset = -second * inverse % n, rest * inverse % n
    tried = 0
    s = 2 * f.alpha - f.t
    for c, e in _close(slope, offset, n, c0, d0, d):
        tried += 1
        if tried > 4000:
            return None
        z, w = c0 + n * c, d0 + n * e
        m = target - p * (z * z + d * w * w)
        if m <= 0:
            if tried > 40:
                return None
            continue
        m //= n * n
        found = represent(-4 * d, m)  # x² + d·y²
        if found is not None:
            x, y = found
            return n * (x + y * s) + (z + w * s) * f.beta
    return None


def _close(slope: int, offset: int, n: int, c0: int, d0: int, d: int) -> Iterator[tuple[int, int]]:
    """Yield (c, e) with c ≡ slope·e + offset modulo N, from those that make (c₀ + N·c, d₀ + N·e) small."""
    basis = fmpz_mat([[n, 0], [slope, 1]])
    weight = fmpz_mat([[1, 0], [0, d]])
    _, steps = (basis * weight * basis.transpose()).lll(transform=True, rep="gram")
    (a, b), (u, v) = ([int(x) for x in row] for row in (steps * basis).tolist())
    # the point to come close to, −(c₀, d₀)/N less a solution (offset, 0), in coordinates of the basis
    det = a * v - b * u
    px, py = -c0 - n * offset, -d0
    r = _nearest(px * v - py * u, det * n)
    t = _nearest(a * py - b * px, det * n)
    for radius in count(0):
        for i in range(-radius, radius + 1):
            sides = (-radius, radius) if abs(i) < radius else range(-radius, radius + 1)
            for j in sides:
                if radius or not j:
                    yield offset + (r + i) * a + (t + j) * u, (r + i) * b + (t + j) * v


def _nearest(x: int, y: int) -> int:
    return (2 * x + y) // (2 * y)
