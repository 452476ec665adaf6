"""Two elements of an ideal whose norms have a given sum: Qlapoti.

Let I be a left ideal of norm N of a p-extremal order with the frame R + R·β. If it contains a λ + β with λ in
R, it contains u + v·β for all u ≡ v·λ modulo N. So x = v·λ + N·w + v·β and y = N·w′ have norms of sum S·N if

    N(v·λ + N·w) + N²·N(w′) = S·N − p·N(v).

For a v in R that is one linear condition on w modulo N. Each short solution gives N(w′), and Cornacchia's
algorithm finds w′. There are enough solutions for S ≥ 2p (Borin, Corte-Real Santos, Eriksen, Invernizzi,
Mula, Schaeffler and Vercauteren, "Qlapoti", ePrint 2025/1604). In other orders, for small p, the norms of
many short elements are listed and sorted, which shows the pairs with the sum.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, count, islice
from typing import TYPE_CHECKING

from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import LatticeError, UndecidedError, shorten
from hfield.orders import hermite
from hfield.orders.klpt import by_norm, random_elements
from hfield.orders.lattice_values import LatticeValue, contains, multiple, spanning_rows
from hfield.orders.quadratic_frames import (
    QuadraticFrame,
    extremal_frame,
    frame,
    in_frame,
    represent,
)
from hfield.orders.strong_approximation import MAX_FRAME_DISCRIMINANT, close, expect_maximal

if TYPE_CHECKING:
    import numpy as np

Pair = tuple[Quaternion, Quaternion]
MAX_SEARCHED_DISCRIMINANT = 2**40
"""Above this discriminant pairs are not searched for by sorting."""
SAMPLES = 2**12, 2**15, 2**18, 2**20, 2**22
"""So many elements are sorted, one number after the other."""
MAX_SMALL, MAX_SMALL_NORM, MAX_TRIALS = 2**20, 64, 20_000
"""Up to this discriminant, or this norm of an equivalent ideal, random elements are tried."""
MAX_PRIMES, MAX_MULTIPLIERS, MAX_STEPS = 12, 3_000, 60


def with_sum(ideal: LatticeValue, order: LatticeValue, total: int, seed: int) -> Pair:
    """Return x and y in a left ideal of a maximal order with coprime N(x)/N(I) and N(y)/N(I) of a given sum.

    Raises :class:`LatticeError` for other orders, and :class:`UndecidedError` where none were found.
    """
    p = expect_maximal(order, "equivalent_pair()")
    f = extremal_frame(order, MAX_FRAME_DISCRIMINANT)
    if f is None and p >= MAX_SEARCHED_DISCRIMINANT:
        raise LatticeError(
            "equivalent_pair() is for ideals of p-extremal orders, such as A.extremal_order(), and of other "
            "maximal orders for p < 2^40: connect this order to an extremal one with connecting_ideal()"
        )
    searched, rng = SAMPLES if p < MAX_SEARCHED_DISCRIMINANT else (), random.Random(seed)
    found = _by_sorting(ideal, total, searched[:2], seed)
    if found is None and f is not None:
        found = _by_qlapoti(ideal, f, total, rng)
    if (
        found is None
        and total > p // 4
        and (p < MAX_SMALL or next(by_norm(ideal))[1] < MAX_SMALL_NORM)
    ):
        found = _by_representing(ideal, f or frame(order), total, rng)
    if found is None:
        found = _by_sorting(ideal, total, searched[2:], seed)
    if found is None:
        raise UndecidedError(
            f"no two equivalent ideals with coprime norms of the sum {shorten(total)} were found; a sum of "
            f"at least about 2·p = {shorten(2 * p)} is needed, and an ideal with short elements of odd norms "
            "prime to the sum"
        )
    return found


def _by_qlapoti(
    ideal: LatticeValue, f: QuadraticFrame, total: int, rng: random.Random
) -> Pair | None:
    """Return such a pair for an ideal of a p-extremal order, or None."""
    tried = 0
    for row, norm in _elements(ideal, rng):
        if math.gcd(norm, 2 * f.norm * f.discriminant * total) > 1:
            continue
        # N(v·λ + N·w) is about N³ and less than S·N
        if f.norm >= total * norm or norm * norm > 16 * total:
            continue
        tried += 1
        if tried > MAX_PRIMES:
            return None
        x = ideal.element(row)
        start = multiple(ideal, x.conjugate() / ideal.norm, "right")
        found = _in_prime_ideal(start, f, norm, total)
        if found is not None:
            first, second = (y * x / norm for y in found)
            return first, second
    return None


def _by_representing(
    ideal: LatticeValue, f: QuadraticFrame, total: int, rng: random.Random
) -> Pair | None:
    """Return the same for an ideal equivalent to one of small norm N, in an order with any frame.

    x is random, and of the elements whose norm is that which is left about one in N + 1 lies in the ideal.
    Some N may be excluded, as a frame has an index in the order; quotients of its elements are tried as well.
    """
    starts = {norm: row for row, norm in islice(by_norm(ideal), 50)}
    for norm, least in islice(starts.items(), 5):
        x = ideal.element(least)
        start = multiple(ideal, x.conjugate() / ideal.norm, "right")
        found = _by_representing_in(start, f, norm, total, rng)
        if found is not None:
            first, second = (y * x / norm for y in found)
            return first, second
    return None


def _by_representing_in(
    ideal: LatticeValue, f: QuadraticFrame, norm: int, total: int, rng: random.Random
) -> Pair | None:
    """Return the same for a left ideal of norm N; norms are multiples of N."""
    rows, gram = ideal.reduced
    bounds = _bounds(gram, 2 * total)
    denominators = 1, 2, -f.discriminant
    left = 100 + 64 * norm
    for trial in range(MAX_TRIALS):
        row = hermite.combination([rng.randint(-b, b) for b in bounds], rows)
        n = ideal.multiple(row)
        if not 0 < n < total or math.gcd(n, total) > 1:
            continue
        den = denominators[trial % 3]
        found = in_frame(f, norm * (total - n) * den**2, rng, 100)
        if found is not None and contains(ideal, found / den):
            return ideal.element(row), found / den
        left -= 1
        if not left:
            return None
    return None


def _elements(ideal: LatticeValue, rng: random.Random) -> Iterator[tuple[tuple[int, ...], int]]:
    """Yield some elements as rows with their norms as multiples of the norm of the ideal."""
    yield from islice(by_norm(ideal), 2_000)
    yield from islice(random_elements(ideal, rng), 2_000)


def _in_prime_ideal(ideal: LatticeValue, f: QuadraticFrame, norm: int, total: int) -> Pair | None:
    """Return the same for a left ideal of norm N; norms are multiples of N."""
    scalar = _scalar_part(ideal, f, norm)
    if scalar is None:
        return None
    p, square = f.norm, norm * norm
    # about one in so many numbers is a norm
    left = 100 + 16 * total.bit_length()
    for v in islice(_multipliers(f, (total * norm - 1) // p), MAX_MULTIPLIERS):
        g = _centred(_times(f, v, scalar), norm)
        whole = total * norm - p * f.binary(*v)
        rest = (whole - f.binary(*g)) // norm
        # Tr(g·conj(w)) ≡ rest modulo N
        first, second = (2 * g[0] + f.t * g[1]) % norm, (f.t * g[0] + 2 * f.n * g[1]) % norm
        if math.gcd(first, norm) > 1:
            continue
        inverse = pow(first, -1, norm)
        form = [[2, f.t], [f.t, 2 * f.n]]
        steps = close(-second * inverse % norm, rest * inverse % norm, norm, g, form)
        misses = 0
        for c, e in islice(steps, MAX_STEPS + left // 4):
            u = g[0] + norm * c, g[1] + norm * e
            m = (whole - f.binary(*u)) // square
            if m <= 0:
                misses += 1
                if misses > 12:
                    break
                continue
            if math.gcd(norm * m, total) > 1:
                continue
            left -= 1
            if not left:
                return None
            last = represent(f.discriminant, m)
            if last is not None:
                return f.element(*u, *v), norm * f.element(*last, 0, 0)
    return None


def _scalar_part(ideal: LatticeValue, f: QuadraticFrame, norm: int) -> tuple[int, int] | None:
    """Return the coordinates of λ in R, modulo N, with λ + β in an ideal that contains N·O, or None.

    N is prime to the index of the frame.
    """
    basis = [f.beta, f.alpha * f.beta, ideal.algebra(1), f.alpha]
    den, rows = spanning_rows(ideal.ambient, basis)
    # coordinates over the frame of the ideal, whose denominators are prime to N
    inside, d = hermite.in_coordinates(rows, ideal.matrix)
    entries = [[Fraction(int(c) * den, d * ideal.den) for c in row] for row in inside.tolist()]
    table = [[c.numerator * pow(c.denominator, -1, norm) % norm for c in row] for row in entries]
    scaled = [[norm * int(m == n) for n in range(4)] for m in range(4)]
    first = fmpz_mat(table + scaled).hnf().tolist()[0]
    if first[0] != 1 or first[1] != 0:
        return None
    return int(first[2]), int(first[3])


def _times(f: QuadraticFrame, v: tuple[int, int], w: tuple[int, int]) -> tuple[int, int]:
    """Return the product in R, α² = t·α − n."""
    (a, b), (c, d) = v, w
    return a * c - f.n * b * d, a * d + b * c + f.t * b * d


def _centred(v: tuple[int, int], n: int) -> tuple[int, int]:
    a, b = ((c + n // 2) % n - n // 2 for c in v)
    return a, b


def _multipliers(f: QuadraticFrame, largest: int) -> Iterator[tuple[int, int]]:
    """Yield v ≠ 0 in R, one of ±v, of norm at most a number, the small ones first."""
    for size in count(1):
        # N(v) ≥ |d|·x²/(4·N(α)) and ≥ |d|·y²/4
        if -f.discriminant * size * size > 4 * f.n * largest:
            return
        sides = ((x, y) for y in range(size) for x in (-size, size))
        top = ((x, size) for x in range(-size, size + 1))
        for x, y in chain(sides, top):
            if (y or x > 0) and math.gcd(x, y) == 1 and f.binary(x, y) <= largest:
                yield x, y


def _by_sorting(ideal: LatticeValue, total: int, samples: Sequence[int], seed: int) -> Pair | None:
    """Return such a pair among so many short elements, or all of them, for a total of at most 50 bits."""
    import numpy as np

    rows, gram = ideal.reduced
    bounds = _bounds(gram, 2 * total)
    if total.bit_length() > 50 or max(bounds) > 2**26:
        return None
    box = math.prod(2 * b + 1 for b in bounds)
    numbers = np.random.default_rng(seed)
    for size in samples:
        if box <= size:
            ranges = [np.arange(-b, b + 1, dtype=np.int64) for b in bounds]
            vectors = np.stack(np.meshgrid(*ranges, indexing="ij"), axis=-1).reshape(-1, 4)
        else:
            columns = [numbers.integers(-b, b + 1, size, dtype=np.int64) for b in bounds]
            vectors = np.stack(columns, axis=-1)
        pair = _matching(vectors, gram, total)
        if pair is not None:
            first, second = (ideal.element(hermite.combination(v, rows)) for v in pair)
            return first, second
        if box <= size:
            return None
    return None


def _matching(
    vectors: np.ndarray, gram: list[list[int]], total: int
) -> tuple[list[int], list[int]] | None:
    """Return two vectors with coprime values of half a form and a given sum, or None."""
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


def _bounds(gram: list[list[int]], length: int) -> list[int]:
    """Return how large each coordinate of a vector with x·gram·x ≤ length can be."""
    inverse = fmpz_mat(gram).inv()
    return [math.isqrt(int(length * inverse[k, k].p) // int(inverse[k, k].q)) for k in range(4)]
