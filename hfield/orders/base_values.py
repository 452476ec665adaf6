"""Protocols for the numbers, ideals, primes and residues of a base, for functions that serve every base."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING, Protocol, Self, TypeAlias, TypeVar

from hfield.core import product

if TYPE_CHECKING:
    from fractions import Fraction

    from flint import fmpq, fmpq_mat, fmpz, fmpz_mat, fq_default_poly, nmod_mat

    from hfield.fields.function_fields.ideals import FunctionFieldIdeal
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.number_fields.ideals import FractionalIdeal
    from hfield.orders.polynomial_matrices import FractionMatrix, PolynomialMatrix
    from hfield.orders.residue_matrices import ResidueMatrix

Integer: TypeAlias = "int | fmpz | fq_default_poly"
"""A number of the domain over which lattices are matrices: an integer, or a polynomial over GF(q)."""

Rational: TypeAlias = "fmpq | RationalFunction"
"""A fraction of two numbers of the domain."""

IntegerMatrix: TypeAlias = "fmpz_mat | PolynomialMatrix"
RationalMatrix: TypeAlias = "fmpq_mat | FractionMatrix"
ModularMatrix: TypeAlias = "nmod_mat | ResidueMatrix"
"""A matrix modulo a prime of the domain."""

Prime: TypeAlias = Hashable
"""A prime of a base: over ℤ a number, elsewhere a prime ideal. Only the base looks into it."""

ShownIdeal: TypeAlias = "int | Fraction | FractionalIdeal | FunctionFieldIdeal"
"""An ideal as a user sees it: over ℤ the positive number that generates it."""


class BaseNumber(product.Scalar, Protocol):
    """A number of the field of a base: a rational number of flint, or an element of a number field."""

    def __add__(self, other: Self | int, /) -> Self: ...
    def __sub__(self, other: Self | int, /) -> Self: ...
    def __mul__(self, other: Self | int, /) -> Self: ...
    def __truediv__(self, other: Self | int, /) -> Self: ...
    def __rtruediv__(self, other: int, /) -> Self: ...
    def __pow__(self, exponent: int, /) -> Self: ...
    def __bool__(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...


class BaseIdeal(Protocol):
    """A fractional ideal of a base; over ℤ it is its positive generator, a Fraction."""

    def __mul__(self, other: Self, /) -> Self: ...
    def __truediv__(self, other: Self, /) -> Self: ...
    def __pow__(self, exponent: int, /) -> Self: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...


NumberT = TypeVar("NumberT", bound=BaseNumber)
NumberT_co = TypeVar("NumberT_co", bound=BaseNumber, covariant=True)
IdealT = TypeVar("IdealT")
IdealT_contra = TypeVar("IdealT_contra", contravariant=True)


class IdealClassGroup(Protocol[IdealT_contra]):
    """A group of classes of ideals, a product of cyclic groups."""

    @property
    def order(self) -> int:
        """The number of classes."""

    @property
    def invariants(self) -> Sequence[int]:
        """The orders of the cyclic groups."""

    def class_of(self, ideal: IdealT_contra, /) -> tuple[int, ...]:
        """Return the class of an ideal as coordinates in the cyclic groups."""


class NarrowRepresentatives(Protocol[NumberT_co, IdealT]):
    """Ideals as products ν·a with ν totally positive and a in a list of representatives of narrow classes."""

    @property
    def order(self) -> int:
        """The number of classes."""

    @property
    def group(self) -> IdealClassGroup[IdealT]:
        """The group of the classes."""

    @property
    def ideals(self) -> Sequence[IdealT]:
        """One ideal of each class that has occurred so far."""

    def split(self, ideal: IdealT, /) -> tuple[int, NumberT_co]:
        """Return the index of a in the list, and ν."""


ThetaSeries: TypeAlias = list[int] | dict[BaseNumber, int]
"""How many elements have which norm: over ℤ by multiples of a step, elsewhere by the norms."""


class TrivialClassGroup:
    """The trivial class group of a base in which all ideals are principal in the required sense."""

    order = 1
    invariants: tuple[int, ...] = ()

    def class_of(self, ideal: object) -> tuple[int, ...]:
        """Return the only class."""
        return ()
