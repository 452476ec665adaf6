"""Numbers with given Hilbert symbols, common slots, and algebras from their ramification, over number fields.

An e for which every (x, e) ramifies at given places and nowhere else is built as a zero of a quadratic form
is in the theorem of Hasse and Minkowski (Serre, *A Course in Arithmetic*, chapter IV, §3): above each prime
that matters a class is picked, and numbers in these classes with the signs asked for are tried until, apart
from these primes, only one prime ideal divides them. There the symbols are right by the product formula.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator, Sequence

import flint

from hfield.errors import RingError, UndecidedError, shorten
from hfield.factorisation import remove
from hfield.primality import is_probable_prime
from hfield.rings.number_elements import FieldElement
from hfield.rings.number_field import NumberField
from hfield.rings.number_field_places import Place, RealPlace, place_of_number_field
from hfield.rings.number_primes import PrimeIdeal, primes_above
from hfield.structure.number_fields.dyadic_symbol import DyadicPrime
from hfield.structure.number_fields.hilbert_number_fields import (
    candidates,
    hilbert_symbol_number_field,
    ramified_places_number_field,
)
from hfield.structure.number_fields.integral_basis import coordinate_rows
from hfield.structure.rationals.whole_numbers import crt

TRIALS = 20_000
LOCAL_TRIALS = 400
TWOS = 2**5  # symbols above 2 of an e of valuation at most 1 hang on e modulo this


def common_slot(numbers: Sequence[FieldElement], ramified: Collection[Place]) -> FieldElement:
    """Return an e with (x, e) ramified exactly at the given places, for each of the numbers x.

    Raises :class:`UndecidedError` where the norms are too hard to factor, or where no e was found, because
    there is none or by bad luck.
    """
    field, rng = numbers[0].field, random.Random(1)
    relevant = {2}.union(*(candidates(field, x) for x in numbers))
    relevant |= {v.p for v in ramified if isinstance(v, PrimeIdeal)}
    classes = [_local_class(p, numbers, ramified, rng) for p in sorted(relevant)]
    signs = [_sign(v, numbers, ramified) for v in field.real_places()]
    for e in _lifts(field, classes, signs, rng):
        rest = abs(int(e.norm().p))
        for p in relevant:
            rest = remove(rest, p)[1]
        if (rest == 1 or is_probable_prime(rest)) and all(
            set(ramified_places_number_field(x, e)) == set(ramified) for x in numbers
        ):
            return e
    raise UndecidedError(
        f"no number of {field.name} with the symbols asked for was found among {TRIALS} of fitting classes"
    )


def from_ramification_number_field(
    field: NumberField, named: Sequence[Place | str]
) -> tuple[FieldElement, FieldElement]:
    """Return (a, b) such that ``(a, b | K)`` ramifies exactly at the places named.

    Raises :class:`RingError` unless they are even in number, different, and none of them complex.
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
        a = _small(field, 1 + trial // 200, rng)
        if a and all(not is_local_square(v, a) for v in places):
            return a, common_slot([a], places)
    raise UndecidedError(
        f"no small number of {shorten(field.name)} that is a square at none of the places was found"
    )


def _small(field: NumberField, size: int, rng: random.Random) -> FieldElement:
    x: FieldElement = field.zero
    for w in field.integral_basis():
        x = x + w * rng.randint(-size, size)
    return x


def is_local_square(place: Place, x: FieldElement) -> bool:
    """Tell whether x ≠ 0 is a square in the completion at a place."""
    if isinstance(place, RealPlace):
        return place.sign(x) > 0
    if not isinstance(place, PrimeIdeal):
        return True
    v, unit = place.unit_part(x)
    if v % 2:
        return False
    if place.p == 2:
        integral = place.order.truncated(place.integral(unit), TWOS * 2)
        return DyadicPrime(place).defect(integral)[0] > 2 * place.e
    residue = place.residue_of(unit)
    if place.f == 1:
        return int(flint.fmpz(int(residue[0])).jacobi(place.p)) == 1
    return bool(residue.pow_mod((place.norm - 1) // 2, place.residue) == 1)


def _wanted(place: Place, ramified: Collection[Place]) -> int:
    return -1 if place in ramified else 1


def _sign(place: RealPlace, numbers: Sequence[FieldElement], ramified: Collection[Place]) -> int:
    """Return the sign that e must have at a real place, 1 where either will do."""
    for sign in (1, -1):
        if all(
            (-1 if sign < 0 and place.sign(x) < 0 else 1) == _wanted(place, ramified)
            for x in numbers
        ):
            return sign
    raise UndecidedError(f"no number has the symbols asked for at {place}")


def _local_class(
    p: int, numbers: Sequence[FieldElement], ramified: Collection[Place], rng: random.Random
) -> tuple[list[int], int]:
    """Return coordinates in the integral basis, and a modulus, for the prime p.

    What is congruent to them has the symbols asked for at the places above p, and valuations 0 or 1 there.
    """
    field, modulus = numbers[0].field, TWOS if p == 2 else p * p
    e: FieldElement = field.zero
    for prime in primes_above(field, p):
        part = _number_at(prime, numbers, ramified, rng)
        # 1 modulo a power of the prime, 0 modulo a power of the others: 3ε² − 2ε³ doubles the exponents
        unit = prime.idempotent
        for _ in range(3 if p == 2 else 1):
            unit = prime.order.truncated(unit * unit * (3 - 2 * unit), modulus)
        e = prime.order.truncated(e + unit * prime.order.truncated(part, modulus), modulus)
    coordinates = coordinate_rows(field, [e]).entries()
    return [int(c.p) * pow(int(c.q), -1, modulus) % modulus for c in coordinates], modulus


def _number_at(
    prime: PrimeIdeal,
    numbers: Sequence[FieldElement],
    ramified: Collection[Place],
    rng: random.Random,
) -> FieldElement:
    """Return an integer of valuation 0 or 1 with the symbols asked for at one prime ideal."""
    wanted = _wanted(prime, ramified)
    for trial in range(LOCAL_TRIALS):
        e: FieldElement = prime.field.one
        if trial > 1:
            coordinates = [rng.randrange(max(prime.p, 8)) for _ in range(prime.field.degree)]
            e = prime.order.element(coordinates)
            if not e or prime.valuation(e):
                continue
        if trial % 2:
            e = e * prime.uniformiser
        if all(hilbert_symbol_number_field(x, e, prime) == wanted for x in numbers):
            return e
    raise UndecidedError(f"no number was found that has the symbols asked for at {prime}")


def _lifts(
    field: NumberField, classes: list[tuple[list[int], int]], signs: list[int], rng: random.Random
) -> Iterator[FieldElement]:
    """Run through random numbers with the given classes and signs at the real places, of growing size."""
    import numpy as np

    basis, n = field.integral_basis(), field.degree
    residues = [crt((c[k], m) for c, m in classes) for k in range(n)]
    modulus = residues[0][1]
    places = field.infinite_places()
    values = [[complex(v.value(w, 15)) for v in places] for w in basis]
    rows = [
        [
            t
            for v, z in zip(places, row, strict=True)
            for t in ([z.real] if isinstance(v, RealPlace) else [z.real, z.imag])
        ]
        for row in values
    ]
    inverse = np.linalg.inv(np.array(rows))
    start = np.array([float(r) / modulus for r, _ in residues])
    for trial in range(TRIALS):
        # a point with the right signs, in units of the modulus, and the number next to it in the class
        size = 1 + trial / 200
        target = np.array(
            [s * rng.uniform(0.5, 1.5) * size for s in signs]
            + [rng.uniform(-size, size) for _ in range(n - len(signs))]
        )
        steps = np.rint(target @ inverse - start)
        e: FieldElement = field.zero
        for w, (r, _), step in zip(basis, residues, steps, strict=True):
            e = e + w * (r + modulus * int(step))
        if e and all(v.sign(e) == s for v, s in zip(field.real_places(), signs, strict=True)):
            yield e
