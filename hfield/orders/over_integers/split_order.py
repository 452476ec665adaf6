"""Orders over the integers of totally real fields that split at one real place, for their groups."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import arb, ctx, fmpq, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, LatticeError, TooLargeError, UndecidedError, shorten
from hfield.evidence import Claim
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.number_fields.classes.zeta import zeta_minus_one
from hfield.fuchsian.search import Sight, element_of_norm, first_plane, reduction
from hfield.fuchsian.split_order import SplitOrder, TwoSided
from hfield.orders.lattice_values import LatticeValue, multiple, scalars_into
from hfield.orders.over_integers import certificates
from hfield.orders.over_integers.elliptic_points import elliptic_points
from hfield.orders.over_integers.equivalence import Comparison
from hfield.orders.over_integers.local_orders import Local
from hfield.orders.over_integers.positive_generators import (
    totally_positive_generator,
    units_modulo_squares,
)

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal

MOST_IDEALS = 10_000
"""Products of a class of ideals and of two-sided primes, at most."""
SCALES = 20
"""So many numbers are looked at to find one of small norm in an ideal."""


def element_generating(order: Any, lattice: LatticeValue, norm: Ideal) -> Comparison:
    """Return an element of a locally principal lattice whose norm generates an ideal, or why there is none.

    By Eichler's theorem there is one where the ideal has a generator that is positive at the real places that
    ramify (Voight, theorem 28.5.5). ``order`` is an order of the lattice, of Eichler's kind. Raises
    :class:`IndefiniteError`, and :class:`UndecidedError` where no such element was found.
    """
    split, ambient = SplitIntegersOrder(order), order.value.ambient
    generator = norm.is_principal().generator
    if generator is None:
        return Comparison(False, f"the norm would generate {norm}, which is not principal")
    group = ambient.base.ring.unit_group()
    units = [ambient.base.field.one]
    for u in map(ambient.base.inside, (-1, *group.generators)):
        units += [u * v for v in units]
    norms = [ambient.base.inside(generator) * u for u in units]
    norms = [x for x in norms if all(value > 0 for value in split.elsewhere(x))]
    if not norms:
        return Comparison(
            False,
            f"the norm would be a generator of {norm} that is positive where the algebra ramifies",
        )
    basis = list(lattice.basis)
    for x in norms:
        found = element_of_norm(split, basis, x)
        if found is not None:
            return Comparison(True, "the element is multiplied out", found)
    raise UndecidedError(f"no element whose norm generates {norm} was found in this lattice")


class TwoSidedIdeals:
    """The invertible two-sided ideals of an Eichler order: 𝔞·∏J_P, 𝔞 of the field, P over the discriminant.

    J_P² = Pᵉ·O. Sets of primes are numbers: bit k is the k-th prime of the discriminant. Modulo numbers
    and units of norm 1, elements that normalise the order are known by such an ideal and a generator of
    its norm.
    """

    def __init__(self, order: Any) -> None:
        if not order.is_eichler():
            raise LatticeError("the normaliser is known here for Eichler orders, and this is none")
        self.order, self._whole = order, order.discriminant()
        self.primes = [P for P, _ in self._whole.factorisation()]
        base, group = order.value.ambient.base, order.value.ambient.base.ring.class_group()
        self.powers = [
            P**e
            for P, e in self._whole.factorisation()
            for P in [order.value.ambient.base.ideal(P)]
        ]
        if group.order << len(self.primes) > MOST_IDEALS:
            raise TooLargeError(
                f"the field has {group.order} classes of ideals and the discriminant {len(self.primes)} "
                f"prime ideals: products up to {MOST_IDEALS} are looked at"
            )
        self.classes = [base.one]
        for a, d in zip(group.generators, group.invariants, strict=True):
            self.classes = [a**k * b for k in range(d) for b in self.classes]

    def norm(self, chosen: int) -> Ideal:
        """Return the norm of a product of J_P."""
        some = (p for k, p in enumerate(self.powers) if chosen >> k & 1)
        found: Ideal = prod(some, start=self.order.value.ambient.base.one)
        return found

    def primes_of(self, norm: object) -> int:
        """Return the set of primes with a norm. Raises :class:`LatticeError` where there is none."""
        ideal = self.order.value.ambient.base.ideal(norm)
        chosen = sum(1 << k for k, P in enumerate(self.primes) if ideal.valuation(P) > 0)
        if self.norm(chosen) != ideal:
            raise LatticeError(
                f"{ideal} is no exact divisor of {self._whole}, the discriminant of the order: "
                "an involution belongs to a divisor that is coprime to its cofactor"
            )
        return chosen

    def generated(self, chosen: int) -> list[TwoSided]:
        """Return the 𝔞·∏J_P of a set, one for each class of 𝔞, whose norm has a totally positive generator.

        With the generator. Of the empty set O is the first.
        """
        norm = self.norm(chosen)
        found: list[TwoSided] = []
        for a in self.classes:
            generator = totally_positive_generator(a * a * norm)
            if generator is not None:
                some = [P for k, P in enumerate(self.primes) if chosen >> k & 1]
                factors = map(self.order.two_sided_prime, some)
                found.append((prod(factors, start=self.order * a).basis, generator))
        return found


class SplitIntegersOrder(SplitOrder):
    """An order over the integers of a totally real field; exact numbers are those of ``order.field``.

    Raises :class:`IndefiniteError` unless there are only real places and one splits.
    """

    def __init__(self, order: Any) -> None:
        self.order, self.algebra = order, order.algebra
        ambient = order.value.ambient
        field = ambient.base.field
        real, n = field.real_places(), field.degree
        split = [v.index for v in ambient.split_places]
        if not ambient.is_fuchsian:
            complex_ones = (n - len(real)) // 2
            raise IndefiniteError(
                f"{shorten(self.algebra)} splits at {len(split)} of the {len(real)} real places"
                + (f" and the field has {complex_ones} complex ones" if complex_ones else "")
                + "; norm_one_group() asks for a totally real field and exactly one real place that splits"
            )
        self.degree, self.place = n, split[0]
        self._others = [v.index for v in real if v.index != self.place]
        self._value = field.embeddings
        self.level = order.level
        self.title = "maximal order" if order.is_maximal() else f"order of level {self.level}"

    @cached_property
    def basis(self) -> tuple[Quaternion, ...]:  # type: ignore[override]
        """A basis over ℤ that looks short from a point, so that products have small coordinates."""
        sight = Sight(first_plane(self), self.order.basis)
        steps = reduction(sight.forms(np.zeros(1), 1.0)[0]).tolist()
        value: LatticeValue = self.order.value
        return value.elements(fmpz_mat(steps) * value.matrix)

    def __contains__(self, x: Quaternion) -> bool:
        return x in self.order

    def area(self) -> Fraction:
        """Return the area by Shimizu's formula and the local indices of units.

        These are divided by those of their norms (Voight, theorem 39.1.8 and lemma 26.6.7).
        """
        order, ambient = self.order.value, self.order.value.ambient
        found: Fraction = abs(zeta_minus_one(self.algebra.ring)) * Fraction(4, 2**self.degree)
        found *= self.order.norm_of_discriminant()
        for place, _ in self.order.discriminant().factorisation():
            local = Local(ambient, ambient.base.prime(place))
            q, symbol = local.prime.norm(), self.order.eichler_symbol(place) or 0
            found *= (1 - Fraction(1, q * q)) / (1 - Fraction(symbol, q))
            if symbol == 0:
                found /= local.norm_index(order)
        return found

    def elliptic_points(self) -> dict[int, int] | None:
        # over the field of degree 1 the algebra may be split
        return elliptic_points(self.order) if self.degree > 1 else None

    def scalar(self, x: Any) -> FieldElement:
        found: FieldElement = self.order.value.ambient.base.inside(x)
        return found

    def sign(self, x: FieldElement) -> int:
        return int(self.order.value.ambient.base.field.sign_at(x, self.place))

    def real(self, x: FieldElement) -> float:
        return self._near(x, self.place)

    def elsewhere(self, x: FieldElement) -> list[float]:
        return [self._near(x, place) for place in self._others]

    def _near(self, x: FieldElement, place: int) -> float:
        return float(self._value.close(x.poly, place, 15).real.mid()) if x else 0.0

    def ball(self, x: FieldElement) -> arb:
        return self._value.value(x.poly, self.place, ctx.prec).real

    def root(self, x: FieldElement) -> Any:
        found = x.sqrt()
        return None if found is None else self.order.value.ambient.base.outside(found)

    def primitive(self, x: Quaternion) -> Quaternion:
        order, ambient = self.order.value, self.order.value.ambient
        into = scalars_into(multiple(order, x, "left"), order)
        scales = s_units(self.algebra.ring).short(into, SCALES)
        norm = self.scalar(x.norm())
        scale = min(scales, key=lambda c: (abs(c.norm()), (c * c * norm).trace()))
        found: Quaternion = x * ambient.base.outside(scale)
        return found

    def normalising(self, norms: Sequence[object]) -> list[TwoSided]:
        """Return O with units, 𝔞·O for ideals 𝔞 of the field, and what the norms, or all, need."""
        ideals = TwoSidedIdeals(self.order)
        chosen = [ideals.primes_of(m) for m in norms]
        units = units_modulo_squares(self.algebra.ring)  # each bit of a number is a generator
        found: list[TwoSided] = [
            (self.basis, units[1 << k]) for k in range(len(units).bit_length() - 1)
        ]
        found += ideals.generated(0)[1:]
        reached = [0]
        for primes in chosen or range(1 << len(ideals.powers)):
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

    def flat(self, q: Quaternion) -> list[fmpq]:
        found: list[fmpq] = self.order.value.ambient.row(q).entries()
        return found

    def written(self, g: Quaternion) -> dict[str, Any]:
        ambient = self.order.value.ambient
        return certificates.element_json(ambient, ambient.row(g))

    def claim(self, word: str, parts: list[str], shown: dict[str, Any], *cited: str) -> Claim:
        return certificates.of_units(self.order, word, parts, shown, *cited)
