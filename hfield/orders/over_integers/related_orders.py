"""Orders above and below an order at a prime; over ℤ_K Gorenstein closures and connecting ideals.

A maximal suborder of O contains P·O, and is of index P or P², so that subalgebras of O/P·O give all of them.
A minimal overorder is O[x] for an x in P⁻¹·O whose products with O have integral traces.
J. Voight, *Quaternion Algebras*, chapters 23 and 24; S. Chari, D. Smertnig and J. Voight, "On basic and Bass
quaternion orders", 2021.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product as tuples
from typing import Any

import flint

from hfield.errors import LatticeError, TooLargeError
from hfield.orders.invariants import conductor, is_eichler, level
from hfield.orders.lattice_values import (
    LatticeValue,
    add,
    add_elements,
    add_rows,
    dual,
    includes,
    meet,
    product,
    scalars_into,
    times_ideal,
)
from hfield.orders.maximal_orders import MOST, in_steps
from hfield.orders.over_integers.local_orders import Local, independent

# --- below and above -------------------------------------------------------------------------------


def suborders(order: LatticeValue, prime: Any, k: int) -> list[LatticeValue]:
    """Return the orders of index Pᵏ in an order. Raises :class:`TooLargeError`."""
    return in_steps(order, k, lambda O: _maximal_suborders(O, prime), lambda O: O.hnf)


def overorders(order: LatticeValue, prime: Any, k: int) -> list[LatticeValue]:
    """Return the orders in which an order has the index Pᵏ. Raises :class:`TooLargeError`."""
    if order.ambient.base.valuation(level(order), prime) < k:
        return []
    return in_steps(order, k, lambda O: _minimal_overorders(O, prime), lambda O: O.hnf)


def _digits(order: LatticeValue, prime: Any, dimension: int) -> list[flint.fmpq_mat]:
    """Return residues modulo a prime as matrices. Raises :class:`TooLargeError` for too many lines."""
    base = order.ambient.base
    q = base.absolute_norm(base.prime_ideal(prime))
    if sum(q**n for n in range(dimension)) > MOST:
        raise TooLargeError(f"there are too many candidates for orders at {prime} to try them")
    if dimension == 1:  # of one line
        return []
    return [order.ambient.scalar(x) for x in base.residues(prime)]


def _maximal_suborders(order: LatticeValue, prime: Any) -> Iterator[tuple[int, LatticeValue]]:
    """Yield the orders of index P, and those of index P² that contain P·O, with the exponents."""
    ambient, digits = order.ambient, _digits(order, prime, 3)
    below = times_ideal(order, ambient.base.prime_ideal(prime))
    one = ambient.row(1).entries()
    basis = independent(flint.fmpq_mat([one, *order.rows.tolist()]), below)[1:]
    b, c, d = (flint.fmpq_mat([row]) for row in basis)
    planes = [(b + d * x, c + d * y) for x in digits for y in digits]
    planes += [*((b + c * x, d) for x in digits), (c, d)]
    for pair in planes:
        found = add_elements(below, flint.fmpq_mat([one, *(x.entries() for x in pair)]))
        products = (x * ambient.times(y) * found.inverse_rows for x in pair for y in pair)
        if all(z.numer_denom()[1] == 1 for z in products):
            yield 1, found
    lines = [b + c * x + d * y for x in digits for y in digits]
    for x in (*lines, *(c + d * y for y in digits), d):
        yield 2, add_elements(below, flint.fmpq_mat([one, x.entries()]))


def _minimal_overorders(order: LatticeValue, prime: Any) -> Iterator[tuple[int, LatticeValue]]:
    """Yield all minimal overorders at P, and perhaps others, with the exponents of the indices."""
    ambient, base, limit = order.ambient, order.ambient.base, dual(order)
    around = meet(times_ideal(order, base.inverse(base.prime_ideal(prime))), limit)
    basis = [flint.fmpq_mat([row]) for row in independent(around.rows, order)]
    if not basis:
        return
    digits = _digits(order, prime, len(basis))
    for k, first in enumerate(basis):
        for scalars in tuples(digits, repeat=len(basis) - k - 1):
            x = first
            for m, v in zip(scalars, basis[k + 1 :], strict=True):
                x = x + v * m
            if not ambient.is_integral(x.entries()):
                continue
            larger = _generated(add_elements(order, x), limit)
            if larger is not None:
                yield base.valuation(order.volume / larger.volume, prime), larger


def _generated(lattice: LatticeValue, limit: LatticeValue) -> LatticeValue | None:
    """Return the ring that a lattice with 1 generates, or None where it does not stay in another."""
    while includes(limit, lattice):
        wider = product(lattice, lattice)
        if wider == lattice:
            return lattice
        lattice = wider
    return None


# --- Gorenstein closures --------------------------------------------------------------------


def gorenstein_closure(order: LatticeValue) -> LatticeValue:
    """Return the Gorenstein order G with O = ℤ_K + f·G, f the conductor."""
    ambient, found = order.ambient, order
    for place, m in conductor(order).factorisation():
        P = ambient.base.prime(place)
        local = Local(ambient, P)
        rows = (flint.fmpq_mat([row]) for row in order.rows.tolist())
        shifted = flint.fmpq_mat([_without_scalar(local, row, m).entries() for row in rows])
        for c in (ambient.base.prime_ideal(P) ** -m).basis:
            found = add_rows(found, shifted * ambient.scalar(c))
    return found


def _without_scalar(local: Local, y: flint.fmpq_mat, m: int) -> flint.fmpq_mat:
    """Return y − a in f·G at P, where y is in ℤ_K + f·G and f = Pᵐ there: N(y − a) ∈ P²ᵐ tells a."""
    ambient, P = local.ambient, local.prime
    one = ambient.row(1)
    if P.p > 2:
        half = ambient.base.field(pow(2, -1, P.p**m))
        return y - one * ambient.scalar(ambient.parts(y.entries())[0] * 2 * half)
    power = ambient.base.field.one
    for j in range(m):
        for r in local.representatives:
            found = y - one * ambient.scalar(r * power)
            norm = ambient.norm(found.entries())
            if not norm or P.valuation(norm) >= 2 * j + 2:
                break
        y, power = found, ambient.base.integer_near(power * P.uniformiser, P.p**m)
    return y


# --- what connects two orders ----------------------------------------------------------------------


Ends = tuple[LatticeValue, LatticeValue]


def _ends(local: Local, order: LatticeValue, k: int) -> Ends:
    """Return the two orders, maximal at P, whose intersection is an order, Eichler of level Pᵏ at P."""
    ambient = local.ambient
    corners = local.corners(order, local.idempotent(order, k))
    factors = [ambient.scalar(c) for c in (ambient.base.prime_ideal(local.prime) ** -k).basis]
    ends = []
    for corner in corners:
        larger = order
        for factor in factors:
            larger = add_rows(larger, corner * factor)
        ends.append(larger)
    return ends[0], ends[1]


def connecting(first: LatticeValue, second: LatticeValue) -> LatticeValue:
    """Return a primitive integral ideal that connects two Eichler orders of one level.

    It is the intersection of those that connect their ends, multiplied so that they have one norm. Raises
    :class:`LatticeError` for other orders.
    """
    ambient, whole = first.ambient, level(first)
    if level(second) != whole or not (is_eichler(first) and is_eichler(second)):
        raise LatticeError(
            "connecting ideals exist here between Eichler orders of one level, and these are none"
        )
    ideals = [product(first, second)] * 2
    for place, k in whole.factorisation():
        local = Local(ambient, ambient.base.prime(place))
        (a, b), (c, d) = _ends(local, first, k), _ends(local, second, k)
        # of the two ways to match the ends the one that makes the norm smaller
        ways = [[(a, c), (b, d)], [(a, d), (b, c)]]
        products = [[product(*pair) for pair in way] for way in ways]
        sums = [sum(x.norm.valuation(place) for x in way) for way in products]
        better = products[sums[1] > sums[0]]
        ideals = [add(x, y) for x, y in zip(ideals, better, strict=True)]
    found, other = ideals
    if whole != 1:
        root = ambient.base.one
        for P, e in (found.norm / other.norm).factorisation():
            assert e % 2 == 0, "the distances of the two ends have the same parity"
            root = root * ambient.base.ideal(P) ** (e // 2)
        found = meet(found, times_ideal(other, root))
    return times_ideal(found, scalars_into(found, first))
