"""Class groups, narrow class groups and unit groups of number fields, and whether an ideal is principal.

All is read off the proved S-units (:mod:`hfield.fields.number_fields.classes.s_units`): the class group is
ℤ^S modulo their exponents, the units are the S-units with exponents 0; signs at the real places make the
narrow group.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import flint

from hfield.errors import UndecidedError
from hfield.evidence import Certified, CertifiedClaim
from hfield.fields.base.balls import precision
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.s_units import SUnits, logarithms, s_units
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import FractionalIdeal
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    from hfield.fields.number_fields.ring import NumberField


@dataclass(frozen=True, eq=False, repr=False)
class Principality(Verdict[FieldElement]):
    """Whether an ideal is principal: ``generator`` if so, else None; ``evidence`` as data."""

    evidence: dict[str, object] | None = None

    @property
    def generator(self) -> FieldElement | None:
        """A generator of the ideal, or None."""
        return self.witness


class AbelianGroup:
    """ℤᵏ modulo the rows of a matrix of full rank, as a product of cyclic groups."""

    def __init__(self, rows: Sequence[Sequence[int]], k: int) -> None:
        self.k = k
        diagonal, self._into, self._outof = _smith([list(map(int, r)) for r in rows], k)
        self._at = [i for i, d in enumerate(diagonal) if d != 1]
        self.invariants = tuple(diagonal[i] for i in self._at)
        self.order = math.prod(self.invariants)

    def coordinates(self, vector: Sequence[int]) -> tuple[int, ...]:
        """Return a vector in the cyclic factors."""
        out = [sum(vector[j] * self._into[j][i] for j in range(self.k)) for i in self._at]
        return tuple(c % d for c, d in zip(out, self.invariants, strict=True))

    @property
    def generators(self) -> list[list[int]]:
        """One vector for each cyclic factor."""
        return [self._outof[i] for i in self._at]


def _smith(m: list[list[int]], k: int) -> tuple[list[int], list[list[int]], list[list[int]]]:
    """Return d, V and V⁻¹ with U·M·V diagonal and d₁ | d₂ | …, M having k columns and rank k."""
    v = [[int(i == j) for j in range(k)] for i in range(k)]
    w = [[int(i == j) for j in range(k)] for i in range(k)]
    m = [list(map(int, row)) for row in flint.fmpz_mat(m).hnf().tolist()[:k]] if k else []

    def columns(i: int, j: int, q: int) -> None:
        """Subtract q times column i from column j."""
        for row in (*m, *v):
            row[j] -= q * row[i]
        w[i] = [a + q * b for a, b in zip(w[i], w[j], strict=True)]

    def swap(i: int, j: int) -> None:
        for row in (*m, *v):
            row[i], row[j] = row[j], row[i]
        w[i], w[j] = w[j], w[i]

    for t in range(k):
        while True:
            _, r, c = min((abs(m[r][c]), r, c) for r in range(t, k) for c in range(t, k) if m[r][c])
            m[t], m[r] = m[r], m[t]
            if c != t:
                swap(t, c)
            for r in range(t + 1, k):
                q = m[r][t] // m[t][t]
                m[r] = [a - q * b for a, b in zip(m[r], m[t], strict=True)]
            for c in range(t + 1, k):
                columns(t, c, m[t][c] // m[t][t])
            if any(m[r][t] for r in range(t + 1, k)) or any(m[t][t + 1 :]):
                continue
            bad = next(
                (r for r in range(t + 1, k) if any(x % m[t][t] for x in m[r][t + 1 :])), None
            )
            if bad is None:
                break
            m[t] = [a + b for a, b in zip(m[t], m[bad], strict=True)]
    return [abs(m[t][t]) for t in range(k)], v, w


class _Field:
    """The S-units of a field: units, and generators that are not units."""

    def __init__(self, ring: NumberField) -> None:
        self.s: SUnits = s_units(ring)
        s, self.ring = self.s, ring
        k = len(s.primes)
        count = len(s.rows)
        whole = [[*row, *(int(i == j) for j in range(count))] for i, row in enumerate(s.rows)]
        reduced = flint.fmpz_mat(whole).hnf().tolist() if whole else []
        self.rows = [list(map(int, row[:k])) for row in reduced[:k]]
        self._change = [list(map(int, row[k:])) for row in reduced]

    @cached_property
    def classes(self) -> AbelianGroup:
        """The exponents at the primes of S modulo those of S-units: the class group."""
        return AbelianGroup(self.s.rows, len(self.s.primes))

    @cached_property
    def units(self) -> list[FieldElement]:
        """Fundamental units, with short logarithms."""
        s = self.s
        vectors = self._change[len(s.primes) :]
        if not vectors:
            return []
        if s.reduced_ideals is not None:
            return s.generators[-1:]
        bits = 256 + 2 * max(abs(c).bit_length() for row in vectors for c in row)
        logs = [logarithms(s.frame, x, bits, s.rank) for x in s.generators]
        whole = []
        with precision(bits):
            scale = flint.arb(2) ** 64
            for row in vectors:
                sums = [
                    sum((log[j] * c for log, c in zip(logs, row, strict=True)), flint.arb(0))
                    for j in range(s.rank)
                ]
                whole.append([int((x.mid() * scale).floor().unique_fmpz()) for x in sums])
        change = flint.fmpz_mat(whole).lll(transform=True)[1]
        short = (change * flint.fmpz_mat(vectors)).tolist()
        return [s.product(s.generators, list(map(int, row))) for row in short]

    @cached_property
    def s_elements(self) -> list[FieldElement]:
        """Elements with the exponents ``rows``."""
        return [
            self.shortened(self.s.product(self.s.generators, c))
            for c in self._change[: len(self.rows)]
        ]

    def shortened(self, x: FieldElement) -> FieldElement:
        """Return x times a unit, with conjugates of about the same size."""
        s, units = self.s, self.units
        if not units:
            return x
        bits = 256
        logs = [logarithms(s.frame, u, bits) for u in units]
        its = logarithms(s.frame, x, bits)
        n, real = s.n, s.field.signature[0]
        with precision(bits):
            mean = sum(its, flint.arb(0)) / n
            excess = [v - mean * (1 if k < real else 2) for k, v in enumerate(its)][: s.rank]
            matrix = flint.arb_mat([row[: s.rank] for row in logs])
            found = (flint.arb_mat([excess]) * matrix.inv()).entries()
            turns = [_nearest(c) for c in found]
        return s.product([x, *units], [1, *(-t for t in turns)])

    def class_of(self, a: FractionalIdeal) -> tuple[FieldElement, list[int]]:
        """Return (x, e): a is x times the product of the primes in S with exponents e."""
        s = self.s
        if s.reduced_ideals is not None:
            located = s.reduced_ideals.class_of(a)
            assert located is not None, "the primes in S generate the class group"
            return located
        inverse = a.inverse()
        for turn in range(400):
            helper = inverse
            for _ in range(turn % 5 if turn else 0):
                if s.base:
                    helper = helper * s.frame.prime(
                        s.base[s.rng.randrange(min(len(s.base), 4 + turn))]
                    )
            for y in s.short(helper, 20):
                exponents = s.smooth_ideal(s.frame.principal(y) * a)
                if exponents is not None:
                    x, found = s.reduced(s.field.one, exponents)
                    # y·a = ∏Pᵉ = x⁻¹·∏_S
                    return (y * x).inverse(), found
        raise UndecidedError(f"no element was found that brings {a} into the base of primes")

    def principal(self, a: FractionalIdeal) -> FieldElement | None:
        """Return a generator of an ideal, or None if there is none."""
        s = self.s
        size = a.norm()
        if len(a.generators) == 1:
            return a.generators[0]
        for y in s.short(a, 60):
            if abs(y.norm()) == flint.fmpq(size.numerator, size.denominator):
                return y
        x, exponents = self.class_of(a)
        if any(self.classes.coordinates(exponents)):
            return None
        left = list(exponents)
        for k, row in enumerate(self.rows):  # upper triangular
            times = left[k] // row[k]
            if times:
                left = [c - times * d for c, d in zip(left, row, strict=True)]
                x = x * s.field.power(self.s_elements[k], times)
        x = self.shortened(x)
        assert s.frame.principal(x) == a, "a generator generates"
        return x


def _nearest(c: flint.arb) -> int:
    """Return an integer near the middle of a ball, which only makes a number shorter."""
    whole = (c.mid() + flint.arb("0.5")).mid().floor().unique_fmpz()
    return 0 if whole is None else int(whole)


@lru_cache(maxsize=256)
def _field(ring: NumberField) -> _Field:
    return _Field(ring)


def is_principal(a: FractionalIdeal) -> Principality:
    """Return whether an ideal is principal, with a generator, or its class."""
    field = _field(a.ring)
    x = field.principal(a)
    if x is not None:
        return Principality(True, "a generator is known", x, evidence={"kind": "generator"})
    classes = field.classes.coordinates(field.class_of(a)[1])
    found: dict[str, object]
    found = {"kind": "class", "invariants": field.classes.invariants, "class": classes}
    return Principality(False, "its class is not 0 in the class group", evidence=found)


class ClassGroup(Certified):
    """The class group of a number field, proved without hypotheses, narrow at some real places.

    ``order``, ``invariants`` d₁ | d₂ | …, ``generators`` (ideals, of these orders), ``evidence``, and
    ``assumes``, which is empty.

    >>> from hfield import ring
    >>> K = ring("QQ(sqrt(-5))"); C = K.class_group()
    >>> C, C.order, C.class_of(K.ideal([2, 1 + K.gen])), C.assumes
    (ℤ/2, 2, (1,), ())
    """

    assumes: tuple[str, ...] = ()

    def __init__(self, ring: NumberField, signs: tuple[int, ...] = ()) -> None:
        self.ring, self.narrow, self._field, self._signs = ring, bool(signs), _field(ring), signs
        self.group = self._with_signs() if signs else self._field.classes
        self.order, self.invariants = self.group.order, self.group.invariants

    def __len__(self) -> int:
        return self.order

    def __repr__(self) -> str:
        return " × ".join(f"ℤ/{d}" for d in self.invariants) or "the trivial group"

    def _with_signs(self) -> AbelianGroup:
        s, places = self._field.s, len(self._signs)
        k = len(s.primes)
        rows = [[*row, *self._of_signs(x)] for row, x in zip(s.rows, s.generators, strict=True)]
        rows += [[0] * k + self._of_signs(-s.field.one)]
        rows += [[0] * k + [2 * int(i == j) for j in range(places)] for i in range(places)]
        return AbelianGroup(rows, k + places)

    def _of_signs(self, x: FieldElement) -> list[int]:
        return [int(self._field.s.field.sign_at(x, k) < 0) for k in self._signs]

    def class_of(self, a: FractionalIdeal) -> tuple[int, ...]:
        """Return the class of an ideal, in the cyclic factors."""
        x, exponents = self._field.class_of(a)
        return self.group.coordinates([*exponents, *self._of_signs(x)])

    def factors(self, a: FractionalIdeal) -> tuple[FieldElement, list[int]]:
        """Return x and exponents with a = x·∏Pᵉ, P in the S of :attr:`evidence`."""
        return self._field.class_of(a)

    @cached_property
    def generators(self) -> tuple[FractionalIdeal, ...]:
        """Integral ideals whose classes generate the cyclic factors."""
        s = self._field.s
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
        s = self._field.s
        found = [a]
        for y in s.short(a.inverse(), 40):
            if all(s.field.sign_at(y, k) > 0 for k in self._signs):
                found.append(a * s.frame.principal(y))
        return min((b for b in found if b.is_integral()), key=lambda b: b.norm(), default=a)

    def _with_class(self, a: FractionalIdeal, wanted: tuple[int, ...]) -> FractionalIdeal:
        s = self._field.s
        for y in s.short(a.inverse(), 4_000):
            b = a * s.frame.principal(y)
            if self.class_of(b) == wanted:
                return b
        raise UndecidedError("no small ideal was found in a narrow class")

    @cached_property
    def evidence(self) -> dict[str, object]:
        """The evidence as JSON data: reductions, generators of S-units, primes at which they are
        saturated.
        """
        return evidence.evidence(self._field.s)

    @property
    def claim(self) -> CertifiedClaim:
        """The class group as a statement with its evidence; there is none for the narrow one."""
        if self.narrow:
            why = "narrow class groups are not certified: ask for class_group()"
            return CertifiedClaim("", "class-group", {}, "S-units", ring=self.ring, refusal=why)
        orders = ",".join(map(str, self.invariants or (1,)))
        return evidence.claim(self._field.s, self.ring, f"class-group{{{orders}}}")


class UnitGroup(Certified):
    """The units of a number field: ``generators`` of the free part, ``rank``, ``torsion``, ``regulator``.

    >>> from hfield import ring
    >>> U = ring("QQ(sqrt(2))").unit_group()
    >>> U.rank, [abs(u.norm()) for u in ring("QQ[s]/(s^3-2)").unit_group().generators], U.torsion_order
    (1, [1], 2)
    """

    assumes: tuple[str, ...] = ()

    def __init__(self, ring: NumberField) -> None:
        self.ring, self._field = ring, _field(ring)
        s = self._field.s
        self.rank, self.torsion_order = s.rank, s.order_of_torsion
        self.torsion = s.torsion
        self.generators = tuple(self._field.units)

    def __repr__(self) -> str:
        free = f" × ℤ^{self.rank}" if self.rank else ""
        return f"ℤ/{self.torsion_order}{free}"

    @cached_property
    def regulator(self) -> flint.arb:
        """A ball of flint that contains the regulator; 1 where the rank is 0."""
        return self._field.s.covolume(self._field.units, [[] for _ in self._field.units])

    @cached_property
    def totally_positive(self) -> tuple[FieldElement, ...]:
        """Generators of the group of totally positive units; without real places, those of the free part."""
        s = self._field.s
        real = s.field.signature[0]
        if not real:
            return self.generators
        every = [-s.field.one, *self._field.units]
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
            u = s.product(self._field.units, list(map(int, v)))
            out.append(u if s.field.sign_at(u, 0) > 0 else -u)
        return tuple(out)

    @cached_property
    def evidence(self) -> dict[str, object]:
        """The evidence, as for the class group."""
        return evidence.evidence(self._field.s)

    @property
    def claim(self) -> CertifiedClaim:
        """The units as a statement with its evidence."""
        texts = [str(self.torsion_order), *map(self.ring.text, self.generators)]
        return evidence.claim(self._field.s, self.ring, f"unit-group{{{'; '.join(texts)}}}")


@lru_cache(maxsize=256)
def class_group(ring: NumberField, signs: tuple[int, ...] = ()) -> ClassGroup:
    """Return the group of ideals modulo generators that are positive at some real places."""
    return ClassGroup(ring, signs)


def narrow_class_group(ring: NumberField) -> ClassGroup:
    """Return the group of ideals modulo those with a totally positive generator."""
    return class_group(ring, tuple(range(_field(ring).s.field.signature[0])))


@lru_cache(maxsize=256)
def unit_group(ring: NumberField) -> UnitGroup:
    """Return the unit group."""
    return UnitGroup(ring)
