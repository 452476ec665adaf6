"""Trees made by operators and functions are those that the parser makes of the text."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield import syntax
from hfield.prover.statements.printing import to_text
from hfield.syntax import Node, names, number, parse
from tests.subcases import subcases

P, Q, S = names("p q s")
LEAVES = st.sampled_from([P, Q, S, P[0], number(2), number(-3), number(0.5)])


def compound(children):
    pairs = st.tuples(children, children)
    return st.one_of(
        pairs.map(lambda x: x[0] + x[1]),
        pairs.map(lambda x: x[0] - x[1]),
        pairs.map(lambda x: x[0] * x[1]),
        pairs.map(lambda x: x[0] / x[1]),
        children.map(lambda x: -x),
        children.map(lambda x: x**2),
        children.map(syntax.conj),
        children.map(syntax.norm),
    )


@given(st.recursive(LEAVES, compound, max_leaves=12))
def test_what_operators_make_is_what_its_text_means(x: Node) -> None:
    assert parse(to_text(x)) == x


@subcases(
    ("made", "text"),
    [
        (1 + P * Q - 2 * S, "1 + p*q - 2*s"),
        (3 / S / Fraction(5, 2) - 1, "3/s/2.5 - 1"),
        (1 - P**2 * Q[3], "1 - p**2*q[3]"),
        (-(P + -2), "-(p + (-2))"),
        (syntax.equal(syntax.comm(P, Q), 0), "comm(p, q) == 0"),
        (syntax.implies("s == 1", "p == q", syntax.unequal(S, 0)), "s == 1 => p == q => s != 0"),
        (syntax.both(syntax.equal(P, Q), "s == 1", "s == 2"), "p == q and s == 1 and s == 2"),
        (syntax.either("s == 1", syntax.negation(syntax.equal(P, Q))), "s == 1 or not p == q"),
        (syntax.iff(syntax.equal(P, Q), "s == 1"), "p == q <=> s == 1"),
        (syntax.inv(syntax.vector(P)) * syntax.scalar(Q), "inv(vector(p))*scalar(q)"),
    ],
)
def test_trees_are_those_of_the_parser(made: Node, text: str) -> None:
    assert made == parse(text)


def test_a_quaternion_has_four_coordinates() -> None:
    assert [str(x.index) for x in P] == ["0", "1", "2", "3"]
    with pytest.raises(IndexError, match="0 to 3"):
        P[4]
