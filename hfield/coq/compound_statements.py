"""Certificates of statements made of others, such as ``every{…}`` (docs/certificates.md)."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from hfield.coq.base_rings import base_ring_of
from hfield.coq.cofactors import MismatchError
from hfield.coq.judgement import Judgement
from hfield.coq.presented import Presentation, is_presentation, presentation
from hfield.coq.sentences import Proved
from hfield.coq.terms import NotCoveredError
from hfield.evidence import Kind
from hfield.fields.names import ring
from hfield.proving.statements.setting import Setting
from hfield.rings import Ring
from hfield.syntax.brackets import split

LOGIC = ("every", "implies", "iff", "not-everywhere", "over", "angles", "citing")
MAX_DEPTH = 6


@dataclass(frozen=True)
class Whole:
    """A word of the vocabulary with the texts between its braces."""

    word: str
    parts: tuple[str, ...]


def read_whole(text: str) -> Whole | None:
    """Read a statement of the vocabulary; None for one of the language."""
    m = re.fullmatch(r"\s*([a-z]+(?:-[a-z]+)*)\s*\{(.*)\}\s*", text, re.DOTALL)
    if m is None:
        word = text.strip()
        words = ("division", "formally-real", "modulus-exists")
        return Whole(word, ()) if word in words else None
    return Whole(m[1], tuple(split(m[2], ";")))


def judge(
    name: str,
    text: str,
    setting: Setting,
    verdict: str,
    evidence: Mapping[str, Any],
    depth: int = 0,
) -> Proved:
    """Prove what a verdict on any statement says. Raises NotCoveredError and MismatchError."""
    if depth > MAX_DEPTH:
        raise MismatchError("the statement nests too deeply")
    whole = read_whole(text)
    if whole is not None:
        return _Logic(name, whole, setting, depth).judge(verdict, evidence)
    if is_presentation(text):
        return presentation(text, setting, verdict, evidence)
    if setting.field is None and evidence.get("kind") == Kind.OVER:
        evidence = _over(evidence)
    return Judgement(name, text, setting).by(verdict, evidence)


def _over(evidence: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return evidence from one field as evidence against all fields, whose field it names."""
    inner = evidence["evidence"]
    if inner.get("ring", evidence["ring"]) != evidence["ring"]:
        raise MismatchError("the fields of the evidence do not agree")
    return {**inner, "ring": evidence["ring"]}


def claimed(text: str, setting: Setting) -> str:
    """Return what a statement says as a proposition, whether it is true or not."""
    whole = read_whole(text)
    if whole is None:
        if is_presentation(text):
            field = setting.field
            return Presentation(
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
    """Return the ring of a canonical name."""
    found = ring(name.strip())
    if found.name != name.strip():
        raise MismatchError(f"{name} is not the name of {found.name}")
    return found


def _core_alone(angles: Whole, setting: Setting) -> bool:
    """Tell whether ``angles{P; Q}`` says P alone: Q is said of RR, which is among all fields."""
    if setting.field is None:
        return len(angles.parts) == 1
    return setting.field.name != "RR"


def _no_word(word: str) -> NotCoveredError:
    return NotCoveredError(f"the word {word!r} of the ledger's vocabulary")


class _Logic:
    """One statement made of others."""

    def __init__(self, name: str, whole: Whole, setting: Setting, depth: int) -> None:
        self.name, self.whole, self.setting, self.depth = name, whole, setting, depth

    def part(self, n: int, verdict: str, evidence: Mapping[str, Any]) -> tuple[Proved, str]:
        """Prove a part as a lemma; return it and its name."""
        name = f"{self.name}_{n + 1}"
        text = self.whole.parts[n]
        if verdict == "vacuous" and read_whole(text) is None:
            return Judgement(name, text, self.setting).true_vacuously(evidence), name
        own = judge(name, text, self.setting, verdict, evidence, self.depth + 1)
        if verdict == "vacuous":  # of implies{P; Q} it says that P is false
            never = f"{name}_never"
            lines = (f"intro P; elim ({never} P).",)
            return Proved(claimed(text, self.setting), lines, (own.lemma(never),)), name
        if own.place:
            raise NotCoveredError("a table against associative algebras inside another statement")
        return own, name

    def judge(self, verdict: str, evidence: Mapping[str, Any]) -> Proved:
        """Prove what the verdict says."""
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

    def _every(self, parts: Sequence[Mapping[str, Any]]) -> Proved:
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

    def _not_every(self, evidence: Mapping[str, Any]) -> Proved:
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

    def _iff(self, verdict: str, evidence: Mapping[str, Any]) -> Proved:
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
