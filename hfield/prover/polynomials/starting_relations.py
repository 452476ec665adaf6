"""Relations that a proof may use besides the clause."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import combinations
from typing import TYPE_CHECKING

from hfield.core.product import norm
from hfield.errors import TooLargeError
from hfield.fields.base.ring import Ring
from hfield.prover.polynomials.expansion import Expanded, Symbolic
from hfield.prover.polynomials.field_rules import relation
from hfield.prover.polynomials.vanishing import collected, factored, known, vanishes
from hfield.prover.problem import Problem, remembered
from hfield.prover.statements.language import BASIS, RESULT, Sort
from hfield.prover.statements.trees import walk
from hfield.syntax import Binary, Call, Compare, Name, Negate, Node, Power

if TYPE_CHECKING:
    import flint


MAX_NONZERO = 6
MAX_QUATERNIONS = 24
MAX_QUATERNION_TERMS = 200


def relations_of(x: Expanded, field: Ring | None) -> tuple[flint.fmpz_mpoly, ...]:
    """Return the known polynomial relations of the constants of the field.

    These are polynomials in one constant, and the equation of the unit circle for the cosine and sine of one
    angle.
    """
    if field is None:
        return ()
    out, free = [], []
    for n in range(x.unknowns, len(x.variables)):
        g, text = x.context.gens()[n], x.variables[n]
        found = relation(field, text)
        if found is not None:
            out.append(sum((c * g**k for k, c in enumerate(found)), x.context.constant(0)))
        elif text.startswith(("cos(", "sin(")):
            free.append((g, field(text)))
    for (g, c), (h, s) in combinations(free, 2):
        if field.is_zero(c * c + s * s - field.one):
            out.append(g**2 + h**2 - 1)
    return tuple(out)


def nonzero_constants_of(
    x: Expanded, field: Ring | None, polynomials: Iterable[flint.fmpz_mpoly]
) -> tuple[flint.fmpz_mpoly, ...]:
    """Return the nonzero factors of coefficients of polynomials, as polynomials in the constants of the
    field.

    Only if some constant satisfies no known relation; otherwise a relation determines the inverses.
    """
    if field is None or not x.has_constants:
        return ()
    free = [
        n for n in range(x.unknowns, len(x.variables)) if relation(field, x.variables[n]) is None
    ]
    found: dict[str, flint.fmpz_mpoly] = {}
    for f in polynomials if free else ():
        for coefficient in collected(f, range(x.unknowns)).values():
            for g, _ in factored(coefficient)[1]:
                if any(g.degrees()[n] for n in free) and known(vanishes, g, x, field) is False:
                    found.setdefault(str(g), g)
    return tuple(sorted(found.values(), key=len)[:MAX_NONZERO])


@remembered
def quaternions_of(
    problem: Problem,
) -> tuple[tuple[tuple[flint.fmpz_mpoly, ...], flint.fmpz_mpoly], ...]:
    """Return the quaternions in the statement and their vector parts, each with its norm."""
    world = Symbolic(problem)
    statement = problem.statement
    found: dict[str, tuple[tuple[flint.fmpz_mpoly, ...], flint.fmpz_mpoly]] = {}
    nodes = [n for h in (*statement.hypotheses, statement.conclusion) for n in walk(h)]
    for node in sorted(nodes, key=lambda n: not isinstance(n, Name)):
        if isinstance(node, Compare):  # the factors of a product are often compared with 0
            node = Binary("-", node.left, node.right)
        if not isinstance(node, Name | Binary | Power | Call) or is_scalar(node, statement.sorts):
            continue
        try:
            q, _ = world.term(node)
        except TooLargeError:  # smaller ones may do
            continue
        if not isinstance(q, tuple) or len(found) >= MAX_QUATERNIONS:
            continue
        if sum(map(len, q)) > MAX_QUATERNION_TERMS:
            continue
        for part in (q, (world.scalars.zero, *q[1:])):
            numerators = world.numerators(part)
            lifted = tuple(map(world.scalars.lift, numerators))
            norm_of = world.scalars.numerator(norm(world.constants, lifted))
            if any(not u.is_constant() for u in numerators):
                found.setdefault(str(numerators), (numerators, norm_of))
    return tuple(found.values())


def is_scalar(term: Node, sorts: Mapping[str, Sort]) -> bool:
    """Return whether a term is a scalar; constants of the field are scalars."""
    match term:
        case Name(name):
            return sorts.get(name) is not Sort.QUATERNION and name not in BASIS
        case Call(function, _):
            return RESULT.get(function) is not Sort.QUATERNION
        case Negate(x) | Power(x, _):
            return is_scalar(x, sorts)
        case Binary(_, x, y):
            return is_scalar(x, sorts) and is_scalar(y, sorts)
    return True  # a number or a coordinate
