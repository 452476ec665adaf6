"""Finite fields: GF(p) on flint's residues, GF(pⁿ) on flint's ``fq_default``."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Hashable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from random import Random
from typing import TYPE_CHECKING

import flint

from hfield.core.product import Constants
from hfield.errors import NotInvertibleError, shorten
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.foreign_values import is_galois
from hfield.fields.base.modular import Modular
from hfield.fields.base.printing import sum_text
from hfield.fields.base.ring import FINITE_LIMIT, Fact, Ring, shared
from hfield.fields.base.roots import of_flint
from hfield.fields.base.storage.base import BatchStorage, Storage
from hfield.fields.finite import tables
from hfield.fields.finite.storage import PolynomialStorage
from hfield.fields.rationals.ring import ZZ

if TYPE_CHECKING:
    import numpy as np
    import sympy

    from hfield.fields.base.flint_types import Coefficient


CONWAY_BELOW = (
    2**32
)  # every pⁿ below, n > 1, has its Conway polynomial in flint's and galois's tables
NAME = "x"


class FiniteField(Ring):
    """The common part of GF(p) and GF(pⁿ): arrays as in galois, through its integer labels."""

    order: int
    degree: int
    is_field = True
    parse_limit = FINITE_LIMIT

    def in_words(self) -> str:
        """Return a description of the field."""
        return f"the finite field of {shorten(self.order)} elements"

    @property
    def data(self) -> dict[str, object]:
        """The characteristic and degree of the field, as JSON data."""
        own = {"characteristic": self.characteristic, "degree": self.degree}
        return {"kind": "finite field", **own, "modulus": None}

    @abstractmethod
    def label(self, x: Coefficient) -> int:
        """Return galois's integer label of x: its coefficients as digits in base p."""

    @abstractmethod
    def from_label(self, n: int) -> Coefficient:
        """Return the element with galois's integer label n."""

    def array(self, values: object) -> np.ndarray:
        """Return a galois array, or an array of flint's elements if the field is too large for galois."""
        from hfield.fields.finite import galois_arrays

        return galois_arrays.array(self, values)

    def array_of_labels(self, row: np.ndarray) -> np.ndarray:
        """Return an array of labels in the same form as ``array`` does, without a copy if the types agree."""
        from hfield.fields.finite import galois_arrays

        return galois_arrays.of_labels(self, row)

    def array_storage(self, constants: Constants) -> BatchStorage:
        """Return the storage of arrays as rows of labels, unless the field is too large."""
        from hfield.fields.base.array_storage.finite import array_storage

        return array_storage(self, constants)

    def scalar(self, x: object) -> Coefficient:
        """Convert an entry of ``array`` back to an element."""
        from hfield.fields.finite import galois_arrays

        return galois_arrays.scalar(self, x)

    def array_units(self, values: np.ndarray) -> np.ndarray:
        """Return a bool array that marks the nonzero entries."""
        from hfield.fields.finite import galois_arrays

        return galois_arrays.units(self, values)

    def array_inverse(self, values: np.ndarray) -> np.ndarray:
        """Invert an array of nonzero entries elementwise."""
        from hfield.fields.finite import galois_arrays

        return galois_arrays.inverse(self, values)


class PrimeField(Modular, FiniteField):
    """GF(p): elements are flint's ``nmod`` or ``fmpz_mod``, arrays galois's."""

    degree = 1

    def __init__(self, p: int) -> None:
        Modular.__init__(self, ZZ, f"GF({p})", p, True)

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.order)

    def __call__(self, x: object) -> flint.nmod | flint.fmpz_mod:
        """Convert an int n to n·1 and a Fraction a/b to a·b⁻¹; read a text or a galois scalar."""
        if is_galois(x):
            from hfield.fields.finite import galois_arrays

            return galois_arrays.from_galois(self, x)
        return super().__call__(x)


class ExtensionField(FiniteField):
    """GF(pⁿ), n > 1, as polynomials in x modulo an irreducible polynomial; elements are ``fq_default``.

    ``modulus`` is the modulus as text, ``gen`` the class of x. A modulus is part of the name unless it is
    flint's default: Conway's polynomial if it is tabulated (every order below 2³² and many above), else a
    sparse irreducible polynomial; ``modulus_origin`` says which.
    """

    gen_name = NAME

    def __init__(self, p: int, n: int, coefficients: Sequence[int] | None = None) -> None:
        self.characteristic, self.degree, self.order = p, n, p**n
        default = flint.fq_default_ctx(p, n, NAME)
        self.context = default
        self.name = f"GF({p**n})"
        if coefficients is not None:
            given = flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(p))(list(coefficients))
            self.context = flint.fq_default_ctx(modulus=given, var=NAME)
        self.coefficients = [int(c) for c in self.context.modulus().coeffs()]
        self.modulus = modulus_text(self.coefficients)
        self.is_default = self.coefficients == [int(c) for c in default.modulus().coeffs()]
        if not self.is_default:
            self.name = f"GF({p**n}, {self.modulus})"
        self._gen = self.context.gen()

    def __reduce__(self) -> tuple[object, ...]:
        modulus = () if self.is_default else (tuple(self.coefficients),)
        return shared, (type(self), self.characteristic, self.degree, *modulus)

    @property
    def data(self) -> dict[str, object]:
        """The field by its modulus, as JSON data; a default modulus that the checker has no table of is
        omitted.
        """
        from hfield.checker.scalars.conway import CONWAY

        known = not self.is_default or self.order in CONWAY
        modulus = self.coefficients if known else None
        return {**super().data, "modulus": modulus}

    @property
    def modulus_origin(self) -> str:
        """The origin of the modulus: ``given``, ``Conway`` or ``sparse``.

        Above 2³² the tables have gaps; then galois, which is imported for this, decides.
        """
        if not self.is_default:
            return "given"
        if self.order < CONWAY_BELOW:
            return "Conway"
        from hfield.fields.finite import galois_arrays

        conway = galois_arrays.conway(self.characteristic, self.degree)
        return "Conway" if conway == self.coefficients else "sparse"

    @property
    def gen(self) -> flint.fq_default:
        """The class of x."""
        return self._gen

    def __call__(self, x: object) -> flint.fq_default:
        """Convert an int n to n·1 and a Fraction a/b to a·b⁻¹; read a text or a galois scalar.

        Raises :class:`CoercionError` for an element of another field or with another modulus.
        """
        if is_galois(x):
            from hfield.fields.finite import galois_arrays

            return galois_arrays.from_galois(self, x)
        x = unwrap(x)
        if isinstance(x, flint.fq_default):
            # Adding is the only way to find the parent of a flint element, which is not public.
            try:
                return x + self.context.zero()
            except ValueError:
                mend = (
                    f"elements of different fields do not mix; the modulus here is {self.modulus}"
                )
                raise self.refuse(x, shorten(mend, 120)) from None
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        if number is None:
            return self.foreign(x)
        if isinstance(number, Fraction):
            return self.ratio(number)
        return self.context(number % self.characteristic)

    def closed_form(self, x: sympy.Expr) -> flint.fq_default:
        """Raise an error for roots and other closed forms: there may be several such elements, or none."""
        raise self.refuse(x, f"expected rational numbers and the generator {NAME}")

    def to_sympy(self, x: flint.fq_default, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the polynomial in x with coefficients from 0 to p − 1."""
        from hfield.fields.base.to_sympy import polynomial_in, symbol

        return polynomial_in(symbol(NAME, symbols), map(int, x.to_list()))

    def is_zero(self, x: flint.fq_default) -> bool:
        """Return whether x is 0."""
        return bool(x.is_zero())

    def equal(self, x: flint.fq_default, y: flint.fq_default) -> bool:
        """Return whether x = y."""
        return bool(x == y)

    def key(self, x: Hashable) -> Hashable:
        """Return x itself: flint's elements are hashable."""
        return x

    def inverse(self, x: flint.fq_default) -> flint.fq_default:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        if x.is_zero():  # flint itself aborts the whole process on inverse() of 0
            raise NotInvertibleError(f"cannot divide by 0 in {shorten(self.name)}")
        return x.inverse()

    def sqrt(self, x: flint.fq_default) -> flint.fq_default | None:
        """Return some y with y² = x, or None; in characteristic 2, y is unique."""
        return x.sqrt() if x.is_zero() or x.is_square() else None

    def roots(self, coefficients: Sequence[flint.fq_default]) -> list[flint.fq_default]:
        """Return the roots of a nonzero polynomial."""
        polynomial = flint.fq_default_poly_ctx(self.context)(list(coefficients))
        return [root for root, _ in polynomial.roots()]

    def irreducible_factors(
        self, coefficients: Sequence[flint.fq_default]
    ) -> list[list[flint.fq_default]]:
        """Return the distinct monic irreducible factors of a nonzero polynomial."""
        return of_flint(self, flint.fq_default_poly_ctx(self.context)(list(coefficients)), self)

    @property
    def level(self) -> Fact:
        """1 if −1 is a square, else 2."""
        return self.level_of(self.minus_one_as_squares())

    def minus_one_as_squares(self) -> tuple[flint.fq_default, ...]:
        """Return one or two elements whose squares add up to −1."""
        for x in self.elements():
            y = self.sqrt(self.context(-1) - x * x)
            if y is not None:
                return (y,) if x.is_zero() else (x, y)
        raise AssertionError("in a finite field −1 is a sum of two squares")

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements: as labels over a small field, as polynomials over a large one."""
        if self.order < tables.BELOW:
            return tables.Labels(self, constants)
        return PolynomialStorage(self, constants)

    @cached_property
    def tables(self) -> tables.ElementTables:
        """Tables of a small field: sums, products and inverses of labels."""
        return tables.tables(self)

    def elements(self) -> Iterator[flint.fq_default]:
        """Yield the pⁿ elements, 0 and 1 first, in the order of galois's labels."""
        return (self.from_label(n) for n in range(self.order))

    def random(self, rng: Random) -> flint.fq_default:
        """Return a random element; the same for the same seed."""
        return self.context([rng.randrange(self.characteristic) for _ in range(self.degree)])

    def power(self, x: flint.fq_default, n: int) -> flint.fq_default:
        """Return xⁿ; for n < 0, x is inverted first. Exponents of any size are fast."""
        return (x if n >= 0 else self.inverse(x)) ** abs(n)

    def text(self, x: flint.fq_default, style: str = "plain") -> str:
        """Write x as a polynomial in x, such as ``2*x+1``."""
        return modulus_text([int(c) for c in x.to_list()], style)

    def label(self, x: flint.fq_default) -> int:
        """Return galois's integer label of x: its coefficients as digits in base p."""
        n = 0
        for c in reversed(x.to_list()):
            n = n * self.characteristic + int(c)
        return n

    def from_label(self, n: int) -> flint.fq_default:
        """Return the element with galois's integer label n."""
        digits = []
        for _ in range(self.degree):
            n, digit = divmod(n, self.characteristic)
            digits.append(digit)
        return self.context(digits)


def modulus_text(coefficients: list[int], style: str = "plain") -> str:
    """Write a polynomial in x, given by its coefficients, low degree first."""
    terms = [(str(c), [(NAME, n)]) for n, c in enumerate(coefficients) if c]
    return sum_text(reversed(terms), style)
