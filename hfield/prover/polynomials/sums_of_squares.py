"""Write polynomials as sums of squares of polynomials with positive rational weights.

A Gram matrix of f is a symmetric matrix G with ``f = mᵀ·G·m`` for monomials m; some of its entries are free.
An interior point method finds a positive semidefinite G in floats. G is rounded to rational numbers and
factored exactly as L·D·Lᵀ, so floats affect whether a sum is found, but not whether it is correct. If all
Gram matrices are singular, as for the Cauchy–Schwarz inequality, their common kernel is rounded first (Peyrl
and Parrilo, "Computing sum of squares decompositions with rational coefficients", Theoretical Computer
Science 409 (2008); Powers and Wörmann on Gram matrices, J. Pure Appl. Algebra 127 (1998)).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations_with_replacement, product
from math import lcm, prod
from random import Random
from typing import TYPE_CHECKING

from hfield.prover.clock import UNTIMED, Clock

if TYPE_CHECKING:
    import flint
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MAX_TERMS = 150
MAX_BOX = 20_000  # monomials in the bounding box of the Newton polytope, halved
MAX_MONOMIALS = 60  # in the squared polynomials
MAX_FREE = 160  # entries of the Gram matrix
RANDOM_DIRECTIONS = 40  # that bound the Newton polytope
DENOMINATORS = (1, 2, 3, 4, 6, 12, 60, 840, 10**4, 10**6, 10**9)
MAX_DENOMINATOR = 60  # of the entries of a kernel
KERNEL_TOLERANCE = 1e-4

Monomial = tuple[int, ...]
Terms = Mapping[Monomial, int]
Entry = tuple[int, int, int]  # the block, row and column of an entry of the Gram matrix
Square = tuple[Fraction, dict[Monomial, Fraction]]  # d and g of d·g²


def as_sum_of_squares(
    f: flint.fmpz_mpoly, clock: Clock = UNTIMED
) -> list[tuple[int, flint.fmpz_mpoly]] | None:
    """Return pairs of an integer c > 0 and an integer polynomial g with Σ c·g² a multiple of f or −f.

    None if no such sum is found.
    """
    terms = {tuple(map(int, m)): int(c) for m, c in f.terms()}
    if not 2 <= len(terms) <= MAX_TERMS:
        return None
    used = [n for n in range(len(next(iter(terms)))) if any(m[n] for m in terms)]
    small = {tuple(m[n] for n in used): c for m, c in terms.items()}
    sign = 1 if small[max(small)] > 0 else -1
    squares = _squares({m: sign * c for m, c in small.items()}, clock)
    if squares is None:
        return None
    context, width = f.context(), len(next(iter(terms)))
    cleared = []
    for d, g in squares:
        below = lcm(*(c.denominator for c in g.values()))
        polynomial = {}
        for m, c in g.items():
            wide = [0] * width
            for n, e in zip(used, m, strict=True):
                wide[n] = e
            polynomial[tuple(wide)] = int(c * below)
        cleared.append((d / below**2, context.from_dict(polynomial)))
    scale = lcm(*(c.denominator for c, _ in cleared))
    return [(int(c * scale), g) for c, g in cleared]


def eliminate_variables(generators: Sequence[flint.fmpz_mpoly]) -> list[flint.fmpz_mpoly]:
    """Eliminate from the polynomials of an ideal those powers vᵏ of variables that its generators express.

    ``s - z**2`` expresses s; ``m**2 - n**2 - z**2`` expresses m² if m occurs in even powers only. After
    this substitution a polynomial is often a sum of squares.
    """
    left, out = [f for f in generators if len(f) <= MAX_TERMS], list["flint.fmpz_mpoly"]()
    while True:
        expressed = (hit for f in left for hit in _powers_expressed(f, left))
        found = min(expressed, key=lambda hit: hit[2], default=None)
        if found is None:
            return out
        f, n, k, value = found
        left = [h for g in left if g != f and (h := _substitute(g, n, k, value)) != 0]
        left = [g for g in left if len(g) <= MAX_TERMS]
        out += left


def _powers_expressed(
    f: flint.fmpz_mpoly, others: Sequence[flint.fmpz_mpoly]
) -> Iterator[tuple[flint.fmpz_mpoly, int, int, flint.fmpz_mpoly]]:
    """Yield v, k and value with f = ±(vᵏ − value), where v occurs only in powers of vᵏ."""
    terms = {tuple(map(int, m)): int(c) for m, c in f.terms()}
    for m, c in terms.items():
        powers = [(n, e) for n, e in enumerate(m) if e]
        if len(powers) != 1 or abs(c) != 1:
            continue
        n, k = powers[0]
        if any(other[n] for other in terms if other != m):
            continue
        if all(int(other[n]) % k == 0 for g in others for other, _ in g.terms()):
            yield f, n, k, f.context().from_dict({m: 1}) - c * f


def _substitute(f: flint.fmpz_mpoly, n: int, k: int, value: flint.fmpz_mpoly) -> flint.fmpz_mpoly:
    """Substitute a value for vᵏ, where v is variable n."""
    context, parts = f.context(), dict[int, dict[Monomial, int]]()
    for m, c in f.terms():
        rest = (*m[:n], 0, *m[n + 1 :])
        parts.setdefault(int(m[n]) // k, {})[rest] = int(c)
    zero = context.constant(0)
    return sum((context.from_dict(part) * value**e for e, part in parts.items()), zero)


def _squares(f: Terms, clock: Clock) -> list[Square] | None:
    """Return weights and polynomials whose squares add up to f."""
    weights = _directions(len(next(iter(f))))
    if not _may_be_positive(f, weights):
        return None
    monomials = _halves(f, weights)
    if not monomials or len(monomials) > MAX_MONOMIALS:
        return None
    gram = _Gram.of(f, monomials)
    if gram is None or len(gram.free) > MAX_FREE:
        return None
    for values in gram.candidates(clock):
        squares = gram.squares(values)
        if squares is not None:
            return squares
    return None


def _directions(width: int) -> list[Monomial]:
    """Return linear functions of exponents: the coordinates, the degree, and several random ones."""
    rng = Random(width)
    units = [tuple(int(n == m) for n in range(width)) for m in range(width)]
    random = [tuple(rng.randint(-9, 9) for _ in range(width)) for _ in range(RANDOM_DIRECTIONS)]
    both = [(1,) * width, *units, *random]
    return [tuple(s * e for e in w) for w in both for s in (1, -1)]


def _value(w: Monomial, m: Monomial) -> int:
    return sum(a * b for a, b in zip(w, m, strict=True))


def _may_be_positive(f: Terms, weights: Sequence[Monomial]) -> bool:
    """Return whether corners of the Newton polytope are squares with positive coefficients."""
    for w in weights:
        top = max(_value(w, m) for m in f)
        corner = [m for m in f if _value(w, m) == top]
        if len(corner) == 1 and (f[corner[0]] < 0 or any(e % 2 for e in corner[0])):
            return False
    return True


def _halves(f: Terms, weights: Sequence[Monomial]) -> list[Monomial] | None:
    """Return the monomials that may occur in the polynomials to be squared."""
    ends = [max(m[n] for m in f) // 2 for n in range(len(next(iter(f))))]
    if prod(e + 1 for e in ends) > MAX_BOX:
        return None
    tops = [max(_value(w, m) for m in f) for w in weights]
    found = [
        m
        for m in product(*(range(e + 1) for e in ends))
        if all(2 * _value(w, m) <= top for w, top in zip(weights, tops, strict=True))
    ]
    while True:
        # The square of a monomial occurs in f, or is a product of two others: else its row in G is 0.
        others = {_times(m, n) for m, n in combinations_with_replacement(found, 2) if m != n}.union(
            f
        )
        left = [m for m in found if _times(m, m) in others]
        if len(left) == len(found):
            return found
        found = left


def _times(m: Monomial, n: Monomial) -> Monomial:
    return tuple(a + b for a, b in zip(m, n, strict=True))


def _blocks(f: Terms, monomials: Sequence[Monomial]) -> list[list[Monomial]]:
    """Return the classes of monomials under those sign changes of variables that leave f unchanged."""
    basis: dict[int, int] = {}  # by the highest bit

    def reduced(m: Monomial) -> int:
        bits = sum((e & 1) << n for n, e in enumerate(m))
        for top in sorted(basis, reverse=True):
            if bits >> top & 1:
                bits ^= basis[top]
        return bits

    for m in f:
        bits = reduced(m)
        if bits:
            basis[bits.bit_length() - 1] = bits
    classes: dict[int, list[Monomial]] = {}
    for m in monomials:
        classes.setdefault(reduced(m), []).append(m)
    return list(classes.values())


@dataclass
class _Gram:
    """A symmetric matrix in blocks; ``entries`` lists, for each monomial of f, the entries that contribute to
    it.

    The last entry of each list is determined by the others, which are ``free``.
    """

    blocks: list[list[Monomial]]
    entries: list[tuple[int, list[Entry]]]  # with the coefficient of the monomial
    free: list[Entry]

    @classmethod
    def of(cls, f: Terms, monomials: Sequence[Monomial]) -> _Gram | None:
        """Return the Gram matrix of a polynomial, or None if it cannot have one."""
        blocks, places = _blocks(f, monomials), dict[Monomial, list[Entry]]()
        for number, block in enumerate(blocks):
            for i, m in enumerate(block):
                for j in range(i, len(block)):
                    places.setdefault(_times(m, block[j]), []).append((number, i, j))
        if not places.keys() >= f.keys():
            return None
        entries = [(f.get(m, 0), own) for m, own in places.items()]
        return cls(blocks, entries, [e for _, own in entries for e in own[:-1]])

    def matrices(self, values: Sequence[Fraction]) -> list[list[list[Fraction]]]:
        """Return the blocks, for values of the free entries."""
        out = [[[Fraction(0)] * len(b) for _ in b] for b in self.blocks]
        rest = iter(values)
        for coefficient, own in self.entries:
            left = Fraction(coefficient)
            for number, i, j in own[:-1]:
                x = next(rest)
                out[number][i][j] = out[number][j][i] = x
                left -= x if i == j else 2 * x
            number, i, j = own[-1]
            out[number][i][j] = out[number][j][i] = left if i == j else left / 2
        return out

    def squares(self, values: Sequence[Fraction]) -> list[Square] | None:
        """Return the squares by L·D·Lᵀ of all blocks; None if a block is not positive semidefinite."""
        out: list[Square] = []
        for block, g in zip(self.blocks, self.matrices(values), strict=True):
            found = _complete_squares(block, g)
            if found is None:
                return None
            out.extend(found)
        return out

    def candidates(self, clock: Clock) -> Iterator[list[Fraction]]:
        """Yield values of the free entries for which the matrix may be positive semidefinite."""
        if not self.free:
            yield []
            return
        point = self.interior(clock)
        if point is None:
            return
        x, kernels = point
        near = _rounded(x)
        yield from near
        solved = _Solutions.of(self, kernels)
        if solved is not None:
            for values in near:
                yield solved.nearest(values)

    def interior(self, clock: Clock) -> tuple[Floats, list[Floats]] | None:
        """Return free entries with a positive semidefinite matrix of maximal rank, and its kernels.

        It minimises s subject to G + s·1 being positive semidefinite; None if the minimum is positive.
        """
        import numpy as np

        count = len(self.free)
        constant = [np.zeros((len(b), len(b))) for b in self.blocks]
        slopes = [np.zeros((count + 1, len(b), len(b))) for b in self.blocks]
        for slope in slopes:
            slope[count] = np.eye(slope.shape[1])
        at = 0
        for coefficient, own in self.entries:
            number, i, j = own[-1]
            scale = 1.0 if i == j else 0.5
            constant[number][i, j] = constant[number][j, i] = coefficient * scale
            for block, k, m in own[:-1]:
                slopes[block][at, k, m] = slopes[block][at, m, k] = 1.0
                weight = scale if k == m else 2 * scale
                slopes[number][at, i, j] = slopes[number][at, j, i] = -weight
                at += 1
        size = max(float(np.abs(c).sum(axis=1).max()) for c in constant)
        x = np.zeros(count + 1)
        x[count] = 1 + size
        sharpness = 1.0 / (1 + size)

        def matrices(y: Floats) -> list[Floats]:
            pairs = zip(constant, slopes, strict=True)
            return [c + np.tensordot(y, b, 1) for c, b in pairs]

        def barrier(y: Floats) -> float:
            total = sharpness * y[count]
            for g in matrices(y):
                signs, log = np.linalg.slogdet(g)
                if signs <= 0 or np.linalg.eigvalsh(g)[0] <= 0:
                    return float("inf")
                total -= log
            return float(total)

        try:
            for _ in range(60):
                for _ in range(30):
                    if clock.is_late:
                        return None
                    gradient, hessian = np.zeros(count + 1), np.zeros((count + 1, count + 1))
                    gradient[count] = sharpness
                    for g, b in zip(matrices(x), slopes, strict=True):
                        scaled = np.linalg.solve(g, b)
                        gradient -= np.trace(scaled, axis1=1, axis2=2)
                        hessian += np.einsum("nij,mji->nm", scaled, scaled)
                    step = -np.linalg.solve(hessian, gradient)
                    decrease = -float(gradient @ step)
                    length, here = 1.0, barrier(x)
                    while (
                        length > 1e-9
                        and barrier(x + length * step) > here - 0.1 * length * decrease
                    ):
                        length /= 2
                    if length <= 1e-9:
                        break
                    x = x + length * step
                    if decrease < 1e-6:
                        break
                if x[count] < -0.01 * size or sharpness * size > 1e9:
                    break
                sharpness *= 4
        except np.linalg.LinAlgError:
            pass
        if x[count] > 1e-5 * (1 + size):
            return None
        y = x.copy()
        y[count] = 0
        return x[:count], [_kernel(g, size) for g in matrices(y)]


def _rounded(x: Floats) -> list[list[Fraction]]:
    """Return rational values near floats, with small denominators first."""
    return [[Fraction(round(float(v) * n), n) for v in x] for n in DENOMINATORS]


def _kernel(g: Floats, size: float) -> Floats:
    """Return a basis of the numerical kernel of a matrix, in echelon form, as rows."""
    import numpy as np

    values, vectors = np.linalg.eigh(g)
    rows = vectors[:, values < KERNEL_TOLERANCE * (1 + size)].T.copy()
    done = 0
    for column in range(rows.shape[1]):
        if done == len(rows):
            break
        best = done + int(np.argmax(np.abs(rows[done:, column])))
        if abs(rows[best, column]) < 10 * KERNEL_TOLERANCE:
            continue
        rows[[done, best]] = rows[[best, done]]
        rows[done] /= rows[done, column]
        for n in range(len(rows)):
            if n != done:
                rows[n] -= rows[n, column] * rows[done]
        done += 1
    return rows


@dataclass
class _Solutions:
    """The free entries of matrices with given rational kernel vectors; ``pivots`` are expressed by the
    others.
    """

    pivots: dict[int, tuple[dict[int, Fraction], Fraction]]

    @classmethod
    def of(cls, gram: _Gram, kernels: Sequence[Floats]) -> _Solutions | None:
        """Solve G·v = 0 for rationalised kernel vectors."""
        place = {entry: n for n, entry in enumerate(gram.free)}
        known: dict[Entry, tuple[dict[int, Fraction], Fraction]] = {
            entry: ({n: Fraction(1)}, Fraction(0)) for entry, n in place.items()
        }
        for coefficient, own in gram.entries:
            scale = Fraction(1 if own[-1][1] == own[-1][2] else 2)
            parts = {place[e]: -(1 if e[1] == e[2] else 2) / scale for e in own[:-1]}
            known[own[-1]] = parts, Fraction(coefficient) / scale
        pivots: dict[int, tuple[dict[int, Fraction], Fraction]] = {}
        for number, rows in enumerate(kernels):
            for row in rows:
                v = [Fraction(float(c)).limit_denominator(MAX_DENOMINATOR) for c in row]
                if any(
                    abs(float(c) - float(d)) > 100 * KERNEL_TOLERANCE
                    for c, d in zip(v, row, strict=True)
                ):
                    return None
                for i in range(len(v)):
                    left, right = dict[int, Fraction](), Fraction(0)
                    for j, c in enumerate(v):
                        if c:
                            parts, number_there = known[number, min(i, j), max(i, j)]
                            right -= c * number_there
                            for n, slope in parts.items():
                                left[n] = left.get(n, Fraction(0)) + c * slope
                    if not _eliminate(pivots, left, right):
                        return None
        return cls(pivots)

    def nearest(self, values: Sequence[Fraction]) -> list[Fraction]:
        """Return values that solve the equations, with the given values of the free ones."""
        out = list(values)
        for n, (parts, number) in self.pivots.items():
            out[n] = number - sum((c * values[m] for m, c in parts.items()), Fraction(0))
        return out


def _eliminate(
    pivots: dict[int, tuple[dict[int, Fraction], Fraction]],
    left: dict[int, Fraction],
    right: Fraction,
) -> bool:
    """Add the equation Σ left·x = right to the solved ones; return False if it contradicts them."""
    for n in [n for n in left if n in pivots]:
        parts, number = pivots[n]
        c = left.pop(n)
        right -= c * number
        for m, d in parts.items():
            left[m] = left.get(m, Fraction(0)) - c * d
    left = {n: c for n, c in left.items() if c}
    if not left:
        return right == 0
    pivot = min(left)
    lead = left.pop(pivot)
    row, value = {n: c / lead for n, c in left.items()}, right / lead
    for n, (parts, number) in list(pivots.items()):
        if pivot in parts:
            c = parts.pop(pivot)
            for m, d in row.items():
                parts[m] = parts.get(m, Fraction(0)) - c * d
            pivots[n] = {m: d for m, d in parts.items() if d}, number - c * value
    pivots[pivot] = row, value
    return True


def _complete_squares(block: Sequence[Monomial], g: list[list[Fraction]]) -> list[Square] | None:
    """Complete squares: return d and polynomials with mᵀ·G·m = Σ d·g², or None if some d is negative."""
    out: list[Square] = []
    rows = [row[:] for row in g]
    for n in range(len(block)):
        pivot = rows[n][n]
        if pivot < 0 or (not pivot and any(rows[n][n:])):
            return None
        if not pivot:
            continue
        line = [c / pivot for c in rows[n]]
        out.append((pivot, {block[m]: line[m] for m in range(n, len(block)) if line[m]}))
        for i in range(n + 1, len(block)):
            if line[i]:
                for j in range(n + 1, len(block)):
                    rows[i][j] -= pivot * line[i] * line[j]
    return out
