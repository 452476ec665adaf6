"""Whatever is typed or read from a file, a command ends with a status and at most one line of error."""

import io
import json
from contextlib import redirect_stderr, redirect_stdout

import pytest

from hfield.cli import main
from tests.subcases import subcases

STATEMENTS = [
    *("", " ", "\x00", "\ud800", "p" * 20_001, "(" * 500 + "p" + ")" * 500, "-" * 3_000 + "p == p"),
    *(
        "p" + "*p" * 5_000 + " == 0",
        "s**99999999999 == s",
        "s**(10**9) == s",
        "s**65537 == s",
        "s**-0 == 1",
    ),
    *(
        "norm(" * 90 + "q" + ")" * 90 + " == 0",
        "q" + "²" * 20_000 + " == 0",
        "ｐ == 0",
        "s == ٣",
        "s == ²",
        "p == q\u2028 or 1 == 1",
        "½ == s",
    ),
    *(
        "1e999999999 == s",
        "0.1e-999999 == s",
        "9" * 4_001 + " == s",
        "1/0 == 1/0",
        "q[4] == 0",
        "q[-1] == 0",
    ),
    *(
        "exists : q == 0",
        "exists q,q: q == 0",
        "exists e: e == 0",
        "not",
        "== ==",
        "p == q == r",
        "=> =>",
    ),
    *(
        "sqrt(10**400) == s",
        "root(2,10**9) == s",
        "inv(0) == e",
        "comm(p) == 0",
        "norm(p,q) == 0",
        "pi == s",
    ),
    *(
        "__import__('os')",
        "lambda: 0",
        "s == s" + " " * 100_000,
        "s == s # c",
        "s==s\n\n",
        "s == 1_000",
    ),
    *(
        "0x10 == s",
        "1j == s",
        "p@q == 0",
        "{s} == s",
        "s if s else s",
        "not " * 300 + "s == s",
        "~s == s",
    ),
    *(
        "s <=> s <=> s",
        "2**2**2 == s",
        "s ** 1.0 == s",
        "(p+q)**60 == 0",
        "(p+q+r+u+v+w)**12 == 0",
        "s ≠ s",
    ),
]
FIELDS = [
    *(
        "",
        "GF(6)",
        "GF(10**100)",
        "GF(" + "9" * 5_000 + ")",
        "GF(2^100000)",
        "GF(2^127-1)",
        "GF(4,x^2)",
    ),
    *(
        "GF(3317044064679887385961981)",
        "GF(9," + "x+" * 3_000 + "1)",
        "QQ(sqrt(8))",
        "QQ(sqrt(" + "7" * 60 + "))",
    ),
    *(
        "QQ(sqrt(-1))",
        "QQ(e)",
        "QQ(" + "x" * 5_000 + ")",
        "ZZ/0",
        "ZZ/1",
        "ZZ/" + "9" * 4_000,
        "ZZ[a,a]",
    ),
    *(
        "QQ(x)(y)(z)",
        "GF(٣)",
        "GF(½)",
        "\ud800",
        "GF(2)(T1)",
        "QQ(p)",
        "GF(-3)",
        "GF(2.0)",
        "GF(2",
        "(((((",
        "F",
    ),
]
ALGEBRAS = [
    *(
        "(1/0,-1|QQ)",
        "(" + "a*" * 300 + "a,1|F)",
        "(-1,-1|",
        "-1,-1",
        "(q,1|QQ)",
        "(1,2,3|QQ)",
        "(s t,1|QQ)",
    ),
    *(
        "(|)",
        "(,|QQ)",
        "(1/(a-a),1|F)",
        "(" + "9" * 300 + ",1|QQ)",
        "(-1,-1|GF(6))",
        "(-1,-1|\ud800)",
    ),
    *(
        "((((,1|QQ)",
        "(1,1|QQ))",
        "(a==a,1|QQ)",
        "(exists a: a,1|QQ)",
        "(10**100000,1|QQ)",
        "(2**(10**9),1|QQ)",
    ),
]


def ends_well(*words: str) -> None:
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        status = main(words)
    assert status in (0, 1, 2, 3)
    if status == 2:
        assert err.getvalue().count("\n") <= 1
        assert len(err.getvalue()) < 1_200
    assert "Traceback" not in out.getvalue() + err.getvalue()
    (out.getvalue() + err.getvalue()).encode()


@pytest.mark.slow
@subcases("text", STATEMENTS)
def test_statements_and_terms(text: str) -> None:
    ends_well("prove", text, "--timeout", "1")
    ends_well("prove", text, "--timeout", "1", "--field", "GF(3)")
    ends_well("eval", text, "--field", "RR")


@pytest.mark.slow
@subcases("name", FIELDS)
def test_fields(name: str) -> None:
    ends_well("prove", "p*q == q*p", f"--field={name}", "--timeout", "1")
    ends_well("eval", "i*j", f"--field={name}")
    ends_well("info", f"(-1,-1|{name})")


@pytest.mark.slow
@subcases("name", ALGEBRAS)
def test_algebras(name: str) -> None:
    ends_well("prove", "norm(q) == 0 => q == 0", f"--algebra={name}", "--timeout", "1")
    ends_well("info", name)


def hostile_files() -> list[str]:
    good = {
        "schema": "hfield-cert/2",
        "statement": "p*(q + r) == p*q + p*r",
        "algebra": "(-1,-1|QQ)",
        "field": "QQ",
        "ring": {"kind": "rationals"},
        "verdict": "proved",
        "method": "identity",
        "assumes": [],
        "evidence": {"kind": "identity"},
    }
    changed = [
        json.dumps({**good, key: value})
        for key in good
        for value in (
            None,
            True,
            0,
            1e3,
            "",
            "\ud800",
            "\x00",
            [],
            {},
            [[]],
            "p" * 30_000,
            10**4000,
        )
    ]
    text = json.dumps(good)
    return [
        *changed,
        *("", "null", "[]", "{", '"', "NaN", "1e999", "9" * 5_000, "[" * 100_000, '{"a":' * 50_000),
        *(
            text + text,
            text[:-1],
            "\ufeff" + text,
            text.replace("}", ',"x":1}'),
            text.replace(":", " "),
        ),
        text.replace('"QQ"', '"QQ", "field": "GF(3)"'),
        text.replace("rationals", "rationals\ud800"),
        text.replace('"rationals"', '"rationals", "n": ' + "9" * 4_000),
        json.dumps({**good, "schema": "hfield-cert/1"}),
        '"' + '\\"' * 2_000,
    ]


def test_files(tmp_path) -> None:
    path = tmp_path / "certificate.json"
    for text in hostile_files():
        path.write_text(text, encoding="utf-8", errors="surrogatepass")
        ends_well("check", str(path))
    path.write_bytes(b"\xff\xfe\x00")
    ends_well("check", str(path))
    ends_well("check", str(tmp_path))
    ends_well("check", str(tmp_path / "missing\ud800.json"))
