"""Common slots over ℚ(x), by search: q times norms from F(i), so that (p, e) = (p, q) holds of itself.

They are tried until (a, e) = (a, b) holds too.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from hfield.errors import UndecidedError
from hfield.fields.function_fields.ring import FunctionField
from hfield.product import Constants
from hfield.structure.forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.fields.function_fields.quotients import Quotient


TRIALS = 600

SameClass = Callable[[NormalForm, NormalForm], bool]


def searched_slot(
    ring: FunctionField, outer: Constants, inner: Constants, same_class: SameClass
) -> Any:
    """Return a common slot of two isomorphic algebras (a, b | ℚ(x)) by search."""
    for m, n in itertools.islice(_small_pairs(ring), TRIALS):
        for first, second in ((inner, outer), (outer, inner)):
            e = first.b * (m * m - first.a * (n * n))
            if ring.is_zero(e):
                continue
            forms = [normal_form(ring, Constants(second.a, ring.zero, x)) for x in (e, second.b)]
            if same_class(*forms):
                return e
    raise UndecidedError(
        f"an isomorphism exists, but none with small numbers was found over {ring.name}"
    )


def _small_pairs(ring: FunctionField) -> Iterator[tuple[Quotient, Quotient]]:
    """Run through pairs of small polynomials over ℚ, not both 0."""
    seen: list[Any] = []
    for x in _small(ring):
        seen.append(x)
        for y in seen[:-1]:
            yield x, y
            yield y, x


def _small(ring: FunctionField) -> Iterator[Quotient]:
    """Run through small polynomials, 0 and 1 first."""
    yield ring.zero
    yield ring.one
    digits = [ring(x) for x in (0, 1, -1, 2)]
    for degree in itertools.count(1):
        for leading, *rest in itertools.product(digits, repeat=degree + 1):
            if not ring.is_zero(leading):
                value = leading
                for x in rest:
                    value = value * ring.gen + x
                yield value
