"""Completion, the doctor, searching for claims, and pages of a given width."""

import json
import re
import subprocess
from shutil import which

import pytest

from hfield.cli import main
from hfield.cli.catalogue import names
from hfield.cli.commands import completion, doctor
from hfield.cli.commands.completion import SCRIPTS, candidates
from tests.patience import PATIENCE
from tests.subcases import slow, subcases


@subcases(
    ("words", "offered"),
    [
        (["pro"], ["prove"]),
        (["help", "ver"], ["verify"]),
        (["explain", "theorem-2"], ["theorem-2.1", "theorem-2.2", "theorem-2.3", "theorem-2.4"]),
        (["prove", "x", "--field", "GF2"], ["GF2", "GF2t"]),
        (["table", "--format", "la"], ["latex"]),
        (["info", "--fa"], ["--factors"]),
        (["precompile", "--"], ["--help", "--format", "--output"]),
        (["eval", "i", "--algebra", "'["], ["'[1,t|GF(4)(t))'"]),
        (["check", "a"], []),
        (["nonsense", ""], []),
    ],
)
def test_what_may_follow(words, offered):
    assert candidates(words) == offered


def test_at_first_all_commands(capsys):
    assert set(names()) < set(candidates([""]))
    assert main(["completion", "--words", "expo"]) == 0
    assert capsys.readouterr().out == "export\n"


def test_two_hyphens_are_the_beginning_of_an_option(capsys):
    assert main(["completion", "--words", "info", "--"]) == 0
    assert "--factors" in capsys.readouterr().out.split()


@pytest.mark.slow
@pytest.mark.parametrize("shell", SCRIPTS)
def test_the_script_is_one_the_shell_reads(capsys, shell):
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    if which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    subprocess.run([shell, "-n"], input=script, text=True, check=True, timeout=PATIENCE)


@pytest.mark.slow
def test_bash_completes(tmp_path):
    if which("bash") is None or which("hfield") is None:
        pytest.skip("bash or hfield is not on the path")
    lines = [SCRIPTS["bash"], "COMP_WORDS=(hfield explain centr)", "COMP_CWORD=2", "_hfield"]
    lines += ['echo "${COMPREPLY[@]}"']
    said = subprocess.run(
        ["bash"], input="\n".join(lines), text=True, capture_output=True, timeout=PATIENCE
    )
    assert "centre" in said.stdout.split()


@pytest.mark.parametrize(
    ("typed", "offered"),
    [("explain centr", "centre"), ("", "info"), ("verify --format ", "json"), ("check ", "file")],
)
def test_fish_offers_files_only_where_nothing_else_is_known(tmp_path, typed, offered):
    if which("fish") is None or which("hfield") is None:
        pytest.skip("fish or hfield is not on the path")
    script = f"{SCRIPTS['fish']}\ncomplete -C 'hfield {typed}'"
    (tmp_path / "file").touch()
    said = subprocess.run(
        ["fish"], input=script, text=True, capture_output=True, timeout=PATIENCE, cwd=tmp_path
    )
    words = said.stdout.split()
    assert offered in words
    assert ("file" in words) == (offered == "file")
    assert said.stderr == ""


@subcases("field", [f for f in completion.FIELDS if f != "universal"])
def test_the_fields_offered_are_fields(field):
    from hfield import ring

    assert ring(field).is_field or field == "Z"


def test_the_doctor_names_what_is_missing(capsys, monkeypatch):
    monkeypatch.setattr(doctor, "_version", lambda name: None if name == "pyarrow" else "1.0")
    monkeypatch.setattr(doctor, "which", lambda name: None)
    assert main(["doctor"]) == 0
    out = capsys.readouterr().out
    assert "pip install 'hfield[survey]'" in out
    assert "second judge" in out
    monkeypatch.setattr(doctor, "_version", lambda name: None)
    assert main(["doctor", "--format", "json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["needed"]["numpy"] is None


def test_claims_are_searched_by_their_words(capsys):
    assert main(["claims", "--search", "CENTRE", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)["claims"]
    assert "centre" in [claim["name"] for claim in found]
    assert len(found) < 30
    assert main(["claims", "--search", "no such word"]) == 0
    assert "no claim contains" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["1.4.1", "twierdzenie 3", "lemat-1", "definition 2"])
def test_numbers_of_the_thesis_name_claims(capsys, name):
    assert main(["explain", name, "--field", "GF3"]) in (0, 1)
    assert "thesis 1." in capsys.readouterr().out


PAGES = [
    ["claims"],
    ["claims", "--search", "norm"],
    ["count", "--field", "GF3"],
    ["doctor"],
    ["eval", "(1+i)*(j-k)**-1", "--field", "GF7"],
    ["explain", "C1.4.3-e"],
    ["explain", "centre"],
    ["info", "(-1,-3|QQ)"],
    ["info", "H(GF(9))"],
    ["info", "H(GF(25))"],
    ["classes", "(-1,-11|QQ)"],
    ["count", "--field", "GF9", "--formulas"],
    ["ideal", "(-1,-11|QQ)", "3, 1 + j"],
    ["order", "(-1,-11|QQ)", "--level", "9"],
    ["prove", "p*q == 0 => p == 0 or q == 0", "--field", "QQ"],
    ["prove", "p*q == q*p"],
    ["table", "--field", "GF3"],
    slow(["verify", "--field", "GF2,-"]),
    ["verify", "--section", "1.2", "--field", "GF2,QQ,universal"],
]


@pytest.mark.parametrize("words", PAGES, ids=" ".join)
def test_a_page_has_the_given_width(capsys, monkeypatch, words):
    monkeypatch.setenv("COLUMNS", "60")
    assert main(words) in (0, 1)
    assert [line for line in capsys.readouterr().out.splitlines() if len(line) > 60] == []


def test_what_is_checked_and_what_went_wrong_fits_too(capsys, monkeypatch, tmp_path):
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.chdir(tmp_path)
    statement = "norm(p) == 0 and norm(q) == 0 and p*q == 1 => p == 0 or q == 0 or p*q == q*p"
    assert main(["prove", statement, "--field", "QQ(sqrt(-7))", "--certificate", "a.json"]) == 0
    capsys.readouterr()
    long_name = "a-file-with-a-name-that-is-longer-than-the-line-is-wide-and-is-left-whole.json"
    assert main(["check", "a.json"]) == 0
    (statement_lines,) = re.findall(
        r"^  statement:.*\n(?:    .*\n)+", capsys.readouterr().out, re.M
    )
    assert max(map(len, statement_lines.splitlines())) <= 60
    assert " ".join(statement_lines.split()) == f"statement: {statement}"
    assert main(["check", long_name]) == 2
    assert capsys.readouterr().out.startswith(f"{long_name}:\n    cannot read\n")
    assert main(["info", "(-1,-1|QQ(zeta1000))", "--factors", "3"]) == 2
    assert main(["survey", "2..9", "-o", "a/long/name/of/a/file/with/another/suffix.txt"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) > 3
    assert max(map(len, lines)) <= 60


def test_the_doctor_speaks_on_the_narrowest_terminal(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "15")
    assert main(["doctor"]) == 0
    assert capsys.readouterr().err == ""


def test_latex_of_several_inputs_is_one_document(capsys):
    words = ["prove", "p*q == q*p", "norm(i) == 1", "--format", "latex"]
    assert main(words) == 1
    pieces = capsys.readouterr().out
    assert pieces.count(r"\noindent \textbf{") == 2
    assert "documentclass" not in pieces
    assert main([*words, "--standalone"]) == 1
    whole = capsys.readouterr().out
    assert pieces.strip() in whole
    for part in (r"\documentclass", r"\begin{document}", r"\end{document}"):
        assert whole.count(part) == 1
    assert whole.endswith("\\end{document}\n")
