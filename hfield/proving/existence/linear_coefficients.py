"""Polynomials in what is given, as the coefficients of a linear system: what is 0 and what is a unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from hfield.proving.polynomials.vanishing import factored

if TYPE_CHECKING:
    import flint


Row = tuple[Any, ...]  # the coefficients of what is sought, and last the constant


class Coefficients:
    """The polynomials over ``context``, over the fields of characteristic p, or over all (p is None)."""

    def __init__(self, context: flint.fmpz_mpoly_ctx, p: int | None) -> None:
        self.context, self.p = context, p
        self.one = context.constant(1)

    def is_zero(self, f: flint.fmpz_mpoly) -> bool:
        """Tell whether a polynomial is 0 over all fields that are meant."""
        return bool(f == 0 or (self.p and int(f.content()) % self.p == 0))

    def is_unit(self, f: flint.fmpz_mpoly) -> bool:
        """Tell whether a polynomial is a number that is not 0 in any field that is meant."""
        return bool(f != 0 and f.is_constant() and self.is_nonzero_number(int(f.content())))

    def is_nonzero_number(self, n: int) -> bool:
        """Tell whether a number is not 0 in any field that is meant."""
        if self.p is None or n == 0:
            return abs(n) == 1
        return self.p == 0 or n % self.p != 0

    def primitive(self, row: Row, nonzero: Sequence[flint.fmpz_mpoly] = ()) -> Row:
        """Divide a row by common factors that are not 0."""
        common = self.context.constant(0)
        for f in row:
            common = common.gcd(f)
        if common == 0:
            return row
        n = int(common.content())
        divisor = self.context.constant(n if self.is_nonzero_number(n) else 1)
        for f in nonzero:
            while common % f == 0 and not common.is_constant():
                common, divisor = common / f, divisor * f
        return tuple(f / divisor for f in row)

    def factors(self, f: flint.fmpz_mpoly) -> list[flint.fmpz_mpoly]:
        """Return the factors of f that are not known to be units."""
        number, powers = factored(f)
        out = [g for g, _ in powers]
        n = abs(number)
        return out if self.is_nonzero_number(n) else [self.context.constant(n), *out]

    def radical(self, f: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Return a polynomial with the same zeros that is squarefree."""
        out = self.one
        for g in self.factors(f):
            out = out * g
        return out
