"""Left, right and two-sided ideals of an algebra over a finite field or ℤ/n.

The left ideals of M₂(F) other than 0 and all are the points of the projective line: the matrices whose rows
are multiples of one row. In other algebras every ideal is a sum of principal ones, which zero divisors
generate. Over ℤ/n an ideal is the product of ideals modulo the prime powers of n.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from itertools import product
from math import prod

from hfield.algebra import structure
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.factorisation import factorise
from hfield.errors import TooLargeError
from hfield.exploring.conjugacy_classes import splitting
from hfield.exploring.elements import Elements
from hfield.exploring.labels import labelled, order_of_ring
from hfield.exploring.properties import Condition
from hfield.exploring.submodules import Submodule, check_listed, products
from hfield.exploring.unit_groups import prime_power_parts
from hfield.fields import quadratic_forms
from hfield.fields.base.modular import Modular

MAX_GENERATORS = 100_000
"""The greatest number of generators of principal ideals that are tried, or points of the projective line."""


class AlgebraIdeal(Submodule):
    """An ideal of an algebra: ``side`` is ``left``, ``right`` or ``two-sided``.

    ``generator`` generates it as such an ideal; it is None for one that is not principal.

    >>> from hfield import H
    >>> I = H("GF(3)").left_ideals()[1]
    >>> I.dimension, I.basis, all(q * I.generator in I for q in H("GF(3)").basis)
    (2, (1 + j + k, i + 2*j + k), True)
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
    """Return all ideals of a side over a finite field or ℤ/n, 0 and the algebra included, small ones first.

    Over an infinite field those of a division algebra, and the two-sided ones of a simple algebra, are 0
    and all; others raise :class:`NotFiniteError`. Raises :class:`RingError` over other rings, and
    :class:`TooLargeError`.
    """
    nothing = AlgebraIdeal(algebra, side, [], algebra.zero)
    everything = AlgebraIdeal(algebra, side, algebra.basis, algebra.one)
    ring, c = algebra.ring, algebra.constants
    simple = bool(ring.is_field) and structure.is_central_simple(ring, c)
    if side == "two-sided" and simple:
        return nothing, everything
    if ring.order is None and ring.is_field and quadratic_forms.is_division(ring, c):
        return nothing, everything
    q = check_listed(algebra, f"{side} ideals")
    parts = prime_power_parts(algebra)
    if len(parts) > 1:
        return _products_of_parts(algebra, side, [ideals(part, side) for part in parts])
    if simple:
        _check_number(algebra, q + 1)
        between = [_generated(algebra, side, x) for x in _projective_line(algebra, side)]
    else:
        between = _proper(algebra, side)
    return nothing, *between, everything


def _products_of_parts(
    algebra: Parent, side: str, parts: list[tuple[AlgebraIdeal, ...]]
) -> tuple[AlgebraIdeal, ...]:
    """Return the ideals over ℤ/n from those modulo its prime powers, of which n is the product."""
    total = prod(map(len, parts))
    if total > MAX_GENERATORS:
        raise TooLargeError(
            f"{algebra} has {total} {side} ideals, more than the {MAX_GENERATORS} that are listed"
        )
    found = []
    for chosen in product(*parts):
        elements = [_lifted(algebra, x) for ideal in chosen for x in ideal.basis]
        generators = [_lifted(algebra, x) for ideal in chosen if (x := ideal.generator) is not None]
        generator = sum(generators, algebra.zero) if len(generators) == len(chosen) else None
        found.append(AlgebraIdeal(algebra, side, elements, generator))
    return tuple(sorted(found, key=lambda ideal: ideal.cardinality()))


def _lifted(algebra: Parent, x: Quaternion) -> Quaternion:
    """Return the element over ℤ/n that is x modulo a prime power q of n, and 0 modulo n/q."""
    n, q = order_of_ring(algebra), order_of_ring(x.algebra)
    idempotent = n // q * pow(n // q, -1, q)
    return algebra(*(idempotent * int(c) for c in x.coordinates))


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


_PRODUCTS: dict[str, Callable[[Sequence[Quaternion], Quaternion], list[Quaternion]]] = {
    "left": lambda basis, x: [u * x for u in basis],
    "right": lambda basis, x: [x * u for u in basis],
    "two-sided": lambda basis, x: products([u * x for u in basis], basis),
}


def _generated(algebra: Parent, side: str, x: Quaternion) -> AlgebraIdeal:
    return AlgebraIdeal(algebra, side, _PRODUCTS[side](algebra.basis, x), x)


def _proper(algebra: Parent, side: str) -> list[AlgebraIdeal]:
    """Return the ideals other than 0 and all: principal ones, then their sums."""
    found: dict[Hashable, AlgebraIdeal] = {}
    for x in _up_to_scalars(algebra):
        ideal = _generated(algebra, side, x)
        if algebra.one not in ideal:  # a two-sided ideal may contain units
            found.setdefault(ideal.key, ideal)
    principal = list(found.values())
    queue = list(principal)
    while queue:
        one = queue.pop()
        for other in principal:
            if not other <= one:
                total = AlgebraIdeal(algebra, side, [*one.basis, *other.basis], None)
                if algebra.one not in total and total.key not in found:
                    found[total.key] = total
                    queue.append(total)
    return sorted(found.values(), key=lambda ideal: ideal.length)


def _up_to_scalars(algebra: Parent) -> list[Quaternion]:
    """Return the zero divisors whose first coordinate that is not 0 is 1, or over ℤ/pᵏ a power of p."""
    labels = labelled(algebra)
    elements = Elements(algebra, Condition("zero divisors"))
    q = labels.q
    leading, scalars = [1], q - 1
    if isinstance(algebra.ring, Modular):
        ((p, k),) = factorise(q).items()
        leading = [p**n for n in range(k)]
        scalars = q - q // p
    _check_number(algebra, elements.cardinality() // scalars)
    found: list[Quaternion] = []
    for numbers in elements.numbers():
        # the numbers with a leading digit d lie in [d, d + 1), [dq, (d + 1)q), … [dq³, (d + 1)q³)
        for power in (1, q, q**2, q**3):
            for d in leading:
                inside = numbers[(numbers >= d * power) & (numbers < (d + 1) * power)]
                found += [labels.element(int(n)) for n in inside]
    return found
