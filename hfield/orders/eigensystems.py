"""Newforms of weight 2 with rational eigenvalues, and dimensions, from the Brandt matrices of Eichler orders.

Functions on the right ideal classes, invariant under the ideals of K, that are orthogonal to those of the
norm alone are the cusp forms of parallel weight 2 that are new at the primes of the algebra (Eichler; Jacquet
and Langlands; M. Kirschmer and J. Voight, 2010; L. Dembélé and J. Voight, "Explicit methods for Hilbert
modular forms", 2013). A newform of level m comes in level N as often as N/m has divisors, with the same
eigenvalues off N; by multiplicity one nothing else has the same. So what a system of rational eigenvalues has
more than the newforms of lower levels account for is, when it is one dimension, a newform of this level.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from math import prod
from typing import Any

import flint

from hfield.errors import LatticeError, UndecidedError

Exponents = tuple[int, ...]
MOST_PRIMES = 60
"""No more Hecke operators than this are used to tell newforms apart."""


@dataclass(frozen=True)
class Piece:
    """A space of functions on which some Hecke operators are numbers: a basis, in columns, and these."""

    basis: flint.fmpq_mat
    values: tuple[int, ...]

    @property
    def dimension(self) -> int:
        """How many forms there are in it."""
        return int(self.basis.ncols())

    def restricted(self, operator: flint.fmpq_mat) -> flint.fmpq_mat:
        """Return the matrix of an operator that maps the space into itself."""
        rows = flint.fmpq_mat(self.basis.transpose()).rref()[0].tolist()
        pivots = [next(k for k, c in enumerate(row) if c != 0) for row in rows]
        image, table = (operator * self.basis).tolist(), self.basis.tolist()
        chosen = flint.fmpq_mat([table[k] for k in pivots])
        return chosen.inv() * flint.fmpq_mat([image[k] for k in pivots])

    def split(self, operator: flint.fmpq_mat) -> Iterator[Piece]:
        """Yield the parts on which another operator is an integer too."""
        matrix = self.restricted(operator)
        one = flint.fmpq_mat(
            [[int(k == m) for m in range(self.dimension)] for k in range(self.dimension)]
        )
        for factor, _ in matrix.charpoly().numer().factor()[1]:
            if factor.degree() == 1:
                root = int(-factor[0])  # a root of a monic integral polynomial
                kernel, rank = (matrix - one * root).numer_denom()[0].nullspace()
                table = [row[: int(rank)] for row in kernel.tolist()]
                yield Piece(
                    self.basis * flint.fmpq_mat(flint.fmpz_mat(table)), (*self.values, root)
                )


@dataclass(frozen=True)
class Newform:
    """A newform with rational eigenvalues ``f[P]``; ``level``: pairs of a prime and an exponent."""

    module: Module
    piece: Piece
    by_prime: dict[Any, int]

    @property
    def signs(self) -> dict[Any, int]:
        """The signs of Atkin and Lehner at the primes of the level and of the discriminant."""
        return {self.module.shown(P): sign for P, sign in self.by_prime.items()}

    @property
    def level(self) -> Sequence[tuple[Any, int]]:
        """The level beside the discriminant of the algebra."""
        return self.module.level

    def __getitem__(self, prime: object) -> int:
        """Return the eigenvalue at a prime."""
        P = self.module.prime(prime)
        exponents = dict((*self.level, *((Q, 1) for Q in self.module.ramified)))
        if P in exponents:
            return -self.by_prime[P] if exponents[P] == 1 else 0
        return self._eigenvalue(P)

    def _eigenvalue(self, P: Any) -> int:
        total = _trace(self.piece.restricted(self.module.operator(P)))
        for form, times in self.module.old(self.piece):
            total -= times * form._eigenvalue(P)
        return total

    def eigenvalues(self, number: int) -> dict[Any, int]:
        """Return the eigenvalues at the first primes off the level and the discriminant."""
        primes = self.module.good_primes()
        several = [next(primes) for _ in range(number)]
        return {self.module.shown(P): self[P] for P in several}

    def named_eigenvalues(self, number: int) -> str:
        """Return the first eigenvalues as a text, such as ``a_2 = 1, a_5 = -2, …``."""
        return ", ".join([*(f"a_{P} = {a}" for P, a in self.eigenvalues(number).items()), "…"])

    def __repr__(self) -> str:
        return f"<newform {self.named_eigenvalues(5)}>"


class Module(ABC):
    """The functions on the classes of an Eichler order, modulo the ideals of the base field."""

    level: Sequence[tuple[Any, int]]
    """Pairs of a prime and its exponent in the level."""
    ramified: Sequence[Any]
    """The primes of the discriminant of the algebra."""
    weights: Sequence[flint.fmpq]
    """1/[units], of each point."""
    narrow: Sequence[int]
    """What the norm of each point is, modulo squares."""

    @abstractmethod
    def prime(self, given: object) -> Any:
        """Return a prime of the base field. Raises :class:`LatticeError`."""

    def shown(self, prime: Any) -> Any:
        """Return a prime as the base field has it."""
        return prime

    @abstractmethod
    def good_primes(self) -> Iterator[Any]:
        """Yield the primes that divide neither the level nor the discriminant."""

    @abstractmethod
    def operator(self, prime: Any) -> flint.fmpq_mat:
        """Return a Hecke operator on functions, in columns."""

    @abstractmethod
    def exchange(self, prime: Any) -> list[int]:
        """Return which point each becomes by the two-sided ideal at a prime."""

    @abstractmethod
    def lower(self, level: Sequence[tuple[Any, int]]) -> Module:
        """Return the module of another level, in the same algebra."""

    @cached_property
    def _lower(self) -> dict[Exponents, Module]:
        """The modules of the levels that divide this one, by exponents."""
        ranges = (range(e + 1) for _, e in self.level)
        whole = tuple(e for _, e in self.level)
        found: dict[Exponents, Module] = {}
        for exponents in product(*ranges):
            if exponents != whole:
                pairs = [(P, k) for (P, _), k in zip(self.level, exponents, strict=True) if k]
                found[exponents] = self.lower(pairs)
        return found

    @cached_property
    def cusp_dimension(self) -> int:
        """The dimension of the cusp forms of this level."""
        return len(self.weights) - len(set(self.narrow))

    @cached_property
    def new_dimension(self) -> int:
        """The dimension of the newforms: by inclusion and exclusion over the levels that divide this one."""
        total = self.cusp_dimension
        for exponents, module in self._lower.items():
            drops = [e - k for (_, e), k in zip(self.level, exponents, strict=True)]
            total += prod((1, -2, 1)[d] if d < 3 else 0 for d in drops) * module.cusp_dimension
        return total

    @cached_property
    def cusp_forms(self) -> Piece:
        """The functions that are orthogonal to those of the norm alone."""
        kinds = sorted(set(self.narrow))
        table = [
            [
                w if n == kind else flint.fmpq(0)
                for w, n in zip(self.weights, self.narrow, strict=True)
            ]
            for kind in kinds
        ]
        kernel, rank = flint.fmpq_mat(table).numer_denom()[0].nullspace()
        rows = [row[: int(rank)] for row in kernel.tolist()]
        return Piece(flint.fmpq_mat(flint.fmpz_mat(rows)), ())

    def old(self, piece: Piece) -> Iterator[tuple[Newform, int]]:
        """Yield the newforms of lower levels with the eigenvalues of a piece, and how often each is there."""
        primes = self._first(len(piece.values))
        for exponents, module in self._lower.items():
            times = prod(e - k + 1 for (_, e), k in zip(self.level, exponents, strict=True))
            for form in module.newforms:
                if all(form[P] == a for P, a in zip(primes, piece.values, strict=True)):
                    yield form, times

    def _first(self, number: int) -> list[Any]:
        primes = self.good_primes()
        return [next(primes) for _ in range(number)]

    @cached_property
    def newforms(self) -> list[Newform]:
        """The newforms of this level with rational eigenvalues. Raises :class:`UndecidedError`."""
        pieces = [self.cusp_forms] if self.new_dimension else []
        found: list[Newform] = []
        for count, P in enumerate(self.good_primes()):
            left = []
            for piece in pieces:
                new = piece.dimension - sum(times for _, times in self.old(piece))
                if count and new == 1:
                    found.append(self._newform(piece))
                elif new:
                    left.append(piece)
            if not left:
                return sorted(found, key=lambda form: form.piece.values)
            if count == MOST_PRIMES:
                break
            operator = self.operator(P)
            pieces = [part for piece in left for part in piece.split(operator)]
        raise UndecidedError(
            f"{MOST_PRIMES} Hecke operators do not tell the newforms of this level apart"
        )

    def _newform(self, piece: Piece) -> Newform:
        signs = {}
        old = list(self.old(piece))
        for Q, e in (*self.level, *((Q, 0) for Q in self.ramified)):
            moved = self.exchange(Q)
            size = range(len(moved))
            matrix = flint.fmpq_mat([[int(moved[i] == j) for j in size] for i in size])
            trace = _trace(piece.restricted(matrix))
            # W exchanges what comes from g by d with what comes by Qᶠ/d: in the middle it is the sign of g
            for form, times in old:
                drop = e - dict(form.level).get(Q, 0)
                if drop % 2 == 0:
                    trace -= (
                        times // (drop + 1) * (form.by_prime.get(Q, 1) if e else -form.by_prime[Q])
                    )
            if abs(trace) != 1:
                raise AssertionError("an involution is 1 or −1 on a newform")
            signs[Q] = trace if e else -trace
        return Newform(self, piece, signs)


class WithForms:
    """What class sets of Eichler orders say of cusp forms of parallel weight 2 and trivial character.

    Those of the level of the order that are new at the primes of the algebra. All raises
    :class:`LatticeError` for other orders.

    >>> from hfield import QuaternionAlgebra
    >>> C = QuaternionAlgebra(11).eichler_order(3).class_set(); C.cusp_dimension(), C.new_dimension()
    (3, 1)
    >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); P = A.ring.primes_above(31)[0]
    >>> f, = A.eichler_order([(P, 1)]).class_set().newforms(); f[2], f[A.ring.gen], f[3], f[7], f[P]
    (-3, -2, 2, 2, -1)
    """

    @property
    @abstractmethod
    def _forms(self) -> Module:
        """The functions on the classes as a module of Hecke operators."""

    def cusp_dimension(self) -> int:
        """Return the dimension of the cusp forms."""
        return self._forms.cusp_dimension

    def new_dimension(self) -> int:
        """Return the dimension of the newforms."""
        return self._forms.new_dimension

    def newforms(self) -> list[Newform]:
        """Return the newforms with rational eigenvalues: ``f[P]``, and ``f.signs``, of Atkin and Lehner.

        Raises :class:`UndecidedError` where many Hecke operators do not tell them apart.

        >>> from hfield import QuaternionAlgebra
        >>> f = QuaternionAlgebra(37).maximal_order().class_set().newforms()[0]; f, f.signs
        (<newform a_2 = -2, a_3 = -3, a_5 = -2, a_7 = -1, a_11 = -5, …>, {37: 1})
        """
        return self._forms.newforms


def _trace(matrix: flint.fmpq_mat) -> int:
    total = sum((matrix[k, k] for k in range(matrix.nrows())), flint.fmpq(0))
    assert total.q == 1, "eigenvalues are integral"
    return int(total.p)


def expect_eichler(is_eichler: bool) -> None:
    """Raise :class:`LatticeError` for an order whose forms have no level."""
    if not is_eichler:
        raise LatticeError(
            "newforms and their dimensions are for maximal and Eichler orders, and this is none"
        )
