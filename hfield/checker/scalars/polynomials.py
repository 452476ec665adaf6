"""Polynomials over a domain, in one variable or several."""

import re
from collections.abc import Mapping

from hfield.checker.budget import spend
from hfield.checker.language import Tree
from hfield.checker.rejection import reject, shown
from hfield.checker.scalars.names import blackboard, plain, variables
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing, Ring

MAX_TERMS = 4_000
MAX_DEGREE = 2_000

Poly = tuple[tuple[tuple[int, ...], E], ...]  # exponents and nonzero coefficients, in order


class PolynomialRing(Ring[Poly[E]]):
    """The ring ``base[names]`` over a domain."""

    is_integral = True

    def __init__(self, base: Ring[E], names: tuple[str, ...]) -> None:
        self.base, self.names, self.name = base, names, f"{base.name}[{','.join(names)}]"
        self.words = f"the polynomials in {', '.join(names)} over {blackboard(base.name)}"
        self.characteristic = base.characteristic
        self.wide = 1 + len(names) // 10  # cost of a monomial's exponents
        self.zero: Poly[E] = ()
        self.one: Poly[E] = self._constant(base.one)

    def number(self, n: int) -> Poly[E]:
        """Return n·1."""
        return self._constant(self.base.number(n))

    def add(self, x: Poly[E], y: Poly[E]) -> Poly[E]:
        """Return x + y."""
        spend(self.wide * (len(x) + 4 * len(y)))
        out = dict(x)
        for m, c in y:
            out[m] = self.base.add(out[m], c) if m in out else c
        return self._poly(out)

    def neg(self, x: Poly[E]) -> Poly[E]:
        """Return −x."""
        spend(2 * len(x))
        return tuple((m, self.base.neg(c)) for m, c in x)

    def mul(self, x: Poly[E], y: Poly[E]) -> Poly[E]:
        """Return x·y."""
        if len(x) * len(y) > MAX_TERMS**2 // 16:
            reject(f"an element of {self.name} has grown too large")
        spend((4 + self.wide) * len(x) * len(y))
        out: dict[tuple[int, ...], E] = {}
        for m, c in x:
            for n, d in y:
                key = tuple([a + b for a, b in zip(m, n, strict=True)])
                term = self.base.mul(c, d)
                out[key] = self.base.add(out[key], term) if key in out else term
        return self._poly(out)

    def inverse(self, x: Poly[E]) -> Poly[E] | None:
        """Return 1/x for a constant unit (the base is a domain)."""
        if len(x) != 1 or any(x[0][0]):
            return None
        c = self.base.inverse(x[0][1])
        return None if c is None else self._constant(c)

    def constant(self, tree: Tree) -> Poly[E] | None:
        """Return a variable, or a constant of the base."""
        spend(self.wide)
        if tree[0] == "name" and tree[1] in self.names:
            place = self.names.index(tree[1])
            return ((tuple(int(n == place) for n in range(len(self.names))), self.base.one),)
        c = self.base.constant(tree)
        return None if c is None else self._constant(c)

    def _constant(self, c: E) -> Poly[E]:
        return () if self.base.is_zero(c) else (((0,) * len(self.names), c),)

    def _poly(self, values: dict[tuple[int, ...], E]) -> Poly[E]:
        spend(len(values))
        out = tuple(sorted((m, c) for m, c in values.items() if not self.base.is_zero(c)))
        if len(out) > MAX_TERMS:
            reject(f"an element of {self.name} has more than {MAX_TERMS} terms")
        return out


def dense(f: Poly[E], base: Ring[E]) -> list[E]:
    """Return the coefficients of a polynomial in one variable, low degree first."""
    if not f:
        return []
    if f[-1][0][0] > MAX_DEGREE:
        reject(f"a polynomial has a degree above {MAX_DEGREE}")
    spend(1 + f[-1][0][0] // 4)
    out = [base.zero] * (f[-1][0][0] + 1)
    for (n,), c in f:
        out[n] = c
    return out


def _polynomials(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    base = ring(plain(data, "base variables")["base"])
    prime = base.is_field and base.order == base.characteristic
    if base.name not in ("ZZ", "QQ") and not (prime or base.is_number_field):
        reject(f"polynomials are over ZZ, QQ, a number field or GF(p), not over {shown(base.name)}")
    names = variables(data["variables"], base)
    number = next((name for name in names if re.fullmatch("zeta_?[0-9]+", name)), None)
    if number:
        reject(
            f"{base.name}[{','.join(names)}] reads as the ring that the number {number} generates"
        )
    return PolynomialRing(base, names)


KINDS: dict[str, Kind] = {"polynomials": _polynomials}
