"""The integers of a number field by an integral basis, shown to be maximal; prime ideals and valuations.

An integer is a row of coordinates in the basis. Modulo p the integers are an algebra over 𝔽_p, whose radical
is where a high power of Frobenius is 0; a prime ideal P above p is an ideal of that algebra with a field for
quotient, and all are listed where the degrees of these fields have the dimension modulo the radical for sum.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import lcm

from hfield.certificates.number_fields.factoring import factored
from hfield.certificates.number_fields.matrices import determinant, unit
from hfield.certificates.number_fields.modular import (
    Vector,
    echelon,
    kernel,
    pivot,
    remainder,
)
from hfield.certificates.rejection import a_list, an_integer, reject
from hfield.certificates.scalars.finite import is_prime
from hfield.certificates.scalars.matrices import inverse_matrix
from hfield.certificates.scalars.number_fields import NumberField
from hfield.certificates.work import charge, charge_products

MOST = 12
"""The largest degree."""


class Integers:
    """The span over ℤ of some elements, seen to be the ring of all integers of the field."""

    def __init__(self, field: NumberField, rows: list[list[Fraction]]) -> None:
        self.field, self.n = field, field.degree
        n = self.n
        if n > MOST:
            reject(f"integers are checked up to the degree {MOST}")
        back = inverse_matrix(rows)
        if back is None:
            reject("the integral basis is dependent")
        self.rows, self._back = rows, back
        self.table = [
            [self._integral(field.mul(tuple(x), tuple(y)), "a product") for y in rows] for x in rows
        ]
        self.one = self._integral(field.one, "1")
        self.discriminant = determinant(
            [[self.trace(self.table[k][m]) for m in range(n)] for k in range(n)]
        )
        for p, e in factored(abs(self.discriminant)).items():
            if e > 1 and not self._is_maximal_at(p):
                reject(f"the integral basis does not span all integers at {p}")

    def coordinates(self, x: Sequence[Fraction]) -> tuple[int, Vector]:
        """Return an element as coordinates over a denominator, in lowest terms."""
        charge(self.n**2)
        found = [
            sum((c * row[k] for c, row in zip(x, self._back, strict=True)), Fraction(0))
            for k in range(self.n)
        ]
        den = lcm(*(c.denominator for c in found))
        return den, tuple(int(c * den) for c in found)

    def _integral(self, x: Sequence[Fraction], what: str) -> Vector:
        den, row = self.coordinates(x)
        if den != 1:
            reject(f"the integral basis spans no ring: {what} is not in it")
        return row

    def mul(self, x: Sequence[int], y: Sequence[int]) -> Vector:
        """Return a product."""
        charge(self.n**2)
        charge_products(x, y)
        out = [0] * self.n
        for a, rows in zip(x, self.table, strict=True):
            if a:
                for b, row in zip(y, rows, strict=True):
                    if b:
                        for k, c in enumerate(row):
                            out[k] += a * b * c
        return tuple(out)

    def matrix(self, x: Sequence[int]) -> list[list[int]]:
        """Return the matrix that takes a row y to x·y."""
        charge(self.n**3 // 2)
        return [
            [
                sum(a * row[m][k] for a, row in zip(x, self.table, strict=True))
                for k in range(self.n)
            ]
            for m in range(self.n)
        ]

    def trace(self, x: Sequence[int]) -> int:
        """Return the trace down to ℚ."""
        return sum(row[k] for k, row in enumerate(self.matrix(x)))

    def norm(self, x: Sequence[int]) -> int:
        """Return the norm down to ℚ."""
        return determinant(self.matrix(x))

    # --- modulo a prime number -----------------------------------------------------------------------

    def power_modulo(self, x: Sequence[int], e: int, p: int) -> Vector:
        """Return a power modulo p."""
        out: Vector = tuple(c % p for c in self.one)
        base: Vector = tuple(c % p for c in x)
        while e:
            if e & 1:
                out = tuple(c % p for c in self.mul(out, base))
            e >>= 1
            if e:
                base = tuple(c % p for c in self.mul(base, base))
        return out

    def radical(self, p: int) -> list[Vector]:
        """Return the nilpotent elements modulo p: those that p^k-th powers with p^k ≥ n make 0."""
        size = p
        while size < self.n:
            size *= p
        return echelon(
            kernel([self.power_modulo(unit(self.n, m), size, p) for m in range(self.n)], p), p
        )

    def _is_maximal_at(self, p: int) -> bool:
        """Tell whether only elements of O map what is nilpotent modulo p into itself (Pohst, Zassenhaus)."""
        n, nilpotent = self.n, self.radical(p)
        pivots = {pivot(row) for row in nilpotent}
        basis = [*nilpotent, *(unit(n, k, p) for k in range(n) if k not in pivots)]
        images = []
        for m in range(n):
            image: list[int] = []
            for b in basis:
                rest = list(self.mul(unit(n, m), b))
                for row in nilpotent:
                    c = rest[pivot(row)]
                    image.append(c)
                    rest = [x - c * y for x, y in zip(rest, row, strict=True)]
                image += [rest[k] // p for k in range(n) if k not in pivots]
            images.append(image)
        return len(echelon(images, p)) == n

    # --- prime ideals --------------------------------------------------------------------------------

    def primes_above(self, p: int, seconds: Sequence[Vector]) -> list["Prime"]:
        """Return the prime ideals (p, α) for these α, seen to be prime, different, and all above p."""
        if not is_prime(p):
            reject(f"{p} is no prime number")
        found = [Prime(self, p, self._span(p, x)) for x in seconds]
        if len({tuple(P.span) for P in found}) < len(found):
            reject(f"a prime ideal above {p} is given twice")
        for P in found:
            P.need_prime()
        reduced = self.n if self.discriminant % p else self.n - len(self.radical(p))
        if sum(P.degree for P in found) != reduced:
            reject(f"these are not all prime ideals above {p}")
        return found

    def _span(self, p: int, x: Vector) -> list[Vector]:
        """Return the ideal that an element generates modulo p."""
        return echelon(self.matrix(x), p)


@dataclass(frozen=True)
class Prime:
    """A prime ideal above p: its elements modulo p, as a space in echelon form."""

    integers: Integers = field(repr=False, compare=False)
    p: int
    span: list[Vector]

    @property
    def degree(self) -> int:
        """The degree of the residue field."""
        return self.integers.n - len(self.span)

    @property
    def norm(self) -> int:
        """The number of residues."""
        return int(self.p**self.degree)

    def need_prime(self) -> None:
        """Reject unless the quotient is a field: Frobenius is injective there, and fixes 𝔽_p alone."""
        ring, p = self.integers, self.p
        pivots = {pivot(row) for row in self.span}
        free = [k for k in range(ring.n) if k not in pivots]
        if not free:
            reject(f"an ideal above {p} is the whole ring")
        if len(free) == 1:
            return
        rows = []
        for k in free:
            image = remainder(ring.power_modulo(unit(ring.n, k), p, p), self.span, p)
            rows.append([image[m] for m in free])
        fixed = [[c - int(k == m) for m, c in enumerate(row)] for k, row in enumerate(rows)]
        if len(echelon(rows, p)) < len(free) or len(echelon(fixed, p)) < len(free) - 1:
            reject(f"an ideal above {p} is not prime")

    @cached_property
    def _beta(self) -> Vector:
        """An integer β outside p·O with β·P in p·O: β/p has the valuation −1 here, and no pole elsewhere."""
        ring, p = self.integers, self.p
        if not self.span:
            return ring.one
        images = [
            [c for row in self.span for c in ring.mul(unit(ring.n, m), row)] for m in range(ring.n)
        ]
        return kernel(images, p)[0]

    def valuation(self, x: Sequence[int]) -> int:
        """Return how often the ideal divides an integer other than 0."""
        found, y = 0, tuple(x)
        while True:
            y = self.integers.mul(y, self._beta)
            if any(c % self.p for c in y):
                return found
            y, found = tuple(c // self.p for c in y), found + 1


class Factors:
    """Prime ideals, all above some prime numbers, and the exponents of elements at them."""

    def __init__(self, integers: Integers, data: object) -> None:
        """Read ``[[p, [α, …]], …]``, the α as coordinates in the integral basis."""
        self.integers = integers
        self.primes: list[Prime] = []
        self.above: dict[int, list[int]] = {}
        for entry in a_list(data, "the primes"):
            pair = a_list(entry, "a prime number with its prime ideals", 2)
            p = an_integer(pair[0], "a prime number", 2)
            if p in self.above or len(pair) != 2:
                reject(f"the prime ideals above {p} are given twice, or with something else")
            rows = [integer_row(x, integers.n) for x in a_list(pair[1], "prime ideals", 1)]
            found = integers.primes_above(p, rows)
            self.above[p] = list(range(len(self.primes), len(self.primes) + len(found)))
            self.primes += found

    def exponents(self, x: Sequence[Fraction]) -> dict[int, int]:
        """Return the exponents of an element other than 0, all of whose primes have to be among these."""
        den, row = self.integers.coordinates(x)
        if not any(row):
            reject("0 has no prime ideals")
        size = abs(self.integers.norm(row))
        found: dict[int, int] = {}
        rests = [size, den]
        for p, places in self.above.items():
            charge(1 + size.bit_length() // 64)
            if rests[0] % p and rests[1] % p:
                continue
            below = 0
            while rests[0] % p == 0:
                charge(1 + size.bit_length() // 64)
                rests[0] //= p
            while rests[1] % p == 0:
                rests[1] //= p
                below += 1
            for k in places:
                P = self.primes[k]
                v = P.valuation(row) - below * P.valuation(tuple(p * c for c in self.integers.one))
                if v:
                    found[k] = v
        if rests != [1, 1]:
            reject("an element has a prime ideal that is not among those given")
        return found


def integer_row(value: object, n: int) -> Vector:
    """Read a row of n integers."""
    row = tuple(an_integer(x, "a coordinate") for x in a_list(value, "a row"))
    if len(row) != n:
        reject(f"a row has {n} coordinates")
    return row
