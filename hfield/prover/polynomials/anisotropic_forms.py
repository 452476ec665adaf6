"""Find anisotropic forms as factors of a polynomial.

``s² − 2y² = 0`` implies s = y = 0 over ℚ, since 2 is not a square; ``s² + y² − 3z² = 0`` implies that all
three are 0, since (−1, 3) is a division algebra over ℚ. A quadratic polynomial is first written as Σ c·L² by
Lagrange's method.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import gcd, isqrt
from typing import TYPE_CHECKING, TypeAlias

from hfield.core.product import Scalar
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.scalars import constant
from hfield.prover.polynomials.field_rules import Rule, norm_rule_of
from hfield.prover.polynomials.recognition import polynomial_text
from hfield.prover.polynomials.vanishing import collected, factored, value_at

if TYPE_CHECKING:
    import flint


MAX_DEGREE = 12
MAX_TERMS = 60

Square: TypeAlias = "tuple[flint.fmpz, flint.fmpz_mpoly]"  # c and L of c·L²


@dataclass(frozen=True)
class AnisotropicForm:
    """A form ``value`` in ``terms`` that is 0 only if all terms are; ``step`` is its notation in evidence."""

    value: flint.fmpz_mpoly
    terms: tuple[flint.fmpz_mpoly, ...]
    step: Mapping[str, object]
    rule: Rule | None = None  # its own rule, in addition to the one for roots


class FormFinder:
    """Finds forms in polynomials; the variables from index ``unknowns`` on, called ``names``, are
    constants.
    """

    def __init__(
        self, names: tuple[str, ...], unknowns: int, field: Ring, context: flint.fmpz_mpoly_ctx
    ) -> None:
        self.names, self.unknowns, self.field, self.context = names, unknowns, field, context
        self.gens = context.gens()
        self.free = [n for n in range(len(self.gens)) if not unknowns <= n < len(names)]
        self.one = context.constant(1)

    def of(self, f: flint.fmpz_mpoly) -> Iterator[AnisotropicForm]:
        """Yield the forms equal to f up to a factor."""
        if not 2 <= len(f) <= MAX_TERMS:
            return
        yield from self.binary(f)
        squares = self.diagonal(f)
        if squares is not None:
            yield from self.quadratic(squares)

    # --- binary forms ----------------------------------------------------------------------------

    def binary(self, f: flint.fmpz_mpoly) -> Iterator[AnisotropicForm]:
        """Yield the ways to write f as Σ cₖ·X^k·Y^(n−k) with monomials X and Y."""
        parts = self.coefficients(f)
        monomials = list(parts)
        for top in monomials:
            for bottom in monomials:
                if not any(top) or any(a and b for a, b in zip(top, bottom, strict=True)):
                    continue
                common = gcd(*top, *bottom)
                for n in range(2, min(common, MAX_DEGREE) + 1):
                    found = self.along(parts, top, bottom, n) if common % n == 0 else None
                    if found is not None and self.field.is_rootless(self.values(found)):
                        yield self.made(found, top, bottom, n)

    def along(
        self,
        parts: Mapping[tuple[int, ...], flint.fmpz_mpoly],
        top: tuple[int, ...],
        bottom: tuple[int, ...],
        n: int,
    ) -> list[flint.fmpz_mpoly] | None:
        """Return the coefficients c₀ … cₙ if all monomials lie between X^n and Y^n."""
        coefficients = [self.context.constant(0)] * (n + 1)
        for m, c in parts.items():
            for k in range(n + 1):
                if all(
                    e * n == k * a + (n - k) * b for e, a, b in zip(m, top, bottom, strict=True)
                ):
                    coefficients[k] = c
                    break
            else:
                return None
        return coefficients

    def made(
        self,
        coefficients: list[flint.fmpz_mpoly],
        top: tuple[int, ...],
        bottom: tuple[int, ...],
        n: int,
    ) -> AnisotropicForm:
        """Return the binary form."""
        x, y = (self.context.from_dict({tuple(e // n for e in m): 1}) for m in (top, bottom))
        return self.form(coefficients, x, y)

    def form(
        self, coefficients: list[flint.fmpz_mpoly], x: flint.fmpz_mpoly, y: flint.fmpz_mpoly
    ) -> AnisotropicForm:
        """Return Σ cₖ·x^k·y^(n−k) as an anisotropic form."""
        n = len(coefficients) - 1
        zero = self.context.constant(0)
        value = sum((c * x**k * y ** (n - k) for k, c in enumerate(coefficients)), zero)
        step = {"step": "binary form", "coefficients": [self.text(c) for c in coefficients]}
        return AnisotropicForm(value, (x, y), step)

    # --- quadratic forms -------------------------------------------------------------------------

    def diagonal(self, f: flint.fmpz_mpoly) -> list[Square] | None:
        """Return squares with Σ c·L² a multiple of f (Lagrange), or None if a step has no square term."""
        degrees = [sum(int(m[n]) for n in self.free) for m, _ in f.terms()]
        if max(degrees) != 2:
            return None
        squares: list[Square] = []
        sign, rest = 1, f
        while rest != 0:
            found = self.square_in(rest)
            if found is None:
                if any(self.coefficients(rest).keys() - {(0,) * len(self.gens)}):
                    return None
                squares.append((sign * rest, self.one))
                break
            n, a = found
            slope = rest.derivative(n)
            squares = [(4 * a * c, g) for c, g in squares]
            squares.append((self.context.constant(sign), slope))
            sign, rest = -sign, slope * slope - 4 * a * rest
            if len(rest) > MAX_TERMS:
                return None
        return self.lightened(squares)

    def square_in(self, f: flint.fmpz_mpoly) -> tuple[int, flint.fmpz_mpoly] | None:
        """Return a variable whose square occurs, with its coefficient."""
        parts = self.coefficients(f)
        for n in self.free:
            m = tuple(2 if k == n else 0 for k in range(len(self.gens)))
            if m in parts and not self.is_zero(parts[m]):
                return n, parts[m]
        return None

    def lightened(self, squares: list[Square]) -> list[Square]:
        """Move square factors of coefficients into the linear forms, and cancel common factors."""
        out = []
        for c, g in squares:
            n = int(g.content())
            c, g = c * n * n, g / n
            out.append((c, g))
        common = gcd(*(int(c.content()) for c, _ in out))
        made = []
        for c, g in out:
            c = c / common
            root, rest = square_part(int(c.content()))
            made.append(((c / int(c.content())) * rest, root * g))
        return made

    def quadratic(self, squares: list[Square]) -> Iterator[AnisotropicForm]:
        """Yield the reasons why Σ c·L² is 0 only if all L are 0."""
        if any(self.is_zero(c) for c, _ in squares):
            return
        zero = self.context.constant(0)
        value = sum((c * g * g for c, g in squares), zero)
        if all(c.is_constant() for c, _ in squares):
            numbers = [int(c.leading_coefficient()) for c, _ in squares]
            if all(n > 0 for n in numbers) or all(n < 0 for n in numbers):
                step = {"step": "squares", "coefficients": [abs(n) for n in numbers]}
                positive = value if numbers[0] > 0 else -value
                yield AnisotropicForm(positive, tuple(g for _, g in squares), step)
        if len(squares) == 2:
            (a, x), (b, y) = squares
            if self.field.is_rootless(self.values([b, zero, a])):
                yield self.form([b, zero, a], x, y)
        if len(squares) == 3:
            yield from self.ternary(squares)

    def ternary(self, squares: list[Square]) -> Iterator[AnisotropicForm]:
        """Return a·(a·X² + b·Y² + c·Z²) as the norm of (−ab, −ac), if that is a division algebra."""
        (a, x), (b, y), (c, z) = squares
        (p, alpha), (q, beta) = (square_free(-a * other) for other in (b, c))
        rule = norm_rule_of(self.field, self.text(alpha), self.text(beta))
        if rule is None:
            return
        terms = (a * x, p * y, q * z, self.context.constant(0))
        value = terms[0] ** 2 - alpha * terms[1] ** 2 - beta * terms[2] ** 2
        yield AnisotropicForm(value, terms, {"step": "norm", "algebra": rule.algebra}, rule)

    # --- coefficients ----------------------------------------------------------------------------

    def coefficients(self, f: flint.fmpz_mpoly) -> dict[tuple[int, ...], flint.fmpz_mpoly]:
        """Return the coefficients, polynomials in the constants, by exponents of the free variables."""
        return collected(f, self.free)

    def value(self, f: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
        """Return a polynomial in the constants as an element of the field."""
        known = range(self.unknowns, len(self.names))
        return value_at(f, {n: constant(self.field, self.names[n]) for n in known}, self.field)

    def values(self, coefficients: list[flint.fmpz_mpoly]) -> list[Scalar]:
        """Return coefficients as elements of the field."""
        return [self.value(c) for c in coefficients]

    def is_zero(self, f: flint.fmpz_mpoly) -> bool:
        """Return whether a polynomial in the constants is 0."""
        return bool(self.field.is_zero(self.value(f)))

    def text(self, f: flint.fmpz_mpoly) -> str:
        """Write a polynomial in the constants."""
        return polynomial_text(f, self.names)


@lru_cache(maxsize=1024)
def square_part(n: int) -> tuple[int, int]:
    """Return (m, r) with |n| = m²·|r| and r of the sign of n; m contains only small primes."""
    m, rest, p = 1, n, 2
    while p * p <= abs(rest) and p < 1000:
        while rest % (p * p) == 0:
            m, rest = m * p, rest // (p * p)
        p += 1
    root = isqrt(abs(rest))
    if root * root == abs(rest) and rest:
        m, rest = m * root, rest // (root * root)
    return m, rest


def square_free(f: flint.fmpz_mpoly) -> tuple[flint.fmpz_mpoly, flint.fmpz_mpoly]:
    """Return (m, g) with f = m²·g, by factoring f."""
    number, powers = factored(f)
    m, rest = square_part(number)
    root, free = f.context().constant(m), f.context().constant(rest)
    for g, e in powers:
        root, free = root * g ** (e // 2), free * g ** (e % 2)
    return root, free
