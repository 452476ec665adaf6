"""Square roots in local fields, by Hensel's lemma, and −1 as a sum of squares.

If 2 is not invertible in the residue field, a unit is first brought as close to 1 as multiplication by
squares allows (its quadratic defect: O'Meara, *Introduction to Quadratic Forms*, §63A).
"""

from __future__ import annotations

import itertools
from random import Random
from typing import TYPE_CHECKING

from hfield.core.product import Scalar
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.local.element import LocalElement

if TYPE_CHECKING:
    from hfield.fields.local.field import LocalField


TRIES = 5_000


def square_root(F: LocalField, x: LocalElement, digits: int) -> LocalElement | None:
    """Return a square root of x, or None if there is none.

    It is exact if x is exact and its root is in the global field; otherwise it is known to ``digits`` digits,
    or to as many as x allows. Raises :class:`UndecidedError`, whose message gives the number of digits of x
    needed.
    """
    if x.is_exact:
        root = F.global_field.sqrt(x.value)
        if root is not None or not x.has_value:
            return LocalElement(F, x.value if root is None else root)
    elif F.characteristic != 2 and not x.has_value:
        F.check_digits(x, F.square_digits, "its square class")
    if F.characteristic == 2:
        return _even_root(F, x)
    n = x.valuation()
    if n % 2:
        return None
    known = x.digits()
    wanted = digits if known is None else min(digits, known - F.doubling)
    scale = F.global_field.power(F.pi, n // 2)
    unit = F.global_field.divide(x.value, scale * scale)
    start = _near_root(F, F.truncated(unit, max(wanted, 0) + 2 * F.doubling + 1), known)
    if start is None:
        return None
    F.check_digits(x, F.square_digits, f"whether {x} is a square")
    root = hensel(F, (-unit, F.global_field.zero, F.global_field.one), start, wanted)
    return LocalElement(F, root * scale, wanted + n // 2)


def _even_root(F: LocalField, x: LocalElement) -> LocalElement | None:
    """Return the square root in characteristic 2 of an element without a root in the global field."""
    if x.is_exact:
        return None  # k is perfect, so that x = u² + t·v² is a square only if v = 0
    K: Ring[Scalar] = F.global_field
    (t,) = K.variable_names
    slope = K.derivative(x.value, t)
    shift = F.order_of(K.derivative(F.pi, t))
    if (
        not K.is_zero(slope)
        and x.precision is not None
        and F.order_of(slope) - shift < x.precision - 1
    ):
        return None  # a term of odd degree is known
    raise UndecidedError(
        f"whether {x} is a square in {F} is not decided by any number of digits: it must be given exactly"
    )


def _near_root(F: LocalField, unit: Scalar, known: int | None) -> Scalar | None:
    """Return y with v(y² − u) > 2·v(2) for a unit u of the global field, or None if u is not a square.

    If only ``known`` digits of u are known, y² agrees with these; None then means that no unit with these
    digits is a square.
    """
    K: Ring[Scalar] = F.global_field
    k, e = F.residues, F.doubling
    if not e:
        root = k.sqrt(k.reduce(unit))
        return None if root is None else K(k.lift(root))
    y, digits = K(k.lift(k.sqrt(k.reduce(unit)))), 2 * e + 2
    while True:
        rest = K.divide(unit, y * y) - K.one
        n = digits if K.is_zero(rest) else F.order_of(rest)
        if n > 2 * e or (known is not None and n >= known):
            return y
        if n % 2:
            return None
        # (1 + π^m·d)² = 1 + 2π^m·d + π^2m·d², where 2π^m is smaller than π^2m, or as small for n = 2e
        step = K.power(F.pi, n // 2)
        leading = k.reduce(K.divide(rest, step * step))
        if n < 2 * e:
            factor = K.one + step * K(k.lift(k.sqrt(leading)))
        else:
            # (1 + 2z)² = 1 + 4(z² + z)
            found = k.quadratic_root(k.one, k.one, k.reduce(K.divide(rest, K(4))))
            if found is None:
                return None
            z = k.multiply(found[0], k.inverse(found[1]))
            factor = K.one + K(2) * K(k.lift(z))
        y = F.truncated(y * factor, digits)


def hensel(F: LocalField, f: tuple[Scalar, Scalar, Scalar], x: Scalar, digits: int) -> Scalar:
    """Return a root of ``f₀ + f₁·X + f₂·X²`` up to π^digits, from an x with v(f(x)) > 2·v(f′(x)).

    All are elements of the global field. Newton's iteration doubles the known digits of the only root near x
    (Hensel's lemma).
    """
    K: Ring[Scalar] = F.global_field
    while True:
        value, slope = f[0] + x * (f[1] + x * f[2]), f[1] + x * (f[2] + f[2])
        n = F.order_of(slope)
        if K.is_zero(value) or F.order_of(value) - n >= digits:
            return F.truncated(x, digits)
        reached = F.order_of(value) - n  # the valuation of x less the root
        x = F.truncated(x - K.divide(value, slope), min(2 * reached - n, max(digits, n + 1)))


def minus_one(F: LocalField) -> tuple[LocalElement, ...]:
    """Return as many elements as the level whose squares add up to −1."""
    root = F.sqrt(-F.one)
    if root is not None:
        return (root,)
    if F.doubling and F.doubling * len(F.residues.over_prime_field()) % 2:  # the degree over ℚ₂
        root = F.sqrt(F(-7))
        assert root is not None  # −7 is 1 modulo 8
        return F.one, F.one, F(2), root
    rng = Random(1)
    for n in itertools.islice(itertools.count(), TRIES):
        x = F(n) if n < 10 else F(sum((F.random(rng).value * F.pi**m for m in range(4)), F.pi * 0))
        root = F.sqrt(-F.one - x * x)
        if root is not None:
            return x, root
    raise UndecidedError(f"−1 is a sum of two squares in {F}, but none were found in {TRIES} tries")
