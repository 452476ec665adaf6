"""``hfield claims`` and ``hfield explain`` on a fake ledger."""

import json

import pytest


def test_claims_lists_all(run):
    status, out, err = run("claims")
    assert (status, err) == (0, "")
    for text in (
        "C1-a",
        "slip",
        "formula",
        "A slip of the pen",
        "Section 1.10",
        "Hamilton was Irish",
    ):
        assert text in out
    assert max(map(len, out.splitlines())) <= 100
    starred = [line for line in out.splitlines() if line.startswith("*")]
    assert len(starred) == 1
    assert "C1-a" in starred[0]


def test_claims_of_a_section(run):
    _, out, _ = run("claims", "--section", "1.1", "--format", "json")
    data = json.loads(out)
    assert data["schema"] == "hfield-claims/1"
    assert [c["id"] for c in data["claims"]] == ["C1.1-a", "C1.1-b"]
    first = data["claims"][0]
    assert (first["name"], first["section"], first["kind"]) == ("slip", "1.1", "formula")
    assert first["statement"] == "A slip of the pen"
    assert first["checkable"] is True


def test_claims_as_markdown_in_a_file(run, tmp_path):
    target = tmp_path / "claims.md"
    assert run("claims", "--format", "markdown", "-o", str(target)) == (0, "", "")
    assert "| C1.10-a | history | remark | Hamilton was Irish |" in target.read_text("utf-8")


@pytest.mark.parametrize(
    "words", [["--section", "9"], ["C1-a"], ["--format", "plain"], ["-o", "/no/x"]]
)
def test_claims_refuses(run, words):
    status, out, err = run("claims", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)


def test_explain_shows_the_whole_decision(run):
    status, out, err = run("explain", "slip", "--field", "GF9")
    assert (status, err) == (0, "")
    for text in (
        "C1.1-a  slip",
        "thesis 1.1, formula; over GF(9)",
        "A slip of the pen",
        "q₁q₂ = q₂q₁ √",
        "p·q = q·p",
        "The factors are swapped.",
        "✗ refuted  (by identity)",
        "        1. p·q ≠ q·p",
        "p = i, q = j + k",
        "there       p·q = 2j + k ≠ j + 2k = q·p",
        "p·q − q·p = [p, q]",
        "✓ proved  (by identity, over all fields)",
        "All coefficients vanish.",
    ):
        assert text in out
    assert max(map(len, out.splitlines())) <= 100


def test_explain_json(run):
    data = json.loads(run("explain", "C1.1-a", "--field", "universal", "--format", "json")[1])
    assert data["schema"] == "hfield-explain/1"
    assert (data["id"], data["field"]) == ("C1.1-a", "universal")
    printed, corrected = data["as_printed"], data["as_corrected"]
    assert (printed["verdict"], corrected["verdict"]) == ("refuted", "proved")
    assert printed["witness"]["p"] == ["0", "1", "0", "0"]
    assert corrected["steps"] == ["All coefficients vanish."]
    assert json.loads(run("explain", "table", "--format", "json")[1])["as_corrected"] is None


def test_explain_latex(run):
    _, out, _ = run("explain", "slip", "--field", "GF(9)", "--format", "latex")
    assert r"p \cdot q = q \cdot p" in out
    for part in (
        r"\textbf{Refuted} over $\mathbb{F}_{9}$",
        r"$p = i, q = j + k$",
        r"\begin{enumerate}",
    ):
        assert part in out
    assert out.isascii()


def test_explain_without_a_field(run):
    assert "over QQ" in run("explain", "table")[1]
    assert "about no field" in run("explain", "average")[1]
    _, out, _ = run("explain", "history")
    assert "not applicable" in out
    assert "History." in out


def test_explain_says_what_was_tried(broken):
    status, out, _ = broken("explain", "hard")
    assert status == 1
    assert "undecided" in out
    assert "a million terms" in out


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ([], "CLAIM"),
        (["slpi"], "slip"),
        (["slip", "--field", "GF(6)"], "GF(6)"),
        (["slip", "--field", "QQ,RR"], "one decision"),
        (["slip", "--field", "-"], "C1.1-a"),
        (["slip", "--filed", "QQ"], "--field"),
        (["slip", "-o", "/no/such/file"], "/no/such/file"),
    ],
)
def test_explain_refuses(run, words, hint):
    status, out, err = run("explain", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert hint in err
