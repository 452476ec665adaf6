"""The part of ℝ and ℂ that square roots of rational numbers generate, and ℚ(√m, √n, …) in it.

An element is a finite sum of rational multiples of √n, where n runs through products of −1 and
distinct primes; these roots are linearly independent over ℚ (Besicovitch 1940; docs/explanation/trust.md has
a proof), so an element is 0 only if all its coefficients are.
"""

from collections.abc import Mapping
from fractions import Fraction
from itertools import product
from math import isqrt, prod

from hfield.checker.budget import Remembered, spend
from hfield.checker.language import Tree
from hfield.checker.rejection import a_list, an_integer, reject, shown
from hfield.checker.scalars.names import only, plain
from hfield.checker.scalars.rationals import QQ
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing, Ring

MAX_ROOT = 10**9  # square roots of larger numbers are not taken apart
MAX_SUMMANDS = 32
MAX_ROOTS = 5  # of those that generate a field

Radical = tuple[int, ...]  # primes and −1, in order; () is 1
Surd = tuple[tuple[Radical, Fraction], ...]


class Surds(Ring[Surd]):
    """A field of sums of square roots."""

    characteristic = 0
    is_field = True
    is_real: bool  # whether it is part of ℝ

    zero: Surd = ()
    one: Surd = (((), Fraction(1)),)

    def has_root(self, key: Radical) -> bool:
        """Return whether the square root of the product of these primes lies in the field."""
        return True

    def number(self, n: int) -> Surd:
        """Return n."""
        return (((), Fraction(n)),) if n else ()

    def add(self, x: Surd, y: Surd) -> Surd:
        """Return x + y."""
        out = dict(x)
        for key, c in y:
            out[key] = QQ.add(out[key], c) if key in out else c
        return self._surd(out)

    def neg(self, x: Surd) -> Surd:
        """Return −x."""
        spend(len(x))
        return tuple((key, -c) for key, c in x)

    def mul(self, x: Surd, y: Surd) -> Surd:
        """Return x·y, by √m·√n = √(mn) with √(−1)² = −1."""
        out: dict[Radical, Fraction] = {}
        for m, c in x:
            for n, d in y:
                spend(5 + len(m) + len(n))
                key, common = tuple(sorted(set(m) ^ set(n))), set(m) & set(n)
                term = QQ.mul(c, d)
                if common:
                    term = QQ.mul(term, Fraction(prod(common)))
                out[key] = QQ.add(out[key], term) if key in out else term
        return self._surd(out)

    def inverse(self, x: Surd) -> Surd | None:
        """Return 1/x, by multiplying with one conjugate after the other."""
        if not x:
            return None
        top, below = self.one, x
        while any(key for key, _ in below):
            p = next(key[0] for key, _ in below if key)
            conjugate = tuple((key, -c if p in key else c) for key, c in below)
            top, below = self.mul(top, conjugate), self.mul(below, conjugate)
        return self.mul(top, (((), 1 / below[0][1]),))

    def sign(self, x: Surd) -> int | None:
        """Return the sign of a real number; None in a field that is not real.

        A sum of roots that is not () is not 0, so some precision tells its sign.
        """
        if not self.is_real:
            return None
        bits = 32
        while x:
            below = sum(_floor(key, c, bits) for key, c in x)  # at most len(x) below the sum
            if below > 0 or below + len(x) < 0:
                return 1 if below > 0 else -1
            bits *= 2
        return 0

    def constant(self, tree: Tree) -> Surd | None:
        """Return the value of ``I`` or of ``sqrt(…)``, if it lies in the field."""
        if tree == ("name", "I"):
            return self._inside((((-1,), Fraction(1)),))
        if tree[0] != "call" or tree[1] != "sqrt" or len(tree[2]) != 1:
            return None
        x = QQ.value(tree[2][0], "the number under a root")
        key, scale = radical(x.numerator * x.denominator)
        if scale == 0:
            return ()
        return self._inside(((key, Fraction(scale, x.denominator)),))

    def _inside(self, x: Surd) -> Surd | None:
        """Return x if it lies in the field."""
        return x if all(self.has_root(key) for key, _ in x if key) else None

    def _surd(self, values: dict[Radical, Fraction]) -> Surd:
        if len(values) > MAX_SUMMANDS:
            reject("too many square roots in one number")
        spend(1 + sum(map(len, values)))
        return tuple(sorted((key, c) for key, c in values.items() if c))


class Reals(Surds):
    """RR, as far as square roots go."""

    name, words = "RR", "the real algebraic numbers"

    is_real = True

    def has_root(self, key: Radical) -> bool:
        """Return whether the number under the root is positive."""
        return -1 not in key

    def is_square(self, x: Surd) -> bool:
        """Return whether x is not negative."""
        return self.sign(x) != -1


class Complexes(Surds):
    """CC, as far as square roots go."""

    name, words = "CC", "the complex algebraic numbers"

    is_real = False

    def is_square(self, x: Surd) -> bool:
        """Every number is a square."""
        return True


def _floor(key: Radical, c: Fraction, bits: int) -> int:
    """Return the greatest integer below or at c·√n·2^bits, n being the product of the primes."""
    n = prod(key)
    long = 2 * bits + n.bit_length() + 2 * (c.numerator.bit_length() + c.denominator.bit_length())
    spend(5 + len(key) + long * long // 500_000)
    square = c.numerator**2 * n << 2 * bits
    root = isqrt(square // c.denominator**2)
    return root if c > 0 else -root - 1


@Remembered
def radical(n: int) -> tuple[Radical, int]:
    """Return (primes, m) with √n = m·√(their product)."""
    if n == 0:
        return (), 0
    if abs(n) > MAX_ROOT:
        reject(f"the square root of {shown(n)} is not taken apart here")
    spend(isqrt(abs(n)))
    key, scale, rest, p = [-1] if n < 0 else [], 1, abs(n), 2
    while p * p <= rest:
        power = 0
        while rest % p == 0:
            rest, power = rest // p, power + 1
        scale *= p ** (power // 2)
        if power % 2:
            key.append(p)
        p += 1 + p % 2
        if p > 2000 and isqrt(rest) ** 2 == rest:
            scale, rest = scale * isqrt(rest), 1
    return tuple(key if rest == 1 else [*key, rest]), scale


def root_text(n: int) -> str:
    """Write the square root of an integer."""
    return "I" if n == -1 else f"sqrt({n})"


class Multiquadratic(Surds):
    """ℚ(√m, √n, …); if all roots are real, it has an ordering for each choice of their signs."""

    is_number_field = True

    def __init__(self, numbers: list[int]) -> None:
        self.name = f"QQ({','.join(map(root_text, numbers))})"
        self.words = f"the field of {', '.join(map(root_text, numbers))} over ℚ"
        self.is_real = all(n > 0 for n in numbers)
        self.roots: list[Radical] = []
        span: set[Radical] = {()}
        for n in numbers:
            key, _ = radical(n)
            if key not in span:
                self.roots.append(key)
                span |= {_product(key, other) for other in span}
        self._span = span

    def has_root(self, key: Radical) -> bool:
        """Return whether the root is a product of those in the name, up to a rational number."""
        return key in self._span

    def is_square(self, x: Surd) -> bool:
        """Return whether x is a square, where x is rational or negative in an ordering."""
        if all(not key for key, _ in x):
            c = dict(x).get((), Fraction(0))
            return self.has_root(radical(c.numerator * c.denominator)[0])
        if -1 in self.signs(x):
            return False
        reject(f"whether a number is a square in {self.name} is not decided here")

    def signs(self, x: Surd) -> tuple[int | None, ...]:
        """Return the signs of x under all choices of signs of the square roots in the name."""
        if not self.is_real:
            return (None,)
        out = []
        for signs in product((1, -1), repeat=len(self.roots)):
            at: dict[Radical, int] = {(): 1}
            for key, sign in zip(self.roots, signs, strict=True):
                at |= {_product(key, other): sign * s for other, s in at.items()}
            out.append(self.sign(tuple((key, c * at[key]) for key, c in x)))
        return tuple(out)


def _product(a: Radical, b: Radical) -> Radical:
    """Return the class of the product of two numbers that are products of different primes."""
    return tuple(sorted({*a} ^ {*b}))


def _multiquadratic(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    numbers = [
        an_integer(n, "a number under a root") for n in a_list(plain(data, "d")["d"], "d", 2)
    ]
    if len(numbers) > MAX_ROOTS:
        reject(f"there are {len(numbers)} square roots; at most {MAX_ROOTS} are taken")
    if (
        -1 in numbers[:-1]
        or len({*numbers}) < len(numbers)
        or not all(radical(n)[0] for n in numbers)
    ):
        reject("the numbers under roots are different, none is a square, and −1 is the last")
    return Multiquadratic(numbers)


KINDS: dict[str, Kind] = {
    "reals": only(Reals()),
    "complexes": only(Complexes()),
    "multiquadratic field": _multiquadratic,
}
