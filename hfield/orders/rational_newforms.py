"""Newforms with rational eigenvalues at large level, from the rows of one sparse Hecke operator.

The functions on the classes are split by their Atkin–Lehner signs at the primes of the discriminant and of
the level. For a squarefree level each system of eigenvalues occurs at most once in a space of given signs.
This includes oldforms: one from level M occurs with both signs at the primes of the level that do not divide
M.

In each space Lanczos' recurrence (:mod:`hfield.core.lanczos`) finds the eigenspaces of T_P for all rational
integers, as verified integer vectors, and proves that there are no others. Eigenspaces of dimension above 1
are split by other Hecke operators, of which only a few rows are computed.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from itertools import islice, product
from typing import TYPE_CHECKING

import numpy as np
from flint import fmpq_mat

from hfield.core.lanczos import (
    PRIME,
    BreakdownError,
    SparseOperator,
    echelon,
    eigenvectors,
    lifted,
    recurrence,
)
from hfield.core.progress import track
from hfield.core.properties import cached_property
from hfield.errors import LatticeError, UndecidedError
from hfield.orders.base_values import BaseIdeal, Prime
from hfield.orders.invariants import good_primes, is_eichler, level
from hfield.orders.lattice_values import discriminant
from hfield.orders.sign_spaces import SignSpace

if TYPE_CHECKING:
    from hfield.orders.base import Base
    from hfield.orders.classes import Classes

MAX_OPERATORS = 3
"""The number of Hecke operators that are tried before the rational eigenspaces are given up."""
MAX_STARTS = 8
"""The largest number of recurrences for one operator."""
MAX_SPLITTING_PRIMES = 30
"""No more Hecke operators than this are used to split an eigenspace, or to recognise an oldform."""


@dataclass(frozen=True, eq=False)
class RationalNewform:
    """A newform of weight 2 with rational eigenvalues, as a function on the ideal classes.

    ``f[P]`` is the eigenvalue at a prime. At a prime away from the level it takes one row of neighbours, that
    is, N(P) + 1 look-ups.
    """

    classes: Classes
    values: tuple[int, ...]
    """Its values on the classes, coprime integers."""
    by_prime: Mapping[Prime, int]

    @property
    def signs(self) -> dict[Prime, int]:
        """The Atkin–Lehner signs at the primes of the level and of the discriminant."""
        base = self.classes.ambient.base
        return {_shown(base, P): sign for P, sign in self.by_prime.items()}

    def __getitem__(self, prime: object) -> int:
        P = self.classes.ambient.base.prime(prime)
        return -self.by_prime[P] if P in self.by_prime else self._eigenvalue(P)

    @cached_property
    def _least(self) -> int:
        """The class with the nonzero value of least absolute value."""
        values = self.values
        return min((n for n, x in enumerate(values) if x), key=lambda n: abs(values[n]))

    def _eigenvalue(self, P: Prime) -> int:
        row = self.classes.neighbours_of(self._least, P)
        total = sum(times * self.values[n] for n, times in row.items())
        value, rest = divmod(total, self.values[self._least])
        assert not rest, "eigenvalues are integral"
        return value

    def eigenvalues(self, number: int) -> dict[Prime, int]:
        """Return the eigenvalues at the first primes that divide neither the level nor the discriminant."""
        primes = islice(good_primes(self.classes.order), number)
        return {_shown(self.classes.ambient.base, P): self[P] for P in primes}

    def __repr__(self) -> str:
        several = ", ".join(f"a_{P} = {a}" for P, a in self.eigenvalues(5).items())
        return f"<newform {several}, …>"


def rational_newforms(
    classes: Classes, make: Callable[[BaseIdeal], Classes], executor: Executor | None = None
) -> list[RationalNewform]:
    """Return all newforms of weight 2, rational eigenvalues, trivial character and a squarefree level.

    ``make`` returns the classes of another level. Raises :class:`LatticeError` for a level that is not
    squarefree, and :class:`UndecidedError` if the list is not proved to be complete.
    """
    order, base = classes.order, classes.ambient.base
    factors = base.factorisation(level(order))
    if not is_eichler(order) or any(e > 1 for _, e in factors):
        raise LatticeError(
            "rational_newforms() is for maximal orders and Eichler orders of squarefree level, and this is "
            "none; newforms() has those of any level"
        )
    primes = [P for P, _ in factors]
    old = [
        form
        for kept in product((False, True), repeat=len(primes))
        if not all(kept)
        for form in rational_newforms(
            make(
                math.prod(
                    (base.prime_ideal(P) for P, k in zip(primes, kept, strict=True) if k),
                    start=base.one,
                )
            ),
            make,
            executor,
        )
    ]
    return list(_new(classes, old, executor))


def _new(
    classes: Classes, old: Sequence[RationalNewform], executor: Executor | None
) -> Iterator[RationalNewform]:
    """Yield the newforms of the level, given those of lower levels."""
    order, ramified = classes.order, classes.ambient.ramified
    primes = [P for P, _ in classes.ambient.base.factorisation(discriminant(order))]
    choices = list(product((1, -1), repeat=len(primes)))
    for signs in track(choices, len(choices), "signs"):
        chosen = dict(zip(primes, signs, strict=True))
        space = SignSpace(classes, {P: -s if P in ramified else s for P, s in chosen.items()})
        found = [
            RationalNewform(classes, tuple(space.function(v).tolist()), chosen)
            for v in RationalSystems(space, executor).vectors()
        ]
        lower = [f for f in old if all(chosen[P] == s for P, s in f.by_prime.items())]
        for form in lower:
            found.remove(_recognised(form, found))
        yield from found


def _recognised(form: RationalNewform, found: Sequence[RationalNewform]) -> RationalNewform:
    """Return the function, among several, that has the eigenvalues of a newform of lower level."""
    if not found:
        raise AssertionError("an oldform is missing")
    for P in islice(good_primes(found[0].classes.order), MAX_SPLITTING_PRIMES):
        found = [f for f in found if f[P] == form[P]]
        if len(found) == 1:
            return found[0]
    raise UndecidedError(
        f"{MAX_SPLITTING_PRIMES} eigenvalues do not separate an oldform from newforms"
    )


class RationalSystems:
    """The rational systems of eigenvalues in a space of functions, one integer vector for each."""

    def __init__(self, space: SignSpace, executor: Executor | None = None) -> None:
        self.space, self.executor = space, executor
        self._rng = random.Random(1)

    def vectors(self) -> list[np.ndarray]:
        """Return the integer vectors, proved complete. Raises :class:`UndecidedError`."""
        if not len(self.space):
            return []
        classes = self.space.classes
        for P in islice(good_primes(classes.order), MAX_OPERATORS):
            operator = self.space.operator(classes.neighbours(P, self.executor))
            assert operator.is_self_adjoint(), "Hecke operators are self-adjoint"
            spaces = self._eigenspaces(operator, _bound(classes, P))
            if spaces is not None:
                return [v for some in spaces for v in self._split(some)]
        raise UndecidedError(
            f"{MAX_OPERATORS} Hecke operators do not prove that there are no more rational newforms: "
            "one with repeated irrational eigenvalues, or large values, hides them"
        )

    def _eigenspaces(self, operator: SparseOperator, bound: int) -> list[list[np.ndarray]] | None:
        """Return bases of the eigenspaces for the integers up to a bound, or None if they are not proved."""
        residues: dict[int, list[np.ndarray]] = {}
        for _ in range(MAX_STARTS):
            start = np.array([self._rng.randrange(PRIME) for _ in range(operator.size)])
            try:
                found = recurrence(operator, start)
            except BreakdownError:
                continue
            roots = [a for a in range(-bound, bound + 1) if not found.polynomials(a)[-1]]
            rest = operator.size - len(found)
            before = sum(map(len, residues.values()))
            for a, vector in zip(roots, eigenvectors(operator, start, found, roots), strict=True):
                residues[a] = echelon([*residues.get(a, []), vector])[0]
            dimension = sum(map(len, residues.values()))
            if dimension == len(roots) + rest:  # the bound is reached
                spaces = [
                    [lifted(operator, v, a) for v in vectors] for a, vectors in residues.items()
                ]
                whole = [[v for v in some if v is not None] for some in spaces]
                return whole if sum(map(len, whole)) == dimension else None
            if dimension == before:
                return None
        return None

    def _split(self, basis: list[np.ndarray]) -> Iterator[np.ndarray]:
        """Yield the vectors in an eigenspace that are eigenvectors of all Hecke operators."""
        spaces = [basis]
        for P in islice(good_primes(self.space.classes.order), MAX_SPLITTING_PRIMES):
            for some in spaces:
                if len(some) == 1:
                    yield from some
            spaces = [part for some in spaces if len(some) > 1 for part in self._parts(some, P)]
            if not spaces:
                return
        raise UndecidedError(
            f"{MAX_SPLITTING_PRIMES} Hecke operators do not split a space of {len(spaces[0])} rational "
            "functions"
        )

    def _parts(self, basis: list[np.ndarray], P: Prime) -> Iterator[list[np.ndarray]]:
        """Yield bases of the rational eigenspaces of the Hecke operator of a prime in a space."""
        space, size = self.space, len(basis)
        _, pivots = echelon(basis)
        here = fmpq_mat([[int(v[k]) for k in pivots] for v in basis])
        images = []
        for k in pivots:
            row = space.classes.neighbours_of(space.first[k], P)
            terms = [(space.orbit[n], int(space.sign[n]) * times) for n, times in row.items()]
            images.append([sum(int(v[m]) * t for m, t in terms) for v in basis])
        # the rows of the basis times this are their images
        matrix = fmpq_mat(images).transpose() * here.inv()
        bound = _bound(space.classes, P)
        one = fmpq_mat([[int(k == m) for m in range(size)] for k in range(size)])
        for a in range(-bound, bound + 1):
            kernel, rank = (matrix - one * a).transpose().numer_denom()[0].nullspace()
            columns = kernel.transpose().tolist()[: int(rank)]
            if columns:
                yield [
                    _primitive(
                        sum(
                            (
                                np.array(v, dtype=object) * int(c)
                                for v, c in zip(basis, x, strict=True)
                            ),
                            np.zeros(len(basis[0]), dtype=object),
                        )
                    )
                    for x in columns
                ]


def _shown(base: Base, prime: Prime) -> Prime:
    """Return a prime as an object of the base field."""
    above = base.primes_above(base.place(prime).below)
    return next(P for P, Q in above if prime == Q)


def _primitive(vector: np.ndarray) -> np.ndarray:
    """Return an integer vector divided by its content."""
    content: int = math.gcd(*map(int, vector))
    found: np.ndarray = (vector // content).astype("int64")
    return found


def _bound(classes: Classes, P: Prime) -> int:
    """Return the largest integer of absolute value at most 2√N(P)."""
    base = classes.ambient.base
    return math.isqrt(4 * base.absolute_norm(base.prime_ideal(P)))
