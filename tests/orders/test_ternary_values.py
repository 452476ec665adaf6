"""Vectors of a given value of an indefinite form, against all vectors of a box."""

import numpy as np

from hfield.orders.ternary_values import vectors_of_value

BOUND, REACH = 60, 7


def test_all_vectors_are_found_up_to_the_sign() -> None:
    rng, found = np.random.default_rng(1), 0
    box = np.indices((2 * REACH + 1,) * 3).reshape(3, -1).T - REACH
    for scale in (1, 10**12):  # long numbers do not fit into 64 bits
        for _ in range(30):
            half, rows = rng.integers(-4, 5, (3, 3)), rng.integers(-2, 3, (3, 3))
            form = half + half.T + np.diag([0, 0, 1])
            definite = rows @ rows.T + np.eye(3, dtype=int)  # at least the square of the length
            value = int(rng.choice([-8, -3, 2, 5, 12]))
            values, sizes = (((box @ m) * box).sum(axis=1) for m in (form, definite))
            chosen = box[(values == value) & (sizes <= BOUND)].tolist()
            got = list(
                vectors_of_value((form * scale).tolist(), value * scale, definite.tolist(), BOUND)
            )
            both = [*got, *(tuple(-c for c in x) for x in got)]
            assert sorted(both) == sorted(map(tuple, chosen))
            found += len(got)
    assert found > 50
