"""Orders, ideals and answers over the integers of a number field as certificates ``hfield-cert/2``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import flint

from hfield.checker.glossary import (
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
from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.evidence import Claim
from hfield.fields.number_fields.classes import evidence
from hfield.fields.number_fields.classes.s_units import s_units
from hfield.fields.number_fields.integral_basis import coordinate_rows
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.over_integers.equivalence import two_generators
from hfield.orders.over_integers.positive_generators import totally_positive_generator
from hfield.orders.short_elements import reduced

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.orders.basis import AlgebraBasis


def of_class_set(classes: Any) -> Claim:
    """Return how many right ideal classes an order has, with one ideal of each."""
    order, ambient = classes.order, classes.ambient
    ring, algebra = ambient.base.ring, ambient.algebra
    statement = f"ideal-classes{{{text(order)}; {len(classes)}}}"
    s = s_units(ring)
    shown = {
        "kind": "ideal-classes",
        **_units(ambient),
        "narrow": [_product(ring, a) for a in classes.keys.narrow.ideals],
        "primes": _primes(order),
        "classes": [_ideal(classes, n) for n in range(len(classes))],
    }
    cited = (*evidence.cited(s), SIEGEL, MASS_OVER_FIELDS)
    return Claim(algebra, statement, shown, BY_MASS, assumes=cited)


def _primes(order: Any) -> list[Any]:
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


def _units(ambient: AlgebraBasis) -> dict[str, Any]:
    """Return what shows the units of the field."""
    ring = ambient.base.ring
    units = [ambient.base.inside(u) for u in ring.unit_group().generators]
    shown = evidence.evidence(s_units(ring))
    return {"units": shown, "fundamental": [ambient.base.field.coordinates(u) for u in units]}


def _ideal(classes: Any, n: int) -> dict[str, Any]:
    """Return a basis in which short vectors are found quickly, and what generates the norm."""
    nu = classes.norms[n].element
    return {
        **_basis(classes.lattices[n], nu.inverse()),
        "norm": classes.ambient.base.field.coordinates(nu),
        "narrow": classes.norms[n].number,
    }


def _basis(lattice: LatticeValue, c: FieldElement) -> dict[str, Any]:
    """Return a basis of a lattice that is reduced for Tr(c·N(x))."""
    den, table = _coordinates(lattice.ambient, reduced(lattice.ambient, lattice.rows, c)[1])
    return {"den": den, "rows": table}


def _coordinates(ambient: AlgebraBasis, rows: flint.fmpq_mat) -> tuple[int, list[list[int]]]:
    """Return elements w + x·i + y·j + z·k as rows over a denominator: w, x, y, z in the integral basis."""
    elements = [
        ambient.base.inside(x) for row in rows.tolist() for x in ambient.quaternion(row).coordinates
    ]
    entries = coordinate_rows(ambient.base.field, elements).entries()
    numbers, den = flint.fmpq_mat(rows.nrows(), ambient.size, entries).numer_denom()
    return int(den), [list(map(int, row)) for row in numbers.tolist()]


def element_json(ambient: AlgebraBasis, row: flint.fmpq_mat) -> dict[str, Any]:
    """Return an element as evidence has it: a row over a denominator."""
    den, table = _coordinates(ambient, row)
    return {"den": den, "row": table[0]}


def text(lattice: Any) -> str:
    """Write a basis over ℤ as statements do."""
    write: Any = lattice.algebra.ring.text
    return " | ".join(",".join(map(write, q.coordinates)) for q in lattice.basis)


def _claim(
    ambient: AlgebraBasis, statement: str, method: str, verdict: str = "proved", **shown: Any
) -> Claim:
    """Return a statement with its evidence; its kind is the first word."""
    kind = statement.partition("{")[0]
    cited: tuple[str, ...] = ()
    if "units" in shown:
        cited = evidence.cited(s_units(ambient.base.ring))
    else:
        shown["basis"] = _integral_basis(ambient)
    return Claim(
        ambient.algebra, statement, {"kind": kind, **shown}, method, verdict, assumes=cited
    )


def _integral_basis(ambient: AlgebraBasis) -> list[Any]:
    return [ambient.base.field.coordinates(w) for w in ambient.base.integral_basis]


def of_units(order: Any, word: str, parts: list[str], shown: dict[str, Any], *cited: str) -> Claim:
    """Return a statement about the units of norm 1 of an order that splits at one real place."""
    kind = f"{word}-over-integers"
    data = {
        "kind": kind,
        "basis": _integral_basis(order.value.ambient),
        "primes": _primes(order),
        **shown,
    }
    statement = f"{kind}{{{'; '.join([text(order), *parts])}}}"
    return Claim(order.algebra, statement, data, BY_AREA, assumes=(SIEGEL, SHIMIZU, *cited))


def of_order(order: Any) -> Claim:
    """Return that this is an order, and the norm of its reduced discriminant."""
    statement = f"order-over-integers{{{text(order)}; {order.norm_of_discriminant()}}}"
    return _claim(order.value.ambient, statement, ORDER)


def of_ideal(ideal: Any) -> Claim:
    """Return that this is a locally principal ideal of its order, and the norm of its reduced norm."""
    about = f"{text(ideal)}; {ideal.side}; {text(ideal.order)}; {ideal.norm().norm()}"
    return _claim(ideal.value.ambient, f"ideal-over-integers{{{about}}}", IDEAL)


def of_unit_index(order: Any) -> Claim:
    """Return how many units there are modulo those of the field."""
    ambient = order.value.ambient
    statement = f"unit-index{{{text(order)}; {order.unit_index()}}}"
    basis = _basis(order.value, ambient.base.field.one)
    return _claim(ambient, statement, ENUMERATION, **_units(ambient), order=basis)


def of_equivalence(first: Any, second: Any, element: Quaternion | None) -> Claim:
    """Return that an element carries one ideal to another, or that none does."""
    ambient = first.value.ambient
    statement = f"equivalent-over-integers{{{first.side}; {text(first)}; {text(second)}}}"
    if element is not None:
        return _claim(
            ambient, statement, ELEMENT, element=element_json(ambient, ambient.row(element))
        )
    quotient = second.norm() / first.norm()
    nu = totally_positive_generator(quotient)
    shown = _units(ambient)
    if nu is None:
        found = _product(ambient.base.ring, quotient)
        return _claim(ambient, statement, NORM, "refuted", **shown, quotient=found)
    pair = (first, second) if first.side == "left" else (first.conjugate(), second.conjugate())
    between = (pair[0].inverse() * pair[1]).value
    shown |= {"norm": ambient.base.field.coordinates(nu), "between": _basis(between, nu.inverse())}
    return _claim(ambient, statement, ENUMERATION, "refuted", **shown)


def of_isomorphism(first: Any, second: Any, element: Quaternion | None) -> Claim:
    """Return that an element conjugates one order into another, or that the orders are not isomorphic."""
    ambient = first.value.ambient
    statement = f"isomorphic-over-integers{{{text(first)}; {text(second)}}}"
    if element is not None:
        return _claim(
            ambient, statement, ELEMENT, element=element_json(ambient, ambient.row(element))
        )
    if first.norm_of_discriminant() != second.norm_of_discriminant():
        return _claim(ambient, statement, DISCRIMINANT, "refuted")
    pair = [element_json(ambient, x) for x in two_generators(first.value)]
    basis = _basis(second.value, ambient.base.field.one)
    return _claim(ambient, statement, ENUMERATION, "refuted", pair=pair, order=basis)
