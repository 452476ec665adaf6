"""Statements about all associative algebras in Coq: what follows from relations, and tables against it.

The cofactors of a certificate become a sum of ``left * (l - r) * right`` over the relations. Where
the identity is not assumed, the table that refutes a claim becomes a counterexample over every
commutative ring.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from hfield.coq.cofactors import MismatchError
from hfield.coq.judgement import IN_ASSOCIATIVE, IN_RINGS, Proved
from hfield.coq.rooms import room_of
from hfield.coq.terms import NotCoveredError
from hfield.proving.statements.setting import Setting
from hfield.syntax import Binary, Compare, Logic, Name, Negate, Node, Number, Power, parse

PLACES = ("re", "im", "jm", "km")


def is_presentation(text: str) -> bool:
    """Tell whether a statement is one about all associative algebras."""
    return re.match(r"\s*associative\s*\(", text) is not None


def presentation(
    name: str, text: str, setting: Setting, verdict: str, evidence: Mapping[str, Any]
) -> Proved:
    """Prove what a verdict on a presentation says, over every ring: it holds for algebras over one.

    Raises :class:`NotCoveredError` when the proof is one for a single characteristic.
    """
    m = re.fullmatch(r"\s*associative\s*\(([eijk,\s]*)\)\s*:(.*)", text, re.DOTALL)
    letters = "".join(m[1].split()) if m else ""
    tree = parse(m[2]) if m else None
    if letters not in ("i,j,k", "e,i,j,k") or not isinstance(tree, Logic) or tree.op != "=>":
        raise MismatchError("expected associative(i, j, k): relations => goals")
    if setting.field is not None:
        room_of(setting.field)
    relations, goals = _equations(tree.left), _equations(tree.right)
    kind = evidence["kind"]
    if (kind, verdict) == ("presentation", "proved"):
        if letters != "i,j,k":
            raise NotCoveredError("consequences of relations without an identity")
        return _consequence(relations, goals, evidence)
    if (kind, verdict) == ("algebra", "refuted"):
        if letters == "i,j,k":
            raise NotCoveredError("a table against a statement with an identity")
        if setting.field is not None:
            raise NotCoveredError("a table over one field")
        return _counterexample(name, relations, goals, evidence)
    raise MismatchError(f"evidence of the kind {kind!r} does not show that this is {verdict}")


def _equations(node: Node) -> list[Compare]:
    if isinstance(node, Logic) and node.op == "and":
        return _equations(node.left) + _equations(node.right)
    if not isinstance(node, Compare) or node.op != "==":
        raise MismatchError("relations and goals are equations")
    return [node]


def _consequence(
    relations: Sequence[Node], goals: Sequence[Node], evidence: Mapping[str, Any]
) -> Proved:
    proofs = evidence["proofs"]
    if len(proofs) != len(goals):
        raise MismatchError("there are not as many proofs as goals")
    if evidence["characteristic"] or any(p["denominator"] != 1 for p in proofs):
        raise NotCoveredError("the proof divides by integers, so it is not one for every ring")
    hypotheses = [_text(r) for r in relations]
    conclusion = " /\\\n  ".join(_text(g) for g in goals)
    names = [f"h{n + 1}" for n in range(len(hypotheses))]
    lines = [f"intros i j k {' '.join(names)}; repeat split."]
    for proof in proofs:
        sum_of = "nil"
        for c, left, n, right in reversed(proof["cofactors"]):
            if not set(left + right) <= set("ijk"):
                raise MismatchError("a cofactor is no word in i, j, k")
            sum_of = f"(cons ({_factor(c, left)}) ({_word(right)}) {names[n]} {sum_of})"
        lines.append(f"- combine {sum_of}.")
    text = " ->\n  ".join(["forall i j k : R,\n  " + hypotheses[0], *hypotheses[1:], conclusion])
    return Proved(text, tuple(lines), place=IN_ASSOCIATIVE)


def _counterexample(
    name: str, relations: Sequence[Node], goals: Sequence[Compare], evidence: Mapping[str, Any]
) -> Proved:
    """Write a refuting table as a theorem: associative, bilinear, all relations, but not the goal."""
    at = next(n for n, c in enumerate(evidence["value"]) if c)
    value = int(evidence["value"][at])
    if evidence["characteristic"]:
        raise NotCoveredError("the table refutes the claim in a single characteristic only")
    goal = goals[evidence["goal"]]
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
        *(_equation(r, product) for r in relations),
        f"(num {abs(value)} <> 0 -> {_product(goal.left, product)} <> {_product(goal.right, product)})",
    ]
    sign = "1" if value > 0 else "- (1)"
    lines = [
        f"repeat split; try (unfold {product}; equations).",
        f"intros N E; apply N; unfold {product} in E.",
        f"combine (cons ({sign}) (f_equal {PLACES[at]} E) nil).",
    ]
    return Proved(" /\\\n  ".join(parts), tuple(lines), (definition,), IN_RINGS)


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
    raise NotCoveredError("this is no polynomial in the letters with integer coefficients")


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
    raise NotCoveredError("the counterexample is written for products of letters only")
