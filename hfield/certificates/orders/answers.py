"""Orders and ideals over the integers of a number field, and what carries one to another, or that none does.

``order-over-integers{O; n}`` · ``ideal-over-integers{I; side; O; n}``, n the absolute norm of the reduced
discriminant and of the reduced norm · ``equivalent-over-integers{side; I; J}`` ·
``isomorphic-over-integers{O; P}`` · ``unit-index{O; n}``. A lattice is written as a basis over ℤ.

J = I·c makes N(c) a generator of N(J)/N(I), in a totally definite algebra a totally positive one: c is one of
finitely many elements, up to units of the field, or N(J)/N(I) has no such generator.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from hfield.certificates.finding import Finding
from hfield.certificates.glossary import (
    DISCRIMINANT,
    ELEMENT,
    ENUMERATION,
    FIELD,
    IDEAL,
    NORM,
    ORDER,
)
from hfield.certificates.number_fields.classes import field_of
from hfield.certificates.number_fields.ideals import index
from hfield.certificates.number_fields.lattices import (
    Frame,
    Lattice,
    Row,
    a_frame,
    need_definite,
    need_locally_principal,
    need_same,
    of_norm,
)
from hfield.certificates.number_fields.matrices import rational_rows, times, unit
from hfield.certificates.number_fields.narrow import Narrow
from hfield.certificates.rejection import a_list, an_object, reject
from hfield.certificates.scalars.matrices import inverse_matrix
from hfield.certificates.statement import Setting
from hfield.certificates.work import charge

Parts = tuple[str, ...]


def _narrow(setting: Setting, data: Any) -> tuple[Narrow, Frame]:
    narrow = Narrow(field_of(setting), data["units"], data["fundamental"])
    return narrow, Frame(setting, narrow.s.integers)


# --- orders and ideals ------------------------------------------------------------------------------


def _is_order(parts: Parts, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind basis", "the evidence")
    if a_frame(setting, data["basis"]).order(parts[0]).discriminant != int(parts[1]):
        reject("this order has another reduced discriminant")
    return Finding(FIELD, ORDER)


def _is_ideal(parts: Parts, setting: Setting, evidence: object) -> Finding:
    base = a_frame(setting, an_object(evidence, "kind basis", "the evidence")["basis"])
    ideal = base.lattice(parts[0])
    need_locally_principal(ideal, base.order(parts[2]), parts[1])
    if index(ideal.norm) != Fraction(parts[3]):
        reject("this ideal has another norm")
    return Finding(FIELD, IDEAL)


def _unit_index(parts: Parts, setting: Setting, evidence: object) -> Finding:
    """Units modulo those of the field have a norm among the totally positive units modulo squares."""
    data = an_object(evidence, "kind units fundamental order", "the evidence")
    narrow, base = _narrow(setting, data)
    order = base.order(parts[0])
    given = base.given(data["order"], "an order")
    need_same(order, given)
    if sum(1 for u in narrow.units for _ in of_norm(given, u)) != int(parts[1]):
        reject("the order has another number of units modulo those of the field")
    return Finding(FIELD, ENUMERATION).citing(*narrow.s.cites)


# --- what carries one to the other ------------------------------------------------------------------


def _are_equivalent(parts: Parts, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind basis element", "the evidence")
    base = a_frame(setting, data["basis"])
    first, second = map(base.lattice, parts[1:])
    # left ideals go into each other by factors on the right
    side = "right" if parts[0] == "left" else "left"
    if first.times(*base.element(data["element"]), side).key != second.key:
        reject("the element does not carry the first lattice to the second")
    return Finding(FIELD, ELEMENT)


def _are_not_equivalent(parts: Parts, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind units fundamental", "the evidence", "quotient norm between")
    narrow, base = _narrow(setting, data)
    first, second = map(base.lattice, parts[1:])
    if parts[0] == "right":
        first, second = _conjugate(first), _conjugate(second)
    _need_module(first)
    _need_module(second)
    if "quotient" in data:
        if data.keys() & {"norm", "between"}:
            reject(
                "there is nothing to run through: no element can have the norm that is asked for"
            )
        x, e = narrow.read(data["quotient"])
        if not narrow.is_quotient(x, e, second.norm, first.norm):
            reject("the quotient of the norms is another ideal")
        if narrow.is_principal(x, e):
            reject("the quotient of the norms has a totally positive generator")
        return Finding(FIELD, NORM).citing(*narrow.s.cites)
    if not data.keys() >= {"norm", "between"}:
        reject("the evidence lacks the key 'quotient', or the keys 'norm' and 'between'")
    nu = narrow.s.given(data["norm"])
    inverse = narrow.need_totally_positive(nu)
    if not narrow.is_quotient(nu, [0] * len(narrow.s.S), second.norm, first.norm):
        reject("the quotient of the norms is another ideal")
    between = base.given(data["between"], "the lattice between")
    need_same(first.into(second), between)
    for u in narrow.units:
        if next(of_norm(between, base.field.mul(inverse, u)), None) is not None:
            reject("an element of the norm that is asked for lies between the lattices")
    return Finding(FIELD, ENUMERATION).citing(*narrow.s.cites)


def _conjugate(lattice: Lattice) -> Lattice:
    base = lattice.base
    rows = tuple(base.conjugate(x) for x in lattice.rows)
    return Lattice(base, lattice.den * base.conjugate_scale, rows)


def _need_module(lattice: Lattice) -> None:
    """Reject unless a lattice is closed under the integers of the field, and the algebra is definite."""
    base = lattice.base
    for k in range(base.n):
        if not lattice.holds(
            lattice.den * base.scale, times(lattice.rows, base.left(unit(base.size, k)))
        ):
            reject("a lattice is no module over the integers of the field")
    need_definite(lattice)


def _are_isomorphic(parts: Parts, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind basis element", "the evidence")
    base = a_frame(setting, data["basis"])
    first, second = map(base.order, parts)
    x = base.element(data["element"])
    # a zero divisor x does not give lattices
    if first.times(*x, "left").key != second.times(*x, "right").key:
        reject("the element does not conjugate the first order into the second")
    return Finding(FIELD, ELEMENT)


def _are_not_isomorphic(parts: Parts, setting: Setting, evidence: object) -> Finding:
    """An isomorphism is known by the images of two elements that generate the algebra: none fits."""
    data = an_object(evidence, "kind basis", "the evidence", "pair order")
    base = a_frame(setting, data["basis"])
    first, second = map(base.order, parts)
    if first.discriminant != second.discriminant:
        if len(data) > 2:
            reject("there is nothing to run through: the discriminants differ")
        return Finding(FIELD, DISCRIMINANT)
    if not data.keys() >= {"pair", "order"}:
        reject("the evidence lacks the keys 'pair' and 'order'")
    given = base.given(data["order"], "an order")
    need_same(second, given)
    pair = [base.element(x) for x in a_list(data["pair"], "a pair", 2)]
    if len(pair) != 2 or not all(first.holds(den, [row]) for den, row in pair):
        reject("a pair is two elements of the first order")
    a, b = (_over(base, *x) for x in pair)
    source = inverse_matrix(_span(base, a, b))
    if source is None:
        reject("the two elements do not generate the algebra")
    rows = [[Fraction(c, first.den) for c in row] for row in first.rows]
    relative = _product(rows, source)
    images = [_alike(given, x) for x in (a, b)]
    wanted = _pairing(base, a, b)
    for s in images[0]:
        for t in images[1]:
            if _pairing(base, s, t) == wanted and _integral(
                second, _product(relative, _span(base, s, t))
            ):
                reject("there is an isomorphism of the orders")
    return Finding(FIELD, ENUMERATION)


Vector = list[Fraction]


def _over(base: Frame, den: int, row: Row) -> Vector:
    return [Fraction(c, den) for c in row]


def _whole(x: Vector) -> tuple[int, Row]:
    den, (row,) = rational_rows([x])
    return den, row


def _times(base: Frame, x: Vector, y: Vector) -> Vector:
    (d, u), (e, v) = _whole(x), _whole(y)
    return _over(base, d * e * base.scale, times([v], base.left(u))[0])


def _pairing(base: Frame, x: Vector, y: Vector) -> Vector:
    """Return tr(x·conj(y)) in the integral basis."""
    (d, u), (e, v) = _whole(x), _whole(y)
    den = d * e * base.scale * base.conjugate_scale
    return [Fraction(times(times([u], form), [[c] for c in v])[0][0], den) for form in base.form]


def _span(base: Frame, a: Vector, b: Vector) -> list[Vector]:
    """Return the products of the integral basis with 1, a, b and ab."""
    numbers = [_over(base, 1, unit(base.size, k)) for k in range(base.n)]
    one = _over(base, 1, (*base.integers.one, *[0] * (3 * base.n)))
    return [_times(base, w, x) for x in (one, a, b, _times(base, a, b)) for w in numbers]


def _product(rows: list[Vector], matrix: list[Vector]) -> list[Vector]:
    charge(len(rows) * len(matrix) * len(matrix[0]) // 2)
    columns = list(zip(*matrix, strict=True))
    return [[sum(map(Fraction.__mul__, row, c), Fraction(0)) for c in columns] for row in rows]


def _integral(order: Lattice, rows: list[Vector]) -> bool:
    return all(order.holds(den, [row]) for den, row in map(_whole, rows))


def _alike(order: Lattice, a: Vector) -> list[Vector]:
    """Return the elements of an order with the trace and the norm of an element."""
    base, integers = order.base, order.base.integers
    one = _over(base, 1, (*integers.one, *[0] * (3 * base.n)))
    trace, twice = _pairing(base, a, one), _pairing(base, a, a)
    norm = tuple(
        sum((c / 2 * w[k] for c, w in zip(twice, integers.rows, strict=True)), Fraction(0))
        for k in range(base.n)
    )
    inverse = base.field.inverse(norm)
    if inverse is None or any(s != 1 for s in base.field.signs(norm)):
        reject("an element of a pair has no totally positive norm")
    found = []
    for x in of_norm(order, inverse):
        y = _over(base, order.den, times([x], order.rows)[0])
        found += [z for z in (y, [-c for c in y]) if _pairing(base, z, one) == trace]
    return found


Check = Callable[[Parts, Setting, object], Finding]
_CHECKS: dict[tuple[str, str], Check] = {
    ("order-over-integers", "proved"): _is_order,
    ("ideal-over-integers", "proved"): _is_ideal,
    ("unit-index", "proved"): _unit_index,
    ("equivalent-over-integers", "proved"): _are_equivalent,
    ("equivalent-over-integers", "refuted"): _are_not_equivalent,
    ("isomorphic-over-integers", "proved"): _are_isomorphic,
    ("isomorphic-over-integers", "refuted"): _are_not_isomorphic,
}


def _establish(word: str) -> Callable[[Parts, Setting, str, Any], Finding]:
    def check(parts: Parts, setting: Setting, verdict: str, evidence: Any) -> Finding:
        own = _CHECKS.get((word, verdict))
        if own is None or not isinstance(evidence, dict) or evidence.get("kind") != word:
            reject(f"evidence of this kind does not show that {word} is {verdict}")
        return own(parts, setting, evidence)

    return check


_NUMBER = "[1-9][0-9]{0,99}"
FORMS = {
    "order-over-integers": f"[^;]+;{_NUMBER}",
    "ideal-over-integers": f"[^;]+;(left|right);[^;]+;{_NUMBER}(/{_NUMBER})?",
    "unit-index": f"[^;]+;{_NUMBER}",
    "equivalent-over-integers": "(left|right);[^;]+;[^;]+",
    "isomorphic-over-integers": "[^;]+;[^;]+",
}
CHECKS = {word: _establish(word) for word in FORMS}
