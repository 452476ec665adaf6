"""A small ledger of fake claims, so that the commands are tested apart from the mathematics."""

from dataclasses import dataclass

import pytest

from hfield.cli import main
from hfield.errors import TooLargeError
from hfield.ledger import registry
from hfield.ledger.claim import Claim
from hfield.prover.decision import Decision


@dataclass(frozen=True)
class Fake:
    """Refuted over the fields in ``false``, undecided over those in ``open``, else proved."""

    text: str = "p*q == q*p"
    false: tuple[str, ...] = ()
    open: tuple[str, ...] = ()

    def decide(self, field):
        name = field.name if field else "universal"
        if name in self.open:
            raise TooLargeError("this would take a million terms")
        if name in self.false:
            witness = {"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "1"]}
            return Decision("refuted", "identity", witness=witness, steps=("p·q ≠ q·p",))
        return Decision("proved", "identity", steps=("All coefficients vanish.",), scope="fields")


CLAIMS = (
    Claim("C1-a", "table", "definition", "The table", "ij = k", Fake(), headline=True),
    Claim(
        "C1.1-a",
        "slip",
        "formula",
        "A slip of the pen",
        "źle: q₁q₂ = q₂q₁ √",
        Fake(false=("QQ", "GF(9)", "GF(11)", "universal")),
        corrected=Fake("p*q - q*p == comm(p,q)"),
        note="The factors are swapped.",
        language="Polish",
    ),
    Claim("C1.1-b", "average", "number", "An average of 3", "3", Fake(), fields=("-",)),
    Claim("C1.10-a", "history", "remark", "Hamilton was Irish", "", None, note="History."),
)
BROKEN = (
    Claim("C1-x", "hard", "claim", "Too large", "?", Fake(open=("QQ",))),
    Claim("C1-y", "clash", "claim", "Contradicts itself", "!", Fake(false=("GF(9)",))),
)


@pytest.fixture
def run(monkeypatch, capsys):
    """Return a function that runs a command line on the fake ledger: (status, stdout, stderr)."""
    fake_ledger(monkeypatch, CLAIMS)

    def call(*words):
        status = main(words)
        out, err = capsys.readouterr()
        assert "Traceback" not in err
        return status, out, err

    yield call
    registry.claims.cache_clear()
    registry._spellings.cache_clear()


@pytest.fixture
def broken(run, monkeypatch):
    """The same with claims that are undecided or contradict themselves."""
    fake_ledger(monkeypatch, BROKEN)
    return run


def fake_ledger(monkeypatch, claims):
    monkeypatch.setattr(registry, "CLAIMS", claims)
    monkeypatch.setattr(registry, "_foreign", lambda: ())
    registry.claims.cache_clear()
    registry._spellings.cache_clear()
