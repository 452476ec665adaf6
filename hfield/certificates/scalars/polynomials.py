"""Polynomials over a domain, in one variable or several."""

import re
from collections.abc import Hashable
from typing import Any

from hfield.certificates.language import Tree
from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.names import variable
from hfield.certificates.scalars.ring import ReadRing, Ring
from hfield.certificates.work import charge

MAX_TERMS = 4_000
MAX_DEGREE = 2_000

Poly = tuple[tuple[tuple[int, ...], Any], ...]  # exponents and nonzero coefficients, in order


class Polynomials(Ring):
    """``base[names]``, the base being a domain."""

    is_integral = True

    def __init__(self, base: Ring, names: tuple[str, ...], name: str) -> None:
        self.base, self.names, self.name = base, names, name
        self.characteristic = base.characteristic
        if len(names) == 1:
            self.fractions = f"{base.fractions or base.name}({names[0]})"
        self.zero: Poly = ()
        self.one: Poly = self._constant(base.one)

    def number(self, n: int) -> Poly:
        """Return n·1."""
        return self._constant(self.base.number(n))

    def add(self, x: Poly, y: Poly) -> Poly:
        """Return x + y."""
        out = dict(x)
        for m, c in y:
            out[m] = self.base.add(out[m], c) if m in out else c
        return self._poly(out)

    def neg(self, x: Poly) -> Poly:
        """Return −x."""
        return tuple((m, self.base.neg(c)) for m, c in x)

    def mul(self, x: Poly, y: Poly) -> Poly:
        """Return x·y."""
        if len(x) * len(y) > MAX_TERMS**2 // 16:
            reject(f"an element of {self.name} has grown too large")
        charge(5 * len(x) * len(y))
        out: dict[tuple[int, ...], Any] = {}
        for m, c in x:
            for n, d in y:
                key = tuple([a + b for a, b in zip(m, n, strict=True)])
                term = self.base.mul(c, d)
                out[key] = self.base.add(out[key], term) if key in out else term
        return self._poly(out)

    def inverse(self, x: Poly) -> Poly | None:
        """Return 1/x for a constant unit (the base is a domain)."""
        if len(x) != 1 or any(x[0][0]):
            return None
        c = self.base.inverse(x[0][1])
        return None if c is None else self._constant(c)

    def constant(self, tree: Tree) -> Poly | None:
        """Return a variable, or a constant of the base."""
        if tree[0] == "name" and tree[1] in self.names:
            place = self.names.index(tree[1])
            return ((tuple(int(n == place) for n in range(len(self.names))), self.base.one),)
        c = self.base.constant(tree)
        return None if c is None else self._constant(c)

    def _constant(self, c: Hashable) -> Poly:
        return () if self.base.is_zero(c) else (((0,) * len(self.names), c),)

    def _poly(self, values: dict[tuple[int, ...], Hashable]) -> Poly:
        out = tuple(sorted((m, c) for m, c in values.items() if not self.base.is_zero(c)))
        if len(out) > MAX_TERMS:
            reject(f"an element of {self.name} has more than {MAX_TERMS} terms")
        return out


def dense(f: Poly, base: Ring) -> list[Any]:
    """Return the coefficients of a polynomial in one variable, low degree first."""
    if not f:
        return []
    if f[-1][0][0] > MAX_DEGREE:
        reject(f"a polynomial has a degree above {MAX_DEGREE}")
    out = [base.zero] * (f[-1][0][0] + 1)
    for (n,), c in f:
        out[n] = c
    return out


def read(name: str, ring: ReadRing) -> Ring | None:
    """Return ``ZZ[a,b]``, ``QQ[x]`` or ``GF(5)[x]``."""
    m = re.fullmatch(r"(.+)\[([a-zA-Z][a-zA-Z0-9_]*(?:,[a-zA-Z][a-zA-Z0-9_]*)*)\]", name)
    if m is None:
        return None
    base = ring(m[1])
    if base.name not in ("ZZ", "QQ") and not (base.is_field and base.order == base.characteristic):
        reject(f"{shown(name)}: polynomials are over ZZ, QQ or GF(p)")
    names = tuple(variable(v, base) for v in m[2].split(","))
    if len(set(names)) < len(names):
        reject(f"{shown(name)}: a variable occurs twice")
    return Polynomials(base, names, name)
