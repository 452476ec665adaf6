"""Statements about all associative algebras in Coq: what follows from relations, and tables against it.

The cofactors of a certificate are sums of word·relation·word, which Coq multiplies out (words.v). Where
the identity is not assumed, the table that refutes a claim becomes a counterexample over every
commutative ring.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from hfield.certificates.glossary import PROVED, REFUTED, VACUOUS
from hfield.coq.base_rings import base_ring_of
from hfield.coq.cofactors import MismatchError
from hfield.coq.sentences import COMPUTED, IN_RINGS, Proved
from hfield.coq.terms import NotCoveredError
from hfield.evidence import Kind
from hfield.proving.statements.setting import Setting
from hfield.syntax import Binary, Compare, Logic, Name, Negate, Node, Number, Power, parse

PLACES = ("re", "im", "jm", "km")
MAX_POWER = 200


def is_presentation(text: str) -> bool:
    """Tell whether a statement is one about all associative algebras."""
    return re.match(r"\s*associative\s*\(", text) is not None


class Presentation:
    """Relations and goals in letters, as a proposition about rings in which ``characteristic`` is 0."""

    def __init__(self, text: str, characteristic: int) -> None:
        m = re.fullmatch(r"\s*associative\s*\(([eijk,\s]*)\)\s*:(.*)", text, re.DOTALL)
        letters = "".join(m[1].split()) if m else ""
        tree = parse(m[2]) if m else None
        if letters not in ("i,j,k", "e,i,j,k") or not isinstance(tree, Logic) or tree.op != "=>":
            raise MismatchError("expected associative(i, j, k): relations => goals")
        self.letters, self.characteristic = letters.split(","), characteristic
        self.identity = "e" not in self.letters
        self.relations, self.goals = _equations(tree.left), _equations(tree.right)

    @property
    def text(self) -> str:
        """The proposition."""
        ring = "every associative ring R"
        opening = f"{ring} with identity, " if self.identity else f"{ring}, "
        p = self.characteristic
        if p:
            opening += f"(forall x : R, multiple {p} x = 0) -> "
        goals = " /\\\n  ".join(self._equation(g) for g in self.goals)
        said = " ->\n  ".join([*(self._equation(r) for r in self.relations), goals])
        return f"{opening}forall {' '.join(self.letters)} : R,\n  {said}"

    def data(self, equations: Sequence[Compare]) -> str:
        """Equations as data."""
        pairs = (f"({self._data(e.left)}, {self._data(e.right)})" for e in equations)
        return "[" + ";\n   ".join(pairs) + "]"

    def word(self, letters: str) -> str:
        """A word as data."""
        if not set(letters) <= set(self.letters):
            raise MismatchError(f"{letters!r} is no word in {', '.join(self.letters)}")
        return "[" + "; ".join(f"{'eijk'.index(x)}" for x in letters) + "]%nat"

    def _equation(self, node: Compare) -> str:
        return f"{self._text(node.left)} = {self._text(node.right)}"

    def _text(self, node: Node) -> str:
        match node:
            case Name(name) if name in self.letters:
                return name
            case Name("e"):
                return "1"
            case Number(0):
                return "0"
            case Number(value) if isinstance(value, int) and self.identity:
                return f"multiple {value} 1"
            case Negate(x):
                return f"- ({self._text(x)})"
            case Binary("*", Number(value), y) if isinstance(value, int):
                return f"multiple {value} ({self._text(y)})"
            case Binary("+" | "-" | "*" as op, x, y):
                return f"{self._inner(x)} {op} {self._inner(y)}"
            case Power(x, n) if 0 < n <= MAX_POWER:
                return " * ".join([self._inner(x)] * n)
        raise MismatchError("a relation is a polynomial in the letters with integer coefficients")

    def _inner(self, node: Node) -> str:
        text = self._text(node)
        return text if text in ("e", "i", "j", "k", "0", "1") else f"({text})"

    def _data(self, node: Node) -> str:
        match node:
            case Name(name) if name in ("e", *self.letters):
                return f"Letter {'eijk'.index(name)}"
            case Number(0):
                return "Nothing"
            case Number(value) if isinstance(value, int) and self.identity:
                return f"Multiple {value} (Letter 0)"
            case Negate(x):
                return f"Minus ({self._data(x)})"
            case Binary("*", Number(value), y) if isinstance(value, int):
                return f"Multiple {value} ({self._data(y)})"
            case Binary("+" | "-" | "*" as op, x, y):
                word = {"+": "Plus", "-": "Less", "*": "Times"}[op]
                return f"{word} ({self._data(x)}) ({self._data(y)})"
            case Power(x, n) if 0 < n <= MAX_POWER:
                out = self._data(x)
                for _ in range(n - 1):
                    out = f"Times ({out}) ({self._data(x)})"
                return out
        raise MismatchError("a relation is a polynomial in the letters with integer coefficients")


def presentation(text: str, setting: Setting, verdict: str, evidence: Mapping[str, Any]) -> Proved:
    """Prove what a verdict on a presentation says.

    Over a field of characteristic p an algebra is a ring in which p = 0. Over ℤ and ℚ the theorem is about
    all rings. Raises :class:`NotCoveredError` for proofs that divide.
    """
    p = 0 if setting.field is None else base_ring_of(setting.field).characteristic
    said = Presentation(text, p)
    kind = evidence["kind"]
    if (kind, verdict) == (Kind.PRESENTATION, PROVED):
        return _consequence(said, evidence)
    if (kind, verdict) == (Kind.ALGEBRA, REFUTED):
        if said.identity:
            raise NotCoveredError("a table against a statement with an identity")
        if setting.field is not None:
            raise NotCoveredError("a table over one field")
        return _counterexample(said.relations, said.goals, evidence)
    if (kind, verdict) == (Kind.UNSATISFIABLE, VACUOUS):
        raise NotCoveredError("relations that hold in no algebra other than 0")
    raise MismatchError(f"evidence of the kind {kind!r} does not show that this is {verdict}")


def _equations(node: Node) -> list[Compare]:
    if isinstance(node, Logic) and node.op == "and":
        return _equations(node.left) + _equations(node.right)
    if not isinstance(node, Compare) or node.op != "==":
        raise MismatchError("relations and goals are equations")
    return [node]


def _consequence(said: Presentation, evidence: Mapping[str, Any]) -> Proved:
    if evidence["characteristic"] not in (0, said.characteristic):
        raise MismatchError("the proof is one for another characteristic")
    if evidence["identity"] is not said.identity:
        raise MismatchError("whether e is the identity is not as in the statement")
    if any(p["denominator"] != 1 for p in evidence["proofs"]):
        raise NotCoveredError("a proof about associative algebras that divides by integers")
    proofs = []
    for proof in evidence["proofs"]:
        parts = (
            f"(({int(c)})%Z, {said.word(v)}, {int(n)}%nat, {said.word(w)})"
            for c, v, n, w in proof["cofactors"]
        )
        proofs.append("[" + "; ".join(parts) + "]")
    judge = "presented" if said.identity else "presented_without"
    names = ["R", "operations", "laws"]
    if said.identity:
        names.append("one")
    last = "char" if said.characteristic else "(fun _ => eq_refl)"
    data = [said.data(said.relations), said.data(said.goals), "[" + ";\n   ".join(proofs) + "]"]
    call = "\n  ".join([f"{judge} {said.characteristic}", *data, " ".join(["_", *names, last])])
    introduced = [*names, "char"] if said.characteristic else names
    return Proved(
        said.text, (f"intros {' '.join(introduced)}.", f"refine ({call}).", f"all: {COMPUTED}")
    )


def _counterexample(
    relations: Sequence[Node], goals: Sequence[Compare], evidence: Mapping[str, Any]
) -> Proved:
    """Write a refuting table as a theorem: associative, bilinear, all relations, but not the goal."""
    at = next(n for n, c in enumerate(evidence["value"]) if c)
    value = int(evidence["value"][at])
    if evidence["characteristic"]:
        raise NotCoveredError("the table refutes the claim in a single characteristic only")
    goal = goals[evidence["goal"]]
    coordinates = "".join(f"\n    ({_coordinate(evidence['table'], n)})" for n in range(4))
    parts = [
        "(forall p q r, product (product p q) r = product p (product q r))",
        "(forall s p q r, product ((s [.] p) [+] q) r = (s [.] product p r) [+] product q r)",
        "(forall s p q r, product r ((s [.] p) [+] q) = (s [.] product r p) [+] product r q)",
        *(_equation(r) for r in relations),
        f"(num {abs(value)} <> 0 -> {_product(goal.left)} <> {_product(goal.right)})",
    ]
    sign = "1" if value > 0 else "- (1)"
    lines = [
        "intro product; repeat split; try (unfold product; equations).",
        "intros N E; apply N; unfold product in E.",
        f"combine (cons ({sign}) (f_equal {PLACES[at]} E) nil).",
    ]
    text = f"let product (p q : quaternion R) := Quaternion{coordinates} in\n  "
    return Proved(text + " /\\\n  ".join(parts), tuple(lines), (), IN_RINGS)


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


def _equation(node: Node) -> str:
    assert isinstance(node, Compare)
    return f"{_product(node.left)} = {_product(node.right)}"


def _product(node: Node) -> str:
    """Write a term of e, i, j, k in the algebra of the table."""
    match node:
        case Name(name):
            return name
        case Negate(x):
            return f"([-] {_product(x)})"
        case Binary("*", x, y):
            return f"(product {_product(x)} {_product(y)})"
    raise NotCoveredError("the counterexample is written for products of letters only")
