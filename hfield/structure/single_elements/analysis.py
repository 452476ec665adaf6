"""Modulus, polar form, exponential, logarithm and powers of quaternions (thesis 1.3.1, 1.4.4).

Write q = w + v with 2w = tr(q). Then v² = s is a scalar and q lies in the commutative ring F[v]. With
φ = √|s|, a function f with real coefficients has the value

- Re f(w + iφ) + v·Im f(w + iφ)/φ   where s < 0, as in Hamilton's algebra for all q but scalars,
- f(w) + v·f′(w)                    where s = 0,
- the mean of f(w + φ) and f(w − φ), plus v times their difference over 2φ, where s > 0.

Over RDF numpy computes f, of arrays too; over RR the values are exact.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from hfield.errors import CoercionError, HFieldError, NoSolutionError, RingError, shorten
from hfield.product import Constants, Coordinates, norm, trace
from hfield.rings.base import Ring
from hfield.structure.single_elements.square_roots import square_roots

if TYPE_CHECKING:
    import numpy as np


class RealFunctions:
    """The exact functions of RR by name: ``exp``, ``log``, ``cos`` … and the angle of a point."""

    def __init__(self, ring: Ring, q: Coordinates) -> None:
        if ring.name != "RR" or _is_batch(q):
            what = f"arrays over {ring}" if _is_batch(q) else str(ring)
            raise RingError(
                "exponentials, logarithms and polar forms are computed over RDF, and of single quaternions "
                f"over RR, not over {what}: write q.change_ring('RR') or q.change_ring('RDF')"
            )
        self.ring: Any = ring

    def __getattr__(self, name: str) -> Callable[[Any], Any]:
        function: Callable[[Any], Any] = self.ring.functions()[name]
        return function

    def angle(self, y: Any, x: Any) -> Any:
        """Return the angle of the point (x, y), which must be a rational multiple of π."""
        import sympy

        from hfield.rings.closed_fields.closed_forms import to_sympy

        try:
            return self.ring(sympy.atan2(to_sympy(y), to_sympy(x)))
        except HFieldError:
            raise CoercionError(
                f"the angle of the point ({x}, {y}) is no rational multiple of π, and RR does not have "
                "it: write q.change_ring('RDF')"
            ) from None


def parts(ring: Ring, c: Constants, q: Coordinates) -> tuple[Any, Coordinates, Any]:
    """Return w, v and s with ``q = w + v``, ``tr(v) = 0`` and ``v² = s``. 2 must be a unit of the ring."""
    a, t, b = c
    w, x, y, z = q
    half = ring.inverse(ring(2))
    middle = half * t * x  # of the trace t of i
    shifted = y + half * t * z
    square = (a + half * half * t * t) * (x * x - b * z * z) + b * shifted * shifted
    return w + middle, (-middle, x, y, z), square


def _combined(even: Any, odd: Any, v: Coordinates) -> Coordinates:
    """Return ``even + odd·v``."""
    w, x, y, z = v
    return even + odd * w, odd * x, odd * y, odd * z


def exact_value(
    ring: Any,
    c: Constants,
    q: Coordinates,
    f: Callable[[Any], Any],
    slope: Callable[[Any], Any],
    complex_parts: Callable[[Any, Any], tuple[Any, Any]],
) -> Coordinates:
    """Return f(q) over RR, from f(w), f′(w), and the real and imaginary part of f(w + iφ)."""
    w, v, s = parts(ring, c, q)
    sign = ring.sign(s)
    if sign == 0:
        return _combined(f(w), slope(w), v)
    phi = ring.sqrt(s if sign > 0 else -s)
    if sign < 0:
        even, odd = complex_parts(w, phi)
    else:
        plus, minus, half = f(w + phi), f(w - phi), ring.inverse(ring(2))
        even, odd = half * (plus + minus), half * (plus - minus)
    return _combined(even, ring.divide(odd, phi), v)


def float_value(
    ring: Ring,
    c: Constants,
    q: Coordinates,
    noun: str,
    f: Callable[[Any], Any],
    slope: Callable[[Any], Any],
) -> Coordinates:
    """Return f(q) over RDF, from numpy's functions f and f′ of complex arrays."""
    import numpy as np

    w, v, s = parts(ring, c, q)
    phi = np.sqrt(np.abs(s))
    flat, split = np.asarray(s == 0), np.asarray(s > 0)
    with np.errstate(all="ignore"):
        at = f(w + 1j * np.where(s < 0, phi, 0.0))
        even, odd, is_real = at.real, at.imag / phi, at.imag == 0
        if flat.any():
            odd = np.where(flat, np.where(_is_scalar(q), 0.0, slope(w + 0j).real), odd)
        if split.any():
            plus, minus = f(w + phi + 0j), f(w - phi + 0j)
            even = np.where(split, (plus + minus).real / 2, even)
            odd = np.where(split, (plus - minus).real / (2 * phi), odd)
            is_real = np.where(split, (plus.imag == 0) & (minus.imag == 0), is_real)
    wrong = ((flat | split) & ~is_real) | ~np.isfinite(even) | ~np.isfinite(odd)
    if wrong.any():
        raise _no_value(ring, q, wrong, noun)
    return _combined(even, odd, v) if _is_batch(q) else _combined(float(even), float(odd), v)


def _is_batch(q: Coordinates) -> bool:
    return hasattr(q[0], "shape")


def _is_scalar(q: Coordinates) -> Any:
    _, x, y, z = q
    return (x == 0) & (y == 0) & (z == 0)


def _no_value(ring: Ring, q: Coordinates, wrong: np.ndarray, noun: str) -> NoSolutionError:
    """Say at which entry there is no value, and why."""
    where = tuple(int(n[0]) for n in wrong.nonzero()) if _is_batch(q) else ()
    shown = ", ".join(ring.text(x[where] if _is_batch(q) else x) for x in q)
    at = f" at index {where}" if _is_batch(q) else ""
    return NoSolutionError(
        f"the quaternion ({shown}){at} has no {noun}: it is 0 or too large, has a negative real "
        "eigenvalue, or is a negative scalar, for which every n with n² = −1 gives another value"
    )


def modulus(ring: Ring, c: Constants, q: Coordinates) -> Any:
    """Return ``|q| = √N(q)``, the nonnegative root, of an array elementwise (Definition 2).

    Raises :class:`NoSolutionError` where the norm has no root in the base ring, and :class:`RingError`
    over a ring without an ordering.
    """
    square = norm(c, q)
    if not ring.is_exact:
        return _float_modulus(c, q, square)
    try:
        ring.sign(square)
    except RingError:
        raise RingError(
            f"|q| is the nonnegative root of N(q), and {ring} has no ordering"
        ) from None
    root = ring.sqrt(square)
    if root is None:
        raise NoSolutionError(
            f"|q| = √({shorten(ring.text(square))}) is not in {ring}; q.change_ring('RR') has it where "
            f"{ring} is a field of real numbers"
        )
    return -root if ring.sign(root) < 0 else root


def _float_modulus(c: Constants, q: Coordinates, square: Any) -> Any:
    import numpy as np

    if np.any(np.asarray(square) < 0):
        raise NoSolutionError("|q| = √N(q), and the norm is negative here")
    if not _is_batch(q):
        return float(np.sqrt(square)) if 1e-290 < square < 1e290 else _scaled_modulus(c, q)
    root = np.sqrt(square)
    for where in map(tuple, np.argwhere(~((square > 1e-290) & (square < 1e290)))):
        w, x, y, z = (float(part[where]) for part in q)
        root[where] = _scaled_modulus(c, (w, x, y, z))
    return root


def _scaled_modulus(c: Constants, q: Coordinates) -> float:
    """Return the modulus of a quaternion of floats whose norm leaves their range."""
    largest = max(map(abs, q))
    if largest == 0:
        return 0.0
    w, x, y, z = (part / largest for part in q)
    return float(largest * norm(c, (w, x, y, z)) ** 0.5)


def polar(ring: Ring, c: Constants, q: Coordinates) -> tuple[Any, Coordinates, Any]:
    """Return r, n and θ with ``q = r·(cos θ + n·sin θ)`` and ``n² = −1``; n of a scalar is i, j or k.

    Raises :class:`NoSolutionError` where v² > 0, or v ≠ 0 and v² = 0.
    """
    w, v, s = parts(ring, c, q)
    if not ring.is_exact:
        return _float_polar(ring, c, q)
    functions = RealFunctions(ring, q)
    r = modulus(ring, c, q)
    if all(map(ring.is_zero, v)):
        return r, _axis(ring, c), functions.angle(ring.zero, w)
    if ring.sign(s) >= 0:
        raise _no_polar_form(q)
    phi = functions.sqrt(-s)
    return r, _combined(ring.zero, ring.inverse(phi), v), functions.angle(phi, w)


def _float_polar(ring: Ring, c: Constants, q: Coordinates) -> tuple[Any, Coordinates, Any]:
    import numpy as np

    w, v, s = parts(ring, c, q)
    scalar = np.asarray(_is_scalar(q))
    if np.any((np.asarray(s) >= 0) & ~scalar):
        raise _no_polar_form(q)
    phi = np.sqrt(np.abs(s))
    angle = np.arctan2(phi, w)
    with np.errstate(all="ignore"):
        factor = np.where(scalar, 0.0, 1 / phi)
    axis = _combined(0.0, factor if _is_batch(q) else float(factor), v)
    if scalar.any():
        w, x, y, z = (p + n * scalar for p, n in zip(axis, _axis(ring, c), strict=True))
        axis = (w, x, y, z) if _is_batch(q) else (float(w), float(x), float(y), float(z))
    return modulus(ring, c, q), axis, angle if _is_batch(q) else float(angle)


def _no_polar_form(q: Coordinates) -> NoSolutionError:
    what = "an entry of the array" if _is_batch(q) else "the quaternion"
    return NoSolutionError(f"{what} has no polar form: its part of trace 0 has no negative square")


def _axis(ring: Any, c: Constants) -> Coordinates:
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


def cosine_and_sine(ring: Ring, angle: Any) -> tuple[Any, Any]:
    """Return cos and sin of an angle in radians, over RDF of an array too."""
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


def exp(ring: Ring, c: Constants, q: Coordinates) -> Coordinates:
    """Return the sum of ``qⁿ/n!``, in Hamilton's algebra ``eʷ·(cos φ + n·sin φ)`` for q = w + φ·n."""
    if not ring.is_exact:
        import numpy as np

        return float_value(ring, c, q, "exponential within the range of floats", np.exp, np.exp)
    of = RealFunctions(ring, q)
    return exact_value(
        ring,
        c,
        q,
        of.exp,
        of.exp,
        lambda w, phi: (of.exp(w) * of.cos(phi), of.exp(w) * of.sin(phi)),
    )


def log(ring: Ring, c: Constants, q: Coordinates) -> Coordinates:
    """Return the principal logarithm, ``log|q| + n·θ`` with θ in [0, π).

    Raises :class:`NoSolutionError` for 0, for negative scalars and where a real eigenvalue is negative.
    """
    noun = "principal logarithm"
    if not ring.is_exact:
        import numpy as np

        return float_value(ring, c, q, noun, np.log, np.reciprocal)
    import numpy as np

    of = RealFunctions(ring, q)

    def real(x: Any) -> Any:
        if ring.sign(x) <= 0:
            raise _no_value(ring, q, np.zeros(1), noun)
        return of.log(x)

    return exact_value(
        ring,
        c,
        q,
        real,
        ring.inverse,
        lambda w, phi: (of.log(of.sqrt(w * w + phi * phi)), of.angle(phi, w)),
    )


def sqrt(ring: Ring, c: Constants, q: Coordinates) -> Coordinates:
    """Return the principal root: of trace > 0, or 0 for 0. Raises :class:`NoSolutionError`."""
    if not ring.is_exact:
        return power(ring, c, q, 0.5)
    if all(map(ring.is_zero, q)):
        return q
    found = square_roots(ring, c, q)
    for root in found.isolated:
        if ring.sign(trace(c, root)) > 0:
            return root
    there = "those of trace 0, q.square_roots()" if found else "none"
    raise NoSolutionError(
        f"there is no square root of positive trace over {ring}; there are {there}; "
        "q.change_ring('RR') may have more"
    )


def power(ring: Ring, c: Constants, q: Coordinates, exponent: float | Fraction) -> Coordinates:
    """Return ``exp(exponent·log q)`` over RDF."""
    import numpy as np

    p = float(exponent)

    def f(z: np.ndarray) -> Any:
        return np.sqrt(z) if p == 0.5 else np.power(z, p)

    noun = f"principal power with the exponent {exponent}"
    return float_value(ring, c, q, noun, f, lambda z: p * np.power(z, p - 1))
