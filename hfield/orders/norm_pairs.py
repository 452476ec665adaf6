"""Find two elements of an ideal whose norms have a given sum S·N (Qlapoti).

Let J be a left ideal of norm N of a p-extremal order with the frame R + R·β, and 𝔞 = J ∩ R. For x = u + z·β
in J, c in R and a in 𝔞 the element y = c·x − a lies in J. With D = 1 + N(c),

    D·(N(x) + N(y)) = N(D·x − c̄·a) + N(a).

For given z and c let U = D·u + s with s in 𝔞. Then x = (U + c̄·a)/D + z·β has to lie in J, so D·N(𝔞) divides
N(s) + N(a). Modulo D·N(𝔞), the equation N(U) + N(a) + p·D²·N(z) = D·S·N is one linear condition on s. Each
short solution gives N(a), and Cornacchia's algorithm finds a. For c = 0 this is the algorithm of Borin,
Corte-Real Santos, Eriksen, Invernizzi, Mula, Schaeffler and Vercauteren ("Qlapoti", ePrint 2025/1604), where
N divides N(y)/N. Other c are used for ideals in which the norms of all short elements have a factor in common
with S, such as ideals of norm 2ᵏ.

Two other methods are used in special cases. For small p the norms of many short elements are sorted to find
pairs with the given sum. In planes of small discriminant x is chosen at random, and y is an element of the
remaining norm.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, count, islice
from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, NoEquivalentIdealError, UndecidedError, shorten
from hfield.orders import hermite
from hfield.orders.klpt import by_norm, random_elements
from hfield.orders.lattice_values import LatticeValue, contains, multiple, spanning_rows
from hfield.orders.norm_search import PLANE_TRIALS, bounds, has_small_planes, on_planes
from hfield.orders.quadratic_frames import QuadraticFrame, extremal_frame
from hfield.orders.represent_integer import represent
from hfield.orders.short_elements import least_norm
from hfield.orders.strong_approximation import MAX_FRAME_DISCRIMINANT, close, expect_maximal

if TYPE_CHECKING:
    import numpy as np

Pair = tuple[Quaternion, Quaternion]
MAX_SEARCHED_DISCRIMINANT = 2**40
"""Above this discriminant pairs are not searched for by sorting."""
SAMPLES = 2**12, 2**15, 2**18, 2**20, 2**22
"""So many elements are sorted, one number after the other."""
MAX_TRIALS = 1_000
"""So many random elements are tried."""
MAX_STARTS, MAX_MULTIPLIERS, MAX_STEPS, MAX_FAILURES = 100, 300, 60, 24


def with_sum(ideal: LatticeValue, order: LatticeValue, total: int, seed: int) -> Pair:
    """Return x and y in a left ideal of a maximal order; N(x)/N(I) and N(y)/N(I) are coprime, with sum
    ``total``.

    Raises :class:`LatticeError` for other orders, :class:`NoEquivalentIdealError` if all pairs were tried,
    and :class:`UndecidedError` if none was found.
    """
    p = expect_maximal(order, "equivalent_pair()")
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT)
    if f is None and p >= MAX_SEARCHED_DISCRIMINANT:
        raise LatticeError(
            "equivalent_pair() is for ideals of p-extremal orders, such as A.extremal_order(), and of other "
            "maximal orders for p < 2^40: connect this order to an extremal one with connecting_ideal()"
        )
    searched, rng = SAMPLES if p < MAX_SEARCHED_DISCRIMINANT else SAMPLES[:1], random.Random(seed)
    found, proved = _by_sorting(ideal, total, searched[:2], seed)
    if found is None and not proved:
        found = _by_qlapoti(ideal, f, total, rng) if f is not None else None
        if found is None and total > p // 4:
            found = _by_representing(ideal, total, rng)
        if found is None:
            found, proved = _by_sorting(ideal, total, searched[2:], seed)
    if found is not None:
        return found
    needed = f"a sum of at least about 2·p = {shorten(2 * p)} is needed"
    if proved:
        raise NoEquivalentIdealError(
            f"no two equivalent ideals have coprime norms of the sum {shorten(total)}: all that have smaller "
            f"norms were tried; {needed}"
        )
    raise UndecidedError(
        f"no two equivalent ideals with coprime norms of the sum {shorten(total)} were found; {needed}"
    )


def _by_qlapoti(
    ideal: LatticeValue, f: QuadraticFrame, total: int, rng: random.Random
) -> Pair | None:
    """Return such a pair for an ideal of a p-extremal order, or None."""
    norms, lines = set[int](), set[tuple[int, ...]]()
    for row, norm in _elements(ideal, rng):
        content = math.gcd(*row)
        line = tuple(c // content for c in row)
        # products with units and numbers lead to the same ideals
        if norm * norm > 16 * total or norm in norms or line in lines:
            continue
        norms.add(norm)
        lines.add(line)
        if len(norms) > MAX_STARTS:
            return None
        x = ideal.element(row)
        start = multiple(ideal, x.conjugate() / ideal.norm, "right")
        found = _in_ideal(start, f, norm, total)
        if found is not None:
            first, second = (y * x / norm for y in found)
            return first, second
    return None


def _by_representing(ideal: LatticeValue, total: int, rng: random.Random) -> Pair | None:
    """Return such a pair for an ideal with planes of small discriminant; small p give such planes in any
    order.

    x is random, and y is an element of the remaining norm.
    """
    if not has_small_planes(ideal):
        return None
    rows, gram = ideal.reduced
    sides = bounds(gram, 2 * total)
    for _ in range(MAX_TRIALS):
        row = hermite.combination([rng.randint(-b, b) for b in sides], rows)
        n = ideal.multiple(row)
        if not 0 < n < total or math.gcd(n, total) > 1:
            continue
        y = on_planes(ideal, total - n, rng, PLANE_TRIALS[:1])
        if y is not None:
            return ideal.element(row), ideal.element(y)
    return None


def _elements(ideal: LatticeValue, rng: random.Random) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield some elements as rows with their norms as multiples of the norm of the ideal."""
    yield from islice(by_norm(ideal), 2_000)
    yield from islice(random_elements(ideal, rng), 2_000)


def _in_ideal(ideal: LatticeValue, f: QuadraticFrame, norm: int, total: int) -> Pair | None:
    """Return such a pair for a left ideal of norm N; norms are given as multiples of N."""
    start = _SplitIdeal.of(ideal, f, norm)
    if start is None:
        return None
    for c in ((0, 0), (1, 0), (0, 1), (1, 1), (2, 0)):
        # N divides N(y)/N for c = 0, and units lead to the same elements
        if (c == (0, 0) and math.gcd(start.step, total) > 1) or (c == (0, 1) and f.n == 1):
            continue
        found = _of_shape(start, f, total, c)
        if found is not None:
            return found
    return None


@dataclass(frozen=True)
class _SplitIdeal:
    """A left ideal J of norm N, the a with R·a = J ∩ R, and elements u + z·β, all in coordinates over a
    denominator.

    ``step`` is N(a)/N.
    """

    ideal: LatticeValue
    den: int
    norm: int
    over: tuple[tuple[int, ...], tuple[int, ...]]
    generator: tuple[int, int]
    step: int

    @classmethod
    def of(cls, ideal: LatticeValue, f: QuadraticFrame, norm: int) -> _SplitIdeal | None:
        """Return the data of an ideal J; None if J ∩ R is not principal."""
        basis = [f.beta, f.alpha * f.beta, ideal.algebra(1), f.alpha]
        den, rows = spanning_rows(ideal.ambient, basis)
        inside, d = hermite.in_coordinates(rows, ideal.matrix)
        # the coordinates are inside·den/(d·ideal.den)
        scale = math.gcd(den, d * ideal.den)
        den, below = den // scale, d * ideal.den // scale
        first, second, *plane = (inside * den).hnf().tolist()
        lattice = fmpz_mat([row[2:] for row in plane])
        form = fmpz_mat([[2, f.t], [f.t, 2 * f.n]])
        _, steps = (lattice * form * lattice.transpose()).lll(transform=True, rep="gram")
        index = abs(int(lattice.det()))
        reduced_rows = hermite.tuples(steps * lattice)
        a = min(reduced_rows, key=lambda v: f.binary(*v))
        if f.binary(*a) != index:
            return None
        over = tuple(int(x) for x in first), tuple(int(x) for x in second)
        return cls(ideal, below, norm, over, (a[0], a[1]), index // (norm * below**2))


def _of_shape(start: _SplitIdeal, f: QuadraticFrame, total: int, c: tuple[int, int]) -> Pair | None:
    """Return x and y = c·x − a, with a in R, for a left ideal of norm N."""
    size, conjugate = 1 + f.binary(*c), (c[0] + f.t * c[1], -c[1])
    unit, p = start.norm * start.den**2, f.norm
    g, step = start.generator, start.step
    ideal = fmpz_mat([g, _times(f, (0, 1), g)])
    form = fmpz_mat([[2, f.t], [f.t, 2 * f.n]])
    whole = size * total * unit
    left, failures = 100 + 16 * total.bit_length(), 0
    (b0, b1, *_), (_, b2, *_) = start.over
    for k, (i, j) in enumerate(_small_pairs()):
        if k > MAX_MULTIPLIERS:
            return None
        z = i * b0, i * b1 + j * b2
        rest = whole - p * size**2 * f.binary(*z)
        if rest <= 0:
            continue
        u = tuple(size * (i * v + j * w) for v, w in zip(*start.over, strict=True))[2:]
        near = fmpz_mat([u])
        # Tr(U·conj(s)) = rest − N(u) modulo D·N(𝔞), all divided by D·N
        below = size * unit
        traces = [int(x) // below for x in (near * form * ideal.transpose()).entries()]
        solved = _solutions(traces, (rest - f.binary(*u)) // below, step)
        if solved is None:
            continue
        offset, kernel = solved
        first = (near + fmpz_mat([offset]) * ideal).tolist()[0]
        misses = 0
        for v in islice(close(first, fmpz_mat(kernel) * ideal, form), MAX_STEPS + left // 4):
            m = (rest - f.binary(*v)) // (step * unit)
            if m <= 0:
                misses += 1
                if misses > 12:
                    break
                continue
            left -= 1
            if not left:
                return None
            last = represent(f.discriminant, m)
            if last is None:
                continue
            # which of them leads into J depends on residues, at 2 often in the same way for all z
            for w in _of_same_norm(f, last):
                pair = _pair(start, f, total, c, conjugate, (v[0], v[1]), z, _times(f, w, g))
                if pair is not None:
                    return pair
            failures += 1
            if failures > MAX_FAILURES:
                return None
    return None


def _pair(
    start: _SplitIdeal,
    f: QuadraticFrame,
    total: int,
    c: tuple[int, int],
    conjugate: tuple[int, int],
    U: tuple[int, int],
    z: tuple[int, int],
    a: tuple[int, int],
) -> Pair | None:
    """Return x = (U + c̄·a)/D + z·β and c·x − a if x lies in the ideal and the norms are coprime."""
    size, den = 1 + f.binary(*c), start.den
    v = [m + n for m, n in zip(U, _times(f, conjugate, a), strict=True)]
    if v[0] % size or v[1] % size:
        return None
    x = f.element(v[0] // size, v[1] // size, *z) / den
    if math.gcd(int(x.norm() / start.norm), total) > 1 or not contains(start.ideal, x):
        return None
    return x, f.element(*c, 0, 0) * x - f.element(*a, 0, 0) / den


def _solutions(
    traces: list[int], value: int, modulus: int
) -> tuple[list[int], list[list[int]]] | None:
    """Return one s with traces·s ≡ value, and a basis of all s with traces·s ≡ 0, modulo a number."""
    g = math.gcd(*traces, modulus)
    if value % g:
        return None
    first, second, m = traces[0] // g, traces[1] // g, modulus // g
    # the Hermite form of (first, 1, 0), (second, 0, 1), (m, 0, 0)
    (_, *one), *kernel = fmpz_mat([[first, 1, 0], [second, 0, 1], [m, 0, 0]]).hnf().tolist()
    return [int(x) * (value // g) for x in one], [[int(x) for x in row[1:]] for row in kernel]


def _of_same_norm(f: QuadraticFrame, v: tuple[int, int]) -> Iterator[tuple[int, int]]:
    """Yield the products of an element of R and of its conjugate with the units of R."""
    for w in (v, (v[0] + f.t * v[1], -v[1])):
        x = w
        while True:
            yield x
            yield -x[0], -x[1]
            x = _times(f, x, (0, 1))  # α is a unit, of order 4 or 6, or none is but ±1
            if f.n > 1 or x in (w, (-w[0], -w[1])):
                break


def _times(f: QuadraticFrame, v: tuple[int, int], w: tuple[int, int]) -> tuple[int, int]:
    """Return the product in R, α² = t·α − n."""
    (a, b), (c, d) = v, w
    return a * c - f.n * b * d, a * d + b * c + f.t * b * d


def _small_pairs() -> Iterator[tuple[int, int]]:
    """Yield one of ±v for the primitive pairs of integers, small ones first."""
    for size in count(1):
        sides = ((x, y) for y in range(size) for x in (-size, size))
        top = ((x, size) for x in range(-size, size + 1))
        for x, y in chain(sides, top):
            if (y or x > 0) and math.gcd(x, y) == 1:
                yield x, y


def _by_sorting(
    ideal: LatticeValue, total: int, samples: Sequence[int], seed: int
) -> tuple[Pair | None, bool]:
    """Return such a pair of short elements; for a total of at most 50 bits all of them are tried.

    The second result is whether all were tried.
    """
    import numpy as np

    rows, gram = ideal.reduced
    if total < 2 * least_norm(ideal):
        return None, True
    sides = bounds(gram, 2 * total)
    if total.bit_length() > 50 or max(sides) > 2**26:
        return None, False
    box = math.prod(2 * b + 1 for b in sides)
    numbers = np.random.default_rng(seed)
    for size in samples:
        if box <= size:
            ranges = [np.arange(-b, b + 1, dtype=np.int64) for b in sides]
            vectors = np.stack(np.meshgrid(*ranges, indexing="ij"), axis=-1).reshape(-1, 4)
        else:
            columns = [numbers.integers(-b, b + 1, size, dtype=np.int64) for b in sides]
            vectors = np.stack(columns, axis=-1)
        pair = _matching(vectors, gram, total)
        if pair is not None:
            first, second = (ideal.element(hermite.combination(v, rows)) for v in pair)
            return (first, second), True
        if box <= size:
            return None, True
    return None, False


def _matching(
    vectors: np.ndarray, gram: list[list[int]], total: int
) -> tuple[list[int], list[int]] | None:
    """Return two vectors whose values of half the form are coprime with a given sum, or None."""
    import numpy as np

    # below 2⁶³ in the box, where |x·gram·x| ≤ 16·16·2·total
    norms = ((vectors @ np.array(gram, dtype=np.int64)) * vectors).sum(axis=1) // 2
    inside = (norms > 0) & (norms < total)
    vectors, norms = vectors[inside], norms[inside]
    norms, places = np.unique(norms, return_index=True)
    matched = np.searchsorted(norms, total - norms)
    ok = (matched < len(norms)) & (norms[np.minimum(matched, len(norms) - 1)] == total - norms)
    ok &= np.gcd(norms, total) == 1
    for k in np.flatnonzero(ok)[:1]:
        return vectors[places[k]].tolist(), vectors[places[matched[k]]].tolist()
    return None
