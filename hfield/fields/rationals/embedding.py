"""Inside a division algebra over ℚ: the i and j of an isomorphic one, and square roots of numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import known_primes
from hfield.core.primality import is_prime
from hfield.core.product import Constants, Coordinates
from hfield.fields.base.ring import Ring
from hfield.fields.rationals import symbols
from hfield.fields.rationals.isometries import isometry
from hfield.fields.rationals.places import INFINITE, Place
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.rationals.whole_numbers import crt, fraction, square_class, squarefree

if TYPE_CHECKING:
    import flint


class _Diagonal:
    """The norm on the quaternions of trace 0 of (a, b | ℚ), with squarefree coefficients.

    ``scales`` are those of i, j and k = ij that have ``−form`` as squares.
    """

    def __init__(self, a: flint.fmpq, b: flint.fmpq) -> None:
        m, r, in_m = squarefree(square_class(a))
        n, s, in_n = squarefree(square_class(b))
        common = math.gcd(m, n)
        self.form = (-m, -n, (m // common) * (n // common))
        self.primes = {*in_m, *in_n}
        x, y = fraction(a).denominator / fraction(r), fraction(b).denominator / fraction(s)
        self.scales = (x, y, x * y / common)


def embed_rational(
    ring: Ring, outer: Constants, inner: Constants
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the algebra ``inner`` over ℚ that satisfy the relations of ``outer``.

    Both are division algebras, isomorphic, with t = 0. Raises :class:`UnfactoredError`.
    """
    source, target = _Diagonal(outer.a, outer.b), _Diagonal(inner.a, inner.b)
    images = isometry(source.form, target.form, source.primes | target.primes)
    found = []
    for row, scale in zip(images[:2], source.scales, strict=False):
        x, y, z = (ring(u * v / scale) for u, v in zip(row, target.scales, strict=True))
        found.append((ring.zero, x, y, z))
    return found[0], found[1]


def traceless_root_rational(ring: Ring, c: Constants, s: flint.fmpq) -> Coordinates | None:
    """Return some x of trace 0 with ``x² = s`` in a division algebra (a, b | ℚ), or None; s is not 0.

    It is the image of i in an algebra (s, e) with the same ramification, if ℚ(√s) splits the algebra: if s is
    no square at any ramified place (Voight, *Quaternion Algebras*, proposition 14.6.7).
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
    """Return an e for which (s, e | ℚ) ramifies exactly at these places, or None if there is none.

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
