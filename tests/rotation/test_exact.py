"""Exact rotations: groups closed and matrices orthogonal by exact arithmetic, floats as those of the rest."""

import itertools
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from hfield import H
from rotation import Rotation, RotationError, exact_group, exact_matrix, from_exact


def times(m: Any, n: Any) -> tuple[tuple[Any, ...], ...]:
    return tuple(
        tuple(
            sum((a * b for a, b in zip(row, column, strict=True)), 0 * row[0])
            for column in zip(*n, strict=True)
        )
        for row in m
    )


@pytest.mark.parametrize(("group", "order"), [("T", 12), ("O", 24), ("I", 60)])
def test_the_groups_are_groups_exactly(group: str, order: int) -> None:
    matrices = {exact_matrix(q): q for q in exact_group(group)}
    assert len(matrices) == order
    some = list(matrices)[:: max(1, order // 12)]
    for m in some:
        assert times(m, tuple(zip(*m, strict=True))) == exact_matrix(H("QQ")(1))
        assert all(times(m, n) in matrices for n in matrices)


@pytest.mark.parametrize("group", ["T", "O", "I"])
def test_their_floats_are_the_group_of_floats(group: str) -> None:
    exact, floats = from_exact(exact_group(group)), Rotation.create_group(group)
    same = np.abs(exact.as_quat() @ floats.as_quat().T) > 1 - 1e-14
    assert (same.sum(axis=0) == 1).all()
    assert (same.sum(axis=1) == 1).all()
    assert exact[0] == Rotation.identity()


def test_matrices_agree_with_floats() -> None:
    for c in itertools.product((-2, 1, 3), repeat=4):
        q = H("QQ")(*c)
        found = np.array([[float(Fraction(str(x))) for x in row] for row in exact_matrix(q)])
        np.testing.assert_allclose(from_exact(q).as_matrix(), found, atol=5e-16)


def test_square_roots_and_errors() -> None:
    quarter = from_exact(H("RR")("sqrt(2)", "sqrt(2)", 0, 0))
    assert quarter.approx_equal(Rotation.from_euler("x", 90, degrees=True), 1e-15)
    for bad in (3, H("QQ(I)")("I", 1, 0, 0), H("GF(7)")(1, 2, 0, 0)):
        with pytest.raises(RotationError):
            from_exact(bad)
    with pytest.raises(RotationError, match="zero"):
        from_exact(H("QQ")(0))
    with pytest.raises(RotationError, match="group 'D3'"):
        exact_group("D3")
