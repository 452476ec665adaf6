"""Statements evaluated over small commutative rings by tables, at every place or at many.

Nothing of the prover is used but the parser. A ring is its two tables; products, dual numbers and
residues are made of pairs. What is undefined makes a comparison false; only units divide.
"""

from fractions import Fraction
from itertools import product

import numpy as np

from hfield.syntax import (
    Binary,
    Call,
    Compare,
    Exists,
    Index,
    Logic,
    Name,
    Negate,
    Not,
    Number,
    Power,
    parse,
)

QUATERNIONS, SCALARS = "pqruvw", "stxyz"


class Table:
    """A commutative ring with 1 on the numbers 0 … order − 1; element 0 is 0."""

    def __init__(self, name, elements, plus, times, one, is_field, is_reduced):
        self.name, self.order, self.is_field, self.is_reduced = (
            name,
            len(elements),
            is_field,
            is_reduced,
        )
        at = {x: n for n, x in enumerate(elements)}
        self.sum = np.array([[at[plus(x, y)] for y in elements] for x in elements])
        self.product = np.array([[at[times(x, y)] for y in elements] for x in elements])
        self.minus = np.argmin(self.sum, axis=1)  # where x + y = 0
        self.one = at[one]
        self.unit = (self.product == self.one).any(axis=1)
        self.inverse = np.argmax(self.product == self.one, axis=1)
        self.characteristic, total = 1, self.one
        while total:
            total, self.characteristic = self.sum[total, self.one], self.characteristic + 1

    def number(self, n):
        total = 0
        for _ in range(n % self.characteristic):
            total = self.sum[total, self.one]
        return total


def residues(n):
    prime = all(n % d for d in range(2, n))
    reduced = all(n % (d * d) for d in range(2, n))
    return Table(
        f"Z/{n}",
        list(range(n)),
        lambda x, y: (x + y) % n,
        lambda x, y: x * y % n,
        1,
        prime,
        reduced,
    )


def pairs(name, m, n, times, one, is_field, is_reduced):
    return Table(
        name,
        [(x, y) for x in range(m) for y in range(n)],
        lambda u, v: ((u[0] + v[0]) % m, (u[1] + v[1]) % n),
        times,
        one,
        is_field,
        is_reduced,
    )


def direct_product(m, n):
    return pairs(
        f"F{m} x F{n}",
        m,
        n,
        lambda u, v: (u[0] * v[0] % m, u[1] * v[1] % n),
        (1, 1),
        False,
        True,
    )


def quadratic(name, p, c, d, is_field, is_reduced):
    """F_p[x] with x² = c + d·x."""
    return pairs(
        name,
        p,
        p,
        lambda u, v: (
            (u[0] * v[0] + c * u[1] * v[1]) % p,
            (u[0] * v[1] + u[1] * v[0] + d * u[1] * v[1]) % p,
        ),
        (1, 0),
        is_field,
        is_reduced,
    )


RINGS = [
    *map(residues, range(2, 10)),
    direct_product(2, 2),
    direct_product(2, 3),
    direct_product(3, 3),
    quadratic("F2[eps]", 2, 0, 0, False, False),
    quadratic("F3[eps]", 3, 0, 0, False, False),
    quadratic("GF(4)", 2, 1, 1, True, True),
    quadratic("GF(9)", 3, 2, 0, True, True),
]


class Places:
    """The unknowns of a statement with values: every place of a ring, or ``most`` at random."""

    def __init__(self, ring, constants=("-1", "0", "-1"), values=None):
        self.ring, self.values = ring, values or {}
        self.defined = True
        self.a = self.t = self.b = 0  # of scalars alone the constants are made
        found = []
        for text in constants:
            x, ok = self.term(parse(text))
            found.append(x[0])
            self.defined = self.defined & ok
        self.a, self.t, self.b = found

    def add(self, x, y):
        return self.ring.sum[x, y]

    def mul(self, x, y):
        return self.ring.product[x, y]

    def neg(self, x):
        return self.ring.minus[x]

    def times(self, p, q):
        """i² = a + t·i, j² = b, ij = k, ji = t·j − k; k = ij does the rest by associativity."""
        a, t, b, one = self.a, self.t, self.b, self.ring.one
        ab, tb = self.mul(a, b), self.mul(t, b)
        table = {
            (1, 1): [(0, a), (1, t)],
            (1, 2): [(3, one)],
            (1, 3): [(2, a), (3, t)],
            (2, 1): [(2, t), (3, self.neg(one))],
            (2, 2): [(0, b)],
            (2, 3): [(0, tb), (1, self.neg(b))],
            (3, 1): [(2, self.neg(a))],
            (3, 2): [(1, b)],
            (3, 3): [(0, self.neg(ab))],
        }
        out = [0, 0, 0, 0]
        for m, n in product(range(4), repeat=2):
            value = self.mul(p[m], q[n])
            for at, c in table.get((m, n), [(m + n, one)]):
                out[at] = self.add(out[at], self.mul(c, value))
        return out

    def conjugate(self, q):
        w = self.add(q[0], self.mul(self.t, q[1]))
        return [w, *map(self.neg, q[1:])]

    def inverse(self, q):
        norm = self.times(q, self.conjugate(q))[0]
        by = self.ring.inverse[norm]
        return [self.mul(by, x) for x in self.conjugate(q)], self.ring.unit[norm]

    def reciprocal(self, q):
        return [self.ring.inverse[q[0]], 0, 0, 0], self.ring.unit[q[0]]

    def term(self, n):
        if isinstance(n, Number):
            value = Fraction(n.value)
            top, below = self.ring.number(value.numerator), self.ring.number(value.denominator)
            return [self.mul(top, self.ring.inverse[below]), 0, 0, 0], self.ring.unit[below]
        if isinstance(n, Name):
            if n.name in "eijk":
                return [self.ring.one if "eijk"[m] == n.name else 0 for m in range(4)], True
            value = self.values[n.name]
            return (list(value) if n.name in QUATERNIONS else [value, 0, 0, 0]), True
        if isinstance(n, Negate):
            x, ok = self.term(n.operand)
            return list(map(self.neg, x)), ok
        if isinstance(n, Index):
            x, ok = self.term(n.base)
            return [x[n.index], 0, 0, 0], ok
        if isinstance(n, Power):
            x, ok = self.term(n.base)
            if n.exponent < 0:
                x, fine = self.inverse(x)
                ok = ok & fine
            out = [self.ring.one, 0, 0, 0]
            for _ in range(abs(n.exponent)):
                out = self.times(out, x)
            return out, ok
        if isinstance(n, Binary):
            x, ok = self.term(n.left)
            y, fine = self.term(n.right)
            ok = ok & fine
            if n.op == "/":
                y, fine = self.reciprocal(y)
                ok = ok & fine
            if n.op in "*/":
                return self.times(x, y), ok
            y = y if n.op == "+" else list(map(self.neg, y))
            return [self.add(u, v) for u, v in zip(x, y, strict=True)], ok
        assert isinstance(n, Call), n
        x, ok = self.term(n.arguments[0])
        if n.function == "conj":
            return self.conjugate(x), ok
        if n.function == "norm":
            return [self.times(x, self.conjugate(x))[0], 0, 0, 0], ok
        if n.function == "trace":
            return [self.add(x[0], self.conjugate(x)[0]), 0, 0, 0], ok
        if n.function == "scalar":
            return [x[0], 0, 0, 0], ok
        if n.function == "vector":
            return [0, *x[1:]], ok
        if n.function == "inv":
            y, fine = self.inverse(x)
            return y, ok & fine
        y, fine = self.term(n.arguments[1])
        xy, yx = self.times(x, y), self.times(y, x)
        return [self.add(u, self.neg(v)) for u, v in zip(xy, yx, strict=True)], ok & fine

    def truth(self, n):
        if isinstance(n, Compare):
            x, ok = self.term(n.left)
            y, fine = self.term(n.right)
            same = True
            for u, v in zip(x, y, strict=True):
                same = same & (np.asarray(u) == v)
            return np.asarray(ok & fine) & (same if n.op == "==" else np.logical_not(same))
        if isinstance(n, Not):
            return np.logical_not(self.truth(n.operand))
        assert isinstance(n, Logic), n
        x, y = self.truth(n.left), self.truth(n.right)
        if n.op == "and":
            return np.logical_and(x, y)
        if n.op == "or":
            return np.logical_or(x, y)
        if n.op == "=>":
            return np.logical_or(np.logical_not(x), y)
        return np.asarray(x) == np.asarray(y)


def names_in(node):
    """The names in a tree in alphabetical order."""
    found, stack = set(), [node]
    while stack:
        n = stack.pop()
        if isinstance(n, Name) and n.name not in "eijk":
            found.add(n.name)
        for field in getattr(n, "__slots__", ()):
            value = getattr(n, field)
            stack.extend(value if isinstance(value, tuple) else [value])
    return sorted(found)


def _split(node):
    hypotheses = []
    while isinstance(node, Logic) and node.op == "=>":
        hypotheses.append(node.left)
        node = node.right
    bound = ()
    while isinstance(node, Exists):
        bound, node = (*bound, *node.names), node.body
    return hypotheses, bound, node


def truths(text, ring, constants=("-1", "0", "-1"), most=70_000, seed=1):
    """Evaluate everywhere: (truth of the statement, truth of the hypotheses, defined), flat arrays.

    Where there are more places than ``most``, at that many random ones; None for an ``exists`` then.
    """
    hypotheses, bound, body = _split(parse(text))
    names = names_in(parse(text))
    names += [n for c in constants for n in names_in(parse(c)) if n not in names]
    names = list(dict.fromkeys(names))
    free = [n for n in names if n not in bound]

    def width(which):
        return sum(4 if n in QUATERNIONS else 1 for n in which)

    def unpack(which, columns):
        values, start = {}, 0
        for n in which:
            size = 4 if n in QUATERNIONS else 1
            piece = columns[start : start + size]
            values[n], start = (tuple(piece) if size == 4 else piece[0]), start + size
        return values

    total = ring.order ** width(names)
    if total <= most:
        columns = [c.ravel() for c in np.indices((ring.order,) * width(free))]
    elif bound:
        return None
    else:
        rng = np.random.default_rng(seed)
        columns = list(rng.integers(0, ring.order, (width(free), most)))
    size = len(columns[0]) if columns else 1
    if bound:
        inner = [c.ravel() for c in np.indices((ring.order,) * width(bound))]
        outer = [np.repeat(c, len(inner[0])) for c in columns]
        inner = [np.tile(c, size) for c in inner]
        values = {**unpack(free, outer), **unpack(bound, inner)}
    else:
        values = unpack(free, columns)
    places = Places(ring, constants, values)
    shape = (size, -1) if bound else (size,)
    full = len(inner[0]) if bound else size

    def flat(x):
        return np.broadcast_to(np.asarray(x), (full,)).reshape(shape)

    conclusion, given = flat(places.truth(body)), flat(True)
    for h in hypotheses:
        given = given & flat(places.truth(h))
    defined = flat(places.defined)
    if bound:
        conclusion, given, defined = conclusion.any(axis=1), given[:, 0], defined[:, 0]
    return conclusion | ~given, given, defined


def holds(text, ring, constants=("-1", "0", "-1"), most=70_000):
    """Whether the statement is true wherever its algebra exists; None where that was not tried."""
    found = truths(text, ring, constants, most)
    return None if found is None else bool(np.all(found[0] | ~found[2]))
