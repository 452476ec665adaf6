"""Whatever is typed, the answer is a result or one line that says what was wrong."""

import io
import json
from contextlib import redirect_stderr, redirect_stdout

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hfield.cli import main
from tests.thorough import cases

FIELDS = [
    "QQ",
    "ZZ",
    "ZZ/6",
    "GF(7)",
    "GF(4)",
    "GF(9, x^2+1)",
    "QQ(x)",
    "GF(2)(t)",
    "ZZ[a,b]",
    "RDF",
]
WORDS = """e i j k x t a 0 1 2 3 7 1/2 0.5 1e3 10**3 **2 **-1 ** ^ + - * / ( ) [ ] [0] , = == != =>
conj( norm( inv( comm( sqrt( not and or exists: p q __ . ' " \\ é √ ½ ² ∞ nan inf"""
TOKENS = [*WORDS.split(), " ", "\x00"]
NAMES = ["QQ", "ZZ", "GF", "(", ")", "[", "]", ",", "/", "^", "*", "+", "-", "x", "I", "sqrt", "0"]
NAMES += [
    "1",
    "2",
    "4",
    "9",
    "6",
    "-7",
    "RR",
    "CC",
    "RDF",
    "t",
    "|",
    "universal",
    " ",
    "e",
    "²",
    "é",
]


def answer(*words):
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        status = main(words)
    return status, out.getvalue(), err.getvalue()


def check(*words):
    status, out, err = answer(*words)
    assert status in (0, 2), (words, err)
    if status == 2:
        assert out == ""
        assert err.startswith("hfield: error: ")
        assert err.count("\n") == 1
        assert len(err) < 1000
    else:
        assert err == ""
    return status, out


@settings(deadline=None, max_examples=cases(500))
@given(st.lists(st.sampled_from(TOKENS), max_size=12).map("".join), st.sampled_from(FIELDS))
def test_eval_of_anything(text, field):
    status, out = check("eval", "--field", field, "--", text)
    if status == 0 and field != "RDF":
        assert check("eval", "--field", field, "--", out.strip()) == (0, out)


@settings(deadline=None, max_examples=cases(500))
@given(st.lists(st.sampled_from(NAMES), max_size=8).map("".join))
def test_any_field(text):
    check("eval", "i*j", f"--field={text}")


@settings(deadline=None, max_examples=cases(400))
@given(st.lists(st.sampled_from(NAMES), max_size=8).map("".join), st.sampled_from(["()", "[)"]))
def test_any_algebra(text, brackets):
    check("eval", "i*j", f"--algebra={brackets[0]}{text}|GF(4){brackets[1]}")


TERMS = ["p", "q", "i", "s", "2", "p*q", "q+i", "conj(q)", "norm(p)", "q[1]", "inv(q)", "s/2", "x"]
FACTS = st.builds("{} {} {}".format, *(st.sampled_from(x) for x in (TERMS, ["==", "!="], TERMS)))
LINKS = ["and", "or", "=>", "<=>", "=> not", ") and ("]


@settings(deadline=None, max_examples=60)
@given(FACTS, st.sampled_from(LINKS), FACTS, st.sampled_from([*FIELDS, None]))
def test_prove_anything(first, link, second, field):
    words = ["prove", f"({first} {link} {second})", "--timeout", "1", "--format", "json"]
    status, out, err = answer(*words, *([] if field is None else ["--field", field]))
    assert status in (0, 1, 2, 3), (words, err)
    if status == 2:
        assert err.startswith("hfield: error: ")
        assert err.count("\n") == 1
    else:
        data = json.loads(out)
        wanted = {"proved": 0, "vacuous": 0, "refuted": 1, "undecided": 3, "not-applicable": 3}
        assert wanted[data["verdict"]] == status


@pytest.mark.slow
@settings(deadline=None, max_examples=cases(250))
@given(st.lists(st.text(max_size=8), max_size=4))
def test_any_words(words):
    given = [word for word in words if not word.startswith(("-o", "--out"))]
    if len(given) < 2:
        check("eval", *given)
        return
    status, out, err = answer(
        "eval", *given
    )  # each text has an answer, or a line that says why not
    assert status in (0, 2), err
    lines = err.splitlines()
    assert (status == 2) == bool(lines)
    assert len(lines) + out.count("\n") <= len(given)
    for line in lines:
        assert line.startswith("hfield: error: ")
        assert len(line) < 1000
