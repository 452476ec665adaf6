"""Class groups and narrow class groups of number fields, and whether an ideal is principal.

The class group is ℤ^S modulo the exponents of the proved S-units
(:mod:`hfield.fields.number_fields.classes.s_units`); their signs at the real places determine the narrow
group.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from hfield.errors import UndecidedError
from hfield.evidence import Certified, CertifiedClaim
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.abelian_groups import AbelianGroup
from hfield.fields.number_fields.classes.s_unit_basis import s_unit_basis
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import FractionalIdeal
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField


@dataclass(frozen=True, eq=False, repr=False)
class Principality(Verdict[FieldElement]):
    """Whether an ideal is principal; ``generator`` is a generator or None, ``evidence`` is JSON data."""

    evidence: dict[str, object] | None = None

    @property
    def generator(self) -> FieldElement | None:
        """A generator of the ideal, or None."""
        return self.witness


def is_principal(a: FractionalIdeal) -> Principality:
    """Return whether an ideal is principal, with a generator if it is, else with its class."""
    basis = s_unit_basis(a.ring)
    x = basis.principal(a)
    if x is not None:
        return Principality(True, "a generator is known", x, evidence={"kind": "generator"})
    classes = basis.classes.coordinates(basis.class_of(a)[1])
    found: dict[str, object]
    found = {"kind": "class", "invariants": basis.classes.invariants, "class": classes}
    return Principality(False, "its class is not 0 in the class group", evidence=found)


class ClassGroup(Certified):
    """The class group of a number field, or a narrow class group for some real places, proved without
    hypotheses.

    ``order``; ``invariants`` d₁ | d₂ | …; ``generators``, ideals of these orders; ``evidence``; and
    ``assumes``, which is empty.

    >>> from hfield import ring
    >>> K = ring("QQ(sqrt(-5))"); C = K.class_group()
    >>> C, C.order, C.class_of(K.ideal([2, 1 + K.gen])), C.assumes
    (ℤ/2, 2, (1,), ())
    """

    assumes: tuple[str, ...] = ()

    def __init__(self, ring: NumberField, signs: tuple[int, ...] = ()) -> None:
        self.ring, self.narrow, self._signs = ring, bool(signs), signs
        self._basis = s_unit_basis(ring)
        self.group = self._with_signs() if signs else self._basis.classes
        self.order, self.invariants = self.group.order, self.group.invariants

    def __len__(self) -> int:
        return self.order

    def __repr__(self) -> str:
        return " × ".join(f"ℤ/{d}" for d in self.invariants) or "the trivial group"

    def _with_signs(self) -> AbelianGroup:
        s, places = self._basis.s, len(self._signs)
        k = len(s.primes)
        rows = [[*row, *self._of_signs(x)] for row, x in zip(s.rows, s.generators, strict=True)]
        rows += [[0] * k + self._of_signs(-s.field.one)]
        rows += [[0] * k + [2 * int(i == j) for j in range(places)] for i in range(places)]
        return AbelianGroup(rows, k + places)

    def _of_signs(self, x: FieldElement) -> list[int]:
        return [int(self._basis.s.field.sign_at(x, k) < 0) for k in self._signs]

    def class_of(self, a: FractionalIdeal) -> tuple[int, ...]:
        """Return the class of an ideal as coordinates in the cyclic factors."""
        x, exponents = self._basis.class_of(a)
        return self.group.coordinates([*exponents, *self._of_signs(x)])

    def factors(self, a: FractionalIdeal) -> tuple[FieldElement, list[int]]:
        """Return x and exponents with a = x·∏Pᵉ, where P runs through the set S of :attr:`evidence`."""
        return self._basis.class_of(a)

    @cached_property
    def generators(self) -> tuple[FractionalIdeal, ...]:
        """Integral ideals whose classes generate the cyclic factors."""
        s = self._basis.s
        out = []
        for vector in self.group.generators:
            a = s.frame.one
            for k, e in zip(s.primes, vector, strict=False):
                a = self._smaller(a * s.frame.prime(s.base[k]) ** int(e))
            wanted = self.group.coordinates(vector)
            if self.class_of(a) != wanted:  # signs: times an element that has them
                a = self._with_class(a, wanted)
            out.append(a)
        return tuple(out)

    def _smaller(self, a: FractionalIdeal) -> FractionalIdeal:
        """Return an integral ideal of small norm in the class."""
        s = self._basis.s
        found = [a]
        for y in s.short(a.inverse(), 40):
            if all(s.field.sign_at(y, k) > 0 for k in self._signs):
                found.append(a * s.frame.principal(y))
        return min((b for b in found if b.is_integral()), key=lambda b: b.norm(), default=a)

    def _with_class(self, a: FractionalIdeal, wanted: tuple[int, ...]) -> FractionalIdeal:
        s = self._basis.s
        for y in s.short(a.inverse(), 4_000):
            b = a * s.frame.principal(y)
            if self.class_of(b) == wanted:
                return b
        raise UndecidedError("no small ideal was found in a narrow class")

    @cached_property
    def evidence(self) -> dict[str, object]:
        """The evidence as JSON data: reductions, generators of the S-units, and primes at which these are
        saturated.
        """
        return evidence.evidence(self._basis.s)

    @property
    def claim(self) -> CertifiedClaim:
        """The class group as a statement with its evidence; not available for a narrow class group."""
        if self.narrow:
            why = "narrow class groups are not certified: ask for class_group()"
            return CertifiedClaim("", "class-group", {}, "S-units", ring=self.ring, refusal=why)
        orders = ",".join(map(str, self.invariants or (1,)))
        return evidence.claim(self._basis.s, self.ring, f"class-group{{{orders}}}")


@lru_cache(maxsize=256)
def class_group(ring: NumberField, signs: tuple[int, ...] = ()) -> ClassGroup:
    """Return the group of ideals modulo principal ideals with a generator that is positive at some real
    places.
    """
    return ClassGroup(ring, signs)


def narrow_class_group(ring: NumberField) -> ClassGroup:
    """Return the group of ideals modulo those with a totally positive generator."""
    return class_group(ring, tuple(range(s_unit_basis(ring).s.field.signature[0])))
