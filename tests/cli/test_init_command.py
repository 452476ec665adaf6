"""``hfield init``: the ledger that it writes runs at once, and nothing is written over."""

from pathlib import Path

import pytest

from tests.cli.running import run


@pytest.mark.slow
def test_the_ledger_is_decided(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    status, _, err = run(capsys, "init", "lemmas.toml")
    assert status == 0
    assert "hfield verify lemmas.toml" in err
    status, out, _ = run(capsys, "verify", "lemmas.toml")
    assert status == 0
    assert "E1" in out
    text = (tmp_path / "lemmas.toml").read_text()
    assert "lemmas.html" in text
    assert "sheet" not in text


def test_a_file_that_is_there_stays(tmp_path: Path, capsys) -> None:
    path = tmp_path / "sheet.toml"
    path.write_text("mine")
    status, _, err = run(capsys, "init", str(path))
    assert status == 2
    assert "exists already" in err
    assert path.read_text() == "mine"


def test_a_name_is_needed(capsys) -> None:
    assert "the output file is empty" in run(capsys, "init", "")[2]
