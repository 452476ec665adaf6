"""The classes of a quadratic field by its reduced ideals: all relations between prime ideals, and the unit.

The ideal (a, b) is ℤ·a + ℤ·(b + √D)/2, with a > 0 and b² ≡ D mod 4a. A class contains one reduced ideal if D
< 0, and a cycle of them if D > 0. The step to the next ideal multiplies by (−b + √D)/(2a), and the product of
the steps once around the principal cycle is a fundamental unit. The classes that some primes generate are
enumerated, so that relations are found without a search (H. Cohen, *A Course in Computational Algebraic
Number Theory*, sections 5.4 to 5.8).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property

import flint

from hfield.errors import TooLargeError, shorten
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import FractionalIdeal, MaximalOrder

MAX_REDUCED = 2_000_000
"""So many reduced ideals are enumerated at most."""

Form = tuple[int, int]


class ReducedIdeals:
    """The subgroup of the class group of a quadratic field that prime ideals P₁, P₂, … generate.

    ``rows`` contains the exponents of :attr:`relations`. All x that generate a product of powers of the Pᵢ
    are products of these relations, powers of the :attr:`unit` and roots of unity. Numbers are computed when
    they are needed, because they may be long.
    """

    def __init__(self, frame: MaximalOrder) -> None:
        self.frame, self.field = frame, frame.field
        self.D = int(self.field.discriminant())
        self._floor = math.isqrt(self.D) if self.D > 0 else 0
        f = self.field.polynomial
        scale = flint.fmpq(f[1] ** 2 - 4 * f[0]) / self.D
        unscaled = self.field.gen * 2 + f[1]
        self._root = unscaled / flint.fmpq(math.isqrt(int(scale.p)), math.isqrt(int(scale.q)))
        # each prime as it is given, and the reduced ideals of its powers
        self._primes: list[list[Form]] = []
        self._power_elements: list[list[FieldElement]] = []
        self._starts: list[Form] = []  # a reduced ideal of each class
        self._origins: list[tuple[int, int]] = []  # of each class: an earlier one, times a power
        self._vectors: list[tuple[int, ...]] = []
        self._place: dict[Form, tuple[int, int]] = {}  # number of the class, place in its cycle
        self._add_class(self._path((1, self.D % 2))[-1], (0, 0), ())
        self.rows: list[list[int]] = []

    def __contains__(self, a: FractionalIdeal) -> bool:
        """Return whether the class of an ideal is in the subgroup."""
        return self._path(self._form(a)[0])[-1] in self._place

    @cached_property
    def relations(self) -> list[tuple[FieldElement, list[int]]]:
        """Pairs (x, e) with (x) = P₁^e₁·P₂^e₂·…, one for each prime."""
        found = []
        for m, row in enumerate(self.rows):
            _, y = self._located(self._primes[m][-1])
            found.append((y / self._element_of_power(m, len(self._primes[m]) - 1), row))
        return found

    @property
    def unit(self) -> FieldElement | None:
        """The fundamental unit > 1 of a real field; None for an imaginary one."""
        if self.D < 0:
            return None
        start = self._starts[0]
        return self._product([self._step(form) for form in self._cycle(start)]).inverse()

    def class_of(self, a: FractionalIdeal) -> tuple[FieldElement, list[int]] | None:
        """Return (x, e) with a = x·∏Pᵉ, or None if the primes do not generate the class of a."""
        form, scale = self._form(a)
        reduced, x = self._reduced(form)
        if reduced not in self._place:
            return None
        n, y = self._located(reduced)
        # reduced = x·form = y·∏Pᵉ
        vector = self._vectors[n]
        exponents = [*vector, *[0] * (len(self.rows) - len(vector))]
        return y / x * flint.fmpq(scale[0], scale[1]), exponents

    # --- the group ---------------------------------------------------------------------------------

    def adjoin(self, a: FractionalIdeal) -> None:
        """Add a prime to the generators, with the relation for its first power that lies in the subgroup."""
        P = self._form(a)[0]
        before, count = len(self._starts), len(self.rows)
        powers = [P, self._path(P)[-1]]
        self._primes.append(powers)
        self._power_elements.append([])
        while powers[-1] not in self._place:
            j = len(powers) - 1
            for n in range(before):
                vector = self._vectors[n]
                whole = (*vector, *[0] * (count - len(vector)), j)
                self._add_class(self._times(self._starts[n], powers[-1]), (n, j), whole)
            powers.append(self._times(powers[-1], P))
        number, _ = self._place[powers[-1]]
        vector = self._vectors[number]
        others = [*(-e for e in vector), *[0] * (count - len(vector))]
        self.rows = [[*row, 0] for row in self.rows] + [[*others, len(powers) - 1]]

    def _add_class(self, start: Form, origin: tuple[int, int], vector: tuple[int, ...]) -> None:
        """Add the class of a reduced ideal, which equals a product of primes up to a number."""
        number = len(self._starts)
        self._starts.append(start)
        self._origins.append(origin)
        self._vectors.append(vector)
        for place, reduced in enumerate(self._cycle(start)):
            self._place[reduced] = number, place
        if len(self._place) > MAX_REDUCED:
            raise TooLargeError(
                f"{shorten(self.frame.field.name)} has over {MAX_REDUCED} reduced ideals, "
                "the most that are enumerated: the discriminant is too large"
            )

    def _located(self, form: Form) -> tuple[int, FieldElement]:
        """Return the number of the class of a reduced ideal, and y with form = y·∏Pᵉ."""
        number, place = self._place[form]
        cycle = self._cycle(self._starts[number])
        steps = [self._step(f) for f, _ in zip(cycle, range(place), strict=False)]
        return number, self._product([self._element_of_class(number), *steps])

    def _element_of_class(self, number: int) -> FieldElement:
        """Return x such that the first reduced ideal of a class is x·∏Pᵉ."""
        factors = [self.field.one]
        while number:
            n, j = self._origins[number]
            m = len(self._vectors[number]) - 1
            factors.append(self._factor(self._starts[n], self._primes[m][j]))
            factors.append(self._element_of_power(m, j))
            number = n
        return self._product(factors)

    def _element_of_power(self, m: int, j: int) -> FieldElement:
        """Return x such that the reduced ideal of the j-th power of a prime P is x·Pʲ."""
        (P, *reduced), found = self._primes[m], self._power_elements[m]
        if not found:
            found.append(self._reduced(P)[1])
        for power in reduced[len(found) - 1 : j - 1]:
            found.append(found[-1] * self._factor(power, P))
        return found[j - 1]

    def _product(self, factors: list[FieldElement]) -> FieldElement:
        """Return a product, multiplying factors of about the same size at each step."""
        while len(factors) > 1:
            pairs = [x * y for x, y in zip(factors[::2], factors[1::2], strict=False)]
            factors = pairs + factors[len(factors) & ~1 :]
        return factors[0]

    # --- ideals as pairs ---------------------------------------------------------------------------

    def _form(self, a: FractionalIdeal) -> tuple[Form, tuple[int, int]]:
        """Return (a, b) and a rational m with the ideal m·(a, b)."""
        half = self._root / 2
        s = half.poly[1]
        rows = []
        for x in a.basis:
            y = x.poly[1] / s
            rows += [y, (x - half * y).poly[0] * 2]
        whole, den = flint.fmpq_mat(2, 2, rows).numer_denom()
        (m, b), (_, n) = ([int(c) for c in row] for row in whole.hnf().tolist())
        return self._normal(n // (2 * m), b // m), (m, int(den))

    def _normal(self, a: int, b: int) -> Form:
        """Return the same ideal with b in the normal interval for a."""
        top = self._floor if self.D > 0 and a <= self._floor else a
        return a, top - (top - b) % (2 * a)

    def _step(self, form: Form) -> FieldElement:
        a, b = form
        return FieldElement(self.field, (self._root.poly - b) / (2 * a))

    def _next(self, form: Form) -> Form:
        """Return an ideal times :meth:`_step`."""
        a, b = form
        return self._normal(abs(self.D - b * b) // (4 * a), -b)

    def _is_reduced(self, form: Form) -> bool:
        a, b = form
        if self.D > 0:
            return 0 < b <= self._floor and (2 * a <= self._floor or 2 * a - self._floor <= b)
        c = (b * b - self.D) // (4 * a)
        return a < c or (a == c and b >= 0)

    def _path(self, form: Form) -> list[Form]:
        """Return the steps from an ideal to a reduced one, which is the last."""
        steps = [self._normal(*form)]
        while not self._is_reduced(steps[-1]):
            steps.append(self._next(steps[-1]))
        return steps

    def _reduced(self, form: Form) -> tuple[Form, FieldElement]:
        """Return a reduced ideal and x such that it is x·form."""
        *steps, reduced = self._path(form)
        return reduced, self._product([self.field.one, *map(self._step, steps)])

    def _cycle(self, start: Form) -> Iterator[Form]:
        """Yield the reduced ideals of a class, starting from a given one."""
        yield start
        form = self._next(start)
        while self.D > 0 and form != start:
            yield form
            form = self._next(form)

    def _times(self, one: Form, other: Form) -> Form:
        """Return the reduced ideal of a product."""
        return self._path(self._composed(one, other)[0])[-1]

    def _factor(self, one: Form, other: Form) -> FieldElement:
        """Return x such that the reduced ideal of a product is x·one·other."""
        form, g = self._composed(one, other)
        x: FieldElement = self._reduced(form)[1] * flint.fmpq(1, g)
        return x

    def _composed(self, one: Form, other: Form) -> tuple[Form, int]:
        """Return an ideal and an integer g with one·other = g·(a, b)."""
        (a1, b1), (a2, b2) = one, other
        d, v1, v2 = _xgcd(a1, a2)
        g, u, w = _xgcd(d, (b1 + b2) // 2)
        v1, v2 = v1 * u, v2 * u
        a = a1 * a2 // g**2
        b = (v1 * a1 * b2 + v2 * a2 * b1 + w * ((b1 * b2 + self.D) // 2)) // g
        return (a, b), g


def _xgcd(a: int, b: int) -> tuple[int, int, int]:
    """Return (g, u, v) with g = u·a + v·b the greatest common divisor."""
    u, v, s, t = 1, 0, 0, 1
    while b:
        q, (a, b) = a // b, (b, a % b)
        u, v, s, t = s, t, u - q * s, v - q * t
    return (a, u, v) if a > 0 else (-a, -u, -v)
