"""Quadratic number fields as global fields.

Hilbert symbols over quadratic number fields ℚ(√d), d squarefree, elements as pairs (u, v) = u + v√d.

Above an odd prime the symbol is tame and read off a residue field; above a split 2 the completion
is ℚ₂; at a real embedding the signs decide. Where 2 does not split there is one place above it, and
the product formula gives the symbol there. Voight, *Quaternion Algebras*, chapters 12 and 14.
That takes a fifth of the time of what serves all number fields; points and slots are left to these.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from hfield.core.factorisation import Factors, factorise, known_primes, remove
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import RingError
from hfield.fields.number_fields.arithmetic import NumberFieldArithmetic
from hfield.fields.number_fields.conics import solve_conic_number_field
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.quadratic.as_number_field import (
    as_number_field,
    from_number_field,
    into_number_field,
    place_in_number_field,
)
from hfield.fields.number_fields.quadratic.places import (
    QuadraticPlace,
    place_of_quadratic,
    places_above,
)
from hfield.fields.number_fields.quadratic.residues import DegreeOne, Inert, prime_at
from hfield.fields.number_fields.quadratic.ring import QuadraticField
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.embedding import traceless_root_rational
from hfield.fields.rationals.symbols import ramified_places_q, symbol_of_parts
from hfield.rings.integers import QQ
from hfield.rings.whole_numbers import fraction
from hfield.structure.forms import NormalForm
from hfield.structure.global_field import GlobalField
from hfield.structure.norm_forms.zero_norm_answer import CONIC, ZeroNorm, found

if TYPE_CHECKING:
    from hfield.rings.closed_fields.surds import Surd


class QuadraticArithmetic(GlobalField):
    """The arithmetic of ℚ(√d): tame symbols, and the product formula at a lone place above 2."""

    ring: QuadraticField

    def read_place(self, text: object) -> QuadraticPlace:
        """Return a prime ideal or an infinite place."""
        return place_of_quadratic(self.ring, text)

    def hilbert_symbol(
        self, a: Scalar | str, b: Scalar | str, place: object, factors: Factors | None
    ) -> int:
        """Return the symbol; at a lone place above 2 the norms of a and b are factored."""
        x, y = (pair(self.ring, self.ring(x)) for x in (a, b))
        with known_primes(factors):
            return hilbert_symbol_quadratic(self.ring, x, y, place)

    def ramified(self, form: NormalForm) -> tuple[QuadraticPlace, ...]:
        """Return the places with a symbol of −1; the norms of a and b are factored."""
        a, b = (pair(self.ring, x) for x in form.constants)
        return ramified_places_quadratic(self.ring, a, b)

    def discriminant(self, ramified: tuple[QuadraticPlace, ...]) -> tuple[QuadraticPlace, ...]:
        """Return the prime ideals, whose product it is."""
        return tuple(v for v in ramified if v.prime)

    def with_ramification(
        self, places: Sequence[object], infinite: bool | None = None
    ) -> tuple[Surd, Surd]:
        """Return constants found in ℚ[s]/(s² − d), which is the same field."""
        same = [place_in_number_field(self.read_place(v)) for v in places]
        a, b = self.same.with_ramification(same, infinite)
        return self._back(a), self._back(b)

    @cached_property
    def same(self) -> NumberFieldArithmetic:
        """The arithmetic of the same field as ℚ[s]/(s² − d), which looks for points and isomorphisms."""
        return NumberFieldArithmetic(as_number_field(self.ring))

    def _there(self, c: Constants) -> Constants:
        return Constants(*(into_number_field(self.ring, x) for x in c))

    def _back(self, x: FieldElement) -> Surd:
        return from_number_field(self.ring, x)

    def unramified_zero(self, c: Constants, form: NormalForm) -> ZeroNorm:
        """Return a point of the conic, or, for rational a and b, a square root of d over ℚ less √d."""
        q = form.back(self._zero(form))
        return found(self.ring, c, q, "conic", CONIC)

    def _zero(self, form: NormalForm) -> Coordinates:
        ring = self.ring
        (a, s), (b, t) = (pair(ring, x) for x in form.constants)
        if s or t:
            c = self._there(Constants(form.a, ring.zero, form.b))
            x, y, z = map(self._back, solve_conic_number_field(self.same.ring, c.a, c.b))
            return z, x, y, ring.zero
        if not ramified_places_q(a, b):
            x, y, z = (ring(u) for u in solve_conic(a, b))
            return z, x, y, ring.zero
        root = traceless_root_rational(QQ, Constants(QQ(a), QQ.zero, QQ(b)), QQ(ring.d))
        assert root is not None, "an algebra over ℚ that ℚ(√d) splits contains a square root of d"
        _, x, y, z = (ring(u) for u in root)
        return -ring.gen, x, y, z

    def residues(self, place: QuadraticPlace) -> DegreeOne | Inert | None:
        """Return the prime ideal with its residue field."""
        return prime_at(place) if place.prime else None

    def embed(self, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
        """Return I and J as they are found in ℚ[s]/(s² − d)."""
        i, j = self.same.embed(self._there(outer), self._there(inner))
        return self._all_back(i), self._all_back(j)

    def traceless_root(self, form: NormalForm, s: Surd) -> Coordinates | None:
        """Return x as it is found in ℚ[s]/(s² − d)."""
        a, b, square = self._there(Constants(form.a, form.b, s))
        x = self.same.traceless_root(form._replace(a=a, b=b), square)
        return None if x is None else self._all_back(x)

    def _all_back(self, q: Coordinates) -> Coordinates:
        w, x, y, z = map(self._back, q)
        return w, x, y, z


Pair = tuple[Fraction, Fraction]


def pair(field: QuadraticField, x: Surd) -> Pair:
    """Return the coordinates of u + v√d."""
    terms = field(x).terms
    return fraction(terms.get(1, 0)), fraction(terms.get(field.d, 0))


def sign(d: int, x: Pair | tuple[int, int], root: int) -> int:
    """Return the sign of ``u + v√d`` under ``√d ↦ root·√|d|``, d > 0, root = ±1."""
    u, v = x[0], x[1] * root
    if u * v >= 0:
        return (u + v > 0) - (u + v < 0)
    larger = u * u > d * v * v
    return (1 if u > 0 else -1) if larger else (1 if v > 0 else -1)


def integral(x: Pair) -> tuple[int, int]:
    """Return x times a square of an integer, with integer coordinates."""
    if not (x[0] or x[1]):
        raise RingError(
            "a Hilbert symbol is defined for nonzero numbers only, and one of these is 0"
        )
    m = x[0].denominator * x[1].denominator
    return int(x[0] * m * m), int(x[1] * m * m)


def _local(v: QuadraticPlace, x: tuple[int, int]) -> tuple[int, int]:
    """Return the valuation of x and a number in the residue class that decides its unit part.

    At a split place the unit is a p-adic integer modulo 8 or p; at a ramified one modulo p with
    respect to the uniformiser √d; at an inert one the norm of the unit is returned, which is a square
    modulo p exactly when the unit is one in GF(p²).
    """
    p, d = v.prime, v.d
    size = x[0] * x[0] - d * x[1] * x[1]
    n, unit = remove(size, p)
    if v.root is not None:
        kappa = prime_at(v)
        assert isinstance(kappa, DegreeOne)
        s, t = map(Fraction, x)
        u, w = (s - t, 2 * t) if d % 4 == 1 else (s, t)
        return remove(int(kappa.near(u, w, n + 4)), p)
    if d % p:  # inert: n is even
        return n // 2, unit % p
    k, odd = divmod(n, 2)
    leading = x[1] if odd else x[0]
    return n, leading // p**k * pow(d // p, -k, p) % p


def is_dyadic(v: QuadraticPlace) -> bool:
    """Tell whether this is the one place above a 2 that does not split."""
    return v.prime == 2 and v.root is None


def direct_symbol(v: QuadraticPlace, a: tuple[int, int], b: tuple[int, int]) -> int:
    """Return the symbol of nonzero integers u + v√d at a place other than a lone one above 2."""
    if not v.prime:
        if v.root is None:
            return 1
        return -1 if sign(v.d, a, v.root) < 0 and sign(v.d, b, v.root) < 0 else 1
    (alpha, u), (beta, w) = _local(v, a), _local(v, b)
    if v.root is None and v.d % v.prime:  # inert: −1 is a square, and u, w are norms of units
        value = (u if beta % 2 else 1) * (w if alpha % 2 else 1) % v.prime
        return 1 if pow(value, (v.prime - 1) // 2, v.prime) == 1 else -1
    return symbol_of_parts(v.prime, alpha, u, beta, w)


def ramified_places_quadratic(
    field: QuadraticField, a: Pair, b: Pair
) -> tuple[QuadraticPlace, ...]:
    """Return the places of ℚ(√d) where ``(a, b | ℚ(√d))`` does not split, infinite ones last.

    Raises :class:`UnfactoredError` for a norm that is too hard to factor.
    """
    x, y, d = integral(a), integral(b), field.d
    primes = {2}
    for s in (x, y):
        primes |= set(factorise(s[0] * s[0] - d * s[1] * s[1]))
    candidates = [v for p in (*sorted(primes), 0) for v in places_above(field, p)]
    bad = [v for v in candidates if not is_dyadic(v) and direct_symbol(v, x, y) < 0]
    lone = [v for v in candidates if is_dyadic(v)]
    if len(bad) % 2:
        assert lone, "the number of ramified places is even"
        bad = lone + bad
    return tuple(bad)


def hilbert_symbol_quadratic(field: QuadraticField, a: Pair, b: Pair, place: object) -> int:
    """Return the Hilbert symbol of two nonzero elements at a place of ℚ(√d).

    Above a 2 that does not split the norms of a and b are factored. Raises :class:`UnfactoredError`.
    """
    v = place_of_quadratic(field, place)
    if is_dyadic(v):
        return -1 if v in ramified_places_quadratic(field, a, b) else 1
    return direct_symbol(v, integral(a), integral(b))
