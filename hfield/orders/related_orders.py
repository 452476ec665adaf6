"""Orders above and below an order at a prime, its Gorenstein closure, and ideals connecting two orders.

A maximal suborder of O contains P·O and has the index P or P², so maximal suborders are found as subalgebras
of O/P·O. A minimal overorder is O[x] for some x in P⁻¹·O whose products with O have integral traces. See J.
Voight, *Quaternion Algebras*, chapters 23 and 24; S. Chari, D. Smertnig and J. Voight, "On basic and Bass
quaternion orders", 2021.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product as tuples

from flint import fmpq_mat

from hfield.errors import LatticeError, TooLargeError
from hfield.orders import hermite
from hfield.orders.base_values import Prime
from hfield.orders.invariants import conductor, is_eichler, level
from hfield.orders.kernels.general import ideal_multiples
from hfield.orders.lattice_values import (
    LatticeValue,
    add,
    add_elements,
    dual,
    hermite_form,
    includes,
    meet,
    product,
    scalars_into,
    times_ideal,
)
from hfield.orders.orders_at_primes import OrderAtPrime, independent

MAX_CANDIDATES = 10_000
"""No more candidates for orders at one prime than this are tried."""

# --- below and above -------------------------------------------------------------------------------


def suborders(order: LatticeValue, prime: Prime, k: int) -> list[LatticeValue]:
    """Return the orders of index Pᵏ in an order. Raises :class:`TooLargeError`."""
    return in_steps(order, k, lambda O: _maximal_suborders(O, prime))


def overorders(order: LatticeValue, prime: Prime, k: int) -> list[LatticeValue]:
    """Return the orders in which an order has the index Pᵏ. Raises :class:`TooLargeError`."""
    if order.ambient.base.valuation(level(order), prime) < k:
        return []
    return in_steps(order, k, lambda O: _minimal_overorders(O, prime))


def in_steps(
    start: LatticeValue,
    k: int,
    around: Callable[[LatticeValue], Iterator[tuple[int, LatticeValue]]],
) -> list[LatticeValue]:
    """Return the orders reached by chains of steps of total length k. Raises :class:`TooLargeError`."""
    reached: list[dict[LatticeValue, LatticeValue]] = [{start: start}, *({} for _ in range(k))]
    for n in range(k):
        for order in reached[n].values():
            for length, other in around(order):
                if n + length <= k:
                    reached[n + length].setdefault(other, other)
        if sum(map(len, reached)) > MAX_CANDIDATES:
            raise TooLargeError("there are too many orders of this index to list them")
    return list(reached[k].values())


def _digits(order: LatticeValue, prime: Prime, dimension: int) -> list[fmpq_mat]:
    """Return residues modulo a prime as matrices. Raises :class:`TooLargeError` if there are too many
    lines.
    """
    base = order.ambient.base
    q = base.absolute_norm(base.prime_ideal(prime))
    if sum(q**n for n in range(dimension)) > MAX_CANDIDATES:
        raise TooLargeError(f"there are too many candidates for orders at {prime} to try them")
    if dimension == 1:  # of one line
        return []
    return [order.ambient.scalar(x) for x in base.residues(prime)]


def _maximal_suborders(order: LatticeValue, prime: Prime) -> Iterator[tuple[int, LatticeValue]]:
    """Yield the orders of index P, and those of index P² that contain P·O, with the exponents."""
    ambient, digits = order.ambient, _digits(order, prime, 3)
    below = times_ideal(order, ambient.base.prime_ideal(prime))
    one = ambient.one.entries()
    matrix = ambient.domain.fraction_matrix
    basis = independent(matrix([one, *order.rows.tolist()]), below)[1:]
    b, c, d = basis
    planes = [(b + d * x, c + d * y) for x in digits for y in digits]
    planes += [*((b + c * x, d) for x in digits), (c, d)]
    for pair in planes:
        found = add_elements(below, matrix([one, *(x.entries() for x in pair)]))
        products = (x * ambient.times(y) * found.inverse_rows for x in pair for y in pair)
        if all(z.numer_denom()[1] == 1 for z in products):
            yield 1, found
    lines = [b + c * x + d * y for x in digits for y in digits]
    for x in (*lines, *(c + d * y for y in digits), d):
        yield 2, add_elements(below, matrix([one, x.entries()]))


def _minimal_overorders(order: LatticeValue, prime: Prime) -> Iterator[tuple[int, LatticeValue]]:
    """Yield all minimal overorders at P, and perhaps others, with the exponents of the indices."""
    ambient, base, limit = order.ambient, order.ambient.base, dual(order)
    around = meet(times_ideal(order, base.inverse(base.prime_ideal(prime))), limit)
    basis = independent(around.rows, order)
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
    """Return the ring generated by a lattice with 1, or None if it is not contained in ``limit``."""
    while includes(limit, lattice):
        wider = product(lattice, lattice)
        if wider == lattice:
            return lattice
        lattice = wider
    return None


# --- Gorenstein closures --------------------------------------------------------------------


def gorenstein_closure(order: LatticeValue) -> LatticeValue:
    """Return the Gorenstein order G with O = R + f·G, where f is the conductor.

    At each prime G is spanned by R and all f⁻¹·(y − a), for y in O and some a in R with y − a in f·G. If 2 is
    a unit, a is tr(y)/2. At other primes a is computed from norms.
    """
    ambient, base, found = order.ambient, order.ambient.base, order
    for prime, m in base.factorisation(conductor(order)):
        at = OrderAtPrime(order, prime)
        rows = (fmpq_mat([row]) for row in order.rows.tolist())
        shifted = fmpq_mat([_without_number(at, row, m).entries() for row in rows])
        den, whole = hermite.rational(shifted)
        below, multiples = ideal_multiples(ambient, whole, base.inverse(at.ideal**m))
        joined = hermite.joined(found.den, found.matrix, den * below, multiples)
        found = hermite_form(ambient, *joined)
    return found


def _without_number(at: OrderAtPrime, y: fmpq_mat, m: int) -> fmpq_mat:
    """Return y − a in f·G at P, for y in R + f·G; f = Pᵐ at P, and N(y − a) ∈ P²ᵐ determines a."""
    ambient, base, place = at.ambient, at.base, at.place
    one = ambient.one
    if at.p > 2:
        half = pow(2, -1, at.p**m)
        return y - one * ambient.scalar(ambient.trace(y.entries()) * half)
    power = base.field.one
    for j in range(m):
        for r in at.representatives:
            found = y - one * ambient.scalar(r * power)
            norm = ambient.norm(found.entries())
            if not norm or place.valuation(norm) >= 2 * j + 2:
                break
        y, power = found, base.integer_near(power * place.uniformiser, at.p**m)
    return y


# --- connecting ideals ----------------------------------------------------------------------


def connecting(first: LatticeValue, second: LatticeValue) -> LatticeValue:
    """Return a primitive integral ideal that connects two Eichler orders of the same level.

    It is the intersection of the ideals that connect the maximal orders at their ends, scaled to one norm.
    Raises :class:`LatticeError` for other orders.
    """
    base, whole = first.ambient.base, level(first)
    if level(second) != whole or not (is_eichler(first) and is_eichler(second)):
        raise LatticeError(
            "connecting ideals exist here between Eichler orders of one level, and these are none"
        )
    sources, targets = (first, first), (second, second)
    for prime, k in base.factorisation(whole):
        a, b = OrderAtPrime(first, prime).ends(k)
        c, d = OrderAtPrime(second, prime).ends(k)
        straight, crossed = (
            sum(_distance(x, y, prime) for x, y in way)
            for way in (((a, c), (b, d)), ((a, d), (b, c)))
        )
        if crossed < straight:
            c, d = d, c
        # at a prime all other summands are the order there
        sources = add(sources[0], a), add(sources[1], b)
        targets = add(targets[0], c), add(targets[1], d)
    found = product(sources[0], targets[0])
    if whole != 1:
        other = product(sources[1], targets[1])
        root = base.one
        for prime, e in base.factorisation(found.norm / other.norm):
            assert e % 2 == 0, "the distances of the two ends have the same parity"
            power = base.prime_ideal(prime) ** (abs(e) // 2)
            root = root * (power if e > 0 else base.inverse(power))
        found = meet(found, times_ideal(other, root))
    return times_ideal(found, scalars_into(found, first))


def _distance(first: LatticeValue, second: LatticeValue, prime: Prime) -> int:
    """Return v_P of the index of the intersection of two lattices in either of them."""
    return first.ambient.base.valuation(meet(first, second).volume / first.volume, prime)
