"""Modulus, polar form, exponential, logarithm and powers of quaternions (thesis 1.3.1, 1.4.4).

Write q = w + v with 2w = tr(q). Then v² = s is a scalar and q lies in the commutative ring F[v]. With
φ = √|s|, a function f with real coefficients has the value

- Re f(w + iφ) + v·Im f(w + iφ)/φ   where s < 0, as in Hamilton's algebra for all q but scalars,
- f(w) + v·f′(w)                    where s = 0,
- the mean of f(w + φ) and f(w − φ), plus v times their difference over 2φ, where s > 0.

Over RDF numpy computes f, also of arrays (:mod:`.float_functions`); over RR the values are exact. Over rings
with cosines and sines of angles, the angle of a polar form is a rational combination of those angles and π.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Generic

from hfield.algebra.structure.elements.square_roots import square_roots
from hfield.algebra.structure.elements.undefined_values import NO_POLAR_FORM, no_value
from hfield.core.product import Constants, Coordinates, Scalar, norm, trace
from hfield.errors import CoercionError, HFieldError, NoSolutionError, RingError, shorten
from hfield.fields.base.ring import E, Ring
from hfield.fields.floats import RDF

if TYPE_CHECKING:
    from typing_extensions import TypeIs

    from hfield.fields.circles.angles import SymbolicAngle, WithAngles

    PolarForm = tuple[E, Coordinates[E], E | SymbolicAngle]


def over_floats(ring: Ring) -> bool:
    """Return whether functions are computed in floats. Raises :class:`RingError` over other inexact rings."""
    if not ring.is_exact and ring != RDF:
        raise RingError(
            "moduli, polar forms, exponentials and powers of floats are real functions, computed over RDF, "
            f"not over {ring}"
        )
    return ring == RDF


class RealFunctions(Generic[E]):
    """The exact functions of RR by name: ``exp``, ``log``, ``cos`` … and the angle of a point."""

    def __init__(self, ring: Ring[E], q: Coordinates[E]) -> None:
        batch = hasattr(q[0], "shape")
        if ring.name != "RR" or batch:
            what = f"arrays over {ring}" if batch else str(ring)
            raise RingError(
                "exponentials, logarithms and polar forms are computed over RDF, and of single quaternions "
                f"over RR, not over {what}: write q.change_ring('RR') or q.change_ring('RDF')"
            )
        self.ring = ring

    def __getattr__(self, name: str) -> Callable[[E], E]:
        return self.ring.functions()[name]

    def angle(self, y: E, x: E) -> E:
        """Return the angle of the point (x, y); it must be a rational multiple of π."""
        import sympy

        from hfield.fields.algebraic.closed_forms import to_sympy

        try:
            found: E = self.ring(sympy.atan2(to_sympy(y), to_sympy(x)))
        except HFieldError:
            raise CoercionError(
                f"the angle of the point ({x}, {y}) is not a rational multiple of π, and RR does not have "
                "it: write q.change_ring('RDF')"
            ) from None
        return found


def parts(ring: Ring[E], c: Constants[E], q: Coordinates[E]) -> tuple[E, Coordinates[E], E]:
    """Return w, v and s with ``q = w + v``, ``tr(v) = 0`` and ``v² = s``. 2 must be a unit of the ring."""
    a, t, b = c
    w, x, y, z = q
    half = ring.inverse(ring(2))
    middle = half * t * x  # of the trace t of i
    shifted = y + half * t * z
    square = (a + half * half * t * t) * (x * x - b * z * z) + b * shifted * shifted
    return w + middle, (-middle, x, y, z), square


def _combined(even: E, odd: E, v: Coordinates[E]) -> Coordinates[E]:
    """Return ``even + odd·v``."""
    w, x, y, z = v
    return even + odd * w, odd * x, odd * y, odd * z


def exact_value(
    ring: Ring[E],
    c: Constants[E],
    q: Coordinates[E],
    f: Callable[[E], E],
    slope: Callable[[E], E],
    complex_parts: Callable[[E, E], tuple[E, E]],
) -> Coordinates[E]:
    """Return f(q) over RR, from f(w), f′(w), and the real and imaginary parts of f(w + iφ)."""
    w, v, s = parts(ring, c, q)
    sign = ring.sign(s)
    if sign == 0:
        return _combined(f(w), slope(w), v)
    phi = ring.sqrt(s if sign > 0 else -s)
    assert phi is not None, "a positive number of RR has a root"
    if sign < 0:
        even, odd = complex_parts(w, phi)
    else:
        plus, minus, half = f(w + phi), f(w - phi), ring.inverse(ring(2))
        even, odd = half * (plus + minus), half * (plus - minus)
    return _combined(even, ring.divide(odd, phi), v)


def modulus(ring: Ring[E], c: Constants[E], q: Coordinates[E]) -> E:
    """Return ``|q| = √N(q)``, the nonnegative root, elementwise on arrays (Definition 2).

    Raises :class:`NoSolutionError` where the norm has no root in the base ring, and :class:`RingError`
    over a ring without an ordering.
    """
    if over_floats(ring):
        from hfield.algebra.structure.elements import float_functions

        found: E = float_functions.modulus(c, q)
        return found
    square = norm(c, q)
    try:
        positive(ring, square)
    except RingError:
        raise RingError(
            f"|q| is the nonnegative root of N(q), and {ring} has no ordering"
        ) from None
    root: E | None = ring.sqrt(square)
    if root is None:
        raise NoSolutionError(
            f"|q| = √({shorten(ring.text(square))}) is not in {ring}; q.change_ring('RR') has it where "
            f"{ring} is a field of real numbers"
        )
    return root if positive(ring, root) else -root


def positive(ring: Ring[E], x: E) -> bool:
    """Return whether x ≥ 0; for functions of angles, whether x ≥ 0 for all small positive angles."""
    sign: Callable[[E], int] = getattr(ring, "sign_near_zero", ring.sign)
    return sign(x) >= 0


def polar(ring: Ring[E], c: Constants[E], q: Coordinates[E]) -> PolarForm[E]:
    """Return r, n and θ with ``q = r·(cos θ + n·sin θ)`` and ``n² = −1``; for a scalar, n is i, j or k.

    Raises :class:`NoSolutionError` where v² > 0, or v ≠ 0 and v² = 0.
    """
    if over_floats(ring):
        from hfield.algebra.structure.elements import float_functions

        found: PolarForm[E] = float_functions.polar(c, q, lambda: _axis(ring, c))
        return found
    w, v, s = parts(ring, c, q)
    if has_angles(ring):
        return _polar_with_angles(ring, c, (w, v, s), modulus(ring, c, q))
    functions = RealFunctions(ring, q)
    r = modulus(ring, c, q)
    if all(map(ring.is_zero, v)):
        return r, _axis(ring, c), functions.angle(ring.zero, w)
    if ring.sign(s) >= 0:
        raise NoSolutionError(NO_POLAR_FORM)
    phi = functions.sqrt(-s)
    return r, _combined(ring.zero, ring.inverse(phi), v), functions.angle(phi, w)


def has_angles(ring: Ring[E]) -> TypeIs[WithAngles[E]]:
    """Return whether the ring has cosines and sines of angles."""
    return hasattr(ring, "angle_of_point")


def _polar_with_angles(
    ring: WithAngles[E], c: Constants[E], of: tuple[E, Coordinates[E], E], r: E
) -> PolarForm[E]:
    """Return the polar form; for small positive angles θ lies in [0, π], as over RR."""
    w, v, s = of
    if ring.is_zero(r):
        raise NoSolutionError("there is no polar form of an element of norm 0")
    scale = ring.inverse(r)
    if all(map(ring.is_zero, v)):
        return r, _axis(ring, c), ring.angle_of_point(w * scale, ring.zero)
    phi = ring.sqrt(-s)
    if phi is None:
        raise NoSolutionError(
            f"there is no polar form over {ring}, which has no root of {shorten(ring.text(-s))}"
        )
    if not positive(ring, phi):
        phi = -phi
    angle = ring.angle_of_point(w * scale, phi * scale)
    return r, _combined(ring.zero, ring.inverse(phi), v), angle


def power_with_angles(ring: Ring, c: Constants, q: Coordinates, exponent: Fraction) -> Coordinates:
    """Return ``rᵖ·(cos pθ + n·sin pθ)`` (De Moivre). Raises :class:`CoercionError`, NoSolutionError."""
    r, n, angle = polar(ring, c, q)
    length: Scalar | None = r
    if exponent.denominator != 1 and not ring.is_zero(r - ring.one):
        length = ring.sqrt(r) if exponent.denominator == 2 else None
        if length is None:
            raise NoSolutionError(
                f"|q|^({exponent}) is not in {ring}, where |q| = {shorten(ring.text(r))}"
            )
    length = ring.power(length, exponent.numerator)
    cosine, sine = ring.cosine_and_sine_of(angle * exponent)
    return _combined(length * cosine, length * sine, n)


def _axis(ring: Ring[E], c: Constants[E]) -> Coordinates[E]:
    """Return the first of i, j, k whose square is −1."""
    a, t, b = c
    zero, one = ring.zero, ring.one
    if ring.is_zero(t) and ring.is_zero(a + one):
        return zero, one, zero, zero
    if ring.is_zero(b + one):
        return zero, zero, one, zero
    if ring.is_zero(a * b - one):
        return zero, zero, zero, one
    raise NoSolutionError("none of i, j, k has the square −1, to be the axis of a scalar")


def cosine_and_sine(ring: Ring, angle: object) -> tuple[Scalar, Scalar]:
    """Return cos and sin of an angle in radians; over RDF the angle may be an array."""
    if has_angles(ring):
        return ring.cosine_and_sine_of(angle)
    if ring.is_exact:
        functions, theta = RealFunctions(ring, (angle,) * 4), ring(angle)
        return functions.cos(theta), functions.sin(theta)
    import numpy as np

    theta = np.asarray(angle, dtype=float)
    return (
        (np.cos(theta), np.sin(theta))
        if theta.ndim
        else (float(np.cos(theta)), float(np.sin(theta)))
    )


def exp(ring: Ring[E], c: Constants[E], q: Coordinates[E]) -> Coordinates[E]:
    """Return the sum of ``qⁿ/n!``; in Hamilton's algebra ``eʷ·(cos φ + n·sin φ)`` for q = w + φ·n."""
    if over_floats(ring):
        from hfield.algebra.structure.elements import float_functions

        return float_functions.value(ring, c, q, float_functions.EXP)
    if has_angles(ring):
        if all(map(ring.is_zero, q)):
            return ring.one, ring.zero, ring.zero, ring.zero
        raise CoercionError(
            f"the exponential is not a rational function of cosines and sines, so not in {ring}; (n * "
            "angle).exp() is, for an axis n and an angle of the ring such as ring.angle('2*t')"
        )
    of = RealFunctions(ring, q)
    return exact_value(
        ring,
        c,
        q,
        of.exp,
        of.exp,
        lambda w, phi: (of.exp(w) * of.cos(phi), of.exp(w) * of.sin(phi)),
    )


def log(ring: Ring[E], c: Constants[E], q: Coordinates[E]) -> Coordinates[E]:
    """Return the principal logarithm, ``log|q| + n·θ`` with θ in [0, π).

    Raises :class:`NoSolutionError` for 0, for negative scalars, and if q has a negative real eigenvalue.
    """
    if over_floats(ring):
        from hfield.algebra.structure.elements import float_functions

        return float_functions.value(ring, c, q, float_functions.LOG)
    of = RealFunctions(ring, q)

    def real(x: E) -> E:
        if ring.sign(x) <= 0:
            raise NoSolutionError(no_value(", ".join(map(ring.text, q)), "principal logarithm"))
        return of.log(x)

    return exact_value(
        ring,
        c,
        q,
        real,
        ring.inverse,
        lambda w, phi: (of.log(of.sqrt(w * w + phi * phi)), of.angle(phi, w)),
    )


def sqrt(ring: Ring[E], c: Constants[E], q: Coordinates[E]) -> Coordinates[E]:
    """Return the principal root, which has positive trace or is 0. Raises :class:`NoSolutionError`."""
    if over_floats(ring):
        return power(ring, c, q, 0.5)
    if all(map(ring.is_zero, q)):
        return q
    found = square_roots(ring, c, q)
    for root in found.isolated:
        if not ring.is_zero(trace(c, root)) and positive(ring, trace(c, root)):
            return root
    others = "q.square_roots() has roots of trace 0" if found else "a larger ring may have one"
    raise NoSolutionError(f"there is no square root of positive trace over {ring}; {others}")


def power(
    ring: Ring[E], c: Constants[E], q: Coordinates[E], exponent: float | Fraction
) -> Coordinates[E]:
    """Return ``exp(exponent·log q)`` over RDF."""
    over_floats(ring)
    from hfield.algebra.structure.elements import float_functions

    return float_functions.value(ring, c, q, float_functions.power_function(exponent))
