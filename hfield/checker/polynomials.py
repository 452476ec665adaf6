"""Polynomials with integer coefficients, as dicts from monomials to nonzero coefficients.

A variable is a number. A monomial is a tuple of pairs (variable, exponent) with positive exponents and
descending variables; the empty tuple is 1. So two monomials are equal if and only if the tuples are, and the
order of tuples is the lexicographic order of monomials. Each operation on all terms spends its cost in
advance: it depends on the number of terms, the width of the monomials (the length of the tuples), and the
coefficients.
"""

import re
from collections.abc import Iterable, Sequence

from hfield.checker.budget import spend, spend_products
from hfield.checker.language import Tree, parse
from hfield.checker.rejection import MAX_DIGITS, reject, shown

MAX_EXPONENT = 1 << 16
EXPONENT_BITS = 18  # they hold the sum of two exponents
MAX_DIRECT_TERMS = 1_000  # products of terms, for which nothing is set up
MAX_TEXT = 4_000_000
LONG_NUMBER_BITS = 256  # bits: to compute with shorter numbers takes no longer

Monomial = tuple[tuple[int, int], ...]
Poly = dict[Monomial, int]

ONE: Monomial = ()
_SIGN = re.compile(r"\s*([+-])", re.ASCII)
# A number, or an atom with an exponent; then the sign that shows whether the term continues.
_FACTOR = re.compile(
    r"\s*(?:([0-9]+)|([A-Za-z][A-Za-z0-9_]*(?:\[[0-3]\]|\([^()]*\))?)(?:\*\*([0-9]+))?)"
    r"\s*(\*(?!\*))?",
    re.ASCII,
)


def constant(c: int) -> Poly:
    """Return a constant."""
    return {ONE: c} if c else {}


def variable(number: int) -> Poly:
    """Return a variable."""
    return {((number, 1),): 1}


def add(f: Poly, g: Poly, scale: int = 1) -> Poly:
    """Return f + scale·g."""
    if len(f) > 8:
        spend(len(f) // 8)
    out = dict(f)
    accumulate(out, g, scale)
    return out


def accumulate(f: Poly, g: Poly, scale: int = 1) -> None:
    """Add scale·g to f."""
    spend(1 + 3 * len(g))
    for m, c in g.items():
        _collect(f, m, scale * c)


def multiply(f: Poly, g: Poly) -> Poly:
    """Return f·g."""
    if not f or not g:
        return {}
    terms = len(f) * len(g)
    if terms > MAX_DIRECT_TERMS:
        return _long_product(f, g)
    spend(terms + len(f) * width(g) + len(g) * width(f))
    out: Poly = {}
    for m, c in f.items():
        for n, d in g.items():
            _collect(out, times(m, n), c * d)
    return out


def _long_product(f: Poly, g: Poly) -> Poly:
    """Return f·g, with the exponents of a monomial as digits of one number, so that adding codes multiplies
    monomials.

    The cost of new terms is spent as they occur, because many products may give few terms.
    """
    names = sorted(variables(f) | variables(g))
    long = len(names) // 16
    spend(long * len(f) * len(g))
    spend_products(f.values(), g.values())
    place = {v: n * EXPONENT_BITS for n, v in enumerate(names)}
    left, right = ([(sum(e << place[v] for v, e in m), c) for m, c in h.items()] for h in (f, g))
    sums: dict[int, int] = {}
    for m, c in left:
        before = len(sums)
        for n, d in right:
            sums[m + n] = sums.get(m + n, 0) + c * d
        spend((4 + long) * (len(sums) - before))
    out: Poly = {}
    for digits, c in sums.items():
        monomial = []
        while digits:
            n = (digits.bit_length() - 1) // EXPONENT_BITS
            e = digits >> n * EXPONENT_BITS
            digits -= e << n * EXPONENT_BITS
            if e > MAX_EXPONENT:
                reject("a degree has grown too large")
            monomial.append((names[n], e))
        spend(3 + (1 + long) * len(monomial))
        _collect(out, tuple(monomial), c)
    return out


def width(f: Iterable[Monomial]) -> int:
    """Return the total number of variables in the monomials."""
    return sum(map(len, f))


def times(m: Monomial, n: Monomial) -> Monomial:
    """Return the product of two monomials."""
    if not m or not n:
        return m or n
    exponents = dict(m)
    for v, e in n:
        exponents[v] = exponents.get(v, 0) + e
        if exponents[v] > MAX_EXPONENT:
            reject("a degree has grown too large")
    return tuple(sorted(exponents.items(), reverse=True))


def _collect(f: Poly, m: Monomial, c: int) -> None:
    """Add c·m to f; the cost was spent with the factors."""
    total = f.get(m, 0) + c
    bits = total.bit_length()
    if bits > LONG_NUMBER_BITS:
        spend(bits // 100 + bits * bits // 500_000)
        if bits > 4 * MAX_DIGITS:
            reject("a coefficient has grown too large")
    if total:
        f[m] = total
    else:
        f.pop(m, None)


def power(f: Poly, n: int) -> Poly:
    """Return fⁿ."""
    out = constant(1)
    for _ in range(n):
        out = multiply(out, f)
    return out


def modulo(f: Poly, p: int) -> Poly:
    """Return f with its coefficients reduced modulo p; f itself for p = 0."""
    if not p:
        return f
    spend(len(f))
    if p >> LONG_NUMBER_BITS:
        spend_products([p], f.values())
    return {m: c % p for m, c in f.items() if c % p}


def is_constant(f: Poly) -> bool:
    """Return whether f is a nonzero constant."""
    return len(f) == 1 and ONE in f


def variables(f: Poly) -> set[int]:
    """Return the variables that occur in f."""
    spend(len(f) + width(f))
    return {v for m in f for v, _ in m}


def divide(f: Poly, g: Poly) -> Poly | None:
    """Return f/g if g divides f over ℤ, else None."""
    spend(1 + len(f) + len(g) + width(g))
    lead = max(g)
    rest, out = dict(f), dict[Monomial, int]()
    while rest:
        spend(5 + (len(rest) + width(rest)) // 4)
        top = max(rest)
        exponents = dict(top)
        for v, e in lead:
            exponents[v] = exponents.get(v, 0) - e
        spend_products([rest[top]], [g[lead]])
        if rest[top] % g[lead] or min(exponents.values(), default=0) < 0:
            return None
        m: Monomial = tuple((v, e) for v, e in exponents.items() if e)
        out[m] = rest[top] // g[lead]
        accumulate(rest, multiply({m: out[m]}, g), -1)
    return out


class Names:
    """The variables of a polynomial ring: each is a tree, such as ``("name", "s")`` or the tree of q[0]."""

    def __init__(self, trees: Sequence[Tree]) -> None:
        spend(5 * len(trees))
        self.trees = tuple(trees)
        self.place = {tree: n for n, tree in enumerate(self.trees)}
        if len(self.place) < len(self.trees):
            reject("two variables have the same name")
        self._atoms: dict[str, int] = {}

    def variable(self, tree: Tree) -> Poly:
        """Return the variable as a polynomial."""
        return variable(self.place[tree])

    def extended(self, names: Sequence[str]) -> "Names":
        """Return the names with further variables."""
        return Names((*self.trees, *(("name", name) for name in names)))

    def read(self, text: str, what: str) -> Poly:
        """Read a whole text as a sum of terms such as ``- 2*q[0]**2*s + sqrt(2)``, or reject it."""
        if len(text) > MAX_TEXT:
            reject(f"{what} is longer than {MAX_TEXT} characters")
        spend(10 + len(text))
        out: Poly = {}
        position = 0
        while position < len(text) or not position:
            sign = _SIGN.match(text, position)
            if sign is None and position:
                reject(f"{what} is not a polynomial: {shown(text)}")
            position = sign.end() if sign else position
            exponents = dict[int, int]()
            c, more = -1 if sign and sign[1] == "-" else 1, True
            while more:
                factor = _FACTOR.match(text, position)
                if factor is None:
                    reject(f"{what} is not a polynomial: {shown(text)}")
                position, more = factor.end(), bool(factor[4])
                if factor[1]:
                    c *= _number(factor[1], MAX_DIGITS, what)
                    if c.bit_length() > 4 * MAX_DIGITS:
                        reject(f"a coefficient in {what} is too large")
                else:
                    exponent = _number(factor[3] or "1", 6, what)
                    if not 1 <= exponent <= MAX_EXPONENT:
                        reject(f"an exponent in {what} is not from 1 to {MAX_EXPONENT}")
                    v = self._number(factor[2], what)
                    exponents[v] = exponent = exponents.get(v, 0) + exponent
                    if exponent > MAX_EXPONENT:
                        reject("a degree has grown too large")
            _collect(out, tuple(sorted(exponents.items(), reverse=True)), c)
        return out

    def _number(self, atom: str, what: str) -> int:
        """Return the number of the variable with this notation."""
        if atom not in self._atoms:
            place = self.place.get(parse(atom))
            if place is None:
                reject(f"{what} speaks of {shown(atom)!r}, which does not occur in the statement")
            self._atoms[atom] = place
        return self._atoms[atom]


def _number(digits: str, most: int, what: str) -> int:
    if len(digits) > most:
        reject(f"a number in {what} has more than {most} digits")
    return int(digits)
