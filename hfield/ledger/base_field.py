"""Propositions about the base field that determine whether inverses exist."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from hfield.algebra import structure
from hfield.checker.glossary import (
    ANISOTROPIC_NORM,
    LEVEL,
    NO_MEANING,
    NO_ORDER,
    NOT_APPLICABLE,
    ORDERING,
    PROVED,
    REFUTED,
    SUM_OF_SQUARES,
    UNDECIDED,
    WITNESS,
    ZERO_NORM,
)
from hfield.core.product import Constants, Coordinates, Scalar, norm
from hfield.errors import UndecidedError
from hfield.evidence import Evidence, Kind
from hfield.fields import quadratic_forms
from hfield.fields.base.ring import INFINITY, Ring
from hfield.ledger.scopes import search_panel
from hfield.notation import element_text
from hfield.prover.decision import Decision
from hfield.prover.steps import say

COUNTED_BELOW = 16  # the largest field over which all elements are gone through


def hamilton(F: Ring) -> Constants:
    """Return the structure constants of H(F)."""
    return Constants(F(-1), F(0), F(-1))


def texts(F: Ring, q: Coordinates) -> list[str]:
    """Write the coordinates of a witness."""
    return [F.text(x) for x in q]


def known_equal(F: Ring, x: Scalar, y: Scalar) -> bool | None:
    """Return whether x = y; None if they agree to all known digits, as in a local field.

    In a local field a number found by Hensel's lemma stands for the root that begins with its digits.
    """
    try:
        return F.equal(x, y)
    except UndecidedError:
        return None


def _no_single_field() -> Decision:
    return Decision(
        NOT_APPLICABLE,
        NO_MEANING,
        steps=(say("about-one-field"),),
    )


@dataclass(frozen=True)
class LevelAbove:
    """The claim that −1 is not a sum of ``bound`` squares in F; ``INFINITY`` means that F is
    formally real.
    """

    bound: float

    @property
    def text(self) -> str:
        """The fact in words."""
        if self.bound == INFINITY:
            return "F is formally real"
        squares = "a square" if self.bound == 1 else f"a sum of {self.bound} squares"
        return f"−1 is not {squares} in F"

    @property
    def statement(self) -> str:
        """The fact in the vocabulary of certificates."""
        return "formally-real" if self.bound == INFINITY else f"level-above{{{int(self.bound)}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Compare with the level of the field; a refutation gives squares that sum to −1."""
        if field is None:
            return _no_single_field()
        level = field.level
        if level.value is None:
            return Decision(UNDECIDED, LEVEL, tried=(level.reason,))
        if level.value > self.bound or level.value == INFINITY:
            return Decision(
                PROVED, LEVEL, steps=(say("level-is", level=level),), evidence=Evidence(Kind.LEVEL)
            )
        roots = field.minus_one_as_squares()
        total = field.zero
        for x in roots:
            total = total + x * x
        exact = known_equal(field, total, field(-1))
        if exact is False:
            return Decision(UNDECIDED, LEVEL, tried=(f"squares adding up to −1 in {field}",))
        shown = " + ".join(f"({field.text(x)})²" for x in roots)
        witness = {f"x{n}": [field.text(x)] for n, x in enumerate(roots, 1)}
        squares = Evidence(Kind.SQUARES, values=[field.text(x) for x in roots])
        evidence = squares if exact else None
        steps = (f"−1 = {shown}", *(() if exact else (say("level-is", level=level),)))
        return Decision(REFUTED, SUM_OF_SQUARES, witness=witness, steps=steps, evidence=evidence)


@dataclass(frozen=True)
class IsDivisionAlgebra:
    """The claim that every nonzero element of H(F) is invertible: only 0 has norm 0."""

    text: str = "every nonzero element of H(F) has an inverse"
    statement = "division"

    def decide(self, field: Ring | None) -> Decision:
        """Find a nonzero element of norm 0, or the reason why there is none."""
        if field is None:
            return _no_single_field()
        found = quadratic_forms.zero_norm(field, hamilton(field))
        if found.element is None:
            data = quadratic_forms.norm_evidence(
                f"(-1,-1|{field.name})", field, hamilton(field), found
            )
            if data is None:
                return Decision(UNDECIDED, ANISOTROPIC_NORM, tried=(found.reason,))
            evidence = Evidence(Kind.ANISOTROPIC, **data)
            steps = (say("norm-zero-only", reason=found.reason),)
            return Decision(PROVED, ANISOTROPIC_NORM, steps=steps, evidence=evidence)
        q = found.element
        step = say("has-norm-zero", q=element_text(field, q, "unicode", "e"))
        return Decision(
            REFUTED,
            ZERO_NORM,
            witness={"q": texts(field, q)},
            steps=(step, *_counted(field)),
            evidence=Evidence(Kind.ZERO_NORM, value=texts(field, q)),
        )


@lru_cache(maxsize=64)
def _counted(F: Ring) -> tuple[str, ...]:
    """Return the number of elements of H(F) of norm 0: by formula, and by enumeration over a small field."""
    if F.order is None:
        return ()
    formula = structure.count(F, hamilton(F), "norm", F.zero)
    if F.order > COUNTED_BELOW:
        return (say("norm-zero-count", n=formula.value, formula=formula.formula),)
    found = structure.confirm(F, hamilton(F))  # raises an error if formula and count differ
    zeros = found.norms[F.text(F.zero)]
    return (say("norm-zero-counted", n=zeros, m=found.elements, formula=formula.formula),)


@dataclass(frozen=True)
class PositiveNorm:
    """The claim that q is invertible if and only if N(q) > 0 (``sign`` = 1), for every ordering of F."""

    sign: int = 1

    @property
    def text(self) -> str:
        """The criterion as printed."""
        return f"q has an inverse if and only if N(q) {'>' if self.sign > 0 else '<'} 0"

    @property
    def statement(self) -> str:
        """The criterion in the vocabulary of certificates."""
        return f"norm-criterion{{{'>' if self.sign > 0 else '<'}}}"

    def decide(self, field: Ring | None) -> Decision:
        """Compare the criterion with N(q) ≠ 0 in the orderings of the field."""
        if field is None:
            return search_panel(self)
        one = (field.one, *(field.zero,) * 3)
        if field.characteristic:
            step = say("no-order", F=field, p=field.characteristic)
            return Decision(NOT_APPLICABLE, NO_ORDER, steps=(step,))
        if field.level.value == INFINITY and self.sign > 0:
            real = say("formally-real", F=field, reason=field.level.reason)
            steps = (real, say("norm-positive"))
            return Decision(PROVED, ORDERING, steps=steps, evidence=Evidence(Kind.ORDERING))
        candidates = [one] + ([(field.gen, *one[1:])] if field.gen_name else [])
        squares = field.minus_one_as_squares()
        if 0 < len(squares) <= 4:  # then −1 is a norm
            candidates.append((*squares, *one[len(squares) :]))
        for q in candidates:
            n = norm(hamilton(field), q)
            value = next(
                (m for m in range(-20, 21) if known_equal(field, n, field(m)) is not False), 0
            )
            if value * self.sign < 0:
                shown = element_text(field, q, "unicode", "e")
                step = say("inverse-though", q=shown, n=value)
                value_of_q = texts(field, q)
                exact = known_equal(field, n, field(value))
                evidence = Evidence(Kind.WITNESS, value=value_of_q, norm=value)
                return Decision(
                    REFUTED,
                    WITNESS,
                    witness={"q": value_of_q},
                    steps=(step,),
                    evidence=evidence if exact else None,
                )
        return Decision(
            UNDECIDED, ORDERING, tried=("multiples of e with a rational norm, and norms −1",)
        )
