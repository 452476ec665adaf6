"""Recognise closed forms that are 0 by the field axioms alone: they are quotients of polynomials in their
radicals.

Each radical ``b^(1/n)``, and each other part, becomes a variable. The number is 0 if its numerator is 0 once
every ``(b^(1/n))ⁿ`` is replaced by b, however many digits a numerical test would need. Numbers that vanish by
another relation, such as √(5 + 2√6) = √2 + √3, are not recognised here.
"""

from __future__ import annotations

from functools import reduce
from math import lcm

import flint
import sympy

from hfield.core.factorisation import factor

MAX_TERMS = 1_000_000  # products of terms that are worked out, and terms that are examined
MAX_DEGREE = 5_000  # of a radical

Quotient = tuple[flint.fmpq_mpoly, flint.fmpq_mpoly]


class _TooLongError(Exception):
    """Polynomials too long to expand."""


def vanishes_identically(expr: sympy.Expr) -> bool:
    """Return whether a sympy number, whose denominators are not 0, is recognised as 0 by the field axioms."""
    try:
        return _Variables(expr).vanish()
    except _TooLongError:
        return False


def _powers(node: sympy.Expr) -> dict[sympy.Expr, sympy.Rational]:
    """Return the bases and exponents of a product; {} for other parts.

    A part that is not a power is its own base.
    """
    if node is sympy.I:
        return {sympy.S.NegativeOne: sympy.Rational(1, 2)}
    if node.is_Rational or node.is_Add or node.is_Mul:
        return {}
    if not (node.is_Pow and node.exp.is_Rational):
        return {node: sympy.S.One}
    base, exponent = node.base, node.exp
    if exponent.is_Integer:
        return {}
    if not base.is_Rational:
        return {base: exponent}
    found = {sympy.S.NegativeOne: exponent} if base < 0 else {}  # the roots are principal
    for n, sign in ((abs(int(base.p)), 1), (int(base.q), -1)):
        parts = factor(n)
        rest = {parts.rest.value: 1} if parts.rest else {}
        for p, e in {**parts.primes, **rest}.items():
            found[sympy.Integer(p)] = sign * e * exponent
    return found


class _Variables:
    """Variables for the bases of radicals and for the other parts of a sympy number.

    ``degrees`` maps each base to its degree, with bases before those that contain them; the variable of b
    stands for ``b^(1/degree)``.
    """

    def __init__(self, expr: sympy.Expr) -> None:
        self.expr = expr
        self.degrees: dict[sympy.Expr, int] = {}
        for node in sympy.postorder_traversal(expr):
            for base, exponent in _powers(node).items():
                self.degrees[base] = lcm(self.degrees.get(base, 1), int(exponent.q))
        if max(self.degrees.values(), default=1) > MAX_DEGREE:
            raise _TooLongError
        names = tuple(f"x{n}" for n in range(len(self.degrees)))
        self.context = flint.fmpq_mpoly_ctx.get(names, "lex")
        self.variables = dict(zip(self.degrees, self.context.gens(), strict=True))
        self.known: dict[sympy.Expr, Quotient] = {}
        self.left = MAX_TERMS

    def vanish(self) -> bool:
        """Return whether the numerator is 0 modulo the relations of the radicals."""
        top = self.quotient(self.expr)[0]
        for base in reversed(self.degrees):
            if base not in _powers(base):
                top = self._reduced(top, base)
        return bool(top == 0)

    def quotient(self, expr: sympy.Expr) -> Quotient:
        """Return the number as a quotient of polynomials."""
        if expr not in self.known:
            self.known[expr] = self._quotient(expr)
        return self.known[expr]

    def _quotient(self, expr: sympy.Expr) -> Quotient:
        if expr.is_Rational:
            return self._constant(int(expr.p)), self._constant(int(expr.q))
        if expr.is_Add:
            return self._sum([self.quotient(arg) for arg in expr.args])
        if expr.is_Mul:
            return reduce(self._product, map(self.quotient, expr.args))
        powers = _powers(expr)
        if not powers:
            return self._power(self.quotient(expr.base), int(expr.exp))
        one = self._constant(1)
        return reduce(
            self._product,
            (
                self._power((self.variables[base], one), int(exponent * self.degrees[base]))
                for base, exponent in powers.items()
            ),
        )

    def _constant(self, n: int) -> flint.fmpq_mpoly:
        return self.context.constant(n)

    def _sum(self, terms: list[Quotient]) -> Quotient:
        parts: list[Quotient] = []  # one for each denominator
        for top, bottom in terms:
            k = next((k for k, part in enumerate(parts) if part[1] == bottom), len(parts))
            parts[k : k + 1] = [(parts[k][0] + top, bottom) if k < len(parts) else (top, bottom)]
        top, bottom = parts[0]
        for other, below in parts[1:]:
            self._spend(10 * len(bottom) * len(below))
            common = bottom.gcd(below)
            more = below / common
            top, bottom = (
                self._times(top, more) + self._times(other, bottom / common),
                self._times(bottom, more),
            )
        return top, bottom

    def _product(self, x: Quotient, y: Quotient) -> Quotient:
        return self._times(x[0], y[0]), self._times(x[1], y[1])

    def _power(self, x: Quotient, n: int) -> Quotient:
        top, bottom = x if n >= 0 else x[::-1]
        one = self._constant(1)
        return reduce(self._product, [(top, bottom)] * abs(n), (one, one))

    def _times(self, x: flint.fmpq_mpoly, y: flint.fmpq_mpoly) -> flint.fmpq_mpoly:
        self._spend(len(x) * len(y))
        return x * y

    def _spend(self, terms: int) -> None:
        self.left -= terms
        if self.left < 0:
            raise _TooLongError

    def _reduced(self, top: flint.fmpq_mpoly, base: sympy.Expr) -> flint.fmpq_mpoly:
        """Return a nonzero multiple of a polynomial in which the radicals of one base have small powers."""
        n, x = self.degrees[base], self.variables[base]
        self._spend(10 * len(top))
        if base == -1:  # a root of unity
            cyclotomic = flint.fmpz_poly.cyclotomic(2 * n).coeffs()
            self._spend(len(top) * len(cyclotomic))
            return top % sum((x**k * int(c) for k, c in enumerate(cyclotomic)), self._constant(0))
        index = list(self.degrees).index(base)
        parts: dict[int, dict[tuple[int, ...], flint.fmpq]] = {}
        for monomial, c in top.to_dict().items():
            whole, rest = divmod(int(monomial[index]), n)
            moved = (*monomial[:index], rest, *monomial[index + 1 :])
            parts.setdefault(whole, {})[moved] = c
        most, (up, down) = max(parts, default=0), self.quotient(base)
        total = self._constant(0)
        for whole, terms in parts.items():
            scale = reduce(self._times, [up] * whole + [down] * (most - whole), self._constant(1))
            total = total + self._times(self.context.from_dict(terms), scale)
        return total
