"""The discrete valuations at which lattices are checked: a uniformiser, and residues in a finite field.

Of a valuation no more is used than this: which elements are integral, what their residues are (a
ring homomorphism whose kernel is the maximal ideal), and one element that generates this ideal. To take an
element that is integral for one that is not would be no harm: it only rejects.
"""

import re
from abc import ABC, abstractmethod
from fractions import Fraction
from typing import Any

from hfield.certificates.local.quotients import Quotient
from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.finite import Residues, is_prime
from hfield.certificates.scalars.functions import Functions, dense
from hfield.certificates.scalars.numbers import Rationals, Surds
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.work import charge

MAX_POWER = 4_000  # of a prime in a denominator


class Place(ABC):
    """A discrete valuation of a field with a finite residue field."""

    residues: Ring
    uniformiser: Any

    @abstractmethod
    def residue(self, x: Any) -> Any:
        """Return the residue of an integral element; None for another."""


def read_place(field: Ring, text: str) -> Place:
    """Read a place: ``7`` of ℚ, ``7`` or ``(7, sqrt(2)-3)`` of ℚ(√2), ``t^2+1`` or ``inf`` of GF(q)(t)."""
    name = "".join(text.split())
    if isinstance(field, Rationals) and field.is_field and field.name == "QQ":
        return PrimeNumber(_prime(name))
    if isinstance(field, Surds) and field.d is not None:
        m = re.fullmatch(r"\(([0-9]+),(sqrt\(-?[0-9]+\)|I)-([0-9]+)\)", name)
        if m is None:
            return OnlyPrimeIdeal(field, _prime(name))
        if m[2] != ("I" if field.d == -1 else f"sqrt({field.d})"):
            reject(f"{shown(name)!r} is no place of {field.name}")
        return SplitPrimeIdeal(field, _prime(m[1]), _number(m[3]))
    if isinstance(field, Functions) and field.base.order is not None:
        if name == "inf":
            return Infinity(field)
        return PrimePolynomial(field, field.read(text))
    reject(f"no places of {field.name} are known here")


def _number(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 60):
        reject(f"{shown(text)!r} is no prime number, or too large a one")
    return int(text)


def _prime(text: str) -> int:
    p = _number(text)
    if not is_prime(p):
        reject(f"{p} is no prime number")
    return p


def _residue(x: Fraction, p: int) -> int | None:
    """Return the class of a rational number modulo p; None where p divides the denominator."""
    return None if x.denominator % p == 0 else x.numerator * pow(x.denominator, -1, p) % p


class PrimeNumber(Place):
    """ℚ at p: integral are the fractions whose denominator p does not divide."""

    def __init__(self, p: int) -> None:
        self.p, self.residues, self.uniformiser = p, Residues(p, True, f"GF({p})"), Fraction(p)

    def residue(self, x: Fraction) -> int | None:
        """Return the class modulo p."""
        return _residue(x, self.p)


class _Quadratic(Place):
    """ℚ(√d) above p, in coordinates u + v·ω with ω² = trace·ω − norm.

    ω is (1 + √d)/2 where p = 2 and d ≡ 1 modulo 4, and √d elsewhere. The integers of the field are
    ℤ[ω] then, or ℤ[ω] has an index that is prime to p (2 for d ≡ 1 modulo 4, or 1).
    """

    def __init__(self, field: Surds, p: int) -> None:
        assert field.d is not None
        self.p, self.d, self.half = p, field.d, p == 2 and field.d % 4 == 1
        self.trace, self.norm = (1, (1 - field.d) // 4) if self.half else (0, -field.d)

    def coordinates(self, x: Any) -> tuple[Fraction, Fraction]:
        """Return (u, v) with x = u + v·ω."""
        values = dict(x)
        s = values.pop((), Fraction(0))
        t = next(iter(values.values()), Fraction(0))
        return (s - t, 2 * t) if self.half else (s, t)

    def minimal(self, r: int) -> int:
        """Return r² − trace·r + norm, which is 0 for r = ω."""
        return r * r - self.trace * r + self.norm


class OnlyPrimeIdeal(_Quadratic):
    """The prime ideal P above a p that does not split; integral are u + v·ω with u and v integral at p.

    Modulo p the minimal polynomial of ω is irreducible, and p generates P; or it has a double root r, and
    ω − r generates P, since its norm is divisible by p just once: were it by p², (ω − r)/p would be integral.
    """

    def __init__(self, field: Surds, p: int) -> None:
        super().__init__(field, p)
        self.residues: Ring
        if self.half or (p > 2 and self.d % p):
            minimal = [self.norm % p, -self.trace % p, 1]
            self.residues, self.uniformiser = (
                Quotient(Residues(p, True, f"GF({p})"), minimal),
                field.number(p),
            )
            self.omega: Any = self.residues.generator
            return
        root = self.d % p
        if self.minimal(root) % (p * p) == 0:
            reject(f"{field.d} is not squarefree")
        omega = field.read("I" if field.d == -1 else f"sqrt({field.d})")
        self.residues, self.omega = Residues(p, True, f"GF({p})"), root
        self.uniformiser = field.add(omega, field.number(-root))

    def residue(self, x: Any) -> Any:
        """Return u + v·ω with the residue of ω."""
        u, v = (_residue(c, self.p) for c in self.coordinates(x))
        if u is None or v is None:
            return None
        k = self.residues
        return k.add(k.number(u), k.mul(k.number(v), self.omega))


class SplitPrimeIdeal(_Quadratic):
    """A prime ideal P above a p that splits: √d is r modulo p there (modulo 4 for p = 2).

    The completion is that of ℚ at p, with ω a root of its minimal polynomial, known to any power of p.
    """

    def __init__(self, field: Surds, p: int, r: int) -> None:
        super().__init__(field, p)
        self.root = (1 + r) // 2 if self.half else r
        simple = (2 * self.root - self.trace) % p != 0 == self.minimal(self.root) % p
        if not simple or (self.half and r % 2 == 0) or r >= max(p, 4):
            reject(f"√{self.d} is not {r} at a prime ideal above {p}")
        self.residues, self.uniformiser = Residues(p, True, f"GF({p})"), field.number(p)

    def residue(self, x: Any) -> int | None:
        """Return the class of u + v·ω: a numerator that p divides as often as the denominator."""
        u, v = self.coordinates(x)
        below = u.denominator * v.denominator
        top = (u * below).numerator, (v * below).numerator
        power, rest = 0, below
        while rest % self.p == 0:
            rest, power = rest // self.p, power + 1
        if power > MAX_POWER:
            reject("a power of a prime is too large")
        modulus = self.p ** (power + 1)
        value = (top[0] + top[1] * self._omega(modulus)) % modulus
        if value % self.p**power:
            return None
        residue: int = value // self.p**power * pow(rest, -1, self.p) % self.p
        return residue

    def _omega(self, modulus: int) -> int:
        """Return ω modulo a power of p, by Newton's steps."""
        charge(10 + modulus.bit_length() ** 2 // 500)
        r = self.root
        while self.minimal(r) % modulus:
            r = (r - self.minimal(r) * pow(2 * r - self.trace, -1, modulus)) % modulus
        return r


class PrimePolynomial(Place):
    """GF(q)(t) at a prime polynomial P: integral are the fractions whose denominator P does not divide."""

    def __init__(self, field: Functions, prime: Any) -> None:
        self.base, self.uniformiser = field.base, prime
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


class Infinity(Place):
    """GF(q)(t) at infinity: integral are the fractions whose degree is not positive."""

    def __init__(self, field: Functions) -> None:
        self.residues = self.base = field.base
        self.uniformiser = field.inverse(field.constant(("name", field.polynomials.names[0])))

    def residue(self, x: Any) -> Any:
        """Return the quotient of the coefficients at the degree of the denominator."""
        base = self.base
        top, below = (dense(part, base) for part in x)
        if len(top) > len(below):
            return None
        if len(top) < len(below):
            return base.zero
        return base.mul(top[-1], base.inverse(below[-1]))
