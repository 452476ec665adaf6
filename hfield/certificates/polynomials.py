"""Polynomials with integer coefficients in many variables: a dict from packed exponents to numbers.

The exponents of a monomial are the digits of one integer in base 2²⁴, so that monomials multiply by
adding. Every product is charged for before it is begun.
"""

import re
from collections.abc import Mapping, Sequence

from hfield.certificates.language import Tree, parse
from hfield.certificates.rejection import MAX_DIGITS, reject, shown
from hfield.certificates.work import charge

BITS = 24
MASK = (1 << BITS) - 1
MAX_EXPONENT = 1 << 16
MAX_PRODUCTS = 1_000_000  # of terms in one multiplication: they bound the memory
MAX_TEXT = 4_000_000

Poly = dict[int, int]

_TERM = re.compile(
    r"\s*([+-]?)\s*((?:[^\s+*(\[-]|\([^()]*\)|\[[0-3]\])(?:[^\s+(\[-]|\([^()]*\)|\[[0-3]\])*)"
)
_FACTOR = re.compile(r"([A-Za-z]\w*(?:\[[0-3]\]|\([^()]*\))?)(?:\*\*([0-9]{1,6}))?")


def constant(c: int) -> Poly:
    """Return a constant."""
    return {0: c} if c else {}


def add(f: Poly, g: Poly, scale: int = 1) -> Poly:
    """Return f + scale·g."""
    charge(len(f) // 8 + len(g))
    out = dict(f)
    for m, c in g.items():
        total = out.get(m, 0) + scale * c
        if total:
            out[m] = total
        else:
            out.pop(m, None)
    return out


def multiply(f: Poly, g: Poly) -> Poly:
    """Return f·g."""
    if len(f) * len(g) > MAX_PRODUCTS:
        reject("a product of polynomials has too many terms")
    bits = max((c.bit_length() for h in (f, g) for c in h.values()), default=0)
    charge(len(f) * len(g) * (1 + bits // 1_000) + len(f) + len(g))
    out: Poly = {}
    for m, c in f.items():
        for n, d in g.items():
            out[m + n] = out.get(m + n, 0) + c * d
    out = {m: c for m, c in out.items() if c}
    if out:
        top = max(out)
        while top:
            if top & MASK > MAX_EXPONENT:
                reject("a degree has grown too large")
            top >>= BITS
        if any(c.bit_length() > 4 * MAX_DIGITS for c in out.values()):
            reject("a coefficient has grown too large")
    return out


def modulo(f: Poly, p: int) -> Poly:
    """Return f with its coefficients reduced modulo p; f itself for p = 0."""
    return {m: c % p for m, c in f.items() if c % p} if p else f


def is_constant(f: Poly) -> bool:
    """Tell whether f is a nonzero constant."""
    return len(f) == 1 and 0 in f


def exponents(m: int, count: int) -> tuple[int, ...]:
    """Return the exponents of a packed monomial."""
    return tuple((m >> (BITS * n)) & MASK for n in range(count))


def divide(f: Poly, g: Poly) -> Poly | None:
    """Return f/g if g divides f over ℤ, else None."""
    lead = max(g)
    rest, out = dict(f), {}
    while rest:
        top = max(rest)
        m, c = top - lead, rest[top]
        if c % g[lead] or not _divides(lead, top):
            return None
        out[m] = c // g[lead]
        charge(len(g))
        for n, d in g.items():
            total = rest.get(m + n, 0) - out[m] * d
            if total:
                rest[m + n] = total
            else:
                rest.pop(m + n, None)
    return out


def _divides(m: int, n: int) -> bool:
    while m:
        if m & MASK > n & MASK:
            return False
        m, n = m >> BITS, n >> BITS
    return True


class Names:
    """The variables of a polynomial ring: each is a tree, such as ``("name", "s")`` or q[0]'s."""

    def __init__(self, variables: Sequence[Tree]) -> None:
        self.variables = tuple(variables)
        self.place: Mapping[Tree, int] = {v: n for n, v in enumerate(self.variables)}
        self._atoms: dict[str, int] = {}

    def variable(self, tree: Tree) -> Poly:
        """Return the variable as a polynomial."""
        return {1 << (BITS * self.place[tree]): 1}

    def extended(self, names: Sequence[str]) -> "Names":
        """Return the same with further variables."""
        return Names((*self.variables, *(("name", name) for name in names)))

    def read(self, text: str, what: str) -> Poly:
        """Read a sum of terms such as ``2*q[0]**2*s``."""
        if len(text) > MAX_TEXT:
            reject(f"{what} is longer than {MAX_TEXT} characters")
        out: Poly = {}
        position = 0
        end = len(text.rstrip())
        while position < end:
            match = _TERM.match(text, position)
            if match is None or (position and not match[1]):
                reject(f"{what} is no polynomial: {shown(text)}")
            m, c = self._term(match[2], what)
            out[m] = out.get(m, 0) + (-c if match[1] == "-" else c)
            position = match.end()
        if not text.strip():
            reject(f"{what} is empty")
        return {m: c for m, c in out.items() if c}

    def _term(self, text: str, what: str) -> tuple[int, int]:
        m, c = 0, 1
        for factor in re.split(r"(?<!\*)\*(?!\*)", text):
            if factor.isdigit() and factor.isascii():
                if len(factor) > MAX_DIGITS:
                    reject(f"a number in {what} has more than {MAX_DIGITS} digits")
                c *= int(factor)
                continue
            match = _FACTOR.fullmatch(factor)
            if match is None:
                reject(f"{what} has a factor that cannot be read: {shown(factor)}")
            power = int(match[2] or 1)
            if power > MAX_EXPONENT:
                reject(f"a degree in {what} is too large")
            m += power << (BITS * self._place(match[1], what))
        if c.bit_length() > 4 * MAX_DIGITS:
            reject(f"a coefficient in {what} is too large")
        for e in exponents(m, len(self.variables)):
            if e > MAX_EXPONENT:
                reject(f"a degree in {what} is too large")
        return m, c

    def _place(self, atom: str, what: str) -> int:
        if atom not in self._atoms:
            place = self.place.get(parse(atom))
            if place is None:
                reject(f"{what} speaks of {shown(atom)!r}, which does not occur in the statement")
            self._atoms[atom] = place
        return self._atoms[atom]
