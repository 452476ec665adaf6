"""Evaluate terms and statements over a ring, or over polynomials.

The product is computed from the sixteen products of basis elements, which follow from i² = a + t·i, j² = b,
ij = k and ji = t·j − k.
"""

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Generic, Literal, Protocol, TypeVar

from hfield.checker.budget import spend
from hfield.checker.language import FUNCTIONS, Tree
from hfield.checker.rejection import reject
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import MAX_EXPONENT, Ring, power

S = TypeVar("S")  # the representation of a scalar
T = TypeVar("T")  # the representation of a truth value
Conditions = tuple[S, ...]  # numbers that must not be 0 for a term to be defined


class Scalars(Protocol[S, T]):
    """The arithmetic of an evaluation; a condition is a scalar that must be a unit."""

    zero: S
    one: S

    def number(self, value: int | Fraction) -> tuple[S, Conditions[S]]:
        """Return the value of a literal."""

    def add(self, x: S, y: S) -> S:
        """Return x + y."""

    def neg(self, x: S) -> S:
        """Return −x."""

    def mul(self, x: S, y: S) -> S:
        """Return x·y."""

    def reciprocal(self, x: S) -> tuple[S, Conditions[S]]:
        """Return 1/x with the condition that it exists."""

    def compare(self, differences: list[S], conditions: Conditions[S], equal: bool) -> T:
        """Return the truth value of "everything is defined, and all (or not all) differences are 0"."""

    def join(self, kind: Literal["and", "or"], x: T, y: T) -> T:
        """Return the truth of "x and y" or "x or y"."""

    def deny(self, x: T) -> T:
        """Return the truth of "not x"."""


class Quaternion(tuple[S, ...]):
    """Four coordinates over (e, i, j, k); any other value is a scalar."""

    __slots__ = ()


def products(
    one: S, a: S, t: S, b: S, ab: S, tb: S, neg: Callable[[S], S]
) -> list[list[list[tuple[int, S]]]]:
    """Return the products of 1, i, j, k: for each pair, indices of basis elements and their coefficients."""
    return [
        [[(0, one)], [(1, one)], [(2, one)], [(3, one)]],
        [[(1, one)], [(0, a), (1, t)], [(3, one)], [(2, a), (3, t)]],
        [[(2, one)], [(2, t), (3, neg(one))], [(0, b)], [(0, tb), (1, neg(b))]],
        [[(3, one)], [(2, neg(a))], [(1, b)], [(0, neg(ab))]],
    ]


class Evaluator(Generic[S, T]):
    """The algebra over some scalars, with values for unknowns and constants."""

    def __init__(
        self,
        scalars: Scalars[S, T],
        constants: tuple[Tree, Tree, Tree],
        values: Mapping[Tree, S | Quaternion[S]],
    ):
        s = self.s = scalars
        self.values = values
        self.needed: Conditions[S] = ()  # by the terms evaluated last
        self.constants = a, t, b = [self._scalar(self.value(tree)) for tree in constants]
        self.conditions: Conditions[S] = self.needed  # under which the algebra exists
        self.table = products(s.one, a, t, b, s.mul(a, b), s.mul(t, b), s.neg)
        self.t = t

    def quaternion(self, x: S | Quaternion[S]) -> Quaternion[S]:
        """Return a scalar as its multiple of e."""
        zero = self.s.zero
        return x if isinstance(x, Quaternion) else Quaternion((x, zero, zero, zero))

    def product(
        self, x: Quaternion[S], y: Quaternion[S], wanted: range = range(4)
    ) -> Quaternion[S]:
        """Return x·y; only the wanted coordinates are computed, the others are 0."""
        s = self.s
        spend(20)
        out = [s.zero] * 4
        for m, u in enumerate(x):
            for n, v in enumerate(y):
                if u == s.zero or v == s.zero:
                    continue
                parts = [
                    part for part in self.table[m][n] if part[0] in wanted and part[1] != s.zero
                ]
                uv = s.mul(u, v) if parts else s.zero
                for place, c in parts:
                    out[place] = s.add(out[place], uv if c == s.one else s.mul(c, uv))
        return Quaternion(out)

    def conjugate(self, q: Quaternion[S]) -> Quaternion[S]:
        """Return the standard involution: i ↦ t − i, j ↦ −j, k ↦ −k."""
        s = self.s
        w, x, y, z = q
        return Quaternion((s.add(w, s.mul(self.t, x)), s.neg(x), s.neg(y), s.neg(z)))

    def norm(self, q: Quaternion[S]) -> S:
        """Return the norm, which is the coefficient of e in q·conj(q); the other coefficients are 0."""
        return self.product(q, self.conjugate(q), range(1))[0]

    def value(self, tree: Tree) -> S | Quaternion[S]:
        """Return the value of a term; scalars that must be units for it to be defined are added to
        ``needed``.
        """
        s = self.s
        spend(10)
        if tree[0] == "num":
            return self._defined(s.number(tree[1]))
        if (
            tree[0] == "call" and tree[1] in FUNCTIONS
        ):  # others are short; the whole tree would be hashed
            inside = tree[2][0]
            if tree[1] == "trace" and inside[0] == "*":
                return self._call("trace", self._traced(*map(self.value, inside[1:])))
            return self._call(tree[1], *map(self.value, tree[2]))
        if tree[0] in ("name", "call") and tree in self.values:
            return self.values[tree]
        if tree[0] == "name":
            return self._name(tree[1])
        if tree[0] == "call":
            reject(f"there is no function {tree[1]!r}")
        if tree[0] == "exists":
            reject("a term cannot be evaluated")
        x = self.value(tree[1])
        if tree[0] == "neg":
            return Quaternion(map(s.neg, x)) if isinstance(x, Quaternion) else s.neg(x)
        if tree[0] in ("+", "-"):
            return self._plus(x, self.value(tree[2]), tree[0])
        if tree[0] in ("*", "/"):
            y = self.value(tree[2])
            return self._times(
                x, y if tree[0] == "*" else self._defined(s.reciprocal(self._scalar(y)))
            )
        if tree[0] == "pow":
            if abs(tree[2]) > MAX_EXPONENT:
                reject("an exponent is too large")
            return self._power(x if tree[2] >= 0 else self._inverse(x), abs(tree[2]))
        if tree[0] == "index":
            return self._coordinate(x, tree[2])
        reject("a term cannot be evaluated")

    @staticmethod
    def _scalar(x: S | Quaternion[S]) -> S:
        if isinstance(x, Quaternion):
            reject("a quaternion stands where a scalar is meant")
        return x

    def _coordinate(self, x: S | Quaternion[S], n: int) -> S:
        return self.quaternion(x)[n]

    def _defined(self, found: tuple[S, Conditions[S]]) -> S:
        if found[1]:
            spend(1 + len(self.needed) // 16)
            self.needed += found[1]
        return found[0]

    def truth(self, tree: Tree) -> T:
        """Return the truth value of a quantifier-free statement."""
        s = self.s
        spend(10)
        if tree[0] in ("==", "!="):
            self.needed = ()
            x, y = self.value(tree[1]), self.value(tree[2])
            if isinstance(x, Quaternion) or isinstance(y, Quaternion):
                pairs = zip(self.quaternion(x), self.quaternion(y), strict=True)
                differences = [s.add(u, s.neg(v)) for u, v in pairs]
            else:
                differences = [s.add(x, s.neg(y))]
            return s.compare(differences, self.needed, tree[0] == "==")
        if tree[0] == "not":
            return s.deny(self.truth(tree[1]))
        if tree[0] not in ("and", "or", "=>", "<=>"):
            reject("a statement cannot be evaluated")
        left, right = self.truth(tree[1]), self.truth(tree[2])
        if tree[0] in ("and", "or"):
            return s.join(tree[0], left, right)
        forth = s.join("or", s.deny(left), right)
        return forth if tree[0] == "=>" else s.join("and", forth, s.join("or", left, s.deny(right)))

    def _name(self, name: str) -> Quaternion[S]:
        place = "eijk".find(name)
        if place < 0 or len(name) != 1:
            reject(f"the unknown {name!r} has no value")
        return Quaternion([self.s.one if n == place else self.s.zero for n in range(4)])

    def _plus(self, x: S | Quaternion[S], y: S | Quaternion[S], sign: str) -> S | Quaternion[S]:
        s = self.s
        if not (isinstance(x, Quaternion) or isinstance(y, Quaternion)):
            return s.add(x, s.neg(y) if sign == "-" else y)
        pairs = zip(self.quaternion(x), self.quaternion(y), strict=True)
        return Quaternion([s.add(u, s.neg(v) if sign == "-" else v) for u, v in pairs])

    def _times(self, x: S | Quaternion[S], y: S | Quaternion[S]) -> S | Quaternion[S]:
        s = self.s
        if isinstance(x, Quaternion):
            if isinstance(y, Quaternion):
                return self.product(x, y)
            return Quaternion([s.mul(u, y) for u in x])
        if isinstance(y, Quaternion):
            return Quaternion([s.mul(x, v) for v in y])
        return s.mul(x, y)

    def _traced(self, x: S | Quaternion[S], y: S | Quaternion[S]) -> S | Quaternion[S]:
        """Return those parts of x·y on which its trace depends."""
        if isinstance(x, Quaternion) and isinstance(y, Quaternion):
            return self.product(x, y, range(1 if self.t == self.s.zero else 2))
        return self._times(x, y)

    def _power(self, x: S | Quaternion[S], n: int) -> S | Quaternion[S]:
        return power(self.s.one, x, n, self._times)

    def _inverse(self, x: S | Quaternion[S]) -> S | Quaternion[S]:
        if not isinstance(x, Quaternion):
            return self._defined(self.s.reciprocal(x))
        return self._times(self.conjugate(x), self._defined(self.s.reciprocal(self.norm(x))))

    def _call(self, function: str, *arguments: S | Quaternion[S]) -> S | Quaternion[S]:
        x, s = self.quaternion(arguments[0]), self.s
        if function == "inv":
            return self._inverse(x)
        if function == "comm":
            y = self.quaternion(arguments[1])
            return self._plus(self.product(x, y), self.product(y, x), "-")
        if function == "trace":
            return s.add(s.add(x[0], x[0]), s.mul(self.t, x[1]))
        if function == "vector":
            return Quaternion((s.zero, *x[1:]))
        if function == "conj":
            return self.conjugate(x)
        if function == "norm":
            return self.norm(x)
        return self._coordinate(x, 0)


class RingScalars(Generic[E]):
    """Elements of a ring; the one condition is that 0 is a unit: there is no inverse."""

    def __init__(self, ring: Ring[E]) -> None:
        self.ring, self.zero, self.one = ring, ring.zero, ring.one
        self.add, self.neg, self.mul = ring.add, ring.neg, ring.mul

    def number(self, value: int | Fraction) -> tuple[E, Conditions[E]]:
        """Return the value of a literal."""
        x = self.ring.fraction(value)
        return (self.zero, (self.zero,)) if x is None else (x, ())

    def reciprocal(self, x: E) -> tuple[E, Conditions[E]]:
        """Return 1/x."""
        y = self.ring.inverse(x)
        return (self.zero, (self.zero,)) if y is None else (y, ())

    def compare(self, differences: list[E], conditions: Conditions[E], equal: bool) -> bool:
        """Return the truth value of "everything is defined, and all (or not all) differences are 0"."""
        return not conditions and all(map(self.ring.is_zero, differences)) == equal

    def join(self, kind: Literal["and", "or"], x: bool, y: bool) -> bool:
        """Return "x and y" or "x or y"."""
        return (x and y) if kind == "and" else (x or y)

    def deny(self, x: bool) -> bool:
        """Return the formula "not x"."""
        return not x
