"""GF(q)[t] modulo a polynomial that Rabin's test proves irreducible: the finite residue fields."""

from collections.abc import Sequence

from hfield.checker.budget import spend
from hfield.checker.rejection import reject
from hfield.checker.scalars.finite import Finite, is_prime
from hfield.checker.scalars.place import E

MAX_DEGREE = 200

Dense = tuple[E, ...]  # as many coefficients as the degree of the modulus, low degree first


class QuotientField(Finite[Dense[E]]):
    """The field ``base[t]/(modulus)`` over a finite field; the modulus is dense, low degree first."""

    is_field = True

    def __init__(self, base: Finite[E], modulus: Sequence[E]) -> None:
        self.base, self.degree = base, len(modulus) - 1
        if not 1 <= self.degree <= MAX_DEGREE:
            reject(f"a prime polynomial has a degree from 1 to {MAX_DEGREE}")
        lead = base.need_inverse(modulus[-1])
        self._tail = [base.neg(base.mul(lead, c)) for c in modulus[:-1]]
        self.characteristic = base.characteristic
        self.order = base.order**self.degree
        self.name = f"{base.name}[t] modulo a polynomial of degree {self.degree}"
        self.zero: Dense[E] = (base.zero,) * self.degree
        self.one = self.reduce([base.one])
        self.generator = self.reduce([base.zero, base.one])
        if not self._is_irreducible():
            reject("a polynomial that should be a prime is reducible")

    def reduce(self, f: Sequence[E]) -> Dense[E]:
        """Return the class of a polynomial, dense, low degree first."""
        base, n, out = self.base, self.degree, list(f)
        spend(20 + 5 * n * max(len(out) - n, 0))
        while len(out) > n:
            top = out.pop()
            if not base.is_zero(top):
                shift = len(out) - n
                for m, c in enumerate(self._tail):
                    out[shift + m] = base.add(out[shift + m], base.mul(top, c))
        return (*out, *self.zero[len(out) :])

    def number(self, n: int) -> Dense[E]:
        """Return n·1."""
        return self.reduce([self.base.number(n)])

    def add(self, x: Dense[E], y: Dense[E]) -> Dense[E]:
        """Return x + y."""
        spend(self.degree)
        return tuple([self.base.add(u, v) for u, v in zip(x, y, strict=True)])

    def neg(self, x: Dense[E]) -> Dense[E]:
        """Return −x."""
        spend(self.degree)
        return tuple([self.base.neg(u) for u in x])

    def mul(self, x: Dense[E], y: Dense[E]) -> Dense[E]:
        """Return x·y."""
        base = self.base
        spend(5 * self.degree**2)
        wide = [base.zero] * (2 * self.degree - 1)
        for m, u in enumerate(x):
            if not base.is_zero(u):
                for n, v in enumerate(y, m):
                    wide[n] = base.add(wide[n], base.mul(u, v))
        return self.reduce(wide)

    def inverse(self, x: Dense[E]) -> Dense[E] | None:
        """Return 1/x = x^(q−2)."""
        return None if self.is_zero(x) else self.power(x, self.order - 2)

    def _is_irreducible(self) -> bool:
        """Return whether the modulus is irreducible, by Rabin's test.

        The first condition says that all prime factors are distinct, with degrees that divide n; the second
        says that no degree divides n/r. Units are recognised by the extended Euclidean algorithm, since
        powers do not give inverses before this is known to be a field.
        """
        n, power = self.degree, self.generator
        for m in range(1, n + 1):
            power = self.power(power, self.base.order)
            if n % m == 0 and m < n and is_prime(n // m):
                difference = self.add(power, self.neg(self.generator))
                if not self._is_unit(difference):
                    return False
        return power == self.generator

    def _is_unit(self, x: Dense[E]) -> bool:
        """Return whether a polynomial is prime to the modulus."""
        base = self.base
        f, g = [*map(base.neg, self._tail), base.one], list(x)
        while True:
            while g and base.is_zero(g[-1]):
                g.pop()
            if len(g) <= 1:
                return bool(g) or len(f) == 1
            lead = base.need_inverse(g[-1])
            spend(5 * len(f) * len(g))
            while len(f) >= len(g):
                scale, shift = base.neg(base.mul(f.pop(), lead)), len(f) - len(g) + 1
                for m, c in enumerate(g[:-1]):
                    f[shift + m] = base.add(f[shift + m], base.mul(scale, c))
            f, g = g, f
