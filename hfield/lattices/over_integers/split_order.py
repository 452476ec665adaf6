"""Orders over the integers of totally real fields that split at one real place, for their groups."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from flint import arb, ctx, fmpq

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, UndecidedError, shorten
from hfield.evidence import Claim
from hfield.fields.number_fields.classes.zeta import zeta_minus_one
from hfield.fuchsian.search import element_of_norm
from hfield.fuchsian.split_order import SplitOrder
from hfield.lattices.over_integers import certificates
from hfield.lattices.over_integers.equivalence import Comparison
from hfield.lattices.over_integers.local_orders import Local

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.lattices.over_integers.lattices import IntegersOrder


def element_generating(order: IntegersOrder, rows: Any, norm: Ideal) -> Comparison:
    """Return an element of a locally principal lattice whose norm generates an ideal, or why there is none.

    By Eichler's theorem there is one where the ideal has a generator that is positive at the real places that
    ramify (Voight, theorem 28.5.5). ``order`` is an order of the lattice, of Eichler's kind. Raises
    :class:`IndefiniteError`, and :class:`UndecidedError` where no such element was found.
    """
    split, frame = SplitIntegersOrder(order), order.frame
    generator = norm.is_principal().generator
    if generator is None:
        return Comparison(False, f"the norm would generate {norm}, which is not principal")
    group = order.algebra.ring.unit_group()
    units = [frame.field.one]
    for u in map(frame.integers.inside, (-1, *group.generators)):
        units += [u * v for v in units]
    norms = [frame.integers.inside(generator) * u for u in units]
    norms = [x for x in norms if all(value > 0 for value in split.elsewhere(x))]
    if not norms:
        return Comparison(
            False,
            f"the norm would be a generator of {norm} that is positive where the algebra ramifies",
        )
    basis = [frame.quaternion(row) for row in rows.tolist()]
    for x in norms:
        found = element_of_norm(split, basis, x)
        if found is not None:
            return Comparison(True, "the element is multiplied out", found)
    raise UndecidedError(f"no element whose norm generates {norm} was found in this lattice")


class SplitIntegersOrder(SplitOrder):
    """An order over the integers of a totally real field; exact numbers are those of ``order.field``.

    Raises :class:`IndefiniteError` unless there are only real places and one splits.
    """

    def __init__(self, order: IntegersOrder) -> None:
        self.order, self.algebra, self.basis = order, order.algebra, order.basis
        field, frame = order.field, order.frame
        real, n = field.real_places(), field.degree
        split = [v.index for v in frame.split_places]
        if not frame.is_fuchsian:
            complex_ones = (n - len(real)) // 2
            raise IndefiniteError(
                f"{shorten(self.algebra)} splits at {len(split)} of the {len(real)} real places"
                + (f" and the field has {complex_ones} complex ones" if complex_ones else "")
                + "; norm_one_group() asks for a totally real field and exactly one real place that splits"
            )
        self.place = split[0]
        self._others = [v.index for v in real if v.index != self.place]
        self._value = field.embeddings
        self.level = order.level
        self.title = "maximal order" if order.is_maximal() else f"order of level {self.level}"

    def __contains__(self, x: Quaternion) -> bool:
        return x in self.order

    def area(self) -> Fraction:
        """Return the area by Shimizu's formula and the local indices of units.

        These are divided by those of their norms (Voight, theorem 39.1.8 and lemma 26.6.7).
        """
        order, frame = self.order, self.order.frame
        found = abs(zeta_minus_one(self.algebra.ring)) * Fraction(4, 2**order.field.degree)
        found *= order.norm_of_discriminant()
        for place, _ in order.discriminant().factorisation():
            local = Local(frame, frame.prime(place))
            q, symbol = local.prime.norm, local.symbol(order.rows)
            found *= (1 - Fraction(1, q * q)) / (1 - Fraction(symbol, q))
            if symbol == 0:
                found /= local.norm_index(order.rows)
        return found

    def scalar(self, x: Any) -> FieldElement:
        return self.order.frame.integers.inside(x)

    def sign(self, x: FieldElement) -> int:
        return self.order.field.sign(x, self.place)

    def real(self, x: FieldElement) -> float:
        return self._near(x, self.place)

    def elsewhere(self, x: FieldElement) -> list[float]:
        return [self._near(x, place) for place in self._others]

    def _near(self, x: FieldElement, place: int) -> float:
        return float(self._value.close(x.poly, place, 15).real.mid()) if x else 0.0

    def ball(self, x: FieldElement) -> arb:
        return self._value.value(x.poly, self.place, ctx.prec).real

    def flat(self, q: Quaternion) -> list[fmpq]:
        found: list[fmpq] = self.order.frame.row(q).entries()
        return found

    def written(self, g: Quaternion) -> dict[str, Any]:
        frame = self.order.frame
        return certificates.element_json(frame, frame.row(g))

    def claim(self, word: str, parts: list[str], shown: dict[str, Any], *cited: str) -> Claim:
        return certificates.of_units(self.order, word, parts, shown, *cited)
