"""Lattices, orders, ideals and class sets as a user holds them: values, with what one asks of them.

They stand in one module because they make one another: a lattice its orders, an order its ideals and its
classes, an ideal its order. What takes an algorithm is a function on values in a module below.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cached_property
from typing import Any, Self, overload

from flint import fmpq

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import LatticeError, MixedParentsError, shorten
from hfield.evidence import Certified, Claim
from hfield.fuchsian.group import NormOneGroup
from hfield.fuchsian.split_order import RationalOrder
from hfield.hints import CLASSES, IDEAL, LATTICE, ORDER, Hinted
from hfield.orders import (
    certificates,
    class_number,
    compatible_products,
    equivalence,
    hermite,
    ideals_of_norm,
    isomorphic_orders,
    klpt,
    maximal_orders,
    quadratic_orders,
    short_elements,
    ternary_forms,
    z_lattice,
    z_order,
)
from hfield.orders.certificates import Answer
from hfield.orders.checked_arguments import (
    checked_side,
    integer,
    listed,
    natural,
    positive,
    prime,
)
from hfield.orders.checked_arguments import prime as checked_prime
from hfield.orders.class_number import ByStableClasses, StableClasses, WithStableClasses
from hfield.orders.classes import Classes
from hfield.orders.eigensystems import WithForms
from hfield.orders.hecke_modules import RationalModule
from hfield.orders.quadratic_orders import Embeddings
from hfield.orders.short_elements import expect_definite
from hfield.orders.ternary_forms import TernaryForm
from hfield.orders.z_lattice import ZLattice, rows_json
from hfield.orders.z_order import ZOrder
from hfield.rings.whole_numbers import fraction
from hfield.sympy_printing import PrintedBySympy

UNIT_GROUPS = {2: "C2", 4: "C4", 6: "C6", 8: "Q8", 12: "Dic3", 24: "SL(2,3)"}
"""Which group the units are, by their number, in a definite algebra over ℚ (Voight, section 11.5)."""
OTHER = {"left": "right", "right": "left", "two-sided": "two-sided"}


class Lattice(Hinted, PrintedBySympy):
    """The integer combinations of four independent elements of an algebra over ℚ.

    It is kept in its Hermite normal form over (1, i, j, k), so equal lattices are equal, and hash
    alike, however they were given. ``x in L`` asks for membership, ``M <= L`` for containment.

    >>> from hfield import H
    >>> A = H("QQ")
    >>> L = A.lattice([1, "i", "j", "1/2 + 1/2*i + 1/2*j + 1/2*k"])
    >>> L.hnf
    (2, ((1, 1, 1, 1), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 2)))
    >>> L.theta_series(4)
    [1, 24, 24, 96, 24]
    """

    elsewhere = LATTICE
    multiplied_by_elements = True  # so that ``q * L`` is asked of L

    def __init__(self, value: ZLattice) -> None:
        self.value = value
        self.algebra = value.algebra

    @classmethod
    def spanned(cls, algebra: Parent, elements: Iterable[object]) -> Lattice:
        """Return the lattice that elements span over ℤ.

        Raises :class:`LatticeError` when its rank is below 4, :class:`RingError` for an algebra that
        is not over ℚ.
        """
        return Lattice(z_lattice.spanned(algebra, elements))

    # --- what it is ------------------------------------------------------------------------------

    @property
    def hnf(self) -> tuple[int, hermite.Rows]:
        """The least denominator, and the rows of the Hermite normal form, integers."""
        return self.value.hnf

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The rows of the normal form as elements: a basis, the same for equal lattices."""
        return self.value.basis

    def __contains__(self, x: object) -> bool:
        return z_lattice.contains(self.value, x)

    def coordinates(self, x: object) -> tuple[Any, ...]:
        """Return the rational coordinates of an element with respect to :attr:`basis`."""
        return z_lattice.coordinates(self.value, x)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Lattice) and self.value == other.value

    def __hash__(self) -> int:
        return hash(self.value)

    def __le__(self, other: Lattice) -> bool:
        """Tell whether every element of this lattice lies in the other."""
        return z_lattice.includes(self._same(other, "compare").value, self.value)

    def __ge__(self, other: Lattice) -> bool:
        return z_lattice.includes(self.value, self._same(other, "compare").value)

    def __repr__(self) -> str:
        return f"ℤ⟨{', '.join(map(str, self.basis))}⟩ in {self.algebra}"

    def latex(self) -> str:
        """Write the lattice by its basis over ℤ, and its algebra, in LaTeX."""
        basis = ", ".join(q.text("latex") for q in self.basis)
        return rf"\mathbb{{Z}}\left\langle {basis} \right\rangle \subset {self.algebra.latex()}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    def _same(self, other: object, what: str) -> Lattice:
        if not isinstance(other, Lattice):
            raise LatticeError(
                f"cannot {what} a lattice and {shorten(repr(other))}: expected a lattice"
            )
        if other.algebra is not self.algebra and other.algebra != self.algebra:
            raise MixedParentsError(
                f"cannot {what} a lattice in {self.algebra} and one in {other.algebra}: "
                "they lie in different algebras"
            )
        return other

    # --- arithmetic ------------------------------------------------------------------------------

    def __add__(self, other: object) -> Lattice:
        """Return the sum, the least lattice that contains both."""
        return Lattice(z_lattice.add(self.value, self._same(other, "add").value))

    def __and__(self, other: object) -> Lattice:
        """Return the intersection."""
        return Lattice(z_lattice.meet(self.value, self._same(other, "intersect").value))

    def __mul__(self, other: object) -> Lattice:
        """Return the lattice spanned by all products, or the multiple by an element or a number."""
        if isinstance(other, Lattice):
            return Lattice(z_lattice.product(self.value, self._same(other, "multiply").value))
        return Lattice(z_lattice.multiple(self.value, other, "right"))

    def __rmul__(self, other: object) -> Lattice:
        return Lattice(z_lattice.multiple(self.value, other, "left"))

    def __truediv__(self, n: object) -> Lattice:
        """Return the lattice divided by a rational number."""
        x = fraction(n)
        if not x:
            raise LatticeError("a lattice cannot be divided by 0")
        return Lattice(z_lattice.scaled(self.value, 1 / x))

    def conjugate(self) -> Lattice:
        """Return the lattice of the conjugates."""
        return Lattice(z_lattice.conjugate(self.value))

    def dual(self) -> Lattice:
        """Return ``{x : tr(x·L) ⊆ ℤ}``, the codifferent of an order (Voight, definition 15.6.2)."""
        return Lattice(z_lattice.dual(self.value))

    def colon(self, other: object, side: str = "left") -> Lattice:
        """Return ``{x : x·M ⊆ L}`` for M = other, or ``{x : M·x ⊆ L}`` for ``side="right"``."""
        factor = self._same(other, "divide")
        return Lattice(z_lattice.colon(self.value, factor.value, checked_side(side)))

    def index(self, other: object) -> int | Fraction:
        """Return the index of the other lattice in this one: an int where it is contained.

        Otherwise the ratio of the volumes, a Fraction (Voight, section 9.6).
        """
        ratio = z_lattice.index(self.value, self._same(other, "compare").value)
        return ratio.numerator if ratio.denominator == 1 else ratio

    def left_order(self) -> Order:
        """Return ``{x : x·L ⊆ L}``, an order; in M₂(ℚ) as in division algebras."""
        return Order(z_order.order_of(self.value, "left"))

    def right_order(self) -> Order:
        """Return ``{x : L·x ⊆ L}``, an order."""
        return Order(z_order.order_of(self.value, "right"))

    def is_invertible(self) -> bool:
        """Tell whether ``L·L⁻¹`` is the left order: whether L is locally principal (Voight, 16.7.7)."""
        return z_order.is_locally_principal(self.value, self.left_order().value)

    def inverse(self) -> Lattice:
        """Return ``{x : L·x·L ⊆ L}``, the inverse. Raises :class:`LatticeError` where L has none."""
        if not self.is_invertible():
            raise LatticeError(f"{shorten(self)} is not invertible: it is not locally principal")
        return Lattice(z_lattice.scaled(z_lattice.conjugate(self.value), 1 / self.value.norm))

    def is_integral(self) -> bool:
        """Tell whether products of elements of the lattice lie in it."""
        return z_lattice.includes(self.value, z_lattice.product(self.value, self.value))

    # --- the norm --------------------------------------------------------------------------------

    def norm(self) -> fmpq:
        """Return the reduced norm of the lattice, the gcd of the norms of its elements, in QQ."""
        value = self.value
        return fmpq(value.content, value.regular.scale * value.den * value.den)

    def gram_matrix(self) -> tuple[tuple[fmpq, ...], ...]:
        """Return ``tr(x·conj(y))`` for x, y in :attr:`basis`: twice the norms are on the diagonal."""
        F, norm = self.algebra.ring, self.value.norm
        return tuple(tuple(F(x * norm) for x in row) for row in hermite.tuples(self.value.even))

    def reduced_basis(self) -> tuple[Quaternion, ...]:
        """Return an LLL-reduced basis for the norm, the shortest first in a definite algebra.

        In an indefinite one the norm is replaced by ``|w² …|``, the sum of the absolute values of its terms.
        """
        rows, gram = self.value.reduced
        found = self.value.elements(rows)
        if not self.value.regular.definite:
            return found
        return tuple(found[n] for n in sorted(range(4), key=lambda n: gram[n][n]))

    def shortest(self) -> tuple[Quaternion, ...]:
        """Return the nonzero elements of least norm, of a definite algebra, x and −x."""
        expect_definite(self.value, "shortest()")
        return short_elements.shortest(self.value)

    def elements_of_norm(self, n: object) -> tuple[Quaternion, ...]:
        """Return all elements of norm n, of a definite algebra.

        Raises :class:`IndefiniteError`, and :class:`TooLargeError` where there are more than a million.
        """
        expect_definite(self.value, "elements_of_norm()")
        return short_elements.of_norm(self.value, fraction(n))

    def elements_of_norm_at_most(self, n: object) -> tuple[Quaternion, ...]:
        """Return all elements of norm at most n, 0 too, of a definite algebra, by ascending norm.

        Raises as :meth:`elements_of_norm` does.
        """
        expect_definite(self.value, "elements_of_norm_at_most()")
        return short_elements.of_norm_at_most(self.value, fraction(n))

    def theta_series(self, n: int) -> list[int]:
        """Return [r(0), …, r(n)], where r(m) elements have the norm ``m·norm()``, in a definite algebra.

        Raises :class:`IndefiniteError`.
        """
        expect_definite(self.value, "theta_series()")
        return short_elements.theta_series(self.value, n)


class Order(WithStableClasses, Certified, Lattice):
    """A lattice that is a ring with 1: ``q in O`` asks for membership.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> O.discriminant(), O.is_maximal(), O.is_definite(), O.unit_count()
    (11, True, True, 4)
    """

    elsewhere = ORDER
    value: ZOrder

    def __init__(self, value: ZOrder) -> None:
        super().__init__(value)

    @classmethod
    def generated(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the ring that elements generate.

        Raises :class:`LatticeError` when it has a rank below 4, or is no lattice, because it contains
        elements that are not integral.
        """
        return cls(z_order.generated(algebra, elements))

    @classmethod
    def from_basis(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the order with the given ℤ-basis.

        Raises :class:`LatticeError` unless they are four that span a ring with 1; the message names
        the product that is missing.
        """
        basis = listed(elements)
        if len(basis) != 4:
            raise LatticeError(
                f"a basis of an order has four elements, and {len(basis)} were given"
            )
        return cls.from_lattice(Lattice.spanned(algebra, basis))

    @classmethod
    def from_lattice(cls, lattice: Lattice) -> Order:
        """Return a lattice as an order. Raises :class:`LatticeError` unless it is a ring with 1."""
        return cls(z_order.checked_ring(lattice.value))

    @overload
    def __and__(self, other: Order) -> Order: ...
    @overload
    def __and__(self, other: object) -> Lattice: ...
    def __and__(self, other: object) -> Lattice:
        """Return the intersection with a lattice; that with another order is an order."""
        found = super().__and__(other)
        return Order(ZOrder.of(found.value)) if isinstance(other, Order) else found

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        return certificates.of_order(self.value)

    @property
    def evidence(self) -> dict[str, object]:
        """What a program needs to check the order: its rows, closed under products, and its discriminant."""
        return {
            "kind": "order",
            "algebra": str(self.algebra),
            **rows_json(self.value),
            "discriminant": self.value.discriminant,
            "discriminant_of_algebra": self.value.regular.discriminant,
        }

    # --- what it is as a ring --------------------------------------------------------------------

    def discriminant(self) -> int:
        """Return the reduced discriminant; for a maximal order it is that of the algebra."""
        return self.value.discriminant

    @property
    def level(self) -> int:
        """The index in a maximal order: the reduced discriminant over that of the algebra."""
        return self.value.level

    def is_definite(self) -> bool:
        """Tell whether the algebra ramifies at the infinite place: the order has finitely many units."""
        return bool(self.value.regular.definite)

    def is_maximal(self) -> bool:
        """Tell whether no larger order contains this one: whether its discriminant is that small."""
        return self.value.level == 1

    def is_eichler(self) -> bool:
        """Tell whether this is an intersection of two maximal orders (Voight, section 24.3)."""
        return z_order.is_eichler(self.value)

    def eichler_symbol(self, p: int) -> int | None:
        """Return the Eichler symbol (O | p): 1, 0 or −1; None where the order is M₂(ℤₚ).

        It tells the residue algebra: split, ramified or inert (Voight, definition 24.3.2).
        """
        return z_order.eichler_symbol(self.value, prime(p))

    def conductor(self) -> int:
        """Return the largest f with O = ℤ + f·G for an order G; 1 for a Gorenstein order."""
        return z_order.conductor(self.value)

    def ternary_theta_series(self, n: int) -> list[int]:
        """Return [r(0), …, r(n)], where r(m) elements of norm m are in the trace-0 part of ℤ + 2O.

        Raises :class:`IndefiniteError` and :class:`TooLargeError`. It is Gross's ternary lattice ("Heights
        and the special values of L-series", 1987).
        """
        expect_definite(self.value, "ternary_theta_series()")
        return short_elements.theta_series_of_form(self.value.reduced_ternary[2], n)

    def ternary_form(self) -> TernaryForm:
        """Return the form whose even Clifford algebra is the order, reduced where it is definite.

        Its discriminant is that of the order (Voight, *Quaternion Algebras*, chapter 22).

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order(); f = O.ternary_form()
        >>> f, f.discriminant(), f.genus()
        (x²+y²+3·z²+y·z, 11, (x²+y²+3·z²+y·z, x²+y²+4·z²+x·z+x·y))
        """
        value = self.value
        den, rows, _ = value.reduced_ternary if value.regular.definite else value.ternary
        i, j, k = (self.algebra(*x) / (2 * den) for x in rows.tolist())  # up to scalars
        found = ternary_forms.form_of((i, j, k), type(self.algebra))
        return found.reduced() if found.is_definite() else found

    def maximal_overorder(self) -> Order:
        """Return a maximal order that contains this one, always the same."""
        return Order(maximal_orders.overorder(self.value))

    def gorenstein_closure(self) -> Order:
        """Return the Gorenstein order G with O = ℤ + f·G, f the conductor (Voight, section 24.2)."""
        return Order(z_order.gorenstein_closure(self.value))

    def suborders(self, p: int, k: int = 1) -> list[Order]:
        """Return all orders of index pᵏ in this one. Raises :class:`TooLargeError` for many candidates.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
        >>> [len(O.suborders(2, k)) for k in (1, 2)], O.suborders(11)[0].eichler_symbol(11)
        ([3, 13], 0)
        """
        exponent = natural(k, "the exponent of an index is")
        return [Order(O) for O in maximal_orders.suborders(self.value, checked_prime(p), exponent)]

    # --- units -------------------------------------------------------------------------------------

    def units(self) -> tuple[Quaternion, ...]:
        """Return all units of an order in a definite algebra.

        Raises :class:`NotFiniteError` for an indefinite algebra, whose orders have infinitely many.
        """
        expect_definite(self.value, "units()")
        return self.elements_of_norm(1)

    def unit_count(self) -> int:
        """Return how many units there are; at most 24. Raises as :meth:`units` does."""
        expect_definite(self.value, "unit_count()")
        return 2 * sum(1 for _ in short_elements.up_to(self.value, 1))

    def unit_group(self) -> str:
        """Return the name of the group of units: ``C2 C4 C6 Q8 Dic3`` or ``SL(2,3)``.

        Of an indefinite algebra, ``"infinite"``: a finitely presented group that is not written down.
        """
        return UNIT_GROUPS[self.unit_count()] if self.value.regular.definite else "infinite"

    def norm_one_group(self) -> NormOneGroup:
        """Return the units of norm 1 modulo ±1 as a group of motions of the hyperbolic plane.

        Its Dirichlet domains, signature, presentation and words. Raises :class:`IndefiniteError`
        in a definite
        algebra.
        """
        return NormOneGroup(RationalOrder(self.value))

    # --- ideals ------------------------------------------------------------------------------------

    def left_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the left ideal ``O·gens``. Raises :class:`LatticeError` when its rank is below 4."""
        return Ideal.generated(self, generators, "left")

    def right_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the right ideal ``gens·O``. Raises :class:`LatticeError` when its rank is below 4."""
        return Ideal.generated(self, generators, "right")

    def two_sided_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the ideal ``O·gens·O``. Raises :class:`LatticeError` for a rank below 4."""
        return Ideal.generated(self, generators, "two-sided")

    def two_sided_prime(self, p: int) -> Ideal:
        """Return the two-sided ideal at a prime that generates, with the numbers, all those there.

        Its square is pᵉ·O, the part of the discriminant at p; it is p·O where p does not divide that.
        Raises :class:`LatticeError` where the order is neither maximal nor Eichler at p.
        """
        return Ideal(ideals_of_norm.two_sided_prime(self.value, prime(p)), "two-sided", self)

    def ideals_of_norm(self, n: int, side: str = "left") -> list[Ideal]:
        """Return all invertible integral ideals of norm n on a side: p + 1 where p is off the discriminant.

        Raises :class:`LatticeError`, and :class:`TooLargeError` for more than 10⁵.
        """
        norm, side = positive(n, "norm"), checked_side(side)
        found = [Ideal(J, "right", self) for J in ideals_of_norm.ideals_of_norm(self.value, norm)]
        return found if side == "right" else [J.conjugate() for J in found]

    def random_ideal(self, n: int, side: str = "left", seed: int | None = None) -> Ideal:
        """Return a random ideal of norm n, prime to the discriminant, which no integer divides.

        The same for the same seed. Raises :class:`LatticeError`.
        """
        norm, side = positive(n, "norm"), checked_side(side)
        lattice = ideals_of_norm.random_ideal(self.value, norm, random.Random(seed))
        found = Ideal(lattice, "left", self)
        return found if side == "left" else found.conjugate()

    def connecting_ideal(self, other: Order) -> Ideal:
        """Return the primitive integral ideal with this left order and the right order ``other``.

        Raises :class:`LatticeError` unless both are Eichler orders of one level.
        """
        found = isomorphic_orders.connecting_ideal(self.value, self._order_like(other))
        return Ideal(found, "left", self)

    def isomorphism(self, other: Order) -> Answer:
        """Return an answer with an ``element`` x, x·O·x⁻¹ being the other order, or the ``reason`` why none.

        Decided for all orders of definite algebras, and for ℤ + f·Eichler orders of indefinite ones, where
        the element may be missing. Raises :class:`UndecidedError`.
        """
        search = _from_the_plane(self.value)
        return isomorphic_orders.isomorphism(self.value, self._order_like(other), search)

    def _order_like(self, other: object) -> ZOrder:
        """Return an order of the same algebra, perhaps given as a lattice, ``x * O * x.inverse()``."""
        value = self._same(other, "compare").value
        return value if isinstance(value, ZOrder) else z_order.checked_ring(value)

    def is_isomorphic(self, other: Order) -> bool:
        """Tell whether two orders are isomorphic. Raises as :meth:`isomorphism` does."""
        return bool(self.isomorphism(other))

    # --- elements ----------------------------------------------------------------------------------

    def represent_integer(self, n: int, seed: int | None = None) -> Quaternion | None:
        """Return an element of norm n, or None where there is none; n may have hundreds of digits.

        Raises :class:`IndefiniteError`, and :class:`UndecidedError` for a large n in an order without small
        quadratic orders.
        """
        return quadratic_orders.represent_integer(self.value, positive(n, "norm"), seed)

    def embeddings(self, discriminant: int) -> Embeddings:
        """Return the optimal embeddings of the quadratic order of a negative discriminant.

        Raises :class:`LatticeError` for what is no such discriminant, :class:`IndefiniteError`.
        """
        d = integer(discriminant, "discriminant")
        return Embeddings(self, d, *quadratic_orders.embeddings(self.value, d))

    # --- classes -----------------------------------------------------------------------------------

    def class_set(self) -> ClassSet:
        """Return the right ideal classes, enumerated and checked by the mass, in a definite algebra.

        Raises :class:`IndefiniteError`; there the number of classes is 1 for an Eichler order.
        """
        return ClassSet(self)

    @cached_property
    def _stable(self) -> StableClasses:
        return class_number.over_z(self.value)

    def _units_modulo_scalars(self) -> int:
        return self.unit_count() // 2

    def mass(self) -> Fraction:
        """Return ``Σ 1/[O_L(I)^× : ±1]`` over the right ideal classes, by a formula."""
        expect_definite(self.value, "the mass of ideal classes")
        return class_number.mass(self.value)


class Ideal(Certified, Lattice):
    """A lattice with ``O·I = I`` for the order O (``side="left"``), or ``I·O = I``, or both.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> I = O.left_ideal([3, "1 + j"])
    >>> I.norm(), I.left_order() == O
    (3, True)
    >>> I * I.inverse() == O
    True
    """

    elsewhere = IDEAL

    def __init__(self, value: ZLattice, side: str = "left", order: Order | None = None) -> None:
        super().__init__(value)
        self.side = side
        self._order = order

    @classmethod
    def generated(cls, order: Order, generators: Iterable[object], side: str) -> Self:
        """Return the ideal of an order that elements generate on a side.

        Raises :class:`LatticeError` when its rank is below 4.
        """
        return cls(z_order.generated_ideal(order.value, listed(generators), side), side, order)

    @classmethod
    def of(cls, lattice: Lattice, side: str, order: Order | None = None) -> Self:
        """Return a lattice as an ideal of its left or right order, which may be known."""
        return cls(lattice.value, side, order)

    @classmethod
    def like(cls, lattice: Lattice, order: Order, side: str) -> Self:
        """Return a lattice as an ideal of an order. Raises :class:`LatticeError` where it is none."""
        pair = (lattice.value, order.value) if side == "right" else (order.value, lattice.value)
        if z_lattice.product(*pair) != lattice.value:
            raise LatticeError(f"{shorten(lattice)} is no {side} ideal of {shorten(order)}")
        return cls(lattice.value, side, order)

    # --- its orders ------------------------------------------------------------------------------

    @property
    def order(self) -> Order:
        """The order of which this is an ideal."""
        if self._order is None:
            self._order = self.colon_order(self.side)
        return self._order

    def colon_order(self, side: str) -> Order:
        """Return the left or the right order, as for any lattice."""
        return Order(z_order.order_of(self.value, "right" if side == "right" else "left"))

    def left_order(self) -> Order:
        """Return ``{x : x·I ⊆ I}``; for an invertible left ideal it is :attr:`order`."""
        known = self.side != "right" and self.is_invertible()
        return self.order if known else super().left_order()

    def right_order(self) -> Order:
        """Return ``{x : I·x ⊆ I}``; for an invertible right ideal it is :attr:`order`."""
        known = self.side != "left" and self.is_invertible()
        return self.order if known else super().right_order()

    def is_invertible(self) -> bool:
        """Tell whether the ideal is locally principal."""
        return z_order.is_locally_principal(self.value, self.order.value)

    def is_integral(self) -> bool:
        """Tell whether the ideal lies in its order."""
        return self <= self.order

    def is_two_sided(self) -> bool:
        """Tell whether the left and the right order are the same."""
        return self.side == "two-sided" or self.left_order() == self.right_order()

    # --- arithmetic ------------------------------------------------------------------------------

    def conjugate(self) -> Ideal:
        """Return the ideal of the conjugates, on the other side."""
        return Ideal.of(super().conjugate(), OTHER[self.side], self._order)

    def inverse(self) -> Ideal:
        """Return ``conj(I)/N(I)``. Raises :class:`LatticeError` unless I is locally principal."""
        return Ideal.of(super().inverse(), OTHER[self.side], self._order)

    def __truediv__(self, n: object) -> Ideal:
        """Return the ideal divided by a rational number."""
        return Ideal.of(super().__truediv__(n), self.side, self._order)

    def __mul__(self, other: object) -> Lattice:
        """Return the product with a lattice, or the multiple by an element or a number."""
        if self.side != "right" or _is_number(other):
            side = "right" if self.side == "right" else "left"
            return Ideal.of(super().__mul__(other), side, self._order)
        if isinstance(other, Ideal) and other.side == "left" and self.order == other.order:
            pair = self.value, other.value
            return Ideal(compatible_products.product(*pair, self.order.value), "right")
        known = other._order if isinstance(other, Ideal) and other.side == "right" else None
        return Ideal.of(super().__mul__(other), "right", known)

    def __rmul__(self, other: object) -> Lattice:
        found = super().__rmul__(other)
        known = self._order if self.side == "right" or _is_number(other) else None
        return Ideal.of(found, "right" if self.side == "right" else "left", known)

    def primitive_part(self) -> tuple[Ideal, int]:
        """Return (J, m) with I = m·J and m the largest integer for which J is integral.

        Raises :class:`LatticeError` unless the ideal is integral.
        """
        m = z_lattice.divisor(self.order.value, self.value)
        if m.denominator != 1:
            raise LatticeError("only an integral ideal has a primitive part, and this one is none")
        return self / m, m.numerator

    def pushforward(self, other: Ideal) -> Ideal:
        """Return ``I⁻¹·(I ∩ J)`` for J = other: a left ideal of the right order of I, of norm N(J).

        Both are left ideals of one order, of coprime norms, else :class:`LatticeError` (Leroux, 2022).
        """
        self._joint(other)
        self._coprime(other)
        return Ideal(
            z_lattice.product(self.inverse().value, (self & other).value),
            "left",
            self.right_order(),
        )

    def pullback(self, other: Ideal) -> Ideal:
        """Return ``I·J + N(J)·O``, for J a left ideal of the right order of I: what I pushes forward to J."""
        if self.side == "right" or other.side == "right" or other.order != self.right_order():
            raise LatticeError(
                "the pullback along a left ideal I is asked of a left ideal of the right order of I"
            )
        self._coprime(other)
        order = self.order
        rest = z_lattice.scaled(order.value, other.value.norm)
        found = z_lattice.add(z_lattice.product(self.value, other.value), rest)
        return Ideal(found, "left", order)

    def _coprime(self, other: Ideal) -> None:
        n, m = self.value.norm, other.value.norm
        if n.denominator != 1 or m.denominator != 1 or math.gcd(n.numerator, m.numerator) != 1:
            raise LatticeError(f"the norms {n} and {m} are not coprime integers")

    def _joint(self, other: object) -> Ideal:
        """Return ``other`` if it is an ideal on the same side of the same order."""
        if isinstance(other, Lattice) and not isinstance(other, Ideal):
            other = Ideal.like(self._same(other, "compare"), self.order, self.side)
        if not isinstance(other, Ideal):
            raise LatticeError(f"{shorten(repr(other))} is not an ideal")
        self._same(other, "compare")
        if "left" in (self.side, other.side) and "right" in (self.side, other.side):
            raise LatticeError(
                "one is a left ideal and the other a right ideal; conjugate one first"
            )
        if other.order != self.order:
            raise LatticeError(
                "these are ideals of different orders: two ideals are compared over one order"
            )
        return other

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        return certificates.of_ideal(self.value, self.side, self.order.value)

    @property
    def evidence(self) -> dict[str, object]:
        """What a program needs to check the ideal: its rows, those of its order, and its norm."""
        return {
            "kind": "ideal",
            "algebra": str(self.algebra),
            "side": self.side,
            **rows_json(self.value),
            "order": rows_json(self.order.value),
            "norm": str(self.value.norm),
        }

    # --- classes ---------------------------------------------------------------------------------

    def equivalence(self, other: Ideal) -> Answer:
        """Return an answer with ``element`` c such that J = I·c for left ideals, J = c·I for right ones.

        Where there is none it is false, and ``reason`` says what was exhausted. In an indefinite
        algebra a theorem may decide, and the element be missing. Raises :class:`LatticeError` for an
        ideal of another order, and :class:`UndecidedError`.
        """
        second = self._joint(other).value
        order = self.order.value
        return equivalence.equivalence(self.value, second, order, self.side, _from_the_plane(order))

    def is_equivalent(self, other: Ideal) -> bool:
        """Tell whether ``J = I·c`` (or ``c·I``) for some c. Raises as :meth:`equivalence` does."""
        return bool(self.equivalence(other))

    def is_principal(self) -> Answer:
        """Return an answer with a generator as ``element``: I = O·c for a left ideal, c·O for a right one."""
        order = self.order.value
        return equivalence.equivalence(order, self.value, order, self.side, _from_the_plane(order))

    def equivalent_of_prime_norm(self, avoid: Iterable[int] = ()) -> tuple[Ideal, Quaternion]:
        """Return (J, c) with J equivalent to I of the least prime norm that is not in ``avoid``.

        J = I·c for a left ideal, c·I for a right one, with c = conj(x)/N(I) for a short x in I
        (Kohel, Lauter, Petit and Tignol, 2014).
        """
        c = klpt.to_prime_norm(self.value, frozenset(avoid))
        found = z_lattice.multiple(self.value, c, "left" if self.side == "right" else "right")
        return Ideal(found, self.side, self.order), c

    def equivalent_of_power_norm(self, prime: int, seed: int = 0) -> tuple[Ideal, Quaternion, int]:
        """Return (J, c, e), J = I·c of norm primeᵉ, for a left ideal of a p-extremal order: KLPT.

        Raises :class:`LatticeError` for another order, and :class:`UndecidedError`.
        """
        p = checked_prime(prime)
        c, e = klpt.to_power_norm(self.value, self.order.value, self.side, p, seed)
        return Ideal.of(self * c, "left", self.order), c, e


def _from_the_plane(order: ZOrder) -> equivalence.Search:
    """Return a search for elements of an indefinite algebra that are short from points of its plane."""

    def search(lattice: ZLattice, size: Fraction) -> Quaternion | None:
        from hfield.fuchsian.search import element_of_norm

        split, rows = RationalOrder(order), hermite.tuples(lattice.reduced[0])
        basis = [lattice.element(row) for row in rows]
        return element_of_norm(split, basis, split.scalar(size)) or element_of_norm(
            split, basis, split.scalar(-size)
        )

    return search


class ClassSet(Classes, ByStableClasses, WithForms, Hinted):
    """The right ideal classes of an order: ``len(C)``, iteration over representatives, ``C[n]``.

    >>> from hfield import QuaternionAlgebra
    >>> C = QuaternionAlgebra("QQ", -1, -11).maximal_order().class_set()
    >>> len(C), C.mass, C.type_number
    (2, Fraction(5, 6), 2)
    >>> C.brandt_matrix(2)
    [[1, 2], [3, 0]]
    """

    elsewhere = CLASSES
    order: Order

    def __init__(self, order: Order) -> None:
        super().__init__(order.value)
        self.order = order

    def __getitem__(self, n: int) -> Ideal:
        """Return the representative of class n, a primitive integral right ideal; class 0 is that of O."""
        if not -len(self) <= n < len(self):
            raise IndexError(f"there are {len(self)} classes, numbered from 0: {n} is none of them")
        return Ideal(self._representative(n), "right", self.order)

    def __iter__(self) -> Iterator[Ideal]:
        return (self[n] for n in range(len(self)))

    def left_ideals(self) -> Iterator[Ideal]:
        """Yield representatives of the left ideal classes, the conjugates of the right ones."""
        return (I.conjugate() for I in self)

    def index(self, ideal: object) -> int:
        """Return the number of the class of a right ideal. Raises :class:`LatticeError` for others."""
        found = ideal
        if isinstance(ideal, Lattice) and not isinstance(ideal, Ideal):
            found = Ideal.like(ideal, self.order, "right")
        if not isinstance(found, Ideal) or found.side == "left" or found.order != self.order:
            raise LatticeError(
                f"{shorten(repr(ideal))} is not a right ideal of {shorten(self.order)}"
            )
        if not found.is_invertible():
            raise LatticeError(f"{shorten(found)} is not invertible, and belongs to no class")
        return self._index(found.value)

    def left_orders(self) -> list[Order]:
        """Return the left orders of the representatives, one a class."""
        return [I.left_order() for I in self]

    def _stable_class(self, n: int) -> int:
        stable, local = self.order._stable, class_number.local_multiple
        return stable.reduced(local(self._lattices[n], place.prime) for place in stable.places)

    @cached_property
    def _forms(self) -> RationalModule:
        """The functions on the classes as a module of Hecke operators."""
        return RationalModule(self)

    def _repr_latex_(self) -> str:
        mass = rf"\frac{{{self.mass.numerator}}}{{{self.mass.denominator}}}"
        return rf"$h = {len(self)},\quad \text{{mass}} = {mass},\quad {self.order.latex()}$"

    def __repr__(self) -> str:
        return f"{len(self)} right ideal classes, mass {self.mass}, of {self.order}"


def _is_number(x: object) -> bool:
    return not isinstance(x, (Lattice, Quaternion, tuple, list, str))
