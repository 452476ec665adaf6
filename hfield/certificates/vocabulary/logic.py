"""Statements about the field and the algebra as wholes, and logic between closed statements.

The vocabulary, with P, Q for statements of any kind:

``every{P; Q; …}`` · ``implies{P; Q}`` · ``iff{P; Q}`` · ``not-everywhere{P}`` · ``over{F; P}`` ·
``angles{P}`` · ``angles{P; Q}`` · ``citing{T; P}`` · ``division`` · ``formally-real`` ·
``level-above{2}`` · ``norm-criterion{>}`` · ``modulus-exists`` · ``modulus-law{*}`` · ``centre{2}`` ·
``basis{4; 1,0,0,0; …}`` · ``determined-by{all; 1,2,3}`` · ``curried-linear{1}`` ·
``last-argument{4; 1,2,3}`` · and those of :mod:`hfield.certificates.orders.words` about lattices.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from hfield.certificates.evidence.unsatisfiable import need_hypotheses
from hfield.certificates.finding import Finding, together
from hfield.certificates.glossary import CIRCLE, CITED_BY_NAME, FIELD, FIELDS, INDUCTION, WITNESS
from hfield.certificates.kinds import establish
from hfield.certificates.language import Tree, parse, walk
from hfield.certificates.orders.words import PARTS as LATTICES
from hfield.certificates.orders.words import establish_lattices, meaning_of_lattices
from hfield.certificates.rejection import (
    a_list,
    a_text,
    an_integer,
    an_object,
    kind_of,
    reject,
    shown,
)
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.statement import HAMILTON, QUATERNIONS, SCALARS, Setting, read_statement
from hfield.certificates.vocabulary import linear_algebra, of_fields
from hfield.certificates.vocabulary.lemmas import LEMMAS
from hfield.certificates.vocabulary.presentation import establish_presentation, read_presentation

# How many parts each word has: from, to.
LOGIC = {
    "every": (1, 64), "implies": (2, 2), "iff": (2, 2), "not-everywhere": (1, 1),
    "over": (2, 2), "angles": (1, 2), "citing": (2, 2),
}  # fmt: skip
NAMED = ("over", "citing")  # words whose first part is a name and no statement
MAX_DEPTH = 6
MAX_PARTS = 64


@dataclass(frozen=True)
class Proposition:
    """A word of the vocabulary with the texts between its braces."""

    word: str
    parts: tuple[str, ...]


Check = Callable[[tuple[str, ...], Setting, str, Any], Finding]
SPECIAL: dict[str, Check] = {**of_fields.CHECKS, **linear_algebra.CHECKS}


def read_proposition(text: str, depth: int = 0) -> Proposition | None:
    """Read a statement of the vocabulary; None for any other."""
    m = re.fullmatch(r"\s*([a-z]+(?:-[a-z]+)*)\s*(?:\{(.*)\}\s*)?", text, re.DOTALL)
    if m is None or not any(m[1] in words for words in (LOGIC, SPECIAL, LATTICES)):
        return None
    if depth > MAX_DEPTH:
        reject("the statement nests too deeply")
    parts = () if m[2] is None else tuple(_split(m[2]))
    if m[1] in LOGIC and not LOGIC[m[1]][0] <= len(parts) <= LOGIC[m[1]][1]:
        reject(f"{m[1]} has {len(parts)} parts")
    if len(parts) > MAX_PARTS or not all(part.strip() for part in parts):
        reject(f"{m[1]} has an empty part, or too many")
    return Proposition(m[1], tuple(part.strip() for part in parts))


def _split(text: str) -> list[str]:
    parts, depth = [""], 0
    for char in text:
        depth += (char == "{") - (char == "}")
        if depth < 0:
            reject("the braces of the statement do not match")
        if char == ";" and not depth:
            parts.append("")
        else:
            parts[-1] += char
    if depth:
        reject("the braces of the statement do not match")
    return parts


def proposition_tree(p: Proposition, depth: int = 0) -> Tree:
    """Return what a statement of the vocabulary says, without blanks and superfluous parentheses."""
    if p.word in LATTICES:
        return meaning_of_lattices(p.word, p.parts)
    if p.word in SPECIAL:
        return (p.word, tuple(re.sub(r"\s*([,;])\s*", r"\1", part.strip()) for part in p.parts))
    out: list[Any] = []
    for part in p.parts:
        if p.word in NAMED and not out:  # the name in front
            out.append(read_field(part.strip()).name if p.word == "over" else part.strip())
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
) -> Finding:
    """Check the evidence for a verdict on a statement of any kind."""
    if verdict != "refuted" and setting.field is not None and not setting.field.is_exact:
        reject("nothing is proved over floats")
    p = read_proposition(text, depth)
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
    if p.word in LATTICES:
        return establish_lattices(p.word, p.parts, setting, verdict, evidence)
    if setting.constants != HAMILTON:
        reject("statements about wholes are about H(F)")
    if p.word in SPECIAL:
        if setting.field is None and kind_of(evidence) == "over":
            return _over(text, setting, verdict, evidence, depth)
        return SPECIAL[p.word](p.parts, setting, verdict, evidence)
    return _Logic(p, text, setting, depth).establish(verdict, evidence)


def _over(text: str, setting: Setting, verdict: str, evidence: object, depth: int) -> Finding:
    """Refute for all fields by one field."""
    data = an_object(evidence, "kind field evidence", "the evidence")
    ring = read_field(a_text(data["field"], "the field of the evidence"))
    if verdict != "refuted" or not ring.is_field:
        reject("one field refutes what is said of all, and proves nothing")
    here = replace(setting, field=ring, moved=True)
    return establish_any(text, here, "refuted", data["evidence"], depth + 1).within(FIELD)


def _with_the_same_names(text: str, setting: Setting) -> Setting:
    """Reject what says nothing of all fields, and a field in which an unknown of it would be an element."""
    assert setting.field is not None
    read_statement(text, replace(setting, field=None))
    for node in walk(parse(text)):
        unknown = node[0] == "name" and node[1] in (*QUATERNIONS, *SCALARS)
        if unknown and setting.field.constant(node) is not None:
            reject(f"{node[1]!r} means an element of {setting.field.name} there")
    return replace(setting, moved=False)


class _Logic:
    """One proposition made of others."""

    def __init__(self, p: Proposition, text: str, setting: Setting, depth: int) -> None:
        self.p, self.text, self.setting, self.depth = p, text, setting, depth

    def part(self, n: int, verdict: str, evidence: object) -> Finding:
        """Check a part."""
        return establish_any(self.p.parts[n], self.setting, verdict, evidence, self.depth + 1)

    def establish(self, verdict: str, evidence: object) -> Finding:
        """Check the evidence."""
        kind, word = kind_of(evidence), self.p.word
        if word == "over":
            ring = read_field(self.p.parts[0].strip())
            here = replace(self.setting, field=ring, moved=False)
            inside = establish_any(self.p.parts[1], here, verdict, evidence, self.depth + 1)
            return inside.within(FIELD)
        everywhere = self.setting.field is None
        if everywhere and kind == "over" and word not in ("not-everywhere", "every"):
            return _over(self.text, self.setting, verdict, evidence, self.depth)
        if word == "citing":
            theorem = CITED_BY_NAME.get(self.p.parts[0].strip())
            if theorem is None:
                reject(f"there is no theorem {shown(self.p.parts[0].strip())!r} to cite")
            inside = self.part(1, verdict, evidence)
            if theorem == INDUCTION:  # what fails for some number of arguments fails without it
                return inside.citing(theorem) if verdict == "proved" else inside
            if not self._is_real():
                reject("theorems about real polynomials are cited over RR alone")
            return inside.citing(theorem)
        if word == "angles":  # points of the circle c² + s² = 1; they are angles over RR
            if not self._is_real():
                return self.part(0, verdict, evidence)
            if len(self.p.parts) == 1:
                return self.part(0, verdict, evidence).citing(CIRCLE)
            return self._every(verdict, kind, evidence).citing(CIRCLE)
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

    def _every(self, verdict: str, kind: str, evidence: object) -> Finding:
        if verdict == "refuted" and kind == "part":
            data = an_object(evidence, "kind part evidence", "the evidence")
            n = an_integer(data["part"], "the number of a part", 0)
            if n >= len(self.p.parts):
                reject("there is no part of that number")
            return self.part(n, "refuted", data["evidence"]).within(FIELD)
        if verdict not in ("proved", "vacuous") or kind != "parts":
            reject(f"evidence of the kind {shown(kind)!r} does not show this {verdict}")
        data = an_object(evidence, "kind parts", "the evidence")
        parts = a_list(data["parts"], "parts")
        if len(parts) != len(self.p.parts):
            reject("there is not evidence for every part")
        found: list[Finding] = []
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

    def _not_everywhere(self, verdict: str, evidence: object) -> Finding:
        data = an_object(evidence, "kind field evidence", "the evidence")
        if verdict != "proved" or data["kind"] != "over":
            reject("that something fails somewhere is shown by a field where it fails")
        field = self.setting.field
        if field is not None and read_field(a_text(data["field"], "field")).name != field.name:
            reject("the field of the evidence is not that of the certificate")
        anywhere = replace(self.setting, field=None)
        return _over(self.p.parts[0], anywhere, "refuted", data, self.depth).by(WITNESS)

    def _implies(self, verdict: str, kind: str, evidence: object) -> Finding:
        if verdict == "proved" and kind == "conclusion":
            data = an_object(evidence, "kind evidence", "the evidence")
            return self.part(1, "proved", data["evidence"])
        if verdict == "vacuous" and kind == "hypothesis":
            data = an_object(evidence, "kind evidence", "the evidence")
            return self.part(0, "refuted", data["evidence"])
        if verdict == "refuted" and kind == "both":
            data = an_object(evidence, "kind left right", "the evidence")
            left = self.part(0, *_judged(data["left"], ("proved",)))
            right = self.part(1, *_judged(data["right"], ("refuted",)))
            return together((left, right)).within(FIELD).by(right.method)
        reject(f"evidence of the kind {shown(kind)!r} does not show this {verdict}")

    def _iff(self, verdict: str, kind: str, evidence: object) -> Finding:
        data = an_object(evidence, "kind left right", "the evidence")
        left, right = (_judged(data[x], ("proved", "refuted")) for x in ("left", "right"))
        if kind != "both" or verdict != ("proved" if left[0] == right[0] else "refuted"):
            reject(f"the two sides do not show this {verdict}")
        return together((self.part(0, *left), self.part(1, *right))).within(FIELD)

    def _everywhere(self, kind: str, evidence: object) -> Finding:
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


def meaning(statement: str) -> Tree:
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
