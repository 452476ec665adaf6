"""``hfield export --coq FILE``."""

import pytest

from hfield.cli.commands import export
from hfield.cli.parser import Parser, UsageError
from hfield.errors import NotationError
from hfield.ledger.registry import UnknownClaimError


@pytest.fixture
def run(capsys):
    def call(*words):
        parser = Parser("hfield export", export.HELP)
        export.configure(parser)
        status = export.run(parser.read(words))
        return status, *capsys.readouterr()

    return call


def test_a_claim_and_a_statement(run, tmp_path):
    file = tmp_path / "out.v"
    status, out, err = run("--coq", str(file), "--claim", "centre", "--statement", "e*q == q")
    assert (status, err) == (0, "")
    assert out.startswith(f"{file}: 1 theorem exported and ")
    assert out.endswith(" proved by hand, 0 not exported\n")
    text = file.read_text(encoding="utf-8")
    assert "Theorem statement_1 :" in text
    assert "C1.1.2-c: centre, centre_in_char_2" in text


def test_what_is_not_exported_is_reported(run, tmp_path):
    file = str(tmp_path / "out.v")
    status, out, err = run("--coq", file, "--claim", "table", "--statement", "p*q == q*p")
    assert status == 1
    assert "1 not exported" in out
    assert "statement_1, p*q == q*p: refuted, so this is not a theorem" in err


def test_to_the_terminal(run):
    words = ("--coq", "-", "--claim", "C1-a", "--statement", "q*e == q", "--algebra", "(a,b|F)")
    status, out, err = run(*words)
    assert status == 0
    assert "q [*(Algebra a 0 b)] e = q" in out
    assert "note: 2 theorems exported" in err


def test_bad_usage(run, tmp_path):
    for words in ((), ("--coq", "x.v", "--algebra", "(a,b|F)")):
        with pytest.raises(UsageError):
            run(*words)
    with pytest.raises(UnknownClaimError):
        run("--coq", str(tmp_path / "x.v"), "--claim", "no-such-claim")
    with pytest.raises(NotationError):
        run("--coq", str(tmp_path / "x.v"), "--claim", "table", "--statement", "p ==")
    assert not list(tmp_path.iterdir())
