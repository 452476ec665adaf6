"""Linear equations with one unknown quaternion: Σ aₙ·x·bₙ = c, by coordinates over the base ring."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import UndecidedError
from hfield.structure.linear_algebra.echelon import null_space, solution


@dataclass(frozen=True)
class LinearSolutions:
    """All solutions: ``particular`` plus the combinations of ``kernel``, a basis over the field; or none.

    Where there is none it is false, ``particular`` is None, and ``reason`` says why: ``functional`` are four
    scalars whose sum with the coordinates of the left side is 0 for every x, and with those of c is not.
    """

    particular: Quaternion | None
    kernel: tuple[Quaternion, ...]
    reason: str = ""
    functional: tuple[object, ...] = ()

    def __bool__(self) -> bool:
        return self.particular is not None


def solve_linear(
    algebra: Parent, terms: Sequence[tuple[object, object]], c: object
) -> LinearSolutions:
    """Return all x with Σ a·x·b = c for the pairs (a, b) of ``terms``.

    Raises :class:`UndecidedError` over rings that are no fields.
    """
    F, right = algebra.ring, algebra(c)
    if not F.is_field:
        raise UndecidedError(f"linear equations are solved over fields, and {F.name} is none")
    pairs = [(algebra(a), algebra(b)) for a, b in terms]
    images = []
    for u in algebra.basis:
        image = algebra.scalar(0)
        for a, b in pairs:
            image = image + a * u * b
        images.append(image.coordinates)
    rows = [list(row) for row in zip(*images, strict=True)]
    found = solution(F, rows, [[x] for x in right.coordinates])
    kernel = tuple(algebra(*v) for v in null_space(F, rows, 4))
    if found is not None:
        return LinearSolutions(algebra(*(row[0] for row in found)), kernel)
    for y in null_space(F, [list(v) for v in images], 4):
        value = sum((s * x for s, x in zip(y, right.coordinates, strict=True)), F.zero)
        if not F.is_zero(value):
            weights = ", ".join(map(F.text, y))
            reason = (
                f"({weights}) times the coordinates of the left side is 0 for every x, "
                f"and {F.text(value)} for c = {right}"
            )
            return LinearSolutions(None, kernel, reason, tuple(y))
    raise AssertionError("a system without solution has a functional that says so")
