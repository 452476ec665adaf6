"""The steps of proofs are sentences of one table: none lacks a language, and none is made beside it."""

import re
from pathlib import Path
from string import Formatter

import pytest

import hfield
from hfield.ledger.translated import is_formula
from hfield.prover.decide import decide
from hfield.prover.methods.presentations import decide_presentation
from hfield.prover.steps import Step, indented, say, sentences
from tests.prover.statements import DEPENDS, FALSE, FIELD_NAMES, FIELDS, UNIVERSAL
from tests.prover.test_existence import LINEAR, ROOTS
from tests.prover.test_textbook import RINGS
from tests.subcases import subcases

SOURCES = "\n".join(
    path.read_text(encoding="utf-8")
    for package in ("prover", "ledger")
    for path in (Path(hfield.__file__).parent / package).rglob("*.py")
)


def slots(sentence: str) -> set[str]:
    return {slot for _, slot, _, _ in Formatter().parse(sentence) if slot is not None}


@subcases("name", sentences())
def test_a_sentence_is_there_in_every_language_with_the_same_slots(name):
    translations = sentences()[name]
    assert translations.keys() == {"en", "pl"}
    assert all(
        slots(text) == slots(translations["en"]) and text.strip() for text in translations.values()
    )


def test_every_sentence_that_is_said_is_in_the_table():
    assert set(re.findall(r'\bsay\(\s*"([\w-]+)"', SOURCES)) <= sentences().keys()


def test_a_line_keeps_its_sentence_when_it_is_moved():
    line = say("so-root", theorem=say("odd-degree", n=3))
    assert line == "so it has a root: has the odd degree 3"
    assert indented(line) == f"  {line}"
    assert indented(line).strip().said("pl", str) == "więc ma pierwiastek: ma nieparzysty stopień 3"
    assert line.said("pl", lambda text: None) is None
    assert indented("s = 1") == "  s = 1"


ASKED = [
    *((text, None) for text in (*UNIVERSAL, *FIELDS, *FALSE, *DEPENDS)),
    *((text, name) for n, name in enumerate(FIELD_NAMES) for text in (*FALSE, *DEPENDS)[n::4]),
    *((text, name) for text, name, *_ in (*LINEAR, *ROOTS, *RINGS)),
]


@pytest.mark.slow
def test_the_prover_says_nothing_beside_the_table():
    relations = ["i*i == -e", "j*j == -e", "k*k == -e", "i*j*k == -e"]
    made = [decide_presentation(relations, ["i*j == k"], identity) for identity in (True, False)]
    steps = {step for found in made for step in found.steps}
    steps |= {step for text, name in ASKED for step in decide(text, name, timeout=5).steps}
    assert len(steps) > 100
    beside = [step for step in steps if not isinstance(step, Step) and not is_formula(step)]
    assert beside == []
    assert all(step.said("pl", str) for step in steps if isinstance(step, Step))
