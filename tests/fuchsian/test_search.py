"""The search for units, part by part."""

from itertools import product

import numpy as np

from hfield.fuchsian.search import short_vectors


def test_short_vectors_of_many_lattices_are_all_of_them() -> None:
    rng, bound, reach = np.random.default_rng(1), 6.0, range(-4, 5)
    bases = np.eye(3) * 1.5 + rng.uniform(-0.5, 0.5, (4, 3, 3))
    which, found = short_vectors(bases, bound)
    assert list(which) == sorted(which)
    for n, basis in enumerate(bases):
        short = {c for c in product(reach, repeat=3) if sum((np.array(c) @ basis) ** 2) <= bound}
        mine = {tuple(map(int, c)) for c in found[which == n]}
        assert mine | {tuple(-x for x in c) for c in mine} == short
        assert max(max(c) for c in short) < 4  # no other combination is as short
