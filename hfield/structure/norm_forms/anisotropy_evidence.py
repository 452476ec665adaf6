"""Why a norm form is 0 only at 0, as evidence that the checker of certificates accepts."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from typing import Any

from hfield.certificates.places import is_certified
from hfield.errors import UndecidedError
from hfield.factorisation import is_prime
from hfield.product import Constants
from hfield.rings.base import Ring
from hfield.rings.function_places import FunctionPlace
from hfield.rings.functions import FunctionField
from hfield.rings.integers import QQ
from hfield.rings.quadratic import QuadraticField
from hfield.rings.quadratic_places import QuadraticPlace
from hfield.structure.forms import discriminant, normal_form
from hfield.structure.function_fields.conic_bundle import inverted
from hfield.structure.function_fields.residue_field import ResidueField
from hfield.structure.minimise import Vector
from hfield.structure.norm_forms.local_order import unit_and_prime
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm
from hfield.structure.quadratic_fields.hilbert_quadratic import p_adic_root, pair
from hfield.structure.quadratic_fields.prime_ideals import primes_above
from hfield.structure.rationals.hilbert_rationals import hilbert_symbol_q, ramified_places_q
from hfield.structure.rationals.prime_numbers import PrimePlace
from hfield.structure.rationals.whole_numbers import fraction, square_class

POINTS, FEW = 400, 5  # values tried for a specialisation; those at which all primes are looked for
SMALL = [p for p in range(2, 1_000) if is_prime(p)]

Evidence = Mapping[str, Any]


def norm_evidence(algebra: str, ring: Ring, c: Constants, answer: ZeroNorm) -> Evidence | None:
    """Return the evidence for an answer without element, or None where there is none that is checked."""
    for data in _candidates(ring, c, answer):
        if is_certified(algebra, ring.name, data):
            return data
    return None


def _candidates(ring: Ring, c: Constants, answer: ZeroNorm) -> Iterator[Evidence]:
    if answer.method in ("ordering", "level"):
        yield {"by": answer.method}
        return
    if isinstance(ring, FunctionField) and ring.base.order is None:
        yield from _specialised(ring, c)
        return
    yield from evidence_at(ring, c, answer.places)


def evidence_at(ring: Ring, c: Constants, places: Iterable[Any]) -> Iterator[Evidence]:
    """Yield the evidence at those places where the algebra is ramified and residues are finite."""
    for place in places:
        found = _unit_and_prime(ring, c, place)
        if found is not None:
            u, j = ([ring.text(ring(x)) for x in v] for v in found)
            yield {"by": "place", "place": str(place), "u": u, "j": j}


def _unit_and_prime(ring: Ring, c: Constants, place: Any) -> tuple[Vector, Vector] | None:
    """Return two quaternions that show the norm form to be 0 only at 0 over the completion at a place."""
    if isinstance(ring, FunctionField) and isinstance(place, FunctionPlace):
        if place.poly is not None:
            return unit_and_prime(ResidueField(ring, place.poly), c, ring.one)
        turned = Constants(*(inverted(ring, x) for x in c))
        found = unit_and_prime(ResidueField(ring, ring.gen.num), turned, ring.one)
        if found is None:
            return None
        u, j = ([inverted(ring, x) for x in v] for v in found)
        return u, j
    if isinstance(ring, QuadraticField) and isinstance(place, QuadraticPlace) and place.prime:
        if place.root is None:
            return unit_and_prime(primes_above(ring, place.prime)[0], c, ring.one)
        return unit_and_prime(PrimePlace(place.prime), _completed(ring, c, place), Fraction(1))
    if ring.name == "QQ" and isinstance(place, int):
        rational = Constants(*(fraction(x) for x in c))
        return unit_and_prime(PrimePlace(place), rational, Fraction(1))
    return None


def _completed(ring: QuadraticField, c: Constants, place: QuadraticPlace) -> Constants:
    """Return rational numbers close to the images of the constants at a place that splits."""
    pairs = [pair(ring, x) for x in c]
    sizes = sum(abs(n).bit_length() for u in pairs for x in u for n in (x.numerator, x.denominator))
    root = p_adic_root(place, 2 * sizes // place.prime.bit_length() + 12)
    return Constants(*(u + v * root for u, v in pairs))


def _specialised(ring: FunctionField, c: Constants) -> Iterator[Evidence]:
    """Yield values of the variable at which an algebra over ℚ(x) becomes a division algebra over ℚ.

    There are infinitely many if it is one itself: ℚ is Brauer–Hilbertian (Fein, Saltman and Schacher, *Trans.
    Amer. Math. Soc.* 334 (1992)). At most of them a small prime is ramified.
    """
    for n in range(POINTS):
        point = QQ((n + 1) // 2 * (-1) ** n)
        if any(x.den(point) == 0 for x in c):
            continue
        special = Constants(*(x.num(point) / x.den(point) for x in c))
        if not discriminant(special):
            continue
        proof = _rational(special, every=n < FEW)
        if proof is not None:
            yield {"by": "specialisation", "at": QQ.text(point), "proof": proof}


def _rational(c: Constants, every: bool) -> Evidence | None:
    """Return evidence over ℚ; from small primes alone, or from ``every`` prime if these can be found."""
    form = normal_form(QQ, c)
    if form.a < 0 and form.b < 0:
        return {"by": "ordering"}
    whole = square_class(form.a) * square_class(form.b)
    primes: Iterable[Any] = (
        p for p in SMALL if (p == 2 or whole % p == 0) and hilbert_symbol_q(form.a, form.b, p) < 0
    )
    if every:
        with suppress(UndecidedError):
            primes = ramified_places_q(form.a, form.b)
    return next(evidence_at(QQ, c, primes), None)
