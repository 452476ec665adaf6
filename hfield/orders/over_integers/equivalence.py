"""Which element carries one lattice over the integers into another, or one order, in definite algebras.

``J = c·I`` means that c lies in J·I⁻¹ and that N(c) generates N(J)/N(I). For each totally positive generator,
modulo squares of units, c would be a vector of least conceivable length of a positive form
(:mod:`hfield.orders.short_elements`). An isomorphism of orders is a conjugation (Skolem and
Noether), hence an isometry of trace-0 parts, and is known by the images of two elements that do not commute.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import count
from typing import TYPE_CHECKING, Any

import flint

from hfield.evidence import Certified, Claim
from hfield.orders.enumeration import short_vectors, vectors_of_length
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.over_integers.positive_generators import (
    totally_positive_generator,
    units_modulo_squares,
)
from hfield.orders.short_elements import expect_definite, reduced, rows_of_norm, ternary_rows

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.orders.basis import AlgebraBasis


@dataclass(frozen=True)
class Comparison(Certified):
    """True or false in an ``if``; ``element`` proves a true answer, ``reason`` says how it was decided."""

    holds: bool
    reason: str
    element: Quaternion | None = None
    claimed: Callable[[Quaternion | None], Claim] | None = field(
        default=None, compare=False, repr=False
    )

    @cached_property
    def claim(self) -> Claim:
        """The answer as a statement with its evidence."""
        assert self.claimed is not None, "orders and ideals say what was asked of them"
        return self.claimed(self.element)

    def __bool__(self) -> bool:
        return self.holds

    def __repr__(self) -> str:
        shown = "" if self.element is None else f" with {self.element}"
        return f"{'yes' if self.holds else 'no'}{shown}: {self.reason}"


def element_generating(lattice: LatticeValue, norm: Ideal) -> Comparison:
    """Return an element of a lattice whose norm generates an ideal, or why there is none.

    Raises :class:`IndefiniteError` unless the algebra is totally definite.
    """
    ambient, base = lattice.ambient, lattice.ambient.base
    expect_definite(ambient, "equivalence()")
    generator = totally_positive_generator(norm)
    if generator is None:
        return Comparison(
            False, f"the norm would be a totally positive generator of {norm}, which has none"
        )
    units = units_modulo_squares(base.ring)
    for u in units:
        for row in rows_of_norm(lattice, generator * u):
            return Comparison(
                True, "the element is multiplied out", ambient.quaternion(row.entries())
            )
    shown = ", ".join(base.ring.text(base.outside(generator * u)) for u in units)
    return Comparison(
        False,
        f"no element of the lattice between them has a norm among {shown}, up to squares of units",
    )


# --- isomorphisms of orders ------------------------------------------------------------------------


def conjugator(first: LatticeValue, second: LatticeValue) -> Comparison:
    """Return x with x·O·x⁻¹ = O' for two orders, or why there is none. Raises :class:`IndefiniteError`."""
    ambient = first.ambient
    expect_definite(ambient, "isomorphism()")
    one, other = _Ternary(first), _Ternary(second)
    a, b = one.two_generators()
    norms = [ambient.norm(x.entries()) for x in (a, b)]
    images = [other.of_norm(norm) for norm in norms]
    between, inverse, tried = one.pairing(a, b), second.inverse_rows, 0
    for s in images[0]:
        for t in images[1]:
            product = one.pairing(s, t)
            if product not in (between, -between):
                continue
            for sign in (1, -1):
                for u in (t, -t) if not between else (t if product == between else -t,):
                    tried += 1
                    x = _intertwiner(ambient, (a, b), (s * sign, u * sign))
                    # x·O ⊂ O'·x, and the discriminants are the same
                    moved = first.rows * ambient.times(x, "left")
                    back = moved * ambient.times(x.entries()).inv() * inverse
                    if back.numer_denom()[1] == 1:
                        return Comparison(
                            True,
                            "the element conjugates one into the other",
                            ambient.quaternion(x.entries()),
                        )
    return Comparison(
        False,
        f"of the {tried} pairs in the trace-0 part of ℤ_K + 2O with the norms and the inner product of two "
        "elements of the other none comes from a conjugation that maps one order onto the other",
    )


class _Ternary:
    """The elements 2x − tr(x) for x in an order, a lattice of rank 3n over ℤ."""

    def __init__(self, order: LatticeValue) -> None:
        self.ambient, self.basis = order.ambient, ternary_rows(order)

    def two_generators(self) -> tuple[flint.fmpq_mat, flint.fmpq_mat]:
        """Return two short elements that do not commute, the first of them as short as possible."""
        gram, basis, _ = reduced(self.ambient, self.basis, self.ambient.base.field.one)
        least = min(gram[k][k] for k in range(len(gram)))
        for bound in count(1):
            found = sorted(short_vectors(gram, bound * least), key=lambda pair: pair[1])
            rows = [flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis for x, _ in found]
            for row in rows[1:]:
                if not self._commute(rows[0], row):
                    return rows[0], row
        raise AssertionError("a quaternion algebra is not commutative")

    def _commute(self, x: flint.fmpq_mat, y: flint.fmpq_mat) -> bool:
        times = self.ambient.times
        return bool(x * times(y) == y * times(x))

    def of_norm(self, norm: FieldElement) -> list[flint.fmpq_mat]:
        """Return one of ±x for each element of a norm."""
        gram, basis, den = reduced(self.ambient, self.basis, self.ambient.base.field.one)
        length = 2 * den * norm.trace()
        if length.q != 1:
            return []
        rows = (
            flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis
            for x in vectors_of_length(gram, int(length.p))
        )
        return [row for row in rows if self.ambient.norm(row.entries()) == norm]

    def pairing(self, x: flint.fmpq_mat, y: flint.fmpq_mat) -> Any:
        """Return N(x + y) − N(x) − N(y)."""
        norm = self.ambient.norm
        return norm((x + y).entries()) - norm(x.entries()) - norm(y.entries())


def two_generators(order: LatticeValue) -> tuple[flint.fmpq_mat, flint.fmpq_mat]:
    """Return two elements of an order that do not commute: they generate the algebra."""
    return _Ternary(order).two_generators()


def _intertwiner(
    ambient: AlgebraBasis, sources: tuple[flint.fmpq_mat, ...], targets: tuple[flint.fmpq_mat, ...]
) -> flint.fmpq_mat:
    """Return x ≠ 0 with x·s = t·x for two pairs s, t with the same norms and inner products."""
    columns: list[Any] = []
    for s, t in zip(sources, targets, strict=True):
        columns += (ambient.times(s.entries()) - ambient.times(t, "left")).transpose().tolist()
    whole = flint.fmpq_mat(columns).numer_denom()[0]
    kernel, rank = whole.nullspace()
    assert rank == ambient.degree, "two elements that do not commute generate the algebra"
    return flint.fmpq_mat([[kernel[k, 0] for k in range(ambient.size)]])


def unit_index(order: LatticeValue) -> int:
    """Return [Oˣ : ℤ_Kˣ] for an order. Raises :class:`IndefiniteError` where it is infinite."""
    return sum(1 for _ in units(order))


def units(order: LatticeValue) -> Iterator[flint.fmpq_mat]:
    """Yield one of each coset of ℤ_Kˣ in the units of an order."""
    expect_definite(order.ambient, "units()")
    for u in units_modulo_squares(order.ambient.base.ring):
        yield from rows_of_norm(order, u)


def unit_group(order: LatticeValue) -> str:
    """Return the name of the group of units modulo those of the field: ``C4 D2 D6 A4 S4 A5`` and so on.

    It is a finite group of rotations; its order and the largest order of an element tell it.
    """
    found = list(units(order))
    size, largest = len(found), max(_order(order.ambient, row) for row in found)
    if largest == size:
        return f"C{size}"
    if 2 * largest == size:
        return f"D{largest}"
    return {12: "A4", 24: "S4", 60: "A5"}[size]


def _order(ambient: AlgebraBasis, row: flint.fmpq_mat) -> int:
    """Return the order of a unit modulo the field."""
    matrix, power, n = ambient.times(row.entries()), row, 1
    while any(power.entries()[ambient.degree :]):
        power, n = power * matrix, n + 1
    return n
