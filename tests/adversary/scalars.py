"""Scalars the judge computes with: many places of small rings at once, or one place of a large ring.

Undefinedness is a mask (or a bool), never a value: ``inverse`` returns any value at all where there is
none, and False beside it.
"""

import re
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property, lru_cache
from math import isqrt
from typing import Any

import flint
import mpmath
import numpy as np

from tests.adversary.grammar import Tree
from tests.adversary.small_rings import CONWAY, MAX_ORDER, Table, galois, integers_modulo


class Union:
    """The tables of several rings side by side; an element is an index into all of them."""

    def __init__(self, tables: Sequence[Table]) -> None:
        self.tables = tuple(tables)
        orders = np.array([t.order for t in tables])
        self.start = np.concatenate([[0], np.cumsum(orders)])[:-1]
        size = int(orders.sum())
        self.plus = np.zeros((size, size), np.int32)
        self.times = np.zeros((size, size), np.int32)
        self.minus, self.inverse = np.zeros(size, np.int32), np.zeros(size, np.int32)
        self.unit = np.zeros(size, bool)
        self.is_zero = np.zeros(size, bool)
        for s, t in zip(self.start.tolist(), tables, strict=True):
            own = slice(s, s + t.order)
            self.plus[own, own] = t.plus + s
            self.times[own, own] = t.times + s
            self.minus[own], self.inverse[own] = t.minus + s, np.maximum(t.inverse, 0) + s
            self.unit[own] = t.inverse >= 0
            self.is_zero[s] = True
        self.plus, self.times, self.size = self.plus.ravel(), self.times.ravel(), size

    @cached_property
    def orders(self) -> np.ndarray:
        """The orders of the rings."""
        return np.array([t.order for t in self.tables])


class Places:
    """Places of the rings of a union: ``where[n]`` is the number of the ring of the n-th."""

    def __init__(self, union: Union, where: np.ndarray) -> None:
        self.u, self.where = union, where
        self.zero = union.start[where]
        self.true = np.ones(len(where), bool)

    def number(self, n: int) -> Any:
        u = self.u
        ones = [t.multiples[n % t.characteristic] for t in u.tables]
        return (np.array(ones) + u.start)[self.where]

    def add(self, x: Any, y: Any) -> Any:
        return self.u.plus[x * self.u.size + y]

    def mul(self, x: Any, y: Any) -> Any:
        return self.u.times[x * self.u.size + y]

    def neg(self, x: Any) -> Any:
        return self.u.minus[x]

    def inverse(self, x: Any) -> tuple[Any, Any]:
        return self.u.inverse[x], self.u.unit[x]

    def is_zero(self, x: Any) -> Any:
        return self.u.is_zero[x]

    def constant(self, tree: Tree) -> Any:
        if tree != ("name", "x") or len(self.u.tables) > 1 or self.u.tables[0].generator is None:
            return None
        return self.zero + self.u.tables[0].generator


class Modular:
    """Many places of ℤ/n at once by the arithmetic of numbers, which is faster than tables."""

    def __init__(self, table: Table, size: int) -> None:
        # Short unsigned numbers that hold every product: numpy divides them fastest by far.
        kind = np.min_scalar_type((table.order - 1) ** 2)
        self.n = kind.type(table.order)
        self.inverses = np.maximum(table.inverse, 0).astype(kind)
        self.units = table.inverse >= 0
        self.zero, self.true = np.zeros(size, kind), np.ones(size, bool)

    def number(self, n: int) -> Any:
        return self.zero + self.zero.dtype.type(n % int(self.n))

    def add(self, x: Any, y: Any) -> Any:
        return self._remainder(x + y)

    def mul(self, x: Any, y: Any) -> Any:
        return self._remainder(x * y)

    def neg(self, x: Any) -> Any:
        return self._remainder(self.n - x)

    def _remainder(self, x: Any) -> Any:
        return x & 1 if self.n == 2 else x - x // self.n * self.n

    def inverse(self, x: Any) -> tuple[Any, Any]:
        return self.inverses[x], self.units[x]

    def is_zero(self, x: Any) -> Any:
        return x == 0

    def constant(self, tree: Tree) -> Any:
        return None


class Exact:
    """One place of a ring whose elements are Python objects."""

    true = np.True_
    zero: Any = Fraction(0)

    def number(self, n: int) -> Any:
        return Fraction(n)

    def add(self, x: Any, y: Any) -> Any:
        return x + y

    def mul(self, x: Any, y: Any) -> Any:
        return x * y

    def neg(self, x: Any) -> Any:
        return -x

    def inverse(self, x: Any) -> tuple[Any, Any]:
        return (1 / x, np.True_) if x != 0 else (x, np.False_)

    def is_zero(self, x: Any) -> Any:
        return np.bool_(x == 0)

    def constant(self, tree: Tree) -> Any:
        return None

    def some(self, rng: Any) -> Any:
        """Return a random element, small ones more often."""
        if rng.random() < 0.7:
            return self.number(rng.choice((0, 0, 0, 1, 1, -1, 2, 3, -2, 6)))
        x, _ = self.inverse(self.number(rng.choice((2, 3, 5, 7, 11))))
        return self.mul(self.number(rng.randint(-6, 6)), x)


class Integers(Exact):
    """ℤ."""

    def inverse(self, x: Any) -> tuple[Any, Any]:
        return x, np.bool_(abs(x) == 1)

    def some(self, rng: Any) -> Any:
        return Fraction(rng.choice((0, 0, 0, 1, 1, -1, 2, 3, -2, 4, 6, 12, rng.randint(-99, 99))))


class Residues(Exact):
    """ℤ/n for any n."""

    def __init__(self, n: int) -> None:
        self.n, self.zero = n, 0

    def number(self, n: int) -> Any:
        return n % self.n

    def add(self, x: Any, y: Any) -> Any:
        return (x + y) % self.n

    def mul(self, x: Any, y: Any) -> Any:
        return x * y % self.n

    def neg(self, x: Any) -> Any:
        return -x % self.n

    def inverse(self, x: Any) -> tuple[Any, Any]:
        try:
            return pow(x, -1, self.n), np.True_
        except ValueError:
            return x, np.False_

    def some(self, rng: Any) -> Any:
        return rng.choice((0, 0, 1, rng.randrange(self.n))) % self.n


class Numbers(Exact):
    """Complex numbers to 120 digits: a judge's view of ℝ, ℂ and fields of numbers.

    A number below 10⁻⁸⁰ counts as 0. That is no proof, but no witness and no sample here comes near.
    """

    def __init__(self, name: str, roots: tuple[str, ...] | None) -> None:
        self.name, self.roots = name, roots  # None: all constants are read
        self.zero = mpmath.mpc(0)
        mpmath.mp.dps = 120

    def number(self, n: int) -> Any:
        return mpmath.mpc(n)

    def is_zero(self, x: Any) -> Any:
        return np.bool_(abs(x) < mpmath.mpf(10) ** -80)

    def inverse(self, x: Any) -> tuple[Any, Any]:
        return (x, np.False_) if self.is_zero(x) else (1 / x, np.True_)

    def constant(self, tree: Tree) -> Any:
        if tree == ("name", "I") and self.name != "RR" and self.roots in (None, ("I",)):
            return mpmath.mpc(0, 1)
        if tree == ("name", "pi") and self.roots is None:
            return mpmath.mpc(mpmath.pi)
        if tree[0] != "call" or tree[1] not in ("sqrt", "root", "cos", "sin"):
            return None
        if self.roots is not None:
            return self._quadratic(tree)
        values = [self.value(x) for x in tree[2]]
        if any(v is None for v in values):
            return None
        if tree[1] == "root":
            n = int(values[1].real)
            negative = values[0].real < 0 and n % 2 and values[0].imag == 0
            found = mpmath.root(abs(values[0]) if negative else values[0], n)
            found = -found if negative else found
        else:
            found = getattr(mpmath, tree[1])(values[0])
        found = mpmath.mpc(found)
        if self.name == "RR" and not self.is_zero(found.imag):
            return None
        return found

    def _quadratic(self, tree: Tree) -> Any:
        """Return √n in ℚ(√d): where n or n/d is the square of a rational number."""
        n = value_of(tree[2][0], Exact())
        assert self.roots is not None
        d = -1 if self.roots[0] == "I" else int(self.roots[0])
        if tree[1] != "sqrt" or n is None or not any(map(_is_square, (n, n / d))):
            return None
        return mpmath.mpc(mpmath.sqrt(mpmath.mpf(n.numerator) / n.denominator))

    def value(self, tree: Tree) -> Any:
        """Return the value of a term."""
        return value_of(tree, self)

    def some(self, rng: Any) -> Any:
        x = super().some(rng)
        if rng.random() < 0.25:
            extra = {"RR": "2", "CC": "-1"}.get(self.name) or (self.roots or ("2",))[0]
            x = x + super().some(rng) * mpmath.sqrt(-1 if extra == "I" else int(extra))
        return x


def _is_square(n: Fraction) -> bool:
    return n >= 0 and all(isqrt(k) ** 2 == k for k in (n.numerator, n.denominator))


class Quotients(Exact):
    """F(t): quotients of flint's polynomials."""

    def __init__(self, base: str, variable: str) -> None:
        self.variable, self.characteristic = variable, 0
        self.field: Any = None
        if base == "QQ":
            self.x = flint.fmpq_poly([0, 1])
        else:
            q = int(base[3:-1])
            p, modulus = CONWAY.get(q, (q, (0, 1)))
            self.characteristic = p
            context = flint.fq_default_ctx(modulus=flint.fmpz_mod_poly_ctx(p)(list(modulus)))
            self.field = context
            self.x = flint.fq_default_poly_ctx(context)([0, 1])
        self.unit = self.x**0
        self.zero = (self.x - self.x, self.unit)

    def number(self, n: int) -> Any:
        return (self.unit * n, self.unit)

    def add(self, x: Any, y: Any) -> Any:
        return self._made(x[0] * y[1] + y[0] * x[1], x[1] * y[1])

    def mul(self, x: Any, y: Any) -> Any:
        return self._made(x[0] * y[0], x[1] * y[1])

    def neg(self, x: Any) -> Any:
        return (-x[0], x[1])

    def inverse(self, x: Any) -> tuple[Any, Any]:
        return (x, np.False_) if x[0] == 0 else ((x[1], x[0]), np.True_)

    def is_zero(self, x: Any) -> Any:
        return np.bool_(x[0] == 0)

    def constant(self, tree: Tree) -> Any:
        if tree == ("name", self.variable):
            return (self.x, self.unit)
        if tree == ("name", "x") and self.field is not None and self.field.degree() > 1:
            return (self.unit * self.field.gen(), self.unit)
        return None

    def _made(self, top: Any, below: Any) -> Any:
        common = top.gcd(below)
        return (divmod(top, common)[0], divmod(below, common)[0])

    def some(self, rng: Any) -> Any:
        x = self.number(rng.choice((0, 0, 0, 1, 1, -1, 2)))
        if rng.random() < 0.4:
            y = self.mul(
                self.number(rng.choice((1, -1))), (self.x ** rng.choice((1, 2)), self.unit)
            )
            x = self.add(x, self.inverse(y)[0] if rng.random() < 0.3 else y)
        return x


def _is_prime(n: int) -> bool:
    """Tell whether n is prime; False for numbers that would take long."""
    return n < 10**10 and all(n % d for d in range(2, isqrt(n) + 1))


def value_of(tree: Tree, s: Any) -> Any:
    """Return the element that a term without unknowns names, None if it names none."""
    kind = tree[0]
    if kind == "number":
        n = Fraction(tree[1])
        below, fine = s.inverse(s.number(n.denominator))
        if n.denominator == 1:
            return s.number(n.numerator)
        return s.mul(s.number(n.numerator), below) if np.all(fine) else None
    if kind in ("name", "call"):
        return s.constant(tree)
    if kind == "power":
        x, n = value_of(tree[1], s), tree[2]
        if x is not None and n < 0:
            x, fine = s.inverse(x)
            x = x if np.all(fine) else None
        if x is None:
            return None
        out = s.number(1)
        for _ in range(abs(n)):
            out = s.mul(out, x)
        return out
    parts = [value_of(x, s) for x in tree[1:]]
    if any(x is None for x in parts):
        return None
    if kind == "minus":
        return s.neg(parts[0])
    x, y = parts
    if kind == "/":
        y, fine = s.inverse(y)
        return s.mul(x, y) if np.all(fine) else None
    if kind not in ("+", "-", "*"):
        return None
    return s.mul(x, y) if kind == "*" else s.add(x, s.neg(y) if kind == "-" else y)


@lru_cache(maxsize=64)
def named(name: str) -> Any:
    """Return a :class:`Table` or an :class:`Exact` for the name of a ring, None if it is not known here."""
    name = "".join(name.split())
    if name == "QQ":
        return Exact()
    if name == "ZZ":
        return Integers()
    if name in ("RR", "CC"):
        return Numbers(name, None)
    if m := re.fullmatch(r"ZZ/(\d+)", name):
        n = int(m[1])
        return integers_modulo(n) if n <= 4 * MAX_ORDER else Residues(n)
    if m := re.fullmatch(r"GF\((\d+)\)", name):
        q = int(m[1])
        if q in CONWAY or q <= 4 * MAX_ORDER:
            return galois(q)
        return Residues(q) if _is_prime(q) else None
    if m := re.fullmatch(r"QQ\((?:sqrt\((-?\d+)\)|I)\)", name):
        return Numbers(name, (m[1] or "I",))
    if m := re.fullmatch(r"(QQ|GF\(\d+\))\(([a-z])\)", name):
        return Quotients(m[1], m[2])
    return None
