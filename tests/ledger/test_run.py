"""Deciding claims × fields through an executor, and finding contradictions."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import pytest

from hfield.core.executors import InProcess
from hfield.errors import TooLargeError
from hfield.ledger import run
from hfield.ledger.claim import NO_FIELD, Claim, Row
from hfield.ledger.run import MIN_ROWS_PER_TASK, contradictions, decide_row, decide_rows
from hfield.prover.decision import Decision


@dataclass(frozen=True)
class Fake:
    """Proved over every field but those in ``false``; keeps a list of what it was asked."""

    text: str = "p == p"
    false: tuple[str, ...] = ()
    calls: list[str] = field(default_factory=list, hash=False, compare=False)

    def decide(self, ring):
        name = ring.name if ring else "universal"
        self.calls.append(name)
        return Decision("refuted" if name in self.false else "proved", "fake", scope="fields")


def claim(number, proposition, corrected=None):
    return Claim(
        number, number.lower(), "claim", "words", "print", proposition, corrected=corrected
    )


@pytest.fixture
def ledger(monkeypatch):
    calls = []
    claims = {
        f"C1-{letter}": claim(f"C1-{letter}", Fake(false=("GF(3)",), calls=calls), Fake("q == q"))
        for letter in "abcdefghijklmnopqrst"
    }
    monkeypatch.setattr(run, "find", claims.__getitem__)
    return claims, calls


FIELDS = ("QQ", "GF(3)", "universal")


@pytest.mark.parametrize("make", [InProcess, lambda: ThreadPoolExecutor(3)])
def test_rows_come_in_the_given_order(ledger, make):
    claims, _ = ledger
    pieces = [(c, f) for c in claims.values() for f in FIELDS]
    with make() as executor:
        rows = decide_rows(pieces, executor)
    assert [(row.claim, row.field) for row in rows] == pieces
    for row in rows:
        assert row.as_printed.verdict == ("refuted" if row.field == "GF(3)" else "proved")
        assert (row.as_corrected is not None) == (row.field == "GF(3)")


def test_a_claim_goes_through_its_fields_before_the_next(ledger):
    claims, calls = ledger
    decide_rows([(c, f) for c in claims.values() for f in FIELDS], InProcess())
    assert calls == [f for _ in claims for f in FIELDS]


def test_what_computes_without_a_field_goes_first(ledger):
    claims, _ = ledger
    done = []
    pieces = [(c, f) for c in claims.values() for f in FIELDS]
    pieces[-1] = (pieces[-1][0], NO_FIELD)
    rows = decide_rows(pieces, InProcess(), lambda _done, _total, what: done.append(what))
    assert done[0] == "C1-t"
    assert [(row.claim, row.field) for row in rows] == pieces


def test_progress_runs_up_to_the_end(ledger):
    claims, _ = ledger
    seen = []
    pieces = [(c, f) for c in claims.values() for f in FIELDS]
    decide_rows(pieces, InProcess(), lambda done, total, what: seen.append((done, total, what)))
    done = [n for n, _, _ in seen]
    assert done == sorted(set(done))
    assert seen[-1] == (60, 60, "C1-t")
    assert len(seen) == 60 // MIN_ROWS_PER_TASK


def test_no_rows():
    assert decide_rows([], InProcess()) == []


def test_what_cannot_be_decided_says_why():
    class Heavy:
        text = "heavy"

        def decide(self, ring):
            raise TooLargeError("a million terms")

    row = decide_row(claim("C1-a", Heavy()), "QQ")
    assert (row.as_printed.verdict, row.as_printed.tried) == ("undecided", ("a million terms",))
    assert not row.settled


def row(field, printed, corrected=None):
    made = [v and Decision(v, "fake", scope="fields") for v in (printed, corrected)]
    return Row(claim("C1-a", Fake()), field, *made)


@pytest.mark.parametrize(
    "rows",
    [
        [row("universal", "proved"), row("QQ", "proved")],
        [row("universal", "refuted"), row("QQ", "proved"), row("GF(3)", "refuted")],
        [row("universal", "not-applicable"), row("QQ", "refuted")],
        [row("universal", "undecided"), row("QQ", "refuted")],
        [row("universal", "proved"), row("ZZ/6", "refuted")],  # proved over fields only
        [row("-", "refuted")],
        [row("QQ", "refuted", "proved")],
        [row("QQ", "refuted", "vacuous"), row("universal", "refuted", "not-applicable")],
    ],
)
def test_no_contradiction(rows):
    assert contradictions(rows) == []


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([row("universal", "proved"), row("QQ", "refuted")], "as printed: proved in general"),
        ([row("QQ", "refuted"), row("universal", "vacuous")], "as printed: vacuous in general"),
        ([row("QQ", "refuted", "refuted")], "correction is refuted over QQ"),
        (
            [row("universal", "refuted", "proved"), row("GF(3)", "refuted", "refuted")],
            "as corrected: proved in general",
        ),
    ],
)
def test_contradiction(rows, words):
    assert any(words in text for text in contradictions(rows))
