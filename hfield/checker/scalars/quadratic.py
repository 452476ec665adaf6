"""The field ℚ(√d): elements u + v·√d; squares, level, prime ideals."""

from collections.abc import Mapping
from fractions import Fraction
from itertools import product
from math import gcd

from hfield.checker.budget import spend
from hfield.checker.rejection import an_integer, an_object, keyed, reject, shown
from hfield.checker.scalars.names import plain
from hfield.checker.scalars.place import AnyPlace, Place
from hfield.checker.scalars.quotients import QuotientField
from hfield.checker.scalars.rationals import QQ, root
from hfield.checker.scalars.residues import (
    GF2,
    ModuloNumber,
    OverFiniteField,
    jacobi,
    modulo,
    two_or_odd,
)
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing
from hfield.checker.scalars.surds import Radical, Surd, Surds, radical, root_text

MAX_POWER = 1_000  # of n in a denominator


class Quadratic(Surds):
    """The field QQ(sqrt(d)) for a squarefree number d."""

    is_number_field = True

    def __init__(self, d: int) -> None:
        self.gen = root_text(d)
        self.name, self.words = f"QQ({self.gen})", f"the field of {self.gen} over ℚ"
        self.d, self.is_real = d, d > 0
        self.root, scale = radical(d)
        if scale != 1 or self.root == ():
            reject(f"{self.name}: expected the root of a squarefree number other than 1")

    def is_fraction_field_of(self, ring: AnyRing) -> bool:
        """Return whether this is ℚ(I) and the ring is ℤ[I]."""
        return self.d == -1 and ring.name == "ZZ[I]"

    def has_root(self, key: Radical) -> bool:
        """Return whether the square root is that of d."""
        return key == self.root

    def signs(self, x: Surd) -> tuple[int | None, ...]:
        """Return the signs of a + b·√d and of a − b·√d."""
        return self.sign(x), self.sign(tuple((key, -c if key else c) for key, c in x))

    def coefficients(self, x: Surd) -> tuple[Fraction, ...]:
        """Return u and v for u + v·√d."""
        return pair(x)

    def is_square(self, x: Surd) -> bool:
        """Return whether u + v·√d is a square: its norm is a square r², and one of (u ± r)/2 is a square."""
        u, v = pair(x)
        d, half = Fraction(self.d), Fraction(1, 2)
        if not v:
            return QQ.is_square(u) or QQ.is_square(QQ.mul(u, 1 / d))
        norm = QQ.add(QQ.mul(u, u), QQ.mul(-d, QQ.mul(v, v)))
        r = root(norm) if norm >= 0 else None
        return r is not None and any(QQ.is_square(QQ.mul(QQ.add(u, s), half)) for s in (r, -r))

    def level_above(self, bound: int) -> bool:
        """Prove that −1 is not a sum of ``bound`` squares; False means that no proof was found.

        For d ≡ 1 modulo 8, ℚ(√d) embeds in ℚ₂. A sum of four squares that is 0 in ℚ₂ could be scaled until
        one of its terms is odd; but then it is not 0 modulo 8.
        """
        if super().level_above(bound):
            return True
        if bound == 1:
            return self.d != -1
        return bound <= 3 and self.d % 8 == 1 and _odd_squares_modulo_8()

    def place(self, data: object) -> AnyPlace[Surd]:
        """Return a place of the kind ``number``, or ``split``, where √d is the ``root`` modulo n."""
        kind = keyed(data, "a place").get("kind")
        if kind == "split":
            found = an_object(data, "kind n root", "a place")
            return SplitIdeal(self, two_or_odd(found["n"]), an_integer(found["root"], "a root", 0))
        if kind != "number":
            return super().place(data)
        n = two_or_odd(an_object(data, "kind n", "a place")["n"])
        if n > 2 and gcd(n, self.d) == 1:
            return InertNumber(self, n)
        return InertTwo(self) if n == 2 and self.d % 4 == 1 else RamifiedIdeal(self, n)


def _odd_squares_modulo_8() -> bool:
    """Try all cases: a sum of four squares, not all of even numbers, is never 0 modulo 8."""
    return all(
        (w * w + x * x + y * y + z * z) % 8
        for w, x, y, z in product(range(8), repeat=4)
        if (w | x | y | z) & 1
    )


def pair(x: Surd) -> tuple[Fraction, Fraction]:
    """Return (u, v) with x = u + v·√d."""
    values = dict(x)
    u = values.pop((), Fraction(0))
    return u, next(iter(values.values()), Fraction(0))


def _pair_of_integers(x: Surd) -> tuple[Fraction, Fraction]:
    """Return (u, v) with x = u + v·ω, ω = (1 + √d)/2. If d ≡ 1 modulo 4, x is integral at 2 exactly if u and
    v are.
    """
    u, v = pair(x)
    return u - v, 2 * v


class RamifiedIdeal(ModuloNumber[Surd]):
    """ℚ(√d) at a divisor n of d, or at 2 for d ≢ 1 modulo 4; u + v·√d is integral if u and v are integral at
    n.

    √d ≡ d modulo the prime. The norm of √d − (d mod n) is (d mod n)² − d, which every prime factor of n
    divides exactly once, since d is squarefree; so this element generates the only prime ideal above that
    prime.
    """

    def __init__(self, field: Quadratic, n: int) -> None:
        if n > 2 and field.d % n:
            reject(f"{n} neither divides {field.d} nor is prime to it")
        self.n, self.root, self.name = n, field.d % n, f"({n})"
        self.odd = field.add(((field.root, Fraction(1)),), field.number(-self.root))

    def residue(self, x: Surd) -> int | None:
        """Return u + v·d modulo n."""
        u, v = (modulo(c, self.n) for c in pair(x))
        return None if u is None or v is None else (u + v * self.root) % self.n


class SplitIdeal(ModuloNumber[Surd]):
    """ℚ(√d) with √d ≡ r modulo n (modulo 4 for n = 2); r is prime to n, so the primes in n split.

    At such a prime p the completion is ℚ_p, with the square root of d congruent to r.
    """

    def __init__(self, field: Quadratic, n: int, r: int) -> None:
        self.n, self.odd, d = n, field.number(n), field.d
        self.name = f"({n}, {field.gen}-{r})"
        self.pair = _pair_of_integers if n == 2 else pair
        # ω, its trace and its norm
        self.root, self.trace, self.norm = ((1 + r) // 2, 1, (1 - d) // 4) if n == 2 else (r, 0, -d)
        fits = d % 8 == 1 and r in (1, 3) if n == 2 else r < n and gcd(r, n) == 1
        if not fits or self._minimal(self.root) % n:
            reject(f"√{shown(d)} is not {shown(r)} at an ideal above {shown(n)}")

    def _minimal(self, r: int) -> int:
        return r * r - self.trace * r + self.norm

    def residue(self, x: Surd) -> int | None:
        """Return the residue class of u + v·ω modulo n."""
        u, v = self.pair(x)
        below = u.denominator * v.denominator
        top = (u * below).numerator, (v * below).numerator
        power, rest = 0, below
        while rest % self.n == 0:
            spend(5 + rest.bit_length() // 100)
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
        """Return ω modulo a power of n, by Newton's iteration."""
        spend(10 + modulus.bit_length() ** 2 // 500)
        r = self.root
        while self._minimal(r) % modulus:
            r = (r - self._minimal(r) * pow(2 * r - self.trace, -1, modulus)) % modulus
        return r


class InertNumber(Place[Surd, tuple[int, int]]):
    """ℚ(√d) at an odd n prime to d; u + v·√d is integral if u and v are integral at n.

    If a prime p in n is inert, an element of GF(p²) is a square if and only if its norm is a square in GF(p).
    If p splits and the norm of D is not a square, then D is not a square at one of the two prime ideals. So
    the quadratic symbol of the norm decides.
    """

    def __init__(self, field: Quadratic, n: int) -> None:
        self.n, self.d, self.odd, self.name = n, field.d, field.number(n), f"({n})"

    def residue(self, x: Surd) -> tuple[int, int] | None:
        """Return (u, v) modulo n."""
        u, v = (modulo(c, self.n) for c in pair(x))
        return None if u is None or v is None else (u, v)

    def _norm(self, u: int, v: int) -> int:
        return u * u - self.d * v * v

    def is_unit(self, residue: tuple[int, int]) -> bool:
        """Return whether the norm is prime to n."""
        return gcd(self._norm(*residue), self.n) == 1

    def is_irreducible(self, trace: tuple[int, int], norm: tuple[int, int]) -> bool:
        """Return whether the discriminant is not a square."""
        u, v = trace
        discriminant = u * u + self.d * v * v - 4 * norm[0], 2 * u * v - 4 * norm[1]
        return jacobi(self._norm(*discriminant), self.n) == -1


class InertTwo(OverFiniteField[Surd, tuple[int, ...]]):
    """ℚ(√d) at 2 for d ≡ 5 modulo 8, with residues in GF(4); for d ≡ 1 the polynomial of ω would be
    reducible.
    """

    def __init__(self, field: Quadratic) -> None:
        self.residues: QuotientField[int] = QuotientField(GF2, [(1 - field.d) // 4 % 2, 1, 1])
        self.odd, self.name = field.number(2), "(2)"

    def residue(self, x: Surd) -> tuple[int, ...] | None:
        """Return u + v·ω modulo 2."""
        u, v = (modulo(c, 2) for c in _pair_of_integers(x))
        return None if u is None or v is None else self.residues.reduce([u, v])


def _quadratic(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    return Quadratic(an_integer(plain(data, "d")["d"], "the number under the root"))


KINDS: dict[str, Kind] = {"quadratic field": _quadratic}
