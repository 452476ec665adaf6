"""The rings of integers over which orders are defined, ℤ, ℤ_K and 𝔽_q[t], with one interface.

Computations use elements of ``field``; results for the user are elements of ``ring``. Ideals of ℤ are
positive rational numbers. Lattices are matrices over the ``domain`` of the base, ℤ or 𝔽_q[t]. The kinds of
base are distinguished only here, in ``polynomial_base`` and in ``kernels``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import partial
from heapq import heappop, heappush
from itertools import count as counter
from itertools import product
from typing import TYPE_CHECKING, Generic, NamedTuple, Protocol, TypeAlias, TypeGuard, TypeVar

from flint import arb, ctx, fmpq, fmpq_mat, fmpz, fmpz_mat, fmpz_poly, nmod_poly

from hfield.core.factorisation import factorise, remove
from hfield.core.primality import primes
from hfield.core.product import Constants, Coordinates
from hfield.errors import LatticeError, RingError, TooLargeError, shorten
from hfield.fields.base.finite_places import Residue, ResiduePlace
from hfield.fields.base.residue_polynomials import coefficients, residues
from hfield.fields.number_fields import ideals
from hfield.fields.number_fields.classes.class_groups import ClassGroup, class_group
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.residues import LocalPlace, local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates, finite_ramified, square_class
from hfield.fields.quadratic_forms.normal_forms import discriminant, normal_form
from hfield.fields.rationals.places import INFINITE
from hfield.fields.rationals.rational_numbers import RationalNumber, rational_number
from hfield.fields.rationals.residues import PrimePlace
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.rationals.whole_numbers import fraction, square_root, squarefree
from hfield.orders import positive_generators, validation
from hfield.orders.base_values import (
    BaseIdeal,
    BaseNumber,
    IdealClassGroup,
    IdealT,
    Integer,
    NarrowRepresentatives,
    NumberT,
    Prime,
    ShownIdeal,
    ThetaSeries,
    TrivialClassGroup,
)
from hfield.orders.domains import INTEGERS, EuclideanDomain
from hfield.orders.linear_algebra_mod_p import kronecker, rational_residue

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Parent
    from hfield.fields.base.flint_types import Polynomial, Rational
    from hfield.fields.base.ring import Ring
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice_values import LatticeValue

PrimeT = TypeVar("PrimeT", bound=Prime)
ResidueT = TypeVar("ResidueT", bound=Residue)


SPLIT = "is indefinite, split at a real place"
NOT_TOTALLY_REAL = "is indefinite, as its field is not totally real"
TOTALLY_DEFINITE = "a totally definite algebra, a < 0 and b < 0 where t = 0"


class QuaternionBasis(NamedTuple, Generic[NumberT]):
    """Constants of ``I² = a + t·I, J² = b`` in the field of the base, and coordinates over 1, I, J, IJ.

    ``into`` converts coordinates over 1, i, j, k to coordinates over 1, I, J, IJ; ``back`` is the inverse.
    """

    constants: Constants[NumberT]
    into: Callable[[Sequence[NumberT]], Coordinates[NumberT]]
    back: Callable[[Sequence[NumberT]], Coordinates[NumberT]]


class Counts(NamedTuple):
    """Numbers of elements by norm; norms are coordinates over a denominator."""

    numbers: dict[tuple[Integer, ...], int]
    den: Integer


class TypedBase(Protocol[NumberT, IdealT, PrimeT, ResidueT]):
    """A ring of integers, free of rank ``degree`` over its domain with the basis ``integral_basis``.

    The type parameters are its numbers, ideals, primes and residues.
    """

    @property
    def ring(self) -> Ring:
        """The field of the elements that users see."""

    @property
    def field(self) -> Ring[NumberT]:
        """The field of the elements used in computations."""

    degree: int

    @property
    def integral_basis(self) -> tuple[NumberT, ...]:
        """A basis of the integers over the domain, beginning with 1."""

    is_rational: bool
    """Whether the base is ℤ."""
    is_polynomial: bool
    """Whether the base is 𝔽_q[t]."""
    lists_all_units: bool
    """Whether units of orders are listed, as over ℤ, and not their cosets of those of the base."""
    symbol: str
    """How the ring is written."""
    vocabulary: str
    """How certificates write statements: in words for ``"integers"``, a ``"field"`` or ``"polynomials"``."""

    @property
    def domain(self) -> EuclideanDomain:
        """The domain over which lattices are matrices: ℤ, or polynomials."""

    def coordinate_rows(self, elements: Sequence[NumberT]) -> fmpq_mat:
        """Return the coordinates of elements in the integral basis, row by row."""

    def element_of(self, row: Sequence[fmpq]) -> NumberT:
        """Return the element with these coordinates."""

    def quaternion_basis(self, algebra: Parent) -> QuaternionBasis[NumberT]:
        """Return the basis in which lattices of an algebra are stored."""

    def is_definite(self, constants: Constants[NumberT]) -> bool:
        """Return whether an algebra ramifies at all infinite places."""

    is_totally_real: bool

    why_indefinite: str
    """What errors say of an algebra over this base that is not definite."""
    definite_algebra: str
    """What errors expect in its place."""
    real_places: tuple[int, ...]
    """The numbers of the real places."""

    @property
    def one(self) -> IdealT:
        """The unit ideal."""

    def prime(self, x: object) -> PrimeT:
        """Return a prime from user input. Raises :class:`LatticeError` for anything else."""

    def primes_above(self, p: int) -> list[tuple[Prime, PrimeT]]:
        """Return the primes above a prime number, each as an object of the ring and as :meth:`prime` returns
        it.
        """

    def primes_by_norm(self) -> Iterator[PrimeT]:
        """Yield all primes in order of norm."""

    def prime_ideal(self, prime: PrimeT) -> IdealT:
        """Return a prime as an ideal."""

    @property
    def zeta_minus_one(self) -> Fraction:
        """The value ζ(−1) of the zeta function of a totally real field."""

    @property
    def mass_factor(self) -> Fraction:
        """2^(1−n)·|ζ(−1)|·h for a totally real field, h its class number: the mass of discriminant 1."""

    @property
    def number_of_units(self) -> int | None:
        """The number of units; None if it is infinite."""

    def norm_bound(self, lattice: LatticeValue, n: object) -> int:
        """Return a user's bound for norms as a bound for their values divided by the content."""

    def absolute_norm(self, ideal: IdealT) -> int:
        """Return the number of residues modulo an integral ideal."""

    def valuation(self, ideal: IdealT, prime: PrimeT) -> int:
        """Return the exponent of a prime in an ideal."""

    def factorisation(self, ideal: IdealT) -> list[tuple[PrimeT, int]]:
        """Return the primes of an ideal with their exponents, ascending. Raises :class:`UnfactoredError`."""

    def residues(self, prime: PrimeT) -> list[NumberT]:
        """Return integers of the field, one for each residue class modulo a prime, 0 first."""

    def place(self, prime: PrimeT) -> ResiduePlace:
        """Return the residue field of a prime, with the arithmetic in it."""

    def digits(self, prime: PrimeT, residue: ResidueT) -> list[int]:
        """Return the coordinates of a residue over the prime field."""

    def residue(self, prime: PrimeT, digits: Sequence[int]) -> ResidueT:
        """Return the residue with given coordinates."""

    def lift(self, prime: PrimeT, residue: ResidueT) -> NumberT:
        """Return an integer of the field with a given residue modulo a prime."""

    def root_modulo_4(self, d: NumberT) -> NumberT | None:
        """Return t with t² ≡ d modulo 4 (over ℤ, d itself), or None if there is none."""

    def integer_near(self, x: NumberT, modulus: int) -> NumberT:
        """Return an integer of the field congruent to x modulo a power of p; x must be integral at p."""

    def integral_ideal(self, x: object, what: str = "norm") -> IdealT:
        """Return an integral ideal from user input for a norm or a level, which may be a text.

        Raises :class:`LatticeError` for anything but an integral ideal.
        """

    def number_data(self, x: Integer) -> int | str:
        """Return a number of the domain for JSON."""

    def ideal_text(self, ideal: IdealT) -> int | str:
        """Return an integral ideal for JSON."""

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> IdealClassGroup[IdealT]:
        """Return the class group of ideals modulo elements that are positive at the ramified real places."""

    def generators(self, ideal: IdealT, places: tuple[int, ...]) -> list[NumberT]:
        """Return the generators of an ideal, in the field, that are positive at some real places.

        The result has one generator for each coset of the squares of units; it is empty if there are none.
        """

    @property
    def positive_units(self) -> tuple[NumberT, ...]:
        """The totally positive units, one for each coset of the squares of units, 1 first.

        The index of a unit is a bit set: each bit stands for a generator.
        """

    def is_integral(self, ideal: IdealT) -> bool:
        """Return whether all elements of an ideal are integers."""

    def are_coprime(self, first: IdealT, second: IdealT) -> bool:
        """Return whether the sum of two integral ideals is the unit ideal."""

    @property
    def narrow_classes(self) -> NarrowRepresentatives[NumberT, IdealT]:
        """The narrow ideal class group: ideals modulo totally positive elements."""

    @property
    def class_generators(self) -> tuple[IdealT, ...]:
        """Ideals that generate the class group; none if all ideals are principal."""

    def square_classes(self, prime: PrimeT) -> tuple[int, Callable[[NumberT], int]]:
        """Return the number of bits of a class of local units modulo squares, and the function to classes.

        The function returns the class of the unit part of a number, for a fixed uniformiser.
        """

    def principal_multiple(self, ideal: IdealT) -> IdealT:
        """Return an ideal if it is principal, else its least multiple that an integer generates."""

    def quadratic_symbol(self, trace: NumberT, norm: NumberT, prime: PrimeT) -> int:
        """Return 1, 0 or −1 if x² − trace·x + norm has two roots, one or none modulo a prime."""

    def ramified_primes(self, constants: Constants[NumberT]) -> tuple[PrimeT, ...]:
        """Return the primes at which an algebra ramifies. Raises :class:`UnfactoredError`."""

    def principal(self, x: NumberT) -> IdealT:
        """Return the ideal generated by a nonzero element."""

    def ideal_spanned(self, entries: Sequence[Integer], den: Integer) -> IdealT:
        """Return the ideal spanned over ℤ by rows of coordinates, listed one after another over a
        denominator.
        """

    def ideal_rows(self, ideal: IdealT) -> tuple[Integer, list[list[Integer]]]:
        """Return the coordinates of a ℤ-basis of an ideal, as integers over a denominator."""

    def inverse(self, ideal: IdealT) -> IdealT:
        """Return the inverse of an ideal."""

    def ideal(self, x: object) -> IdealT:
        """Return an ideal from user input: an ideal, a number or an element."""

    def is_ideal(self, x: object) -> TypeGuard[IdealT]:
        """Return whether x acts on lattices like an ideal of the base."""

    def is_totally_positive(self, x: NumberT) -> bool:
        """Return whether an element is positive at all infinite places."""

    def sign(self, x: NumberT, place: int) -> int:
        """Return the sign of an element at a real place: −1, 0 or 1."""

    def real(self, x: NumberT, place: int) -> float:
        """Return an approximation to the value of an element at a real place."""

    def ball(self, x: NumberT, place: int) -> arb:
        """Return a ball around the value, with flint's current precision."""

    def square_root(self, x: NumberT) -> BaseNumber | None:
        """Return a square root of an element, as an element of ``ring``, or None."""

    def square_factor(self, x: NumberT) -> NumberT:
        """Return s such that x/s² is simple: over ℤ squarefree, over other bases s = 1."""

    def embeddings_modulo(self, p: int) -> list[list[int]]:
        """Return the images of the integral basis under the embeddings of the field in 𝔽_p, for a large p."""

    def splits_completely(self, p: int) -> bool:
        """Return whether a large prime number splits completely in the field."""

    def short_elements(self, ideal: IdealT, count: int) -> Iterable[NumberT]:
        """Return up to a number of short elements of an ideal; over ℤ its generator."""

    def ideal_classes(self, most: int) -> list[IdealT]:
        """Return one ideal of each class, the unit ideal first. Raises :class:`TooLargeError` for more than
        ``most``.
        """

    def as_rational(self, x: NumberT) -> fmpq | None:
        """Return an element of the field as a rational number, or None if it is not rational."""

    def trace(self, x: NumberT) -> fmpq:
        """Return the trace of an element down to ℚ."""

    def norm(self, x: NumberT) -> fmpq:
        """Return the norm of an element down to ℚ."""

    def inside(self, x: object) -> NumberT:
        """Convert an element of ``ring`` to one of ``field``."""

    def outside(self, x: NumberT) -> BaseNumber:
        """Convert an element of ``field`` to one of ``ring``."""

    def shown_number(self, x: Integer) -> int | RationalFunction:
        """Return a number of the domain as shown to users."""

    def shown_norm(self, lattice: LatticeValue) -> ShownIdeal:
        """Return the norm of a lattice as shown to users."""

    def shown_index(self, ideal: IdealT) -> ShownIdeal:
        """Return an ideal as an index shown to users."""

    def theta_step(self, lattice: LatticeValue) -> Fraction:
        """Return the step of the exponents of a theta series: the norm over ℤ, 1 over other bases."""

    def shown_counts(self, counts: Counts, step: Fraction, bound: int) -> ThetaSeries:
        """Return numbers of elements by norm as shown to users.

        Over ℤ it is a list, for the multiples of a step up to a bound; over other bases it is a dict.
        """


Base: TypeAlias = TypedBase[BaseNumber, BaseIdeal, Prime, Residue]
"""A base of any kind. Its numbers, ideals, primes and residues mix with those of the same base alone."""


class RationalIntegers:
    """The ring ℤ; quaternions have coordinates over (1, i, j, k)."""

    ring = field = QQ
    degree = 1
    integral_basis: tuple[fmpq, ...] = (fmpq(1),)
    symbol = "ℤ"
    vocabulary = "integers"
    domain = INTEGERS
    is_rational = True
    lists_all_units = True
    is_polynomial = False
    is_totally_real = True
    why_indefinite = SPLIT
    definite_algebra = TOTALLY_DEFINITE
    real_places: tuple[int, ...] = (0,)
    one = 1

    def prime(self, x: object) -> int:
        return validation.prime(x)

    def primes_above(self, p: int) -> list[tuple[Prime, int]]:
        return [(p, p)]

    def primes_by_norm(self) -> Iterator[int]:
        return primes()

    def prime_ideal(self, prime: int) -> int:
        return prime

    number_of_units = 2

    def norm_bound(self, lattice: LatticeValue, n: object) -> int:
        return _norm_bound(lattice, n)

    zeta_minus_one = Fraction(-1, 12)
    mass_factor = Fraction(1, 12)

    def absolute_norm(self, ideal: Fraction | int) -> int:
        return int(ideal)

    def valuation(self, ideal: Fraction | int, prime: int) -> int:
        return remove(ideal.numerator, prime)[0] - remove(ideal.denominator, prime)[0]

    def factorisation(self, ideal: Fraction | int) -> list[tuple[int, int]]:
        found = dict(factorise(ideal.numerator))
        for p, e in factorise(ideal.denominator).items() if ideal.denominator > 1 else ():
            found[p] = found.get(p, 0) - e
        return sorted(found.items())

    def residues(self, prime: int) -> list[fmpq]:
        return list(map(fmpq, range(prime)))

    def place(self, prime: int) -> PrimePlace:
        return PrimePlace(prime, fmpq)

    def digits(self, prime: int, residue: int) -> list[int]:
        return [residue]

    def residue(self, prime: int, digits: Sequence[int]) -> int:
        return digits[0]

    def lift(self, prime: int, residue: int) -> fmpq:
        return fmpq(residue)

    def root_modulo_4(self, d: fmpq) -> fmpq | None:
        return d if d.q == 1 and int(d.p) % 4 in (0, 1) else None

    def integer_near(self, x: fmpq, modulus: int) -> fmpq:
        return fmpq(rational_residue(x, modulus))

    def integral_ideal(self, x: object, what: str = "norm") -> int:
        if isinstance(x, str) and x.isascii() and x.isdecimal():
            x = int(x)
        return validation.positive(x, what)

    def ideal_text(self, ideal: Fraction | int) -> int:
        return int(ideal)

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> TrivialClassGroup:
        return TrivialClassGroup()

    def generators(self, ideal: Fraction | int, places: tuple[int, ...]) -> list[fmpq]:
        x = self.inside(ideal)
        return [x] if places else [x, -x]

    positive_units: tuple[fmpq, ...] = (fmpq(1),)

    def is_integral(self, ideal: Fraction | int) -> bool:
        return ideal.denominator == 1

    def are_coprime(self, first: Fraction | int, second: Fraction | int) -> bool:
        return math.gcd(first.numerator, second.numerator) == 1

    @property
    def narrow_classes(self) -> OneNarrowClass:
        return OneNarrowClass()

    class_generators: tuple[Fraction | int, ...] = ()

    def square_classes(self, prime: int) -> tuple[int, Callable[[fmpq], int]]:
        return (2 if prime == 2 else 1), partial(_square_class, prime)

    def principal_multiple(self, ideal: Fraction | int) -> Fraction | int:
        return ideal

    def quadratic_symbol(self, trace: fmpq, norm: fmpq, prime: int) -> int:
        return kronecker(int(trace.p) ** 2 - 4 * int(norm.p), prime)  # both are integers

    def ramified_primes(self, constants: Constants) -> tuple[int, ...]:
        a, t, b = map(fraction, constants)
        return tuple(int(p) for p in ramified_places_q(a + t * t / 4, b) if p != INFINITE)

    def coordinate_rows(self, elements: Sequence[fmpq]) -> fmpq_mat:
        return fmpq_mat(len(elements), 1, list(elements))

    def element_of(self, row: Sequence[fmpq]) -> fmpq:
        return row[0]

    def quaternion_basis(self, algebra: Parent) -> QuaternionBasis[fmpq]:
        if not discriminant(algebra.ring, algebra.constants):
            raise degenerate(algebra)
        return QuaternionBasis(
            Constants(*map(self.inside, algebra.constants)), _as_it_is, _as_it_is
        )

    def principal(self, x: Rational) -> Fraction:
        return abs(fraction(x))

    def ideal_spanned(self, entries: Sequence[fmpz], den: int) -> Fraction:
        return Fraction(int(fmpz_poly(list(entries)).content()), den)

    def ideal_rows(self, ideal: Fraction | int) -> tuple[Integer, list[list[Integer]]]:
        return ideal.denominator, [[ideal.numerator]]

    def inverse(self, ideal: Fraction | int) -> Fraction:
        return Fraction(ideal.denominator, ideal.numerator)

    def ideal(self, x: object) -> Fraction:
        value = abs(fraction(x))
        if not value:
            raise LatticeError("a lattice cannot be divided by 0")
        return value

    def is_ideal(self, x: object) -> TypeGuard[Fraction]:
        return False

    def is_definite(self, constants: Constants) -> bool:
        return is_totally_definite(self, constants)

    def number_data(self, x: Integer) -> int:
        return int(x)

    def shown_number(self, x: int) -> int:
        return x

    def is_totally_positive(self, x: fmpq) -> bool:
        return bool(x > 0)

    def sign(self, x: fmpq, place: int) -> int:
        return int(x > 0) - int(x < 0)

    def real(self, x: fmpq, place: int) -> float:
        return int(x.p) / int(x.q)

    def ball(self, x: fmpq, place: int) -> arb:
        return arb(x)

    def square_root(self, x: fmpq) -> Fraction | None:
        return square_root(fraction(x))

    def square_factor(self, x: fmpq) -> fmpq:
        _, s, _ = squarefree(int(x.p * x.q))
        return fmpq(s, x.q)

    def embeddings_modulo(self, p: int) -> list[list[int]]:
        return [[1]]

    def splits_completely(self, p: int) -> bool:
        return True

    def short_elements(self, ideal: Fraction | int, count: int) -> list[fmpq]:
        return [self.inside(ideal)]

    def ideal_classes(self, most: int) -> list[Fraction | int]:
        return [self.one]

    def as_rational(self, x: Rational) -> fmpq | None:
        return self.inside(x)

    def trace(self, x: Rational) -> fmpq:
        return self.inside(x)

    def norm(self, x: Rational) -> fmpq:
        return self.inside(x)

    def inside(self, x: Rational) -> fmpq:
        if type(x) is fmpq:
            return x
        if isinstance(x, fmpq | int):  # a RationalNumber too, which computes more slowly
            return fmpq(x)
        value = fraction(x)
        return fmpq(value.numerator, value.denominator)

    def outside(self, x: fmpq) -> RationalNumber:
        return rational_number(x)

    def shown_norm(self, lattice: LatticeValue) -> RationalNumber:
        # as norm, which is a Fraction, and slower to make
        return rational_number(lattice.content, lattice.ambient.scale * lattice.den**2)

    def shown_index(self, ideal: Fraction | int) -> int | Fraction:
        return ideal.numerator if ideal.denominator == 1 else ideal

    def theta_step(self, lattice: LatticeValue) -> Fraction:
        return fraction(lattice.norm)

    def shown_counts(self, counts: Counts, step: Fraction, bound: int) -> list[int]:
        unit, found = int(step * counts.den), [0] * (bound + 1)
        for (norm,), count in counts.numbers.items():
            found[norm // unit] = count
        return found


def _square_class(p: int, x: fmpq) -> int:
    """Return the class modulo squares of the unit part of a number at p."""
    n = remove(int(x.p), p)[1] * remove(int(x.q), p)[1]
    return (n % 4 == 3) + 2 * (n % 8 in (3, 5)) if p == 2 else int(kronecker(n, p) < 0)


class OneNarrowClass:
    """The ideals of ℤ modulo positive numbers."""

    order = 1
    group = TrivialClassGroup()
    ideals = (Fraction(1),)

    def split(self, ideal: Fraction | int) -> tuple[int, fmpq]:
        """Return 0, the number of the only class, and the ideal as a number."""
        return 0, fmpq(ideal.numerator, ideal.denominator)


def number_field_integers(base: Base) -> NumberFieldIntegers:
    """Return the base, typed as the integers of a number field.

    Raises :class:`TypeError` for another base.
    """
    if isinstance(base, NumberFieldIntegers):
        return base
    raise TypeError(f"expected the integers of a number field, not {base.symbol}")


def _norm_bound(lattice: LatticeValue, n: object) -> int:
    """Return the largest multiple of the content that is at most n, as a bound of traces of norms."""
    scale = lattice.ambient.scale * lattice.den**2
    return int(fraction(n) * scale // int(lattice.content))


def is_totally_definite(
    base: TypedBase[NumberT, IdealT, PrimeT, ResidueT], constants: Constants[NumberT]
) -> bool:
    """Return whether an algebra over a number field is totally definite."""
    a, t, b = constants
    positive = base.is_totally_positive
    return base.is_totally_real and positive(-a - t * t / 4) and positive(-b)


def degenerate(algebra: Parent) -> RingError:
    """Return the error for a degenerate algebra."""
    return RingError(
        f"{shorten(algebra)} is a degenerate algebra, (t² + 4a)·b = 0: it is not simple, and has no orders "
        "here"
    )


def _as_it_is(coordinates: Sequence[NumberT]) -> Coordinates[NumberT]:
    w, x, y, z = coordinates
    return w, x, y, z


class NumberFieldIntegers:
    """The integers ℤ_K of a number field K; I and J anticommute and have integral squares."""

    def __init__(self, ring: NumberField) -> None:
        self.ring, self.integers = ring, ideals.integers(ring)
        self.field = ring
        self.degree = self.field.degree
        self.integral_basis: tuple[FieldElement, ...] = self.field.integral_basis()
        self.is_totally_real = self.field.signature == (self.degree, 0)
        self.why_indefinite = SPLIT if self.is_totally_real else NOT_TOTALLY_REAL
        self.real_places = tuple(range(self.field.signature[0]))

    symbol = "ℤ_K"
    vocabulary = "field"
    definite_algebra = TOTALLY_DEFINITE
    domain = INTEGERS
    is_rational = False
    lists_all_units = False
    is_polynomial = False

    def inside(self, x: object) -> FieldElement:
        return self.field(x)

    def outside(self, x: FieldElement) -> FieldElement:
        return x

    def primes_above(self, p: int) -> list[tuple[Prime, PrimeIdeal]]:
        return [(P, P) for P in self.field.primes_above(p)]

    def primes_by_norm(self) -> Iterator[PrimeIdeal]:
        number, waiting = counter(), list[tuple[int, int, PrimeIdeal]]()
        for p in primes():
            while waiting and waiting[0][0] < p:
                yield heappop(waiting)[2]
            for prime in self.field.primes_above(p):
                heappush(
                    waiting, (self.absolute_norm(self.prime_ideal(prime)), next(number), prime)
                )

    def prime_ideal(self, prime: PrimeIdeal) -> ideals.FractionalIdeal:
        return self.integers.prime(prime)

    @property
    def zeta_minus_one(self) -> Fraction:
        return Fraction(self.ring.zeta_minus_one())

    @property
    def mass_factor(self) -> Fraction:
        classes = self.ring.class_group().order
        return Fraction(abs(self.zeta_minus_one) * classes, 2 ** (self.degree - 1))

    @property
    def number_of_units(self) -> int | None:
        return None if self.degree > 1 else 2

    def norm_bound(self, lattice: LatticeValue, n: object) -> int:
        return _norm_bound(lattice, n)

    def absolute_norm(self, ideal: ideals.FractionalIdeal) -> int:
        return int(ideal.norm())

    def valuation(self, ideal: ideals.FractionalIdeal, prime: PrimeIdeal) -> int:
        return ideal.valuation(prime)

    def factorisation(self, ideal: ideals.FractionalIdeal) -> list[tuple[PrimeIdeal, int]]:
        return [(self.prime(P), e) for P, e in ideal.factorisation()]

    def residues(self, prime: PrimeIdeal) -> list[FieldElement]:
        digits = product(range(prime.p), repeat=prime.f)
        return [self.lift(prime, self.residue(prime, c)) for c in digits]

    def place(self, prime: PrimeIdeal) -> LocalPlace:
        return local_place(prime)

    def digits(self, prime: PrimeIdeal, residue: Polynomial) -> list[int]:
        found = coefficients(residue)
        return found + [0] * (prime.f - len(found))

    def residue(self, prime: PrimeIdeal, digits: Sequence[int]) -> Polynomial:
        return residues(prime.p, digits)

    def lift(self, prime: PrimeIdeal, residue: Polynomial) -> FieldElement:
        return self.integer_near(prime.lift(residue), prime.p)

    def root_modulo_4(self, d: FieldElement) -> FieldElement | None:
        for digits in product((0, 1), repeat=self.degree):
            t = self.element_of(list(map(fmpq, digits)))
            if self.field.is_integral((t * t - d) * fmpq(1, 4)):
                return t
        return None

    def integer_near(self, x: FieldElement, modulus: int) -> FieldElement:
        (row,) = self.coordinate_rows([x]).tolist()
        digits = [rational_residue(c, modulus) for c in row]
        return self.element_of([fmpq(c) for c in digits])

    def integral_ideal(self, x: object, what: str = "norm") -> ideals.FractionalIdeal:
        found = self.ideal(x)
        if not found.is_integral():
            raise LatticeError(f"expected an ideal of integers as the {what}, not {found}")
        return found

    def ideal_text(self, ideal: ideals.FractionalIdeal) -> str:
        return str(ideal)

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> ClassGroup:
        return class_group(self.ring, ambient.ramified_real_places)

    def generators(
        self, ideal: ideals.FractionalIdeal, places: tuple[int, ...]
    ) -> list[FieldElement]:
        return positive_generators.generators(ideal, places)

    @property
    def positive_units(self) -> tuple[FieldElement, ...]:
        return positive_generators.units_modulo_squares(self.ring)

    def is_integral(self, ideal: ideals.FractionalIdeal) -> bool:
        return ideal.is_integral()

    def are_coprime(self, first: ideals.FractionalIdeal, second: ideals.FractionalIdeal) -> bool:
        return bool(first + second == self.one)

    @property
    def narrow_classes(self) -> positive_generators.NarrowClasses:
        return positive_generators.narrow_classes(self.ring)

    @property
    def class_generators(self) -> tuple[ideals.FractionalIdeal, ...]:
        return tuple(self.ring.class_group().generators)

    def square_classes(self, prime: PrimeIdeal) -> tuple[int, Callable[[FieldElement], int]]:
        size = prime.e * prime.f + 1 if prime.p == 2 else 1
        return size, partial(square_class, prime)

    def principal_multiple(self, ideal: ideals.FractionalIdeal) -> ideals.FractionalIdeal:
        if ideal.is_principal():
            return ideal
        return self.ideal(Fraction(ideal.least_integer, ideal.denominator))

    def quadratic_symbol(self, trace: FieldElement, norm: FieldElement, prime: PrimeIdeal) -> int:
        place, t, n = local_place(prime), prime.residue_of(trace), prime.residue_of(norm)
        if (t if place.even else (t * t - n * 4) % place.modulus) == 0:
            return 0
        return -1 if place.quadratic_root(place.one, place.zero - t, n) is None else 1

    def ramified_primes(self, constants: Constants) -> tuple[PrimeIdeal, ...]:
        a, _, b = constants
        some = {2} | candidates(self.field, a) | candidates(self.field, b)
        return tuple(finite_ramified(a, b, some))

    def prime(self, x: object) -> PrimeIdeal:
        """Return a prime ideal of the field, given as an ideal or as an inert prime number.

        Raises :class:`LatticeError` for anything else.
        """
        place = x
        if not isinstance(x, PrimeIdeal):
            factors = self.ideal(x).factorisation()
            if len(factors) == 1 and factors[0][1] == 1:
                place = factors[0][0]
        with suppress(RingError):
            return self.integers.prime_ideal(place)
        raise LatticeError(
            f"{shorten(x)} is not a prime ideal of {shorten(self.ring.name)}; see primes_above(p) of the "
            "field"
        )

    def coordinate_rows(self, elements: Sequence[FieldElement]) -> fmpq_mat:
        return coordinate_rows(self.field, elements)

    def element_of(self, row: Sequence[fmpq]) -> FieldElement:
        return element_of(self.field, list(row))

    def quaternion_basis(self, algebra: Parent) -> QuaternionBasis[FieldElement]:
        if not algebra.is_central_simple():
            raise degenerate(algebra)
        form = normal_form(self.field, Constants(*map(self.inside, algebra.constants)))
        # I and J are multiples by integers r, s that make their squares integral
        r, s = (int(coordinate_rows(self.field, [x]).numer_denom()[1]) for x in form.constants)
        a, b = form.constants
        p, q, pq = fmpq(1, r), fmpq(1, s), fmpq(1, r * s)

        def into(coordinates: Sequence[FieldElement]) -> Coordinates[FieldElement]:
            c0, c1, c2, c3 = coordinates
            w, x, y, z = form.forth((c0, c1, c2, c3))
            return w, x * p, y * q, z * pq

        def back(coordinates: Sequence[FieldElement]) -> Coordinates[FieldElement]:
            w, x, y, z = coordinates
            return form.back((w, x * r, y * s, z * (r * s)))

        return QuaternionBasis(Constants(a * (r * r), self.field.zero, b * (s * s)), into, back)

    @property
    def one(self) -> ideals.FractionalIdeal:
        return self.integers.one

    def principal(self, x: FieldElement) -> ideals.FractionalIdeal:
        return self.integers.principal(x)

    def ideal_spanned(self, entries: Sequence[fmpz], den: int) -> ideals.FractionalIdeal:
        n = self.degree
        rows = fmpz_mat(len(entries) // n, n, list(entries))
        return self.integers.ideal(fmpq_mat(rows) * fmpq(1, den))

    def ideal_rows(self, ideal: ideals.FractionalIdeal) -> tuple[Integer, list[list[Integer]]]:
        return ideal.denominator, ideal.matrix.tolist()

    def inverse(self, ideal: ideals.FractionalIdeal) -> ideals.FractionalIdeal:
        return ideal.inverse()

    def ideal(self, x: object) -> ideals.FractionalIdeal:
        return ideals.ideal(self.ring, x)

    def is_ideal(self, x: object) -> TypeGuard[ideals.FractionalIdeal]:
        return isinstance(x, ideals.FractionalIdeal)

    def is_definite(self, constants: Constants) -> bool:
        return is_totally_definite(self, constants)

    def number_data(self, x: Integer) -> int:
        return int(x)

    def shown_number(self, x: int) -> int:
        return x

    def is_totally_positive(self, x: FieldElement) -> bool:
        signs = self.field.multiplication(x).charpoly().coeffs()
        return all(c * (-1) ** (len(signs) - 1 - k) > 0 for k, c in enumerate(signs))

    def sign(self, x: FieldElement, place: int) -> int:
        return int(self.field.sign_at(x, place))

    def real(self, x: FieldElement, place: int) -> float:
        return float(self.field.embeddings.close(x.poly, place, 15).real.mid()) if x else 0.0

    def ball(self, x: FieldElement, place: int) -> arb:
        found: arb = self.field.embeddings.value(x.poly, place, ctx.prec).real
        return found

    def square_root(self, x: FieldElement) -> FieldElement | None:
        found = x.sqrt()
        return None if found is None else self.outside(found)

    def square_factor(self, x: FieldElement) -> FieldElement:
        return self.field.one

    def _modulus(self, p: int) -> nmod_poly:
        """Return the polynomial that defines the field, modulo p."""
        return nmod_poly([rational_residue(c, p) for c in self.field.modulus_over_rationals()], p)

    def embeddings_modulo(self, p: int) -> list[list[int]]:
        modulus = self._modulus(p)
        rows = [
            [rational_residue(c, p) for c in self.field.coefficients_of(w)]
            for w in self.integral_basis
        ]
        roots = sorted(int(root) for root, times in modulus.roots() if times == 1)
        return [[int(nmod_poly(row, p)(root)) for row in rows] for root in roots]

    def splits_completely(self, p: int) -> bool:
        modulus, x = self._modulus(p), nmod_poly([0, 1], p)
        return bool(x.pow_mod(p, modulus) == x % modulus)

    def short_elements(self, ideal: ideals.FractionalIdeal, count: int) -> Iterable[FieldElement]:
        return s_units(self.ring).short(ideal, count)

    def ideal_classes(self, most: int) -> list[ideals.FractionalIdeal]:
        group = self.ring.class_group()
        if group.order > most:
            raise TooLargeError(
                f"{shorten(self.ring.name)} has {group.order} classes of ideals, and at most {most} are "
                "looked at here"
            )
        found = [self.one]
        for a, d in zip(group.generators, group.invariants, strict=True):
            found = [a**k * b for k in range(d) for b in found]
        return found

    def as_rational(self, x: FieldElement) -> fmpq | None:
        return x.poly[0] if x.poly.degree() < 1 else None

    def trace(self, x: FieldElement) -> fmpq:
        return x.trace()

    def norm(self, x: FieldElement) -> fmpq:
        return x.norm()

    def shown_norm(self, lattice: LatticeValue) -> ideals.FractionalIdeal:
        return self.ideal(lattice.norm)

    def shown_index(self, ideal: ideals.FractionalIdeal) -> ideals.FractionalIdeal:
        return ideal

    def theta_step(self, lattice: LatticeValue) -> Fraction:
        return Fraction(1)

    def shown_counts(self, counts: Counts, step: Fraction, bound: int) -> dict[BaseNumber, int]:
        norms = {
            self.element_of([fmpq(x, counts.den) for x in values]): count
            for values, count in counts.numbers.items()
        }
        ordered = sorted(norms.items(), key=lambda pair: (self.trace(pair[0]), str(pair[0])))
        return {self.outside(norm): count for norm, count in ordered}


RATIONAL_INTEGERS: TypedBase[fmpq, Fraction | int, int, int] = RationalIntegers()
