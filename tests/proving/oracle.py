"""An evaluator of statements that shares nothing with the prover but the parser.

Truth tables over GF(p), all assignments at once, by Table 1.1 written out; and a generator of
random statements.
"""

import random
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

# (sign, index) of the product of two basis vectors, from the thesis.
TABLE = [
    [(1, 0), (1, 1), (1, 2), (1, 3)],
    [(1, 1), (-1, 0), (1, 3), (-1, 2)],
    [(1, 2), (-1, 3), (-1, 0), (1, 1)],
    [(1, 3), (1, 2), (-1, 1), (-1, 0)],
]
QUATERNIONS, SCALARS = "pqruvw", "stxyz"


def unknowns(text):
    """The unknowns of a statement in alphabetical order."""
    found = set()
    stack = [parse(text)]
    while stack:
        n = stack.pop()
        if isinstance(n, Name) and n.name in QUATERNIONS + SCALARS:
            found.add(n.name)
        for field in getattr(n, "__slots__", ()):
            value = getattr(n, field)
            stack.extend(value if isinstance(value, tuple) else [value])
    return sorted(found)


class Oracle:
    """Evaluates modulo p (numpy arrays), or over the rationals (p = 0, Fractions, one place)."""

    def __init__(self, p, values):
        self.p, self.values = p, values

    def norm_form(self, x):
        return x % self.p if self.p else x

    def term(self, n):
        """A quaternion as a list of four, and where it is defined."""
        zero, one = self.values["0"], self.values["0"] + 1
        if isinstance(n, Number):
            if isinstance(n.value, Fraction) and self.p:
                d = n.value.denominator % self.p
                ok = (zero == 0) & (d != 0)
                inverse = pow(d, -1, self.p) if d else 0
                return [zero + n.value.numerator * inverse, zero, zero, zero], ok
            return [zero + n.value, zero, zero, zero], zero == 0
        if isinstance(n, Name):
            if n.name in "eijk":
                return [one if "eijk"[m] == n.name else zero for m in range(4)], zero == 0
            value = self.values[n.name]
            return (list(value) if n.name in QUATERNIONS else [value, zero, zero, zero]), zero == 0
        if isinstance(n, Negate):
            x, ok = self.term(n.operand)
            return [self.norm_form(-u) for u in x], ok
        if isinstance(n, Index):
            x, ok = self.term(n.base)
            return [x[n.index], zero, zero, zero], ok
        if isinstance(n, Power):
            x, ok = self.term(n.base)
            if n.exponent < 0:
                x, fine = self.inverse(x)
                ok = ok & fine
            out = [one, zero, zero, zero]
            for _ in range(abs(n.exponent)):
                out = self.times(out, x)
            return out, ok
        if isinstance(n, Binary):
            x, ok = self.term(n.left)
            y, fine = self.term(n.right)
            ok = ok & fine
            if n.op == "/":
                y, fine = self.inverse(y)
                ok, out = ok & fine, self.times(x, y)
            elif n.op == "*":
                out = self.times(x, y)
            else:
                sign = 1 if n.op == "+" else -1
                out = [self.norm_form(u + sign * v) for u, v in zip(x, y, strict=True)]
            return out, ok
        assert isinstance(n, Call), n
        x, ok = self.term(n.arguments[0])
        bar = [x[0], *(self.norm_form(-u) for u in x[1:])]
        if n.function == "conj":
            return bar, ok
        if n.function == "norm":
            return self.times(x, bar), ok
        if n.function == "trace":
            return [self.norm_form(x[0] + x[0]), zero, zero, zero], ok
        if n.function == "scalar":
            return [x[0], zero, zero, zero], ok
        if n.function == "vector":
            return [zero, *x[1:]], ok
        if n.function == "inv":
            y, fine = self.inverse(x)
            return y, ok & fine
        y, fine = self.term(n.arguments[1])
        xy, yx = self.times(x, y), self.times(y, x)
        return [self.norm_form(u - v) for u, v in zip(xy, yx, strict=True)], ok & fine

    def times(self, x, y):
        out = [self.values["0"]] * 4
        for m, n in product(range(4), repeat=2):
            sign, at = TABLE[m][n]
            out[at] = self.norm_form(out[at] + sign * x[m] * y[n])
        return out

    def inverse(self, x):
        square = self.norm_form(sum(u * u for u in x))
        if self.p:
            reciprocal = np.zeros_like(square)
            for n in range(1, self.p):
                reciprocal = np.where(square == n, pow(n, -1, self.p), reciprocal)
        else:
            reciprocal = 1 / square if square else Fraction(0)
        return [
            self.norm_form(u * reciprocal * s) for u, s in zip(x, (1, -1, -1, -1), strict=True)
        ], (square != 0)

    def truth(self, n):
        if isinstance(n, Compare):
            x, ok = self.term(n.left)
            y, fine = self.term(n.right)
            same = self.values["0"] == 0
            for u, v in zip(x, y, strict=True):
                same = same & (self.norm_form(u - v) == 0)
            return ok & fine & (same if n.op == "==" else np.logical_not(same))
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


def holds_everywhere(text, p):
    """Whether the statement (perhaps with one `exists` in front) is true over GF(p)."""
    node = parse(text)
    bound = ()
    if isinstance(node, Exists):
        bound, node = node.names, node.body
    names = unknowns(text)
    widths = [4 if n in QUATERNIONS else 1 for n in names]
    axes = np.indices((p,) * sum(widths)).astype(np.int64) if names else np.zeros((1,), np.int64)
    values, start = {"0": np.zeros((p,) * sum(widths), np.int64)}, 0
    for name, width in zip(names, widths, strict=True):
        piece = axes[start : start + width]
        values[name] = piece[0] if width == 1 else tuple(piece)
        start += width
    truth = np.broadcast_to(Oracle(p, values).truth(node), values["0"].shape)
    start, over = 0, []
    for name, width in zip(names, widths, strict=True):
        over += [start + m for m in range(width)] if name in bound else []
        start += width
    return bool(np.all(np.any(truth, axis=tuple(over)) if over else truth))


def true_at(text, p, witness):
    """Whether the statement is true at a witness of a prime field, or of the rationals (p = 0)."""

    def number(t):
        x = Fraction(t)
        return x if not p else np.int64(x.numerator * pow(x.denominator, -1, p) % p)

    values = {"0": Fraction(0) if not p else np.int64(0)}
    for name, texts in witness.items():
        if name != "F":
            coordinates = tuple(map(number, texts))
            values[name] = coordinates if len(coordinates) == 4 else coordinates[0]
    return bool(Oracle(p, values).truth(parse(text)))


def holds_at_random(text, rng, tries=12):
    """Whether the statement is true at some random rational places."""
    names = unknowns(text)
    for _ in range(tries):
        witness = {
            n: [str(Fraction(rng.choice([0, 0, 1, -1, 2, 3, -5]), rng.choice([1, 1, 2, 3])))]
            + [str(rng.choice([0, 0, 1, -1, 2])) for _ in range(3)] * (n in QUATERNIONS)
            for n in names
        }
        if not true_at(text, 0, witness):
            return False
    return True


class Generator:
    """Random statements in a few unknowns."""

    def __init__(self, seed, quaternions="pq", scalars="s", divide=True):
        self.rng = random.Random(seed)
        self.quaternions, self.scalars, self.divide = quaternions, scalars, divide

    def scalar(self, depth):
        pick = self.rng.random()
        if depth <= 0 or pick < 0.25:
            return self.rng.choice([*self.scalars, *self.scalars, "0", "1", "2", "3"])
        if pick < 0.55:
            f = self.rng.choice(["norm", "trace", "scalar"])
            return f"{f}({self.quaternion(depth - 1)})"
        if pick < 0.7:
            return f"{self.rng.choice(self.quaternions)}[{self.rng.randrange(4)}]"
        if pick < 0.8:
            return f"({self.scalar(depth - 1)})**{self.rng.choice([0, 1, 2, 2, 3, 4])}"
        if pick < 0.84 and self.divide:
            return f"({self.scalar(depth - 1)})/({self.scalar(depth - 1)})"
        op = self.rng.choice(["+", "-", "*"])
        return f"({self.scalar(depth - 1)}) {op} ({self.scalar(depth - 1)})"

    def quaternion(self, depth):
        pick = self.rng.random()
        if depth <= 0 or pick < 0.3:
            return self.rng.choice([*self.quaternions * 3, "e", "i", "j", "k"])
        if pick < 0.45:
            f = self.rng.choice(["conj", "vector", "conj", "inv" if self.divide else "conj"])
            return f"{f}({self.quaternion(depth - 1)})"
        if pick < 0.52:
            return f"comm({self.quaternion(depth - 1)}, {self.quaternion(depth - 1)})"
        if pick < 0.6:
            exponents = [0, 1, 2, 2, 3, -1] if self.divide else [0, 1, 2, 2, 3, 4]
            return f"({self.quaternion(depth - 1)})**{self.rng.choice(exponents)}"
        if pick < 0.68:
            return f"({self.scalar(depth - 1)})*({self.quaternion(depth - 1)})"
        op = self.rng.choice(["+", "-", "*", "*", "*"])
        return f"({self.quaternion(depth - 1)}) {op} ({self.quaternion(depth - 1)})"

    def comparison(self, depth):
        op = self.rng.choice(["==", "==", "==", "!="])
        if self.rng.random() < 0.4:
            return f"{self.scalar(depth)} {op} {self.scalar(depth)}"
        right = self.rng.choice(["0", "0", self.quaternion(depth)])
        return f"{self.quaternion(depth)} {op} {right}"

    def statement(self, depth=2):
        pick = self.rng.random()
        c = self.comparison
        if pick < 0.3:
            return c(depth)
        if pick < 0.6:
            return f"{c(1)} => {c(depth)}"
        if pick < 0.7:
            return f"{c(1)} and {c(1)} => {c(1)} or {c(1)}"
        if pick < 0.8:
            return f"({c(1)}) <=> ({c(1)})"
        if pick < 0.88:
            return f"not ({c(1)}) => {c(1)} => {c(1)}"
        if pick < 0.94:
            return f"({c(1)}) or ({c(1)})"
        return f"exists {self.rng.choice(self.quaternions)}: {c(1)} and {c(1)}"
