"""Find an element of given norm in any lattice over ℤ of a definite algebra, or prove that there is none.

The norm, divided by that of the lattice, is a quadratic form in four coordinates. For small norms three of
them are enumerated, in blocks of an array. If there are too many values, random ones are tried. Large norms
are represented by a plane of the lattice and its orthogonal complement: ``n = f(x, y) + g(z, w)``. Once (z,
w) is chosen, the pairs (x, y) with f(x, y) = m are shortest vectors of planar lattices, one for each root of
f modulo m (Cornacchia's algorithm for any form).
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, islice, product
from typing import TYPE_CHECKING

from flint import fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import factor
from hfield.core.primality import WORD
from hfield.fields.rationals.whole_numbers import crt, fraction, sqrt_mod
from hfield.orders import enumeration, hermite
from hfield.orders.allowed_norms import Divisors
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.represent_integer import likely
from hfield.orders.short_elements import first_of_norm, least_norm, up_to

if TYPE_CHECKING:
    import numpy as np

Row = tuple[int, ...]
MAX_HEADS_WITHOUT_ARRAYS, MAX_HEADS_WITHOUT_PLANES = 1_000, 2**17
"""Up to these numbers of choices of three coordinates, arrays and planes are not used."""
MAX_HEADS, MAX_ALL_HEADS = 2**24, 2**26
"""At most this number of choices is tried for one norm, and for all divisors of a number."""
BLOCK = 2**16
MAX_RANGE = 2**10
"""At most this number of values of the second coordinate is tried, where the search is not complete."""
MAX_SHORT, MAX_SHORT_OF_LARGE = 10_000, 300
"""At most this number of shortest elements is listed, in small and in large lattices."""
SMALL_VOLUME = 2**24
"""In lattices of at most this volume, for ideals the discriminant, norms of all sizes are searched."""
MAX_DIVISORS = 200_000
MAX_PLANES, MAX_PLANE_DISCRIMINANT = 24, 2**28
"""At most this number of planes is used; planes of larger discriminant represent too few numbers."""
MAX_ROOTS = 64
PLANE_TRIALS = 1_000, 30_000
"""Pairs (z, w) tried for each plane, in two rounds, since a plane may represent no such number."""


def of_norm(lattice: LatticeValue, n: int, rng: random.Random) -> tuple[Quaternion | None, bool]:
    """Return an element with N(x) = n·N(L), or None, and whether this is proved."""
    row, decided = _row_of_norm(lattice, n, rng)
    return (None if row is None else lattice.element(row)), decided


def _row_of_norm(lattice: LatticeValue, n: int, rng: random.Random) -> tuple[Row | None, bool]:
    """Return the same, with the element as a row over the denominator of the lattice."""
    rows, gram = lattice.reduced
    heads = enumeration.volume(gram, 2 * n, 3)
    if heads <= MAX_HEADS_WITHOUT_ARRAYS:
        found = first_of_norm(lattice, lattice.ambient.base.inside(fraction(lattice.norm) * n))
        return (None if found is None else hermite.tuples(found)[0]), True
    row = on_planes(lattice, n, rng) if heads > MAX_HEADS_WITHOUT_PLANES else None
    if row is not None:
        return row, True
    x, decided = _vector_of_length(gram, 2 * n, MAX_HEADS, heads, rng)
    return (None if x is None else hermite.combination(x, rows)), decided


def norm_dividing(
    lattice: LatticeValue, number: int, rng: random.Random
) -> tuple[Quaternion | None, bool, int]:
    """Return an element for which N(x)/N(L) divides a number, the least such norm if it can be found.

    The other results are whether the answer is proved, and the bound up to which all norms were decided.
    """
    small = volume(lattice) < SMALL_VOLUME
    x, tried = _among_short(lattice, number, MAX_SHORT if small else MAX_SHORT_OF_LARGE)
    if x is not None or tried >= number:
        return x, True, tried
    found = factor(number)
    divisors = Divisors(tuple(found.primes.items()))
    row, tried = _least_divisor(lattice, divisors, tried, rng)
    proved = row is not None or (found.rest is None and tried >= number)
    return (None if row is None else lattice.element(row)), proved, tried


def volume(lattice: LatticeValue) -> int:
    """Return the square root of the determinant of the form; p for ideals of maximal orders of discriminant
    p.
    """
    return math.isqrt(enumeration.bareiss(lattice.reduced[1])[0][4])


def _among_short(lattice: LatticeValue, number: int, most: int) -> tuple[Quaternion | None, int]:
    """Return an element of least N(x)/N(L) that divides a number, among a limited number of short ones.

    The second result is the bound up to which all were tried.
    """
    tried, bound = 0, least_norm(lattice)
    while True:
        bound = min(bound, number)
        short = list(islice(up_to(lattice, bound), most + 1))
        if len(short) > most:
            return None, tried
        tried = bound
        found = min(((m, row) for row, m in short if number % m == 0), default=None)
        if found is not None:
            return lattice.element(found[1]), tried
        if tried == number:
            return None, tried
        bound *= 2


def _least_divisor(
    lattice: LatticeValue, divisors: Divisors, tried: int, rng: random.Random
) -> tuple[Row | None, int]:
    """Return an element for the least divisor above those tried, and the bound up to which all were
    decided.
    """
    gram, size, spent = lattice.reduced[1], volume(lattice), 0.0
    # an element of norm n is expected from n = p/24 on
    first = size >> 8 if size > SMALL_VOLUME else 1
    if enumeration.volume(gram, 2 * max(first, tried), 3) > MAX_HEADS:
        return None, tried
    gaps = False
    for n in islice(divisors.ascending(), MAX_DIVISORS):
        if n <= tried:
            continue
        if n < first:
            gaps = True
            continue
        spent += enumeration.volume(gram, 2 * n, 3)
        if spent > MAX_ALL_HEADS:
            break
        row, decided = _row_of_norm(lattice, n, rng)
        if row is not None:
            return row, tried
        if not decided:
            break
        tried = tried if gaps else n
    return None, tried


# --- enumeration -----------------------------------------------------------------------------------


def _vector_of_length(
    gram: list[list[int]], length: int, most: int, heads: float, rng: random.Random
) -> tuple[Row | None, bool]:
    """Return x with x·gram·x = length, or None, and whether the answer is proved.

    The last two coordinates are tried in random order (not all of them if there are too many), and the first
    one is solved for.
    """
    import numpy as np

    _, between, low, high = bounds(gram, length)
    sizes = between + 2, low, high  # the ranges of the second coordinate are wider by up to 2
    whole = sum(
        abs(gram[k + 1][m + 1]) * sizes[k] * sizes[m] for k, m in product(range(3), repeat=2)
    )
    shifts = sum(abs(x) * size for x, size in zip(gram[0][1:], sizes, strict=True))
    if shifts**2 + gram[0][0] * (length + whole) >= 2**62:
        return None, False
    width = 2 * low + 1
    tails = width * (high + 1)
    complete = heads <= 2 * most and tails <= most
    numbers = np.random.default_rng(rng.getrandbits(64))
    form, columns = np.array(gram, dtype=np.int64), _Columns(gram, length)
    order = numbers.permutation(tails) if complete else None
    step = max(1, math.ceil(BLOCK * tails / max(heads, 1.0)))
    done, start = 0, 0
    while start < tails if complete else done < most:
        if order is None:
            index = numbers.integers(0, tails, step)
        else:
            index = order[start : start + step]
            start += step
        last, third = index // width, index % width - low
        second, third, last = columns.expand(third, last, None if complete else numbers)
        done += max(len(second), step)
        x = np.stack([second, third, last], axis=-1)
        shift = x @ form[0, 1:]
        # (g·x₀ + shift)² = shift² + g·(length − x·form·x)
        left = shift**2 + gram[0][0] * (length - ((x @ form[1:, 1:]) * x).sum(axis=1))
        root = np.rint(np.sqrt(np.maximum(left, 0))).astype(np.int64)
        for sign in (1, -1):
            value, odd = np.divmod(sign * root - shift, gram[0][0])
            hits = np.flatnonzero((root * root == left) & (odd == 0))
            if len(hits):
                k = hits[0]
                return (int(value[k]), *(int(c) for c in x[k])), True
    return None, complete


class _Columns:
    """The ranges of the second coordinate, given the last ones, among the vectors up to a length."""

    def __init__(self, gram: list[list[int]], length: int) -> None:
        minors, forms = enumeration.bareiss(gram)
        self.minors, self.forms, self.length = minors, forms, length

    def expand(
        self, third: np.ndarray, last: np.ndarray, numbers: np.random.Generator | None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return all three coordinates; if ``numbers`` are given, a random part of long ranges."""
        import numpy as np

        d, forms = self.minors, self.forms
        z, w = third.astype(float), last.astype(float)
        used = (forms[2][2] * z + forms[2][3] * w) ** 2 / (float(d[2]) * d[3])
        used += (forms[3][3] * w) ** 2 / (float(d[3]) * d[4])
        inside = used <= self.length * (1 + 1e-9)
        third, last, z, w = third[inside], last[inside], z[inside], w[inside]
        radius = np.sqrt(np.maximum(self.length - used[inside], 0) * (float(d[1]) * d[2]))
        shift = forms[1][2] * z + forms[1][3] * w
        # one more on each side, whatever the rounding
        begin = np.floor((-radius - shift) / d[2]).astype(np.int64) - 1
        sizes = np.ceil((radius - shift) / d[2]).astype(np.int64) + 2 - begin
        if numbers is not None:
            few = np.minimum(sizes, MAX_RANGE)
            begin = begin + numbers.integers(0, sizes - few + 1)
            sizes = few
        before = np.repeat(np.cumsum(sizes) - sizes, sizes)
        second = np.repeat(begin, sizes) + np.arange(len(before)) - before
        return second, np.repeat(third, sizes), np.repeat(last, sizes)


def bounds(gram: Sequence[Sequence[int]], length: int) -> list[int]:
    """Return bounds for the coordinates of a vector with x·gram·x ≤ length."""
    inverse = fmpz_mat(gram).inv()
    size = len(gram)
    return [math.isqrt(int(length * inverse[k, k].p) // int(inverse[k, k].q)) for k in range(size)]


# --- planes ------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Plane:
    """A plane of a lattice and its orthogonal complement: coordinates of bases, with reduced forms."""

    discriminant: int
    first: fmpz_mat
    form: list[list[int]]
    second: fmpz_mat
    rest: list[list[int]]


def has_small_planes(lattice: LatticeValue) -> bool:
    """Return whether there are planes with a form of small discriminant, as in every lattice of
    small volume.
    """
    return bool(_planes(lattice))


def on_planes(
    lattice: LatticeValue, n: int, rng: random.Random, rounds: Sequence[int] = PLANE_TRIALS
) -> Row | None:
    """Return a row for an element of norm n·N(L), the sum of an element of a plane and one
    orthogonal to it.
    """
    # no prime is an obstacle if the discriminant is odd and prime to n
    planes = sorted(_planes(lattice), key=lambda plane: math.gcd(plane.discriminant, 2 * n) > 1)
    for trials, plane in product(rounds, planes):
        for z, w in islice(_pairs(plane.rest, 2 * n, trials, rng), trials):
            m = n - _value(plane.rest, (z, w), (z, w)) // 2
            found = _in_plane(plane.form, m) if m > 0 else None
            if found is not None:
                x = fmpz_mat([found]) * plane.first + fmpz_mat([(z, w)]) * plane.second
                return hermite.combination(hermite.tuples(x)[0], lattice.reduced[0])
    return None


@lru_cache(maxsize=16)
def _planes(lattice: LatticeValue) -> tuple[_Plane, ...]:
    """Return planes spanned by short vectors, ordered by discriminant: some odd and some even ones."""
    gram = fmpz_mat(lattice.reduced[1])
    short = [v for v in product((-1, 0, 1), repeat=4) if v > (0, 0, 0, 0)]
    found: dict[tuple[Row, ...], tuple[int, fmpz_mat]] = {}
    for pair in combinations(short, 2):
        plane = fmpz_mat(pair).hnf()
        key = hermite.tuples(plane)
        if key not in found and any(key[1]) and _is_primitive(key):
            found[key] = int((plane * gram * plane.transpose()).det()), plane
    small = (x for x in found.values() if x[0] < MAX_PLANE_DISCRIMINANT)
    ordered = sorted(small, key=lambda x: x[0])
    odd = [x for x in ordered if x[0] % 2][: MAX_PLANES // 2]
    even = [x for x in ordered if x[0] % 2 == 0][: MAX_PLANES // 2]
    return tuple(_with_complement(*x, gram) for x in sorted(odd + even, key=lambda x: x[0]))


def _with_complement(discriminant: int, plane: fmpz_mat, gram: fmpz_mat) -> _Plane:
    equations = gram * plane.transpose()
    stacked = [[*row, *(int(m == k) for k in range(4))] for m, row in enumerate(equations.tolist())]
    rest = fmpz_mat([row[2:] for row in fmpz_mat(stacked).hnf().tolist()[2:]])
    return _Plane(discriminant, *_reduced(plane, gram), *_reduced(rest, gram))


def _is_primitive(pair: tuple[Row, ...]) -> bool:
    v, w = pair
    return math.gcd(*(v[i] * w[j] - v[j] * w[i] for i, j in combinations(range(4), 2))) == 1


def _reduced(plane: fmpz_mat, gram: fmpz_mat) -> tuple[fmpz_mat, list[list[int]]]:
    form, steps = (plane * gram * plane.transpose()).lll(transform=True, rep="gram")
    return steps * plane, list(map(list, hermite.tuples(form)))


def _pairs(form: list[list[int]], length: int, few: int, rng: random.Random) -> Iterator[Row]:
    """Yield pairs with values up to a length: all if there are few, else random ones."""
    if enumeration.volume(form, length, 2) < few:
        yield 0, 0
        yield from (v for v, _ in enumeration.short_vectors(form, length))
        return
    first, second = bounds(form, length)
    while True:
        yield rng.randint(-first, first), rng.randint(-second, second)


def _in_plane(form: list[list[int]], m: int) -> Row | None:
    """Return (x, y) with x·form·x = 2·m, or None; a large m must be prime, and others may be missed."""
    a, b = form[0][0] // 2, form[0][1]
    d = b * b - form[0][0] * form[1][1]
    if math.gcd(m, 2 * a) > 1:
        return None
    primes = _primes(m, d)
    if not primes or any(fmpz(d % q).jacobi(q) + (e == 1) < 1 for q, e in primes.items()):
        return (1, 0) if a == m else None
    roots = [_root(d, q, e) for q, e in primes.items()]
    inverse = pow(2 * a, -1, m)
    for signs in islice(product((1, -1), repeat=len(roots)), MAX_ROOTS):
        r, _ = crt([(s * x, q) for s, (x, q) in zip(signs, roots, strict=True)])
        v = _shortest(form, (m, 0), ((r - b) * inverse % m, 1))
        if _value(form, v, v) == 2 * m:
            return v
    return None


def _primes(m: int, d: int) -> Mapping[int, int]:
    """Return the primes of m; a large m must be a prime times a divisor of d, else the result is empty."""
    if m < WORD:
        return factor(m).primes
    common = math.gcd(m, d)
    rest = m // common
    return {**factor(common).primes, rest: 1} if likely(rest) else {}


def _root(d: int, q: int, e: int) -> tuple[int, int]:
    """Return a square root of d modulo qᵉ for an odd prime q, or modulo q if q divides d, with the
    modulus.
    """
    x, power = sqrt_mod(d, q), q
    for _ in range(e - 1):
        power *= q
        x = (x - (x * x - d) * pow(2 * x, -1, power)) % power
    return x, power


def _value(form: list[list[int]], v: Row, w: Row) -> int:
    return v[0] * (form[0][0] * w[0] + form[0][1] * w[1]) + v[1] * (
        form[1][0] * w[0] + form[1][1] * w[1]
    )


def _shortest(form: list[list[int]], v: Row, w: Row) -> Row:
    """Return a shortest vector of the planar lattice spanned by two vectors, by Gauss' reduction."""
    long, between, short = _value(form, v, v), _value(form, v, w), _value(form, w, w)
    while True:
        if long < short:
            v, w, long, short = w, v, short, long
        k = (2 * between + short) // (2 * short)
        if not k:
            return w
        v = v[0] - k * w[0], v[1] - k * w[1]
        long += k * (k * short - 2 * between)
        between -= k * short
