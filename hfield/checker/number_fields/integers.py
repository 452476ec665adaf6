"""The integers of a number field by an integral basis, proved maximal; prime ideals and valuations.

An integer is a row of coordinates in the basis. Modulo p the integers form an algebra over 𝔽_p, whose radical
is the kernel of a high power of Frobenius. A prime ideal P above p is an ideal of this algebra whose quotient
is a field. The list of prime ideals is complete if the degrees of these fields add up to the dimension modulo
the radical.
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import gcd, lcm

from hfield.checker.budget import spend, spend_products
from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.matrices import determinant, rational_rows, times, unit
from hfield.checker.number_fields.modular import (
    Vector,
    echelon,
    kernel,
    pivot,
    remainder,
)
from hfield.checker.rejection import a_list, an_integer, reject
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.matrices import inverse_matrix
from hfield.checker.scalars.number_fields import Element, NumberField
from hfield.checker.scalars.quadratic import Quadratic
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.statement import Setting

MAX_DEGREE = 12
"""The largest degree."""


class RingOfIntegers:
    """The span over ℤ of some elements, proved to be the ring of integers of the field."""

    def __init__(self, field: NumberField, rows: list[list[Fraction]]) -> None:
        self.field, self.n = field, field.degree
        n = self.n
        if n > MAX_DEGREE:
            reject(f"integers are checked up to the degree {MAX_DEGREE}")
        back = inverse_matrix(rows)
        if back is None:
            reject("the integral basis is dependent")
        self.rows = rows
        self._below, self._back = rational_rows(back)
        self.table = [
            [self._integral(field.mul(tuple(x), tuple(y)), "a product") for y in rows] for x in rows
        ]
        self.one = self._integral(field.one, "1")
        self.discriminant = determinant(self._trace_form)
        for p, e in factored(abs(self.discriminant)).items():
            if e > 1 and not self._is_maximal_at(p):
                reject(f"the integral basis does not span all integers at {p}")

    zero = 0

    def coordinates(self, x: Sequence[Fraction]) -> tuple[int, Vector]:
        """Return an element as coordinates over a denominator, in lowest terms."""
        spend(self.n**2)
        den = lcm(*[c.denominator for c in x])
        (row,) = times([[c.numerator * (den // c.denominator) for c in x]], self._back)
        den *= self._below
        common = gcd(den, *row)
        return den // common, tuple([c // common for c in row])

    def number(self, coordinates: Sequence[Fraction]) -> Element:
        """Return a number of the field by its coordinates."""
        spend(self.n**2)
        columns = zip(*self.rows, strict=True)
        return tuple(
            sum((a * c for a, c in zip(coordinates, column, strict=True)), Fraction(0))
            for column in columns
        )

    def _integral(self, x: Sequence[Fraction], what: str) -> Vector:
        den, row = self.coordinates(x)
        if den != 1:
            reject(f"the integral basis spans no ring: {what} is not in it")
        return row

    def mul(self, x: Sequence[int], y: Sequence[int]) -> Vector:
        """Return a product."""
        spend(self.n**2)
        spend_products(x, y)
        out = [0] * self.n
        for a, rows in zip(x, self.table, strict=True):
            if a:
                for b, row in zip(y, rows, strict=True):
                    if b:
                        for k, c in enumerate(row):
                            out[k] += a * b * c
        return tuple(out)

    @cached_property
    def _flat(self) -> list[Vector]:
        return [tuple(c for row in rows for c in row) for rows in self.table]

    def matrix(self, x: Sequence[int]) -> list[Vector]:
        """Return the matrix that takes a row y to x·y."""
        n = self.n
        spend(n**3 // 2)
        (entries,) = times([x], self._flat)
        return [entries[m : m + n] for m in range(0, n * n, n)]

    def trace(self, x: Sequence[int]) -> int:
        """Return the trace down to ℚ."""
        return sum(row[k] for k, row in enumerate(self.matrix(x)))

    @cached_property
    def _trace_form(self) -> list[Vector]:
        return [tuple(self.trace(row) for row in rows) for rows in self.table]

    def traces(self, x: Sequence[int]) -> Vector:
        """Return Tr(w·x) for the elements w of the basis."""
        return times([x], self._trace_form)[0]

    def norm(self, x: Sequence[int]) -> int:
        """Return the norm down to ℚ."""
        return determinant(self.matrix(x))

    # --- modulo a prime number -----------------------------------------------------------------------

    def power_modulo(self, x: Sequence[int], e: int, p: int) -> Vector:
        """Return a power modulo p."""
        if self.n == 1:
            return (pow(x[0], e, p),)
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
        """Return the nilpotent elements modulo p: those whose p^k-th power is 0, where p^k ≥ n."""
        size = p
        while size < self.n:
            size *= p
        return echelon(
            kernel([self.power_modulo(unit(self.n, m), size, p) for m in range(self.n)], p), p
        )

    def _is_maximal_at(self, p: int) -> bool:
        """Return whether O is the multiplier ring of its p-radical (criterion of Pohst and Zassenhaus)."""
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
        """Return the prime ideals (p, α) for these α, proved to be prime, distinct, and all those above p."""
        if not is_prime(p):
            reject(f"{p} is not a prime number")
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
        """Return the ideal generated by an element modulo p."""
        return echelon(self.matrix(x), p)


@dataclass(frozen=True)
class Prime:
    """A prime ideal above p, given by its elements modulo p as a space in echelon form."""

    integers: RingOfIntegers = field(repr=False, compare=False)
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
        """Reject unless the quotient is a field: Frobenius is injective on it and fixes only 𝔽_p."""
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
        """An integer β outside p·O with β·P in p·O: β/p has valuation −1 at P, and no other pole."""
        ring, p = self.integers, self.p
        if not self.span:
            return ring.one
        images = [
            [c for row in self.span for c in ring.mul(unit(ring.n, m), row)] for m in range(ring.n)
        ]
        return kernel(images, p)[0]

    def valuation(self, x: Sequence[int]) -> int:
        """Return the exponent of this prime ideal in a nonzero integer."""
        found, y = 0, tuple(x)
        while True:
            y = self.integers.mul(y, self._beta)
            if any(c % self.p for c in y):
                return found
            y, found = tuple(c // self.p for c in y), found + 1


class Factors:
    """All prime ideals above some prime numbers, and the exponents of elements at them."""

    def __init__(self, integers: RingOfIntegers, data: object) -> None:
        """Read ``[[p, [α, …]], …]``, with α as coordinates in the integral basis."""
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

    def at(self, p: int) -> list[Prime]:
        """Return the prime ideals above a prime number, which must be given."""
        if p not in self.above:
            reject(f"the prime ideals above {p} are missing")
        return [self.primes[k] for k in self.above[p]]

    def exponents(self, x: Sequence[Fraction]) -> dict[int, int]:
        """Return the exponents of a nonzero element; all its primes must be among these."""
        den, row = self.integers.coordinates(x)
        if not any(row):
            reject("0 has no prime ideals")
        size = abs(self.integers.norm(row))
        found: dict[int, int] = {}
        rests = [size, den]
        for p, places in self.above.items():
            spend(1 + size.bit_length() // 64)
            if rests[0] % p and rests[1] % p:
                continue
            below = 0
            while rests[0] % p == 0:
                spend(1 + size.bit_length() // 64)
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


def field_of(setting: Setting) -> NumberField:
    """Return the field of a statement as ℚ[s]/(f)."""
    ring = setting.field
    if isinstance(ring, Quadratic):
        f = [Fraction(-ring.d), Fraction(0), Fraction(1)]
        return NumberField(ring.name, f, ("name", "s"), "s", proved=True)
    if not isinstance(ring, NumberField):
        reject(
            "class groups and units are checked of fields QQ[s]/(f), quadratic and cyclotomic ones"
        )
    return ring


def coefficients(ring: AnyRing, x: Hashable) -> Element:
    """Return the coefficients of 1, s, s², … in an element; over ℚ the element alone."""
    return ring.coefficients(x)


def integer_row(value: object, n: int) -> Vector:
    """Read a row of n integers."""
    row = tuple(an_integer(x, "a coordinate") for x in a_list(value, "a row"))
    if len(row) != n:
        reject(f"a row has {n} coordinates")
    return row


RATIONAL_FIELD = NumberField("QQ", [Fraction(-1), Fraction(1)], ("name", "s"), "s", proved=True)
RATIONAL_INTEGERS = RingOfIntegers(RATIONAL_FIELD, [[Fraction(1)]])
"""ℤ, the integers of the field of degree 1."""


class RationalPrimes:
    """The prime ideals of ℤ; the evidence need not list them."""

    def at(self, p: int) -> list[Prime]:
        """Return the ideal that a prime number generates."""
        return [Prime(RATIONAL_INTEGERS, p, [])]


Primes = Factors | RationalPrimes
