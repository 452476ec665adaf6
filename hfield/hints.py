"""Names that other systems give to what is called otherwise here: asked for, they say what to write."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, NoReturn


class Elsewhere:
    """A name that is called otherwise here: asked for, it raises an AttributeError that says so."""

    def __init__(self, name: str, hint: str) -> None:
        self.name, self.hint = name, hint

    def __get__(self, instance: object, owner: type) -> NoReturn:
        raise AttributeError(
            f"a {owner.__name__} has no {self.name!r}: write {self.hint}",
            name=self.name,
            obj=instance,
        )


class Hinted:
    """A class that answers a name of another system with its own, in the AttributeError.

    A ``__getattr__`` would do it too, and make every other attribute slower to find.

    >>> from hfield import H, QQ
    >>> H(QQ).ramified_primes()
    Traceback (most recent call last):
    AttributeError: a QuaternionAlgebra has no 'ramified_primes': write ramified_places()
    """

    __slots__ = ()

    elsewhere: ClassVar[Mapping[str, str]] = {}

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        for name, hint in cls.elsewhere.items():
            if not any(name in base.__dict__ for base in cls.__mro__):
                setattr(cls, name, Elsewhere(name, hint))

    def __dir__(self) -> list[str]:
        return [name for name in super().__dir__() if name not in self.elsewhere]


ELEMENT = {
    "reduced_norm": "norm()",
    "reduced_trace": "trace()",
    "coefficient_tuple": "coordinates",
    "coefficients": "coordinates",
    "reduced_characteristic_polynomial": "characteristic_polynomial()",
    "minpoly": "minimal_polynomial()",
    "charpoly": "characteristic_polynomial()",
    "multiplicative_order": "order()",
    "is_invertible": "is_unit()",
    "parent": "algebra",
    "base_ring": "ring",
    "real": "scalar_part",
    "imag": "vector_part",
    "w": "coordinates[0]",
    "x": "coordinates[1]",
    "y": "coordinates[2]",
    "z": "coordinates[3]",
}
"""Sage, GAP, Magma, numpy-quaternion."""

ALGEBRA = {
    "gens": "basis",
    "gen": "basis[1]",
    "is_division": "is_division_algebra()",
    "ramified_primes": "ramified_places()",
    "ramified_infinite_places": "ramified_places()",
    "finite_ramified_places": "ramified_places()",
    "base_ring": "ring",
    "invariants": "constants",
    "is_matrix_ring": "split(), which is None for a division algebra",
    "is_split": "split(), which is None for a division algebra",
    "is_definite": "ramified_places(), which has inf for a definite algebra over QQ",
    "quaternion_order": "order(elements)",
    "hilbert_symbol": "hilbert_symbol(a, b, place) of hfield",
    "one_basis": "basis",
    "modp_splitting_data": "split()",
    "is_exact": "ring.is_exact",
    "random": "random_element()",
}
"""Sage, Magma, PARI."""
