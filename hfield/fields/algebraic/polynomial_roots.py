"""Roots of irreducible polynomials over ℚ as sympy numbers, without radicals.

``rootof(n, c0, …, cd)`` is the n-th root of c0 + … + cd·x^d over ℤ. The real roots come first, in ascending
order, numbered from 0, followed by the pairs of conjugate roots, in each pair the one above the real axis
first. ``rootof_trace`` is the sum of such a pair and ``rootof_norm`` its product, both real; they take the
number of the root above the axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log
from typing import TYPE_CHECKING

import flint
import sympy

from hfield.errors import CoercionError, shorten
from hfield.fields.base.balls import precision
from hfield.fields.base.isolated_roots import IsolatedRoots, isolated_roots

if TYPE_CHECKING:
    from sympy.printing.latex import LatexPrinter

MIN_DEGREE = 3  # below they are written with square roots


class RootOf(sympy.Function):  # type: ignore[misc,unused-ignore]
    """The common part of the three kinds of roots."""

    is_number = is_finite = is_algebraic = True
    spelled = ""  # the function that texts call

    @property
    def roots(self) -> IsolatedRoots:
        """The roots of the polynomial."""
        return isolated_roots(tuple(map(int, self.args[1:])))

    def ball(self) -> flint.acb:
        """Return a ball around the root, at flint's current precision."""
        return self.roots.numbered(int(self.args[0]), flint.ctx.prec)

    @property
    def height(self) -> float:
        """A bound for the logarithmic height: the logarithm of the polynomial's 2-norm, divided by the
        degree.
        """
        squares = sum(int(c) ** 2 for c in self.args[1:])
        return log(squares) / 2 / (len(self.args) - 2)

    @property
    def conjugates(self) -> list[int]:
        """The indices of the conjugate roots."""
        return [int(self.args[0])]

    def _latex(self, printer: LatexPrinter) -> str:
        name = self.spelled.replace("_", r"\_")
        return rf"\operatorname{{{name}}}\left({', '.join(map(str, self.args))}\right)"

    def _eval_evalf(self, prec: int) -> sympy.Expr:
        with precision(prec + 16):
            z = self.ball()
            parts = [
                sympy.Float(str(x.mid().str(prec, radius=False)), prec // 3 + 5)
                for x in (z.real, z.imag)
            ]
        return parts[0] + sympy.I * parts[1]


class Root(RootOf):
    """A root."""

    spelled = "rootof"

    def _eval_is_extended_real(self) -> bool:
        return int(self.args[0]) < self.roots.real_count

    def _eval_conjugate(self) -> sympy.Expr:
        n, real = int(self.args[0]), self.roots.real_count
        return self if n < real else Root(real + ((n - real) ^ 1), *self.args[1:])


class _OfPair(RootOf):
    is_extended_real = is_real = True

    @property
    def conjugates(self) -> list[int]:
        """The indices of the conjugate roots."""
        n = int(self.args[0])
        return [n, n + 1]

    @property
    def height(self) -> float:
        """A bound for the logarithmic height of the number."""
        return 2 * super().height + log(2)


class TraceOfPair(_OfPair):
    """The sum of a root and its conjugate."""

    spelled = "rootof_trace"

    def ball(self) -> flint.acb:
        """Return a ball around it."""
        return flint.acb(super().ball().real * 2)


class NormOfPair(_OfPair):
    """The product of a root and its conjugate."""

    spelled = "rootof_norm"

    def ball(self) -> flint.acb:
        """Return a ball around it."""
        z = super().ball()
        return flint.acb(z.real * z.real + z.imag * z.imag)


KINDS = {kind.spelled: kind for kind in (Root, TraceOfPair, NormOfPair)}


def read(name: str, arguments: Sequence[int | None]) -> sympy.Expr:
    """Return a number of one of the three classes, given by integers. Raises :class:`CoercionError`."""
    whole = [x for x in arguments if x is not None]
    if len(whole) < len(arguments) or not whole:
        raise CoercionError(
            f"{name} takes which root, and the coefficients from low to high, all in ZZ"
        )
    n, *c = whole
    f = flint.fmpz_poly(c)
    factors = f.factor()
    if f.degree() < MIN_DEGREE or abs(factors[0]) != 1 or [e for _, e in factors[1]] != [1]:
        raise CoercionError(
            f"{name} takes a primitive polynomial over ZZ, irreducible and of degree {MIN_DEGREE} or more; "
            f"found {shorten(f)}"
        )
    real = isolated_roots(tuple(c)).real_count
    last = f.degree() - 1
    pair = name != "rootof"
    if not (real if pair else 0) <= n <= last or (pair and (n - real) % 2):
        raise CoercionError(
            f"{name} takes the number of a {'pair of roots' if pair else 'root'}; found {n}"
        )
    return KINDS[name](n, *c)
