"""``hfield check`` and ``hfield verify --certificates``."""

import json
from pathlib import Path

import pytest

from hfield.checker.glossary import ODD_DEGREE, THEOREMS
from hfield.cli import main


def written(tmp_path: Path, statement: str, *options: str) -> str:
    path = str(tmp_path / "one.json")
    main(["prove", statement, "--certificate", path, *options])
    return path


def test_accepted_and_rejected(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, "p*q == q*p", "--field", "GF(9)")
    capsys.readouterr()
    assert main(["check", path]) == 0
    assert "refuted over GF(9)" in capsys.readouterr().out
    assert main(["check", path, "--statement", "(p*q) == (q*p)", "--field", "GF9"]) == 0
    assert main(["check", path, "--statement", "p*q == q*p", "--field", "GF(3)"]) == 1
    assert main(["check", path, "--statement", "p*q == q*p"]) == 1
    assert "rejected" in capsys.readouterr().out
    bad = tmp_path / "bad.json"
    bad.write_bytes(b"\xff\xfe")
    assert main(["check", path, str(bad)]) == 1
    assert main(["check", path, str(tmp_path / "missing.json")]) == 2
    assert main(["check", str(tmp_path)]) == 2


def test_bad_usage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, "p*q == q*p", "--field", "QQ")
    for options in (
        ["--field", "QQ"],
        ["--claim", "C9.9-z"],
        ["--claim", "C1-a", "--statement", "q == q"],
        ["--statement", "q =="],
        ["--statement", "q == q", "--field", "GF(6)"],
        ["--claim", "impression"],
    ):
        assert main(["check", path, *options]) == 2, options
    assert main(["check"]) == 2


def test_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, "(p*q)*r == p*(q*r)")
    capsys.readouterr()
    assert main(["check", path, "--format", "json"]) == 0
    (result,) = json.loads(capsys.readouterr().out)["results"]
    assert result["accepted"]
    assert result["scope"] == "commutative rings"
    assert result["field"] is None


def test_verify_writes_certificates(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    directory = tmp_path / "certificates"
    options = ["--field", "QQ,GF(4),QQ(sqrt(-7)),universal", "--certificates", str(directory)]
    assert main(["verify", "C1.1.2-b", "C1.2-a", "C1.3.1-y", *options, "--format", "json"]) == 0
    rows = json.loads(capsys.readouterr().out)["results"]
    paths = [row["certificate"] for row in rows if row["as_printed"] != "not-applicable"]
    assert all(Path(path).parent == directory for path in paths)
    files = [str(path) for path in directory.glob("*.json")]
    assert len(files) > len(paths)
    assert main(["check", *files]) == 0
    for row in rows:
        expected = ["--claim", row["id"], "--field", row["field"]]
        assert main(["check", row["certificate"], *expected]) == 0
        assert main(["check", row["certificate"], "--claim", "C1-a", "--field", row["field"]]) == 1


def test_a_directory_that_cannot_be_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    options = ["--field", "QQ", "--certificates", str(tmp_path / "file")]
    assert main(["verify", "C1-a", *options]) == 2
    assert "choose another directory" in capsys.readouterr().err


def test_an_assumption_has_an_exit_status_of_its_own(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written(tmp_path, "exists s: s**3 == 2", "--field", "RR")
    good = written(tmp_path, "exists s: s**3 == 2", "--field", "RR")
    capsys.readouterr()
    assert main(["check", path]) == 0
    assert f"cites the theorem: {ODD_DEGREE}" in capsys.readouterr().out
    monkeypatch.delitem(THEOREMS, ODD_DEGREE)
    assert main(["check", path, good]) == 3
    assert f"assumes, unproved: {ODD_DEGREE}" in capsys.readouterr().out
    assert main(["check", path, "--statement", "exists s: s**3 == 2", "--field", "RR"]) == 3
    capsys.readouterr()
    assert main(["check", path, "--allow-assumptions", "--format", "json"]) == 0
    (result,) = json.loads(capsys.readouterr().out)["results"]
    assert (result["assumptions"], result["theorems"]) == ([ODD_DEGREE], [])
    (tmp_path / "bad.json").write_text("{}")
    assert main(["check", path, str(tmp_path / "bad.json"), "--allow-assumptions"]) == 1


def test_hypotheses_given_apart_are_part_of_the_pin(tmp_path: Path) -> None:
    path = written(tmp_path, "q*inv(q) == e", "--given", "norm(q) != 0", "--field", "QQ")
    expected = ["--statement", "q*inv(q) == e", "--field", "QQ"]
    assert main(["check", path, *expected]) == 1
    assert main(["check", path, *expected, "--given", "norm(q)!=0"]) == 0
    assert main(["check", path, *expected, "--given", "norm(q) == 0"]) == 1
    assert (
        main(["check", path, "--statement", "norm(q) != 0 => q*inv(q) == e", "--field", "QQ"]) == 0
    )
    assert main(["check", path, "--given", "norm(q) != 0"]) == 2


def test_the_whole_statement_is_shown(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    statement = "p*q == q*p" + " " * 400 + "or 0 == 0"
    path = written(tmp_path, statement, "--field", "QQ")
    capsys.readouterr()
    assert main(["check", path]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].endswith(": proved over QQ")
    assert "  statement: p*q == q*p or 0 == 0" in lines
    assert {"  field: QQ, the rational numbers", "  algebra: (-1,-1|QQ)"} <= set(lines)


def test_a_file_of_many_is_checked_line_by_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one = json.loads(Path(written(tmp_path, "p*q == q*p", "--field", "GF(9)")).read_text("utf-8"))
    two = json.loads(Path(written(tmp_path, "norm(i) == 1", "--field", "QQ")).read_text("utf-8"))
    many = tmp_path / "many.jsonl"
    many.write_text(f"{json.dumps(one)}\n\n{json.dumps(two)}\n", encoding="utf-8")
    capsys.readouterr()
    assert main(["check", str(many)]) == 0
    output = capsys.readouterr().out
    assert f"{many}:1: refuted over GF(9)" in output
    assert f"{many}:3: proved over QQ" in output
    with many.open("a", encoding="utf-8") as stream:
        stream.write(json.dumps(two | {"verdict": "refuted"}) + "\n")
    assert main(["check", str(many), "--format", "csv"]) == 1
    assert "many.jsonl:4,false," in capsys.readouterr().out
    assert main(["check", str(tmp_path / "absent.jsonl")]) == 2
    assert "absent.jsonl" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("field", "words"),
    [
        ("QQ(p)", "QQ(p), the rational functions in p over ℚ"),
        ("QQ(zeta_8)", "QQ(zeta8), the field of ζ₈ over ℚ"),
        ("QQ(sqrt2)", "QQ(sqrt(2)), the field of sqrt(2) over ℚ"),
        ("GF(3)(t)_t", "GF(3)((t)), the completion of GF(3)(t) at t = 0, the Laurent series"),
        ("Frac(QQ[sqrt2])", "Frac(QQ[sqrt2]), the rational functions in sqrt2 over ℚ"),
    ],
)
def test_fields_are_said_in_words(
    field: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path, "s*q == q*s", "--field", field)
    assert words.partition(",")[0] in capsys.readouterr().out
    assert main(["check", path]) == 0
    assert f"  field: {words}" in capsys.readouterr().out.splitlines()


def test_an_unknown_of_a_pin_is_no_element_of_the_field(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path, "p*q == q*p", "--field", "QQ(p)")
    assert main(["check", path]) == 0
    for expected in (["--statement", "p*q == q*p", "--field", "QQ(p)"], ["--claim", "C1.3.1-p"]):
        assert main(["check", path, *expected]) == 1, expected
    assert "p is an unknown of the statement, and an element of QQ(p)" in capsys.readouterr().out
    path = written(tmp_path, "x*q == q*x", "--field", "QQ(x)")
    assert main(["check", path, "--statement", "x*q == q*x", "--field", "QQ(x)"]) == 0
    assert "over QQ(x), rational functions in x over ℚ" in capsys.readouterr().err


def test_a_claim_without_a_field_says_which_lines_name_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    directory = tmp_path / "certificates"
    main(["verify", "C1-a", "--field", "GF(4)", "--certificates", str(directory)])
    (path,) = map(str, directory.iterdir())
    capsys.readouterr()
    assert main(["check", "--claim", "C1-a", path]) == 0
    output = capsys.readouterr()
    assert "claim C1-a over any field: each certificate says below over which" in output.err
    assert "  field: GF(4), the field with 4 elements, x a root of x^2+x+1" in output.out
