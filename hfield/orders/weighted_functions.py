"""Forms of weight k > 2 as a module: functions on ideals with values in a representation of the quaternions.

Such a function f on right ideals satisfies f(γ·I) = γ·f(I). So its value at the representative I of a class
can be any value fixed by the units of the left order. (T_P·f)(I) is N(P)^(k/2−1) times the sum of f(J) over
the ideals J of relative norm P in I. See B. Gross, "Algebraic modular forms", 1999, and Dembélé and Voight
for Hilbert modular forms. Values and operators are computed modulo primes.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator

from flint import nmod_mat, nmod_poly

from hfield.core.properties import cached_property
from hfield.errors import LatticeError
from hfield.orders import brandt
from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.class_elements import ClassElements, Located
from hfield.orders.classes import Classes
from hfield.orders.eigensystems import Combination, Module
from hfield.orders.residues_modulo_primes import fixed_by, identity, lifted, pivots
from hfield.orders.symmetric_powers import SymmetricPower


class Reduction:
    """The values modulo p, and for each class a basis of the invariant values, in reduced echelon form."""

    def __init__(self, elements: ClassElements, weight: int, p: int) -> None:
        self.action = SymmetricPower(elements.classes.ambient, weight, p)
        one = identity(self.action.dimension, p)
        self.columns: list[nmod_mat] = []
        self.pivots: list[list[int]] = []
        self.starts = [0]
        for units in elements.units:
            basis = one
            for unit in units[1:]:
                basis = fixed_by(self.action.matrix(unit), basis)
            self.columns.append(basis.transpose())
            self.pivots.append(pivots(basis))
            self.starts.append(self.starts[-1] + basis.nrows())
        self.size = self.starts[-1]


class WeightedFunctions(Module):
    """Forms of an even weight k > 2: functions on the classes of an Eichler order with invariant values."""

    def __init__(self, classes: Classes, make: Callable[[BaseIdeal], Classes], weight: int) -> None:
        super().__init__(classes, make)
        if classes.order.algebra.ring.characteristic:
            raise LatticeError(
                f"forms of weight {weight} are for orders over number fields: over GF(q)[t] the weight is 2"
            )
        self.weight = weight
        self._elements = ClassElements(classes)
        self._reductions: dict[int, Reduction] = {}
        self._operators: dict[tuple[Prime, int], nmod_mat] = {}
        self._subspaces: dict[int, nmod_mat | None] = {}

    def of_classes(self, classes: Classes) -> WeightedFunctions:
        """Return the module of the classes of another level."""
        return WeightedFunctions(classes, self.make, self.weight)

    def suits(self, p: int) -> bool:
        """Return whether a prime splits completely in the field."""
        return self.classes.ambient.base.splits_completely(p)

    def _reduction(self, p: int) -> Reduction:
        if p not in self._reductions:
            self._reductions[p] = Reduction(self._elements, self.weight, p)
        return self._reductions[p]

    @cached_property
    def cusp_dimension(self) -> int:
        """The dimension of the cusp forms, which are all functions with trivial character."""
        p = next(self.primes())
        basis = self._trivial_character(p)
        return self._reduction(p).size if basis is None else int(basis.nrows())

    def norm_polynomial(self, T: Combination, p: int) -> nmod_poly:
        """Return 1, because no function of this weight factors through the norm."""
        return nmod_poly([1], p)

    # --- operators -----------------------------------------------------------------------------------

    def _blocks(self, located: Iterable[Located], p: int) -> Iterator[tuple[int, nmod_mat]]:
        """Yield, for each class j among located ideals γ·I_j, the sum of the matrices of γ, as columns."""
        reduction, sums = self._reduction(p), dict[int, nmod_mat]()
        for j, element in located:
            if reduction.pivots[j]:
                matrix = reduction.action.matrix(element)
                sums[j] = sums[j] + matrix if j in sums else matrix
        for j, matrix in sums.items():
            yield j, matrix * reduction.columns[j]

    def _operator(self, located: Callable[[int], Iterable[Located]], p: int) -> nmod_mat:
        """Return the operator f(I_i) ↦ Σ f(J), where J runs through the ideals that belong to each class."""
        reduction = self._reduction(p)
        size, starts = reduction.size, reduction.starts
        entries = [0] * (size * size)
        for i, kept in enumerate(reduction.pivots):
            for j, block in self._blocks(located(i), p) if kept else ():
                rows, width = block.tolist(), block.ncols()
                for n, k in enumerate(kept, starts[i]):
                    start = n * size + starts[j]
                    entries[start : start + width] = map(int, rows[k])
        return nmod_mat(size, size, entries, p)

    def _row(
        self, number: int, located: Callable[[int], Iterable[Located]], p: int
    ) -> dict[int, int]:
        """Return one row of the operator of :meth:`_operator`."""
        reduction = self._reduction(p)
        i = bisect_right(reduction.starts, number) - 1
        k = reduction.pivots[i][number - reduction.starts[i]]
        found: dict[int, int] = {}
        for j, block in self._blocks(located(i), p):
            found |= dict(enumerate(map(int, block.tolist()[k]), reduction.starts[j]))
        return found

    def _scale(self, prime: Prime) -> int:
        return int(self.absolute_norm(prime) ** (self.weight // 2 - 1))

    def _hecke_operator(self, prime: Prime, p: int) -> nmod_mat:
        """Return the Hecke operator at a prime on all functions."""
        if (prime, p) not in self._operators:
            found = self._operator(lambda i: self._elements.neighbours(i, prime), p)
            self._operators[prime, p] = found * self._scale(prime)
        return self._operators[prime, p]

    def row(self, prime: Prime, i: int, p: int) -> dict[int, int]:
        """Return row i of the Hecke operator at a prime."""
        scale = self._scale(prime)
        found = self._row(i, lambda i: self._elements.neighbours(i, prime), p)
        return {j: c * scale for j, c in found.items()}

    def exchange_row(self, prime: Prime, i: int, p: int) -> dict[int, int]:
        """Return row i of the operator of the two-sided ideal at a prime."""
        return self._row(i, lambda i: [self._elements.exchanged(i, prime)], p)

    def _central(self, ideal: BaseIdeal, p: int) -> nmod_mat:
        """Return the operator of an ideal of the base."""
        return self._operator(lambda i: [self._elements.multiplied(i, ideal)], p)

    def _trivial_character(self, p: int) -> nmod_mat | None:
        """Return a basis of the functions with trivial character, one per row; None if all
        functions have it.
        """
        if p not in self._subspaces:
            self._subspaces[p] = self._fixed(p) if self.base.class_generators else None
        return self._subspaces[p]

    def blocks(self, prime: Prime, p: int) -> list[nmod_mat]:
        """Return the Hecke operator at a prime on functions with trivial character."""
        matrix, basis = self._hecke_operator(prime, p), self._trivial_character(p)
        if basis is None:
            return [matrix]
        rows, size = (matrix * basis.transpose()).tolist(), basis.nrows()
        return [nmod_mat(size, size, [c for k in pivots(basis) for c in rows[k]], p)]

    def expanded(self, block: int, rows: nmod_mat, p: int) -> nmod_mat:
        """Return functions with trivial character as functions on the classes, one per row."""
        basis = self._trivial_character(p)
        return rows if basis is None else rows * basis

    def _fixed(self, p: int) -> nmod_mat:
        basis = identity(self._reduction(p).size, p)
        for ideal in self.base.class_generators:
            basis = fixed_by(self._central(ideal, p), basis)
        return basis

    # --- all characters --------------------------------------------------------------------------------

    def hecke_polynomial(self, norm: BaseIdeal) -> list[int]:
        """Return the characteristic polynomial of the Hecke operator of an ideal, on forms of any unramified
        character.

        The values have an invariant definite form, so every eigenvalue of T_P is at most the number of ideals
        of norm P, which is at most 2·N(P) + 1, times N(P)^(k/2−1). Raises :class:`LatticeError` if P divides
        the level and P² divides the norm.
        """
        factors = self.base.factorisation(norm)
        for P, e in factors:
            if e > 1 and P in dict(self.level):
                raise LatticeError(
                    f"the Hecke operator of {self.shown(P)}^{e} in weight {self.weight} is not computed, as "
                    "the prime divides the level: expected a norm that it divides once at most"
                )
        numbers = ((2 * self.absolute_norm(P) + 1) * self._scale(P) for P, _ in factors)
        bound = math.prod(n**e for n, (_, e) in zip(numbers, factors, strict=True))
        polynomials = ((p, self._all_characters(factors, p).charpoly()) for p in self.primes())
        residues = ((p, list(map(int, f.coeffs()))) for p, f in polynomials)
        return lifted(residues, (1 + bound) ** self._reduction(next(self.primes())).size)

    def _all_characters(self, factors: list[tuple[Prime, int]], p: int) -> nmod_mat:
        found = identity(self._reduction(p).size, p)
        for P, e in factors:
            step = self._hecke_operator(P, p)
            if P in self.ramified:
                found = found * step**e
                continue
            central = self._central(self.base.prime_ideal(P), p) if e > 1 else step
            weight = central * (self._scale(P) ** 2 * self.absolute_norm(P))
            found = found * brandt.of_power(step, weight, e)
        return found
