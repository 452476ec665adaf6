"""The commands about orders over GF(q)(t)."""

import json

import pytest

from hfield.cli import main

ALGEBRA = "(-1,t^3+2*t+1|GF(3)(t))"


def read(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, object]:
    assert main([*words, "--format", "json"]) == 0
    found: dict[str, object] = json.loads(capsys.readouterr().out)
    return found


def test_commands_over_polynomials(capsys: pytest.CaptureFixture[str]) -> None:
    order = read(capsys, "order", ALGEBRA, "--level", "t", "--units")
    assert order["discriminant"] == {
        "generators": ["t^4+2*t^2+t"],
        "norm": "81",
        "factorisation": [["ideal(t)", 1], ["ideal(t^3+2*t+1)", 1]],
    }
    assert (order["maximal"], order["eichler"], order["unit_index"]) == (False, True, 1)
    ideal = read(capsys, "ideal", ALGEBRA, "t, 1 + j", "--principal")
    assert ideal["norm"] == {"generators": ["t"], "norm": "3", "factorisation": [["ideal(t)", 1]]}
    assert ideal["holds"] is False
    classes = read(capsys, "classes", ALGEBRA)
    assert [classes[key] for key in ("class_number", "mass", "type_number")] == [4, "13/4", 4]
    brandt = read(capsys, "brandt", ALGEBRA)
    assert brandt["matrix"] == [[0, 4, 0, 0], [1, 0, 2, 1], [0, 2, 1, 1], [0, 1, 1, 2]]
    assert brandt == read(capsys, "brandt", ALGEBRA, "--prime", "t")


def test_orders_and_ideals_have_the_same_keys_over_every_base(
    capsys: pytest.CaptureFixture[str],
) -> None:
    algebras = ("(-1,-11|QQ)", "(-1,-1|QQ(sqrt(5)))", ALGEBRA)
    for words in (("order",), ("ideal", "3, 1 + i + j")):
        found = [read(capsys, words[0], A, *words[1:]) for A in algebras]
        rational, over_field, over_polynomials = (list(data) for data in found)
        assert [key for key in over_field if key != "pseudo_basis"] == rational == over_polynomials
    orders = [read(capsys, "order", A) for A in algebras]
    assert [data["mass"] for data in orders] == ["5/6", "1/60", "13/4"]
    assert [data["unit_index"] for data in orders] == [2, 60, 4]
    assert [data["unit_group"] for data in orders] == ["C4", "A5", "C4"]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("classes", ALGEBRA, "--level", "t^3+2*t+1"), "have the prime"),
        (("brandt", ALGEBRA, "--prime", "1/t"), "expected an ideal of GF(3)[t]"),
        (("classes", ALGEBRA, "--formula"), "over other fields the classes are enumerated"),
        (("order", ALGEBRA, "--extremal"), "p-extremal"),
    ],
)
def test_what_is_not_possible_is_refused(
    capsys: pytest.CaptureFixture[str], words: tuple[str, ...], reason: str
) -> None:
    assert main(list(words)) == 2
    assert reason in " ".join(capsys.readouterr().err.split())
