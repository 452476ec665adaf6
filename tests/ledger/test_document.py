"""Ledgers in TOML: what is read, what is refused and where, and that they run like the thesis's."""

import json
from pathlib import Path

import pytest

from hfield.cli import main
from hfield.ledger.claim import NO_FIELD, PANEL, decide
from hfield.ledger.document import (
    LedgerError,
    Propositions,
    load,
    read_ledger,
    read_ledgers,
    read_title,
)
from hfield.ledger.registry import claims

ROOT = Path(__file__).parents[2]
HEAD = """
[[claims]]
id = "E1"
name = "first"
section = "1.2"
kind = "exercise"
statement = "Words"
"""
FAULTS = {
    'colour = "red"': "sheet.toml:8, claim 'E1', key 'colour': there is no such key",
    'holds = "p == "': "sheet.toml:8, claim 'E1', key 'holds': expected a number",
    'holds = "p == z1"': "sheet.toml:8, claim 'E1', key 'holds': 'z1' means nothing",
    'holds = "p == q"\ngiven = "p ="': "sheet.toml:9, claim 'E1', key 'given': ",
    'holds = "p == q"\ncorrected = ["p == p", "("]': "sheet.toml:9, claim 'E1', key 'corrected'",
    'spoilt = "p == q"': "key 'holds': it is missing",
    "holds = 3": "key 'holds': expected a text in quotes, found 3",
    "holds = []": "key 'holds': the list is empty",
    'fields = ["QQ", "GF(6)"]': "key 'fields': GF\\(6\\)",
    'fields = ["-", "QQ"]': "key 'fields': '-' is for a claim about no field",
    'algebra = "(1,2"': "key 'algebra': ",
    'algebra = "(1,2|QQ)"\nfields = "GF(3)"': "key 'fields': the algebra is over QQ",
    'headline = "yes"': "key 'headline': expected true or false",
    HEAD: "sheet.toml:10, claim 'E1', key 'id': this id comes twice",
}


def written(tmp_path: Path, text: str) -> str:
    path = tmp_path / "sheet.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("line", FAULTS)
def test_a_fault_is_named_with_its_place(line: str, tmp_path: Path) -> None:
    with pytest.raises(LedgerError, match=FAULTS[line]):
        read_ledger(written(tmp_path, HEAD + line + "\n"))


@pytest.mark.parametrize("key", ["id", "name", "section", "kind", "statement"])
def test_what_names_a_claim_may_be_left_out_and_not_empty(key: str, tmp_path: Path) -> None:
    lines = (HEAD + 'holds = "p = p"').splitlines()
    text = "\n".join(line for line in lines if not line.startswith(f"{key} "))
    (claim,) = read_ledger(written(tmp_path, text))
    made = {"id": "E1", "name": "E1", "section": "1", "kind": "claim", "statement": "p == p"}
    assert getattr(claim, key) == made[key]
    with pytest.raises(LedgerError, match=f"key '{key}': it is empty"):
        read_ledger(written(tmp_path, text + f'\n{key} = " "'))


def test_a_claim_says_something(tmp_path: Path) -> None:
    with pytest.raises(
        LedgerError, match=r"sheet.toml:4, claim 'number 2', key 'holds': it is missing"
    ):
        read_ledger(written(tmp_path, '[[claims]]\nholds = "p = p"\n\n[[claims]]\nname = "x"'))


def test_faults_of_claims_without_an_id_have_a_line(tmp_path: Path) -> None:
    with pytest.raises(LedgerError, match=r"sheet.toml:5, claim 'E2', key 'holds': "):
        read_ledger(written(tmp_path, '[[claims]]\nholds = "p = p"\n\n[[claims]]\nholds = "p = "'))


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "expected at least one table"),
        ("x = 1", "key 'x': there is no such key"),
        ("[[claims", "is not TOML"),
        ("claims = [3]", "entry 1 is not a table"),
        ('schema = "other/2"\n' + HEAD, "expected 'hfield-ledger/1'"),
    ],
)
def test_a_file_that_is_no_ledger(text: str, why: str, tmp_path: Path) -> None:
    with pytest.raises(LedgerError, match=why):
        read_ledger(written(tmp_path, text))


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(LedgerError, match="No such file"):
        read_ledger(tmp_path / "none.toml")
    (tmp_path / "raw.toml").write_bytes(b"\xff")
    with pytest.raises(LedgerError, match="UTF-8"):
        read_ledger(tmp_path / "raw.toml")
    sheet = written(tmp_path, HEAD)
    with pytest.raises(LedgerError, match="key 'id': it is in"):
        read_ledgers([sheet, sheet])


def test_what_a_claim_becomes(tmp_path: Path) -> None:
    more = 'holds = ["p*q ==\\n  q*p", "s == s"]\ngiven = "2 == 0"\nnote = """a\n  b"""\n'
    (claim,) = read_ledger(written(tmp_path, HEAD + more))
    assert (claim.id, claim.section, claim.fields, claim.note) == ("E1", "1.2", PANEL, "a b")
    assert claim.as_printed is not None
    assert claim.as_printed.statement == "every{(2 == 0) => (p*q == q*p); (2 == 0) => (s == s)}"
    (bare,) = read_ledger(written(tmp_path, HEAD + 'fields = "-"\n'))
    assert bare.fieldless
    assert not bare.checkable


def test_algebras_and_constants(tmp_path: Path) -> None:
    text = HEAD + 'algebra = "(-1,-3|QQ)"\nholds = "p*q == 0 => p == 0 or q == 0"\n'
    (claim,) = read_ledger(written(tmp_path, text))
    assert claim.fields == ("QQ",)
    assert decide(claim, "QQ").as_printed.verdict == "proved"
    text = HEAD + 'algebra = "(a,b|F)"\nholds = ["i*i == a", "i*j == -j*i"]\n'
    (claim,) = read_ledger(written(tmp_path, text))
    assert decide(claim, "GF(9)").as_printed.verdict == "proved"
    assert decide(claim, "universal").as_printed.verdict == "proved"
    (claim,) = read_ledger(written(tmp_path, HEAD + 'holds = "sqrt(2)**2 == 2"\n'))
    verdicts = {field: decide(claim, field).as_printed.verdict for field in ("RR", "GF(3)")}
    assert verdicts == {"RR": "proved", "GF(3)": "not-applicable"}


SHEET = HEAD + (
    'printed = "N"\nholds = "norm(p+q) == norm(p) + norm(q)"\n'
    'corrected = "norm(p+q) + norm(p-q) == 2*norm(p) + 2*norm(q)"\nfields = ["QQ", "GF(2)"]\n'
)


def test_verify_runs_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, SHEET)
    certificates = tmp_path / "out"
    words = [path, "--format", "json", "--certificates", str(certificates), "--jobs", "2"]
    assert main(["verify", *words]) == 0
    rows = json.loads(capsys.readouterr().out)["results"]
    assert [(r["field"], r["as_printed"], r["as_corrected"]) for r in rows] == [
        ("QQ", "refuted", "proved"),
        ("GF(2)", "proved", None),
    ]
    assert main(["check", *map(str, sorted(certificates.iterdir()))]) == 0
    capsys.readouterr()
    assert main(["verify", path, "E1", "--field", "GF(3)"]) == 0
    assert "1 claim, 1 row: 1 refuted." in capsys.readouterr().out
    assert main(["verify", path, "--section", "1"]) == 0
    assert "parallelogram" not in capsys.readouterr().out
    for words in ([path, "E9"], [path, "--section", "7"], [str(tmp_path / "no.toml")]):
        assert main(["verify", *words]) == 2
        assert capsys.readouterr().err.startswith("hfield: error: ")


def test_the_sheet_of_the_page_runs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = (ROOT / "docs" / "how-to" / "ledgers.md").read_text(encoding="utf-8")
    sheet = page.split("```toml\n")[1].split("```")[0]
    assert main(["verify", written(tmp_path, sheet)]) == 0
    out = capsys.readouterr().out
    assert "3 claims, 22 rows: 19 proved, 3 refuted." in out


def test_the_thesis_is_kept_in_documents() -> None:
    """Every claim comes from a TOML file, and Python decides only what its file leaves open."""
    files = {
        "hfield.ledger.chapter1": ["chapter1.toml"],
        "rotation.ledger": ["introduction.toml", "chapter2.toml", "chapter3_rotations.toml"],
        "anim.ledger": ["chapter3_top.toml", "chapter4.toml"],
    }
    bare = {c.id: c for package, names in files.items() for f in names for c in load(package, f)}
    assert set(bare) == {claim.id for claim in claims()}
    for claim in claims():
        for kind in ("as_printed", "spoilt", "corrected"):
            written_down = getattr(bare[claim.id], kind)
            assert written_down is None or written_down == getattr(claim, kind)
    assert {c.fields for c in claims()} == {PANEL, (NO_FIELD,)}


def test_a_proposition_without_its_claim_is_refused() -> None:
    with pytest.raises(LedgerError, match="there is no claim C9"):
        load("anim.ledger", "chapter4.toml", {"C9": Propositions()})


def test_the_title_is_what_the_file_says_or_its_name(tmp_path: Path) -> None:
    path = tmp_path / "sheet.toml"
    claim = '[[claims]]\nid = "E1"\nname = "a"\nsection = "1"\nkind = "fact"\nstatement = "s"\n'
    path.write_text(claim, encoding="utf-8")
    assert read_title(path) == "sheet"
    path.write_text('title = "Exercises,  week 3"\n' + claim, encoding="utf-8")
    assert read_title(path) == "Exercises, week 3"
    path.write_text("title = 3\n" + claim, encoding="utf-8")
    with pytest.raises(LedgerError, match=r"title.*expected a text, found int"):
        read_ledger(path)


def test_statements_may_have_the_signs_of_the_answers(tmp_path: Path) -> None:
    more = 'holds = "q·q̄ = N(q)"\ngiven = "N(q) ≠ 0"\nfields = "QQ"\n'
    (claim,) = read_ledger(written(tmp_path, HEAD + more))
    assert claim.as_printed is not None
    assert claim.as_printed.text == "norm(q) != 0 => q*conj(q) == norm(q)"
    assert decide(claim, "QQ").as_printed.verdict == "proved"


def test_a_mark_of_the_order_of_bytes_is_no_part_of_a_ledger(tmp_path):
    path = tmp_path / "sheet.toml"
    path.write_text('holds = "p == p"'.join((HEAD, "\n")), encoding="utf-8-sig")
    assert [claim.id for claim in read_ledger(path)] == ["E1"]
    assert read_title(path) == "sheet"
