"""Check statements about orders, ideals and units, over any base.

Each check has two arguments: a reader of the evidence, and the parts of the statement.
"""

from fractions import Fraction
from functools import cache, partial
from typing import TypeVar

from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import (
    BY_AREA,
    BY_MASS,
    DISCRIMINANT,
    ELEMENT,
    ENUMERATION,
    FIELD,
    IDEAL,
    NORM,
    ORDER,
    POINCARE,
    SHIMIZU,
)
from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.ideals import index
from hfield.checker.number_fields.matrices import (
    N,
    Row,
    RowsOf,
    inverse,
    is_singular,
    lcm,
    ratio,
    times,
)
from hfield.checker.orders.algebra import AlgebraOf
from hfield.checker.orders.class_set import need_class_set, need_ideal
from hfield.checker.orders.elements import of_norm, with_trace_and_norm
from hfield.checker.orders.fuchsian import FundamentalDomain, area
from hfield.checker.orders.lattice import ElementOf, Lattice, LatticeOf
from hfield.checker.orders.local_types import symbols
from hfield.checker.orders.reading import OverField, OverPolynomials, OverQ
from hfield.checker.orders.texts import (
    a_rational,
    a_side,
    a_whole_number,
    numbers_of,
    words_of,
)
from hfield.checker.rejection import a_list, an_integer, reject
from hfield.checker.scalars.finite_field_polynomials import RationalFunction

Parts = tuple[str, ...]
Given = OverQ | OverField
G = TypeVar("G", OverQ, OverField, OverPolynomials)

# --- orders and ideals ------------------------------------------------------------------------------


def is_order(given: G, parts: Parts) -> CheckResult:
    """Check that O is an order of this discriminant, and maximal if the statement says so."""
    order = given.order(parts[0])
    if order.discriminant != given.whole(parts[1], "a discriminant"):
        reject("this order has another reduced discriminant")
    if len(parts) == 3:
        assert isinstance(given, OverQ), "that an order is maximal is stated over ℚ alone"
        exponents = factored(order.discriminant)
        for P, symbol in symbols(order, given.primes):
            if exponents[P.p] > 1 or symbol != -1:
                reject(f"it is not shown that this order is maximal at {P.p}")
    return CheckResult(FIELD, ORDER)


def is_ideal(given: G, parts: Parts) -> CheckResult:
    """Check that I is a locally principal ideal of the order, of this norm."""
    ideal = given.lattice(parts[0])
    need_ideal(ideal, given.order(parts[2]), a_side(parts[1]))
    if index(ideal.norm) != given.fraction(parts[3]):
        reject("this ideal has another norm")
    return CheckResult(FIELD, IDEAL)


def has_units(given: Given, parts: Parts) -> CheckResult:
    """Check that a unit has the stated norm among the totally positive units modulo squares."""
    order = given.basis(given.order(parts[0]), given.data["order"])
    if sum(1 for u in given.units for _ in of_norm(order, u)) != int(parts[1]):
        reject("the order has another number of units modulo those of the field")
    return CheckResult(FIELD, ENUMERATION).citing(*given.unit_theorems)


def has_unit_index(given: OverPolynomials, parts: Parts) -> CheckResult:
    """Check the number of units: elements whose norm is a polynomial of degree 0."""
    order = given.basis(given.order(parts[0]), given.data["order"])
    if len(order.least()) != a_whole_number(parts[1], "the number of units"):
        reject("the order has another number of units modulo the constants")
    return CheckResult(FIELD, ENUMERATION)


# --- what carries one to the other ------------------------------------------------------------------


def are_equivalent(given: G, parts: Parts) -> CheckResult:
    """Check an equivalence: J = I·c for the left side, c·I for the right."""
    side, c = a_side(parts[0]), given.element(given.data["element"])
    first, second = map(given.lattice, parts[1:])
    if first.times(c, "right" if side == "left" else "left").key != second.key:
        reject("the element does not carry the first lattice to the second")
    return CheckResult(FIELD, ELEMENT)


def are_not_equivalent(given: Given, parts: Parts) -> CheckResult:
    """Check that no element c maps one lattice onto the other: no element has the norm, or the norm is
    impossible.
    """
    side = a_side(parts[0])
    first, second = map(given.lattice, parts[1:])
    between = cache(partial(first.into, second, side))
    inverse_norm = given.quotient(first, second, between)
    if inverse_norm is None:
        if given.data.keys() & {"norm", "between"}:
            reject("there is nothing to run through: no element can have the given norm")
        return CheckResult(FIELD, NORM).citing(*given.unit_theorems)
    if "between" not in given.data:
        reject("the elements that are run through need a basis, under the key 'between'")
    basis, field = given.between(between(), side), given.algebra.integers.field
    for u in given.units:
        if next(of_norm(basis, field.mul(inverse_norm, u)), None) is not None:
            reject(
                "an element carries the first lattice to the second: one of its norm lies between"
            )
    return CheckResult(FIELD, ENUMERATION).citing(*given.unit_theorems)


def none_of_least_degree_carries(given: OverPolynomials, parts: Parts) -> CheckResult:
    """Check that no element with a norm of least degree maps one lattice onto the other."""
    side = a_side(parts[0])
    first, second = map(given.lattice, parts[1:])
    between = given.basis(first.into(second, side), given.data["between"])
    for x in between.least():
        moved = first.times(ElementOf(between.den, x), "right" if side == "left" else "left")
        if moved.key == second.key:
            reject("an element carries the first lattice to the second")
    return CheckResult(FIELD, ENUMERATION)


def are_isomorphic(given: G, parts: Parts) -> CheckResult:
    """Check an isomorphism P = x·O·x⁻¹; x must not be a zero divisor."""
    first, second = map(given.order, parts)
    x = given.element(given.data["element"])
    if first.times(x, "left").key != second.times(x, "right").key:
        reject("the element does not conjugate the first order into the second")
    return CheckResult(FIELD, ELEMENT)


def have_other_numbers(given: Given, parts: Parts) -> CheckResult:
    """Check that two orders differ in discriminant, or in the number of elements of some trace and norm."""
    first, second = map(given.order, parts)
    if _have_other_discriminants(given, first, second, {"trace", "norm", "bases"}):
        return CheckResult(FIELD, DISCRIMINANT)
    bases = a_list(given.data["bases"], "bases")
    if len(bases) != 2:
        reject("there is one basis for each of the two orders")
    trace, norm = (an_integer(given.data[key], key) for key in ("trace", "norm"))
    numbers = [
        len(with_rational_trace_and_norm(given.basis(order, basis), trace, norm))
        for order, basis in zip((first, second), bases, strict=True)
    ]
    if numbers[0] == numbers[1]:
        reject(f"both orders have {numbers[0]} elements of this trace and norm")
    return CheckResult(FIELD, ENUMERATION)


def have_no_images(given: G, parts: Parts) -> CheckResult:
    """Check that there is no isomorphism: no elements can be the images of two generators of the algebra."""
    first, second = map(given.order, parts)
    if _have_other_discriminants(given, first, second, {"pair", "order"}):
        return CheckResult(FIELD, DISCRIMINANT)
    second, algebra = given.basis(second, given.data["order"]), given.algebra
    pair = [given.element(x) for x in a_list(given.data["pair"], "a pair", 2)]
    if len(pair) != 2 or not all(first.holds(x.den, [x.row]) for x in pair):
        reject("a pair is two elements of the first order")
    den, span = _spanned(algebra, *pair)
    if is_singular(span):
        reject("the two elements do not generate the algebra")
    back, det = inverse(span)
    # the rows of the first order are combinations of the span, over den_first·det/den
    relative = [tuple(den * c for c in row) for row in times(first.rows, back)]
    images = [[ElementOf(second.den, y) for y in given.images(second, x)] for x in pair]
    wanted = _pairing(algebra, *pair)
    for x in images[0]:
        for y in images[1]:
            if _pairing(algebra, x, y) == wanted:
                below, other = _spanned(algebra, x, y)
                second.pay(2)
                if second.holds(first.den * det * below, times(relative, other)):
                    reject("there is an isomorphism of the orders")
    return CheckResult(FIELD, ENUMERATION)


def _have_other_discriminants(
    given: OverQ | OverField | OverPolynomials,
    first: LatticeOf[N],
    second: LatticeOf[N],
    keys: set[str],
) -> bool:
    """Return whether the discriminants differ; the evidence must have these keys if they agree, and none
    otherwise.
    """
    if first.discriminant != second.discriminant:
        if given.data.keys() & keys:
            reject("there is nothing to run through: the discriminants differ")
        return True
    if not given.data.keys() >= keys:
        reject(f"the evidence lacks one of the keys {', '.join(map(repr, sorted(keys)))}")
    return False


def with_rational_trace_and_norm(order: Lattice, trace: int, norm: int) -> list[Row]:
    """Return the elements of an order with a given trace and norm that are integers."""
    integers = order.algebra.integers
    return with_trace_and_norm(
        order, [Fraction(trace * c) for c in integers.one], integers.field.number(norm)
    )


def _pairing(
    algebra: AlgebraOf[N], x: ElementOf[N], y: ElementOf[N]
) -> list[Fraction] | list[RationalFunction]:
    """Return tr(x·conj(y)) in the integral basis."""
    den = x.den * y.den * algebra.scale
    return [ratio(c, den) for c in algebra.pairing(x.row, y.row)]


def _spanned(algebra: AlgebraOf[N], a: ElementOf[N], b: ElementOf[N]) -> tuple[N, RowsOf[N]]:
    """Return the products of the integral basis with 1, a, b and ab, as rows over a denominator."""
    ab = times([b.row], algebra.left(a.row))[0]
    one = ElementOf(algebra.integers.zero + 1, algebra.number(algebra.integers.one))
    every = (one, a, b, ElementOf(a.den * b.den * algebra.scale, ab))
    den = lcm(*(x.den for x in every))
    return den, tuple(
        algebra.blockwise([c * (den // x.den) for c in x.row], by)
        for x in every
        for by in algebra.integers.table
    )


# --- classes, and units of norm 1 ---------------------------------------------------------------------


def is_class_set(given: G, parts: Parts) -> CheckResult:
    """Check the number of classes of locally principal right ideals of the order."""
    values, order = a_list(given.data["classes"], "classes", 1), given.order(parts[0])
    if len(values) != a_whole_number(parts[1], "the number of classes"):
        reject(f"{len(values)} classes are given, which is not the number that is stated")
    need_class_set(order, given.classes(values), given.divided, given.mass(order))
    cites = (*given.unit_theorems, *given.zeta_theorems, given.mass_theorem)
    return CheckResult(FIELD, BY_MASS).citing(*cites)


def is_domain(given: Given, parts: Parts) -> CheckResult:
    """Check that the units g of norm 1 bound the Dirichlet domain around the centre."""
    order, plane = given.order(parts[0]), given.real_algebra()
    center = given.elements(parts[1])
    if len(center) != 1:
        reject(f"a domain has one centre, found {len(center)}")
    FundamentalDomain(order, plane, area(order, given.primes), center[0], given.elements(parts[2]))
    return CheckResult(FIELD, BY_AREA).citing(*given.zeta_theorems, SHIMIZU)


def is_group(given: Given, parts: Parts) -> CheckResult:
    """Check that the units of norm 1 modulo ±1 have this signature and this presentation."""
    order, plane = given.order(parts[0]), given.real_algebra()
    center = given.element(given.data["center"])
    units = [given.element(x) for x in a_list(given.data["units"], "units")]
    domain = FundamentalDomain(order, plane, area(order, given.primes), center, units)
    signature = (a_rational(parts[1]), list(numbers_of(parts[2])), a_rational(parts[3]))
    domain.need_group(signature, given.elements(parts[4]), list(words_of(parts[5])))
    return CheckResult(FIELD, BY_AREA).citing(*given.zeta_theorems, SHIMIZU, POINCARE)
