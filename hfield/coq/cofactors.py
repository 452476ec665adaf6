"""The polynomials of evidence: texts with integer coefficients, read and written in Coq's notation."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from hfield.errors import HFieldError
from hfield.syntax.brackets import outside

if TYPE_CHECKING:
    import flint


MAX_LENGTH = 400_000  # characters of one polynomial
MAX_DEPTH = 40
_TOKEN = re.compile(r"\s*(?:(\d+)|([A-Za-z]\w*)(?:\[([0-3])\])?|(\*\*|[-+*()^]))")


class MismatchError(HFieldError, ValueError):
    """Evidence that cannot be about the statement; the message says why."""


class Reader:
    """Reads polynomials in some variables, each known by its number in Coq."""

    def __init__(self, places: Mapping[str, int]) -> None:
        self.places = places

    def coq(self, text: str) -> str:
        """Return the text of a polynomial for Coq. Raises :class:`MismatchError`."""
        return str(_Parser(text, self._written).run())

    def value(self, text: str, gens: Mapping[str, Any], constant: Callable[[int], Any]) -> Any:
        """Return a polynomial made of ``gens``. Raises :class:`MismatchError`."""
        self.coq(text)
        return _Parser(text, _Values(gens, constant)).run()

    def _written(self, kind: str, *parts: Any) -> str:
        match kind:
            case "number":
                return f"C {parts[0]}"
            case "name":
                if parts[0] not in self.places:
                    raise MismatchError(f"{parts[0]!r} is no variable of the statement")
                return f"X {self.places[parts[0]]}"
            case "-x":
                return f"(- {parts[0]})"
            case "**":
                return f"({parts[0]}) ^ {parts[1]}" if parts[1] else "C 1"
            case "*":
                return " * ".join(f"({x})" if _is_sum(x) else x for x in parts)
            case _:
                return f"{parts[0]} {kind} {f'({parts[1]})' if _is_sum(parts[1]) else parts[1]}"


class _Values:
    def __init__(self, gens: Mapping[str, Any], constant: Callable[[int], Any]) -> None:
        self.gens, self.constant = gens, constant

    def __call__(self, kind: str, *parts: Any) -> Any:
        match kind:
            case "number":
                return self.constant(parts[0])
            case "name":
                return self.gens[parts[0]]
            case "-x":
                return -parts[0]
            case "**":
                return parts[0] ** parts[1]
            case "*":
                out = parts[0]
                for x in parts[1:]:
                    out = out * x
                return out
            case "+":
                return parts[0] + parts[1]
            case _:
                return parts[0] - parts[1]


def _is_sum(text: str) -> bool:
    return any(n and char in "+-" and text[n - 1] == " " for n, char in outside(text))


class _Parser:
    """Sums of products of powers; ``make`` builds the value of each."""

    def __init__(self, text: str, make: Callable[..., Any]) -> None:
        if not isinstance(text, str) or len(text) > MAX_LENGTH:
            raise MismatchError(f"a polynomial is no text of at most {MAX_LENGTH} characters")
        self.text, self.make, self.at = text, make, 0
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
            out = self.make(sign, out, self.product(depth))
        return out

    def signed(self, depth: int) -> Any:
        """Read a product that may have a sign in front."""
        sign = self.take("+", "-")
        out = self.product(depth)
        return self.make("-x", out) if sign == "-" else out

    def product(self, depth: int) -> Any:
        """Read a product."""
        parts = [self.power(depth)]
        while self.take("*"):
            parts.append(self.power(depth))
        return self.make("*", *parts) if len(parts) > 1 else parts[0]

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
            out = self.make(kind, value)
        if self.take("**"):
            if self.at >= len(self.tokens) or self.tokens[self.at][0] != "number":
                self.fail()
            exponent = self.tokens[self.at][1]
            self.at += 1
            if exponent > 10_000:
                raise MismatchError(f"the exponent {exponent} is too large")
            out = self.make("**", out, exponent)
        return out


def written(polynomial: flint.fmpz_mpoly, places: list[int]) -> str:
    """Write a polynomial of flint for Coq; its variables have these numbers there."""
    out = ""
    for exponents, coefficient in polynomial.terms():
        c = int(coefficient)
        powers = [
            f"X {k}" + (f" ^ {int(n)}" if n > 1 else "")
            for k, n in zip(places, exponents, strict=False)
            if n
        ]
        if abs(c) != 1 or not powers:
            powers.insert(0, f"C {abs(c)}")
        body = " * ".join(powers)
        if out:
            out += f" {'-' if c < 0 else '+'} {body}"
        else:
            out = f"- ({body})" if c < 0 else body
    return out or "C 0"
