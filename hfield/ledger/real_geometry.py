"""Propositions of real geometry: angles as points of the circle, and theorems of analysis.

An angle occurs only as the point (cos θ, sin θ). A claim about points (c, s) with c² + s² = 1 has a meaning
over every commutative ring; over RR these points are the angles, which is cited.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from hfield.checker.glossary import CIRCLE, CITED_BY_NAME, NO_MEANING, REFUTED
from hfield.fields.base.ring import Ring
from hfield.ledger.claim import Proposition
from hfield.ledger.propositions import Every
from hfield.ledger.scopes import InField
from hfield.prover.decision import NOT_APPLICABLE, Decision
from hfield.prover.steps import say

REAL = "RR"


@dataclass(frozen=True)
class Angles:
    """A claim about angles: ``core`` about points of the circle, and ``real``, a further condition over RR.

    Over RR, and over all fields (which include RR), the decision cites that the points of the circle are the
    points (cos θ, sin θ). Over any other field ``real`` is ignored.
    """

    core: Proposition
    real: Proposition | None = None

    @property
    def text(self) -> str:
        """The core."""
        return self.core.text

    @property
    def statement(self) -> str:
        """The core and the real part, in the vocabulary of certificates."""
        parts = [self.core, *([self.real] if self.real else [])]
        return f"angles{{{'; '.join(part.statement for part in parts)}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide the core over ``field``, and the real part if ``field`` is RR or None."""
        if field is not None and field.name != REAL:
            return self.core.decide(field)
        whole = Every((self.core, InField(REAL, self.real))) if self.real else self.core
        decision = whole.decide(field)
        refuted = field is None and decision.verdict == REFUTED
        return decision if refuted else _citing(decision, CIRCLE)


@dataclass(frozen=True)
class Analysis:
    """A proposition over RR that follows from another by a cited theorem of analysis (a key of
    ``CITED_BY_NAME``).
    """

    theorem: str
    proposition: Proposition

    @property
    def text(self) -> str:
        """The proposition with the theorem."""
        return f"{self.proposition.text}; {CITED_BY_NAME[self.theorem]}"

    @property
    def statement(self) -> str:
        """The proposition with the name of the theorem, in the vocabulary of certificates."""
        return f"citing{{{self.theorem}; {self.proposition.statement}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Decide the proposition over RR; the theorem is cited."""
        if field is None or field.name != REAL:
            return Decision(NOT_APPLICABLE, NO_MEANING, steps=(say("real-polynomials"),))
        return _citing(self.proposition.decide(field), CITED_BY_NAME[self.theorem])


def _citing(decision: Decision, theorem: str) -> Decision:
    return replace(decision, assumes=tuple(dict.fromkeys((*decision.assumes, theorem))))
