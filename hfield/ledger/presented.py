"""Propositions about algebras given by i² = j² = k² = ijk = −e: what follows from the relations."""

from __future__ import annotations

from dataclasses import dataclass

from hfield.proving.decision import Decision
from hfield.proving.methods.presentations import decide_presentation, presentation_text
from hfield.rings.base import Ring

RELATIONS = ("i*i == -e", "j*j == -e", "k*k == -e", "i*j*k == -e")


@dataclass(frozen=True)
class Presented:
    """Each of ``goals`` holds in every associative algebra in which the relations hold.

    With ``identity`` e is the identity of the algebra, else just another letter.
    """

    goals: tuple[str, ...]
    identity: bool = True

    @property
    def text(self) -> str:
        """The relations and the goals as one writes them."""
        unit = "with identity e" if self.identity else "with basis (e,i,j,k)"
        goals = ", ".join(self.goals).replace("*", "").replace("==", "=").replace("-", "−")
        return f"in an associative algebra {unit}, i² = j² = k² = ijk = −e ⇒ {goals}"

    @property
    def statement(self) -> str:
        """The same as certificates state it."""
        return presentation_text(RELATIONS, self.goals, self.identity)

    def decide(self, field: Ring | None) -> Decision:
        """Rewrite each goal by the relations in ℤ⟨e,i,j,k⟩, or find an algebra where one fails."""
        return decide_presentation(RELATIONS, self.goals, field=field, identity=self.identity)
