"""MathML is well formed, has what its elements want, and says what the unicode writer says."""

from xml.etree import ElementTree

import pytest

from hfield.errors import NotationError
from hfield.ledger.registry import claims
from hfield.prover.statements.mathml import to_mathml
from hfield.prover.statements.printing import to_unicode
from hfield.syntax import parse

TWO = {"mfrac", "msup", "msub", "mover"}
LEAVES = {"mi", "mn", "mo"}


def statements():
    out = [
        "p/q == 2",
        "(p+q)/(p-q) == -p",
        "sqrt(norm(p)) == -1/2",
        "exists p, q: p**2 == -1 and not p == q",
    ]
    for claim in claims():
        for proposition in (claim.as_printed, claim.corrected):
            if proposition is not None:
                try:
                    parse(proposition.text)
                except NotationError:
                    continue
                out.append(proposition.text)
    return out


def test_every_formula_of_the_thesis_is_well_formed():
    texts = statements()
    assert len(texts) > 100
    for text in texts:
        root = ElementTree.fromstring(f"<p>{to_mathml(parse(text))}</p>")
        for element in root.iter():
            if element.tag in TWO:
                assert len(element) == 2, text
            assert (len(element) == 0) == (element.tag in LEAVES), text
            if element.tag not in LEAVES:
                assert not (element.text or "").strip(), text


@pytest.mark.parametrize(
    "text",
    [
        "p*q == q*p",
        "norm(p*q) == norm(p)*norm(q)",
        "(p*q)*r == p*(q*r) and p != -q => s - (t - 1) == 0",
    ],
)
def test_it_reads_as_the_unicode_writer_writes(text):
    root = ElementTree.fromstring(f"<p>{to_mathml(parse(text))}</p>")
    assert "".join("".join(root.itertext()).split()) == "".join(to_unicode(parse(text)).split())


def test_lines_may_break_before_operators_only_outside_parentheses():
    pieces = to_mathml(parse("(p + q)*r == p*r + q*r => p == q")).split("</math> ")
    assert len(pieces) == 5
    assert all('<math><mo form="infix">' in piece for piece in pieces[1:])
