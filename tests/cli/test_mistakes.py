"""Mistakes that people make: each message says what was wrong, what was expected, and what to write."""

import re
import runpy
import shlex
from pathlib import Path

import numpy as np
import pytest

import hfield
from hfield import H, QuaternionAlgebra, norm, ring
from hfield.cli.commands.survey import Columns
from hfield.errors import CoercionError, HFieldError, RingError
from hfield.hints import CALLS
from tests.cli.running import run

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
    ("eval \"'i*j'\"", "use double quotes"),
    ("domain 6 d.svg", "write -o d.svg"),
    ("render top.mp4", "write hfield render -o top.mp4"),
    ("hilbert 2 5 5", "write hfield eval 'hilbert(2,5,5)'"),
    ("list units GF3", "write hfield list GF3 units"),
    ("field x^3-2", "QQ[x]/(x^3-2)"),
    ("info H", "H(RR) for Hamilton's"),
    ("info '(-1,-1|F)'", "name the field"),
    ("info QQ -f GF7", "this command has no --field"),
    ("eval i --field 'H(GF(7))'", "--algebra takes an algebra"),
    ("eval GF7", "GF7 is a ring: expected EXPR before it"),
    ("eval (1+i)²⁻¹", "²⁻¹ is not an integer"),
    ("prove p*q == q*p", "quote it, as in 'p*q == q*p'"),
    ("prove 'tr p == 2'", "write tr(p)"),
    ("prove 'i^2 = -1, j^2 = -1'", "join statements by and"),
    ("prove 'pp* = N(p)'", "found '='; the conjugate of q is conj(q)"),
    ("prove 'p ≠ ≠ q'", "found '≠'"),
    ("prove 'i^2 = j^2 = -1 +'", "after '+' (at character 16"),
    ("prove 'p = q ='", "after '=' (at character 7"),
    (r"prove '\langle p, q\rangle = 0'", r"'\\langle': this command of LaTeX is not known"),
    ("embed 6 -- -24 --all", "write it before the --"),
    ("version", "write hfield --version"),
    ("eval 'hilbert(2,5)'", "two elements of the field and a place"),
    ("eval 'hilbert(2,5,4)'", "not a place of QQ"),
    ("order 6 --units", "is indefinite"),
    (
        "eval i --field 'QQ(sqrt(10000000000000000000000000000603000000000000000000000000001881))'",
        "factoring it failed",
    ),
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
    (lambda: A.maximal_order(5), HFieldError, "5 is not a list of prime factors"),
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


@pytest.mark.parametrize(
    ("line", "plain"),
    [
        ("roots 'x^2+1' GF7", "roots 'x^2+1' --field GF7"),
        ("prove 'p*q == q*p' GF4", "prove 'p*q == q*p' --field GF4"),
        ("eval 'i^2' '(-2,3|QQ)'", "eval 'i^2' --algebra '(-2,3|QQ)'"),
        ("roots q^2+i", "roots x^2+i"),
        ("eval i -f GF7", "eval i --field GF7"),
        ("eval 2i --field '\\mathbb{F}_7'", "eval 2i --field GF7"),
        ("info 'ℍ(𝔽₇)'", "info 'H(GF(7))'"),
        ("info ℍ", "info 'H(RR)'"),
        (r"info '\mathbb{H}'", "info 'H(RR)'"),
        ("info '(a,b|F)'", "info '(a,b|QQ(a,b))'"),
        (r"info '(\frac{-1,–3}{\mathbb{Q}(\sqrt{2})})'", "info '(-1,-3|QQ(sqrt(2)))'"),
    ],
)
def test_what_is_typed_is_understood(capsys, line, plain):
    assert run(capsys, *shlex.split(line)) == run(capsys, *shlex.split(plain))


def test_minus_f_is_an_expression_where_no_field_follows(capsys):
    assert run(capsys, "eval", "-f", "--field", "QQ(f)")[1] == "-f\n"


def test_hilbert_symbols_and_units(capsys):
    symbols = ["hilbert(2,5,5)", "hilbert(-1,-1,inf)", "hilbert(2,5,3)"]
    assert run(capsys, "eval", *symbols)[1].split() == ["-1", "-1", "1"]
    cubic = ["--field", "QQ[s]/(s^3-2)"]
    assert run(capsys, "eval", "hilbert(-1,-1,inf0)", "hilbert(s,-1,(2,s))", *cubic)[1] == "-1\n1\n"
    assert run(capsys, "order", "2", "--units")[1].count("unit  ") == 24


@pytest.mark.parametrize("x", [[1, 2, 3], [], [[1, 2, 3, 4]] * 2, [[1]] * 4, [1, 2, 3, 4, 5]])
def test_lists_other_than_of_four_scalars_are_refused(x):
    A = H("GF(7)")
    for many in (x, np.array(x)):
        with pytest.raises(CoercionError, match="from_array"):
            A(many)


def test_a_list_or_an_array_of_four_is_a_quaternion():
    A = H("GF(7)")
    assert A([0, 1, 0, 0]) == A((0, 1, 0, 0)) == A(np.arange(4)[[0, 1, 0, 0]]) == A.i
    assert A([1, 2], 0, [0, 1], 0)[1] == A(2, 0, 1, 0)


def test_messages_are_shortened():
    with pytest.raises(HFieldError) as caught:
        ring("x" * 9_000 + "(")
    assert len(str(RingError("x" * 20_000))) <= 1000
    assert len(str(caught.value)) <= 1000


@pytest.mark.parametrize(
    "typed",
    [
        ("prove", "i*i == 2 and j*j == 6", "--algebra"),
        ("eval", "i*j*k", "--algebra"),
        ("roots", "x^2 - 2", "--algebra"),
        ("solve", "i*x == j", "--algebra"),
        ("matrix", "[[1, i], [j, k]]", "--algebra"),
        ("table",),
        ("info",),
        ("order",),
    ],
    ids=lambda typed: typed[0],
)
def test_every_command_reads_a_discriminant_as_the_algebra(capsys, typed):
    assert run(capsys, *typed, "6") == run(capsys, *typed, "(2,6|QQ)")
    for no_discriminant in ("12", "0", "9" * 5_000):
        status, out, error = run(capsys, *typed, no_discriminant)
        assert (status, out) == (2, "")
        assert "is not the discriminant of an algebra" in error or "digits" in error


def test_names_of_other_systems_say_what_to_write():
    with pytest.raises(AttributeError, match=r"write O.class_set\(\)"):
        hfield.BrandtModule  # noqa: B018
    with pytest.raises(AttributeError, match="No hfield attribute nothing"):
        hfield.nothing  # noqa: B018


def test_every_import_of_a_function_of_another_system_says_what_to_write():
    """``hasattr`` still answers, and a name that nobody has gets the error of Python."""
    for names, here in CALLS.items():
        for name in names.split(", "):
            with pytest.raises(ImportError, match="write " + re.escape(here)):
                exec(f"from hfield import H, {name}", {})
            assert not hasattr(hfield, name)
    with pytest.raises(ImportError, match="cannot import name 'nothing'"):
        exec("from hfield import nothing", {})


def test_a_survey_is_a_table_on_a_terminal():
    rows = [
        {"level": 1, "class_number": 10, "units": {"24": 1, "2": 9}},
        {"level": 100, "class_number": 2, "units": {}},
    ]
    assert list(Columns().lines(rows)) == [
        "level  class number  units",
        "1      10            24: 1, 2: 9",
        "100    2",
    ]


def test_a_field_with_a_large_discriminant_takes_its_primes():
    p, q = 10**30 + 57, 10**31 + 33
    name = f"QQ(sqrt({p * q}))"
    assert ring(name, factors=[p]).name == name


def test_first_tasks_are_answered():
    """Cheap ones; scripts/try_first_tasks.py tries all sixty."""
    path = Path(__file__).parents[2] / "scripts" / "try_first_tasks.py"
    tasks = runpy.run_path(str(path), run_name="tasks")
    for line, expected in tasks["STUDENT"]:
        if "prove" in line or "eval" in line:
            came, foreign = tasks["answer"](line)
            assert (expected in came, foreign) == (True, ""), line
