"""Elements over ℚ and over number fields as ints over one denominator, in lowest terms.

A coordinate over a field of degree n is a vector of n rational numbers: the coefficients of 1, s, …, sⁿ⁻¹,
where s is an algebraic integer. The basis is scaled to i′ = m·i, j′ = k·j, so that the constants a′ = m²a,
t′ = mt, b′ = k²b are integral: the algebra keeps its form, and so its formula.
"""

from __future__ import annotations

from collections.abc import Callable
from math import gcd, lcm
from typing import Any

import flint

from hfield.product import Constants, Coordinates
from hfield.rings.base import Ring
from hfield.rings.held.compact import LARGE, Compact, function, statements
from hfield.straight_line import FIRST, SECOND, named, parts, specialise_extension

Held = tuple[Any, ...]  # the coefficients of w, x, y, z, and the denominator last, positive
Vector = tuple[Any, ...]  # of rational numbers


class Fractions(Compact):
    """Elements over a field ``ℚ(s)`` with ``sⁿ = Σ relation[k]·sᵏ`` for integers; ℚ has n = 1, s = 0."""

    def __init__(
        self,
        ring: Ring,
        constants: Constants,
        relation: tuple[int, ...],
        vector: Callable[[Any], Vector],
        element: Callable[..., Any],
    ) -> None:
        """Take the maps from the ring to vectors and back, ``element(c₀, …, cₙ₋₁, denominator)``."""
        super().__init__(ring, constants)
        self.degree, self.relation = len(relation), relation
        self._vector, self._element = vector, element
        a, t, b = map(vector, constants)
        self._m, self._k = _denominator(a + t), _denominator(b)
        scaled = [c * self._m**2 for c in a], [c * self._m for c in t], [c * self._k**2 for c in b]
        self._integral: dict[str, int] = {}
        self._pattern = tuple(
            self._named(name, [int(c.p) for c in values])
            for name, values in zip("atb", scaled, strict=True)
        )
        self._relation = self._named("m", list(relation))

    def _named(self, letter: str, values: list[int]) -> tuple[str, ...]:
        """Return integers as the specialiser takes them, and remember those that it names."""
        names = parts(letter, self.degree)
        self._integral |= dict(zip(names, values, strict=True))
        return tuple(named(v, name, int.__eq__) for name, v in zip(names, values, strict=True))

    # --- in and out ----------------------------------------------------------------------------

    def hold(self, coordinates: Coordinates) -> Held:
        """Return the element with these coordinates in the field."""
        scales = 1, self._m, self._k, self._m * self._k
        vectors = map(self._vector, coordinates)
        every = [c / s for v, s in zip(vectors, scales, strict=True) for c in v]
        d = lcm(*(int(c.q) for c in every))
        return lowest(*(int(c.p) * (d // int(c.q)) for c in every), d)

    def whole(self, w: int, x: int, y: int, z: int) -> Held:
        """Hold four ints."""
        if (
            self.degree == self._m == self._k == 1
            and -LARGE < min(w, x, y, z) <= max(w, x, y, z) < LARGE
        ):
            return w, x, y, z, 1
        held: Held = super().whole(w, x, y, z)
        return held

    def coordinates(self, held: Held) -> Coordinates:
        """Return the four coordinates, elements of the field."""
        element, m, k, n = self._element, self._m, self._k, self.degree
        *every, d = held
        if m != 1 or k != 1:
            scales = [s for s in (1, m, k, m * k) for _ in range(n)]
            every = [c * s for c, s in zip(every, scales, strict=True)]
        if n == 1:
            w, x, y, z = every
            return element(w, d), element(x, d), element(y, d), element(z, d)
        w, x, y, z = (element(*every[at : at + n], d) for at in range(0, 4 * n, n))
        return w, x, y, z

    # --- arithmetic ----------------------------------------------------------------------------

    def names(self) -> dict[str, Any]:
        """Return the constants, and what puts fractions in lowest terms."""
        return self._integral | {
            "element": self._element,
            "by_norm": self._by_norm,
            "gcd": gcd,
            "lowest": lowest,
            "LARGE": LARGE,
            "SMALL": -LARGE,
        }

    def source(self, operation: str) -> str:
        """Return the text of an operation on ints over one denominator."""
        degree = self.degree
        first, second, results = (
            [part for name in side for part in parts(name, degree)]
            for side in (FIRST, SECOND, "wxyz")
        )
        norm = list(parts("s", degree))
        p = {"p": f"{', '.join(first)}, d1"}
        both = p | {"q": f"{', '.join(second)}, d2"}

        def formula(name: str, outputs: list[str]) -> list[str]:
            program = specialise_extension(name, self._pattern, self._relation)
            return statements(program, tuple(outputs))

        if operation == "product":
            body = [*formula("product", results), "d = d1*d2", *_settle(results)]
            return function("product", both, body)
        if operation in ("sum", "difference"):
            body = [*_added("+" if operation == "sum" else "-", results, first, second)]
            return function(operation, both, [*body, *_settle(results)])
        if operation == "inverse":
            if degree > 1:
                return "def inverse(p):\n    return by_norm(p)"
            return function(
                "inverse", p, [*formula("adjoint", [*results, "d"]), *INVERTED, *_settle(results)]
            )
        if operation in ("norm", "trace"):
            d = "d1*d1" if operation == "norm" else "d1"
            value = f"return element({', '.join(norm)}, {d})"
            return function(operation, p, [*formula(operation, norm), value])
        value = f"return {', '.join(results)}, d1"
        return function(operation, p, [*formula(operation, results), value])

    def _by_norm(self, p: Held) -> Held | None:
        """Return the inverse through that of the norm in the field."""
        n = self.norm(p)
        if self.ring.is_zero(n):
            return None
        return self.scaled(self.conjugate(p), self.ring.inverse(n))

    def scaled(self, p: Held, s: Any) -> Held:
        """Return s·p for an element s of the field."""
        zero = self.ring.zero
        held: Held = self.product(p, self.hold((s, zero, zero, zero)))
        return held

    def equal(self, p: Held, q: Held) -> bool:
        """Tell whether p = q: lowest terms are unique."""
        return p == q

    def is_zero(self, p: Held) -> bool:
        """Tell whether p = 0."""
        return not any(p[:-1])

    def key(self, p: Held) -> Held:
        """Return p itself: flint's integers hash as Python's."""
        return p


def _denominator(vector: Vector) -> int:
    return lcm(*(int(c.q) for c in vector))


def _added(sign: str, results: list[str], first: list[str], second: list[str]) -> list[str]:
    """Write the sum or difference of two fractions, not in lowest terms."""
    triples = list(zip(results, first, second, strict=True))
    return [
        "if d1 == d2:",
        *(f"    {r} = {u} {sign} {v}" for r, u, v in triples),
        "    d = d1",
        "else:",
        *(f"    {r} = {u}*d2 {sign} {v}*d1" for r, u, v in triples),
        "    d = d1*d2",
    ]


INVERTED = [
    "if d == 0:",
    "    return None",
    "if d < 0:",
    "    d, d1 = -d, -d1",
    "w, x, y, z = w*d1, x*d1, y*d1, z*d1",
]


def _settle(names: list[str]) -> list[str]:
    """Write how to return fractions in lowest terms; one look tells whether the numbers are large."""
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


def lowest(*fraction: Any) -> Held:
    """Put integers over one denominator, which is the last and positive, in lowest terms.

    Large ones become flint's, which multiply faster from :data:`LARGE` on, the others Python's.
    """
    d = fraction[-1]
    if all(-LARGE < c < LARGE for c in fraction):
        g = gcd(*fraction) if d != 1 else 1
        return tuple(int(c) // g for c in fraction) if g != 1 else tuple(map(int, fraction))
    large = [flint.fmpz(c) for c in fraction]
    g = large[-1]
    for c in large:
        if g == 1:
            break
        g = g.gcd(c)
    return tuple(large) if g == 1 else tuple(c // g for c in large)
