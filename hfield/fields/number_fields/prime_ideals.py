"""Prime ideals of number fields: e, f, two generators, valuations, residue fields.

If ℤ[s] is maximal at p, the polynomial of s modulo p determines everything (Kummer and Dedekind). Otherwise
the algebra O/pO of a p-maximal order is decomposed (:mod:`.residue_algebra`). Each prime P has a π with (p,
π) = P; a β in pP⁻¹ that is not in pO, with which valuations are computed (Cohen, algorithm 4.8.17); and an
idempotent ε modulo p, which is 1 at P and 0 at the other primes above p.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, lru_cache
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import remove
from hfield.core.primality import is_prime
from hfield.errors import RingError, shorten
from hfield.fields.base.coercion import rational
from hfield.fields.base.residue_polynomials import (
    coefficients,
    idempotent,
    residues,
    sorted_factors,
)
from hfield.fields.base.ring import Ring
from hfield.fields.finite.ring import modulus_text
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.integers import (
    LocalOrder,
    integral_generator,
    left_kernel,
    local_order,
)

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Coefficient
    from hfield.fields.number_fields.ring import NumberField


class PrimeIdeal:
    """A prime ideal P above p, with ramification index ``e`` and residue degree ``f``.

    (p, ``pi``) = P; ``beta`` is in pP⁻¹, not in pO; ``idempotent`` is 1 at P and 0 at the other primes above
    p. ``residue`` is an irreducible polynomial over GF(p), the residue field is GF(p)[x] modulo it, and
    ``residue_gen`` is an integer of the field with residue x. If the order is not ℤ[s], ``images`` is the
    matrix that maps coordinates to residues. Without ``epsilon`` the order is ℤ[s] at p, and the idempotent
    is computed on first use.

    >>> from hfield import ring
    >>> K = ring("QQ[s]/(s^3-2)"); (P,) = K.primes_above(2)
    >>> P, P.e, P.f, P.valuation(K(6)), K.gen in P
    ((2, s), 3, 1, 3, True)
    """

    is_finite = True

    def __init__(
        self,
        order: LocalOrder,
        e: int,
        f: int,
        pi: FieldElement,
        beta: FieldElement,
        epsilon: FieldElement | None,
        residue: flint.nmod_poly,
        residue_gen: FieldElement,
        images: flint.nmod_mat = None,
    ) -> None:
        self.field, self.order, self.p, self.e, self.f = order.field, order, order.p, e, f
        self.pi, self.beta, self._epsilon = pi, beta, epsilon
        self.residue, self.residue_gen, self._images = residue, residue_gen, images

    @property
    def generators(self) -> tuple[FieldElement, FieldElement]:
        """Return p and a second generator of the ideal: ``pi``, made integral at all primes."""
        scale = remove(integral_generator(self.field)[0], self.p)[1]
        return self.field(self.p), self.pi * flint.fmpq(scale ** self.pi.poly.degree())

    def norm(self) -> int:
        """The number of residues, p^f."""
        return int(self.p**self.f)

    @property
    def data(self) -> dict[str, object]:
        """The ideal as JSON data: p, and the coefficients of the second generator unless p is inert."""
        element = None if self.is_inert else self.field.coordinates(self.pi)
        return {"kind": "prime ideal", "p": self.p, "element": element}

    @property
    def is_inert(self) -> bool:
        """Whether p itself generates the ideal."""
        return self.f == self.field.degree

    def __str__(self) -> str:
        return (
            str(self.p) if self.is_inert else f"({self.p}, {self.field.text(self.generators[1])})"
        )

    @property
    def short_name(self) -> str:
        """The text used in names of completions, where ``pi`` need not be an integer away from p."""
        return str(self.p) if self.is_inert else f"({self.p}, {self.field.text(self.pi)})"

    __repr__ = __str__

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, PrimeIdeal)
            and self.p == other.p
            and self.field == other.field
            and self.pi == other.pi
        )

    def __hash__(self) -> int:
        return hash((self.field, self.p, self.pi))

    def __reduce__(self) -> tuple[object, ...]:
        return _prime_above, (self.field, self.p, self.pi)

    def __contains__(self, x: object) -> bool:
        y = self.field(x)
        return not y or (self.field.is_integral(y) and self.valuation(y) > 0)

    def valuation(self, x: FieldElement) -> int:
        """Return the valuation of x ≠ 0 at P. Raises :class:`RingError` for 0."""
        return self.unit_part(self.field(x))[0]

    def unit_part(self, x: FieldElement) -> tuple[int, FieldElement]:
        """Return ``(v, u)``: the valuation of x ≠ 0, and x·(β/p)^v, times the square of a number."""
        if not x:
            raise RingError("0 has no valuation: it lies in every power of a prime ideal")
        order, p = self.order, self.p
        twice = order.content(x) // 2
        y = x * flint.fmpq(p) ** (-2 * twice) if twice else x
        v = 2 * twice * self.e
        while True:
            z = y * self.inverse_uniformiser
            if order.content(z) < 0:
                return v, y
            y, v = z, v + 1

    @cached_property
    def inverse_uniformiser(self) -> FieldElement:
        """β/p, of valuation −1 here and integral at all other primes."""
        found: FieldElement = self.beta * flint.fmpq(1, self.p)
        return found

    @cached_property
    def idempotent(self) -> FieldElement:
        """An integer that is 1 modulo the power of this ideal in p, and 0 modulo the powers of the other
        ideals.
        """
        if self._epsilon is not None:
            return self._epsilon
        part = self.residue**self.e
        return self.order.element(coefficients(idempotent(_modulo_p(self.order), part)))

    @cached_property
    def uniformiser(self) -> FieldElement:
        """An integer of valuation 1 here and valuation 0 at the other primes above p."""
        if self.is_inert:
            found: FieldElement = self.field(self.p)
            return found
        return self.pi if self.valuation(self.pi) == 1 else self.pi + self.p

    # --- the residue field -----------------------------------------------------------------------

    @cached_property
    def residue_field(self) -> Ring:
        """The field of residues GF(p^f), in which x is ``residue_gen``."""
        from hfield.fields.finite.names import GF

        if self.f == 1:
            return GF(self.p)
        return GF(self.norm(), modulus_text(coefficients(self.residue)))

    def reduce(self, x: FieldElement) -> Coefficient:
        """Return the class of x in the residue field. Raises :class:`RingError` for a negative valuation."""
        field, residue = self.residue_field, coefficients(self.residue_of(self.field(x)))
        total = field.zero
        gen = field.gen if self.f > 1 else field.zero
        for c in reversed(residue):
            total = total * gen + field(c)
        return total

    def residue_of(self, x: FieldElement) -> flint.nmod_poly:
        """Return the class of x as a polynomial over GF(p) reduced modulo ``residue``."""
        if not x:
            return residues(self.p, [])
        return self._residue(self.integral(x))

    def integral(self, x: FieldElement) -> FieldElement:
        """Return x, of valuation ≥ 0, times the square of a number that is 1 modulo P; the product is
        integral at p.
        """
        if self.order.content(x) < 0 and self.valuation(x) < 0:
            raise RingError(f"{shorten(x)} has no residue at {self}: its valuation is negative")
        while self.order.content(x) < 0:
            x = x * self.idempotent * self.idempotent
        return x

    def _residue(self, x: FieldElement) -> flint.nmod_poly:
        numerators, below = self.order.coordinates(x)
        scale = pow(below, -1, self.p)
        values = [c * scale % self.p for c in numerators]
        if self._images is None:
            return residues(self.p, values) % self.residue
        row = flint.nmod_mat(1, len(values), values, self.p) * self._images
        return residues(self.p, row.entries())

    def lift(self, residue: flint.nmod_poly) -> FieldElement:
        """Return an integer of the field with the given residue, a polynomial over GF(p)."""
        total: FieldElement = self.field.zero
        for c in reversed(coefficients(residue)):
            total = total * self.residue_gen + c
        return total


def primes_above(field: NumberField, p: object) -> tuple[PrimeIdeal, ...]:
    """Return the prime ideals above a prime number, in a fixed order. Raises :class:`RingError`."""
    number = rational(p)
    if not isinstance(number, int) or not is_prime(number):
        raise RingError(f"{shorten(p)} is not a prime number; expected one, such as 5")
    return _primes_above(field, number)


def _prime_above(field: NumberField, p: int, pi: FieldElement) -> PrimeIdeal:
    """Return the prime ideal above p with the second generator ``pi``."""
    return next(P for P in _primes_above(field, p) if P.pi == pi)


@lru_cache(maxsize=4096)
def _primes_above(field: NumberField, p: int) -> tuple[PrimeIdeal, ...]:
    return field.known_primes_above(p) or general_primes_above(field, p)


@lru_cache(maxsize=4096)
def general_primes_above(field: NumberField, p: int) -> tuple[PrimeIdeal, ...]:
    """Return the prime ideals above a prime number p by the method that works in every number field."""
    order = local_order(field, p)
    if order.plain:
        return _by_kummer(order)
    from hfield.fields.number_fields.residue_algebra import by_idempotents

    return by_idempotents(order)


def by_other_generators(prime: PrimeIdeal, count: int) -> Iterator[dict[str, object]]:
    """Yield the ideal as data: p and g(θ), where g is the minimal polynomial over GF(p) of an integer θ."""
    field, rng = prime.field, Random(1)
    for _ in range(count):
        theta = prime.order.element(rng.randrange(4 * prime.p) for _ in range(field.degree))
        powers = [prime.residue_of(theta**k) for k in range(prime.f + 1)]
        rows = [coefficients(r) + [0] * (prime.f - len(coefficients(r))) for r in powers]
        entries = [c for row in rows for c in row]
        kernel = left_kernel(flint.nmod_mat(prime.f + 1, prime.f, entries, prime.p))
        g = residues(prime.p, kernel[0])
        if len(kernel) == 1 and g.degree() == prime.f:
            generator = field.coordinates(theta)
            data = {"p": prime.p, "polynomial": coefficients(g), "generator": generator}
            yield {"kind": "other generator", **data}


def _modulo_p(order: LocalOrder) -> flint.nmod_poly:
    """Return the polynomial of s modulo p."""
    polynomial, p = order.field.polynomial, order.p
    scale = pow(int(polynomial.denom()), -1, p)
    return residues(p, [c * scale for c in polynomial.numer().coeffs()])


def _by_kummer(order: LocalOrder) -> tuple[PrimeIdeal, ...]:
    """Return the primes, read off the polynomial of s modulo p."""
    field, p, f = order.field, order.p, _modulo_p(order)
    out = []
    for g, e in sorted_factors(f):
        pi = order.element(coefficients(g))
        if g.degree() == field.degree:  # p is inert
            pi = field(p)
        out.append(
            PrimeIdeal(
                order,
                e,
                int(g.degree()),
                pi,
                order.element(coefficients(f // g)),
                None,
                g,
                field.gen,
            )
        )
    return tuple(out)
