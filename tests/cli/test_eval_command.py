"""``hfield eval`` and ``hfield table``: results in four formats, and bad input of every kind."""

import json

import pytest

from hfield.cli import main
from tests.cli.running import run


def evaluate(capsys, *words):
    status, out, err = run(capsys, "eval", *words)
    assert (status, err) == (0, "")
    return out.rstrip("\n")


@pytest.mark.parametrize(
    ("words", "value"),
    [
        (["i*j"], "k"),
        (["-i*j"], "-k"),
        (["-1*i", "--field", "QQ"], "-i"),
        (["--field", "QQ", "-1"], "-1"),
        (["--field=GF(7)", "-(1+i)**-1*2"], "6 + i"),
        (["(1+i)*(j-k)**-1", "--field", "GF(7)"], "6*j"),
        (["(1+i)*(j-k)**-1", "--field", "GF7"], "6*j"),
        (["1/2*i + 3.5", "--field", "Q"], "7/2 + 1/2*i"),
        (["norm(1+i+j)"], "3"),
        (["(1+i+j)[2]"], "1"),
        (["conj(i)*trace(3+j) − comm(i,j)"], "-6*i - 2*k"),
        (["i**2", "--algebra", "(-1/2,-3|QQ)"], "-1/2"),
        (["j**2", "--algebra", "(-1/2,-3|QQ)"], "-3"),
        (["x*x", "--field", "GF(9, x^2+1)"], "2"),
        (["i*i + i", "--algebra", "[1,x|GF(4))"], "1"),
        (["0"], "0"),
        (["i**0"], "1"),
        (["i**999"], "-i"),
    ],
)
def test_values(capsys, words, value):
    assert evaluate(capsys, *words) == value


def test_what_is_printed_reads_back(capsys):
    value = evaluate(capsys, "(1+2*i-j/3)**5 * k")
    assert evaluate(capsys, value) == value


def test_formats(capsys):
    expression = "1/2 - 3*i"
    assert evaluate(capsys, expression, "--format", "unicode") == "1/2 − 3i"
    assert r"\frac" in evaluate(capsys, expression, "--format", "latex")
    assert json.loads(evaluate(capsys, expression, "--format", "json")) == {
        "schema": "hfield-eval/1",
        "expression": expression,
        "algebra": "(-1,-1|QQ)",
        "field": "QQ",
        "value": "1/2 - 3*i",
        "coordinates": ["1/2", "-3", "0", "0"],
    }


def test_output_file(capsys, tmp_path):
    target = tmp_path / "value.txt"
    assert evaluate(capsys, "i*j", "-o", str(target)) == ""
    assert target.read_text(encoding="utf-8") == "k\n"


DEEP = "(" * 5000 + "i" + ")" * 5000
BAD = [
    (["(1+i"], "at character 5"),
    (["1 +* i"], "at character 4"),
    (["i $ j"], "$"),
    (["|i|"], "norm(q)"),
    (["∀i"], "without a sign"),
    (["forall p"], "without 'forall'"),
    ([""], "empty"),
    (["  "], "empty"),
    (["a*i"], "'a' means nothing"),
    (["x", "--field", "QQ"], "'x' means nothing"),
    (["__import__('os')"], "cannot read"),
    (["__import__(os)"], "no function '__import__'"),
    (["i.__class__"], "'.'"),
    (["i == j"], "found a statement"),
    (["norm(i,j)"], "norm"),
    (["i**j"], "integer literal"),
    (["i**(10**12)"], "exponent"),
    (["i**1000000000000"], "too large"),
    (["((1+i)**9999)**9999"], "too large"),
    (["9" * 5000], "digits"),
    ([DEEP], "nests"),
    (["-" * 5000 + "i"], "nests"),
    (["+".join(["i"] * 5000)], "in parts"),
    (["1/0"], "cannot invert 0"),
    (["i/0", "--field", "GF(9)"], "cannot invert 0"),
    (["inv(i-i)"], "cannot invert 0"),
    (["1/7", "--field", "GF(7)"], "7"),
    (["1/(2+3*i+j)", "--field", "GF7"], "q·y = 0 for y = "),
    (["(1+i)**-1", "--field", "GF(2)"], "q·y = 0 for y = "),
    (["1/2", "--field", "ZZ"], "2"),
    (["1/(2*i)", "--field", "ZZ/6"], "y = "),
    (["i", "--field", "GF(6)"], "GF(6)"),
    (["i", "--field", "GF(0)"], "0"),
    (["i", "--field", "GF(4, x^2)"], "irreducible"),
    (["i", "--field", "QQ(sqrt(4))"], "sqrt(4)"),
    (["i", "--field", "universal"], "universal"),
    (["i", "--field", "-"], "-"),
    (["i", "--algebra", "(1,2|QQ"], "not an algebra"),
    (["i", "--algebra", "(1|QQ)"], "structure constant"),
    (["i", "--algebra", "(y,1|QQ)"], "y"),
    (["i", "--algebra", ""], "not an algebra"),
    (["nan", "--field", "RDF"], "nan"),
    (["1e999*i", "--field", "RDF"], ""),
    (["i", "-o", "/no/such/dir/file"], "/no/such/dir/file"),
]


@pytest.mark.parametrize(("words", "hint"), BAD, ids=[str(n) for n in range(len(BAD))])
def test_bad_input_is_one_line(capsys, words, hint):
    status, out, err = run(capsys, "eval", *words)
    assert (status, out) == (2, "")
    assert err.startswith("hfield: error: ")
    assert err.count("\n") == 1
    assert len(err) < 600
    assert hint in err


def test_the_zero_divisor_named_is_one(capsys):
    _, _, err = run(capsys, "eval", "1/(2+3*i+j)", "--field", "GF7")
    y = err.strip().partition("q·y = 0 for y = ")[2]
    assert evaluate(capsys, f"(2+3*i+j)*({y})", "--field", "GF7") == "0"
    assert evaluate(capsys, y, "--field", "GF7") != "0"


# --- the table ---------------------------------------------------------------------------------


def test_table_plain(capsys):
    status, out, err = run(capsys, "table", "--field", "QQ")
    assert (status, err) == (0, "")
    rows = [line.replace("|", " ").split() for line in out.splitlines() if "-+-" not in line]
    assert rows == [
        ["*", "e", "i", "j", "k"],
        ["e", "e", "i", "j", "k"],
        ["i", "i", "-e", "k", "-j"],
        ["j", "j", "-k", "-e", "i"],
        ["k", "k", "j", "-i", "-e"],
    ]


def test_the_algebra_may_come_first(capsys):
    assert main(["table", "[1,x|GF(4))"]) == 0
    first = capsys.readouterr().out
    assert main(["table", "--algebra", "[1,x|GF(4))"]) == 0
    assert capsys.readouterr().out == first != ""
    assert main(["table", "GF9", "--field", "GF4"]) == 2


def test_table_json(capsys):
    _, out, _ = run(capsys, "table", "--algebra", "(-1,-3|QQ)", "--format", "json")
    data = json.loads(out)
    assert data["schema"] == "hfield-table/1"
    assert (data["algebra"], data["field"]) == ("(-1,-3|QQ)", "QQ")
    assert data["basis"] == ["e", "i", "j", "k"]
    assert data["table"][2] == ["j", "-k", "-3*e", "3*i"]


def test_table_unicode_and_latex(capsys):
    assert "−k" in run(capsys, "table", "--format", "unicode")[1]
    assert r"\begin{array}" in run(capsys, "table", "--format", "latex")[1]


def test_in_characteristic_two_the_table_is_symmetric(capsys):
    data = json.loads(run(capsys, "table", "--field", "GF4", "--format", "json")[1])
    table = data["table"]
    assert table == [list(column) for column in zip(*table, strict=True)]


@pytest.mark.parametrize(
    "words", [["--field", "GF(6)"], ["--algebra", "nonsense"], ["-o", "/no/x"]]
)
def test_table_refuses(capsys, words):
    status, out, err = run(capsys, "table", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
