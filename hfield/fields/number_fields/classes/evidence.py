"""Evidence for class groups and units, made of S-units, for an independent checker."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from hfield.checker.glossary import (
    ARTIN,
    BY_S_UNITS,
    CUSICK,
    FRIEDMAN,
    HERMITE,
    MINKOWSKI,
    REDUCED_FORMS,
    ZIMMERT,
)
from hfield.core.primality import primes
from hfield.evidence import CertifiedClaim
from hfield.fields.number_fields.classes import s_units
from hfield.fields.number_fields.classes.s_units import SUnits
from hfield.fields.number_fields.integral_basis import coordinate_rows

if TYPE_CHECKING:
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.fields.number_fields.ring import NumberField

CITED = {s_units.FRIEDMAN: FRIEDMAN, s_units.ARTIN: ARTIN, s_units.CUSICK: CUSICK}


def evidence(s: SUnits) -> dict[str, object]:
    """Return the evidence as JSON data (docs/reference/certificates.md), with prime ideals as numbers."""
    coordinates = s.field.coordinates
    listed: list[list[object]] = []
    number: dict[PrimeIdeal, int] = {}
    for p in primes(s.bound + 1):
        above = list(s.frame.field.primes_above(p))
        number |= {P: len(number) + k for k, P in enumerate(above)}
        listed.append([p, seconds_above(s, p)])
    return {
        "kind": "S-units",
        "basis": [coordinates(w) for w in s.frame.basis],
        "primes": listed,
        "S": [number[s.base[k]] for k in s.primes],
        "reductions": [[number[s.base[k]], coordinates(x)] for k, (x, _) in s.reductions.items()],
        "generators": [coordinates(x) for x in s.generators],
        "torsion": {
            "order": s.order_of_torsion,
            "generator": coordinates(s.torsion),
            "residues": _residues(s),
        },
        "saturated": [
            [ell, [list(pair) for pair in s.saturated[ell]]] for ell in s.possible_divisors()
        ],
    }


def seconds_above(s: SUnits, p: int) -> list[list[int]]:
    """Return the second generators of the prime ideals above p, in the integral basis."""
    return [_second(s, P) for P in s.frame.field.primes_above(p)]


def cited(s: SUnits) -> tuple[str, ...]:
    """Return the theorems that show that all S-units were found."""
    if s.n == 2:
        return (REDUCED_FORMS,)
    bound = MINKOWSKI if s.has_primes_to(s_units.minkowski(s.frame)) else ZIMMERT
    if not s.rank:
        return (bound,)
    regulator, source = s.known_regulator
    listed = {*s.possible_divisors()}
    is_known = all(ell in listed for ell in primes(s.unit_index_bound(regulator) + 1))
    return (bound, CITED[source] if is_known else HERMITE)


def _second(s: SUnits, P: PrimeIdeal) -> list[int]:
    """Return the second generator of a prime ideal in the integral basis, times an integer prime to p."""
    if P.is_inert:
        return [0] * s.n
    rows, _ = coordinate_rows(s.field, [P.pi]).numer_denom()
    return [int(c) for c in rows.entries()]


def _residues(s: SUnits) -> list[list[int]]:
    """Return primes q with simple roots modulo q, such that the gcd of the q − 1 is the number of roots of
    unity.
    """
    if s.field.signature[0]:
        return []
    found, common = [], 0
    for q in primes():
        if q < s.n + 2 or (common and (q - 1) % common == 0):
            continue
        if roots := s_units.simple_roots(s.field, q):
            found.append([q, roots[0]])
            common = math.gcd(common, q - 1)
            if common == s.order_of_torsion:
                return found
    return found


def claim(s: SUnits, ring: NumberField, statement: str) -> CertifiedClaim:
    """Return a statement about a field, with the S-units that prove it."""
    algebra = f"(-1,-1|{ring.name})"
    return CertifiedClaim(algebra, statement, evidence(s), BY_S_UNITS, assumes=cited(s), ring=ring)
