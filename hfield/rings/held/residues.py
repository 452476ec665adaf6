"""Elements over ℤ/n as four ints between 0 and n − 1; sums of products are reduced once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import flint

from hfield.product import Constants, Coordinates
from hfield.rings.held.compact import LARGE, Compact, function, statements
from hfield.straight_line import pattern, specialise

if TYPE_CHECKING:
    from hfield.rings.modular import Modular

WORD = 2**63  # below, flint's nmod

Held = tuple[Any, Any, Any, Any]
RESIDUES = ("w % n", "x % n", "y % n", "z % n")


class Residues(Compact):
    """Elements over ℤ/n; flint's integers take the place of Python's where n is large."""

    def __init__(self, ring: Modular, constants: Constants) -> None:
        super().__init__(ring, constants)
        self._residue = ring.residue
        self._int: Any = int if ring.modulus < LARGE else lambda x: flint.fmpz(int(x))
        self.modulus = self._int(ring.modulus)
        self.integral = Constants(*map(self._int, constants))
        self.pattern = pattern(self.integral, lambda x, k: (x - k) % self.modulus == 0)

    def hold(self, coordinates: Coordinates) -> Held:
        """Return the element with these coordinates in ℤ/n."""
        w, x, y, z = map(self._int, coordinates)
        return w, x, y, z

    def coordinates(self, held: Held) -> Coordinates:
        """Return the four coordinates, flint's residues."""
        w, x, y, z = map(self._residue, map(int, held))
        return w, x, y, z

    def read(self, values: tuple[Any, ...]) -> Held:
        """Hold four values that ℤ/n reads."""
        w, x, y, z = values
        if type(w) is type(x) is type(y) is type(z) is int:
            n = self.modulus
            return w % n, x % n, y % n, z % n
        held: Held = super().read(values)
        return held

    def names(self) -> dict[str, Any]:
        """Return the constants, the modulus, and what makes flint's residue of an int."""
        residue = flint.nmod if self.modulus < WORD else lambda x, n: self._residue(int(x))
        return self.integral._asdict() | {"n": self.modulus, "residue": residue}

    def source(self, operation: str) -> str:
        """Return the text of an operation on four residues."""
        p, q = {"p": "w1, x1, y1, z1"}, {"q": "w2, x2, y2, z2"}
        reduced = f"return {', '.join(RESIDUES)}"
        if operation == "sum":
            sums = ", ".join(f"({c}1 + {c}2) % n" for c in "wxyz")
            return function("sum", p | q, [f"return {sums}"])
        program = specialise("adjoint" if operation == "inverse" else operation, self.pattern)
        if operation == "inverse":
            return function(
                "inverse", p, [*statements(program, (*"wxyz", "s")), *INVERTED, reduced]
            )
        if operation in ("norm", "trace"):
            return function(
                operation, p, [*statements(program, ("s",)), "return residue(s % n, n)"]
            )
        operands = p | q if operation == "product" else p
        return function(operation, operands, [*statements(program, (*"wxyz",)), reduced])

    def difference(self, p: Held, q: Held, /) -> Held:
        """Return p − q."""
        (w1, x1, y1, z1), (w2, x2, y2, z2), n = p, q, self.modulus
        return (w1 - w2) % n, (x1 - x2) % n, (y1 - y2) % n, (z1 - z2) % n

    def negative(self, p: Held, /) -> Held:
        """Return −p."""
        (w, x, y, z), n = p, self.modulus
        return -w % n, -x % n, -y % n, -z % n

    def scaled(self, p: Held, s: Any) -> Held:
        """Return s·p for a residue s."""
        (w, x, y, z), n, s = p, self.modulus, int(s)
        return w * s % n, x * s % n, y * s % n, z * s % n

    def equal(self, p: Held, q: Held) -> bool:
        """Tell whether p = q."""
        return p == q

    def is_zero(self, p: Held) -> bool:
        """Tell whether p = 0."""
        return p == (0, 0, 0, 0)

    def key(self, p: Held) -> Held:
        """Return p itself."""
        return p


INVERTED = [
    "try:",
    "    s = pow(int(s), -1, int(n))",
    "except ValueError:",
    "    return None",
    "w, x, y, z = w*s, x*s, y*s, z*s",
]
