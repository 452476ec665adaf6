"""Buchberger's algorithm over a prime field, with a history for each element.

The history gives cofactors with respect to the generators for every polynomial that reduces to 0. Monomials
are encoded as integers ``(degree << n·B) − Σ eₖ << k·B``: the order of integers is the degree reverse
lexicographic order, and the sum of codes is the product of monomials. Pairs are eliminated by the criteria of
Gebauer and Möller (1988).
"""

import heapq
from collections.abc import Iterable, Mapping

from hfield.errors import TooLargeError
from hfield.prover.clock import UNTIMED, Clock

FIELD_BITS = 16
DIGIT = (1 << FIELD_BITS) - 1
MAX_EXPONENT = 2**12
MAX_EXPRESSION = 200_000

Polynomial = dict[int, int]  # monomial → coefficient
History = list[tuple[int, int, int]]  # element or generator, monomial, coefficient


class Monomials:
    """The encoding of monomials in ``n`` variables."""

    def __init__(self, n: int) -> None:
        self.n, self.width = n, n * FIELD_BITS
        self.mask = (1 << self.width) - 1
        self.guard = sum(1 << (k * FIELD_BITS + FIELD_BITS - 1) for k in range(n))

    def encode(self, exponents: Iterable[int]) -> int:
        """Return the code. Raises TooLargeError for exponents that do not fit."""
        packed = degree = 0
        for k, e in enumerate(exponents):
            if e > MAX_EXPONENT:
                raise TooLargeError(f"an exponent {e} is larger than {MAX_EXPONENT}")
            packed |= e << (k * FIELD_BITS)
            degree += e
        return (degree << self.width) - packed

    def decode(self, code: int) -> tuple[int, ...]:
        """Return the exponents."""
        packed = -code & self.mask
        return tuple(packed >> (k * FIELD_BITS) & DIGIT for k in range(self.n))

    def divides(self, x: int, y: int) -> bool:
        """Return whether x divides y."""
        guard, mask = self.guard, self.mask
        return ((-y & mask | guard) - (-x & mask)) & guard == guard

    def lcm(self, x: int, y: int) -> int:
        """Return the least common multiple: the maximum of the exponents, in all fields at once."""
        u, v, guard = -x & self.mask, -y & self.mask, self.guard
        above = (u | guard) - v & guard  # where u has the greater exponent
        chosen = above - (above >> FIELD_BITS - 1)
        packed = u & chosen | v & ~chosen
        # Modulo 2ᴮ − 1 a number is the sum of its fields, as long as that is smaller.
        if self.degree(x) + self.degree(y) < DIGIT:
            return (packed % DIGIT << self.width) - packed
        return self.encode(self.decode(-packed))

    def degree(self, x: int) -> int:
        """Return the total degree."""
        return -(-x >> self.width)


class Basis:
    """An incremental Gröbner basis modulo the prime p; ``generators`` counts the generators added."""

    def __init__(self, n: int, p: int, clock: Clock = UNTIMED) -> None:
        self.monomials, self.p, self.generators, self.clock = Monomials(n), p, 0, clock
        self.leads: list[int] = []
        self.tails: list[list[tuple[int, int]]] = []
        self.history: list[History] = []
        self.active: list[tuple[int, int]] = []  # packed leading exponents, index
        self.pairs: list[tuple[int, int, int, int]] = []  # degree, lcm, i, j
        self.has_one = False

    def add(self, polynomial: Mapping[int, int]) -> None:
        """Add a generator; its coefficients are reduced modulo p."""
        self.generators += 1
        f = {m: c % self.p for m, c in polynomial.items() if c % self.p}
        rest, history = self.reduce(f)
        self._enter(rest, [(-self.generators, 0, 1), *history])

    def run(self, steps: int) -> bool:
        """Process at most ``steps`` pairs; return whether the basis is complete (or contains 1)."""
        while self.pairs and not self.has_one:
            if steps <= 0 or self.clock.is_late:
                return False
            steps -= 1
            _, lcm, i, j = heapq.heappop(self.pairs)
            u, v = lcm - self.leads[i], lcm - self.leads[j]
            f: Polynomial = {m + u: c for m, c in self.tails[i]}
            for m, c in self.tails[j]:
                d = (f.get(m + v, 0) - c) % self.p
                if d:
                    f[m + v] = d
                else:
                    f.pop(m + v, None)
            rest, history = self.reduce(f)
            self._enter(rest, [(i, u, 1), (j, v, self.p - 1), *history])
        return True

    def reduce(self, f: Polynomial) -> tuple[Polynomial, History]:
        """Return the normal form r of f and a history h with r = f + h.

        Raises :class:`TooLargeError` if the time limit is reached.
        """
        p, mask, guard, active = self.p, self.monomials.mask, self.monomials.guard, self.active
        rest: Polynomial = {}
        history: History = []
        f = dict(f)
        heap = [-m for m in f]
        heapq.heapify(heap)
        count = 0
        while heap:
            m = -heapq.heappop(heap)
            c = f.pop(m, 0)
            if not c:
                continue
            packed = -m & mask | guard
            for lead, index in active:
                if (packed - lead) & guard == guard:
                    q = m - self.leads[index]
                    history.append((index, q, p - c))
                    for tail, d in self.tails[index]:
                        t = tail + q
                        old = f.get(t)
                        if old is None:
                            f[t] = -c * d % p
                            heapq.heappush(heap, -t)
                        else:
                            f[t] = (old - c * d) % p
                    break
            else:
                rest[m] = c
            count += 1
            if not count & 1023 and self.clock.is_late:
                raise TooLargeError("the time limit was reached")
        return rest, history

    def express(self, history: History) -> list[Polynomial]:
        """Write Σ coefficient·monomial·element as cofactors with respect to the generators.

        Raises TooLargeError if the cofactors become too large.
        """
        p = self.p
        sums: dict[int, Polynomial] = {}
        size = 0
        for index, m, c in history:
            size += _accumulate(sums.setdefault(index, {}), {0: c}, m, 1, p)
        for index in range(len(self.leads) - 1, -1, -1):
            factor = sums.pop(index, None)
            if not factor:
                continue
            for source, m, c in self.history[index]:
                size += _accumulate(sums.setdefault(source, {}), factor, m, c, p)
            if size > MAX_EXPRESSION:
                raise TooLargeError("the cofactors grow too large")
        return [
            {m: c for m, c in sums.get(-n, {}).items() if c} for n in range(1, self.generators + 1)
        ]

    def _enter(self, f: Polynomial, history: History) -> None:
        """Make f monic and add it to the basis, with the pairs that survive the criteria."""
        if not f:
            return
        mon, new = self.monomials, len(self.leads)
        lead = max(f)
        scale = pow(f.pop(lead), -1, self.p)
        self.leads.append(lead)
        self.tails.append([(m, c * scale % self.p) for m, c in f.items()])
        self.history.append([(n, m, c * scale % self.p) for n, m, c in history])
        if lead == 0:
            self.has_one = True
        self._cut(lead)
        fresh: dict[int, int] = {}
        coprime: set[int] = set()
        for _, i in self.active:
            lcm = mon.lcm(self.leads[i], lead)
            fresh.setdefault(lcm, i)
            if lcm == self.leads[i] + lead:
                coprime.add(lcm)
        for lcm, i in self._minimal(fresh):
            if lcm not in coprime:
                heapq.heappush(self.pairs, (mon.degree(lcm), lcm, i, new))
        self.active = [x for x in self.active if not mon.divides(lead, self.leads[x[1]])]
        self.active.append((-lead & mon.mask, new))

    def _minimal(self, fresh: Mapping[int, int]) -> list[tuple[int, int]]:
        """Return the new multiples that are minimal under divisibility."""
        guard, mask = self.monomials.guard, self.monomials.mask
        packed = [-lcm & mask for lcm in fresh]
        out = []
        for own, pair in zip(packed, fresh.items(), strict=True):
            raised = own | guard
            for other in packed:
                if (raised - other) & guard == guard and other != own:
                    break
            else:
                out.append(pair)
        return out

    def _cut(self, lead: int) -> None:
        """Drop the old pairs that the new element makes superfluous (Buchberger's chain criterion)."""
        mon = self.monomials
        self.pairs = [
            pair
            for pair in self.pairs
            if not mon.divides(lead, pair[1])
            or mon.lcm(self.leads[pair[2]], lead) == pair[1]
            or mon.lcm(self.leads[pair[3]], lead) == pair[1]
        ]
        heapq.heapify(self.pairs)


def _accumulate(into: Polynomial, factor: Polynomial, m: int, c: int, p: int) -> int:
    for k, d in factor.items():
        into[k + m] = (into.get(k + m, 0) + c * d) % p
    return len(factor)
