"""Choose between the functions for any base and their faster variants over ℤ.

``general`` has every function for any rank 4n; ``rank4`` has faster variants of some for n = 1, over ℤ.
Removing a function from ``rank4`` changes only the speed and, if several answers are correct, which one is
returned.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, TypeVar

from flint import fmpz, fmpz_mat

from hfield.orders.base_values import BaseIdeal, BaseNumber, Integer, IntegerMatrix, ThetaSeries
from hfield.orders.kernels import general, polynomials, rank4

if TYPE_CHECKING:
    from hfield.orders.base import Base
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.enumeration import Gram
    from hfield.orders.lattice_values import LatticeValue

FunctionT = TypeVar("FunctionT", bound=Callable[..., object])

Rows = tuple[int, fmpz_mat]
"""Rows over a denominator."""


class Kernels:
    """The functions for lattices over a base: ℤ, polynomials, or any other."""

    first_order: Callable[[AlgebraBasis], Rows]
    norm: Callable[[AlgebraBasis, Sequence[fmpz_mat], fmpz, int], BaseIdeal]
    content: Callable[[fmpz_mat], fmpz]
    volume: Callable[[AlgebraBasis, fmpz_mat, int], BaseIdeal]
    class_forms: Callable[
        [AlgebraBasis, Sequence[fmpz_mat], BaseNumber, Sequence[BaseNumber]], list[fmpz_mat]
    ]
    index: Callable[[LatticeValue, LatticeValue], BaseIdeal]
    order_rows: Callable[[LatticeValue, fmpz_mat], Rows]
    is_locally_principal: Callable[[LatticeValue, LatticeValue], bool]
    has_norm: Callable[[AlgebraBasis, Integer, IntegerMatrix, BaseNumber], bool]
    least_products: Callable[[Sequence[tuple[int, list[int]]], Sequence[fmpz_mat]], Sequence[int]]
    combination: Callable[[Sequence[int], Sequence[Sequence[int]]], tuple[int, ...]]
    theta_series: Callable[[AlgebraBasis, int, fmpz_mat, Gram, fmpz, Fraction, int], ThetaSeries]

    def __init__(self, base: Base) -> None:
        own = rank4 if base.is_rational else polynomials if base.is_polynomial else general
        self._name = own.__name__.rpartition(".")[2]
        for name in Kernels.__annotations__:
            setattr(self, name, getattr(own, name, getattr(general, name)))

    def choose(self, general: FunctionT, **own: FunctionT) -> FunctionT:
        """Return the variant for this base of a function for any base, from ``rank4`` or ``polynomials``.

        Modules that build on lattices choose among their own functions in this way.
        """
        return own.get(self._name, general)
