"""What a question about equivalence or isomorphism is answered with: the element, or the reason."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from hfield.quaternion import Quaternion


@dataclass(frozen=True)
class Answer:
    """True or false in an ``if``; ``element`` proves a true answer, ``reason`` says how it was decided.

    ``theorem`` names the theorem that decided where nothing was enumerated; then a true answer may come
    without its element, which was not found within a bound. ``evidence`` is what a program needs to check it.
    """

    holds: bool
    reason: str
    element: Quaternion | None = None
    theorem: str | None = None
    evidence: dict[str, Any] = field(default_factory=dict, compare=False)

    def __bool__(self) -> bool:
        """Tell whether it holds."""
        return self.holds

    def __repr__(self) -> str:
        shown = "" if self.element is None else f" with {self.element}"
        return f"{'yes' if self.holds else 'no'}{shown}: {self.reason}"


def rows_json(lattice: Any) -> dict[str, Any]:
    """Return a lattice as JSON: its denominator and Hermite rows."""
    den, rows = lattice.hnf
    return {"den": den, "rows": [list(row) for row in rows]}


def element_json(q: Quaternion) -> list[str]:
    """Return an element as four texts."""
    return [q.ring.text(x) for x in q.coordinates]


STRONG_APPROXIMATION = (
    "Eichler's theorem, from strong approximation: in an indefinite algebra over QQ an order whose local "
    "units have all unit norms has one ideal class (Voight, Quaternion Algebras, chapter 28)"
)
