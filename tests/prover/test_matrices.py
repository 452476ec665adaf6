"""Matrices in statements: prover and checker write them out alike, and as the library multiplies them."""

import json
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import pytest

from hfield import QuaternionAlgebra, Rejected, check
from hfield.checker.check import ExpectedClaim
from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.language import parse as parse_for_checker
from hfield.checker.matrices import without_matrices
from hfield.checker.scalars.rationals import ZZ
from hfield.checker.statement import read_setting
from hfield.checker.statement import read_statement as read_for_checker
from hfield.errors import NotationError
from hfield.ledger.document import read_ledger
from hfield.matrices.matrix import Matrix
from hfield.prover.prove import prove
from hfield.prover.statements.matrices import expanded
from hfield.prover.statements.printing import to_latex, to_text
from hfield.syntax import parse
from tests.subcases import subcases

PAGE = Path(__file__).parents[2] / "docs/how-to/matrix-exercises.md"


def random_term(rng: Random, depth: int, leaf: Callable[[], str]) -> str:
    """A term that is a 2 × 2 matrix."""
    if not depth:
        return leaf()
    x, y = (random_term(rng, depth - 1, leaf) for _ in range(2))
    return rng.choice(
        (
            f"({x} + {y})",
            f"({x} - {y})",
            f"{x}*{y}",
            f"-{x}",
            f"(i + 2)*{x}",
            f"{x}*j",
            f"({x} - k)",
            f"(3 + {x})",
            f"conj({x})",
            f"transpose({x})",
            f"({x})**2",
            f"comm({x}, {y})",
            f"norm({x})*{y}",
            f"trace({x})*{y}",
        )
    )


def test_prover_and_checker_write_the_same_entries() -> None:
    rng = Random(1)

    def leaf() -> str:
        return rng.choice(("L", "M", "N", "matrix(p, q, s, 1/2)", "matrix(inv(q), i, 0, t)"))

    for _ in range(300):
        x, y = (random_term(rng, rng.randint(0, 2), leaf) for _ in range(2))
        op, word = rng.choice(("==", "!=")), rng.choice(("and", "or", "=>", "<=>"))
        vector = rng.choice(("column(p, 0) == 0", f"{x}*column(p, q) != column(1, 2)"))
        end = rng.choice(("{}", "exists N: {}", "not ({})")).format(f"N {op} 1")
        text = f"({x} {op} {y} {word} {vector}) => ({end})" if "L" not in end else f"{x} {op} {y}"
        own = to_text(expanded(parse(text), (), text))
        assert parse_for_checker(own) == without_matrices(parse_for_checker(text), lambda _: False)


MATRICES: dict[str, Callable[..., Any]] = {
    "comm": lambda x, y: x @ y - y @ x,
    "transpose": lambda x: x.T,
}


@pytest.mark.parametrize("field", ["GF(3)", "QQ"])
def test_values_are_those_of_the_library(field: str) -> None:
    """A closed term is what matrices of the library give; any other value is refuted."""
    rng = Random(3)
    A = QuaternionAlgebra(field, -1, -1)
    one = A.matrix([[1, 0], [0, 1]])

    def times(x: Any, y: Any) -> Any:
        return x @ y if isinstance(x, Matrix) and isinstance(y, Matrix) else x * y

    def value(node: Any) -> Any:
        kind = type(node).__name__
        if kind == "Name":
            return dict(zip("eijk", A.basis, strict=True))[node.name]
        if kind == "Number":
            return A(node.value)
        if kind == "Negate":
            return -value(node.operand)
        if kind == "Power":
            return value(node.base) ** node.exponent
        if kind == "Call":
            values = [value(x) for x in node.arguments]
            if node.function == "matrix":
                return A.matrix([values[:2], values[2:]])
            if node.function == "norm":
                return A.scalar(values[0].reduced_norm())
            if node.function == "trace":
                return A.scalar((values[0][0, 0] + values[0][1, 1]).trace())
            if node.function == "conj":
                return values[0].conjugate_transpose().T
            return MATRICES[node.function](*values)
        x, y = value(node.left), value(node.right)
        if node.op == "*":
            return times(x, y)
        if isinstance(x, Matrix) or isinstance(y, Matrix):
            x, y = (v if isinstance(v, Matrix) else one * v for v in (x, y))
        return x + y if node.op == "+" else x - y

    def leaf() -> str:
        return (
            "matrix("
            + ", ".join(rng.choice(("0", "1", "i", "j - 1", "-k", "2*j")) for _ in "abcd")
            + ")"
        )

    for _ in range(40):
        text = random_term(rng, 2, leaf)
        found = value(parse(text))
        entries = [found[r, c] for r in (0, 1) for c in (0, 1)]
        shown = [str(q).replace("−", "-") for q in entries]
        written = "matrix(" + ", ".join(re.sub(r"(\d)([ijk])", r"\1*\2", x) for x in shown) + ")"
        right = prove(f"{text} == {written}", field)
        assert right.verdict == "proved", (text, written)
        assert check(right.certificate)
        wrong = prove(f"{text} == {written} + matrix(0, 0, k, 0)", field)
        assert wrong.verdict == "refuted"
        with pytest.raises(Rejected):
            check(json.loads(json.dumps({**right.certificate, "statement": wrong.text})))


DECIDED = [
    ("norm(conj(transpose(M))) == norm(M)", None, "proved"),
    ("norm(transpose(M)) == norm(M)", "QQ", "refuted"),
    ("matrix(s,t,x,y)**2 - (s+y)*matrix(s,t,x,y) + (s*y-t*x) == 0", None, "proved"),
    ("row(p,q)*column(r,u) == p*r + q*u", None, "proved"),
    ("M**2 == 0 => M == 0", "RR", "refuted"),
    ("M == conj(transpose(M)) => norm(M) == (M11[0]*M22[0] - norm(M12))**2", "QQ", "proved"),
    ("exists M: M*matrix(1,i,j,k) == 1", "QQ", "proved"),
    ("exists M: M**2 == 2", "QQ", "proved"),
    ("matrix(1,i,j,k)*column(p,q) == 0 => p == 0 and q == 0", "QQ", "proved"),
    ("M*q - q*M == comm(M, q)", None, "proved"),
    ("M != matrix(inv(q), 0, 0, 1)", "GF(2)", "refuted"),
    ("q**2 + i*q + 1 == 0 => q*i == i*q", "RR", "proved"),
    ("i*q - q*j == k => q != q", "QQ", "vacuous"),
]


@subcases(("text", "field", "verdict"), DECIDED)
def test_verdicts_with_certificates(text: str, field: str | None, verdict: str) -> None:
    answer = prove(text, field)
    assert answer.verdict == verdict
    assert answer.certificate is not None
    assert check(answer.certificate)


def exercises() -> list[Any]:
    found = re.search(r"```toml\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)
    assert found is not None
    claims: list[Any] = tomllib.loads(found[1])["claims"]
    return claims


def test_the_ledger_of_exercises_can_be_read(tmp_path: Path) -> None:
    found = re.search(r"```toml\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)
    assert found is not None
    (tmp_path / "sheet.toml").write_text(found[1], "utf-8")
    assert len(read_ledger(tmp_path / "sheet.toml")) == len(exercises()) == 10


@pytest.mark.slow
@subcases("claim", exercises())
def test_exercises_and_forged_certificates(claim: Any) -> None:
    """Each is decided; its certificate passes for no spoilt statement, and spoilt ones are refuted."""
    field = claim["fields"][0]
    answer = prove(claim["holds"], field)
    assert answer.verdict == ("refuted" if "corrected" in claim else "proved")
    data = answer.certificate
    assert check(data)
    other = claim.get("spoilt", "q == q")
    assert prove(other, field).verdict != answer.verdict
    with pytest.raises(Rejected):
        check({**data, "statement": other})
    turned = "proved" if answer.verdict == "refuted" else "refuted"
    with pytest.raises(Rejected):
        check({**data, "verdict": turned})


@pytest.mark.parametrize(
    "forged",
    [
        "(L*M)*N == L*(N*M)",  # another product
        "(L*M)*N == L*M",
        "(L*M)*N == transpose(L*(M*N))",
        "(L*M)*N == L*(M*N) + matrix(0, 0, 0, e)",
        "(L*M)*N == L*(M*N) and M == 0",
        "(L*M)*N != L*(M*N)",
        "L == (M*N)*(L*M)",
    ],
)
def test_a_certificate_shows_no_other_statement(forged: str) -> None:
    data = prove("(L*M)*N == L*(M*N)").certificate
    with pytest.raises(Rejected):
        check({**data, "statement": forged})


def test_shapes_and_names() -> None:
    for text, why in (
        ("M == column(p, q)", "fit"),
        ("column(p, q)*M == 0", "product"),
        ("M + row(p, q) == 0", "fit"),
        ("column(p, q) == 1", "square"),
        ("inv(M) == 1", "takes no matrix"),
        ("M[0] == 1", "expected a quaternion"),
        ("M**0 == 1", "powers"),
        ("M/M == 1", "no product"),
        ("1/M == 1", "divides"),
        ("matrix(p, q, r) == 0", "takes 4"),
        ("matrix(M, q, r, u) == 0", "expected a quaternion"),
        ("transpose(q) == q", "takes a matrix"),
        ("M", "expected a quaternion"),
        ("M == 0 => (exists M: M == 1)", "stands for something already"),
    ):
        with pytest.raises(NotationError, match=why):
            prove(text)
        with pytest.raises(Rejected):
            read_for_checker(text, read_setting("(-1,-1|F)", None))
    # where M is an element of the field it is that; where an entry is, there is no matrix of this name
    assert prove("M*q == q*M", "QQ(M)").verdict == "proved"
    assert prove("M*q == q*M", "QQ").verdict == "refuted"
    assert check(prove("M*q == q*M", "QQ(M)").certificate)
    with pytest.raises(NotationError, match="means nothing"):
        prove("M*N == N*M", "QQ(M11)")
    assert to_latex(parse("transpose(M) == matrix(M11, 0, 1, i)")) == (
        r"{M}^{\mathsf{T}} = \begin{pmatrix} M_{11} & 0 \\ 1 & i \end{pmatrix}"
    )


def test_names_of_matrices_that_a_field_has() -> None:
    """Neither a pin nor evidence over another field takes an element of it for an unknown matrix."""
    data = prove("M*q == q*M", "QQ(M)").certificate
    with pytest.raises(Rejected, match="an unknown of the statement"):
        check(data, ExpectedClaim(("M*q == q*M",), "QQ(M)"))
    over = prove("trace(M) == trace(M11) + trace(M22)", "QQ(M)").certificate
    everywhere = prove(
        "M*N == N*M"
    ).certificate  # of the same statement over all fields it is no witness
    with pytest.raises(Rejected):
        check({**everywhere, "statement": over["statement"], "evidence": over["evidence"]})


@pytest.mark.slow
def test_the_norm_of_a_product_is_checked_with_what_is_done_for_one_file() -> None:
    # what the checker does not follow is not written
    assert prove("norm(M*N) == norm(M)*norm(N)").certificate is not None


@pytest.mark.parametrize("constants", [(-1, 0, -1), (2, 1, 3), (0, 3, 0)])
def test_the_trace_of_a_product_needs_two_of_its_coordinates(
    constants: tuple[int, int, int],
) -> None:
    a, t, b = constants
    rng, scalars = Random(a), RingScalars(ZZ)
    evaluator = Evaluator(scalars, tuple(("num", n) for n in constants), {})
    terms = [
        parse_for_checker(x) for x in ("trace(P*Q)", "trace(P*Q*P)", "norm(P*Q)", "trace(2*P)")
    ]
    A = QuaternionAlgebra("ZZ", a, b, t)
    for _ in range(10):
        rows = [[rng.randint(-5, 5) for _ in range(4)] for _ in range(2)]
        p, q = (A(*row) for row in rows)
        named = dict(zip("PQ", (Quaternion(map(ZZ.fraction, row)) for row in rows), strict=True))
        evaluator.values = {("name", name): x for name, x in named.items()}
        found = [evaluator.value(term) for term in terms]
        assert [*map(int, found)] == [
            int(x) for x in ((p * q).trace(), (p * q * p).trace(), (p * q).norm(), (2 * p).trace())
        ]
