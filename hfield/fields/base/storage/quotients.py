"""Storage of elements over R/(n) as four representatives; each sum of products is reduced once."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

import flint

from hfield.core.product import Constants, Coordinates
from hfield.core.straight_line import BINARY, pattern, specialise
from hfield.fields.base.storage.compact import LARGE, Compact, function, statements

if TYPE_CHECKING:
    from hfield.fields.base.finite_places import Residue
    from hfield.fields.base.flint_types import Coefficient
    from hfield.fields.base.modular import Modular
    from hfield.fields.base.ring import Ring

R = TypeVar("R", bound="Residue")  # a representative
Representatives = tuple[R, R, R, R]


class Quotients(Compact[Representatives[R], "Coefficient"]):
    """Storage of elements over R/(n) as the unique representatives that ``%`` returns."""

    reduces_sums = True

    def __init__(
        self,
        ring: Ring,
        constants: Constants,
        modulus: R,
        lift: Callable[[Coefficient], R],
        project: Callable[[R], Coefficient],
        invert: Callable[[R], R],
    ) -> None:
        """Store the maps from the ring to representatives and back.

        ``invert`` returns a representative of the inverse or raises ValueError.
        """
        super().__init__(ring, constants)
        self.modulus, self._lift, self._project, self._invert = modulus, lift, project, invert
        self.lifted = Constants(*map(lift, constants))
        self.pattern = pattern(constants, lambda x, k: ring.equal(x, ring(k)))

    def encode(self, coordinates: Coordinates) -> Representatives[R]:
        """Return the element with these coordinates in the ring."""
        w, x, y, z = map(self._lift, coordinates)
        return w, x, y, z

    def coordinates(self, stored: Representatives[R]) -> Coordinates:
        """Return the four coordinates, flint's residues or field elements."""
        w, x, y, z = map(self._project, stored)
        return w, x, y, z

    def names(self) -> dict[str, object]:
        """Return the constants, the modulus, and the maps."""
        tools = {"n": self.modulus, "project": self._project, "invert": self._invert}
        return self.lifted._asdict() | tools

    def source(self, operation: str) -> str:
        """Return the source text of an operation on four representatives."""
        program = specialise(
            "adjoint" if operation == "inverse" else operation,
            self.pattern,
            2 if self.ring.characteristic == 2 else 0,
        )
        operands = {"p": "w1, x1, y1, z1"}
        if operation in ("norm", "trace"):
            body = [*statements(program, ("s",)), "return project(s % n)"]
        elif operation == "inverse":
            body = [*statements(program, (*"wxyz", "s")), *INVERTED, REDUCED]
        else:
            multiplies = any(step.operation == "*" for step in program.steps)
            last = REDUCED if self.reduces_sums or multiplies else "return w, x, y, z"
            body = [*statements(program, (*"wxyz",)), last]
        if operation in BINARY:
            operands["q"] = "w2, x2, y2, z2"
        return function(operation, operands, body)

    def scaled(self, p: Representatives[R], s: Coefficient) -> Representatives[R]:
        """Return s·p for an element s of the ring."""
        (w, x, y, z), n, s = p, self.modulus, self._lift(s)
        return w * s % n, x * s % n, y * s % n, z * s % n

    def is_zero(self, p: Representatives[R]) -> bool:
        """Return whether p = 0."""
        return p == (0, 0, 0, 0)


INVERTED = [
    "try:",
    "    s = invert(s)",
    "except ValueError:",
    "    return None",
    "w, x, y, z = w*s, x*s, y*s, z*s",
]
REDUCED = "return w % n, x % n, y % n, z % n"


class ResidueStorage(Quotients["int | flint.fmpz"]):
    """Storage of elements over ℤ/n as four ints between 0 and n − 1, of flint for large n."""

    def __init__(self, ring: Modular, constants: Constants) -> None:
        n, word = ring.modulus, ring.modulus < LARGE
        super().__init__(
            ring,
            constants,
            n if word else flint.fmpz(n),
            lift=int if word else lambda x: flint.fmpz(int(x)),
            project=ring.residue if word else lambda x: ring.residue(int(x)),
            invert=lambda s: pow(int(s), -1, n),
        )

    def whole(self, w: int, x: int, y: int, z: int) -> Representatives[int | flint.fmpz]:
        """Encode four ints."""
        n = self.modulus
        return w % n, x % n, y % n, z % n

    def key(self, p: Representatives[int | flint.fmpz]) -> Representatives[int | flint.fmpz]:
        """Return p itself."""
        return p
