"""Elements of rings as expressions of sympy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import flint

from hfield.errors import CoercionError, shorten
from hfield.fields.base.registry import REGISTRY

if TYPE_CHECKING:
    import sympy

Symbols = Mapping[str, "sympy.Symbol"]


def symbol(name: str, symbols: Symbols) -> sympy.Symbol:
    """Return the given symbol of a name, or a symbol without assumptions."""
    import sympy

    return symbols.get(name) or sympy.Symbol(name)


def polynomial_in(x: sympy.Expr, coefficients: Iterable[sympy.Expr | int]) -> sympy.Expr:
    """Return Σ cₙ·xⁿ as an expression, for coefficients from low to high."""
    import sympy

    return sympy.Add(*(c * x**n for n, c in enumerate(coefficients)))


def scalar_to_sympy(x: object, symbols: Symbols) -> sympy.Expr:
    """Return an element of a ring as an expression. Raises :class:`CoercionError` for another value."""
    import sympy

    if isinstance(x, (int, float)):
        return sympy.sympify(x)
    if isinstance(x, (flint.fmpz, flint.fmpq)):
        return sympy.Rational(int(x.numerator), int(x.denominator))
    if isinstance(x, (flint.nmod, flint.fmpz_mod)):
        return sympy.Integer(int(x))
    if isinstance(x, flint.fq_default):
        return polynomial_in(symbol("x", symbols), map(int, x.to_list()))
    if hasattr(x, "field"):
        found: sympy.Expr = x.field.to_sympy(x, symbols)
        return found
    if hasattr(x, "terms") and hasattr(x, "context"):
        gens = [symbol(name, symbols) for name in x.context().names()]
        return sympy.Add(
            *(
                scalar_to_sympy(c, symbols)
                * sympy.Mul(*(g**n for g, n in zip(gens, exponents, strict=True)))
                for exponents, c in x.terms()
            )
        )
    if isinstance(x, complex):
        return sympy.Float(x.real) + sympy.I * sympy.Float(x.imag)
    number = REGISTRY.functions.algebraic_to_sympy(x)
    if number is None:
        raise CoercionError(f"{shorten(repr(x))} ({type(x).__name__}) has no expression in sympy")
    return number
