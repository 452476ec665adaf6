"""Enclose sympy numbers in flint's complex balls, to any precision and with rigorous error bounds."""

import flint
import sympy

from hfield.fields.algebraic.polynomial_roots import RootOf
from hfield.fields.algebraic.radicals import FUNCTIONS

_FUNCTIONS = {getattr(sympy, name): name for name in FUNCTIONS}


def is_known(expr: sympy.Expr) -> bool:
    """Return whether :func:`evaluate` can enclose the expression: it must not contain symbols, floats or
    unknown functions.
    """
    if expr.is_Rational or expr is sympy.I or expr is sympy.pi or expr is sympy.E:
        return True
    if isinstance(expr, RootOf):
        return True
    if expr.is_Add or expr.is_Mul or expr.is_Pow or expr.func in _FUNCTIONS:
        return all(is_known(arg) for arg in expr.args)
    return False


def evaluate(expr: sympy.Expr, known: dict[sympy.Expr, flint.acb] | None = None) -> flint.acb:
    """Return a ball around a number whose parts are all known, at flint's current precision; each part is
    enclosed once.
    """
    known = {} if known is None else known
    if expr not in known:
        known[expr] = _evaluated(expr, known)
    return known[expr]


def _evaluated(expr: sympy.Expr, known: dict[sympy.Expr, flint.acb]) -> flint.acb:
    if expr.is_Rational:
        return flint.acb(flint.arb(flint.fmpq(int(expr.p), int(expr.q))))
    if expr is sympy.I:
        return flint.acb(0, 1)
    if expr is sympy.pi:
        return flint.acb(flint.arb.pi())
    if expr is sympy.E:
        return flint.acb(flint.arb.const_e())
    if isinstance(expr, RootOf):
        return expr.ball()
    if expr.is_Add or expr.is_Mul:
        out = flint.acb(0 if expr.is_Add else 1)
        for arg in expr.args:
            part = evaluate(arg, known)
            out = out + part if expr.is_Add else out * part
        return out
    if expr.is_Pow and not isinstance(expr, sympy.exp):
        return _power(expr, known)
    return getattr(evaluate(expr.args[0], known), _FUNCTIONS[expr.func])()


def _power(expr: sympy.Expr, known: dict[sympy.Expr, flint.acb]) -> flint.acb:
    """Enclose the principal value of baseᵉˣᵖ."""
    base = evaluate(expr.base, known)
    if expr.exp.is_Integer:
        return base ** int(expr.exp)
    if expr.base.is_real and not base.imag.is_zero():
        base = flint.acb(base.real)  # or the branch cut would run through the ball
    if expr.exp.is_Rational and base.imag.is_zero() and base.real > 0:
        return flint.acb(base.real.root(int(expr.exp.q)) ** int(expr.exp.p))
    return (evaluate(expr.exp, known) * base.log()).exp()
