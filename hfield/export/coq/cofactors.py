"""Read and write the polynomials of evidence in Coq's notation.

To find what evidence speaks of, terms are computed as Coq computes them: a numerator over a product of
divisors, of which nothing is ever cancelled. Nothing here is trusted: Coq computes all of it again.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NoReturn

from flint import Ordering, fmpz_mpoly_ctx

from hfield.errors import HFieldError, TooLargeError

if TYPE_CHECKING:
    import flint


MAX_LENGTH = 400_000  # characters of one polynomial
MAX_DEPTH = 40
_TOKEN = re.compile(r"\s*(?:(\d+)|([A-Za-z]\w*)(?:\[([0-3])\])?|(\*\*|[-+*()^]))")


class MismatchError(HFieldError, ValueError):
    """Evidence that cannot be about the statement; the message says why."""


class _Parser:
    """Sums of products of powers."""

    def __init__(self, text: str, numerators: Numerators) -> None:
        if not isinstance(text, str) or len(text) > MAX_LENGTH:
            raise MismatchError(f"a polynomial is no text of at most {MAX_LENGTH} characters")
        self.text, self.numerators, self.at = text, numerators, 0
        self.tokens: list[tuple[str, Any]] = []
        position, end = 0, len(text.rstrip())
        while position < end:
            m = _TOKEN.match(text, position)
            if m is None:
                self.fail()
            number, name, index, sign = m.groups()
            if number:
                self.tokens.append(("number", int(number)))
            elif name:
                self.tokens.append(("name", name if index is None else f"{name}[{index}]"))
            else:
                self.tokens.append(("sign", "**" if sign == "^" else sign))
            position = m.end()

    def fail(self) -> NoReturn:
        raise MismatchError(f"{self.text[:60]!r} is no polynomial with integer coefficients")

    def take(self, *signs: str) -> str:
        """Take the next token if it is one of these signs."""
        if self.at < len(self.tokens) and self.tokens[self.at][0] == "sign":
            sign = str(self.tokens[self.at][1])
            if sign in signs:
                self.at += 1
                return sign
        return ""

    def run(self) -> Any:
        """Return the value of the whole text."""
        out = self.sum(0)
        if self.at < len(self.tokens):
            self.fail()
        return out

    def sum(self, depth: int) -> Any:
        """Read a sum."""
        if depth > MAX_DEPTH:
            raise MismatchError("a polynomial nests too deeply")
        out = self.signed(depth)
        while sign := self.take("+", "-"):
            term = self.product(depth)
            out = out + term if sign == "+" else out - term
        return out

    def signed(self, depth: int) -> Any:
        """Read a product that may have a sign in front."""
        sign = self.take("+", "-")
        out = self.product(depth)
        return -out if sign == "-" else out

    def product(self, depth: int) -> Any:
        """Read a product."""
        out = self.power(depth)
        while self.take("*"):
            out = times(out, self.power(depth))
        return out

    def power(self, depth: int) -> Any:
        """Read an atom with its exponent."""
        if self.at >= len(self.tokens):
            self.fail()
        kind, value = self.tokens[self.at]
        if kind == "sign":
            if not self.take("("):
                self.fail()
            out = self.sum(depth + 1)
            if not self.take(")"):
                self.fail()
        else:
            self.at += 1
            out = self.atom(kind, value)
        if self.take("**"):
            if self.at >= len(self.tokens) or self.tokens[self.at][0] != "number":
                self.fail()
            exponent = self.tokens[self.at][1]
            self.at += 1
            if exponent > 10_000:
                raise MismatchError(f"the exponent {exponent} is too large")
            if len(out) > 1 and len(out) ** exponent > MAX_TERMS:
                raise TooLargeError(f"a power of a polynomial has more than {MAX_TERMS} terms")
            out = out**exponent
        return out

    def atom(self, kind: str, value: Any) -> Any:
        """Return a number or a variable."""
        if kind == "number":
            return self.numerators.context.constant(value)
        if value not in self.numerators.gens:
            raise MismatchError(f"{value!r} is no variable of the statement")
        return self.numerators.gens[value]


def written(polynomial: flint.fmpz_mpoly) -> str:
    """Write a polynomial of flint for Coq, where its variables are numbered from 1."""
    out = ""
    for exponents, coefficient in polynomial.terms():
        c = int(coefficient)
        powers = [
            f"X {k}" + (f" ^ {int(n)}" if n > 1 else "") for k, n in enumerate(exponents, 1) if n
        ]
        if abs(c) != 1 or not powers:
            powers.insert(0, f"C {abs(c)}")
        body = " * ".join(powers)
        if out:
            out += f" {'-' if c < 0 else '+'} {body}"
        else:
            out = f"- ({body})" if c < 0 else body
    return out or "C 0"


MAX_TERMS = 400_000  # pairs of terms that are multiplied


class Numerators:
    """The polynomials in the coordinates of some unknowns, and what was divided by."""

    def __init__(self, atoms: Sequence[str]) -> None:
        self.atoms = list(atoms)
        names = [f"v{n}" for n in range(max(len(atoms), 1))]
        self.context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
        self.gens = dict(zip(self.atoms, self.context.gens(), strict=False))
        self.factors: list[Any] = []

    def read(self, text: str) -> flint.fmpz_mpoly:
        """Read a polynomial in the coordinates. Raises :class:`MismatchError`, :class:`TooLargeError`."""
        return _Parser(text, self).run()

    def coq(self, text: str) -> str:
        """Return a polynomial in Coq's notation, from its text."""
        return written(self.read(text))

    def number(self, n: int) -> Numerator:
        """Return an integer."""
        return Numerator(self, self.context.constant(n), ())

    def atom(self, name: str) -> Numerator:
        """Return a coordinate."""
        return Numerator(self, self.gens[name], ())

    def product(self, exponents: Sequence[int]) -> flint.fmpz_mpoly:
        """Return a product of powers of what was divided by."""
        out = self.context.constant(1)
        for factor, n in zip(self.factors, exponents, strict=False):
            for _ in range(n):
                out = times(out, factor)
        return out

    def inverse(self, x: Numerator) -> Numerator:
        """Return 1/x, where x is not 0."""
        above = self.product(x.below)
        if x.top == 1:
            return Numerator(self, above, ())
        if x.top not in self.factors:
            self.factors.append(x.top)
        place = self.factors.index(x.top)
        return Numerator(self, above, tuple(int(n == place) for n in range(place + 1)))


@dataclass(frozen=True)
class Numerator:
    """A polynomial over the product of the divisors to the powers ``below``."""

    ring: Numerators
    top: Any
    below: tuple[int, ...]

    def __neg__(self) -> Numerator:
        return Numerator(self.ring, -self.top, self.below)

    def __add__(self, other: Numerator) -> Numerator:
        return self._sum(other, 1)

    def __sub__(self, other: Numerator) -> Numerator:
        return self._sum(other, -1)

    def __mul__(self, other: Numerator) -> Numerator:
        return self._made(times(self.top, other.top), _joined(self.below, other.below, sum))

    def _sum(self, other: Numerator, sign: int) -> Numerator:
        common = _joined(self.below, other.below, max)
        tops = []
        for x in (self, other):
            own = (*x.below, *[0] * len(common))
            missing = [n - m for n, m in zip(common, own, strict=False)]
            tops.append(times(x.top, self.ring.product(missing)))
        return self._made(tops[0] + sign * tops[1], common)

    def _made(self, top: flint.fmpz_mpoly, below: tuple[int, ...]) -> Numerator:
        return Numerator(self.ring, top, below if top != 0 else ())


def times(f: flint.fmpz_mpoly, g: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
    """Return a product. Raises :class:`TooLargeError` when it is too large to expand."""
    if len(f) * len(g) > MAX_TERMS:
        raise TooLargeError(f"a product of polynomials has more than {MAX_TERMS} terms")
    return f * g


def _joined(x: tuple[int, ...], y: tuple[int, ...], how: Any) -> tuple[int, ...]:
    width = max(len(x), len(y))
    pairs = zip((*x, *[0] * (width - len(x))), (*y, *[0] * (width - len(y))), strict=True)
    return tuple(how(pair) for pair in pairs)
