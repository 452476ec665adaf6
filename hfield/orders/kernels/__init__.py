"""Choose between the functions for any base and their quicker variants over ℤ.

``general`` has every function for any rank 4n; ``rank4`` has some of them for n = 1, over ℤ. Leaving a
function out of ``rank4`` changes times only.
"""

from __future__ import annotations

from typing import Any

from hfield.orders.kernels import general, rank4


class Kernels:
    """The functions for lattices over a base: ℤ, or another one."""

    def __init__(self, rational: bool) -> None:
        def choose(name: str) -> Any:
            return getattr(rank4 if rational else general, name, getattr(general, name))

        self.first_order = choose("first_order")
        self.norm = choose("norm")
        self.content = choose("content")
        self.volume = choose("volume")
        self.order_rows = choose("order_rows")
        self.is_locally_principal = choose("is_locally_principal")
        self.combination = choose("combination")
        self.theta_series = choose("theta_series")
        self.conjugator = choose("conjugator")
