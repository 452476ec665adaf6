"""Zero norms over fields: written down over finite ones, found by the places over others, or by squares.

Leading terms: norms whose four terms never cancel, over rational functions in several variables.

An order of the variables, each small or large, makes a valuation of k(x, y, …) with values in ℤⁿ, ordered as
in a dictionary: that of a polynomial is the least exponent in it. Where v(a) and v(b) are independent modulo
2, the terms of w² − a·x² − b·y² + ab·z² have four different values, and their sum is 0 only if all are. For
[a, b), with v(a) < 0 as well, w·x is larger than the lesser of w² and a·x², its value being larger than half
the sum of theirs. Nothing in this depends on k, nor on its characteristic.
"""

from __future__ import annotations

from itertools import permutations, product
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

from hfield.core.product import Constants, Coordinates
from hfield.errors import UndecidedError
from hfield.rings.base import Ring
from hfield.structure.forms import NormalForm, normal_form
from hfield.structure.global_field import global_field
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm, found, none

if TYPE_CHECKING:
    from hfield.rings.flint_types import SparsePolynomial


def zero_norm_finite(ring: Ring, c: Constants) -> Coordinates:
    """Return a nonzero element of norm 0 of a nondegenerate algebra over GF(q), in O(log q) steps.

    In even characteristic every element is a square and ``N(i + s·j) = −a − b·s²``. In odd
    characteristic a product of two non-squares is a square, and a non-square is a sum of two squares.
    """
    a, t, b = c
    zero, one = ring.zero, ring.one
    if ring.characteristic == 2:
        return zero, one, _root(ring, ring.divide(a, b)), zero
    half = ring.inverse(ring(2))
    shift = t * half
    a = a + shift * shift  # the square of i − t/2
    root = ring.sqrt(a)
    if root is not None:
        return root - shift, one, zero, zero
    root = ring.sqrt(b)
    if root is not None:
        return root, zero, one, zero
    # a and b are non-squares: b = a·s², and 1/a = x² + y² gives a·(a·x)² + b·(a·y/s)² = a²
    s = _root(ring, ring.divide(b, a))
    target = ring.inverse(a)
    for x in ring.elements():
        y = ring.sqrt(target - x * x)
        if y is not None:
            u, v = a * x, ring.divide(a * y, s)
            return a - shift * u, u, v, zero
    raise UndecidedError(
        f"{ring.name} has a non-square that is no sum of two squares: not a field?"
    )


def _root(ring: Ring, x: object) -> object:
    root = ring.sqrt(x)
    if root is None:
        raise UndecidedError(
            f"{ring.name} gave no square root of {ring.text(x)}, which must have one"
        )
    return root


def by_places(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Decide by the ramified places; where there are none, solve the conic."""
    field = global_field(ring)
    if field is None:
        return by_leading_terms(ring, c, form)
    try:
        places = field.ramified(form)
    except UndecidedError:
        partial = field.ramified_at_small_places(form)
        if not partial:
            answer = by_leading_terms(ring, c, form)
            if answer is None:
                raise
            return answer
        return none(
            "ramified places",
            f"{field.why_ramified(form, partial)}, maybe elsewhere, too",
            partial,
            field.cited,
        )
    if places:
        return none("ramified places", field.why_ramified(form, places), places, field.cited)
    return field.unramified_zero(c, form)


def inseparable(ring: Ring, c: Constants) -> ZeroNorm:
    """Answer for characteristic 2 and t = 0, where the algebra is commutative and N is additive."""
    zero, one = ring.zero, ring.one
    a, _, b = c
    answer = by_leading_terms(ring, c, normal_form(ring, c))
    if answer is not None:
        return answer
    field = global_field(ring)
    if field is not None:
        # x = u² + g·v²: 1, a and b are dependent over the squares
        (u, v), (s, t) = field.square_parts(a), field.square_parts(b)
        q = (u, one, zero, zero) if ring.is_zero(v) else (u * t + s * v, t, v, zero)
        return found(ring, c, q, "squares", "1, a and b are linearly dependent over the squares")
    for square, unit in (
        (a, (one, zero, zero)),
        (b, (zero, one, zero)),
        (a * b, (zero, zero, one)),
    ):
        root = ring.sqrt(square)
        if root is not None:
            reason = f"{ring.text(square)} is a square in {ring.name}"
            return found(ring, c, (root, *unit), "square root", reason)
    raise UndecidedError(
        f"whether 1, a, b, ab are independent over the squares of {ring.name} is not decided"
    )


MAX_VARIABLES = 4
Exponents = tuple[int, ...]


@runtime_checkable
class Expanded(Protocol):
    """A field whose elements have leading terms, for every order of some variables."""

    @property
    def expanded_in(self) -> tuple[str, ...]:
        """The variables; () where elements have none after all."""

    def parts(self, x: Any) -> list[Any]:
        """Return fractions ``num/den`` whose leading terms do not cancel, of which x is made."""


def by_leading_terms(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Look for an order of the variables in which the norm has no zero."""
    if not isinstance(ring, Expanded):
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


def _value(parts: list[Any], order: Order) -> Exponents:
    """Return the exponents of the leading term of a nonzero element; elements of k count for nothing."""
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
