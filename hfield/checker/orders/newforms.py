"""Newforms: eigenvectors of Hecke operators on functions on the right ideals of an order.

Let O be an Eichler order of level N in a totally definite algebra of discriminant D. The value of T_P·f at I
is the sum of f(J) over the right ideals J in I of relative norm P, of which there are N(P) + 1 where P does
not divide D·N. In weight 2 the values are numbers and f(c·I) = f(I). In weight k over ℚ they lie in a
representation (:mod:`hfield.checker.orders.weights`), f(c·I) = c·f(I), and T_p has the factor p^(k/2−1). A
function f is new if it is orthogonal to functions of the norm, in weight 2, and if its trace to each
order O′ in which O has prime index vanishes: the sum of f(J) over the J with J·O′ = L, for each right ideal L
of O′. At a prime of the level there are two such orders.

The ideals J are given as c·I, where I represents a class. The list of the J is complete if they are distinct
and have the expected number. An orbit of newforms is given by the values of an eigenvector in the field of
the orbit. If a combination of Hecke operators has distinct eigenvalues on all these eigenvectors and their
conjugates, they are independent. They span the new functions if their number is the dimension; equations
modulo a prime give an upper bound for it (docs/explanation/trust.md).
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import accumulate
from math import lcm
from operator import add

from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import (
    BY_EIGENVECTORS,
    FIELD,
    NEW_FUNCTIONS,
    NEW_FUNCTIONS_OF_WEIGHT,
    SIGNS,
)
from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.ideals import index, times_primes
from hfield.checker.number_fields.integers import RATIONAL_FIELD, Prime, coefficients, integer_row
from hfield.checker.number_fields.matrices import (
    Key,
    Rows,
    hermite,
    longest,
    times,
    transposed,
    unit,
)
from hfield.checker.number_fields.modular import echelon, kernel
from hfield.checker.orders.class_set import left_units, need_class_set, need_ideal
from hfield.checker.orders.lattice import Lattice, LatticeElement
from hfield.checker.orders.local_types import symbols
from hfield.checker.orders.reading import OverField, OverQ
from hfield.checker.orders.texts import a_whole_number, orbits_of, signs_of
from hfield.checker.orders.weights import Values
from hfield.checker.rejection import a_list, an_integer, an_object, reject, shown
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.finite import gcd_modulo, is_prime
from hfield.checker.scalars.number_fields import Element as Number
from hfield.checker.scalars.number_fields import NumberField
from hfield.checker.scalars.rationals import QQ


@dataclass(frozen=True)
class Sum:
    """The sum of the values of a function at some ideals, times ``den``: Σ f(Iⱼ)·Mⱼ, Mⱼ by j."""

    den: int
    blocks: Mapping[int, Rows]
    bits: int
    """The bit length of the longest entry."""


def are_newforms(given: OverQ | OverField, parts: tuple[str, ...]) -> CheckResult:
    """Check that these are the Galois orbits of newforms of a weight, with eigenvalues at some primes."""
    values = Values(given.algebra, a_whole_number(parts[1], "a weight"))
    functions = FunctionsOnClasses(given, given.order(parts[0]), values)
    primes, data = given.primes_named(parts[2]), given.data
    rows = functions.hecke_rows(primes, data["neighbours"])
    weights = [an_integer(c, "a coefficient") for c in a_list(data["operator"], "the operator")]
    if len(weights) != len(primes):
        reject("the operator has a coefficient for each prime")
    if any(c and len(own) < functions.size for c, own in zip(weights, rows, strict=True)):
        reject("an operator that tells newforms apart is given at all classes")
    equations = [*functions.equations(data["above"]), *functions.central_equations()]
    orbits = list(_orbits(parts[3], data["orbits"], functions, len(primes)))
    for orbit in orbits:
        orbit.need_invariant(functions.actions)
        orbit.need_new(equations)
        for P, own, a in zip(primes, rows, orbit.eigenvalues, strict=True):
            orbit.need_eigenvalue(own, a, P.norm**values.degree)
    p = an_integer(data["modulus"], "a prime number", 2)
    if not is_prime(p):
        reject("the modulus is no prime number")
    if sum(orbit.field.degree for orbit in orbits) != functions.dimension(equations, p):
        reject("the degrees of the orbits do not add up to the dimension of the new functions")
    _need_different([orbit.characteristic(weights) for orbit in orbits], p)
    cites = [*given.unit_theorems, *given.zeta_theorems, given.mass_theorem]
    cites.append(NEW_FUNCTIONS_OF_WEIGHT if values.degree else NEW_FUNCTIONS)
    if len(parts) > 4 or "signs" in data:
        _need_signs(functions, orbits, parts[4:])
        cites.append(SIGNS)
    return CheckResult(FIELD, BY_EIGENVECTORS).citing(*cites)


def _need_signs(
    functions: "FunctionsOnClasses", orbits: Sequence["Orbit"], parts: tuple[str, ...]
) -> None:
    """Reject unless the orbits have these signs of Atkin and Lehner at these primes."""
    given = functions.given
    if len(parts) != 2 or "signs" not in given.data:
        reject("signs are stated together with primes, and have evidence")
    primes, stated = given.primes_named(parts[0]), signs_of(parts[1])
    entries = a_list(given.data["signs"], "signs", 1)
    if len(entries) != len(primes) or [len(own) for own in stated] != [len(primes)] * len(orbits):
        reject("there is a sign for each orbit and each prime, and evidence for each prime")
    for n, (P, entry) in enumerate(zip(primes, entries, strict=True)):
        factor, rows = functions.exchange_rows(P, entry)
        for orbit, own in zip(orbits, stated, strict=True):
            orbit.need_eigenvalue(rows, orbit.field.number(factor * own[n]), 1)


class FunctionsOnClasses:
    """The functions on the right ideals of an Eichler order, one ideal of each class being given."""

    def __init__(self, given: OverQ | OverField, order: Lattice, values: Values) -> None:
        self.given, self.order, self.values = given, order, values
        classes = list(given.classes(a_list(given.data["classes"], "classes", 1)))
        self.units = need_class_set(order, classes, given.divided, given.mass(order))
        self.ideals, self.kinds = [x for x, _, _ in classes], [kind for _, _, kind in classes]
        self.size = len(classes)
        self.actions: list[list[tuple[Rows, int]]] = [[] for _ in classes]
        """For each class, how the units of the left order act on values; 1 is left out."""
        if values.degree:
            for own, (ideal, scale, _) in zip(self.actions, classes, strict=True):
                own += map(values.action, left_units(given.units, ideal, scale)[1:])
        self._symbols = symbols(order, given.primes)
        self.level = self._level()

    def _level(self) -> list[Prime]:
        """Return the primes of the level of an Eichler order. Rejects another order."""
        found = []
        for p, e in factored(self.order.discriminant).items():
            above = [(P, symbol) for P, symbol in self._symbols if P.p == p]
            is_squarefree = e == sum(P.degree for P, _ in above)
            for P, symbol in above:
                if symbol == 1:
                    found.append(P)
                elif symbol == 0 or not is_squarefree:
                    reject(f"it is not shown that this is an Eichler order at {p}")
        return found

    def _ideals(
        self, entries: object, inside: Lattice, number: int, volume: Fraction, norm: Key | None
    ) -> Sum:
        """Read so many different right ideals in a lattice, as pairs of a class and an element."""
        found, known = list[tuple[int, LatticeElement]](), set()
        for entry in a_list(entries, "ideals"):
            j, c, ideal = self._ideal(entry)
            if not inside.holds(ideal.den, ideal.rows):
                reject("an ideal does not lie where it should")
            if ideal.volume != volume or norm not in (None, ideal.norm):
                reject("an ideal has another norm than it should")
            known.add(ideal.key)
            found.append((j, c))
        if len(known) != number or len(found) != number:
            reject(f"{number} different ideals are expected")
        return self._sum(found)

    def _sum(self, ideals: Sequence[tuple[int, LatticeElement]]) -> Sum:
        """Return the sum of the values at some ideals c·Iⱼ: f(c·I) is f(I) on which c acts."""
        width = self.values.dimension
        terms = [(j, *self.values.action(c.row)) for j, c in ideals]
        den = 1
        for _, _, scale in terms:
            spend(den.bit_length() * scale.bit_length() // 500_000)
            den = lcm(den, scale)
        bits, blocks = den.bit_length(), dict[int, list[list[int]]]()
        spend(len(terms) * width**2 * (1 + bits // 1_000 + bits * bits // 500_000))
        for j, matrix, scale in terms:
            own = blocks.setdefault(j, [[0] * width for _ in range(width)])
            for total, row in zip(own, matrix, strict=True):
                total[:] = [x + den // scale * y for x, y in zip(total, row, strict=True)]
        whole = {j: tuple(map(tuple, own)) for j, own in blocks.items()}
        return Sum(den, whole, longest(row for own in whole.values() for row in own))

    def _ideal(self, entry: object) -> tuple[int, LatticeElement, Lattice]:
        """Read ``[j, c]``: the ideal c·I of class j."""
        pair = a_list(entry, "an ideal", 2)
        j, c = an_integer(pair[0], "a class", 0), self.given.element(pair[1])
        if len(pair) != 2 or j >= self.size or not any(c.row):
            reject("an ideal is the number of a class and an element other than 0")
        ideal = self.ideals[j].times(c, "left")
        _ = ideal.key  # of full rank
        return j, c, ideal

    def hecke_rows(self, primes: Sequence[Prime], value: object) -> list[dict[int, Sum]]:
        """Read the rows of Hecke operators: for each prime, pairs of a class and the ideals in it."""
        tables = a_list(value, "neighbours")
        if len(tables) != len(primes) or not primes:
            reject("there are neighbours for each prime, one at least")
        found: list[dict[int, Sum]] = []
        for P, table in zip(primes, tables, strict=True):
            if P in [Q for Q, _ in self._symbols]:
                reject("a prime divides the discriminant of the order")
            rows: dict[int, Sum] = {}
            for entry in a_list(table, "neighbours", 1):
                pair = a_list(entry, "a row", 2)
                i = an_integer(pair[0], "a class", 0)
                if len(pair) != 2 or i >= self.size or i in rows:
                    reject("a row has the number of a class, and its ideals; no class comes twice")
                around = self.ideals[i]
                volume = around.volume * P.norm**2
                norm = times_primes(around.algebra.integers, [(P, 1)], around.norm)
                rows[i] = self._ideals(pair[1], around, P.norm + 1, volume, norm)
            found.append(rows)
        return found

    def central_equations(self) -> Iterator[Sum]:
        """Yield f(P·I) = f(I) for the prime ideals P of the field that generate its class group.

        The values are numbers: the field is not ℚ, so that the weight is 2.
        """
        primes = self.given.class_group_primes
        tables = a_list(self.given.data.get("central", []), "the products with ideals of the field")
        if len(tables) != len(primes):
            reject("there are products with each prime ideal that is needed for the class group")
        for P, table in zip(primes, tables, strict=True):
            entries = a_list(table, "the products with a prime ideal")
            if len(entries) != self.size:
                reject("there is a product of each class with a prime ideal")
            for i, entry in enumerate(entries):
                j, _, image = self._ideal(entry)
                if image.key != _times_prime(self.ideals[i], P).key:
                    reject("an ideal is not the product with an ideal of the field")
                if i != j:
                    yield Sum(1, {i: ((-1,),), j: ((1,),)}, 1)

    def exchange_rows(self, P: Prime, value: object) -> tuple[int, dict[int, Sum]]:
        """Read rows of the operator f(I) ↦ f(I·J) for the two-sided ideal J at a prime of the discriminant.

        Returns the factor by which it differs from the operator of Atkin and Lehner, and the rows.
        """
        symbol = next((symbol for Q, symbol in self._symbols if Q == P), None)
        if symbol is None:
            reject("signs are stated at primes of the discriminant of the order")
        data = an_object(value, "ideal images", "the evidence of signs")
        two_sided = self.given.given(data["ideal"])
        self._need_two_sided_prime(two_sided, P)
        rows: dict[int, Sum] = {}
        for entry in a_list(data["images"], "images"):
            pair = a_list(entry, "a row", 2)
            i = an_integer(pair[0], "a class", 0)
            if len(pair) != 2 or i >= self.size or i in rows:
                reject("an image has the number of a class, and an ideal; no class comes twice")
            j, c, image = self._ideal(pair[1])
            if image.key != _product(self.ideals[i], two_sided).key:
                reject("an ideal is not the product with the two-sided ideal")
            rows[i] = self._sum([(j, c)])
        return (-1 if symbol < 0 else 1), rows

    def _need_two_sided_prime(self, ideal: Lattice, P: Prime) -> None:
        """Reject unless an ideal is the two-sided one at P that is not O and not in P·O.

        With P·O it generates the locally principal two-sided ideals at P.
        """
        for side in ("left", "right"):
            need_ideal(ideal, self.order, side, "the two-sided ideal")
        integers = self.order.algebra.integers
        whole: Key = 1, tuple(unit(integers.n, k) for k in range(integers.n))
        size, norm = index(ideal.norm), times_primes(integers, [(P, 1)], whole)
        while index(norm) < size:
            spend(20 + size.numerator.bit_length() // 100)
            norm = times_primes(integers, [(P, 1)], norm)
        if norm != ideal.norm or not self.order.holds(ideal.den, ideal.rows):
            reject("the norm of the two-sided ideal is no power of the prime")
        if _times_prime(self.order, P).holds(ideal.den, ideal.rows):
            reject("the two-sided ideal is a multiple of the prime")

    def dimension(self, equations: Sequence[Sum], p: int) -> int:
        """Return a bound of the dimension of the functions that satisfy equations, from those modulo p."""
        width = self.values.dimension
        bases = [self._fixed(own, p) for own in self.actions]
        starts = [0, *accumulate(map(len, bases))]
        spend(len(equations) * width * starts[-1])
        table: list[list[int]] = []
        for equation in equations:
            rows = [[0] * starts[-1] for _ in range(width)]
            for j, matrix in equation.blocks.items():
                spend(len(bases[j]) * width**2 * (1 + equation.bits // 1_000))
                for n, value in enumerate(times(bases[j], matrix), starts[j]):
                    for row, c in zip(rows, value, strict=True):
                        row[n] = c % p
            table += rows
        return starts[-1] - len(echelon(table, p))

    def _fixed(self, actions: Sequence[tuple[Rows, int]], p: int) -> Sequence[Sequence[int]]:
        """Return a basis of the values that units fix, modulo p."""
        width = self.values.dimension
        if not actions:
            return [unit(width, n) for n in range(width)]
        wide = [
            [c - scale * int(k == n) for matrix, scale in actions for k, c in enumerate(matrix[n])]
            for n in range(width)
        ]
        return kernel(wide, p)

    def equations(self, value: object) -> list[Sum]:
        """Read the linear equations of new functions, from the orders in which this order has prime index."""
        common = lcm(*self.units)
        found: list[Sum] = []
        for kind in sorted(set(self.kinds)) if not self.values.degree else ():
            own = [n for n, k in enumerate(self.kinds) if k == kind]
            blocks = {n: ((common // self.units[n],),) for n in own}
            found.append(Sum(1, blocks, common.bit_length()))
        primes: list[Prime] = []
        larger = set()
        for entry in a_list(value, "the orders above"):
            data = an_object(entry, "order ideals", "an order above")
            above = self.given.given(data["order"])
            P = self._prime_of_index(above)
            larger.add(above.key)
            primes.append(P)
            found += self._traces(above, P, a_list(data["ideals"], "ideals of an order above", 1))
        if any(primes.count(P) != 2 for P in self.level) or len(larger) != 2 * len(self.level):
            reject("there are two orders above at each prime of the level, and all are to be given")
        return found

    def _prime_of_index(self, above: Lattice) -> Prime:
        """Return the prime of the level at which an order is larger than this one; reject other lattices."""
        one = self.order.algebra.number(self.order.algebra.integers.one)
        if not (
            above.holds(1, [one])
            and above.products_lie_in(above, above)
            and above.holds(self.order.den, self.order.rows)
        ):
            reject("an order above is no order, or does not contain the other")
        ratio = self.order.volume / above.volume
        for P in self.level:
            if ratio == P.norm:
                inside = _times_prime(above, P)
                if self.order.holds(inside.den, inside.rows):  # O′ is larger at P alone
                    return P
        reject("an order above has no prime index at a prime of the level")

    def _traces(self, above: Lattice, P: Prime, values: Sequence[object]) -> Iterator[Sum]:
        """Yield the sums over the ideals J with J·O′ = L, for one L in each class."""
        in_level = P in [Q for Q, _ in symbols(above, self.given.primes)]
        number = P.norm if in_level else P.norm + 1
        classes: set[int] = set()
        for value in values:
            entries = a_list(value, "ideals", 1)
            _, _, first = self._ideal(entries[0])
            generated = _product(first, above)
            row = self._ideals(entries, generated, number, first.volume, None)
            classes |= row.blocks.keys()
            yield row
        if len(classes) != self.size:
            reject("a class lies in no ideal of an order above")


def _times_prime(lattice: Lattice, P: Prime) -> Lattice:
    """Return P·L."""
    algebra = lattice.algebra
    span = [*P.span, tuple(P.p * c for c in algebra.integers.one)]
    lattice.pay(len(span))
    rows = [
        algebra.blockwise(row, algebra.integers.matrix(x)) for x in span for row in lattice.rows
    ]
    return Lattice(algebra, lattice.den, hermite(rows))


def _product(ideal: Lattice, order: Lattice) -> Lattice:
    """Return I·O′."""
    ideal.pay(3 * ideal.algebra.size, order.bits)
    rows = [x for row in order.rows for x in times(ideal.rows, ideal.algebra.right(row))]
    den = ideal.den * order.den * ideal.algebra.scale
    return Lattice(ideal.algebra, den, hermite(rows))


# --- orbits -------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Orbit:
    """A Galois orbit: the field, eigenvalues at the primes, and an eigenvector with integral coefficients."""

    field: NumberField
    eigenvalues: list[Number]
    vector: list[Rows]
    """For each class and each power of the generator of the field a value, a row."""
    bits: int
    """The bit length of its longest entry."""

    def _at(self, row: Sum) -> list[list[int]]:
        """Return a sum of values."""
        spend(4)
        found = [[0] * len(value) for value in self.vector[0]]
        for j, matrix in row.blocks.items():
            self._pay(matrix, row.bits)
            for total, part in zip(found, times(self.vector[j], matrix), strict=True):
                total[:] = map(add, total, part)
        return found

    def _pay(self, matrix: Rows, bits: int) -> None:
        """Spend the cost of applying a matrix to a value."""
        cost = 1 + (self.bits + bits) // 1_000 + self.bits * bits // 500_000
        spend(4 + self.field.degree * len(matrix) ** 2 * cost)

    def need_invariant(self, actions: Sequence[Sequence[tuple[Rows, int]]]) -> None:
        """Reject values that units of left orders change."""
        for value, own in zip(self.vector, actions, strict=True):
            for matrix, scale in own:
                self._pay(matrix, longest(matrix))
                if times(value, matrix) != [tuple(scale * c for c in row) for row in value]:
                    reject("a unit of a left order changes a value of an eigenvector")

    def need_new(self, equations: Sequence[Sum]) -> None:
        """Reject a function that is not new."""
        if any(any(map(any, self._at(row))) for row in equations):
            reject("an eigenvector is no new function: an equation fails")

    def need_eigenvalue(self, rows: Mapping[int, Sum], a: Number, factor: int) -> None:
        """Reject unless these rows of an operator, times a factor, have this eigenvalue.

        One of them has to be at a value other than 0.
        """
        field = self.field
        for i, row in rows.items():
            for x, y in zip(transposed(self.vector[i]), transposed(self._at(row)), strict=True):
                value = tuple(Fraction(row.den * c) for c in x)
                if field.mul(a, value) != tuple(factor * c for c in y):
                    reject("a vector is no eigenvector with the eigenvalue that is stated")
        if not any(any(map(any, self.vector[i])) for i in rows):
            reject("an eigenvalue is not seen: the eigenvector is 0 where the operator is given")

    def characteristic(self, weights: Sequence[int]) -> list[int]:
        """Return the characteristic polynomial of the operator's eigenvalue, by Newton's identities."""
        field, x = self.field, self.field.zero
        for c, a in zip(weights, self.eigenvalues, strict=True):
            x = field.add(x, field.mul(field.number(c), a))
        power, sums = field.one, []
        for _ in range(field.degree):
            power = field.mul(power, x)
            sums.append(_dot(power, self._traces))
        return _by_power_sums(sums)

    @cached_property
    def _traces(self) -> list[Fraction]:
        """The traces of 1, s, s², …"""
        e = self.field.modulus[::-1]
        found = [Fraction(self.field.degree)]
        for k in range(1, self.field.degree):
            # t_k + e₁·t_(k−1) + … + e_(k−1)·t₁ + k·e_k = 0 for the coefficients e_m of degree n − m
            found.append(-_dot([*e[1:k], e[k]], [*found[:0:-1], Fraction(k)]))
        return found


def _dot(xs: Sequence[Fraction], ys: Sequence[Fraction]) -> Fraction:
    """Return Σ x·y."""
    found = Fraction(0)
    for x, y in zip(xs, ys, strict=True):
        found = QQ.add(found, QQ.mul(x, y))
    return found


def _by_power_sums(sums: Sequence[Fraction]) -> list[int]:
    """Return the monic polynomial whose roots have these power sums, low degree first."""
    e = [Fraction(1)]
    for k in range(1, len(sums) + 1):
        e.append(-_dot(e, sums[k - 1 :: -1]) / k)
    if any(c.denominator != 1 for c in e):
        reject("an eigenvalue is no integer of its field")
    return [int(c) for c in reversed(e)]


def _need_different(polynomials: Sequence[Sequence[int]], p: int) -> None:
    """Reject unless all roots modulo p of all these polynomials together are distinct."""
    whole = [1]
    for f in polynomials:
        spend(len(whole) * len(f))
        found = [0] * (len(whole) + len(f) - 1)
        for k, c in enumerate(whole):
            for m, d in enumerate(f):
                found[k + m] = (found[k + m] + c * d) % p
        whole = found
    derivative = [k * c % p for k, c in enumerate(whole)][1:]
    if len(gcd_modulo(whole, derivative, p)) > 1:
        reject(
            "the operator does not tell these newforms apart: it has an eigenvalue twice modulo p"
        )


def _orbits(
    text: str, value: object, functions: FunctionsOnClasses, primes: int
) -> Iterator[Orbit]:
    """Read ``field: a, a, …`` between bars, with the data of the fields and the eigenvectors."""
    data = a_list(value, "orbits")
    named = orbits_of(text)
    if len(named) != len(data):
        reject("there is an eigenvector for each orbit that is stated")
    for entry, (name, texts) in zip(data, named, strict=True):
        orbit = an_object(entry, "ring vector", "an orbit")
        ring = read_ring(orbit["ring"])
        field = RATIONAL_FIELD if ring is QQ else ring
        if not isinstance(field, NumberField) or name != ring.name:
            reject(f"the field of an orbit is {shown(name)!r} by its name, and not by its data")
        d, width = field.degree, functions.values.dimension
        vector = [integer_row(x, d * width) for x in a_list(orbit["vector"], "an eigenvector")]
        if len(texts) != primes or len(vector) != functions.size:
            reject("an orbit has an eigenvalue for each prime, and a value for each class")
        values = [coefficients(ring, ring.read(x)) for x in texts]
        parted = [tuple(row[k::d] for k in range(d)) for row in vector]
        yield Orbit(field, values, parted, longest(vector))
