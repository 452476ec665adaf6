"""Matrices of terms: what they mean agrees with matrices of numbers."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from hfield.prover.prove import prove
from hfield.prover.statements.printing import to_text
from hfield.syntax import Node, both, equal, names, number, parse
from rotation.ledger import entries
from rotation.ledger.entries import (
    ONE,
    ZERO,
    apply,
    cofactors,
    cross,
    det,
    dot,
    general,
    matrix,
    negative,
    product,
    shifted,
    times,
    total,
    trace,
    transpose,
)

P, Q, S, Y = names("p q s y")
NUMBERS = st.lists(st.integers(-3, 3), min_size=9, max_size=9)


def terms(values: list[int]) -> entries.Matrix:
    rows = [values[n : n + 3] for n in (0, 3, 6)]
    return tuple(tuple(map(number, row)) for row in rows)


def value(term: Node) -> Fraction:
    """Evaluate arithmetic on integers, with Python's rules."""
    return Fraction(eval(to_text(term), {"__builtins__": {}}))  # of digits and operators


def exact_det(m: list[int]) -> int:
    a, b, c, d, e, f, g, h, i = m
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


@given(NUMBERS, NUMBERS)
def test_products_determinants_and_traces(x: list[int], y: list[int]) -> None:
    m, n = terms(x), terms(y)
    got = [value(entry) for row in times(m, n) for entry in row]
    rows, columns = [x[k : k + 3] for k in (0, 3, 6)], [y[k::3] for k in (0, 1, 2)]
    assert got == [sum(a * b for a, b in zip(r, c, strict=True)) for r in rows for c in columns]
    assert value(det(m)) == exact_det(x)
    assert value(trace(m)) == x[0] + x[4] + x[8]
    shift = [v + 2 if k in (0, 4, 8) else v for k, v in enumerate(x)]
    assert value(det(shifted(m, number(2)))) == exact_det(shift)
    adjugate = times(m, transpose(cofactors(m)))
    assert [value(v) for row in adjugate for v in row] == [
        exact_det(x) * (r == c) for r in range(3) for c in range(3)
    ]


@given(NUMBERS)
def test_cross_product_is_perpendicular(x: list[int]) -> None:
    v, w, u = terms(x)
    assert value(dot(cross(v, w), v)) == value(dot(cross(v, w), w)) == 0
    assert value(dot(cross(v, w), u)) == exact_det([*x[6:], *x[:3], *x[3:6]])


@pytest.mark.parametrize(
    ("made", "expected"),
    [
        (product(-P[0], Q[1]), "-(p[0]*q[1])"),
        (product(P[0] - Q[1], -ONE), "-(p[0] - q[1])"),
        (product(ZERO, P[0]), "0"),
        (negative(-(S + Y)), "s + y"),
        (total([ZERO, -S, -Y, -S + Y]), "-s - y + (-s + y)"),
        (total([]), "0"),
    ],
)
def test_short_terms(made: Node, expected: str) -> None:
    assert made == parse(expected)


def test_symbolic_matrices_satisfy_cayley_and_hamilton() -> None:
    m = general("p")
    square = times(m, m)
    left = [
        equal(square[r][c] - trace(m) * m[r][c] + (det(m) if r == c else 0), 0)
        for r in (0, 1)
        for c in (0, 1)
    ]
    assert prove(to_text(both(*left)))
    assert apply(matrix("0, -1; 1, 0"), (ONE, ZERO)) == (ZERO, ONE)
