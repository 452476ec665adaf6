"""Closed forms as text that RR and CC read back."""

import sympy

from hfield.fields.algebraic.polynomial_roots import RootOf
from hfield.fields.algebraic.radicals import FUNCTIONS
from hfield.fields.base.printing import is_sum, number_text, parentheses, power_text

_FUNCTIONS = tuple(getattr(sympy, name) for name in FUNCTIONS)


def closed_text(expr: sympy.Expr, style: str = "plain") -> str:
    """Write a sympy number with ``sqrt``, ``root(x,n)``, ``cos`` and so on, ``pi`` and ``I``."""
    if style == "latex":
        return str(sympy.latex(expr, imaginary_unit="I"))
    plain = _text(expr)
    if style == "plain":
        return plain
    return plain.replace("-", "−").replace("*", "·").replace("sqrt(", "√(").replace("pi", "π")


def _text(expr: sympy.Expr) -> str:
    if expr.is_Add:
        out = ""
        for arg in expr.as_ordered_terms():
            term = _text(arg)
            out += term if not out or term.startswith("-") else f"+{term}"
        return out
    if expr.is_Mul:
        return _product(expr)
    if expr.is_Rational:
        return number_text(expr)
    if expr is sympy.E:
        return "exp(1)"
    if isinstance(expr, RootOf):
        return f"{expr.spelled}({','.join(map(str, expr.args))})"
    if isinstance(expr, _FUNCTIONS):
        return f"{expr.func.__name__}({_text(expr.args[0])})"
    if expr.is_Pow:
        return _power(expr)
    return str(expr)  # pi, I


def _product(expr: sympy.Expr) -> str:
    """Write a product, with each inverse factor after a slash of its own."""
    sign, factors = "", []
    for n, arg in enumerate(expr.as_ordered_factors()):
        if n == 0 and arg.is_Rational and arg < 0:
            sign, arg = "-", -arg
            if arg == 1:
                continue
        text = _text(arg)
        factors.append(parentheses(text, "plain") if is_sum(text) or text[0] == "-" else text)
    return sign + "*".join(factors)


def _power(expr: sympy.Expr) -> str:
    base, exponent = expr.as_base_exp()
    if not exponent.is_Rational:
        return f"exp({_text(exponent * sympy.log(base))})"
    if exponent < 0:
        text = _text(base**-exponent)
        simple = not is_sum(text) and "*" not in text and "/" not in text
        return f"1/{text if simple else parentheses(text, 'plain')}"
    p, q = int(exponent.p), int(exponent.q)
    if q == 1:
        text = _text(base)
        whole = text.isalnum() or isinstance(base, (*_FUNCTIONS, RootOf))
        return power_text(text if whole else parentheses(text, "plain"), p, "plain")
    if base.is_negative:  # principal: exp(i·π·p/q) times the root of the absolute value
        turn = f"exp(I*pi*{exponent})"
        return turn if base == -1 else f"{_text((-base) ** exponent)}*{turn}"
    inner = _text(base)
    root = f"sqrt({inner})" if q == 2 else f"root({inner},{q})"
    return power_text(root, p, "plain")
