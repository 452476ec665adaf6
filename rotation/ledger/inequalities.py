"""State that one rational number is smaller than another, in the language of quaternions.

A rational number d is positive if and only if −d is not a norm over ℚ: norms are sums of four squares, and by
Lagrange's theorem every d ≥ 0 is one. So ``a < b`` is the statement that no quaternion has the norm a − b.
The prover proves it; if it is false, four squares are a counterexample.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from hfield.algebra.structure import four_squares
from hfield.checker.glossary import WITNESS
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring
from hfield.fields.rationals.whole_numbers import fraction
from hfield.ledger.propositions import Assertion, Every
from hfield.prover.decision import REFUTED, Decision


@dataclass(frozen=True)
class Less:
    """``left < right`` for two closed terms, decided over ℚ."""

    left: str
    right: str
    words: str = ""

    @property
    def text(self) -> str:
        """The inequality, in words if they are given."""
        return self.words or f"{self.left} < {self.right}"

    @property
    def statement(self) -> str:
        """The inequality, as a statement about norms over ℚ."""
        return f"norm(q) != {self.difference}"

    @property
    def difference(self) -> str:
        """The term that is negative if the inequality holds."""
        return f"({self.left}) - ({self.right})"

    def decide(self, field: Ring | None) -> Decision:
        """Decide the inequality over ℚ. Raises CoercionError for another field."""
        base = field or ring("QQ")
        left, right = (fraction(base(side)) for side in (self.left, self.right))
        sides = ((self.left, left), (self.right, right))
        steps = tuple(_valued(side, x) for side, x in sides if not side.replace(".", "").isdigit())
        if left < right:
            decision = Assertion(self.statement).decide(base)
            return replace(decision, steps=(*steps, *decision.steps))
        gap = left - right
        squares = four_squares(gap.numerator * gap.denominator)
        witness = [str(Fraction(n, gap.denominator)) for n in squares]
        return Decision(
            REFUTED,
            WITNESS,
            witness={"q": witness},
            steps=(
                *steps,
                f"their difference {gap} is not negative: it is a sum of squares over ℚ",
            ),
            evidence=Evidence(Kind.WITNESS, ring=base.data, values={"q": witness}),
        )


def _valued(term: str, value: Fraction) -> str:
    """Write a term with its value, and the value to six digits."""
    return f"{term} = {value}" + ("" if value.denominator == 1 else f" ≈ {float(value):.6g}")


def between(low: str, value: str, high: str, name: str) -> Every:
    """Return ``low < value < high``; ``name`` describes the value."""
    parts = (Less(low, value, f"{low} < {name}"), Less(value, high, f"{name} < {high}"))
    return Every(parts, f"{low} < {name} < {high}")
