"""Completions at a place: ``Qp(5)``, ``GF(9)((t))``, ``QQ(sqrt(2))_inf-``, as far as the global field goes.

Elements are those of the global field, on which the completion computes as it does. What is shown at the
place of the norm over the global field holds over the completion, where valuation and residues are the same.
An ordering or a level of the global field is none of the completion, so nothing else is known here, but
the one ordering of the completion at a real place.
"""

import re
from collections.abc import Hashable

from hfield.certificates.language import Tree
from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.finite import Finite, is_prime
from hfield.certificates.scalars.functions import Functions
from hfield.certificates.scalars.names import integer
from hfield.certificates.scalars.number_fields import NumberField
from hfield.certificates.scalars.place import Place
from hfield.certificates.scalars.quadratic import Quadratic
from hfield.certificates.scalars.rationals import QQ
from hfield.certificates.scalars.residues import jacobi
from hfield.certificates.scalars.ring import ReadRing, Ring


class Completion(Ring):
    """The completion of a global field, of which only elements of the global field are named."""

    is_field = True

    def __init__(self, name: str, base: Ring) -> None:
        self.name, self.base = name, base
        self.characteristic = base.characteristic
        self.zero, self.one = base.zero, base.one

    def number(self, n: int) -> Hashable:
        """Return n·1."""
        return self.base.number(n)

    def add(self, x: Hashable, y: Hashable) -> Hashable:
        """Return x + y."""
        return self.base.add(x, y)

    def neg(self, x: Hashable) -> Hashable:
        """Return −x."""
        return self.base.neg(x)

    def mul(self, x: Hashable, y: Hashable) -> Hashable:
        """Return x·y."""
        return self.base.mul(x, y)

    def inverse(self, x: Hashable) -> Hashable | None:
        """Return 1/x, None for 0."""
        return self.base.inverse(x)

    def is_zero(self, x: Hashable) -> bool:
        """Tell whether x is 0."""
        return self.base.is_zero(x)

    def constant(self, tree: Tree) -> Hashable | None:
        """Return what the name or call means in the global field; O(…) means nothing."""
        return self.base.constant(tree)


class AtPrime(Completion):
    """The completion at a finite place."""

    def __init__(self, name: str, base: Ring, place: str) -> None:
        super().__init__(name, base)
        self.place_name, self.only = place, base.place(place)

    def place(self, text: str) -> Place:
        """Return the one place."""
        if "".join(text.split()) != self.place_name:
            reject(f"{self.name} has one place, and {shown(text)} is not it")
        return self.only

    def is_square(self, x: Hashable) -> bool:
        """Tell that x is none: its valuation is odd, or it is a unit and no square among the residues."""
        over = self.only.residue(self.mul(x, self.base.inverse(self.only.odd)))
        if over is not None and self.only.is_unit(over):
            return False
        unit = self.only.residue(x)
        if unit is not None and self.only.is_unit(unit):
            trace, size = (self.only.residue(y) for y in (self.zero, self.neg(x)))
            if self.only.is_irreducible(trace, size):
                return False
        return super().is_square(x)


class AtRealRoot(Completion):
    """The real numbers with a number field in them: signs are those of one of its orderings."""

    def __init__(self, name: str, base: Ring, number: int) -> None:
        super().__init__(name, base)
        self.number_of_signs = number

    def sign(self, x: Hashable) -> int | None:
        """Return the sign at the place."""
        return self.base.signs(x)[self.number_of_signs]

    def is_square(self, x: Hashable) -> bool:
        """Tell whether x is not negative."""
        return self.is_zero(x) or self.sign(x) == 1


def read(name: str, ring: ReadRing) -> Ring | None:
    """Return ``Qp(5)``, ``GF(9)((t))``, or any other completion at a finite or a real place."""
    if m := re.fullmatch(r"Qp\(([0-9]+)\)", name):
        return _checked(name, QQ, m[1])
    if m := re.fullmatch(r"(.+)\(\(([a-zA-Z][a-zA-Z0-9_]*)\)\)", name):
        return _checked(name, ring(f"{m[1]}({m[2]})"), m[2])
    if m := re.fullmatch(r"(.+)_inf([0-9]+|-)", name):
        return _real(name, ring(m[1]), m[2])
    if m := re.fullmatch(r"(.+)_(inf|\(.+\))", name):
        return _checked(name, ring(m[1]), m[2] if "," in m[2] else m[2].strip("()"))
    return None


def _checked(name: str, base: Ring, place: str) -> AtPrime:
    """Return the completion, if the text names a single finite place of the field."""
    if base is QQ or isinstance(base, Quadratic):
        p = integer(re.sub(r"\(([0-9]+),.*", r"\1", place))
        if not is_prime(p):
            reject(f"{shown(name)}: {p} is no prime number")
        d = base.d if isinstance(base, Quadratic) and "," not in place else 0
        if d and (d % 8 == 1 if p == 2 else jacobi(d, p) == 1):
            reject(f"{shown(name)}: two places lie above {p}")
    elif not (isinstance(base, NumberField) or _is_over_finite(base)):
        reject(f"the completions of {shown(base.name)} are not known here")
    return AtPrime(name, base, place)


def _real(name: str, base: Ring, number: str) -> AtRealRoot:
    """Return the completion at the real root of that number, ascending, or where a root is negative."""
    if isinstance(base, Quadratic) and base.d > 0 and number == "-":
        return AtRealRoot(name, base, 1)
    if isinstance(base, NumberField) and number != "-":
        n, signs = integer(number), base.signs(base.one)
        if n < len(signs) and signs[n] == 1:
            return AtRealRoot(name, base, n)
    reject(f"{shown(name)}: no such real place is known here")


def _is_over_finite(base: Ring) -> bool:
    return isinstance(base, Functions) and isinstance(base.base, Finite)
