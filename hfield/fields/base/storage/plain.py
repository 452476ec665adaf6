"""Elements as the tuple of their coordinates, for any ring with + − ×."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hfield.core.product import Constants, Coordinates, Scalar
from hfield.core.straight_line import BINARY, GENERAL, pattern, specialise
from hfield.errors import HFieldError
from hfield.fields.base.storage.compact import Compact, function, statements

if TYPE_CHECKING:
    from hfield.fields.base.ring import Ring


class Plain(Compact[Coordinates, Scalar]):
    """Storage of elements as tuples of their four coordinates."""

    def __init__(self, ring: Ring, constants: Constants) -> None:
        super().__init__(ring, constants)
        self.is_unique = False

    def equal(self, p: Coordinates, q: Coordinates) -> bool:
        """Return whether p = q."""
        return all(map(self.ring.equal, p, q))

    def source(self, operation: str) -> str:
        """Return the source text of an operation on coordinates."""
        if operation == "inverse":
            return "def inverse(p):\n    return by_norm(p)"
        # floats keep the formula to the letter, for 0·∞ is not 0
        known = pattern(self.constants, self._is_constant) if self.ring.is_exact else GENERAL
        program = specialise(operation, known)
        operands = {"p": "w1, x1, y1, z1"}
        if operation in BINARY:
            operands["q"] = "w2, x2, y2, z2"
        outputs = ("s",) if operation in ("norm", "trace") else (*"wxyz",)
        body = statements(program, outputs)
        return function(operation, operands, [*body, f"return {', '.join(outputs)}"])

    def _is_constant(self, x: Scalar, n: int) -> bool:
        try:
            return self.ring.equal(x, self.ring(n))
        except HFieldError:  # not decided: then it stays a name
            return False

    def names(self) -> dict[str, object]:
        """Return the constants, and 0."""
        return {**self.constants._asdict(), "by_norm": self._by_norm}

    def _by_norm(self, p: Coordinates) -> Coordinates | None:
        w, x, y, z = p
        if self.ring.is_exact and all(map(self.ring.is_zero, (x, y, z))):
            # A scalar: its norm, the square, takes longer to invert. Texts divide by scalars.
            return (self.ring.inverse(w), x, y, z) if self.ring.is_unit(w) else None
        n = self.norm(p)
        if not self.ring.is_unit(n):
            return None
        return self.scaled(self.conjugate(p), self.ring.inverse(n))
