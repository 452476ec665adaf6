"""Convert square roots between :class:`Surd` and sympy, within bounds for the size of sympy expressions."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield.errors import TooLargeError
from hfield.fields.algebraic.surds import Surd, from_rational, sqrt_rational

if TYPE_CHECKING:
    import sympy


# What closed forms are made of beside roots: the names that sympy, flint and texts share.
FUNCTIONS = ("cos", "sin", "tan", "cosh", "sinh", "tanh", "exp", "log")
ROOTS = ("rootof", "rootof_trace", "rootof_norm")  # of polynomials over ℚ, see polynomial_roots
MAX_OPERATIONS = 3_000


def times(x: sympy.Expr, y: sympy.Expr) -> sympy.Expr:
    """Return x·y in sympy, unexpanded if the expanded product could be too large."""
    _check_operations(max(int(x.count_ops()), 1) * max(int(y.count_ops()), 1) // 20)
    return x * y


def check_size(expr: sympy.Expr) -> None:
    """Raise :class:`TooLargeError` for a sympy expression that is too large."""
    _check_operations(int(expr.count_ops()))


def _check_operations(operations: int) -> None:
    if operations > MAX_OPERATIONS:
        raise TooLargeError(
            f"a closed form of {operations} operations; at most {MAX_OPERATIONS} are computed with"
        )


def surd_of(expr: sympy.Expr) -> Surd | None:
    """Return an expression in square roots of rational numbers as a surd, or None."""
    import sympy

    if expr.is_Rational:
        return from_rational(Fraction(int(expr.p), int(expr.q)))
    if expr is sympy.I:
        return sqrt_rational(flint.fmpq(-1))
    if expr.is_Pow and expr.base.is_Rational and expr.exp.is_Rational and expr.exp.q == 2:
        root = sqrt_rational(flint.fmpq(int(expr.base.p), int(expr.base.q)))
        return root ** int(expr.exp.p)
    if not (expr.is_Add or expr.is_Mul):
        return None
    parts = [surd_of(arg) for arg in expr.args]
    out = from_rational(0 if expr.is_Add else 1)
    for part in parts:
        if part is None:
            return None
        out = out + part if expr.is_Add else out * part
    return out
