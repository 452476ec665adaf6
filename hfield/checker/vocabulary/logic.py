"""Statements about the field and the algebra as a whole, and logic between closed statements.

The vocabulary, with P, Q for statements of any kind:

``every{P; Q; …}`` · ``implies{P; Q}`` · ``iff{P; Q}`` · ``not-everywhere{P}`` · ``over{F; P}`` ·
``angles{P}`` · ``angles{P; Q}`` · ``citing{T; P}`` · ``division`` · ``formally-real`` ·
``level-above{2}`` · ``norm-criterion{>}`` · ``modulus-exists`` · ``modulus-law{*}`` · ``centre{2}`` ·
``basis{4; 1,0,0,0; …}`` · ``determined-by{all; 1,2,3}`` · ``curried-linear{1}`` ·
``last-argument{4; 1,2,3}`` · ``class-group{2,4}`` · ``unit-group{2; 1+s}`` ·
and those about orders, of :mod:`hfield.checker.orders.words`.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from hfield.checker.check_result import CheckResult, together
from hfield.checker.evidence import establish
from hfield.checker.evidence.unsatisfiable import need_hypotheses
from hfield.checker.glossary import (
    CIRCLE,
    CITED_BY_NAME,
    COMMUTATIVE_RINGS,
    FIELD,
    FIELDS,
    INDUCTION,
    WITNESS,
)
from hfield.checker.language import BLANKS, Meaning, parse, split, walk
from hfield.checker.number_fields import class_groups
from hfield.checker.orders import words as orders
from hfield.checker.orders.words import PARTS as ORDERS
from hfield.checker.rejection import a_list, an_integer, an_object, kind_of, reject, shown
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.scalars.surds import Reals
from hfield.checker.statement import HAMILTON, UNKNOWNS, Setting, read_statement
from hfield.checker.vocabulary import field_properties, linear_algebra
from hfield.checker.vocabulary.lemmas import LEMMAS
from hfield.checker.vocabulary.presentation import establish_presentation, read_presentation

# How many parts each word has: from, to.
LOGIC = {
    "every": (1, 64), "implies": (2, 2), "iff": (2, 2), "not-everywhere": (1, 1),
    "over": (2, 2), "angles": (1, 2), "citing": (2, 2),
}  # fmt: skip
NAMED = ("over", "citing")  # words whose first part is a name and no statement
MAX_DEPTH = 6
MAX_PARTS = 64


@dataclass(frozen=True)
class VocabularyStatement:
    """A word of the vocabulary with the texts between its braces."""

    word: str
    parts: tuple[str, ...]


Check = Callable[[tuple[str, ...], Setting, str, object], CheckResult]
VOCABULARIES = (field_properties, linear_algebra, class_groups, orders)
"""Of orders in any algebra; the others are about H(F)."""
SPECIAL: dict[str, Check] = {
    word: check for vocabulary in VOCABULARIES for word, check in vocabulary.CHECKS.items()
}
FORMS = {word: form for vocabulary in VOCABULARIES for word, form in vocabulary.FORMS.items()}


def read_proposition(text: str, depth: int = 0) -> VocabularyStatement | None:
    """Read a statement of the vocabulary; None for other statements."""
    m = re.fullmatch(r"\s*([a-z]+(?:-[a-z]+)*)\s*(?:\{(.*)\}\s*)?", text, re.DOTALL | re.ASCII)
    if m is None or not any(m[1] in words for words in (LOGIC, SPECIAL, ORDERS)):
        return None
    if depth > MAX_DEPTH:
        reject("the statement nests too deeply")
    parts = () if m[2] is None else tuple(split(m[2], ";"))
    if m[1] in LOGIC and not LOGIC[m[1]][0] <= len(parts) <= LOGIC[m[1]][1]:
        reject(f"{m[1]} has {len(parts)} parts")
    parts = tuple(part.strip(BLANKS) for part in parts)
    if len(parts) > MAX_PARTS or not all(parts):
        reject(f"{m[1]} has an empty part, or too many")
    if m[1] in SPECIAL:
        parts = tuple(re.sub(r"\s*,\s*", ",", part, flags=re.ASCII) for part in parts)
        if not re.fullmatch(FORMS[m[1]], ";".join(parts)):
            reject(f"{shown(text)!r} is not how {m[1]} is written")
    return VocabularyStatement(m[1], parts)


def statements_inside(p: VocabularyStatement, setting: Setting) -> list[tuple[str, Setting]]:
    """Return the parts that are statements, each with the rings that it is about."""
    settings = [setting] * len(p.parts)
    if p.word == "over":
        settings[1] = replace(setting, field=_named(p.parts[0], setting), moved=False)
    elif p.word == "not-everywhere":
        settings[0] = replace(setting, field=None)
    elif p.word == "angles" and len(settings) > 1:
        settings[1] = replace(setting, field=Reals(), moved=False)
    elif p.word == "citing" and p.parts[0] not in CITED_BY_NAME:
        reject(f"there is no theorem {shown(p.parts[0])!r} to cite")
    found = list(zip(p.parts, settings, strict=True))
    return found[1:] if p.word in NAMED else found


def need_meaning(p: VocabularyStatement, setting: Setting, depth: int = 0) -> None:
    """Reject a statement with a meaningless part, even if the evidence does not use that part."""
    for text, there in statements_inside(p, setting):
        inner = read_proposition(text, depth + 1)
        if inner is None:
            if read_presentation(text) is None:
                read_statement(text, there)
        elif inner.word in LOGIC:
            need_meaning(inner, there, depth + 1)
        elif inner.word in ORDERS:
            orders.need_order_meaning(inner.word, inner.parts, there)


def proposition_tree(p: VocabularyStatement, depth: int = 0) -> Meaning:
    """Return the meaning of a statement of the vocabulary, without blanks and superfluous parentheses."""
    if p.word in ORDERS:
        return orders.order_meaning(p.word, p.parts)
    if p.word in SPECIAL:
        return (p.word, p.parts)
    out: list[str | Meaning] = []
    for part in p.parts:
        if p.word in NAMED and not out:  # the name in front
            out.append(part)
            continue
        inner = read_proposition(part, depth + 1)
        presentation = None if inner else read_presentation(part)
        if inner is not None:
            out.append(proposition_tree(inner, depth + 1))
        else:
            out.append(presentation.tree if presentation else parse(part))
    return (p.word, tuple(out))


def establish_any(
    text: str, setting: Setting, verdict: str, evidence: object, depth: int = 0
) -> CheckResult:
    """Check the evidence for a verdict on a statement of any kind."""
    if verdict != "refuted" and setting.field is not None and not setting.field.is_exact:
        reject("nothing is proved over floats")
    p = read_proposition(text, depth)
    if setting.table is not None and (p is not None or read_presentation(text) is not None):
        reject("of an algebra by its table there are statements of the language only")
    if p is None:
        presentation = read_presentation(text)
        if presentation is not None:
            return establish_presentation(presentation, setting.field, verdict, evidence)
        if setting.moved:
            setting = _with_the_same_names(text, setting)
        statement = read_statement(text, setting)
        found = establish(statement, setting, verdict, evidence)
        if verdict == "proved":
            need_hypotheses(statement, setting)
        return found
    if p.word in LOGIC and not depth:
        if rings_named(p):
            setting, evidence = _with_rings(p, setting, evidence)
        need_meaning(p, setting)
    if p.word in ORDERS:
        return orders.establish_order(p.word, p.parts, setting, verdict, evidence)
    if setting.constants != HAMILTON and p.word not in orders.CHECKS:
        reject("statements about wholes are about H(F)")
    if p.word in SPECIAL:
        if setting.field is None and kind_of(evidence) == "over":
            return _over(text, setting, verdict, evidence, depth)
        return SPECIAL[p.word](p.parts, setting, verdict, evidence)
    return replace(
        _Logic(p, text, setting, depth).establish(verdict, evidence), rings=setting.named
    )


def names_of_rings(statement: str) -> list[str]:
    """Return the names of rings in the words of a statement, in order."""
    p = read_proposition(statement)
    return sorted(rings_named(p)) if p else []


def rings_named(p: VocabularyStatement, depth: int = 0) -> set[str]:
    """Return the names of rings in a statement of the vocabulary."""
    found = {p.parts[0]} if p.word == "over" else set()
    if p.word in LOGIC:
        for part in p.parts[p.word in NAMED :]:
            inner = read_proposition(part, depth + 1)
            found |= rings_named(inner, depth + 1) if inner else set()
    return found


def _with_rings(
    p: VocabularyStatement, setting: Setting, evidence: object
) -> tuple[Setting, object]:
    """Read exactly the rings that the statement names, and the remaining evidence."""
    data = an_object(evidence, "kind rings evidence", "the evidence")
    rings = [read_ring(x) for x in a_list(data["rings"], "rings")]
    if data["kind"] != "rings" or sorted(x.name for x in rings) != sorted(rings_named(p)):
        reject("the evidence does not say which rings the statement names")
    return replace(setting, named=tuple(rings)), data["evidence"]


def _named(name: str, setting: Setting) -> AnyRing:
    found = next((x for x in setting.named if x.name == name), None)
    if found is None:
        reject(f"the evidence does not say which ring {shown(name)!r} is")
    return found


def _over(text: str, setting: Setting, verdict: str, evidence: object, depth: int) -> CheckResult:
    """Refute a statement about all fields by one field."""
    data = an_object(evidence, "kind ring evidence", "the evidence")
    ring = read_ring(data["ring"])
    if verdict != "refuted" or not ring.is_field:
        reject("one field refutes what is said of all, and proves nothing")
    here = replace(setting, field=ring, moved=True)
    return establish_any(text, here, "refuted", data["evidence"], depth + 1).within(FIELD)


def _with_the_same_names(text: str, setting: Setting) -> Setting:
    """Reject a statement without a meaning over all fields, or with an unknown named like an element of the
    field.
    """
    assert setting.field is not None
    read_statement(text, replace(setting, field=None))
    for node in walk(parse(text)):
        unknown = node[0] == "name" and node[1] in UNKNOWNS
        if unknown and setting.field.constant(node) is not None:
            reject(f"{node[1]!r} means an element of {setting.field.name} there")
    return replace(setting, moved=False)


class _Logic:
    """A proposition composed of others."""

    def __init__(self, p: VocabularyStatement, text: str, setting: Setting, depth: int) -> None:
        self.p, self.text, self.setting, self.depth = p, text, setting, depth
        self.inside = statements_inside(p, setting)

    def part(self, n: int, verdict: str, evidence: object) -> CheckResult:
        """Check the evidence for the n-th part of a compound statement; the part is a statement."""
        text, setting = self.inside[n]
        found = establish_any(text, setting, verdict, evidence, self.depth + 1)
        if self.p.word == "angles" and n:  # a part about RR only does not restrict the scope
            return replace(found, scope=COMMUTATIVE_RINGS)
        return found

    def establish(self, verdict: str, evidence: object) -> CheckResult:
        """Check the evidence."""
        kind, word = kind_of(evidence), self.p.word
        if word == "over":
            return self.part(0, verdict, evidence).within(FIELD)
        everywhere = self.setting.field is None
        if everywhere and kind == "over" and word not in ("not-everywhere", "every"):
            return _over(self.text, self.setting, verdict, evidence, self.depth)
        if word == "citing":
            theorem = CITED_BY_NAME[self.p.parts[0]]
            inside = self.part(0, verdict, evidence)
            if theorem == INDUCTION:  # a counterexample needs no induction
                return inside.citing(theorem) if verdict == "proved" else inside
            if not self._is_real():
                reject("theorems about real polynomials are cited over RR alone")
            return inside.citing(theorem)
        if word == "angles":
            return self._angles(verdict, kind, evidence)
        if word == "every":
            return self._every(verdict, kind, evidence)
        if word == "not-everywhere":
            return self._not_everywhere(verdict, evidence)
        if everywhere:
            if verdict != "proved":
                reject(f"evidence of the kind {shown(kind)!r} refutes nothing here")
            return self._everywhere(kind, evidence)
        return (self._implies if word == "implies" else self._iff)(verdict, kind, evidence)

    def _is_real(self) -> bool:
        return self.setting.field is not None and self.setting.field.name == "RR"

    def _angles(self, verdict: str, kind: str, evidence: object) -> CheckResult:
        """Check P for points with c² + s² = 1; over RR, where these are angles, check Q as well."""
        field, second = self.setting.field, self.p.parts[1:]
        with_real = second and (field is None or self._is_real())
        found = (
            self._every(verdict, kind, evidence) if with_real else self.part(0, verdict, evidence)
        )
        if self._is_real():
            return found.citing(CIRCLE)
        if verdict == "refuted":
            return found
        where = "everywhere but over RR" if field is None else "which is said of RR alone"
        found = found.without(*(f"{q} ({where})" for q in second))
        return found.citing(CIRCLE) if field is None else found

    def _every(self, verdict: str, kind: str, evidence: object) -> CheckResult:
        if verdict == "refuted" and kind == "part":
            data = an_object(evidence, "kind part evidence", "the evidence")
            n = an_integer(data["part"], "the number of a part", 0)
            if n >= len(self.inside):
                reject("there is no part of that number")
            return self.part(n, "refuted", data["evidence"]).within(FIELD)
        if verdict not in ("proved", "vacuous") or kind != "parts":
            reject(f"evidence of the kind {shown(kind)!r} does not show this {verdict}")
        data = an_object(evidence, "kind parts", "the evidence")
        parts = a_list(data["parts"], "parts")
        if len(parts) != len(self.inside):
            reject("there is not evidence for every part")
        found: list[CheckResult] = []
        verdicts: set[str] = set()
        allowed = ("proved", "vacuous") if verdict == "proved" else ("vacuous",)
        for n, raw in enumerate(parts):
            judged, own = _judged(raw, allowed)
            part = self.part(n, judged, own)
            verdicts.add(judged)
            if judged == "vacuous":
                part = replace(part, vacuous=(*part.vacuous, self.p.parts[n]))
            found.append(part)
        if verdict == "proved" and verdicts == {"vacuous"}:
            reject("all parts are vacuous, so the whole is vacuous and not proved")
        return together(found)

    def _not_everywhere(self, verdict: str, evidence: object) -> CheckResult:
        data = an_object(evidence, "kind ring evidence", "the evidence")
        if verdict != "proved" or data["kind"] != "over":
            reject("that something fails somewhere is shown by a field where it fails")
        (part, anywhere), field = self.inside[0], self.setting.field
        if field is not None and read_ring(data["ring"]).name != field.name:
            reject("the field of the evidence is not that of the certificate")
        return _over(part, anywhere, "refuted", data, self.depth).by(WITNESS)

    def _implies(self, verdict: str, kind: str, evidence: object) -> CheckResult:
        if verdict == "proved" and kind == "conclusion":
            data = an_object(evidence, "kind evidence", "the evidence")
            found = self.part(1, "proved", data["evidence"])
            return found.without(f"{self.p.parts[0]} (whether it holds)")
        if verdict == "vacuous" and kind == "hypothesis":
            data = an_object(evidence, "kind evidence", "the evidence")
            return self.part(0, "refuted", data["evidence"])
        if verdict == "refuted" and kind == "both":
            data = an_object(evidence, "kind left right", "the evidence")
            left = self.part(0, *_judged(data["left"], ("proved",)))
            right = self.part(1, *_judged(data["right"], ("refuted",)))
            return together((left, right)).within(FIELD).by(right.method)
        reject(f"evidence of the kind {shown(kind)!r} does not show this {verdict}")

    def _iff(self, verdict: str, kind: str, evidence: object) -> CheckResult:
        data = an_object(evidence, "kind left right", "the evidence")
        left, right = (_judged(data[x], ("proved", "refuted")) for x in ("left", "right"))
        if kind != "both" or verdict != ("proved" if left[0] == right[0] else "refuted"):
            reject(f"the two sides do not show this {verdict}")
        return together((self.part(0, *left), self.part(1, *right))).within(FIELD)

    def _everywhere(self, kind: str, evidence: object) -> CheckResult:
        """Prove a relation between closed statements over all fields at once, by known lemmas."""
        data = an_object(evidence, "kind proofs", "the evidence")
        said = proposition_tree(self.p)
        lemmas = next((own for text, own in LEMMAS.items() if meaning(text) == said), None)
        proofs = a_list(data["proofs"], "proofs")
        if kind != "lemmas" or lemmas is None or len(proofs) != len(lemmas):
            reject("these are not the proofs that show this over all fields")
        found = together(
            establish(read_statement(lemma, self.setting), self.setting, "proved", proof)
            for lemma, proof in zip(lemmas, proofs, strict=True)
        )
        if found.cites or found.scope == FIELD:
            reject("a proof over all fields cites what it cannot")
        return found.within(FIELDS)


def meaning(statement: str) -> Meaning:
    """Return a statement of any kind as a tree, without blanks and superfluous parentheses."""
    p = read_proposition(statement)
    if p is not None:
        return proposition_tree(p)
    presentation = read_presentation(statement)
    return parse(statement) if presentation is None else presentation.tree


def _judged(raw: object, allowed: tuple[str, ...]) -> tuple[str, object]:
    """Return the verdict and the evidence for a part."""
    data = an_object(raw, "verdict evidence", "the evidence for a part")
    if data["verdict"] not in allowed:
        reject(f"a part must be {' or '.join(allowed)}")
    return data["verdict"], data["evidence"]
