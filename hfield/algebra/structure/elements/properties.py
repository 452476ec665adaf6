"""Decide whether an element is nilpotent, idempotent, a unit, or conjugate to another."""

import itertools

from hfield.algebra.structure.invariants.finite_radical import is_nilpotent as is_nilpotent_scalar
from hfield.core.product import Constants, Coordinates, Scalar, multiply, norm, trace
from hfield.errors import UndecidedError
from hfield.fields.base.powers import power
from hfield.fields.base.ring import Ring
from hfield.fields.linear_algebra.kernels import kernel
from hfield.fields.quadratic_forms.normal_forms import basis_of
from hfield.verdicts import Verdict


def characteristic_polynomial(
    ring: Ring, c: Constants, q: Coordinates
) -> tuple[Scalar, Scalar, Scalar]:
    """Return the coefficients of ``x² − tr(q)·x + N(q)``, low degree first."""
    return norm(c, q), ring.zero - trace(c, q), ring.one


def is_nilpotent(ring: Ring, c: Constants, q: Coordinates) -> bool:
    """Return whether a power of q is 0, which holds if and only if its trace and norm are nilpotent in the
    ring.

    One direction follows from ``q² = tr(q)·q − N(q)``, the other by reducing modulo every prime ideal.
    """
    return all(_nilpotent_scalar(ring, x) for x in (trace(c, q), norm(c, q)))


def _nilpotent_scalar(ring: Ring, x: Scalar) -> bool:
    if ring.is_zero(x) or ring.is_field:
        return ring.is_zero(x)
    if ring.order is not None:
        return is_nilpotent_scalar(ring, x)
    if ring.annihilator(x) is None:  # a nilpotent element is a zero divisor
        return False
    if any(ring.is_zero(power(ring.one, x, n)) for n in (2, 64)):
        return True
    raise UndecidedError(f"whether {ring.text(x)} is nilpotent in {ring.name} is not decided")


def is_idempotent(ring: Ring, c: Constants, q: Coordinates) -> bool:
    """Return whether ``q² = q``."""
    return all(ring.equal(x, y) for x, y in zip(multiply(c, q, q), q, strict=True))


def is_unit(ring: Ring, c: Constants, q: Coordinates) -> bool:
    """Return whether q has an inverse: whether its norm has one."""
    return ring.is_unit(norm(c, q))


def conjugacy(ring: Ring, c: Constants, p: Coordinates, q: Coordinates) -> Verdict[Coordinates]:
    """Return whether there is a unit x with ``x·p = q·x``, with such an x. The ring must be a field.

    The solutions form a linear space, and the norm is a quadratic form on it. If the form vanishes on a basis
    and on the sums of two basis vectors, it is 0; so only these are tried. In a central simple algebra there
    is a unit whenever p and q have the same minimal polynomial (Skolem and Noether).
    """
    if not ring.is_field:
        raise UndecidedError(f"{ring.no_field}: conjugacy is decided over fields only")
    for name, function in (("traces", trace), ("norms", norm)):
        x, y = function(c, p), function(c, q)
        if not ring.equal(x, y):
            return Verdict(False, f"their {name} differ: {ring.text(x)} and {ring.text(y)}")
    columns = [
        [x - y for x, y in zip(multiply(c, u, p), multiply(c, q, u), strict=True)]
        for u in basis_of(ring)
    ]
    space = kernel(ring, [list(row) for row in zip(*columns, strict=True)], 4)
    sums = ([x + y for x, y in zip(u, v, strict=True)] for u, v in itertools.combinations(space, 2))
    for w, x, y, z in itertools.chain(space, sums):
        if not ring.is_zero(norm(c, (w, x, y, z))):
            return Verdict(True, "x·p = q·x is solved by a unit", (w, x, y, z))
    reason = f"x·p = q·x has a solution space of dimension {len(space)}, and no unit is in it"
    return Verdict(False, reason)
