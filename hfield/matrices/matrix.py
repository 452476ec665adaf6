"""Exact matrices over a quaternion algebra; vectors are columns, on which scalars act from the right.

Linear problems are solved in coordinates over the base ring F: an m × n matrix over A is a 4m × 4n matrix
over F. F. Zhang, "Quaternions and matrices of quaternions", Linear Algebra Appl. 251 (1997).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.product import Scalar
from hfield.errors import (
    CoercionError,
    MixedParentsError,
    NoSolutionError,
    NotInvertibleError,
    RingError,
    UndecidedError,
    shorten,
)
from hfield.fields.linear_algebra.kernels import kernel
from hfield.matrices.elimination import (
    Cleared,
    Vector,
    by_functional,
    dot,
    left_kernel,
    over_ring,
    transposed,
    vector,
)
from hfield.symbols import as_list, is_quaternion
from hfield.sympy_printing import PrintedBySympy

if TYPE_CHECKING:
    import numpy as np
    import sympy

    from hfield.fields.algebraic.closed_forms import Closed
    from hfield.fields.algebraic.surds import Surd
    from hfield.fields.base.ring import Ring
    from hfield.matrices.decompositions import SVD, PolarDecomposition, Schur
    from hfield.matrices.hermitian import DiagonalForm, HermitianSignature

Entries = tuple[Vector, ...]


class EchelonForm(NamedTuple):
    """The echelon form: ``transformation`` @ M == ``form``; ``pivots`` are column indices, from 0."""

    form: Matrix
    transformation: Matrix
    pivots: tuple[int, ...]


class Matrix(PrintedBySympy):
    """A matrix over a quaternion algebra: ``A.matrix([[q11, q12], [q21, q22]])``. Immutable.

    ``M @ N`` is the product; ``M * q`` and ``q * M`` multiply each entry by a quaternion on that side. An
    entry may be an array of quaternions; such matrices support addition and multiplication.

    >>> from hfield import H
    >>> A = H("QQ"); e, i, j, k = A.basis
    >>> M = A.matrix([[1, i], [j, k]])
    >>> M @ M, M.reduced_norm(), M.rank()
    ([[1 + k, i - j], [-i + j, -1 - k]], 4, 2)
    >>> M @ M.inverse() == A.matrix([[1, 0], [0, 1]])
    True
    """

    __slots__ = ("__dict__", "algebra", "rows")
    __array_ufunc__ = None
    multiplied_by_elements = True
    algebra: Parent
    rows: Entries

    def __init__(
        self, algebra: Parent, rows: Iterable[Iterable[object]] | Matrix | Quaternion
    ) -> None:
        given: object = rows.rows if isinstance(rows, Matrix) else as_list(rows)
        if isinstance(given, Quaternion) and len(given.shape) > 1:
            m, n = given.shape[-2:]
            given = [[given[..., r, s] for s in range(n)] for r in range(m)]
        if isinstance(given, str) or not isinstance(given, Iterable):
            raise CoercionError(f"a matrix takes a list of rows, not {shorten(given)}")
        found = []
        for row in given:
            if isinstance(row, str | Quaternion) or not isinstance(row, Iterable):
                raise CoercionError(
                    f"a row is a list of elements, not {shorten(row)}; write [[…], […]]"
                )
            found.append(tuple(algebra(x) for x in row))
        if not found or not found[0] or len({len(row) for row in found}) > 1:
            lengths = [len(row) for row in found]
            raise CoercionError(
                f"the rows of a matrix have one length, at least 1; here the lengths are {lengths}"
            )
        self.algebra, self.rows = algebra, tuple(found)

    def _like(self, rows: Iterable[Iterable[Quaternion]]) -> Matrix:
        made = object.__new__(Matrix)
        made.algebra, made.rows = self.algebra, tuple(map(tuple, rows))
        return made

    # --- entries -------------------------------------------------------------------------------

    @property
    def shape(self) -> tuple[int, int]:
        """The numbers of rows and columns."""
        return len(self.rows), len(self.rows[0])

    def __getitem__(self, place: tuple[int, int]) -> Quaternion:
        if not isinstance(place, tuple) or len(place) != 2:
            raise CoercionError(f"an entry is M[i, j], from 0; found M[{place!r}]")
        try:
            return self.rows[place[0]][place[1]]
        except IndexError:
            raise IndexError(
                f"M[{place[0]}, {place[1]}] is not an entry of a matrix of shape {self.shape}, numbered from "
                "0"
            ) from None

    @property
    def T(self) -> Matrix:
        """The transpose; (M·N).T is N.T·M.T only if the entries commute."""
        return self._like(zip(*self.rows, strict=True))

    def change_ring(self, ring: Ring | str) -> Matrix:
        """Return the matrix over another ring, which must contain the constants and coordinates.

        >>> from hfield import H
        >>> H("QQ").matrix([["i/2", 3]]).change_ring("GF(7)")
        [[4*i, 3]]
        """
        rows = [[q.change_ring(ring) for q in row] for row in self.rows]
        made = self._like(rows)
        made.algebra = rows[0][0].algebra
        return made

    def conjugate(self) -> Matrix:
        """Return the matrix of the conjugates."""
        return self._like([[q.conjugate() for q in row] for row in self.rows])

    def conjugate_transpose(self) -> Matrix:
        """Return the adjoint, ``(M·N)* = N*·M*``."""
        return self.conjugate().T

    def is_hermitian(self) -> bool:
        """Return whether the matrix equals its conjugate transpose."""
        return self == self.conjugate_transpose()

    def diagonal_form(self) -> DiagonalForm:
        """Return ``.diagonal`` and ``.transformation``, P, of a hermitian matrix: P*·M·P is diagonal.

        The diagonal entries lie in the base field, unless 2 = 0 there. Raises :class:`CoercionError` unless
        M* = M, and :class:`UndecidedError` if none is found, which happens only with zero divisors in
        characteristic 2.

        >>> from hfield import H
        >>> A = H("QQ"); e, i, j, k = A.basis
        >>> M = A.matrix([[0, i], [-i, 1]]); d, P = M.diagonal_form()
        >>> d, P.conjugate_transpose() @ M @ P
        ((1, -1), [[1, 0], [0, -1]])
        """
        from hfield.matrices.hermitian import diagonal_form

        return diagonal_form(self)

    def signature(self, ordering: int = 0) -> HermitianSignature:
        """Return how many entries of a diagonal form are positive, negative and 0 in an ordering of F.

        Raises :class:`CoercionError` unless M* = M, :class:`RingError` if there is no ordering or the norm of
        the algebra takes both signs in it.

        >>> from hfield import H
        >>> H("QQ").matrix([[0, "i"], ["-i", 1]]).signature()
        HermitianSignature(positive=1, negative=1, zero=0)
        """
        from hfield.matrices.hermitian import signature

        return signature(self, ordering)

    def is_positive_definite(self, ordering: int = 0) -> bool:
        """Return whether x*·M·x > 0 for every x ≠ 0, in an ordering of F, for a hermitian matrix."""
        from hfield.matrices.hermitian import is_positive_definite

        return is_positive_definite(self, ordering)

    # --- arithmetic ----------------------------------------------------------------------------

    def _matching(self, other: object, shape: tuple[int, int] | None) -> Matrix | None:
        if not isinstance(other, Matrix):
            return None
        if other.algebra != self.algebra:
            raise MixedParentsError(
                f"a matrix over {self.algebra} cannot be combined with one over {other.algebra}"
            )
        if shape is not None and other.shape != shape:
            raise CoercionError(
                f"shapes {self.shape} and {other.shape} do not fit; expected {shape}"
            )
        return other

    def __add__(self, other: object) -> Matrix:
        b = self._matching(other, self.shape)
        if b is None:
            return NotImplemented
        pairs = zip(self.rows, b.rows, strict=True)
        return self._like([[x + y for x, y in zip(r, s, strict=True)] for r, s in pairs])

    def __neg__(self) -> Matrix:
        return self._like([[-q for q in row] for row in self.rows])

    def __sub__(self, other: object) -> Matrix:
        b = self._matching(other, self.shape)
        return NotImplemented if b is None else self + -b

    def __matmul__(self, other: object) -> Matrix:
        b = self._matching(other, None)
        if b is None:
            return NotImplemented
        if self.shape[1] != b.shape[0]:
            raise CoercionError(f"shapes {self.shape} and {b.shape} do not multiply")
        columns = list(zip(*b.rows, strict=True))
        return self._like([[dot(row, column) for column in columns] for row in self.rows])

    def _factor(self, x: object) -> Quaternion | None:
        if isinstance(x, Matrix):
            raise CoercionError("M * N is not defined for matrices: the product is M @ N")
        return self.algebra(x)

    def __mul__(self, x: object) -> Matrix:
        q = self._factor(x)
        return self._like([[y * q for y in row] for row in self.rows])

    def __rmul__(self, x: object) -> Matrix:
        q = self._factor(x)
        return self._like([[q * y for y in row] for row in self.rows])

    def __pow__(self, n: int) -> Matrix:
        self._expect_square("a power")
        if not isinstance(n, int):
            return NotImplemented
        base, n = (self.inverse(), -n) if n < 0 else (self, n)
        result = self._identity()
        while n:
            if n & 1:
                result = result @ base
            n >>= 1
            base = base @ base if n else base
        return result

    def _identity(self) -> Matrix:
        one, zero, n = self.algebra.basis[0], self.algebra.scalar(0), self.shape[0]
        return self._like([[one if i == j else zero for j in range(n)] for i in range(n)])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Matrix):
            return NotImplemented
        if (self.algebra, self.shape) != (other.algebra, other.shape):
            return False
        pairs = zip(self.rows, other.rows, strict=True)
        same = (x == y for r, s in pairs for x, y in zip(r, s, strict=True))
        return all(bool(x.all()) if hasattr(x, "all") else bool(x) for x in same)

    def __hash__(self) -> int:
        return hash((self.algebra, self.rows))

    # --- reduced norm --------------------------------------------------------------------------

    def _expect_square(self, what: str) -> None:
        if self.shape[0] != self.shape[1]:
            raise CoercionError(
                f"{what} is defined for square matrices; this one has the shape {self.shape}"
            )

    def reduced_norm(self) -> Scalar:
        """Return the reduced norm, in the base ring; it is multiplicative, and ``q.norm()`` for a 1 × 1
        matrix.

        It is the determinant over S = F[X]/(X² − tX − a) under u + vj ↦ [[u, v], [b·v̄, ū]]. Rows with a unit
        are eliminated, and the remaining determinant is expanded without division (Berkowitz 1984).
        """
        self._expect_square("the reduced norm")
        rows = [list(row) for row in self.rows]
        norm: Scalar = self.algebra.ring.one
        while rows:
            at = next(
                ((r, c) for r, row in enumerate(rows) for c, q in enumerate(row) if q.is_unit()),
                None,
            )
            if at is None:
                return norm * self._like(rows).reduced_characteristic_polynomial()[0]
            pivot = rows.pop(at[0])
            norm, back = norm * pivot[at[1]].norm(), pivot[at[1]].inverse()
            for row in rows:
                factor = row[at[1]] * back
                row[:] = [x - factor * y for x, y in zip(row, pivot, strict=True)]
                del row[at[1]]
        return norm

    def reduced_characteristic_polynomial(self) -> tuple[Scalar, ...]:
        """Return the coefficients in the base ring, low degree first, of a monic polynomial of degree 2n with
        root M.
        """
        self._expect_square("the characteristic polynomial")
        from hfield.matrices.characteristic_polynomials import characteristic_polynomial

        F, c = self.algebra.ring, self.algebra.constants
        blocks: list[list[tuple[Scalar, Scalar]]] = []
        for row in self.rows:
            upper, lower = [], []
            for q in row:
                w, x, y, z = q.coordinates
                upper += [(w, x), (y, z)]
                lower += [(c.b * (y + c.t * z), -c.b * z), (w + c.t * x, -x)]
            blocks += [upper, lower]
        found = characteristic_polynomial(F, c.a, c.t, blocks)
        return tuple(x for x, _ in found)

    def is_invertible(self) -> bool:
        """Return whether there is an inverse, that is, the reduced norm is a unit."""
        return self.shape[0] == self.shape[1] and self.algebra.ring.is_unit(self.reduced_norm())

    def inverse(self) -> Matrix:
        """Return the two-sided inverse. Raises :class:`NotInvertibleError` with a proof if there is none."""
        self._expect_square("the inverse")
        F = self.algebra.ring
        if F.is_field:
            found = self._beside(self._identity()).solution()
            if found is not None:
                return self._like(zip(*found, strict=True))
            y = self.left_kernel()[0]
            raise NotInvertibleError(f"this matrix has no inverse: y·M = 0 for y = {_shown(y)}")
        c = self.reduced_characteristic_polynomial()
        if not F.is_unit(c[0]):
            raise NotInvertibleError(
                f"this matrix has no inverse: its reduced norm {shorten(F.text(c[0]))} is not a unit of "
                f"{F.name}"
            )
        result = self._identity()  # Cayley and Hamilton: c₀ + M·(c₁ + c₂·M + …) = 0
        for x in reversed(c[1:-1]):
            result = self @ result + self._identity() * x
        scaled: Matrix = result * -F.inverse(c[0])
        return scaled

    # --- over the base ring --------------------------------------------------------------------

    def _beside(self, right: Matrix | None = None) -> Cleared:
        """Return the matrix after elimination by units, with another matrix to the right of it."""
        rows: Sequence[Sequence[Quaternion]] = self.rows
        if right is not None:
            rows = [[*x, *y] for x, y in zip(self.rows, right.rows, strict=True)]
        return Cleared(self.algebra, rows, self.shape[1])

    def _field(self, what: str) -> Ring:
        F = self.algebra.ring
        if not F.is_field:
            raise RingError(
                f"{F.no_field}: {what} is of matrices over an algebra over a field; use A.change_ring(L) for "
                "a field L that contains it"
            )
        return F

    def rank(self) -> int | Fraction:
        """Return dim_F(M·Aⁿ)/4: an int, or possibly a fraction if the algebra has zero divisors."""
        self._field("the rank")
        rank = self._beside().rank()
        return rank.numerator if rank.denominator == 1 else rank

    def echelon_form(self) -> EchelonForm:
        """Return ``.form``, the reduced row echelon form E, ``.transformation`` T with T·M = E, and
        ``.pivots``.

        T is invertible; the pivot columns of E are those of the identity. Raises :class:`UndecidedError` if a
        column has zero divisors as entries and no unit with which to clear them.

        >>> from hfield import H
        >>> M = H("QQ").matrix([["i", "j", 1], ["k", 1, "j"]])
        >>> E, T, pivots = M.echelon_form(); E, T @ M == E, pivots
        ([[1, -k, 0], [0, 0, 1]], True, (0, 2))
        """
        A, (m, n) = self.algebra, self.shape
        F = self._field("the echelon form")
        if not F.is_exact:
            raise UndecidedError(f"whether a column is 0 is not decided over {F.name}; use svd()")
        rows = [[*row, *(A.scalar(r == c) for c in range(m))] for r, row in enumerate(self.rows)]
        found = Cleared(A, rows, n, leftmost=True)
        order = sorted(zip(found.pivots, found.done, strict=True), key=lambda pair: pair[0])
        left = [
            *(x for c, row in order for x in row[:c]),
            *(x for row in found.rest for x in row[:n]),
        ]
        if any(left):
            raise UndecidedError(
                "an echelon form needs a unit in each column that it clears; rank() and solve() do not"
            )
        whole = [*(row for _, row in order), *found.rest]
        form, transformation = (
            self._like(row[part] for row in whole) for part in (slice(n), slice(n, None))
        )
        return EchelonForm(form, transformation, tuple(c for c, _ in order))

    def right_kernel(self) -> tuple[Vector, ...]:
        """Return vectors that generate the right module of all x with M·x = 0.

        Over a division algebra they are a basis; over rings that are not fields they generate over the ring.
        Raises :class:`UndecidedError` if none are found.
        """
        F = self.algebra.ring
        if F.is_field:
            return tuple(self._beside().right_kernel())
        found = kernel(F, over_ring(self.rows), 4 * self.shape[1])
        return tuple(vector(self.algebra, v) for v in found)

    def left_kernel(self) -> tuple[Vector, ...]:
        """Return vectors that generate the left module of all x with x·M = 0; see :meth:`right_kernel`."""
        F = self.algebra.ring
        if F.is_field:
            return tuple(left_kernel(self.algebra, self.rows))
        found = kernel(F, transposed(over_ring(self.rows)), 4 * self.shape[0])
        return tuple(by_functional(self.algebra, v) for v in found)

    def solve(self, b: Matrix | Sequence[object]) -> Matrix:
        """Return a matrix x with ``M @ x == b``; b may be the list of a column.

        Raises :class:`NoSolutionError` with ``witness`` y such that y·M = 0 and y·b ≠ 0; over rings that are
        not fields, :class:`UndecidedError` if M has no inverse.
        """
        F = self.algebra.ring
        if not isinstance(b, Iterable | Matrix):
            raise CoercionError(f"b must be a matrix, or the list of a column, found {shorten(b)}")
        target = b if isinstance(b, Matrix) else Matrix(self.algebra, [[x] for x in b])
        if target.algebra != self.algebra or target.shape[0] != self.shape[0]:
            raise CoercionError(
                f"b has the shape {target.shape}; expected {self.shape[0]} rows over {self.algebra}"
            )
        if not F.is_field:
            if self.is_invertible():
                return self.inverse() @ target
            raise UndecidedError(f"{F.no_field}: only invertible matrices are solved for")
        found = self._beside(target).solution()
        if found is not None:
            return self._like(zip(*found, strict=True))
        for y in self.left_kernel():
            product = [dot(y, column) for column in zip(*target.rows, strict=True)]
            if any(product):
                raise NoSolutionError(
                    f"there is no x with M·x = b: y·M = 0 and y·b = {_shown(product)} for y = {_shown(y)}",
                    y,
                )
        raise AssertionError("a system without solution has a functional that says so")

    # --- eigenvalues ---------------------------------------------------------------------------

    def right_eigenvalues(self) -> tuple[Surd | Closed, ...] | np.ndarray:
        """Return the n complex λ, Im λ ≥ 0, with M·x = x·λ for some x ≠ 0, with multiplicity.

        Each λ represents the class of all q⁻¹·λ·q; in (a, b | F) i/√−a is the imaginary unit. Over RR the
        result is a tuple of exact elements of CC; over RDF it is an array of complex128, by LAPACK, with an
        additional axis for an array of matrices. Raises :class:`CoercionError` over algebras with zero
        divisors, and :class:`UndecidedError` over others and if the characteristic polynomial is not
        factored.

        >>> from hfield import H
        >>> H("RR").matrix([[0, "i"], ["j", 0]]).right_eigenvalues()
        (1/2*sqrt(2)+1/2*I*sqrt(2), -1/2*sqrt(2)+1/2*I*sqrt(2))
        >>> H("RDF").matrix([[0, 1], [-1, 0]]).right_eigenvalues().round(6) + 0
        array([0.+1.j, 0.+1.j])
        """
        from hfield.matrices.decompositions import right_eigenvalues

        return right_eigenvalues(self)

    def schur(self) -> Schur:
        """Return ``.unitary`` U and ``.triangular`` T over RDF: M = U·T·U*, with complex numbers on T's
        diagonal.

        Entries may be arrays; residuals are checked. Raises as :meth:`right_eigenvalues` does.

        >>> from hfield import H
        >>> M = H("RDF").matrix([["i", "1+k"], ["j", 2]]); U, T = M.schur()
        >>> (U @ T @ U.conjugate_transpose() - M)[0, 1].norm() < 1e-28, T[1, 0]
        (True, 0)
        """
        from hfield.matrices.decompositions import schur

        return schur(self)

    def svd(self) -> SVD:
        """Return ``.left`` U, ``.values``, descending, and ``.right`` V over RDF: M = U·diag(values)·V*.

        >>> from hfield import H
        >>> H("RDF").matrix([["3*i", 0], [0, "4*j"], [0, 0]]).svd().values
        array([4., 3.])
        """
        from hfield.matrices.decompositions import svd

        return svd(self)

    def polar(self) -> PolarDecomposition:
        """Return ``.unitary`` W and ``.positive`` P over RDF: M = W·P, W*·W = 1, P hermitian and nonnegative.

        >>> from hfield import H
        >>> W, P = H("RDF").matrix([["2*i"]]).polar(); W, P
        ([[i]], [[2.0]])
        """
        from hfield.matrices.decompositions import polar

        return polar(self)

    # --- text ----------------------------------------------------------------------------------

    def text(self, style: str = "plain") -> str:
        """Write the rows in the style ``plain`` (which ``A.matrix`` reads), ``unicode`` or ``latex``."""
        if style == "latex":
            body = r" \\ ".join(" & ".join(q.text(style) for q in row) for row in self.rows)
            return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"
        rows = (", ".join(q.text(style) for q in row) for row in self.rows)
        return f"[{', '.join(f'[{row}]' for row in rows)}]"

    def _in_sympy(self, symbols: Mapping[str, sympy.Symbol]) -> sympy.Basic:
        """Return the sympy matrix, or an array of shape (m, n, 4), as :func:`hfield.to_sympy` does."""
        import sympy

        rows = [[q._in_sympy(symbols) for q in row] for row in self.rows]
        if is_quaternion(rows[0][0]):
            return sympy.ImmutableMatrix(rows)
        return sympy.Array([[list(q) for q in row] for row in rows])

    def _sympy_(self) -> sympy.Basic:
        return self._in_sympy({})

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _repr_latex_(self) -> str:
        return f"${self.text('latex')}$"


def _shown(v: Iterable[Quaternion]) -> str:
    return shorten(f"({', '.join(map(str, v))})")
