"""Orders, ideals and answers over the integers of a number field as certificates ``hfield-cert/2``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import flint

from hfield.certificates.glossary import (
    BY_AREA,
    BY_MASS,
    DISCRIMINANT,
    ELEMENT,
    ENUMERATION,
    IDEAL,
    MASS_OVER_FIELDS,
    NORM,
    ORDER,
    SHIMIZU,
    SIEGEL,
)
from hfield.evidence import Claim
from hfield.factorisation import factorise
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.number_fields.integral_basis import coordinate_rows
from hfield.orders.over_integers.equivalence import two_generators
from hfield.orders.over_integers.positive_generators import totally_positive_generator
from hfield.orders.over_integers.trace_forms import trace_forms
from hfield.primality import is_prime

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.orders.over_integers.frames import Frame
    from hfield.orders.over_integers.lattices import (
        IntegersClassSet,
        IntegersIdeal,
        IntegersLattice,
        IntegersOrder,
    )


def of_class_set(classes: IntegersClassSet) -> Claim:
    """Return how many right ideal classes an order has, with one ideal of each."""
    order, frame = classes.order, classes.frame
    ring, algebra = frame.integers.ring, frame.algebra
    statement = f"ideal-classes{{{text(order)}; {len(classes)}}}"
    s = s_units(ring)
    shown = {
        "kind": "ideal-classes",
        **_units(frame),
        "narrow": [_product(ring, a) for a in classes.keys.narrow.ideals],
        "primes": _primes(order),
        "classes": [_ideal(classes, n) for n in range(len(classes))],
    }
    cited = (*evidence.cited(s), SIEGEL, MASS_OVER_FIELDS)
    return Claim(algebra, statement, shown, BY_MASS, assumes=cited)


def _primes(order: IntegersOrder) -> list[Any]:
    """Return the prime ideals that the mass formula and Siegel's ask for."""
    s = s_units(order.algebra.ring)
    # σ₁ is summed over ideals of norm at most the discriminant, whose square factors have to be known
    wanted = {p for p in range(2, math.isqrt(s.field.discriminant()) + 1) if is_prime(p)}
    wanted |= set(factorise(int(order.norm_of_discriminant())))
    return [[p, evidence.seconds_above(s, p)] for p in sorted(wanted)]


def _product(ring: Any, a: Ideal) -> list[Any]:
    """Return x and exponents with a = x·∏P^e, P in S."""
    x, exponents = ring.class_group().factors(a)
    return [x.field.coordinates(x), list(map(int, exponents))]


def _units(frame: Frame) -> dict[str, Any]:
    """Return what shows the units of the field."""
    ring = frame.integers.ring
    units = [frame.integers.inside(u) for u in ring.unit_group().generators]
    shown = evidence.evidence(s_units(ring))
    return {"units": shown, "fundamental": [frame.field.coordinates(u) for u in units]}


def _ideal(classes: IntegersClassSet, n: int) -> dict[str, Any]:
    """Return a basis in which short vectors are found quickly, and what generates the norm."""
    nu = classes.norms[n].element
    return {
        **_basis(classes.frame, classes.lattices[n], nu.inverse()),
        "norm": classes.frame.field.coordinates(nu),
        "narrow": classes.norms[n].number,
    }


def _basis(frame: Frame, rows: flint.fmpq_mat, c: FieldElement) -> dict[str, Any]:
    """Return a basis of a lattice that is reduced for Tr(c·N(x))."""
    den, table = _coordinates(frame, trace_forms(frame).reduced(rows, c)[1])
    return {"den": den, "rows": table}


def _coordinates(frame: Frame, rows: flint.fmpq_mat) -> tuple[int, list[list[int]]]:
    """Return elements w + x·i + y·j + z·k as rows over a denominator: w, x, y, z in the integral basis."""
    elements = [
        frame.integers.inside(x) for row in rows.tolist() for x in frame.quaternion(row).coordinates
    ]
    entries = coordinate_rows(frame.field, elements).entries()
    numbers, den = flint.fmpq_mat(rows.nrows(), frame.size, entries).numer_denom()
    return int(den), [list(map(int, row)) for row in numbers.tolist()]


def element_json(frame: Frame, row: flint.fmpq_mat) -> dict[str, Any]:
    """Return an element as evidence has it: a row over a denominator."""
    den, table = _coordinates(frame, row)
    return {"den": den, "row": table[0]}


def text(lattice: IntegersLattice) -> str:
    """Write a basis over ℤ as statements do."""
    write: Any = lattice.algebra.ring.text
    return " | ".join(",".join(map(write, q.coordinates)) for q in lattice.basis)


def _claim(
    frame: Frame, statement: str, method: str, verdict: str = "proved", **shown: Any
) -> Claim:
    """Return a statement with its evidence; its kind is the first word."""
    kind = statement.partition("{")[0]
    cited: tuple[str, ...] = ()
    if "units" in shown:
        cited = evidence.cited(s_units(frame.integers.ring))
    else:
        shown["basis"] = _integral_basis(frame)
    return Claim(frame.algebra, statement, {"kind": kind, **shown}, method, verdict, assumes=cited)


def _integral_basis(frame: Frame) -> list[Any]:
    return [frame.field.coordinates(w) for w in frame.omega]


def of_units(
    order: IntegersOrder, word: str, parts: list[str], shown: dict[str, Any], *cited: str
) -> Claim:
    """Return a statement about the units of norm 1 of an order that splits at one real place."""
    kind = f"{word}-over-integers"
    data = {"kind": kind, "basis": _integral_basis(order.frame), "primes": _primes(order), **shown}
    statement = f"{kind}{{{'; '.join([text(order), *parts])}}}"
    return Claim(order.algebra, statement, data, BY_AREA, assumes=(SIEGEL, SHIMIZU, *cited))


def of_order(order: IntegersOrder) -> Claim:
    """Return that this is an order, and the norm of its reduced discriminant."""
    statement = f"order-over-integers{{{text(order)}; {order.norm_of_discriminant()}}}"
    return _claim(order.frame, statement, ORDER)


def of_ideal(ideal: IntegersIdeal) -> Claim:
    """Return that this is a locally principal ideal of its order, and the norm of its reduced norm."""
    about = f"{text(ideal)}; {ideal.side}; {text(ideal.order)}; {ideal.norm().norm()}"
    return _claim(ideal.frame, f"ideal-over-integers{{{about}}}", IDEAL)


def of_unit_index(order: IntegersOrder) -> Claim:
    """Return how many units there are modulo those of the field."""
    frame = order.frame
    statement = f"unit-index{{{text(order)}; {order.unit_index()}}}"
    basis = _basis(frame, order.rows, frame.field.one)
    return _claim(frame, statement, ENUMERATION, **_units(frame), order=basis)


def of_equivalence(
    first: IntegersIdeal, second: IntegersIdeal, element: Quaternion | None
) -> Claim:
    """Return that an element carries one ideal to another, or that none does."""
    frame = first.frame
    statement = f"equivalent-over-integers{{{first.side}; {text(first)}; {text(second)}}}"
    if element is not None:
        return _claim(frame, statement, ELEMENT, element=element_json(frame, frame.row(element)))
    quotient = second.norm() / first.norm()
    nu = totally_positive_generator(quotient)
    shown = _units(frame)
    if nu is None:
        found = _product(frame.integers.ring, quotient)
        return _claim(frame, statement, NORM, "refuted", **shown, quotient=found)
    pair = (first, second) if first.side == "left" else (first.conjugate(), second.conjugate())
    rows = (pair[0].inverse() * pair[1]).rows
    shown |= {"norm": frame.field.coordinates(nu), "between": _basis(frame, rows, nu.inverse())}
    return _claim(frame, statement, ENUMERATION, "refuted", **shown)


def of_isomorphism(
    first: IntegersOrder, second: IntegersOrder, element: Quaternion | None
) -> Claim:
    """Return that an element conjugates one order into another, or that the orders are not isomorphic."""
    frame = first.frame
    statement = f"isomorphic-over-integers{{{text(first)}; {text(second)}}}"
    if element is not None:
        return _claim(frame, statement, ELEMENT, element=element_json(frame, frame.row(element)))
    if first.norm_of_discriminant() != second.norm_of_discriminant():
        return _claim(frame, statement, DISCRIMINANT, "refuted")
    pair = [element_json(frame, x) for x in two_generators(frame, first.rows)]
    basis = _basis(frame, second.rows, frame.field.one)
    return _claim(frame, statement, ENUMERATION, "refuted", pair=pair, order=basis)
