"""ℚ(√m, √n, …): sums of square roots; if all are real, there is an ordering for each choice of signs."""

import re
from fractions import Fraction
from itertools import product

from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.names import integer
from hfield.certificates.scalars.ring import ReadRing, Ring
from hfield.certificates.scalars.surds import Radical, Surd, Surds, radical

MAX_ROOTS = 5
_ROOT = r"(?:sqrt\(-?[0-9]+\)|I)"


class Multiquadratic(Surds):
    """The field that several square roots of integers generate."""

    def __init__(self, name: str, numbers: list[int]) -> None:
        super().__init__(name)
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
        """Tell whether the root is a product of those in the name, up to a rational number."""
        return key in self._span

    def is_square(self, x: Surd) -> bool:
        """Tell it of rational numbers, and of what is negative in an ordering."""
        if all(not key for key, _ in x):
            c = dict(x).get((), Fraction(0))
            return self.has_root(radical(c.numerator * c.denominator)[0])
        if -1 in self.signs(x):
            return False
        reject(f"whether a number is a square in {self.name} is not decided here")

    def signs(self, x: Surd) -> tuple[int | None, ...]:
        """Return the signs of x, the roots in the name taken as positive or negative in all ways."""
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


def read(name: str, ring: ReadRing) -> Ring | None:
    """Return ``QQ(sqrt(2),sqrt(3))``, two or more roots, I among them."""
    m = re.fullmatch(rf"QQ\(({_ROOT}(?:,{_ROOT})+)\)", name)
    if m is None:
        return None
    texts = m[1].split(",")
    if len(texts) > MAX_ROOTS:
        reject(f"{shown(name)} has more than {MAX_ROOTS} roots")
    return Multiquadratic(name, [-1 if text == "I" else integer_under(text) for text in texts])


def integer_under(text: str) -> int:
    """Return n of ``sqrt(n)``."""
    digits = text[5:-1]
    return -integer(digits[1:]) if digits[0] == "-" else integer(digits)
