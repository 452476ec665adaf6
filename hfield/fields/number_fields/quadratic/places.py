"""The places of quadratic number fields ℚ(√d): prime ideals given by the image of √d, and infinite places."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import remove
from hfield.errors import RingError
from hfield.fields.number_fields.places import ComplexPlace, RealPlace
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, general_primes_above

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.integers import LocalOrder
    from hfield.fields.number_fields.quadratic.ring import QuadraticField


class QuadraticPrime(PrimeIdeal):
    """A prime ideal of ℚ(√d) above p. ``root`` is the image of √d if p splits, else None.

    The image is taken modulo p, or modulo 4 for p = 2. The field reads back the text (``"5"`` for an inert
    prime, ``"(7, sqrt(2)-3)"``, ``"(2, sqrt(2))"``). Attributes that other prime ideals compute at
    construction, such as idempotents, are computed here on first use.
    """

    field: QuadraticField

    def __init__(self, field: QuadraticField, p: int, root: int | None = None) -> None:
        self.field, self.p, self.root, self.d = field, p, root, field.d
        ramified = self.d % 4 != 1 if p == 2 else self.d % p == 0
        self.e = 2 if ramified else 1
        self.f = 2 // self.e if root is None else 1

    def __reduce__(self) -> tuple[object, ...]:
        return QuadraticPrime, (self.field, self.p, self.root)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, QuadraticPrime)
            and (self.p, self.root) == (other.p, other.root)
            and self.field == other.field
        )

    def __hash__(self) -> int:
        return hash((self.field, self.p, self.root))

    # --- what is computed on first use -----------------------------------------------------------

    @cached_property
    def _general(self) -> PrimeIdeal:
        """The prime ideal in the form of general number fields."""
        above = general_primes_above(self.field, self.p)
        second = self.generators[1]
        return above[0] if len(above) == 1 else next(P for P in above if not P.residue_of(second))

    @cached_property
    def order(self) -> LocalOrder:  # type: ignore[override]  # given elsewhere, computed here
        """The order of the field that is maximal at p."""
        return self._general.order

    @cached_property
    def pi(self) -> FieldElement:  # type: ignore[override]
        """A number that, together with p, generates the ideal locally at p."""
        return self._general.pi

    @cached_property
    def beta(self) -> FieldElement:  # type: ignore[override]
        """A number β with β·P in p·O."""
        return self._general.beta

    @cached_property
    def idempotent(self) -> FieldElement:
        """A number that is 1 modulo the ideal and 0 at the other prime ideals above p."""
        return self._general.idempotent

    @cached_property
    def residue(self) -> Polynomial:
        """The polynomial over GF(p) that defines the residue field."""
        return self._general.residue

    @cached_property
    def residue_gen(self) -> FieldElement:  # type: ignore[override]
        """An integer whose residue is a root of that polynomial."""
        return self._general.residue_gen

    @cached_property
    def _images(self) -> flint.nmod_mat:
        return self._general._images

    # --- texts and data --------------------------------------------------------------------------

    def __str__(self) -> str:
        if self.f == 2:
            return str(self.p)
        if self.root is not None and self.p > 2:
            return self.short_name
        return f"({self.p}, {self.field.text(self.generators[1])})"

    __repr__ = __str__

    @property
    def short_name(self) -> str:
        """The text used in names of completions: p alone, or with the image of √d if p splits.

        Above 2 the text names only the place: there √d − root generates another ideal.
        """
        gen = self.field.gen_name
        return str(self.p) if self.root is None else f"({self.p}, {gen}-{self.root})"

    @property
    def data(self) -> dict[str, object]:
        """The ideal as JSON data: p, with the root if there are two ideals."""
        if self.root is None:
            return {"kind": "number", "n": self.p}
        return {"kind": "split", "n": self.p, "root": self.root}

    # --- arithmetic ------------------------------------------------------------------------------

    @property
    def generators(self) -> tuple[FieldElement, FieldElement]:
        """Return p and a second number that together generate the ideal."""
        p, root = self.field(self.p), self.field.gen
        if self.f == 2:
            return p, p
        if self.root is None:
            return p, root + self.d % 2 if self.p == 2 else root
        shifted = root - self.root
        return p, shifted * Fraction(1, 2) if self.p == 2 else shifted

    @property
    def root_of_omega(self) -> int:
        """The residue of ω modulo an ideal with residue field ℤ/p."""
        p, d, r = self.p, self.d, self.root or 0
        if p == 2:
            return (r + 1) // 2 % 2 if d % 4 == 1 else d % 2
        return (r + 1) * (p + 1) // 2 % p if d % 4 == 1 else r

    def valuation(self, x: FieldElement | int | Fraction) -> int:
        """Return the valuation of x ≠ 0 at P. Raises :class:`RingError` for 0."""
        p, y = self.p, self.field(x)
        if not y:
            raise RingError("0 has no valuation: it lies in every power of a prime ideal")
        u, v = integer_coordinates(self.d, y)
        k = min(_order(n, p) for n in (u, v) if n)
        u, v = u * Fraction(p) ** -k, v * Fraction(p) ** -k
        if self.root is not None:
            image = v.numerator * u.denominator * self.root_of_omega
            if (u.numerator * v.denominator + image) % p:
                return k
        # y/p^k is no multiple of p, so that its norm has the order of one ideal alone
        norm = u * u + u * v + v * v * Fraction(1 - self.d, 4)
        norm = norm if self.d % 4 == 1 else u * u - self.d * v * v
        return self.e * k + _order(norm, p) // (self.f if self.root is None else 1)

    def __contains__(self, x: object) -> bool:
        y = self.field(x)
        if not y:
            return True
        whole = all(n.denominator == 1 for n in integer_coordinates(self.d, y))
        return whole and self.valuation(y) > 0


class QuadraticRealPlace(RealPlace):
    """A real place of ℚ(√d): "inf+" if √d is positive, "inf-" if it is negative."""

    field: QuadraticField

    @property
    def d(self) -> int:
        """The squarefree integer under the root."""
        return self.field.d

    @property
    def root(self) -> int:
        """The sign of √d."""
        return 1 if self.index else -1

    def __str__(self) -> str:
        return "inf+" if self.index else "inf-"


class QuadraticComplexPlace(ComplexPlace):
    """The infinite place of an imaginary quadratic field, "inf"."""

    @property
    def data(self) -> dict[str, object]:
        """The place as JSON data."""
        return {"kind": "infinity"}


QuadraticPlace = QuadraticPrime | QuadraticRealPlace | QuadraticComplexPlace


def integer_coordinates(d: int, x: FieldElement) -> tuple[Fraction, Fraction]:
    """Return rationals (u, v) with x = u + v·ω, where 1 and ω are the basis of the integers of ℚ(√d)."""
    s, t = (Fraction(int(c.p), int(c.q)) for c in (x.poly[0], x.poly[1]))
    return (s - t, 2 * t) if d % 4 == 1 else (s, t)


def minimal_of_omega(d: int) -> tuple[int, int]:
    """Return (t, n) with ω² = t·ω + n."""
    return (1, (d - 1) // 4) if d % 4 == 1 else (0, d)


def _order(x: Fraction, p: int) -> int:
    return remove(x.numerator, p)[0] - remove(x.denominator, p)[0]


def quadratic_primes_above(field: QuadraticField, p: int) -> tuple[QuadraticPrime, ...]:
    """Return the one or two prime ideals of ℚ(√d) above the prime p, in ascending order of the
    image of √d.
    """
    d = field.d
    roots: list[int | None]
    if p == 2:
        roots = [1, 3] if d % 8 == 1 else [None]
    elif d % p and pow(d, (p - 1) // 2, p) == 1:
        r = int(flint.fmpz(d % p).sqrtmod(p))
        roots = [*sorted((r, p - r))]
    else:
        roots = [None]
    return tuple(QuadraticPrime(field, p, r) for r in roots)
