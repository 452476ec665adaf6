"""Lattices, orders and ideals over the integers ℤ_K of a number field, as a user holds them.

They are kept as ℤ-lattices of rank 4n: rows are coordinates in the integral basis of K times 1, I, J, IJ
(:class:`Frame`), in Hermite normal form, which is unique, so lattices are equal where rows are. Class numbers
of K play no part (Voight, *Quaternion Algebras*, chapters 9, 10, 16). They stand in one module because they
make one another; what takes an algorithm is a function on frames and rows in a module below.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import flint

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, LatticeError, TooLargeError, shorten
from hfield.evidence import Certified, Claim
from hfield.fields.number_fields.ideals import Ideal
from hfield.fuchsian.group import NormOneGroup
from hfield.hints import CLASSES, IDEAL, LATTICE, ORDER, Hinted, over_fields
from hfield.orders.checked_arguments import checked_side, listed, natural
from hfield.orders.class_number import ByStableClasses, StableClasses, WithStableClasses
from hfield.orders.eigensystems import WithForms
from hfield.orders.over_integers import (
    certificates,
    class_sets,
    equivalence,
    ideals_of_norm,
    local_orders,
    quadratic_orders,
    related_orders,
    stable_classes,
)
from hfield.orders.over_integers.dedekind_modules import free_basis, meet, unique_rows
from hfield.orders.over_integers.frames import Frame, frame_of
from hfield.orders.over_integers.hecke_modules import IntegersModule
from hfield.orders.over_integers.local_orders import Local, Rows
from hfield.orders.over_integers.quadratic_orders import IntegersEmbeddings
from hfield.orders.over_integers.trace_forms import all_of_norm, theta_series, trace_forms
from hfield.orders.ternary_forms import TernaryForm, form_of
from hfield.sympy_printing import PrintedBySympy

if TYPE_CHECKING:
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.orders.over_integers.dedekind_modules import PseudoBasis
    from hfield.orders.over_integers.indefinite_classes import IndefiniteClassSet

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


class IntegersLattice(Hinted, PrintedBySympy):
    """A lattice over the integers of a number field, of full rank; ``rows`` are a basis over ℤ.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(); i = O.algebra(0, 1, 0, 0)
    >>> I = O.right_ideal([2, 1 + i]); J = O.left_ideal([3])
    >>> I.norm(), I.right_order() == O, I * I.inverse() == I.left_order()
    (ideal(2), True, True)
    >>> I + J == O, O.index(I & J), 1 + i in I, I.conjugate().left_order() == O
    (True, ideal(324), True, True)
    """

    elsewhere = over_fields(LATTICE)
    multiplied_by_elements = True  # so that ``q * L`` is asked of L

    def __init__(self, frame: Frame, rows: flint.fmpq_mat) -> None:
        self.frame, self.rows = frame, unique_rows(rows)
        self.algebra, self.field = frame.algebra, frame.field

    def __reduce__(self) -> tuple[object, ...]:
        whole, den = self.rows.numer_denom()
        table = [list(map(int, row)) for row in whole.tolist()]
        return _restored, (type(self), self.algebra, int(den), table, *self._described)

    _described: tuple[object, ...] = ()  # what else the class is made with

    # --- what it is --------------------------------------------------------------------------------

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """A basis over ℤ, of 4n quaternions."""
        return tuple(self.frame.quaternion(row) for row in self.rows.tolist())

    @property
    def hnf(self) -> tuple[int, tuple[tuple[int, ...], ...]]:
        """A denominator and the rows over it, unique: coordinates in the integral basis times 1, I, J, IJ.

        I and J anticommute and have integral squares; they are i and j for t = 0 and integral a and b.
        """
        whole, den = self.rows.numer_denom()
        return int(den), tuple(tuple(map(int, row)) for row in whole.tolist())

    def coordinates(self, x: object) -> tuple[flint.fmpq, ...]:
        """Return the rational coordinates of an element with respect to :attr:`basis`."""
        return tuple((self.frame.row(x) * self.inverse_rows).entries())

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

    def latex(self) -> str:
        """Write the lattice as a sum of ideals times elements, and its algebra, in LaTeX."""
        K: Any = self.algebra.ring
        pairs = []
        for ideal, q in self.pseudo_basis():
            numbers = (K.text(x, "latex") for x in K.ideal(list(ideal)).generators)
            pairs.append(rf"\left({', '.join(numbers)}\right)\left({q.text('latex')}\right)")
        return rf"{' + '.join(pairs)} \subset {self.algebra.latex()}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    # --- arithmetic --------------------------------------------------------------------------------

    def __add__(self, other: IntegersLattice) -> IntegersLattice:
        both = self.rows.tolist() + self._same(other).rows.tolist()
        return IntegersLattice(self.frame, flint.fmpq_mat(both))

    def __and__(self, other: IntegersLattice) -> IntegersLattice:
        """Return the intersection."""
        rows = meet(self.rows, self._same(other).rows)
        is_ring = isinstance(self, IntegersOrder) and isinstance(other, IntegersOrder)
        return (IntegersOrder if is_ring else IntegersLattice)(self.frame, rows)

    def _times(self, other: object) -> flint.fmpq_mat:
        """Return rows that span the product with a lattice, an element, or an ideal of the field."""
        frame = self.frame
        if isinstance(other, IntegersLattice):
            return frame.product(self.rows, self._same(other).rows)
        if isinstance(other, Ideal):
            return frame.multiple(self.rows, frame.ideal(other))
        return self.rows * frame.right(frame.row(other).entries())

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
        return IntegersLattice(self.frame, self.frame.dual(self.rows))

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

    def is_integral(self) -> bool:
        """Tell whether products of elements of the lattice lie in it."""
        return self * self <= self

    # --- elements, in totally definite algebras ----------------------------------------------------

    def _both_signs(self, rows: Iterable[flint.fmpq_mat]) -> tuple[Quaternion, ...]:
        return tuple(self.frame.quaternion((row * s).entries()) for row in rows for s in (1, -1))

    def elements_of_norm(self, n: object) -> tuple[Quaternion, ...]:
        """Return all elements of norm n, a totally positive number of the field; none for other n ≠ 0.

        Raises :class:`IndefiniteError` unless the algebra is totally definite, and :class:`TooLargeError` for
        more than a million.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> len(O.elements_of_norm(1)), len(O.units()), len(O.shortest()), O.shortest()[0].norm()
        (120, 60, 120, 1)
        """
        return tuple(all_of_norm(self.frame, self.rows, self.frame.integers.inside(n)))

    def shortest(self) -> tuple[Quaternion, ...]:
        """Return the elements x ≠ 0 with the least Tr(N(x)), the trace down to ℚ. Raises likewise."""
        return self._both_signs(trace_forms(self.frame).shortest(self.rows))

    def theta_series(self, n: int) -> dict[Any, int]:
        """Return {ν: r(ν)} for the norms ν of trace at most n, 0 among them, r(ν) = #{x in L: N(x) = ν}.

        Ascending by traces. Raises :class:`IndefiniteError` unless the algebra is totally definite, and
        :class:`TooLargeError` for more than two million elements.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().theta_series(3)
        {0: 1, 1: 120, 3/2+1/2*sqrt(5): 120, 3/2-1/2*sqrt(5): 120}
        """
        found = theta_series(
            self.frame, self.rows, natural(n, "a theta series goes up to the trace")
        )
        ordered = sorted(found.items(), key=lambda pair: (pair[0].trace(), str(pair[0])))
        return {self.frame.integers.outside(norm): count for norm, count in ordered}

    def reduced_basis(self) -> tuple[Quaternion, ...]:
        """Return a basis over ℤ that is LLL-reduced for Tr(N(x)). Raises likewise."""
        _, basis, _ = trace_forms(self.frame).reduced(self.rows, self.field.one)
        return tuple(map(self.frame.quaternion, basis.tolist()))

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


class IntegersOrder(IntegersLattice, WithStableClasses, Certified):
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

    elsewhere = over_fields(ORDER) | {"ternary_quadratic_form": "ternary_form()"}

    # --- what it is as a ring ----------------------------------------------------------------------

    def discriminant(self) -> Ideal:
        """Return the reduced discriminant, an ideal of the integers of the field."""
        return self._discriminant

    @cached_property
    def _discriminant(self) -> Ideal:
        return self.frame.reduced_discriminant(self.rows)

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

    def eichler_symbol(self, prime: object) -> int | None:
        """Return the Eichler symbol (O | P): 1, 0 or −1; None where the order is M₂(ℤ_P).

        It tells the residue algebra: split, ramified or inert (Voight, definition 24.3.2).
        """
        P = self.frame.prime(prime)
        if not self.discriminant().valuation(P):
            return None
        return Local(self.frame, P).symbol(self.rows)

    def is_eichler(self) -> bool:
        """Tell whether this is an intersection of two maximal orders (Voight, section 24.3)."""
        level = self.level.factorisation()
        ramified = self.frame.ramified
        return all(
            self.frame.prime(P) not in ramified and self.eichler_symbol(P) == 1 for P, _ in level
        )

    def is_maximal(self) -> Because:
        """Tell whether no larger order contains this one, with a ``reason``: its discriminant decides."""
        level = self.level
        if level == 1:
            return Because(True, f"its discriminant {self.discriminant()} is that of the algebra")
        whole = f"its discriminant {self.discriminant()} is that of the algebra"
        return Because(False, f"{whole}, {self.frame.discriminant}, times {level}")

    def ternary_form(self) -> TernaryForm:
        """Return a form whose even Clifford algebra is the order; up to units its discriminant is that.

        Raises :class:`LatticeError` for an order that is no free module, see :meth:`pseudo_basis`.

        >>> from hfield import QuaternionAlgebra
        >>> f = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().ternary_form()
        >>> f.order().is_maximal().holds, f.ring.norm(f.discriminant())
        (True, 1)
        """
        _, *pairs = self.pseudo_basis()  # the first are the integers of the field
        i, j, k = free_basis(self.frame, tuple(pairs))
        return form_of((i, j, k), type(self.algebra))

    def maximal_overorder(self) -> IntegersOrder:
        """Return a maximal order that contains this one, always the same.

        Raises :class:`UnfactoredError`, and :class:`TooLargeError` at primes of 64 bits and more.
        """
        return IntegersOrder(self.frame, local_orders.maximal(self.frame, self.rows, self.level))

    def is_definite(self) -> bool:
        """Tell whether the algebra is totally definite: units modulo those of the field are finitely many."""
        return self.frame.is_definite

    def conductor(self) -> Ideal:
        """Return the largest ideal f with O = ℤ_K + f·G for an order G; 1 for a Gorenstein order."""
        return related_orders.conductor(self.frame, self.rows)

    def is_gorenstein(self) -> bool:
        """Tell whether the codifferent is invertible: whether the conductor is 1 (Voight, section 24.2)."""
        return self.conductor() == 1

    def gorenstein_closure(self) -> IntegersOrder:
        """Return the Gorenstein order G with O = ℤ_K + f·G, f the conductor (Voight, section 24.2)."""
        return IntegersOrder(self.frame, related_orders.gorenstein_closure(self.frame, self.rows))

    def is_bass(self) -> bool:
        """Tell whether every order that contains this one is Gorenstein (Voight, section 24.5)."""
        return related_orders.is_bass(self.frame, self.rows)

    def is_hereditary(self) -> bool:
        """Tell whether all ideals are invertible: whether no square divides the discriminant."""
        return all(e == 1 for _, e in self.discriminant().factorisation())

    def suborders(self, prime: object, k: int = 1) -> list[IntegersOrder]:
        """Return all orders of index Pᵏ in this one. Raises :class:`TooLargeError` for many candidates.

        >>> from hfield import QuaternionAlgebra
        >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); O = A.maximal_order(); P = A.ring.primes_above(2)[0]
        >>> [len(O.suborders(P, k)) for k in (1, 2)], len(O.suborders(P)[0].overorders(P))
        ([5, 41], 2)
        """
        return self._related(related_orders.suborders, prime, k)

    def overorders(self, prime: object, k: int = 1) -> list[IntegersOrder]:
        """Return all orders in which this one has the index Pᵏ. Raises :class:`TooLargeError` likewise."""
        return self._related(related_orders.overorders, prime, k)

    def _related(self, search: Any, prime: object, k: int) -> list[IntegersOrder]:
        local = Local(self.frame, self.frame.prime(prime))
        found = search(local, self.rows, natural(k, "the exponent of an index is"))
        return [IntegersOrder(self.frame, rows) for rows in found]

    # --- elements ----------------------------------------------------------------------------------

    def represent_integer(self, n: object) -> Quaternion | None:
        """Return an element of norm n, an integer of the field, or None where there is none.

        Decided by enumeration, or by a prime that forbids it. Raises :class:`IndefiniteError` unless the
        algebra is totally definite, and :class:`UndecidedError` for large n.

        >>> from hfield import QuaternionAlgebra
        >>> A = QuaternionAlgebra("QQ(sqrt(2))", -1, -1); M, s = A.maximal_order(), A.ring.gen
        >>> A.order(["i", "j"]).represent_integer(2 + s), M.represent_integer(2 + s).norm()
        (None, 2+sqrt(2))
        """
        return quadratic_orders.represent(self.frame, self.rows, n)

    def embeddings(self, discriminant: object) -> IntegersEmbeddings:
        """Return the optimal embeddings of the quadratic order of a totally negative discriminant.

        Raises :class:`LatticeError` for what is no such discriminant, :class:`IndefiniteError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(); found = O.embeddings(-3)
        >>> len(found), found.orbits, found.element**3
        (20, 1, −1)
        """
        return quadratic_orders.embeddings(self.frame, self.rows, discriminant)

    # --- ideals ------------------------------------------------------------------------------------

    def two_sided_prime(self, prime: object) -> IntegersIdeal:
        """Return the two-sided ideal at P that generates, with those of the field, all invertible ones there.

        Its square is Pᵉ·O, the part of the discriminant at P; it is P·O where P does not divide that.
        Raises :class:`LatticeError` where the order is neither maximal nor Eichler at P.
        """
        P = self.frame.prime(prime)
        e = self.discriminant().valuation(P)
        if e > 1 and (P in self.frame.ramified or self.eichler_symbol(P) != 1):
            raise LatticeError(
                f"the order is neither maximal nor an Eichler order at {shorten(prime)}: its two-sided "
                "ideals there are not known"
            )
        found = self * self.frame.integers.prime(P) ** max(e, 1)
        if e:
            found = found + self.dual() * self.discriminant()
        return IntegersIdeal(self.frame, found.rows, "right", self)

    def connecting_ideal(self, other: IntegersOrder) -> IntegersIdeal:
        """Return the primitive integral ideal with this left order and the right order ``other``.

        Raises :class:`LatticeError` unless both are Eichler orders of one level.
        """
        self._same(other)
        level = self.level
        if (
            not isinstance(other, IntegersOrder)
            or other.level != level
            or not (self.is_eichler() and other.is_eichler())
        ):
            raise LatticeError(
                "connecting ideals exist here between Eichler orders of one level, and these are none"
            )
        rows = related_orders.connecting(self.frame, self.rows, other.rows, level)
        return IntegersIdeal(self.frame, rows, "left", self)

    def left_ideal(self, generators: Iterable[object]) -> IntegersIdeal:
        """Return the left ideal O·x + O·y + … . Raises :class:`LatticeError` for a rank below 4."""
        return IntegersIdeal(self.frame, self._ideal(generators, "left"), "left", self)

    def two_sided_ideal(self, generators: Iterable[object]) -> IntegersIdeal:
        """Return the ideal of the sums of all a·x·b, as a right ideal. Raises :class:`LatticeError`."""
        return IntegersIdeal(self.frame, (self.left_ideal(generators) * self).rows, "right", self)

    def right_ideal(self, generators: Iterable[object]) -> IntegersIdeal:
        """Return the right ideal x·O + y·O + … . Raises :class:`LatticeError` for a rank below 4."""
        return IntegersIdeal(self.frame, self._ideal(generators, "right"), "right", self)

    def ideals_of_prime_norm(self, prime: PrimeIdeal) -> tuple[Local, list[Rows]]:
        """Return what is needed to list right ideals of norm P, computed once."""
        if prime not in self._known:
            local = Local(self.frame, prime)
            exponent = self.discriminant().valuation(prime)
            found = ideals_of_norm.generators(local, self.rows, exponent)
            self._known[prime] = local, found
        return self._known[prime]

    @cached_property
    def _known(self) -> dict[PrimeIdeal, tuple[Local, list[Rows]]]:
        return {}

    def subideals(self, ideal: IntegersLattice, prime: object) -> list[IntegersIdeal]:
        """Return all invertible right ideals of relative norm P in an invertible right ideal of this order.

        They are N(P) + 1 where P does not divide the discriminant. Raises :class:`TooLargeError`.
        """
        local, found = self.ideals_of_prime_norm(self.frame.prime(prime))
        rows = ideals_of_norm.subideals(local, self._same(ideal).rows, found)
        return [IntegersIdeal(self.frame, J, "right", self) for J in rows]

    def ideals_of_norm(self, norm: object, side: str = "left") -> list[IntegersIdeal]:
        """Return all invertible integral ideals on a side whose norm is an ideal or a prime of the field.

        Of prime norm P, off the discriminant, there are N(P) + 1. Raises :class:`LatticeError`,
        and :class:`TooLargeError` for more than 10⁵.

        >>> from hfield import QuaternionAlgebra
        >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); O = A.eichler_order(3)
        >>> [len(O.ideals_of_norm(n)) for n in (1, 2, 3)]
        [1, 5, 19]
        """
        wanted = self.frame.ideal(norm)
        if not wanted.is_integral():
            raise LatticeError(f"expected an ideal of integers as the norm, not {wanted}")
        layer = [IntegersIdeal(self.frame, self.rows, "right", self)]
        for P, e in wanted.factorisation():
            if e > 1 and self.discriminant().valuation(P) > 1:
                raise LatticeError(
                    f"ideals of norm {wanted} are not listed at {P}, whose square divides the discriminant; "
                    "those of norm P are"
                )
            for _ in range(e):
                if len(layer) * (self.frame.prime(P).norm() + 1) > ideals_of_norm.MOST:
                    raise TooLargeError(f"there are too many ideals of norm {wanted} to list them")
                layer = list({J: J for I in layer for J in self.subideals(I, P)})
        return layer if checked_side(side) == "right" else [J.conjugate() for J in layer]

    def __repr__(self) -> str:
        kind = "a maximal order" if self.is_maximal() else "an order"
        return f"{kind} of {self.algebra} with the discriminant {self.discriminant()}"

    # --- units, in an algebra that splits at one real place -----------------------------------------

    def norm_one_group(self) -> NormOneGroup:
        """Return the units of norm 1 modulo ±1 as a group of motions of the hyperbolic plane.

        Raises :class:`IndefiniteError` unless the field is totally real and exactly one real place splits.

        >>> from hfield import QuaternionAlgebra, ring
        >>> K = ring("QQ[s]/(s^3+s^2-2*s-1)")
        >>> A = QuaternionAlgebra.from_ramification(K, K.real_places()[:2])
        >>> G = A.maximal_order().norm_one_group(); G.area, G.signature
        (Fraction(1, 42), Signature(genus=0, orders=(2, 3, 7), cusps=0))
        """
        from hfield.orders.over_integers.split_order import SplitIntegersOrder

        return NormOneGroup(SplitIntegersOrder(self))

    # --- units and classes, in a totally definite algebra ------------------------------------------

    def unit_index(self) -> int:
        """Return [Oˣ : ℤ_Kˣ]. Raises :class:`IndefiniteError` where it is infinite.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> O.unit_index(), O.unit_group()
        (60, 'A5')
        """
        return equivalence.unit_index(self.frame, self.rows)

    def units(self) -> tuple[Quaternion, ...]:
        """Return one unit of each coset of ℤ_Kˣ. Raises :class:`IndefiniteError` where they are infinite."""
        rows = equivalence.units(self.frame, self.rows)
        return tuple(self.frame.quaternion(row.entries()) for row in rows)

    def unit_group(self) -> str:
        """Return the name of Oˣ/ℤ_Kˣ: ``C4 D2 D6 A4 S4 A5`` and so on. Raises :class:`IndefiniteError`."""
        return equivalence.unit_group(self.frame, self.rows)

    def isomorphism(self, other: IntegersLattice) -> equivalence.Comparison:
        """Return an answer with an ``element`` x, x·O·x⁻¹ being the other order, or the ``reason`` why none.

        Raises :class:`IndefiniteError`.
        """
        ring = self._same(other).left_order()
        if ring != other:
            raise LatticeError(f"{shorten(repr(other))} is no order")
        if self.discriminant() != ring.discriminant():
            found = equivalence.Comparison(False, "their discriminants differ")
        else:
            found = equivalence.conjugator(self.frame, self.rows, ring.rows)
        return replace(found, claimed=partial(certificates.of_isomorphism, self, ring))

    @property
    def claim(self) -> Claim:
        """That this is an order of its discriminant, as a statement with its evidence."""
        return certificates.of_order(self)

    @property
    def units_claim(self) -> Claim:
        """How many units there are modulo those of the field, likewise."""
        return certificates.of_unit_index(self)

    def mass(self) -> Fraction:
        """Return Σ 1/[O_L(I)ˣ : ℤ_Kˣ] over the right ideal classes, by a formula. Raises likewise."""
        return class_sets.mass(self)

    @cached_property
    def _stable(self) -> StableClasses:
        return stable_classes.stable_classes(self)

    def _units_modulo_scalars(self) -> int:
        return self.unit_index()

    def class_set(self) -> IntegersClassSet:
        """Return the invertible right ideal classes, complete by the mass formula. Raises likewise."""
        if not self.is_definite():
            number = class_sets.number_by_signs(self.algebra)
            raise IndefiniteError(
                f"{self.algebra} is split at an infinite place: by strong approximation an Eichler order "
                f"has as many right ideal classes as the ideals of {self.algebra.ring.name} have modulo "
                f"generators that are positive where the algebra ramifies, {number}, told by the reduced "
                "norm, and classes_by_norm() has representatives; class_set() enumerates in totally definite "
                "algebras"
            )
        return IntegersClassSet(self)

    def classes_by_norm(self) -> IndefiniteClassSet:
        """Return the right ideal classes where the algebra splits at an infinite place, with representatives.

        Raises :class:`IndefiniteError` for a totally definite algebra, and for orders of which local units do
        not have all norms.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra("QQ(sqrt(10))", -1, 3).maximal_order().classes_by_norm()
        >>> len(C), [I.norm() for I in C], [C.index(I) for I in C], C.type_number
        (2, [ideal(1), ideal(2, sqrt(10))], [0, 1], 1)
        """
        from hfield.orders.over_integers.indefinite_classes import IndefiniteClassSet

        return IndefiniteClassSet(self)

    def expect_right_ideal(self, ideal: object) -> None:
        """Raise :class:`LatticeError` unless this is an invertible right ideal of the order."""
        if not isinstance(ideal, IntegersIdeal) or ideal.side != "right":
            raise LatticeError(f"expected a right ideal of the order, not {shorten(repr(ideal))}")
        if ideal.order != self or not ideal.is_invertible():
            raise LatticeError(f"{shorten(repr(ideal))} is no invertible right ideal of {self}")


class IntegersIdeal(IntegersLattice, Certified):
    """A lattice with O·I = I for the order O (``side="left"``), or I·O = I (``side="right"``).

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ(sqrt(10))", -1, -1).maximal_order()
    >>> I = O.left_ideal([3, "1 + i + j"])
    >>> I.norm(), I.left_order() == O, I * I.inverse() == O, I.side
    (ideal(3), True, True, 'left')
    """

    elsewhere = over_fields(IDEAL)

    def __init__(
        self, frame: Frame, rows: flint.fmpq_mat, side: str, order: IntegersOrder | None = None
    ) -> None:
        super().__init__(frame, rows)
        self.side, self._order = side, order

    @property
    def _described(self) -> tuple[object, ...]:  # type: ignore[override]
        return self.side, self._order

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

    def primitive_part(self) -> tuple[IntegersIdeal, Ideal]:
        """Return (J, a) with I = a·J, a an ideal of the field, and J integral and not in b·O for any other b.

        Raises :class:`LatticeError` unless the ideal is integral.
        """
        inverse = self.frame.scalars_into(self.rows, self.order.rows)
        if not self.is_integral():
            raise LatticeError("only an integral ideal has a primitive part, and this one is none")
        return self._with(self * inverse), inverse.inverse()

    # --- arithmetic --------------------------------------------------------------------------------

    def _with(self, lattice: IntegersLattice) -> IntegersIdeal:
        return IntegersIdeal(self.frame, lattice.rows, self.side, self._order)

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

    # --- classes, in a totally definite algebra ----------------------------------------------------

    def is_principal(self) -> equivalence.Comparison:
        """Return an answer with a generator as ``element``: I = O·c for a left ideal, c·O for a right one."""
        return IntegersIdeal(self.frame, self.order.rows, self.side, self.order).equivalence(self)

    def equivalence(self, other: IntegersIdeal) -> equivalence.Comparison:
        """Return an answer with ``element`` c such that J = I·c for left ideals, J = c·I for right ones.

        Where there is none it is false, and ``reason`` says why. Where the algebra splits at several infinite
        places, or at a complex one, strong approximation decides, and no element is told. Raises
        :class:`LatticeError` for ideals that are not invertible, or of different orders or sides,
        :class:`IndefiniteError` where an Eichler symbol is 0 in such an algebra.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(3))", -1, -1).maximal_order()
        >>> I = O.left_ideal([11, "1 + 3*i + j"]); answer = I.is_principal()
        >>> I.norm(), bool(answer), O.left_ideal([answer.element]) == I
        (ideal(11), True, True)
        """
        same = isinstance(other, IntegersIdeal) and (self.side, self.order) == (
            other.side,
            other.order,
        )
        if not same or not (self.is_invertible() and other.is_invertible()):
            raise LatticeError(
                f"expected two invertible {self.side} ideals of one order, not {shorten(repr(other))}"
            )
        norm = other.norm() / self.norm()
        if not (self.frame.is_definite or self.frame.is_fuchsian):
            from hfield.orders.over_integers import indefinite_classes

            return indefinite_classes.equivalence(self.order, norm)
        pair = (self.inverse(), other) if self.side == "left" else (other, self.inverse())
        between = pair[0] * pair[1]
        if self.frame.is_definite:
            found = equivalence.element_generating(self.frame, between.rows, norm)
        else:
            from hfield.orders.over_integers.split_order import element_generating

            found = element_generating(self.order, between.rows, norm)
        return replace(found, claimed=partial(certificates.of_equivalence, self, other))

    def is_equivalent(self, other: IntegersIdeal) -> bool:
        """Tell whether J = I·c, or c·I, for some c. Raises as :meth:`equivalence` does."""
        return bool(self.equivalence(other))

    @property
    def claim(self) -> Claim:
        """That this is a locally principal ideal of its order, as a statement with its evidence."""
        return certificates.of_ideal(self)

    def __repr__(self) -> str:
        return f"a {self.side} ideal of norm {self.norm()} of {self.order}"


class IntegersClassSet(class_sets.Classes, ByStableClasses, WithForms, Certified, Hinted):
    """The invertible right ideal classes of an order: ``len(C)``, iteration over representatives, ``C[n]``.

    >>> from hfield import QuaternionAlgebra
    >>> C = QuaternionAlgebra("QQ(sqrt(6))", -1, -1).maximal_order().class_set()
    >>> len(C), C.mass, C.type_number
    (3, Fraction(1, 4), 3)
    """

    elsewhere = CLASSES
    order: IntegersOrder

    def __init__(self, order: IntegersOrder) -> None:
        super().__init__(order)
        self.order = order

    @property
    def claim(self) -> Claim:
        """How many classes there are, as a statement with its evidence."""
        return certificates.of_class_set(self)

    def __getitem__(self, n: int) -> IntegersIdeal:
        """Return the representative of class n, a right ideal that contains 1; class 0 is that of O."""
        return IntegersIdeal(self.frame, self.lattices[n], "right", self.order)

    def __iter__(self) -> Iterator[IntegersIdeal]:
        return (self[n] for n in range(len(self)))

    def left_ideals(self) -> Iterator[IntegersIdeal]:
        """Yield representatives of the left ideal classes, the conjugates of the right ones."""
        return (I.conjugate() for I in self)

    def index(self, ideal: IntegersIdeal) -> int:
        """Return the number of the class of a right ideal. Raises :class:`LatticeError` for others."""
        self.order.expect_right_ideal(ideal)
        return self.class_of(ideal.rows, ideal.norm())

    def left_orders(self) -> list[IntegersOrder]:
        """Return the left orders of the representatives, one a class."""
        return [I.left_order() for I in self]

    def _stable_class(self, n: int) -> tuple[int, int]:
        stable, norm, frame = self.order._stable, self.norms[n], self.frame
        local = (
            ideals_of_norm.local_generator(Local(frame, place.prime), self.lattices[n])
            for place in stable.places
        )
        values = (frame.norm(x.entries()) / norm.element for x in local)
        return norm.number, stable.reduced(values)

    @cached_property
    def _forms(self) -> IntegersModule:
        """The functions on the classes as a module of Hecke operators."""
        frame = self.frame

        def of_level(level: list[tuple[PrimeIdeal, int]]) -> IntegersClassSet:
            primes = [frame.integers.prime(P) ** e for P, e in level]
            ideal = math.prod(primes, start=frame.integers.one)
            rows = local_orders.eichler(frame, self._maximal.rows, ideal)
            return IntegersClassSet(IntegersOrder(frame, rows))

        return IntegersModule(self, of_level)

    @cached_property
    def _maximal(self) -> IntegersOrder:
        return self.order.maximal_overorder()

    def __repr__(self) -> str:
        return f"{len(self)} right ideal classes, mass {self.mass}, of {self.order}"


def _restored(
    kind: type[Any], algebra: Any, den: int, table: list[list[int]], *rest: object
) -> IntegersLattice:
    """Return a lattice that was pickled."""
    rows = flint.fmpq_mat(flint.fmpz_mat(table)) * flint.fmpq(1, den)
    found: IntegersLattice = kind(frame_of(algebra), rows, *rest)
    return found


def _integral(matrix: flint.fmpq_mat) -> bool:
    return bool(matrix.numer_denom()[1] == 1)
