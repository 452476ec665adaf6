"""Random statements of every shape of the language, with the algebra and the field to ask them in."""

import random
from dataclasses import dataclass
from typing import Any

SMALL = ("GF(2)", "GF(3)", "GF(4)", "GF(5)", "GF(7)", "GF(8)", "GF(9)", "GF(16)")
MODULI = ("ZZ/4", "ZZ/6", "ZZ/8", "ZZ/9", "ZZ/12")
LARGE = (
    "QQ",
    "ZZ",
    "RR",
    "CC",
    "QQ(sqrt(2))",
    "QQ(I)",
    "QQ(sqrt(-7))",
    "QQ(x)",
    "GF(2)(t)",
    "GF(5)(t)",
)
CONSTANTS = {
    "GF(4)": "x",
    "GF(8)": "x",
    "GF(9)": "x",
    "GF(16)": "x",
    "RR": "sqrt(2)",
    "CC": "I",
    "QQ(sqrt(2))": "sqrt(2)",
    "QQ(I)": "I",
    "QQ(sqrt(-7))": "sqrt(-7)",
    "QQ(x)": "x",
    "GF(2)(t)": "t",
    "GF(5)(t)": "t",
}
PLAIN = (
    "(-1,-1|F)",
    "(1,1|F)",
    "(2,3|F)",
    "(0,-1|F)",
    "(1,0|F)",
    "[1,1|F)",
    "[0,1|F)",
    "[1,-1,1|F)",
)
LETTERS = ("(a,b|F)", "[a,b|F)", "[a,b,c|F)", "(a,-1|F)", "(-1,b**2|F)", "(a,a|F)", "(s,-1|F)")
DIVIDED = (
    "(1/a,-1|F)",
    "(-1,1/(a-1)|F)",
    "(1/2,-1|F)",
    "(a/b,b|F)",
    "[1/a,b|F)",
    "(0.5,3|F)",
    "(a**-1,1|F)",
)


@dataclass(frozen=True)
class Case:
    """A statement to be decided; ``true`` says that it was made to be true wherever it is defined."""

    statement: str
    field: str | None
    algebra: str | None
    true: bool
    shape: str


class Generator:
    """Draws statements; the letters of the algebra and the constants of the field are used too."""

    def __init__(self, seed: int) -> None:
        self.rng = random.Random(seed)
        self.quaternions, self.scalars = "pq", "s"
        self.divide = self.constant = False
        self.algebra_terms = ("-1", "0", "-1")
        self.generator = ""

    def case(self) -> Case:
        """Return a random case."""
        rng = self.rng
        field = rng.choice(
            (None, None, None, rng.choice(SMALL), rng.choice(SMALL), rng.choice(LARGE))
        )
        if rng.random() < 0.15:
            field = rng.choice(MODULI)
        kinds = (None, None, None, None, PLAIN, PLAIN, LETTERS, DIVIDED)
        kind = rng.choice(kinds)
        algebra = None if kind is None else rng.choice(kind)
        self.generator = CONSTANTS.get(field or "", "")
        letters = sorted({c for c in algebra or "" if c in "abcs"})
        self.algebra_terms = _constants(algebra)
        few = field in (
            "GF(8)",
            "GF(9)",
            "GF(16)",
            "GF(7)",
            "GF(5)",
            "ZZ/8",
            "ZZ/9",
            "ZZ/12",
            "ZZ/6",
        )
        self.quaternions = "q" if few else rng.choice(("q", "pq", "pq", "pqr"))
        scalars = ["s", "s", "y", *letters]
        self.scalars = "".join(c for c in scalars if c != self.generator)
        self.divide = rng.random() < 0.35
        shape = rng.choice(SHAPES)
        made = getattr(self, f"_{shape}")
        statement, true = made()
        if algebra is not None and field is not None:
            algebra = algebra.replace("|F)", f"|{field})")
        return Case(statement, field, algebra, true, shape)

    # Terms.

    def number(self) -> str:
        """Return a number, or a constant of the field."""
        pick = self.rng.random()
        if self.generator and pick < 0.35:
            return self.rng.choice((self.generator, f"({self.generator} + 1)"))
        if self.divide and pick < 0.5:
            return self.rng.choice(("0.5", "1/2", "1.5", "0.2", "(1/3)", "2.0"))
        return self.rng.choice(("0", "1", "1", "2", "3", "4", "6", "(-1)", "12"))

    def scalar(self, depth: int) -> str:
        """Return a scalar term."""
        rng, pick = self.rng, self.rng.random()
        if depth <= 0 or pick < 0.25:
            return rng.choice((*self.scalars, *self.scalars, self.number()))
        if pick < 0.55:
            return f"{rng.choice(('norm', 'trace', 'scalar'))}({self.quaternion(depth - 1)})"
        if pick < 0.7:
            inside = rng.choice(self.quaternions) if pick < 0.67 else f"({self.quaternion(1)})"
            return f"{inside}[{rng.randrange(4)}]"
        if pick < 0.8:
            low = -1 if self.divide else 0
            return f"({self.scalar(depth - 1)})**{rng.choice((low, 0, 1, 2, 2, 3))}"
        if pick < 0.86 and self.divide:
            return f"({self.scalar(depth - 1)})/({self.scalar(depth - 1)})"
        return f"({self.scalar(depth - 1)}) {rng.choice('+-*')} ({self.scalar(depth - 1)})"

    def quaternion(self, depth: int) -> str:
        """Return a quaternion term."""
        rng, pick = self.rng, self.rng.random()
        if depth <= 0 or pick < 0.3:
            return rng.choice((*self.quaternions * 3, "e", "i", "j", "k"))
        if pick < 0.45:
            function = rng.choice(("conj", "vector", "conj", "inv" if self.divide else "conj"))
            return f"{function}({self.quaternion(depth - 1)})"
        if pick < 0.52:
            return f"comm({self.quaternion(depth - 1)}, {self.quaternion(depth - 1)})"
        if pick < 0.6:
            low = -1 if self.divide else 0
            return f"({self.quaternion(depth - 1)})**{rng.choice((low, 0, 1, 2, 2, 3))}"
        if pick < 0.68:
            return f"({self.scalar(depth - 1)})*({self.quaternion(depth - 1)})"
        operator = rng.choice("+-***")
        return f"({self.quaternion(depth - 1)}) {operator} ({self.quaternion(depth - 1)})"

    def comparison(self, depth: int) -> str:
        """Return an equation, or less often its opposite."""
        operator = self.rng.choice(("==", "==", "==", "!="))
        if self.rng.random() < 0.4:
            return f"{self.scalar(depth)} {operator} {self.rng.choice((self.scalar(depth), '0'))}"
        return (
            f"{self.quaternion(depth)} {operator} {self.rng.choice(('0', self.quaternion(depth)))}"
        )

    def equal(self, depth: int) -> tuple[str, str]:
        """Return two terms that are equal in every quaternion algebra over every commutative ring."""
        q, s = self.quaternion, self.scalar
        a, b, c = q(depth), q(depth), q(depth)
        x, y = s(depth), s(depth)
        A, T, B = self.algebra_terms
        laws: tuple[tuple[str, str], ...] = (
            (f"(({a})*({b}))*({c})", f"({a})*(({b})*({c}))"),
            (f"({a})*(({b}) - ({c}))", f"({a})*({b}) - ({a})*({c})"),
            (f"(({x})*({a}))*({b})", f"({a})*(({b})*({x}))"),
            (f"conj(({a})*({b}))", f"conj({b})*conj({a})"),
            (f"norm(({a})*({b}))", f"norm({a})*norm({b})"),
            (f"trace(({a})*({b}))", f"trace(({b})*({a}))"),
            (f"({a})**2", f"trace({a})*({a}) - norm({a})"),
            (f"comm({a}, {b})", f"({a})*({b}) - ({b})*({a})"),
            (f"({a})*conj({a})", f"norm({a})*e"),
            (f"norm(({a}) + ({b}))", f"norm({a}) + norm({b}) + trace(({a})*conj({b}))"),
            (f"({a}) - vector({a})", f"scalar({a})"),
            (f"conj({a}) + ({a})", f"trace({a})"),
            (f"norm(({x})*({a}))", f"({x})**2*norm({a})"),
            (f"(({x}) - ({y}))*(({x}) + ({y}))", f"({x})**2 - ({y})**2"),
            ("i*i", f"{A} + {T}*i"),
            ("j*j", f"({B})*e"),
            ("j*i", f"{T}*j - k"),
            (f"k*({x})", f"({x})*(i*j)"),
            ("norm(k)", f"({A})*({B})"),
            (f"({x})**3*({x})", f"({x})**2*({x})**2"),
            (f"trace(({a})*comm({b}, {a}))", "0"),
            (
                f"({a})[0] + ({a})[1]*i + ({a})[2]*j + ({a})[3]*k",
                f"({a})",
            ),
        )
        return self.rng.choice(laws)

    # Shapes; each returns a statement and whether it is true by construction.

    def _identity(self) -> tuple[str, bool]:
        left, right = self.equal(1)
        return f"{left} == {right}", not self.divide

    def _spoilt(self) -> tuple[str, bool]:
        left, right = self.equal(1)
        places = [n for n, c in enumerate(right) if c in "+-" and right[n - 1 : n] == " "]
        if places and self.rng.random() < 0.7:
            n = self.rng.choice(places)
            right = right[:n] + ("+" if right[n] == "-" else "-") + right[n + 1 :]
        else:
            right = self.rng.choice((f"-({right})", f"2*({right})", f"({right})*({right})"))
        return f"{left} == {right}", False

    def _comparison(self) -> tuple[str, bool]:
        return self.comparison(2), False

    def _implication(self) -> tuple[str, bool]:
        c = self.comparison
        return self.rng.choice(
            (
                f"{c(1)} => {c(2)}",
                f"{c(1)} and {c(1)} => {c(1)} or {c(1)}",
                f"{c(1)} => {c(1)} => {c(1)}",
                f"({c(1)} => {c(1)}) => {c(1)}",
            )
        ), False

    def _consequence(self) -> tuple[str, bool]:
        """Multiply an equation on both sides, or add two of them: true wherever it is defined."""
        a, b = self.quaternion(1), self.quaternion(1)
        c, d = self.quaternion(1), self.quaternion(0)
        text = self.rng.choice(
            (
                f"{a} == {b} => ({c})*({a})*({d}) == ({c})*({b})*({d})",
                f"{a} == {b} => norm({a}) == norm({b})",
                f"{a} == 0 and {b} == 0 => ({a})*({c}) + ({d})*({b}) == 0",
                f"({a})*({b}) == 1 => ({b})*({a}) == 1",
                f"({a})*({b}) == ({b})*({a}) => conj({a})*({b}) == ({b})*conj({a})",
                f"norm({a}) == 0 => norm(({a})*({b})) == 0",
            )
        )
        return text, not self.divide

    def _domain(self) -> tuple[str, bool]:
        """Return what holds in fields at most: what scopes are easily wrong about."""
        s, t = self.rng.choice(self.scalars), self.scalar(1)
        n, q = self.rng.choice((2, 2, 3)), self.rng.choice(self.quaternions)
        return self.rng.choice(
            (
                f"({s})**{n} == 0 => {s} == 0",
                f"{s}*({t}) == 0 => {s} == 0 or {t} == 0",
                f"{s} != 0 => {s}/{s} == 1",
                f"{s} != 0 => {s}/{s} + {n}*({t}) == 1",
                f"{s}**{n} == {s} => {s} == 0 or {s} == 1",
                f"{q}**{n} == 0 => {q}**2 == 0",
                f"{n}*{s} == 0 => {s} == 0",
                f"norm({q}) == 0 => {q} == 0",
                f"norm({q}) != 0 => {q}*inv({q}) == e",
                f"{q}*({self.quaternion(1)}) == 0 => {q} == 0 or norm({self.quaternion(1)}) == 0",
                f"{n} == 0 => {self.comparison(1)}",
                f"{n} != 0 => {self.comparison(1)}",
                f"{s}*{s} == {s} and {n} == 0 => {self.comparison(1)}",
                f"inv({q}) == inv({q})",
                f"{s}**-1 == {s}**-1 or {s} == 0",
                f"1/{n} == 1/{n} => {self.comparison(1)}",
            )
        ), False

    def _logic(self) -> tuple[str, bool]:
        c = self.comparison
        return self.rng.choice(
            (
                f"({c(1)}) <=> ({c(1)})",
                f"not ({c(1)}) => {c(1)} => {c(1)}",
                f"({c(1)}) or ({c(1)})",
                f"not ({c(1)} and {c(1)})",
                f"(not ({c(1)}) or {c(1)}) and {c(1)}",
                f"({c(1)} <=> {c(1)}) => ({c(1)} or not {c(1)})",
            )
        ), False

    def _exists(self) -> tuple[str, bool]:
        c, q, s = self.comparison, self.rng.choice(self.quaternions), self.rng.choice(self.scalars)
        free = "z" if self.generator != "z" else "y"
        return self.rng.choice(
            (
                f"exists {q}: {c(1)} and {c(1)}",
                f"exists {q}: {c(1)}",
                f"exists {free}: {free}**2 == {self.scalar(1)}",
                f"exists {free}: {free}**{self.rng.choice((2, 3))} == {self.number()}",
                f"exists {q}: {q} != 0 and norm({q}) == 0",
                f"{c(1)} => (exists {free}: {free}*{s} == {self.scalar(1)})",
            )
        ), False

    def _linear_exists(self) -> tuple[str, bool]:
        a, b, s = self.quaternion(1), self.quaternion(0), self.rng.choice(self.scalars)
        return self.rng.choice(
            (
                f"exists u: u + {s} == {b}",
                f"exists u: ({a})*u == {b}",
                f"exists u: u*({a}) - ({b})*u == {self.rng.choice('eijk')}",
                f"norm({a}) != 0 => (exists u: ({a})*u == {b})",
                f"{s} != 0 => (exists z: {s}*z == {self.number()})",
                f"exists z: {self.number()}*z == {self.number()}",
                f"exists u, z: u*({a}) + z == {b}",
                f"exists z: z*norm({b}) == {self.scalar(1)} or z == {self.scalar(0)}",
            )
        ), False


SHAPES = (
    *("identity", "identity", "spoilt", "spoilt", "comparison", "implication", "implication"),
    *("consequence", "domain", "domain", "domain", "logic", "exists", "linear_exists"),
)


def _constants(algebra: str | None) -> tuple[str, str, str]:
    """Return the texts of a, t, b."""
    if algebra is None:
        return "-1", "0", "-1"
    parts = algebra[1:].partition("|")[0].split(",")
    if len(parts) == 3:
        return f"({parts[0]})", f"({parts[2]})", f"({parts[1]})"
    return f"({parts[0]})", "1" if algebra[0] == "[" else "0", f"({parts[1]})"


def plain_statements(seed: int, count: int) -> list[str]:
    """Return random statements about H, which name no constants of a field."""
    generator: Any = Generator(seed)
    generator.divide = True
    shapes = [generator.rng.choice(SHAPES) for _ in range(count)]
    return [getattr(generator, f"_{shape}")()[0] for shape in shapes]


def cases(seed: int, count: int) -> list[Case]:
    """Return random cases, the same for the same seed."""
    generator: Any = Generator(seed)
    return [generator.case() for _ in range(count)]
