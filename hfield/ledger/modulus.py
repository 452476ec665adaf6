"""Propositions about square roots in the base field: the modulus |q| = √N(q) and its law."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from dataclasses import dataclass, replace
from itertools import chain
from itertools import product as tuples

from hfield.checker.glossary import (
    ALL_CHOICES_OF_ROOTS,
    CHOICE_OF_ROOTS,
    CLOSED_FIELD,
    COMPLEX_ROOTS,
    EXHAUSTION,
    IDENTITY,
    KULIKOV,
    ORDERING,
    PROVED,
    REAL_ROOTS,
    REFUTED,
    SEARCH,
    UNDECIDED,
    UNIQUE_ROOTS,
    WITNESS,
)
from hfield.core.product import Coordinates, Scalar, multiply, norm
from hfield.errors import UndecidedError
from hfield.evidence import Evidence, Kind
from hfield.fields.base.ring import INFINITY, Ring
from hfield.ledger.base_field import hamilton, texts
from hfield.ledger.propositions import Assertion
from hfield.ledger.scopes import search_panel
from hfield.prover.decision import Decision
from hfield.prover.steps import say

CHECKED_BELOW = 256  # the largest field whose pairs of roots are all multiplied out

# In characteristic 2 each norm is the square of the sum of the coordinates.
SUM_OF_ALL = Assertion("norm(q) == (q[0] + q[1] + q[2] + q[3])**2")


@dataclass(frozen=True)
class ModulusDefined:
    """The claim that the modulus |q| = √N(q) exists in F for each q."""

    text = "N(q) is a square in F for each q, so that |q| = √N(q) exists"
    statement = "modulus-exists"

    def decide(self, field: Ring | None) -> Decision:
        """Search for a small q whose norm is not a square, or prove that every norm is a square."""
        if field is None:
            return search_panel(self)
        for q in chain(small_elements(field), self._norm_without_root(field)):
            n = norm(hamilton(field), q)
            if field.sqrt(n) is None:
                step = say("no-square", n=field.text(n), F=field)
                value = texts(field, q)
                return Decision(
                    REFUTED,
                    WITNESS,
                    witness={"q": value},
                    steps=(step,),
                    evidence=Evidence(Kind.NO_ROOT, value=value),
                )
        if field.characteristic == 2:
            return replace(SUM_OF_ALL.decide(field), method=IDENTITY)
        if field.closure:
            step = say("real-closed" if field.closure == "real closed" else "closed", F=field)
            return Decision(
                PROVED,
                CLOSED_FIELD,
                steps=(step,),
                assumes=(REAL_ROOTS if field.closure == "real closed" else COMPLEX_ROOTS,),
                evidence=Evidence(Kind.CLOSED),
            )
        return Decision(UNDECIDED, SEARCH, tried=("norms of small elements",))

    def _norm_without_root(self, F: Ring) -> Iterator[Coordinates]:
        """Yield w + x·i whose norm is not a square, over a finite field of odd order."""
        if F.order is None or F.characteristic == 2:
            return
        target = next(n for n in F.elements() if F.sqrt(n) is None)
        for w in F.elements():
            x = F.sqrt(target - w * w)
            if x is not None:
                yield w, x, F.zero, F.zero
                return


def small_elements(F: Ring) -> list[Coordinates]:
    """Return a few dozen quaternions with coordinates 0, 1 and the generators of F."""
    values = [F.zero, F.one, *([F.gen] if F.gen_name else [])]
    return [(w, x, y, z) for z, y, x, w in tuples(values, repeat=4)]


@dataclass(frozen=True)
class ModulusLaw:
    """The claim |pq| = |p||q|, or with ``operation`` "+" the false variant |pq| = |p| + |q|.

    √ is one fixed root for each square that has one, and the law holds if it holds for some choice of roots.
    A multiplicative choice x ↦ √x exists if and only if F has characteristic 2 or −1 is not a square:
    otherwise √1 = √1·√1 implies √1 = 1, which contradicts √(−1)·√(−1) = −1.
    """

    operation: str = "*"

    @property
    def text(self) -> str:
        """The law as printed, or its counterpart."""
        return "|pq| = |p||q|" if self.operation == "*" else "|pq| = |p| + |q|"

    @property
    def statement(self) -> str:
        """The law in the vocabulary of certificates."""
        return f"modulus-law{{{self.operation}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Refute the law on several elements for every choice of their roots, or give a choice that works."""
        if field is None:
            return search_panel(self)
        zero = field.zero
        sample: list[Coordinates] = [(field.one, zero, zero, zero)]
        iota = field.sqrt(field(-1))
        if iota is not None:
            sample.append((iota, zero, zero, zero))
        try:
            bad = self._without_choice(field, sample)
        except UndecidedError:  # √−1 is known to some digits
            if iota is None or self.operation != "*":
                raise
            step = say("no-choice-near")
            bad = {name: texts(field, sample[-1]) for name in "pq"}
            return Decision(REFUTED, ALL_CHOICES_OF_ROOTS, witness=bad, steps=(step,))
        if bad is not None:
            steps = (say("no-choice", n=2 ** len(sample)),)
            evidence = Evidence(
                Kind.ALL_CHOICES,
                elements=[texts(field, q) for q in sample],
                roots=[field.text(field.sqrt(norm(hamilton(field), q))) for q in sample],
            )
            return Decision(
                REFUTED, ALL_CHOICES_OF_ROOTS, witness=bad, steps=steps, evidence=evidence
            )
        if self.operation != "*":
            return Decision(UNDECIDED, ALL_CHOICES_OF_ROOTS, tried=("roots of small norms",))
        if field.characteristic == 2:
            step = say("one-root")
            return Decision(
                PROVED, UNIQUE_ROOTS, steps=(step,), evidence=Evidence(Kind.UNIQUE_ROOTS)
            )
        if field.level.value == INFINITY:
            lines = (say("field-because", F=field, reason=field.level.reason), say("root-in-order"))
            return Decision(PROVED, ORDERING, steps=lines, evidence=Evidence(Kind.ORDERING))
        if field.order is not None:
            return self._finite(field)
        step = say("pure-subgroup")
        return Decision(
            PROVED,
            CHOICE_OF_ROOTS,
            steps=(step,),
            assumes=(KULIKOV,),
            evidence=Evidence(Kind.PURE_SUBGROUP),
        )

    def _without_choice(self, F: Ring, sample: list[Coordinates]) -> dict[str, list[str]] | None:
        """Return None if some choice satisfies the law, else p, q that violate it under the choice √1 = 1."""
        norms = {F.key(norm(hamilton(F), q)): norm(hamilton(F), q) for q in sample}
        roots = {key: r for key, n in norms.items() if (r := F.sqrt(n)) is not None}
        roots[F.key(F.one)] = F.one
        bad: dict[str, list[str]] | None = None
        for signs in tuples((1, -1), repeat=len(roots)):
            chosen = {
                key: r if s > 0 else -r for (key, r), s in zip(roots.items(), signs, strict=True)
            }
            failing = [
                {"p": texts(F, p), "q": texts(F, q)}
                for p, q in tuples(sample, repeat=2)
                if not self._holds(F, chosen, p, q)
            ]
            if not failing:
                return None
            bad = bad or failing[-1]
        return bad

    def _holds(
        self, F: Ring, chosen: dict[Hashable, Scalar], p: Coordinates, q: Coordinates
    ) -> bool:
        c = hamilton(F)
        m, n = (chosen[F.key(norm(c, x))] for x in (p, q))
        product = chosen.get(F.key(norm(c, multiply(c, p, q))))
        if product is None:
            return True
        return F.equal(product, m * n if self.operation == "*" else m + n)

    def _finite(self, F: Ring) -> Decision:
        """Choose the root that is itself a square; on small fields check all products too."""
        steps = (say("half-squares"), say("take-that"))
        evidence = Evidence(Kind.SQUARE_ROOTS)
        if F.order is None or F.order > CHECKED_BELOW:
            return Decision(PROVED, CHOICE_OF_ROOTS, steps=steps, evidence=evidence)
        squares = {F.key(x * x) for x in F.elements()}
        root = {F.key(x * x): x for x in F.elements() if F.key(x) in squares}
        pairs = tuples(root.values(), repeat=2)
        if set(root) != squares or not all(
            F.equal(root[F.key(x * x * (y * y))], x * y) for x, y in pairs
        ):
            return Decision(UNDECIDED, EXHAUSTION, tried=steps)
        checked = (*steps, say("checked-pairs", n=f"{len(root)}²"))
        return Decision(PROVED, EXHAUSTION, steps=checked, evidence=evidence)
