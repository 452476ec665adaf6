"""What a statement means, from docs/reference/language.md: truth at places, over scalars of any kind.

The product is Cayley and Dickson's doubling, not a table of basis products: with K = R[i]/(i² − t·i − a)
and u ↦ ū, i ↦ t − i, a quaternion is u + v·j with u, v in K, and
(u + v·j)(u' + v'·j) = (u·u' + b·v·v̄') + (u·v' + v·ū')·j.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from tests.adversary.grammar import NotRead, Tree, names_in, read

QUATERNIONS, SCALARS, BASIS = "pqruvw", "stxyz", "eijk"
HAMILTON = (("number", -1), ("number", 0), ("number", -1))


@dataclass(frozen=True)
class Claim:
    """A statement with its algebra, read: for all ``given`` there are ``bound`` with the rest.

    Unknowns are pairs of a name and the number of its coordinates.
    """

    hypotheses: tuple[Tree, ...]
    conclusion: Tree
    given: tuple[tuple[str, int], ...]
    bound: tuple[tuple[str, int], ...]
    constants: tuple[Tree, Tree, Tree]  # a, t, b


def read_algebra(text: str | None) -> tuple[Tree, Tree, Tree]:
    """Return the trees of a, t, b of ``(a,b|F)``, ``[a,b|F)`` or ``[a,b,t|F)``."""
    if text is None:
        return HAMILTON
    inside = text.strip()[1:].rpartition("|")[0]
    parts, depth = [""], 0
    for char in inside:
        depth += (char in "([") - (char in ")]")
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    trees = [read(part) for part in parts]
    if len(trees) == 3:
        return trees[0], trees[2], trees[1]
    return trees[0], ("number", int(text.strip()[0] == "[")), trees[1]


def read_claim(statement: str, algebra: str | None, scalars: Any = None) -> Claim:
    """Read a statement; ``scalars`` are those of the field that is named, None without a field."""
    constants = read_algebra(algebra)
    tree = read(statement)

    def is_constant(name: str) -> bool:
        return scalars is not None and scalars.constant(("name", name)) is not None

    letters = {n for c in constants for n in names_in(c) if not is_constant(n)}
    hypotheses, bound = [], []
    while tree[0] == "=>":
        hypotheses.append(tree[1])
        tree = tree[2]
    while tree[0] == "exists":
        bound += tree[1]
        tree = tree[2]
    used = letters.union(*map(names_in, (*hypotheses, tree)), bound)
    widths = {}
    for name in sorted(used):
        if name in BASIS or is_constant(name):
            continue
        if name in letters or name in SCALARS:
            widths[name] = 1
        elif name in QUATERNIONS:
            widths[name] = 4
        else:
            raise NotRead(f"the name {name!r}")
    return Claim(
        tuple(hypotheses),
        tree,
        tuple((n, w) for n, w in widths.items() if n not in bound),
        tuple((n, widths[n]) for n in dict.fromkeys(bound)),
        constants,
    )


def substituted(claim: Claim, terms: Mapping[str, Tree]) -> Claim:
    """Return a claim without ``exists``: the terms are put in for what it binds."""

    def put(tree: Any) -> Any:
        if not isinstance(tree, tuple):
            return tree
        if tree[0] == "name":
            return terms.get(tree[1], tree)
        return tuple(put(x) for x in tree)

    return replace(claim, conclusion=put(claim.conclusion), bound=())


class World:
    """An algebra over scalars, with values for unknowns: 4 coordinates or 1 each."""

    def __init__(
        self, scalars: Any, constants: tuple[Tree, Tree, Tree], values: Mapping[str, Any]
    ) -> None:
        self.s, self.values = scalars, values
        self.zero, self.one = scalars.zero, scalars.number(1)
        self.a = self.t = self.b = self.zero  # until they are known
        self.plain = constants[1] == ("number", 0)  # t = 0, as it is most of the time
        (self.a, *_), da = self.term(constants[0])
        (self.t, *_), dt = self.term(constants[1])
        (self.b, *_), db = self.term(constants[2])
        self.exists = da & dt & db

    # Elements u + v·i of K = R[i]/(i² − t·i − a) are pairs.
    def _k_times(self, x: Any, y: Any) -> Any:
        s = self.s
        square = s.mul(x[1], y[1])
        crossed = s.add(s.mul(x[0], y[1]), s.mul(x[1], y[0]))
        if not self.plain:
            crossed = s.add(crossed, s.mul(self.t, square))
        return s.add(s.mul(x[0], y[0]), s.mul(self.a, square)), crossed

    def _k_bar(self, x: Any) -> Any:
        bar = self.s.neg(x[1])
        return (x[0] if self.plain else self.s.add(x[0], self.s.mul(self.t, x[1]))), bar

    def _k_plus(self, x: Any, y: Any) -> Any:
        return self.s.add(x[0], y[0]), self.s.add(x[1], y[1])

    def times(self, p: Any, q: Any) -> Any:
        """Return p·q."""
        u, v, x, y = p[:2], p[2:], q[:2], q[2:]
        b_v = tuple(self.s.mul(self.b, c) for c in v)
        first = self._k_plus(self._k_times(u, x), self._k_times(b_v, self._k_bar(y)))
        second = self._k_plus(self._k_times(u, y), self._k_times(v, self._k_bar(x)))
        return (*first, *second)

    def conjugate(self, q: Any) -> Any:
        """Return ū − v·j."""
        return (*self._k_bar(q[:2]), self.s.neg(q[2]), self.s.neg(q[3]))

    def norm(self, q: Any) -> Any:
        """Return the e-coordinate of q·conj(q); u·ū − b·v·v̄ is all there is of it."""
        return self.times(q, self.conjugate(q))[0]

    def inverse(self, q: Any) -> tuple[Any, Any]:
        """Return conj(q)/norm(q), and where it is defined."""
        factor, fine = self.s.inverse(self.norm(q))
        return tuple(self.s.mul(c, factor) for c in self.conjugate(q)), fine

    def scalar(self, x: Any) -> Any:
        """Return x·e."""
        return (x, self.zero, self.zero, self.zero)

    def term(self, tree: Tree) -> tuple[Any, Any]:
        """Return four coordinates, and where the term is defined."""
        kind, s = tree[0], self.s
        if kind == "number":
            n = Fraction(tree[1])
            below, fine = s.inverse(s.number(n.denominator))
            if n.denominator == 1:
                return self.scalar(s.number(n.numerator)), s.true
            return self.scalar(s.mul(s.number(n.numerator), below)), fine & s.true
        if kind in ("name", "call"):
            return self._named(tree)
        if kind == "coordinate":
            x, d = self.term(tree[1])
            return self.scalar(x[tree[2]]), d
        if kind == "power":
            x, d = self.term(tree[1])
            if tree[2] < 0:
                x, fine = self.inverse(x)  # a scalar is a unit where its square, the norm, is
                d = d & fine
            return self._power(x, abs(tree[2])), d
        if kind == "minus":
            x, d = self.term(tree[1])
            return tuple(map(s.neg, x)), d
        x, dx = self.term(tree[1])
        y, dy = self.term(tree[2])
        d = dx & dy
        if kind == "/":
            factor, fine = s.inverse(y[0])
            return self.times(x, self.scalar(factor)), d & fine
        if kind == "*":
            return self.times(x, y), d
        if kind not in ("+", "-"):
            raise NotRead(f"{kind} in a term")
        y = tuple(map(s.neg, y)) if kind == "-" else y
        return tuple(map(s.add, x, y)), d

    def _power(self, x: Any, n: int) -> Any:
        out = self.scalar(self.one)
        for digit in bin(n)[2:]:
            out = self.times(out, out)
            if digit == "1":
                out = self.times(out, x)
        return out

    def _named(self, tree: Tree) -> tuple[Any, Any]:
        s = self.s
        if tree[0] == "name":
            if tree[1] in self.values:
                value = self.values[tree[1]]
                is_quaternion = isinstance(value, tuple) and len(value) == 4
                return (value if is_quaternion else self.scalar(value)), s.true
            if tree[1] in BASIS:
                place = BASIS.index(tree[1])
                return tuple(self.one if n == place else self.zero for n in range(4)), s.true
        functions = ("conj", "norm", "trace", "inv", "scalar", "vector", "comm")
        if tree[0] == "name" or tree[1] not in functions:
            found = s.constant(tree)
            if found is None:
                raise NotRead(f"the name {tree!r}")
            return self.scalar(found), s.true
        x, d = self.term(tree[2][0])
        if tree[1] == "inv":
            x, fine = self.inverse(x)
            return x, d & fine
        if tree[1] == "comm":
            y, dy = self.term(tree[2][1])
            back = map(s.neg, self.times(y, x))
            return tuple(map(s.add, self.times(x, y), back)), d & dy
        if tree[1] == "trace":  # q + conj(q)
            return self.scalar(s.add(x[0], self.conjugate(x)[0])), d
        if tree[1] == "norm":
            return self.scalar(self.norm(x)), d
        if tree[1] == "scalar":
            return self.scalar(x[0]), d
        return (self.conjugate(x) if tree[1] == "conj" else (self.zero, *x[1:])), d

    def truth(self, tree: Tree) -> Any:
        """Return where a statement without quantifiers is true."""
        kind = tree[0]
        if kind in ("==", "!="):
            x, dx = self.term(tree[1])
            y, dy = self.term(tree[2])
            same = self.s.true
            for u, v in zip(x, y, strict=True):
                same = same & self.s.is_zero(self.s.add(u, self.s.neg(v)))
            return dx & dy & (same if kind == "==" else np.logical_not(same))
        if kind == "not":
            return np.logical_not(self.truth(tree[1]))
        if kind not in ("and", "or", "=>", "<=>"):
            raise NotRead(f"{kind} in a statement")
        x, y = self.truth(tree[1]), self.truth(tree[2])
        if kind == "and":
            return x & y
        if kind == "or":
            return x | y
        return np.logical_not(x) | y if kind == "=>" else np.logical_not(x ^ y)
