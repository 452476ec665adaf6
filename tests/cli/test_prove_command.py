"""``hfield prove``: verdicts, exit status, formats, certificates, bad input."""

import json

import pytest

from hfield.syntax import parse
from tests.cli import running


def run(capsys, *words):
    return running.run(capsys, "prove", *words)


def answer(capsys, *words):
    status, out, _ = run(capsys, *words, "--format", "json")
    return status, json.loads(out)


@pytest.mark.parametrize(
    ("words", "status", "verdict"),
    [
        (["(p*q)*r == p*(q*r)"], 0, "proved"),
        (["p*q == q*p"], 1, "refuted"),
        (["p*q == q*p", "--field", "GF(4)"], 0, "proved"),
        (["p*q == q*p", "--field", "Q"], 1, "refuted"),
        (["q*inv(q) == e", "--given", "norm(q) != 0"], 0, "proved"),
        (["q*inv(q) == e", "--field", "QQ"], 1, "refuted"),
        (["i*i == -3*e", "--algebra", "(-3,1|QQ)"], 0, "proved"),
        (
            ["norm(q) == q[0]**2 - a*q[1]**2 - b*q[2]**2 + a*b*q[3]**2", "--algebra", "(a,b|F)"],
            0,
            "proved",
        ),
        (["-q == q", "--field", "GF2"], 0, "proved"),
        (["-q + q == 0"], 0, "proved"),
        (["-i*j == -k", "--given", "-q == q"], 0, "proved"),
    ],
)
def test_verdicts(capsys, words, status, verdict):
    code, data = answer(capsys, *words)
    assert (code, data["verdict"]) == (status, verdict)


def test_json_is_as_fixed(capsys):
    status, data = answer(capsys, "p*q == q*p", "--field", "QQ")
    assert status == 1
    assert data == {
        "schema": "hfield-prove/1",
        "statement": "p*q == q*p",
        "algebra": "(-1,-1|QQ)",
        "field": "QQ",
        "verdict": "refuted",
        "scope": "characteristics [2]",
        "method": "identity",
        "witness": {"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "0"]},
        "assumes": [],
        "tried": [],
        "certificate": None,
    }


def test_the_statement_is_quoted_as_it_was_typed(capsys):
    assert answer(capsys, " (p*q)*r==p*(q*r) ")[1]["statement"] == "(p*q)*r==p*(q*r)"
    _, data = answer(capsys, "p == q", "--given", "p == r => q == r", "--given", "norm(p) == 1")
    assert parse(data["statement"]) == parse("(p == r => q == r) => norm(p) == 1 => p == q")


def test_without_a_field(capsys):
    _, data = answer(capsys, "p*q == q*p")
    assert data["field"] is None


def test_plain_and_latex(capsys):
    _, out, _ = run(capsys, "p*q == q*p", "--field", "QQ")
    for text in ("(-1,-1|QQ)", "refuted", "in characteristic 2", "p = i, q = j"):
        assert text in out
    assert "p·q = k ≠ −k = q·p" in out
    assert r"p \cdot q" in run(capsys, "p*q == q*p", "--format", "latex")[1]


def test_a_certificate_is_written(capsys, tmp_path):
    target = tmp_path / "proof.json"
    words = ("(p*q)*r == p*(q*r)", "--certificate", str(target))
    status, data = answer(capsys, *words)
    assert (status, data["certificate"]) == (0, str(target))
    certificate = json.loads(target.read_text("utf-8"))
    keys = {"schema", "statement", "algebra", "field", "ring", "verdict", "method", "assumes"}
    assert set(certificate) == {*keys, "evidence"}
    assert certificate["schema"] == "hfield-cert/2"


def test_equality_may_be_written_as_it_is_printed(capsys):
    assert run(capsys, "p*q = q*p") == run(capsys, "p*q == q*p")


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ([], "STATEMENT"),
        (["p*q"], "statement"),
        (["p == q", "--field", "GF(6)"], "GF(6)"),
        (["p == q", "--algebra", "nonsense"], "not an algebra"),
        (["p == q", "--algebra", "(1,1|QQ)", "--field", "RR"], "RR"),
        (["o == q"], "'o'"),
        (["p == q", "--given", "p"], "p"),
        (["p == q", "--timeout", "0"], "--timeout"),
        (["p == q", "--timeout", "nan"], "--timeout"),
        (["p == q", "--timeout", "-1"], "--timeout"),
        (["p == q", "--certificate", "/no/such/file"], "/no/such/file"),
        (["p == q", "--certificate", ""], "empty"),
        (["p == q", "-o", "/no/such/file"], "/no/such/file"),
        (["__import__('os') == q"], "cannot read"),
    ],
)
def test_bad_input(capsys, words, hint):
    status, out, err = run(capsys, *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert err.startswith("hfield: error: ")
    assert hint in err
