"""Points on conics ``a·x² + b·y² = z²`` over number fields, searched within a bound.

The form ``z² − a·x² − b·y²`` is put on a module in K³ where it is good at every prime ideal, a lattice of
rank 3n in which a :class:`Walk` looks for zeros. At a prime ideal ``minimal_conics``
gives a local basis whose entries are integral at all other primes. The module that has these bases at the bad
primes, and is the standard one elsewhere, is their sum, each times a number that is divisible enough by the
others.

Compare Cremona and Rusin, "Efficient solution of rational conics", Math. Comp. 72 (2003).

A module in Kᵐ with a diagonal form, K a number field, searched for zeros of the form.

The majorant of the form is the sum of the absolute values of its terms over the infinite places. For a module
on which the form is good at every prime the volume depends on the discriminant of the field alone, so after
reduction (LLL) a zero is among small combinations, if the field is small. The majorant is changed at random
by automorphisms of the form at the infinite places until a zero turns up.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterable, Iterator, Sequence
from functools import cache, cached_property
from typing import Any

import flint

from hfield.errors import UndecidedError
from hfield.fields.number_fields.elements import FieldElement, coefficients
from hfield.fields.number_fields.integral_basis import integral_multiple
from hfield.fields.number_fields.prime_ideals import primes_above
from hfield.fields.number_fields.residues import LocalPlace, local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates
from hfield.rings.balls import precision
from hfield.structure.lattice_reduction import combination, real_coordinates, reduced, turned
from hfield.structure.minimal_conics import Conic, Vector, minimise


def solve_conic_number_field(
    field: NumberField, a: FieldElement, b: FieldElement
) -> tuple[FieldElement, FieldElement, FieldElement]:
    """Return ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``, for nonzero a and b.

    The conic must have a point, that is, ``(a, b | K)`` must ramify nowhere. Raises
    :class:`UndecidedError` where none was met, and where a norm or the discriminant is too hard to factor.
    """
    none = f"a conic over {field.name} has points, but none"
    expect_small_degree(field, none)
    primes = sorted({2} | candidates(field, a) | candidates(field, b))
    r, s = (integral_multiple(x) for x in (a, b))
    form = [field.one, -a * (r * r), -b * (s * s)]
    walk = Walk(field, form, good_module(field, form, primes))
    for z, x, y in walk.zeros():
        return x * r, y * s, z
    raise not_met(none)


def good_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in K³ on which a diagonal form is minimal at each prime ideal.

    The coefficients are integers of the field, and units outside ``primes``, which contain 2. The form
    must have a zero in each completion.
    """
    o = field.zero
    conic = Conic((form[0], form[1], form[2], o, o, o), o, field.one)
    local: list[tuple[LocalPlace, list[Vector]]] = []
    depths: dict[int, int] = {}  # the conductor, prime by prime
    for p in primes:
        depths[p] = 0
        for place in map(local_place, primes_above(field, p)):
            lattice = conic.start()
            if not minimise(conic, lattice, place):
                raise AssertionError("the form has a zero in every completion")
            depths[p] = max(depths[p], -(-_depth(place, lattice.basis) // place.index))
            local.append((place, lattice.basis))
    conductor = math.prod(p**n for p, n in depths.items())
    rows = [[x * conductor for x in v] for v in conic.start().basis]
    for place, basis in local:
        n = depths[place.below]
        scale = _unit(place, n) * (conductor // place.below**n)
        rows += [[scale * x for x in v] for v in basis]
    return module_basis(field, rows)


def _depth(place: LocalPlace, basis: list[Vector]) -> int:
    """Return an n for which the span contains the n-th power of the prime times the standard lattice."""
    (a, b, c), (d, e, f), (g, h, i) = basis
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    worst = min(place.valuation(x) for v in basis for x in v if x)
    return max(0, place.valuation(determinant) - 2 * min(0, worst))


def _unit(place: LocalPlace, n: int) -> FieldElement:
    """Return an integer that is 1 at the place, and divisible by pⁿ at the others above p."""
    prime, p = place.prime, place.below
    power = n * max(Q.e for Q in primes_above(prime.field, p))
    return prime.order.truncated(prime.field.power(prime.idempotent, power), p ** (n + 1))


def module_basis(field: NumberField, generators: list[Vector]) -> list[Vector]:
    """Return a basis over ℤ of what vectors of Kᵐ generate over the integers, scaled to be integral."""
    n = field.degree
    width = n * len(generators[0])
    wide = [[w * x for x in v] for w in field.integral_basis() for v in generators]
    rows = [[c for x in v for c in coefficients(x)] for v in wide]
    scale = math.lcm(*(int(c.q) for row in rows for c in row))
    entries = [(c * scale).p for row in rows for c in row]
    matrix = flint.fmpz_mat(len(rows), width, entries).hnf()
    return [
        [FieldElement(field, flint.fmpq_poly(row[k : k + n])) for k in range(0, width, n)]
        for row in matrix.tolist()[:width]
    ]


MAX_DEGREE = 12
COMBINATIONS = 60_000  # of a reduced basis
WALKED = 60  # bases, as many more as fewer combinations there are of each
CLOSE = 1e-5
MOST = 50  # of the combinations at which the form is nearly 0: at so many it is computed exactly
SCALE = 2.0**40


def expect_small_degree(field: NumberField, what: str) -> None:
    """Refuse a walk over a field of large degree. Raises :class:`UndecidedError`."""
    if field.degree > MAX_DEGREE:
        raise UndecidedError(f"{what} was sought: the degree is over {MAX_DEGREE}")


def not_met(what: str) -> UndecidedError:
    """Return the error that says that there was none of something on a walk."""
    return UndecidedError(
        f"{what} was found among {COMBINATIONS} combinations of each of {WALKED} reduced bases, or of more"
    )


class Walk:
    """A lattice in Kᵐ with a diagonal form, and as many reduced bases of it as one likes.

    ``points`` are the basis at the infinite places, where the form is a sum of squares of m complex
    numbers, m after m; the largest of them is 1. With an isotropic vector ``modulo`` the lattice lies in its
    orthogonal complement, and is looked at modulo its multiples: ``points`` are orthogonal to it, and it is
    the last of them.
    """

    def __init__(
        self, field: NumberField, form: Vector, basis: list[Vector], modulo: Vector | None = None
    ) -> None:
        self.field, self.form, self.basis = field, form, basis
        self.rank, self.width = len(basis), len(form)
        self.modulo = [] if modulo is None else [modulo]
        self.real = field.signature[0]
        self.points = self._first()

    @cached_property
    def signs(self) -> list[list[int] | None]:
        """The signs of the form at each infinite place, None at a complex one."""
        embeddings = self.field.embeddings
        return [
            [embeddings.sign(f.poly, k) for f in self.form] if k < self.real else None
            for k in range(embeddings.count)
        ]

    def _first(self) -> list[list[complex]]:
        """Reduce the basis exactly; return it at the infinite places."""
        size = max(
            abs(int(c.p)).bit_length() + int(c.q).bit_length()
            for v in (self.form, *self.basis, *self.modulo)
            for x in v
            for c in x.poly.coeffs()
        )
        bits = 4 * size + 128
        with precision(bits):
            scale = flint.arb(2) ** (2 * size + 64)
            rows = [
                [int((t * scale).mid().floor().unique_fmpz()) for t in self._real(v)]
                for v in self._values(bits)[: self.rank]
            ]
            self.basis = [combination(u, self.basis) for u in reduced(rows)[1]]
            points = self._values(bits)
            units = [max(abs(z).mid() for v in points[: self.rank] for z in v)]
            units = units * self.rank + [max(abs(z).mid() for z in v) for v in points[self.rank :]]
            return [
                [complex(float((z / unit).real.mid()), float((z / unit).imag.mid())) for z in v]
                for v, unit in zip(points, units, strict=True)
            ]

    def _values(self, bits: int) -> list[list[Any]]:
        """Return √f·x for the coordinates x of each vector at each infinite place."""
        embeddings = self.field.embeddings
        roots = [
            [_root(embeddings.value(f.poly, k, bits)) for f in self.form]
            for k in range(embeddings.count)
        ]
        return self._apart(
            [
                [
                    embeddings.value(x.poly, k, bits) * root
                    for k, at in enumerate(roots)
                    for x, root in zip(v, at, strict=True)
                ]
                for v in (*self.basis, *self.modulo)
            ]
        )

    def _apart(self, points: list[list[Any]]) -> list[list[Any]]:
        """Return points less multiples of the last, so that they are orthogonal to it for the majorant."""
        if not self.modulo:
            return points
        out, last = [], points[-1]
        for v in points[:-1]:
            row: list[Any] = []
            for k in range(0, len(v), self.width):
                at, u = v[k : k + self.width], last[k : k + self.width]
                pairing = sum(z * w.conjugate() for z, w in zip(at, u, strict=True))
                factor = pairing / sum(w * w.conjugate() for w in u)
                row += [z - factor * w for z, w in zip(at, u, strict=True)]
            out.append(row)
        return [*out, last]

    def _real(self, v: Sequence[Any]) -> list[Any]:
        return real_coordinates(v, self.width * self.real)

    def zeros(self) -> Iterator[Vector]:
        """Run through the zeros of the form that are met among small combinations of the reduced bases.

        The first of them, and those reduced for other majorants, at random but always the same.
        """
        rng = random.Random(1)
        for step in range(
            max(WALKED, WALKED * COMBINATIONS // len(_small_combinations(self.rank)))
        ):
            yield from self._zeros(rng, step)

    def _zeros(self, rng: random.Random, step: int) -> Iterator[Vector]:
        import numpy as np

        points, steps = self.points[: self.rank], None
        if step:
            size = rng.uniform(0, 9 / math.comb(self.width, 2))
            points = self._apart(turned(self.points, self.signs, size, rng, self.width))[
                : self.rank
            ]
            scale = SCALE / max(abs(z) for v in points for z in v)
            _, steps = reduced([[round(t * scale) for t in self._real(v)] for v in points])
            points = [combination(u, points) for u in steps]
        values = np.array(points)
        chosen = _small_combinations(self.rank)
        at = chosen @ values.real + 1j * (chosen @ values.imag)
        form = np.abs((at**2).reshape(len(chosen), -1, self.width).sum(axis=2)).sum(axis=1)
        largest = float(np.abs(values).max()) ** 2
        nearest = np.argpartition(form, MOST)[:MOST] if len(form) > MOST else np.arange(len(form))
        for index in sorted(nearest[form[nearest] < CLOSE * largest], key=form.__getitem__):
            u = [int(x) for x in chosen[index]]
            if steps is not None:
                u = [sum(x * s[j] for x, s in zip(u, steps, strict=True)) for j in range(self.rank)]
            v = combination(u, self.basis)
            total = sum((f * x * x for f, x in zip(self.form, v, strict=True)), self.field.zero)
            if not total:
                yield v


def _root(z: Any) -> Any:
    """Return a square root of a ball; a ball around a negative number is not cut by the branch."""
    return z.sqrt() if z.real.mid() >= 0 else (-z).sqrt() * flint.acb(0, 1)


@cache
def _small_combinations(rank: int) -> Any:
    """Return vectors of entries 0, 1, −1, the first of them 1: those with few entries first."""
    import numpy as np

    blocks: list[Any] = []
    for size in range(1, rank + 1):
        signs = np.array(list(itertools.product((1,), *[(1, -1)] * (size - 1))))
        most = -(-(COMBINATIONS - sum(map(len, blocks))) // len(signs))
        if most <= 0:
            break
        chosen = itertools.islice(itertools.combinations(range(rank), size), most)
        supports = np.repeat(list(chosen), len(signs), axis=0)
        block = np.zeros((len(supports), rank))
        block[np.arange(len(block))[:, None], supports] = np.tile(
            signs, (len(block) // len(signs), 1)
        )
        blocks.append(block)
    return np.concatenate(blocks)
