"""The search for units, part by part."""

import math
from itertools import product

import numpy as np
import pytest

from hfield import QuaternionAlgebra, ring
from hfield.errors import TooLargeError
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


BETWEEN = 10**40 + 1
# conjugators: large, very large, and into a cusp
SKEW = [
    (6, (10007, 3, 501, 70001)),
    (6, (BETWEEN, 3, -(BETWEEN**2), BETWEEN // 7)),
    (1, (10**20 + 1, 10**20 - 1, 0, 0)),
]


@pytest.mark.parametrize(("D", "conjugator"), SKEW)
def test_conjugate_orders_have_equal_groups(D: int, conjugator: tuple[int, ...]) -> None:
    A = QuaternionAlgebra("QQ", 1, 1) if D == 1 else QuaternionAlgebra(D)
    O, x = A.maximal_order(), A(*conjugator)
    group, skew = (P.norm_one_group() for P in (O, A.order([x * b / x for b in O.basis])))
    domain = skew.domain()
    assert (domain.area, skew.signature) == (group.area, group.signature)
    assert all(u in skew.order and u.norm() == 1 for u in skew.generators)
    # conjugation maps one group into the other
    assert all(len(skew.word(x * u / x)) > 0 for u in group.generators)
    assert len(skew.cm_points(-24)) == len(group.cm_points(-24))
    # a point that a unit of the order fixes, exactly and in floats
    z = complex(domain.center)
    assert z.imag > 0
    assert math.isfinite(abs(z))


def test_a_centre_deep_in_a_cusp_is_refused() -> None:
    A = QuaternionAlgebra("QQ", 1, 1)
    x = A(10**20 + 1, 10**20 - 1, 0, 0)
    skew = A.order([x * b / x for b in A.maximal_order().basis]).norm_one_group()
    with pytest.raises(TooLargeError, match="too deep in a cusp"):
        skew.domain(0.3 + 1j)


def test_skew_orders_over_a_field() -> None:
    K = ring("QQ(sqrt(5))")
    A = QuaternionAlgebra.from_ramification(K, [K.real_places()[0], K.primes_above(2)[0]])
    O, x = A.maximal_order(), A(10**12 + K.gen, 3, 501 * K.gen, 70001)
    skew = A.order([x * b / x for b in O.basis]).norm_one_group()
    assert skew.domain().area == O.norm_one_group().area
