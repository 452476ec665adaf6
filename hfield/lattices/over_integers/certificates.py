"""Class sets over the integers of a number field as certificates ``hfield-cert/2``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import flint

from hfield.certificates.glossary import BY_MASS, MASS_OVER_FIELDS, SIEGEL
from hfield.evidence import Claim
from hfield.factorisation import factorise
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.number_fields.integral_basis import coordinate_rows
from hfield.lattices.over_integers.trace_forms import trace_forms
from hfield.primality import is_prime

if TYPE_CHECKING:
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.lattices.over_integers.lattices import IntegersClassSet


def of_class_set(classes: IntegersClassSet) -> Claim:
    """Return how many right ideal classes an order has, with one ideal of each."""
    order, frame = classes.order, classes.frame
    ring, algebra = frame.integers.ring, frame.algebra
    text = " | ".join(",".join(map(ring.text, q.coordinates)) for q in order.basis)
    statement = f"ideal-classes{{{text}; {len(classes)}}}"
    s = s_units(ring)
    # σ₁ is summed over ideals of norm at most the discriminant, whose square factors have to be known
    wanted = {p for p in range(2, math.isqrt(s.field.discriminant()) + 1) if is_prime(p)}
    wanted |= set(factorise(int(order.norm_of_discriminant())))
    units = [frame.integers.inside(u) for u in ring.unit_group().generators]
    shown = {
        "kind": "ideal-classes",
        "units": evidence.evidence(s),
        "fundamental": [frame.field.coordinates(u) for u in units],
        "narrow": [_product(ring, a) for a in classes.keys.narrow.ideals],
        "primes": [[p, evidence.seconds_above(s, p)] for p in sorted(wanted)],
        "classes": [_ideal(classes, n) for n in range(len(classes))],
    }
    cited = (*evidence.cited(s), SIEGEL, MASS_OVER_FIELDS)
    return Claim(algebra, statement, shown, BY_MASS, assumes=cited)


def _product(ring: Any, a: Ideal) -> list[Any]:
    """Return x and exponents with a = x·∏P^e, P in S."""
    x, exponents = ring.class_group().factors(a)
    return [x.field.coordinates(x), list(map(int, exponents))]


def _ideal(classes: IntegersClassSet, n: int) -> dict[str, Any]:
    """Return a basis in which short vectors are found quickly, and what generates the norm."""
    frame, nu, rows = classes.frame, classes.norms[n].element, classes.lattices[n]
    form = trace_forms(frame).form(nu.inverse())
    whole, _ = (rows * form * rows.transpose()).numer_denom()
    reduced = flint.fmpq_mat(whole.lll(transform=True, rep="gram")[1]) * rows
    elements = [
        frame.integers.inside(x)
        for row in reduced.tolist()
        for x in frame.quaternion(row).coordinates
    ]
    entries = coordinate_rows(frame.field, elements).entries()
    numbers, den = flint.fmpq_mat(frame.size, frame.size, entries).numer_denom()
    return {
        "den": int(den),
        "rows": [list(map(int, row)) for row in numbers.tolist()],
        "norm": frame.field.coordinates(nu),
        "narrow": classes.norms[n].number,
    }
