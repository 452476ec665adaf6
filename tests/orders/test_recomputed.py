"""Every operation on lattices, orders, ideals and classes at random cases, against plain arithmetic.

``scripts/check_lattices.py`` takes as many as one likes.
"""

from tests.orders.recomputed import OPERATIONS, run
from tests.subcases import subcases
from tests.thorough import cases

CASES = cases(80)


@subcases("name", OPERATIONS)
def test_random_cases(name: str) -> None:
    for n in range(CASES):
        run(name, n, seed=1)
