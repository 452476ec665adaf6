"""The forms Tr(c·N(x)) of a totally definite algebra, positive definite over ℤ for totally positive c.

An element of norm ν has the value n = [K : ℚ] in the form with c = 1/ν; by the inequality of the means every
x ≠ 0 with N(x)/ν integral has at least that. So equivalences, generators and units are vectors of least
conceivable length: they are there, or an exhausted enumeration says that they are not (J. Voight,
*Quaternion Algebras*, section 17.6; M. Kirschmer and J. Voight, *SIAM J. Comput.* 39, 2010). All is integral.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import IndefiniteError, TooLargeError, shorten
from hfield.orders.enumeration import least_vectors, short_vectors, vectors_of_length, volume
from hfield.orders.short_elements import MANY, expect_affordable

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.orders.over_integers.frames import Frame


class TraceForms:
    """The positive forms of a frame.

    Raises :class:`IndefiniteError` for an algebra that is not totally definite.
    """

    def __init__(self, frame: Frame) -> None:
        field = frame.field
        totally_real = field.signature == (field.degree, 0)
        if not totally_real or not all(_positive(field, -x) for x in (frame.a, frame.b)):
            why = (
                f"{shorten(frame.integers.ring.name)} is not totally real, so no algebra over it is definite"
                if not totally_real
                else f"{shorten(frame.algebra)} is split at a real place, so it is not totally definite"
            )
            raise IndefiniteError(
                f"{why}: short elements, units, class sets and Brandt matrices are for totally definite "
                "algebras over totally real fields"
            )
        self.frame, self.field, self.n = frame, field, frame.n

    def form(self, c: FieldElement) -> flint.fmpq_mat:
        """Return the matrix of the form Tr(c·tr(x·conj(y))), twice Tr(c·N(x)) for x = y."""
        total = flint.fmpq_mat(self.frame.size, self.frame.size)
        for w, matrix in zip(self.frame.omega, self.frame.gram, strict=True):
            total = total + matrix * (c * w).trace()
        return total

    def reduced(
        self, rows: flint.fmpq_mat, c: FieldElement
    ) -> tuple[list[list[int]], flint.fmpq_mat, int]:
        """Return the matrix of a form times a number for a reduced basis, the basis, and the number."""
        whole, den = (rows * self.form(c) * rows.transpose()).numer_denom()
        reduced, change = whole.lll(transform=True, rep="gram")
        gram = [list(map(int, row)) for row in reduced.tolist()]
        return gram, flint.fmpq_mat(change) * rows, int(den)

    def shortest(self, rows: flint.fmpq_mat) -> list[flint.fmpq_mat]:
        """Return one of ±x for each x ≠ 0 in a lattice with the least Tr(N(x))."""
        gram, basis, _ = self.reduced(rows, self.field.one)
        found = least_vectors(gram)[1]
        return [flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis for x in found]

    def elements_of_norm(
        self, rows: flint.fmpq_mat, norm: FieldElement
    ) -> Iterator[flint.fmpq_mat]:
        """Yield one of ±x for each x in a lattice with the given norm, totally positive."""
        gram, basis, den = self.reduced(rows, norm.inverse())
        for x in vectors_of_length(gram, 2 * self.n * den):
            row = flint.fmpq_mat(flint.fmpz_mat(1, len(x), x)) * basis
            if self.frame.norm(row.entries()) == norm:
                yield row


def all_of_norm(frame: Frame, rows: flint.fmpq_mat, norm: FieldElement) -> list[Quaternion]:
    """Return all elements of a lattice with a norm, in a fixed order. Raises :class:`TooLargeError`."""
    forms, zero = trace_forms(frame), [flint.fmpq(0)] * frame.size
    if not norm:
        return [frame.quaternion(zero)]
    if not _positive(frame.field, norm):
        return []
    gram, _, den = forms.reduced(rows, norm.inverse())
    expect_affordable(volume(gram, 2 * frame.n * den, frame.size - 1), "elements as short as")
    found = []
    for row in forms.elements_of_norm(rows, norm):
        found += [row.entries(), (-row).entries()]
        if len(found) > MANY:
            raise TooLargeError(f"more than {MANY} elements of this lattice have the given norm")
    return [frame.quaternion(row) for row in sorted(found, reverse=True)]


def theta_series(frame: Frame, rows: flint.fmpq_mat, bound: int) -> dict[FieldElement, int]:
    """Return how many elements of a lattice have each norm of trace at most a bound, 0 among them.

    Raises :class:`TooLargeError` for more than two million elements.
    """
    gram, basis, den = trace_forms(frame).reduced(rows, frame.field.one)
    if (estimate := volume(gram, 2 * bound * den, frame.size)) > 8 * MANY:
        raise TooLargeError(
            f"about {estimate:.0e} elements have norms of trace at most {bound}, and at most {2 * MANY} are "
            "counted; expected a smaller bound"
        )
    forms = [(basis * form * basis.transpose()).numer_denom() for form in frame.gram]
    entries = [[list(map(int, row)) for row in form.tolist()] for form, _ in forms]
    counts = Counter({(0,) * len(forms): 1})
    for number, (x, _) in enumerate(short_vectors(gram, 2 * bound * den), 1):
        if number > MANY:
            raise TooLargeError(
                f"more than {2 * MANY} elements have norms of trace at most {bound}"
            )
        places = [(n, c) for n, c in enumerate(x) if c]
        values = (sum(c * d * form[n][m] for n, c in places for m, d in places) for form in entries)
        counts[tuple(values)] += 2
    halves = [flint.fmpq(1, 2 * int(d)) for _, d in forms]
    return {
        sum(
            (v * h * w for v, h, w in zip(values, halves, frame.omega, strict=True)),
            frame.field.zero,
        ): n
        for values, n in counts.items()
    }


def _positive(field: Any, x: FieldElement) -> bool:
    """Tell whether an element of a totally real field is totally positive: by the signs of its polynomial."""
    signs = field.multiplication(x).charpoly().coeffs()
    return all(c * (-1) ** (len(signs) - 1 - k) > 0 for k, c in enumerate(signs))


@lru_cache(maxsize=64)
def trace_forms(frame: Frame) -> TraceForms:
    """Return the forms of a frame. Raises :class:`IndefiniteError`."""
    return TraceForms(frame)
