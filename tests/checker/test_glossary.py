"""One list of words: what checker, prover and ledger write is in it, and the documents show it."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from hfield.checker import glossary
from hfield.checker.check import check
from hfield.checker.glossary import METHODS, THEOREMS, UNCERTIFIED, VERDICTS
from hfield.evidence import Evidence, Kind
from hfield.ledger.certificate import certificate
from hfield.ledger.propositions import Assertion
from hfield.prover.decision import Decision

ROOT = Path(__file__).parents[2]


def written(call: ast.Call, place: int, keyword: str) -> Iterator[str]:
    """The texts that a call gives as an argument, in words or by the names of the glossary."""
    given = [x.value for x in call.keywords if x.arg == keyword]
    for argument in [*call.args[place : place + 1], *given]:
        for node in [argument, *ast.iter_child_nodes(argument)]:
            if (
                isinstance(node, ast.Constant)
                and isinstance(node.value, str)
                and node.value != "; "
            ):
                yield node.value
            elif isinstance(node, ast.Name) and isinstance(vars(glossary).get(node.id), str):
                yield vars(glossary)[node.id]


def nodes(*folders: str) -> Iterator[ast.AST]:
    for folder in folders:
        for path in (ROOT / folder).rglob("*.py"):
            if path.stem == "glossary":
                continue
            yield from ast.walk(ast.parse(path.read_text(encoding="utf-8")))


def calls(name: str, *folders: str) -> Iterator[ast.Call]:
    for node in nodes(*folders):
        if isinstance(node, ast.Call):
            called = node.func
            if name in (getattr(called, "id", ""), getattr(called, "attr", "")):
                yield node


@pytest.mark.slow
def test_every_decision_speaks_in_these_words() -> None:
    found = [
        (set(written(c, 0, "verdict")), set(written(c, 1, "method")))
        for c in calls("Decision", "hfield", "rotation", "anim")
    ]
    assert len(found) > 40
    for verdicts, methods in found:
        assert verdicts <= set(VERDICTS)
        assert methods <= {*METHODS, *UNCERTIFIED}


@pytest.mark.slow
def test_every_method_of_a_certificate_is_one_that_the_checker_finds() -> None:
    folder = "hfield/checker"
    given = {m for c in calls("CheckResult", folder) for m in written(c, 1, "method")}
    given |= {m for c in calls("by", folder) for m in written(c, 0, "method")}
    assert given <= METHODS.keys()
    used = {node.id for node in nodes(folder) if isinstance(node, ast.Name)}
    constants = {name: text for name, text in vars(glossary).items() if isinstance(text, str)}
    assert {constants[name] for name in used & constants.keys()} >= METHODS.keys()


@pytest.mark.parametrize("words", [METHODS, UNCERTIFIED, THEOREMS])
def test_each_word_is_one_text_with_one_name(words: dict[str, str]) -> None:
    names = [
        name for name, text in vars(glossary).items() if isinstance(text, str) and text in words
    ]
    assert len(names) == len(words)
    assert all(text.strip() for text in (*words, *words.values()))


def test_the_documents_list_the_methods() -> None:
    text = (ROOT / "docs" / "reference" / "certificates.md").read_text(encoding="utf-8")
    table = text[text.index("## Methods") : text.index("## Polynomials")]
    rows = re.findall(r"^\| `(.+?)` \| (.+) \|$", table, re.MULTILINE)
    assert dict(rows) == METHODS


def test_a_row_that_cites_other_than_its_evidence_has_no_certificate() -> None:
    claim = Assertion("p*q == q*p")
    evidence = Evidence(Kind.IDENTITY)
    good = Decision("proved", "identity", evidence=evidence)
    data = certificate(claim, good, "GF(2)")
    assert data is not None
    assert check(data).assumes == ()
    cites = Decision("proved", "identity", evidence=evidence, assumes=(glossary.KULIKOV,))
    other = Decision("proved", "implication", evidence=evidence)
    assert certificate(claim, cites, "GF(2)") is None
    assert certificate(claim, other, "GF(2)") is None
