"""The integers, the rationals and the residue rings ZZ/n, on flint's ``fmpz``, ``fmpq``, ``nmod``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.primality import is_prime, primes
from hfield.core.product import Constants
from hfield.errors import CoercionError, NotInvertibleError, RingError, shorten
from hfield.fields.base.coercion import fmpq, rational, unwrap
from hfield.fields.base.modular import Modular
from hfield.fields.base.printing import number_text
from hfield.fields.base.ring import INFINITY, Fact, Ring, shared
from hfield.fields.base.roots import of_flint, rational_roots
from hfield.fields.base.storage.base import BatchStorage, Storage
from hfield.fields.base.value_ring import ValueRing
from hfield.fields.rationals.rational_numbers import rational_number

if TYPE_CHECKING:
    import numpy as np
    import sympy


_ORDERED = "squares are not negative in the usual ordering, so no sum of squares is −1"


class _Ordered(ValueRing):
    """The common part of ℤ and ℚ: exact numbers with their only ordering."""

    characteristic = 0

    def __reduce__(self) -> str:
        return self.name

    @property
    def level(self) -> Fact:
        """Infinite: −1 is not a sum of squares."""
        return Fact(INFINITY, _ORDERED)

    @property
    def orderings(self) -> Fact:
        """The usual ordering is the only one."""
        return Fact(1, "every positive number is a sum of four squares over one square")

    def sign(self, x: flint.fmpz | flint.fmpq, ordering: int = 0) -> int:
        """Return −1, 0 or 1."""
        self.check_ordering(ordering)
        return int(x > 0) - int(x < 0)

    @property
    def data(self) -> dict[str, object]:
        """ℤ or ℚ, by their names."""
        return {"kind": "rationals" if self.is_field else "integers"}

    def to_sympy(
        self, x: flint.fmpz | flint.fmpq, symbols: Mapping[str, sympy.Symbol]
    ) -> sympy.Expr:
        """Return the number as a sympy number."""
        import sympy

        return sympy.Rational(int(x.numerator), int(x.denominator))

    def text(self, x: int | flint.fmpz | flint.fmpq, style: str = "plain") -> str:
        """Write x, such as ``-1/2``."""
        return number_text(x, style)


class Integers(_Ordered):
    """ℤ; elements are flint's ``fmpz``. ``ZZ / 6`` is the residue ring.

    >>> (ZZ / 6).order, ZZ(6) * 7
    (6, 42)
    """

    name = "ZZ"
    is_field = False

    def in_words(self) -> str:
        """Return a description of ℤ."""
        return "the integers ℤ"

    def __call__(self, x: object) -> flint.fmpz:
        """Convert an integer to an element; read a text. Raises :class:`CoercionError`."""
        x = unwrap(x)
        if isinstance(x, flint.fmpz):
            return x
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        if number is None:
            return self.foreign(x)
        if isinstance(number, Fraction):
            raise CoercionError(f"{shorten(number_text(number))} is not an integer; QQ has it")
        return flint.fmpz(number)

    @property
    def fractions(self) -> Ring:
        """ℚ."""
        return QQ

    def modulo(self, n: int) -> Ring:
        """Return ℤ/n."""
        return Zmod(n)

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements as four ints, as over ℚ."""
        from hfield.fields.base.storage.fractions import FractionStorage

        return FractionStorage(
            self, constants, (0,), lambda x: (flint.fmpq(x),), lambda n, _=1: flint.fmpz(n)
        )

    def __truediv__(self, n: int) -> Modular:
        return Zmod(n)

    def array_storage(self, constants: Constants) -> BatchStorage:
        """Return the storage of arrays as rows of 64-bit integers, as long as they fit."""
        from hfield.fields.base.array_storage.words import WholeArrays

        return WholeArrays(self, constants)

    def inverse(self, x: flint.fmpz) -> flint.fmpz:
        """Return 1/x for x = 1 or −1. Raises :class:`NotInvertibleError`."""
        if x == 1 or x == -1:
            return x
        if x == 0:
            raise NotInvertibleError("cannot divide by 0 in ZZ")
        raise NotInvertibleError(
            f"{shorten(x)} has no inverse in ZZ, only 1 and -1 have; QQ has 1/x"
        )

    def divide(self, x: flint.fmpz, y: flint.fmpz) -> flint.fmpz:
        """Return x/y if y divides x. Raises :class:`NotInvertibleError`."""
        if y == 0 or x % y != 0:
            self.inverse(y)
        return x // y

    def euclid(self, x: flint.fmpz, y: flint.fmpz) -> tuple[flint.fmpz, flint.fmpz]:
        """Return the quotient and the remainder, which has the sign of y."""
        quotient, remainder = divmod(x, y)
        return quotient, remainder

    def roots(self, coefficients: Sequence[flint.fmpz]) -> list[flint.fmpz]:
        """Return the integer roots of a nonzero polynomial."""
        return [flint.fmpz(x.p) for x in rational_roots(coefficients) if x.q == 1]

    def sqrt(self, x: flint.fmpz) -> flint.fmpz | None:
        """Return the root y ≥ 0 with y² = x, or None."""
        return x.isqrt() if x >= 0 and x.is_square() else None


class Rationals(_Ordered):
    """ℚ; elements are flint's ``fmpq``.

    >>> QQ("1/3") + 1, QQ.level.value
    (4/3, inf)
    """

    name = "QQ"
    is_field = True
    theory = "rationals"

    def in_words(self) -> str:
        """Return a description of ℚ."""
        return "the rational numbers ℚ"

    def place_data(self, place: object) -> dict[str, object]:
        """Return a prime number as JSON data."""
        return {"kind": "number", "n": place}

    def __call__(self, x: object) -> flint.fmpq:
        """Convert a rational number to an element; read a text. Raises :class:`CoercionError`."""
        if type(x) is int:
            return flint.fmpq(x)
        x = unwrap(x)
        if isinstance(x, flint.fmpq):
            return x
        if isinstance(x, flint.fmpz):
            return flint.fmpq(x)
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        if number is None:
            return self.foreign(x)
        return fmpq(number)

    def array_storage(self, constants: Constants) -> BatchStorage:
        """Return the storage of arrays as rows of 64-bit integers, one of them for the denominators, as long
        as they fit.
        """
        from hfield.fields.base.array_storage.fractions import FractionArrays

        return FractionArrays(self, constants)

    def inverse(self, x: flint.fmpq) -> flint.fmpq:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        if x == 0:
            raise NotInvertibleError("cannot divide by 0 in QQ")
        return 1 / x

    def sqrt(self, x: flint.fmpq) -> flint.fmpq | None:
        """Return the root y ≥ 0 with y² = x, or None."""
        if x < 0 or not (x.p.is_square() and x.q.is_square()):
            return None
        return flint.fmpq(x.p.isqrt(), x.q.isqrt())

    def roots(self, coefficients: Sequence[flint.fmpq]) -> list[flint.fmpq]:
        """Return the rational roots of a nonzero polynomial."""
        return rational_roots(coefficients)

    def irreducible_factors(self, coefficients: Sequence[flint.fmpq]) -> list[list[flint.fmpq]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial."""
        return of_flint(self, flint.fmpq_poly(list(coefficients)), self)

    def is_rootless(self, coefficients: Sequence[flint.fmpq]) -> bool:
        """Return whether a polynomial has no rational root, that is, no linear factor."""
        return coefficients[-1] != 0 and not rational_roots(coefficients)

    degree = 1

    def integral_basis(self) -> tuple[flint.fmpq]:
        """Return 1."""
        return (self.one,)

    def random(self, rng: Random) -> flint.fmpq:
        """Return a small random fraction; the same for the same seed."""
        return flint.fmpq(rng.randint(-9, 9), rng.choice((1, 1, 2, 3, 5)))

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements as four ints over one denominator."""
        from hfield.fields.base.storage.fractions import FractionStorage

        return FractionStorage(self, constants, (0,), lambda x: (x,), rational_number)

    def places(self) -> Iterator[int | str]:
        """Yield the places: ``"inf"``, then the primes."""
        yield "inf"
        yield from primes()


class Residues(Modular):
    """ℤ/n for n ≥ 2, prime or not."""

    def __init__(self, n: int) -> None:
        super().__init__(ZZ, f"ZZ/{n}", n, is_prime(n))

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.modulus)

    @property
    def data(self) -> dict[str, object]:
        """The ring by its modulus."""
        return {"kind": "residues", "modulus": self.modulus}

    def array_of_labels(self, row: np.ndarray) -> np.ndarray:
        """Return an array of residues in the same form as ``array`` does."""
        from hfield.fields.base.arrays import objects

        return objects(row, lambda n: self(int(n)))

    def array_storage(self, constants: Constants) -> BatchStorage:
        """Return the storage of arrays as rows of residues, unless the modulus is too large."""
        from hfield.fields.base.array_storage.finite import array_storage

        return array_storage(self, constants)

    def in_words(self) -> str:
        """Return a description of ℤ/n."""
        return f"the integers modulo {shorten(self.modulus)}"


def Zmod(n: int) -> Modular:
    """Return the residue ring ℤ/n. Raises :class:`RingError` unless n is an int and at least 2.

    >>> from hfield import H
    >>> H(Zmod(6)).count("units")
    384
    """
    number = rational(n)
    if not isinstance(number, int):
        raise RingError(f"ZZ/{shorten(n)}: the modulus must be an integer, as in ZZ/6")
    if number.bit_length() > 4096:
        raise RingError(
            f"ZZ/n with n of {number.bit_length()} bits is too large; at most 4096 bits are taken"
        )
    if number == 0:
        raise RingError("ZZ/0 is the ring of integers itself: write ZZ")
    if number == 1:
        raise RingError("ZZ/1 is the zero ring, where 1 = 0; expected a modulus of at least 2")
    if number < 0:
        raise RingError(
            f"ZZ/{shorten(number, 20)}: the modulus must be at least 2; write ZZ/{shorten(-number, 20)}"
        )
    return shared(Residues, number)


ZZ = Integers()
QQ = Rationals()
