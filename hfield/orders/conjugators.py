"""Conjugations that map one order of a totally definite algebra onto another, over any base.

An isomorphism of orders is a conjugation (Skolem and Noether), hence an isometry of trace-0 parts. It is
determined by the images of two elements that do not commute. Over ℤ these lattices of rank 3 have few reduced
bases: the kernel :mod:`hfield.orders.ternary_reduction` compares them, which is quick, however skew they are.
"""

from __future__ import annotations

from itertools import count
from typing import TYPE_CHECKING

import flint

from hfield.orders.base_values import Scalar
from hfield.orders.connected_orders import conjugator as by_connecting_ideals
from hfield.orders.enumeration import short_vectors, vectors_of_length
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.short_elements import expect_definite, reduced, ternary_rows
from hfield.orders.ternary_reduction import conjugator as by_reduced_bases

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.orders.basis import AlgebraBasis


def conjugator(first: LatticeValue, second: LatticeValue) -> tuple[Quaternion | None, str]:
    """Return x with x·O·x⁻¹ = O' for two orders of one discriminant, or None and why there is none.

    Raises :class:`IndefiniteError` unless the algebra is totally definite.
    """
    expect_definite(first.ambient, "isomorphism()")
    if first.ambient.base.is_polynomial:
        return by_connecting_ideals(first, second)
    if first.ambient.kernels.reduces_ternary_forms:
        return by_reduced_bases(first, second)
    return by_two_images(first, second)


def by_two_images(first: LatticeValue, second: LatticeValue) -> tuple[Quaternion | None, str]:
    """Return the same by the images of two elements; the one way over any base."""
    ambient = first.ambient
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
                        return ambient.quaternion(x.entries()), ""
    return None, (
        f"of the {tried} pairs in the trace-0 part of {ambient.base.symbol} + 2O with the norms and the "
        "inner product of two elements of the other none comes from a conjugation that maps one order onto "
        "the other"
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

    def of_norm(self, norm: Scalar) -> list[flint.fmpq_mat]:
        """Return one of ±x for each element of a norm."""
        gram, basis, den = reduced(self.ambient, self.basis, self.ambient.base.field.one)
        length = 2 * den * self.ambient.base.trace(norm)
        if length.q != 1:
            return []
        rows = (
            flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis
            for x in vectors_of_length(gram, int(length.p))
        )
        return [row for row in rows if self.ambient.norm(row.entries()) == norm]

    def pairing(self, x: flint.fmpq_mat, y: flint.fmpq_mat) -> Scalar:
        """Return N(x + y) − N(x) − N(y)."""
        norm = self.ambient.norm
        found: Scalar = norm((x + y).entries()) - norm(x.entries()) - norm(y.entries())
        return found


def two_generators(order: LatticeValue) -> tuple[flint.fmpq_mat, flint.fmpq_mat]:
    """Return two elements of an order that do not commute: they generate the algebra."""
    return _Ternary(order).two_generators()


def _intertwiner(
    ambient: AlgebraBasis, sources: tuple[flint.fmpq_mat, ...], targets: tuple[flint.fmpq_mat, ...]
) -> flint.fmpq_mat:
    """Return x ≠ 0 with x·s = t·x for two pairs s, t with the same norms and inner products."""
    columns: list[list[flint.fmpq]] = []
    for s, t in zip(sources, targets, strict=True):
        columns += (ambient.times(s.entries()) - ambient.times(t, "left")).transpose().tolist()
    whole = flint.fmpq_mat(columns).numer_denom()[0]
    kernel, rank = whole.nullspace()
    assert rank == ambient.degree, "two elements that do not commute generate the algebra"
    return flint.fmpq_mat([[kernel[k, 0] for k in range(ambient.size)]])
