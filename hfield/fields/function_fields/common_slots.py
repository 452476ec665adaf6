"""Common slots over GF(q)(t), q odd, and over ℚ(x): an e such that all (x, e) ramify only at given places.

Over GF(q), as over number fields, e is built from local classes by weak approximation with one new prime. It
is divisible by the primes that must divide it. Cofactors are tried until they are a square or a non-square,
as required, at every relevant prime: at the few of highest degree by chance, at the others by the Chinese
remainder theorem. At new primes the symbols must be 1; if there is only one new prime, they are 1 by the
product formula.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from hfield.core.product import Constants
from hfield.errors import UndecidedError
from hfield.fields.function_fields.places import FunctionPlace
from hfield.fields.function_fields.residues import FunctionResidues, ResidueField, residues_at
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.function_fields.symbols import ramified_places_functions, symbol
from hfield.fields.quadratic_forms.normal_forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Polynomial
    from hfield.fields.function_fields.quotients import RationalFunction


TRIALS = 50_000
SEARCHED = 600  # pairs of small polynomials over ℚ
LEFT_TO_CHANCE = 4
"""At how many places the class is not prescribed; each costs a factor 2 of trials and saves its degree."""

Fits: TypeAlias = "Callable[[FunctionPlace, RationalFunction], bool]"
SameClass = Callable[[NormalForm, NormalForm], bool]


@dataclass(frozen=True)
class _Local:
    """Local conditions on e at a prime π: its valuation, 0 or 1, and whether e/π^valuation is a square."""

    kappa: ResidueField
    valuation: int
    square: bool


def common_slot_functions(
    field: FunctionField, c: Constants, numbers: Sequence[RationalFunction]
) -> RationalFunction | None:
    """Return an e with (x, e) isomorphic to the given algebra for each of the numbers x, or None.

    None is a proof that there is no such e: at some place no class has the required symbols. The numbers are
    not 0, and the algebra is nondegenerate. Raises :class:`UndecidedError` if the random search fails.
    """
    ramified = ramified_places_functions(field, normal_form(field, c))
    reduced, primes = _square_classes(field, numbers)
    places = {str(v): v for v in (*primes, *ramified) if v.poly is not None}

    def fits(v: FunctionPlace, e: RationalFunction) -> bool:
        sign = -1 if v in ramified else 1
        return all(symbol(field, _form(x, e), v) == sign for x in reduced)

    locals_: list[_Local] = []
    for v in sorted(places.values(), key=lambda v: (v.degree, str(v))):
        found = _local_class(v, fits)
        if found is None:
            return None
        locals_.append(found)
    infinite = _classes_at_infinity(field, fits)
    return _search(field, [x.num for x in reduced], locals_, infinite) if infinite else None


def _form(a: RationalFunction, b: RationalFunction) -> NormalForm:
    return NormalForm("symbol", a, b, lambda q: q, lambda q: q)


def _square_classes(
    field: FunctionField, numbers: Sequence[RationalFunction]
) -> tuple[list[RationalFunction], list[FunctionPlace]]:
    """Return squarefree polynomials with the classes of the numbers, and their prime divisors."""
    reduced, primes = [], []
    for x in numbers:
        whole = x.num * x.den
        value = field.constant(field.base(whole.leading_coefficient()))
        for p, exponent in whole.factor()[1]:
            if exponent % 2:
                monic = field.quotient(field.one.num, p).den
                primes.append(FunctionPlace(field, monic))
                value = value * field.quotient(monic, field.one.num)
        reduced.append(value)
    return reduced, primes


def _local_class(v: FunctionPlace, fits: Fits) -> _Local | None:
    """Return one of the four classes at a prime that has the required symbols, a unit if possible."""
    kappa = residues_at(v)
    for power in (0, 1):
        for square in (True, False):
            unit = kappa.lift(_unit(kappa, square, random.Random(1)))
            if fits(v, unit * kappa.uniformiser if power else unit):
                return _Local(kappa, power, square)
    return None


def _unit(kappa: ResidueField, square: bool, rng: random.Random) -> Polynomial:
    """Return a random nonzero square of the residue field, or a random non-square."""
    while True:
        x = kappa.random(rng)
        if x != 0 and (square or not kappa.is_square(x)):
            return kappa.multiply(x, x) if square else x


def _classes_at_infinity(field: FunctionField, fits: Fits) -> set[tuple[int, bool]]:
    """Return which parities of the degree fit a leading coefficient that is a square, and which fit a
    non-square.
    """
    kappa = FunctionResidues(field, field.gen.num)
    good = set()
    for parity in (0, 1):
        for square in (True, False):
            unit = kappa.lift(_unit(kappa, square, random.Random(1)))
            if fits(FunctionPlace(field), unit * field.power(field.gen, parity)):
                good.add((parity, square))
    return good


def _search(
    field: FunctionField,
    numbers: list[Polynomial],
    places: list[_Local],
    infinite: set[tuple[int, bool]],
) -> RationalFunction:
    """Try cofactors u of increasing degree until ``u·∏ π^valuation`` fits at all places."""
    rng = random.Random(1)
    divisor = field.one.num
    for v in places:
        if v.valuation:
            divisor = divisor * v.kappa.modulus
    wanted = []  # at π: whether u has to be a square there
    for v in places:
        rest = divisor // v.kappa.modulus if v.valuation else divisor
        wanted.append((v.kappa, v.kappa.is_square(rest % v.kappa.modulus) == v.square))
    fixed, chance = wanted[:-LEFT_TO_CHANCE], wanted[-LEFT_TO_CHANCE:]
    constants = ResidueField(field, field.gen.num)
    for trial in range(TRIALS):
        u, modulus = _remainder(field, [(k, _unit(k, square, rng)) for k, square in fixed])
        for _ in range(1 + trial // 100):
            u, modulus = u + constants.random(rng) * modulus, modulus * field.gen.num
        if u == 0:
            continue
        e = u * divisor
        lead = constants.is_square(field.constant(field.base(e.leading_coefficient())).num)
        if (
            (int(e.degree()) % 2, lead) in infinite
            and all(u % k.modulus != 0 and k.is_square(u % k.modulus) == s for k, s in chance)
            and _fits_at_new_primes(field, numbers, u)
        ):
            return field.quotient(e, field.one.num)
    raise UndecidedError(
        f"no common slot over {field} was found among {TRIALS} polynomials of fitting local classes"
    )


def _remainder(
    field: FunctionField, residues: Sequence[tuple[ResidueField, Polynomial]]
) -> tuple[Polynomial, Polynomial]:
    """Return the polynomial with the given residues, of degree below that of the modulus, and the modulus."""
    x, modulus = field.zero.num, field.one.num
    for kappa, r in residues:
        step = kappa.multiply((r - x) % kappa.modulus, kappa.inverse(modulus % kappa.modulus))
        x, modulus = x + step * modulus, modulus * kappa.modulus
    return x, modulus


def _fits_at_new_primes(field: FunctionField, numbers: list[Polynomial], u: Polynomial) -> bool:
    """Return whether the numbers are squares at all primes that divide u to odd order; they are
    units there.
    """
    for p, exponent in u.factor()[1]:
        if exponent % 2:
            kappa = ResidueField(field, field.quotient(field.one.num, p).den)
            if not all(kappa.is_square(x % kappa.modulus) for x in numbers):
                return False
    return True


# --- over ℚ(x), by search: q times norms from F(i), so that (p, e) = (p, q) holds of itself ---------


def searched_slot(
    ring: FunctionField,
    outer: Constants[RationalFunction],
    inner: Constants[RationalFunction],
    same_class: SameClass,
) -> RationalFunction:
    """Return a common slot of two isomorphic algebras, found by search: candidates e are tried until (a, e) =
    (a, b) also holds.
    """
    for m, n in itertools.islice(_small_pairs(ring), SEARCHED):
        for first, second in ((inner, outer), (outer, inner)):
            e = first.b * (m * m - first.a * (n * n))
            if ring.is_zero(e):
                continue
            forms = [normal_form(ring, Constants(second.a, ring.zero, x)) for x in (e, second.b)]
            if same_class(*forms):
                return e
    raise UndecidedError(
        f"an isomorphism exists, but none with small numbers was found over {ring.name}"
    )


def _small_pairs(ring: FunctionField) -> Iterator[tuple[RationalFunction, RationalFunction]]:
    """Yield pairs of small polynomials over ℚ, not both 0."""
    seen: list[RationalFunction] = []
    for x in _small(ring):
        seen.append(x)
        for y in seen[:-1]:
            yield x, y
            yield y, x


def _small(ring: FunctionField) -> Iterator[RationalFunction]:
    """Yield small polynomials, 0 and 1 first."""
    yield ring.zero
    yield ring.one
    digits = [ring(x) for x in (0, 1, -1, 2)]
    for degree in itertools.count(1):
        for leading, *rest in itertools.product(digits, repeat=degree + 1):
            if not ring.is_zero(leading):
                value = leading
                for x in rest:
                    value = value * ring.gen + x
                yield value
