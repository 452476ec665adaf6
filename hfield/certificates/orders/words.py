"""The words of certificates about lattices, and the evidence that shows or refutes them.

``order{L; n}`` · ``order{L; n; maximal}`` · ``ideal{I; side; O; norm}`` · ``equivalent{side; I; J}`` ·
``isomorphic-orders{O; P}`` · ``embedding{O; d}`` · ``class-set{O; h}``. A lattice is written as
four rows of rational numbers, ``1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1/2,1/2,1/2,1/2``.
"""

import re
from collections.abc import Callable
from fractions import Fraction
from math import gcd
from typing import Any

from hfield.certificates.finding import Finding
from hfield.certificates.glossary import (
    BY_MASS,
    DISCRIMINANT,
    ELEMENT,
    ENUMERATION,
    FIELD,
    IDEAL,
    MASS,
    NORM,
    ORDER,
)
from hfield.certificates.orders.algebra import Algebra, times
from hfield.certificates.orders.classes import need_class_set
from hfield.certificates.orders.enumeration import short_vectors
from hfield.certificates.orders.lattice import Element, Lattice, inverse, rational_rows, root
from hfield.certificates.orders.local_types import (
    discriminant,
    eichler_symbol,
    factored,
    need_locally_principal,
    need_order,
)
from hfield.certificates.rejection import (
    MAX_DIGITS,
    a_list,
    an_integer,
    an_object,
    kind_of,
    reject,
    shown,
    texts,
)
from hfield.certificates.statement import Setting

SIDES = ("left", "right")


def establish_lattices(
    word: str, parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> Finding:
    """Check the evidence for a statement about lattices."""
    kind = kind_of(evidence)
    check = CHECKS.get((word, verdict, kind))
    if check is None:
        reject(f"evidence of the kind {shown(kind)!r} does not show that {word} is {verdict}")
    if len(parts) not in PARTS[word]:
        reject(f"{word} has not {len(parts)} parts")
    return check(Algebra(setting), parts, evidence)


def meaning_of_lattices(word: str, parts: tuple[str, ...]) -> Any:
    """Return what such a statement says, however it is written; a basis is not changed."""
    return word, tuple(_values(part) if "|" in part else part for part in parts)


# --- reading --------------------------------------------------------------------------------------


def _rational(text: str) -> Fraction:
    m = re.fullmatch(r"\s*(-?[0-9]+)(?:/([0-9]+))?\s*", text)
    if m is None or max(len(m[1]), len(m[2] or "")) > MAX_DIGITS:
        reject(f"{shown(text)!r} is no rational number that is read")
    denominator = int(m[2] or 1)
    if not denominator:
        reject(f"{shown(text)!r} divides by 0")
    return Fraction(int(m[1]), denominator)


def _integer(text: str, what: str) -> int:
    x = _rational(text)
    if x.denominator != 1:
        reject(f"{what} must be an integer")
    return x.numerator


def _values(text: str) -> tuple[tuple[Fraction, ...], ...]:
    rows = tuple(tuple(_rational(x) for x in row.split(",")) for row in text.split("|"))
    if len(rows) != 4 or any(len(row) != 4 for row in rows):
        reject("a lattice is written as four rows of four numbers")
    return rows


def _lattice(algebra: Algebra, text: str) -> Lattice:
    found = Lattice(algebra, *rational_rows(_values(text)))
    _ = found.key  # of rank 4
    return found


def _order(algebra: Algebra, text: str) -> Lattice:
    order = _lattice(algebra, text)
    need_order(order)
    return order


def _side(text: str) -> str:
    if text not in SIDES:
        reject(f"the side must be left or right, found {shown(text)!r}")
    return text


def _given_rows(value: object, algebra: Algebra) -> Lattice:
    """Read a lattice of the evidence, ``den`` and ``rows``."""
    data = an_object(value, "den rows", "a lattice")
    rows = [
        tuple(an_integer(x, "an entry") for x in a_list(row, "a row"))
        for row in a_list(data["rows"], "rows")
    ]
    if len(rows) != 4 or any(len(row) != 4 for row in rows):
        reject("a lattice has four rows of four integers")
    return Lattice(algebra, an_integer(data["den"], "a denominator", 1), tuple(rows))


def _basis_of(lattice: Lattice, value: object) -> Lattice:
    """Read another basis of a lattice."""
    found = _given_rows(value, lattice.algebra)
    if found.key != lattice.key:
        reject("these rows are no basis of the lattice that is run through")
    return found


def _element(value: object) -> Element:
    found = [_rational(x) for x in texts(value, "an element")]
    if len(found) != 4:
        reject("an element has four coordinates")
    den, rows = rational_rows([found])
    return Element(den, rows[0])


# --- orders and ideals ------------------------------------------------------------------------------


def _is_order(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    an_object(evidence, "kind", "the evidence")
    order = _order(algebra, parts[0])
    n = discriminant(order)
    if n != _integer(parts[1], "a discriminant"):
        reject("this order has another reduced discriminant")
    if len(parts) == 3:
        if parts[2] != "maximal":
            reject(f"an order is stated to be maximal, or nothing more; found {shown(parts[2])!r}")
        for p, e in factored(n).items():
            if e > 1 or eichler_symbol(order, p) != -1:
                reject(f"it is not shown that this order is maximal at {p}")
    return Finding(FIELD, ORDER)


def _is_ideal(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    an_object(evidence, "kind", "the evidence")
    ideal, order = _lattice(algebra, parts[0]), _order(algebra, parts[2])
    factors = (order, ideal) if _side(parts[1]) == "left" else (ideal, order)
    if not factors[0].products_lie_in(factors[1], ideal):
        reject(f"this is no {parts[1]} ideal of the order")
    need_locally_principal(ideal, order)
    if ideal.norm != _rational(parts[3]):
        reject("this ideal has another norm")
    return Finding(FIELD, IDEAL)


# --- what carries one to the other ------------------------------------------------------------------


def _are_equivalent(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind element", "the evidence")
    side, c = _side(parts[0]), _element(data["element"])
    first, second = (_lattice(algebra, part) for part in parts[1:])
    # left ideals go into each other by factors on the right
    if first.times(c, "right" if side == "left" else "left").key != second.key:
        reject("the element does not carry the first lattice to the second")
    return Finding(FIELD, ELEMENT)


def _are_not_equivalent(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind", "the evidence", "between")
    side = _side(parts[0])
    first, second = (_lattice(algebra, part) for part in parts[1:])
    size = root(second.volume / first.volume)
    between = first.into(second, side)
    if size is None or (size / between.norm).denominator != 1:
        if "between" in data:
            reject(
                "there is nothing to run through: no element can have the norm that is asked for"
            )
        return Finding(FIELD, NORM)
    if "between" not in data:
        reject("the elements that are run through need a basis, under the key 'between'")
    basis = _basis_of(between, data["between"])
    wanted = 2 * size * basis.unit
    for _, value in short_vectors(basis.gram, int(wanted)):
        if value == wanted:
            reject("an element carries the first lattice to the second")
    return Finding(FIELD, ENUMERATION)


def _are_isomorphic(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind element", "the evidence")
    first, second = (_order(algebra, part) for part in parts)
    x = _element(data["element"])
    if first.times(x, "left").key != second.times(x, "right").key:
        reject("the element does not conjugate the first order into the second")
    return Finding(FIELD, ELEMENT)


def _are_not_isomorphic(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind", "the evidence", "trace norm bases")
    first, second = (_order(algebra, part) for part in parts)
    if discriminant(first) != discriminant(second):
        return Finding(FIELD, DISCRIMINANT)
    data = an_object(evidence, "kind trace norm bases", "the evidence")
    trace, norm = (an_integer(data[key], key) for key in ("trace", "norm"))
    bases = a_list(data["bases"], "bases")
    if len(bases) != 2:
        reject("there is one basis for each of the two orders")
    numbers = [
        len(_with_trace_and_norm(_basis_of(order, basis), trace, norm))
        for order, basis in zip((first, second), bases, strict=True)
    ]
    if numbers[0] == numbers[1]:
        reject(f"both orders have {numbers[0]} elements of this trace and norm")
    return Finding(FIELD, ENUMERATION)


def _with_trace_and_norm(order: Lattice, trace: int, norm: int) -> list[tuple[int, ...]]:
    """Return the elements of an order of a definite algebra with a trace and a norm, as rows."""
    found = []
    wanted, whole = 2 * norm * order.unit, trace * order.algebra.scale * order.den
    for x, value in short_vectors(order.gram, wanted):
        if value == wanted:
            (row,) = times([x], order.rows)
            t = times([row], order.algebra.form)[0][0]
            found += [s for s, own in ((row, t), (tuple(-y for y in row), -t)) if own == whole]
    return found


# --- quadratic orders inside --------------------------------------------------------------------------


def _is_embedded(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind element", "the evidence")
    order, d = _order(algebra, parts[0]), _integer(parts[1], "a discriminant")
    x = _element(data["element"])
    if not order.holds(x.den, [x.row]):
        reject("the element is not in the order")
    trace = Fraction(times([x.row], algebra.form)[0][0], algebra.scale * x.den)
    if trace * trace - 4 * x.norm(algebra) != d:
        reject("the element has another discriminant")
    if not _is_optimal(order, x):
        reject("the element does not generate all integral elements of its field in the order")
    return Finding(FIELD, ELEMENT)


def _is_optimal(order: Lattice, x: Element) -> bool:
    """Tell whether no (x − m)/k with k > 1 is in the order: minors of 1 and x in coordinates are coprime."""
    back, det = inverse(order.rows)
    u, v = times([(x.den, 0, 0, 0), x.row], back)
    # coordinates are u·den/(det·x.den)
    u, v = (tuple(c * order.den // (det * x.den) for c in w) for w in (u, v))
    return gcd(*(u[m] * v[n] - u[n] * v[m] for m in range(4) for n in range(m))) == 1


def _is_not_embedded(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind basis", "the evidence")
    order, d = _order(algebra, parts[0]), _integer(parts[1], "a discriminant")
    if d >= 0 or d % 4 > 1:
        reject("a negative discriminant is 0 or 1 modulo 4")
    basis = _basis_of(order, data["basis"])
    trace = d % 2
    for row in _with_trace_and_norm(basis, trace, (trace - d) // 4):
        if _is_optimal(order, Element(basis.den, row)):
            reject("an element of the order has this discriminant, and is optimal")
    return Finding(FIELD, ENUMERATION)


# --- classes --------------------------------------------------------------------------------------------


def _is_class_set(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind classes", "the evidence")
    order = _order(algebra, parts[0])
    ideals = [_given_rows(value, algebra) for value in a_list(data["classes"], "classes", 1)]
    if len(ideals) != _integer(parts[1], "the number of classes"):
        reject(f"{len(ideals)} classes are given, which is not the number that is stated")
    need_class_set(order, ideals)
    return Finding(FIELD, BY_MASS).citing(MASS)


Check = Callable[[Algebra, tuple[str, ...], object], Finding]
CHECKS: dict[tuple[str, str, str], Check] = {
    ("order", "proved", "order"): _is_order,
    ("ideal", "proved", "ideal"): _is_ideal,
    ("equivalent", "proved", "equivalent"): _are_equivalent,
    ("equivalent", "refuted", "equivalent"): _are_not_equivalent,
    ("isomorphic-orders", "proved", "isomorphic-orders"): _are_isomorphic,
    ("isomorphic-orders", "refuted", "isomorphic-orders"): _are_not_isomorphic,
    ("embedding", "proved", "embedding"): _is_embedded,
    ("embedding", "refuted", "embedding"): _is_not_embedded,
    ("class-set", "proved", "class-set"): _is_class_set,
}
PARTS = {
    "order": (2, 3), "ideal": (4,), "equivalent": (3,), "isomorphic-orders": (2,), "embedding": (2,),
    "class-set": (2,),
}  # fmt: skip
