"""Coq proofs of compound statements, such as ``every{…}``, and about associative algebras.

The cofactors of a presentation are sums of word·relation·word, which Coq multiplies out (words.v). If no
identity element is assumed, the table that refutes a claim becomes a counterexample over every commutative
ring (docs/reference/certificates.md).
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from hfield.checker.glossary import PROVED, REFUTED, VACUOUS
from hfield.checker.rejection import Rejected
from hfield.checker.vocabulary.logic import VocabularyStatement, read_proposition
from hfield.evidence import Kind
from hfield.export.coq.base_rings import base_ring_of
from hfield.export.coq.certificate_data import EvidenceData, PartData
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.judgement import Judgement
from hfield.export.coq.sentences import COMPUTED, IN_RINGS, Proved
from hfield.export.coq.terms import NotCoveredError
from hfield.fields import Ring
from hfield.fields.names import ring
from hfield.prover.statements.setting import Setting
from hfield.syntax import Binary, Compare, Logic, Name, Negate, Node, Number, Power, parse

LOGIC = ("every", "implies", "iff", "not-everywhere", "over", "angles", "citing")
MAX_DEPTH = 6


def read(text: str) -> VocabularyStatement | None:
    """Read a compound statement as the checker does; None for a statement of the language."""
    try:
        return read_proposition(text)
    except Rejected as error:
        raise MismatchError(str(error)) from error


def judge(
    name: str,
    text: str,
    setting: Setting,
    verdict: str,
    evidence: EvidenceData,
    depth: int = 0,
) -> Proved:
    """Prove the verdict on any statement. Raises NotCoveredError and MismatchError."""
    if depth > MAX_DEPTH:
        raise MismatchError("the statement nests too deeply")
    whole = read(text)
    if whole is not None:
        return _CompoundStatement(name, whole, setting, depth).judge(verdict, evidence)
    if is_presentation(text):
        return presentation(text, setting, verdict, evidence)
    if setting.field is None and evidence.get("kind") == Kind.OVER:
        evidence = _over(evidence)
    return Judgement(name, text, setting).by(verdict, evidence)


def _over(evidence: EvidenceData) -> EvidenceData:
    """Return evidence against a statement over one field as evidence against it over all fields."""
    inner = evidence["evidence"]
    if inner.get("ring", evidence["ring"]) != evidence["ring"]:
        raise MismatchError("the fields of the evidence do not agree")
    return {**inner, "ring": evidence["ring"]}


def claimed(text: str, setting: Setting) -> str:
    """Return the proposition that a statement claims, whether it is true or false."""
    whole = read(text)
    if whole is None:
        if is_presentation(text):
            field = setting.field
            return PresentationStatement(
                text, 0 if field is None else base_ring_of(field).characteristic
            ).text
        return Judgement("", text, setting).sentence.text
    parts = [claimed(part, setting) for part in whole.parts] if whole.word in LOGIC[:3] else []
    match whole.word, parts:
        case "every", _:
            return " /\\\n  ".join(f"({part})" for part in parts)
        case "implies", [p, q]:
            return f"({p}) -> {q}"
        case "iff", [p, q]:
            return f"({p}) <-> ({q})"
        case "angles", _ if _core_alone(whole, setting):
            return claimed(whole.parts[0], setting)
        case "over", _:
            here = replace(setting, field=_named(whole.parts[0]))
            return claimed(whole.parts[1], here)
    raise _no_word(whole.word)


def _named(name: str) -> Ring:
    """Return the ring with a canonical name."""
    found = ring(name.strip())
    if found.name != name.strip():
        raise MismatchError(f"{name} is not the name of {found.name}")
    return found


def _core_alone(angles: VocabularyStatement, setting: Setting) -> bool:
    """Return whether ``angles{P; Q}`` reduces to P, because Q is a statement about RR."""
    if setting.field is None:
        return len(angles.parts) == 1
    return setting.field.name != "RR"


def _no_word(word: str) -> NotCoveredError:
    return NotCoveredError(f"the word {word!r} of the ledger's vocabulary")


class _CompoundStatement:
    """A statement composed of others."""

    def __init__(self, name: str, whole: VocabularyStatement, setting: Setting, depth: int) -> None:
        self.name, self.whole, self.setting, self.depth = name, whole, setting, depth

    def part(self, n: int, verdict: str, evidence: EvidenceData) -> tuple[Proved, str]:
        """Prove a part as a lemma; return it and its name."""
        name = f"{self.name}_{n + 1}"
        text = self.whole.parts[n]
        if verdict == "vacuous" and read(text) is None:
            return Judgement(name, text, self.setting).true_vacuously(evidence), name
        own = judge(name, text, self.setting, verdict, evidence, self.depth + 1)
        if verdict == "vacuous":  # for implies{P; Q} this means that P is false
            never = f"{name}_never"
            lines = (f"intro P; elim ({never} P).",)
            return Proved(claimed(text, self.setting), lines, (own.lemma(never),)), name
        if own.place:
            raise NotCoveredError("a table against associative algebras inside another statement")
        return own, name

    def judge(self, verdict: str, evidence: EvidenceData) -> Proved:
        """Prove the verdict."""
        word, kind = self.whole.word, evidence.get("kind")
        if word not in LOGIC:
            raise _no_word(word)
        if word == "over":
            here = replace(self.setting, field=_named(self.whole.parts[0]))
            return judge(self.name, self.whole.parts[1], here, verdict, evidence, self.depth + 1)
        if word == "angles" and _core_alone(self.whole, self.setting):
            return judge(
                self.name, self.whole.parts[0], self.setting, verdict, evidence, self.depth + 1
            )
        if word == "not-everywhere" and verdict == "proved":
            anywhere = replace(self.setting, field=None)
            return judge(
                self.name, self.whole.parts[0], anywhere, "refuted", _over(evidence), self.depth + 1
            )
        match word, verdict, kind:
            case "every", "proved", Kind.PARTS:
                return self._every(evidence["parts"])
            case "every", "refuted", Kind.PART:
                return self._not_every(evidence)
            case "implies", "proved", Kind.CONCLUSION:
                whole = claimed(self._text, self.setting)
                own, name = self.part(1, "proved", evidence["evidence"])
                return Proved(whole, (f"exact (fun _ => {name}).",), (own.lemma(name),))
            case "implies", "vacuous", Kind.HYPOTHESIS:
                return self.part(0, "refuted", evidence["evidence"])[0]
            case "iff", _, Kind.BOTH:
                return self._iff(verdict, evidence)
        raise NotCoveredError(f"{word}{{…}} by evidence of the kind {kind!r}")

    @property
    def _text(self) -> str:
        return f"{self.whole.word}{{{';'.join(self.whole.parts)}}}"

    def _every(self, parts: Sequence[PartData]) -> Proved:
        if len(parts) != len(self.whole.parts):
            raise MismatchError("there is not evidence for every part")
        found = []
        for n, part in enumerate(parts):
            if part["verdict"] not in ("proved", "vacuous"):
                raise MismatchError("a part is neither proved nor vacuous")
            found.append(self.part(n, part["verdict"], part["evidence"]))
        text = " /\\\n  ".join(f"({own.text})" for own, _ in found)
        lines = [f"split; [exact {name} |]." for _, name in found[:-1]]
        lines.append(f"exact {found[-1][1]}.")
        return Proved(text, tuple(lines), tuple(own.lemma(name) for own, name in found))

    def _not_every(self, evidence: EvidenceData) -> Proved:
        n = evidence["part"]
        if not 0 <= n < len(self.whole.parts):
            raise MismatchError("there is no part of that number")
        own, name = self.part(n, "refuted", evidence["evidence"])
        texts = [
            own.text[3:-1] if m == n and own.text.startswith("~ (") else claimed(part, self.setting)
            for m, part in enumerate(self.whole.parts)
        ]
        whole = " /\\\n  ".join(f"({text})" for text in texts)
        lines = ["intro F.", *["destruct F as [_ F]."] * n, f"exact ({name} F)."]
        if n < len(texts) - 1:
            lines[-1] = f"exact ({name} (proj1 F))."
        return Proved(f"~ ({whole})", tuple(lines), (own.lemma(name),))

    def _iff(self, verdict: str, evidence: EvidenceData) -> Proved:
        left, right = evidence["left"], evidence["right"]
        verdicts = left["verdict"], right["verdict"]
        if not set(verdicts) <= {"proved", "refuted"}:
            raise MismatchError("a side is neither proved nor refuted")
        if (verdicts[0] == verdicts[1]) != (verdict == "proved"):
            raise MismatchError("the two sides do not show this")
        first, a = self.part(0, verdicts[0], left["evidence"])
        second, b = self.part(1, verdicts[1], right["evidence"])
        whole = claimed(self._text, self.setting)
        before = (first.lemma(a), second.lemma(b))
        match verdicts:
            case "proved", "proved":
                lines = [f"split; intros _; [exact {b} | exact {a}]."]
            case "refuted", "refuted":
                lines = [f"split; intro F; [elim ({a} F) | elim ({b} F)]."]
            case "proved", "refuted":
                lines = [f"intros [F _]. exact ({b} (F {a}))."]
            case _:
                lines = [f"intros [_ F]. exact ({a} (F {b}))."]
        text = f"~ ({whole})" if verdict == "refuted" else whole
        return Proved(text, tuple(lines), before)


PLACES = ("re", "im", "jm", "km")
MAX_POWER = 200


def is_presentation(text: str) -> bool:
    """Return whether a statement is about all associative algebras."""
    return re.match(r"\s*associative\s*\(", text) is not None


class PresentationStatement:
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
        """Return equations as data."""
        pairs = (f"({self._data(e.left)}, {self._data(e.right)})" for e in equations)
        return "[" + ";\n   ".join(pairs) + "]"

    def word(self, letters: str) -> str:
        """Return a word as data."""
        if not set(letters) <= set(self.letters):
            raise MismatchError(f"{letters!r} is not a word in {', '.join(self.letters)}")
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


def presentation(text: str, setting: Setting, verdict: str, evidence: EvidenceData) -> Proved:
    """Prove the verdict on a presentation.

    Over a field of characteristic p an algebra is a ring in which p = 0. Over ℤ and ℚ the theorem is about
    all rings. Raises :class:`NotCoveredError` for proofs that use division.
    """
    p = 0 if setting.field is None else base_ring_of(setting.field).characteristic
    said = PresentationStatement(text, p)
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


def _consequence(said: PresentationStatement, evidence: EvidenceData) -> Proved:
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
    relations: Sequence[Node], goals: Sequence[Compare], evidence: EvidenceData
) -> Proved:
    """Write a refuting table as a theorem: it is associative, bilinear, and satisfies all relations, but not
    the goal.
    """
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
    """Write a coordinate of the product p·q as a sum over the table's entries."""
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
    """Write a term in e, i, j, k in the algebra of the table."""
    match node:
        case Name(name):
            return name
        case Negate(x):
            return f"([-] {_product(x)})"
        case Binary("*", x, y):
            return f"(product {_product(x)} {_product(y)})"
    raise NotCoveredError("the counterexample is written for products of letters only")
