"""Elements over GF(p)[x]/(f) as four polynomials; sums of products are reduced once."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from hfield.core.product import Constants
from hfield.fields.base.residue_polynomials import polynomials_modulo
from hfield.fields.base.storage.quotients import Quotients, Representatives

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.finite.ring import ExtensionField


class PolynomialStorage(Quotients["Polynomial"]):
    """Elements over GF(pⁿ) as four polynomials of degree below n."""

    reduces_sums = False  # their degrees are small enough

    def __init__(self, ring: ExtensionField, constants: Constants) -> None:
        p = ring.characteristic
        polynomial = polynomials_modulo(p)
        f = polynomial(ring.coefficients)

        def invert(s: Polynomial) -> Polynomial:
            common, inverse, _ = (s % f).xgcd(f)
            if common != 1:
                raise ValueError("0 has no inverse")
            return inverse

        super().__init__(
            ring,
            constants,
            f,
            lift=lambda x: polynomial([int(c) for c in x.to_list()]),
            project=ring.context,
            invert=invert,
        )
        self._constant: Callable[[int], Polynomial] = lambda n: polynomial([n % p])

    def whole(self, w: int, x: int, y: int, z: int) -> Representatives[Polynomial]:
        """Encode four ints."""
        c = self._constant
        return c(w), c(x), c(y), c(z)

    def key(self, p: Representatives[Polynomial]) -> tuple[tuple[int, ...], ...]:
        """Return the coefficients."""
        return tuple(tuple(map(int, c.coeffs())) for c in p)
