"""The thesis's ledger in Polish: no English is left on the page, nor in its figures."""

import re

import pytest

from anim.report import PLAYER
from hfield.checker.glossary import (
    COMPLEX_ROOT,
    COMPLEX_ROOTS,
    LIMITS,
    ODD_DEGREE,
    QUATERNION_ROOT,
    REAL_ROOTS,
    SIGN_CHANGE,
)
from hfield.cli import main
from hfield.core.executors import InProcess
from hfield.fields.names import ring
from hfield.ledger.document import LedgerError, read_ledger
from hfield.ledger.errata import errata
from hfield.ledger.registry import claims
from hfield.ledger.run import decide_rows
from hfield.ledger.selection import rows_to_decide
from hfield.ledger.translated import Translation, is_formula
from hfield.ledger.wording import witness_text
from hfield.prover.decide import decide
from hfield.prover.polynomials.field_rules import norm_rule_of
from hfield.prover.steps import sentences
from hfield.report.markup import formula
from hfield.report.page import Certificates, page
from hfield.report.page_texts import OURS, POLISH, Language, counted
from rotation.figures import FIGURES
from rotation.report import LETTERING

ENGLISH = re.compile(
    r"\b(the|and|with|for|which|that|are|not|over|is|of|by|in|all|has|have|it|if|then|every|each|two|from)\b"
)
PROGRAM = re.compile(r"`[^`]*`|sin|cos|\b[a-z]+[A-Z]\w*")


@pytest.fixture(scope="module")
def whole():
    return decide_rows(rows_to_decide(claims(), []), InProcess())


def said_in_words():
    """All texts of the claims: statements, notes, and what is decided where that is no formula."""
    for claim in claims():
        yield claim.statement
        yield claim.note
        for proposition in (claim.as_printed, claim.corrected):
            if proposition is not None and not formula(proposition.text):
                yield proposition.text


def decided(rows):
    """All that the page tells of decisions."""
    for row in rows:
        decision = row.as_printed
        yield from (step.strip() for step in decision.steps)
        yield from (*decision.assumes, *decision.tried, witness_text(decision.witness, row.field))
    for erratum in errata(rows):
        yield from (erratum.witness, *erratum.failures)


@pytest.mark.slow
def test_every_text_of_claims_and_decisions_has_a_polish_one(whole):
    language = Language("pl", whole)
    assert [claim.id for claim in claims() if language.for_claim(claim) is None] == []
    texts = dict.fromkeys(filter(None, (*said_in_words(), *decided(whole))))
    assert len(texts) > 900
    assert [text for text in texts if language.say(text) is None] == []
    said = {text: PROGRAM.sub("", language.say(text)) for text in texts}
    assert {text: found for text, found in said.items() if ENGLISH.search(found)} == {}


@pytest.mark.slow
def test_no_text_is_marked_as_english(whole):
    html = page(whole, Certificates([]), "pl")
    assert 'lang="en"' not in html
    assert "twierdzenie Cantora" in html
    assert "rozwińmy obie strony" in html
    rest = re.sub(r"<style>.*</style>|<script.*</script>|<[^>]*>", " ", html, flags=re.DOTALL)
    assert ENGLISH.findall(PROGRAM.sub("", rest)) == []
    assert 'lang="en"' not in page(whole[:20], Certificates([]), "en").split("</head>")[1]


def polish_texts():
    """All Polish texts: of claims, steps of proofs, the page, the figures and the player."""
    translation = Translation(claims(), "pl", OURS)
    for said in translation._by_claim.values():
        yield from (said.name, said.statement, said.note, said.holds, said.corrected)
    yield from (said for _, said in translation._phrases)
    yield from (translations["pl"] for translations in sentences().values())
    yield from (*POLISH.values(), *LETTERING["pl"].values(), *PLAYER["pl"].values())


def test_polish_typography():
    """Quotations stand in „…”, dashes are short, measures have a decimal comma, and % has no space."""
    wrong = re.compile(r"“|—| %|\d\.\d+(?=[°%]| s\b| rad\b)")
    texts = list(polish_texts())
    assert len(texts) > 900
    assert [text for text in texts if wrong.search(text)] == []


FIELDS = (
    *(
        "QQ",
        "RR",
        "CC",
        "GF(2)",
        "GF(7)",
        "QQ(sqrt(2))",
        "QQ(sqrt(-7))",
        "QQ(sqrt(-3))",
        "QQ(zeta(7))",
    ),
    *("QQ(cbrt(2))", "Qp(2)", "Qp(3)", "QQ(x)", "GF(3)(t)", "QQ(sqrt(-7))(t)", "QQ(sqrt(2))(t)"),
    *("QQ(x,y)", "GF(3)(x,y)", "GF(7)((t))"),
)


@pytest.mark.parametrize("name", FIELDS)
def test_the_level_of_a_field_and_its_norms_have_polish_reasons(name):
    translation, field = Translation([], "pl", OURS), ring(name)
    first = "x" if "(x" in name else "-1"
    rules = [norm_rule_of(field, a, b) for a, b in (("-1", "-1"), ("-1", "3"), (first, "-1"))]
    reasons = [str(field.level), *(rule.fact for rule in rules if rule is not None)]
    assert [reason for reason in reasons if translation.say(reason) is None] == []


@pytest.mark.parametrize(
    "theorem",
    [ODD_DEGREE, LIMITS, SIGN_CHANGE, COMPLEX_ROOT, QUATERNION_ROOT, REAL_ROOTS, COMPLEX_ROOTS],
)
def test_the_theorems_that_a_proof_may_cite_have_a_polish_text(theorem):
    assert Translation([], "pl", OURS).say(theorem)


@pytest.mark.parametrize(
    ("statement", "field"),
    [
        ("exists q: q*q*q == 2 + i", "QQ"),
        ("norm(p*q) == norm(p)*norm(q)", "RDF"),
        ("exists q: q*q == -1", "RDF"),
        ("s*t == 1 => s == t", "ZZ"),
    ],
)
def test_what_was_tried_has_a_polish_text(statement, field):
    tried = decide(statement, field, timeout=2).tried
    assert tried
    assert [text for text in tried if Translation([], "pl", OURS).say(text) is None] == []


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("the least number is 0.0", "najmniejszą liczbą jest 0,0"),
        ("3 points", "liczba punktów: 3"),
        ("the angle in frame 2 < the angle in frame 1.5", "kąt w klatce 2 < kąt w klatce 1,5"),
    ],
)
def test_numbers_within_sentences(text, said):
    assert Translation(claims(), "pl").say(text) == said


@pytest.mark.parametrize(
    ("form", "numbers"),
    [
        ("stwierdzenie", (1,)),
        ("stwierdzenia", (2, 3, 4, 22, 34, 102)),
        ("stwierdzeń", (0, 5, 11, 12, 14, 21, 101, 112, 271)),
    ],
)
def test_nouns_after_numbers(form, numbers):
    assert {counted("claims", n, "pl") for n in numbers} == {form}
    assert [counted("claims", n, "en") for n in (0, 1, 2, 22)] == [
        "claims",
        "claim",
        "claims",
        "claims",
    ]


def test_texts_name_claims_that_there_are():
    translation = Translation(claims(), "pl")
    known = {claim.id: claim for claim in claims()}
    assert translation._by_claim.keys() == known.keys()
    for key, translated in translation._by_claim.items():
        assert bool(translated.note) == bool(known[key].note)


def test_the_lettering_of_the_figures():
    from matplotlib.figure import Figure
    from matplotlib.text import Text

    found = set()
    for drawing in FIGURES.values():
        figure = Figure(figsize=drawing.size)
        drawing.draw(figure)
        found |= {text.get_text() for text in figure.findobj(Text)}
    worded = {t for t in found if "\\" not in t and not is_formula(t)}
    assert worded == LETTERING["pl"].keys()


@pytest.mark.parametrize(
    ("text", "formula"),
    [
        ("k = jij − 2", True),
        ("p == 0 or q == 0", True),
        ("norm(p*q) == 0 => p == 0 or q == 0", True),
        ("crossProduct(p, q)", True),
        ("it is false", False),
        ("q is 0", False),
        ("History.", False),
    ],
)
def test_what_is_a_formula(text, formula):
    assert is_formula(text) == formula


LEDGER = """
[[claims]]
id = "L1"
name = "square"
section = "1"
kind = "claim"
statement = "The square of i"
note = "A note that has no translation."
holds = "i*i == -e"
fields = ["QQ"]
"""
TEXTS = """
[claims.L1]
name = "kwadrat"
statement = "Kwadrat elementu i"
[phrases]
"compute both {what}" = "policz {what}"
"sides" = "strony"
"""


@pytest.fixture
def sheet(tmp_path):
    path = tmp_path / "sheet.toml"
    path.write_text(LEDGER, encoding="utf-8")
    return path


def test_a_ledger_of_ones_own_has_its_texts_beside_it(sheet):
    sheet.with_name("sheet.pl.toml").write_text(TEXTS, encoding="utf-8")
    rows = decide_rows(rows_to_decide(read_ledger(sheet), []), InProcess())
    html = page(rows, Certificates([]), "pl", (), "sheet")
    assert "<p>Kwadrat elementu i</p>" in html
    assert "policz strony" in html or "obliczmy obie strony" in html
    assert '<p lang="en">A note that has no translation.</p>' in html


@pytest.mark.parametrize(
    ("texts", "hint"),
    [
        ("[claims.L1\n", "cannot be read"),
        ("[other]\n", "'other'"),
        ("names = ['q', ['p']]\n", "names, entry 2"),
        ("names = 3\n", "'names'"),
        ('[claims.L1]\nname = "x"\n', "expected name and statement"),
        ('[claims.L1]\nname = "x"\nstatement = 3\n', "expected a text"),
        ('[claims]\nL1 = "x"\n', "expected name and statement"),
        ('[phrases]\n"over {F}" = "nad {G}"\n', "another slot"),
        ('[phrases]\n"over {F}" = 1\n', "expected a text"),
    ],
)
def test_texts_that_cannot_be_read_are_said(sheet, texts, hint, capsys):
    target = sheet.with_name("sheet.pl.toml")
    target.write_text(texts, encoding="utf-8")
    with pytest.raises(LedgerError, match=hint):
        Translation(read_ledger(sheet), "pl")
    assert main(["report", str(sheet), "--lang", "pl", "-o", str(sheet.with_suffix(".html"))]) == 2
    assert "sheet.pl.toml" in capsys.readouterr().err
