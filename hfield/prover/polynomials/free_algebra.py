"""Decide membership in two-sided ideals of free algebras, with cofactors.

Words are strings, and polynomials map words to coefficients. Buchberger's algorithm in the free algebra (Mora
1986) need not terminate, so it is bounded. Its result is verified by multiplying out the cofactors: ``f = Σ
c·left·generator·right``.
"""

from collections import deque
from collections.abc import Hashable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import TypeAlias, TypeVar

from hfield.prover.clock import UNTIMED, Clock

K = TypeVar("K", bound=Hashable)
Number: TypeAlias = int | Fraction
Words = dict[str, Number]  # word → coefficient
Cofactors = dict[tuple[str, int, str], Number]  # left, generator, right → coefficient
Rule = tuple[str, Words, Cofactors]  # the leading word, the monic polynomial, and its origin

MAX_RULES = 200


class Rewriting:
    """An incremental rewriting system over ℚ (p = 0) or modulo p for the ideal of ``generators``."""

    def __init__(
        self,
        generators: Sequence[Mapping[str, int]],
        p: int,
        letters: str,
        clock: Clock = UNTIMED,
    ) -> None:
        self.clock = clock
        self.p, self.order = p, {letter: n for n, letter in enumerate(letters)}
        self.rules: list[Rule] = []
        self.pairs: deque[tuple[int, int]] = deque()
        for n, g in enumerate(generators):
            self._enter({w: self.number(c) for w, c in g.items()}, {("", n, ""): self.number(1)})

    def number(self, c: Number) -> Number:
        """Return a coefficient: a Fraction, or an int modulo p."""
        return int(c) % self.p if self.p else Fraction(c)

    def run(self) -> bool:
        """Resolve overlaps until none is left; return False if a bound is reached first."""
        while self.pairs:
            if self.clock.is_late or len(self.rules) > MAX_RULES:
                return False
            x, y = self.pairs.popleft()
            for f, cofactors in self._overlaps(x, y):
                self._enter(f, cofactors)
        return True

    def reduce(self, f: Words, cofactors: Cofactors) -> tuple[Words, Cofactors]:
        """Return the normal form of f; add the negatives of the subtracted multiples to ``cofactors``."""
        f, cofactors, rest = dict(f), dict(cofactors), {}
        while f:
            word = max(f, key=self._key)
            for lead, g, own in self.rules:
                at = word.find(lead)
                if at >= 0:
                    c, left, right = self._minus(f[word]), word[:at], word[at + len(lead) :]
                    self._add(f, c, left, g, right)
                    self._add_cofactors(cofactors, c, left, own, right)
                    break
            else:
                rest[word] = f.pop(word)
        return rest, cofactors

    def member(self, f: Mapping[str, int]) -> Cofactors | None:
        """Return cofactors for f by the current rules, or None."""
        rest, negative = self.reduce(
            {w: self.number(c) for w, c in f.items() if self.number(c)}, {}
        )
        if rest:
            return None
        return {place: self._minus(c) for place, c in negative.items()}

    def _enter(self, f: Words, cofactors: Cofactors) -> None:
        f, cofactors = self.reduce({w: c for w, c in f.items() if c}, cofactors)
        if not f:
            return
        lead = max(f, key=self._key)
        scale = pow(int(f[lead]), -1, self.p) if self.p else 1 / Fraction(f[lead])
        rule = (
            lead,
            {w: self._times(c, scale) for w, c in f.items()},
            {place: self._times(c, scale) for place, c in cofactors.items()},
        )
        new = len(self.rules)
        self.rules.append(rule)
        self.pairs.extend((old, new) for old in range(new))
        self.pairs.extend((new, old) for old in range(new + 1))

    def _overlaps(self, x: int, y: int) -> Iterator[tuple[Words, Cofactors]]:
        """Yield, for each overlap of both leading words, the two ways to rewrite it."""
        (a, f, own), (b, g, other) = self.rules[x], self.rules[y]
        places = [(b[n:], a[:-n], "") for n in range(1, min(len(a), len(b))) if a[-n:] == b[:n]]
        if x != y and b in a:
            at = a.find(b)
            places.append(("", a[:at], a[at + len(b) :]))
        for right_of_f, left_of_g, right_of_g in places:
            h: Words = {}
            cofactors: Cofactors = {}
            one = self.number(1)
            self._add(h, one, "", f, right_of_f)
            self._add_cofactors(cofactors, one, "", own, right_of_f)
            self._add(h, self._minus(one), left_of_g, g, right_of_g)
            self._add_cofactors(cofactors, self._minus(one), left_of_g, other, right_of_g)
            yield h, cofactors

    def _add(self, into: Words, c: Number, left: str, f: Words, right: str) -> None:
        for word, d in f.items():
            self._sum(into, left + word + right, self._times(c, d))

    def _add_cofactors(
        self, into: Cofactors, c: Number, left: str, other: Cofactors, right: str
    ) -> None:
        for (l, n, r), d in other.items():  # noqa: E741
            self._sum(into, (left + l, n, r + right), self._times(c, d))

    def _sum(self, into: dict[K, Number], key: K, c: Number) -> None:
        total = into.get(key, 0) + c
        if self.p:
            total %= self.p
        if total:
            into[key] = total
        else:
            into.pop(key, None)

    def _times(self, c: Number, d: Number) -> Number:
        return c * d % self.p if self.p else c * d

    def _minus(self, c: Number) -> Number:
        return -c % self.p if self.p else -c

    def _key(self, word: str) -> tuple[int, list[int]]:
        return len(word), [self.order[letter] for letter in word]


def multiply_out(cofactors: Cofactors, generators: Sequence[Mapping[str, int]]) -> Words:
    """Return Σ c·left·generator·right."""
    out: Words = {}
    for (left, n, right), c in cofactors.items():
        for word, d in generators[n].items():
            key = left + word + right
            out[key] = out.get(key, 0) + c * d
    return {word: c for word, c in out.items() if c}
