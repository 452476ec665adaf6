"""Leading terms: norms whose four terms never cancel, over rational functions in several variables.

An order of the variables, each small or large, makes a valuation of k(x, y, …) with values in ℤⁿ, ordered as
in a dictionary: that of a polynomial is the least exponent in it. Where v(a) and v(b) are independent modulo
2, the terms of w² − a·x² − b·y² + ab·z² have four different values, and their sum is 0 only if all are. For
[a, b), with v(a) < 0 as well, w·x is larger than the lesser of w² and a·x², its value being larger than half
the sum of theirs. Nothing in this depends on k, nor on its characteristic.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations, product
from typing import TYPE_CHECKING, Any

from hfield.fields.function_fields.extensions import SimpleExtension
from hfield.fields.several_variables.ring import RationalFunctions
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.structure.forms import NormalForm
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm, none

if TYPE_CHECKING:
    from hfield.rings.flint_types import SparsePolynomial


MAX_VARIABLES = 4
Exponents = tuple[int, ...]


def by_leading_terms(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Look for an order of the variables in which the norm has no zero."""
    variables = _variables(ring)
    if not variables or any(ring.is_zero(x) for x in form.constants):
        return None
    for order in _orders(len(variables)):
        v, w = (_value(x, order) for x in form.constants)
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


def _variables(ring: Ring) -> tuple[str, ...]:
    """Return the variables of k(x, y, …), k perhaps an extension; () for any other ring."""
    if isinstance(ring, SimpleExtension):
        c = ring.modulus_coefficients
        constant = isinstance(ring.base, RationalFunctions) and all(
            x.num.is_constant() and x.den.is_constant() for x in c
        )
        return _variables(ring.base) if constant else ()
    if isinstance(ring, RationalFunctions) and len(ring.variables) <= MAX_VARIABLES:
        return ring.variables
    return ()


Order = tuple[tuple[int, ...], tuple[int, ...]]  # which variable comes first, and 1 or −1 for each


def _orders(n: int) -> Iterator[Order]:
    for signs in product((1, -1), repeat=n):
        for places in permutations(range(n)):
            yield places, signs


def _placed(exponents: Exponents, order: Order) -> Exponents:
    places, signs = order
    return tuple(signs[m] * exponents[m] for m in places)


def _value(x: Any, order: Order) -> Exponents:
    """Return the exponents of the leading term of a nonzero element; elements of k count for nothing."""
    parts = [x] if hasattr(x, "num") else [c for c in x.coefficients if c.num != 0]
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
