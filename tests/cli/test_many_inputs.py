"""Several arguments, a file or standard input for one command: an answer a line, none lost."""

import csv
import io
import json

import pytest

from hfield.cli import main


@pytest.fixture
def run(capsys, monkeypatch):
    def run(*words, typed=""):
        monkeypatch.setattr("sys.stdin", io.StringIO(typed))
        status = main(words)
        out, err = capsys.readouterr()
        assert "Traceback" not in err
        return status, out, err

    return run


def test_each_argument_is_answered_in_order(run):
    assert run("eval", "i*j", "-k", "1/(1+i)", "--field", "GF7") == (0, "k\n6*k\n4 + 3*i\n", "")


def test_lines_of_a_file_and_of_standard_input(run, tmp_path):
    file = tmp_path / "algebras.txt"
    file.write_text("# two\n(-1,-3|QQ)\n\n  (1,1|GF(3))\n", encoding="utf-8-sig")
    words = ("info", "-", "--from", str(file), "--format", "jsonl")
    status, out, err = run(*words, typed="(-1,-1|QQ)\n")
    assert (status, err) == (0, "")
    answers = [json.loads(line) for line in out.splitlines()]
    assert [a["algebra"] for a in answers] == ["(-1,-1|QQ)", "(-1,-3|QQ)", "(1,1|GF(3))"]
    assert [a["division"] for a in answers] == [True, True, False]
    assert json.loads(run("info", "(-1,-3|QQ)", "--format", "json")[1]) == answers[1]


def test_a_file_without_inputs_is_noted(run, tmp_path):
    file = tmp_path / "none.txt"
    file.write_text("# nothing\n", encoding="utf-8")
    status, out, err = run("eval", "--from", str(file))
    assert (status, out) == (0, "")
    assert err.endswith("none.txt has no inputs\n")


def test_a_line_that_cannot_be_answered_loses_none_of_the_others(run):
    words = ("info", "(-1,-3|QQ)", "nonsense", "(1,1|QQ)", "--format", "csv")
    status, out, _ = run(*words)
    rows = list(csv.DictReader(io.StringIO(out)))
    assert status == 2
    assert [row["division"] for row in rows] == ["true", "", "false"]
    assert [bool(row["error"]) for row in rows] == [False, True, False]
    assert (rows[0]["ramified_places"], rows[1]["algebra"]) == ("3 inf", "nonsense")
    status, out, err = run("eval", "1/0", "i")
    assert (status, out) == (2, "i\n")
    assert "1/0" in err


@pytest.mark.parametrize(
    ("statements", "status"),
    [
        (["p == p", "q == q"], 0),
        (["p == p", "p*q == q*p"], 1),
        (["p*q == q*p", "p == ", "p == p"], 2),
    ],
)
def test_the_exit_status_is_the_worst(run, statements, status):
    got, out, _ = run("prove", *statements, "--field", "QQ", "--format", "csv")
    assert got == status
    verdicts = [row["verdict"] for row in csv.DictReader(io.StringIO(out))]
    assert len(verdicts) == len(statements)


def test_certificates_by_their_names(run, tmp_path):
    names = [str(tmp_path / name) for name in ("a.json", "b.json")]
    for name in names:
        assert run("prove", "p + q == q + p", "--certificate", name)[0] == 0
    status, out, _ = run("check", "-", "--format", "jsonl", typed="\n".join([*names, "gone.json"]))
    answers = [json.loads(line) for line in out.splitlines()]
    assert status == 2
    assert [a["accepted"] for a in answers] == [True, True, False]


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["info"], "expected ALGEBRA, --from FILE, or - for standard input"),
        (["check", "--format", "csv"], "expected FILE"),
        (["eval", "--from", "/nowhere/at/all"], "cannot read '/nowhere/at/all'"),
        (["info", "(1,1|QQ)", "(1,2|QQ)", "--format", "json"], "use jsonl or csv"),
        (["prove", "p == p", "q == q", "--certificate", "c.json"], "give one statement"),
    ],
)
def test_bad_usage(run, words, hint):
    status, out, err = run(*words)
    assert (status, out) == (2, "")
    assert hint in err


def test_answers_come_as_the_lines_do(monkeypatch, capsys):
    """Each answer is written before the next line is read: a stream has no end to wait for."""

    def lines():
        for n in range(1, 4):
            yield f"{n}\n"
            assert capsys.readouterr().out == f"{n}\n"

    class Endless(io.StringIO):
        def __iter__(self):
            return lines()

    monkeypatch.setattr("sys.stdin", Endless())
    assert main(["eval", "-"]) == 0
