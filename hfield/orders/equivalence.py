"""Whether two ideals differ by an element, and whether an ideal is principal.

``J = I·c`` means that c lies in ``I⁻¹·J`` and has the norm ``N(J)/N(I)``. In a definite algebra that is a
vector of least conceivable length in a positive definite lattice: it is there, or an exhausted enumeration
says that it is not (Kirschmer and Voight, *SIAM J. Comput.* 39, 2010). In an indefinite algebra strong
approximation decides, and the element is looked for among short vectors of a form that majorises the norm,
then among what is short from other points of the hyperbolic plane (``hfield.fuchsian.search``, which stands
above and comes as an argument).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from itertools import islice

from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import factorise
from hfield.errors import UndecidedError
from hfield.orders import enumeration, hermite, ideal_products
from hfield.orders.certificates import STRONG_APPROXIMATION, Answer, element_json
from hfield.orders.invariants import eichler_symbol
from hfield.orders.lattice_values import (
    LatticeValue,
    colon,
    conjugate,
    index,
    is_locally_principal,
    product,
    rows_json,
    scaled,
)
from hfield.orders.short_elements import up_to
from hfield.orders.z_order import ZOrder

TRIED = 4_000
"""Short vectors tried for an element of given norm in an indefinite algebra, before others."""
Search = Callable[[LatticeValue, Fraction], Quaternion | None]
"""What looks for an element of norm ±n in a lattice of an indefinite algebra."""


def equivalence(
    first: LatticeValue, second: LatticeValue, order: ZOrder, side: str, search: Search
) -> Answer:
    """Return c with ``second = first·c`` (left ideals) or ``c·first`` (right ones), or why there is none.

    Raises :class:`UndecidedError` in an indefinite algebra, where strong approximation does not decide.
    """
    left = side != "right"
    invertible = is_locally_principal(first, order) and is_locally_principal(second, order)
    size: Fraction | None
    if invertible:
        bar = conjugate(first)
        pair = (bar, second) if left else (second, bar)
        # an ideal on the right may be given beside a two-sided one
        compatible = side != "two-sided"
        found = ideal_products.product(*pair, order) if compatible else product(*pair)
        bridge = scaled(found, 1 / first.norm)
        size = second.norm / first.norm
    else:
        bridge = colon(second, first, "right" if left else "left")
        size = root(index(first, second))
    lattices = (first, second, bridge)
    evidence = {
        "kind": "equivalent",
        "algebra": str(first.algebra),
        "side": side,
        **dict(zip(("first", "second", "between"), map(rows_json, lattices), strict=True)),
    }
    answer = partial(Answer, evidence=evidence, lattices=lattices)
    if size is None:
        return answer(False, "the index of one in the other is no square")
    evidence["norm"] = str(size)
    element, reason = element_of_norm(bridge, size, search)
    if element is not None:
        evidence["element"] = element_json(element)
        return answer(True, "the element is multiplied out", element)
    if first.ambient.definite:
        return answer(False, reason)
    if not (invertible and one_class(order)):
        raise UndecidedError(
            f"whether these ideals of an indefinite algebra are equivalent is not decided: {reason}, and "
            "strong approximation decides for invertible ideals of orders with Eichler symbols 1 and −1"
        )
    return answer(True, f"{reason}, but there is one", theorem=STRONG_APPROXIMATION)


def one_class(order: ZOrder) -> bool:
    """Tell whether the local units of an order are known to have all unit norms as norms."""
    primes = factorise(order.discriminant)
    return all(
        (order.ambient.discriminant % p == 0 and order.discriminant % (p * p))
        or eichler_symbol(order, p) in (1, -1)
        for p in primes
    )


def element_of_norm(
    lattice: LatticeValue, size: Fraction, search: Search
) -> tuple[Quaternion | None, str]:
    """Return an element of norm ``size`` (±size in an indefinite algebra), or None and what was tried."""
    multiple = size / lattice.norm
    if multiple.denominator != 1:
        return None, f"no element has norm {size}, as all norms are multiples of {lattice.norm}"
    m = multiple.numerator
    if lattice.ambient.definite:
        rows, gram = lattice.reduced
        for n in range(4):  # in a reduced basis a vector of least length is usually there
            if gram[n][n] == 2 * m:
                return lattice.element(hermite.tuples(rows)[n]), ""
        tried = 0
        for row, value in up_to(lattice, m):
            tried += 1
            if value == m:
                return lattice.element(row), ""
        if not tried:
            return None, f"no element but 0 has norm at most {size}"
        return None, f"none of the {2 * tried} elements of norm at most {size} has this norm"
    found = _among_short(lattice, m) or search(lattice, size)
    where = f"{TRIED} short ones, nor among those short from points of the hyperbolic plane"
    return found, "" if found else f"no element of norm ±{size} is among {where}"


def _among_short(lattice: LatticeValue, m: int) -> Quaternion | None:
    """Return an element whose norm is ±m times that of the lattice, if one is among short vectors."""
    rows, _ = lattice.reduced
    size = hermite.tuples(rows * lattice.ambient.majorant * rows.transpose())
    bound, tried = max(size[n][n] for n in range(4)), 0
    while tried < TRIED:
        vectors = enumeration.short_vectors(size, bound)
        tried = 0
        for tried, (x, _) in enumerate(islice(vectors, TRIED), 1):  # noqa: B007
            row = hermite.combination(x, rows)
            if abs(lattice.multiple(row)) == m:
                return lattice.element(row)
        bound *= 2
    return None


def root(x: Fraction) -> Fraction | None:
    """Return the square root of a rational number, or None."""
    p, q = math.isqrt(x.numerator), math.isqrt(x.denominator)
    return Fraction(p, q) if (p * p, q * q) == (x.numerator, x.denominator) else None
