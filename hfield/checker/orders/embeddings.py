"""Check statements about optimal embeddings of quadratic orders in orders over ℤ.

Let pᵉ be the exact power of p in the discriminant of O, and let S = ℤ[x]/(x² − tx + n) be the quadratic order
of discriminant d. Local embeddings are counted up to conjugation by local units. If the Eichler symbol is −1
and e = 1, the algebra ramifies at p and O is maximal there. Then S has 1 − (S/p) local embeddings, and none
if p divides its conductor. If the symbol is 1, O is an Eichler order of level pᵉ at p. Then S has one local
embedding for each root of the polynomial modulo pᵉ. If p divides d, roots modulo pᵉ that come from roots
modulo pᵉ⁺¹ are counted twice (docs/explanation/trust.md).
"""

from math import gcd, isqrt, prod

from hfield.checker.budget import spend, spend_products
from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import (
    BY_CLASS_NUMBER,
    BY_PRIME,
    ELEMENT,
    EMBEDDING_NUMBERS,
    ENUMERATION,
    FIELD,
    SHIMIZU,
)
from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.matrices import inverse, times
from hfield.checker.number_fields.real_numbers import RealRow
from hfield.checker.orders.elements import trace_and_norm
from hfield.checker.orders.fuchsian import FundamentalDomain, area
from hfield.checker.orders.lattice import Lattice, LatticeElement
from hfield.checker.orders.local_types import symbols
from hfield.checker.orders.statements import (
    Given,
    Parts,
    with_rational_trace_and_norm,
)
from hfield.checker.orders.texts import a_whole_number
from hfield.checker.rejection import a_list, an_integer, reject


def is_embedded(given: Given, parts: Parts) -> CheckResult:
    """Check that some x in O has this discriminant and that ℤ[x] is optimally embedded in O."""
    order, d = given.order(parts[0]), a_whole_number(parts[1], "a discriminant")
    _need_embedding(order, given.element(given.data["element"]), d)
    return CheckResult(FIELD, ELEMENT)


def is_not_embedded(given: Given, parts: Parts) -> CheckResult:
    """Check that there is no optimal embedding, locally at a prime or among all elements of trace 0 or 1."""
    order, d = given.order(parts[0]), _discriminant(parts[1])
    if "prime" in given.data:
        if "basis" in given.data:
            reject("the evidence has a prime or a basis, and not both")
        p = an_integer(given.data["prime"], "a prime", 2)
        if p not in factored(order.discriminant):
            reject(f"{p} is no prime number that divides the discriminant")
        e, symbol = _local_types(given, order).get(p, (0, 0))
        if not symbol or not (
            _splits_or_is_not_maximal(d, p) if symbol < 0 else not _is_square(d, p, e)
        ):
            reject(f"{p} does not rule an embedding out")
        return CheckResult(FIELD, BY_PRIME)
    if "basis" not in given.data:
        reject("the evidence lacks the key 'prime' or 'basis'")
    if d > 0:
        reject("for a positive discriminant the elements are not listed")
    basis, trace = given.basis(order, given.data["basis"]), d % 2
    for row in with_rational_trace_and_norm(basis, trace, (trace - d) // 4):
        if _is_optimal(order, LatticeElement(basis.den, row)):
            reject("an element of the order has this discriminant, and is optimal")
    return CheckResult(FIELD, ENUMERATION)


def has_orbits(given: Given, parts: Parts) -> CheckResult:
    """Check the number of orbits of embeddings under units of norm 1, for d < 0.

    Their fixed points must lie in the domain, and no unit may map one to another.
    """
    order, d = given.order(parts[0]), _discriminant(parts[1])
    if d > 0:
        reject("orbits are counted for negative discriminants")
    number = _number_of_orbits(given, order, d)
    if a_whole_number(parts[2], "a number of orbits") != number or not number:
        reject("the order has another number of orbits, or none")
    plane = given.real_algebra()
    center = given.element(given.data["center"])
    units = [given.element(x) for x in a_list(given.data["units"], "units")]
    domain = FundamentalDomain(order, plane, area(order, given.primes), center, units)
    elements = [given.element(x) for x in a_list(given.data["elements"], "elements", 1)]
    if 2 * len(elements) != number:
        reject(f"{len(elements)} embeddings are given, which is not half of the number of orbits")
    seen: set[RealRow] = set()
    for x in elements:
        _need_embedding(order, x, d)
        images = domain.orbit(_root(given, order, x))
        if images & seen:
            reject("a unit maps the point of an embedding to that of another one")
        seen |= images
    return CheckResult(FIELD, BY_CLASS_NUMBER).citing(SHIMIZU, EMBEDDING_NUMBERS)


# --- elements -----------------------------------------------------------------------------------------


def _discriminant(text: str) -> int:
    d = a_whole_number(text, "a discriminant")
    if not d or d % 4 > 1:
        reject("the discriminant of a quadratic order is 0 or 1 modulo 4, and not 0")
    return d


def _need_embedding(order: Lattice, x: LatticeElement, d: int) -> None:
    """Reject unless an element of the order has the discriminant d and is optimal."""
    if not order.holds(x.den, [x.row]):
        reject("the element is not in the order")
    (trace,), (norm,) = trace_and_norm(order.algebra, x)
    if trace * trace - 4 * norm != d:
        reject("the element has another discriminant")
    if not _is_optimal(order, x):
        reject("the element does not generate all integral elements of its field in the order")


def _is_optimal(order: Lattice, x: LatticeElement) -> bool:
    """Return whether no (x − m)/k with k > 1 is in the order: the 2 × 2 minors of (1, x) are coprime."""
    back, det = inverse(order.rows)
    both = times(
        [order.algebra.number([x.den * c for c in order.algebra.integers.one]), x.row], back
    )
    # coordinates are these, times den/(det·x.den)
    u, v = (tuple(c * order.den // (det * x.den) for c in w) for w in both)
    spend_products(u, v)
    minors = [u[m] * v[n] - u[n] * v[m] for m in range(len(u)) for n in range(m)]
    spend_products(minors, minors[:1])
    return gcd(*minors) == 1


def _root(given: Given, order: Lattice, x: LatticeElement) -> LatticeElement:
    """Return 2x − tr(x)."""
    (trace,), _ = trace_and_norm(given.algebra, x)
    scalar = order.algebra.number([int(trace * x.den)])
    return LatticeElement(x.den, tuple(2 * a - b for a, b in zip(x.row, scalar, strict=True)))


# --- numbers ------------------------------------------------------------------------------------------


def _local_types(given: Given, order: Lattice) -> dict[int, tuple[int, int]]:
    """Return the exponent and the symbol of each prime at which the order is Eichler or maximal."""
    exponents = factored(order.discriminant)
    found = {P.p: (exponents[P.p], symbol) for P, symbol in symbols(order, given.primes)}
    return {
        p: (e, symbol) for p, (e, symbol) in found.items() if symbol == 1 or (e, symbol) == (1, -1)
    }


def _number_of_orbits(given: Given, order: Lattice, d: int) -> int:
    """Return 2·h(d) times the numbers of local embeddings, for an Eichler order, by the cited formula."""
    types = _local_types(given, order)
    if types.keys() != factored(order.discriminant).keys():
        reject("the orbits are counted in Eichler orders, and this is none")
    return 2 * _class_number(d) * prod(_local_number(d, p, *types[p]) for p in types)


def _local_number(d: int, p: int, e: int, symbol: int) -> int:
    if symbol < 0:
        return 0 if _splits_or_is_not_maximal(d, p) else 2 if _is_inert(d, p) else 1
    roots = _roots(d, p, e)
    if d % p:
        return len(roots)
    return len(roots) + len({x % p**e for x in _lifted(d, p, e, roots)})


def _splits_or_is_not_maximal(d: int, p: int) -> bool:
    """Return whether p splits in the field of √d, or divides the conductor of the order."""
    if d % (p * p) == 0 and d // (p * p) % 4 < 2:
        return True
    return d % 8 == 1 if p == 2 else d % p != 0 and _is_square(d, p, 1)


def _is_inert(d: int, p: int) -> bool:
    return d % 8 == 5 if p == 2 else d % p != 0 and not _is_square(d, p, 1)


def _is_square(d: int, p: int, e: int) -> bool:
    """Return whether x² − tx + n has a root modulo pᵉ: d is a square modulo pᵉ, or for p = 2 modulo 2ᵉ⁺²."""
    e += 2 * (p == 2)
    v = 0
    while v < e and d % p == 0:
        d, v = d // p, v + 1
    if v == e:
        return True
    if v % 2:
        return False
    return d % 2 ** min(3, e - v) == 1 if p == 2 else pow(d, (p - 1) // 2, p) == 1


def _polynomial(d: int, x: int) -> int:
    t = d % 2
    return x * x - t * x + (t - d) // 4


def _roots(d: int, p: int, e: int) -> list[int]:
    """Return the roots modulo pᵉ of x² − tx + n, a polynomial of discriminant d."""
    spend(p)
    found = [x for x in range(p) if _polynomial(d, x) % p == 0]
    for k in range(1, e):
        found = _lifted(d, p, k, found)
    return found


def _lifted(d: int, p: int, e: int, roots: list[int]) -> list[int]:
    """Return the roots modulo pᵉ⁺¹ above given roots modulo pᵉ."""
    spend(p * len(roots))
    power = p**e
    candidates = (x + power * k for x in roots for k in range(p))
    return [x for x in candidates if _polynomial(d, x) % (power * p) == 0]


def _class_number(d: int) -> int:
    """Return the number of reduced primitive forms a·x² + b·xy + c·y² of discriminant d < 0."""
    spend(10 + -d // 3)
    found = 0
    for a in range(1, isqrt(-d // 3) + 1):
        for b in range(1 - a, a + 1):
            if (b - d) % 2 == 0:
                c, rest = divmod(b * b - d, 4 * a)
                if not rest and (c > a or (c == a and b >= 0)) and gcd(a, b, c) == 1:
                    found += 1
    return found
