"""Systems of eigenvalues of Hecke operators on cusp forms, split over ℚ into Galois orbits of newforms.

Consider the functions on the right ideal classes of an Eichler order that are invariant under the ideals of
K. They are the modular forms of its level that are new at the primes of the algebra. In weight 2 the
functions that factor through the norm are not cusp forms (Eichler; Jacquet and Langlands; M. Kirschmer and J.
Voight, 2010; L. Dembélé and J. Voight, "Explicit methods for Hilbert modular forms", 2013).

A newform of level m has one copy in level N for each divisor of N/m, with the same eigenvalues at primes that
do not divide N. So the characteristic polynomial of a Hecke operator on the new subspace of level N is the
polynomial on all functions divided by those of the copies from proper divisors of N. It is computed modulo
primes of 62 bits. Deligne's bound for the eigenvalues gives a bound for its coefficients, so finitely many
primes prove it.

Let T be a combination of Hecke operators whose polynomial on the new subspace has no multiple root, and no
root in common with those of lower levels. Such a T exists by multiplicity one. Then each irreducible factor g
of degree d is a Galois orbit of d newforms, with eigenvalues in ℚ[x]/(g).
"""

from __future__ import annotations

import math
import random
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from functools import reduce
from itertools import count, product, takewhile
from operator import add
from typing import NamedTuple

from flint import fmpz_poly, nmod_mat, nmod_poly

from hfield.core.primality import is_prime
from hfield.core.properties import cached_property
from hfield.errors import LatticeError, UndecidedError
from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.classes import Classes
from hfield.orders.invariants import good_primes, is_eichler, level
from hfield.orders.newforms import Newform
from hfield.orders.residues_modulo_primes import lifted
from hfield.orders.validation import weight as checked_weight

Level = tuple[tuple[Prime, int], ...]
MAX_PRIMES = 60
"""No more Hecke operators than this are combined to separate newforms."""
COMBINATIONS = 3
"""So many combinations of the same Hecke operators are tried."""
LARGEST = 2**62


class Combination(NamedTuple):
    """A combination of Hecke operators at good primes with small integer coefficients."""

    primes: tuple[Prime, ...]
    coefficients: tuple[int, ...]


class Module(ABC):
    """Functions on the classes of an Eichler order, with operators as matrices modulo primes p.

    An operator acts on columns. A row of it is a dict of its nonzero entries. ``make`` returns the classes of
    another level. Raises :class:`LatticeError` for an order that is not Eichler.
    """

    weight: int

    def __init__(self, classes: Classes, make: Callable[[BaseIdeal], Classes]) -> None:
        self.classes, self.make = classes, make
        order = classes.order
        if not is_eichler(order):
            raise LatticeError(
                "newforms and their dimensions are computed for maximal and Eichler orders, and this order "
                "is neither"
            )
        self.base = base = order.ambient.base
        self.level: Level = tuple(base.factorisation(level(order)))
        """Pairs of a prime and its exponent in the level."""
        self.ramified: tuple[Prime, ...] = order.ambient.ramified
        """The primes of the discriminant of the algebra."""
        self._family: dict[Level, Module] = {self.level: self}
        """The modules of the levels that divide one, which they have in common."""
        self._primes: list[int] = []
        self._new: dict[tuple[Combination, int], nmod_poly] = {}
        self._orbits: dict[tuple[Combination, int, int], nmod_mat] = {}
        self._known_polynomials: dict[tuple[Combination, int], list[nmod_poly]] = {}

    # --- primes of the base --------------------------------------------------------------------------

    def prime(self, given: object) -> Prime:
        """Return a prime of the base. Raises :class:`LatticeError`."""
        found: Prime = self.base.prime(given)
        return found

    def shown(self, prime: Prime) -> object:
        """Return a prime as an object of the base field."""
        p = self.base.place(prime).below
        return next(P for P, Q in self.base.primes_above(p) if prime == Q)

    def absolute_norm(self, prime: Prime) -> int:
        """Return the number of residues modulo a prime."""
        return self.base.absolute_norm(self.base.prime_ideal(prime))

    def good_primes(self) -> Iterator[Prime]:
        """Yield the primes that divide neither the level nor the discriminant."""
        return good_primes(self.classes.order)

    def primes_up_to(self, norm: int) -> list[Prime]:
        """Return all primes of norm up to a bound, in order of norm."""
        return list(takewhile(lambda P: self.absolute_norm(P) <= norm, self.base.primes_by_norm()))

    @property
    def has_expansions(self) -> bool:
        """Whether the field is ℚ, so that forms have q-expansions."""
        return self.base.degree == 1 and not self.classes.order.algebra.ring.characteristic

    def expect_rational(self) -> None:
        """Raise :class:`LatticeError` over a field other than ℚ."""
        if not self.has_expansions:
            raise LatticeError(
                "q-expansions are for forms over QQ: over other fields eigenvalue(P) belongs to a prime P"
            )

    # --- what a module of one weight has ---------------------------------------------------------------

    @property
    @abstractmethod
    def cusp_dimension(self) -> int:
        """The dimension of the cusp forms of this level."""

    @abstractmethod
    def of_classes(self, classes: Classes) -> Module:
        """Return the module of the same weight for the classes of another level."""

    @abstractmethod
    def suits(self, p: int) -> bool:
        """Return whether the module has a reduction modulo p."""

    @abstractmethod
    def blocks(self, prime: Prime, p: int) -> list[nmod_mat]:
        """Return the Hecke operator at a good prime on subspaces that all good Hecke operators preserve.

        Their sum is the space of functions with trivial character.
        """

    @abstractmethod
    def expanded(self, block: int, rows: nmod_mat, p: int) -> nmod_mat:
        """Return elements of such a subspace as functions, one per row."""

    @abstractmethod
    def row(self, prime: Prime, i: int, p: int) -> dict[int, int]:
        """Return row i of the Hecke operator at a prime."""

    @abstractmethod
    def exchange_row(self, prime: Prime, i: int, p: int) -> dict[int, int]:
        """Return row i of the operator of the two-sided ideal at a prime of the level or the discriminant."""

    @abstractmethod
    def norm_polynomial(self, T: Combination, p: int) -> nmod_poly:
        """Return the characteristic polynomial of T on functions that factor through the norm."""

    # --- levels that divide this one -----------------------------------------------------------------

    @cached_property
    def _lower(self) -> list[tuple[Module, int, int]]:
        """The modules of lower levels, with multiplicities of their newforms here and signs in the
        new part.
        """
        found = []
        for exponents in product(*(range(e + 1) for _, e in self.level)):
            drops = [e - k for (_, e), k in zip(self.level, exponents, strict=True)]
            if any(drops):
                pairs = zip(self.level, exponents, strict=True)
                level = tuple((P, k) for (P, _), k in pairs if k)
                sign = math.prod((1, -2, 1)[d] if d < 3 else 0 for d in drops)
                found.append((self._at(level), math.prod(d + 1 for d in drops), sign))
        return found

    def _at(self, level: Level) -> Module:
        if level not in self._family:
            primes = (self.base.prime_ideal(P) ** e for P, e in level)
            classes = self.make(math.prod(primes, start=self.base.one))
            self._family[level] = found = self.of_classes(classes)
            found._family = self._family
        return self._family[level]

    @cached_property
    def new_dimension(self) -> int:
        """The dimension of the new subspace, by inclusion and exclusion over the levels that divide
        this one.
        """
        rest = sum(sign * module.cusp_dimension for module, _, sign in self._lower)
        return self.cusp_dimension + rest

    # --- polynomials ---------------------------------------------------------------------------------

    def primes(self) -> Iterator[int]:
        """Yield primes below 2⁶² modulo which the module has a reduction."""
        for n in count():
            if n == len(self._primes):
                last = self._primes[-1] if n else LARGEST + 1
                odd = range(last - 2, 2, -2)
                self._primes.append(next(p for p in odd if is_prime(p) and self.suits(p)))
            yield self._primes[n]

    def bound(self, prime: Prime) -> int:
        """Return Deligne's bound for the absolute values of the eigenvalues at a good prime."""
        return math.isqrt(4 * self.absolute_norm(prime) ** (self.weight - 1)) + 1

    def radius(self, T: Combination) -> int:
        """Return a bound for the absolute values of the eigenvalues of a combination."""
        return sum(abs(c) * self.bound(P) for P, c in zip(*T, strict=True))

    def _combined(self, T: Combination, p: int) -> list[nmod_mat]:
        """Return a combination of Hecke operators, block by block."""
        terms = ([m * c for m in self.blocks(P, p)] for P, c in zip(*T, strict=True))
        return [reduce(add, several) for several in zip(*terms, strict=True)]

    def _polynomials(self, T: Combination, p: int) -> list[nmod_poly]:
        """Return the characteristic polynomials, block by block."""
        if (T, p) not in self._known_polynomials:
            self._known_polynomials[T, p] = [m.charpoly() for m in self._combined(T, p)]
        return self._known_polynomials[T, p]

    def _new_polynomial(self, T: Combination, p: int) -> nmod_poly:
        """Return the characteristic polynomial on the new subspace."""
        if (T, p) not in self._new:
            found = math.prod(self._polynomials(T, p), start=nmod_poly([1], p))
            found = _quotient(found, self.norm_polynomial(T, p))
            for module, times, _ in self._lower:
                found = _quotient(found, module._new_polynomial(T, p) ** times)
            self._new[T, p] = found
        return self._new[T, p]

    def _lower_polynomial(self, T: Combination, p: int) -> nmod_poly:
        """Return a polynomial with all eigenvalues of oldforms as roots."""
        factors = (module._new_polynomial(T, p) for module, _, _ in self._lower)
        return math.prod(factors, start=self.norm_polynomial(T, p))

    def _orbit(self, T: Combination, p: int, block: int) -> nmod_mat:
        """Return the rows v, T·v, T²·v, … for a random v in a block, one for each eigenvalue in the block."""
        if (T, p, block) not in self._orbits:
            matrix, rng = self._combined(T, p)[block], random.Random(1)
            size = matrix.nrows()
            v = nmod_mat(size, 1, [rng.randrange(p) for _ in range(size)], p)
            entries, number = [], self._annihilator(T, p, block).degree()
            for _ in range(number):
                entries += v.entries()
                v = matrix * v
            self._orbits[T, p, block] = nmod_mat(number, size, entries, p)
        return self._orbits[T, p, block]

    def _annihilator(self, T: Combination, p: int, block: int) -> nmod_poly:
        """Return a polynomial f with f(T) = 0 on a block; T is semisimple, so all eigenvalues are roots."""
        whole = self._lower_polynomial(T, p) * self._new_polynomial(T, p)
        return whole.gcd(self._polynomials(T, p)[block])

    def eigenvectors(self, T: Combination, g: fmpz_poly, p: int) -> nmod_mat | None:
        """Return the eigenvector of T for the root x of g modulo p; column j is a polynomial in x.

        The result is None if g and another factor have a common root modulo p.
        """
        factor = nmod_poly(g.coeffs(), p)
        rest = _quotient(self._lower_polynomial(T, p) * self._new_polynomial(T, p), factor)
        if factor.gcd(rest).degree():
            return None
        polynomials = self._polynomials(T, p)
        block = next(n for n, f in enumerate(polynomials) if not f % factor)
        rest = _quotient(self._annihilator(T, p, block), factor)
        orbit = self._orbit(T, p, block)
        rows = []
        for m in range(factor.degree()):
            # (g(T) − g(x))/(T − x) = Σ xᵐ·(g_(m+1) + g_(m+2)·T + …)
            coefficients = (factor.right_shift(m + 1) * rest).coeffs()
            rows.append(coefficients + [0] * (orbit.nrows() - len(coefficients)))
        return self.expanded(block, nmod_mat(rows, p) * orbit, p)

    # --- newforms --------------------------------------------------------------------------------------

    @cached_property
    def newforms(self) -> list[Newform]:
        """The Galois orbits of newforms of this level. Raises :class:`UndecidedError`."""
        if not self.new_dimension:
            return []
        for T in self._combinations():
            g = self._separated(T)
            if g is not None:
                factors = (f if f[f.degree()] > 0 else -f for f, _ in g.factor()[1])
                return sorted((Newform(self, T, f) for f in factors), key=Traces)
        raise UndecidedError(
            f"{MAX_PRIMES} Hecke operators do not separate the newforms of this level"
        )

    def _combinations(self) -> Iterator[Combination]:
        """Yield combinations of increasingly many Hecke operators."""
        rng, several = random.Random(1), list[Prime]()
        for P in self.good_primes():
            several.append(P)
            for k in range(COMBINATIONS if len(several) > 1 else 1):
                numbers = (
                    rng.choice((-2, -1, 1, 2)) if k else (-1) ** n for n, _ in enumerate(several)
                )
                yield Combination(tuple(several), tuple(numbers))
            if len(several) == MAX_PRIMES:
                return

    def _separated(self, T: Combination) -> fmpz_poly | None:
        """Return the characteristic polynomial of T on the new subspace, or None if T does not separate the
        newforms.
        """
        degree = self.new_dimension
        p = next(self.primes())
        found = self._new_polynomial(T, p)
        if found.degree() != degree:
            raise AssertionError("the dimensions of newforms do not add up")
        others = self._lower_polynomial(T, p)
        if found.gcd(found.derivative()).degree() or found.gcd(others).degree():
            return None
        several = ((q, list(map(int, self._new_polynomial(T, q).coeffs()))) for q in self.primes())
        return fmpz_poly(lifted(several, (1 + self.radius(T)) ** degree))


class Traces:
    """A sort key of Galois orbits: the degree, then the traces, which differ between orbits."""

    def __init__(self, form: Newform) -> None:
        self.form = form

    def __lt__(self, other: Traces) -> bool:
        mine, its = self.form, other.form
        if mine.degree != its.degree:
            return mine.degree < its.degree
        pairs = zip(mine.traces(), its.traces(), strict=False)
        return next(a < b for a, b in pairs if a != b)


def _quotient(f: nmod_poly, g: nmod_poly) -> nmod_poly:
    found, rest = divmod(f, g)
    if rest:
        raise AssertionError("the eigenvalues of lower levels must occur in this level")
    return found


class WithForms(ABC):
    """Methods of class sets of Eichler orders for cusp forms of parallel weight and trivial character.

    The forms have the level of the order and are new at the primes of the algebra. The weight is an even
    number. All methods raise :class:`LatticeError` for other orders and weights.

    >>> from hfield import QuaternionAlgebra
    >>> C = QuaternionAlgebra(11).eichler_order(3).class_set(); C.cusp_dimension(), C.new_dimension()
    (3, 1)
    >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); P = A.ring.primes_above(31)[0]
    >>> f, = A.eichler_order([(P, 1)]).class_set().newforms(); f[2], f[A.ring.gen], f[3], f[7], f[P]
    (-3, -2, 2, 2, -1)
    """

    @abstractmethod
    def _functions(self, weight: int) -> Module:
        """Return the module of functions on the classes with its Hecke operators, for an even weight."""

    def cusp_dimension(self, weight: int = 2) -> int:
        """Return the dimension of the cusp forms.

        >>> from hfield import QuaternionAlgebra
        >>> QuaternionAlgebra(11).maximal_order().class_set().cusp_dimension(weight=4)
        2
        """
        return self._functions(checked_weight(weight)).cusp_dimension

    def new_dimension(self, weight: int = 2) -> int:
        """Return the dimension of the newforms."""
        return self._functions(checked_weight(weight)).new_dimension

    def newforms(self, weight: int = 2) -> list[Newform]:
        """Return the Galois orbits of newforms, those with rational eigenvalues first.

        They are ordered by degree, then by the traces of coefficients. Raises :class:`UndecidedError` if many
        Hecke operators do not separate them.

        >>> from hfield import QuaternionAlgebra
        >>> f = QuaternionAlgebra(37).maximal_order().class_set().newforms()[0]; f, f.signs
        (<newform a_2 = -2, a_3 = -3, a_5 = -2, a_7 = -1, a_11 = -5, …>, {37: 1})
        >>> f, = QuaternionAlgebra(23).maximal_order().class_set().newforms(); f.degree, f.field
        (2, QQ[s]/(s^2-s-1))
        >>> f.eigenvalue(2), f.minimal_polynomial(2), f.eigenvalue(23)
        (-1+s, [-1, 1, 1], 1)
        >>> [f.degree for f in QuaternionAlgebra(5).maximal_order().class_set().newforms(weight=12)]
        [1, 2]
        """
        return list(self._functions(checked_weight(weight)).newforms)
