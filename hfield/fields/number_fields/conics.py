"""Points on conics ``a·x² + b·y² = z²`` over number fields, by a bounded search.

The form ``z² − a·x² − b·y²`` is considered on a module in K³ on which it is minimal at every prime ideal, a
lattice of rank 3n in which :class:`ZeroSearch` looks for zeros. At a prime ideal, ``minimal_conics`` gives a
local basis whose entries are integral at all other primes. The module that has these bases at the bad primes,
and is the standard one elsewhere, is the sum of their spans, each multiplied by a number that is sufficiently
divisible by the other primes.

Compare Cremona and Rusin, "Efficient solution of rational conics", Math. Comp. 72 (2003).
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import flint

from hfield.fields.number_fields.elements import FieldElement, coefficients
from hfield.fields.number_fields.integral_basis import integral_multiple
from hfield.fields.number_fields.prime_ideals import primes_above
from hfield.fields.number_fields.residues import LocalPlace, local_place
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import candidates
from hfield.fields.number_fields.zeros_of_forms import ZeroSearch, expect_small_degree, not_met
from hfield.fields.quadratic_forms.minimal_conics import Conic, Vector, minimise


def solve_conic_number_field(
    field: NumberField, a: FieldElement, b: FieldElement
) -> tuple[FieldElement, FieldElement, FieldElement]:
    """Return ``(x, y, z)``, not all 0, with ``a·x² + b·y² = z²``, for nonzero a and b.

    The conic must have a point, that is, ``(a, b | K)`` must be unramified everywhere. Raises
    :class:`UndecidedError` if no point was found, and if a norm or the discriminant is too hard to factor.
    """
    none = f"a conic over {field.name} has points, but none"
    expect_small_degree(field, none)
    primes = sorted({2} | candidates(field, a) | candidates(field, b))
    r, s = (integral_multiple(x) for x in (a, b))
    form = [field.one, -a * (r * r), -b * (s * s)]
    walk = ZeroSearch(field, form, good_module(field, form, primes))
    for z, x, y in walk.zeros():
        return x * r, y * s, z
    raise not_met(none)


def good_module(field: NumberField, form: Vector, primes: Iterable[int]) -> list[Vector]:
    """Return a basis over ℤ of a module in K³ on which a diagonal form is minimal at each prime ideal.

    The coefficients are integers of the field, and units outside ``primes``, which include 2. The form must
    have a zero in each completion.
    """
    o = field.zero
    conic = Conic((form[0], form[1], form[2], o, o, o), o, field.one)
    local: list[tuple[LocalPlace, list[Vector]]] = []
    depths: dict[int, int] = {}  # the conductor, prime by prime
    for p in primes:
        depths[p] = 0
        for place in map(local_place, primes_above(field, p)):
            lattice = conic.start()
            if not minimise(conic, lattice, place):
                raise AssertionError("the form must have a zero in every completion")
            depths[p] = max(depths[p], -(-_depth(place, lattice.basis) // place.index))
            local.append((place, lattice.basis))
    conductor = math.prod(p**n for p, n in depths.items())
    rows = [[x * conductor for x in v] for v in conic.start().basis]
    for place, basis in local:
        n = depths[place.below]
        scale = _unit(place, n) * (conductor // place.below**n)
        rows += [[scale * x for x in v] for v in basis]
    return module_basis(field, rows)


def _depth(place: LocalPlace, basis: list[Vector]) -> int:
    """Return an n such that the span contains the n-th power of the prime times the standard lattice."""
    (a, b, c), (d, e, f), (g, h, i) = basis
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    worst = min(place.valuation(x) for v in basis for x in v if x)
    return max(0, place.valuation(determinant) - 2 * min(0, worst))


def _unit(place: LocalPlace, n: int) -> FieldElement:
    """Return an integer that is 1 at the place and divisible by pⁿ at the other places above p."""
    prime, p = place.prime, place.below
    power = n * max(Q.e for Q in primes_above(prime.field, p))
    return prime.order.truncated(prime.field.power(prime.idempotent, power), p ** (n + 1))


def module_basis(field: NumberField, generators: list[Vector]) -> list[Vector]:
    """Return a basis over ℤ of the module that vectors of Kᵐ generate over the ring of integers, scaled to be
    integral.
    """
    n = field.degree
    width = n * len(generators[0])
    wide = [[w * x for x in v] for w in field.integral_basis() for v in generators]
    rows = [[c for x in v for c in coefficients(x)] for v in wide]
    scale = math.lcm(*(int(c.q) for row in rows for c in row))
    entries = [(c * scale).p for row in rows for c in row]
    matrix = flint.fmpz_mat(len(rows), width, entries).hnf()
    return [
        [FieldElement(field, flint.fmpq_poly(row[k : k + n])) for k in range(0, width, n)]
        for row in matrix.tolist()[:width]
    ]
