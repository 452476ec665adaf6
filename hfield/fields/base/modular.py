"""Integers modulo n by flint, for ZZ/n and GF(p): ``nmod`` below 2⁶³, ``fmpz_mod`` above."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import gcd
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.primality import WORD
from hfield.core.product import Constants
from hfield.errors import (
    NotInvertibleError,
    UndecidedError,
    shorten,
)
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.ring import FINITE_LIMIT, Fact, Ring
from hfield.fields.base.roots import of_flint, residue_roots
from hfield.fields.base.storage.base import Storage
from hfield.fields.base.value_ring import ValueRing

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import Coefficient


SEARCH = 2_000  # the largest modulus for which squares are searched one by one


class Modular(ValueRing):
    """The ring of integers modulo n ≥ 2; elements are flint's ``nmod`` or ``fmpz_mod``.

    ``integers`` is ℤ.
    """

    order: int
    parse_limit = FINITE_LIMIT

    def __init__(self, integers: Ring, name: str, modulus: int, is_field: bool) -> None:
        self.integers, self.name = integers, name
        self.characteristic = self.order = self.modulus = modulus
        self.is_field = is_field
        self.residue: Callable[[int], flint.nmod | flint.fmpz_mod]  # of any int
        if modulus < WORD:
            self.residue = lambda x: flint.nmod(x % modulus, modulus)
        else:
            self.residue = flint.fmpz_mod_ctx(modulus)
        self._type = type(self.residue(0))

    def __call__(self, x: object) -> flint.nmod | flint.fmpz_mod:
        """Convert an int n to n·1 and a Fraction a/b to a·b⁻¹; read a text.

        Raises :class:`CoercionError`, and :class:`NotInvertibleError` if b is not a unit.
        """
        x = unwrap(x)
        if isinstance(x, self._type):
            if self._modulus_of(x) == self.modulus:
                return x
            raise self.refuse(x)
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        if number is None:
            return self.foreign(x)
        if isinstance(number, Fraction):
            return self.ratio(number)
        return self.residue(number)

    def closed_form(self, x: sympy.Expr) -> flint.nmod | flint.fmpz_mod:
        """Raise an error for roots and other closed forms: there may be several such elements, or none."""
        raise self.refuse(x, "of numbers only rational ones are read here")

    def to_sympy(
        self, x: flint.nmod | flint.fmpz_mod, symbols: Mapping[str, sympy.Symbol]
    ) -> sympy.Expr:
        """Return the representative from 0 to n − 1."""
        import sympy

        return sympy.Integer(int(x))

    def _modulus_of(self, x: Coefficient) -> int:
        """Return the modulus of a residue; for flint's fmpz_mod it is computed from −1."""
        return int(x.modulus()) if self.modulus < WORD else int(-(x - x + 1)) + 1

    @property
    def residues_of(self) -> tuple[Ring, flint.fmpz]:
        """ℤ and the modulus."""
        return self.integers, flint.fmpz(self.modulus)

    def modulo(self, n: int) -> Ring | None:
        """Return ℤ/n for a divisor n of the modulus."""
        return None if self.modulus % n else self.integers.modulo(n)

    def lift(self, x: flint.nmod | flint.fmpz_mod) -> flint.fmpz:
        """Return the residue between 0 and n − 1 as an integer."""
        return flint.fmpz(int(x))

    def label(self, x: flint.nmod | flint.fmpz_mod) -> int:
        """Return the residue between 0 and n − 1."""
        return int(x)

    key = state = label

    def from_label(self, n: int) -> flint.nmod | flint.fmpz_mod:
        """Return the residue with a given label from 0 to n − 1."""
        return self.residue(n)

    def inverse(self, x: flint.nmod | flint.fmpz_mod) -> flint.nmod | flint.fmpz_mod:
        """Return 1/x. Raises :class:`NotInvertibleError`, whose message gives a nonzero element that
        annihilates x.
        """
        value = int(x)
        common = gcd(value, self.modulus)
        if common == 1:
            return 1 / x
        if value == 0:
            raise NotInvertibleError(f"cannot divide by 0 in {shorten(self.name)}")
        raise NotInvertibleError(
            f"cannot divide by {shorten(value, 24)} in {shorten(self.name)}: it is a zero divisor, "
            f"times {shorten(self.modulus // common, 24)} it gives 0"
        )

    def is_unit(self, x: flint.nmod | flint.fmpz_mod) -> bool:
        """Return whether x has an inverse."""
        return gcd(int(x), self.modulus) == 1

    def annihilator(self, x: flint.nmod | flint.fmpz_mod) -> flint.nmod | flint.fmpz_mod | None:
        """Return some nonzero y with x·y = 0, or None."""
        common = gcd(int(x), self.modulus)
        return None if common == 1 else self.residue(self.modulus // common)

    def sqrt(self, x: flint.nmod | flint.fmpz_mod) -> flint.nmod | flint.fmpz_mod | None:
        """Return the smallest y with y² = x, or None. Raises :class:`UndecidedError` if n is too large."""
        if self.is_zero(x):
            return x
        if self.is_field:
            return self._field_sqrt(x)
        if self.modulus > SEARCH**2:
            raise UndecidedError(
                f"square roots in {shorten(self.name)} need the factors of a large modulus"
            )
        for n in range(self.modulus // 2 + 1):
            y = self.residue(n)
            if y * y == x:
                return y
        return None

    def _field_sqrt(self, x: Coefficient) -> Coefficient | None:
        if self.modulus == 2:
            return x
        value = flint.fmpz(int(x))
        if value.jacobi(self.modulus) != 1:
            return None
        root = int(value.sqrtmod(self.modulus))
        return self.residue(min(root, self.modulus - root))

    def roots(
        self, coefficients: Sequence[flint.nmod | flint.fmpz_mod]
    ) -> list[flint.nmod | flint.fmpz_mod]:
        """Return the roots of a nonzero polynomial. Raises :class:`UndecidedError`."""
        return [
            self.residue(n) for n in residue_roots([int(c) for c in coefficients], self.modulus)
        ]

    def irreducible_factors(
        self, coefficients: Sequence[flint.nmod | flint.fmpz_mod]
    ) -> list[list[flint.nmod | flint.fmpz_mod]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial modulo a prime."""
        if not self.is_field:
            return super().irreducible_factors(coefficients)
        over = flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(self.modulus))
        return of_flint(self, over([int(c) for c in coefficients]), lambda c: self.residue(int(c)))

    @property
    def level(self) -> Fact:
        """The least number of squares with sum −1."""
        squares = self.minus_one_as_squares()
        if not squares:
            return Fact(None, f"the modulus is too large to search (above {SEARCH})")
        shown = " + ".join(f"{int(y)}²" for y in squares)
        fewer = ", and fewer squares do not do" if len(squares) > 1 else ""
        return Fact(len(squares), f"−1 = {shown} in {shorten(self.name)}{fewer}")

    def minus_one_as_squares(self) -> tuple[flint.nmod | flint.fmpz_mod, ...]:
        """Return as few elements as possible whose squares add up to −1; () if n is too large."""
        minus_one = self.residue(-1)
        if self.is_field:
            root = self.sqrt(minus_one)
            return (root,) if root is not None else self._two_squares()
        if self.modulus > SEARCH:
            return ()
        return self._fewest_squares()

    def _two_squares(self) -> tuple[Coefficient, ...]:
        """Return x, y with x² + y² = −1 in a prime field; about half of all x have such a y."""
        for n in range(1, self.modulus):
            x = self.residue(n)
            y = self.sqrt(-1 - x * x)
            if y is not None:
                return x, y
        raise AssertionError("every finite field of odd characteristic has two such squares")

    def _fewest_squares(self) -> tuple[flint.nmod, ...]:
        """Search for sums of 1, 2, 3 and 4 squares; four suffice (Lagrange)."""
        n = self.modulus
        roots: dict[int, int] = {}
        for y in range(n // 2 + 1):
            roots.setdefault(y * y % n, y)

        def find(total: int, count: int) -> tuple[int, ...] | None:
            if count == 1:
                return (roots[total],) if total in roots else None
            for square, y in roots.items():
                rest = find((total - square) % n, count - 1)
                if rest is not None:
                    return (y, *rest)
            return None

        found = next(parts for count in range(1, 5) if (parts := find(n - 1, count)))
        return tuple(self.residue(y) for y in found)

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements as four ints between 0 and n − 1."""
        from hfield.fields.base.storage.quotients import ResidueStorage

        return ResidueStorage(self, constants)

    def elements(self) -> Iterator[flint.nmod | flint.fmpz_mod]:
        """Yield 0, 1, …, n − 1."""
        return (self.residue(n) for n in range(self.modulus))

    def random(self, rng: Random) -> flint.nmod | flint.fmpz_mod:
        """Return a random element; the same for the same seed."""
        return self.residue(rng.randrange(self.modulus))

    def power(self, x: flint.nmod | flint.fmpz_mod, n: int) -> flint.nmod | flint.fmpz_mod:
        """Return xⁿ; for n < 0, x is inverted first. Exponents of any size are fast."""
        base = x if n >= 0 else self.inverse(x)
        return self.residue(pow(int(base), abs(n), self.modulus))

    def text(self, x: flint.nmod | flint.fmpz_mod, style: str = "plain") -> str:
        """Write the residue between 0 and n − 1."""
        return str(int(x))
