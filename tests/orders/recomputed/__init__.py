"""Random cases of every operation on lattices, orders, ideals and classes, recomputed another way.

:data:`OPERATIONS` maps the name of an operation to a function that makes a random case and raises
AssertionError where the package and plain arithmetic differ. The tests take some of each;
``scripts/check_lattices.py`` takes thousands.
"""

from tests.orders.recomputed import of_classes, of_ideals, of_lattices, of_orders

OPERATIONS = {
    **of_lattices.OPERATIONS,
    **of_orders.OPERATIONS,
    **of_ideals.OPERATIONS,
    **of_classes.OPERATIONS,
}


def run(name: str, n: int, seed: int = 0) -> None:
    """Try case n of an operation."""
    from random import Random

    OPERATIONS[name](Random(f"{seed} {name} {n}"))
