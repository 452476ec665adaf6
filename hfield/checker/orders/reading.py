"""Read statements and evidence about orders, over ℚ, a number field or a rational function field.

Over ℚ numbers are fractions. Over a number field the evidence also has an integral basis, the units and the
prime ideals. Over function fields the evidence has the same notation as statements.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property

from hfield.checker.glossary import MASS, MASS_OVER_FIELDS, MASS_OVER_POLYNOMIALS, SIEGEL
from hfield.checker.language import split
from hfield.checker.number_fields.ideals import index
from hfield.checker.number_fields.integers import (
    RATIONAL_INTEGERS,
    Factors,
    Prime,
    Primes,
    RationalPrimes,
    RingOfIntegers,
    coefficients,
    field_of,
    integer_row,
)
from hfield.checker.number_fields.matrices import (
    Key,
    N,
    Row,
    is_one,
    lcm,
    normal,
    rational_rows,
    unit,
)
from hfield.checker.number_fields.modular import echelon
from hfield.checker.number_fields.narrow_class_groups import NarrowClasses
from hfield.checker.number_fields.real_numbers import RealPlace
from hfield.checker.orders import local_types, polynomial_lattices
from hfield.checker.orders.algebra import Algebra, PolynomialAlgebra
from hfield.checker.orders.class_set import divided_by_least
from hfield.checker.orders.elements import need_definite, trace_and_norm, with_trace_and_norm
from hfield.checker.orders.lattice import Lattice, LatticeElement, LatticeOf
from hfield.checker.orders.polynomial_integers import PolynomialIntegers, PolynomialRow
from hfield.checker.orders.polynomial_lattices import (
    PolynomialElement,
    PolynomialKey,
    PolynomialLattice,
)
from hfield.checker.orders.real_algebra import RealAlgebra
from hfield.checker.orders.texts import a_rational, a_whole_number, elements_of, numbers_of
from hfield.checker.rejection import (
    a_list,
    a_text,
    an_integer,
    an_object,
    reject,
    shown,
    texts,
)
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial, RationalFunction
from hfield.checker.scalars.functions import Fraction as Function
from hfield.checker.scalars.names import a_rational as a_coefficient
from hfield.checker.scalars.number_fields import Element as Number
from hfield.checker.scalars.number_fields import NumberField
from hfield.checker.scalars.quotients import QuotientField
from hfield.checker.scalars.rationals import root
from hfield.checker.scalars.real_roots import real_roots
from hfield.checker.statement import Setting

Data = Mapping[str, object]


class Given:
    """The parts of a statement and the keys of its evidence, over one base; what is cited there."""

    unit_theorems: tuple[str, ...] = ()
    """What is cited for the units and the class number of the field."""
    zeta_theorems: tuple[str, ...] = ()
    """What is cited for ζ_K(−1)."""
    mass_theorem = MASS

    def __init__(self, data: Data) -> None:
        self.data = data


class OverNumberFields(Given, ABC):
    """An algebra over ℚ or a number field."""

    class_number = 1
    class_group_primes: Sequence[Prime] = ()
    """Prime ideals that generate the class group, none where all ideals are principal."""
    units: Sequence[Number]
    """The totally positive units modulo squares."""

    def __init__(self, setting: Setting, integers: RingOfIntegers, data: Data) -> None:
        super().__init__(data)
        self.algebra = Algebra(setting, integers)

    @property
    @abstractmethod
    def primes(self) -> Primes:
        """The primes of the base, known or given, that the mass formula needs."""

    @abstractmethod
    def coordinates(self, text: str) -> Sequence[Sequence[Fraction]]:
        """Read elements of the statement as coordinates in the integral basis."""

    @abstractmethod
    def primes_named(self, text: str) -> list[Prime]:
        """Read primes of the statement."""

    @abstractmethod
    def element(self, value: object) -> LatticeElement:
        """Read an element of the evidence."""

    def whole(self, text: str, what: str) -> int:
        """Read a number that stands for an integral ideal of the base in statements."""
        return a_whole_number(text, what)

    def fraction(self, text: str) -> Fraction:
        """Read a number that stands for an ideal of the base in statements."""
        return a_rational(text)

    def mass(self, order: Lattice) -> Fraction:
        """Return the sum of 1/[O_L(I)ˣ : ℤ_Kˣ] over the right ideal classes."""
        return local_types.mass(order, self.primes) * self.class_number

    def divided(self, ideal: Lattice, scale: Number) -> tuple[set[Key], int]:
        """Return the lattices that identify a class, and an index of units."""
        return divided_by_least(self.units, ideal, scale)

    def images(self, order: Lattice, x: LatticeElement) -> list[Row]:
        """Return the elements of an order with the trace and norm of x, as rows over its denominator."""
        return with_trace_and_norm(order, *trace_and_norm(self.algebra, x))

    def lattice(self, text: str) -> Lattice:
        """Read a lattice of the statement."""
        rows, size = self.coordinates(text), self.algebra.size
        if len(rows) != size:
            reject(f"a lattice is written as {size} elements, a basis over the integers")
        found = Lattice(self.algebra, *rational_rows(rows))
        _ = found.key  # of full rank
        return found

    def order(self, text: str) -> Lattice:
        """Read a lattice that is an order."""
        found = self.lattice(text)
        _need_order(found)
        return found

    def elements(self, text: str) -> list[LatticeElement]:
        """Read elements of the statement."""
        found = (rational_rows([row]) for row in self.coordinates(text))
        return [LatticeElement(den, row) for den, (row,) in found]

    def given(self, value: object, what: str = "a lattice") -> Lattice:
        """Read a lattice of the evidence."""
        entry, size = an_object(value, "den rows", what), self.algebra.size
        rows = [integer_row(x, size) for x in a_list(entry["rows"], "rows")]
        if len(rows) != size:
            reject(f"a lattice has {size} rows")
        return Lattice(self.algebra, an_integer(entry["den"], "a denominator", 1), tuple(rows))

    def basis(self, lattice: Lattice, value: object) -> Lattice:
        """Read another basis of a lattice."""
        found = self.given(value)
        if found.key != lattice.key:
            reject(
                "these rows are no basis of the lattice that is run through, but of another lattice"
            )
        return found


class OverQ(OverNumberFields):
    """An algebra over ℚ; integral basis, units and primes are those of ℤ."""

    def __init__(self, setting: Setting, data: Data) -> None:
        if setting.field is None or setting.field.name != "QQ" or setting.letters:
            reject("lattices are checked in an algebra over QQ alone, with numbers for constants")
        super().__init__(setting, RATIONAL_INTEGERS, data)
        self.units = [RATIONAL_INTEGERS.field.one]

    @cached_property
    def primes(self) -> Primes:
        """All primes."""
        return RationalPrimes()

    def coordinates(self, text: str) -> Sequence[Sequence[Fraction]]:
        """Read rows of four rational numbers."""
        return elements_of(text)

    def primes_named(self, text: str) -> list[Prime]:
        """Read prime numbers between commas."""
        found = numbers_of(text)
        if not all(map(is_prime, found)):
            reject("a number in the statement is no prime number")
        return [P for p in found for P in self.primes.at(p)]

    def element(self, value: object) -> LatticeElement:
        """Read an element from four texts."""
        found = [a_rational(x) for x in texts(value, "an element")]
        if len(found) != 4:
            reject("an element has four coordinates")
        den, (row,) = rational_rows([found])
        return LatticeElement(den, row)

    def quotient(
        self, first: Lattice, second: Lattice, between: Callable[[], Lattice]
    ) -> Number | None:
        """Return 1/|N(c)| for an element c that would map one lattice to the other; None if no element has
        this norm.
        """
        size = root(second.volume / first.volume)
        if size is None or (size / index(between().norm)).denominator != 1:
            return None
        return (1 / size,)

    def between(self, lattice: Lattice, side: str) -> Lattice:
        """Read a basis of {x: L·x ⊆ M} for the ``left`` side, {x: x·L ⊆ M} for the right."""
        return self.basis(lattice, self.data["between"])

    def classes(self, values: Sequence[object]) -> Iterator[tuple[Lattice, Number, int]]:
        """Read ideals with their norms; each norm is positive and generates an ideal."""
        for value in values:
            yield self.given(value), self.units[0], 0

    def real_algebra(self) -> RealAlgebra:
        """Return the algebra at the real place."""
        return RealAlgebra(self.algebra)


class OverField(OverNumberFields):
    """An algebra over a number field K; the evidence contains a basis of ℤ_K."""

    mass_theorem = MASS_OVER_FIELDS
    zeta_theorems = (SIEGEL,)

    def __init__(self, setting: Setting, data: Data) -> None:
        field = field_of(setting)
        if "basis" in data:
            integers = _integers(field, data["basis"])
        else:
            self.narrow = NarrowClasses(field, data["units"], data["fundamental"])
            integers, self.units = self.narrow.s.integers, self.narrow.units
            self.class_number, self.unit_theorems = self.narrow.order, self.narrow.s.cites
            if self.class_number > 1:
                s = self.narrow.s
                self.class_group_primes = [s.factors.primes[k] for k in s.S]
        super().__init__(setting, integers, data)

    @cached_property
    def primes(self) -> Primes:
        """The prime ideals that are given."""
        return Factors(self.algebra.integers, self.data["primes"])

    def coordinates(self, text: str) -> Sequence[Sequence[Fraction]]:
        """Read elements between bars, four numbers of the field each between commas."""
        found, ring = [], self.algebra.ring
        for entry in split(text, "|"):
            values = split(entry, ",")
            if len(values) != 4:
                reject("an element is written as four numbers")
            row: list[Fraction] = []
            for value in values:
                number = coefficients(ring, ring.read(value.strip()))
                den, own = self.algebra.integers.coordinates(number)
                row += [Fraction(c, den) for c in own]
            found.append(row)
        return found

    def primes_named(self, text: str) -> list[Prime]:
        """Read prime ideals between bars, each as p, or as (p, α)."""
        found, ring = [], self.algebra.ring
        for entry in split(text, "|"):
            whole = entry.strip()
            first, *others = split(whole[1:-1] if whole.startswith("(") else whole, ",")
            p = a_whole_number(first, "the first generator of a prime ideal")
            above = self.primes.at(p)
            rows: list[Row] = []
            for value in others:
                den, row = self.algebra.integers.coordinates(
                    coefficients(ring, ring.read(value.strip()))
                )
                if den != 1:
                    reject("a generator of a prime ideal is no integer of the field")
                rows += self.algebra.integers.matrix(row)
            span = echelon(rows, p) if rows else []
            P = next((P for P in above if P.span == span), None)
            if P is None:
                reject(f"{shown(whole)!r} is no prime ideal that is given")
            found.append(P)
        return found

    def element(self, value: object) -> LatticeElement:
        """Read coordinates over a denominator; the element is not 0."""
        entry = an_object(value, "den row", "an element")
        den = an_integer(entry["den"], "a denominator", 1)
        row = integer_row(entry["row"], self.algebra.size)
        if not any(row):
            reject("an element is 0")
        return LatticeElement(den, row)

    def quotient(
        self, first: Lattice, second: Lattice, between: Callable[[], Lattice]
    ) -> Number | None:
        """Return 1/ν for a totally positive generator ν of N(M)/N(L), or None if there is none.

        In a totally definite algebra, J = I·c implies that N(c) is such a generator: ν up to squares of
        units.
        """
        narrow = self.narrow
        for lattice in (first, second):
            _need_module(lattice)
            need_definite(lattice)
        if "quotient" in self.data:
            x, e = narrow.read(self.data["quotient"])
            if not narrow.is_quotient(x, e, second.norm, first.norm):
                reject("the quotient of the norms is another ideal")
            if narrow.is_principal(x, e):
                reject("the quotient of the norms has a totally positive generator")
            return None
        if not self.data.keys() >= {"norm", "between"}:
            reject("the evidence lacks the key 'quotient', or the keys 'norm' and 'between'")
        nu = narrow.s.given(self.data["norm"])
        inverse = narrow.need_totally_positive(nu)
        if not narrow.is_quotient(nu, [0] * len(narrow.s.S), second.norm, first.norm):
            reject("the quotient of the norms is another ideal")
        return inverse

    def between(self, lattice: Lattice, side: str) -> Lattice:
        """Read a basis of {x: L·x ⊆ M} for the ``left`` side; for the right side, of the conjugates."""
        return self.basis(lattice if side == "left" else lattice.conjugate, self.data["between"])

    def classes(self, values: Sequence[object]) -> Iterator[tuple[Lattice, Number, int]]:
        """Read ideals with their norms: ν times one of the ideals of the narrow classes."""
        narrow, n = self.narrow, self.algebra.n
        norms = narrow.classes(self.data.get("narrow"))
        whole = 1, tuple(unit(n, k) for k in range(n))
        for value in values:
            entry = dict(an_object(value, "den rows norm", "an ideal", "narrow"))
            nu = narrow.s.given(entry.pop("norm"))
            kind = an_integer(entry.pop("narrow", 0), "a number", 0)
            if kind >= len(norms):
                reject("an ideal has the norm of a narrow class that is not given")
            ideal = self.given(entry)
            inverse = narrow.need_totally_positive(nu)
            x, e = norms[kind]
            if not narrow.is_quotient(narrow.field.mul(nu, x), e, ideal.norm, whole):
                reject("the norm of an ideal is another one")
            yield ideal, inverse, kind

    def real_algebra(self) -> RealAlgebra:
        """Return the algebra at the only real place where it splits; the field is totally real."""
        algebra = self.algebra
        integers = algebra.integers
        roots = real_roots(integers.field.modulus)
        first, second = (integers.number([Fraction(c) for c in row]) for row in algebra.signs)
        found = [x for x in roots if x.sign(first) > 0 or x.sign(second) > 0]
        if len(roots) < algebra.n or len(found) != 1:
            reject("groups are of algebras over totally real fields that split at one real place")
        return RealAlgebra(algebra, RealPlace(integers, found[0]))


class OverPolynomials(Given):
    """An algebra over GF(q)(t): lattices are given by bases over GF(q)[t], ideals by generators."""

    mass_theorem = MASS_OVER_POLYNOMIALS

    def __init__(self, setting: Setting, data: Data) -> None:
        super().__init__(data)
        self.polynomials = PolynomialIntegers(setting)
        self.algebra = PolynomialAlgebra(setting, self.polynomials)

    @cached_property
    def primes(self) -> list[tuple[FiniteFieldPolynomial, QuotientField[Hashable]]]:
        """The given primes, with their residue fields."""
        return list(map(self.polynomials.prime, texts(self.data["primes"], "the primes")))

    def coordinates(self, text: str) -> Sequence[Sequence[Function[Hashable]]]:
        """Read elements between bars, four functions each between commas."""
        field, found = self.polynomials.functions, []
        for entry in split(text, "|"):
            values = split(entry, ",")
            if len(values) != 4:
                reject("an element is written as four functions")
            found.append([field.read(value.strip()) for value in values])
        return found

    def _rows(self, text: str) -> tuple[FiniteFieldPolynomial, tuple[PolynomialRow, ...]]:
        """Read elements as rows over the least denominator."""
        entries = [
            [self.polynomials.coordinates([x]) for x in row] for row in self.coordinates(text)
        ]
        den = lcm(*(below for row in entries for below, _ in row))
        rows = tuple(tuple(top * (den // below) for below, (top,) in row) for row in entries)
        return den, rows

    def lattice(self, text: str) -> PolynomialLattice:
        """Read a lattice of the statement or of the evidence."""
        den, rows = self._rows(text)
        if len(rows) != 4:
            reject("a lattice is written as 4 elements, a basis over the polynomials")
        found = PolynomialLattice(self.algebra, den, rows)
        _ = found.key  # of full rank
        return found

    def order(self, text: str) -> PolynomialLattice:
        """Read a lattice that is an order."""
        found = self.lattice(text)
        _need_order(found)
        return found

    def element(self, value: object) -> PolynomialElement:
        """Read a nonzero element."""
        den, rows = self._rows(a_text(value, "an element"))
        if len(rows) != 1 or not any(rows[0]):
            reject("an element is four functions, not all of them 0")
        return PolynomialElement(den, rows[0])

    def basis(self, lattice: PolynomialLattice, value: object) -> PolynomialLattice:
        """Read another basis of a lattice."""
        found = self.lattice(a_text(value, "a basis"))
        if found.key != lattice.key:
            reject("these elements are no basis of the lattice that is run through, but of another")
        return found

    def whole(self, text: str, what: str) -> FiniteFieldPolynomial:
        """Read the monic generator of an integral ideal."""
        found = self.fraction(text)
        if not is_one(found.denominator):
            reject(f"{what} must be a polynomial")
        return found.numerator

    def fraction(self, text: str) -> RationalFunction:
        """Read the generator of an ideal, a quotient of monic polynomials."""
        den, (top,) = self.polynomials.coordinates([self.polynomials.functions.read(text)])
        if not top or top != normal(top):
            reject("an ideal is written as a quotient of monic polynomials")
        return top.ratio(den)

    def mass(self, order: PolynomialLattice) -> Fraction:
        """Return the sum of 1/[O_L(I)ˣ : GF(q)ˣ] over the right ideal classes."""
        return polynomial_lattices.mass(order, self.primes)

    def divided(self, ideal: PolynomialLattice, scale: None) -> tuple[set[PolynomialKey], int]:
        """Return the lattices that identify a class, and an index of units."""
        return polynomial_lattices.divided_by_least(ideal)

    def classes(self, values: Sequence[object]) -> Iterator[tuple[PolynomialLattice, None, int]]:
        """Read ideals in reduced bases."""
        for value in values:
            yield self.lattice(a_text(value, "an ideal")), None, 0

    def images(self, order: PolynomialLattice, x: PolynomialElement) -> list[PolynomialRow]:
        """Return the elements of an order with the trace and norm of x, as rows over its denominator."""
        return polynomial_lattices.with_trace_and_norm_of(order, x)


def _integers(field: NumberField, value: object) -> RingOfIntegers:
    """Read an integral basis of a field."""
    rows = [
        [a_coefficient(c, "a coefficient") for c in a_list(x, "an element")]
        for x in a_list(value, "the integral basis")
    ]
    if [len(row) for row in rows] != [field.degree] * field.degree:
        reject(f"an integral basis has {field.degree} elements, of as many coefficients")
    return RingOfIntegers(field, rows)


def _need_module(lattice: Lattice) -> None:
    """Reject unless a lattice is closed under the integers of the field."""
    algebra = lattice.algebra
    lattice.pay(algebra.n)
    for by in algebra.integers.table:
        if not lattice.holds(lattice.den, [algebra.blockwise(x, by) for x in lattice.rows]):
            reject("a lattice is no module over the integers of the field")


def _need_order(lattice: LatticeOf[N]) -> None:
    """Reject a lattice that is no order."""
    algebra = lattice.algebra
    if not lattice.holds(algebra.integers.zero + 1, algebra.basis):
        reject("this is no order: 1 is not in it, or not all integers of the field")
    if not lattice.products_lie_in(lattice, lattice):
        reject("this is no order: a product of two rows is not in it")
