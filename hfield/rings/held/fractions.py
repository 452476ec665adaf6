"""Elements over ℚ as four ints over one denominator, in lowest terms.

The basis is scaled to i′ = m·i, j′ = n·j so that the constants a′ = m²a, t′ = mt, b′ = n²b are integers: the
algebra keeps its form, and so its formula. From 2²⁵⁶ on flint's integers take the place of
Python's, which multiply long numbers digit by digit.
"""

from __future__ import annotations

from math import gcd, lcm
from typing import Any

import flint

from hfield.product import Constants, Coordinates
from hfield.rings.base import Ring
from hfield.rings.held.compact import LARGE, Compact, function, statements
from hfield.straight_line import pattern, specialise

Held = tuple[Any, Any, Any, Any, Any]  # (w, x, y, z, d) for (w + x·i′ + y·j′ + z·k′)/d


class Fractions(Compact):
    """Elements over ℚ."""

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        a, t, b = constants
        self.m, self.n = lcm(int(a.q), int(t.q)), int(b.q)
        self.integral = Constants(int(a * self.m**2), int(t * self.m), int(b * self.n**2))
        self.pattern = pattern(self.integral, lambda x, k: x == k)
        self.is_scaled = self.m != 1 or self.n != 1

    def hold(self, coordinates: Coordinates) -> Held:
        """Return the element with these rational coordinates."""
        if self.is_scaled:
            w, x, y, z = coordinates
            coordinates = w, x / self.m, y / self.n, z / (self.m * self.n)
        parts = [(int(c.p), int(c.q)) for c in coordinates]
        d = lcm(*(q for _, q in parts))
        w, x, y, z = (p * (d // q) for p, q in parts)
        return _settled(w, x, y, z, d)

    def coordinates(self, held: Held) -> Coordinates:
        """Return the four rational coordinates."""
        w, x, y, z, d = held
        if self.is_scaled:
            x, y, z = x * self.m, y * self.n, z * (self.m * self.n)
        fraction = flint.fmpq
        return fraction(w, d), fraction(x, d), fraction(y, d), fraction(z, d)

    def whole(self, w: int, x: int, y: int, z: int) -> Held:
        """Hold four ints."""
        if self.is_scaled:
            held: Held = super().whole(w, x, y, z)
            return held
        return _settled(w, x, y, z, 1)

    def names(self) -> dict[str, Any]:
        """Return the constants, and what puts fractions in lowest terms."""
        tools = {
            "gcd": gcd,
            "lowest": lowest,
            "fraction": flint.fmpq,
            "LARGE": LARGE,
            "SMALL": -LARGE,
        }
        return self.integral._asdict() | tools

    def source(self, operation: str) -> str:
        """Return the text of an operation on four ints over one denominator."""
        p, q = {"p": "w1, x1, y1, z1, d1"}, {"q": "w2, x2, y2, z2, d2"}
        if operation == "product":
            formula = statements(specialise("product", self.pattern), ("w", "x", "y", "z"))
            return function("product", p | q, [*formula, "d = d1*d2", *LOWEST])
        if operation == "sum":
            return function("sum", p | q, [*ADDED, *LOWEST])
        if operation == "inverse":
            formula = statements(specialise("adjoint", self.pattern), ("w", "x", "y", "z", "d"))
            return function("inverse", p, [*formula, *INVERTED, *LOWEST])
        outputs = ("w", "x", "y", "z") if operation == "conjugate" else ("n",)
        formula = statements(specialise(operation, self.pattern), outputs)
        value = {
            "conjugate": "w, x, y, z, d1",
            "norm": "fraction(n, d1*d1)",
            "trace": "fraction(n, d1)",
        }[operation]
        return function(operation, p, [*formula, f"return {value}"])

    def difference(self, p: Held, q: Held) -> Held:
        """Return p − q."""
        held: Held = self.sum(p, self.negative(q))
        return held

    def negative(self, p: Held) -> Held:
        """Return −p."""
        w, x, y, z, d = p
        return -w, -x, -y, -z, d

    def scaled(self, p: Held, s: Any) -> Held:
        """Return s·p for a rational number s."""
        w, x, y, z, d = p
        n, m = int(s.p), int(s.q)
        return _settled(w * n, x * n, y * n, z * n, d * m)

    def equal(self, p: Held, q: Held) -> bool:
        """Tell whether p = q."""
        return p == q

    def is_zero(self, p: Held) -> bool:
        """Tell whether p = 0."""
        return p == (0, 0, 0, 0, 1)

    def key(self, p: Held) -> Held:
        """Return p itself: lowest terms are unique, and flint's integers hash as Python's."""
        return p


LOWEST = [
    "if d == 1:",
    "    if SMALL < w < LARGE:",
    "        return w, x, y, z, d",
    "elif d < LARGE > w:",
    "    g = gcd(d, w, x, y, z)",
    "    return (w, x, y, z, d) if g == 1 else (w//g, x//g, y//g, z//g, d//g)",
    "return lowest(w, x, y, z, d)",
]
ADDED = [
    "if d1 == d2:",
    "    w, x, y, z, d = w1 + w2, x1 + x2, y1 + y2, z1 + z2, d1",
    "else:",
    "    w, x, y, z, d = w1*d2 + w2*d1, x1*d2 + x2*d1, y1*d2 + y2*d1, z1*d2 + z2*d1, d1*d2",
]
INVERTED = [
    "if d == 0:",
    "    return None",
    "if d < 0:",
    "    d, d1 = -d, -d1",
    "w, x, y, z = w*d1, x*d1, y*d1, z*d1",
]


def lowest(*parts: Any) -> Held:
    """Put large numbers in lowest terms, the denominator last and positive; they become flint's."""
    w, x, y, z, d = map(flint.fmpz, parts)
    g = d.gcd(w).gcd(x).gcd(y).gcd(z) if d != 1 else d
    if g != 1:
        w, x, y, z, d = w // g, x // g, y // g, z // g, d // g
    if all(-LARGE < c < LARGE for c in (w, x, y, z, d)):
        return int(w), int(x), int(y), int(z), int(d)
    return w, x, y, z, d


def _settled(w: Any, x: Any, y: Any, z: Any, d: Any) -> Held:
    """Put an element in lowest terms, of whatever size."""
    if d == 1:
        if -LARGE < w < LARGE:
            return w, x, y, z, d
    elif d < LARGE > w:
        g = gcd(d, w, x, y, z)
        return (w, x, y, z, d) if g == 1 else (w // g, x // g, y // g, z // g, d // g)
    return lowest(w, x, y, z, d)
