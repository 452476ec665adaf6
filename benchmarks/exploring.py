"""Elements, groups, ideals and subalgebras of algebras over GF(31), of 923 521 elements each.

    python benchmarks/exploring.py

Groups and ideals of the split algebra come from formulas; groups of the degenerate algebras are listed. Times
are seconds of processor time. The unit group is created once, so later tasks reuse its generators.
"""

import time
from collections.abc import Callable

from hfield import QuaternionAlgebra

ALGEBRAS = {
    "split": (-1, -1),
    "degenerate, modulo its radical GF(31)": (0, 0),
    "degenerate, modulo its radical GF(961)": (-1, 0),
    "degenerate, modulo its radical GF(31) x GF(31)": (1, 0),
}


def tasks(A: QuaternionAlgebra) -> dict[str, Callable[[], int]]:
    G = A.unit_group()
    return {
        "numbers of all zero divisors": lambda: sum(len(n) for n in A.zero_divisors().numbers()),
        "numbers of all units": lambda: sum(len(n) for n in A.units().numbers()),
        "zero divisors as elements": lambda: sum(1 for _ in A.zero_divisors()),
        "left ideals": lambda: len(A.left_ideals()),
        "generators of the unit group": lambda: len(G.generators),
        "classes of the unit group": lambda: len(G.conjugacy_classes),
        "orders of its elements": lambda: len(G.element_orders),
        "its centre": lambda: G.center.order,
        "classes of the algebra": lambda: len(A.conjugacy_classes()),
        "subalgebras of dimension 2": lambda: len(A.subalgebras(dimension=2)),
        "subalgebras of dimension 3": lambda: len(A.subalgebras(dimension=3)),
    }


def main() -> None:
    small = QuaternionAlgebra("GF(19)", 0, 0)
    for task in tasks(small).values():  # imports, and loops from the disk
        task()
    for title, (a, b) in ALGEBRAS.items():
        A = QuaternionAlgebra("GF(31)", a, b)
        print(f"{A}, {title}")
        for name, task in tasks(A).items():
            begun = time.process_time()
            found = task()
            print(f"  {name}: {found} in {time.process_time() - begun:.2f} s")


if __name__ == "__main__":
    main()
