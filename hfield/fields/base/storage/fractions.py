"""Store elements over ℤ, ℚ and number fields as integers over one denominator, in lowest terms."""

from __future__ import annotations

from collections.abc import Callable
from math import gcd, lcm
from typing import TYPE_CHECKING

import flint

from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import FIRST, named, parts, specialise_extension
from hfield.fields.base.storage.base import S
from hfield.fields.base.storage.common_denominator import CommonDenominatorStorage
from hfield.fields.base.storage.compact import LARGE, function, statements

if TYPE_CHECKING:
    from hfield.fields.base.ring import Ring

Vector = tuple[flint.fmpz | flint.fmpq, ...]
Integers = tuple[int | flint.fmpz, ...]  # numerators, and the denominator last


class FractionStorage(CommonDenominatorStorage[Integers, S]):
    """Elements over ℚ(s) as ints over one denominator.

    Here ``sⁿ = Σ relation[k]·sᵏ`` with integers; for ℚ and ℤ, n = 1 and s = 0.
    """

    inverted = [  # noqa: RUF012
        "if d == 0:",
        "    return None",
        "if d < 0:",
        "    d, d1 = -d, -d1",
        *CommonDenominatorStorage.inverted[2:],
    ]

    def __init__(
        self,
        ring: Ring,
        constants: Constants,
        relation: tuple[int, ...],
        vector: Callable[[S], Vector],
        element: Callable[..., S],
    ) -> None:
        """Store the maps from the ring to vectors, and back.

        The map back is ``element(c₀, …, cₙ₋₁, denominator)``; the denominator is 1 if it is omitted."""
        super().__init__(ring, constants)
        self.degree = len(relation)
        self._vector, self._element = vector, element
        a, t, b = map(vector, constants)
        self._m, self._k = _denominator(a + t), _denominator(b)
        scaled = [c * self._m**2 for c in a], [c * self._m for c in t], [c * self._k**2 for c in b]
        self.is_scaled = self._m != 1 or self._k != 1
        self.integers: dict[str, int] = {}  # the constants in the scaled basis, and the relation
        self.pattern = tuple(
            self._named(name, [int(c.p) for c in values])
            for name, values in zip("atb", scaled, strict=True)
        )
        self.relation, self.whole_relation = self._named("m", list(relation)), relation

    def _named(self, letter: str, values: list[int]) -> tuple[str, ...]:
        """Return integers in the form of the specialiser, and record those that are referred to by name."""
        names = parts(letter, self.degree)
        self.integers |= dict(zip(names, values, strict=True))
        return tuple(named(v, name, int.__eq__) for name, v in zip(names, values, strict=True))

    # --- in and out ----------------------------------------------------------------------------

    def encode(self, coordinates: Coordinates) -> Integers:
        """Return the element with these coordinates in the field."""
        scales = 1, self._m, self._k, self._m * self._k
        vectors = map(self._vector, coordinates)
        every = [c / s for v, s in zip(vectors, scales, strict=True) for c in v]
        d = lcm(*(int(c.q) for c in every))
        stored = *(int(c.p) * (d // int(c.q)) for c in every), d
        return stored if -LARGE < min(stored) <= max(stored) < LARGE else lowest(*stored)

    def whole(self, w: int, x: int, y: int, z: int) -> Integers:
        """Encode four ints."""
        stored: Integers
        if self.is_scaled:
            stored = super().whole(w, x, y, z)
            return stored
        zeros = (0,) * (self.degree - 1)
        stored = (w, *zeros, x, *zeros, y, *zeros, z, *zeros, 1)
        return stored if -LARGE < min(stored) <= max(stored) < LARGE else lowest(*stored)

    def scalar(self, s: S) -> Integers:
        """Encode s·e for an element s of the field."""
        *numerators, d = self.fraction(s)
        stored = *numerators, *(0,) * (3 * self.degree), d
        return stored if -LARGE < min(stored) <= max(stored) < LARGE else lowest(*stored)

    def coordinates(self, stored: Integers) -> Coordinates:
        """Return the four coordinates, elements of the field."""
        element, m, k, n = self._element, self._m, self._k, self.degree
        *every, d = stored
        if self.is_scaled:
            scales = [s for s in (1, m, k, m * k) for _ in range(n)]
            every = [c * s for c, s in zip(every, scales, strict=True)]
        if n == 1:
            w, x, y, z = every
            return element(w, d), element(x, d), element(y, d), element(z, d)
        w, x, y, z = (element(*every[at : at + n], d) for at in range(0, 4 * n, n))
        return w, x, y, z

    # --- arithmetic ----------------------------------------------------------------------------

    def names(self) -> dict[str, object]:
        """Return the constants, and the function that reduces fractions to lowest terms."""
        tools = {"element": self._element, "gcd": gcd, "lowest": lowest}
        tools["reciprocal"] = self._reciprocal
        return super().names() | self.integers | tools | {"LARGE": LARGE, "SMALL": -LARGE}

    def value(self, names: list[str], denominator: str) -> list[str]:
        """Return code that returns integers over a denominator, with a fast branch for the denominator 1."""
        whole = f"    return element({', '.join(names)})"
        return ["if d1 == 1:", whole, *super().value(names, denominator)]

    def source(self, operation: str) -> str:
        """Return the source text of an operation; the inverse over ℚ(s) is a multiple of the conjugate."""
        if operation != "inverse" or self.degree == 1:
            return super().source(operation)
        n = self.degree
        first, conjugate, norm, inverse = (
            [part for name in side for part in parts(name, n)]
            for side in (FIRST, "wxyz", "s", ("w2",))
        )
        adjoint = specialise_extension("adjoint", self.pattern, self.relation)
        multiple = specialise_extension("multiple", self.pattern, self.relation)
        body = [
            *statements(adjoint, (*conjugate, *norm)),
            f"{', '.join(inverse)}, d = reciprocal({', '.join(norm)})",
            *self.inverted[:4],
            f"{', '.join(first)} = {', '.join(conjugate)}",
            f"{', '.join(inverse)} = {', '.join(f'{u}*d1' for u in inverse)}",
            *statements(multiple, tuple(conjugate)),
            *self.settle(conjugate),
        ]
        return function("inverse", {"p": f"{', '.join(first)}, d1"}, body)

    def divided(self, p: Integers, s: S) -> Integers | None:
        """Return p/s for an element s of the ring, or None if s is not a unit."""
        stored: Integers | None
        if not self.ring.is_field:
            stored = super().divided(p, s)
            return stored
        *numerators, d1 = self.fraction(s)
        *inverse, d = self._reciprocal(*numerators)
        if d == 0:
            return None
        if d < 0:
            d, d1 = -d, -d1
        stored = self.multiple(p, (*(c * d1 for c in inverse), d))
        return stored

    def fraction(self, s: S) -> Integers:
        """Return the numerators of an element of the ring over one denominator."""
        vector = self._vector(s)
        d = _denominator(vector)
        return *(int(c.p) * (d // int(c.q)) for c in vector), d

    def _reciprocal(self, *s: int) -> tuple[int, ...]:
        """Return (u₀, …, uₙ₋₁, d) with ``Σ sₖ·sᵏ · Σ uₖ·sᵏ = d``, for n = 1, 2 or 3; d = 0 only if Σ sₖ·sᵏ =
        0.

        Up to the factor d, the u are the first column of the inverse of the matrix of multiplication by Σ
        sₖ·sᵏ.
        """
        if len(s) == 1:
            return 1, *s
        if len(s) == 2:
            (x, y), (m0, m1) = s, self.whole_relation
            u = x + m1 * y
            return u, -y, x * u - m0 * y * y
        x, y, z = s
        m0, m1, m2 = self.whole_relation
        x1, y1, z1 = m0 * z, x + m1 * z, y + m2 * z
        x2, y2, z2 = m0 * z1, x1 + m1 * z1, y1 + m2 * z1
        u, v, w = y1 * z2 - y2 * z1, y2 * z - y * z2, y * z1 - y1 * z
        return u, v, w, x * u + x1 * v + x2 * w

    def settle(self, names: list[str]) -> list[str]:
        """Return code that returns ints over d in lowest terms."""
        listed = ", ".join(names)
        return [
            "if d == 1:",
            f"    if SMALL < {names[0]} < LARGE:",
            f"        return {listed}, d",
            f"elif d < LARGE > {names[0]}:",
            f"    g = gcd(d, {listed})",
            "    if g == 1:",
            f"        return {listed}, d",
            f"    return {', '.join(f'{n}//g' for n in names)}, d//g",
            f"return lowest({listed}, d)",
        ]


def _denominator(vector: Vector) -> int:
    return lcm(*(int(c.q) for c in vector))


def lowest(*fraction: int | flint.fmpz) -> Integers:
    """Reduce integers over a common positive denominator, the last entry, to lowest terms.

    Large integers become flint's, which multiply faster from 2²⁵⁶ on; the others become Python's.
    """
    large: list[flint.fmpz] = [c if type(c) is flint.fmpz else flint.fmpz(c) for c in fraction]
    g = large[-1]
    for c in large:
        if g == 1:
            break
        g = g.gcd(c)
    if g != 1:
        large = [c // g for c in large]
    if all(-LARGE < c < LARGE for c in reversed(large)):
        return tuple(map(int, large))
    return tuple(large)
