"""The protocol of rings in the checker: operations on plain, hashable values, and optional facts on
fields.

Each kind of ring is a module beside this one, with a class that implements the protocol, and ``KINDS``, which
builds rings from their data; ``fields`` lists these modules. A fact that a kind does not provide counts as
unknown and is never used.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any, Generic, TypeAlias, TypeVar

from hfield.checker.language import Tree, parse
from hfield.checker.rejection import keyed, reject, shown
from hfield.checker.scalars.place import AnyPlace, E

MAX_EXPONENT = 10_000


T = TypeVar("T")


def power(one: T, x: T, n: int, times: Callable[[T, T], T]) -> T:
    """Return xⁿ for n ≥ 0 by repeated squaring."""
    result = one
    while n:
        if n & 1:
            result = times(result, x)
        n >>= 1
        if n:
            x = times(x, x)
    return result


class Ring(ABC, Generic[E]):
    """A commutative ring. ``order`` is None if it is infinite.

    ``name`` is canonical: rings with the same name are the same ring. ``words`` describe the ring.
    """

    name: str
    words: str
    characteristic: int
    order: int | None = None
    is_field: bool = False
    is_integral: bool = False  # known to have no zero divisors, though it may be no field
    is_number_field: bool = False  # whether there may be functions over it
    is_exact: bool = True  # whether its arithmetic proves anything
    roots_by = "squares"  # shows that there are no roots: discriminants, or linear factors
    zero: E
    one: E

    @abstractmethod
    def number(self, n: int) -> E:
        """Return n·1."""

    @abstractmethod
    def add(self, x: E, y: E) -> E:
        """Return x + y."""

    @abstractmethod
    def neg(self, x: E) -> E:
        """Return −x."""

    @abstractmethod
    def mul(self, x: E, y: E) -> E:
        """Return x·y."""

    @abstractmethod
    def inverse(self, x: E) -> E | None:
        """Return 1/x, or None if x is not a unit."""

    def need_inverse(self, x: E) -> E:
        """Return 1/x; rejects an element that is not a unit."""
        found = self.inverse(x)
        if found is None:
            reject(f"an element of {self.name} has no inverse")
        return found

    @property
    def is_domain(self) -> bool:
        """Whether a product is 0 only if a factor is 0."""
        return self.is_field or self.is_integral

    @property
    def is_ordered(self) -> bool:
        """Whether ``sign`` returns the sign in an ordering of the field."""
        return self.is_field and self.sign(self.one) == 1

    def is_zero(self, x: E) -> bool:
        """Return whether x is 0."""
        return bool(x == self.zero)

    def constant(self, tree: Tree) -> E | None:
        """Return the element given by a name or a call, or None."""
        return None

    def named_elements(self, trees: Iterable[Tree]) -> dict[Tree, E]:
        """Return the elements that names and calls name; rejects one that names none."""
        out = {}
        for tree in trees:
            x = self.constant(tree)
            if x is None:
                reject(f"{shown(tree[1])!r} names no element of {self.name}")
            out[tree] = x
        return out

    def elements(self) -> Iterator[E]:
        """Yield all elements of a finite ring."""
        reject(f"{self.name} has infinitely many elements")

    def sign(self, x: E) -> int | None:
        """Return the sign of x in an ordering of the field; None if there is no ordering."""
        return None

    def signs(self, x: E) -> tuple[int | None, ...]:
        """Return the signs of x in several orderings of the field."""
        return (self.sign(x),)

    def is_square(self, x: E) -> bool:
        """Return whether x is a square; rejects if this is not decided here."""
        reject(f"squares in {self.name} are not decided here")

    def has_no_root(self, c: list[E]) -> bool:
        """Prove that Σ cₙ·xⁿ, of degree len(c) − 1, has no root in the field; False means that no proof was
        found.
        """
        if len(c) != 3 or self.characteristic == 2:
            return False
        four = self.mul(self.number(-4), self.mul(c[2], c[0]))
        return not self.is_square(self.add(self.mul(c[1], c[1]), four))

    def level_above(self, bound: int) -> bool:
        """Prove that −1 is not a sum of ``bound`` squares in a field; False means that no proof was found."""
        return bound < 1 or self.is_ordered

    def place(self, data: object) -> AnyPlace[E]:
        """Return the place of the field given by data."""
        kind = keyed(data, "a place").get("kind")
        reject(f"no place of the kind {shown(kind)!r} is known of {self.name}")

    def is_fraction_field_of(self, ring: "AnyRing") -> bool:
        """Return whether this is the field of fractions of another ring."""
        return False

    def contains(self, x: E) -> bool:
        """Return whether x lies in the ring, where it is of the field of fractions with the same values."""
        return True

    def at(self, point: str) -> "tuple[AnyRing, Callable[[E], Hashable]]":
        """Return the field of values of functions at a point, and the evaluation map."""
        reject(f"the elements of {self.name} have no values at points here")

    def coefficients(self, x: E) -> tuple[Fraction, ...]:
        """Return the coefficients of the powers of the generator in an element of a number field."""
        reject(f"the elements of {self.name} have no coefficients over QQ here")

    def maps_modulo(self, n: int) -> bool:
        """Return whether the ring modulo n is ℤ/n."""
        return False

    def equal(self, x: E, y: E) -> bool:
        """Return whether x = y."""
        return self.is_zero(self.add(x, self.neg(y)))

    def power(self, x: E, n: int) -> E:
        """Return xⁿ for n ≥ 0."""
        return power(self.one, x, n, self.mul)

    def fraction(self, value: int | Fraction) -> E | None:
        """Return the value of a literal, or None if its denominator is not a unit."""
        if isinstance(value, int):
            return self.number(value)
        below = self.inverse(self.number(value.denominator))
        return None if below is None else self.mul(self.number(value.numerator), below)

    def read(self, text: str) -> E:
        """Read an element from its text."""
        return self.value(parse(text), text)

    def value(self, tree: Tree, text: str) -> E:
        """Evaluate a term that is an element of the ring."""
        result: E | None = None
        if tree[0] == "num":
            result = self.fraction(tree[1])
        elif tree[0] == "neg":
            result = self.neg(self.value(tree[1], text))
        elif tree[0] in ("+", "-", "*", "/"):
            x, y = (self.value(t, text) for t in tree[1:])
            second = self.inverse(y) if tree[0] == "/" else self.neg(y) if tree[0] == "-" else y
            if second is not None:
                result = self.add(x, second) if tree[0] in "+-" else self.mul(x, second)
        elif tree[0] == "pow":
            x = self.value(tree[1], text)
            if abs(tree[2]) > MAX_EXPONENT:
                reject(f"the exponent in {shown(text)!r} is too large")
            base = self.inverse(x) if tree[2] < 0 else x
            result = None if base is None else self.power(base, abs(tree[2]))
        elif tree[0] in ("name", "call"):
            result = self.constant(tree)
        if result is None:
            reject(f"{shown(text)!r} is not an element of {self.name}")
        return result


AnyRing: TypeAlias = Ring[Any]
"""A ring that was read from data: of what type its elements are, only the ring knows."""

# Makes a ring of its data; given to each kind for the rings inside its own.
ReadRing = Callable[[object], AnyRing]
Kind = Callable[[Mapping[str, object], ReadRing], AnyRing]
