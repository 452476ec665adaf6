"""Decide a statement over a finite ring by trying all cases."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property, lru_cache
from itertools import product
from typing import TYPE_CHECKING, TypeVar

from hfield.core.product import Scalar
from hfield.errors import TooLargeError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import Decided, PrimeScalars, RingScalars, constant
from hfield.prover.evaluation.searcher import Assignment, Searcher, lifted
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Sort, Statement

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Indices = npt.NDArray[np.integer]
    Booleans = bool | npt.NDArray[np.bool_]
    Operations = Mapping[str, Callable[..., Indices]]

X = TypeVar("X")
MAX_CASES = 10**8
FEW_CASES = 1_500  # below, a loop is faster than loading numpy
BLOCK = 1 << 18
MAX_TABLE = 1 << 8  # elements of a ring whose products are tabulated
MAX_PRIME = 1 << 16  # elements of a prime field whose inverses are
MANY_CASES = (
    10**5
)  # from here on loops that are compiled, or read from the disk, pay for themselves


def coordinates(statement: Statement, used: frozenset[str] | None) -> list[tuple[str, int]]:
    """Return the coordinates over which a case distinction ranges; the others do not matter.

    ``used`` are the texts of the coordinates on which the statement depends; None if not known.
    """
    out = []
    for name, sort in statement.unknowns:
        for n in range(sort.width):
            text = name if sort is Sort.SCALAR else f"{name}[{n}]"
            if used is None or text in used:
                out.append((name, n))
    return out


def counterexample(
    problem: Problem, used: frozenset[str] | None, wanted: bool = False
) -> tuple[Assignment | None, int]:
    """Return the first case in which the statement is false (or ``wanted``), and the number of cases.

    Raises :class:`TooLargeError` for more than 10⁸ cases. Raises :class:`UndecidedError` if time runs out, or
    if no such case is found but some cases are undecided.
    """
    field = problem.ring
    assert field.order is not None
    places = coordinates(problem.statement, used)
    cases = field.order ** len(places)
    if cases > MAX_CASES:
        raise TooLargeError(f"{field.order}^{len(places)} cases are more than 10^8")
    largest = MAX_PRIME if field.order == field.characteristic else MAX_TABLE
    if cases <= FEW_CASES or field.order > largest:
        found = _one_by_one(problem, places, wanted)
    else:
        found = _in_blocks(problem, places, wanted)
    return found, cases


def _assignment(
    statement: Statement, places: list[tuple[str, int]], values: Iterable[X], zero: X
) -> dict[str, X | tuple[X, ...]]:
    given = dict(zip(places, values, strict=True))
    return {
        name: given.get((name, 0), zero)
        if sort is Sort.SCALAR
        else tuple(given.get((name, n), zero) for n in range(4))
        for name, sort in statement.unknowns
    }


def _one_by_one(problem: Problem, places: list[tuple[str, int]], wanted: bool) -> Assignment | None:
    field, statement = problem.ring, problem.statement
    prime = field.is_field and field.order == field.characteristic and not statement.constants
    elements: Iterable[Scalar] = range(field.characteristic) if prime else field.elements()
    zero: Scalar = 0 if prime else field.zero
    # elements are not listed if at most one is needed: there may be 10⁸ or more
    cases = ((x,) for x in elements) if len(places) == 1 else product(elements, repeat=len(places))
    scalars = PrimeScalars(field.characteristic) if prime else RingScalars(field)
    seeker = Searcher(problem, scalars, wanted)
    doubt: UndecidedError | None = None
    for n, values in enumerate(cases):
        if n % 64 == 63 and problem.is_late:
            raise UndecidedError(f"the time limit was reached after {n} cases")
        assignment = _assignment(statement, places, values, zero)
        try:
            if seeker.decide(assignment):
                return lifted(field, assignment)
        except UndecidedError as error:  # another case may decide
            doubt = doubt or error
    if doubt is not None:
        raise doubt
    return None


def _in_blocks(problem: Problem, places: list[tuple[str, int]], wanted: bool) -> Assignment | None:
    import numpy as np

    field, statement = problem.ring, problem.statement
    order: int = field.order or 0
    table = _table(field, order ** len(places) >= MANY_CASES)
    scalars = _TableScalars(table)
    fixed = {text: scalars.element(constant(field, text)) for text in statement.constants}
    evaluator = Evaluator(scalars, problem.setting.trees, statement.sorts, fixed)
    holds = evaluator.function(problem.matrix)
    q, cases = len(table.elements), len(table.elements) ** len(places)
    for start in range(0, cases, BLOCK):
        if problem.is_late:
            raise UndecidedError(f"the time limit was reached after {start} of {cases} cases")
        index = np.arange(start, min(start + BLOCK, cases), dtype=np.int32)  # at most MAX_CASES
        digits = []
        for _ in places:
            index, digit = np.divmod(index, q)
            digits.append(table.entry(digit.astype(table.kind)))
        digits.reverse()
        values = _assignment(statement, places, digits, scalars.zero)
        defined = evaluator.bind(values)
        hit = (np.asarray(holds(values)) == wanted) & defined
        hits = np.flatnonzero(np.broadcast_to(hit, digits[0].array.shape))
        if len(hits):
            chosen = [table.elements[int(d.array[hits[0]])] for d in digits]
            return _assignment(statement, places, chosen, field.zero)
    return None


class _Table:
    """The arithmetic of a finite ring on the indices of its elements, which are labels if ``loops``."""

    def __init__(self, field: Ring, loops: bool) -> None:
        import numpy as np

        from hfield.fields.base.array_storage.finite import scalar_arrays

        self.field, p = field, field.characteristic
        prime = field.order == p  # the n-th element is then n·1
        self.elements = [field(n) for n in range(p)] if prime else list(field.elements())
        self.index = {field.key(x): n for n, x in enumerate(self.elements)}
        compiled = scalar_arrays(field) if loops else None
        dtype = compiled.dtype if compiled else np.int64 if prime else np.uint16
        self.kind: np.dtype[np.integer] = np.dtype(dtype)
        if compiled:
            # One of "sum", "difference", "product" and "negative" is computed on arrays of indices.
            self.compute: Callable[..., Indices] = compiled
        else:
            operations = _modulo(p) if prime else self._tabulated()
            self.compute = lambda name, *arrays: operations[name](*arrays)

    @cached_property
    def units(self) -> tuple[npt.NDArray[np.bool_], Indices]:
        """The mask of units, and the inverses, 0 for other elements.

        Raises :class:`UndecidedError` if the ring does not decide which elements are units.
        """
        import numpy as np

        field = self.field
        units = [field.is_unit(x) for x in self.elements]
        inverses = self._row(
            field.inverse(x) if unit else field.zero
            for x, unit in zip(self.elements, units, strict=True)
        )
        return np.array(units), inverses

    def _row(self, elements: Iterable[Scalar]) -> Indices:
        """Return the indices of some elements."""
        import numpy as np

        return np.array([self.index[self.field.key(x)] for x in elements], self.kind)

    def _tabulated(self) -> Operations:
        """Return the operations, by tables."""
        import numpy as np

        every = self.elements
        sums = np.array([self._row(x + y for y in every) for x in every])
        products = np.array([self._row(x * y for y in every) for x in every])
        minus = self._row(self.field.zero - x for x in every)
        return {
            "sum": lambda x, y: sums[x, y],
            "difference": lambda x, y: sums[x, minus[y]],
            "product": lambda x, y: products[x, y],
            "negative": lambda x: minus[x],
        }

    def entry(self, array: Indices) -> _Entries:
        return _Entries(self, array)


def _modulo(p: int) -> Operations:
    """Return the operations on residues, kept nonnegative because numpy divides negative numbers
    more slowly.
    """
    return {
        "sum": lambda x, y: (x + y) % p,
        "difference": lambda x, y: (x + p - y) % p,
        "product": lambda x, y: x * y % p,
        "negative": lambda x: (p - x) % p,
    }


class _Entries:
    """An array of indices whose addition and multiplication use tables."""

    __slots__ = ("array", "table")

    def __init__(self, table: _Table, array: Indices) -> None:
        self.table, self.array = table, array

    def __add__(self, other: _Entries) -> _Entries:
        return _Entries(self.table, self.table.compute("sum", self.array, other.array))

    def __neg__(self) -> _Entries:
        return _Entries(self.table, self.table.compute("negative", self.array))

    def __sub__(self, other: _Entries) -> _Entries:
        return _Entries(self.table, self.table.compute("difference", self.array, other.array))

    def __mul__(self, other: _Entries) -> _Entries:
        return _Entries(self.table, self.table.compute("product", self.array, other.array))


class _TableScalars(Decided[_Entries, "Booleans"]):
    def __init__(self, table: _Table) -> None:
        self.table = table
        self.zero, self.one = self.element(table.field.zero), self.element(table.field.one)

    def element(self, x: Scalar) -> _Entries:
        import numpy as np

        return self.table.entry(
            np.array(self.table.index[self.table.field.key(x)], self.table.kind)
        )

    def integer(self, n: int) -> _Entries:
        return self.element(self.table.field(n))

    def reciprocal(self, x: _Entries) -> tuple[_Entries, Booleans]:
        units, inverses = self.table.units
        return self.table.entry(inverses[x.array]), units[x.array]

    def equal(self, differences: Iterable[_Entries], defined: Booleans) -> Booleans:
        truth = defined
        zero = self.zero.array
        for d in differences:
            truth = truth & (d.array == zero)
        return truth

    def unequal(self, differences: Iterable[_Entries], defined: Booleans) -> Booleans:
        truth: Booleans = False
        zero = self.zero.array
        for d in differences:
            truth = truth | (d.array != zero)
        return truth & defined


@lru_cache(maxsize=16)
def _table(field: Ring, loops: bool) -> _Table:
    return _Table(field, loops)
