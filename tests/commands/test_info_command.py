"""``hfield info``, ``count`` and ``four-squares``."""

import json
import time

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.cli import main


def run(capsys, *words):
    status = main(words)
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return status, out, err


def page(capsys, *words):
    status, out, err = run(capsys, *words)
    assert (status, err) == (0, "")
    return out


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("(-1,-3|QQ)", ["ramified at 3, inf", "discriminant 3", "12 units", "commutative no", "radical 0"]),
        ("[1,t|GF(4)(t))", ["i² = 1 + i", "ji = j + k", "ramified at no place", "M₂(GF(4)(t))"]),
        ("(0,1|GF(3))", ["radical spanned by i, k (dimension 2)", "confirmed by going through all 81"]),
        ("[1,2|GF(5))", ["isomorphic to (0,2|GF(5)), with 4 + 2i for i", "zero norm N(4 + 2i) = 0"]),
        ("[1,2|QQ)", ["isomorphic to (5,2|QQ), with −1 + 2i for i", "infinitely many units"]),
        ("(-1,-1|QQ(sqrt(-7)))", ["(2, sqrt(-7)-1), (2, sqrt(-7)-3)", "level 4, because"]),
        ("(x,x+1|QQ(x))", ["ramified at x+1, inf", "division algebra yes"]),
        ("H(GF(9))", ["norm 0 801 q^3+q^2-q", "modulus x^2+2*x+2 (Conway)", "Hamilton's quaternions"]),
        ("(-1,-1|GF(2))", ["commutative yes", "centre spanned by e, i, j, k (dimension 4)"]),
        ("(-1,-1|ZZ)", ["ZZ is not a field", "only 0 has norm 0"]),
        ("(1,2|RDF)", ["division algebra undecided: RDF is inexact", "nothing is proved"]),
        ("(2,3|ZZ/6)", ["centre undecided", "confirmed by going through all 1296 elements"]),
        ("(sqrt(2),pi|RR)", ["i ↦ [root(2,4), 0; 0, −root(2,4)]"]),
        ("[x,t,x|GF(4)(t))", ["isomorphic to [x+1,t|GF(4)(t)), with (x+1)i for i", "ramified at t, inf"]),
    ],
)  # fmt: skip
def test_pages(capsys, text, lines):
    out = " ".join(page(capsys, "info", text).split())
    for line in lines:
        assert line in out


def test_factors_that_are_known_spare_the_factorisation(capsys):
    p, q = 10**60 + 7, 10**61 + 93  # 3 and 1 modulo 4
    data = json.loads(
        page(capsys, "info", f"(-1,{p * q}|QQ)", "--format", "json", "--factors", f"{p}, {q}")
    )
    assert data["ramified_places"] == [2, p]
    assert data["division"] is True
    assert data["discriminant"] == 2 * p
    text = page(capsys, "info", f"(-1,{p * q}|QQ)", "--factors", f"{p},{q}")
    assert max(map(len, text.splitlines())) <= 100
    assert "The table is wider than this page" in text
    status, _, err = run(capsys, "info", "(-1,15|QQ)", "--factors", "3;5")
    assert status == 2
    assert "expected primes such as 3,5,1000003" in err
    assert "4 was given as a prime factor" in run(capsys, "info", "(-1,12|QQ)", "--factors", "4")[2]


def test_what_cannot_be_factored_is_undecided_and_the_page_is_printed(capsys):
    n = -(10**60 + 7) * (10**61 + 9)
    out = page(capsys, "info", f"({n},3|QQ)")
    assert "ramified at      undecided" in out
    data = json.loads(page(capsys, "info", f"({n},3|QQ)", "--format", "json"))
    assert data["ramified_places"] is None
    assert data["division"] is None
    assert {"ramified_places", "division"} <= set(data["undecided"])
    assert data["central_simple"] is True


def test_json_is_read_back(capsys):
    data = json.loads(page(capsys, "info", "(t,t+1|GF(5)(t))", "--format", "json"))
    assert data["schema"] == "hfield-info/1"
    A = QuaternionAlgebra.from_text(data["algebra"])
    F = ring(data["field"])
    q = A(*data["zero_norm_element"])
    assert F.is_zero(q.norm())
    assert data["division"] is False
    (a, b), (c, d) = [[F(x) for x in row] for row in data["splitting"]["i"]]
    assert F.equal(a * d - b * c, A.basis[1].norm())
    assert data["ramified_places"] == []
    finite = json.loads(page(capsys, "info", "H(GF(3))", "--format", "json"))
    assert finite["counts"]["confirmed_on"] == 81
    rational = json.loads(page(capsys, "info", "(-1,-3|QQ)", "--format", "json"))
    assert (rational["ramified_places"], rational["discriminant"]) == ([3, "inf"], 3)
    assert rational["maximal_order"]["units"] == 12
    assert rational["level"] == "inf"


def test_info_goes_to_a_file_and_refuses_what_is_no_algebra(capsys, tmp_path):
    target = tmp_path / "page.txt"
    assert page(capsys, "info", "(-1,-3|QQ)", "-o", str(target)) == ""
    assert target.read_text(encoding="utf-8").startswith("(-1,-3|QQ)\n")
    for words in (["info", "QQ"], ["info", "(1|QQ)"], ["info", "(1,x|QQ)"], ["info"]):
        status, out, err = run(capsys, *words)
        assert (status, out) == (2, "")
        assert err.startswith("hfield: error: ")
        assert err.count("\n") == 1


def test_counts(capsys):
    out = page(capsys, "count", "--field", "GF(9)")
    assert " ".join(out.split()).startswith("(-1,-1|GF(9)), q = 9 elements 6561 q^4 units 5760")
    assert "confirmed by going through all 6561 elements" in out
    assert "by the formulas" in page(capsys, "count", "--field", "GF(9)", "--formulas")
    assert "by the formulas" in page(capsys, "count", "--field", "GF(1000003)")
    squares = " ".join(page(capsys, "count", "--algebra", "(0,0|GF(5))").split())
    assert "each norm n a square ≠ 0 250 2*q^3 each norm n not a square 0 0" in squares
    data = json.loads(page(capsys, "count", "--field", "GF(4)", "--format", "json"))
    assert data["counts"][2] == {"what": "norm 0", "count": 64, "formula": "q^3"}
    assert data["confirmed_on"] == 256
    status, _, err = run(capsys, "count", "--field", "QQ")
    assert status == 2
    assert "not a finite field" in err


def test_counts_for_every_field_up_to_32_in_time(capsys):
    start = time.perf_counter()
    for q in (2, 3, 4, 5, 7, 8, 9, 11, 13, 16, 17, 19, 23, 25, 27, 29, 31, 32):
        assert f"going through all {q**4} elements" in page(capsys, "count", "--field", f"GF({q})")
    assert time.perf_counter() - start < 20


def test_four_squares(capsys):
    assert page(capsys, "four-squares", "7") == "7 = 2^2 + 1^2 + 1^2 + 1^2\n"
    assert page(capsys, "four-squares", "0", "--format", "unicode") == "0 = 0² + 0² + 0² + 0²\n"
    start = time.perf_counter()
    data = json.loads(page(capsys, "four-squares", "10**60+7", "--format", "json"))
    assert time.perf_counter() - start < 3
    assert sum(x * x for x in data["squares"]) == data["n"] == 10**60 + 7
    for wrong, message in (
        ("-1", "≥ 0"),
        ("2.5", "not an integer"),
        ("x", "ZZ"),
        ("10**600", "digits"),
    ):
        status, out, err = run(capsys, "four-squares", wrong)
        assert (status, out) == (2, "")
        assert message in err
