"""Find i and j of an isomorphic algebra, and square roots of numbers, in a division algebra over ℚ."""

from __future__ import annotations

import math

import flint

from hfield.core.factorisation import known_primes
from hfield.core.primality import is_prime
from hfield.core.product import Constants, Coordinates
from hfield.fields.base.ring import Ring, shared
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.unimodular_lattice import embed_number_field
from hfield.fields.rationals import symbols
from hfield.fields.rationals.places import INFINITE, Place
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.rationals.whole_numbers import crt, square_class, squarefree


def embed_rational(
    ring: Ring, outer: Constants, inner: Constants
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the algebra ``inner`` over ℚ that satisfy the relations of ``outer``.

    Both are isomorphic division algebras with t = 0; ℚ is treated as a number field of degree 1. Raises
    :class:`UnfactoredError`.
    """
    K = shared(NumberField, "s-1", "s")
    given = [Constants(*map(K, constants)) for constants in (outer, inner)]
    i, j = (tuple(ring(x.poly[0]) for x in q) for q in embed_number_field(K, *given))
    return i, j


def traceless_root_rational(ring: Ring, c: Constants, s: flint.fmpq) -> Coordinates | None:
    """Return some x of trace 0 with ``x² = s`` in a division algebra (a, b | ℚ), or None; s is not 0.

    It is the image of i in an algebra (s, e) with the same ramification, which exists if ℚ(√s) splits the
    algebra, that is, if s is not a square at any ramified place (Voight, *Quaternion Algebras*, proposition
    14.6.7).
    """
    places = ramified_places_q(c.a, c.b)
    m, _, primes = squarefree(square_class(s))
    found = _partner(m, primes, places)
    if found is None:
        return None
    e, new = found
    with known_primes([p for p in (*places, new) if isinstance(p, int) and p > 1]):
        return embed_rational(ring, Constants(s, ring.zero, ring(e)), c)[0]


def _partner(s: int, primes: list[int], places: tuple[Place, ...]) -> tuple[int, int] | None:
    """Return an e such that (s, e | ℚ) ramifies exactly at these places, or None if there is none.

    Along with it a prime of e, or 1, the others being among the places; s is squarefree, of the given
    primes. By the product formula the symbol at the one prime that is new takes care of itself.
    """
    odd = [p for p in places if isinstance(p, int) and p > 2]
    if any(symbols.hilbert_symbol_q(s, p, p) > 0 for p in odd if s % p):
        return None  # s is a square there
    if INFINITE in places and s > 0:
        return None
    sign = -1 if INFINITE in places else 1
    start = sign * math.prod(p for p in odd if s % p)
    wanted = -1 if 2 in places else 1
    classes = [
        (u, twos)
        for twos in (1, 2)
        for u in (1, 3, 5, 7)
        if symbols.hilbert_symbol_q(s, u * twos, 2) == wanted
    ]
    if not classes:
        return None
    u, twos = classes[0]
    start *= twos
    residues = [(u * pow(start // twos, -1, 8) % 8, 8)]
    for p in primes:
        if p != 2:
            r = symbols.non_residue(p) if p in places else 1
            residues.append((r * pow(start, -1, p) % p, p))
    q, step = crt(residues)
    while not (q == 1 or (is_prime(q) and q not in places and s % q)):
        q += step
    return start * q, q
