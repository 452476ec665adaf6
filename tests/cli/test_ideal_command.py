"""``hfield ideal``, and ``--factors`` of the commands about orders."""

import json

import pytest

from hfield import QuaternionAlgebra
from hfield.core.primality import is_prime
from tests.cli import running

P, Q = 10**35 + 1, 10**36 + 1


def run(capsys, *words):
    """As :func:`running.run`, with each text in one line, for pages are wrapped."""
    status, out, err = running.run(capsys, *words)
    return status, " ".join(out.split()), " ".join(err.split())


@pytest.mark.parametrize(
    ("words", "lines"),
    [
        (["3, comm(i, j)/2"], ["left ideal of", "norm 1: integral"]),
        (["3, 1 + j"], ["left ideal of", "norm 3: integral, locally principal", "right order"]),
        (["j"], ["norm 11: integral, locally principal, two-sided"]),
        (["3, 1 + j", "--principal"], ["principal yes with 1/2 + 1/2*j"]),
        (["2, 1 + i", "--side", "right", "--principal"], ["right ideal of", "principal yes with"]),
        (
            ["2, 1/2 + i + 1/2*j", "--with", "1"],
            ["equivalent no: no element of norm 1/2 lies between them"],
        ),
        (["1/3", "--format", "latex"], [r"\mathbb{Z}\left\langle"]),
    ],
)
def test_pages(capsys, words, lines):
    status, out, err = run(capsys, "ideal", "(-1,-11|QQ)", *words)
    assert (status, err) == (0, "")
    for line in lines:
        assert line in out


def test_over_a_number_field(capsys):
    words = [
        "ideal",
        "(-1,-1|QQ(sqrt(3)))",
        "11, 1 + 3*i + j",
        "--side",
        "right",
    ]
    status, out, err = run(capsys, *words, "--principal")
    assert (status, err) == (0, "")
    for line in (
        "right ideal of a maximal order",
        "norm ideal(11): integral, locally principal",
        "principal yes with",
    ):
        assert line in out
    data = json.loads(run(capsys, *words, "--with", "2", "--format", "json")[1])
    assert data["norm"] == {
        "generators": ["11"],
        "norm": "121",
        "factorisation": data["norm"]["factorisation"],
    }
    A = QuaternionAlgebra("(-1,-1|QQ(sqrt(3)))")
    O = A.maximal_order()
    I, J = O.right_ideal([11, A(1, 3, 1, 0)]), O.right_ideal([2])
    assert data["holds"] == bool(I.equivalence(J))
    assert (data["element"] is not None) == data["holds"]
    if data["holds"]:
        assert A(*data["element"]) * I == J


def test_an_indefinite_algebra_names_the_theorem(capsys):
    words = ["ideal", "(3,5|QQ)", "1009, 1 + i", "--principal"]
    status, out, _ = run(capsys, *words)
    assert status == 0
    assert "principal yes" in out


@pytest.mark.parametrize(
    ("words", "statement"),
    [
        (["3, 1 + j"], "ideal{"),
        (["3, 1 + j", "--side", "right"], "ideal{"),
        (["3, 1 + j", "--with", "9"], "equivalent{left;"),
        (["2, 1/2 + i + 1/2*j", "--principal"], "equivalent{left;"),
        (["7, 2 + j", "--level", "3", "--side", "right", "--with", "7"], "equivalent{right;"),
    ],
)
def test_certificates_are_accepted(capsys, tmp_path, words, statement):
    file = str(tmp_path / "ideal.json")
    assert run(capsys, "ideal", "(-1,-11|QQ)", *words, "--certificate", file)[0] == 0
    status, out, _ = run(capsys, "check", file)
    assert status == 0
    assert f"statement: {statement}" in out


def test_json(capsys):
    words = ["ideal", "11", "3, 1 + j", "--with", "9", "--format", "json"]
    data = json.loads(run(capsys, *words)[1])
    assert (data["schema"], data["norm"], data["holds"]) == ("hfield-ideal/1", "3", True)
    assert len(data["element"]) == 4


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (["11", ","], "names no element"),
        (["11", "0"], "rank below 4"),
        (["11", "3", "--with", "0"], "rank below 4"),
        (["11", "3", "--side", "both"], "left"),
        (["11", "3", "--level", "22"], "in common"),
        (["(1,1|GF(5))", "1"], "over QQ"),
        (["11", "1/0"], "0"),
        (["11", "3", "--with", "9", "--principal"], "not allowed with"),
    ],
)
def test_bad_input(capsys, words, hint):
    status, out, err = run(capsys, "ideal", *words)
    assert (status, out) == (2, "")
    assert hint in err


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "shift"), [("order", 3), ("classes --formula", 5), ("ideal", 7), ("brandt", 9)]
)
def test_primes_that_nobody_finds_are_required_and_used(capsys, command, shift):
    """Primes of its own for each, as those of an algebra are remembered."""
    p, q = (
        next(n for n in range(x, x + 9999, 2) if is_prime(n))
        for x in (P + 10**9 * shift, Q + 10**9 * shift)
    )
    name, *more = command.split()
    words = [name, f"(-1,-{p * q}|QQ)", *(["1"] if name == "ideal" else []), *more]
    status, _, err = run(capsys, *words)
    assert status != 0
    assert "give its primes with --factors" in err
    if name != "brandt":
        status, _, err = run(capsys, *words, "--factors", f"{p},{q}")
        assert (status, err) == (0, "")
    status, _, err = run(capsys, *words, "--factors", "4")
    assert (status, "4 was given as a prime factor" in err) == (2, True)
