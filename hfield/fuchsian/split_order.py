"""An order together with the real place at which its algebra splits."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import prod

from flint import arb, fmpq, fmpq_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, LatticeError, TooLargeError, shorten
from hfield.evidence import CertifiedClaim
from hfield.fuchsian import area
from hfield.orders import certificates
from hfield.orders.base_values import BaseIdeal, BaseNumber
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.invariants import is_eichler, level
from hfield.orders.lattice_values import (
    LatticeValue,
    contains,
    discriminant,
    multiple,
    product,
    scalars_into,
    times_ideal,
)
from hfield.orders.validation import expect_number_field

MAX_IDEALS = 10_000
"""Products of a class of ideals and of two-sided primes, at most."""
SCALES = 20
"""So many numbers are looked at to find one of small norm in an ideal."""
TwoSided = tuple[Sequence[Quaternion], BaseNumber]
"""A basis over ℤ of a two-sided ideal, and an exact number that generates its norm."""


class SplitOrder:
    """An order in an algebra that splits at exactly one infinite place, which is real.

    Exact numbers are elements of ``base.field``. The methods give their values at the split place, and
    coordinates with respect to ``basis``, a basis of the order over ℤ. Raises :class:`IndefiniteError` for
    other algebras.
    """

    def __init__(self, order: LatticeValue, basis: Sequence[Quaternion] | None = None) -> None:
        ambient = order.ambient
        _expect_one_split_place(order)
        self.order, self.algebra, self.base = order, order.algebra, ambient.base
        self.basis = order.basis if basis is None else tuple(basis)
        self.degree, (self.place,) = ambient.degree, ambient.split_places
        self.level = level(order)
        shown = self.base.shown_index(self.level)
        self.title = "maximal order" if self.level == 1 else f"order of level {shown}"

    def __str__(self) -> str:
        article = "an" if self.title[0] in "aeio" else "a"
        return f"{article} {self.title} in {self.algebra}"

    def __contains__(self, x: Quaternion) -> bool:
        """Return whether an element of the algebra lies in the order."""
        return contains(self.order, x)

    # --- formulas ----------------------------------------------------------------------------------

    def area(self) -> Fraction:
        """Return the area of the plane modulo the units of norm 1, in units of 2π."""
        return area.area(self.order)

    def elliptic_points(self) -> dict[int, int] | None:
        """Return the number of elliptic points of each order, if a formula gives it."""
        return area.elliptic_points(self.order)

    def cusps(self) -> int | None:
        """Return the number of cusps, if a formula gives it."""
        return area.cusps(self.order)

    # --- numbers -----------------------------------------------------------------------------------

    def scalar(self, x: object) -> BaseNumber:
        """Return a number of the base ring as an exact number."""
        return self.base.inside(x)

    def sign(self, x: BaseNumber) -> int:
        """Return the sign of an exact number at the split place: −1, 0 or 1."""
        return self.base.sign(x, self.place)

    def real(self, x: BaseNumber) -> float:
        """Return the approximate value of an exact number at the split place."""
        return self.base.real(x, self.place)

    def ball(self, x: BaseNumber) -> arb:
        """Return a ball around the value, with flint's current precision."""
        return self.base.ball(x, self.place)

    def values_at_other_places(self, x: BaseNumber) -> list[float]:
        """Return approximate values at the other real places, where the norm is definite."""
        return [self.base.real(x, v) for v in self.base.real_places if v != self.place]

    def root(self, x: BaseNumber) -> BaseNumber | None:
        """Return a square root of an exact number, as an element of the base ring, or None."""
        return self.base.square_root(x)

    # --- elements ----------------------------------------------------------------------------------

    def primitive(self, x: Quaternion) -> Quaternion:
        """Return the primitive scalar multiple in the order."""
        into = scalars_into(multiple(self.order, x, "left"), self.order)
        scales, base = self.base.short_elements(into, SCALES), self.base
        norm = self.scalar(x.norm())

        def size(c: BaseNumber) -> tuple[int, fmpq]:
            return base.absolute_norm(base.principal(c) / into), base.trace(c * c * norm)

        found: Quaternion = x * base.outside(min(scales, key=size))
        return found

    @cached_property
    def _inverse(self) -> fmpq_mat:
        """The matrix that changes ambient coordinates to coordinates with respect to ``basis``."""
        return self.order.ambient.rows(self.basis).inv()

    def rows(self, elements: list[Quaternion]) -> list[list[int]]:
        """Return the coordinates of elements of the order with respect to the basis."""
        found = self.order.ambient.rows(elements) * self._inverse
        return [[int(c.p) for c in row] for row in found.tolist()]

    @cached_property
    def bars(self) -> list[list[int]]:
        """The conjugates of the basis."""
        return self.rows([x.conjugate() for x in self.basis])

    @cached_property
    def products(self) -> list[list[int]]:
        """The products of all pairs of basis elements, row after row."""
        return self.rows([x * y for x in self.basis for y in self.basis])

    def traces_at_other_places(self, basis: tuple[Quaternion, ...]) -> list[list[float]]:
        """Return approximate values of tr(x·conj(y)) at the other real places, for all x and y of a basis."""
        bars = [x.conjugate() for x in basis]
        return [
            self.values_at_other_places(self.scalar((x * y).trace())) for x in basis for y in bars
        ]

    def element(self, row: list[int]) -> Quaternion:
        """Return the element with these coordinates with respect to the basis."""
        terms = [x * c for x, c in zip(self.basis, row, strict=True) if c]
        return sum(terms, self.algebra(0))

    # --- the normaliser, and certificates ----------------------------------------------------------

    def normalising(self, norms: Sequence[object]) -> list[TwoSided]:
        """Return two-sided ideals with norms; their generators give the normalising elements of positive
        norm.

        Positive means totally positive. With scalars and units of norm 1 the generators generate all such
        elements, or those of the given norms. The ideals are O with units as norms, 𝔞·O for ideals 𝔞 of the
        field, and one for each set of primes that is needed. Raises :class:`LatticeError`, and
        :class:`TooLargeError`.
        """
        ideals = TwoSidedIdeals(self.order)
        chosen = [ideals.primes_of(m) for m in norms]
        units = self.base.positive_units
        # each bit of a number is a generator
        found: list[TwoSided] = [
            (self.basis, units[1 << k]) for k in range(len(units).bit_length() - 1)
        ]
        found += ideals.generated(0)[1:]
        reached = [0]
        for primes in chosen or range(1 << len(ideals.primes)):
            if primes in reached:
                continue
            some = ideals.generated(primes)[:1]
            if some:
                reached += [primes ^ other for other in reached]
            elif chosen:
                raise LatticeError(
                    f"no element of totally positive norm generates a two-sided ideal of norm "
                    f"{ideals.norm(primes)}, not even times an ideal of the field"
                )
            found += some
        return found

    def written(self, g: Quaternion) -> object:
        """Return an element in the notation of evidence."""
        return certificates.element_json(self.order.ambient, g)

    def claim(
        self, word: str, parts: list[str], shown: dict[str, object], *cited: str
    ) -> CertifiedClaim:
        """Return a statement about the order that begins with ``word``, with its evidence."""
        return certificates.of_units(self.order, word, parts, shown, *cited)


def _expect_one_split_place(order: LatticeValue) -> None:
    """Raise :class:`IndefiniteError` unless the field is totally real and exactly one real place splits."""
    ambient, base = order.ambient, order.ambient.base
    error = IndefiniteError(
        f"units of an order in {shorten(order.algebra)} are not motions of the hyperbolic plane: "
        "norm_one_group() is for orders over ℤ and the integers of totally real fields"
    )
    expect_number_field(base, error)
    if ambient.definite:
        raise IndefiniteError(
            f"{order.algebra} is definite, so an order has finitely many units modulo numbers, and units() "
            "lists them: norm_one_group() needs an algebra that splits at exactly one real place"
        )
    if not ambient.is_fuchsian:
        real = len(base.real_places)
        complex_ones = (base.degree - real) // 2
        raise IndefiniteError(
            f"{shorten(order.algebra)} splits at {len(ambient.split_places)} of the {real} real places"
            + (f" and the field has {complex_ones} complex ones" if complex_ones else "")
            + "; norm_one_group() needs a totally real field and exactly one split real place"
        )


class TwoSidedIdeals:
    """The invertible two-sided ideals of an Eichler order: 𝔞·∏J_P with 𝔞 an ideal of the field, P |
    discriminant.

    J_P² = Pᵉ·O. A set of primes is an integer: bit k stands for the k-th prime of the discriminant. Modulo
    scalars and units of norm 1, a normalising element is determined by such an ideal and a generator of its
    norm.
    """

    def __init__(self, order: LatticeValue) -> None:
        if not is_eichler(order):
            raise LatticeError(
                "the normaliser is computed for Eichler orders only, and this order is not one"
            )
        self.order, self.base, self._whole = order, order.ambient.base, discriminant(order)
        factors = self.base.factorisation(self._whole)
        self.primes = [P for P, _ in factors]
        self.powers = [self.base.prime_ideal(P) ** e for P, e in factors]
        self.classes = self.base.ideal_classes(MAX_IDEALS)
        if len(self.classes) << len(self.primes) > MAX_IDEALS:
            raise TooLargeError(
                f"the field has {len(self.classes)} classes of ideals and the discriminant "
                f"{len(self.primes)} prime ideals: at most {MAX_IDEALS} products are examined"
            )

    def norm(self, chosen: int) -> BaseIdeal:
        """Return the norm of the product of the J_P of a set."""
        some = (p for k, p in enumerate(self.powers) if chosen >> k & 1)
        return prod(some, start=self.base.one)

    def primes_of(self, norm: object) -> int:
        """Return the set of primes with a given norm. Raises :class:`LatticeError` if there is none."""
        ideal = self.base.integral_ideal(norm)
        chosen = sum(1 << k for k, P in enumerate(self.primes) if self.base.valuation(ideal, P) > 0)
        if self.norm(chosen) != ideal:
            raise LatticeError(
                f"{ideal} is not an exact divisor of {self._whole}, the discriminant of the order: an "
                "involution belongs to a divisor that is coprime to its cofactor"
            )
        return chosen

    def generated(self, chosen: int) -> list[TwoSided]:
        """Return, for a set and each class of 𝔞, an ideal 𝔞·∏J_P whose norm has a totally positive generator.

        The generator is returned as well. For the empty set, O comes first.
        """
        norm = self.norm(chosen)
        found: list[TwoSided] = []
        for a in self.classes:
            for generator in self.base.generators(a * a * norm, self.base.real_places)[:1]:
                ideal = times_ideal(self.order, a)
                for k, P in enumerate(self.primes):
                    if chosen >> k & 1:
                        ideal = product(ideal, two_sided_prime(self.order, P))
                found.append((ideal.basis, generator))
        return found
