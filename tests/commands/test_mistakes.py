"""Mistakes that people make: each is told what was wrong, what was expected, and what to write."""

import shlex

import pytest

from hfield import QuaternionAlgebra, norm
from hfield.errors import HFieldError
from tests.commands.running import run

TYPED = [
    ("prove 'for all p, q: p*q == q*p'", "write the statement without 'for'"),
    ("prove 'there is q with q*q == -1'", "write exists q: …"),
    ("prove 'if p == q then q == p'", "write h => goal"),
    ("prove 'p == q implies q == p'", "write =>"),
    ("prove 'p == q iff q == p'", "write <=>"),
    ("prove 'p == q; q == p'", "join statements by and"),
    ("prove 'p == 1/2q'", "has two readings"),
    ("prove 'sqrt(2)*p == p*sqrt(2)'", "such as QQ(sqrt(2))"),
    ("prove 'conjugate(p) == p'", "write conj"),
    ("prove 'p > 0'", "> compares scalars"),
    ("prove 'p*q'", "expected a statement such as p == q"),
    ("prove 'p*q == q*p' --field 'GF(6)'", "the nearest are GF(5) and GF(7)"),
    ("info '(-1 -1|QQ)'", "has 1 structure constant, which commas separate"),
    ("count QQ", "such as GF(9) or ZZ/6"),
    ("brandt 100003 --plot g.xyz", "ends in .svg, .png, .pdf"),
    ("brandt 100003 --plot missing/g.svg", "there is no folder"),
    ("domain 6 -o x.bmp", ".pdf, .html"),
    ("domain 6 --center i", "such as 0.1+2j"),
    ("upgrade nofile.json", "cannot read 'nofile.json': No such file or directory"),
    ("eval 2**(1/2)", "such as **3 or **(-1)"),
    ("survey 100..2", "in ascending ranges"),
]


@pytest.mark.parametrize(("line", "said"), TYPED, ids=[line for line, _ in TYPED])
def test_a_line_that_is_typed(capsys, tmp_path, monkeypatch, line, said):
    monkeypatch.chdir(tmp_path)
    status, out, err = run(capsys, *shlex.split(line))
    assert (status, out) == (2, "")
    assert said in " ".join(err.split())


def test_a_table_of_a_discriminant(capsys):
    status, out, _ = run(capsys, "table", "11")
    assert status == 0
    assert "11" in out


A = QuaternionAlgebra("QQ", -1, -11)
CALLED = [
    (lambda: A.maximal_order(5), HFieldError, "5 is no list of prime factors"),
    (lambda: A.maximal_order([4]), HFieldError, "4 was given as a prime factor"),
    (lambda: QuaternionAlgebra("QQ", -1), HFieldError, r"write QuaternionAlgebra\('QQ', -1, -1\)"),
    (lambda: A.maximal_order().class_set()[2], IndexError, "there are 2 classes, numbered from 0"),
    (lambda: A.matrix([[1, "i"]])[1, 0], IndexError, r"of shape \(1, 2\), numbered from 0"),
    (lambda: norm("i"), HFieldError, r"found 'i'; A\('i'\) makes one"),
]


@pytest.mark.parametrize(("call", "error", "said"), CALLED, ids=[said for *_, said in CALLED])
def test_a_call(call, error, said):
    with pytest.raises(error, match=said):
        call()
