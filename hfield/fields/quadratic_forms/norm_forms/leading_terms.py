"""Leading terms: norms whose four terms never cancel, over rational functions in several variables.

An order of the variables, each small or large, defines a valuation of k(x, y, …) with values in ℤⁿ, ordered
lexicographically: the value of a polynomial is its least exponent. If v(a) and v(b) are independent modulo 2,
the terms of w² − a·x² − b·y² + ab·z² have four different values, so their sum is 0 only if all are 0. For [a,
b) with also v(a) < 0, the term w·x has a larger value than the smaller of w² and a·x², because its value
exceeds half the sum of theirs. Nothing here depends on k or its characteristic.
"""

from __future__ import annotations

from itertools import permutations, product
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from hfield.core.product import Constants, Scalar
from hfield.fields.base.ring import Ring
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, none
from hfield.fields.quadratic_forms.normal_forms import NormalForm

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hfield.fields.base.flint_types import SparsePolynomial
    from hfield.fields.function_fields.quotients import RationalFunction


MAX_VARIABLES = 4
Exponents = tuple[int, ...]


@runtime_checkable
class ExpandedConstants(Protocol):
    """A field whose elements have leading terms, for every order of some variables."""

    @property
    def expanded_in(self) -> tuple[str, ...]:
        """The variables; () if elements have no leading terms after all."""

    def parts(self, x: Scalar) -> Sequence[RationalFunction]:
        """Return the fractions ``num/den`` whose sum is x; their leading terms do not cancel."""


def by_leading_terms(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Search for an order of the variables that shows that the norm has no nontrivial zero."""
    if not isinstance(ring, ExpandedConstants):
        return None
    variables, parts = ring.expanded_in, ring.parts
    if not 0 < len(variables) <= MAX_VARIABLES or any(ring.is_zero(x) for x in form.constants):
        return None
    n = len(variables)
    for signs, first in product(product((1, -1), repeat=n), permutations(range(n))):
        order = first, signs
        v, w = (_value(parts(x), order) for x in form.constants)
        below = form.kind == "symbol" or _placed(v, order) < (0,) * len(v)
        classes = {tuple(n % 2 for n in x) for x in (v, w, (0,) * len(v))}
        if below and len(classes) == 3:
            shown = " and ".join(_monomial(variables, x) for x in (v, w))
            reason = (
                f"the leading terms {shown} of {ring.text(form.a)} and {ring.text(form.b)} are independent "
                "up to squares, so that the terms of the norm never cancel"
            )
            return none("leading terms", reason)
    return None


Order = tuple[tuple[int, ...], tuple[int, ...]]  # which variable comes first, and 1 or −1 for each


def _placed(exponents: Exponents, order: Order) -> Exponents:
    places, signs = order
    return tuple(signs[m] * exponents[m] for m in places)


def _value(parts: Sequence[RationalFunction], order: Order) -> Exponents:
    """Return the exponents of the leading term of a nonzero element; elements of k do not contribute."""
    values = [
        tuple(a - b for a, b in zip(_least(c.num, order), _least(c.den, order), strict=True))
        for c in parts
    ]
    return min(values, key=lambda e: _placed(e, order))


def _least(poly: SparsePolynomial, order: Order) -> Exponents:
    exponents = (tuple(int(n) for n in e) for e, _ in poly.terms())
    return min(exponents, key=lambda e: _placed(e, order))


def _monomial(variables: tuple[str, ...], exponents: Exponents) -> str:
    powers = zip(variables, exponents, strict=True)
    return "*".join(f"{v}^{n}" if n != 1 else v for v, n in powers if n) or "1"
