"""The words of certificates about lattices, and the evidence that shows or refutes them.

``order{L; n}`` · ``order{L; n; maximal}`` · ``ideal{I; side; O; norm}`` · ``equivalent{side; I; J}`` ·
``isomorphic-orders{O; P}`` · ``embedding{O; d}`` · ``class-set{O; h}`` · ``dirichlet-domain{O; c; g | …}`` ·
``norm-one-group{O; genus; orders; cusps; g | …; words}``. A lattice is written as four rows of rational
numbers, ``1,0,0,0 | 0,1,0,0 | 0,0,1,0 | 1/2,1/2,1/2,1/2``.
"""

from collections.abc import Callable
from fractions import Fraction
from math import gcd

from hfield.certificates.finding import Finding
from hfield.certificates.glossary import (
    BY_AREA,
    BY_MASS,
    DISCRIMINANT,
    ELEMENT,
    ENUMERATION,
    FIELD,
    IDEAL,
    MASS,
    NORM,
    ORDER,
    POINCARE,
    SHIMIZU,
)
from hfield.certificates.language import Tree
from hfield.certificates.number_fields.enumeration import short_vectors
from hfield.certificates.number_fields.factoring import factored
from hfield.certificates.number_fields.matrices import inverse, times
from hfield.certificates.orders.algebra import Algebra
from hfield.certificates.orders.fuchsian import Domain, area
from hfield.certificates.orders.lattice import Element, Lattice
from hfield.certificates.orders.local_types import (
    discriminant,
    eichler_symbol,
    need_class_set,
    need_locally_principal,
)
from hfield.certificates.orders.reading import (
    a_lattice,
    a_rational,
    a_side,
    a_whole_number,
    an_element,
    an_order,
    another_basis,
    elements_of,
    given_lattice,
    numbers_of,
    rows_of,
    words_of,
)
from hfield.certificates.rejection import (
    a_list,
    an_integer,
    an_object,
    kind_of,
    reject,
    shown,
)
from hfield.certificates.scalars.rationals import root
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge_products


def establish_lattices(
    word: str, parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> Finding:
    """Check the evidence for a statement about lattices."""
    kind = kind_of(evidence)
    check = CHECKS.get((word, verdict, kind))
    if check is None:
        reject(f"evidence of the kind {shown(kind)!r} does not show that {word} is {verdict}")
    meaning_of_lattices(word, parts)
    return check(Algebra(setting), parts, evidence)


def meaning_of_lattices(word: str, parts: tuple[str, ...]) -> Tree:
    """Return what such a statement says, however it is written; a basis is not changed."""
    readers = PARTS[word]
    if len(parts) != len(readers) and (word, len(parts)) != ("order", 2):
        reject(f"{word} has not {len(parts)} parts")
    return word, tuple(read(part) for read, part in zip(readers, parts, strict=False))


# --- orders and ideals ------------------------------------------------------------------------------


def _is_order(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    an_object(evidence, "kind", "the evidence")
    order = an_order(algebra, parts[0])
    n = discriminant(order)
    if n != a_whole_number(parts[1], "a discriminant"):
        reject("this order has another reduced discriminant")
    if len(parts) == 3:
        for p, e in factored(n).items():
            if e > 1 or eichler_symbol(order, p) != -1:
                reject(f"it is not shown that this order is maximal at {p}")
    return Finding(FIELD, ORDER)


def _is_ideal(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    an_object(evidence, "kind", "the evidence")
    ideal, order = a_lattice(algebra, parts[0]), an_order(algebra, parts[2])
    factors = (order, ideal) if a_side(parts[1]) == "left" else (ideal, order)
    if not factors[0].products_lie_in(factors[1], ideal):
        reject(f"this is no {parts[1]} ideal of the order")
    need_locally_principal(ideal, order)
    if ideal.norm != a_rational(parts[3]):
        reject("this ideal has another norm")
    return Finding(FIELD, IDEAL)


# --- what carries one to the other ------------------------------------------------------------------


def _are_equivalent(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind element", "the evidence")
    side, c = a_side(parts[0]), an_element(data["element"])
    first, second = (a_lattice(algebra, part) for part in parts[1:])
    # left ideals go into each other by factors on the right
    if first.times(c, "right" if side == "left" else "left").key != second.key:
        reject("the element does not carry the first lattice to the second")
    return Finding(FIELD, ELEMENT)


def _are_not_equivalent(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind", "the evidence", "between")
    side = a_side(parts[0])
    first, second = (a_lattice(algebra, part) for part in parts[1:])
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
    basis = another_basis(between, data["between"])
    wanted = 2 * size * basis.unit
    for _, value in short_vectors(basis.gram, int(wanted)):
        if value == wanted:
            reject("an element carries the first lattice to the second")
    return Finding(FIELD, ENUMERATION)


def _are_isomorphic(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind element", "the evidence")
    first, second = (an_order(algebra, part) for part in parts)
    x = an_element(data["element"])
    if first.times(x, "left").key != second.times(x, "right").key:
        reject("the element does not conjugate the first order into the second")
    return Finding(FIELD, ELEMENT)


def _are_not_isomorphic(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    first, second = (an_order(algebra, part) for part in parts)
    if discriminant(first) != discriminant(second):
        an_object(evidence, "kind", "the evidence of two discriminants")
        return Finding(FIELD, DISCRIMINANT)
    data = an_object(evidence, "kind trace norm bases", "the evidence")
    trace, norm = (an_integer(data[key], key) for key in ("trace", "norm"))
    bases = a_list(data["bases"], "bases")
    if len(bases) != 2:
        reject("there is one basis for each of the two orders")
    numbers = [
        len(_with_trace_and_norm(another_basis(order, basis), trace, norm))
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
    order, d = an_order(algebra, parts[0]), a_whole_number(parts[1], "a discriminant")
    x = an_element(data["element"])
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
    charge_products(u, v)
    minors = [u[m] * v[n] - u[n] * v[m] for m in range(4) for n in range(m)]
    charge_products(minors, minors[:1])
    return gcd(*minors) == 1


def _is_not_embedded(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind basis", "the evidence")
    order, d = an_order(algebra, parts[0]), a_whole_number(parts[1], "a discriminant")
    if d >= 0 or d % 4 > 1:
        reject("a negative discriminant is 0 or 1 modulo 4")
    basis = another_basis(order, data["basis"])
    trace = d % 2
    for row in _with_trace_and_norm(basis, trace, (trace - d) // 4):
        if _is_optimal(order, Element(basis.den, row)):
            reject("an element of the order has this discriminant, and is optimal")
    return Finding(FIELD, ENUMERATION)


# --- classes --------------------------------------------------------------------------------------------


def _is_class_set(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind classes", "the evidence")
    order = an_order(algebra, parts[0])
    ideals = [given_lattice(value, algebra) for value in a_list(data["classes"], "classes", 1)]
    if len(ideals) != a_whole_number(parts[1], "the number of classes"):
        reject(f"{len(ideals)} classes are given, which is not the number that is stated")
    need_class_set(order, ideals)
    return Finding(FIELD, BY_MASS).citing(MASS)


# --- units of norm 1 ------------------------------------------------------------------------------------


def _is_domain(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    an_object(evidence, "kind", "the evidence")
    (center,) = elements_of(parts[1], 1)
    order = an_order(algebra, parts[0])
    Domain(order, area(order), center, elements_of(parts[2]))
    return Finding(FIELD, BY_AREA).citing(SHIMIZU)


def _is_group(algebra: Algebra, parts: tuple[str, ...], evidence: object) -> Finding:
    data = an_object(evidence, "kind center units", "the evidence")
    units = [an_element(x) for x in a_list(data["units"], "units")]
    order = an_order(algebra, parts[0])
    domain = Domain(order, area(order), an_element(data["center"]), units)
    domain.need_group(
        (a_rational(parts[1]), list(numbers_of(parts[2])), a_rational(parts[3])),
        elements_of(parts[4]),
        list(words_of(parts[5])),
    )
    return Finding(FIELD, BY_AREA).citing(SHIMIZU, POINCARE)


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
    ("dirichlet-domain", "proved", "dirichlet-domain"): _is_domain,
    ("norm-one-group", "proved", "norm-one-group"): _is_group,
}


def _maximal(text: str) -> str:
    if text != "maximal":
        reject(f"an order is stated to be maximal, or nothing more; found {shown(text)!r}")
    return text


# How the parts of each word are read; that an order is maximal may be left away.
PARTS: dict[str, tuple[Callable[[str], object], ...]] = {
    "order": (rows_of, a_rational, _maximal),
    "ideal": (rows_of, a_side, rows_of, a_rational),
    "equivalent": (a_side, rows_of, rows_of),
    "isomorphic-orders": (rows_of, rows_of),
    "embedding": (rows_of, a_rational),
    "class-set": (rows_of, a_rational),
    "dirichlet-domain": (rows_of, elements_of, elements_of),
    "norm-one-group": (rows_of, a_rational, numbers_of, a_rational, elements_of, words_of),
}
