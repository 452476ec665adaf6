"""A place where given polynomials are not 0: always found, one variable after the other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, count, islice
from typing import TYPE_CHECKING, Any

from hfield.errors import HFieldError
from hfield.product import Scalar
from hfield.proving.counterexamples.candidates import small_scalars
from hfield.proving.evaluation.searcher import Assignment, assigned
from hfield.proving.polynomials.expansion import Expanded
from hfield.proving.polynomials.vanishing import Monomial, coefficients
from hfield.proving.problem import Problem
from hfield.rings.base import Ring
from hfield.rings.powers import power

if TYPE_CHECKING:
    import flint


MAX_VALUES = 1_000


def nonzero_place(
    problem: Problem, x: Expanded, polynomials: Sequence[flint.fmpz_mpoly]
) -> Assignment | None:
    """Return values of the unknowns at which none of the polynomials is 0.

    Over an infinite field there is such a place for polynomials that are not 0; over a finite one
    for a single polynomial that is not 0 as a function. 0 is the last value for letters.
    """
    field = problem.ring
    left = [dict(coefficients(p, x, field, field.order)) for p in polynomials]
    if not all(left):
        return None
    values: list[Any] = []
    for name in x.variables[: x.unknowns]:
        for value in values_of(field, name in problem.letters):
            tried = [_substitute(f, value, field) for f in left]
            if all(tried):
                left, values = tried, [*values, value]
                break
        else:
            return None
    return assigned(problem.statement, values)


def _substitute(f: dict[Monomial, Scalar], value: Scalar, field: Ring) -> dict[Monomial, Scalar]:
    """Put a value in for the first variable."""
    out: dict[Monomial, Any] = {}
    for monomial, c in f.items():
        term = c * power(field.one, value, monomial[0]) if monomial[0] else c
        rest = monomial[1:]
        out[rest] = out[rest] + term if rest in out else term
    return {m: c for m, c in out.items() if not field.is_zero(c)}


def values_of(field: Ring, nonzero: bool = False) -> Iterator[Scalar]:
    """Run through distinct elements of a field, small ones first: all, or a thousand of them.

    With ``nonzero``, 0 comes last.
    """
    values = islice(_values(field), MAX_VALUES)
    return chain(islice(values, 1, None), [field.zero]) if nonzero else values


def _values(field: Ring) -> Iterator[Scalar]:
    if field.order is not None:
        yield from field.elements()
        return
    yield from small_scalars(field)
    try:
        g = field.gen if field.characteristic else field(3)
    except HFieldError:
        return
    x = g * g if field.characteristic else g
    for _ in count():
        yield x
        x = x * g if field.characteristic else x + field.one
