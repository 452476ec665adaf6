"""Lattices over GF(q)[t]: reduced bases, elements of least or given degree, Eichler symbols, masses.

A basis b is reduced if the degree of N(Σ cₙ·bₙ) is always the largest of the degrees of N(cₙ·bₙ). The leading
coefficients prove this, and also that the algebra ramifies at infinity (docs/explanation/trust.md).
"""

from collections.abc import Hashable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import product

from hfield.checker.budget import spend
from hfield.checker.number_fields.matrices import KeyOf, is_one, times
from hfield.checker.orders.algebra import PolynomialAlgebra
from hfield.checker.orders.lattice import ElementOf, LatticeOf
from hfield.checker.orders.polynomial_integers import PolynomialIntegers, PolynomialRow
from hfield.checker.rejection import reject
from hfield.checker.scalars.finite_field_polynomials import FiniteFieldPolynomial, RationalFunction
from hfield.checker.scalars.quotients import QuotientField

PolynomialKey = KeyOf[FiniteFieldPolynomial]


class PolynomialElement(ElementOf[FiniteFieldPolynomial]):
    """A row of polynomials over a denominator."""


class PolynomialLattice(LatticeOf[FiniteFieldPolynomial]):
    """The combinations of four independent rows over ``den`` with polynomials as coefficients."""

    algebra: PolynomialAlgebra
    volume: RationalFunction

    @property
    def polynomials(self) -> PolynomialIntegers:
        """The ring of the coefficients."""
        return self.algebra.integers

    @cached_property
    def norms(self) -> list[PolynomialRow]:
        """The norms of the rows, multiplied by :attr:`unit`."""
        return [(self.algebra.norm(row),) for row in self.rows]

    @cached_property
    def degrees(self) -> list[int]:
        """The degrees of :attr:`norms` for a reduced basis. Raises :class:`Rejected` for other bases."""
        base, norms = self.polynomials.base, [x for (x,) in self.norms]
        (traces,), degrees = self.gram, [x.degree for x in norms]
        if not all(norms):
            reject(
                "an element of a lattice has the norm 0: its algebra does not ramify at infinity"
            )
        for parity in (0, 1):
            some = [m for m, degree in enumerate(degrees) if degree % 2 == parity]
            if len(some) > 2:
                reject("a basis is not reduced: three of its norms have degrees of one parity")
            if len(some) == 2:
                m, n = some
                scale = base.need_inverse(norms[m].lead)
                middle = traces[m][n].at((degrees[m] + degrees[n]) // 2)
                if not base.is_irreducible(base.mul(middle, scale), base.mul(norms[n].lead, scale)):
                    reject("a basis is not reduced: the leading terms of two norms are dependent")
        for m in range(4):
            for n in range(m):
                if 2 * traces[m][n].degree > degrees[m] + degrees[n]:
                    reject("a basis is not reduced: a trace has too large a degree")
        return degrees

    def up_to_degree(self, degree: int) -> Iterator[PolynomialRow]:
        """Yield all elements for which :attr:`unit` times the norm has at most a given degree."""
        bounds = [(degree - own) // 2 + 1 for own in self.degrees]
        spend(self.polynomials.order ** max(max(bounds), 0))  # lists of polynomials
        choices = [list(self.polynomials.of_degree_below(bound)) for bound in bounds]
        for combination in product(*choices):
            spend(20)
            yield times([combination], self.rows)[0]

    def least(self) -> list[PolynomialRow]:
        """Return the elements with norms of least degree, one of each line over the constants."""
        least, (one,) = min(self.degrees), self.polynomials.one
        first, *second = [row for row, d in zip(self.rows, self.degrees, strict=True) if d == least]
        found: list[PolynomialRow] = [first]
        for row in second:
            for c in self.polynomials.of_degree_below(1):
                found += times([(c, one)], [first, row])
        return found

    def divided(self, x: PolynomialRow) -> PolynomialKey:
        """Return x⁻¹·L, for a row x over the denominator of the lattice."""
        norm = self.algebra.norm(x)
        bar = tuple(c * self.den for c in self.algebra.conjugate(x))
        return self.times(PolynomialElement(norm * norm.to_normal, bar), "left").key


def divided_by_least(lattice: PolynomialLattice) -> tuple[set[PolynomialKey], int]:
    """Return the lattices x⁻¹·I for the x in I with norms of least degree, and for each the number of x
    modulo GF(q)ˣ.

    That number is the index of GF(q)ˣ in the units of the left order of I.
    """
    every = lattice.least()
    found = {lattice.divided(x) for x in every}
    return found, len(every) // len(found)


def with_trace_and_norm_of(order: PolynomialLattice, x: PolynomialElement) -> list[PolynomialRow]:
    """Return the elements of an order with the trace and the norm of x, as rows over its denominator."""
    algebra = order.algebra
    trace, norm = algebra.trace(x.row)[0] * order.den, algebra.norm(x.row) * order.den**2
    degree = norm.degree - 2 * x.den.degree  # of the norm, as of the rows
    return [
        y
        for y in order.up_to_degree(degree)
        if algebra.trace(y)[0] * x.den == trace and algebra.norm(y) * x.den**2 == norm
    ]


def mass(
    order: PolynomialLattice,
    primes: Sequence[tuple[FiniteFieldPolynomial, QuotientField[Hashable]]],
) -> Fraction:
    """Return Σ 1/[O_L(I)ˣ : GF(q)ˣ] over the right ideal classes, by the cited formula.

    The primes of the discriminant must be given.
    """
    rest, q = order.discriminant, order.polynomials.order
    spend((1 + len(primes)) * (rest.degree * q.bit_length()) ** 2 // 100_000)
    found = Fraction(q**rest.degree, q * q - 1)
    for P, residues in primes:
        quotient, remainder = divmod(rest, P)
        if remainder:
            reject("a prime that is given does not divide the discriminant, or is given twice")
        while not remainder:
            rest = quotient
            quotient, remainder = divmod(rest, P)
        symbol = _eichler_symbol(order, residues)
        size = residues.order
        found *= 1 - Fraction(1, size**2) if symbol == 0 else 1 + Fraction(symbol, size)
    if not is_one(rest):
        reject("the primes of the discriminant are not all given")
    return found


def _eichler_symbol(order: PolynomialLattice, residues: QuotientField[Hashable]) -> int:
    """Return the Eichler symbol: the symbol of the polynomial of some basis element with distinct roots, or
    0.
    """
    den = order.den * order.algebra.scale
    for row, (norm,) in zip(order.rows, order.norms, strict=True):
        t = residues.reduce((order.algebra.trace(row)[0] // den).coefficients)
        n = residues.reduce((norm // order.unit).coefficients)
        square = residues.mul(t, t)
        if not residues.is_zero(residues.add(square, residues.mul(residues.number(-4), n))):
            return -1 if residues.is_irreducible(t, n) else 1
    return 0
