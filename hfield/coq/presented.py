"""Theorem 1 of the thesis in Coq: what follows from relations in every associative ring.

The cofactors of the decision become a sum of ``left * (l - r) * right`` over the relations. Where
the identity is not assumed, the table that refutes the claim becomes a counterexample over every
commutative ring.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from hfield.coq.facts import NoProofError
from hfield.coq.theorems import ASSOCIATIVE, RINGS, Theorem
from hfield.syntax import Binary, Compare, Name, Negate, Node, Number, Power, parse

PLACES = ("re", "im", "jm", "km")


def presented(
    name: str,
    comment: str,
    relations: Sequence[str],
    goals: Sequence[str],
    evidence: Mapping[str, Any],
) -> Theorem:
    """Write what was proved by rewriting as a theorem about associative rings with identity.

    Raises :class:`NoProofError` when the proof is one for a single characteristic.
    """
    proofs = evidence["proofs"]
    if evidence["characteristic"] or any(p["denominator"] != 1 for p in proofs):
        raise NoProofError("the proof divides by integers, so it is not one for every ring")
    hypotheses = [_text(parse(r)) for r in relations]
    conclusion = " /\\\n  ".join(_text(parse(g)) for g in goals)
    names = [f"h{n + 1}" for n in range(len(hypotheses))]
    lines = [f"intros i j k {' '.join(names)}; repeat split."]
    for proof in proofs:
        sum_of = "nil"
        for c, left, n, right in reversed(proof["cofactors"]):
            sum_of = f"(cons ({_factor(c, left)}) ({_word(right)}) {names[n]} {sum_of})"
        lines.append(f"- combine {sum_of}.")
    text = " ->\n  ".join(["forall i j k : R,\n  " + hypotheses[0], *hypotheses[1:], conclusion])
    return Theorem(name, ASSOCIATIVE, comment, text, _script(lines))


def counterexample(
    name: str,
    comment: str,
    relations: Sequence[str],
    goals: Sequence[str],
    evidence: Mapping[str, Any],
) -> Theorem:
    """Write a refuting table as a theorem: associative, bilinear, all relations, but not the goal.

    Raises :class:`NoProofError` when the table is one for a single characteristic.
    """
    at = next(n for n, c in enumerate(evidence["value"]) if c)
    value = int(evidence["value"][at])
    if evidence["characteristic"]:
        raise NoProofError("the table refutes the claim in a single characteristic only")
    goal = parse(goals[evidence["goal"]])
    assert isinstance(goal, Compare)
    product = f"{name}_product"
    definition = (
        f"Definition {product} (p q : quaternion R) := Quaternion\n"
        + "\n".join(f"  ({_coordinate(evidence['table'], n)})" for n in range(4))
        + "."
    )
    parts = [
        f"(forall p q r, {product} ({product} p q) r = {product} p ({product} q r))",
        f"(forall s p q r, {product} ((s [.] p) [+] q) r = (s [.] {product} p r) [+] {product} q r)",
        f"(forall s p q r, {product} r ((s [.] p) [+] q) = (s [.] {product} r p) [+] {product} r q)",
        *(_equation(parse(r), product) for r in relations),
        f"(num {abs(value)} <> 0 -> {_product(goal.left, product)} <> {_product(goal.right, product)})",
    ]
    sign = "1" if value > 0 else "- (1)"
    lines = [
        f"repeat split; try (unfold {product}; equations).",
        f"intros N E; apply N; unfold {product} in E.",
        f"combine (cons ({sign}) (f_equal {PLACES[at]} E) nil).",
    ]
    text = " /\\\n  ".join(parts)
    return Theorem(name, RINGS, comment, text, _script(lines), before=definition)


def _script(lines: Sequence[str]) -> str:
    return "\n".join(["Proof.", *(f"  {line}" for line in lines), "Qed."])


# --- words in an associative ring ----------------------------------------------------------------


def _text(node: Node) -> str:
    """Write a relation or a term of the letters, e being the identity 1."""
    match node:
        case Compare("==", x, y):
            return f"{_text(x)} == {_text(y)}"
        case Name(name):
            return "1" if name == "e" else name
        case Number(value) if isinstance(value, int):
            return _number(value)
        case Negate(x):
            return f"- ({_text(x)})"
        case Binary("+" | "-" | "*" as op, x, y):
            return f"{_inner(x)} {op} {_inner(y)}"
        case Power(x, n) if n > 0:
            return " * ".join([_inner(x)] * n)
    raise NoProofError("this is no polynomial in the letters with integer coefficients")


def _inner(node: Node) -> str:
    text = _text(node)
    return text if text in ("i", "j", "k", "0", "1") else f"({text})"


def _number(n: int) -> str:
    """Write an integer by doubling, which any ring with 1 understands."""
    if n < 2:
        return str(n)
    half = f"(1 + 1) * ({_number(n // 2)})"
    return f"1 + {half}" if n % 2 else half


def _word(word: str) -> str:
    return " * ".join(word) or "1"


def _factor(c: int, word: str) -> str:
    text = _word(word)
    if abs(c) != 1:
        text = f"({_number(abs(c))}) * {text}"
    return f"- ({text})" if c < 0 else text


# --- an algebra given by its table ---------------------------------------------------------------


def _coordinate(table: Mapping[str, Sequence[int]], n: int) -> str:
    """Write a coordinate of the product p·q: the sum over the table's entries."""
    out = "0"
    for place, vector in table.items():
        p, q = (f"{PLACES['eijk'.index(x)]} {of}" for x, of in zip(place, "pq", strict=True))
        c = int(vector[n])
        if c:
            body = f"{p} * {q}" if abs(c) == 1 else f"num {abs(c)} * {p} * {q}"
            out = f"{out} {'-' if c < 0 else '+'} {body}" if out != "0" or c < 0 else body
    return out


def _equation(node: Node, product: str) -> str:
    assert isinstance(node, Compare)
    return f"{_product(node.left, product)} = {_product(node.right, product)}"


def _product(node: Node, product: str) -> str:
    """Write a term of e, i, j, k in the algebra whose product is named."""
    match node:
        case Name(name):
            return name
        case Negate(x):
            return f"([-] {_product(x, product)})"
        case Binary("*", x, y):
            return f"({product} {_product(x, product)} {_product(y, product)})"
    raise NoProofError("the counterexample is written for products of letters only")
