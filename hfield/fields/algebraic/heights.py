"""Decide whether an algebraic number is 0, by lower bounds for nonzero ones from their heights.

A nonzero algebraic number of degree at most d and absolute logarithmic height at most h has absolute
value at least exp(−d·h) (Liouville's inequality; Waldschmidt, *Diophantine Approximation on Linear
Algebraic Groups*, 2000, 3.5). Heights of sums, products and powers are bounded by those of the parts,
and the degree by the product of the degrees of the radicals, so that an enclosure of finite precision
decides; no minimal polynomial is computed.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import lcm, log, perm, prod

import sympy

from hfield.fields.algebraic.polynomial_roots import RootOf


@dataclass
class Bounds:
    """Bounds of an algebraic number: of its height and its degree.

    ``roots`` maps each base under a root to the degrees taken of it; ``order`` is that of a root of
    unity in whose field the cosines and sines lie; ``conjugates`` are numbers of roots of a polynomial.
    """

    height: float = 0.0
    roots: dict[tuple[sympy.Expr, int], int] = field(default_factory=dict)
    order: int = 1
    conjugates: dict[tuple[sympy.Expr, ...], set[int]] = field(default_factory=dict)

    @property
    def degree(self) -> int:
        """A bound of the degree over ℚ of the field of all parts."""
        of_roots = (perm(len(c) - 1, len(chosen)) for c, chosen in self.conjugates.items())
        return prod(self.roots.values()) * prod(of_roots) * int(sympy.totient(self.order))


def bounds(expr: sympy.Expr) -> Bounds | None:
    """Return the bounds of a sympy number, or None if it is not seen to be algebraic."""
    found = Bounds()
    height = _height(expr, found)
    if height is None:
        return None
    found.height = height
    return found


def _height(expr: sympy.Expr, found: Bounds) -> float | None:
    """Return a bound of the logarithmic height; add the sources of the degree to ``found``."""
    if expr.is_Rational:
        return log(max(abs(int(expr.p)), int(expr.q)))
    if expr is sympy.I:
        found.order = lcm(found.order, 4)
        return 0.0
    if expr is sympy.GoldenRatio:
        return _height(expr.expand(func=True), found)
    if expr.is_Add or expr.is_Mul:
        return _height_of_polynomial(expr.args if expr.is_Add else [expr], found)
    if expr.is_Pow and expr.exp.is_Rational:
        h = _height(expr.base, found)
        if h is None:
            return None
        if expr.exp.q > 1:
            found.roots[expr.base, int(expr.exp.q)] = int(expr.exp.q)
        return h * abs(float(expr.exp))
    if isinstance(expr, RootOf):
        found.conjugates.setdefault(expr.args[1:], set()).update(expr.conjugates)
        return expr.height
    return _cyclotomic(expr, found)


def _height_of_polynomial(terms: Sequence[sympy.Expr], found: Bounds) -> float | None:
    """Bound a sum of products of parts: by the size of the coefficients, and each part by its highest power.

    1/x counts as a part beside x, of the same height.
    """
    coefficients, powers = [], dict[tuple[sympy.Expr, bool], int]()
    for term in terms:
        coefficient, factors = term.as_coeff_mul()
        if not coefficient.is_Rational:
            coefficient, factors = sympy.Integer(1), (coefficient, *factors)
        coefficients.append(coefficient)
        for factor in factors:
            base, exponent = factor.as_base_exp()
            if not exponent.is_Integer or base is sympy.E:
                base, exponent = factor, sympy.Integer(1)
            part = base, exponent < 0
            powers[part] = max(powers.get(part, 0), abs(int(exponent)))
    below = lcm(*(int(c.q) for c in coefficients))
    height = log(max(below, int(sum(abs(c) for c in coefficients) * below)))
    for (part, _), power in powers.items():
        h = _height(part, found)
        if h is None:
            return None
        height += power * h
    return height


def _cyclotomic(expr: sympy.Expr, found: Bounds) -> float | None:
    """Bound values of cos, sin, tan and exp at rational multiples of π: sums of roots of unity."""
    angle = _angle(expr)
    if angle is None:
        return None
    found.order = lcm(found.order, 4 * int(angle.q))
    # ζ has height 0; cos and sin are (ζ ± 1/ζ) over 2 or 2i, tan is their quotient.
    return {sympy.cos: 2, sympy.sin: 2, sympy.tan: 4}.get(expr.func, 0) * log(2)


def _angle(expr: sympy.Expr) -> sympy.Expr | None:
    """Return r where expr is a function of cos, sin, tan at r·π, or exp(i·r·π); else None."""
    if expr.func in (sympy.cos, sympy.sin, sympy.tan):
        ratio = expr.args[0] / sympy.pi
    elif expr.func is sympy.exp:
        ratio = expr.args[0] / (sympy.I * sympy.pi)
    else:
        return None
    return ratio if ratio.is_Rational else None
