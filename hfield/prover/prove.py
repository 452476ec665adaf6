"""``prove``: decide a statement and return an answer with a certificate."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from hfield.errors import NotationError, shorten
from hfield.evidence import is_complete, why_rejected
from hfield.fields.names import RingName
from hfield.prover.decide import TIMEOUT, answer, read_question
from hfield.prover.decision import (
    FIELD,
    NOT_APPLICABLE,
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    Decision,
)
from hfield.prover.statements.language import Statement
from hfield.prover.statements.printing import to_latex, to_unicode
from hfield.prover.statements.setting import Setting, read_setting
from hfield.prover.statements.tables import BLOCKS
from hfield.prover.statements.trees import conjunction
from hfield.prover.steps import say
from hfield.syntax import Logic, parse, plain

if TYPE_CHECKING:
    from hfield.algebra import QuaternionAlgebra
    from hfield.algebra.structure_algebra import StructureAlgebra

MAX_STEPS = 12  # shown to people; the decision has them all
EXIT_STATUS = {PROVED: 0, VACUOUS: 0, REFUTED: 1, UNDECIDED: 3, NOT_APPLICABLE: 3}
_COMPARISON = re.compile(r"[=!<>]=|=>|[=≠⇒⇔<>≤≥]")
_SIGNS = {PROVED: "✓", VACUOUS: "✓", REFUTED: "✗", UNDECIDED: "?", NOT_APPLICABLE: "–"}


@dataclass(frozen=True)
class Answer:
    """A statement with its decision. Its truth value raises UndecidedError if it is undecided.

    Answers are equal if statement, algebra, field and decision are equal, also after pickling.
    """

    statement: Statement
    setting: Setting
    decision: Decision

    @property
    def verdict(self) -> str:
        """``proved``, ``refuted``, ``vacuous``, ``undecided`` or ``not-applicable``."""
        return self.decision.verdict

    @property
    def witness(self) -> Mapping[str, list[str]] | None:
        """The values found, as a map from unknowns to coordinates, as texts that the field can read."""
        return self.decision.witness

    @property
    def exit_status(self) -> int:
        """The exit status of the command: 0 for proved or vacuous, 1 for refuted, 3 for undecided."""
        return EXIT_STATUS[self.verdict]

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/2`` as JSON data, accepted by the checker, or None.

        There is none for undecided statements. There is also none if the checker does not know the constants
        or checking would take too long; :attr:`why_no_certificate` gives the reason.
        """
        data = self._evidence
        if data is None or self.why_no_certificate is not None:
            return None
        return data

    @cached_property
    def why_no_certificate(self) -> str | None:
        """The reason, on one line, why there is no certificate; None if there is one."""
        if self._evidence is None:
            decided = self.verdict in (PROVED, REFUTED, VACUOUS)
            if decided and self.setting.field is not None and self.setting.field.data is None:
                return f"the checker does not know the ring {self.field}"
            return (
                "no evidence is made for this way to prove it"
                if decided
                else f"this is {self.verdict}"
            )
        return why_rejected(self._evidence)

    @property
    def _evidence(self) -> dict[str, object] | None:
        """The decision as a certificate, before the checker has seen it."""
        d = self.decision
        if not is_complete(d.evidence):
            return None
        return d.certificate(self.text, self.setting.algebra, self.setting.field)

    @property
    def text(self) -> str:
        """The statement as typed, with separate hypotheses in front."""
        return self.statement.text

    @property
    def field(self) -> str | None:
        """The name of the field, or None for all fields."""
        return None if self.setting.field is None else self.setting.field.name

    def to_json(self, certificate: str | None = None) -> dict[str, object]:
        """Return the answer in the format ``hfield-prove/1``; ``certificate`` is the name of a
        written file.
        """
        d = self.decision
        return {
            "schema": "hfield-prove/1",
            "statement": self.text,
            "algebra": self.setting.algebra,
            "field": self.field,
            "verdict": d.verdict,
            "scope": d.scope,
            "method": d.method,
            "witness": None if d.witness is None else {k: list(v) for k, v in d.witness.items()},
            "assumes": list(d.assumes),
            "tried": list(d.tried),
            "certificate": certificate,
        }

    def __hash__(self) -> int:
        return hash((self.text, self.setting.algebra, self.verdict))

    def __bool__(self) -> bool:
        return bool(self.decision)

    @property
    def place(self) -> str:
        """The scope of the decision, in words that follow the verdict."""
        d = self.decision
        where = self.setting.algebra if not self.setting.is_hamilton else ""
        where = f", in {shorten(where)}" if where else ""
        if self.field is not None:
            return f" over {self.field}" + where
        if d.verdict == PROVED:
            return f" over every {(d.scope or '').removesuffix('s')}" + where
        return where

    def __str__(self) -> str:
        d, where = self.decision, self.place
        lines = [f"{_SIGNS[d.verdict]} {to_unicode(self.statement.written)}"]
        if d.witness:
            shown = ", ".join(f"{n} = {_value(v)}" for n, v in d.witness.items() if n != "F")
            over = f" over {d.witness['F'][0]}" if "F" in d.witness else ""
            where += over + (f" by {shown}" if shown else "")
        lines.append(f"  {d.verdict}{where} ({d.method})")
        lines.extend(f"  · {step}" for step in d.steps[:MAX_STEPS])
        if len(d.steps) > MAX_STEPS:
            lines.append(f"  · … and {len(d.steps) - MAX_STEPS} steps more")
        lines.extend(f"  cites {theorem}" for theorem in d.assumes)
        lines.extend(f"  tried: {t}" for t in d.tried)
        return "\n".join(lines)

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        from html import escape

        return f"<pre>{escape(str(self))}</pre>"

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {to_latex(self.statement.written)} \quad\text{{({self.verdict})}}$"


class ConsequenceAnswer(Answer):
    """Whether equations follow from relations; the witness is the products of a counterexample."""

    @property
    def place(self) -> str:
        """The scope of the decision, in words that follow the verdict."""
        over = "" if self.field is None else f" that is an algebra over {self.field}"
        whole = "not in every ring" if self.verdict == REFUTED else "in every ring"
        return f", {whole} with identity{over}"


def _value(texts: list[str]) -> str:
    """Write the coordinates of a witness as a sum: ``1 + 2i − k``."""
    if len(texts) == 1:
        return texts[0]
    out = ""
    for text, unit in zip(texts, ("", "i", "j", "k"), strict=True):
        if text == "0":
            continue
        simple = text.lstrip("-").isalnum()
        sign, body = ("−", text[1:]) if simple and text.startswith("-") else ("+", text)
        if unit:
            body = unit if body == "1" else (body + unit if simple else f"({body}){unit}")
        out += f" {sign} {body}" if out else (f"−{body}" if sign == "−" else body)
    return out or "0"


def prove(
    statement: str,
    field: RingName | None = None,
    given: str | Iterable[str] = (),
    algebra: QuaternionAlgebra | StructureAlgebra | str | None = None,
    timeout: float = TIMEOUT,
    relations: str | Iterable[str] = (),
) -> Answer:
    """Decide a statement about quaternions and return the answer with its evidence.

    ``field`` is a ring, its text, a sympy domain or a galois field; with None the statement is decided for
    all fields at once. ``given`` is one or more hypotheses, added in front of the statement. Both may use the
    signs in which answers are printed (``p·q̄ ≠ 0``). ``algebra`` is an algebra (also a
    :class:`StructureAlgebra`), or a text such as ``(-1,-3|QQ)`` or ``(a,b|F)``; None stands for H.
    ``timeout`` is the time limit in seconds. Raises :class:`NotationError` with the position of unreadable
    text.

    With ``relations``, such as ``"i*i == j*j == -1"``, the statement is about every ring with identity, or
    every algebra with identity over ``field``, with elements i, j and k that satisfy them. The answer has
    cofactors, or an algebra in which it fails (Theorem 1 of the thesis).

    The language is described in docs/reference/language.md.

    >>> prove("p*q == q*p", field="QQ").witness
    {'p': ['0', '1', '0', '0'], 'q': ['0', '0', '1', '0']}
    >>> bool(prove("(p*q)*r == p*(q*r)"))
    True
    >>> bool(prove("i*j == k", relations="i*i == j*j == k*k == i*j*k == -1"))
    True
    """
    if not isinstance(statement, str) or (isinstance(field, str) and _COMPARISON.search(field)):
        raise NotationError(
            f"the statement comes first, as a text: prove('p*q == q*p', field='QQ'), "
            f"not prove({statement!r}, …)"
        )
    hypotheses = (given,) if isinstance(given, str) else tuple(given)
    if relations:
        if algebra is not None or hypotheses:
            raise NotationError(
                "relations are about every ring with identity: leave the algebra out, and write what is "
                "given as relations"
            )
        return _from_relations(plain(statement), relations, field, timeout)
    where = None if algebra is None else str(algebra)
    if field is None and algebra is not None and not isinstance(algebra, str):
        field = algebra.ring  # it may be a user-defined ring that no name refers to
    question = read_question(statement, field, hypotheses, where, timeout)
    problem, decision = question.problem, answer(question)
    read, table = problem.statement, problem.setting.table
    if question.remarks:
        decision = replace(decision, steps=(*decision.steps, *question.remarks))
    if read.assumes_of_basis and table is None:
        hint = say("basis-constants", A=problem.setting.algebra)
        decision = replace(decision, steps=(*decision.steps, hint))
    if table is not None and decision.scope is not None:
        decision = replace(decision, scope=FIELD)  # the coordinates are of this field
    if decision.witness is not None:
        shown = {x: v for x, v in decision.witness.items() if x not in read.helpers}
        decision = replace(decision, witness=shown if table is None else _elements(shown, table))
    return Answer(read, problem.setting, decision)


def _from_relations(
    statement: str, relations: str | Iterable[str], field: RingName | None, timeout: float
) -> Answer:
    """Decide whether equations follow from relations in every ring with identity."""
    from hfield.prover.methods import presentations

    goals, setting = presentations.read_goals(statement), read_setting(field)
    equations = presentations.read_relations(relations)
    decision = presentations.decide_presentation(
        equations, goals, field=setting.field, timeout=timeout
    )
    hypothesis, conclusion = (conjunction([*map(parse, x)]) for x in (equations, goals))
    node = Logic("=>", hypothesis, conclusion)
    said = Statement(
        text=presentations.presentation_text(equations, goals),
        node=node,
        written=node,
        unknowns=(),
        exists=(),
        hypotheses=(hypothesis,),
        conclusion=conclusion,
        constants=(),
        divides=False,
        compares_unequal=False,
    )
    return ConsequenceAnswer(said, setting, decision)


def _elements(witness: dict[str, list[str]], table: StructureAlgebra) -> dict[str, list[str]]:
    """Return a witness with elements of the algebra, as texts, instead of coordinates."""
    found = dict(witness)
    for letter, names in BLOCKS.items():
        if letter in found:
            texts = [c for name in names for c in found.pop(name, ["0"] * 4)]
            coordinates = [table.ring(c) for c in texts[: table.dimension]]
            found[letter] = [str(table(coordinates))]
    return found
