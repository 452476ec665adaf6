"""``hfield verify`` on a fake ledger: selection, formats, exit status, output files."""

import json
from pathlib import Path

import pytest

from hfield import __version__
from hfield.ledger.claim import PANEL
from tests.subcases import subcases


def results(run, *words):
    status, out, _ = run("verify", *words, "--format", "json")
    data = json.loads(out)
    assert data["schema"] == "hfield-verify/1"
    assert data["version"] == __version__
    assert set(data) == {"schema", "version", "results"}
    return status, data["results"]


def pairs(rows):
    return [(row["id"], row["field"]) for row in rows]


def test_all_claims_over_the_whole_panel(run):
    status, rows = results(run)
    fielded = [(name, field) for name in ("C1-a", "C1.1-a") for field in PANEL]
    last = [("C1.10-a", field) for field in PANEL]
    assert pairs(rows) == [*fielded, ("C1.1-b", "-"), *last]
    assert status == 0


def test_a_row_has_the_fixed_keys(run):
    _, (row,) = results(run, "C1.1-a", "--field", "GF(9)")
    assert row == {
        "id": "C1.1-a",
        "field": "GF(9)",
        "as_printed": "refuted",
        "as_corrected": "proved",
        "method": "identity",
        "witness": {"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "1"]},
        "correction": "p*q - q*p == comm(p,q)",
        "certificate": None,
    }


def test_names_ids_and_case(run):
    for name in ("slip", "C1.1-a", "c1.1-A"):
        assert pairs(results(run, name, "--field", "QQ")[1]) == [("C1.1-a", "QQ")]


def test_fields_repeat_or_stand_between_commas_in_any_spelling(run):
    _, rows = results(run, "table", "--field", "GF9,Q", "--field", "GF(4, x^2+x+1),universal,QQ")
    fields = [row["field"] for row in rows]
    assert fields[:2] == ["GF(9)", "QQ"]
    assert fields[3:] == ["universal"]
    assert len(fields) == 4


def test_a_field_outside_the_panel(run):
    assert pairs(results(run, "slip", "--field", "GF11")[1]) == [("C1.1-a", "GF(11)")]


def test_a_claim_about_no_field_keeps_its_row(run):
    assert pairs(results(run, "average", "--field", "QQ")[1]) == [("C1.1-b", "-")]
    assert pairs(results(run, "--field", "-")[1]) == [("C1.1-b", "-")]
    assert "C1.1-b" not in dict(pairs(results(run, "--field", "QQ")[1]))


def test_a_claim_about_fields_has_no_row_without_one(run):
    status, _, err = run("verify", "slip", "--field", "-")
    assert status == 2
    assert "C1.1-a" in err


def test_section_takes_subsections_but_not_namesakes(run):
    _, rows = results(run, "--section", "1.1", "--field", "QQ,-")
    assert pairs(rows) == [("C1.1-a", "QQ"), ("C1.1-b", "-")]
    assert len(results(run, "--section", "1", "--field", "QQ,-")[1]) == 4


def test_the_terminal_report(run):
    status, out, err = run("verify")
    assert status == 0
    assert err == ""
    assert max(map(len, out.splitlines())) <= 100
    for text in (
        "Headline",
        "C1-a",
        "Errata",
        "C1.1-a  slip",
        "źle",
        "swapped",
        "p = i, q = j + k",
    ):
        assert text in out
    assert "C1.10-a" in out.splitlines()[-3]


def test_the_last_line_says_whether_all_is_as_expected(run):
    for words in (), ("--format", "markdown"):
        last = run("verify", *words)[1].splitlines()[-1]
        assert last.startswith("All is as expected: every row has a verdict")


def test_the_last_line_counts_what_is_not_as_expected(broken):
    last = broken("verify", "--field", "QQ,GF9,universal")[1].splitlines()[-1]
    assert last == "Not as expected: 1 decision without a verdict, 1 contradiction."


def test_a_quotation_in_another_language_is_marked(run):
    for words, label in ((("verify", "slip"), "prints"), (("explain", "slip"), "printed")):
        (line,) = (x for x in run(*words)[1].splitlines() if x.split()[:1] == [label])
        assert line.endswith(" “źle: q₁q₂ = q₂q₁ √” (Polish)")


def test_all_shows_every_row(run):
    _, out, _ = run("verify", "--all")
    lines = out.splitlines()
    for field in PANEL:
        assert any(line.startswith("C1.1-a") and f" {field} " in line for line in lines)


def test_markdown(run):
    status, out, _ = run("verify", "--format", "markdown")
    assert status == 0
    assert out.count("\n| C1-a | table | ✓ |") == 1
    assert "### C1.1-a slip" in out
    status, out, _ = run("verify", "slip", "--field", "QQ", "--format", "markdown", "--all")
    assert "| C1.1-a | QQ | refuted | identity | p = i, q = j + k | proved |" in out


def test_undecided_and_contradictory_rows_are_status_1(broken):
    status, (row,) = results(broken, "hard", "--field", "QQ")
    assert status == 1
    assert row["as_printed"] == "undecided"
    words = ("verify", "clash", "--field", "QQ,GF9,universal")
    status, out, err = broken(*words, "--format", "json")
    assert status == 1
    assert "contradiction: C1-y" in err
    status, out, err = broken(*words)
    assert (status, err) == (1, "")
    assert "C1-y as printed: proved in general" in out
    assert broken("verify", "clash", "--field", "QQ,universal")[0] == 0


def test_undecided_rows_say_what_was_tried(broken):
    _, out, _ = broken("verify", "hard")
    assert "C1-x as printed, over QQ. Tried:" in out
    assert "a million terms" in out


def test_a_ring_that_is_no_field_is_named(run):
    status, _, err = run("verify", "table", "--field", "ZZ/6")
    assert status == 0
    assert "ZZ/6 is not a field" in err


def test_output_file(run, tmp_path: Path):
    target = tmp_path / "report.json"
    target.write_text("old")
    status, out, err = run("verify", "--format", "json", "-o", str(target))
    assert (status, out, err) == (0, "", "")
    assert json.loads(target.read_text())["schema"] == "hfield-verify/1"
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]


def test_an_interrupt_leaves_the_old_file(run, tmp_path: Path, monkeypatch):
    def interrupt(*_):
        raise KeyboardInterrupt

    target = tmp_path / "report.json"
    target.write_text("old")
    monkeypatch.setattr("hfield.ledger.run.decide", interrupt)
    status, _, err = run("verify", "-o", str(target))
    assert status == 130
    assert err == "hfield: error: interrupted\n"
    assert target.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["report.json"]


@pytest.mark.parametrize("name", ["no/such/dir/file", ".", ""])
def test_an_unwritable_file_is_found_before_the_work(run, tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("hfield.ledger.run.decide", lambda *_: pytest.fail("worked first"))
    status, out, err = run("verify", "-o", name)
    assert (status, out) == (2, "")
    assert err.startswith("hfield: error: ")
    assert err.count("\n") == 1


def test_a_full_disk(run):
    device = Path("/dev/full")
    if not device.exists():
        pytest.skip("this system has no /dev/full")
    status, _, err = run("verify", "-o", str(device))
    assert status == 2
    assert "/dev/full" in err


@subcases(
    ("words", "hint"),
    [
        (["C9.9-z"], "there is no claim"),
        (["norm.json"], "not a ledger"),
        (["tabel"], "the nearest are table"),
        (["--field", "GF(6)"], "GF(6)"),
        (["--field", "GF(0)"], "0"),
        (["--field", "GF(4, x^2)"], "irreducible"),
        (["--field", "QQ(sqrt(4))"], "sqrt(4)"),
        (["--field", "Quaternions"], "Quaternions"),
        (["--field", ""], "empty"),
        (["--field", "QQ,"], "empty"),
        (["--field"], "--field"),
        (["--section", "7.7"], "there is no section"),
        (["--section", ""], "there is no section"),
        (["--feild", "QQ"], "did you mean --field"),
        (["--format", "xml"], "xml"),
        (["--jobs", "0"], "--jobs"),
        (["--jobs", "many"], "many"),
        (["--jobs", "-3"], "-3"),
        (["--jobs", "1e9"], "1e9"),
    ],
)
def test_bad_usage(run, words, hint):
    status, out, err = run("verify", *words)
    assert (status, out) == (2, "")
    assert err.startswith("hfield: error: ")
    assert err.count("\n") == 1
    assert hint in err
