"""Collections of elements: units, zero divisors, idempotents, nilpotents, elements of given norm or trace.

Over a finite ring elements are found by solving, not by filtering, where possible. The norm form is a sum of
two binary forms, ``N(w, x, y, z) = N(w, x, 0, 0) + N(0, 0, y, z)``, and the trace depends only on (w, x). So
the q² pairs (y, z) are sorted once by norm, and each pair (w, x) has a list of the pairs that complete it. An
element is a unit if its norm is a unit; all others are zero divisors. It is nilpotent if its trace and norm
are nilpotent. Because ``q² = tr(q)·q − N(q)``, it is idempotent if ``(tr − 1)·w = N`` and ``(tr − 1)·x``,
``(tr − 1)·y``, ``(tr − 1)·z`` are 0.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from random import Random
from typing import TYPE_CHECKING

from hfield.algebra import structure
from hfield.algebra.quaternion import Parent, Quaternion, TooManyError
from hfield.algebra.structure.invariants.finite_radical import is_nilpotent as is_nilpotent_scalar
from hfield.core.product import Scalar
from hfield.core.properties import WithoutCaches
from hfield.errors import CoercionError, HFieldError, TooLargeError, UndecidedError, shorten
from hfield.exploring.formulas import expanded, trace_count
from hfield.exploring.labels import MAX_ORDER, LabelledAlgebra, labelled, order_of_ring
from hfield.exploring.properties import CONDITIONS, Condition, has_property
from hfield.fields.base.ring import Ring

if TYPE_CHECKING:
    import numpy as np

MAX_ARRAY = 10**8
"""The greatest number of elements in one array."""
BLOCK = 1 << 16
"""About so many elements are computed at a time."""
CACHED_PAIRS = 1 << 23
"""So many pairs (y, z) are kept to be used again."""
SHOWN = 6
"""Elements in the text of a collection."""
ROWS = 10
"""Elements in its table in a notebook."""


@dataclass(frozen=True)
class _Selection:
    """A key for each pair (w, x), or −1 if no (y, z) completes it, and the sorted pairs for each key."""

    keys: np.ndarray
    completions: Callable[[int], np.ndarray]


class Elements(WithoutCaches):
    """The elements of an algebra with a property, iterated in the order of ``A.elements()``.

    Elements are listed only when needed. Over an infinite field ``condition`` describes them, and
    :meth:`sample` draws random ones.

    >>> from hfield import H
    >>> S = H("GF(3)").nilpotents()
    >>> len(S), S.formula, S[1], "i + j + k" in S, "i" in S
    (9, 'q^2', i + j + k, True, False)
    """

    def __init__(self, algebra: Parent, condition: Condition) -> None:
        self.algebra = algebra
        self.property = condition

    # --- how many ------------------------------------------------------------------------------

    @cached_property
    def _count(self) -> tuple[int, str | None]:
        """The number of elements, and the formula in q."""
        ring, constants = self.algebra.ring, self.algebra.constants
        order_of_ring(self.algebra)
        name, value = self.property
        if name == "trace":
            return trace_count(ring, constants, value)
        if not structure.has_formulas(ring):
            return self.count_by_listing(), None
        if name == "zero divisors":
            found, every = (
                structure.count(ring, constants, "units"),
                structure.count(ring, constants, "elements"),
            )
            total, formula = every.value - found.value, f"{every.formula}-({found.formula})"
        else:
            total, formula = structure.count(ring, constants, name, value)
        return total, expanded(formula) if ring.is_field else None

    def cardinality(self) -> int:
        """Return the number of elements, of any size. Raises :class:`NotFiniteError` over infinite rings.

        >>> from hfield import H
        >>> H("GF(1000003)").units().cardinality()
        1000011000044000076000048
        """
        return self._count[0]

    def __len__(self) -> int:
        """Return the number of elements; raises :class:`NotFiniteError` also if it exceeds
        ``sys.maxsize``.
        """
        if self.cardinality() > sys.maxsize:
            raise TooManyError(f"{self._title} are too many for len(); use .cardinality()")
        return self.cardinality()

    @property
    def formula(self) -> str | None:
        """The number as a polynomial in q, the order of the field; None over other rings.

        It holds for a family of algebras: the split ones, or one kind of degenerate algebras.
        """
        return self._count[1] if self.algebra.ring.order is not None else None

    def count_by_listing(self) -> int:
        """Return the number of elements by enumerating pairs of coordinates, without a formula.

        Raises :class:`TooLargeError` if the ring has more than 2048 elements.

        >>> from hfield import H
        >>> S = H("ZZ/12").idempotents(); S.count_by_listing(), len(S)
        (28, 28)
        """
        import numpy as np

        keys = self._selection.keys
        found, times = np.unique(keys[keys >= 0], return_counts=True)
        sizes = [len(self._selection.completions(int(key))) for key in found]
        return int(np.dot(times, sizes)) if sizes else 0

    def __bool__(self) -> bool:
        if self.is_finite:
            return self.cardinality() > 0
        return next(iter(self.sample(1)), None) is not None

    @property
    def is_finite(self) -> bool:
        """Whether the algebra is finite, and the elements can be listed."""
        return self.algebra.ring.order is not None

    # --- which ---------------------------------------------------------------------------------

    def __contains__(self, x: object) -> bool:
        try:
            q = self.algebra(x)
        except HFieldError:
            return False
        return not q.is_batch and has_property(q, self.property)

    @property
    def condition(self) -> str:
        """A statement on an element q, in the language of ``hfield prove``, that holds exactly for these
        elements.

        Raises :class:`UndecidedError` over rings that are not fields, where there may be no such statement.

        >>> from hfield import QQ, H
        >>> H(QQ).idempotents().condition, H(QQ).elements_of_norm(2).condition
        ('q*q == q', 'norm(q) == 2')
        """
        ring = self.algebra.ring
        if not ring.is_field and self.property.name in ("units", "zero divisors", "nilpotents"):
            raise UndecidedError(
                f"{self._title} are not described by a statement: statements describe elements over fields "
                "only"
            )
        value = self.property.value
        return CONDITIONS[self.property.name].format(ring.text(value) if value is not None else "")

    @cached_property
    def _labels(self) -> LabelledAlgebra:
        return labelled(self.algebra)

    @cached_property
    def _selection(self) -> _Selection:
        return _select(self._labels, self.property)

    def numbers(self, block: int = BLOCK) -> Iterator[np.ndarray]:
        """Yield the numbers of the elements, ascending, in arrays of about ``block`` entries.

        The digits of a number in base q are the labels of the coordinates; see ``Quaternion.to_array``.

        >>> from hfield import H
        >>> [n.tolist() for n in H("GF(2)").nilpotents().numbers()]
        [[0, 3, 5, 6, 9, 10, 12, 15]]
        """
        import numpy as np

        square = self._labels.q**2
        pending: list[np.ndarray] = []
        gathered = 0
        for first in np.flatnonzero(self._selection.keys >= 0):
            second = self._selection.completions(int(self._selection.keys[first]))
            pending.append(int(first) * square + second)
            gathered += len(second)
            if gathered >= block:
                yield np.concatenate(pending)
                pending, gathered = [], 0
        if gathered:
            yield np.concatenate(pending)

    def __iter__(self) -> Iterator[Quaternion]:
        if order_of_ring(self.algebra) > MAX_ORDER:
            return self._solved()
        return self._listed()

    def _listed(self) -> Iterator[Quaternion]:
        make = self._labels.of_labels
        for numbers in self.numbers():
            rows = (row.tolist() for row in self._labels.rows(numbers))
            yield from map(make, *rows)

    def _solved(self) -> Iterator[Quaternion]:
        """Yield the elements over a ring that is too large for tables."""
        from hfield.exploring.large_rings import solutions

        return solutions(self.algebra, self.property)

    def __getitem__(self, n: int) -> Quaternion:
        """Return the n-th element without listing the elements before it."""
        import numpy as np

        total = self.cardinality()
        if not -total <= n < total:
            raise IndexError(
                f"index {shorten(n)} is out of range: there are {shorten(total)} {self._title}"
            )
        if order_of_ring(self.algebra) > MAX_ORDER:
            return next(islice(self._solved(), n % total, None))
        ends = self._ends
        first = int(np.searchsorted(ends, n % total, side="right"))
        second = self._selection.completions(int(self._selection.keys[first]))
        place = n % total - (int(ends[first]) - len(second))
        return self._labels.element(first * self._labels.q**2 + int(second[place]))

    @cached_property
    def _ends(self) -> np.ndarray:
        """The cumulative numbers of elements up to each pair (w, x)."""
        import numpy as np

        keys = self._selection.keys
        sizes = {
            int(k): len(self._selection.completions(int(k))) for k in np.unique(keys[keys >= 0])
        }
        return np.cumsum([sizes.get(key, 0) for key in keys.tolist()], dtype=np.int64)

    def array(self) -> Quaternion:
        """Return all elements as one array of quaternions. Raises :class:`TooLargeError` beyond 10⁸.

        >>> from hfield import H
        >>> p = H("GF(3)").units().array(); p.shape, int((p**8 == 1).sum())
        ((48,), 32)
        """
        import numpy as np

        if self.cardinality() > MAX_ARRAY:
            raise TooLargeError(
                f"{self._title} are {shorten(self.cardinality())}, more than the {MAX_ARRAY} of one array: "
                "iterate instead"
            )
        blocks = list(self.numbers())
        return self._labels.array(np.concatenate(blocks) if blocks else np.zeros(0, dtype=np.int64))

    def sample(self, n: int, seed: int = 0) -> tuple[Quaternion, ...]:
        """Return n distinct random elements, or all if there are fewer; the same ones for the same seed.

        Raises :class:`UndecidedError` over an infinite field if none is found, although one may exist.

        >>> from hfield import QQ, H, QuaternionAlgebra
        >>> A = QuaternionAlgebra(QQ, 1, 3); all(q.norm() == 0 for q in A.zero_divisors().sample(5))
        True
        >>> H(QQ).zero_divisors().sample(5)
        (0,)
        """
        if not self.is_finite:
            from hfield.exploring.infinite_fields import sample

            return sample(self.algebra, self.property, n, seed)
        total, rng = self.cardinality(), Random(seed)
        if order_of_ring(self.algebra) > MAX_ORDER:
            from hfield.exploring.large_rings import drawn

            return drawn(self, n, rng)
        places = rng.sample(range(total), min(n, total))
        return tuple(self[place] for place in places)

    # --- text ----------------------------------------------------------------------------------

    @property
    def title(self) -> str:
        """The title of the collection: ``units``, ``elements of norm 2``."""
        name, value = self.property
        return f"elements of {name} {self.algebra.ring.text(value)}" if value is not None else name

    @property
    def _title(self) -> str:
        return f"the {self.title} of {self.algebra}"

    def _repr_html_(self) -> str:
        """Return a notebook table: the number of elements, and the first ones with trace and norm."""
        from html import escape

        ring = self.algebra.ring
        first = list(islice(self, ROWS)) if self.is_finite else list(self.sample(ROWS))
        if self.is_finite:
            total = self.cardinality()
            counted = (
                f"{total} = {self.formula}"
                if self.formula not in (None, str(total))
                else f"{total}"
            )
            more = total - len(first)
            below = f"… and {more} more" if more else ""
        else:
            counted, below = "infinitely many", "… drawn at random"
        head = f"{self.title} of {self.algebra}: {counted}"
        cells = ((repr(q), ring.text(q.trace()), ring.text(q.norm())) for q in first)
        rows = "".join(
            f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in cells
        )
        return (
            f"<table><caption>{escape(head)}</caption><thead><tr><th>element</th><th>trace</th><th>norm</th>"
            f"</tr></thead><tbody>{rows}</tbody></table>{below}"
        )

    def __repr__(self) -> str:
        if not self.is_finite:
            return f"<{self.title} of {self.algebra}>"
        shown = ": " + ", ".join(map(repr, islice(self, SHOWN))) if self else ""
        more = ", …" if self.cardinality() > SHOWN else ""
        return f"<{shorten(self.cardinality())} {self.title} of {self.algebra}{shown}{more}>"


def _select(labels: LabelledAlgebra, condition: Condition) -> _Selection:
    """Return which pairs (y, z) complete each pair (w, x)."""
    import numpy as np

    ring, tables, q = labels.ring, labels.tables, labels.q
    pairs = np.divmod(np.arange(q * q, dtype=np.int32), np.int32(q))
    zero = np.int32(0)  # the label of 0
    first = labels.norm((*pairs, zero, zero))  # type: ignore[arg-type]
    second = labels.norm((zero, zero, *pairs))  # type: ignore[arg-type]
    traces = labels.trace((*pairs, zero, zero))  # type: ignore[arg-type]
    cached = max(1, CACHED_PAIRS // q**2)
    name, value = condition
    if name == "idempotents":
        return _idempotents(labels, pairs, first, second, traces, cached)
    elements = tables.elements
    wanted = np.ones(q, dtype=bool)  # norms
    keys = first
    if name == "norm":
        wanted = np.arange(q) == labels.label(value)
    elif name == "units":
        wanted = np.array([ring.is_unit(x) for x in elements])
    elif name == "zero divisors":
        wanted = np.array([not ring.is_unit(x) for x in elements])
    elif name == "nilpotents":
        wanted = np.array([_is_nilpotent(ring, x) for x in elements])
        keys = np.where(wanted[traces], first, -1)
    else:
        keys = np.where(traces == labels.label(value), 0, -1)
        everything = np.arange(q * q)
        return _Selection(keys, lambda _: everything)
    return _Selection(keys, _cached(_by_norm(labels, second, wanted), cached))


def _is_nilpotent(ring: Ring, x: Scalar) -> bool:
    return bool(ring.is_zero(x) if ring.is_field else is_nilpotent_scalar(ring, x))


def _by_norm(
    labels: LabelledAlgebra, second: np.ndarray, wanted: np.ndarray
) -> Callable[[int], np.ndarray]:
    """Return, as a function of ``key``, the pairs with a norm n such that ``key + n`` is wanted."""
    import numpy as np

    tables, q = labels.tables, labels.q
    if np.count_nonzero(wanted) > 1:
        return lambda key: np.flatnonzero(wanted[tables.sums[key * q + second]])
    sorted_pairs = _SortedPairs(second, q)
    goal = int(np.flatnonzero(wanted)[0])
    return lambda key: sorted_pairs.of_norm(tables.sums[goal * q + tables.negatives[key]])


class _SortedPairs:
    """The pairs (y, z) sorted by norm."""

    def __init__(self, norms: np.ndarray, q: int) -> None:
        import numpy as np

        self.order = np.argsort(norms, kind="stable")
        self.ends = np.searchsorted(norms[self.order], np.arange(q + 1))

    def of_norm(self, n: int) -> np.ndarray:
        """Return the pairs of norm n, ascending."""
        found: np.ndarray = self.order[self.ends[n] : self.ends[n + 1]]
        return found


def _idempotents(
    labels: LabelledAlgebra,
    pairs: tuple[np.ndarray, np.ndarray],
    first: np.ndarray,
    second: np.ndarray,
    traces: np.ndarray,
    cached: int,
) -> _Selection:
    """Return the pairs (y, z) of norm ``s·w − N(w, x)`` for ``s = tr − 1``, by these two values as a key."""
    import numpy as np

    tables, q = labels.tables, labels.q
    w, x = pairs
    minus_one = tables.negatives[labels.label(labels.ring.one)]
    s = tables.sums[traces * q + minus_one]
    norms = tables.sums[tables.products[s * q + w] * q + tables.negatives[first]]
    keys = np.where(tables.products[s * q + x] == 0, s * q + norms, -1)

    sorted_pairs = _SortedPairs(second, q)

    def completions(key: int) -> np.ndarray:
        factor, n = divmod(key, q)
        if factor == 0:
            return sorted_pairs.of_norm(n)
        killed = np.flatnonzero(tables.products[factor * q + np.arange(q)] == 0)
        found = np.add.outer(killed * q, killed).ravel()
        fitting: np.ndarray = found[second[found] == n]
        return fitting

    return _Selection(keys, _cached(completions, cached))


def _cached(function: Callable[[int], np.ndarray], size: int) -> Callable[[int], np.ndarray]:
    from functools import lru_cache

    return lru_cache(size)(function)


def check_scalar(algebra: Parent, x: object) -> Scalar:
    """Return a scalar of the base ring. Raises :class:`CoercionError`."""
    if isinstance(x, Quaternion):
        if x.algebra != algebra or not x.vector_part.is_zero():
            raise CoercionError(f"expected a scalar of {algebra.ring}, found {shorten(x)}")
        part: Scalar = x.scalar_part
        return part
    found: Scalar = algebra.ring(x)
    return found
