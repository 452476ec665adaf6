"""The rings ℤ/n and GF(pⁿ) in integer arithmetic; moduli are proved irreducible by Rabin's test."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

from hfield.checker.budget import spend, spend_inverse, spend_products
from hfield.checker.language import Tree
from hfield.checker.rejection import a_list, an_integer, reject, shown
from hfield.checker.scalars.conway import CONWAY
from hfield.checker.scalars.names import plain, polynomial_text
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing, Ring

MAX_BITS = 512
MAX_DEGREE = 64
LONG_NUMBER_BITS = 256  # bits: shorter numbers cost no time
# Miller–Rabin with these bases is a proof below the bound (Sorenson and Webster 2015).
_BASES, PROVED_BELOW = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41), 3317044064679887385961981


def is_prime(n: int) -> bool:
    """Return whether n is prime; rejects numbers for which the test is not a proof."""
    if n < 2:
        return False
    for p in _BASES:
        if n % p == 0:
            return n == p
    spend(200)
    if n >= PROVED_BELOW:
        reject(f"the number {shown(n)} is too large to be proved prime here")
    odd, twos = n - 1, 0
    while odd % 2 == 0:
        odd, twos = odd // 2, twos + 1
    for base in _BASES:
        x = pow(base, odd, n)
        if x in (1, n - 1):
            continue
        for _ in range(twos - 1):
            x = x * x % n
            if x == n - 1:
                break
        else:
            return False
    return True


class Finite(Ring[E]):
    """The common base class of finite fields and ℤ/n."""

    order: int
    digits = 1  # the coefficients of an element

    def from_digits(self, values: Sequence[int]) -> E:
        """Return the element with so many coefficients, numbers from 0 to p − 1."""
        reject(f"elements of {self.name} are not read from coefficients")

    def is_square(self, x: E) -> bool:
        """Return whether x is a square, by Euler's criterion; in characteristic 2 every element is one."""
        q = self.order
        if not self.is_field:
            return super().is_square(x)
        return self.is_zero(x) or q % 2 == 0 or self.equal(self.power(x, (q - 1) // 2), self.one)

    def level_above(self, bound: int) -> bool:
        """Return whether −1 is not a sum of ``bound`` squares: it is one of two, and a square unless q ≡ 3
        modulo 4.
        """
        return bound < 1 or (self.is_field and bound == 1 and self.order % 4 == 3)

    def is_irreducible(self, trace: E, norm: E) -> bool:
        """Return whether X² − trace·X + norm has no root in the field.

        In odd characteristic this holds if trace² − 4·norm is a nonsquare. In characteristic 2 it holds if
        trace is not 0 and z² + z = norm/trace² has no solution, that is, norm/trace² has the trace 1 down to
        GF(2).
        """
        if self.characteristic != 2:
            return self.has_no_root([norm, self.neg(trace), self.one])
        if self.is_zero(trace):
            return False
        below = self.need_inverse(trace)
        term = self.mul(norm, self.mul(below, below))
        total = term
        for _ in range(self.order.bit_length() - 2):
            term = self.mul(term, term)
            total = self.add(total, term)
        return self.equal(total, self.one)


class Residues(Finite[int]):
    """The ring ℤ/n, which is the field GF(p) for a prime n."""

    def __init__(self, n: int, is_field: bool, name: str) -> None:
        self.characteristic = self.order = n
        self.is_field, self.name = is_field, name
        self.words = (
            f"the field with {n} elements" if name[0] == "G" else f"the integers modulo {n}"
        )
        self.is_long = n.bit_length() > LONG_NUMBER_BITS
        self.zero, self.one = 0, 1 % n

    def from_digits(self, values: Sequence[int]) -> int:
        """Return the only digit."""
        return values[0]

    def number(self, n: int) -> int:
        """Return n·1."""
        if self.is_long:
            spend_products([n], [self.characteristic])
        return n % self.characteristic

    def add(self, x: int, y: int) -> int:
        """Return x + y."""
        return (x + y) % self.characteristic

    def neg(self, x: int) -> int:
        """Return −x."""
        return -x % self.characteristic

    def mul(self, x: int, y: int) -> int:
        """Return x·y."""
        if self.is_long:
            spend_products([x, self.characteristic], [y, self.characteristic])
        return x * y % self.characteristic

    def inverse(self, x: int) -> int | None:
        """Return 1/x, or None if x is not a unit."""
        spend_inverse(self.characteristic)
        try:
            return pow(x, -1, self.characteristic)
        except ValueError:
            return None

    def elements(self) -> Iterator[int]:
        """Yield all elements."""
        return iter(range(self.characteristic))

    def maps_modulo(self, n: int) -> bool:
        """Return whether n divides the characteristic."""
        return self.characteristic % n == 0


Digits = tuple[int, ...]


class Extension(Finite[Digits]):
    """The field GF(pⁿ): polynomials in x modulo ``modulus``, a monic list of n + 1 integers, low degree
    first.

    The name omits Conway's polynomial. For q above 4096, where that polynomial is not known here, a field
    without a modulus has the plain name, and only the elements of GF(p) in it can be named.
    """

    is_field = True

    def __init__(self, p: int, n: int, modulus: Sequence[int] | None) -> None:
        self.characteristic, self.degree, self.order = p, n, p**n
        self.digits = n
        self.is_wide = n >= 8
        self.words = f"the field with {self.order} elements"
        if modulus is None:
            self.name = f"GF({self.order})"
            if self.order in CONWAY:
                reject(f"{self.name} has to say its modulus")
        elif len(modulus) != n + 1 or modulus[-1] != 1 or not all(0 <= c < p for c in modulus):
            reject(
                f"a modulus of GF({shown(self.order)}) is monic, of the degree {n}, reduced modulo {p}"
            )
        else:
            shape = polynomial_text(modulus, "x")
            conway = " ".join(map(str, modulus)) == CONWAY.get(self.order)
            self.name = f"GF({self.order})" if conway else f"GF({self.order}, {shape})"
            self.words += f", x a root of {shape}"
        self.zero: Digits = (0,) * n
        self.one: Digits = (1, *(0,) * (n - 1))
        self.modulus: Digits | None = None if modulus is None else tuple(modulus)
        if modulus is not None:
            self._tail = [-c % p for c in modulus[:-1]]
            if not self._irreducible():
                reject(f"the modulus of {shown(self.name)} is reducible")

    def from_digits(self, values: Sequence[int]) -> Digits:
        """Return the class of a polynomial in x, low degree first."""
        return tuple(values)

    def number(self, n: int) -> Digits:
        """Return n·1."""
        return (n % self.characteristic, *self.zero[1:])

    def add(self, x: Digits, y: Digits) -> Digits:
        """Return x + y."""
        p = self.characteristic
        if self.is_wide:
            spend(self.degree // 8)
        return tuple([(a + b) % p for a, b in zip(x, y, strict=True)])

    def neg(self, x: Digits) -> Digits:
        """Return −x."""
        if self.is_wide:
            spend(self.degree // 8)
        return tuple([-a % self.characteristic for a in x])

    def mul(self, x: Digits, y: Digits) -> Digits:
        """Return x·y."""
        n, p = self.degree, self.characteristic
        if self.is_wide:
            spend(n // 8)
        if not any(x[1:]):
            return tuple([x[0] * b % p for b in y])
        if not any(y[1:]):
            return tuple([a * y[0] % p for a in x])
        if self.modulus is None:
            reject(f"the modulus of {self.name} is not known here; write it in the field's name")
        spend(n * n)
        wide = [0] * (2 * n - 1)
        for m, a in enumerate(x):
            if a:
                for k, b in enumerate(y):
                    wide[m + k] += a * b
        for m in range(2 * n - 2, n - 1, -1):
            top = wide[m] % p
            if top:
                for k, c in enumerate(self._tail):
                    wide[m - n + k] += top * c
        return tuple([c % p for c in wide[:n]])

    def inverse(self, x: Digits) -> Digits | None:
        """Return 1/x = x^(q−2)."""
        if x == self.zero:
            return None
        if not any(x[1:]):
            return self.number(pow(x[0], -1, self.characteristic))
        return self.power(x, self.characteristic**self.degree - 2)

    def constant(self, tree: Tree) -> Digits | None:
        """Return the class of x for the name of the generator."""
        if tree != ("name", "x"):
            return None
        if self.modulus is None:
            reject(f"what x is in {self.name} is not known here; write the modulus in its name")
        return (0, 1, *(0,) * (self.degree - 2))

    def elements(self) -> Iterator[Digits]:
        """Yield all elements."""
        return product(range(self.characteristic), repeat=self.degree)

    def _irreducible(self) -> bool:
        """Return whether the modulus is irreducible (Rabin): x^(p^n) = x, and x^(p^(n/r)) − x is prime to it
        for primes r | n.
        """
        n, p = self.degree, self.characteristic
        x: Digits = (0, 1, *(0,) * (n - 2))
        powers, y = [x], x
        for _ in range(n):
            y = self.power(y, p)
            powers.append(y)
        if y != x:
            return False
        assert self.modulus is not None
        for r in (r for r in range(2, n + 1) if n % r == 0 and is_prime(r)):
            rest = self.add(powers[n // r], self.neg(x))
            if len(gcd_modulo(list(self.modulus), list(rest), p)) != 1:
                return False
        return True


def gcd_modulo(f: list[int], g: list[int], p: int) -> list[int]:
    """Return the greatest common divisor of polynomials over GF(p), low degree first."""
    while g and g[-1] == 0:
        g.pop()
    while g:
        spend(len(f) * len(g))
        lead = pow(g[-1], -1, p)
        while len(f) >= len(g):
            c, shift = f[-1] * lead % p, len(f) - len(g)
            for m, d in enumerate(g):
                f[m + shift] = (f[m + shift] - c * d) % p
            while f and f[-1] == 0:
                f.pop()
        f, g = g, f
    return f


def _residues(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    n = an_integer(plain(data, "modulus")["modulus"], "the modulus", 2)
    return Residues(n, n < PROVED_BELOW and is_prime(n), f"ZZ/{n}")


def _galois_field(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    """Return GF(p), or GF(pⁿ) with its modulus."""
    plain(data, "characteristic degree modulus")
    p = an_integer(data["characteristic"], "the characteristic", 2)
    n = an_integer(data["degree"], "the degree", 1)
    if n > MAX_DEGREE or n * (p.bit_length() - 1) >= MAX_BITS:
        reject(f"a finite field of degree {shown(n)} over GF({shown(p)}) is too large")
    if not is_prime(p):
        reject(f"the characteristic {p} is not a prime number")
    modulus = data["modulus"]
    if n == 1:
        if modulus is not None:
            reject(f"GF({p}) takes no modulus")
        return Residues(p, True, f"GF({p})")
    if modulus is None:
        return Extension(p, n, None)
    return Extension(p, n, [an_integer(c, "a coefficient") for c in a_list(modulus, "a modulus")])


KINDS: dict[str, Kind] = {"residues": _residues, "finite field": _galois_field}
