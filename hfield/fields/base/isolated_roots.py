"""The complex roots of a polynomial over ℚ, each isolated in a ball, at any precision."""

from __future__ import annotations

from functools import cmp_to_key, lru_cache

import flint

from hfield.fields.base.balls import precision

START = 128


class IsolatedRoots:
    """The roots of a squarefree polynomial over ℚ: the real roots in ascending order, then the complex ones.

    Each pair of conjugate roots is represented by the one above the real axis. Roots are complex balls of
    flint that contain exactly one root each; their order is the same at every precision.
    """

    def __init__(self, polynomial: flint.fmpq_poly) -> None:
        self._whole = polynomial.numer()
        first = self._isolated(START)
        real = sorted((z for z in first if z.imag == 0), key=cmp_to_key(_order))
        upper = sorted((z for z in first if z.imag > 0), key=cmp_to_key(_order))
        self.real_count, self.count = len(real), len(real) + len(upper)
        self._at: dict[int, list[flint.acb]] = {START: real + upper}

    def _isolated(self, bits: int) -> list[flint.acb]:
        with precision(bits):
            return [flint.acb(z) for z, _ in self._whole.complex_roots()]

    def at(self, bits: int) -> list[flint.acb]:
        """Return the roots with ``bits`` bits."""
        if bits not in self._at:
            finer = self._isolated(bits)
            near = [[z for z in finer if z.overlaps(known)] for known in self._at[START]]
            alone = all(len(zs) == 1 for zs in near)  # else balls of neighbours touch
            self._at[bits] = [z for (z,) in near] if alone else self.at(2 * bits)
        return self._at[bits]

    def numbered(self, n: int, bits: int) -> flint.acb:
        """Return the n-th root, where roots in the lower half plane are counted too, each after its
        conjugate.
        """
        pair, is_below = divmod(max(n - self.real_count, 0), 2)
        z = self.at(bits)[min(n, self.real_count) + pair]
        with precision(bits):
            return z.conjugate() if is_below else z


def _order(z: flint.acb, w: flint.acb) -> int:
    """Order by real parts, and by imaginary parts if the real parts may be equal."""
    for x, y in ((z.real, w.real), (z.imag, w.imag)):
        if x < y or x > y:
            return -1 if x < y else 1
    return 0


@lru_cache(maxsize=256)
def isolated_roots(coefficients: tuple[int, ...]) -> IsolatedRoots:
    """Return the roots of a polynomial over ℤ, low degree first; the same object for the same polynomial."""
    return IsolatedRoots(flint.fmpq_poly(list(coefficients)))
