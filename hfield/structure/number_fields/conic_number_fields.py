"""Points on conics ``a·x² + b·y² = z²`` over number fields, searched within a bound.

The form ``z² − a·x² − b·y²`` is put on a module where it is good at every prime ideal. The volume of this
lattice of rank 3n for the majorant |z|² + |a||x|² + |b||y|², summed over the infinite places, depends on
the discriminant of the field alone, so after reduction (LLL) a zero is among small combinations, if the
field is small. The majorant is changed at random by automorphisms of the form at the infinite places until
a zero turns up, as over quadratic fields (:mod:`hfield.structure.quadratic_fields.conic_quadratic`).
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import flint

from hfield.errors import UndecidedError
from hfield.rings.number_elements import FieldElement
from hfield.rings.number_field import NumberField
from hfield.rings.number_orders import integral_generator
from hfield.structure.lattice_reduction import combination, real_coordinates, reduced, turned
from hfield.structure.minimal_conics import Vector
from hfield.structure.number_fields.good_module import good_module
from hfield.structure.number_fields.hilbert_number_fields import candidates

MAX_DEGREE = 12
WALKED = 60
COMBINATIONS = 60_000
CLOSE = 1e-5
MOST = 50  # of the combinations at which the form is nearly 0: at so many it is computed exactly
SCALE = 2.0**40


def solve_conic_number_field(
    field: NumberField, a: FieldElement, b: FieldElement
) -> tuple[FieldElement, FieldElement, FieldElement]:
    """Return ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``, for nonzero a and b.

    The conic must have a point, that is, ``(a, b | K)`` must ramify nowhere. Raises
    :class:`UndecidedError` where none was met, and where a norm or the discriminant is too hard to factor.
    """
    n = field.degree
    if n > MAX_DEGREE:
        raise UndecidedError(
            f"a conic over {field.name} has points, but none was sought: the degree is over {MAX_DEGREE}"
        )
    primes = sorted({2} | candidates(field, a) | candidates(field, b))
    r, s = (integral_multiple(x) for x in (a, b))
    form = [field.one, -a * (r * r), -b * (s * s)]
    walk = Walk(field, form, good_module(field, form, primes))
    rng = random.Random(1)
    for z, x, y in itertools.chain.from_iterable(walk.zeros(rng, k) for k in range(WALKED)):
        return x * r, y * s, z
    raise UndecidedError(
        f"a conic over {field.name} has points, but none was found among {COMBINATIONS} combinations of each "
        f"of {WALKED} reduced bases"
    )


def integral_multiple(x: FieldElement) -> int:
    """Return a positive integer m for which m·x is an algebraic integer."""
    scale, _ = integral_generator(x.field)
    return math.lcm(*(int((c / flint.fmpq(scale) ** k).q) for k, c in enumerate(x.poly.coeffs())))


class Walk:
    """A lattice in K³ with a diagonal form, and as many reduced bases of it as one likes.

    ``points`` are the basis at the infinite places, where the form is a sum of squares of three complex
    numbers, three after three.
    """

    def __init__(self, field: NumberField, form: Vector, basis: list[Vector]) -> None:
        self.field, self.form, self.basis = field, form, basis
        self.rank = 3 * field.degree
        self.real = field.signature[0]
        self.points = self._embedded(*self._first())

    @cached_property
    def signs(self) -> list[list[int] | None]:
        """The signs of the form at each infinite place, None at a complex one."""
        embeddings = self.field.embeddings
        return [
            [embeddings.sign(f.poly, k) for f in self.form] if k < self.real else None
            for k in range(embeddings.count)
        ]

    def _first(self) -> tuple[list[Vector], int]:
        """Reduce the basis exactly; return it, and how many bits its numbers need."""
        size = max(
            abs(int(c.p)).bit_length() + int(c.q).bit_length()
            for v in (self.form, *self.basis)
            for x in v
            for c in x.poly.coeffs()
        )
        bits = 4 * size + 128
        with flint.ctx.workprec(bits):
            scale = flint.arb(2) ** (2 * size + 64)
            rows = [
                [int((t * scale).mid().floor().unique_fmpz()) for t in row]
                for row in self._real_rows(self.basis, bits)
            ]
        self.basis = [combination(u, self.basis) for u in reduced(rows)[1]]
        return self.basis, bits

    def _values(self, basis: list[Vector], bits: int) -> list[list[Any]]:
        """Return √f·x for the coordinates x of each vector at each infinite place."""
        embeddings, out = self.field.embeddings, []
        with flint.ctx.workprec(bits):
            roots = [
                [embeddings.value(f.poly, k, bits).sqrt() for f in self.form]
                for k in range(embeddings.count)
            ]
            for v in basis:
                out.append(
                    [
                        embeddings.value(x.poly, k, bits) * root
                        for k, at in enumerate(roots)
                        for x, root in zip(v, at, strict=True)
                    ]
                )
        return out

    def _real_rows(self, basis: list[Vector], bits: int) -> list[list[Any]]:
        with flint.ctx.workprec(bits):
            return [real_coordinates(row, 3 * self.real) for row in self._values(basis, bits)]

    def _embedded(self, basis: list[Vector], bits: int) -> list[list[complex]]:
        return [
            [complex(float(z.real.mid()), float(z.imag.mid())) for z in row]
            for row in self._values(basis, bits)
        ]

    def zeros(self, rng: random.Random, step: int) -> Iterator[Vector]:
        """Run through the zeros of the form that are met among small combinations of a reduced basis.

        The basis is the first one, or, after step 0, one reduced for another majorant, at random.
        """
        import numpy as np

        points, steps = self.points, None
        if step:
            moved = turned(points, self.signs, rng.uniform(0, 3), rng)
            _, steps = reduced(self._rounded(moved))
            points = [combination(u, points) for u in steps]
        values = np.array(points)
        chosen = _small_combinations(self.rank)
        at = chosen @ values.real + 1j * (chosen @ values.imag)
        form = np.abs((at**2).reshape(len(chosen), -1, 3).sum(axis=2)).sum(axis=1)
        scale = max(1.0, float(np.abs(values).max()) ** 2)
        nearest = np.argpartition(form, MOST)[:MOST] if len(form) > MOST else np.arange(len(form))
        for index in sorted(nearest[form[nearest] < CLOSE * scale], key=form.__getitem__):
            u = [int(x) for x in chosen[index]]
            if steps is not None:
                u = [sum(x * s[j] for x, s in zip(u, steps, strict=True)) for j in range(self.rank)]
            v = combination(u, self.basis)
            total = sum((f * x * x for f, x in zip(self.form, v, strict=True)), self.field.zero)
            if not total:
                yield v

    def _rounded(self, points: list[list[complex]]) -> list[list[int]]:
        scale = SCALE / max(abs(z) for v in points for z in v)
        return [[round(t * scale) for t in real_coordinates(v, 3 * self.real)] for v in points]


_KNOWN: dict[int, Any] = {}


def _small_combinations(rank: int) -> Any:
    """Return vectors of entries 0, 1, −1, the first of them 1: those with few entries first."""
    import numpy as np

    if rank not in _KNOWN:
        rows: list[list[int]] = []
        for size in range(1, rank + 1):
            for support in itertools.combinations(range(rank), size):
                for signs in itertools.product((1, -1), repeat=size - 1):
                    row = [0] * rank
                    for k, sign in zip(support, (1, *signs), strict=True):
                        row[k] = sign
                    rows.append(row)
                if len(rows) >= COMBINATIONS:
                    break
            if len(rows) >= COMBINATIONS:
                break
        _KNOWN[rank] = np.array(rows, dtype=np.float64)
    return _KNOWN[rank]
