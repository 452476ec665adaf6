"""Left, right and two-sided ideals of an algebra over a finite field.

The left ideals of M₂(F) other than 0 and all are the points of the projective line: the matrices whose rows
are multiples of one row. In other algebras every ideal is a sum of principal ones, which zero divisors
generate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from hfield import structure
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import TooLargeError
from hfield.exploring.classes import splitting
from hfield.exploring.elements import Elements
from hfield.exploring.labels import labelled
from hfield.exploring.properties import Condition
from hfield.exploring.subspaces import Subspace, check_finite_field, products

MAX_GENERATORS = 100_000
"""The greatest number of generators of principal ideals that are tried, or points of the projective line."""


class AlgebraIdeal(Subspace):
    """An ideal of an algebra: ``side`` is ``left``, ``right`` or ``two-sided``.

    ``generator`` generates it as such an ideal; it is None for one that is not principal.

    >>> from hfield import H
    >>> I = H("GF(3)").left_ideals()[1]
    >>> I.dimension, I.basis, all(q * I.generator in I for q in H("GF(3)").basis)
    (2, (1 + j + k, i + 2j + k), True)
    """

    def __init__(
        self,
        algebra: Parent,
        side: str,
        elements: Iterable[Quaternion],
        generator: Quaternion | None,
    ) -> None:
        super().__init__(algebra, elements)
        self.side, self.generator = side, generator

    def __repr__(self) -> str:
        return f"<{self.side} ideal of {self.algebra}: {self.span_text}>"


def ideals(algebra: Parent, side: str) -> tuple[AlgebraIdeal, ...]:
    """Return all ideals of a side over a finite field, 0 and the algebra included, small ones first.

    Over an infinite field those of a division algebra, and the two-sided ones of a simple algebra, are 0
    and all; others raise :class:`NotFiniteError`. Raises :class:`RingError` over rings that are no fields.
    """
    nothing = AlgebraIdeal(algebra, side, [], algebra.zero)
    everything = AlgebraIdeal(algebra, side, algebra.basis, algebra.one)
    ring, c = algebra.ring, algebra.constants
    simple = structure.is_central_simple(ring, c)
    if side == "two-sided" and simple:
        return nothing, everything
    if ring.order is None and ring.is_field and structure.is_division(ring, c):
        return nothing, everything
    q = check_finite_field(algebra, f"{side} ideals")
    if simple:
        _check_number(algebra, q + 1)
        between = [_generated(algebra, side, x) for x in _projective_line(algebra, side)]
    else:
        between = _proper(algebra, side)
    return nothing, *between, everything


def _check_number(algebra: Parent, n: int) -> None:
    if n > MAX_GENERATORS:
        raise TooLargeError(
            f"the ideals of {algebra} are among {n} that elements generate, and {MAX_GENERATORS} are tried"
        )


def _projective_line(algebra: Parent, side: str) -> list[Quaternion]:
    """Return matrices of rank 1 with one row, or one column, for each point of the projective line."""
    ring = algebra.ring
    o, e = ring.zero, ring.one
    matrices = splitting(algebra)
    found = []
    for s, t in [(o, e), *((e, x) for x in ring.elements())]:
        matrix = ((s, t), (o, o)) if side == "left" else ((s, o), (t, o))
        found.append(Quaternion(algebra, matrices.from_matrix(matrix)))
    return found


_PRODUCTS: dict[str, Callable[[Any, Quaternion], list[Quaternion]]] = {
    "left": lambda basis, x: [u * x for u in basis],
    "right": lambda basis, x: [x * u for u in basis],
    "two-sided": lambda basis, x: products([u * x for u in basis], basis),
}


def _generated(algebra: Parent, side: str, x: Quaternion) -> AlgebraIdeal:
    return AlgebraIdeal(algebra, side, _PRODUCTS[side](algebra.basis, x), x)


def _proper(algebra: Parent, side: str) -> list[AlgebraIdeal]:
    """Return the ideals other than 0 and all: principal ones, then their sums."""
    found: dict[Any, AlgebraIdeal] = {}
    for x in _up_to_scalars(algebra):
        ideal = _generated(algebra, side, x)
        if ideal.dimension < 4:  # a two-sided ideal may contain units
            found.setdefault(ideal.key, ideal)
    principal = list(found.values())
    queue = list(principal)
    while queue:
        one = queue.pop()
        for other in principal:
            if not other <= one:
                total = AlgebraIdeal(algebra, side, [*one.basis, *other.basis], None)
                if total.dimension < 4 and total.key not in found:
                    found[total.key] = total
                    queue.append(total)
    return sorted(found.values(), key=lambda ideal: ideal.dimension)


def _up_to_scalars(algebra: Parent) -> list[Quaternion]:
    """Return the zero divisors whose first coordinate that is not 0 is 1."""
    labels = labelled(algebra)
    elements = Elements(algebra, Condition("zero divisors"))
    q = labels.q
    _check_number(algebra, elements.cardinality() // max(q - 1, 1))
    found: list[Quaternion] = []
    for numbers in elements.numbers():
        # the numbers with a leading digit 1 lie in [1, 2), [q, 2q), [q², 2q²), [q³, 2q³)
        for power in (1, q, q**2, q**3):
            inside = numbers[(numbers >= power) & (numbers < 2 * power)]
            found += [labels.element(int(n)) for n in inside]
    return found
