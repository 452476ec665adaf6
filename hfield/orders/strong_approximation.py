"""The steps of KLPT in a p-extremal order O with frame R + R·β, where N(β) = p, R = ℤ[α] and s = 2α − t.

Let I be an ideal of prime norm N. The elements μ₀ = (C + D·s)·β with γ·μ₀ in I, or with γ·μ₀·δ in the Eichler
order ℤ + I, are the solutions of linear equations modulo N (IdealModConstraint, EichlerModConstraint). An
element μ ≡ λ·μ₀ modulo N·O is ``N·(x + y·s) + (C′ + N·c + (D′ + N·e)·s)·β``. It has the given norm modulo N²
if and only if (c, e) satisfies one linear condition. Each solution, shortest first, determines the value of
x² + |d|·y² that remains to be represented (StrongApproximation).

See Kohel, Lauter, Petit and Tignol, 2014; De Feo, Kohel, Leroux, Petit and Wesolowski, "SQISign", 2020.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, count

from flint import fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import factor, remove
from hfield.core.primality import is_probable_prime
from hfield.errors import LatticeError, NoSolutionError, UndecidedError, shorten
from hfield.fields.rationals.whole_numbers import fraction, sqrt_mod
from hfield.orders import hermite
from hfield.orders.allowed_norms import Divisors
from hfield.orders.invariants import level
from hfield.orders.lattice_values import (
    LatticeValue,
    add_elements,
    contains,
    discriminant,
    includes,
    spanning_rows,
    times_ideal,
)
from hfield.orders.linear_algebra_mod_p import kernel
from hfield.orders.norm_search import norm_dividing
from hfield.orders.quadratic_frames import QuadraticFrame, extremal_frame
from hfield.orders.represent_integer import represent
from hfield.orders.short_elements import expect_definite
from hfield.orders.validation import positive

MAX_FRAME_DISCRIMINANT = 1000
"""The largest discriminant of the quadratic order for which the norms are likely to be represented."""


def expect_maximal(order: LatticeValue, what: str) -> int:
    """Return the discriminant of a maximal order. Raises :class:`LatticeError` for another order."""
    expect_definite(order.ambient, what)
    if level(order) != 1:
        raise LatticeError(
            f"{what} is for ideals of maximal orders, and this order has level {shorten(level(order))}: "
            "maximal_overorder() contains it"
        )
    return int(fraction(discriminant(order)))


def expect_frame(order: LatticeValue, what: str) -> QuadraticFrame:
    """Return the frame of a p-extremal order. Raises :class:`LatticeError` for another order."""
    expect_maximal(order, what)
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT)
    if f is None:
        raise LatticeError(
            f"{what} is for p-extremal orders, such as A.extremal_order(): this one contains no small "
            "quadratic order with an element of norm p at right angles to it"
        )
    return f


# --- the constraints ---


def mod_constraint(
    ideal: LatticeValue, order: LatticeValue, gamma: Quaternion, delta: Quaternion | None
) -> Quaternion:
    """Return μ₀ = (C + D·s)·β with γ·μ₀ in a left ideal I of prime norm N; if δ is given, with γ·μ₀·δ in ℤ +
    I.

    Raises :class:`LatticeError` for another order, another norm or elements outside the order.
    """
    what = "ideal_mod_constraint()" if delta is None else "eichler_mod_constraint()"
    f = expect_frame(order, what)
    norm = fraction(ideal.norm)
    if norm.denominator != 1 or not is_probable_prime(int(norm)) or not includes(order, ideal):
        raise LatticeError(
            f"{what} is for integral ideals of prime norm, and this norm is {shorten(norm)}: "
            "equivalent_of_prime_norm() leads to one"
        )
    for x in (gamma,) if delta is None else (gamma, delta):
        if not contains(order, x):
            raise LatticeError(f"{shorten(x)} does not lie in the order of the ideal")
    first, second = gamma * f.beta, gamma * f.root * f.beta
    lattice = ideal
    if delta is not None:
        first, second = first * delta, second * delta
        lattice = add_elements(ideal, order.ambient.row(1))
    ratio = ratio_in(lattice, first, second, int(norm))
    if ratio is None:
        raise LatticeError(
            "no element (C + D·s)·β fits modulo the norm: expected γ of a norm that the norm of the ideal "
            "divides"
        )
    return (ratio[0] + ratio[1] * f.root) * f.beta


def least_second(f: QuadraticFrame, norm: int) -> int:
    """Return about the least T₂ for which an element μ of norm T₂ is likely to be found."""
    return (f.norm * norm**3 * -f.discriminant) << 6


# --- strong approximation ---


def of_smooth_norm(
    order: LatticeValue, x: Quaternion, modulus: object, number: object, seed: int
) -> Quaternion:
    """Return μ in O, congruent to λ·x modulo N·O for some λ prime to N, whose norm divides T.

    x must lie in R·β modulo N·O for the frame of a p-extremal order, and N must be a prime. Raises
    :class:`LatticeError` otherwise, :class:`NoSolutionError` if all divisors of T were tried, and
    :class:`UndecidedError`.
    """
    f, n = expect_frame(order, "strong_approximation()"), positive(modulus, "modulus")
    smooth = positive(number, "number T")
    if n == 2 or n == f.norm or not is_probable_prime(n):
        raise LatticeError(
            f"the modulus {shorten(n)} is not an odd prime other than {shorten(f.norm)}: expected one"
        )
    if not contains(order, x):
        raise LatticeError(f"{shorten(x)} does not lie in the order")
    # C·β + D·s·β + E·x = 0 modulo N·O
    den, rows = spanning_rows(order.ambient, [f.beta, f.root * f.beta, x])
    scaled = times_ideal(order, order.ambient.base.ideal(n))
    inside, d = hermite.in_coordinates(scaled.matrix, rows)
    table = [[int(c) * scaled.den * n // (d * den) for c in row] for row in inside.tolist()]
    found = [v for v in kernel(list(zip(*table, strict=True)), n) if v[2] % n]
    if not found or int(x.norm()) % n == 0:
        raise LatticeError(
            f"{shorten(x)} is not (C + D·s)·β modulo {shorten(n)}·O of norm prime to it: expected what "
            "ideal_mod_constraint() or eichler_mod_constraint() returns"
        )
    divisors = Divisors(tuple((p, e) for p, e in factor(smooth).primes.items() if p != n))
    rng, least = random.Random(seed), least_second(f, n)
    # larger ones leave more choices
    targets = chain.from_iterable(divisors.above(least << 8 * k, rng) for k in range(8))
    mu = strong_approximation(f, n, targets, (found[0][0], found[0][1]))
    if mu is None:
        # all μ are the elements of norm prime to N in the lattice ℤ·x + N·O
        lattice = add_elements(scaled, order.ambient.row(x))
        mu, proved, _ = norm_dividing(lattice, remove(smooth, n)[1], rng)
        if proved and mu is None:
            raise NoSolutionError(
                f"no such element has a norm that divides {shorten(smooth)}: all its divisors were tried"
            )
    if mu is None:
        bits = least_second(f, n).bit_length() + 6
        raise UndecidedError(
            f"no such element was found whose norm divides {shorten(smooth)}, a number of "
            f"{smooth.bit_length()} bits: a smooth number of about {bits} bits is needed"
        )
    return mu


def ratio_in(
    lattice: LatticeValue, u: Quaternion, v: Quaternion, norm: int
) -> tuple[int, int] | None:
    """Return (C, D) ≠ 0 modulo N with C·u + D·v in a lattice that contains N·O."""
    den, both = spanning_rows(lattice.ambient, [u, v])
    inside, d = hermite.in_coordinates(lattice.matrix, both)
    # coordinates over the lattice have the denominator N
    rows = [[int(x) * lattice.den * norm // (d * den) for x in row] for row in inside.tolist()]
    found = kernel(list(zip(*rows, strict=True)), norm)
    return (found[0][0], found[0][1]) if found else None


def strong_approximation(
    f: QuadraticFrame, norm: int, targets: Iterable[int], ratio: tuple[int, int]
) -> Quaternion | None:
    """Return μ ≡ λ·(C + D·s)·β modulo N, for some λ, whose norm is one of the targets, or None."""
    n, p, d = norm, f.norm, -f.discriminant
    c0, d0 = ratio
    size = c0 * c0 + d * d0 * d0
    if size % n == 0:
        return None
    inverse = pow(p * size, -1, n)
    for target in targets:
        square = target * inverse % n
        if fmpz(square).jacobi(n) != 1:
            continue
        root = sqrt_mod(square, n)
        for x in (root, n - root):
            found = _lift(f, n, target, x * c0 % n, x * d0 % n)
            if found is not None:
                return found
    return None


def _lift(f: QuadraticFrame, n: int, target: int, c0: int, d0: int) -> Quaternion | None:
    """Return ``N·(x + y·s) + (c₀ + N·c + (d₀ + N·e)·s)·β`` of norm ``target``.

    Modulo N² this is one linear condition on (c, e), which are chosen close to −(c₀, d₀)/N.
    """
    p, d = f.norm, -f.discriminant
    rest = (target - p * (c0 * c0 + d * d0 * d0)) // n
    # 2p·(c₀·c + d·d₀·e) ≡ rest modulo N
    first, second = 2 * p * c0 % n, 2 * p * d * d0 % n
    if first:
        inverse = pow(first, -1, n)
        c, e, kernel = rest * inverse % n, 0, [[n, 0], [-second * inverse % n, 1]]
    else:  # then e is given
        c, e, kernel = 0, rest * pow(second, -1, n) % n, [[1, 0], [0, n]]
    tried = 0
    s = f.root
    for z, w in close((c0 + n * c, d0 + n * e), n * fmpz_mat(kernel), fmpz_mat([[1, 0], [0, d]])):
        tried += 1
        if tried > 4000:
            return None
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


def close(start: Sequence[int], lattice: fmpz_mat, form: fmpz_mat) -> Iterator[tuple[int, int]]:
    """Yield start + x for x in a planar lattice spanned by rows, ordered by a quadratic form."""
    _, steps = (lattice * form * lattice.transpose()).lll(transform=True, rep="gram")
    (a, b), (u, v) = ([int(x) for x in row] for row in (steps * lattice).tolist())
    x, y = (int(c) for c in start)
    det = a * v - b * u
    r, t = _nearest(y * u - x * v, det), _nearest(b * x - a * y, det)
    for radius in count(0):
        for i in range(-radius, radius + 1):
            sides = (-radius, radius) if abs(i) < radius else range(-radius, radius + 1)
            for j in sides:
                if radius or not j:
                    yield x + (r + i) * a + (t + j) * u, y + (r + i) * b + (t + j) * v


def _nearest(x: int, y: int) -> int:
    return (2 * x + y) // (2 * y)
