"""Every operation on lattices, orders, ideals and classes at random cases, against plain arithmetic.

``scripts/check_lattices.py`` takes as many as one likes.
"""

import pytest

from tests.orders.recomputed import OPERATIONS, run
from tests.subcases import first_quick, subcases
from tests.thorough import cases

CASES, PARTS = cases(80), 8


@pytest.mark.parametrize("part", first_quick(range(PARTS), 1))
@subcases("name", OPERATIONS)
def test_random_cases(name: str, part: int) -> None:
    for n in range(part, CASES, PARTS):
        run(name, n, seed=1)
