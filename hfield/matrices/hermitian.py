"""Hermitian matrices, M* = M: a diagonal form with its transformation, and signs in an ordering.

W. Scharlau, *Quadratic and Hermitian Forms* (1985), 7.6 and 10.1: in characteristic other than 2 the form x ↦
x*·M·x has values in F, and a diagonal form is Σ dₙ·N(xₙ).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from hfield.errors import CoercionError, RingError, UndecidedError

if TYPE_CHECKING:
    from collections.abc import Callable

    from hfield.algebra.quaternion import Quaternion
    from hfield.matrices.matrix import Matrix


class DiagonalForm(NamedTuple):
    """The matrix ``transformation``, P, is invertible, and P*·M·P has ``diagonal`` as diagonal and 0
    elsewhere.
    """

    diagonal: tuple[Quaternion, ...]
    transformation: Matrix


class HermitianSignature(NamedTuple):
    """The numbers of positive, negative and zero entries of a diagonal form in an ordering."""

    positive: int
    negative: int
    zero: int


def diagonal_form(M: Matrix) -> DiagonalForm:
    """Return a diagonal form. It always exists over division algebras, and over others unless 2 = 0.

    Raises :class:`CoercionError` unless M* = M, :class:`UndecidedError` if no pivot is found.
    """
    A, n = M.algebra, M.shape[0]
    _expect_hermitian(M)
    if not A.ring.is_field:
        raise RingError(
            f"{A.ring.no_field}: a diagonal form is defined for matrices over an algebra over a field"
        )
    rows, basis = [list(row) for row in M.rows], [list(row) for row in (M**0).rows]

    def add(source: int, target: int, c: Quaternion) -> None:
        """Replace the basis vector b_target by b_target + b_source·c."""
        for row in (*rows, *basis):
            row[target] = row[target] + row[source] * c
        left = c.conjugate()
        rows[target] = [x + left * y for x, y in zip(rows[target], rows[source], strict=True)]

    for k in range(n):
        at = next((s for s in range(k, n) if rows[s][s].is_unit()), None)
        if at is None:
            at = _make_unit(M, rows, k, add)
        if at is None:
            break
        for row in (*rows, *basis):
            row[k], row[at] = row[at], row[k]
        rows[k], rows[at] = rows[at], rows[k]
        back = rows[k][k].inverse()
        for m in range(k + 1, n):
            if rows[k][m]:
                add(k, m, -(back * rows[k][m]))
    return DiagonalForm(tuple(rows[s][s] for s in range(n)), M._like(basis))


def _make_unit(
    M: Matrix, rows: list[list[Quaternion]], k: int, add: Callable[[int, int, Quaternion], None]
) -> int | None:
    """Change the basis so that a diagonal entry is a unit, and return its index; None if all
    entries are 0.
    """
    n, left = len(rows), False
    for r in range(k, n):
        for s in range(r + 1, n):
            h = rows[r][s]
            left = left or bool(h)
            for c in M.algebra.basis if h else ():
                # (b_r + b_s·c) has the value m_rr + c̄·m_ss·c + tr(h·c)
                value = rows[r][r] + c.conjugate() * rows[s][s] * c + (h * c).trace()
                if value.is_unit():
                    add(s, r, c)
                    return r
    if left:
        raise UndecidedError(f"no diagonal form over {M.algebra} was found")
    return None


def signature(M: Matrix, ordering: int = 0) -> HermitianSignature:
    """Return the signature of a diagonal form, which does not depend on the diagonal form (Sylvester).

    Raises :class:`RingError` unless there is an ordering and the norm of the algebra is positive in it.
    """
    F = M.algebra.ring
    if not F.is_exact:
        raise UndecidedError(f"signs over {F.name} are not exact; M.right_eigenvalues() are there")
    if not is_definite(M, ordering):
        raise RingError(
            f"the norm of {M.algebra} takes both signs in this ordering, so that d and −d are the same form"
        )
    signs = [F.sign(d.coordinates[0], ordering) for d in diagonal_form(M).diagonal]
    return HermitianSignature(signs.count(1), signs.count(-1), signs.count(0))


def is_positive_definite(M: Matrix, ordering: int = 0) -> bool:
    """Return whether x*·M·x > 0 in the ordering for every x ≠ 0."""
    _expect_hermitian(M)
    return is_definite(M, ordering) and signature(M, ordering).positive == M.shape[0]


def is_definite(M: Matrix, ordering: int) -> bool:
    """Return whether the norm of the algebra is positive in the ordering."""
    F, c = M.algebra.ring, M.algebra.constants
    F.check_ordering(ordering)
    values = (-(c.t * c.t + c.a * F(4)), -c.b)
    return all(F.sign(x, ordering) > 0 for x in values)


def _expect_hermitian(M: Matrix) -> None:
    if not M.is_hermitian():
        raise CoercionError("expected a hermitian matrix, M.conjugate_transpose() == M")
