"""The polynomials of evidence: texts with integer coefficients, read and written in Coq's notation."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from hfield.coq.numerators import MAX_TERMS, Numerators, times
from hfield.errors import HFieldError, TooLargeError

if TYPE_CHECKING:
    import flint


MAX_LENGTH = 400_000  # characters of one polynomial
MAX_DEPTH = 40
_TOKEN = re.compile(r"\s*(?:(\d+)|([A-Za-z]\w*)(?:\[([0-3])\])?|(\*\*|[-+*()^]))")


class MismatchError(HFieldError, ValueError):
    """Evidence that cannot be about the statement; the message says why."""


class Reader:
    """Reads polynomials in the atoms of some numerators."""

    def __init__(self, numerators: Numerators) -> None:
        self.numerators = numerators

    def value(self, text: str) -> flint.fmpz_mpoly:
        """Return a polynomial. Raises :class:`MismatchError` and :class:`TooLargeError`."""
        return _Parser(text, self.numerators).run()

    def coq(self, text: str) -> str:
        """Return a polynomial in Coq's notation."""
        return written(self.value(text))


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
            assert m is not None
            number, name, index, sign = m.groups()
            if number:
                self.tokens.append(("number", int(number)))
            elif name:
                self.tokens.append(("name", name if index is None else f"{name}[{index}]"))
            else:
                self.tokens.append(("sign", "**" if sign == "^" else sign))
            position = m.end()

    def fail(self) -> None:
        """Raise the error."""
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
