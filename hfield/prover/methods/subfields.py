"""Decide statements over ℚ_p in number fields that lie in ℚ_p, where numbers are exact.

A zero of a norm, or a root, that Hensel's lemma finds is known to some digits only, and no statement is
evaluated at it. But it lies in an extension of ℚ, whose generator Hensel's lemma finds in ℚ_p: there it is
exact. Tried are some ℚ(√d), and fields that a root of an equation in the statement generates. What is false
somewhere in a subfield is false over ℚ_p, and what exists in a subfield exists.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterator
from dataclasses import replace
from itertools import islice
from typing import Protocol, runtime_checkable

import flint

from hfield.core.product import Constants, Scalar, conjugate, multiply, norm, trace
from hfield.errors import HFieldError, TooLargeError
from hfield.evidence import Evidence, Kind
from hfield.fields import QQ
from hfield.fields.algebraic.radicands import reduced
from hfield.fields.base.ring import Ring, WithIntegers
from hfield.fields.base.roots import integral, irreducible_factors, near_root
from hfield.fields.names import ring
from hfield.fields.quadratic_forms.global_field import known_field
from hfield.fields.quadratic_forms.normal_forms import normal_form
from hfield.prover.decision import PROVED, REFUTED, Decision
from hfield.prover.polynomials.expansion import Symbolic
from hfield.prover.polynomials.normal_form import branches
from hfield.prover.problem import Problem
from hfield.prover.steps import say
from hfield.syntax import Not

ROOT_DIGITS = 6  # digits of a root
GENERATOR = "g"  # no unknown has that name
MAX_DEGREE = 20
FIELDS, SECONDS = 3, 5.0  # so many subfields are tried, for so long each
SUBFIELD_RADICANDS = (-1, 2, -2, 3, -3, 5, -5, 6, -6, 7, -7, 10, -11, 17)


class LocalNumber(Scalar, Protocol):
    """An element of a local field: ``value`` is one of the global field, which it is or is near."""

    value: flint.fmpq
    field: CompletionAtPlace

    @property
    def is_exact(self) -> bool:
        """Whether it is an element of the global field."""


class PrimeBelow(Protocol):
    """A place of ℚ, by its prime number."""

    below: int


@runtime_checkable
class CompletionAtPlace(Protocol):
    """A local field: the completion of a global one at a finite place."""

    global_field: Ring
    place: Hashable
    residues: PrimeBelow

    @property
    def zero(self) -> LocalNumber:
        """The element 0."""

    def __call__(self, x: object) -> LocalNumber:
        """Return an element of the field."""

    def text(self, x: LocalNumber) -> str:
        """Return the text of an element."""

    def is_square(self, x: LocalNumber) -> bool:
        """Return whether x is a square."""

    def sqrt(self, x: LocalNumber) -> LocalNumber | None:
        """Return a square root to some digits."""

    def truncated(self, x: flint.fmpq, n: int) -> flint.fmpq:
        """Return the standard element of the global field that is x up to n digits."""

    def up_to(self, x: flint.fmpq, n: int) -> LocalNumber:
        """Return x with an O() after n digits."""


def decide_in_subfields(problem: Problem, decide: Callable[[Problem], Decision]) -> Decision | None:
    """Return a decision over a subfield ℚ(√d) of ℚ_p that holds over ℚ_p too, or None."""
    F, statement = problem.field, problem.statement
    if not isinstance(F, CompletionAtPlace) or F.global_field != QQ or problem.setting.letters:
        return None
    bound = set(statement.exists)
    if bound and statement.given:
        return None
    wanted = PROVED if bound else REFUTED
    for K, near in _subfields(F, problem):
        try:
            decision = decide(problem.within(SECONDS).over(K))
        except HFieldError:
            continue
        if decision.verdict == wanted:
            root = F.up_to(near, ROOT_DIGITS)
            step = say("in-subfield", K=K, F=F, x=K.gen_name, root=root)
            return replace(
                decision,
                witness={
                    name: [_read_back(K, root, text) for text in texts]
                    for name, texts in (decision.witness or {}).items()
                },
                steps=(step, *decision.steps),
                scope=None,
                evidence=_evidence(K, near, decision),
            )
    return None


def _evidence(K: Ring, near: flint.fmpq, decision: Decision) -> Evidence | None:
    """Return the witness with a number so near the generator that Hensel's lemma finds it."""
    found = decision.evidence
    if found is None or found.kind is not Kind.WITNESS:
        return None
    return Evidence(Kind.SUBFIELD, ring=K.data, root=QQ.text(near), witness=found)


def _read_back(K: Ring, root: LocalNumber, text: str) -> str:
    """Write an element of K as ℚ_p reads it: I as a root, a generator of higher degree in digits."""
    if isinstance(K, WithIntegers) and K.degree == 2:
        return re.sub(r"\bI\b", "sqrt(-1)", text)
    F, total = root.field, root.field.zero
    for c in reversed(K(text).poly.coeffs()):
        total = total * root + F(c)
    return str(F.text(total))


def _subfields(F: CompletionAtPlace, problem: Problem) -> Iterator[tuple[Ring, flint.fmpq]]:
    """Yield subfields of ℚ_p, each with a rational number near its generator."""
    for d in _radicands(F, problem):
        square_root = F.sqrt(F(d))
        assert square_root is not None, "d is a square"
        yield ring(f"QQ(sqrt({d}))"), F.truncated(square_root.value, ROOT_DIGITS)
    for f in _of_the_equations(problem):
        root = near_root(f, F.residues.below, ROOT_DIGITS)
        if root is not None:
            yield ring(f"QQ[{GENERATOR}]/({f})"), QQ(root)


def _of_the_equations(problem: Problem) -> Iterator[flint.fmpz_poly]:
    """Yield the irreducible polynomials of degree 3 and more, monic over ℤ, of equations in one unknown."""
    node = problem.matrix if problem.statement.exists else Not(problem.matrix)
    try:
        world = Symbolic(problem.for_formula(node).over(QQ))
        ways = list(islice(branches(world.truth(node)), FIELDS))
    except TooLargeError:
        return
    for f in (f for way in ways for literal in way if literal.zero for f in literal.polynomials):
        used = [n for n, degree in enumerate(f.degrees()) if degree]
        if len(used) == 1 and f.total_degree() <= MAX_DEGREE:
            dense = [flint.fmpq(0)] * (f.total_degree() + 1)
            for exponents, c in f.terms():
                dense[int(exponents[used[0]])] = flint.fmpq(c)
            yield from (integral(g) for g in irreducible_factors(dense) if g.degree() > 2)


def _radicands(F: CompletionAtPlace, problem: Problem) -> Iterator[int]:
    """Yield a few d that are squares in F, first one for which the algebra splits over ℚ(√d)."""
    found: list[int] = []
    for d in (*_of_the_algebra(F, problem), *SUBFIELD_RADICANDS):
        free = reduced(d)[1] if d else 1
        if free != 1 and free not in found and len(found) < FIELDS and F.is_square(F(free)):
            found.append(free)
            yield free


def _of_the_algebra(F: CompletionAtPlace, problem: Problem) -> Iterator[int]:
    """Yield T² − 4·N(q)·N(u) for a plane of q and u on which the norm has a zero in ℚ_p."""
    exact = [F(text) for text in problem.setting.constants]
    if not all(x.is_exact for x in exact):
        return
    a, t, b = (x.value for x in exact)
    c = Constants(a, t, b)
    form = normal_form(QQ, c)
    if form.a == 0 or form.b == 0:
        return
    plane = known_field(QQ).hyperbolic_plane(c, F.place)
    if plane is not None:
        q, u = (tuple(QQ(x) for x in v) for v in plane)
        mixed = trace(c, multiply(c, q, conjugate(c, u)))
        d = mixed * mixed - 4 * norm(c, q) * norm(c, u)
        yield int(d.p * d.q)
