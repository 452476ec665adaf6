"""Unit groups of number fields: fundamental units, torsion, regulator, and the totally positive units.

The units are the proved S-units whose exponents are 0 (:mod:`hfield.fields.number_fields.classes.s_units`).
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import flint

from hfield.evidence import Certified, CertifiedClaim
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.s_unit_basis import s_unit_basis

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ring import NumberField


class UnitGroup(Certified):
    """The units of a number field: ``generators`` of the free part, ``rank``, ``torsion``, ``regulator``.

    >>> from hfield import ring
    >>> U = ring("QQ(sqrt(2))").unit_group()
    >>> U.rank, [abs(u.norm()) for u in ring("QQ[s]/(s^3-2)").unit_group().generators], U.torsion_order
    (1, [1], 2)
    """

    assumes: tuple[str, ...] = ()

    def __init__(self, ring: NumberField) -> None:
        self.ring, self._basis = ring, s_unit_basis(ring)
        s = self._basis.s
        self.rank, self.torsion_order = s.rank, s.order_of_torsion
        self.torsion = s.torsion
        self.generators = tuple(self._basis.units)

    def __repr__(self) -> str:
        free = f" × ℤ^{self.rank}" if self.rank else ""
        return f"ℤ/{self.torsion_order}{free}"

    @cached_property
    def regulator(self) -> flint.arb:
        """A ball of flint that contains the regulator; 1 if the rank is 0."""
        return self._basis.s.covolume(self._basis.units, [[] for _ in self._basis.units])

    @cached_property
    def totally_positive(self) -> tuple[FieldElement, ...]:
        """Generators of the group of totally positive units; without real places, those of the free part."""
        s = self._basis.s
        real = s.field.signature[0]
        if not real:
            return self.generators
        every = [-s.field.one, *self._basis.units]
        signs = [[int(s.field.sign_at(u, k) < 0) for k in range(real)] for u in every]
        count = len(every)
        whole = [[*row, *(int(i == j) for j in range(count))] for i, row in enumerate(signs)]
        whole += [[2 * int(i == j) for j in range(real)] + [0] * count for i in range(real)]
        reduced = flint.fmpz_mat(whole).hnf().tolist()[real:]
        # exponents of −1 count modulo 2
        vectors = [[int(c) for c in row[real + 1 :]] for row in reduced]
        vectors = (
            [v for v in flint.fmpz_mat(vectors).lll().tolist() if any(v)] if vectors[0] else []
        )
        out = []
        for v in vectors:
            u = s.product(self._basis.units, list(map(int, v)))
            out.append(u if s.field.sign_at(u, 0) > 0 else -u)
        return tuple(out)

    @cached_property
    def evidence(self) -> dict[str, object]:
        """The evidence, as for the class group."""
        return evidence.evidence(self._basis.s)

    @property
    def claim(self) -> CertifiedClaim:
        """The units as a statement with its evidence."""
        texts = [str(self.torsion_order), *map(self.ring.text, self.generators)]
        return evidence.claim(self._basis.s, self.ring, f"unit-group{{{'; '.join(texts)}}}")


@lru_cache(maxsize=256)
def unit_group(ring: NumberField) -> UnitGroup:
    """Return the unit group."""
    return UnitGroup(ring)
