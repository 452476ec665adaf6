"""Whether two ideals differ by an element, and whether an ideal is principal.

``J = I·c`` means that c lies in ``I⁻¹·J`` and has the norm ``N(J)/N(I)``. In a definite algebra that is a
vector of least conceivable length in a positive definite lattice: it is there, or an exhausted enumeration
says that it is not (Kirschmer and Voight, *SIAM J. Comput.* 39, 2010). In an indefinite algebra strong
approximation decides, and the element is looked for among short vectors of a form that majorises the norm.
"""

from __future__ import annotations

import math
import random
from fractions import Fraction
from itertools import islice
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Quaternion
from hfield.errors import UndecidedError
from hfield.factorisation import factorise
from hfield.lattices import enumeration, hermite
from hfield.lattices.answers import STRONG_APPROXIMATION, Answer
from hfield.lattices.as_json import element_json, rows_json

if TYPE_CHECKING:
    from hfield.lattices.ideal import Ideal
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order

TRIED = 100_000
"""Vectors tried for an element of given norm in an indefinite algebra, and as many once more."""
PLACES = 25
FAR = 10**4
"""So many other places from which short vectors are looked for, and how far away."""


def equivalence(first: Ideal, second: Ideal) -> Answer:
    """Return c with ``second = first·c`` (left ideals) or ``c·first`` (right ones), or why there is none."""
    left = first.side != "right"
    if first.is_invertible() and second.is_invertible():
        ratio, goal = first, second
        bridge = (
            ratio.conjugate()._product(goal) if left else goal._product(ratio.conjugate())
        )._scaled(1 / first._norm)
        size: Fraction | None = second._norm / first._norm
    else:
        bridge = second.colon(first, "right" if left else "left")
        size = root(first._volume_ratio(second))
    evidence = {
        "kind": "equivalent",
        "algebra": str(first.algebra),
        "side": first.side,
        "first": rows_json(first),
        "second": rows_json(second),
        "between": rows_json(bridge),
    }
    lattices = (first, second, bridge)
    if size is None:
        reason = "the index of one in the other is no square"
        return Answer(False, reason, evidence=evidence, lattices=lattices)
    evidence["norm"] = str(size)
    found, reason = element_of_norm(bridge, size)
    if found is not None:
        evidence["element"] = element_json(found)
        reason = "the element is multiplied out"
        return Answer(True, reason, found, evidence=evidence, lattices=lattices)
    if first._regular.definite:
        return Answer(False, reason, evidence=evidence, lattices=lattices)
    if not (first.is_invertible() and second.is_invertible() and one_class(first.order)):
        raise UndecidedError(
            f"whether these ideals of an indefinite algebra are equivalent is not decided: {reason}, and "
            "strong approximation decides for invertible ideals of orders with Eichler symbols 1 and −1"
        )
    return Answer(
        True, f"{reason}, but there is one", None, STRONG_APPROXIMATION, evidence, lattices
    )


def one_class(order: Order) -> bool:
    """Tell whether the local units of an order are known to have all unit norms as norms."""
    primes = factorise(order._discriminant)
    return all(
        (order._regular.discriminant % p == 0 and order._discriminant % (p * p))
        or order.eichler_symbol(p) in (1, -1)
        for p in primes
    )


def element_of_norm(lattice: Lattice, size: Fraction) -> tuple[Quaternion | None, str]:
    """Return an element of norm ``size`` (±size in an indefinite algebra), or None and what was tried."""
    multiple = size / lattice._norm
    if multiple.denominator != 1:
        return None, f"no element has norm {size}, as all norms are multiples of {lattice._norm}"
    m = multiple.numerator
    if lattice._regular.definite:
        rows, gram = lattice._reduced
        for n in range(4):  # in a reduced basis a vector of least length is usually there
            if gram[n][n] == 2 * m:
                return lattice._element(hermite.tuples(rows)[n]), ""
        tried = 0
        for row, value in lattice._short(m):
            tried += 1
            if value == m:
                return lattice._element(row), ""
        if not tried:
            return None, f"no element but 0 has norm at most {size}"
        return None, f"none of the {2 * tried} elements of norm at most {size} has this norm"
    return _indefinite(lattice, m)


def _indefinite(lattice: Lattice, m: int) -> tuple[Quaternion | None, str]:
    """Try short vectors of the majorant for the value ±m, and short ones as they are seen from elsewhere.

    The elements c of L are those of L·ȳ divided by ȳ, for any y; and what is long seen from 1 may be short
    seen from y.
    """
    found = _among_short(lattice, m, TRIED)
    if found is not None:
        return found, ""
    rng = random.Random(m)
    for _ in range(PLACES):
        row = [rng.randint(-FAR, FAR) for _ in range(4)]
        y = sum((c * q for c, q in zip(row, lattice.basis, strict=True)), lattice.algebra(0))
        if y.norm() == 0:
            continue
        found = _among_short(lattice * y.conjugate(), m, TRIED // PLACES)
        if found is not None:
            return found * y / y.norm(), ""
    tried = f"{TRIED} short ones, nor among as many seen from {PLACES} other places"
    return None, f"no element of norm ±{m * lattice._norm} is among {tried}"


def _among_short(lattice: Lattice, m: int, most: int) -> Quaternion | None:
    """Return an element whose norm is ±m times that of the lattice, if one is among short vectors."""
    rows, gram = lattice._reduced
    size = hermite.tuples(rows * lattice._regular.majorant * rows.transpose())
    lines = hermite.tuples(rows)
    bound, tried = max(size[n][n] for n in range(4)), 0
    while tried < most:
        vectors = enumeration.short_vectors(size, bound)
        tried = 0
        for tried, (x, _) in enumerate(islice(vectors, most), 1):  # noqa: B007
            value = sum(x[i] * x[j] * gram[i][j] for i in range(4) for j in range(4)) // 2
            if abs(value) == m:
                return lattice._element(
                    [sum(x[i] * lines[i][n] for i in range(4)) for n in range(4)]
                )
        bound *= 2
    return None


def root(x: Fraction) -> Fraction | None:
    """Return the square root of a rational number, or None."""
    p, q = math.isqrt(x.numerator), math.isqrt(x.denominator)
    return Fraction(p, q) if (p * p, q * q) == (x.numerator, x.denominator) else None


__all__ = ["element_of_norm", "equivalence", "one_class", "root"]
