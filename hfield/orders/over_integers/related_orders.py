"""Orders above and below an order at a prime ideal; Gorenstein closures, Bass orders; connecting ideals.

A maximal suborder of O contains P·O, and is of index P or P², so that subalgebras of O/P·O give all of them.
A minimal overorder is O[x] for an x in P⁻¹·O whose products with O have integral traces.
J. Voight, *Quaternion Algebras*, chapters 23 and 24; S. Chari, D. Smertnig and J. Voight, "On basic and Bass
quaternion orders", 2021.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING

import flint

from hfield.errors import TooLargeError
from hfield.orders.maximal_orders import MOST, in_steps
from hfield.orders.over_integers.dedekind_modules import meet, unique_rows
from hfield.orders.over_integers.local_orders import Local

if TYPE_CHECKING:
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.orders.over_integers.frames import Frame

# --- below and above -------------------------------------------------------------------------------


def suborders(local: Local, rows: flint.fmpq_mat, k: int) -> list[flint.fmpq_mat]:
    """Return the orders of index Pᵏ in an order. Raises :class:`TooLargeError`."""
    return in_steps(rows, k, lambda order: _maximal_suborders(local, order), str)


def overorders(local: Local, rows: flint.fmpq_mat, k: int) -> list[flint.fmpq_mat]:
    """Return the orders in which an order has the index Pᵏ. Raises :class:`TooLargeError`."""
    return in_steps(rows, k, lambda order: _minimal_overorders(local, order), str)


def _maximal_suborders(local: Local, rows: flint.fmpq_mat) -> Iterator[tuple[int, flint.fmpq_mat]]:
    """Yield the orders of index P, and those of index P² that contain P·O, with the exponents."""
    frame, q = local.frame, local.prime.norm()
    if q * q + q + 1 > MOST:
        raise TooLargeError(
            f"there are too many candidates for orders at {local.prime} to try them"
        )
    below = local.times_prime(rows)
    one = frame.row(1).entries()
    basis = local.independent(flint.fmpq_mat([one, *rows.tolist()]), below)[1:]
    b, c, d = (flint.fmpq_mat([row]) for row in basis)
    digits = [frame.scalar(x) for x in local.representatives]
    planes = [(b + d * x, c + d * y) for x in digits for y in digits]
    planes += [*((b + c * x, d) for x in digits), (c, d)]
    for pair in planes:
        order = _spanned(frame, [one, *(x.entries() for x in pair)], below)
        inverse = order.inv()
        if all(_inside(x * frame.right(y.entries()), inverse) for x in pair for y in pair):
            yield 1, order
    lines = [b + c * x + d * y for x in digits for y in digits]
    for x in (*lines, *(c + d * y for y in digits), d):
        yield 2, _spanned(frame, [one, x.entries()], below)


def _minimal_overorders(local: Local, rows: flint.fmpq_mat) -> Iterator[tuple[int, flint.fmpq_mat]]:
    """Yield all minimal overorders at P, and perhaps others, with the exponents of the indices."""
    frame, q = local.frame, local.prime.norm()
    inverse_prime = frame.integers.prime(local.prime).inverse()
    around = meet(unique_rows(frame.multiple(rows, inverse_prime)), frame.dual(rows))
    basis = [flint.fmpq_mat([row]) for row in local.independent(around, rows)]
    if basis and q ** (len(basis) - 1) > MOST:
        raise TooLargeError(
            f"there are too many candidates for orders at {local.prime} to try them"
        )
    limit = frame.dual(rows).inv()
    digits = [frame.scalar(x) for x in local.representatives]
    size = frame.volume(rows)
    for k, first in enumerate(basis):
        for scalars in product(digits, repeat=len(basis) - k - 1):
            x = first
            for m, v in zip(scalars, basis[k + 1 :], strict=True):
                x = x + v * m
            if not frame.is_integral(x):
                continue
            order = _generated(frame, _spanned(frame, [x.entries()], rows), limit)
            if order is not None:
                yield (size / frame.volume(order)).valuation(local.prime), order


def _generated(frame: Frame, rows: flint.fmpq_mat, limit: flint.fmpq_mat) -> flint.fmpq_mat | None:
    """Return the ring that a lattice with 1 generates, or None where it does not stay in another."""
    while _inside(rows, limit):
        wider = frame.product(rows, rows)
        if wider == rows:
            return rows
        rows = wider
    return None


def _spanned(
    frame: Frame, elements: list[list[flint.fmpq]], below: flint.fmpq_mat
) -> flint.fmpq_mat:
    """Return the sum of a lattice and what elements span over the integers."""
    more = flint.fmpq_mat(elements)
    parts = [row for m in frame.scalars for row in (more * m).tolist()]
    return unique_rows(flint.fmpq_mat([*parts, *below.tolist()]))


def _inside(rows: flint.fmpq_mat, inverse: flint.fmpq_mat) -> bool:
    return bool((rows * inverse).numer_denom()[1] == 1)


# --- Gorenstein and Bass orders --------------------------------------------------------------------


def conductor(frame: Frame, rows: flint.fmpq_mat) -> Ideal:
    """Return the largest ideal f with O = ℤ_K + f·G for an order G.

    It is N(O#)·discrd(O): for Gorenstein orders the dual is locally principal, and f⁻² comes from f⁻¹·G#.
    """
    return frame.norm_ideal(frame.dual(rows)) * frame.reduced_discriminant(rows)


def gorenstein_closure(frame: Frame, rows: flint.fmpq_mat) -> flint.fmpq_mat:
    """Return the Gorenstein order G with O = ℤ_K + f·G, f the conductor."""
    table = rows.tolist()
    for place, m in conductor(frame, rows).factorisation():
        P = frame.prime(place)
        local = Local(frame, P)
        shifted = [_without_scalar(local, flint.fmpq_mat([row]), m).entries() for row in table]
        power = frame.integers.prime(P) ** -m
        table += frame.multiple(flint.fmpq_mat(shifted), power).tolist()
    return unique_rows(flint.fmpq_mat(table))


def _without_scalar(local: Local, y: flint.fmpq_mat, m: int) -> flint.fmpq_mat:
    """Return y − a in f·G at P, where y is in ℤ_K + f·G and f = Pᵐ there: N(y − a) ∈ P²ᵐ tells a."""
    frame, P = local.frame, local.prime
    one = frame.row(1)
    if P.p > 2:
        half = frame.field(pow(2, -1, P.p**m))
        return y - one * frame.scalar(frame.parts(y.entries())[0] * 2 * half)
    power = frame.field.one
    for j in range(m):
        for r in local.representatives:
            found = y - one * frame.scalar(r * power)
            norm = frame.norm(found.entries())
            if not norm or P.valuation(norm) >= 2 * j + 2:
                break
        y, power = found, local.integral(power * P.uniformiser, m)
    return y


def is_bass(frame: Frame, rows: flint.fmpq_mat) -> bool:
    """Tell whether every order that contains this one is Gorenstein.

    With the Eichler symbols 1 and −1 those are Bass that are Gorenstein; with 0 the left order of the radical
    is the only minimal overorder of a Gorenstein order.
    """
    for place, e in frame.reduced_discriminant(rows).factorisation():
        prime = frame.prime(place)
        local, order, exponent = Local(frame, prime), rows, e
        while exponent > 1:
            if conductor(frame, order).valuation(prime):
                return False
            if local.symbol(order):
                break
            order = local.left_order(local.radical(order))
            exponent = frame.reduced_discriminant(order).valuation(prime)
    return True


# --- what connects two orders ----------------------------------------------------------------------


Ends = tuple[flint.fmpq_mat, flint.fmpq_mat]


def _ends(local: Local, rows: flint.fmpq_mat, k: int) -> Ends:
    """Return the two orders, maximal at P, whose intersection is an order, Eichler of level Pᵏ at P."""
    frame = local.frame
    corners = local.corners(rows, local.idempotent(rows, k))
    power = frame.integers.prime(local.prime) ** -k
    larger = (frame.multiple(corner, power) for corner in corners)
    first, second = (unique_rows(flint.fmpq_mat(rows.tolist() + m.tolist())) for m in larger)
    return first, second


def connecting(
    frame: Frame, first: flint.fmpq_mat, second: flint.fmpq_mat, level: Ideal
) -> flint.fmpq_mat:
    """Return a primitive integral ideal that connects two Eichler orders of one level.

    It is the intersection of those that connect their ends, multiplied so that they have one norm.
    """
    ideals = [frame.product(first, second)] * 2
    for place, k in level.factorisation():
        local = Local(frame, frame.prime(place))
        (a, b), (c, d) = _ends(local, first, k), _ends(local, second, k)
        # of the two ways to match the ends the one that makes the norm smaller
        ways = [[(a, c), (b, d)], [(a, d), (b, c)]]
        products = [[frame.product(*pair) for pair in way] for way in ways]
        sums = [sum(frame.norm_ideal(x).valuation(place) for x in way) for way in products]
        better = products[sums[1] > sums[0]]
        ideals = [
            unique_rows(flint.fmpq_mat(x.tolist() + y.tolist()))
            for x, y in zip(ideals, better, strict=True)
        ]
    found, other = ideals
    if level != 1:
        root = frame.integers.one
        for P, e in (frame.norm_ideal(found) / frame.norm_ideal(other)).factorisation():
            assert e % 2 == 0, "the distances of the two ends have the same parity"
            root = root * frame.ideal(P) ** (e // 2)
        found = meet(found, unique_rows(frame.multiple(other, root)))
    return unique_rows(frame.multiple(found, frame.scalars_into(found, first)))
