"""Maximal orders with a small quadratic order and its orthogonal element of norm p: p-extremal ones.

In ``(−q, −p | ℚ)`` with q = 1, 2 or a small prime, a maximal order that contains the ring of integers R of
ℚ(i) and ``R·j`` (Pizer, 1980, proposition 5.2; Kohel, Lauter, Petit and Tignol, 2014, section 2.3).
"""

from __future__ import annotations

from typing import Any

from hfield.algebra.quaternion import Parent
from hfield.errors import LatticeError
from hfield.lattices.modulo_primes import kronecker
from hfield.lattices.order import Order
from hfield.lattices.regular_representation import regular
from hfield.primality import is_prime


def quadratic_part(p: int) -> int:
    """Return q = 1, 2 or a prime 3 modulo 4 for which ``(−q, −p | ℚ)`` ramifies at p and ∞."""
    if p == 2 or p % 4 == 3:
        return 1
    if p % 8 == 5:
        return 2
    q = 3
    while not (is_prime(q) and kronecker(p, q) == -1):
        q += 4
    return q


def extremal_order(algebra: Parent) -> Order:
    """Return a p-extremal maximal order of a definite algebra of prime discriminant p.

    Raises :class:`LatticeError` for another algebra.
    """
    r = regular(algebra)
    if not r.definite or len(r.ramified) != 1:
        raise LatticeError(
            f"{algebra} has no p-extremal order: expected a definite algebra of prime discriminant"
        )
    (p,) = r.ramified
    q = quadratic_part(p)
    i, j = _generators(algebra, q, p)
    w = (1 + i) / 2 if q % 4 == 3 else i
    return Order.generated(algebra, [w, j]).maximal_overorder()


def _generators(algebra: Parent, q: int, p: int) -> tuple[Any, Any]:
    """Return anticommuting elements with squares −q and −p."""
    _, i, j, _ = algebra.basis
    if i * i == -q and j * j == -p and i * j == -(j * i):
        return i, j
    from hfield.structure import isomorphism

    ring = algebra.ring
    source = (ring(-q), ring(0), ring(-p))
    found = isomorphism(ring, type(algebra.constants)(*source), algebra.constants)
    if found is None:
        raise AssertionError("both ramify at p and infinity")
    return algebra(*found.images[1]), algebra(*found.images[2])
