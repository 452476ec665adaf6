"""Reduce definite ternary forms over ℤ: find all Korkine–Zolotarev reduced bases of a lattice.

A basis (u, v, w) is reduced if u is a shortest vector, v is a shortest vector modulo u, and the Gram–Schmidt
coefficients lie in (−1/2, 1/2]. A lattice has few such bases. They are found quickly even if the lattice is
so skew that it has too many vectors of the lengths of a basis to list.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpz_mat

from hfield.orders import enumeration
from hfield.orders.enumeration import Gram, Vector

Basis = tuple[Vector, Vector, Vector]


def reduced_bases(gram: Gram) -> Iterator[tuple[Basis, tuple[int, ...]]]:
    """Yield each reduced basis (with one of ±u as first vector) and its six inner products.

    The given matrix should already be LLL-reduced.
    """
    for u in enumeration.least_vectors(gram)[1]:
        b, c = _completed(u)
        bb, bc, cc = _modulo(gram, u, b, c)
        plane, steps = fmpz_mat(2, 2, [bb, bc, bc, cc]).lll(transform=True, rep="gram")
        b, c = (_sum((int(steps[n, 0]), b), (int(steps[n, 1]), c)) for n in (0, 1))
        form = [[int(e) for e in row] for row in plane.tolist()]
        for x, y in enumeration.least_vectors(form)[1]:
            _, s, t = _gcd(x, y)
            v, w = _sum((x, b), (y, c)), _sum((-t, b), (s, c))
            for e in (1, -1):
                for f in (1, -1):
                    yield _rounded(gram, u, _sum((e, v)), _sum((f, w)))


def _rounded(gram: Gram, u: Vector, v: Vector, w: Vector) -> tuple[Basis, tuple[int, ...]]:
    """Subtract multiples of v and u so that the coefficients lie in (−1/2, 1/2]."""
    vv, vw, _ = _modulo(gram, u, v, w)
    w = _sum((1, w), (-_nearest(vw, vv), v))
    uu = _pair(gram, u, u)
    v, w = (_sum((1, x), (-_nearest(_pair(gram, u, x), uu), u)) for x in (v, w))
    uv, uw, vw = _pair(gram, u, v), _pair(gram, u, w), _pair(gram, v, w)
    return (u, v, w), (uu, _pair(gram, v, v), _pair(gram, w, w), uv, uw, vw)


def _modulo(gram: Gram, u: Vector, x: Vector, y: Vector) -> tuple[int, int, int]:
    """Return ``|u|²`` times the inner products of the projections of x and y orthogonal to u."""
    uu, ux, uy = (_pair(gram, u, v) for v in (u, x, y))

    def outside(v: Vector, w: Vector, uv: int, uw: int) -> int:
        return uu * _pair(gram, v, w) - uv * uw

    return outside(x, x, ux, ux), outside(x, y, ux, uy), outside(y, y, uy, uy)


def _completed(u: Vector) -> tuple[Vector, Vector]:
    """Return two vectors that form a basis of ℤ³ with a primitive vector."""
    g, s, t = _gcd(u[0], u[1])
    x, y = (u[0] // g, u[1] // g) if g else (1, 0)
    _, p, q = _gcd(g, u[2])
    return (-t, s, 0), (-q * x, -q * y, p)


def _gcd(x: int, y: int) -> tuple[int, int, int]:
    """Return (g, s, t) with g = s·x + t·y a greatest common divisor, of either sign (Euclid)."""
    s, t, p, q = 1, 0, 0, 1
    while y:
        n = x // y
        x, y, s, t, p, q = y, x - n * y, p, q, s - n * p, t - n * q
    return x, s, t


def _nearest(n: int, d: int) -> int:
    """Return q with n/d − q in (−1/2, 1/2]."""
    return -((d - 2 * n) // (2 * d))


def _pair(gram: Gram, x: Vector, y: Vector) -> int:
    (a, b, c), (_, d, e), (_, _, f) = gram
    (p, q, r), (s, t, u) = x, y
    return s * (a * p + b * q + c * r) + t * (b * p + d * q + e * r) + u * (c * p + e * q + f * r)


def _sum(*terms: tuple[int, Vector]) -> Vector:
    p = q = r = 0
    for c, (x, y, z) in terms:
        p, q, r = p + c * x, q + c * y, r + c * z
    return p, q, r
