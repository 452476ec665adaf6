"""Masses, class numbers and stable classes: what is known of the classes where nothing is enumerated.

The mass is ``Σ 1/[O_L(I)^× : ±1]`` over the ideal classes (Voight, *Quaternion Algebras*, theorem 26.1.5),
and Eichler's class number formula adds to it what orders with more units than ±1 take away (30.1.5).

Right ideals I and J of a definite order are in one stable class where I ⊕ O ≅ J ⊕ O. These are the classes of
norms of local generators in K^×₊ \\ Â^× / N(Ô^×): narrow classes of ideals, and at primes a class of local
units modulo norms (A. Fröhlich, *J. reine angew. Math.* 274, 1975; D. Smertnig and J. Voight, *Trans. London
Math. Soc.* 6, 2019, section 2). Squares of local units are norms, so the classes of local units are computed
by linear algebra over GF(2). Where the Eichler symbol is not 0, every local unit is a norm.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from hfield.core.factorisation import factorise
from hfield.errors import LatticeError
from hfield.orders.base_values import Prime, Scalar
from hfield.orders.invariants import eichler_symbol, level
from hfield.orders.lattice_values import LatticeValue, discriminant
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.orders.short_elements import expect_definite
from hfield.orders.validation import expect_coprime


def eichler_mass(discriminant: int, level: int) -> Fraction:
    """Return the mass of an Eichler order: φ(D)·ψ(N)/12."""
    mass = Fraction(1, 12)
    for p in factorise(discriminant):
        mass *= p - 1
    for p, e in factorise(level).items():
        mass *= p ** (e - 1) * (p + 1)
    return mass


def mass(order: LatticeValue) -> Fraction:
    """Return Σ 1/[O_L(I)ˣ : Rˣ] over the invertible right ideal classes, R being the integers of the base.

    It is 2^(1−n)·|ζ_K(−1)|·h_K·N(discrd)·Π λ(O, P), λ from Eichler symbols (Voight, 26.1.5). Raises
    :class:`IndefiniteError`, :class:`TooLargeError`.
    """
    base, whole = order.ambient.base, discriminant(order)
    expect_definite(order.ambient, "the mass of ideal classes")
    found = base.mass_factor * base.absolute_norm(whole)
    for P, _ in base.factorisation(whole):
        norm = base.absolute_norm(base.prime_ideal(P))
        found *= local_factor(eichler_symbol(order, P), norm)
    return found


def local_factor(symbol: int | None, p: int) -> Fraction:
    """Return the local factor λ of the mass formula, from the Eichler symbol and the number p of residues."""
    return {1: 1 + Fraction(1, p), -1: 1 - Fraction(1, p), 0: 1 - Fraction(1, p * p)}[symbol or 0]


def class_number(discriminant: int, level: int) -> int:
    """Return the number of right ideal classes of an Eichler order of a definite algebra.

    Raises :class:`LatticeError` for a discriminant that is no product of an odd number of primes, or
    a level that is not prime to it.
    """
    primes = factorise(discriminant)
    powers = factorise(level)
    if any(e > 1 for e in primes.values()) or len(primes) % 2 == 0:
        raise LatticeError(
            f"{discriminant} is not the discriminant of a definite algebra over QQ: expected a product of "
            "an odd number of different primes"
        )
    expect_coprime(level, discriminant)
    total = eichler_mass(discriminant, level)
    # elements of order 4 and of order 3 (or 6): the optimal embeddings of ℤ[i] and of ℤ[ω]
    for d, weight in ((-4, Fraction(1, 4)), (-3, Fraction(1, 3))):
        for p in primes:
            weight *= 1 - kronecker(d, p)
        for p, e in powers.items():
            weight *= _roots(d, p, e)
        total += weight
    if total.denominator != 1:
        raise AssertionError("Eichler's formula gives an integer")
    return total.numerator


def by_formula(order: LatticeValue) -> int | None:
    """Return the number of right ideal classes of a definite Eichler order, by Eichler's formula over ℤ.

    It is None over other bases, where the formula needs class numbers of quadratic extensions.
    """
    base = order.ambient.base
    if not base.is_rational:
        return None
    return class_number(order.ambient.discriminant, base.absolute_norm(level(order)))


def _roots(d: int, p: int, e: int) -> int:
    """Return the number of local optimal embeddings of the maximal order of discriminant d at level pᵉ."""
    if d % p:
        return 1 + kronecker(d, p)
    return 1 if e == 1 else 0


# --- stable classes --------------------------------------------------------------------------------


@dataclass(frozen=True)
class LocalNorms:
    """Norms of local units at one prime: classes modulo squares are numbers of ``size`` binary digits."""

    prime: Prime
    size: int
    square_class: Callable[[Scalar], int]
    """The class of the unit part of a number, for a fixed uniformiser."""
    norms: tuple[int, ...]
    """Classes that generate those of the norms."""


class StableClasses:
    """The stable classes, ``number`` of them, of an order over ℤ_K with ``ideals`` narrow classes of ideals.

    ``units`` generate the totally positive units modulo squares.
    """

    def __init__(self, places: Sequence[LocalNorms], units: Iterable[Scalar], ideals: int) -> None:
        self.places = places
        self._basis: list[int] = []  # leading digits differ, and fall
        size = 0
        for place in places:
            for norm in place.norms:
                self._add(norm << size)
            size += place.size
        for u in units:
            self._add(self.reduced([u] * len(places)))
        self.number = ideals << (size - len(self._basis))

    def _add(self, vector: int) -> None:
        vector = self._without(vector)
        if vector:
            self._basis = sorted([*self._basis, vector], reverse=True)

    def _without(self, vector: int) -> int:
        for b in self._basis:
            vector = min(vector, vector ^ b)
        return vector

    def reduced(self, values: Iterable[Scalar]) -> int:
        """Return the class of numbers, one a place, modulo the norms of local units and all units."""
        vector = size = 0
        for place, x in zip(self.places, values, strict=True):
            vector |= place.square_class(x) << size
            size += place.size
        return self._without(vector)


# --- stable class numbers ------------------------------------------------------------------------------


class WithStableClasses:
    """Stable classes, of an order."""

    mass: Callable[[], Fraction]
    unit_index: Callable[[], int]

    @property
    @abstractmethod
    def _stable(self) -> StableClasses:
        """The stable classes, by local norms."""

    def stable_class_number(self) -> int:
        """Return how many right ideal classes there are up to I ⊕ O ≅ J ⊕ O. Raises :class:`IndefiniteError`.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(6))", -1, -1).maximal_order()
        >>> O.stable_class_number(), O.is_hermite()
        (2, False)
        >>> O = QuaternionAlgebra("QQ", -1, -1).order(["i", "2*j"])
        >>> O.stable_class_number(), O.is_hermite()
        (2, True)
        """
        self.mass()
        return self._stable.number

    def is_hermite(self) -> bool:
        """Tell whether each right ideal with I ⊕ O ≅ O ⊕ O is principal: whether stably free is free.

        All stable classes have the same mass, and in a Hermite order that of O is one class. Raises likewise.
        """
        whole = self.mass() * self.unit_index()
        return whole.denominator == 1 and whole == self.stable_class_number()


class ByStableClasses:
    """Stable classes, of a class set."""

    order: WithStableClasses
    __len__: Callable[[], int]
    _stable_class: Callable[[int], Hashable]

    def stable_classes(self) -> list[int]:
        """Return for each class of I the number of its stable class, that of all J with I ⊕ O ≅ J ⊕ O.

        >>> from hfield import QuaternionAlgebra
        >>> C = QuaternionAlgebra("QQ(sqrt(6))", -1, -1).maximal_order().class_set()
        >>> C.stable_classes(), C.has_cancellation()
        ([0, 1, 0], False)
        """
        numbers: dict[Hashable, int] = {}
        kinds = map(self._stable_class, range(len(self)))
        return [numbers.setdefault(kind, len(numbers)) for kind in kinds]

    def has_cancellation(self) -> bool:
        """Tell whether I ⊕ O ≅ J ⊕ O only where I ≅ J, for all right ideals."""
        return len(self) == self.order.stable_class_number()
