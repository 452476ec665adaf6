"""ℚ(√m, √n, …): sums of square roots; if all are real, there is an ordering for each choice of signs."""

from collections.abc import Mapping
from fractions import Fraction
from itertools import product

from hfield.certificates.rejection import a_list, an_integer, reject
from hfield.certificates.scalars.names import plain
from hfield.certificates.scalars.ring import Kind, ReadRing, Ring
from hfield.certificates.scalars.surds import Radical, Surd, Surds, radical, root_text

MAX_ROOTS = 5


class Multiquadratic(Surds):
    """The field that several square roots of integers generate."""

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


def _multiquadratic(data: Mapping[str, object], ring: ReadRing) -> Ring:
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


KINDS: dict[str, Kind] = {"multiquadratic field": _multiquadratic}
