"""Counting by going through all elements of an algebra over a finite ring, four coordinates at a time.

The ring's additions and multiplications are put into tables once, and numpy looks them up for
all elements with the first coordinate fixed; the product is the one formula of :mod:`hfield.product`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from hfield.errors import NotFiniteError, TooLargeError, shorten
from hfield.product import Constants, Coordinates, multiply, norm
from hfield.rings.base import Ring
from hfield.structure.counting.formulas_finite import Count, count

if TYPE_CHECKING:
    import numpy as np

LIMIT = 2 * 10**6
"""The greatest number of elements that are gone through, in two or three seconds."""


@dataclass
class Tally:
    """What an exhaustive count found. ``norms`` and ``roots`` go by the text of the scalar."""

    elements: int = 0
    norms: dict[str, int] = field(default_factory=dict)
    nilpotent: int = 0
    idempotent: int = 0
    units: int = 0
    roots: dict[str, int] = field(default_factory=dict)


class Tables:
    """The addition and multiplication of a finite ring as tables of indices; 0 and 1 come first."""

    def __init__(self, ring: Ring) -> None:
        import numpy as np

        if ring.order is None:
            raise NotFiniteError(f"{ring.name} is infinite, so its elements cannot be gone through")
        self.ring = ring
        self.elements = list(ring.elements())
        self.index = {ring.key(x): n for n, x in enumerate(self.elements)}
        self.size = len(self.elements)
        self.sums = self._table(np, lambda x, y: x + y)
        self.products = self._table(np, lambda x, y: x * y)
        negatives = [self.index[ring.key(ring.zero - x)] for x in self.elements]
        self.negatives = np.array(negatives, dtype=np.int32)

    def _table(self, np: Any, operation: Any) -> Any:
        key, index = self.ring.key, self.index
        rows = [[index[key(operation(x, y))] for y in self.elements] for x in self.elements]
        return np.array(rows, dtype=np.int32).ravel()

    def of(self, x: Any) -> Indices:
        """Return an element as an index that mixes with arrays of indices."""
        import numpy as np

        return Indices(self, np.int32(self.index[self.ring.key(x)]))


class Indices:
    """Elements of a finite ring as indices into its tables, with ``+ − ×`` elementwise."""

    __slots__ = ("tables", "values")

    def __init__(self, tables: Tables, values: Any) -> None:
        self.tables, self.values = tables, values

    def __add__(self, other: Indices) -> Indices:
        t = self.tables
        return Indices(t, t.sums[self.values * t.size + other.values])

    def __mul__(self, other: Indices) -> Indices:
        t = self.tables
        return Indices(t, t.products[self.values * t.size + other.values])

    def __neg__(self) -> Indices:
        return Indices(self.tables, self.tables.negatives[self.values])

    def __sub__(self, other: Indices) -> Indices:
        return self + -other


def tally(ring: Ring, c: Constants) -> Tally:
    """Go through all elements and count them by norm, by square, and by what they are.

    Raises :class:`NotFiniteError` over an infinite ring and :class:`TooLargeError` beyond :data:`LIMIT`.
    """
    import numpy as np

    if ring.order is not None and ring.order**4 > LIMIT:
        raise TooLargeError(
            f"{shorten(ring.order)}^4 elements are more than the {LIMIT} that are gone through; over a "
            "finite field and over ZZ/n there are formulas"
        )
    tables = Tables(ring)
    q = tables.size
    constants = Constants(*(tables.of(x) for x in c))
    x, y, z = (v.ravel() for v in np.indices((q, q, q), dtype=np.int32))
    norms, squares = np.zeros(q, dtype=np.int64), np.zeros(q, dtype=np.int64)
    result = Tally(elements=q**4)
    for w in range(q):
        element = _element(tables, np.full(q**3, w, dtype=np.int32), x, y, z)
        norms += np.bincount(norm(constants, element).values, minlength=q)
        square = multiply(constants, element, element)
        scalar = ~(square[1].values | square[2].values | square[3].values).astype(bool)
        squares += np.bincount(square[0].values[scalar], minlength=q)
        same = [u.values == v.values for u, v in zip(square, element, strict=True)]
        result.idempotent += int(np.logical_and.reduce(same).sum())
        result.nilpotent += _nilpotent(constants, tables, square)
    texts = [ring.text(u) for u in tables.elements]
    result.norms = dict(zip(texts, map(int, norms), strict=True))
    result.roots = dict(zip(texts, map(int, squares), strict=True))
    result.units = sum(
        int(n) for n, u in zip(norms, tables.elements, strict=True) if ring.is_unit(u)
    )
    return result


def _element(tables: Tables, *coordinates: np.ndarray) -> Coordinates:
    w, x, y, z = (Indices(tables, v) for v in coordinates)
    return w, x, y, z


def _nilpotent(constants: Constants, tables: Tables, square: Coordinates) -> int:
    """Count the elements, given by their squares, some power of which is 0.

    Over a field the square of a nilpotent element is 0; over ℤ/n squaring goes on while it may help.
    """
    steps = 0 if tables.ring.is_field else max(1, tables.size.bit_length())
    for _ in range(steps):
        square = multiply(constants, square, square)
    w, x, y, z = square
    return int((~(w.values | x.values | y.values | z.values).astype(bool)).sum())


def confirm(ring: Ring, c: Constants) -> Tally:
    """Compare the closed formulas with an exhaustive count; return the count.

    Raises :class:`AssertionError` where they differ, which would be an error of this package.
    """
    found = tally(ring, c)
    pairs: list[tuple[Count, int]] = [
        (count(ring, c, "elements"), found.elements),
        (count(ring, c, "nilpotent"), found.nilpotent),
        (count(ring, c, "idempotent"), found.idempotent),
        (count(ring, c, "units"), found.units),
    ]
    for x in ring.elements():
        pairs.append((count(ring, c, "norm", x), found.norms[ring.text(x)]))
        pairs.append((count(ring, c, "square roots", x), found.roots[ring.text(x)]))
    for formula, number in pairs:
        if formula.value != number:
            raise AssertionError(f"{formula} was expected and {number} counted over {ring.name}")
    return found
