"""What an element is: nilpotent, idempotent, a unit and of which order, a conjugate of another."""

import itertools
import math
from dataclasses import dataclass
from typing import Any

from hfield.errors import NotInvertibleError, UndecidedError
from hfield.factorisation import factorise
from hfield.product import Constants, Coordinates, multiply, norm, trace
from hfield.rings.base import Ring, power
from hfield.rings.functions import FunctionField
from hfield.rings.quadratic import QuadraticField
from hfield.structure.commutators import basis_of
from hfield.structure.linear import kernel

SEARCHED_ORDERS = 120


def characteristic_polynomial(ring: Ring, c: Constants, q: Coordinates) -> tuple[Any, Any, Any]:
    """Return the coefficients of ``x² − tr(q)·x + N(q)``, low degree first."""
    return norm(c, q), ring.zero - trace(c, q), ring.one


def is_nilpotent(ring: Ring, c: Constants, q: Coordinates) -> bool:
    """Tell whether a power of q is 0: whether its trace and norm are nilpotent in the ring.

    From ``q² = tr(q)·q − N(q)`` in one direction, and modulo every prime ideal in the other.
    """
    return all(_nilpotent_scalar(ring, x) for x in (trace(c, q), norm(c, q)))


def _nilpotent_scalar(ring: Ring, x: Any) -> bool:
    if ring.order is None or ring.is_field:  # these rings have no nilpotent elements but 0
        return ring.is_zero(x)
    return ring.is_zero(power(ring.one, x, ring.order.bit_length()))


def is_idempotent(ring: Ring, c: Constants, q: Coordinates) -> bool:
    """Tell whether ``q² = q``."""
    return all(ring.equal(x, y) for x, y in zip(multiply(c, q, q), q, strict=True))


def is_unit(ring: Ring, c: Constants, q: Coordinates) -> bool:
    """Tell whether q has an inverse: whether its norm has one."""
    return ring.is_unit(norm(c, q))


@dataclass(frozen=True)
class Conjugator:
    """A unit ``element`` with ``element·p·element⁻¹ = q``, or None with the reason why there is none."""

    element: Coordinates | None
    reason: str

    def __bool__(self) -> bool:
        """Tell whether p and q are conjugate."""
        return self.element is not None


def conjugator(ring: Ring, c: Constants, p: Coordinates, q: Coordinates) -> Conjugator:
    """Return a unit x with ``x·p = q·x``, or the reason why there is none. The ring must be a field.

    The solutions are a linear space. The norm is a quadratic form on it, and one that vanishes on a
    basis and on the sums of two basis vectors is 0, so there is no more to try. In a central simple algebra
    there is one whenever p and q have the same minimal polynomial (Skolem and Noether).
    """
    if not ring.is_field:
        raise UndecidedError(f"{ring.name} is not a field: conjugacy is decided over fields only")
    for name, function in (("traces", trace), ("norms", norm)):
        x, y = function(c, p), function(c, q)
        if not ring.equal(x, y):
            return Conjugator(None, f"their {name} differ: {ring.text(x)} and {ring.text(y)}")
    columns = [
        [x - y for x, y in zip(multiply(c, u, p), multiply(c, q, u), strict=True)]
        for u in basis_of(ring)
    ]
    space = kernel(ring, [list(row) for row in zip(*columns, strict=True)], 4)
    sums = ([x + y for x, y in zip(u, v, strict=True)] for u, v in itertools.combinations(space, 2))
    for w, x, y, z in itertools.chain(space, sums):
        if not ring.is_zero(norm(c, (w, x, y, z))):
            return Conjugator((w, x, y, z), "x·p = q·x is solved by a unit")
    reason = f"x·p = q·x has a solution space of dimension {len(space)}, and no unit is in it"
    return Conjugator(None, reason)


def multiplicative_order(ring: Ring, c: Constants, q: Coordinates) -> int | None:
    """Return the least n > 0 with ``qⁿ = 1``, or None if there is none.

    Raises :class:`NotInvertibleError` when q is no unit and :class:`UndecidedError` over the real and
    complex numbers when no order up to 120 fits.
    """
    if not is_unit(ring, c, q):
        raise NotInvertibleError("an element without inverse has no order: its norm is no unit")
    exponent = _exponent(ring, c, q)
    if exponent is None:
        return None
    if not _is_one(ring, c, q, exponent):
        if ring.name in ("RR", "CC"):
            raise UndecidedError(
                f"the order is infinite or greater than {SEARCHED_ORDERS}: not decided"
            )
        return None
    for p in factorise(exponent):
        while exponent % p == 0 and _is_one(ring, c, q, exponent // p):
            exponent //= p
    return exponent


def _is_one(ring: Ring, c: Constants, q: Coordinates, n: int) -> bool:
    one = basis_of(ring)[0]
    result = one
    for bit in bin(n)[2:]:
        result = multiply(c, result, result)
        if bit == "1":
            result = multiply(c, result, q)
    return all(ring.equal(x, y) for x, y in zip(result, one, strict=True))


def _exponent(ring: Ring, c: Constants, q: Coordinates) -> int | None:
    """Return a number that is a multiple of the order of q if that is finite; None for infinite order.

    q generates an algebra of dimension at most 2. Over GF(q) that is GF(q²), GF(q)² or GF(q)[ε]; a root of
    unity of degree at most 2 over ℚ has order 1, 2, 3, 4 or 6; over a quadratic field 1 to 6, 8, 10 or 12.
    """
    size = ring.order
    if isinstance(ring, FunctionField) and ring.base.order is not None:
        if any(x.num.degree() > 0 or x.den.degree() > 0 for x in (trace(c, q), norm(c, q))):
            return None
        size = ring.base.order
    if size is not None:
        if ring.is_field:
            return (size * size - 1) * ring.characteristic
        return math.lcm(*(p**k * (p * p - 1) for p, k in factorise(size).items()))
    if ring.characteristic or not ring.is_exact:
        raise UndecidedError(f"orders of units over {ring.name} are not decided")
    if ring.name in ("RR", "CC"):
        return next((n for n in range(1, SEARCHED_ORDERS + 1) if _is_one(ring, c, q, n)), 1)
    return 120 if isinstance(ring, QuadraticField) else 12
