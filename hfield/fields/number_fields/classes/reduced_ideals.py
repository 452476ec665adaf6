"""The classes of a quadratic field by its reduced ideals: all relations between prime ideals, and the unit.

The ideal (a, b) is ℤ·a + ℤ·(b + √D)/2, with a > 0 and b² ≡ D mod 4a. A class has one reduced ideal where
D < 0, and a cycle of them where D > 0; the step to the next ideal multiplies by (−b + √D)/(2a), and once
around the principal cycle the product of the steps is a fundamental unit. The classes that some primes
generate are enumerated, so that relations are found without a search (H. Cohen, *A Course in
Computational Algebraic Number Theory*, sections 5.4 to 5.8).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import flint

from hfield.errors import TooLargeError, shorten
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import Ideal, Integers

MAX_REDUCED = 2_000_000
"""So many reduced ideals are enumerated at most."""

Form = tuple[int, int]


class ReducedIdeals:
    """The classes that prime ideals P₁, P₂, … of a quadratic field generate, one after the other.

    ``relations`` are pairs (x, e) with (x) = P₁^e₁·P₂^e₂·…: all such x are products of these, the
    :attr:`unit` and roots of unity.
    """

    def __init__(self, frame: Integers, primes: Sequence[Ideal]) -> None:
        self.frame, self.field = frame, frame.field
        self.D = int(self.field.discriminant())
        self._floor = math.isqrt(self.D) if self.D > 0 else 0
        f = self.field.polynomial
        scale = flint.fmpq(f[1] ** 2 - 4 * f[0]) / self.D
        unscaled = self.field.gen * 2 + f[1]
        self._root = unscaled / flint.fmpq(math.isqrt(int(scale.p)), math.isqrt(int(scale.q)))
        self._vectors: list[tuple[int, ...]] = [()]
        self._first: list[tuple[Form, FieldElement]] = []
        self._place: dict[Form, tuple[int, int]] = {}  # number of the class, place in its cycle
        principal, _ = self._reduced((1, self.D % 2))
        self._add_class(principal, self.field.one)
        self.relations: list[tuple[FieldElement, list[int]]] = []
        for P in primes:
            self._adjoin(self._form(P)[0])

    @property
    def unit(self) -> FieldElement | None:
        """The fundamental unit > 1 of a real field; None for an imaginary one."""
        if self.D < 0:
            return None
        start = self._first[0][0]
        return self._product([self._step(form) for form in self._cycle(start)]).inverse()

    def class_of(self, a: Ideal) -> tuple[FieldElement, list[int]] | None:
        """Return (x, e) with a = x·∏Pᵉ, or None where the primes do not generate the class of a."""
        form, scale = self._form(a)
        reduced, x = self._reduced(form)
        found = self._located(reduced)
        if found is None:
            return None
        n, y = found
        # reduced = x·form = y·∏Pᵉ
        return y / x * flint.fmpq(scale[0], scale[1]), list(self._vectors[n])

    # --- the group ---------------------------------------------------------------------------------

    def _adjoin(self, P: Form) -> None:
        """Take a prime into the group, with the relation of its first power that lies in the group before."""
        before = len(self._first)
        power, x, j = *self._reduced(P), 1
        while (found := self._located(power)) is None:
            for n in range(before):
                form, y = self._first[n]
                product, z = self._times(form, power)
                self._vectors.append((*self._vectors[n], j))
                self._add_class(product, x * y * z)
            power, z = self._times(power, P)
            x, j = x * z, j + 1
        n, y = found
        others = [-e for e in self._vectors[n]]
        self.relations.append((y / x, [*others, *[0] * (len(self.relations) - len(others)), j]))
        self._vectors = [v if len(v) == len(self.relations) else (*v, 0) for v in self._vectors]

    def _add_class(self, form: Form, x: FieldElement) -> None:
        """Add the class of a reduced ideal, which is x times the product of primes."""
        number = len(self._first)
        self._first.append((form, x))
        for place, reduced in enumerate(self._cycle(form)):
            self._place[reduced] = number, place
        if len(self._place) > MAX_REDUCED:
            raise TooLargeError(
                f"{shorten(self.frame.ring.name)} has over {MAX_REDUCED} reduced ideals, "
                "the most that are enumerated: the discriminant is too large"
            )

    def _located(self, form: Form) -> tuple[int, FieldElement] | None:
        """Return the number of the class of a reduced ideal, and y with form = y·∏Pᵉ."""
        if form not in self._place:
            return None
        number, place = self._place[form]
        start, x = self._first[number]
        steps = [self._step(f) for f, _ in zip(self._cycle(start), range(place), strict=False)]
        return number, self._product([*steps, x])

    def _product(self, factors: list[FieldElement]) -> FieldElement:
        """Return a product, of factors of about the same size at each turn."""
        while len(factors) > 1:
            pairs = [x * y for x, y in zip(factors[::2], factors[1::2], strict=False)]
            factors = pairs + factors[len(factors) & ~1 :]
        return factors[0]

    # --- ideals as pairs ---------------------------------------------------------------------------

    def _form(self, a: Ideal) -> tuple[Form, tuple[int, int]]:
        """Return (a, b) and a rational m with the ideal m·(a, b)."""
        half = self._root / 2
        s = half.poly[1]
        rows = []
        for x in a.elements:
            y = x.poly[1] / s
            rows += [y, (x - half * y).poly[0] * 2]
        whole, den = flint.fmpq_mat(2, 2, rows).numer_denom()
        (m, b), (_, n) = ([int(c) for c in row] for row in whole.hnf().tolist())
        return self._normal(n // (2 * m), b // m), (m, int(den))

    def _normal(self, a: int, b: int) -> Form:
        """Return the same ideal with b in the interval that belongs to a."""
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

    def _reduced(self, form: Form) -> tuple[Form, FieldElement]:
        """Return a reduced ideal and x with which it is x·form."""
        form = self._normal(*form)
        steps = [self.field.one]
        while not self._is_reduced(form):
            steps.append(self._step(form))
            form = self._next(form)
        return form, self._product(steps)

    def _cycle(self, start: Form) -> Iterator[Form]:
        """Yield the reduced ideals of a class from a given one on."""
        yield start
        form = self._next(start)
        while self.D > 0 and form != start:
            yield form
            form = self._next(form)

    def _times(self, one: Form, other: Form) -> tuple[Form, FieldElement]:
        """Return a reduced ideal and x with which it is x·one·other."""
        (a1, b1), (a2, b2) = one, other
        d, v1, v2 = _xgcd(a1, a2)
        g, u, w = _xgcd(d, (b1 + b2) // 2)
        v1, v2 = v1 * u, v2 * u
        a = a1 * a2 // g**2
        b = (v1 * a1 * b2 + v2 * a2 * b1 + w * ((b1 * b2 + self.D) // 2)) // g
        form, x = self._reduced((a, b))
        return form, x * flint.fmpq(1, g)


def _xgcd(a: int, b: int) -> tuple[int, int, int]:
    """Return (g, u, v) with g = u·a + v·b, the greatest common divisor."""
    u, v, s, t = 1, 0, 0, 1
    while b:
        q, (a, b) = a // b, (b, a % b)
        u, v, s, t = s, t, u - q * s, v - q * t
    return (a, u, v) if a > 0 else (-a, -u, -v)
