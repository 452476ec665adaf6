"""The valuations at which a norm form is looked at: what is integral, and what its residue is.

Over ℚ and ℚ(√d) an odd n need not be a prime. Where a Jacobi symbol (D/n) is −1, some prime p divides n an
odd number of times and D is no square modulo p: the valuation meant is that of such a p, and what is
integral at n is integral there. To take for not integral what is so does no harm: it only rejects.
"""

import re
from abc import ABC, abstractmethod
from fractions import Fraction
from math import gcd
from typing import Any

from hfield.certificates.local.quotients import Quotient, has_no_root
from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.finite import Residues
from hfield.certificates.scalars.functions import Functions, dense
from hfield.certificates.scalars.numbers import Rationals, Surds
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.work import charge

MAX_DIGITS = 1_000
MAX_POWER = 1_000  # of n in a denominator
GF2 = Residues(2, True, "GF(2)")


class Place(ABC):
    """A valuation of a field, and ``odd``, an element whose valuation is an odd number."""

    odd: Any

    @abstractmethod
    def residue(self, x: Any) -> Any:
        """Return the residue of an integral element; None for another."""

    @abstractmethod
    def is_unit(self, residue: Any) -> bool:
        """Tell whether this is the residue of a unit."""

    @abstractmethod
    def is_irreducible(self, trace: Any, norm: Any) -> bool:
        """Tell whether X² − trace·X + norm has no root in the residue field."""


def read_place(field: Ring, text: str) -> Place:
    """Read a place: ``7`` of ℚ, ``7`` or ``(7, sqrt(2)-3)`` of ℚ(√2), ``t^2+1`` or ``inf`` of GF(q)(t)."""
    name = "".join(text.split())
    if isinstance(field, Rationals) and field.name == "QQ":
        return Number(_number(name))
    if isinstance(field, Functions) and field.base.order is not None:
        return Infinity(field) if name == "inf" else PrimePolynomial(field, field.read(text))
    if isinstance(field, Surds) and field.d is not None:
        root = "I" if field.d == -1 else f"sqrt({field.d})"
        m = re.fullmatch(r"\(([0-9]+),(.+)-([0-9]+)\)", name)
        if m is not None and m[2] == root:
            return SplitIdeal(field, _number(m[1]), int(m[3]))
        n = _number(name)
        if n > 2 and gcd(n, field.d) == 1:
            return InertNumber(field, n)
        return InertTwo(field) if n == 2 and field.d % 4 == 1 else RamifiedIdeal(field, n)
    reject(f"no places of {field.name} are known here")


def _number(text: str) -> int:
    """Read 2 or an odd number above it."""
    if not (text.isascii() and text.isdigit() and len(text) <= MAX_DIGITS):
        reject(f"{shown(text)!r} is no place, or too large a number")
    n = int(text)
    if n != 2 and (n < 3 or n % 2 == 0):
        reject(f"{n} is no place: expected 2 or an odd number")
    return n


def jacobi(a: int, n: int) -> int:
    """Return the Jacobi symbol (a/n) for an odd n > 0, by the law of reciprocity."""
    charge(10 + n.bit_length() ** 2 // 100)
    a, sign = a % n, 1
    while a:
        while a % 2 == 0:
            a //= 2
            if n % 8 in (3, 5):
                sign = -sign
        if a % 4 == n % 4 == 3:
            sign = -sign
        a, n = n % a, a
    return sign if n == 1 else 0


def _modulo(x: Fraction, n: int) -> int | None:
    """Return the class of a rational number; None where the denominator is not prime to n."""
    if gcd(x.denominator, n) > 1:
        return None
    return x.numerator * pow(x.denominator, -1, n) % n


class _ModuloNumber(Place):
    """Residues are the integers modulo n."""

    n: int

    def is_unit(self, residue: int) -> bool:
        """Tell whether it is prime to n."""
        return gcd(residue, self.n) == 1

    def is_irreducible(self, trace: int, norm: int) -> bool:
        """Ask whether the discriminant is a square; modulo 2 only X² + X + 1 is irreducible."""
        if self.n == 2:
            return has_no_root(GF2, trace, norm)
        return jacobi(trace * trace - 4 * norm, self.n) == -1


class Number(_ModuloNumber):
    """ℚ at n: integral are the fractions whose denominator is prime to n."""

    def __init__(self, n: int) -> None:
        self.n, self.odd = n, Fraction(n)

    def residue(self, x: Fraction) -> int | None:
        """Return the class modulo n."""
        return _modulo(x, self.n)


def _pair(x: Any) -> tuple[Fraction, Fraction]:
    """Return (u, v) with x = u + v·√d."""
    values = dict(x)
    u = values.pop((), Fraction(0))
    return u, next(iter(values.values()), Fraction(0))


def _pair_of_integers(x: Any) -> tuple[Fraction, Fraction]:
    """Return (u, v) with x = u + v·ω, ω = (1 + √d)/2: at 2 these are the integers for d ≡ 1 modulo 4."""
    u, v = _pair(x)
    return u - v, 2 * v


class RamifiedIdeal(_ModuloNumber):
    """ℚ(√d) at a divisor n of d, or at 2 for d ≢ 1 modulo 4: integral are u + v·√d with u, v integral at n.

    √d ≡ d modulo the prime, and √d − (d mod n) has the norm (d mod n)² − d, which every prime in n divides
    just once, since d is squarefree: it generates the only prime ideal above that prime.
    """

    def __init__(self, field: Surds, n: int) -> None:
        assert field.d is not None
        if n > 2 and field.d % n:
            reject(f"{n} neither divides {field.d} nor is prime to it")
        self.n, self.root = n, field.d % n
        omega = field.read("I" if field.d == -1 else f"sqrt({field.d})")
        self.odd = field.add(omega, field.number(-self.root))

    def residue(self, x: Any) -> int | None:
        """Return u + v·d modulo n."""
        u, v = (_modulo(c, self.n) for c in _pair(x))
        return None if u is None or v is None else (u + v * self.root) % self.n


class SplitIdeal(_ModuloNumber):
    """ℚ(√d) where √d is r modulo n (modulo 4 for n = 2): r is prime to n, so primes in n split.

    At such a prime p the completion is ℚ_p, with the root of d that begins with r.
    """

    def __init__(self, field: Surds, n: int, r: int) -> None:
        assert field.d is not None
        self.n, self.odd, d = n, field.number(n), field.d
        self.pair = _pair_of_integers if n == 2 else _pair
        # ω, its trace and its norm
        self.root, self.trace, self.norm = ((1 + r) // 2, 1, (1 - d) // 4) if n == 2 else (r, 0, -d)
        fits = d % 8 == 1 and r in (1, 3) if n == 2 else r < n and gcd(r, n) == 1
        if not fits or self._minimal(self.root) % n:
            reject(f"√{d} is not {r} at an ideal above {n}")

    def _minimal(self, r: int) -> int:
        return r * r - self.trace * r + self.norm

    def residue(self, x: Any) -> int | None:
        """Return the class of u + v·ω: of a numerator that is divisible by what n there is below it."""
        u, v = self.pair(x)
        below = u.denominator * v.denominator
        top = (u * below).numerator, (v * below).numerator
        power, rest = 0, below
        while rest % self.n == 0:
            charge(5 + rest.bit_length() // 100)
            rest, power = rest // self.n, power + 1
        if gcd(rest, self.n) > 1 or power > MAX_POWER:
            return None
        modulus = self.n ** (power + 1)
        value = (top[0] + top[1] * self._omega(modulus)) % modulus
        if value % self.n**power:
            return None
        residue: int = value // self.n**power * pow(rest, -1, self.n) % self.n
        return residue

    def _omega(self, modulus: int) -> int:
        """Return ω modulo a power of n, by Newton's steps."""
        charge(10 + modulus.bit_length() ** 2 // 500)
        r = self.root
        while self._minimal(r) % modulus:
            r = (r - self._minimal(r) * pow(2 * r - self.trace, -1, modulus)) % modulus
        return r


class InertNumber(Place):
    """ℚ(√d) at an odd n prime to d: integral are u + v·√d with u, v integral at n.

    Where p in n does not split, an element of GF(p²) is a square if its norm is one in GF(p); where p splits
    and the norm of D is none, D is none at one of the two prime ideals. So the symbol of the norm tells.
    """

    def __init__(self, field: Surds, n: int) -> None:
        assert field.d is not None
        self.n, self.d, self.odd = n, field.d, field.number(n)

    def residue(self, x: Any) -> tuple[int, int] | None:
        """Return (u, v) modulo n."""
        u, v = (_modulo(c, self.n) for c in _pair(x))
        return None if u is None or v is None else (u, v)

    def _norm(self, u: int, v: int) -> int:
        return u * u - self.d * v * v

    def is_unit(self, residue: tuple[int, int]) -> bool:
        """Tell whether the norm is prime to n."""
        return gcd(self._norm(*residue), self.n) == 1

    def is_irreducible(self, trace: tuple[int, int], norm: tuple[int, int]) -> bool:
        """Ask whether the discriminant is a square."""
        u, v = trace
        discriminant = u * u + self.d * v * v - 4 * norm[0], 2 * u * v - 4 * norm[1]
        return jacobi(self._norm(*discriminant), self.n) == -1


class _OverFiniteField(Place):
    """Residues are the elements of a finite field."""

    residues: Ring

    def is_unit(self, residue: Any) -> bool:
        """Tell whether it is not 0."""
        return not self.residues.is_zero(residue)

    def is_irreducible(self, trace: Any, norm: Any) -> bool:
        """Ask the residue field."""
        return has_no_root(self.residues, trace, norm)


class InertTwo(_OverFiniteField):
    """ℚ(√d) at 2 for d ≡ 5 modulo 8, with residues in GF(4); for d ≡ 1 the polynomial of ω is reducible."""

    def __init__(self, field: Surds) -> None:
        assert field.d is not None
        self.residues: Quotient = Quotient(GF2, [(1 - field.d) // 4 % 2, 1, 1])
        self.odd = field.number(2)

    def residue(self, x: Any) -> Any:
        """Return u + v·ω modulo 2."""
        u, v = (_modulo(c, 2) for c in _pair_of_integers(x))
        return None if u is None or v is None else self.residues.reduce([u, v])


class PrimePolynomial(_OverFiniteField):
    """GF(q)(t) at a prime polynomial P: integral are the fractions whose denominator P does not divide."""

    def __init__(self, field: Functions, prime: Any) -> None:
        self.base, self.odd = field.base, prime
        top, below = (dense(part, field.base) for part in prime)
        if len(below) != 1 or len(top) < 2:
            reject("a place is a polynomial, of a degree of at least 1")
        self.residues: Quotient = Quotient(field.base, top)

    def residue(self, x: Any) -> Any:
        """Return numerator over denominator modulo P."""
        k = self.residues
        top, below = (k.reduce(dense(part, self.base)) for part in x)
        inverse = k.inverse(below)
        return None if inverse is None else k.mul(top, inverse)


class Infinity(_OverFiniteField):
    """GF(q)(t) at infinity: integral are the fractions whose degree is not positive."""

    def __init__(self, field: Functions) -> None:
        self.residues = self.base = field.base
        self.odd = field.inverse(field.constant(("name", field.polynomials.names[0])))

    def residue(self, x: Any) -> Any:
        """Return the quotient of the coefficients at the degree of the denominator."""
        base = self.base
        top, below = (dense(part, base) for part in x)
        if len(top) > len(below):
            return None
        if len(top) < len(below):
            return base.zero
        return base.mul(top[-1], base.inverse(below[-1]))
