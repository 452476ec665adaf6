"""Maps of algebras as callables: linear maps, isomorphisms, and splittings into 2 × 2 matrices."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import permutations
from typing import TYPE_CHECKING, Generic

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.product import Coordinates, Scalar
from hfield.errors import CoercionError, MixedParentsError, NotInvertibleError, shorten
from hfield.fields.base.ring import E
from hfield.fields.quadratic_forms.isomorphisms import splitting
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    from hfield.fields.base.ring import Ring
    from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm


Matrix = splitting.Matrix


class LinearMap(Generic[E]):
    """A linear map of algebras over one ring, given by the ``images`` of e, i, j, k. The map is callable."""

    def __init__(self, source: Parent[E], target: Parent[E], images: Sequence[object]) -> None:
        self.source, self.target = source, target
        e, i, j, k = (target(*q) if isinstance(q, (tuple, list)) else target(q) for q in images)
        self.images: Coordinates[Quaternion[E]] = (e, i, j, k)

    def __call__(self, q: object) -> Quaternion[E]:
        """Return the image of q, an element of the source or a value that the source can read."""
        if isinstance(q, Quaternion) and q.algebra != self.source:
            raise MixedParentsError(
                f"{shorten(q)} is an element of {q.algebra}, but the map is defined on {self.source}"
            )
        coordinates = (q if isinstance(q, Quaternion) else self.source(q)).coordinates
        terms = [
            x * q for x, q in zip(map(self.target.scalar, coordinates), self.images, strict=True)
        ]
        return terms[0] + terms[1] + terms[2] + terms[3]

    def matrix(self) -> tuple[tuple[E, ...], ...]:
        """Return the 4 × 4 matrix: column n holds the coordinates of the image of basis element n."""
        return tuple(zip(*(q.coordinates for q in self.images), strict=True))

    @property
    def determinant(self) -> E:
        """The determinant of the matrix, an element of the base ring."""
        m = self.matrix()
        total = self.target.ring.zero
        for p in permutations(range(4)):
            sign = (-1) ** sum(p[s] > p[r] for r in range(4) for s in range(r))
            term = m[0][p[0]] * m[1][p[1]] * m[2][p[2]] * m[3][p[3]]
            total = total + term if sign > 0 else total - term
        return total

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, LinearMap)
            and (self.source, self.target) == (other.source, other.target)
            and self.images == other.images
        )

    def __hash__(self) -> int:
        return hash((self.source, self.target, self.images))

    def __str__(self) -> str:
        rows = (f"{x} ↦ {q}" for x, q in zip("eijk", self.images, strict=True))
        return f"{self.source} → {self.target}: {', '.join(rows)}"

    __repr__ = __str__

    def _repr_latex_(self) -> str:
        rows = (rf"{x} \mapsto {q.text('latex')}" for x, q in zip("eijk", self.images, strict=True))
        arrow = f"{self.source.latex()} \\to {self.target.latex()}"
        return rf"${arrow}\colon\quad {', '.join(rows)}$"


class Isomorphism(LinearMap[E]):
    """An isomorphism of algebras. The constructor checks the relations and the determinant.

    ``reverses`` is true for an isomorphism onto the opposite algebra: φ(pq) = φ(q)·φ(p).
    """

    def __init__(
        self,
        source: Parent[E],
        target: Parent[E],
        images: Sequence[object],
        reverses: bool = False,
    ) -> None:
        super().__init__(source, target, images)
        self.reverses = reverses
        self._check()

    def _check(self) -> None:
        """Check that the map respects all 16 products of basis elements."""
        basis = list(zip(self.source.basis, self.images, strict=True))
        for p, p_image in basis:
            for q, q_image in basis:
                product = q_image * p_image if self.reverses else p_image * q_image
                rest = (self(p * q) - product).coordinates
                if not all(self.target.ring.vanishes(x) for x in rest):
                    raise CoercionError(
                        f"{self} is not a homomorphism: see the product of {p} and {q}"
                    )
        if not self.target.ring.is_unit(self.determinant):
            raise NotInvertibleError(f"{self} is not bijective: its determinant is not a unit")

    def inverse(self) -> Isomorphism[E]:
        """Return the inverse isomorphism, which is checked as well."""
        ring, m = self.target.ring, self.matrix()
        scale = ring.inverse(self.determinant)
        columns = []
        for n in range(4):  # Cramer's rule: the adjugate
            column = []
            for r in range(4):
                minor = _minor([[m[s][t] for t in range(4) if t != r] for s in range(4) if s != n])
                column.append(scale * minor if (n + r) % 2 == 0 else ring.zero - scale * minor)
            columns.append(tuple(column))
        return Isomorphism(self.target, self.source, columns, self.reverses)


def _minor(m: list[list[E]]) -> E:
    """Return the determinant of a 3 × 3 matrix."""
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


@dataclass(frozen=True, eq=False, repr=False)
class Splitting(Verdict[Quaternion[E]]):
    """A checked isomorphism of ``algebra`` with the 2 × 2 matrices over its field.

    A splitting is true, and a :class:`Division` is false. ``i`` and ``j`` are the matrices of i and j (``I, J
    = A.split()`` unpacks them); ``images`` are those of e, i, j, k. ``zero_divisor`` is the witness, an
    element of norm 0, and ``reason`` says why it exists.
    """

    algebra: Parent[E] = field(kw_only=True)
    coordinate_splitting: splitting.CoordinateSplitting = field(kw_only=True)

    @classmethod
    def of(cls, algebra: Parent[E], found: splitting.CoordinateSplitting) -> Splitting[E]:
        """Return the splitting that is given by coordinates."""
        return cls(
            True,
            found.reason,
            algebra(*found.zero_divisor),
            algebra=algebra,
            coordinate_splitting=found,
        )

    @property
    def images(self) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        """The matrices of e, i, j, k."""
        return self.coordinate_splitting.images

    @property
    def i(self) -> Matrix:
        """The matrix of i."""
        return self.coordinate_splitting.i

    @property
    def j(self) -> Matrix:
        """The matrix of j."""
        return self.coordinate_splitting.j

    @property
    def zero_divisor(self) -> Quaternion[E]:
        """The element of norm 0 from which the splitting was computed."""
        assert self.witness is not None, "a splitting is made from a zero divisor"
        return self.witness

    def __iter__(self) -> Iterator[Matrix]:
        return iter((self.i, self.j))

    def to_matrix(self, q: object) -> Matrix:
        """Return the matrix of q."""
        coordinates: Coordinates = self.algebra(q).coordinates
        return self.coordinate_splitting.to_matrix(coordinates)

    def from_matrix(self, matrix: Sequence[Sequence[object]]) -> Quaternion[E]:
        """Return the element with a given matrix, two rows of two entries.

        Raises :class:`CoercionError` for another shape or for entries that are not in the field.
        """
        return self.algebra(*self.coordinate_splitting.from_matrix(matrix))

    def __repr__(self) -> str:
        F = self.algebra.ring
        shown = (matrix_text(F, m) for m in (self.i, self.j))
        i, j = shown
        return f"{self.algebra} ≅ M₂({F}): i ↦ {i}, j ↦ {j}"

    def _repr_latex_(self) -> str:
        F = self.algebra.ring
        i, j = (matrix_latex(F, m) for m in (self.i, self.j))
        onto = rf"{self.algebra.latex()} \cong M_2({F.latex_name})"
        return rf"${onto}\colon\quad i \mapsto {i},\ j \mapsto {j}$"


@dataclass(frozen=True, eq=False, repr=False)
class Division(Verdict[None]):
    """A proof that ``algebra`` is a division algebra: only 0 has norm 0. It has a ``method`` and a
    ``reason``.

    It is false in an ``if``, as there is no splitting. ``places`` are the ramified places if they were
    computed; ``assumes`` lists the theorems cited.
    """

    algebra: Parent = field(kw_only=True)
    method: str = ""
    places: tuple[Hashable, ...] = ()
    assumes: tuple[str, ...] = ()

    @classmethod
    def of(cls, algebra: Parent, found: ZeroNorm) -> Division:
        """Return the proof for an algebra whose norm form was decided to have no zero."""
        return cls(
            False,
            found.reason,
            algebra=algebra,
            method=found.method,
            places=found.places,
            assumes=found.assumes,
        )

    def __repr__(self) -> str:
        return f"{self.algebra} is a division algebra: {self.reason}"


def matrix_latex(F: Ring, m: Sequence[Sequence[Scalar]]) -> str:
    """Write a matrix in LaTeX's mathematics."""
    rows = r" \\ ".join(" & ".join(F.text(x, "latex") for x in row) for row in m)
    return rf"\begin{{pmatrix}} {rows} \end{{pmatrix}}"


def matrix_text(F: Ring, m: Sequence[Sequence[Scalar]], style: str = "plain") -> str:
    """Write a matrix on one line, ``[1, 0; 0, -1]``."""
    return "[" + "; ".join(", ".join(F.text(x, style) for x in row) for row in m) + "]"
