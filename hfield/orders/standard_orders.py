"""Standard orders of an algebra: maximal, Eichler, p-extremal, Lipschitz and Hurwitz orders.

A p-extremal order is a maximal order of ``(−q, −p | ℚ)`` that contains i and j, for a small q. For a prime
q > 2 there are two such orders up to isomorphism (Ibukiyama, *Nagoya Math. J.* 88, 1982; Pizer, 1980,
proposition 5.2; Kohel, Lauter, Petit and Tignol, 2014, section 2.3).
"""

from __future__ import annotations

from functools import lru_cache

from flint import fmpz_mat

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.core.product import Constants
from hfield.errors import CoercionError, LatticeError, shorten
from hfield.fields.rationals.places import INFINITE
from hfield.fields.rationals.symbols import ramified_places_q
from hfield.fields.rationals.whole_numbers import fraction
from hfield.orders import mass_formula
from hfield.orders.base import Base
from hfield.orders.base_values import BaseIdeal
from hfield.orders.basis import basis_of
from hfield.orders.generated_orders import generated
from hfield.orders.lattice_values import LatticeValue, discriminant, hermite_form
from hfield.orders.linear_algebra_mod_p import kronecker
from hfield.orders.maximal_orders import eichler_suborder, overorder
from hfield.orders.validation import expect_coprime, expect_rational, positive


def maximal_order(algebra: Parent) -> LatticeValue:
    """Return a maximal order over the integers of the base field; always the same one.

    Raises :class:`UndecidedError` or :class:`UnfactoredError` if the constants, norms or the discriminant of
    the field cannot be factored.
    """
    ambient = basis_of(algebra)
    start = hermite_form(ambient, *ambient.kernels.first_order(ambient))
    found = overorder(start)
    if discriminant(found) != ambient.discriminant:
        raise AssertionError("a maximal order has the discriminant of its algebra")
    return found


def eichler_order(algebra: Parent, level: object) -> LatticeValue:
    """Return an Eichler order whose level is prime to the discriminant of the algebra; always the same one.

    The level is a number, an ideal of the base, or pairs (prime, exponent). Raises :class:`LatticeError`.
    """
    base = basis_of(algebra).base
    ideal = read_level(base, level)
    common = [P for P, _ in base.factorisation(ideal) if P in basis_of(algebra).ramified]
    if common:
        raise LatticeError(
            f"the level {base.ideal_text(ideal)} and the discriminant of {shorten(algebra)} have the prime "
            f"{common[0]} in common: Eichler orders have a level prime to the discriminant"
        )
    order = _maximal(algebra)
    return order if ideal == 1 else eichler_suborder(order, ideal)


def read_level(base: Base, level: object) -> BaseIdeal:
    """Return an integral ideal given as an ideal, a number, or pairs. Raises :class:`LatticeError`."""
    if not isinstance(level, list | tuple) or not all(isinstance(x, tuple | list) for x in level):
        given: BaseIdeal = base.integral_ideal(level, "level")
        return given
    found: BaseIdeal = base.one
    for pair in level:
        if len(pair) != 2 or not isinstance(pair[1], int) or pair[1] < 0:
            raise LatticeError(
                f"{shorten(pair)} is not a pair of a prime ideal and an exponent ≥ 0"
            )
        found = found * base.prime_ideal(base.prime(pair[0])) ** pair[1]
    return found


def lipschitz_order(algebra: Parent) -> LatticeValue:
    """Return the order of integer combinations of e, i, j, k.

    Raises :class:`CoercionError` unless a, t and b are integers.
    """
    ambient = basis_of(algebra)
    if ambient.degree > 1 or not ambient.base.real_places:
        raise CoercionError(
            f"the Lipschitz order is ℤ⟨e, i, j, k⟩, over QQ, not over {shorten(algebra.ring.name)}: "
            'A.order(["i", "j"]) is the ring that i and j generate'
        )
    constants = Constants(*map(fraction, ambient.constants))
    if any(x.denominator != 1 for x in constants):
        raise CoercionError(
            "e, i, j, k span an order over the integers only if a, t and b are integers"
        )
    return LatticeValue(
        basis_of(algebra), 1, fmpz_mat([[int(m == n) for n in range(4)] for m in range(4)])
    )


def hurwitz_order(algebra: Parent) -> LatticeValue:
    """Return the Hurwitz order. Raises :class:`CoercionError` except in (−1,−1|ℚ)."""
    a, t, b = basis_of(algebra).constants
    if not (a == -1 and t == 0 and b == -1):
        raise CoercionError(f"the Hurwitz order belongs to (-1,-1|QQ), not to {algebra}")
    rows = [[1, 1, 1, 1], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 2]]
    return LatticeValue(basis_of(algebra), 2, fmpz_mat(rows))


def class_number(algebra: Parent, level: object) -> int:
    """Return the number of ideal classes of an Eichler order of the given level."""
    n = positive(level, "level")
    r = basis_of(algebra)
    discriminant = int(fraction(r.discriminant))
    if r.definite:
        return mass_formula.class_number(discriminant, n)
    expect_coprime(n, discriminant)
    return 1  # strong approximation


@lru_cache(maxsize=64)
def _maximal(algebra: Parent) -> LatticeValue:
    return maximal_order(algebra)


def quadratic_part(p: int) -> int:
    """Return q = 1, 2 or the least q ≡ 3 modulo 4 such that ``(−q, −p | ℚ)`` ramifies exactly at p and ∞.

    This q is a prime: for every such q, one of its prime factors that are 3 modulo 4 has the same property.
    """
    if p == 2 or p % 4 == 3:
        return 1
    if p % 8 == 5:
        return 2
    q = 3
    while not (is_prime(q) and kronecker(p, q) == -1):
        q += 4
    return q


def extremal_order(algebra: Parent, q: object = None) -> LatticeValue:
    """Return a maximal order with anticommuting roots of −q and −p, in a definite algebra of discriminant p.

    Raises :class:`LatticeError` for another algebra, and if there is no such order.
    """
    r = basis_of(algebra)
    error = LatticeError(
        f"{algebra} has no p-extremal order: expected a definite algebra over QQ of prime discriminant"
    )
    expect_rational(r.base, error)
    if not r.definite or len(r.ramified) != 1:
        raise error
    p = r.base.absolute_norm(r.discriminant)
    size = quadratic_part(p) if q is None else positive(q, "number q of a p-extremal order")
    if q is not None:
        _expect_fitting(size, p)
    i, j = _generators(algebra, size, p)
    return overorder(generated(algebra, [i, j, *_halves(i, j, size, p)]))


def _expect_fitting(q: int, p: int) -> None:
    """Raise :class:`LatticeError` unless q is squarefree and ``(−q, −p | ℚ)`` ramifies exactly at p and ∞."""
    factors = factorise(q)
    square = next((n for n, e in factors.items() if e > 1), None)
    if square is not None:
        raise LatticeError(
            f"q = {q} has the square factor {square}²: expected a squarefree q, such as {q // square**2}"
        )
    places = ramified_places_q(-q, -p)
    wrong = [n for n in places if n not in (p, INFINITE)]
    if p not in places:
        reason = f"−{q} is a square modulo {shorten(p)}, so that (−q, −p) does not ramify there"
    elif wrong:
        reason = (
            f"−{shorten(p)} is not a square modulo {wrong[-1]}, so that (−q, −p) ramifies there"
        )
    else:
        return
    raise LatticeError(
        f"q = {q} does not fit p = {shorten(p)}: {reason}; expected a q for which (−q, −p) ramifies at p and "
        f"∞ alone, such as {quadratic_part(p)}"
    )


def _halves(i: Quaternion, j: Quaternion, q: int, p: int) -> list[Quaternion]:
    """Return the invariant that separates the two classes of maximal orders with i² = −q and j² = −p.

    For q = 1 there is one class; it contains (1 + √−p)/2 for another root of −p.
    """
    if p % 4 == 1 and q % 2:
        return [(1 + i) / 2]
    return [(1 + j) / 2] if p % 4 == 3 and q > 1 else []


def _generators(algebra: Parent, q: int, p: int) -> tuple[Quaternion, Quaternion]:
    """Return anticommuting elements with squares −q and −p."""
    _, i, j, _ = algebra.basis
    if i * i == -q and j * j == -p and i * j == -(j * i):
        return i, j
    from hfield.fields.quadratic_forms import isomorphism

    ring = algebra.ring
    source = (ring(-q), ring(0), ring(-p))
    found = isomorphism(ring, type(algebra.constants)(*source), algebra.constants)
    if found is None:
        raise AssertionError("both ramify at p and infinity")
    return algebra(*found.images[1]), algebra(*found.images[2])
