"""The rings of integers over which orders are defined, ℤ and ℤ_K, with one interface.

Computations use elements of ``field``; results for the user are elements of ``ring``. Ideals of ℤ are
positive rational numbers. Only this module and ``kernels`` distinguish the two kinds of base.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import lru_cache
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat, fmpz_poly, nmod_poly

from hfield.core.factorisation import factorise, remove
from hfield.core.primality import WORD
from hfield.core.product import Constants
from hfield.errors import LatticeError, RingError, TooLargeError, shorten
from hfield.fields.number_fields import ideals
from hfield.fields.number_fields.classes.class_groups import class_group
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.prime_ideals import PrimeIdeal
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates, finite_ramified
from hfield.fields.rationals.places import INFINITE
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.orders import validation
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.rings.base import Ring
from hfield.rings.integers import QQ
from hfield.rings.whole_numbers import fraction
from hfield.structure.forms import discriminant, normal_form

if TYPE_CHECKING:
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice_values import LatticeValue

Quadruple = tuple[Any, Any, Any, Any]


class QuaternionBasis(NamedTuple):
    """Constants of ``I² = a + t·I, J² = b`` in the field of the base, and coordinates over 1, I, J, IJ.

    ``into`` takes the coordinates of an element over 1, i, j, k to these, ``back`` the other way.
    """

    constants: Constants
    into: Callable[[Sequence[Any]], Quadruple]
    back: Callable[[Sequence[Any]], Quadruple]


class Base(Protocol):
    """A ring of integers, free of rank ``degree`` over ℤ with the basis ``integral_basis``, 1 first."""

    ring: Any
    field: Any
    degree: int
    integral_basis: tuple[Any, ...]
    is_rational: bool
    """Whether the base is ℤ."""
    symbol: str
    """How the ring is written."""

    def coordinate_rows(self, elements: Sequence[Any]) -> fmpq_mat:
        """Return the coordinates of elements in the integral basis, row by row."""

    def element_of(self, row: Sequence[fmpq]) -> Any:
        """Return the element with these coordinates."""

    def quaternion_basis(self, algebra: Any) -> QuaternionBasis:
        """Return the basis in which lattices of an algebra are kept."""

    is_totally_real: bool

    @property
    def one(self) -> Any:
        """The ideal of all integers."""

    def prime(self, x: object) -> Any:
        """Return what a user gives as a prime. Raises :class:`LatticeError` for what is none."""

    def primes_above(self, p: int) -> list[tuple[Any, Any]]:
        """Return the primes above a prime number: as the ring has them, and as :meth:`prime` returns them."""

    def prime_ideal(self, prime: Any) -> Any:
        """Return a prime as an ideal."""

    @property
    def mass_factor(self) -> Fraction:
        """2^(1−n)·|ζ(−1)|·h for a totally real field, h its class number: the mass of discriminant 1."""

    def absolute_norm(self, ideal: Any) -> int:
        """Return how many residues there are modulo an integral ideal."""

    def valuation(self, ideal: Any, prime: Any) -> int:
        """Return the exponent of a prime in an ideal."""

    def factorisation(self, ideal: Any) -> list[tuple[Any, int]]:
        """Return the primes of an ideal with their exponents, ascending. Raises :class:`UnfactoredError`."""

    def residues(self, prime: Any) -> list[Any]:
        """Return integers of the field, one of each class modulo a prime, 0 first."""

    def lift(self, prime: Any, residue: nmod_poly) -> Any:
        """Return an integer of the field with a given residue modulo a prime."""

    def integer_near(self, x: Any, modulus: int) -> Any:
        """Return an integer of the field that is x modulo a power of p, where x is integral at p."""

    def integral_ideal(self, x: object) -> Any:
        """Return what a user gives as a norm. Raises :class:`LatticeError` for what is no integral ideal."""

    def ideal_text(self, ideal: Any) -> int | str:
        """Return an integral ideal for JSON."""

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> Any:
        """Return the group of ideals modulo generators positive at the real places that ramify."""

    def quadratic_symbol(self, trace: Any, norm: Any, prime: Any) -> int:
        """Return 1, 0 or −1 where x² − trace·x + norm has two roots, one or none modulo a prime."""

    def ramified_primes(self, constants: Constants) -> tuple[Any, ...]:
        """Return the primes at which an algebra ramifies. Raises :class:`UnfactoredError`."""

    def principal(self, x: Any) -> Any:
        """Return the ideal of one element, not 0."""

    def ideal_spanned(self, entries: Sequence[fmpz], den: int) -> Any:
        """Return the ideal that rows of coordinates, one after the other over a denominator, span over ℤ."""

    def ideal_rows(self, ideal: Any) -> tuple[int, list[list[Any]]]:
        """Return the coordinates of a basis of an ideal over ℤ, integers over a denominator."""

    def inverse(self, ideal: Any) -> Any:
        """Return the inverse of an ideal."""

    def ideal(self, x: object) -> Any:
        """Return what a user gives as an ideal, a number or an element, as an ideal."""

    def is_ideal(self, x: object) -> bool:
        """Tell whether lattices are multiplied by x as by an ideal of the base."""

    def is_totally_positive(self, x: Any) -> bool:
        """Tell whether an element is positive at all infinite places."""

    def as_rational(self, x: Any) -> fmpq | None:
        """Return an element of the field as a rational number, None for one that is none."""

    def trace(self, x: Any) -> fmpq:
        """Return the trace of an element down to ℚ."""

    def inside(self, x: Any) -> Any:
        """Convert an element of ``ring`` to one of ``field``."""

    def outside(self, x: Any) -> Any:
        """Convert an element of ``field`` to one of ``ring``."""

    def shown_norm(self, lattice: LatticeValue) -> Any:
        """Return the norm of a lattice as a user sees it."""

    def shown_index(self, ideal: Any) -> Any:
        """Return an ideal as an index that a user sees."""


class RationalIntegers:
    """The integers ℤ; the coordinates of quaternions are those over (1, i, j, k)."""

    ring = field = QQ
    degree = 1
    integral_basis: tuple[Any, ...] = (fmpq(1),)
    symbol = "ℤ"
    is_rational = True
    is_totally_real = True
    one = 1

    def prime(self, x: object) -> int:
        return validation.prime(x)

    def primes_above(self, p: int) -> list[tuple[Any, Any]]:
        return [(p, p)]

    def prime_ideal(self, prime: int) -> int:
        return prime

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

    def lift(self, prime: int, residue: nmod_poly) -> fmpq:
        return fmpq(int(residue[0]))

    def integer_near(self, x: fmpq, modulus: int) -> fmpq:
        return fmpq(int(x.p) * pow(int(x.q), -1, modulus) % modulus)

    def integral_ideal(self, x: object) -> int:
        return validation.positive(x, "norm")

    def ideal_text(self, ideal: Fraction | int) -> int:
        return int(ideal)

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> OneClass:
        return OneClass()

    def quadratic_symbol(self, trace: fmpq, norm: fmpq, prime: int) -> int:
        return kronecker(int(trace.p) ** 2 - 4 * int(norm.p), prime)  # both are integers

    def ramified_primes(self, constants: Constants) -> tuple[int, ...]:
        a, t, b = map(fraction, constants)
        return tuple(int(p) for p in ramified_places_q(a + t * t / 4, b) if p != INFINITE)

    def coordinate_rows(self, elements: Sequence[Any]) -> fmpq_mat:
        return fmpq_mat(len(elements), 1, list(elements))

    def element_of(self, row: Sequence[fmpq]) -> fmpq:
        return row[0]

    def quaternion_basis(self, algebra: Any) -> QuaternionBasis:
        if not discriminant(algebra.ring, algebra.constants):
            raise degenerate(algebra)
        return QuaternionBasis(
            Constants(*map(self.inside, algebra.constants)), _as_it_is, _as_it_is
        )

    def principal(self, x: Any) -> Fraction:
        return abs(fraction(x))

    def ideal_spanned(self, entries: Sequence[fmpz], den: int) -> Fraction:
        return Fraction(int(fmpz_poly(list(entries)).content()), den)

    def ideal_rows(self, ideal: Fraction | int) -> tuple[int, list[list[int]]]:
        return ideal.denominator, [[ideal.numerator]]

    def inverse(self, ideal: Fraction | int) -> Fraction:
        return 1 / Fraction(ideal)

    def ideal(self, x: object) -> Fraction:
        value = abs(fraction(x))
        if not value:
            raise LatticeError("a lattice cannot be divided by 0")
        return value

    def is_ideal(self, x: object) -> bool:
        return False

    def is_totally_positive(self, x: Any) -> bool:
        return bool(x > 0)

    def as_rational(self, x: Any) -> fmpq | None:
        return self.inside(x)

    def trace(self, x: Any) -> fmpq:
        return self.inside(x)

    def inside(self, x: Any) -> fmpq:
        if isinstance(x, fmpq):
            return x
        value = fraction(x)
        return fmpq(value.numerator, value.denominator)

    def outside(self, x: Any) -> Any:
        return x

    def shown_norm(self, lattice: LatticeValue) -> fmpq:
        # as norm, which is a Fraction, and slower to make
        return fmpq(lattice.content, lattice.ambient.scale * lattice.den**2)

    def shown_index(self, ideal: Fraction) -> int | Fraction:
        return ideal.numerator if ideal.denominator == 1 else ideal


class OneClass:
    """The ideals of ℤ modulo those with positive generators, all of them."""

    order = 1
    invariants: tuple[int, ...] = ()

    def class_of(self, ideal: object) -> tuple[int, ...]:
        """Return the one class."""
        return ()


def degenerate(algebra: Any) -> RingError:
    """Return the error for a degenerate algebra."""
    return RingError(
        f"{shorten(algebra)} is a degenerate algebra, (t² + 4a)·b = 0: it is not simple, and has no orders "
        "here"
    )


def _as_it_is(coordinates: Sequence[Any]) -> Quadruple:
    w, x, y, z = coordinates
    return w, x, y, z


class NumberFieldIntegers:
    """The integers ℤ_K of a number field K; I and J anticommute and have integral squares."""

    def __init__(self, ring: NumberField) -> None:
        self.ring, self.integers = ring, ideals.integers(ring)
        self.field = ring
        self.degree = ring.degree
        self.integral_basis: tuple[Any, ...] = self.field.integral_basis()
        self.is_totally_real = self.field.signature == (self.degree, 0)

    symbol = "ℤ_K"
    is_rational = False

    def inside(self, x: object) -> Any:
        return self.field(x)

    def outside(self, x: Any) -> Any:
        return x

    def primes_above(self, p: int) -> list[tuple[Any, PrimeIdeal]]:
        return [(P, P) for P in self.field.primes_above(p)]

    def prime_ideal(self, prime: PrimeIdeal) -> ideals.Ideal:
        return self.integers.prime(prime)

    @property
    def mass_factor(self) -> Fraction:
        classes = self.ring.class_group().order
        return Fraction(abs(self.ring.zeta_minus_one()) * classes, 2 ** (self.degree - 1))

    def absolute_norm(self, ideal: ideals.Ideal) -> int:
        return int(ideal.norm())

    def valuation(self, ideal: ideals.Ideal, prime: PrimeIdeal) -> int:
        return ideal.valuation(prime)

    def factorisation(self, ideal: ideals.Ideal) -> list[tuple[PrimeIdeal, int]]:
        return [(self.prime(P), e) for P, e in ideal.factorisation()]

    def residues(self, prime: PrimeIdeal) -> list[Any]:
        digits = product(range(prime.p), repeat=prime.f)
        return [self.lift(prime, nmod_poly(list(c), prime.p)) for c in digits]

    def lift(self, prime: PrimeIdeal, residue: nmod_poly) -> Any:
        return self.integer_near(prime.lift(residue), prime.p)

    def integer_near(self, x: Any, modulus: int) -> Any:
        (row,) = self.coordinate_rows([x]).tolist()
        digits = [int(c.p) * pow(int(c.q), -1, modulus) % modulus for c in row]
        return self.element_of([fmpq(c) for c in digits])

    def integral_ideal(self, x: object) -> ideals.Ideal:
        found = self.ideal(x)
        if not found.is_integral():
            raise LatticeError(f"expected an ideal of integers as the norm, not {found}")
        return found

    def ideal_text(self, ideal: ideals.Ideal) -> str:
        return str(ideal)

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> Any:
        signs = (v.index for v in self.field.real_places() if v not in ambient.split_places)
        return class_group(self.ring, tuple(signs))

    def quadratic_symbol(self, trace: Any, norm: Any, prime: PrimeIdeal) -> int:
        expect_small(prime)
        place, t, n = local_place(prime), prime.residue_of(trace), prime.residue_of(norm)
        if (t if place.even else (t * t - n * 4) % place.modulus) == 0:
            return 0
        return -1 if place.quadratic_root(place.one, place.zero - t, n) is None else 1

    def ramified_primes(self, constants: Constants) -> tuple[PrimeIdeal, ...]:
        a, _, b = constants
        some = {2} | candidates(self.field, a) | candidates(self.field, b)
        return tuple(finite_ramified(a, b, some))

    def prime(self, x: object) -> PrimeIdeal:
        """Return a prime ideal of the field, given as an ideal, or as a prime number that is inert.

        Raises :class:`LatticeError` for what is none.
        """
        place = x
        if not isinstance(x, PrimeIdeal):
            factors = self.ideal(x).factorisation()
            if len(factors) == 1 and factors[0][1] == 1:
                place = factors[0][0]
        with suppress(RingError):
            return self.integers.prime_ideal(place)
        raise LatticeError(
            f"{shorten(x)} is no prime ideal of {shorten(self.ring.name)}; see primes_above(p) of the field"
        )

    def coordinate_rows(self, elements: Sequence[Any]) -> fmpq_mat:
        return coordinate_rows(self.field, elements)

    def element_of(self, row: Sequence[fmpq]) -> Any:
        return element_of(self.field, list(row))

    def quaternion_basis(self, algebra: Any) -> QuaternionBasis:
        if not algebra.is_central_simple():
            raise degenerate(algebra)
        form = normal_form(self.field, Constants(*map(self.inside, algebra.constants)))
        # I and J are multiples by integers r, s that make their squares integral
        r, s = (int(coordinate_rows(self.field, [x]).numer_denom()[1]) for x in form.constants)
        a, b = form.constants
        p, q, pq = fmpq(1, r), fmpq(1, s), fmpq(1, r * s)

        def into(coordinates: Sequence[Any]) -> Quadruple:
            c0, c1, c2, c3 = coordinates
            w, x, y, z = form.forth((c0, c1, c2, c3))
            return w, x * p, y * q, z * pq

        def back(coordinates: Sequence[Any]) -> Quadruple:
            w, x, y, z = coordinates
            return form.back((w, x * r, y * s, z * (r * s)))

        return QuaternionBasis(Constants(a * (r * r), self.field.zero, b * (s * s)), into, back)

    @property
    def one(self) -> ideals.Ideal:
        return self.integers.one

    def principal(self, x: Any) -> ideals.Ideal:
        return self.integers.principal(x)

    def ideal_spanned(self, entries: Sequence[fmpz], den: int) -> ideals.Ideal:
        n = self.degree
        rows = fmpz_mat(len(entries) // n, n, list(entries))
        return self.integers.ideal(fmpq_mat(rows) * fmpq(1, den))

    def ideal_rows(self, ideal: ideals.Ideal) -> tuple[int, list[list[Any]]]:
        return ideal.denominator, ideal.matrix.tolist()

    def inverse(self, ideal: ideals.Ideal) -> ideals.Ideal:
        return ideal.inverse()

    def ideal(self, x: object) -> ideals.Ideal:
        return ideals.ideal(self.ring, x)

    def is_ideal(self, x: object) -> bool:
        return isinstance(x, ideals.Ideal)

    def is_totally_positive(self, x: Any) -> bool:
        signs = self.field.multiplication(x).charpoly().coeffs()
        return all(c * (-1) ** (len(signs) - 1 - k) > 0 for k, c in enumerate(signs))

    def as_rational(self, x: Any) -> fmpq | None:
        return x.poly[0] if x.poly.degree() < 1 else None

    def trace(self, x: Any) -> fmpq:
        return self.field(x).trace()

    def shown_norm(self, lattice: LatticeValue) -> ideals.Ideal:
        found: ideals.Ideal = lattice.norm
        return found

    def shown_index(self, ideal: ideals.Ideal) -> ideals.Ideal:
        return ideal


def expect_small(prime: PrimeIdeal) -> None:
    """Raise :class:`TooLargeError` for a prime ideal whose residues exceed a machine's word."""
    if prime.p >= WORD:
        raise TooLargeError(
            f"orders are not computed at {shorten(prime)}, whose residues exceed a machine's word"
        )


INTEGERS = RationalIntegers()


@lru_cache(maxsize=64)
def base_of(ring: Ring) -> Base:
    """Return the integers of a field. Raises :class:`RingError` for a field over which no orders are."""
    if ring == QQ:
        return INTEGERS
    if isinstance(ring, NumberField):
        return NumberFieldIntegers(ring)
    raise RingError(
        f"lattices, orders and ideals are not defined over {shorten(ring.name)}: expected an algebra over "
        "QQ or another number field"
    )
