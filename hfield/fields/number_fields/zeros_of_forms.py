"""Search for zeros of a diagonal form over a number field K in a module in Kᵐ.

The majorant of the form is the sum of the absolute values of its terms over the infinite places. If the form
is unimodular at every prime on the module, the volume depends only on the discriminant of the field. So for a
small field a zero is among the small combinations after reduction (LLL). The majorant is changed at random by
automorphisms of the form at the infinite places until a zero is found.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator, Sequence
from functools import cache, cached_property
from typing import TYPE_CHECKING, TypeVar

import flint

from hfield.errors import UndecidedError
from hfield.fields.base.balls import precision
from hfield.fields.linear_algebra.lattice_reduction import (
    combination,
    real_coordinates,
    reduced,
    turned,
)
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.quadratic_forms.minimal_conics import Vector

if TYPE_CHECKING:
    import numpy as np

    Z = TypeVar("Z", complex, flint.acb)

MAX_DEGREE = 12
COMBINATIONS = 60_000  # of a reduced basis
MAX_BASES = 60  # bases, as many more as fewer combinations there are of each
CLOSE = 1e-5
MAX_ZEROS = 50
"""The form is computed exactly at so many of the combinations at which it is nearly 0."""
SCALE = 2.0**40


def expect_small_degree(field: NumberField, what: str) -> None:
    """Raise :class:`UndecidedError` for a search over a field of large degree."""
    if field.degree > MAX_DEGREE:
        raise UndecidedError(f"{what} was sought: the degree is over {MAX_DEGREE}")


def not_met(what: str) -> UndecidedError:
    """Return the error for a search that did not find what it was looking for."""
    return UndecidedError(
        f"{what} was found among {COMBINATIONS} combinations of each of {MAX_BASES} reduced bases, or of more"
    )


class ZeroSearch:
    """A lattice in Kᵐ with a diagonal form, and an unlimited supply of reduced bases of it.

    ``points`` contains the values of the basis at the infinite places, where the form is a sum of squares of
    m complex numbers, m after m; the largest absolute value is 1. With an isotropic vector ``modulo``, the
    lattice lies in its orthogonal complement and is considered modulo its multiples: ``points`` are
    orthogonal to it, and it is the last of them.
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
        """The signs of the form at each infinite place; None at a complex one."""
        embeddings = self.field.embeddings
        return [
            [embeddings.sign(f.poly, k) for f in self.form] if k < self.real else None
            for k in range(embeddings.count)
        ]

    def _first(self) -> list[list[complex]]:
        """Reduce the basis exactly; return its values at the infinite places."""
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

    def _values(self, bits: int) -> list[list[flint.acb]]:
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

    def _apart(self, points: list[list[Z]]) -> list[list[Z]]:
        """Return the points minus multiples of the last, so that they are orthogonal to it for the
        majorant.
        """
        if not self.modulo:
            return points
        out: list[list[Z]] = []
        last = points[-1]
        for v in points[:-1]:
            row: list[Z] = []
            for k in range(0, len(v), self.width):
                at, u = v[k : k + self.width], last[k : k + self.width]
                pairing = sum(z * w.conjugate() for z, w in zip(at, u, strict=True))
                factor = pairing / sum(w * w.conjugate() for w in u)
                row += [z - factor * w for z, w in zip(at, u, strict=True)]
            out.append(row)
        return [*out, last]

    def _real(self, v: Sequence[complex]) -> list[float]:
        return real_coordinates(v, self.width * self.real)

    def zeros(self) -> Iterator[Vector]:
        """Yield isotropic vectors of the form among the small combinations of the reduced bases.

        The first basis is reduced for the form's majorant, the others for pseudorandom majorants, the same in
        every run.
        """
        rng = random.Random(1)
        for step in range(
            max(MAX_BASES, MAX_BASES * COMBINATIONS // len(_small_combinations(self.rank)))
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
        nearest = (
            np.argpartition(form, MAX_ZEROS)[:MAX_ZEROS]
            if len(form) > MAX_ZEROS
            else np.arange(len(form))
        )
        for index in sorted(nearest[form[nearest] < CLOSE * largest], key=form.__getitem__):
            u = [int(x) for x in chosen[index]]
            if steps is not None:
                u = [sum(x * s[j] for x, s in zip(u, steps, strict=True)) for j in range(self.rank)]
            v = combination(u, self.basis)
            total = sum((f * x * x for f, x in zip(self.form, v, strict=True)), self.field.zero)
            if not total:
                yield v


def _root(z: flint.acb) -> flint.acb:
    """Return a square root of a ball; around a negative number the branch cut does not split the ball."""
    return z.sqrt() if z.real.mid() >= 0 else (-z).sqrt() * flint.acb(0, 1)


@cache
def _small_combinations(rank: int) -> np.ndarray:
    """Return the vectors with entries 0, 1, −1 and first nonzero entry 1, those with few nonzero entries
    first.
    """
    import numpy as np

    blocks: list[np.ndarray] = []
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
