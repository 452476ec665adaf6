"""Commutative rings with 16 elements and fewer, as tables of sums and products.

Every ring is built from ℤ/n by three constructions, adjoining a root of a monic polynomial, dividing
by an ideal, and products, all on tables; the axioms are tested (test_small_rings.py), not trusted.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import product as pairs

import numpy as np

MAX_ORDER = 16


@dataclass(frozen=True, eq=False)
class Table:
    """A finite commutative ring; elements are 0 … order − 1, and 0 is zero."""

    name: str
    plus: np.ndarray
    times: np.ndarray
    one: int
    generator: int | None = None  # the class of x, where a root was adjoined last

    @property
    def order(self) -> int:
        """The number of elements."""
        return len(self.plus)

    @cached_property
    def minus(self) -> np.ndarray:
        """The opposite of each element."""
        return np.argmax(self.plus == 0, axis=1)

    @cached_property
    def multiples(self) -> np.ndarray:
        """The multiples 0, 1, 2, … of one; as many as the characteristic."""
        out = [0]
        while (following := int(self.plus[out[-1], self.one])) != 0:
            out.append(following)
        return np.array(out)

    @property
    def characteristic(self) -> int:
        """The least n with n·1 = 0."""
        return len(self.multiples)

    @cached_property
    def inverse(self) -> np.ndarray:
        """The inverse of each unit, −1 for what is none."""
        is_one = self.times == self.one
        return np.where(is_one.any(axis=1), np.argmax(is_one, axis=1), -1)

    @property
    def is_field(self) -> bool:
        """Whether all but 0 are units."""
        return bool((self.inverse[1:] >= 0).all())

    @property
    def is_reduced(self) -> bool:
        """Whether no square but that of 0 is 0."""
        return bool((np.diagonal(self.times)[1:] != 0).all())


def integers_modulo(n: int) -> Table:
    """Return ℤ/n."""
    x = np.arange(n)
    return Table(f"Z/{n}", (x[:, None] + x) % n, (x[:, None] * x) % n, 1 % n)


def with_root(base: Table, polynomial: Sequence[int], name: str) -> Table:
    """Return base[x]/(f) for a monic f, whose coefficients are elements, low degree first."""
    degree = len(polynomial) - 1
    elements = [tuple(reversed(t)) for t in pairs(range(base.order), repeat=degree)]
    place = {t: n for n, t in enumerate(elements)}

    def times(f: tuple[int, ...], g: tuple[int, ...]) -> int:
        wide = [0] * (2 * degree)
        for m, u in enumerate(f):
            for n, v in enumerate(g):
                wide[m + n] = base.plus[wide[m + n], base.times[u, v]]
        for top in range(2 * degree - 1, degree - 1, -1):
            for n, c in enumerate(polynomial[:-1]):
                less = base.minus[base.times[wide[top], c]]
                wide[top - degree + n] = base.plus[wide[top - degree + n], less]
        return place[tuple(map(int, wide[:degree]))]

    sums = [
        [place[tuple(int(base.plus[u, v]) for u, v in zip(f, g, strict=True))] for g in elements]
        for f in elements
    ]
    products = [[times(f, g) for g in elements] for f in elements]
    rest = (0,) * (degree - 1)
    root = place[(0, 1, *rest[1:])] if degree > 1 else int(base.minus[polynomial[0]])
    return Table(name, np.array(sums), np.array(products), place[(base.one, *rest)], root)


def divided_by(ring: Table, generators: Sequence[int], name: str) -> Table:
    """Return the ring modulo the ideal of some elements."""
    ideal = {0}
    added = {int(ring.times[g, x]) for g in generators for x in range(ring.order)}
    while not added <= ideal:
        ideal |= added
        added = {int(ring.plus[x, y]) for x in ideal for y in ideal}
    of = np.array([min(int(ring.plus[x, d]) for d in ideal) for x in range(ring.order)])
    kept = sorted(set(of.tolist()))
    label = {x: n for n, x in enumerate(kept)}
    small = np.array([label[x] for x in of.tolist()])
    here = np.ix_(kept, kept)
    return Table(name, small[ring.plus[here]], small[ring.times[here]], int(small[ring.one]))


def both(left: Table, right: Table) -> Table:
    """Return the product of two rings."""
    n = right.order
    x, y = np.divmod(np.arange(left.order * n), n)
    plus = left.plus[np.ix_(x, x)] * n + right.plus[np.ix_(y, y)]
    times = left.times[np.ix_(x, x)] * n + right.times[np.ix_(y, y)]
    return Table(f"{left.name} x {right.name}", plus, times, left.one * n + right.one)


CONWAY = {4: (2, (1, 1, 1)), 8: (2, (1, 1, 0, 1)), 9: (3, (2, 2, 1)), 16: (2, (1, 1, 0, 0, 1))} | {
    25: (5, (2, 4, 1)),
    27: (3, (1, 2, 0, 1)),
    49: (7, (3, 6, 1)),
}


@lru_cache(maxsize=32)
def galois(q: int) -> Table:
    """Return GF(q); x is a root of Conway's polynomial."""
    if q not in CONWAY:
        found = integers_modulo(q)
        return Table(f"GF({q})", found.plus, found.times, found.one)
    p, polynomial = CONWAY[q]
    return with_root(integers_modulo(p), polynomial, f"GF({q})")


@lru_cache(maxsize=1)
def rings() -> tuple[Table, ...]:
    """Return rings of order up to 16: all kinds of local ones, and products of them."""
    Z = {n: integers_modulo(n) for n in range(2, MAX_ORDER + 1)}
    fields = [galois(q) for q in (2, 3, 4, 5, 7, 8, 9, 11, 13, 16)]
    local = [
        *(Z[n] for n in (4, 8, 9, 16)),
        *(with_root(Z[p], (0,) * n + (1,), f"F{p}[e]/e^{n}") for p, n in ((2, 2), (3, 2))),
        *(with_root(Z[2], (0,) * n + (1,), f"F2[e]/e^{n}") for n in (3, 4)),
        with_root(Z[4], (0, 0, 1), "Z/4[e]/e^2"),
        with_root(Z[4], (2, 0, 1), "Z/4[e]/(e^2-2)"),
        with_root(Z[4], (1, 1, 1), "Z/4[e]/(e^2+e+1)"),
        with_root(galois(4), (0, 0, 1), "GF(4)[e]/e^2"),
    ]
    dual = with_root(Z[2], (0, 0, 1), "F2[d]/d^2")
    two = with_root(dual, (0, 0, 1), "F2[d,e]/(d^2,e^2)")
    sum_of_squares = with_root(dual, (0, 2, 1), "F2[d,e]/(d^2,e^2+d*e)")
    d_e = int(two.times[2, 4])
    local += [two, sum_of_squares, divided_by(two, [d_e], "F2[d,e]/(d^2,de,e^2)")]
    four = with_root(Z[4], (0, 0, 1), "Z/4[e]/e^2")
    local.append(divided_by(four, [int(four.times[2, 4])], "Z/4[e]/(2e,e^2)"))
    other = with_root(Z[4], (2, 0, 1), "Z/4[e]/(e^2-2)")
    local.append(divided_by(other, [int(other.times[2, 4])], "Z/4[e]/(2e,e^2-2)"))
    out = [*fields, *local]
    seen = {ring.name for ring in out}
    added = list(out)
    while added:
        following = []
        for x in added:
            for y in (*fields, *local):
                name = " x ".join(sorted((*x.name.split(" x "), y.name)))
                if x.order * y.order <= MAX_ORDER and name not in seen:
                    seen.add(name)
                    found = both(x, y)
                    following.append(Table(name, found.plus, found.times, found.one))
        out += following
        added = following
    return tuple(out)
