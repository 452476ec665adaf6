"""Quaternion algebras over arbitrary rings: compute in them, and decide statements about them.

>>> from hfield import GF, H
>>> A = H(GF(7)); e, i, j, k = A.basis
>>> (1 + i) * (j - k)**-1
6j
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hfield.algebra import H, QuaternionAlgebra
    from hfield.elements import conjugator
    from hfield.lattices.ideal import Ideal
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order
    from hfield.proving.prove import prove
    from hfield.quaternion import Quaternion
    from hfield.rings import CC, GF, QQ, RDF, RR, ZZ, Zmod, ring
    from hfield.structure import four_squares, hilbert_symbol, places

__version__ = "0.1.0"

# Where the public names live. They are imported on first use: `hfield --version` needs none.
_HOMES = {
    "algebra": ["H", "QuaternionAlgebra"],
    "elements": ["conjugator"],
    "lattices.ideal": ["Ideal"],
    "lattices.lattice": ["Lattice"],
    "lattices.order": ["Order"],
    "proving.prove": ["prove"],
    "quaternion": ["Quaternion"],
    "rings": ["CC", "GF", "QQ", "RDF", "RR", "ZZ", "Zmod", "ring"],
    "structure": ["four_squares", "hilbert_symbol", "places"],
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}

__all__ = [
    "CC",
    "GF",
    "QQ",
    "RDF",
    "RR",
    "ZZ",
    "H",
    "Ideal",
    "Lattice",
    "Order",
    "Quaternion",
    "QuaternionAlgebra",
    "Zmod",
    "conjugator",
    "four_squares",
    "hilbert_symbol",
    "places",
    "prove",
    "ring",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'hfield' has no attribute {name!r}")
    value = getattr(import_module(f"hfield.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
