"""Completions at a place: ``Qp(5)``, ``GF(9)((t))``, ``QQ(sqrt(2))_inf-``; only elements of the global field.

The elements are those of the global field, with its arithmetic. What is proved about the norm over the global
field at the place holds over the completion, where valuation and residues are the same. An ordering or a
level of the global field is not one of the completion, so nothing else is known here, except the one ordering
of the completion at a real place.
"""

from collections.abc import Mapping
from typing import Generic

from hfield.checker.language import Tree
from hfield.checker.rejection import an_integer, an_object, keyed, reject, shown
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.functions import Functions
from hfield.checker.scalars.names import plain
from hfield.checker.scalars.number_fields import NumberField
from hfield.checker.scalars.place import E, Place, R
from hfield.checker.scalars.quadratic import Quadratic
from hfield.checker.scalars.rationals import QQ
from hfield.checker.scalars.residues import jacobi
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing, Ring


class Completion(Ring[E]):
    """The completion of a global field; only elements of the global field can be named."""

    is_field = True

    def __init__(self, base: Ring[E], at: str) -> None:
        self.base, self.words = base, f"the completion of {base.name} at {at}"
        self.characteristic = base.characteristic
        self.zero, self.one = base.zero, base.one

    def number(self, n: int) -> E:
        """Return n·1."""
        return self.base.number(n)

    def add(self, x: E, y: E) -> E:
        """Return x + y."""
        return self.base.add(x, y)

    def neg(self, x: E) -> E:
        """Return −x."""
        return self.base.neg(x)

    def mul(self, x: E, y: E) -> E:
        """Return x·y."""
        return self.base.mul(x, y)

    def inverse(self, x: E) -> E | None:
        """Return 1/x, None for 0."""
        return self.base.inverse(x)

    def is_zero(self, x: E) -> bool:
        """Return whether x is 0."""
        return self.base.is_zero(x)

    def constant(self, tree: Tree) -> E | None:
        """Return the value of a name or call in the global field; O(…) has none."""
        return self.base.constant(tree)


class AtPrime(Completion[E], Generic[E, R]):
    """The completion at a finite place."""

    def __init__(self, base: Ring[E], place: Place[E, R]) -> None:
        self.only, at = place, place.name
        super().__init__(base, "infinity" if at == "inf" else f"the place {at}")
        self.name = f"{base.name}_{at}"
        if base is QQ:
            self.name, self.words = f"Qp{at}", f"the {at[1:-1]}-adic numbers"
        elif isinstance(base, Functions) and base.name == f"{base.base.name}{at}":
            self.name = f"{base.base.name}({at})"
            self.words = f"the completion of {base.name} at {base.variable} = 0, the Laurent series"

    def place(self, data: object) -> Place[E, R]:
        """Return the place of the completion."""
        found = self.base.place(data)
        if found.name != self.only.name:
            reject(f"{self.name} has one place, and {shown(found.name)} is not it")
        return self.only

    def is_square(self, x: E) -> bool:
        """Prove that x is not a square, because its valuation is odd or its residue is not a square."""
        over = self.only.residue(self.mul(x, self.base.need_inverse(self.only.odd)))
        if over is not None and self.only.is_unit(over):
            return False
        unit = self.only.residue(x)
        if unit is not None and self.only.is_unit(unit):
            trace, size = (self.only.residue(y) for y in (self.zero, self.neg(x)))
            if trace is not None and size is not None and self.only.is_irreducible(trace, size):
                return False
        return super().is_square(x)


class AtRealRoot(Completion[E]):
    """The real numbers with an embedded number field; its elements have the signs of one of its orderings."""

    def __init__(self, base: Ring[E], name: str, which: str, number: int) -> None:
        super().__init__(base, f"the real place where {which}")
        self.name, self.number_of_signs = f"{base.name}_{name}", number

    def sign(self, x: E) -> int | None:
        """Return the sign at the place."""
        return self.base.signs(x)[self.number_of_signs]

    def is_square(self, x: E) -> bool:
        """Return whether x is nonnegative."""
        return self.is_zero(x) or self.sign(x) == 1


def _completion(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    base, place = ring(plain(data, "of place")["of"]), keyed(data["place"], "a place")
    if place.get("kind") == "real":
        return _real(
            base, an_integer(an_object(place, "kind number", "a place")["number"], "number", 0)
        )
    if not (base is QQ or isinstance(base, (Quadratic, NumberField, Functions))):
        reject(f"the completions of {shown(base.name)} are not known here")
    if place.get("kind") == "other generator":
        reject("a completion is at an ideal that is given in the generator of the field")
    if base is QQ or isinstance(base, Quadratic):
        p = an_integer(place.get("n"), "a prime number", 2)
        if not is_prime(p):
            reject(f"the completions are at prime numbers, and {p} is none")
        d = base.d if isinstance(base, Quadratic) and place.get("kind") == "number" else 0
        if d and (d % 8 == 1 if p == 2 else jacobi(d, p) == 1):
            reject(f"two places of {base.name} lie above {p}")
    return AtPrime(base, base.place(place))


def _real(base: AnyRing, number: int) -> AnyRing:
    """Return the completion at the real root with a number, ascending from 0; for ℚ(√d), 0 means
    that √d < 0.
    """
    if isinstance(base, Quadratic) and base.d > 0 and number == 0:
        return AtRealRoot(base, "inf-", f"{base.gen} is negative", 1)
    if isinstance(base, NumberField):
        signs = base.signs(base.one)
        if number < len(signs) and signs[number] == 1:
            which = f"{base.gen} is the real root number {number}, ascending from 0"
            return AtRealRoot(base, f"inf{number}", which, number)
    reject(f"{shown(base.name)}: the real place number {number} is not known here")


KINDS: dict[str, Kind] = {"completion": _completion}
