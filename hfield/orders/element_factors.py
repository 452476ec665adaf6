"""Factor an element of an order into a unit and elements of prime norms, for a given sequence of primes.

A last factor π of norm P generates a left ideal of norm P that contains x. If x is not in P·O and P does not
divide the discriminant, O·x + P·O is the only such ideal. So the factors of a primitive element are unique up
to units between them (Conway and Smith, *On Quaternions and Octonions*, chapter 5). In all other cases every
ideal of norm P that contains x is tried.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import chain
from typing import NamedTuple

from hfield.algebra.quaternion import Quaternion
from hfield.errors import (
    CoercionError,
    LatticeError,
    MixedParentsError,
    NotationError,
    UndecidedError,
    shorten,
)
from hfield.orders.base_values import BaseIdeal, BaseNumber, Prime
from hfield.orders.equivalence import equivalence
from hfield.orders.ideals_of_norm import ideals_of_norm, random_ideal
from hfield.orders.lattice_values import (
    LatticeValue,
    add,
    conjugate,
    contains,
    discriminant,
    generated_ideal,
    includes,
    is_locally_principal,
    times_ideal,
)
from hfield.orders.units import units
from hfield.orders.validation import listed

MAX_IDEALS_TRIED = 10_000


class GivenPrime(NamedTuple):
    """A prime of the base: as an object of the base, as an ideal, and as the given number, if any."""

    prime: Prime
    ideal: BaseIdeal
    number: BaseNumber | None


def factor(order: LatticeValue, x: object, primes: object) -> tuple[Quaternion, list[Quaternion]]:
    """Return x = u·π₁⋯πₙ with a unit u and factors whose norms generate the given primes.

    Raises :class:`LatticeError` if x is not in the order, if norms do not match, or if an ideal that a factor
    would generate is not principal, and :class:`UndecidedError`.
    """
    algebra, base = order.algebra, order.ambient.base
    element = algebra(x)
    if not contains(order, element):
        raise LatticeError(
            f"{shorten(element)} does not lie in the order: expected an element of it"
        )
    given = [_read_prime(order, p) for p in listed(primes)]
    product = base.one
    for p in given:
        product = product * p.ideal
    norm = element.norm()
    found = base.principal(base.inside(norm)) if norm != 0 else None
    if found != product:
        raise LatticeError(
            f"the norm {algebra.ring.text(norm)} of {shorten(element)} does not generate the product "
            f"{base.ideal_text(product)} of the given primes: expected the primes of the norm, each as often "
            "as it occurs"
        )
    return _FactorSearch(order, given).run(element)


def _read_prime(order: LatticeValue, p: object) -> GivenPrime:
    """Read a prime given as an ideal or as a generator."""
    base = order.ambient.base
    prime = base.prime(p)
    number = None
    if not base.is_ideal(p):
        with suppress(CoercionError, MixedParentsError, NotationError):  # the text of an ideal
            number = base.inside(base.ring(p))
    return GivenPrime(prime, base.prime_ideal(prime), number)


class _FactorSearch:
    """A search for the factors from last to first; if several ideals contain an element, all are tried."""

    def __init__(self, order: LatticeValue, primes: Sequence[GivenPrime]) -> None:
        self.order, self.primes = order, primes
        self.base = order.ambient.base
        self.tried = 0
        self.failure = ""
        self._ideals: dict[Prime, list[LatticeValue]] = {}

    def run(self, x: Quaternion) -> tuple[Quaternion, list[Quaternion]]:
        """Return the unit and the factors. Raises :class:`LatticeError` if there are none."""
        left: list[Quaternion] = [x]
        factors: list[Quaternion] = []
        choices: list[Iterator[Quaternion]] = []
        while len(factors) < len(self.primes):
            if len(choices) == len(factors):
                choices.append(self._last_factors(left[-1], len(self.primes) - len(factors)))
            pi = next(choices[-1], None)
            if pi is not None:
                factors.append(pi)
                left.append(left[-1] * pi.inverse())
                continue
            choices.pop()
            if not choices:
                raise LatticeError(self.failure)
            factors.pop()
            left.pop()
        return left[-1], factors[::-1]

    def _last_factors(self, x: Quaternion, number: int) -> Iterator[Quaternion]:
        """Yield the possible last factors of x; ``number`` factors remain to be found."""
        p = self.primes[number - 1]
        for ideal in self._ideals_with(x, p):
            self.tried += 1
            if self.tried > MAX_IDEALS_TRIED:
                raise UndecidedError(
                    f"{MAX_IDEALS_TRIED} ideals were tried, and no factorisation was found: {self.failure}"
                )
            answer = equivalence(self.order, ideal, self.order, "left")
            if not answer:
                self.failure = self.failure or (
                    f"the left ideal of norm {p.prime} that contains {shorten(x)}, for factor {number}, is "
                    f"not principal: {answer.reason}"
                )
            elif answer.element is None:
                raise UndecidedError(f"factor {number} was not found: {answer.reason}")
            else:
                yield self._with_norm(answer.element, p)

    def _ideals_with(self, x: Quaternion, p: GivenPrime) -> Iterator[LatticeValue]:
        """Yield the invertible left ideals of norm P that contain x."""
        multiples = times_ideal(self.order, p.ideal)
        ideal = add(multiples, generated_ideal(self.order, [x], "left"))
        if ideal.norm == p.ideal and is_locally_principal(ideal, self.order):
            yield ideal
            return
        candidates: Iterator[LatticeValue] = self._ideals_of_norm(p)
        if ideal == multiples and not self.base.valuation(discriminant(self.order), p.prime):
            first = random_ideal(self.order, p.ideal, random.Random(0))
            candidates = chain([first], (J for J in candidates if first != J))
        yield from (J for J in candidates if includes(J, ideal))

    def _ideals_of_norm(self, p: GivenPrime) -> Iterator[LatticeValue]:
        if p.prime not in self._ideals:
            self._ideals[p.prime] = list(map(conjugate, ideals_of_norm(self.order, p.ideal)))
        yield from self._ideals[p.prime]

    def _with_norm(self, pi: Quaternion, p: GivenPrime) -> Quaternion:
        """Return π times a unit such that its norm is the given number, if the units allow this."""
        base = self.base
        if p.number is None or not base.is_totally_positive(p.number):
            return pi
        wanted = base.outside(p.number) / pi.norm()
        if not self.order.ambient.definite:
            root = base.square_root(base.inside(wanted))
            return pi if root is None else pi * root
        for u in units(self.order):
            root = base.square_root(base.inside(wanted / u.norm()))
            if root is not None:
                adjusted: Quaternion = u * pi * root
                return adjusted
        return pi
