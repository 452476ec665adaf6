"""Count all elements of an algebra over a finite ring by enumeration, four coordinates at a time.

All elements with a fixed first coordinate are computed at once: by compiled loops if there are many and the
ring has loops, otherwise from tables of the ring's sums and products with numpy. Both use the product formula
of :mod:`hfield.core.product`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from hfield.algebra.structure.counting.counted_kinds import KINDS
from hfield.algebra.structure.counting.formulas_finite import count
from hfield.core.product import Constants, Coordinates, Scalar, multiply, norm
from hfield.core.progress import track
from hfield.errors import NotFiniteError, TooLargeError, shorten
from hfield.fields.base.ring import Ring

if TYPE_CHECKING:
    import numpy as np

    from hfield.fields.base.array_storage.labels import LabelArrays

Rows = tuple["np.ndarray", ...]

LIMIT = 2 * 10**6
"""The greatest number of elements that are gone through, in a second or, by tables, three."""
MIN_COMPILED = 10**5
"""The number of elements from which on compiled loops are used."""

MANY_SCALARS = 64
"""The order from which on tables of sums and products are computed by compiled loops."""


@dataclass
class Tally:
    """The result of an exhaustive count. The keys of ``norms`` and ``roots`` are texts of scalars."""

    elements: int = 0
    norms: dict[str, int] = field(default_factory=dict)
    nilpotent: int = 0
    idempotent: int = 0
    units: int = 0
    roots: dict[str, int] = field(default_factory=dict)

    def number(self, kind: str, value: str = "") -> int:
        """Return the number of elements of a kind; ``value`` is the text of the norm or square."""
        by_value = {"norm": self.norms, "square roots": self.roots}
        return by_value[kind][value] if kind in by_value else int(getattr(self, kind))


class RingTables:
    """The addition and multiplication of a finite ring as tables of indices; 0 and 1 come first."""

    def __init__(self, ring: Ring) -> None:
        import numpy as np

        if ring.order is None:
            raise NotFiniteError(
                f"{ring.name} is infinite, so its elements cannot be tried one by one"
            )
        self.ring = ring
        self.elements = list(ring.elements())
        self.index = {ring.key(x): n for n, x in enumerate(self.elements)}
        self.size = len(self.elements)
        self.sums = self._table("sum", lambda x, y: x + y)
        self.products = self._table("product", lambda x, y: x * y)
        negatives = [self.index[ring.key(ring.zero - x)] for x in self.elements]
        self.negatives = np.array(negatives, dtype=np.int32)

    def _table(self, name: str, operation: Callable[[Scalar, Scalar], Scalar]) -> np.ndarray:
        import numpy as np

        from hfield.fields.base.array_storage.finite import scalar_arrays

        key, index = self.ring.key, self.index
        loops = scalar_arrays(self.ring) if self.size >= MANY_SCALARS else None
        if loops is not None:
            labels = np.arange(self.size, dtype=loops.dtype)
            return loops(name, labels[:, None], labels[None, :]).astype(np.int32).ravel()
        rows = [[index[key(operation(x, y))] for y in self.elements] for x in self.elements]
        return np.array(rows, dtype=np.int32).ravel()

    def of(self, x: Scalar) -> Indices:
        """Return an element as an index, which can be combined with arrays of indices."""
        import numpy as np

        return Indices(self, np.int32(self.index[self.ring.key(x)]))


class Indices:
    """Elements of a finite ring as indices into its tables, with ``+ − ×`` elementwise."""

    __slots__ = ("tables", "values")

    def __init__(self, tables: RingTables, values: Any) -> None:
        self.tables, self.values = tables, values  # an array, or one number of numpy

    def __add__(self, other: Indices) -> Indices:
        t = self.tables
        return Indices(t, t.sums.take(self.values * t.size + other.values))

    def __mul__(self, other: Indices) -> Indices:
        t = self.tables
        return Indices(t, t.products.take(self.values * t.size + other.values))

    def __neg__(self) -> Indices:
        return Indices(self.tables, self.tables.negatives.take(self.values))

    def __sub__(self, other: Indices) -> Indices:
        return self + -other


def tally(ring: Ring, c: Constants) -> Tally:
    """Count all elements by norm, by square and by property.

    Raises :class:`NotFiniteError` over an infinite ring and :class:`TooLargeError` beyond :data:`LIMIT`.
    """
    import numpy as np

    if ring.order is not None and ring.order**4 > LIMIT:
        raise TooLargeError(
            f"{shorten(ring.order)}^4 elements exceed the {LIMIT} that are tried one by one; over a finite "
            "field and over ZZ/n there are formulas"
        )
    elements = list(ring.elements())
    q = len(elements)
    loops = compiled_loops(ring, c) if q**4 >= MIN_COMPILED else None
    work = _ByTables(ring, c) if loops is None else _ByLoops(loops)
    x, y, z = (v.ravel() for v in np.indices((q, q, q), dtype=work.dtype))
    norms, squares = np.zeros(q, dtype=np.int64), np.zeros(q, dtype=np.int64)
    result = Tally(elements=q**4)
    steps = 0 if ring.is_field else max(1, q.bit_length())
    for w in track(range(q), q, "elements"):
        element = (np.full(q**3, w, dtype=work.dtype), x, y, z)
        norms += np.bincount(work.norm(element), minlength=q)
        square = work.square(element)
        scalar = ~(square[1] | square[2] | square[3]).astype(bool)
        squares += np.bincount(square[0][scalar], minlength=q)
        same = [u == v for u, v in zip(square, element, strict=True)]
        result.idempotent += int(np.logical_and.reduce(same).sum())
        for _ in range(steps):  # over a field the square of a nilpotent element is 0
            square = work.square(square)
        result.nilpotent += int((~np.bitwise_or.reduce(square).astype(bool)).sum())
    texts = [ring.text(u) for u in elements]
    result.norms = dict(zip(texts, map(int, norms), strict=True))
    result.roots = dict(zip(texts, map(int, squares), strict=True))
    result.units = sum(int(n) for n, u in zip(norms, elements, strict=True) if ring.is_unit(u))
    return result


class _ByTables:
    """Norms and squares of elements given by indices, from tables."""

    dtype = "i4"

    def __init__(self, ring: Ring, c: Constants) -> None:
        self.tables = RingTables(ring)
        self.constants = Constants(*(self.tables.of(x) for x in c))

    def norm(self, rows: Rows) -> np.ndarray:
        """Return the norms."""
        found: np.ndarray = norm(self.constants, self._element(rows)).values
        return found

    def square(self, rows: Rows) -> Rows:
        """Return the squares."""
        element = self._element(rows)
        return tuple(c.values for c in multiply(self.constants, element, element))

    def _element(self, rows: Rows) -> Coordinates:
        w, x, y, z = (Indices(self.tables, v) for v in rows)
        return w, x, y, z


class _ByLoops:
    """Norms and squares of elements given by labels, which serve as indices, by compiled loops."""

    def __init__(self, how: LabelArrays) -> None:
        self.how, self.dtype = how, how.dtype

    def norm(self, rows: Rows) -> np.ndarray:
        """Return the norms."""
        return self.how.kernel("norm")(rows)[0][0]

    def square(self, rows: Rows) -> Rows:
        """Return the squares."""
        return self.how.product(rows, rows)


def compiled_loops(ring: Ring, c: Constants) -> LabelArrays | None:
    """Return the compiled loops of an algebra, or None if the ring does not list its elements by labels."""
    from hfield.fields.base.array_storage.labels import LabelArrays

    how = ring.array_storage(c)
    return how if isinstance(how, LabelArrays) and how.compiles else None


def confirm(ring: Ring, c: Constants) -> Tally:
    """Compare the closed formulas with an exhaustive count; return the count.

    Raises :class:`AssertionError` if they differ, which would be an error in this package.
    """
    found = tally(ring, c)
    for kind in KINDS.values():
        for x in ring.elements() if kind.needs else [ring.zero]:
            formula = count(ring, c, kind.name, x if kind.needs else None)
            number = found.number(kind.name, ring.text(x))
            if formula.value != number:
                raise AssertionError(
                    f"{formula} was expected and {number} counted over {ring.name}"
                )
    return found
