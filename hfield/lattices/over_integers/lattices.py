"""Lattices, orders and ideals over the integers ℤ_K of a number field, as a user holds them.

They are kept as ℤ-lattices of rank 4n: rows are coordinates in the integral basis of K times 1, I, J, IJ
(:class:`Frame`), in Hermite normal form, which is unique, so lattices are equal where rows are. Class numbers
of K play no part (Voight, *Quaternion Algebras*, chapters 9, 10, 16). They stand in one module because they
make one another; what takes an algorithm is a function on frames and rows in a module below.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import flint

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, shorten
from hfield.fields.number_fields.ideals import Ideal, integers
from hfield.fuchsian.group import NormOneGroup
from hfield.hints import IDEAL, LATTICE, ORDER, Hinted
from hfield.lattices.checked_arguments import checked_side, listed
from hfield.lattices.enumeration import short_vectors
from hfield.lattices.over_integers import local_orders
from hfield.lattices.over_integers.dedekind_modules import unique_rows
from hfield.lattices.over_integers.frames import Frame

if TYPE_CHECKING:
    from hfield.lattices.over_integers.dedekind_modules import PseudoBasis

OTHER = {"left": "right", "right": "left"}


@dataclass(frozen=True)
class Because:
    """True or false in an ``if``, with the ``reason``; it equals True or False."""

    holds: bool
    reason: str

    def __bool__(self) -> bool:
        return self.holds

    def __eq__(self, other: object) -> bool:
        return self.holds == bool(other) if isinstance(other, bool | Because) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.holds)

    def __repr__(self) -> str:
        return str(self.holds)


class IntegersLattice(Hinted):
    """A lattice over the integers of a number field, of full rank; ``rows`` are a basis over ℤ.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(); i = O.algebra(0, 1, 0, 0)
    >>> I = O.right_ideal([2, 1 + i]); J = O.left_ideal([3])
    >>> I.norm(), I.right_order() == O, I * I.inverse() == I.left_order()
    (ideal(2), True, True)
    >>> I + J == O, O.index(I & J), 1 + i in I, I.conjugate().left_order() == O
    (True, ideal(324), True, True)
    """

    elsewhere = LATTICE
    multiplied_by_elements = True  # so that ``q * L`` is asked of L

    def __init__(self, frame: Frame, rows: flint.fmpq_mat) -> None:
        self.frame, self.rows = frame, unique_rows(rows)
        self.algebra, self.field = frame.algebra, frame.field

    # --- what it is --------------------------------------------------------------------------------

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """A basis over ℤ, of 4n quaternions."""
        return tuple(self.frame.quaternion(row) for row in self.rows.tolist())

    def pseudo_basis(self) -> PseudoBasis:
        """Return four pairs (basis over ℤ of an ideal, quaternion): L is the direct sum of their products."""
        return self.frame.pseudo_basis(self.rows)

    @cached_property
    def inverse_rows(self) -> flint.fmpq_mat:
        """The matrix that takes coordinates of the frame to coordinates in the basis."""
        return self.rows.inv()

    def __contains__(self, x: object) -> bool:
        return _integral(self.frame.row(x) * self.inverse_rows)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, IntegersLattice):
            return NotImplemented
        return bool(self.algebra == other.algebra and self.rows == other.rows)

    def __hash__(self) -> int:
        return hash((self.algebra, str(self.rows)))

    def __le__(self, other: IntegersLattice) -> bool:
        """Tell whether every element of this lattice lies in the other."""
        return _integral(self.rows * self._same(other).inverse_rows)

    def __ge__(self, other: IntegersLattice) -> bool:
        return self._same(other) <= self

    def _same(self, other: object) -> IntegersLattice:
        if not isinstance(other, IntegersLattice) or other.algebra != self.algebra:
            raise LatticeError(
                f"expected a lattice in {shorten(self.algebra)}, not {shorten(other)}"
            )
        return other

    def __repr__(self) -> str:
        return f"a lattice of rank {self.frame.size} over ZZ in {self.algebra}"

    # --- arithmetic --------------------------------------------------------------------------------

    def __add__(self, other: IntegersLattice) -> IntegersLattice:
        both = self.rows.tolist() + self._same(other).rows.tolist()
        return IntegersLattice(self.frame, flint.fmpq_mat(both))

    def __and__(self, other: IntegersLattice) -> IntegersLattice:
        """Return the intersection, the dual of the sum of the duals in the plain pairing of coordinates."""
        both = self.inverse_rows.transpose().tolist()
        both += self._same(other).inverse_rows.transpose().tolist()
        rows = unique_rows(flint.fmpq_mat(both)).inv().transpose()
        is_ring = isinstance(self, IntegersOrder) and isinstance(other, IntegersOrder)
        return (IntegersOrder if is_ring else IntegersLattice)(self.frame, rows)

    def _times(self, other: object) -> flint.fmpq_mat:
        """Return rows that span the product with a lattice, an element, or an ideal of the field."""
        frame = self.frame
        if isinstance(other, IntegersLattice):
            factors = list(map(frame.right, self._same(other).rows.tolist()))
        elif isinstance(other, Ideal):
            factors = list(map(frame.scalar, frame.ideal(other).elements))
        else:
            factors = [frame.right(frame.row(other).entries())]
        return flint.fmpq_mat([row for m in factors for row in (self.rows * m).tolist()])

    def __mul__(self, other: object) -> IntegersLattice:
        """Return the product with a lattice, an element, a number or an ideal of the field."""
        return IntegersLattice(self.frame, self._times(other))

    def __rmul__(self, other: object) -> IntegersLattice:
        if not isinstance(other, Quaternion):
            return self * other
        return (self.conjugate() * other.conjugate()).conjugate()

    def conjugate(self) -> IntegersLattice:
        """Return the lattice of the conjugates."""
        flipped = self.frame.conjugate(self.rows.tolist())
        return IntegersLattice(self.frame, flint.fmpq_mat(flipped))

    def colon(self, other: IntegersLattice, side: str = "left") -> IntegersLattice:
        """Return the x with x·M ⊂ L for M = other, or those with M·x ⊂ L for ``side="right"``."""
        if checked_side(side) == "right":
            return self.conjugate().colon(other.conjugate()).conjugate()
        columns: list[Any] = []
        for row in self._same(other).rows.tolist():
            columns += (self.frame.right(row) * self.inverse_rows).transpose().tolist()
        return IntegersLattice(self.frame, unique_rows(flint.fmpq_mat(columns)).inv().transpose())

    def dual(self) -> IntegersLattice:
        """Return the x with tr(x·L) ⊂ ℤ_K, the codifferent of an order (Voight, definition 15.6.2)."""
        n = self.frame.n
        columns: list[Any] = []
        for row in self.rows.tolist():
            columns += (self.frame.right(row) * 2).transpose().tolist()[:n]
        return IntegersLattice(self.frame, unique_rows(flint.fmpq_mat(columns)).inv().transpose())

    def left_order(self) -> IntegersOrder:
        """Return the x with x·L ⊂ L, an order."""
        return IntegersOrder(self.frame, self.colon(self).rows)

    def right_order(self) -> IntegersOrder:
        """Return the x with L·x ⊂ L, an order."""
        return IntegersOrder(self.frame, self.colon(self, "right").rows)

    def is_invertible(self) -> bool:
        """Tell whether ``L·L⁻¹`` is the left order: whether L is locally principal (Voight, 16.7.7)."""
        return self._is_locally_principal(self.left_order())

    def _is_locally_principal(self, order: IntegersOrder) -> bool:
        """Tell whether L, an ideal of an order on some side, is locally a multiple of it.

        Everywhere locally some x in L has the norm of L, and generates a part of the index N(x)².
        """
        return order.index(self) == self.norm() ** 2

    def inverse(self) -> IntegersLattice:
        """Return ``conj(L)/N(L)``, the x with L·x·L ⊂ L. Raises :class:`LatticeError` where L has none."""
        if not self.is_invertible():
            raise LatticeError(f"{shorten(self)} is not invertible: it is not locally principal")
        return self.conjugate() * self.norm().inverse()

    # --- sizes -------------------------------------------------------------------------------------

    def norm(self) -> Ideal:
        """Return the ideal that the reduced norms generate."""
        return self._norm

    @cached_property
    def _norm(self) -> Ideal:
        return self.frame.norm_ideal(self.rows)

    def volume(self) -> Ideal:
        """Return the index of L in ⟨1, I, J, IJ⟩ over the integers, an ideal; not a whole one, perhaps."""
        return self._volume

    @cached_property
    def _volume(self) -> Ideal:
        return self.frame.volume(self.rows)

    def index(self, other: IntegersLattice) -> Ideal:
        """Return the index ideal [L : M], fractional where M is not in L."""
        return self._same(other).volume() / self.volume()

    # --- ideals ------------------------------------------------------------------------------------

    def _ideal(self, generators: Iterable[object], side: str) -> flint.fmpq_mat:
        """Return the rows of O·x + O·y + …, or of x·O + y·O + … ."""
        given = listed(generators)
        if not given:
            raise LatticeError("expected at least one generator of an ideal")
        left = side == "left"
        elements = [x if left else self.algebra(x).conjugate() for x in given]
        start = self if left else self.conjugate()
        found = unique_rows(flint.fmpq_mat([r for x in elements for r in start._times(x).tolist()]))
        return found if left else flint.fmpq_mat(self.frame.conjugate(found.tolist()))


class IntegersOrder(IntegersLattice):
    """A lattice over the integers of a number field that is a ring with 1.

    >>> from hfield import QuaternionAlgebra
    >>> A = QuaternionAlgebra("QQ[s]/(s^3-2)", -1, -1); O = A.maximal_order()
    >>> O.discriminant(), len(O.basis), O.is_maximal()
    (ideal(2, s), 12, True)
    >>> M = A.order(["i", "j"])
    >>> M.is_maximal().reason
    'its discriminant ideal(4) is that of the algebra, ideal(2, s), times ideal(4, 2*s^2)'
    >>> M.maximal_overorder() >= M, M.local_index(A.ring.primes_above(2)[0])
    (True, 5)
    """

    elsewhere = ORDER

    # --- what it is as a ring ----------------------------------------------------------------------

    def discriminant(self) -> Ideal:
        """Return the reduced discriminant, an ideal of the integers of the field."""
        return self._discriminant

    @cached_property
    def _discriminant(self) -> Ideal:
        frame = self.frame
        return frame.integers.principal(4 * frame.a * frame.b) * self.volume()

    def norm_of_discriminant(self) -> int:
        """Return the absolute norm of the reduced discriminant."""
        return int(self.discriminant().norm())

    @property
    def level(self) -> Ideal:
        """The index in a maximal order: the reduced discriminant over that of the algebra."""
        return self.discriminant() / self.frame.discriminant

    def local_index(self, prime: object) -> int:
        """Return v_P[M : O] for a maximal order M that contains O."""
        P = self.frame.prime(prime)
        return self.discriminant().valuation(P) - (P in self.frame.ramified)

    def is_maximal(self) -> Because:
        """Tell whether no larger order contains this one, with a ``reason``: its discriminant decides."""
        level = self.level
        if level == 1:
            return Because(True, f"its discriminant {self.discriminant()} is that of the algebra")
        whole = f"its discriminant {self.discriminant()} is that of the algebra"
        return Because(False, f"{whole}, {self.frame.discriminant}, times {level}")

    def maximal_overorder(self) -> IntegersOrder:
        """Return a maximal order that contains this one, always the same.

        Raises :class:`UnfactoredError`, and :class:`TooLargeError` at primes of 64 bits and more.
        """
        return IntegersOrder(self.frame, local_orders.maximal(self.frame, self.rows, self.level))

    # --- ideals ------------------------------------------------------------------------------------

    def left_ideal(self, generators: Iterable[object]) -> IntegersIdeal:
        """Return the left ideal O·x + O·y + … . Raises :class:`LatticeError` for a rank below 4."""
        return IntegersIdeal(self.frame, self._ideal(generators, "left"), "left", self)

    def right_ideal(self, generators: Iterable[object]) -> IntegersIdeal:
        """Return the right ideal x·O + y·O + … . Raises :class:`LatticeError` for a rank below 4."""
        return IntegersIdeal(self.frame, self._ideal(generators, "right"), "right", self)

    def __repr__(self) -> str:
        kind = "a maximal order" if self.is_maximal() else "an order"
        return f"{kind} of {self.algebra} with the discriminant {self.discriminant()}"

    # --- units -------------------------------------------------------------------------------------

    def norm_one_group(self) -> NormOneGroup:
        """Return the units of norm 1 modulo ±1 as a group of motions of the hyperbolic plane.

        Raises :class:`IndefiniteError` unless the field is totally real and exactly one real place splits.

        >>> from hfield import QuaternionAlgebra, ring
        >>> K = ring("QQ[s]/(s^3+s^2-2*s-1)")
        >>> A = QuaternionAlgebra.from_ramification(K, K.real_places()[:2])
        >>> G = A.maximal_order().norm_one_group(); G.area, G.signature
        (Fraction(1, 42), Signature(genus=0, orders=(2, 3, 7), cusps=0))
        """
        from hfield.lattices.over_integers.split_order import SplitIntegersOrder

        return NormOneGroup(SplitIntegersOrder(self))

    def unit_index(self) -> int:
        """Return [Oˣ : ℤ_Kˣ], of a totally definite algebra: units are enumerated in the form Tr(N(x)).

        Raises :class:`LatticeError` for other algebras, whose units are infinitely many.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().unit_index()
        60
        """
        field = self.field
        signs = [
            field.multiplication(x).charpoly().coeffs() for x in (-self.frame.a, -self.frame.b)
        ]
        positive = all(c * (-1) ** (len(p) - 1 - k) > 0 for p in signs for k, c in enumerate(p))
        if field.signature != (field.degree, 0) or not positive:
            raise LatticeError(
                f"the units of orders in {shorten(self.algebra)} modulo those of the field are not finitely "
                "many; expected a totally definite algebra over a totally real field"
            )
        # the units of norm u, up to sign, for u in the totally positive units modulo squares of units
        norms = [field.one]
        inside = integers(self.algebra.ring).inside
        for g in map(inside, self.algebra.ring.totally_positive_units()):
            if all((g * u).sqrt() is None for u in norms):
                norms += [g * u for u in norms]
        rows = self.rows.tolist()
        values = [self.frame.norm(row) for row in rows]

        def both(i: int, j: int) -> Any:
            total = self.frame.norm([x + y for x, y in zip(rows[i], rows[j], strict=True)])
            return total - values[i] - values[j]

        size = range(len(rows))
        gram = flint.fmpz_mat([[int(both(i, j).trace().p) for j in size] for i in size])
        change = gram.lll(transform=True, rep="gram")[1]
        form = (change * gram * change.transpose()).tolist()
        basis = flint.fmpq_mat(change) * self.rows
        bound = max(2 * int(u.trace().p) for u in norms)
        count = 0
        for x, _ in short_vectors([list(map(int, row)) for row in form], bound):
            row = flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis
            count += self.frame.norm(row.entries()) in norms
        return count


class IntegersIdeal(IntegersLattice):
    """A lattice with O·I = I for the order O (``side="left"``), or I·O = I (``side="right"``).

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ(sqrt(10))", -1, -1).maximal_order()
    >>> I = O.left_ideal([3, "1 + i + j"])
    >>> I.norm(), I.left_order() == O, I * I.inverse() == O, I.side
    (ideal(3), True, True, 'left')
    """

    elsewhere = IDEAL

    def __init__(
        self, frame: Frame, rows: flint.fmpq_mat, side: str, order: IntegersOrder | None = None
    ) -> None:
        super().__init__(frame, rows)
        self.side, self._order = side, order

    @property
    def order(self) -> IntegersOrder:
        """The order of which this is an ideal."""
        if self._order is None:
            self._order = super().left_order() if self.side == "left" else super().right_order()
        return self._order

    def left_order(self) -> IntegersOrder:
        """Return the x with x·I ⊂ I; for an invertible left ideal it is :attr:`order`."""
        known = self.side == "left" and self.is_invertible()
        return self.order if known else super().left_order()

    def right_order(self) -> IntegersOrder:
        """Return the x with I·x ⊂ I; for an invertible right ideal it is :attr:`order`."""
        known = self.side == "right" and self.is_invertible()
        return self.order if known else super().right_order()

    def is_invertible(self) -> bool:
        """Tell whether the ideal is locally principal."""
        return self._is_locally_principal(self.order)

    def is_integral(self) -> bool:
        """Tell whether the ideal lies in its order."""
        return self <= self.order

    def is_two_sided(self) -> bool:
        """Tell whether the left and the right order are the same."""
        return self.left_order() == self.right_order()

    # --- arithmetic --------------------------------------------------------------------------------

    def __add__(self, other: IntegersLattice) -> IntegersLattice:
        return self._joint(other, super().__add__(other))

    def __and__(self, other: IntegersLattice) -> IntegersLattice:
        return self._joint(other, super().__and__(other))

    def _joint(self, other: IntegersLattice, found: IntegersLattice) -> IntegersLattice:
        """Return a lattice made of two ideals as an ideal, where they are of one side and order."""
        if isinstance(other, IntegersIdeal) and (self.side, self.order) == (
            other.side,
            other.order,
        ):
            return IntegersIdeal(self.frame, found.rows, self.side, self.order)
        return found

    def __mul__(self, other: object) -> IntegersLattice:
        """Return the product with a lattice, an element, a number or an ideal of the field."""
        known = self._order
        if self.side == "right" and isinstance(other, IntegersLattice | Quaternion):
            known = None
            if isinstance(other, IntegersIdeal) and other.side == "right":
                known = other.order
        return IntegersIdeal(self.frame, self._times(other), self.side, known)

    def __rmul__(self, other: object) -> IntegersLattice:
        known = self.side == "right" or not isinstance(other, Quaternion)
        rows = IntegersLattice.__rmul__(self, other).rows
        return IntegersIdeal(self.frame, rows, self.side, self._order if known else None)

    def conjugate(self) -> IntegersIdeal:
        """Return the ideal of the conjugates, on the other side."""
        return IntegersIdeal(self.frame, super().conjugate().rows, OTHER[self.side], self._order)

    def inverse(self) -> IntegersIdeal:
        """Return ``conj(I)/N(I)``. Raises :class:`LatticeError` unless I is locally principal."""
        return IntegersIdeal(self.frame, super().inverse().rows, OTHER[self.side], self._order)

    def __repr__(self) -> str:
        return f"a {self.side} ideal of norm {self.norm()} of {self.order}"


def _integral(matrix: flint.fmpq_mat) -> bool:
    return bool(matrix.numer_denom()[1] == 1)
