"""Draw random elements with a property over an infinite field.

One zero divisor z gives elements of all kinds. ``z·q`` has norm 0. For two such elements u, v of the left
ideal A·z, the combination ``tr(u)·v − tr(v)·u`` is nilpotent, and ``u/tr(u)`` is idempotent. An element of
norm n, multiplied by elements ``q²/N(q)`` of norm 1, gives others of norm n.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from random import Random

from hfield.algebra import structure
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure.elements.trace_and_norm import element_of
from hfield.core.product import Coordinates, Scalar
from hfield.errors import UndecidedError
from hfield.exploring.properties import Condition
from hfield.fields import quadratic_forms

MAX_TRIALS = 200
"""So often in a row nothing new may be found."""
TRACES = 24
"""So many traces are tried for an element of given norm."""


def sample(algebra: Parent, condition: Condition, n: int, seed: int) -> tuple[Quaternion, ...]:
    """Return up to n distinct elements with a property over a field.

    Raises :class:`UndecidedError` if no element of a given norm is found, or zero divisors are not decided.
    """
    ring = algebra.ring
    if not ring.is_field:
        raise UndecidedError(
            f"elements are sampled over fields and finite rings, and {ring} is an infinite ring: use "
            "its field of fractions"
        )
    draw = _drawing(algebra, condition, Random(seed))
    found: list[Quaternion] = []
    seen: set[Hashable] = set()
    misses = 0
    while len(found) < n and misses < MAX_TRIALS:
        q = draw()
        key = None if q is None else q.text()
        if q is None or key in seen:
            misses += 1
            continue
        seen.add(key)
        found.append(q)
        misses = 0
    return tuple(found)


def _drawing(algebra: Parent, condition: Condition, rng: Random) -> Callable[[], Quaternion | None]:
    """Return a function that draws an element with the property, or None on failure."""
    ring, c = algebra.ring, algebra.constants
    name, value = condition

    def anything() -> Quaternion:
        w, x, y, z = (ring.random(rng) for _ in range(4))
        return Quaternion(algebra, (w, x, y, z))

    def unit() -> Quaternion | None:
        q = anything()
        return q if q.is_unit() else None

    if name == "units":
        return unit
    if name == "trace":
        return _of_trace(algebra, value, anything)
    if name == "norm" and not ring.is_zero(value):
        start = algebra(*_of_norm(algebra, value))

        def of_norm() -> Quaternion | None:
            q = unit()
            if q is None:
                return None
            found: Quaternion = start * q * q * algebra.scalar(ring.inverse(q.norm()))
            return found

        return of_norm
    element = quadratic_forms.zero_norm(ring, c).element
    if element is None:
        finite = [algebra.zero, algebra.one] if name == "idempotents" else [algebra.zero]
        return lambda: rng.choice(finite)
    zero = algebra(*element)

    def multiple() -> Quaternion:
        found: Quaternion = anything() * zero * anything()
        return found

    if name == "nilpotents":

        def nilpotent() -> Quaternion:
            u, v = anything() * zero, anything() * zero
            return algebra.scalar(u.trace()) * v - algebra.scalar(v.trace()) * u

        return nilpotent
    if name == "idempotents":

        def idempotent() -> Quaternion:
            u = multiple()
            if ring.is_zero(u.trace()):  # always, if the algebra modulo its radical is a field
                return rng.choice([algebra.zero, algebra.one])
            return u * algebra.scalar(ring.inverse(u.trace()))

        return idempotent
    return multiple


def _of_trace(
    algebra: Parent, s: Scalar, anything: Callable[[], Quaternion]
) -> Callable[[], Quaternion | None]:
    """Return a function that draws elements of trace s."""
    ring, t = algebra.ring, algebra.constants.t
    two = ring(2)
    o = ring.zero
    if not ring.is_zero(two):
        one = algebra(ring.divide(ring.one, two), o, o, o)
    elif not ring.is_zero(t):
        one = algebra(o, ring.divide(ring.one, t), o, o)
    else:  # all traces are 0
        return lambda: anything() if ring.is_zero(s) else None

    def of_trace() -> Quaternion:
        q = anything()
        return q + one * algebra.scalar(s - q.trace())

    return of_trace


def _of_norm(algebra: Parent, n: Scalar) -> Coordinates:
    """Return an element of norm n. Raises :class:`UndecidedError` if none is found."""
    ring, c = algebra.ring, algebra.constants
    root = ring.sqrt(n)
    if root is not None:
        return root, ring.zero, ring.zero, ring.zero
    if structure.is_central_simple(ring, c):
        for s in range(TRACES):
            found = element_of(ring, c, ring(s), n)
            if found is not None:
                return found
    raise UndecidedError(f"no element of norm {ring.text(n)} was found in {algebra}")
