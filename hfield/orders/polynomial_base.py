"""The polynomials 𝔽_q[t] as a base of orders, besides ℤ and ℤ_K.

Lattices are matrices of rank 4 over 𝔽_q[t]. The ideals of 𝔽_q[t] are principal, its units are the constants,
and the one infinite place is that of 1/t. An algebra is called definite if it ramifies at infinity. The
constants modulo squares take the place of the totally positive units modulo squares.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NoReturn, TypeGuard

from hfield.core.product import Constants, Coordinates
from hfield.errors import HFieldError, LatticeError, shorten
from hfield.fields.function_fields.ideals import (
    FunctionFieldIdeal,
    PolynomialResidueField,
    polynomial_integers,
    prime_ideal,
    residue_field,
)
from hfield.fields.function_fields.places import FunctionPlace
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.function_fields.symbols import ramified_places_functions, symbol
from hfield.fields.quadratic_forms.normal_forms import discriminant, normal_form
from hfield.orders.base_values import BaseNumber, Integer, Prime, TrivialClassGroup
from hfield.orders.domains import PolynomialDomain
from hfield.orders.polynomial_matrices import FractionMatrix
from hfield.orders.validation import natural

if TYPE_CHECKING:
    from flint import fq_default_poly

    from hfield.algebra.quaternion import Parent
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.orders.base import Counts, QuaternionBasis
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice_values import LatticeValue


class PolynomialNarrowClass:
    """The trivial group of ideals of 𝔽_q[t] modulo principal ideals."""

    order = 1
    group = TrivialClassGroup()

    def __init__(self, one: FunctionFieldIdeal) -> None:
        self.ideals = (one,)

    def split(self, ideal: FunctionFieldIdeal) -> tuple[int, RationalFunction]:
        """Return 0, the number of the only ideal class, and the generator of the ideal."""
        return 0, ideal.x


class PolynomialBase:
    """The ring 𝔽_q[t]; quaternions have coordinates over 1, I, J, IJ with integral constants."""

    degree = 1
    is_rational = False
    lists_all_units = False
    is_polynomial = True
    vocabulary = "polynomials"
    is_totally_real = False
    why_indefinite = "splits at infinity"
    definite_algebra = "an algebra that ramifies there"
    real_places: tuple[int, ...] = ()
    class_generators: tuple[FunctionFieldIdeal, ...] = ()

    def __init__(self, ring: FunctionField) -> None:
        self.ring, self.integers = ring, polynomial_integers(ring)
        self.field = self.integers.field
        self.order = self.integers.order
        self.domain = PolynomialDomain(self.field)
        self.integral_basis = (self.field.one,)
        self.symbol = self.integers.text
        self.one = self.integers.principal(self.field.one)
        self.narrow_classes = PolynomialNarrowClass(self.one)

    # --- elements ------------------------------------------------------------------------------------

    def inside(self, x: object) -> RationalFunction:
        return self.integers.inside(x)

    def outside(self, x: RationalFunction) -> RationalFunction:
        return self.integers.outside(x)

    def coordinate_rows(self, elements: Sequence[RationalFunction]) -> FractionMatrix:
        return self.domain.fraction_matrix([[x] for x in elements])

    def element_of(self, row: Sequence[RationalFunction]) -> RationalFunction:
        return row[0]

    def as_rational(self, x: RationalFunction) -> RationalFunction:
        return x

    def trace(self, x: RationalFunction) -> RationalFunction:
        return self.domain.as_fraction(x)

    def norm(self, x: RationalFunction) -> RationalFunction:
        return self.domain.as_fraction(x)

    def number_data(self, x: Integer) -> str:
        return self.ring.text(self.shown_number(x))

    def shown_number(self, x: Integer) -> RationalFunction:
        return self.outside(self.domain.as_fraction(x))

    def square_factor(self, x: RationalFunction) -> RationalFunction:
        return self.field.one

    def square_root(self, x: RationalFunction) -> RationalFunction | None:
        found = self.field.sqrt(x)
        return None if found is None else self.outside(found)

    def is_totally_positive(self, x: RationalFunction) -> bool:
        return True

    # --- algebras ------------------------------------------------------------------------------------

    def quaternion_basis(self, algebra: Parent) -> QuaternionBasis[RationalFunction]:
        from hfield.orders.base import QuaternionBasis, degenerate

        constants = Constants(*map(self.inside, algebra.constants))
        if self.field.is_zero(discriminant(self.field, constants)):
            raise degenerate(algebra)
        a, t, b = constants
        # I = r·i and J = s·j have integral traces and norms
        r, s = (
            self.domain.as_fraction(self.domain.lcm(*(x.den for x in some)))
            for some in ((a, t), (b,))
        )

        def into(coordinates: Sequence[RationalFunction]) -> Coordinates[RationalFunction]:
            w, x, y, z = coordinates
            return w, x / r, y / s, z / (r * s)

        def back(coordinates: Sequence[RationalFunction]) -> Coordinates[RationalFunction]:
            w, x, y, z = coordinates
            return w, x * r, y * s, z * (r * s)

        return QuaternionBasis(Constants(a * r * r, t * r, b * s * s), into, back)

    def is_definite(self, constants: Constants) -> bool:
        form = normal_form(self.field, constants)
        return symbol(self.field, form, FunctionPlace(self.field)) < 0

    def ramified_primes(self, constants: Constants) -> tuple[FunctionFieldIdeal, ...]:
        found = ramified_places_functions(self.field, normal_form(self.field, constants))
        return tuple(self._prime(v.poly) for v in found if v.poly is not None)

    # --- ideals and primes ---------------------------------------------------------------------------

    def _prime(self, polynomial: fq_default_poly) -> FunctionFieldIdeal:
        return self.principal(self.domain.as_fraction(polynomial))

    def principal(self, x: RationalFunction | fq_default_poly) -> FunctionFieldIdeal:
        return self.integers.principal(self.domain.as_fraction(x))

    def ideal(self, x: object) -> FunctionFieldIdeal:
        return self.integers.ideal(x)

    def is_ideal(self, x: object) -> TypeGuard[FunctionFieldIdeal]:
        return isinstance(x, FunctionFieldIdeal | FunctionPlace)

    def norm_bound(self, lattice: LatticeValue, n: object) -> int:
        scale = self.domain.integer(lattice.ambient.scale * lattice.den**2)
        shift: int = scale.degree() - lattice.content.degree()
        return natural(n, "norms are listed up to a degree,") + shift

    def integral_ideal(self, x: object, what: str = "norm") -> FunctionFieldIdeal:
        try:
            found = self.ideal(x)
        except HFieldError as error:
            raise LatticeError(
                f"expected an ideal of {self.symbol} as the {what}, such as {self.ring.gen_name}+1, not "
                f"{shorten(x)}: {error}"
            ) from None
        if not found.is_integral():
            raise LatticeError(f"expected an ideal of {self.symbol} as the {what}, not {found}")
        return found

    def ideal_text(self, ideal: FunctionFieldIdeal) -> str:
        return str(ideal)

    def ideal_spanned(self, entries: Sequence[Integer], den: Integer) -> FunctionFieldIdeal:
        domain = self.domain
        return self.principal(domain.fraction(domain.content(entries), den))

    def ideal_rows(self, ideal: FunctionFieldIdeal) -> tuple[Integer, list[list[Integer]]]:
        return ideal.x.den, [[ideal.x.num]]

    def inverse(self, ideal: FunctionFieldIdeal) -> FunctionFieldIdeal:
        return ideal.inverse()

    def is_integral(self, ideal: FunctionFieldIdeal) -> bool:
        return ideal.is_integral()

    def are_coprime(self, first: FunctionFieldIdeal, second: FunctionFieldIdeal) -> bool:
        return bool(first + second == self.one)

    @property
    def number_of_units(self) -> int:
        return self.order - 1

    def absolute_norm(self, ideal: FunctionFieldIdeal) -> int:
        return int(ideal.norm())

    def valuation(self, ideal: FunctionFieldIdeal, prime: FunctionFieldIdeal) -> int:
        return ideal.valuation(prime)

    def factorisation(self, ideal: FunctionFieldIdeal) -> list[tuple[FunctionFieldIdeal, int]]:
        return list(ideal.factorisation())

    def prime(self, x: object) -> FunctionFieldIdeal:
        try:
            return prime_ideal(self.integers, x)
        except HFieldError:
            raise LatticeError(
                f"{shorten(x)} is not a prime of {self.symbol}: expected an irreducible polynomial, such as "
                f"{self.ring.gen_name}"
            ) from None

    def prime_ideal(self, prime: FunctionFieldIdeal) -> FunctionFieldIdeal:
        return prime

    def primes_by_norm(self) -> Iterator[FunctionFieldIdeal]:
        from hfield.fields.function_fields.places import all_places

        return (self._prime(v.poly) for v in all_places(self.field) if v.poly is not None)

    def primes_above(self, p: Integer) -> list[tuple[Prime, FunctionFieldIdeal]]:
        prime = self.prime(self.outside(self.domain.as_fraction(p)))
        return [(prime, prime)]

    def generators(
        self, ideal: FunctionFieldIdeal, places: tuple[int, ...]
    ) -> list[RationalFunction]:
        return [ideal.x * u for u in self.positive_units]

    @property
    def positive_units(self) -> tuple[RationalFunction, ...]:
        k = self.field.base
        one = self.field.one
        if k.characteristic == 2:
            return (one,)
        return one, self.field.constant(next(c for c in k.elements() if k.sqrt(c) is None))

    def classes_modulo_signs(self, ambient: AlgebraBasis) -> TrivialClassGroup:
        return TrivialClassGroup()

    def principal_multiple(self, ideal: FunctionFieldIdeal) -> FunctionFieldIdeal:
        return ideal

    def short_elements(self, ideal: FunctionFieldIdeal, count: int) -> list[RationalFunction]:
        return [ideal.x]

    def ideal_classes(self, most: int) -> list[FunctionFieldIdeal]:
        return [self.one]

    # --- residues ------------------------------------------------------------------------------------

    def place(self, prime: FunctionFieldIdeal) -> PolynomialResidueField:
        return residue_field(prime)

    def residues(self, prime: FunctionFieldIdeal) -> list[RationalFunction]:
        domain = self.domain
        return [domain.as_fraction(x) for x in domain.of_degree_below(prime.degree)]

    def digits(self, prime: FunctionFieldIdeal, residue: fq_default_poly) -> list[fq_default_poly]:
        return [residue]

    def residue(self, prime: FunctionFieldIdeal, digits: Sequence[Integer]) -> fq_default_poly:
        return self.domain.integer(digits[0])

    def lift(self, prime: FunctionFieldIdeal, residue: fq_default_poly) -> RationalFunction:
        return self.domain.as_fraction(residue)

    def integer_near(self, x: RationalFunction, modulus: fq_default_poly) -> RationalFunction:
        inverse = self.domain.inverse_modulo(x.den % modulus, modulus)
        return self.domain.as_fraction(x.num * inverse % modulus)

    def quadratic_symbol(
        self, trace: RationalFunction, norm: RationalFunction, prime: FunctionFieldIdeal
    ) -> int:
        place = self.place(prime)
        t, n = (place.reduce(self.domain.as_fraction(x)) for x in (trace, norm))
        if (t if place.even else (t * t - n * 4) % place.modulus) == 0:
            return 0
        return -1 if place.quadratic_root(place.one, place.zero - t, n) is None else 1

    def square_classes(
        self, prime: FunctionFieldIdeal
    ) -> tuple[int, Callable[[RationalFunction], int]]:
        raise LatticeError(f"stable classes over {self.symbol} are those of Eichler orders, one")

    # --- masses --------------------------------------------------------------------------------------

    @property
    def mass_factor(self) -> Fraction:
        """The value −ζ(−1) = 1/(q² − 1) of the zeta function of 𝔽_q[t]."""
        return Fraction(1, self.order**2 - 1)

    @property
    def zeta_minus_one(self) -> Fraction:
        return -self.mass_factor

    # --- what only number fields have ----------------------------------------------------------------

    def _no_number_field(self, what: str) -> LatticeError:
        return LatticeError(
            f"{what} over ℤ and the integers of number fields, not over {self.symbol}"
        )

    def sign(self, x: RationalFunction, place: int) -> int:
        raise self._no_number_field("there are signs at real places")

    def real(self, x: RationalFunction, place: int) -> float:
        raise self._no_number_field("there are real embeddings")

    def ball(self, x: RationalFunction, place: int) -> NoReturn:
        raise self._no_number_field("there are real embeddings")

    def embeddings_modulo(self, p: int) -> NoReturn:
        raise self._no_number_field("there are embeddings modulo prime numbers")

    def splits_completely(self, p: int) -> NoReturn:
        raise self._no_number_field("there are embeddings modulo prime numbers")

    def root_modulo_4(self, d: RationalFunction) -> NoReturn:
        raise self._no_number_field("quadratic orders are given by discriminants")

    # --- what a user sees ----------------------------------------------------------------------------

    def shown_norm(self, lattice: LatticeValue) -> FunctionFieldIdeal:
        return self.ideal(lattice.norm)

    def shown_index(self, ideal: FunctionFieldIdeal) -> FunctionFieldIdeal:
        return ideal

    def theta_step(self, lattice: LatticeValue) -> Fraction:
        return Fraction(1)

    def shown_counts(self, counts: Counts, step: Fraction, bound: int) -> dict[BaseNumber, int]:
        """Return a dict ordered by degree."""
        key = self.domain.sort_key
        norms = {self.domain.fraction(x, counts.den): n for (x,), n in counts.numbers.items()}
        ordered = sorted(norms.items(), key=lambda pair: key((pair[0].num,)))
        return {self.outside(norm): n for norm, n in ordered}
