"""The S-units of a number field, for a set S of primes that generates the class group: proved, not guessed.

All primes P of norm up to Zimmert's bound generate the class group. For most of them an element is found
whose ideal is P times earlier primes; S is the rest. Elements with all their primes in S span a subgroup
of the S-units. Its index is the index of its units times h'/h, where h is the class number and h' the index
of its exponents in ℤ^S. The index of its units is at most R'/R_min for a proved lower bound R_min of the
regulator. So a prime ℓ that divides the index of the group divides h' or is at most R'/R_min. For each such
ℓ, residues at primes of degree one and norm 1 mod ℓ show that no further product is an ℓ-th power; otherwise
an ℓ-th root is added to the group. In the end the index is 1. Most elements come from one list of the
shortest integers of the field, which bounds the regulator too. The reduced ideals of a quadratic field
enumerate the classes, and only certificates need residues there (H. Cohen, *A Course in Computational
Algebraic Number Theory*, section 6.5; M. Pohst and H. Zassenhaus, *Algorithmic Algebraic Number Theory*,
chapter 5).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property, lru_cache, partial
from itertools import islice, product
from random import Random
from typing import TypeAlias

import flint
import numpy as np
import numpy.typing as npt

from hfield.checker.number_fields.bounds import ZIMMERT_FACTORS
from hfield.core.primality import is_prime, primes
from hfield.core.progress import track
from hfield.errors import TooLargeError, UndecidedError, shorten
from hfield.fields.base.balls import precision
from hfield.fields.base.residue_polynomials import residues
from hfield.fields.number_fields.classes.reduced_ideals import ReducedIdeals
from hfield.fields.number_fields.classes.short_integers import ShortIntegers
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ideals import FractionalIdeal, MaximalOrder, integers
from hfield.fields.number_fields.integers import left_kernel
from hfield.fields.number_fields.integral_basis import element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.ring import NumberField

Characters: TypeAlias = Callable[[Sequence[FieldElement]], tuple[tuple[int, int], list[int]]]
"""From elements to a prime with a root modulo it, and their logarithms there."""

MAX_BOUND = 20_000  # of the norms of primes that generate the class group
MIN_PRIMES_OF_DEGREE_ONE = 8
"""At least so many primes of degree one: ratios of elements give units where few short ones are units."""
MAX_SATURATED = 20_000  # primes at which a group of units is shown to be saturated
TRIES = 400
SHIFT = 40  # binary digits of conjugates in lattices to be reduced

FRIEDMAN = "E. Friedman, Invent. Math. 98 (1989): a regulator is at least 0.2052"
SHORT_UNITS = "C. Hermite: units of a field with no short ones have a large regulator"
ARTIN = "E. Artin: a unit ε > 1 of a cubic field with one real place has 4ε³ + 24 > |D|"
CUSICK = "T. W. Cusick, 1984: the regulator of a totally real cubic field is at least log²(D/4)/16"
QUADRATIC = "a unit > 1 of a real quadratic field is at least (√(D − 4) + √D)/2"


class SUnits:
    """Generators of the S-units of a field modulo roots of unity: the unit rank plus the number of
    ``primes``.
    """

    def __init__(self, frame: MaximalOrder) -> None:
        self.frame, self.field, self.n = frame, frame.field, frame.n
        self.rng = Random(1)
        real, complex_ = self.field.signature
        self.rank = real + complex_ - 1
        self.bound = max(norm_bound(frame), self._least_bound() if self.rank else 1)
        if self.bound > MAX_BOUND:
            raise TooLargeError(
                f"the class group of {shorten(frame.field.name)} needs all prime ideals of norm up to "
                f"{self.bound}, and {MAX_BOUND} is the most here: the discriminant is too large"
            )
        self.order_of_torsion, self.torsion = roots_of_unity(frame)
        self._shape = _conjugates(frame)
        self.base = sorted(
            (P for p in primes(self.bound + 1) for P in frame.field.primes_above(p)),
            key=lambda P: (P.norm() > self.bound, P.norm()),
        )
        self.base = [P for P in self.base if P.norm() <= self.bound]
        self.place = {P: k for k, P in enumerate(self.base)}
        self._places_above: dict[int, list[tuple[PrimeIdeal, int | None]]] = {}
        self.primes: list[int] = []
        self.rows: list[list[int]] = []
        self._saturated: dict[int, list[tuple[int, int]]] = {}
        self._bounded_units: list[FieldElement] = []
        self._bound_of_units = 1
        self.reduced_ideals: ReducedIdeals | None = None
        if self.n == 2:
            self.reduced_ideals = self._enumerate()
        else:
            self.short_integers = ShortIntegers(frame, self._shape)
            self._exponents_of_listed: dict[int, tuple[FieldElement, dict[int, int] | None]] = {}
            self._reduce_base()
            self.generators = []
            self._collect()
            self._saturate()

    def _least_bound(self) -> int:
        """Return the norm of the last of a few prime ideals of degree one."""
        norms = (P.norm() for p in primes() for P in self.frame.field.primes_above(p) if P.f == 1)
        return list(islice(norms, MIN_PRIMES_OF_DEGREE_ONE))[-1]

    # --- smooth elements ---------------------------------------------------------------------------

    def short(self, ideal: FractionalIdeal, count: int) -> Iterator[FieldElement]:
        """Yield short elements of an ideal, by a reduced basis."""
        rows = ideal.matrix * self._shape
        change = rows.lll(transform=True)[1]
        basis = [
            element_of(self.field, row)
            for row in (flint.fmpq_mat(change * ideal.matrix) / ideal.denominator).tolist()
        ]
        done, bound = 0, 0
        while done < count:
            bound += 1
            for c in product(sorted(range(-bound, bound + 1), key=abs), repeat=self.n):
                if max(map(abs, c)) != bound or next(k for k in c if k) < 0:
                    continue
                x = self.field.zero
                for k, w in zip(c, basis, strict=True):
                    if k:
                        x = x + w * k
                yield x
                done += 1
                if done >= count:
                    return

    def smooth(self, x: FieldElement) -> dict[int, int] | None:
        """Return the exponents of x at the primes of the base, or None if other primes divide it."""
        size, den = x.norm(), int(x.poly.denom())
        return self._exponents_at(int(size.p), int(size.q) * den, lambda P: P.valuation(x))

    def smooth_ideal(self, a: FractionalIdeal) -> dict[int, int] | None:
        """Return the exponents of an ideal at the primes of the base, or None if other primes divide it."""
        return self._exponents_at(
            int(a.matrix.det()), a.denominator, lambda P: min(map(P.valuation, a.basis))
        )

    def _exponents_at(
        self, above: int, below: int, valuation: Callable[[PrimeIdeal], int]
    ) -> dict[int, int] | None:
        """Return exponents at the primes of the base, or None if other primes occur.

        The norm is ``above`` over a divisor of a power of ``below``: of what is integral but at primes below.
        """
        rest_above, rest_below = self._rest(above), self._rest(below)
        if rest_above != 1:
            return None
        out: dict[int, int] = {}
        for p, times in _factors(abs(above * below) // rest_below):
            is_integral = below % p != 0  # so that f times the exponents add up
            ideals = self._above(p)
            for number, (P, k) in enumerate(ideals, 1):
                if is_integral and P.f > times:
                    continue
                is_last = is_integral and all(Q.f > times for Q, _ in ideals[number:])
                v = times // P.f if is_last else valuation(P)
                if v:
                    if k is None:
                        return None
                    out[k] = v
                    times -= P.f * v
        return out if rest_below == 1 or not self._has(rest_below, valuation) else None

    def _rest(self, n: int) -> int:
        """Return the part of an integer that is prime to the prime numbers below the base."""
        n = abs(n)
        common = math.gcd(n, self._primorial)
        while common != 1:
            n //= common
            common = math.gcd(n, common)
        return n

    def _above(self, p: int) -> list[tuple[PrimeIdeal, int | None]]:
        """Return the prime ideals above p with their numbers in the base, None where they are not in it."""
        if p not in self._places_above:
            above = self.frame.field.primes_above(p)
            self._places_above[p] = [(P, self.place.get(P)) for P in above]
        return self._places_above[p]

    def _has(self, rest: int, valuation: Callable[[PrimeIdeal], int]) -> bool:
        """Return whether a prime divides the denominator."""
        above = (P for p, _ in _factors(rest) for P in self.frame.field.primes_above(p))
        return any(map(valuation, above))

    @cached_property
    def _rational(self) -> list[int]:
        return sorted({P.p for P in self.base})

    @cached_property
    def _primorial(self) -> int:
        return math.prod(self._rational)

    def _reduce_base(self) -> None:
        """Find for each prime of the base an element that it divides exactly once, and whose other primes
        come earlier.
        """
        self.reductions = {}
        small = max(7, abs(self.field.discriminant()).bit_length())
        numbers: dict[int, list[int]] = {}
        for number, p in enumerate(self._last_primes.tolist()):
            numbers.setdefault(p, []).append(number)
        for k, P in enumerate(track(self.base, len(self.base), "prime ideals")):
            if P.is_inert:
                self.reductions[k] = (self.field(P.p), {k: 1})
                continue
            found = None
            if P.norm() > small:
                found = self._listed_reduction(k, numbers.get(P.p, [])) or self._reduction(k)
            if found is None:
                self.primes.append(k)
            else:
                self.reductions[k] = found

    @cached_property
    def _last_primes(self) -> npt.NDArray[np.int64]:
        """The largest prime number in the norm of each listed short integer; 0 for one not below the base."""
        rests = self.short_integers.norms.copy()
        last = np.ones_like(rests)
        for p in self._rational:
            divisible = np.flatnonzero(rests % p == 0)
            last[divisible] = p
            while len(divisible):
                rests[divisible] //= p
                divisible = divisible[rests[divisible] % p == 0]
        last[rests != 1] = 0
        return last

    def _listed_reduction(
        self, k: int, numbers: list[int]
    ) -> tuple[FieldElement, dict[int, int]] | None:
        for number in numbers:
            x, found = self._listed(number)
            if found and max(found) == k and found[k] == 1:
                return x, found
        return None

    def _listed(self, number: int) -> tuple[FieldElement, dict[int, int] | None]:
        """Return a listed short integer with its exponents."""
        found = self._exponents_of_listed.get(number)
        if found is None:
            x = self.short_integers.element(number)
            found = self._exponents_of_listed[number] = x, self.smooth(x)
        return found

    def _reduction(self, k: int) -> tuple[FieldElement, dict[int, int]] | None:
        ideal = self.frame.prime(self.base[k])
        for turn in range(8):
            helper = ideal
            if turn and self.primes:
                helper = ideal * self.frame.prime(self.base[self.rng.choice(self.primes)])
            for x in self.short(helper, TRIES // 8):
                found = self.smooth(x)
                if found and max(found) == k and found[k] == 1:
                    return x, found
        return None

    def reduced(self, x: FieldElement, exponents: dict[int, int]) -> tuple[FieldElement, list[int]]:
        """Return x times elements of the field, and exponents at the primes of S alone."""
        left = dict(exponents)
        while True:
            k = max((j for j, v in left.items() if v and j in self.reductions), default=None)
            if k is None:
                return x, [left.get(j, 0) for j in self.primes]
            alpha, its = self.reductions[k]
            times = left[k]
            x = x * self.field.power(alpha, -times)
            for j, v in its.items():
                left[j] = left.get(j, 0) - times * v

    def _relations(self) -> Iterator[tuple[FieldElement, list[int]]]:
        """Yield elements with all their primes in S."""
        for p in sorted({self.base[k].p for k in self.primes}):
            found = self.smooth(self.field(p))
            if found:
                yield self.reduced(self.field(p), found)
        last = self._last_primes
        largest = max((self.base[k].p for k in self.primes), default=1)
        smooth = np.flatnonzero(last)
        for number in (*smooth[last[smooth] <= largest], *smooth[last[smooth] > largest]):
            x, found = self._listed(int(number))
            if found is not None:
                yield self.reduced(x, found)
        seen, size = set(), 1
        pool = self.primes or range(min(len(self.base), MIN_PRIMES_OF_DEGREE_ONE))
        for turn in range(1, 2_000):
            ideal = self.frame.one
            if pool:
                for _ in range(1 + self.rng.randrange(1 + min(3, size))):
                    ideal = ideal * self.frame.prime(self.base[self.rng.choice(pool)])
                size += turn % 50 == 0
            for x in self.short(ideal, TRIES // 20 if pool else TRIES):
                key = (int(x.poly.denom()), *map(int, x.poly.numer().coeffs()))
                if key in seen:
                    continue
                seen.add(key)
                found = self.smooth(x)
                if found is not None:
                    yield self.reduced(x, found)

    # --- the group ---------------------------------------------------------------------------------

    def _enumerate(self) -> ReducedIdeals:
        """Take all relations from the reduced ideals of a quadratic field, which give the whole group."""
        found = ReducedIdeals(self.frame)
        for k, P in enumerate(self.base):
            ideal = self.frame.prime(P)
            if ideal not in found:
                self.primes.append(k)
                found.adjoin(ideal)
        self.rows = [*found.rows, *[[0] * len(self.primes)] * self.rank]
        return found

    @cached_property
    def generators(self) -> list[FieldElement]:
        """S-units that generate all S-units together with the roots of unity."""
        found = self.reduced_ideals
        assert found is not None
        unit = found.unit
        return [*(x for x, _ in found.relations), *([] if unit is None else [unit])]

    @cached_property
    def reductions(self) -> dict[int, tuple[FieldElement, dict[int, int]]]:
        """For each prime P of the base outside S, by index: a number x and the exponents of its primes.

        P divides x exactly once; all other primes of x lie in S or come before P.
        """
        assert self.reduced_ideals is not None
        reductions = {}
        for k, P in enumerate(self.base):
            if k not in self.primes:
                located = self.reduced_ideals.class_of(self.frame.prime(P))
                assert located is not None, "the primes in S generate the class group"
                x, exponents = located
                others = {j: -e for j, e in zip(self.primes, exponents, strict=True) if e}
                reductions[k] = x, {k: 1, **others}
        return reductions

    @cached_property
    def saturated(self) -> dict[int, list[tuple[int, int]]]:
        """Primes ℓ, with primes of degree one at which residues prove that the group is saturated at ℓ."""
        every = range(len(self.generators))
        for ell in self.possible_divisors():
            found = self._root_at(ell, every)
            assert found is None, "the group is known to be all"
        return self._saturated

    def _collect(self) -> None:
        """Find elements that span a subgroup of small finite index."""
        wanted = len(self.primes) + self.rank
        if not wanted:
            return
        elements: list[FieldElement] = []
        rows: list[list[int]] = []
        span, surplus = _Span(len(self.primes)), 0
        most, same, before = self.rank + 4, 0, 0
        for turn, (x, row) in enumerate(self._relations()):
            is_new = span.add(row)
            if is_new or surplus < most:
                elements.append(x)
                rows.append(row)
                surplus += not is_new
            if surplus < most or span.rank < len(self.primes):
                continue
            found = self._independent(elements, rows)
            elements = [self.product(elements, c) for c in found]
            products = (flint.fmpz_mat(found) * flint.fmpz_mat(rows)).tolist()
            rows = [list(map(int, row)) for row in products]
            surplus, most = 0, 6
            if len(found) != wanted:
                continue
            self.generators, self.rows = list(elements), list(rows)
            limit = self._index_bound()
            same, before = same + 1 if limit == before else 0, limit
            if (
                limit < 20
                or same == (2 if limit < MAX_SATURATED else 8)
                or turn > 60 * wanted + 600
            ):
                return
        if not self.generators:
            raise UndecidedError(
                f"too few relations were found for the class group of {shorten(self.frame.field.name)}"
            )

    def _exponents(self, x: FieldElement) -> list[int]:
        return [self.base[k].valuation(x) for k in self.primes]

    def product(self, elements: Sequence[FieldElement], exponents: Sequence[int]) -> FieldElement:
        """Return a product of powers."""
        out = self.field.one
        for x, c in zip(elements, exponents, strict=True):
            if c:
                out = out * self.field.power(x, int(c))
        return out

    def _independent(self, elements: list[FieldElement], rows: list[list[int]]) -> list[list[int]]:
        """Return exponents of products that span, up to roots of unity, the same group as all elements.

        Units come first; they have short logarithms.
        """
        count, width = len(elements), len(self.primes)
        unit = [[int(j == k) for j in range(count)] for k in range(count)]
        # so heavy that exponents are 0 first
        heavy = [[*u, *(c << 40 for c in row)] for u, row in zip(unit, rows, strict=True)]
        found = [list(map(int, row)) for row in flint.fmpz_mat(heavy).lll().tolist()]
        units = [row[:count] for row in found if not any(row[count:])]
        others = [row[:count] for row in found if any(row[count:])]
        if not units or not self.rank:
            return others if width else []
        logs = [
            [_rounded(v, 60) for v in logarithms(self.frame, x, 128, self.rank)] for x in elements
        ]
        sums = (flint.fmpz_mat(units) * flint.fmpz_mat(logs)).tolist()
        # so heavy that errors of logarithms are not worth reducing
        heavy = [
            [*(c << 36 for c in row), *map(int, its)] for row, its in zip(units, sums, strict=True)
        ]
        found = flint.fmpz_mat(heavy).lll().tolist()
        short = [row for row in found if any(abs(c) > 1 << 44 for c in row[count:])]
        return [[int(c) >> 36 for c in row[:count]] for row in short] + others

    def covolume(self, elements: list[FieldElement], rows: list[list[int]]) -> flint.arb:
        """Return a ball around h·R times the index of the group that independent S-units span."""
        bits = 128
        while bits <= 1 << 16:
            logs = [logarithms(self.frame, x, bits, self.rank) for x in elements]
            with precision(bits):
                whole = [[*map(flint.arb, row), *log] for row, log in zip(rows, logs, strict=True)]
                size = abs(flint.arb_mat(whole).det()) if whole else flint.arb(1)
            if size > 0 and size.rel_accuracy_bits() > 20:
                return size
            bits *= 2
        raise UndecidedError("a regulator was not distinguished from zero")

    def _index_bound(self) -> int:
        """Return a bound for the index of the group in the S-units: h'R' over the least regulator."""
        return self._class_number() * self._unit_index_bound()

    def _unit_index_bound(self) -> int:
        """Return a bound for the index of the units of the group in all units, 1 for the rank 0."""
        if self._bounded_units != self.units:
            self._bounded_units = self.units
            self._bound_of_units = self.unit_index_bound(self.least_regulator[0])
        return self._bound_of_units

    def unit_index_bound(self, regulator: flint.arb) -> int:
        """Return a bound for the index of the units found, by a lower bound of the regulator."""
        if not self.units:
            return 1
        with precision(128):
            size = self.covolume(self.units, [[] for _ in self.units]) / regulator
            return int((size + flint.arb(2) ** -20).upper().floor().unique_fmpz())

    @property
    def units(self) -> list[FieldElement]:
        """The generators that are units: as many as the rank."""
        return [x for x, row in zip(self.generators, self.rows, strict=True) if not any(row)]

    def has_primes_to(self, bound: int) -> bool:
        """Return whether all prime ideals of norm up to a bound are in the base."""
        return all(
            P in self.place
            for p in primes(bound + 1)
            for P in self.frame.field.primes_above(p)
            if p > self.bound or P.norm() <= bound
        )

    @cached_property
    def least_regulator(self) -> tuple[flint.arb, str]:
        """A proved lower bound for the regulator, and its source."""
        known = self.known_regulator
        if self.n > 2 and self.rank:
            other = self.short_integers.least_regulator(self.order_of_torsion)
            if other > known[0]:
                return other, SHORT_UNITS
        return known

    @property
    def known_regulator(self) -> tuple[flint.arb, str]:
        """A lower bound for the regulator from the degree, rank and discriminant, and its source."""
        if not self.rank:
            return flint.arb(1), "the unit rank is 0"
        if self.n == 2:
            d = flint.arb(self.field.discriminant())
            return (((d - 4).sqrt() + d.sqrt()) / 2).log(), QUADRATIC
        size, least = abs(self.field.discriminant()), flint.arb("0.2052")
        if self.n == 3:
            if self.rank == 1:
                other, source = (flint.arb(size - 24) / 4).log() / 3, ARTIN
            else:
                other, source = (flint.arb(size) / 4).log() ** 2 / 16, CUSICK
            if other > least:
                return other, source
        return least, FRIEDMAN

    def _saturate(self) -> None:
        """Adjoin roots until the group is saturated at all primes that may divide its index.

        The index is that of the units times h'/h: only units matter at a prime that does not divide h'.
        """
        for ell in self.possible_divisors():
            whole = self._class_number() % ell == 0
            positions = [k for k, row in enumerate(self.rows) if whole or not any(row)]
            while (found := self._root_at(ell, positions)) is not None:
                position, y = found
                self.generators[position] = y
                self.rows[position] = self._exponents(y)

    def _class_number(self) -> int:
        """Return the class number, times the index of the rows in the exponents of all S-units."""
        if not self.primes:
            return 1
        reduced = flint.fmpz_mat(self.rows).hnf()
        return math.prod(int(reduced[k, k]) for k in range(len(self.primes)))

    def possible_divisors(self) -> Iterator[int]:
        """Yield the primes that may divide the index; the group is saturated at each before the next.

        These divide the index h'/h in the exponents, or are at most the bound of the index of the units.
        Raises :class:`TooLargeError`.
        """
        ell = 1
        while True:
            bound = self._unit_index_bound()
            if bound > MAX_SATURATED:
                raise TooLargeError(
                    f"the units of {shorten(self.frame.field.name)} are known up to an index "
                    f"below {bound} only"
                )
            after = next(p for p in itertools.count(ell + 1) if is_prime(p))
            later = [after] if after <= bound else []
            later += [p for p, _ in _factors(self._class_number()) if p > ell]
            if not later:
                return
            ell = min(later)
            yield ell

    def _root_at(self, ell: int, positions: Sequence[int]) -> tuple[int, FieldElement] | None:
        """Return an ℓ-th root of a product of some generators, and one that it replaces.

        None if these generators and roots of unity have no such root outside their group.
        """
        elements = [self.generators[k] for k in positions]
        if self.order_of_torsion % ell == 0:
            elements.append(self.torsion)
        columns: list[list[int]] = []
        used: list[tuple[int, int]] = []
        sought = len(elements)
        tests = self._characters(ell)
        for _ in range(40):
            while len(columns) < sought:
                (q, root), column = next(tests)(elements)
                columns.append(column)
                used.append((q, root))
            matrix = flint.nmod_mat(
                len(columns), len(elements), [c for v in columns for c in v], ell
            )
            kernel = left_kernel(matrix.transpose())
            if not kernel:
                reduced, rank = matrix.transpose().rref()
                pivots = [
                    next(k for k, c in enumerate(row) if c) for row in reduced.tolist()[:rank]
                ]
                self._saturated[ell] = [used[k] for k in pivots]
                return None
            # at prime ideals above one q, elements of a subfield have equal residues
            if len({q for q, _ in used}) > len(elements) + 2:
                for vector in kernel:
                    replaced = [k for k, c in enumerate(vector[: len(positions)]) if c]
                    if not replaced:
                        continue
                    # units stay units
                    number = max(replaced, key=lambda k: any(self.rows[positions[k]]))
                    inverse = pow(vector[number], -1, ell)
                    balanced = [(c * inverse + ell // 2) % ell - ell // 2 for c in vector]
                    if ell == 2:
                        balanced = list(vector)
                    y = self.root(self.product(elements, balanced), ell)
                    if y is not None:
                        return positions[number], y
            sought += 10
        raise UndecidedError(
            f"units of {shorten(self.frame.field.name)} were not shown to be saturated at {ell}"
        )

    def _characters(self, ell: int) -> Iterator[Characters]:
        """Yield functions: ℓ-th power residue symbols of elements, as exponents, at primes of degree one."""
        below = {self.base[k].p for k in self.primes}
        for q in itertools.count(1 + ell, ell):
            roots = simple_roots(self.field, q) if is_prime(q) and q not in below else []
            if not roots:
                continue
            logarithm = PowerResidues(ell, q)
            for root in roots:
                yield partial(_logarithms_at, logarithm, q, root)

    def root(self, x: FieldElement, ell: int) -> FieldElement | None:
        """Return y with y^ℓ = x, or None."""
        return root(self.frame, x, ell)


class PowerResidues:
    """A homomorphism from the units modulo a prime q to ℤ/ℓ with kernel the ℓ-th powers, for ℓ | q − 1.

    Logarithms are found by baby steps and giant steps, about the square root of ℓ of each.
    """

    def __init__(self, ell: int, q: int) -> None:
        self.q, self.power = q, (q - 1) // ell
        omega = next(w for w in (pow(b, self.power, q) for b in range(2, q)) if w != 1)
        self.small, w = {}, 1
        self.large = min(ell, 4 * math.isqrt(ell) + 1)
        for k in range(self.large):
            self.small[w] = k
            w = w * omega % q
        self.step = pow(w, -1, q)

    def __call__(self, x: int) -> int:
        """Return the image of x, from 0 to ℓ − 1."""
        w, total = pow(x, self.power, self.q), 0
        while w not in self.small:
            w, total = w * self.step % self.q, total + self.large
        return total + self.small[w]


def simple_roots(field: NumberField, q: int) -> list[int]:
    """Return the roots of the field's polynomial modulo a prime, if all of them are simple; else []."""
    whole = field.polynomial.numer()
    if int(whole.discriminant() * whole.leading_coefficient()) % q == 0:
        return []
    factors = residues(q, whole.coeffs()).factor()[1]
    return [int(-g[0] / g[1]) for g, _ in factors if g.degree() == 1]


def residue(x: FieldElement, root: int, q: int) -> int:
    """Return the residue of x modulo the prime ideal of degree 1 above q that contains s − ``root``."""
    total = 0
    for c in reversed(x.poly.numer().coeffs()):
        total = (total * root + int(c % q)) % q
    return total * pow(int(x.poly.denom()) % q, -1, q) % q


def norm_bound(frame: MaximalOrder) -> int:
    """Return a bound for the norms of prime ideals that generate the class group."""
    n, complex_ = frame.n, frame.field.signature[1]
    if n not in ZIMMERT_FACTORS:
        return minkowski(frame)
    factor = ZIMMERT_FACTORS[n][complex_]
    square = factor * factor * abs(frame.field.discriminant())
    return max(1, math.isqrt(int(square)))


def minkowski(frame: MaximalOrder) -> int:
    """Return a bound such that every ideal class contains an integral ideal of at most this norm."""
    n, size = frame.n, abs(frame.field.discriminant())
    complex_ = frame.field.signature[1]
    with precision(128):
        if n == 2:  # reduced forms have a first coefficient of at most √(|D|/3) or √(D/5)
            bound = (flint.arb(size) / (3 if complex_ else 5)).sqrt()
        else:
            bound = (4 / flint.arb.pi()) ** complex_ * math.factorial(n) / n**n
            bound *= flint.arb(size).sqrt()
        return max(1, int((bound + flint.arb(2) ** -40).upper().floor().unique_fmpz()))


@lru_cache(maxsize=256)
def roots_of_unity(frame: MaximalOrder) -> tuple[int, FieldElement]:
    """Return the number of roots of unity, and one that generates them."""
    field, n = frame.field, frame.n
    if field.signature[0]:
        return 2, -field.one
    # roots of unity differ modulo prime ideals of degree one
    split = ((q, r) for q in primes() if q > n + 1 for r in simple_roots(field, q)[:1])
    tried = list(islice(split, 8))
    common = math.gcd(*(q - 1 for q, _ in tried))
    q, r = tried[0]
    for m in range(common, 2, -2):
        if common % m or n % int(flint.fmpz(m).euler_phi()):
            continue
        powers = (pow(b, (q - 1) // m, q) for b in range(2, q))
        start = next(y for y in powers if all(pow(y, m // p, q) != 1 for p, _ in _factors(m)))
        found = _lifted_power_root(frame, field.one, m, start, (q, r))
        if found is not None:
            return m, found
    return 2, -field.one


def _conjugates(frame: MaximalOrder) -> flint.fmpz_mat:
    """Return the integral basis in real and imaginary parts of conjugates, rounded: for reduction only."""
    rows = []
    for w in frame.basis:
        row = []
        for index in range(frame.field.embeddings.count):
            z = frame.field.embeddings.value(w.poly, index, 128)
            if index < frame.field.embeddings.real_count:
                row.append(_rounded(z.real, SHIFT))
            else:
                row += [_rounded(z.real * 1.41421356, SHIFT), _rounded(z.imag * 1.41421356, SHIFT)]
        rows.append(row)
    return flint.fmpz_mat(rows)


def _logarithms_at(
    logarithm: PowerResidues, q: int, root: int, xs: Sequence[FieldElement]
) -> tuple[tuple[int, int], list[int]]:
    return (q, root), [logarithm(residue(x, root, q)) for x in xs]


def _rounded(x: flint.arb, shift: int) -> int:
    with precision(256):
        return int((x.mid() * flint.arb(2) ** shift).floor().unique_fmpz())


def logarithms(
    frame: MaximalOrder, x: FieldElement, bits: int = 128, count: int | None = None
) -> list[flint.arb]:
    """Return balls around the logarithms of the absolute values at infinity, doubled at complex places.

    With ``count``, only those at the first places.
    """
    embeddings = frame.field.embeddings
    out = []
    for index in range(embeddings.count if count is None else count):
        work = bits
        while True:
            z = embeddings.value(x.poly, index, work)
            with precision(work):
                size = abs(z)
            if size > 0 and size.rel_accuracy_bits() >= bits - 32:
                break
            work *= 2
        with precision(bits):
            out.append(size.log() * (1 if index < embeddings.real_count else 2))
    return out


def root(frame: MaximalOrder, x: FieldElement, ell: int) -> FieldElement | None:
    """Return y with y^ℓ = x for a prime ℓ, or None.

    Modulo a suitable prime ideal of degree one, x has one root, or its roots differ by roots of unity of the
    field; then any of them suffices.
    """
    field = frame.field
    # m·y is an integer if m^ℓ·x is
    scale = math.prod(p ** -(-e // ell) for p, e in _factors(int(frame.principal(x).denominator)))
    target = x * flint.fmpq(scale) ** ell
    several = roots_of_unity(frame)[0] % ell == 0
    q, r = next(
        (q, r)
        for q in primes()
        if q != ell and (several or q % ell != 1) and int(target.poly.denom()) % q
        for r in simple_roots(field, q)
        if residue(target, r, q)
    )
    value = residue(target, r, q)
    start = next((y for y in range(1, q) if pow(y, ell, q) == value), None)
    y = None if start is None else _lifted_power_root(frame, target, ell, start, (q, r))
    return None if y is None else y * flint.fmpq(1, scale)


def _lifted_power_root(
    frame: MaximalOrder, x: FieldElement, m: int, start: int, prime: tuple[int, int]
) -> FieldElement | None:
    """Return y with y^m = x and a given residue, or None, for an algebraic integer x.

    The residue is lifted to a power Pᵏ of the prime ideal of degree one, and reduced to a short number.
    Nonzero numbers in Pᵏ are so large that a root of x is found if there is one.
    """
    field, n, (q, r) = frame.field, frame.n, prime
    weights = [1] * field.signature[0] + [2] * field.signature[1]
    sizes = zip(logarithms(frame, x), weights, strict=True)
    largest = max(0.0, *(float(log.upper()) / weight for log, weight in sizes)) / m
    # by the inequality of the means numbers in Pᵏ are at least √n·q^(k/n); a reduced basis loses less than 3ⁿ
    digits = -(-n * (int(largest / math.log(2)) + 2 * n + 16) // (q.bit_length() - 1))
    modulus = q**digits
    r = _lifted_root([int(c) for c in field.polynomial.numer().coeffs()], r, q, digits)
    power = [-residue(x, r, modulus), *[0] * (m - 1), 1]
    y = _short_with_residue(frame, r, _lifted_root(power, start, q, digits), modulus)
    return y if field.power(y, m) == x else None


def _lifted_root(f: Sequence[int], r: int, q: int, digits: int) -> int:
    """Return the root of a polynomial modulo q^digits that is congruent to r modulo q, where r is a simple
    root.
    """
    slope = [k * c for k, c in enumerate(f)][1:]
    known = 1
    while known < digits:
        known = min(2 * known, digits)
        modulus = q**known
        value, steep = (_value(g, r, modulus) for g in (f, slope))
        r = (r - value * pow(steep, -1, modulus)) % modulus
    return r


def _value(f: Sequence[int], r: int, modulus: int) -> int:
    total = 0
    for c in reversed(f):
        total = (total * r + c) % modulus
    return total


def _short_with_residue(frame: MaximalOrder, r: int, y: int, modulus: int) -> FieldElement:
    """Return a short integer of the field that is y modulo a prime power, where s is r."""
    residues_ = [residue(w, r, modulus) for w in frame.basis]
    pivot = next(k for k, w in enumerate(residues_) if math.gcd(w, modulus) == 1)
    inverse = pow(residues_[pivot], -1, modulus)
    kernel = [[int(i == j) for j in range(frame.n)] for i in range(frame.n)]
    for k, w in enumerate(residues_):
        kernel[k][pivot] = modulus if k == pivot else -w * inverse % modulus
    lattice = flint.fmpz_mat(kernel)
    change = (lattice * _conjugates(frame)).lll(transform=True)[1]
    reduced = flint.fmpq_mat(change * lattice)
    at_pivot = [y * inverse % modulus * (k == pivot) for k in range(frame.n)]
    start = flint.fmpq_mat(1, frame.n, at_pivot)
    turns = [(c + flint.fmpq(1, 2)).floor() for c in (start * reduced.inv()).entries()]
    return element_of(frame.field, (start - flint.fmpq_mat(1, frame.n, turns) * reduced).entries())


def _factors(n: int) -> list[tuple[int, int]]:
    return [(int(p), int(e)) for p, e in flint.fmpz(n).factor()]


class _Span:
    """The rank of rows of integers modulo a large prime, updated row by row."""

    PRIME = (1 << 61) - 1

    def __init__(self, width: int) -> None:
        self._rows: dict[int, list[int]] = {}
        self.width = width

    @property
    def rank(self) -> int:
        return len(self._rows)

    def add(self, row: Sequence[int]) -> bool:
        """Add a row to the span; return whether the rank grew."""
        if self.rank == self.width:
            return False
        p, left = self.PRIME, list(row)
        for k in range(self.width):
            c = left[k] % p
            if not c:
                continue
            pivot = self._rows.get(k)
            if pivot is None:
                inverse = pow(c, -1, p)
                self._rows[k] = [a * inverse % p for a in left]
                return True
            left = [(a - c * b) % p for a, b in zip(left, pivot, strict=True)]
        return False


@lru_cache(maxsize=256)
def s_units(ring: NumberField) -> SUnits:
    """Return the S-units of a field, for primes S that generate its class group."""
    return SUnits(integers(ring))
