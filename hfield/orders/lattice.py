"""Lattices, orders, ideals and class sets: the public classes.

They are in one module because their methods return one another: a lattice returns its orders, an order its
ideals and its class set, an ideal its orders. Algorithms are functions on values, in other modules.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Self, TypeVar, overload

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.factorisation import Factors
from hfield.core.product import IntegerMultiple
from hfield.core.properties import cached_property
from hfield.core.sparse_rows import SparseRows
from hfield.errors import (
    IndefiniteError,
    LatticeError,
    MixedParentsError,
    NotFiniteError,
    shorten,
)
from hfield.evidence import Certified, CertifiedClaim
from hfield.fields.rationals.whole_numbers import fraction
from hfield.fuchsian.group import NormOneGroup
from hfield.fuchsian.search import split_order
from hfield.hints import CLASSES, IDEAL, LATTICE, ORDER, Hinted
from hfield.orders import (
    brandt,
    certificates,
    element_factors,
    equivalence,
    foreign_writing,
    generated_orders,
    ideal_generators,
    ideals_of_norm,
    invariants,
    isomorphism,
    klpt,
    labels,
    lattice_values,
    mass_formula,
    maximal_orders,
    norm_pairs,
    pseudo_bases,
    quadratic_orders,
    related_orders,
    short_elements,
    ternary_forms,
    units,
)
from hfield.orders import strong_approximation as solvers
from hfield.orders.base import number_field_integers
from hfield.orders.base_values import BaseIdeal, BaseNumber, Prime, ShownIdeal, ThetaSeries
from hfield.orders.basis import basis_of
from hfield.orders.class_file import ClassFile
from hfield.orders.classes import Classes, EichlerClasses
from hfield.orders.eigensystems import Module, WithForms
from hfield.orders.hecke_modules import ClassFunctions
from hfield.orders.kernels import ideal_products
from hfield.orders.lattice_values import LatticeValue, rows_json
from hfield.orders.newform_certificates import of_newforms
from hfield.orders.orders_at_primes import OrderAtPrime
from hfield.orders.orders_modulo_integers import ResidueMatrices
from hfield.orders.quadratic_orders import Embeddings
from hfield.orders.short_elements import expect_definite
from hfield.orders.stable_classes import (
    ByStableClasses,
    StableClasses,
    WithStableClasses,
    stable_classes,
)
from hfield.orders.ternary_forms import TernaryForm
from hfield.orders.validation import checked_side, expect_rational, listed, natural, positive
from hfield.orders.validation import prime as checked_prime
from hfield.orders.validation import weight as checked_weight
from hfield.orders.weighted_functions import WeightedFunctions
from hfield.sympy_printing import PrintedBySympy
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.orders.indefinite_classes import IndefiniteClassSet
    from hfield.orders.pseudo_bases import PseudoBasis
    from hfield.orders.rational_newforms import RationalNewform

ValueT = TypeVar("ValueT", bound=IntegerMultiple)
OTHER = {"left": "right", "right": "left", "two-sided": "two-sided"}


class Lattice(Hinted, PrintedBySympy):
    """A module of rank 4 over ℤ, the integers ℤ_K of a number field, or 𝔽_q[t].

    It is stored in Hermite normal form over ℤ, or 𝔽_q[t]. So lattices that are equal as sets compare and hash
    as equal, whatever elements they were constructed from. ``x in L`` tests membership, ``M <= L``
    containment.

    >>> from hfield import H, QuaternionAlgebra
    >>> A = H("QQ")
    >>> L = A.lattice([1, "i", "j", "1/2 + 1/2*i + 1/2*j + 1/2*k"])
    >>> L.hnf
    (2, ((1, 1, 1, 1), (0, 2, 0, 0), (0, 0, 2, 0), (0, 0, 0, 2)))
    >>> L.theta_series(4)
    [1, 24, 24, 96, 24]
    >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(); i = O.algebra(0, 1, 0, 0)
    >>> I = O.right_ideal([2, 1 + i]); J = O.left_ideal([3])
    >>> I.norm(), I.right_order() == O, I * I.inverse() == I.left_order()
    (ideal(2), True, True)
    >>> I + J == O, O.index(I & J), 1 + i in I, I.conjugate().left_order() == O
    (True, ideal(324), True, True)
    """

    foreign_names = LATTICE
    multiplied_by_elements = True  # so that ``q * L`` calls the method of L
    value: LatticeValue

    def __init__(self, value: LatticeValue) -> None:
        self.value = value
        self.algebra = value.ambient.algebra

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self._arguments

    @property
    def _arguments(self) -> tuple[object, ...]:
        """The constructor arguments, without cached results."""
        return (self.value,)

    @classmethod
    def spanned(cls, algebra: Parent, elements: Iterable[object]) -> Lattice:
        """Return the lattice spanned by elements, or pairs (ideal, element), over the integers of the field.

        Raises :class:`LatticeError` if its rank is below 4, or for an algebra over another ring.
        """
        return Lattice(lattice_values.spanned(algebra, elements))

    # --- what it is ------------------------------------------------------------------------------

    @property
    def hnf(self) -> tuple[int | RationalFunction, tuple[tuple[int | RationalFunction, ...], ...]]:
        """The least denominator, and the rows of the Hermite normal form as integers.

        Over ℚ they are coordinates over 1, i, j, k; over K they are coordinates in the integral basis times
        1, I, J, IJ. I and J anticommute and have integral squares; they equal i and j if t = 0 and a and b
        are integral. Over GF(q)(t) they are polynomials, with I = r·i and J = s·j for the least r and s that
        make traces and norms integral.
        """
        shown = self.value.ambient.base.shown_number
        den, rows = self.value.hnf
        return shown(den), tuple(tuple(map(shown, row)) for row in rows)

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:
        """The rows of the normal form as elements: a ℤ-basis, the same for equal lattices."""
        return self.value.basis

    def pseudo_basis(self) -> PseudoBasis:
        """Return four pairs (ℤ-basis of an ideal, quaternion); L is the direct sum of their products.

        >>> from hfield import H
        >>> [q for _, q in H("QQ").lipschitz_order().pseudo_basis()]
        [1, i, j, k]
        """
        return pseudo_bases.pseudo_basis(self.value)

    def __contains__(self, x: object) -> bool:
        return lattice_values.contains(self.value, x)

    def coordinates(self, x: object) -> tuple[BaseNumber, ...]:
        """Return the rational coordinates of an element with respect to :attr:`basis`."""
        return lattice_values.coordinates(self.value, x)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Lattice) and self.value == other.value

    def __hash__(self) -> int:
        return hash(self.value)

    def __le__(self, other: Lattice) -> bool:
        """Return whether every element of this lattice lies in the other."""
        return lattice_values.includes(self._same(other, "compare").value, self.value)

    def __ge__(self, other: Lattice) -> bool:
        return lattice_values.includes(self.value, self._same(other, "compare").value)

    def __repr__(self) -> str:
        symbol = self.value.ambient.domain.symbol
        return f"{symbol}⟨{', '.join(map(str, self.basis))}⟩ in {self.algebra}"

    def latex(self) -> str:
        """Return the lattice in LaTeX, by a basis of four elements or as a sum of ideals times elements."""
        if len(self.basis) == 4:
            basis = ", ".join(q.text("latex") for q in self.basis)
            symbol = self.value.ambient.domain.latex
            return rf"{symbol}\left\langle {basis} \right\rangle \subset {self.algebra.latex()}"
        K = number_field_integers(self.value.ambient.base).ring
        pairs = []
        for ideal, q in self.pseudo_basis():
            numbers = (K.text(x, "latex") for x in K.ideal(list(ideal)).generators)
            pairs.append(rf"\left({', '.join(numbers)}\right)\left({q.text('latex')}\right)")
        return rf"{' + '.join(pairs)} \subset {self.algebra.latex()}"

    def text_for(self, system: str) -> str:
        """Write the lattice as code for ``"sage"``, ``"magma"`` or ``"pari"``; ``A.read(text)`` reads it.

        For Sage the result is an order, an ideal of an order, or otherwise a fractional ideal; over number
        fields only orders that are free modules are written. For Magma it is an order, an ideal, or otherwise
        the list of a basis; for PARI it is always that list. Raises :class:`RingError` if the other system
        has no such object, and as :meth:`QuaternionAlgebra.text_for` does.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra(11).maximal_order(); O.text_for("pari")
        '[[1/2, 1/2]~, [(1/2)*x, (-1/2)*x]~, [0, 1]~, [0, (-1)*x]~]'
        >>> O.algebra.read(O.text_for("sage")) == O, O.left_ideal([2]).text_for("magma")[:21]
        (True, 'lideal<QuaternionOrde')
        """
        return foreign_writing.lattice_text(self.value, system)

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
        """Return the sum, the smallest lattice that contains both."""
        second = self._same(other, "add")
        return self._result_with(second, lattice_values.add(self.value, second.value))

    def __and__(self, other: object) -> Lattice:
        """Return the intersection."""
        second = self._same(other, "intersect")
        return self._result_with(second, lattice_values.meet(self.value, second.value))

    def _result_with(self, other: Lattice, value: LatticeValue) -> Lattice:
        """Return the sum or the intersection with another lattice, from its computed value."""
        return Lattice(value)

    def __mul__(self, other: object) -> Lattice:
        """Return the product with a lattice, an element, a number or an ideal of the field."""
        return Lattice(self._times(other, "right"))

    def __rmul__(self, other: object) -> Lattice:
        return Lattice(self._times(other, "left"))

    def _times(self, other: object, side: str) -> LatticeValue:
        if isinstance(other, Lattice):
            return lattice_values.product(self.value, self._same(other, "multiply").value)
        if self.value.ambient.base.is_ideal(other):
            return lattice_values.times_ideal(self.value, other)
        return lattice_values.multiple(self.value, other, side)

    def __truediv__(self, n: object) -> Lattice:
        """Return the lattice divided by a number or an ideal of the field."""
        return Lattice(self._divided(n))

    def _divided(self, n: object) -> LatticeValue:
        base = self.value.ambient.base
        return lattice_values.times_ideal(self.value, base.inverse(base.ideal(n)))

    def conjugate(self) -> Lattice:
        """Return the lattice of the conjugates."""
        return Lattice(lattice_values.conjugate(self.value))

    def dual(self) -> Lattice:
        """Return all x with tr(x·L) integral; for an order this is the codifferent (Voight, 15.6.2)."""
        return Lattice(lattice_values.dual(self.value))

    def colon(self, other: object, side: str = "left") -> Lattice:
        """Return ``{x : x·M ⊆ L}`` for M = other, or ``{x : M·x ⊆ L}`` for ``side="right"``."""
        factor = self._same(other, "divide")
        return Lattice(lattice_values.colon(self.value, factor.value, checked_side(side)))

    def index(self, other: object) -> ShownIdeal:
        """Return the index of the other lattice in this one; over ℤ an int if it is contained in this one.

        Otherwise it is the ratio of the volumes, a Fraction (Voight, section 9.6). Over ℤ_K it is an ideal.
        """
        ratio = lattice_values.index(self.value, self._same(other, "compare").value)
        return self.value.ambient.base.shown_index(ratio)

    def volume(self) -> ShownIdeal:
        """Return the index of L in ⟨1, i, j, k⟩, or ⟨1, I, J, IJ⟩ over ℤ_K, as :meth:`index` does.

        >>> from hfield import H
        >>> H("QQ").lipschitz_order().volume(), H("QQ").hurwitz_order().volume()
        (1, Fraction(1, 2))
        """
        return self.value.ambient.base.shown_index(self.value.volume)

    def left_order(self) -> Order:
        """Return ``{x : x·L ⊆ L}``, an order; this also works in matrix algebras."""
        return self._order_on("left")

    def right_order(self) -> Order:
        """Return ``{x : L·x ⊆ L}``, an order."""
        return self._order_on("right")

    def _order_on(self, side: str) -> Order:
        return Order(lattice_values.order_of(self.value, side))

    def is_invertible(self) -> bool:
        """Return whether ``L·L⁻¹`` is the left order, which holds if and only if L is locally principal
        (Voight, 16.7.7).
        """
        return lattice_values.is_locally_principal(self.value, self.left_order().value)

    def inverse(self) -> Lattice:
        """Return ``{x : L·x·L ⊆ L}``, the inverse. Raises :class:`LatticeError` if L is not invertible."""
        if not self.is_invertible():
            raise LatticeError(f"{shorten(self)} is not invertible: it is not locally principal")
        return Lattice(lattice_values.inverse(self.value))

    def is_integral(self) -> bool:
        """Return whether products of elements of the lattice lie in it."""
        return lattice_values.includes(self.value, lattice_values.product(self.value, self.value))

    # --- the norm --------------------------------------------------------------------------------

    def norm(self) -> ShownIdeal:
        """Return the reduced norm of the lattice: over ℤ the gcd of the norms of its elements, in QQ.

        Over ℤ_K it is the ideal generated by the norms.
        """
        return self.value.ambient.base.shown_norm(self.value)

    def gram_matrix(self) -> tuple[tuple[BaseNumber, ...], ...]:
        """Return ``tr(x·conj(y))`` for x, y in :attr:`basis`; the diagonal has twice the norms."""
        base, grams = self.value.ambient.base, self.value.grams
        below = self.value.ambient.scale * self.value.den**2
        size, fraction_of = range(len(self.basis)), self.value.ambient.domain.fraction

        def entry(m: int, n: int) -> BaseNumber:
            return base.outside(base.element_of([fraction_of(g[m, n], below) for g in grams]))

        return tuple(tuple(entry(m, n) for n in size) for m in size)

    def reduced_basis(self) -> tuple[Quaternion, ...]:
        """Return an LLL-reduced basis over ℤ for Tr(N(x)); in a definite algebra the shortest element comes
        first.

        In an indefinite algebra over ℚ the norm is replaced by ``|w² …|``, the sum of the absolute values of
        its terms; over other fields :class:`IndefiniteError` is raised.
        """
        rows, gram = self.value.reduced
        found = self.value.elements(rows)
        if not self.value.ambient.definite:
            return found
        length = self.value.ambient.domain.length
        return tuple(found[n] for n in sorted(range(len(found)), key=lambda n: length(gram[n][n])))

    def shortest(self) -> tuple[Quaternion, ...]:
        """Return the nonzero elements x of least Tr(N(x)) (over ℤ, of least norm) in a definite algebra.

        Both x and −x are listed. Raises :class:`IndefiniteError`.
        """
        expect_definite(self.value.ambient, "shortest()")
        return short_elements.shortest(self.value)

    def elements_of_norm(self, n: object) -> tuple[Quaternion, ...]:
        """Return all elements whose norm is n, a number of the field, in a definite algebra.

        Raises :class:`IndefiniteError`, and :class:`TooLargeError` if there are more than a million.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> len(O.elements_of_norm(1)), len(O.units()), len(O.shortest()), O.shortest()[0].norm()
        (120, 60, 120, 1)
        """
        expect_definite(self.value.ambient, "elements_of_norm()")
        return short_elements.of_norm(self.value, self.value.ambient.base.inside(n))

    def elements_of_norm_at_most(self, n: object) -> tuple[Quaternion, ...]:
        """Return all elements with Tr(N(x)) at most n (over ℤ, of norm at most n), including 0, ascending.

        Over 𝔽_q[t], n is a bound for the degree of the norm. Raises as :meth:`elements_of_norm` does.
        """
        expect_definite(self.value.ambient, "elements_of_norm_at_most()")
        return short_elements.of_norm_at_most(self.value, n)

    def theta_series(self, n: int) -> ThetaSeries:
        """Return [r(0), …, r(n)], where r(m) is the number of elements of norm ``m·norm()``, in a definite
        algebra.

        Over ℤ_K return {ν: r(ν)} for the norms ν of trace at most n, ordered by trace; over 𝔽_q[t] for the
        norms of degree at most n. Raises :class:`IndefiniteError`, and :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().theta_series(3)
        {0: 1, 1: 120, 3/2+1/2*sqrt(5): 120, 3/2-1/2*sqrt(5): 120}
        """
        expect_definite(self.value.ambient, "theta_series()")
        return short_elements.theta_series(self.value, n)


class ExplainedBool(Verdict[None]):
    """A verdict that prints as True or False and compares by value."""

    def _key(self) -> tuple[object, ...]:
        return (self.value,)

    def __repr__(self) -> str:
        return str(self.value)


class Order(WithStableClasses, Certified, Lattice):
    """A lattice over ℤ, or over the integers ℤ_K of a number field, that is a ring with 1.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> O.discriminant(), O.is_maximal(), O.is_definite(), O.unit_count()
    (11, True, True, 4)
    >>> A = QuaternionAlgebra("QQ[s]/(s^3-2)", -1, -1); O = A.maximal_order()
    >>> O.discriminant(), len(O.basis), O.is_maximal()
    (ideal(2, s), 12, True)
    >>> M = A.order(["i", "j"])
    >>> M.is_maximal().reason
    'its discriminant ideal(4) is that of the algebra, ideal(2, s), times ideal(4, 2*s^2)'
    >>> M.maximal_overorder() >= M, M.local_index(A.ring.primes_above(2)[0])
    (True, 5)
    """

    foreign_names = ORDER

    @classmethod
    def generated(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the ring generated by elements over the integers of the field.

        Raises :class:`LatticeError` if its rank is below 4, or if it is not a lattice because it contains
        elements that are not integral.
        """
        return cls(generated_orders.generated(algebra, elements))

    @classmethod
    def from_basis(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the order with a basis of four elements; over ℤ_K, the order spanned by elements or a
        pseudo-basis.

        Raises :class:`LatticeError` unless they span a ring with 1; the message names a product that is not
        in the span.
        """
        basis = listed(elements)
        if basis_of(algebra).degree == 1 and len(basis) != 4:
            raise LatticeError(
                f"a basis of an order has four elements, and {len(basis)} were given"
            )
        return cls.from_lattice(Lattice.spanned(algebra, basis))

    @classmethod
    def from_lattice(cls, lattice: Lattice) -> Order:
        """Return a lattice as an order. Raises :class:`LatticeError` unless it is a ring with 1."""
        return cls(generated_orders.checked_ring(lattice.value))

    @overload
    def __and__(self, other: Order) -> Order: ...
    @overload
    def __and__(self, other: object) -> Lattice: ...
    def __and__(self, other: object) -> Lattice:
        """Return the intersection with a lattice; the intersection with another order is an order."""
        found = super().__and__(other)
        return Order(found.value) if isinstance(other, Order) else found

    @cached_property
    def claim(self) -> CertifiedClaim:
        """The claim that this is an order with its discriminant, with evidence."""
        return certificates.of_order(self.value)

    @property
    def evidence(self) -> dict[str, object]:
        """The evidence for the order: its rows, closed under products, and its discriminant.

        The rows are those of :attr:`hnf`; over ℤ_K discriminants are written as texts of ideals.
        """
        ambient = self.value.ambient
        return {
            "kind": "order",
            "algebra": str(self.algebra),
            **rows_json(self.value),
            "discriminant": ambient.base.ideal_text(lattice_values.discriminant(self.value)),
            "discriminant_of_algebra": ambient.base.ideal_text(ambient.discriminant),
        }

    def __repr__(self) -> str:
        if self.value.ambient.base.is_rational:
            return super().__repr__()
        kind = "a maximal order" if self.is_maximal() else "an order"
        return f"{kind} of {self.algebra} with the discriminant {self.discriminant()}"

    def text_for(self, system: str) -> str:
        """Write the order as code for another system, as :meth:`Lattice.text_for` says."""
        return foreign_writing.order_text(self.value, system)

    # --- what it is as a ring --------------------------------------------------------------------

    def discriminant(self) -> ShownIdeal:
        """Return the reduced discriminant, an int over ℤ and an ideal over ℤ_K."""
        return self._discriminant

    @cached_property
    def _discriminant(self) -> ShownIdeal:
        return self.value.ambient.base.shown_index(lattice_values.discriminant(self.value))

    def norm_of_discriminant(self) -> int:
        """Return the absolute norm of the reduced discriminant; over ℤ it is the discriminant."""
        return self.value.ambient.base.absolute_norm(lattice_values.discriminant(self.value))

    @property
    def level(self) -> ShownIdeal:
        """The index in a maximal order: the reduced discriminant divided by that of the algebra."""
        return self.value.ambient.base.shown_index(invariants.level(self.value))

    def local_index(self, prime: object) -> int:
        """Return v_P[M : O] for a maximal order M that contains O."""
        base = self.value.ambient.base
        return base.valuation(invariants.level(self.value), base.prime(prime))

    def is_definite(self) -> bool:
        """Return whether the algebra is totally definite, so that there are finitely many units modulo
        scalars.
        """
        return bool(self.value.ambient.definite)

    def is_maximal(self) -> ExplainedBool:
        """Return whether no larger order contains this one, with a ``reason`` from its discriminant."""
        level = self.level
        whole = f"its discriminant {self.discriminant()} is that of the algebra"
        if level == 1:
            return ExplainedBool(True, whole)
        return ExplainedBool(False, f"{whole}, {self.value.ambient.discriminant}, times {level}")

    def is_eichler(self) -> bool:
        """Return whether this is an intersection of two maximal orders (Voight, section 24.3)."""
        return invariants.is_eichler(self.value)

    def eichler_symbol(self, prime: object) -> int | None:
        """Return the Eichler symbol (O | P): 1, 0 or −1; None if the order is M₂(ℤ_P) at P.

        The values mean that the residue algebra is split, ramified or inert (Voight, definition 24.3.2).
        """
        return invariants.eichler_symbol(self.value, self.value.ambient.base.prime(prime))

    def conductor(self) -> ShownIdeal:
        """Return the largest f with O = R + f·G for an order G, where R is ℤ or ℤ_K; 1 for
        Gorenstein orders.
        """
        return self.value.ambient.base.shown_index(invariants.conductor(self.value))

    def is_gorenstein(self) -> bool:
        """Return whether the codifferent is invertible, or equivalently the conductor is 1 (Voight, section
        24.2).
        """
        return bool(self.conductor() == 1)

    def is_bass(self) -> bool:
        """Return whether every order that contains this one is Gorenstein (Voight, section 24.5)."""
        return invariants.is_bass(self.value, lambda O, P: OrderAtPrime(O, P).larger)

    def is_hereditary(self) -> bool:
        """Return whether all ideals are invertible, or equivalently the discriminant is squarefree."""
        factors = self.value.ambient.base.factorisation(lattice_values.discriminant(self.value))
        return all(e == 1 for _, e in factors)

    def ternary_theta_series(self, n: int) -> ThetaSeries:
        """Return [r(0), …, r(n)], where r(m) counts the elements of norm m in the trace-0 part of ℤ + 2O.

        Over ℤ_K return {ν: r(ν)} as :meth:`theta_series` does. Raises :class:`IndefiniteError` and
        :class:`TooLargeError`. The lattice is Gross's ternary lattice ("Heights and the special values of
        L-series", 1987).

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().ternary_theta_series(6)
        {0: 1, 5/2+1/2*sqrt(5): 12, 5/2-1/2*sqrt(5): 12, 3: 20}
        """
        expect_definite(self.value.ambient, "ternary_theta_series()")
        return short_elements.ternary_theta_series(self.value, n)

    def ternary_form(self) -> TernaryForm:
        """Return a form whose even Clifford algebra is this order; its discriminant is that of the order up
        to units.

        Over ℤ a definite form is reduced (Voight, *Quaternion Algebras*, chapter 22). Raises
        :class:`LatticeError` for an order that is not a free module; see :meth:`pseudo_basis`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order(); f = O.ternary_form()
        >>> f, f.discriminant(), f.genus()
        (x²+y²+3·z²+y·z, 11, (x²+y²+3·z²+y·z, x²+y²+4·z²+x·z+x·y))
        >>> f = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().ternary_form()
        >>> f.order().is_maximal().holds, f.ring.norm(f.discriminant())
        (True, 1)
        """
        return ternary_forms.form_of_order(self.value)

    def label(self) -> str:
        """Return a text that is equal for two orders over ℤ if and only if they are isomorphic.

        For a definite order it is the reduced positive ternary form; for an indefinite Eichler order of level
        N in an algebra of discriminant D it is ``D.N``. ``A.order_from_label(text)`` is the inverse. Raises
        :class:`UndecidedError` for other orders, which have no label yet.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(11).maximal_order().label(), QuaternionAlgebra(6).eichler_order(5).label()
        ('x²+y²+3·z²+y·z', '6.5')
        """
        return labels.label(self.value)

    # --- other orders ----------------------------------------------------------------------------

    def maximal_overorder(self) -> Order:
        """Return a maximal order that contains this one; always the same one.

        Raises :class:`UnfactoredError`.
        """
        return Order(maximal_orders.overorder(self.value))

    def gorenstein_closure(self) -> Order:
        """Return the Gorenstein order G with O = R + f·G, f the conductor (Voight, section 24.2)."""
        return Order(related_orders.gorenstein_closure(self.value))

    def suborders(self, prime: object, k: int = 1) -> list[Order]:
        """Return all orders of index Pᵏ in this one. Raises :class:`TooLargeError` for too many candidates.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
        >>> [len(O.suborders(2, k)) for k in (1, 2)], O.suborders(11)[0].eichler_symbol(11)
        ([3, 13], 0)
        >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); O = A.maximal_order(); P = A.ring.primes_above(2)[0]
        >>> [len(O.suborders(P, k)) for k in (1, 2)], len(O.suborders(P)[0].overorders(P))
        ([5, 41], 2)
        """
        return self._related(related_orders.suborders, prime, k)

    def overorders(self, prime: object, k: int = 1) -> list[Order]:
        """Return all orders in which this one has the index Pᵏ. Raises :class:`TooLargeError`."""
        return self._related(related_orders.overorders, prime, k)

    def _related(
        self,
        search: Callable[[LatticeValue, Prime, int], list[LatticeValue]],
        prime: object,
        k: int,
    ) -> list[Order]:
        P = self.value.ambient.base.prime(prime)
        found = search(self.value, P, natural(k, "the exponent of an index is"))
        return [Order(value) for value in found]

    def isomorphism(self, other: Lattice) -> Verdict[Quaternion]:
        """Return an answer with an ``element`` x such that x·O·x⁻¹ is the other order, or with a ``reason``.

        This is decided for all orders of totally definite algebras, and for orders R + f·(Eichler order) of
        indefinite ones, in which case the element may be missing. Other orders raise :class:`UndecidedError`.
        In an indefinite algebra, :class:`IndefiniteError` is raised if some ideal of the field has no
        generator that is positive at the ramified real places.
        """
        return isomorphism.isomorphism(self.value, self._order_like(other).value)

    def is_isomorphic(self, other: Lattice) -> bool:
        """Return whether two orders are isomorphic. Raises as :meth:`isomorphism` does."""
        return bool(self.isomorphism(other))

    def _order_like(self, other: object) -> Order:
        """Return an order of the same algebra; it may be given as a lattice, ``x * O * x.inverse()``."""
        found = self._same(other, "compare")
        return found if isinstance(found, Order) else Order.from_lattice(found)

    # --- units -------------------------------------------------------------------------------------

    def units(self) -> tuple[Quaternion, ...]:
        """Return all units over ℤ; over ℤ_K and 𝔽_q[t], one from each coset of the units of the base.

        :meth:`units_modulo_scalars` returns one from each coset over every base. Raises
        :class:`IndefiniteError` if there are infinitely many, as in an indefinite algebra.
        """
        return units.units(self.value)

    def units_modulo_scalars(self) -> tuple[Quaternion, ...]:
        """Return one unit from each coset of ℤˣ or ℤ_Kˣ. Raises as :meth:`units` does.

        >>> from hfield import QuaternionAlgebra
        >>> len(QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order().units_modulo_scalars())
        60
        """
        found = self.units()
        return tuple(u for n, u in enumerate(found) if -u not in found[:n])

    def unit_index(self) -> int:
        """Return the index [Oˣ : ±1], or [Oˣ : ℤ_Kˣ] over ℤ_K. Raises as :meth:`units` does.

        >>> from hfield import H, QuaternionAlgebra
        >>> H("QQ").hurwitz_order().unit_index(), len(H("QQ").hurwitz_order().units_modulo_scalars())
        (12, 12)
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> O.unit_index(), O.unit_group()
        (60, 'A5')
        """
        return units.unit_index(self.value)

    def unit_count(self) -> int:
        """Return the number of units, at most 24. Raises as :meth:`units` does.

        Over a field other than ℚ there are infinitely many, and :class:`NotFiniteError` is raised.
        """
        number = self.value.ambient.base.number_of_units
        if number is None:
            raise NotFiniteError(
                f"the order has infinitely many units, as {self.algebra.ring.name} has: unit_index() counts "
                "them modulo those of the field"
            )
        return number * self.unit_index()

    def unit_group(self) -> str:
        """Return the name of the group of units: ``C2 C4 C6 Q8 Dic3`` or ``SL(2,3)``.

        Over ℤ_K it is the name of Oˣ/ℤ_Kˣ: ``C4 D2 D6 A4 S4 A5`` and so on. In an indefinite algebra the
        result is ``"infinite"``.
        """
        return units.unit_group(self.value)

    def norm_one_group(self) -> NormOneGroup:
        """Return the units of norm 1 modulo ±1, as a group of motions of the hyperbolic plane.

        The group has Dirichlet domains, a signature, a presentation and words. Raises
        :class:`IndefiniteError` unless the field is totally real and exactly one real place splits.

        >>> from hfield import QuaternionAlgebra, ring
        >>> K = ring("QQ[s]/(s^3+s^2-2*s-1)")
        >>> A = QuaternionAlgebra.from_ramification(K, K.real_places()[:2])
        >>> G = A.maximal_order().norm_one_group(); G.area, G.signature
        (Fraction(1, 42), Signature(genus=0, orders=(2, 3, 7), cusps=0))
        """
        return self._norm_one_group

    @cached_property
    def _norm_one_group(self) -> NormOneGroup:
        return NormOneGroup(split_order(self.value))

    # --- ideals ------------------------------------------------------------------------------------

    def left_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the left ideal ``O·gens``. Raises :class:`LatticeError` if its rank is below 4."""
        return self._generated(generators, "left")

    def right_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the right ideal ``gens·O``. Raises :class:`LatticeError` if its rank is below 4."""
        return self._generated(generators, "right")

    def two_sided_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the ideal ``O·gens·O``. Raises :class:`LatticeError` if its rank is below 4."""
        return self._generated(generators, "two-sided")

    def _generated(self, generators: Iterable[object], side: str) -> Ideal:
        found = lattice_values.generated_ideal(self.value, listed(generators), side)
        return self._ideal(found, side)

    def _ideal(self, value: LatticeValue, side: str) -> Ideal:
        """Return a lattice, known to be an ideal of this order on a side, as an Ideal."""
        return Ideal(value, side, self)

    def two_sided_prime(self, prime: object) -> Ideal:
        """Return a two-sided ideal that generates, with scalars, the invertible two-sided ideals at P.

        Its square is Pᵉ·O, where Pᵉ is the part of the discriminant at P; it is P·O if P does not divide the
        discriminant. Raises :class:`LatticeError` if the order is neither maximal nor Eichler at P.
        """
        P = self.value.ambient.base.prime(prime)
        return self._ideal(ideals_of_norm.two_sided_prime(self.value, P), "two-sided")

    def ideals_of_norm(self, n: object, side: str = "left") -> list[Ideal]:
        """Return all invertible integral ideals of norm n on a side.

        For a prime norm P that does not divide the discriminant there are N(P) + 1. Over ℤ_K, n is an ideal
        or a prime of the field. Raises :class:`LatticeError`, and :class:`TooLargeError` for more than 10⁵.

        >>> from hfield import QuaternionAlgebra
        >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); O = A.eichler_order(3)
        >>> [len(O.ideals_of_norm(n)) for n in (1, 2, 3)]
        [1, 5, 19]
        """
        norm, side = self.value.ambient.base.integral_ideal(n), checked_side(side)
        values = ideals_of_norm.ideals_of_norm(self.value, norm)
        found = [self._ideal(J, "right") for J in values]
        return found if side == "right" else [J.conjugate() for J in found]

    def subideals(self, ideal: Lattice, prime: object) -> list[Ideal]:
        """Return all invertible right ideals of relative norm P in an invertible right ideal of this order.

        There are N(P) + 1 if P does not divide the discriminant. Raises :class:`LatticeError` for another
        lattice, and :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order(); I = O.right_ideal([3, "1 + j"])
        >>> [(J.norm(), J <= I) for J in O.subideals(I, 2)]
        [(6, True), (6, True), (6, True)]
        """
        P, value = self.value.ambient.base.prime(prime), self._same(ideal, "compare").value
        if not lattice_values.is_locally_principal(value, self.value) or (
            lattice_values.product(value, self.value) != value
        ):
            raise LatticeError(
                f"{shorten(repr(ideal))} is not an invertible right ideal of the order"
            )
        values = ideals_of_norm.subideals(self.value, value, P)
        return [self._ideal(J, "right") for J in values]

    def random_ideal(self, n: object, side: str = "left", seed: int | None = None) -> Ideal:
        """Return a random primitive ideal of norm n, where n is prime to the discriminant.

        All such ideals are equally likely; the same seed gives the same ideal. Raises :class:`LatticeError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> O.random_ideal(49, seed=1).norm(), O.random_ideal(49, seed=1).primitive_part()[1]
        (ideal(49), ideal(1))
        """
        norm, side = self.value.ambient.base.integral_ideal(n), checked_side(side)
        value = ideals_of_norm.random_ideal(self.value, norm, random.Random(seed))
        found = self._ideal(value, "left")
        return found if side == "left" else found.conjugate()

    def connecting_ideal(self, other: Lattice) -> Ideal:
        """Return the primitive integral ideal with this left order and the right order ``other``.

        Raises :class:`LatticeError` unless both are Eichler orders of the same level.
        """
        second = self._order_like(other).value
        return self._ideal(related_orders.connecting(self.value, second), "left")

    # --- elements ----------------------------------------------------------------------------------

    def represent_integer(self, n: object, seed: int | None = None) -> Quaternion | None:
        """Return an element of norm n, an integer of the field, or None if there is none.

        Over ℤ, n may have hundreds of digits. In every order of discriminant below 2²⁰ an element is found if
        there is one. Raises :class:`IndefiniteError` unless the algebra is totally definite, and
        :class:`UndecidedError` for a large n that was not decided.

        >>> from hfield import QuaternionAlgebra
        >>> A = QuaternionAlgebra("QQ(sqrt(2))", -1, -1); M, s = A.maximal_order(), A.ring.gen
        >>> A.order(["i", "j"]).represent_integer(2 + s), M.represent_integer(2 + s).norm()
        (None, 2+sqrt(2))
        """
        return quadratic_orders.represent_integer(self.value, n, seed)

    def strong_approximation(
        self, x: object, modulus: object, number: object, seed: int = 0
    ) -> Quaternion:
        """Return μ ≡ λ·x modulo N·O, for some integer λ prime to N, whose norm divides a smooth number T.

        This is StrongApproximation of KLPT. The order is p-extremal, N is an odd prime, and x = (C + D·s)·β
        is a result of :meth:`Ideal.ideal_mod_constraint`. T should be larger than p·N³. Raises
        :class:`LatticeError` for other arguments; :class:`NoSolutionError` if all divisors of T were tried,
        as for p·N³ < 2²⁰ or small T; and :class:`UndecidedError`, with the size of T that is needed. If no
        divisor of T is λ²·N(x) modulo N, try another γ.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra(2**61 - 1).extremal_order(); I = O.random_ideal(1013, seed=1)
        >>> gamma = O.represent_integer(1013 * 2**80)
        >>> mu = O.strong_approximation(I.ideal_mod_constraint(gamma), 1013, 6**60)
        >>> gamma * mu in I, 6**60 % mu.norm()
        (True, 0)
        """
        _expect_rational(self, "strong_approximation()")
        return solvers.of_smooth_norm(self.value, self.algebra(x), modulus, number, seed)

    def modulo(self, n: object, factors: Factors | None = None) -> ResidueMatrices:
        """Return an isomorphism M of O/NO with M₂(ℤ/N), for N prime to the discriminant.

        M(x) is a matrix, ``M.lift`` is the inverse, ``M.ideal(v)`` is the left ideal of all x with M(x)·v =
        0, and ``M.kernel(I)`` returns v. ``factors`` are the primes of N, if N is too large to be factored.
        Raises :class:`LatticeError`, also over fields other than ℚ, and :class:`UnfactoredError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order(); M = O.modulo(5)
        >>> M(O.algebra("i")), M.ideal((1, 2)).norm(), M.kernel(M.ideal((1, 2)))
        (((0, 1), (4, 0)), 5, (1, 2))
        """
        _expect_rational(self, "modulo()")
        return ResidueMatrices(self, n, factors)

    def factor(self, x: object, primes: Iterable[object]) -> tuple[Quaternion, list[Quaternion]]:
        """Return (u, [π₁, …, πₙ]) with x = u·π₁⋯πₙ, where u is a unit and the norms of the factors are
        ``primes``.

        The primes may come in any order, each as often as it divides the norm of x (Conway and Smith, *On
        Quaternions and Octonions*, chapter 5). Over ℤ_K they are prime ideals, or generators of them. N(πₙ)
        generates the ideal; it is the given number if that is totally positive and the units of the order
        allow it. In an indefinite algebra over ℚ it is the prime up to sign. Raises :class:`LatticeError` if
        norms do not match or an ideal of prime norm is not principal, and :class:`UndecidedError`.

        >>> from hfield import H
        >>> O = H("QQ").hurwitz_order(); u, factors = O.factor("3 + 5*i + j", [5, 7])
        >>> u, factors, u * factors[0] * factors[1], [q.norm() for q in factors]
        (1/2 + 1/2*i - 1/2*j + 1/2*k, [1/2 + 1/2*i + 3/2*j + 3/2*k, -1 + i - 2*j - k], 3 + 5*i + j, [5, 7])
        """
        return element_factors.factor(self.value, x, primes)

    def embeddings(self, discriminant: object) -> Embeddings:
        """Return the optimal embeddings of the quadratic order of discriminant d.

        In a definite algebra d must be totally negative. In an algebra that splits at exactly one real place
        d is any nonsquare discriminant, and ``representatives`` has one embedding for each orbit under the
        units of norm 1. Raises :class:`LatticeError` for other d, :class:`IndefiniteError` for other
        algebras, and :class:`TooLargeError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order(); found = O.embeddings(-3)
        >>> len(found), found.orbits, found.element**3
        (20, 1, -1)
        >>> O = QuaternionAlgebra(6).maximal_order(); found = O.embeddings(-24)
        >>> found.orbits, found.element.norm() * 4 - found.element.trace() ** 2
        (4, 24)
        >>> O.embeddings(-7).reason
        '2 splits in the quadratic field, and the algebra ramifies at 2'
        """
        if not self.is_definite():
            from hfield.fuchsian import cm_points

            group = self.norm_one_group()
            element, reason, prime = cm_points.embedding(group, discriminant)
            return Embeddings(
                element is not None,
                reason,
                element,
                order=self,
                discriminant=discriminant,
                listed=None,
                of_orbits=partial(cm_points.of_orbits, group, discriminant),
                prime=prime,
                of_orbits_claim=partial(cm_points.claim_of_orbits, group, discriminant),
            )
        every, chosen = quadratic_orders.embeddings(self.value, discriminant)
        reason = "" if every else "no element of the order has this discriminant and is optimal"
        first = every[0] if every else None
        return Embeddings(
            first is not None,
            reason,
            first,
            order=self,
            discriminant=discriminant,
            listed=every,
            of_orbits=partial(tuple, chosen),
        )

    # --- classes -----------------------------------------------------------------------------------

    def class_set(
        self, *, executor: Executor | None = None, file: str | Path | None = None
    ) -> ClassSet:
        """Return the invertible right ideal classes, complete by the mass formula.

        An executor, such as a ``ProcessPoolExecutor``, computes neighbours in parallel; the order of the
        classes does not depend on it. If a file is given, classes and rows of
        :meth:`ClassSet.neighbour_counts` are read from it and appended to it as they are found, so that an
        interrupted run can resume. Raises :class:`IndefiniteError` unless the algebra is totally definite;
        see :meth:`classes_by_norm`.
        """
        if not self.is_definite():
            ambient = self.value.ambient
            number = ambient.base.classes_modulo_signs(ambient).order
            raise IndefiniteError(
                f"{self.algebra} is split at an infinite place, and class_set() lists the classes in totally "
                "definite algebras only: by strong approximation the reduced norm determines the right ideal "
                f"class of an Eichler order here, the number of classes is {number}, and classes_by_norm() "
                "has representatives"
            )
        return ClassSet(self, executor, None if file is None else ClassFile(file))

    def classes_by_norm(self) -> IndefiniteClassSet:
        """Return the right ideal classes, with representatives, if the algebra splits at an infinite place.

        Raises :class:`IndefiniteError` for a totally definite algebra, and if some local unit of the base is
        not the norm of a local unit of the order.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra("QQ(sqrt(10))", -1, 3).maximal_order().classes_by_norm()
        >>> len(C), [I.norm() for I in C], [C.index(I) for I in C], C.type_number
        (2, [ideal(1), ideal(2, sqrt(10))], [0, 1], 1)
        """
        from hfield.orders.indefinite_classes import IndefiniteClassSet

        return IndefiniteClassSet(self)

    @cached_property
    def _stable(self) -> StableClasses:
        return stable_classes(self.value)

    def mass(self) -> Fraction:
        """Return Σ 1/[O_L(I)ˣ : ℤ_Kˣ] (over ℤ, modulo ±1) over the right ideal classes, by a formula.

        Raises :class:`IndefiniteError`.
        """
        return mass_formula.mass(self.value)

    def _expect_right_ideal(self, ideal: object) -> None:
        """Raise :class:`LatticeError` unless this is an invertible right ideal of the order."""
        if not isinstance(ideal, Ideal) or ideal.side == "left":
            raise LatticeError(f"{shorten(repr(ideal))} is not a right ideal of {shorten(self)}")
        if ideal.order != self or not ideal.is_invertible():
            raise LatticeError(f"{shorten(repr(ideal))} is not an invertible right ideal of {self}")


class Ideal(Certified, Lattice):
    """A lattice I with ``O·I = I`` for the order O (``side="left"``), or ``I·O = I``, or both.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> I = O.left_ideal([3, "1 + j"])
    >>> I.norm(), I.left_order() == O
    (3, True)
    >>> I * I.inverse() == O
    True
    >>> O = QuaternionAlgebra("QQ(sqrt(10))", -1, -1).maximal_order()
    >>> I = O.left_ideal([3, "1 + i + j"])
    >>> I.norm(), I.left_order() == O, I * I.inverse() == O, I.side
    (ideal(3), True, True, 'left')
    """

    foreign_names = IDEAL

    def __init__(self, value: LatticeValue, side: str = "left", order: Order | None = None) -> None:
        super().__init__(value)
        self.side = side
        self._order = order

    @property
    def _arguments(self) -> tuple[object, ...]:
        return self.value, self.side, self._order

    @classmethod
    def generated(cls, order: Order, generators: Iterable[object], side: str) -> Self:
        """Return the ideal of an order generated by elements on a side.

        Raises :class:`LatticeError` if its rank is below 4.
        """
        return cls(
            lattice_values.generated_ideal(order.value, listed(generators), side), side, order
        )

    @classmethod
    def of(cls, lattice: Lattice, side: str, order: Order | None = None) -> Self:
        """Return a lattice as an ideal of its left or right order; the order may be passed if it is known."""
        return cls(lattice.value, side, order)

    @classmethod
    def like(cls, lattice: Lattice, order: Order, side: str) -> Self:
        """Return a lattice as an ideal of an order. Raises :class:`LatticeError` if it is not one."""
        value, product = lattice.value, lattice_values.product
        on_left = side == "right" or product(order.value, value) == value
        on_right = side == "left" or product(value, order.value) == value
        if not (on_left and on_right):
            raise LatticeError(f"{shorten(lattice)} is not a {side} ideal of {shorten(order)}")
        return cls(value, side, order)

    def __repr__(self) -> str:
        if len(self.basis) == 4:
            return super().__repr__()
        return f"a {self.side} ideal of norm {self.norm()} of {self.order}"

    def text_for(self, system: str) -> str:
        """Write the ideal as code for another system, as :meth:`Lattice.text_for` says."""
        return foreign_writing.ideal_text(self.value, self.order.value, self.side, system)

    # --- its orders ------------------------------------------------------------------------------

    @property
    def order(self) -> Order:
        """The order of which this is an ideal."""
        if self._order is None:
            self._order = self.colon_order(self.side)
        return self._order

    def colon_order(self, side: str) -> Order:
        """Return the left or the right order, as for any lattice."""
        return self._order_on("right" if side == "right" else "left")

    def left_order(self) -> Order:
        """Return ``{x : x·I ⊆ I}``; for an invertible left ideal it is :attr:`order`."""
        known = self.side != "right" and self.is_invertible()
        return self.order if known else super().left_order()

    def right_order(self) -> Order:
        """Return ``{x : I·x ⊆ I}``; for an invertible right ideal it is :attr:`order`."""
        known = self.side != "left" and self.is_invertible()
        return self.order if known else super().right_order()

    def is_invertible(self) -> bool:
        """Return whether the ideal is locally principal."""
        return lattice_values.is_locally_principal(self.value, self.order.value)

    def is_integral(self) -> bool:
        """Return whether the ideal lies in its order."""
        return self <= self.order

    def is_two_sided(self) -> bool:
        """Return whether the left and the right order are the same."""
        return self.side == "two-sided" or self.left_order() == self.right_order()

    # --- arithmetic ------------------------------------------------------------------------------

    def _result_with(self, other: Lattice, value: LatticeValue) -> Lattice:
        """Return the result as an ideal if both operands are ideals of one order on one side."""
        if isinstance(other, Ideal):
            side = self.side if other.side == "two-sided" else other.side
            if self.side in (side, "two-sided") and self.order == other.order:
                return Ideal(value, side, self.order)
        return Lattice(value)

    def conjugate(self) -> Ideal:
        """Return the ideal of the conjugates, on the other side."""
        return Ideal.of(super().conjugate(), OTHER[self.side], self._order)

    def inverse(self) -> Ideal:
        """Return ``conj(I)/N(I)``. Raises :class:`LatticeError` unless I is locally principal."""
        return Ideal.of(super().inverse(), OTHER[self.side], self._order)

    def __truediv__(self, n: object) -> Ideal:
        """Return the ideal divided by a number or an ideal of the field."""
        return Ideal.of(super().__truediv__(n), self.side, self._order)

    def __mul__(self, other: object) -> Lattice:
        """Return the product with a lattice, an element, a number or an ideal of the field."""
        if _is_scalar(other):
            return Ideal.of(super().__mul__(other), self.side, self._order)
        if self.side != "right":
            return Ideal.of(super().__mul__(other), "left", self._order)
        if isinstance(other, Ideal) and other.side == "left" and self.order == other.order:
            pair = self.value, other.value
            return Ideal(ideal_products.product(*pair, self.order.value), "right")
        known = other._order if isinstance(other, Ideal) and other.side == "right" else None
        return Ideal.of(super().__mul__(other), "right", known)

    def __rmul__(self, other: object) -> Lattice:
        found = super().__rmul__(other)
        if _is_scalar(other):
            return Ideal.of(found, self.side, self._order)
        if self.side == "right":
            return Ideal.of(found, "right", self._order)
        return Ideal.of(found, "left")

    def primitive_part(self) -> tuple[Ideal, ShownIdeal]:
        """Return (J, m) with I = m·J and J integral and primitive; m is an int or an ideal.

        Raises :class:`LatticeError` unless the ideal is integral.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(10))", -1, -1).maximal_order(); I = O.left_ideal([3, "1 + i + j"])
        >>> (6 * I).primitive_part()[1], (6 * I).primitive_part()[0] == I
        (ideal(6), True)
        """
        base = self.value.ambient.base
        inverse = lattice_values.scalars_into(self.value, self.order.value)
        m = base.inverse(inverse)
        if not base.is_integral(m):
            raise LatticeError(
                "only an integral ideal has a primitive part, and this one is not integral"
            )
        found = Ideal(lattice_values.times_ideal(self.value, inverse), self.side, self._order)
        return found, base.shown_index(m)

    def pushforward(self, other: Ideal) -> Ideal:
        """Return ``I⁻¹·(I ∩ J)`` for J = other: a left ideal of the right order of I, of norm N(J).

        Both must be left ideals of one order, of coprime norms; otherwise :class:`LatticeError` is raised
        (Leroux, 2022).
        """
        self._joint(other)
        self._coprime(other)
        return Ideal(
            lattice_values.product(self.inverse().value, (self & other).value),
            "left",
            self.right_order(),
        )

    def pullback(self, other: Ideal) -> Ideal:
        """Return ``I·J + N(J)·O``, the ideal whose pushforward by I is J; J is a left ideal of O_R(I)."""
        if self.side == "right" or other.side == "right" or other.order != self.right_order():
            raise LatticeError(
                "the pullback along a left ideal I is defined for left ideals of the right order of I"
            )
        self._coprime(other)
        order = self.order
        rest = lattice_values.times_ideal(order.value, other.value.norm)
        found = lattice_values.add(lattice_values.product(self.value, other.value), rest)
        return Ideal(found, "left", order)

    def _coprime(self, other: Ideal) -> None:
        n, m = self.value.norm, other.value.norm
        base = self.value.ambient.base
        if not (base.is_integral(n) and base.is_integral(m) and base.are_coprime(n, m)):
            raise LatticeError(f"the norms {n} and {m} are not coprime and integral")

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
    def claim(self) -> CertifiedClaim:
        """The claim of a certificate: a statement with its evidence."""
        return certificates.of_ideal(self.value, self.side, self.order.value)

    @property
    def evidence(self) -> dict[str, object]:
        """The evidence for the ideal: its rows, those of its order, and its norm."""
        return {
            "kind": "ideal",
            "algebra": str(self.algebra),
            "side": self.side,
            **rows_json(self.value),
            "order": rows_json(self.order.value),
            "norm": str(self.value.norm),
        }

    # --- classes ---------------------------------------------------------------------------------

    def equivalence(self, other: Ideal) -> Verdict[Quaternion]:
        """Return an answer with ``element`` c such that J = I·c for left ideals, or J = c·I for right ideals.

        A two-sided ideal is compared as a left ideal, or on the side of the other ideal. If they are not
        equivalent the answer is false, with a ``reason``. In an indefinite algebra a theorem may decide
        without an element; the element is searched for only if exactly one infinite place splits and it is
        real. Raises :class:`LatticeError` for ideals of different orders or sides, and
        :class:`UndecidedError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(3))", -1, -1).maximal_order()
        >>> I = O.left_ideal([11, "1 + 3*i + j"]); answer = I.is_principal()
        >>> I.norm(), bool(answer), O.left_ideal([answer.element]) == I
        (ideal(11), True, True)
        """
        second = self._joint(other)
        side = second.side if self.side == "two-sided" else self.side
        return equivalence.equivalence(self.value, second.value, self.order.value, side)

    def is_equivalent(self, other: Ideal) -> bool:
        """Return whether ``J = I·c`` (or ``c·I``) for some c. Raises as :meth:`equivalence` does."""
        return bool(self.equivalence(other))

    def is_principal(self) -> Verdict[Quaternion]:
        """Return an answer with a generator c as ``element``: I = O·c for a left ideal, I = c·O for a right
        ideal.
        """
        order = self.order.value
        return equivalence.equivalence(order, self.value, order, self.side)

    @cached_property
    def generators(self) -> tuple[ShownIdeal, Quaternion]:
        """Two generators, a number n and an element x: I = O·n + O·x, or n·O + x·O for a right ideal.

        Over ℤ_K, n is an ideal of the field. The lattice that they generate is computed and compared with I.
        Raises :class:`LatticeError` for an ideal that is not invertible.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order(); I = O.left_ideal([15, "1 + j"])
        >>> n, x = I.generators; n, O.left_ideal([n, x]) == I
        (3, True)
        >>> O = QuaternionAlgebra("QQ(sqrt(10))", -1, -1).maximal_order()
        >>> I = O.left_ideal([3, "1 + i + j"]); n, x = I.generators; n, n * O + O.left_ideal([x]) == I
        (ideal(3), True)
        """
        return ideal_generators.two_generators(self.value, self.order.value, self.side)

    def reduced_equivalent(self) -> EquivalentIdeal:
        """Return an integral ideal J of least norm equivalent to I, with c as ``J.element``.

        J = I·c for a left ideal, c·I for a right ideal, with c = conj(x)/N(I) for a shortest x in I. Raises
        :class:`LatticeError` for an ideal that is not invertible or over a field other than ℚ, and
        :class:`IndefiniteError`.

        >>> from hfield import QuaternionAlgebra
        >>> I = QuaternionAlgebra(419).extremal_order().random_ideal(1009, seed=1)
        >>> J = I.reduced_equivalent(); J.norm() < 20, I * J.element == J
        (True, True)
        """
        _expect_rational(self, "reduced_equivalent()")
        expect_definite(self.value.ambient, "reduced_equivalent()")
        self._expect_invertible("reduced_equivalent()")
        return self._with_conjugate(short_elements.shortest(self.value)[0])

    def _with_conjugate(self, x: Quaternion) -> EquivalentIdeal:
        """Return the equivalent ideal of norm N(x)/N(I) for an x in I."""
        c = x.conjugate() / self.norm()
        side = "left" if self.side == "right" else "right"
        return EquivalentIdeal(
            lattice_values.multiple(self.value, c, side), self.side, self.order, c
        )

    def _expect_invertible(self, what: str) -> None:
        if not self.is_invertible():
            raise LatticeError(
                f"{what} is for invertible ideals, and this one is not locally principal"
            )

    def equivalent_of_prime_norm(self, avoid: Iterable[int] = ()) -> tuple[Ideal, Quaternion]:
        """Return (J, c), where J is equivalent to I and has the least prime norm not in ``avoid``.

        J = I·c for a left ideal, c·I for a right ideal, with c = conj(x)/N(I) for a short x in I (Kohel,
        Lauter, Petit and Tignol, 2014). Raises :class:`LatticeError` over fields other than ℚ.
        """
        _expect_rational(self, "equivalent_of_prime_norm()")
        return self._with_conjugate(klpt.to_prime_norm(self.value, frozenset(avoid))).pair

    def equivalent_of_power_norm(self, prime: int, seed: int = 0) -> tuple[Ideal, Quaternion, int]:
        """Return (J, c, e), where J is equivalent to I and has norm primeᵉ, by KLPT; c is as in
        :meth:`equivalence`.

        I must be an ideal of a maximal order in an algebra of prime discriminant p. The norm is about p³ for
        a p-extremal order, and about p⁶ for others, which use connecting ideals. Raises :class:`LatticeError`
        for another order or over a field other than ℚ, and :class:`UndecidedError`.
        """
        _expect_rational(self, "equivalent_of_power_norm()")
        left = self._as_left
        x, e = klpt.to_power_norm(left, self.order.value, checked_prime(prime), seed)
        return *self._from_left(x).pair, e

    def equivalent_of_norm_dividing(
        self, number: object, seed: int = 0
    ) -> tuple[Ideal, Quaternion, int]:
        """Return (J, c, n), where J is equivalent to I and its norm n divides a smooth number T, by KLPT.

        c is as in :meth:`equivalence`, and I must be an ideal of a maximal order. Norms of moderate size are
        tried first, and the least one is returned. KLPT needs T > p³ for a p-extremal order, and T > p⁶ for
        other orders, which use connecting ideals. For p < 2²⁰ small divisors of T are decided by complete
        enumeration, and larger ones are found. Raises :class:`LatticeError` for another order or over a field
        other than ℚ; :class:`NoEquivalentIdealError` if all divisors were tried and none is a norm;
        :class:`UndecidedError` if not all were tried. The last two messages give the size of T that is
        needed.

        >>> from hfield import QuaternionAlgebra
        >>> I = QuaternionAlgebra(2**61 - 1).extremal_order().random_ideal(101, seed=1)
        >>> J, c, n = I.equivalent_of_norm_dividing(6**100)
        >>> I * c == J, J.norm() == n, 6**100 % n
        (True, True, 0)
        """
        _expect_rational(self, "equivalent_of_norm_dividing()")
        self._expect_invertible("equivalent_of_norm_dividing()")
        smooth = positive(number, "number T")
        x = klpt.to_norm_dividing(self._as_left, self.order.value, smooth, seed)
        found = self._from_left(x)
        return *found.pair, int(fraction(found.norm()))

    def equivalent_pair(
        self, total: object, seed: int = 0
    ) -> tuple[tuple[Ideal, Quaternion], tuple[Ideal, Quaternion]]:
        """Return ((J₁, c₁), (J₂, c₂)): two ideals equivalent to I with coprime norms of sum ``total``
        (Qlapoti).

        c₁ and c₂ are as in :meth:`equivalence`. The order must be p-extremal, or maximal with p < 2⁴⁰; in the
        latter case a search finds the pair. The total should be at least about 2p (Borin et al., ePrint
        2025/1604). Raises :class:`LatticeError` for another order or over a field other than ℚ. For smaller
        totals, raises :class:`NoEquivalentIdealError` if all smaller norms were listed, else
        :class:`UndecidedError`.

        >>> from hfield import QuaternionAlgebra
        >>> I = QuaternionAlgebra(2**61 - 1).extremal_order().random_ideal(101, seed=1)
        >>> (J, c), (K, d) = I.equivalent_pair(2**64)
        >>> I * c == J, I * d == K, J.norm() + K.norm() == 2**64, J.norm() % 2
        (True, True, True, 1)
        """
        _expect_rational(self, "equivalent_pair()")
        self._expect_invertible("equivalent_pair()")
        number = positive(total, "sum of the norms")
        x, y = norm_pairs.with_sum(self._as_left, self.order.value, number, seed)
        return self._from_left(x).pair, self._from_left(y).pair

    @property
    def _as_left(self) -> LatticeValue:
        """The ideal if it is a left ideal, else its conjugate."""
        return lattice_values.conjugate(self.value) if self.side == "right" else self.value

    def _from_left(self, x: Quaternion) -> EquivalentIdeal:
        """Return the equivalent ideal of norm N(x)/N(I) for an x in :attr:`_as_left`."""
        return self._with_conjugate(x.conjugate() if self.side == "right" else x)

    def ideal_mod_constraint(self, gamma: object) -> Quaternion:
        """Return μ = (C + D·s)·β with γ·μ in I, for a left ideal of prime norm of a p-extremal order.

        s² is the discriminant of the small quadratic order R, and β, of norm p, is orthogonal to R
        (IdealModConstraint of KLPT). The norm of γ must be a multiple of the norm of I. Raises
        :class:`LatticeError` for other ideals and elements.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra(2**61 - 1).extremal_order(); I = O.random_ideal(1009, seed=1)
        >>> gamma = O.represent_integer(1009 * 2**80)
        >>> gamma * I.ideal_mod_constraint(gamma) in I
        True
        """
        return self._mod_constraint(gamma, None, "ideal_mod_constraint()")

    def eichler_mod_constraint(self, gamma: object, delta: object = 1) -> Quaternion:
        """Return μ = (C + D·s)·β with γ·μ·δ in the Eichler order ℤ + I, as :meth:`ideal_mod_constraint` does.

        γ and δ are elements of the order (EichlerModConstraint of SQISign). Raises :class:`LatticeError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra(2**61 - 1).extremal_order(); I = O.random_ideal(1009, seed=1)
        >>> gamma = O.represent_integer(2**80); E = O & I.right_order()
        >>> gamma * I.eichler_mod_constraint(gamma) in E
        True
        """
        return self._mod_constraint(gamma, delta, "eichler_mod_constraint()")

    def _mod_constraint(self, gamma: object, delta: object, what: str) -> Quaternion:
        _expect_rational(self, what)
        if self.side == "right":
            raise LatticeError(f"{what} is for left ideals: conjugate this one first")
        A = self.algebra
        after = None if delta is None else A(delta)
        return solvers.mod_constraint(self.value, self.order.value, A(gamma), after)


class EquivalentIdeal(Ideal):
    """An ideal J equivalent to I, with ``element`` c: J = I·c for left ideals, J = c·I for right ideals."""

    def __init__(self, value: LatticeValue, side: str, order: Order, element: Quaternion) -> None:
        super().__init__(value, side, order)
        self.element = element

    @property
    def pair(self) -> tuple[Ideal, Quaternion]:
        """The ideal J, without the attribute ``element``, and the element c."""
        return Ideal(self.value, self.side, self.order), self.element

    @property
    def _arguments(self) -> tuple[object, ...]:
        return *super()._arguments, self.element


def _expect_rational(lattice: Lattice, what: str) -> None:
    """Raise :class:`LatticeError` unless the base is ℤ."""
    expect_rational(
        lattice.value.ambient.base,
        LatticeError(
            f"{what} is defined for orders over ZZ and their ideals, and this algebra is over "
            f"{lattice.algebra.ring.name}: there norms are ideals, which need not be principal"
        ),
    )


def _is_scalar(x: object) -> bool:
    """Return whether x acts on a lattice as a scalar or an ideal of the field."""
    return not isinstance(x, (Lattice, Quaternion, tuple, list, str))


class ClassSet(ByStableClasses, WithForms, Certified, Hinted):
    """The invertible right ideal classes of an order: ``len(C)``, iteration over representatives, ``C[n]``.

    >>> from hfield import QuaternionAlgebra
    >>> C = QuaternionAlgebra("QQ", -1, -11).maximal_order().class_set()
    >>> len(C), C.mass, C.type_number
    (2, Fraction(5, 6), 2)
    >>> C.brandt_matrix(2)
    [[1, 2], [3, 0]]
    >>> C = QuaternionAlgebra("QQ(sqrt(6))", -1, -1).maximal_order().class_set()
    >>> len(C), C.mass, C.type_number
    (3, Fraction(1, 4), 3)
    """

    foreign_names = CLASSES
    order: Order

    def __init__(
        self, order: Order, executor: Executor | None = None, file: ClassFile | None = None
    ) -> None:
        self.order, self._classes = order, Classes(order.value, executor, file)
        self._base = order.value.ambient.base

    def __len__(self) -> int:
        return len(self._classes)

    def __getitem__(self, n: int) -> Ideal:
        """Return the representative of class n, an integral right ideal; class 0 is that of O.

        It is primitive if the base has class number 1.
        """
        lattice = self._classes.lattice(self._checked(n))
        factor = lattice_values.scalars_into(lattice, self.order.value)
        found = lattice_values.times_ideal(lattice, self._base.principal_multiple(factor))
        return Ideal(found, "right", self.order)

    def _checked(self, n: int) -> int:
        if not -len(self) <= n < len(self):
            raise IndexError(
                f"there are {len(self)} classes, numbered from 0: {n} is not one of them"
            )
        return n

    def __iter__(self) -> Iterator[Ideal]:
        return (self[n] for n in range(len(self)))

    def left_ideals(self) -> Iterator[Ideal]:
        """Yield representatives of the left ideal classes, the conjugates of the right ones."""
        return (I.conjugate() for I in self)

    def left_orders(self) -> list[Order]:
        """Return the left orders of the representatives, one per class."""
        return [I.left_order() for I in self]

    def index(self, ideal: object) -> int:
        """Return the number of the class of a right ideal. Raises :class:`LatticeError` for others."""
        found = ideal
        if isinstance(ideal, Lattice) and not isinstance(ideal, Ideal):
            found = Ideal.like(ideal, self.order, "right")
        self.order._expect_right_ideal(found)
        assert isinstance(found, Ideal)
        return self._classes.class_of(found.value)

    @property
    def mass(self) -> Fraction:
        """The sum Σ 1/[O_L(I)ˣ : Rˣ] over the classes, where R is the ring of integers of the base; over ℤ,
        modulo ±1.
        """
        return self._classes.mass

    @property
    def units(self) -> list[int]:
        """The index [O_L(I)ˣ : Rˣ] for each class, where R is the ring of integers of the base; over ℤ,
        modulo ±1.
        """
        return list(self._classes.units)

    @property
    def unit_counts(self) -> list[int]:
        """The number of units of the left order of each class.

        Over a field other than ℚ there are infinitely many, and :class:`NotFiniteError` is raised.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra(11).maximal_order().class_set(); C.unit_counts, C.units
        ([4, 6], [2, 3])
        """
        number = self._base.number_of_units
        if number is None:
            raise NotFiniteError(
                f"orders over {self.order.algebra.ring.name} have infinitely many units; units has their "
                "numbers modulo those of the field"
            )
        return [number * count for count in self._classes.units]

    @property
    def types(self) -> list[int]:
        """The type of each class, as a number: classes with isomorphic left orders have the same type."""
        return list(self._classes.types)

    @property
    def type_number(self) -> int:
        """The number of isomorphism classes of orders in the genus."""
        return len(set(self._classes.types))

    def labels(self) -> list[str]:
        """Return the label of the left order of each class; two classes have the same label if and only if
        they have the same type.

        Raises as :meth:`Order.label` does.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(23).maximal_order().class_set().labels()
        ['x²+y²+6·z²+y·z', 'x²+2·y²+3·z²+y·z', 'x²+y²+8·z²+x·z+x·y']
        """
        return [str(self._form_of_type[kind]) for kind in self._classes.types]

    def types_by_label(self) -> dict[str, list[int]]:
        """Return the numbers of the classes of each type, as a dict from labels, ordered by label.

        Labels are ordered by the coefficients of the forms, in the order x², y², z², yz, xz, xy. Raises as
        :meth:`Order.label` does.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(37).maximal_order().class_set().types_by_label()
        {'x²+2·y²+5·z²+y·z+x·z': [0], '2·x²+2·y²+3·z²+2·y·z+x·z+x·y': [1, 2]}
        """
        forms = sorted(self._form_of_type.items(), key=lambda item: item[1].coefficients)
        kinds = self._classes.types
        return {
            str(form): [n for n, own in enumerate(kinds) if own == kind] for kind, form in forms
        }

    @cached_property
    def _form_of_type(self) -> dict[int, TernaryForm]:
        """The reduced ternary form of the left orders of each type."""
        labels.expect_labels(self.order.value.ambient)
        kinds = self._classes.types
        firsts = {kind: kinds.index(kind) for kind in range(self.type_number)}
        return {
            kind: labels.reduced_form(lattice_values.order_of(self._classes.lattice(n), "left"))
            for kind, n in firsts.items()
        }

    def exchanged(self, prime: object) -> list[int]:
        """Return the permutation of the classes by the two-sided prime ideal at a prime, as a list.

        Raises :class:`LatticeError` if the order is neither maximal nor Eichler at this prime.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(37).maximal_order().class_set().exchanged(37)
        [0, 2, 1]
        """
        return list(self._classes.exchanged(self._base.prime(prime)))

    # --- Brandt matrices -----------------------------------------------------------------------------

    def neighbour_counts(self, prime: object, *, executor: Executor | None = None) -> SparseRows:
        """Return the Brandt matrix of a prime as rows of dicts {class: count}.

        Row i counts the right ideals of relative norm P in I_i by class; zero counts are omitted. The memory
        is linear in the number of classes: the rows are a sequence with the method ``times(values)``, and
        ``arrays`` for scipy. An executor, such as a ``ProcessPoolExecutor``, computes rows in parallel; the
        result does not depend on it. Raises :class:`LatticeError` unless the argument is a prime, and
        :class:`TooLargeError` if there are too many neighbours.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra(37).maximal_order().class_set()
        >>> list(C.neighbour_counts(2)), C.brandt_matrix(2)
        ([{0: 1, 1: 1, 2: 1}, {0: 1, 2: 2}, {0: 1, 1: 2}], [[1, 1, 1], [1, 0, 2], [1, 2, 0]])
        """
        return self._classes.neighbours(self._base.prime(prime), executor)

    def neighbours(self, prime: object) -> list[Counter[int]]:
        """Return the rows of :meth:`neighbour_counts` as a list of counters."""
        return list(map(Counter, self.neighbour_counts(prime)))

    def neighbours_of(self, n: int, prime: object) -> Counter[int]:
        """Return the row of class n as a counter.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(11).maximal_order().class_set().neighbours_of(0, 2)
        Counter({1: 2, 0: 1})
        """
        return self._classes.neighbours_of(self._checked(n), self._base.prime(prime))

    def power_neighbours(self, prime: object, e: int) -> list[Counter[int]]:
        """Return, for each class, the numbers of right ideals of relative norm Pᵉ inside it, by class."""
        P = self._base.prime(prime)
        matrix = brandt.prime_power(self._classes, P, natural(e, "the exponent is"))
        return list(map(Counter, brandt.sparse(matrix)))

    def brandt_matrix(self, norm: object) -> list[list[int]]:
        """Return the Brandt matrix of a norm: entry (i, j) counts the ideals of this norm in I_i that lie in
        class j.

        The ideals are invertible and have this relative norm, which is an ideal of the base or a number that
        generates it. Over ℤ, entry (i, j) times the number of units of j is entry (j, i) times that of i
        (Pizer, 1980; Gross, 1987). Raises :class:`LatticeError` unless the norm is an integral ideal, and
        :class:`TooLargeError` from some ten thousand classes on; see :meth:`neighbour_counts`.
        """
        return brandt.brandt_lists(self._classes, self._base.integral_ideal(norm))

    def hecke_polynomial(self, norm: object, weight: int = 2) -> list[int]:
        """Return the characteristic polynomial of the Brandt matrix, low degree first.

        For an even weight k > 2 it is the polynomial of the Hecke operator on all forms of weight k, of any
        unramified character. Raises :class:`LatticeError` for other weights, and for weights k > 2 also if
        the order is not Eichler; raises :class:`TooLargeError` as :meth:`brandt_matrix` does.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra(3).maximal_order().class_set()
        >>> C.hecke_polynomial(2), C.hecke_polynomial(2, weight=6), C.hecke_polynomial(2, weight=8)
        ([-3, 1], [6, 1], [-6, 1])
        """
        ideal = self._base.integral_ideal(norm)
        if checked_weight(weight) == 2:
            return brandt.hecke_polynomial(self._classes, ideal)
        functions = self._functions(weight)
        assert isinstance(functions, WeightedFunctions)
        return functions.hecke_polynomial(ideal)

    def hecke_operator(self, norm: object, values: Sequence[ValueT]) -> list[ValueT | int]:
        """Return the Brandt matrix of a norm applied to a function on the classes, given by its values.

        Raises :class:`LatticeError` unless there is a value for each class.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra("QQ", -1, -11).maximal_order().class_set()
        >>> C.hecke_operator(2, [1, 1]), C.hecke_operator(2, [2, -3])
        ([3, 3], [-4, 6])
        """
        if len(values) != len(self):
            raise LatticeError(f"{len(values)} values were given for {len(self)} classes")
        return brandt.brandt_rows(self._classes, self._base.integral_ideal(norm)).times(values)

    def theta_series(self, i: int, j: int, n: int) -> ThetaSeries:
        """Return the theta series of the lattice I_i·I_j⁻¹, as :meth:`Lattice.theta_series` does.

        Over ℤ its coefficient m, divided by the number of units of class j, is entry (i, j) of the Brandt
        matrix of m. Raises :class:`LatticeError` if i or j is not the number of a class.
        """
        h = len(self)
        if not (-h <= i < h and -h <= j < h):
            raise LatticeError(
                f"there are {h} classes, numbered from 0: {i} and {j} are not both of them"
            )
        inverse = lattice_values.inverse(self._classes.lattice(j))
        between = lattice_values.product(self._classes.lattice(i), inverse)
        return short_elements.theta_series(between, n)

    def edges(self, prime: object) -> Iterator[tuple[int, int, dict[str, int | Fraction]]]:
        """Yield the edges of :meth:`graph`."""
        units = self.units
        for i, row in enumerate(self.neighbour_counts(prime)):
            for j, times in row.items():
                yield i, j, {"weight": times, "mass": Fraction(times, units[i])}

    def graph(self, prime: object) -> list[tuple[int, int, dict[str, int | Fraction]]]:
        """Return the edges of the graph of P-neighbours as a list that ``networkx.DiGraph`` reads.

        ``weight`` is the number of right ideals of relative norm P in class i that belong to class j, so that
        the weighted adjacency matrix is the Brandt matrix. ``mass`` is this number divided by entry i of
        :attr:`units`; it is the same in both directions. For a maximal order of prime discriminant over ℤ
        this is the supersingular isogeny graph, up to Galois conjugation of the vertices (Deuring). Raises as
        :meth:`neighbour_counts` does.

        >>> from hfield import QuaternionAlgebra
        >>> for edge in QuaternionAlgebra(11).maximal_order().class_set().graph(2): print(*edge)
        0 0 {'weight': 1, 'mass': Fraction(1, 2)}
        0 1 {'weight': 2, 'mass': Fraction(1, 1)}
        1 0 {'weight': 3, 'mass': Fraction(1, 1)}
        """
        return list(self.edges(prime))

    # --- evidence ------------------------------------------------------------------------------------

    @cached_property
    def claim(self) -> CertifiedClaim:
        """The claim of the class number, with its evidence."""
        return certificates.of_class_set(self._classes)

    def claim_of_newforms(
        self, weight: int = 2, norm: int = 20, signs: bool = False
    ) -> CertifiedClaim:
        """Return the claim of the newforms and their eigenvalues at primes of norm up to a bound.

        With ``signs`` it contains the primes of the level and the discriminant, and the signs there.
        Its evidence is checked over ℚ in weights up to 100, and over totally real fields in weight 2. Raises
        as :meth:`newforms` does.

        >>> from hfield import QuaternionAlgebra
        >>> claim = QuaternionAlgebra(11).maximal_order().class_set().claim_of_newforms(norm=7)
        >>> claim.statement.rpartition(";")[2], claim.why_no_certificate
        (' QQ: -2,-1,1,-2}', None)
        """
        functions = self._functions(checked_weight(weight))
        return of_newforms(functions, positive(norm, "norm"), signs)

    @property
    def evidence(self) -> dict[str, object]:
        """The evidence for the class set: representatives, units, and the mass.

        Units are counted as in :attr:`unit_counts` over ℤ, and as in :attr:`units` over other bases.
        """
        base = self._base
        counts = [(base.number_of_units or 1) * count for count in self.units]
        return {
            "kind": "class-set",
            "algebra": str(self.order.algebra),
            "order": rows_json(self.order.value),
            "discriminant": base.ideal_text(lattice_values.discriminant(self.order.value)),
            "mass": str(self.mass),
            "classes": [
                {**rows_json(I.value), "units": units}
                for I, units in zip(self, counts, strict=True)
            ],
        }

    def text_for(self, system: str) -> str:
        """Return the representatives as a list of right ideals in the code of another system.

        ``A.read(text)`` returns the list. Raises as :meth:`Lattice.text_for` does.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra(11).maximal_order().class_set()
        >>> C.order.algebra.read(C.text_for("sage")) == list(C)
        True
        """
        ideals = [I.value for I in self]
        return foreign_writing.ideals_text(ideals, self.order.value, "right", system)

    # --- stable classes, newforms ----------------------------------------------------------------------

    def _stable_class(self, n: int) -> tuple[int, int]:
        stable = self.order._stable
        values = (self._classes.local_norm(n, place.prime) for place in stable.places)
        return self._classes.norms[n].number, stable.reduced(values)

    @cached_property
    def _modules(self) -> dict[int, Module]:
        """The modules of :meth:`_functions`, by weight."""
        return {}

    def _functions(self, weight: int) -> Module:
        """Return the module of functions on the classes with its Hecke operators, for an even weight."""
        if weight not in self._modules:
            make = self._classes_of_level
            self._modules[weight] = (
                ClassFunctions(self._classes, make)
                if weight == 2
                else WeightedFunctions(self._classes, make, weight)
            )
        return self._modules[weight]

    @cached_property
    def _classes_of_level(self) -> Callable[[BaseIdeal], Classes]:
        """The classes of Eichler orders of the same algebra, by level."""
        return EichlerClasses(self.order.algebra)

    def rational_newforms(self, *, executor: Executor | None = None) -> list[RationalNewform]:
        """Return all newforms of weight 2 with rational eigenvalues; this works at large levels too.

        Each newform is a function on the classes, ``f.values``, with Atkin–Lehner signs ``f.signs``; ``f[P]``
        takes N(P) + 1 look-ups. The time is quadratic in the number of classes and the memory linear: 8 000
        classes take two seconds. Only sparse rows of neighbours are read, which the executor computes. Raises
        :class:`LatticeError` unless the level is squarefree, and :class:`UndecidedError` if it is not proved
        that the list is complete; see :meth:`newforms` for other levels.

        >>> from hfield import QuaternionAlgebra
        >>> f, = QuaternionAlgebra(389).maximal_order().class_set().rational_newforms()
        >>> f, f.signs, f[101], sorted(set(f.values))
        (<newform a_2 = -2, a_3 = -2, a_5 = -3, a_7 = -5, a_11 = -4, …>, {389: -1}, -4, [-2, -1, 0, 1, 2])
        """
        from hfield.orders.rational_newforms import rational_newforms  # imports numpy

        return rational_newforms(self._classes, self._classes_of_level, executor)

    def latex(self) -> str:
        """Return the number of classes and the mass in LaTeX."""
        mass = rf"\frac{{{self.mass.numerator}}}{{{self.mass.denominator}}}"
        return rf"h = {len(self)},\quad \text{{mass}} = {mass},\quad {self.order.latex()}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    def __repr__(self) -> str:
        return f"{len(self)} right ideal classes, mass {self.mass}, of {self.order}"
