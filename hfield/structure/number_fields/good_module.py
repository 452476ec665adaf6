"""Lattices in K³ on which a form over a number field K is good at every prime ideal.

At a prime ideal ``minimal_conics`` gives a local basis whose entries are integral at
all other primes. The module over the integers of K that has these bases at the bad primes, and is the
standard one elsewhere, is their sum, each times a number that is divisible enough by the others.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import flint

from hfield.rings.number_elements import FieldElement
from hfield.rings.number_field import NumberField
from hfield.rings.number_primes import primes_above
from hfield.rings.residues.number_ideals import LocalPlace, local_place
from hfield.structure.minimal_conics import Conic, Vector, minimise


def good_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in K³ on which a diagonal form is minimal at each prime ideal.

    The coefficients are integers of the field, and units outside ``primes``, which contain 2. The form
    must have a zero in each completion.
    """
    o = field.zero
    conic = Conic((form[0], form[1], form[2], o, o, o), o, field.one)
    local: list[tuple[int, LocalPlace, list[Vector]]] = []
    depths: dict[int, int] = {}  # the conductor, prime by prime
    for p in primes:
        depths[p] = 0
        for prime in primes_above(field, p):
            place, lattice = local_place(prime), conic.start()
            if not minimise(conic, lattice, place):
                raise AssertionError("the form has a zero in every completion")
            depths[p] = max(depths[p], -(-_depth(place, lattice.basis) // prime.e))
            local.append((p, place, lattice.basis))
    conductor = math.prod(p**n for p, n in depths.items())
    rows = [[x * conductor for x in v] for v in conic.start().basis]
    for p, place, basis in local:
        # 1 at the place, and divisible by p^depth at the others above p
        depth = depths[p] * max(Q.e for Q in primes_above(field, p))
        unit = field.power(place.prime.idempotent, depth)
        unit = place.prime.order.truncated(unit, p ** (depths[p] + 1))
        scale = unit * (conductor // p ** depths[p])
        rows += [[scale * x for x in v] for v in basis]
    return _basis(field, [[w * x for x in v] for w in field.integral_basis() for v in rows])


def _depth(place: LocalPlace, basis: list[Vector]) -> int:
    """Return an n for which the span contains the n-th power of the prime times the standard lattice."""
    (a, b, c), (d, e, f), (g, h, i) = basis
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    worst = min(place.valuation(x) for v in basis for x in v if x)
    return max(0, place.valuation(determinant) - 2 * min(0, worst))


def _basis(field: NumberField, generators: list[Vector]) -> list[Vector]:
    """Return a basis over ℤ, of rank 3n, of what vectors of K³ generate, scaled to be integral."""
    n = field.degree
    rows = [[c for x in v for c in _coefficients(x, n)] for v in generators]
    scale = math.lcm(*(int(c.q) for row in rows for c in row))
    entries = [(c * scale).p for row in rows for c in row]
    matrix = flint.fmpz_mat(len(rows), 3 * n, entries).hnf()
    return [
        [FieldElement(field, flint.fmpq_poly(row[k : k + n])) for k in range(0, 3 * n, n)]
        for row in matrix.tolist()[: 3 * n]
    ]


def _coefficients(x: FieldElement, n: int) -> list[flint.fmpq]:
    coefficients = x.poly.coeffs()
    return [*coefficients, *[flint.fmpq(0)] * (n - len(coefficients))]
