"""Read and write the polynomials of evidence in Coq's notation.

To find the polynomials to which the evidence refers, terms are computed in the same way as in Coq: a
numerator over a product of divisors, without any cancellation. Nothing here is trusted, because Coq
recomputes all of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from flint import Ordering, fmpz_mpoly_ctx

from hfield.checker.language import parse
from hfield.checker.polynomials import Names
from hfield.checker.rejection import Rejected
from hfield.errors import HFieldError, TooLargeError

if TYPE_CHECKING:
    import flint


class MismatchError(HFieldError, ValueError):
    """The evidence does not fit the statement; the message says why."""


def written(polynomial: flint.fmpz_mpoly) -> str:
    """Write a polynomial of flint in Coq's notation, with variables numbered from 1."""
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
    """The numerators as polynomials in coordinates, and the denominators."""

    def __init__(self, atoms: Sequence[str]) -> None:
        self.atoms = list(atoms)
        names = [f"v{n}" for n in range(max(len(atoms), 1))]
        self.context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
        self.gens = dict(zip(self.atoms, self.context.gens(), strict=False))
        self._names = Names([parse(atom) for atom in self.atoms])
        self.factors: list[flint.fmpz_mpoly] = []

    def read(self, text: str) -> flint.fmpz_mpoly:
        """Read a polynomial in the coordinates, as the checker does. Raises :class:`MismatchError`."""
        if not isinstance(text, str):
            raise MismatchError("a polynomial is expected to be a text")
        try:
            found = self._names.read(text, "a polynomial")
        except Rejected as error:
            raise MismatchError(str(error)) from error
        n = self.context.nvars()
        terms = {}
        for monomial, coefficient in found.items():
            powers = dict(monomial)
            terms[tuple(powers.get(k, 0) for k in range(n))] = coefficient
        return self.context.from_dict(terms)

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
        """Return a product of powers of the divisors."""
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
    """A polynomial divided by powers (``below``) of the divisors."""

    ring: Numerators
    top: flint.fmpz_mpoly
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
    """Return a product. Raises :class:`TooLargeError` if it is too large to expand."""
    if len(f) * len(g) > MAX_TERMS:
        raise TooLargeError(f"a product of polynomials has more than {MAX_TERMS} terms")
    return f * g


def _joined(
    x: tuple[int, ...], y: tuple[int, ...], how: Callable[[tuple[int, int]], int]
) -> tuple[int, ...]:
    width = max(len(x), len(y))
    pairs = zip((*x, *[0] * (width - len(x))), (*y, *[0] * (width - len(y))), strict=True)
    return tuple(how(pair) for pair in pairs)
