"""Counterexamples, worked out on both sides."""

from hfield.ledger.decision_lines import worked_out
from tests.subcases import subcases

I, J = ["0", "1", "0", "0"], ["0", "0", "1", "0"]  # noqa: E741
ZERO = ["0", "0", "0", "0"]


@subcases(
    ("text", "witness", "field", "lines"),
    [
        ("p*q == q*p", {"p": I, "q": J}, "QQ", ["p·q = k ≠ −k = q·p"]),
        ("p*q == q*p", {"F": ["GF(3)"], "p": I, "q": J}, "universal", ["p·q = k ≠ 2k = q·p"]),
        ("q == 0", {"q": I}, "QQ", ["q = i ≠ 0"]),
        ("i*j == j*i and i*i == -e", None, "QQ", ["i·j = k ≠ −k = j·i"]),
        ("norm(q) == 0 => q == 0", {"q": ["1", "1", "0", "0"]}, "GF(2)", ["q = 1 + i ≠ 0"]),
        ("q*inv(q) == e", {"q": ZERO}, "QQ", ["q·q⁻¹ is not defined"]),
        ("q != i", {"q": I}, "QQ", ["q = i"]),
        ("s*q == q", {"s": ["2"], "q": I}, "GF(9)", ["s·q = 2i ≠ i = q"]),
        ("p*q == q*p", {"p": I}, "QQ", []),
        ("p*q == q*p", {"p": I, "q": J}, "universal", []),
        ("p*q == q*p", {"p": I, "q": J}, "-", []),
        ("the centre is F·e", {"c1": I}, "QQ", []),
        ("exists q: q == p", {"p": I}, "QQ", []),
    ],
)
def test_both_sides_are_worked_out(text, witness, field, lines):
    assert worked_out(text, witness, field) == lines


def test_in_another_algebra():
    assert worked_out("i*i == -e", {}, "QQ", "(2,3|QQ)") == ["i·i = 2 ≠ −1 = −e"]
    values = {"q": I, "a": ["5"], "b": ["1"]}
    assert worked_out("q*q == b", values, "QQ", "(a,b|F)") == ["q·q = 5 ≠ 1 = b"]
