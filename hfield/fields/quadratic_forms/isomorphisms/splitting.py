"""Splitting: an explicit isomorphism with the 2 × 2 matrices over the field, from one zero divisor.

A zero divisor q generates a left ideal A·q of dimension 2, on which A acts by left multiplication. For a
nondegenerate algebra this action is an isomorphism onto M₂(F).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from hfield.core.product import Constants, Coordinates, Scalar, multiply
from hfield.errors import CoercionError, UndecidedError
from hfield.fields.base.ring import E, Ring
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm
from hfield.fields.quadratic_forms.norm_forms.zero_norms import zero_norm
from hfield.fields.quadratic_forms.normal_forms import (
    basis_of,
    discriminant,
    from_pairings,
    normal_form,
    pairing_matrix,
    root_if_known,
)

Matrix: TypeAlias = tuple[tuple[E, E], tuple[E, E]]


@dataclass(frozen=True)
class CoordinateSplitting:
    """An isomorphism of the algebra with M₂(F); ``images`` contains the matrices of e, i, j, k.

    ``zero_divisor`` is the element of norm 0 from which it was made, and ``reason`` its origin.
    """

    ring: Ring
    constants: Constants
    images: tuple[Matrix, Matrix, Matrix, Matrix]
    zero_divisor: Coordinates
    reason: str = ""

    @property
    def i(self) -> Matrix:
        """The matrix of i."""
        return self.images[1]

    @property
    def j(self) -> Matrix:
        """The matrix of j."""
        return self.images[2]

    def to_matrix(self, q: Coordinates) -> Matrix:
        """Return the matrix of the element with coordinates q."""
        (a, b), (c, d) = (
            [
                sum(
                    (x * m[r][s] for x, m in zip(q[1:], self.images[1:], strict=True)),
                    q[0] * self.images[0][r][s],
                )
                for s in (0, 1)
            ]
            for r in (0, 1)
        )
        return (a, b), (c, d)

    def from_matrix(self, matrix: Sequence[Sequence[object]]) -> Coordinates:
        """Return the coordinates of the element whose matrix is given, two rows of two entries.

        Raises :class:`CoercionError` for another shape or for entries that are not in the field.
        """
        if len(matrix) != 2 or any(len(row) != 2 for row in matrix):
            raise CoercionError("expected a 2 × 2 matrix, two rows of two entries")
        (a, b), (d, e) = ([self.ring(x) for x in row] for row in matrix)
        pairings = [_pairing(((a, b), (d, e)), image) for image in self.images]
        return from_pairings(self.ring, self.constants, pairings)


def split(ring: Ring, c: Constants) -> CoordinateSplitting | None:
    """Return an isomorphism with M₂(F), verified, or None for a division algebra.

    Raises :class:`CoercionError` for a degenerate algebra, which is not simple, and :class:`UndecidedError`
    if the existence of zero norms is not decided or the ring is not a field.
    """
    answer = division_or_splitting(ring, c)
    return answer if isinstance(answer, CoordinateSplitting) else None


def division_or_splitting(ring: Ring, c: Constants) -> CoordinateSplitting | ZeroNorm:
    """Return the splitting, or the reason why there is no element of norm 0; errors are as for
    :func:`split`.
    """
    if not ring.is_field:
        raise UndecidedError(f"{ring.no_field}: splitting is decided over fields only")
    if ring.is_zero(discriminant(ring, c)):
        raise CoercionError(
            "a degenerate algebra, (t² + 4a)·b = 0, is not simple, hence neither split nor a division algebra"
        )
    return _from_square_root(ring, c) or _from_search(ring, c)


def _from_search(ring: Ring, c: Constants) -> CoordinateSplitting | ZeroNorm:
    answer = zero_norm(ring, c)
    if answer.element is None:
        return answer
    return replace(from_zero_divisor(ring, c, answer.element), reason=answer.reason)


def _from_square_root(ring: Ring, c: Constants) -> CoordinateSplitting | None:
    """Use a root r of a (or b) in the normal form: i ↦ diag(r, −r), j ↦ ((0, b), (1, 0))."""
    form = normal_form(ring, c)
    if form.kind != "symbol":
        return None
    o, e = ring.zero, ring.one
    for swapped, (a, b) in enumerate((form.constants, form.constants[::-1])):
        r = root_if_known(ring, a)
        if r is not None:
            diagonal, other = ((r, o), (o, o - r)), ((o, b), (e, o))
            i, j = (other, diagonal) if swapped else (diagonal, other)
            q = form.back((r, o, e, o) if swapped else (r, e, o, o))
            half = (
                o if ring.is_zero(c.t) else ring.divide(c.t, ring(2))
            )  # i is the normal one plus t/2
            i = ((i[0][0] + half, i[0][1]), (i[1][0], i[1][1] + half))
            return _checked(ring, c, q, (((e, o), (o, e)), i, j, product(i, j)))
    return None


def from_zero_divisor(ring: Ring, c: Constants, q: Coordinates) -> CoordinateSplitting:
    """Return the splitting that a zero divisor of a nondegenerate algebra determines, after checking it."""
    basis = basis_of(ring)
    products = [multiply(c, u, q) for u in basis]
    first = products[0]
    for second in products[1:]:
        for r in range(4):
            for s in range(r):
                minor = first[r] * second[s] - first[s] * second[r]
                if not ring.vanishes(minor):
                    return _verified(ring, c, q, (first, second), (r, s), ring.inverse(minor))
    raise AssertionError("a zero divisor generates an ideal of dimension 2")


def _verified(
    ring: Ring,
    c: Constants,
    q: Coordinates,
    ideal: tuple[Coordinates, Coordinates],
    rows: tuple[int, int],
    scale: Scalar,
) -> CoordinateSplitting:
    """Compute the action on the ideal with the given basis, and check that it is an isomorphism."""
    u, v = ideal
    r, s = rows

    def in_basis(x: Coordinates) -> tuple[Scalar, Scalar]:
        return (x[r] * v[s] - x[s] * v[r]) * scale, (u[r] * x[s] - u[s] * x[r]) * scale

    matrices = []
    for b in basis_of(ring):
        (a, d), (e, f) = in_basis(multiply(c, b, u)), in_basis(multiply(c, b, v))
        matrices.append(((a, e), (d, f)))
    one, i, j, k = matrices
    return _checked(ring, c, q, (one, i, j, k))


def _checked(
    ring: Ring, c: Constants, q: Coordinates, images: tuple[Matrix, Matrix, Matrix, Matrix]
) -> CoordinateSplitting:
    """Check the relations, and that tr(m·adj(n)) is as in the algebra, so that the images are independent."""
    gram = pairing_matrix(ring, c)
    independent = all(
        ring.agree(_pairing(m, n), gram[r][s])
        for r, m in enumerate(images)
        for s, n in enumerate(images)
    )
    if not independent or not _relations(ring, c, *images):
        raise AssertionError("the action on the ideal is not an isomorphism")
    return CoordinateSplitting(ring, c, images, q)


def _pairing(m: Matrix[E], n: Matrix[E]) -> E:
    """Return the trace of m times the adjugate of n; it equals tr(p·conj(q)) for the corresponding
    elements.
    """
    (a, b), (c, d) = m
    (p, q), (r, s) = n
    return a * s - b * r - c * q + d * p


def product(m: Matrix[E], n: Matrix[E]) -> Matrix[E]:
    """Return the product of two 2 × 2 matrices."""
    (a, b), (c, d) = m
    (p, q), (r, s) = n
    return (a * p + b * r, a * q + b * s), (c * p + d * r, c * q + d * s)


def _relations(ring: Ring, c: Constants, one: Matrix, i: Matrix, j: Matrix, k: Matrix) -> bool:
    """Return whether the matrices satisfy ``i² = a + t·i``, ``j² = b``, ``ij = k``, ``ji = t·j − k``."""

    def combine(*terms: tuple[Scalar, Matrix]) -> Matrix:
        (a, b), (d, e) = (
            [
                sum((x * m[r][s] for x, m in terms[1:]), terms[0][0] * terms[0][1][r][s])
                for s in (0, 1)
            ]
            for r in (0, 1)
        )
        return (a, b), (d, e)

    def equal(m: Matrix, n: Matrix) -> bool:
        return all(ring.agree(m[r][s], n[r][s]) for r in (0, 1) for s in (0, 1))

    unit = ((ring.one, ring.zero), (ring.zero, ring.one))
    return (
        equal(one, unit)
        and equal(product(i, i), combine((c.a, one), (c.t, i)))
        and equal(product(j, j), combine((c.b, one)))
        and equal(product(i, j), k)
        and equal(product(j, i), combine((c.t, j), (ring.zero - ring.one, k)))
    )
