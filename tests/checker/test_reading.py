"""The checker reads a text as the prover does, or neither does: an expected claim compares what both mean."""

import random
from fractions import Fraction
from typing import Any

import pytest

from hfield.checker.check import ExpectedClaim, check
from hfield.checker.json_text import read_json
from hfield.checker.language import parse
from hfield.checker.rejection import Rejected
from hfield.errors import NotationError
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
)
from hfield.syntax import parse as parse_as_the_prover
from tests.checker.cases import certified
from tests.thorough import cases

WORDS = (
    *("p", "q", "s", "e", "i", "x", "norm", "inv", "comm", "sqrt", "and", "or", "not", "exists"),
    *("0", "1", "12", "2.5", ".5", "1.", "1e3", "2E-1", "007", "(", ")", "(", ")", "[", "]", "[0]", "[3]"),
    *(",", ":", "+", "-", "*", "/", "**", "^", "==", "!=", "=>", "<=>", "−", "·", "×", "**2", "**(-1)"),
    *(" ", "\t", "\n", "q", "p", "s", "==", "*", "+", "=", "<", "{", "²", "٣", "ｐ", "α", "_", "e3", "\0"),
)  # fmt: skip


def tree_of(node: Any) -> Any:
    """The tree that the checker should read, from that of the prover."""
    match node:
        case Number(value=value):
            return ("num", value if Fraction(value).denominator > 1 else int(value))
        case Name(name=name):
            return ("name", name)
        case Negate(operand=x):
            return ("neg", tree_of(x))
        case Not(operand=x):
            return ("not", tree_of(x))
        case Binary(op=op, left=x, right=y) | Compare(op=op, left=x, right=y):
            return (op, tree_of(x), tree_of(y))
        case Logic(op=op, left=x, right=y):
            return (op, tree_of(x), tree_of(y))
        case Power(base=x, exponent=n):
            return ("pow", tree_of(x), n)
        case Index(base=x, index=n):
            return ("index", tree_of(x), n)
        case Call(function=f, arguments=xs):
            return ("call", f, tuple(map(tree_of, xs)))
        case Exists(names=names, body=x):
            return ("exists", tuple(names), tree_of(x))
    raise AssertionError(node)


def read_by_both(text: str) -> tuple[Any, Any]:
    try:
        ours: Any = parse(text)
    except Rejected:
        ours = None
    try:
        theirs: Any = tree_of(parse_as_the_prover(text))
    except NotationError:
        theirs = None
    return ours, theirs


def test_both_read_alike() -> None:
    rng = random.Random(11)
    read = 0
    for _ in range(20_000):
        text = "".join(rng.choice(WORDS) for _ in range(rng.randint(1, 9)))
        ours, theirs = read_by_both(text)
        assert ours == theirs, text
        read += ours is not None
    assert read > 300


GRAMMAR = {
    "S": ["C", "C", "S and S", "S or S", "not C", "S => S", "(S)", "((S) <=> (S))"],
    "C": ["T == T", "T != T", "(T == T)"],
    "T": [
        "A",
        "A",
        "T + T",
        "T - T",
        "T*T",
        "T·T",
        "-T",
        "+T",
        "(T)",
        "A**2",
        "A^(-1)",
        "A[2]",
        "T × A",
    ],
    "A": ["p", "q", "s", "2", "0.25", "norm(T)", "inv(T)", "comm(T, T)", "e", "(T)", "sqrt(2)"],
}


def expanded(symbol: str, rng: random.Random, depth: int) -> str:
    rule = GRAMMAR[symbol][0] if depth > 7 else rng.choice(GRAMMAR[symbol])
    return "".join(expanded(c, rng, depth + 1) if c in GRAMMAR else c for c in rule)


def test_sentences_of_the_grammar_are_read_alike() -> None:
    rng = random.Random(12)
    for _ in range(cases(4_000)):
        text = expanded("S", rng, 0)
        ours, theirs = read_by_both(text)
        assert ours == theirs, text
        assert ours is not None or ")[2]" in text, text


def test_a_pin_compares_trees() -> None:
    text = "s != 0 => norm(q)**2 == (s/s)*norm(q*q)"
    data = certified(text, None, "identity", {"kind": "identity"})
    for same in (
        "s!=0=>norm( q )^2==((s / s)·norm(q×q))",
        "(s != 0) => (+norm(q)**(2) == ((s/s))*norm(q*q))",
    ):
        assert check(data, ExpectedClaim((same,)))
    for other in (
        "s != 0 => norm(q)**2 == s/s*norm(q*q) and 0 == 0",
        "s != 0 => norm(q)**2 == s/(s*norm(q*q))",
        "s != 0 => norm(q*q) == (s/s)*norm(q)**2",
        "norm(q)**2 == (s/s)*norm(q*q)",
        "every{s != 0 => norm(q)**2 == (s/s)*norm(q*q)}",
    ):
        with pytest.raises(Rejected, match="another statement"):
            check(data, ExpectedClaim((other,)))


def test_a_pin_compares_structure_constants_where_they_are_defined() -> None:
    data = certified("q == q", "GF(4)", "identity", {"kind": "identity"}, "(1/a,1|GF(4))")
    for same in ("(1/a,-1|GF(4))", "( 1/a , 3|GF(4))", "[1/a,1,0|GF(4))"):
        assert check(data, ExpectedClaim(("q == q",), "GF(4)", same))
    for other in (
        "(a,1|GF(4))",
        "(1/b,1|GF(4))",
        "(1/a,x|GF(4))",
        "(1/a**4*a**3,0|GF(4))",
        "[1/a,1|GF(4))",
    ):
        with pytest.raises(Rejected, match="the algebra"):
            check(data, ExpectedClaim(("q == q",), "GF(4)", other))
    wider = {**data, "algebra": "(a*a/a,1|GF(4))"}  # not defined at a = 0
    with pytest.raises(Rejected, match="the algebra"):
        check(wider, ExpectedClaim(("q == q",), "GF(4)", "(a,1|GF(4))"))


def test_json_that_could_hang_or_mean_two_things() -> None:
    for text in (
        '"' + '\\"' * 100_000,
        "[" * 100_000,
        "[" * 130 + "]" * 130,
        '{"a": 1, "a": 1}',
        '{"a": {"b": 1, "b": 2}}',
        "1e3",
        "1.0",
        "Infinity",
        "-NaN",
        "1" * 4_002,
        "[1,]",
        "'a'",
        "\ufeff{}",
        " " * 8_000_001,
    ):
        with pytest.raises(Rejected):
            read_json(text)
    assert read_json("[" * 120 + "]" * 120)
    assert read_json('{"a": -0, "b": [true, null, "\\u0031"]}') == {"a": 0, "b": [True, None, "1"]}
