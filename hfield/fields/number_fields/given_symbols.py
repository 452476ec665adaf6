"""Numbers with given Hilbert symbols, and algebras with given ramification, over number fields.

An e such that (a, e), or each of several (a, e), ramifies exactly at given places is searched for among the
smallest numbers of a coset. These lie in the prime ideals at which the valuation of e must be odd. At those
at which the valuation of an a is odd, they have a class with the right symbols. They also have the right
signs. The symbols above 2, and those at the other primes that divide e (small ones), are left to chance; one
of all these is right by the product formula.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Iterable, Iterator, Sequence

import flint

from hfield.core.factorisation import factorise, remove
from hfield.core.primality import WORD, is_probable_prime
from hfield.errors import RingError, UndecidedError, shorten
from hfield.fields.base.balls import precision
from hfield.fields.linear_algebra.lattice_reduction import combination, reduced
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.integers import small_integer
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.places import Place, RealPlace, place_of_number_field
from hfield.fields.number_fields.prime_ideals import PrimeIdeal, primes_above
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.symbols import (
    DyadicPrime,
    candidates,
    hilbert_symbol_number_field,
    residue_symbol,
)
from hfield.fields.rationals.whole_numbers import crt

TRIALS = 20_000
TWOS = 2**5  # symbols above 2 of an e of valuation ≤ 1 depend on e modulo this


def common_slot(numbers: Sequence[FieldElement], ramified: Collection[Place]) -> FieldElement:
    """Return an e with ``(a, e | K)`` ramified exactly at an even number of given places, for all the numbers
    a.

    No a is a square at any of the places. Raises :class:`UnfactoredError` if a norm is too hard to factor,
    and :class:`UndecidedError` if there is no such e or the search did not find one.
    """
    field = numbers[0].field
    above = {v.p for v in ramified if isinstance(v, PrimeIdeal)}
    above = {2}.union(above, *(candidates(field, a) for a in numbers))
    finite = [P for p in sorted(above) for P in primes_above(field, p)]
    signs = [
        0 if all(v.sign(a) > 0 for a in numbers) else -1 if v in ramified else 1
        for v in field.real_places()
    ]
    for e in _lifts(field, _classes(numbers, finite, ramified), signs):
        if not all(_fits(numbers, e, P, ramified) for P in finite):
            continue
        rest = abs(int(e.norm().p))
        for p in above:
            rest = remove(rest, p)[1]
        if rest < WORD or is_probable_prime(rest):
            new = (P for p in factorise(rest) for P in primes_above(field, p))
            if all(_fits(numbers, e, P, ramified) for P in new):
                return e
    raise UndecidedError(
        f"no number of {field.name} with the wanted symbols was found among {TRIALS} of fitting classes"
    )


def from_ramification_number_field(
    field: NumberField, named: Sequence[Place | str]
) -> tuple[FieldElement, FieldElement]:
    """Return (a, b) such that ``(a, b | K)`` ramifies exactly at the given places.

    Raises :class:`RingError` unless the places are distinct, even in number, and none of them is complex.
    """
    places = [place_of_number_field(field, v) for v in named]
    if len(set(places)) < len(places):
        raise RingError("the same place was named twice among the ramified places")
    if not all(isinstance(v, (PrimeIdeal, RealPlace)) for v in places):
        raise RingError(
            "no algebra ramifies at a complex place: only prime ideals and real places may be named"
        )
    if len(places) % 2:
        raise RingError(
            f"an algebra over {shorten(field.name)} ramifies at an even number of places, and {len(places)} "
            "were named: add or drop one"
        )
    if not places:
        return field.one, field.one
    rng = random.Random(1)
    for trial in range(TRIALS):
        a = small_integer(field, 1 + trial // 200, rng)
        if a and all(not is_local_square(v, a) for v in places):
            return a, common_slot([a], places)
    raise UndecidedError(
        f"no small number of {shorten(field.name)} that is a square at none of the places was found"
    )


def is_local_square(place: Place, x: FieldElement) -> bool:
    """Return whether x ≠ 0 is a square in the completion at a place."""
    if isinstance(place, RealPlace):
        return place.sign(x) > 0
    if not isinstance(place, PrimeIdeal):
        return True
    v, unit = place.unit_part(x)
    if v % 2:
        return False
    if place.p == 2:
        return _defect(place, unit) > 2 * place.e
    return residue_symbol(place, unit) == 1


def _fits(
    numbers: Iterable[FieldElement], e: FieldElement, P: PrimeIdeal, ramified: Collection[Place]
) -> bool:
    """Return whether all symbols (a, e) at a prime ideal have the required values."""
    return all((hilbert_symbol_number_field(a, e, P) < 0) == (P in ramified) for a in numbers)


Classes = dict[PrimeIdeal, tuple[FieldElement, int]]


def _classes(
    numbers: Sequence[FieldElement], finite: Sequence[PrimeIdeal], ramified: Collection[Place]
) -> Classes:
    """Return the residue classes, modulo P or P², that e must have at some prime ideals P."""
    classes: Classes = {}
    for P in finite:
        if P.p > 2:
            right = [c for c in _square_classes(P) if _fits(numbers, c[0], P, ramified)]
            powers = [k for _, k in right]
            if not right:
                raise UndecidedError(
                    f"no number has the wanted symbols at {P}, a prime ideal above {P.p}"
                )
            if powers[:2] != [1, 1]:  # else any unit will do
                classes[P] = right[0] if powers != [2, 2] else (P.field.zero, 1)
        elif P in ramified and all(_is_unramified(P, a) for a in numbers):
            classes[P] = P.field.zero, 1
    return classes


def _is_unramified(P: PrimeIdeal, a: FieldElement) -> bool:
    """Return whether the square root of a is unramified at a prime ideal above 2."""
    v, unit = P.unit_part(a)
    return v % 2 == 0 and _defect(P, unit) >= 2 * P.e


def _defect(P: PrimeIdeal, unit: FieldElement) -> int:
    return DyadicPrime(P).defect(P.order.truncated(P.integral(unit), TWOS * 2))[0]


def _square_classes(P: PrimeIdeal) -> list[tuple[FieldElement, int]]:
    """Return the square classes at an odd prime ideal, two of units and two of valuation 1, modulo
    P or P².
    """
    one, rng = P.field.one, random.Random(1)
    unit = one
    while P.valuation(unit) or is_local_square(P, unit):
        unit = P.order.element(rng.randrange(P.p) for _ in range(P.field.degree)) or one
    return [(one, 1), (unit, 1), (P.uniformiser, 2), (P.uniformiser * unit, 2)]


def _lifts(field: NumberField, classes: Classes, signs: Sequence[int]) -> Iterator[FieldElement]:
    """Yield random small numbers with given residue classes and given signs at the real places."""
    import numpy as np

    rng, places = random.Random(1), field.infinite_places()
    rows, short = _reduced_ideal(field, classes)
    inverse, start = np.linalg.inv(np.array(short)), _representative(field, classes)
    offset = (start * flint.fmpq_mat(rows).inv()).entries()
    tail = np.array([float(x - x.floor()) for x in offset])
    seen = set()
    for trial in range(TRIALS):
        # a point with the right signs, and a number of the coset next to it
        size = 1 + trial / 500
        target: list[float] = []
        for v, sign in zip(places, [*signs, *[0] * len(places)], strict=False):
            target.append(rng.uniform(0.2, 1) * sign * size if sign else rng.uniform(-size, size))
            if not isinstance(v, RealPlace):
                target.append(rng.uniform(-size, size))
        steps = tuple(int(x) for x in np.rint(np.array(target) @ inverse - tail))
        if steps in seen:
            continue
        seen.add(steps)
        whole = [k - int(x.floor()) for k, x in zip(steps, offset, strict=True)]
        row = [x + y for x, y in zip(start.entries(), combination(whole, rows), strict=True)]
        e = element_of(field, row)
        if e and all(v.sign(e) == s for v, s in zip(field.real_places(), signs, strict=True) if s):
            yield e


def _representative(field: NumberField, classes: Classes) -> flint.fmpq_mat:
    """Return the coordinates in the integral basis of a number with the given classes."""
    n, residues = field.degree, []
    for p in {P.p for P in classes}:
        e, m = field.zero, p * p
        for P, (part, _) in classes.items():
            if P.p == p:  # ε²·(3 − 2ε) is 1 or 0 modulo p² if ε is modulo p
                near = P.order.truncated(P.idempotent * P.idempotent * (3 - P.idempotent * 2), m)
                e = P.order.truncated(e + near * P.order.truncated(part, m), m)
        coordinates = coordinate_rows(field, [e]).entries()
        residues.append([(int(c.p) * pow(int(c.q), -1, m) % m, m) for c in coordinates])
    return flint.fmpq_mat(1, n, [crt(r[k] for r in residues)[0] for k in range(n)])


def _reduced_ideal(
    field: NumberField, classes: Classes
) -> tuple[list[list[int]], list[list[float]]]:
    """Return a reduced basis of the product of the moduli of the classes, and its values at the infinite
    places.

    The basis is given by coordinates in the integral basis. The values are real, or real and imaginary parts,
    scaled so that the largest has absolute value 1.
    """
    n, basis = field.degree, list(field.integral_basis())
    for P in (P for P, (_, k) in classes.items() for _ in range(k)):
        both = [x * y for x in basis for y in P.generators]
        rows = (coordinate_rows(field, both).numer_denom()[0]).hnf().tolist()[:n]
        basis = [element_of(field, row) for row in rows]
    size = max(int(c.p).bit_length() for x in basis for c in x.poly.coeffs())
    bits, places = 2 * size + 128, field.infinite_places()
    with precision(bits):
        parts = []
        for x in basis:
            values = [field.embeddings.value(x.poly, v.index, bits) * 2**64 for v in places]
            row = [
                t
                for v, z in zip(places, values, strict=True)
                for t in ([z.real] if isinstance(v, RealPlace) else [z.real, z.imag])
            ]
            parts.append([int(t.mid().floor().unique_fmpz()) for t in row])
    short, steps = reduced(parts)
    largest = max(abs(t) for row in short for t in row)
    basis = [combination(u, [[x] for x in basis])[0] for u in steps]
    rows = [[int(c.p) for c in row] for row in coordinate_rows(field, basis).tolist()]
    return rows, [[t / largest for t in row] for row in short]
