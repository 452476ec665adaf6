"""KLPT and the representation of integers as a script on Sage writes them; runs in Sage's interpreter.

The plain algorithm of Kohel, Lauter, Petit and Tignol (2014) on Sage's own objects: ideals, quaternions,
matrices over finite fields, square roots modulo primes. For the standard order of (−1, −p), p ≡ 3 modulo 4.
"""

import itertools
import random
from typing import Any

from sage.arith.misc import is_pseudoprime
from sage.matrix.constructor import matrix
from sage.rings.finite_rings.finite_field_constructor import GF
from sage.rings.finite_rings.integer_mod import Mod
from sage.rings.integer_ring import ZZ

FIRST = 100


def two_squares(m: Any) -> tuple[Any, Any] | None:
    """Return (x, y) with x² + y² = m for a prime m ≡ 1 modulo 4 (Cornacchia), else None."""
    if m < 5 or m % 4 != 1 or not is_pseudoprime(m):
        return None
    a, b = m, ZZ(Mod(-1, m).sqrt())
    limit = m.isqrt()
    while b > limit:
        a, b = b, a % b
    y = (m - b * b).isqrt()
    return (b, y) if b * b + y * y == m else None


def represent_integer(B: Any, n: Any, rng: random.Random) -> Any:
    """Return an element x + y·i + (z + w·i)·j of norm n, for n greater than p."""
    i, j, _ = B.gens()
    p = ZZ(-B.invariants()[1])
    n = ZZ(n)
    bound = (n // p).isqrt()
    for _ in range(100_000):
        z = rng.randint(0, int(bound))
        rest = ((n - p * z * z) // p).isqrt()
        w = rng.randint(-int(rest), int(rest))
        found = two_squares(ZZ(n - p * (z * z + w * w)))
        if found is not None:
            return found[0] + found[1] * i + (z + w * i) * j
    return None


def equivalent_of_prime_norm(ideal: Any) -> Any:
    """Yield pairs of an equivalent ideal I·conj(x)/N(I) of prime norm and this norm, for short x."""
    size = ideal.norm()
    basis = ideal.reduced_basis()
    small = sorted(itertools.product(range(-3, 4), repeat=4), key=lambda c: sum(x * x for x in c))
    for c in small[1:]:
        x = sum(m * b for m, b in zip(c, basis, strict=True))
        norm = ZZ(x.reduced_norm() / size)
        if norm > FIRST and is_pseudoprime(norm):
            yield ideal * (x.conjugate() / size), norm


def equivalent_of_power_norm(ideal: Any, prime: int, seed: int) -> tuple[Any, int]:
    """Return an equivalent ideal whose norm is a power of a small prime, and the exponent."""
    found, a, b = klpt(ideal, prime, prime, seed)
    return found, a + b


def equivalent_of_norm_dividing(ideal: Any, k: int, seed: int) -> Any:
    """Return an equivalent ideal whose norm 2ᵃ·3ᵇ divides 6ᵏ."""
    found, a, b = klpt(ideal, 2, 3, seed)
    if max(a, b) > k:
        raise ArithmeticError("nothing was found")
    return found


def klpt(ideal: Any, prime: int, second: int, seed: int) -> tuple[Any, int, int]:
    """Return an equivalent ideal of norm primeᵃ·secondᵇ, a and b."""
    B = ideal.quaternion_algebra()
    _, j, k = B.gens()
    p = ZZ(-B.invariants()[1])
    rng = random.Random(seed)
    for J, N in equivalent_of_prime_norm(ideal):
        a = max(1, int(ZZ(p // N + 1).nbits() + 8 + p.nbits().bit_length()))
        for _ in range(4):
            gamma = represent_integer(B, N * prime**a, rng)
            if gamma is None:
                continue
            # (C + D·i)·j with γ·(C + D·i)·j in J, which contains N
            inverse = J.basis_matrix().inverse()
            rows = matrix([list((gamma * q).coefficient_tuple()) for q in (j, k)]) * inverse * N
            found = rows.change_ring(GF(N, proof=False)).kernel()
            if found.dimension() != 1:
                continue
            C, D = (ZZ(x) for x in found.basis()[0])
            mu = strong_approximation(B, p, N, C, D, second)
            if mu is not None:
                x = gamma * mu[0]
                return J * (x.conjugate() / N), a, mu[1]
    raise ArithmeticError("nothing was found")


def strong_approximation(B: Any, p: Any, N: Any, C: Any, D: Any, prime: int) -> Any:
    """Return μ = λ·(C + D·i)·j + N·μ₁ of norm primeᵇ, μ₁ near the closest, and b; or None."""
    i, j, _ = B.gens()
    F = GF(N, proof=False)
    size = F(p * (C * C + D * D))
    start = ZZ((p * N**3) << 6).exact_log(prime) + 1
    for b in range(start, start + 8):
        square = F(prime) ** b / size
        if not square.is_square():
            continue
        root = ZZ(square.sqrt())
        u, v = root * C % N, root * D % N
        # (u + c·N, v + d·N) with p·(…) = primeᵇ modulo N²: one linear equation for c and d
        right = F(ZZ(prime**b - p * (u * u + v * v)) // N) / F(2 * p)
        if not v % N:
            continue
        d0 = ZZ(right / F(v))
        lattice = matrix(ZZ, [[1, ZZ(-F(u) / F(v))], [0, N]]).LLL()
        e, f = lattice.rows()
        # the closest vector to −(u, v)/N, by rounding
        goal = matrix([[-u / N, -v / N - d0]]) * lattice.inverse()
        m, n = (ZZ(x.round()) for x in goal.row(0))
        for s, t in sorted(
            itertools.product(range(-12, 13), repeat=2), key=lambda x: x[0] ** 2 + x[1] ** 2
        ):
            c, d = (m + s) * e[0] + (n + t) * f[0], d0 + (m + s) * e[1] + (n + t) * f[1]
            z, w = u + c * N, v + d * N
            rest = prime**b - p * (z * z + w * w)
            if rest <= 0:
                continue
            found = two_squares(ZZ(rest // N**2))
            if found is not None:
                mu = N * (found[0] + found[1] * i) + (z + w * i) * j
                assert mu.reduced_norm() == prime**b
                return mu, b
    return None


def modulo(order: Any, q: Any) -> Any:
    """Return a matrix over ℤ/q for each element of a basis of an order, an isomorphism O/qO → M₂(ℤ/q)."""
    B = order.quaternion_algebra()
    one, i, j, k = [matrix.identity(GF(q, proof=False), 2), *B.modp_splitting_data(q)]
    return [
        sum(GF(q, proof=False)(c) * m for c, m in zip(x, (one, i, j, k), strict=True))
        for x in (b.coefficient_tuple() for b in order.basis())
    ]


def two_generators(ideal: Any, rng: random.Random) -> tuple[Any, Any]:
    """Return N and x with I = O·N + O·x for a primitive integral left ideal of norm N."""
    size, O = ZZ(ideal.norm()), ideal.left_order()
    while True:
        x = sum(rng.randint(-10, 10) * b for b in ideal.basis())
        if ZZ(x.reduced_norm() / size).gcd(size) == 1:
            assert O.left_ideal([size, x]) == ideal
            return size, x


def reduced_equivalent(ideal: Any) -> Any:
    """Return the equivalent left ideal of least norm."""
    return ideal * (ideal.minimal_element().conjugate() / ideal.norm())


def equivalent_pair(ideal: Any, total: Any) -> tuple[Any, Any]:
    """Return the norms of two equivalent left ideals, coprime and of a given sum (Qlapoti)."""
    B = ideal.quaternion_algebra()
    i, j, _ = B.gens()
    p, total = ZZ(-B.invariants()[1]), ZZ(total)
    for J, N in equivalent_of_prime_norm(ideal):
        inverse = J.basis_matrix().inverse()
        rows = matrix([list(q.coefficient_tuple()) for q in (B(1), i, j)]) * inverse * N
        found = rows.change_ring(GF(N, proof=False)).kernel()
        if found.dimension() != 1 or not found.basis()[0][2]:
            continue
        a, b, c = found.basis()[0]
        l0, l1 = ZZ(a / c), ZZ(b / c)
        small = itertools.product(range(-40, 41), range(41))
        for v0, v1 in sorted(small, key=lambda v: v[0] ** 2 + v[1] ** 2)[1:]:
            whole = total * N - p * (v0 * v0 + v1 * v1)
            if whole <= 0:
                break
            g0, g1 = (l0 * v0 - l1 * v1) % N, (l0 * v1 + l1 * v0) % N
            rest = ZZ((whole - g0 * g0 - g1 * g1) / N)
            if not g0 % N:
                continue
            # 2·(g₀·c + g₁·e) ≡ rest modulo N
            factor = ZZ(1 / GF(N, proof=False)(2 * g0))
            offset, slope = rest * factor % N, -2 * g1 * factor % N
            lattice = matrix(ZZ, [[N, 0], [slope, 1]]).LLL()
            goal = matrix([[-g0 / N - offset, -g1 / N]]) * lattice.inverse()
            m, n = (ZZ(x.round()) for x in goal.row(0))
            for s, t in itertools.product(range(-2, 3), repeat=2):
                c, e = (m + s) * lattice[0] + (n + t) * lattice[1]
                u0, u1 = g0 + N * (c + offset), g1 + N * e
                left = whole - u0 * u0 - u1 * u1
                if left > 0 and two_squares(ZZ(left / N**2)) is not None:
                    second = ZZ(left / N)
                    if second.gcd(total) == 1:
                        return total - second, second
    raise ArithmeticError("nothing was found")
