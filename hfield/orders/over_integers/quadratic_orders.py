"""Quadratic orders over ℤ_K inside an order of a totally definite algebra, and elements of given norm.

The elements s = 2x − tr(x) are those of trace 0 in ℤ_K + 2O, and s² is the discriminant of ℤ_K[x]: a
quadratic order of discriminant d is embedded by the vectors of norm −d of a ternary lattice, and optimally
where no multiple of s by an inverse ideal is in it (Voight, *Quaternion Algebras*, chapter 30).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count, product
from random import Random
from typing import TYPE_CHECKING, Any

import flint

from hfield.core.primality import WORD
from hfield.errors import LatticeError, UndecidedError, shorten
from hfield.orders.lattice_values import LatticeValue, discriminant
from hfield.orders.over_integers.equivalence import units
from hfield.orders.over_integers.ideals_of_norm import generators, random_generators, subideals
from hfield.orders.over_integers.local_orders import Local
from hfield.orders.short_elements import (
    expect_definite,
    of_norm_among,
    rows_of_norm,
    ternary_rows,
)

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.orders.basis import AlgebraBasis

ENUMERATED = 10**6
"""Ellipsoids with about so many integral points are run through."""
TRIALS = 100
"""So many random ideals are tried."""
TRIED = 20_000
"""No more classes of elements modulo powers of a prime than this are tried for a local obstruction."""


@dataclass(frozen=True)
class IntegersEmbeddings:
    """The optimal embeddings of the quadratic ℤ_K-order of ``discriminant`` in an order.

    ``elements`` are the images of ``(t + √d)/2``, t² ≡ d modulo 4; ``orbits`` counts them up to conjugation
    by units of the order.
    """

    discriminant: Any
    elements: tuple[Quaternion, ...]
    orbits: int

    @property
    def element(self) -> Quaternion | None:
        """One of them, or None."""
        return self.elements[0] if self.elements else None

    def __len__(self) -> int:
        return len(self.elements)

    def __bool__(self) -> bool:
        """Tell whether there is an optimal embedding."""
        return bool(self.elements)


def embeddings(order: LatticeValue, d: Any) -> IntegersEmbeddings:
    """Return the optimal embeddings of the quadratic order of discriminant d, totally negative.

    Raises :class:`LatticeError` where d is no discriminant, :class:`IndefiniteError`.
    """
    ambient, base = order.ambient, order.ambient.base
    expect_definite(ambient, "embeddings()")
    field, x = base.field, base.inside(d)
    t = _root_modulo_4(ambient, x)
    if t is None or any(v.sign(x) >= 0 for v in field.real_places()):
        raise LatticeError(
            f"{shorten(d)} is no discriminant of a totally imaginary quadratic order over the integers of "
            f"{shorten(ambient.algebra.ring.name)}: expected a totally negative integer, a square modulo 4"
        )
    ternary = ternary_rows(order)
    # what would make an order of smaller discriminant d/b² contain the image
    inverses = [
        ambient.base.prime_ideal(ambient.base.prime(P)) ** -1
        for P, e in ambient.base.principal(x).factorisation()
        if e > 1
    ]
    found = []
    for s in of_norm_among(ambient, ternary, -x):
        multiples = ([s * ambient.scalar(c) for c in b.basis] for b in inverses)
        if not any(_inside(some, ternary) for some in multiples):
            found += [s, -s]
    shift = ambient.row(1) * ambient.scalar(t)
    images = [(shift + s) * flint.fmpq(1, 2) for s in found]
    elements = tuple(ambient.quaternion(row.entries()) for row in images)
    return IntegersEmbeddings(d, elements, _orbits(order, found))


def _root_modulo_4(ambient: AlgebraBasis, d: FieldElement) -> FieldElement | None:
    """Return t with t² ≡ d modulo 4, or None."""
    field = ambient.base.field
    for digits in product((0, 1), repeat=ambient.degree):
        t: FieldElement = sum(
            (w * c for w, c in zip(ambient.base.integral_basis, digits, strict=True)), field.zero
        )
        if field.is_integral((t * t - d) * flint.fmpq(1, 4)):
            return t
    return None


def _inside(vectors: list[flint.fmpq_mat], ternary: flint.fmpq_mat) -> bool:
    n = ternary.ncols() // 4
    square = flint.fmpq_mat([r[n:] for r in ternary.tolist()])
    pure = flint.fmpq_mat([v.entries()[n:] for v in vectors])
    return bool((pure * square.inv()).numer_denom()[1] == 1)


def _orbits(order: LatticeValue, elements: list[flint.fmpq_mat]) -> int:
    """Return how many orbits there are under conjugation by the units of an order."""
    if not elements:
        return 0
    times = order.ambient.times
    maps = [times(u, "left") * times(u).inv() for u in units(order)]
    left, orbits = {str(s): s for s in elements}, 0
    while left:
        s = next(iter(left.values()))
        for m in maps:
            left.pop(str(s * m), None)
        orbits += 1
    return orbits


# --- norm equations --------------------------------------------------------------------------------


def represent(order: LatticeValue, n: Any, seed: int | None = None) -> Quaternion | None:
    """Return an element of an order with norm n, or None where there is none.

    Small n are decided by enumeration in the form Tr(N(x)/n). For others an obstruction at a prime is looked
    for, and a generator of norm n of random ideals of norm n, whose shortest vectors it is among.
    Raises :class:`IndefiniteError`, and :class:`UndecidedError`.
    """
    ambient, base = order.ambient, order.ambient.base
    expect_definite(ambient, "represent_integer()")
    norm = base.inside(n)
    if not norm:
        return ambient.quaternion([flint.fmpq(0)] * ambient.size)
    if not ambient.base.field.is_integral(norm) or any(
        v.sign(norm) < 0 for v in ambient.base.field.real_places()
    ):
        return None
    small, whole = _points(order, norm) < ENUMERATED, discriminant(order)
    if not small and any(
        is_obstructed(Local(ambient, base.prime(P)), order, norm) for P, _ in whole.factorisation()
    ):
        return None
    rng = Random(1 if seed is None else seed)
    lattices = [order] if small else _random_ideals(order, norm, rng)
    for lattice in lattices:
        for row in rows_of_norm(lattice, norm):
            return ambient.quaternion(row.entries())
    if small:
        return None
    raise UndecidedError(
        f"whether the norm of an element is {shorten(n)} was not decided: no prime forbids it, and of "
        f"{TRIALS} random ideals of this norm none has such a generator"
    )


def _random_ideals(order: LatticeValue, norm: FieldElement, rng: Random) -> Iterator[LatticeValue]:
    """Yield some right ideals of an order whose norm is generated by a number."""
    steps, ambient, whole = [], order.ambient, discriminant(order)
    for place, e in ambient.base.principal(norm).factorisation():
        if place.p >= WORD:
            raise UndecidedError(
                f"whether the norm of an element is {shorten(ambient.base.outside(norm))} was not "
                "decided: "
                f"no small prime forbids it, and residues at {shorten(place)} exceed a machine's word"
            )
        local, divides = Local(ambient, ambient.base.prime(place)), whole.valuation(place) > 0
        steps += [(local, generators(local, order) if divides else [])] * e
    for _ in range(TRIALS):
        ideal = order
        for local, known in steps:
            chosen = rng.choice(known) if known else random_generators(local, order, rng)
            (ideal,) = subideals(local, ideal, [chosen])
        yield ideal


def _points(order: LatticeValue, norm: FieldElement) -> float:
    """Return about how many elements of the lattice have Tr(N(x)/n) ≤ [K : ℚ]."""
    ambient, rows = order.ambient, order.rows
    form = rows * ambient.form(1 / norm) * rows.transpose()
    m = ambient.size
    log_det = math.log(int(form.det().p)) - math.log(int(form.det().q))
    log_ball = m / 2 * math.log(math.pi) - math.lgamma(m / 2 + 1)
    return math.exp(min(log_ball + m / 2 * math.log(2 * ambient.degree) - log_det / 2, 700.0))


def is_obstructed(local: Local, order: LatticeValue, norm: FieldElement) -> bool:
    """Tell whether no element of the order has this norm in the completion at P; False where it is not seen.

    An element outside of P·O with N(x) − n small beside the derivatives tr(x·conj(y)) can be changed to one
    of norm n (Hensel); one in P·O has the norm of one of norm n/π².
    """
    ambient, P = local.ambient, local.prime
    if P.norm() ** 4 > TRIED:
        return False
    basis = [flint.fmpq_mat([r]) for r in local.independent(order.rows, local.times_prime(order))]
    values = [ambient.norm(b.entries()) for b in basis]
    classes = list(_vectors(local, basis))

    def solvable(target: FieldElement) -> bool:
        level, power = [x for x in classes if any(x.entries())], ambient.base.field.one
        for k in count(1):
            rest = []
            for x in level:
                norm = ambient.norm(x.entries())
                if norm != target and P.valuation(norm - target) < k:
                    continue
                slopes = (
                    ambient.norm((x + b).entries()) - norm - c
                    for b, c in zip(basis, values, strict=True)
                )
                slope = min((P.valuation(d) for d in slopes if d), default=math.inf)
                if norm == target or P.valuation(norm - target) > 2 * slope:
                    return True
                rest.append(x)
            if len(rest) * len(classes) > TRIED:
                return True  # not known
            power = power * P.uniformiser
            level = [x + v * ambient.scalar(power) for x in rest for v in classes]
            if not level:
                break
        lower = target / (P.uniformiser * P.uniformiser)
        return P.valuation(lower) >= 0 and solvable(lower)

    return not solvable(norm)


def _vectors(local: Local, basis: list[flint.fmpq_mat]) -> Iterator[flint.fmpq_mat]:
    """Yield one element of each class of an order modulo P times it."""
    ambient = local.ambient
    for digits in product(local.representatives, repeat=len(basis)):
        total = flint.fmpq_mat(1, ambient.size)
        for c, b in zip(digits, basis, strict=True):
            total = total + b * ambient.scalar(c)
        yield total
