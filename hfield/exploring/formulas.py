"""Numbers of elements, also with a given trace, as polynomials in q."""

from __future__ import annotations

from math import gcd
from typing import Any

import flint

from hfield import syntax
from hfield.core.product import Constants
from hfield.fields.base.modular import Modular
from hfield.fields.base.ring import Ring


def expanded(formula: str) -> str:
    """Return a formula in q multiplied out.

    >>> expanded("q^4-(q^3+q^2-q)"), expanded("(2*q-1)*q^2"), expanded("2")
    ('q^4-q^3-q^2+q', '2*q^3-q^2', '2')
    """
    names = {"q": flint.fmpz_poly([0, 1])}
    reader = syntax.Reader(
        lambda n: flint.fmpz_poly([int(n)]), names, {"**": lambda x, n: x**n}, "polynomials in q"
    )
    coefficients = [int(c) for c in reader.read(formula.replace("^", "**")).coeffs()]
    text = ""
    for degree in reversed(range(len(coefficients))):
        c = coefficients[degree]
        if not c:
            continue
        power = ("", "q")[degree] if degree < 2 else f"q^{degree}"
        factor = "" if abs(c) == 1 and power else str(abs(c)) + "*" * bool(power)
        text += ("-" if c < 0 else "+" * bool(text)) + factor + power
    return text or "0"


def trace_count(ring: Ring, c: Constants, s: Any) -> tuple[int, str | None]:
    """Return the number of elements of trace s over a finite ring, and over a field also the formula in q.

    The trace ``2w + t·x`` is linear. Over a field it takes every value q³ times, or it is 0. Over ℤ/n its
    values are the multiples of ``g = gcd(2, t, n)``, each taken ``g·n³`` times.
    """
    assert ring.order is not None
    q = ring.order
    two = ring(2)
    if ring.is_field:
        if not (ring.is_zero(two) and ring.is_zero(c.t)):
            return q**3, "q^3"
        return (q**4, "q^4") if ring.is_zero(s) else (0, "0")
    if isinstance(ring, Modular):
        g = gcd(2, int(c.t), q)
        return (g * q**3 if int(s) % g == 0 else 0), None
    values = [ring.key(c.t * x) for x in ring.elements()]
    return q**2 * sum(values.count(ring.key(s - two * w)) for w in ring.elements()), None
