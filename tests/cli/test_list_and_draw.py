"""``hfield list`` and ``hfield draw``: what they print and write, and what they refuse."""

import csv
import json

import pytest

from hfield import GF, H
from hfield.cli import main


def run(capsys, *words: str) -> tuple[int, str, str]:
    status = main(words)
    out, err = capsys.readouterr()
    return status, out, err


def test_zero_divisors_of_the_issue(capsys) -> None:
    status, out, _ = run(capsys, "list", "H(GF(7))", "zero-divisors")
    assert status == 0
    A = H(GF(7))
    assert [A(line) for line in out.splitlines()] == list(A.zero_divisors())
    assert run(capsys, "list", "GF7", "zero-divisors", "--count")[1] == "385 = q^3+q^2-q\n"
    assert run(capsys, "list", "ZZ/6", "units", "--count")[1] == "384\n"


def test_formats(capsys) -> None:
    _, out, _ = run(capsys, "list", "GF3", "norm=1", "--format", "csv", "--limit", "2")
    rows = list(csv.DictReader(out.splitlines()))
    assert rows == [
        {"1": "0", "i": "0", "j": "0", "k": n, "trace": "0", "norm": "1"} for n in ("1", "2")
    ]
    data = json.loads(run(capsys, "list", "GF2", "idempotents", "--format", "json")[1])
    assert (data["count"], data["formula"], data["elements"]) == (2, "2", ["0", "1"])
    data = json.loads(run(capsys, "list", "GF3", "trace=1", "--count", "--format", "json")[1])
    assert data["count"] == 27
    assert run(capsys, "list", "GF3", "units", "--count", "--format", "csv")[1] == (
        "count,formula\n48,q^4-q^3-q^2+q\n"
    )


@pytest.mark.parametrize(
    ("what", "count"),
    [
        ("left-ideals", 6),
        ("right-ideals", 6),
        ("two-sided-ideals", 2),
        ("subalgebras", 6),
        ("classes", 12),
    ],
)
def test_other_lists(capsys, what: str, count: int) -> None:
    assert run(capsys, "list", "GF3", what, "--count")[1] == f"{count}\n"
    assert len(run(capsys, "list", "GF3", what)[1].splitlines()) == count + 1
    rows = list(csv.DictReader(run(capsys, "list", "GF3", what, "--format", "csv")[1].splitlines()))
    data = json.loads(run(capsys, "list", "GF3", what, "--format", "json")[1])
    assert data["found"] == rows
    assert len(rows) == data["count"] == count


def test_over_infinite_fields_some_are_drawn(capsys) -> None:
    _, out, _ = run(capsys, "list", "QQ", "norm=2", "--limit", "3")
    head, *lines = out.splitlines()
    assert head.startswith("# norm(q) == 2; random elements")
    assert len(lines) == 3
    status, _, err = run(capsys, "list", "QQ", "units", "--count")
    assert (status, "infinite" in err) == (2, True)


def test_misspelt_lists(capsys) -> None:
    status, _, err = run(capsys, "list", "GF3", "zero-divisor")
    assert status == 2
    assert "did you mean zero-divisors" in err


def test_pictures(capsys, tmp_path) -> None:
    path = tmp_path / "a.svg"
    assert run(capsys, "draw", "H(GF(2))", "--what", "ideals", "--dark", "-o", str(path))[0] == 0
    assert "<svg" in path.read_text(encoding="utf-8")
    for words in (["GF2"], ["GF2", "-o", str(tmp_path / "a.txt")], ["QQ", "-o", str(path)]):
        status, out, err = run(capsys, "draw", *words)
        assert (status, out, err.count("\n")) == (2, "", 1)
