"""Search for values of the unknowns that make a statement false or true.

Small values come first, so that the witness can be checked by hand: first the prime field, with Python's
numbers, then small elements of the field, including zero divisors.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import accumulate, islice
from typing import TYPE_CHECKING

from hfield.core.product import Constants, Scalar, conjugate, multiply, trace
from hfield.errors import HFieldError, NotInvertibleError, UndecidedError
from hfield.fields.base.ring import Ring
from hfield.prover.evaluation.scalars import PrimeScalars, RingScalars, constant
from hfield.prover.evaluation.searcher import Assignment, Searcher
from hfield.prover.problem import Problem, remembered
from hfield.prover.statements.language import Sort
from hfield.prover.statements.setting import Setting

if TYPE_CHECKING:
    from hfield.core.product import Coordinates


Shape = tuple[tuple[int, bool], ...]  # number of coordinates of each unknown, and if it is a letter

HEAVIEST = 12  # the weight of a place
Values = tuple[Scalar | tuple[Scalar, ...], ...]
"""The values of unknowns in their order."""
KEPT = (150, 400)  # so many places are tried for many statements, and made once for all of them
MAX_FAST, MAX_SLOW = 20_000, 2_000  # weights of statements that are evaluated at large elements


def by_weight(
    unknowns: Sequence[tuple[str, Sort]],
    scalars: Sequence[Scalar],
    heaviest: int,
    letters: frozenset[str] = frozenset(),
) -> Iterator[Assignment]:
    """Yield assignments by total weight, where ``scalars[n]`` has weight n, and ``scalars[0]`` is 0.

    ``letters`` are tried in another order: first −1, then 1, 2 and the rest, and 0 last.
    """
    names = [name for name, _ in unknowns]
    for values in _values(_shape(unknowns, letters), scalars, heaviest):
        yield dict(zip(names, values, strict=True))


def _shape(unknowns: Sequence[tuple[str, Sort]], letters: frozenset[str]) -> Shape:
    return tuple((sort.width, name in letters) for name, sort in unknowns)


def _values(shape: Shape, scalars: Sequence[Scalar], heaviest: int) -> Iterator[Values]:
    """Yield the values of unknowns in the order of :func:`by_weight`."""
    own = nonzero_first(scalars)
    width = sum(width for width, _ in shape)
    ends = list(accumulate(width for width, _ in shape))
    pieces = [(end - width, end, letter) for end, (width, letter) in zip(ends, shape, strict=True)]
    for total in range(heaviest + 1):
        for vector in vectors(width, total, len(scalars) - 1):
            values, out = tuple([scalars[n] for n in vector]), []
            for start, end, letter in pieces:
                single = own[vector[start]] if letter else values[start]
                out.append(single if end == start + 1 else values[start:end])
            yield tuple(out)


def nonzero_first(scalars: Sequence[Scalar]) -> list[Scalar]:
    """Return the scalars reordered: the third one, −1, comes first, and 0 last."""
    return [*scalars[2:3], *scalars[1:2], *scalars[3:], *scalars[:1]]


def vectors(length: int, total: int, largest: int) -> Iterator[list[int]]:
    """Yield vectors of nonnegative integers with a given sum, none above ``largest``."""
    if total == 0:
        yield [0] * length
        return
    for zeros in range(length):  # in front of the first entry that is not 0
        for first in range(min(total, largest), 0, -1):
            if total - first > largest * (length - zeros - 1):
                break
            for rest in vectors(length - zeros - 1, total - first, largest):
                yield [*[0] * zeros, first, *rest]


def prime_scalars(p: int) -> tuple[int, ...]:
    """Return 0 and then small numbers of the prime field, each once."""
    numbers = (0, 1, -1, 2, -2, 3)
    return tuple(dict.fromkeys(n % p for n in numbers)) if p else numbers


@lru_cache(maxsize=64)
def small_scalars(field: Ring) -> tuple[Scalar, ...]:
    """Return some elements of the field, beginning with 0 and 1; all of them if there are at most 64."""
    if field.order is not None:
        return tuple(islice(field.elements(), 64))
    found: dict[Hashable, Scalar] = {}
    candidates: list[Callable[[], Scalar]] = [
        lambda: field.zero,
        lambda: field.one,
        lambda: field(-1),
        lambda: field.gen,
        lambda: field.gen + field.one,
        lambda: field(2),
        lambda: field.inverse(field(2)),
        lambda: field.zero - field.gen,
    ]
    for make in candidates:
        try:
            x = make()
        except HFieldError:  # no generator, or 2 has no inverse
            continue
        found.setdefault(field.key(x), x)
    return tuple(found.values())


@lru_cache(maxsize=256)
def zero_divisors(setting: Setting) -> tuple[Coordinates, ...]:
    """Return elements of norm 0 if the algebra is known to have some."""
    from hfield.fields.quadratic_forms.norm_forms.zero_norms import zero_norm

    field = setting.field
    assert field is not None
    try:
        c = Constants(*(constant(field, text) for text in setting.constants))
        found = zero_norm(field, c).element
    except UndecidedError:
        return ()
    if found is None:
        return ()
    out = [found, conjugate(c, found)]
    one, zero = field.one, field.zero
    for unit in ((zero, one, zero, zero), (zero, zero, one, zero)):  # often nilpotent
        out.append(multiply(c, found, unit))
    s, t = (trace(c, q) for q in out[-2:])  # of found·i and found·j
    nilpotent = multiply(c, found, (zero, t, zero - s, zero))
    if not all(map(field.vanishes, nilpotent)):
        out.append(nilpotent)
    try:  # an idempotent: q² = tr(q)·q when N(q) = 0
        factor = field.inverse(trace(c, found))
    except NotInvertibleError:
        return tuple(out)
    idempotent = tuple(u * factor for u in found)
    return (
        *out,
        idempotent,
        (idempotent[0] + idempotent[0] - one, *(u + u for u in idempotent[1:])),
    )


def pool(problem: Problem) -> list[Coordinates]:
    """Return a few typical quaternions: 0, the basis, zero divisors, small combinations."""
    field = problem.ring
    zero, one = field.zero, field.one
    out: list[Coordinates] = [(zero, zero, zero, zero)]
    out += [(one, zero, zero, zero), (zero, one, zero, zero)]
    out += [(zero, zero, one, zero), (zero, zero, zero, one)]
    out += zero_divisors(problem.setting)
    for x in small_scalars(field)[2:6]:
        out.extend([(x, zero, zero, zero), (zero, x, zero, zero), (zero, one, x, zero)])
    return out


def from_pool(
    unknowns: Sequence[tuple[str, Sort]],
    quaternions: Sequence[Coordinates],
    scalars: Sequence[Scalar],
) -> Iterator[Assignment]:
    """Yield assignments of the given quaternions and scalars, small indices first."""
    kinds = [scalars if sort is Sort.SCALAR else quaternions for _, sort in unknowns]
    names = [name for name, _ in unknowns]
    largest = max((len(kind) for kind in kinds), default=1) - 1
    for total in range(largest * len(kinds) + 1):
        for vector in vectors(len(kinds), total, largest):
            if all(n < len(kind) for n, kind in zip(vector, kinds, strict=True)):
                chosen = (kind[n] for n, kind in zip(vector, kinds, strict=True))
                yield dict(zip(names, chosen, strict=True))


def prime_search(problem: Problem, p: int, limit: int, wanted: bool = False) -> Assignment | None:
    """Search the prime field of characteristic p; a witness found there holds over every extension.

    Fields of the same characteristic share the result, and a longer search continues a shorter one.
    """
    if problem.statement.constants:
        return None
    return _search_begun(problem, p, wanted).further(problem, limit)


@remembered
def _search_begun(problem: Problem, p: int, wanted: bool) -> _PrimeSearch:
    return _PrimeSearch(p, wanted)


@dataclass
class _PrimeSearch:
    """A search for one truth value of one statement: the number of points tried, and the result."""

    p: int
    wanted: bool
    tried: int = 0
    found: Assignment | None = None  # at the last place tried

    def further(self, problem: Problem, limit: int) -> Assignment | None:
        """Return the first hit among ``limit`` points, trying only those that were not tried before."""
        if self.found is None and self.tried < limit:
            self._try(problem, limit)
        return None if self.found is None or self.tried > limit else dict(self.found)

    def _try(self, problem: Problem, limit: int) -> None:
        statement, scalars = problem.statement, prime_scalars(self.p)
        if not self.p and statement.weight > MAX_FAST:
            scalars = scalars[:3]
        seeker = Searcher(problem, PrimeScalars(self.p), self.wanted)
        if seeker.is_constant:
            limit = 1
        names = [name for name, _ in statement.unknowns]
        shape = _shape(statement.unknowns, problem.letters)
        for values in _places(shape, scalars, self.tried, limit):
            if not self.tried & 15 and problem.is_late:
                return
            self.tried += 1
            place = dict(zip(names, values, strict=True))
            if seeker.test(place):
                self.found = place
                return


def _places(shape: Shape, scalars: tuple[int, ...], start: int, limit: int) -> Iterator[Values]:
    """Yield values of unknowns by weight, starting at index ``start``."""
    kept = next((count for count in KEPT if limit <= count), None)
    places = _values(shape, scalars, HEAVIEST) if kept is None else _kept(shape, scalars, kept)
    return islice(places, start, limit)


@lru_cache(maxsize=256)
def _kept(shape: Shape, scalars: tuple[int, ...], count: int) -> tuple[Values, ...]:
    return tuple(islice(_values(shape, scalars, HEAVIEST), count))


def ring_search(problem: Problem, limit: int, wanted: bool = False) -> Assignment | None:
    """Search small elements of the ring, and its zero divisors."""
    field, statement = problem.ring, problem.statement
    if field.order is None and statement.weight > (MAX_SLOW if field.gen_name else MAX_FAST):
        return None
    seeker = Searcher(problem, RingScalars(field), wanted)
    scalars = small_scalars(field)
    places = by_weight(statement.unknowns, scalars, HEAVIEST, problem.letters)
    if problem.letters:
        return seeker.first(islice(places, 2 * limit))
    found = seeker.first(islice(from_pool(statement.unknowns, pool(problem), scalars), limit))
    return seeker.first(islice(places, limit)) if found is None else found


def true_place(problem: Problem, limit: int) -> Assignment | None:
    """Return values at which the statement is true, or None."""
    field = problem.field
    primes = (0, 2, 3) if field is None else (field.characteristic,) if field.is_field else ()
    for p in primes:
        found = prime_search(problem, p, limit, True)
        if found is not None:
            return found
    return None if field is None else ring_search(problem, limit, True)


def witness_texts(field: Ring, assignment: Assignment) -> dict[str, list[str]]:
    """Write an assignment as texts that the field can read back."""
    return {
        name: [field.text(u) for u in (x if isinstance(x, tuple) else (x,))]
        for name, x in assignment.items()
    }


def shown(witness: Mapping[str, Sequence[str]]) -> str:
    """Write the values of a witness in a line: scalars, and the coordinates of quaternions."""
    return ", ".join(
        f"{name} = {v[0]}" if len(v) == 1 else f"{name} = ({', '.join(v)})"
        for name, v in witness.items()
    )
