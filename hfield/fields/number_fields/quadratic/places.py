"""The places of quadratic number fields ℚ(√d): prime ideals and infinite places, listed and read."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import flint

from hfield.core.factorisation import remove
from hfield.core.primality import is_prime, primes
from hfield.errors import RingError, UndecidedError
from hfield.rings.closed_fields.surds import Surd, as_surd, from_rational

if TYPE_CHECKING:
    from hfield.fields.number_fields.quadratic.ring import QuadraticField


@dataclass(frozen=True)
class QuadraticPlace:
    """A place of a field ℚ(√d): the prime p it lies over (0 for an infinite place) and where √d goes.

    ``root`` is the image of √d modulo p (modulo 4 for p = 2) where p splits, ±1 at the two real
    places, and None where there is one place above p. The text (``"5"`` for an inert prime,
    ``"(7, sqrt(2)-3)"``, ``"(2, sqrt(2))"``, ``"inf+"``, ``"inf-"``, ``"inf"``) is read back by
    :func:`place_of_quadratic`; a finite one also as that ideal by ``ideal`` of the field.
    """

    field: QuadraticField
    prime: int
    root: int | None = None

    def __str__(self) -> str:
        if self.prime:
            if self.f == 2:
                return str(self.prime)
            if self.root is not None and self.prime > 2:
                return self.short_name
            return f"({self.prime}, {self.field.text(self.generators[1])})"
        return {None: "inf", 1: "inf+", -1: "inf-"}[self.root]

    @property
    def short_name(self) -> str:
        """The text of a finite place in names of completions: p, or with the image of √d where p splits.

        Above 2 it names the place only: √d − root generates another ideal there.
        """
        gen = self.field.gen_name
        return str(self.prime) if self.root is None else f"({self.prime}, {gen}-{self.root})"

    def __repr__(self) -> str:
        return str(self)

    @property
    def data(self) -> dict[str, Any]:
        """The place as JSON data: its number, with the root where there are two."""
        if not self.prime:
            return {"kind": "real", "number": self.index} if self.root else {"kind": "infinity"}
        if self.root is None:
            return {"kind": "number", "n": self.prime}
        return {"kind": "split", "n": self.prime, "root": self.root}

    @property
    def d(self) -> int:
        """The squarefree integer under the root."""
        return self.field.d

    # --- an infinite place -----------------------------------------------------------------------

    @property
    def is_finite(self) -> bool:
        """Whether this is a prime ideal."""
        return self.prime > 0

    @property
    def index(self) -> int:
        """The number of an infinite place, by the image of √d, ascending from 0."""
        if self.prime:
            raise UndecidedError(f"{self} is a prime ideal, and has no number")
        return 1 if self.root == 1 else 0

    def sign(self, x: Surd) -> int:
        """Return the sign of x at a real place."""
        if self.prime or self.root is None:
            raise UndecidedError(f"{self} is not a real place: nothing has a sign there")
        return x.sign(self.d if self.root < 0 else 0)

    # --- a prime ideal P above p -----------------------------------------------------------------

    @property
    def p(self) -> int:
        """The prime number below the ideal."""
        return self._at_prime().prime

    @property
    def e(self) -> int:
        """The ramification index."""
        p = self._at_prime().prime
        return 2 if (self.d % 4 != 1 if p == 2 else self.d % p == 0) else 1

    @property
    def f(self) -> int:
        """The degree of the residue field over GF(p)."""
        return 2 // self.e if self.root is None else 1

    def norm(self) -> int:
        """Return the number of residues, p^f."""
        return int(self.p**self.f)

    @property
    def generators(self) -> tuple[Surd, Surd]:
        """Return p and a second number that generate the ideal."""
        p, root = from_rational(self.p), Surd({self.d: flint.fmpq(1)})
        if self.f == 2:
            return p, p
        if self.root is None:
            return p, root + self.d % 2 if self.prime == 2 else root
        shifted = root - self.root
        return p, shifted * Fraction(1, 2) if self.prime == 2 else shifted

    @property
    def root_of_omega(self) -> int:
        """Where ω goes modulo an ideal whose residue field has p elements."""
        p, d, r = self.p, self.d, self.root or 0
        if p == 2:
            return (r + 1) // 2 % 2 if d % 4 == 1 else d % 2
        return (r + 1) * (p + 1) // 2 % p if d % 4 == 1 else r

    def valuation(self, x: Surd | int | Fraction) -> int:
        """Return the order of x ≠ 0 at P. Raises :class:`RingError` for 0."""
        p, y = self.p, as_surd(x)
        if y is None or not y.terms:
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

    def __contains__(self, x: Surd | int | Fraction) -> bool:
        y = as_surd(x)
        if y is None or not y.terms:
            return y is not None
        whole = all(n.denominator == 1 for n in integer_coordinates(self.d, y))
        return whole and self.valuation(y) > 0

    def _at_prime(self) -> QuadraticPlace:
        if not self.prime:
            raise UndecidedError(f"{self} is an infinite place, and lies above no prime")
        return self


def integer_coordinates(d: int, x: Surd) -> tuple[Fraction, Fraction]:
    """Return rationals (u, v) with x = u + v·ω, where 1 and ω are the basis of the integers of ℚ(√d)."""
    s, t = (Fraction(int(c.p), int(c.q)) for c in (x.terms.get(n, flint.fmpq(0)) for n in (1, d)))
    return (s - t, 2 * t) if d % 4 == 1 else (s, t)


def minimal_of_omega(d: int) -> tuple[int, int]:
    """Return (t, n) with ω² = t·ω + n."""
    return (1, (d - 1) // 4) if d % 4 == 1 else (0, d)


def integers_basis(d: int) -> tuple[Surd, Surd]:
    """Return 1 and ω, a basis of the integers: (1 + √d)/2 where d ≡ 1 mod 4, and √d elsewhere."""
    root = Surd({d: flint.fmpq(1)})
    return from_rational(1), (root + 1) * Fraction(1, 2) if d % 4 == 1 else root


def _order(x: Fraction, p: int) -> int:
    return remove(x.numerator, p)[0] - remove(x.denominator, p)[0]


def places_above(field: QuadraticField, p: int) -> tuple[QuadraticPlace, ...]:
    """Return the one or two places of ℚ(√d) above the prime p, or above infinity for p = 0."""
    d = field.d
    roots: list[int | None]
    if p == 0:
        roots = [1, -1] if d > 0 else [None]
    elif p == 2:
        roots = [1, 3] if d % 8 == 1 else [None]
    elif d % p and pow(d, (p - 1) // 2, p) == 1:
        r = int(flint.fmpz(d % p).sqrtmod(p))
        roots = [*sorted((r, p - r))]
    else:
        roots = [None]
    return tuple(QuadraticPlace(field, p, r) for r in roots)


def all_places(field: QuadraticField) -> Iterator[QuadraticPlace]:
    """Run through the places of ℚ(√d): the infinite ones, then prime by prime, without end."""
    yield from places_above(field, 0)
    for p in primes():
        yield from places_above(field, p)


def place_of_quadratic(field: QuadraticField, place: object) -> QuadraticPlace:
    """Read a place: a :class:`QuadraticPlace`, its text, or a prime with a single place above it."""
    if isinstance(place, QuadraticPlace) and place.field == field:
        return place
    text = str(place).replace(" ", "")
    head = text.lstrip("(").split(",")[0]
    p = 0 if text.startswith("inf") else int(head) if head.isdecimal() else -1
    if p == 0 or is_prime(p):
        above = places_above(field, p)
        for v in above:
            names = (str(v), v.short_name) if p else (str(v),)
            if text in (name.replace(" ", "") for name in names):
                return v
        listed = ", ".join(f'"{v}"' for v in above)
        raise RingError(f"{place!r} names no single place of {field}: above it lie {listed}")
    raise RingError(
        f'{place!r} is not a place of {field}: expected "inf", a prime, or the text of a place'
    )
