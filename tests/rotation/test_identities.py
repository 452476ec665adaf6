"""What conversions rest on, proved: our formulas, run on terms, are polynomials that `prove` compares."""

from collections.abc import Iterable
from functools import reduce
from operator import add
from types import SimpleNamespace
from typing import Any

import pytest

from hfield.core.product import conjugate
from hfield.prover.prove import prove
from hfield.prover.statements.printing import to_text
from hfield.syntax import Node, both, equal, names, parse
from rotation import action, matrices
from rotation.euler import SEQUENCES, sequence
from rotation.ledger.entries import Matrix, Vector, det, identity, scaled, times, transpose
from rotation.optimum import davenport
from rotation.quaternions import HAMILTON, multiplied, steadied
from tests.subcases import subcases

P, Q, R, V = (tuple(name[k] for k in range(4)) for name in names("p q r v"))


def proved(equations: Iterable[tuple[Node, Node]], *given: str) -> bool:
    """Tell whether equations are proved over all commutative rings, or refuse to be."""
    return bool(prove(to_text(both(*(equal(a, b) for a, b in equations))), given=given))


def entries(one: Matrix, other: Matrix) -> list[tuple[Node, Node]]:
    return [pair for a, b in zip(one, other, strict=True) for pair in zip(a, b, strict=True)]


def norm(q: Vector) -> Node:
    return reduce(add, (c * c for c in q))


def sandwich(q: str) -> Matrix:
    """Return the matrix of v ↦ q·v·q̄, as the prover's own product has it."""
    columns = [[parse(f"({q}*{unit}*conj({q}))[{k}]") for k in (1, 2, 3)] for unit in "ijk"]
    return tuple(zip(*columns, strict=True))


def to_matrix(q: Vector) -> Matrix:
    """Return what the formula of `as_matrix` computes without rounding: 2 − N(q) times the numerators."""
    return tuple(tuple(row) for row in matrices.matrix_entries(q))


@pytest.fixture(autouse=True)
def exact(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the formula of `as_matrix` run without rounding: (c + grid) − grid is c, whatever the grid."""
    monkeypatch.setattr(matrices, "_GRID", {64: 1})
    monkeypatch.setattr(matrices, "finfo", lambda xp, x: SimpleNamespace(bits=64))


def test_the_formula_of_as_matrix() -> None:
    factor = 2 - norm(Q)
    wanted = tuple(scaled(factor, row) for row in sandwich("q"))
    assert proved(entries(to_matrix(Q), wanted))
    assert not proved(entries(to_matrix(Q), transpose(wanted)))


def test_matrices_are_orthogonal_and_turn() -> None:
    m, n = sandwich("q"), norm(Q)
    square = tuple(scaled(n * n, row) for row in identity(3))
    assert proved(entries(times(m, transpose(m)), square))
    assert proved([(det(m), n * n * n)])
    assert not proved([(det(m), n * n)])


def test_products_are_products_of_matrices_and_norms_multiply() -> None:
    product = multiplied(P, Q)
    assert proved(entries((product,), (tuple(parse(f"(p*q)[{k}]") for k in range(4)),)))
    assert proved(entries(sandwich("(p*q)"), times(sandwich("p"), sandwich("q"))))
    assert not proved(entries(sandwich("(p*q)"), times(sandwich("q"), sandwich("p"))))
    assert proved([(norm(product), norm(P) * norm(Q))])


def test_inverses_are_transposed_matrices() -> None:
    back: Any = conjugate(HAMILTON, (Q[0], Q[1], Q[2], Q[3]))
    assert proved(entries(to_matrix(back), transpose(to_matrix(Q))))
    assert proved(zip(multiplied(Q, back), (norm(Q), 0 * Q[0], 0 * Q[0], 0 * Q[0]), strict=True))


def test_a_step_towards_norm_one() -> None:
    """Of a norm 1 + d the step leaves 1 − 3d²/4 + d³/4."""
    d = norm(Q) - 1
    assert proved([(4 * norm(steadied(Q)), 4 - 3 * d * d + d * d * d)], "2 != 0")


def test_points_turned_as_the_product_does() -> None:
    """`apply` is q·v·q̄ for quaternions of norm 1."""
    image = action.by_rows(to_matrix(Q), V[1:])
    wanted = [parse(f"(q*vector(v)*conj(q))[{k}]") for k in (1, 2, 3)]
    assert proved(zip(image, wanted, strict=True), "norm(q) == 1")
    assert not proved(zip(image, wanted, strict=True))


def test_each_row_that_from_matrix_chooses_from_is_a_multiple_of_q() -> None:
    """S. W. Shepperd: 4·q·qᵀ is Davenport's matrix and N."""
    rows: Any = davenport(sandwich("q"))
    table = [
        (entry + norm(Q) if k == n else entry, 4 * Q[n] * Q[k])
        for n, row in enumerate(rows)
        for k, entry in enumerate(row)
    ]
    assert proved(table)


@pytest.mark.slow
@subcases("seq", SEQUENCES)
def test_euler_angles_are_three_turns(seq: str) -> None:
    """Quaternions of half angles, multiplied, turn points as sines and cosines of the angles do."""
    axes, intrinsic = sequence(seq)
    halves = [(a[0], a[1]) for a in (P, Q, R)]
    turns = [
        (cosine, *(sine if k == axis else 0 * sine for k in range(3)))
        for axis, (cosine, sine) in zip(axes, halves, strict=True)
    ]
    texts = [f"({a}[0] + {a}[1]*{'ijk'[axis]})" for a, axis in zip("pqr", axes, strict=True)]
    order = slice(None, None, 1 if intrinsic else -1)
    whole, text = reduce(multiplied, turns[order]), "*".join(texts[order])
    assert proved([(c, parse(f"({text})[{k}]")) for k, c in enumerate(whole)])
    waves = [(2 * s * c, c * c - s * s) for c, s in halves]
    back = slice(None, None, -1 if intrinsic else 1)
    image = action.turned_about(axes[back], waves[back], V[1:])
    wanted = [parse(f"(({text})*vector(v)*conj({text}))[{k}]") for k in (1, 2, 3)]
    units = [f"{a}[0]**2 + {a}[1]**2 == 1" for a in "pqr"]
    assert proved(zip(image, wanted, strict=True), *units)
