"""Constants with unknown digits: a verdict holds for all numbers that have the digits known.

A number is written by its digits up to an O(…), in several ways; with the same digits it is the same
number (but ``5 + O(5)`` is not known to be ``O(5)``). The oracle puts many exact numbers in for it, and
evaluates by formulas of its own.
"""

from random import Random

import pytest

from hfield import QuaternionAlgebra, prove, ring
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.errors import UndecidedError
from tests.subcases import first_quick
from tests.thorough import cases

PROVED, REFUTED, UNDECIDED = "proved", "refuted", "undecided"


@pytest.mark.parametrize(
    ("statement", "algebra", "verdict"),
    [
        # the same digits are the same number, in statements and in algebras
        ("i*i == -2+O(5^4)", "(-2+O(5^4),3|Qp(5))", PROVED),
        ("i*i != -2+O(5^4)", "(-2+O(5^4),3|Qp(5))", REFUTED),
        ("i*i == O(5^4)+623", "(-2+O(625),3|Qp(5))", PROVED),
        ("627+O(5^4) != 2+O(5^4)", "H(Qp(5))", REFUTED),
        ("i*i == 1+t+O(t)", "(1+t+O(t),-1|GF(3)((t)))", PROVED),
        ("i*i == 1+1/t+O(1/t)", "(1+O(1/t),-1|GF(3)(t)_inf)", PROVED),
        ("i*i == 3+O(2)", "(I+O((1+I)^2),-1|QQ(I)_(2))", REFUTED),
        ("i*i == 2+I+O(2)", "(I+O((1+I)^2),-1|QQ(I)_(2))", PROVED),
        ("i*i == j*j", "(3+O(5),8+O(5)|Qp(5))", PROVED),
        ("i*i == sqrt(-1)", "(sqrt(-1),3|Qp(5))", PROVED),
        ("O(2^3) == O(2^3)", "H(Qp(2))", PROVED),
        ("O(2^3) - O(8) == 0", "H(Qp(2))", PROVED),
        ("8+O(2^3) == 24+O(8)", "H(Qp(2))", PROVED),
        ("0+O(2^3) == O(2^3)", "H(Qp(2))", PROVED),
        ("i*i == 16+O(8)", "(8+O(8),3|Qp(2))", PROVED),
        # what is computed, and what is known to other digits, is another number
        ("O(2^3) + O(2^3) == O(2^3)", "H(Qp(2))", UNDECIDED),
        ("O(2^3) - O(2^3) == O(2^3)", "H(Qp(2))", UNDECIDED),
        ("O(2^3) == O(2^4)", "H(Qp(2))", UNDECIDED),
        ("8+O(2^3)-O(2^3) == 8", "H(Qp(2))", UNDECIDED),
        ("8+O(2^3)-O(2^3) == 0", "H(Qp(2))", UNDECIDED),
        ("1+O(1) == O(1)", "H(Qp(2))", UNDECIDED),
        ("2*(1+O(2)) == 2+O(4)", "H(Qp(2))", UNDECIDED),
        ("2*(1+O(2)) != 2+O(4)", "H(Qp(2))", UNDECIDED),
        ("-(2+O(5)) == -2+O(5)", "H(Qp(5))", UNDECIDED),
        ("2-O(5) == 2+O(5)", "H(Qp(5))", UNDECIDED),
        ("i*i == 2*(1+O(5))", "(2*(1+O(5)),3|Qp(5))", PROVED),
        ("i*i == 2+O(5)", "(2*(1+O(5)),3|Qp(5))", UNDECIDED),
        ("i*i == 0", "(O(5)-O(5),3|Qp(5))", PROVED),
        ("sqrt(4+O(7^2)) == 2+O(7^2)", "H(Qp(7))", UNDECIDED),
        ("sqrt(4+O(7^2)) == sqrt(53+O(7^2))", "H(Qp(7))", PROVED),
        # digits that are known tell
        ("1+O(5) == 2+O(5)", "H(Qp(5))", REFUTED),
        ("O(5) + 1 != 0", "H(Qp(5))", PROVED),
        ("i*(1+O(t)) == 0", "H(GF(3)((t)))", REFUTED),
        ("O(2)*e + i == 0", "H(Qp(2))", REFUTED),
        ("O(2) == 0 or i*i == -1", "H(Qp(2))", PROVED),
        ("O(2) == 0 and i*i == 1", "H(Qp(2))", REFUTED),
        ("O(2) == 0 or O(2) != 0", "H(Qp(2))", PROVED),
        ("s*O(2) == s*O(4)", "H(Qp(2))", UNDECIDED),
        ("x*(1+O(2)) == (1+O(2))*x", "H(Qp(2))", PROVED),
        ("x*(1+O(2)) == 0 => x == 0", "H(Qp(2))", PROVED),
        ("x == 1+O(5) => x == 6+O(5)", "H(Qp(5))", PROVED),
        ("x == 1+O(5) => x == 1+O(5^2)", "H(Qp(5))", UNDECIDED),
        ("exists s: s*(1+O(3)) == 1", "H(Qp(3))", PROVED),
        ("exists s: s == O(3)", "H(Qp(3))", PROVED),
        # what holds in every algebra holds in these
        ("i*j == -j*i", "(3+O(2^2),-1|Qp(2))", PROVED),
        ("i*j == -j*i", "(3+O(2^2)-3,O(2)|Qp(2))", PROVED),
        ("norm(p*q) == norm(p)*norm(q)", "(O(t),1+O(t^2)|GF(2)((t)))", PROVED),
        # where it is not known whether there is an algebra, or a constant
        ("i*j == -j*i", "(1/O(5),3|Qp(5))", UNDECIDED),
        ("sqrt(1+O(2)) == sqrt(1+O(2))", "H(Qp(2))", UNDECIDED),
        ("q == q", "(sqrt(1+O(2)),3|Qp(2))", UNDECIDED),
        ("1/O(5) == 1/O(5)", "H(Qp(5))", UNDECIDED),
        ("inv(O(5)*e) == 1", "H(Qp(5))", UNDECIDED),
        ("(1+O(5))/(6+O(5)) == 1", "H(Qp(5))", PROVED),
    ],
)  # fmt: skip
def test_verdicts(statement, algebra, verdict):
    found = prove(statement, algebra=algebra)
    assert found.verdict == verdict
    assert found.certificate is None or "O(" not in statement + found.setting.algebra


def test_hypotheses_that_are_named_apart_mean_the_same_numbers():
    given = ["x == 1+O(5)", "y == 6+O(5)"]
    assert prove("x == y", "Qp(5)", given).verdict == PROVED
    assert prove("x == y + O(5)", "Qp(5)", given).verdict == UNDECIDED
    assert prove("x == 2", "Qp(5)", ["1+O(5) == 2"]).verdict == "vacuous"


def test_an_algebra_keeps_its_name():
    for text in (
        "(623+O(5^4),3|Qp(5))", "(2*(1+O(5)),O(5)|Qp(5))", "[O(t),1+O(t^2)|GF(2)((t)))",
        "(5^2+O(5^2),-1|Qp(5))",
    ):  # fmt: skip
        found = prove("q == q", algebra=text)
        assert found.setting.algebra == text
        assert prove("q == q", algebra=QuaternionAlgebra.from_text(text)).verdict == PROVED


def test_no_function_of_the_global_field_leaves_out_digits():
    F = ring("QQ(root(2,3))_(2, root(2,3))")
    assert F("cbrt(2)") == F.gen
    for name in sorted(F.functions().keys() - {"O", "sqrt"}):
        arguments = "(2+O(2^9), 3)" if name == "root" else "(2+O(2^9))"
        with pytest.raises(UndecidedError, match="digits"):
            F(name + arguments)


FORGED = {"schema": "hfield-cert/2", "assumes": [], "verdict": "proved"}


@pytest.mark.parametrize(
    "statement",
    ["O(5) == O(5)", "O(0,5) == O(0,5)", "i*i != -2+O(5^4)", "x == x or O(5) == 1", "O == O"],
)
@pytest.mark.parametrize("algebra", ["(-1,-1|Qp(5))", "(O(5),-1|Qp(5))", "(O(0,5),-1|Qp(5))"])
def test_the_checker_reads_no_constant_with_unknown_digits(statement, algebra):
    data = prove("q == q", "Qp(5)").certificate
    forged = {**data, "statement": statement, "algebra": algebra}
    with pytest.raises(Rejected):
        check(forged)
    with pytest.raises(Rejected):
        check({**data, "algebra": "(O(5),-1|Qp(5))"})


# --- random statements -------------------------------------------------------------------------


class Numbers:
    """Numbers of a local field by their digits, as texts and as exact numbers that have these digits."""

    def __init__(self, name, rng):
        self.F, self.rng = ring(name), rng
        self.K, self.pi = self.F.global_field, self.F.pi

    def digit(self):
        """A residue, lifted."""
        residues, x = self.F.residues, self.K(0)
        basis = residues.over_prime_field()
        p = round(residues.order ** (1 / len(basis)))
        for r in basis:
            x += self.K(self.rng.randrange(p)) * self.K(residues.lift(r))
        return x

    def sum(self, digits):
        """Σ d·πᵐ."""
        return sum((d * self.pi**m for m, d in enumerate(digits)), self.K(0))

    def literal(self):
        """A text, and what number it means: its digits, and whether more than zeros are written before O."""
        digits = tuple(self.digit() for _ in range(self.rng.choice((0, 1, 1, 2, 3))))
        n = len(digits)
        above = self.pi**n
        value = self.sum(digits) + self.rng.choice((0, 0, 1, -1, 2)) * above
        big_o = f"O({self.K.text(above * self.rng.choice((1, 1, -1)))})"
        shown = self.K.text(value)
        key = digits, not self.K.is_zero(value) and self.K.is_zero(self.sum(digits))
        if self.K.is_zero(value) and self.rng.random() < 0.7:
            return big_o, key
        return self.rng.choice((f"({shown}+{big_o})", f"({big_o}+({shown}))")), key

    def is_exact(self, texts):
        """Whether all texts are of numbers without an O(…)."""
        return all(self.F(text).is_exact for text in texts)

    def number(self, key):
        """An exact number with these digits."""
        digits, _ = key
        rest = self.rng.choice((0, 0, 1, -1, self.sum([self.digit() for _ in range(3)])))
        return self.sum(digits) + rest * self.pi ** len(digits)


class UndefinedError(Exception):
    """A term divides by 0."""


class World:
    """Terms and statements as nested tuples, at exact values for their constants and unknowns."""

    def __init__(self, K, numbers, constants, unknowns):
        self.K, self.numbers, self.unknowns = K, numbers, unknowns
        self.a, self.b = K(0), K(0)
        self.a, self.b = map(self.term, constants)

    def four(self, x):
        return x if isinstance(x, tuple) else (x, self.K(0), self.K(0), self.K(0))

    def product(self, p, q):
        """(u + v·j)(r + s·j) = (u·r + b·v·conj(s)) + (u·s + v·conj(r))·j over F(i)."""

        def times(u, v):
            return u[0] * v[0] + self.a * u[1] * v[1], u[0] * v[1] + u[1] * v[0]

        (u, v), (r, s) = ((x[:2], x[2:]) for x in (p, q))
        parts = [
            times(u, r), times(v, (s[0], -s[1])), times(u, s), times(v, (r[0], -r[1])),
        ]  # fmt: skip
        ur, vs, us, vr = parts
        return (*(x + self.b * y for x, y in zip(ur, vs, strict=True)),
                *(x + y for x, y in zip(us, vr, strict=True)))  # fmt: skip

    def term(self, t):
        match t:
            case ("number", n):
                return self.numbers[n]
            case ("integer", n):
                return self.K(n)
            case ("basis", name):
                return tuple(self.K(int(name == unit)) for unit in "eijk")
            case ("unknown", name):
                return self.unknowns[name]
            case ("norm", x):
                w, x, y, z = self.four(self.term(x))
                return w * w - self.a * x * x - self.b * (y * y - self.a * z * z)
            case ("/", x, y):
                divisor = self.term(y)
                if self.K.is_zero(divisor):
                    raise UndefinedError
                x, inverse = self.term(x), self.K.inverse(divisor)
                return tuple(c * inverse for c in x) if isinstance(x, tuple) else x * inverse
        x, y = map(self.term, t[1:])
        if not (isinstance(x, tuple) or isinstance(y, tuple)):
            return x + y if t[0] == "+" else x - y if t[0] == "-" else x * y
        x, y = self.four(x), self.four(y)
        if t[0] == "*":
            return self.product(x, y)
        return tuple(c + d if t[0] == "+" else c - d for c, d in zip(x, y, strict=True))

    def truth(self, t):
        if t[0] in ("==", "!="):
            try:
                x, y = (self.four(self.term(s)) for s in t[1:])
            except UndefinedError:
                return False
            same = all(self.K.is_zero(c - d) for c, d in zip(x, y, strict=True))
            return same == (t[0] == "==")
        first, *rest = map(self.truth, t[1:])
        if t[0] == "not":
            return not first
        (second,) = rest
        return {"and": first and second, "or": first or second, "=>": not first or second}[t[0]]


def random_term(rng, depth, count, names, scalar=False):
    if not depth or rng.random() < 0.2:
        leaves = [("number", rng.randrange(count))] * 4 + [("integer", rng.randint(-3, 5))]
        leaves += [("unknown", name) for name in names if not scalar or name == "x"]
        leaves += [] if scalar else [("basis", rng.choice("eijk"))]
        return rng.choice(leaves)
    op = rng.choice("+-*+-*/N")
    if op == "N":
        return "norm", random_term(rng, depth - 1, count, names)
    right = random_term(rng, depth - 1, count, names, scalar or op == "/")
    return op, random_term(rng, depth - 1, count, names, scalar), right


def random_statement(rng, count, names):
    def comparison():
        x = random_term(rng, rng.randint(0, 2), count, names)
        near = [x, ("-", ("+", x, ("number", 0)), ("number", 0)), ("+", x, ("number", count - 1))]
        y = rng.choice([*near, random_term(rng, rng.randint(0, 2), count, names)])
        return rng.choice(("==", "==", "!=")), x, y

    made = comparison()
    if rng.random() < 0.4:
        made = rng.choice(("and", "or", "=>", "=>")), made, comparison()
    return ("not", made) if rng.random() < 0.2 else made


def written(t, texts):
    match t:
        case ("number", n):
            return texts[n]
        case ("integer" | "basis" | "unknown", x):
            return f"({x})"
        case ("norm" | "not" as word, x):
            return f"({word}({written(x, texts)}))"
        case (op, x, y):  # an O(…) alone in a sum would be part of a number: 0 + O(…) is not
            x, y = (written(s, texts) for s in (x, y))
            x, y = (f"(0+{s})" if s.startswith("O") and op == "+" else s for s in (x, y))
            return f"({x} {op} {y})"
    raise AssertionError(t)


FIELDS = (
    "Qp(2)",
    "Qp(5)",
    "GF(3)((t))",
    "GF(4)((t))",
    "QQ(I)_(2)",
    "GF(2)(t)_inf",
    "QQ(sqrt(2))_(3)",
)


def judge(name, seed, timeout=2.0):
    """Decide a random statement; return what was asked, the verdict, and truths at exact numbers.

    There are several at each choice of numbers, one for each place; one at the witness, where there is one.
    """
    rng = Random(f"{name} {seed}")
    numbers = Numbers(name, rng)
    literals = [numbers.literal() for _ in range(rng.randint(1, 3))]
    texts, keys = zip(*literals, strict=True)
    names = [x for x in "xq" if x not in numbers.F.names() and rng.random() < 0.3]
    statement = random_statement(rng, len(texts), names)
    own = [
        ("number", 0),
        ("number", len(texts) - 1),
        ("integer", -1),
        ("*", ("integer", 3), ("number", 0)),
    ]
    constants = rng.choice(own), rng.choice(own)
    a, b = (written(x, texts) for x in constants)
    question = written(statement, texts), f"({a},{b}|{name})"
    found = prove(question[0], algebra=question[1], timeout=timeout)
    K, truths = numbers.K, []
    for _ in range(30):
        chosen = {key: numbers.number(key) for key in keys}
        exact = [chosen[key] for key in keys]
        small = [K(0), K(1), K(-1), *exact]
        places = [
            {"x": rng.choice(small), "q": tuple(rng.choice(small) for _ in range(4))}
            for _ in range(10 if names else 1)
        ]
        if found.verdict == REFUTED and all(map(numbers.is_exact, found.witness.values())):
            values = {name: tuple(map(K, x)) for name, x in found.witness.items()}
            places = [{name: x if len(x) == 4 else x[0] for name, x in values.items()}]
        truths.append([World(K, exact, constants, place).truth(statement) for place in places])
    return question, found, truths


@pytest.mark.parametrize("name", first_quick(FIELDS, 2))
def test_random_statements_are_decided_as_for_all_numbers_with_these_digits(name):
    seen = set()
    for seed in range(cases(100)):
        question, found, truths = judge(name, seed)
        seen.add(found.verdict)
        assert found.certificate is None or "O(" not in "".join(question), question
        if found.verdict in (PROVED, "vacuous"):
            assert all(map(all, truths)), question
        if found.verdict == REFUTED:
            assert not any(map(all, truths)), question
    assert {PROVED, REFUTED} <= seen
