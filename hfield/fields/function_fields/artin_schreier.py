"""Characteristic 2 over k(t), k finite: square roots, solutions of y² + y = m, and both in algebras [a, b).

Since k is perfect, every s in k(t) is ``w² + b·r²`` for any b that is not a square. So every algebra [a, b)
with such a b contains a square root ``w + r·j`` of s, of trace 0.

An element w + i + y·j + z·k of trace 1 has the norm w² + w + a + s with s = b·N(y + z·i). So s is chosen such
that the conic w² + wx + (a + m)·x² = s·z² has a point, that is, such that [a + m, s) is unramified
everywhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import TYPE_CHECKING

from hfield.core.product import Constants, Coordinates, norm
from hfield.errors import UndecidedError, shorten
from hfield.fields.function_fields.conics import solve_conic_functions
from hfield.fields.function_fields.residues import FunctionResidues, ResidueField
from hfield.fields.function_fields.symbols import ramified_places_functions
from hfield.fields.quadratic_forms.normal_forms import NormalForm, normal_form

if TYPE_CHECKING:
    from hfield.fields.function_fields.quotients import RationalFunction
    from hfield.fields.function_fields.ring import FunctionField

TRIALS = 3_000


def has_solution_at(at: FunctionResidues, m: RationalFunction) -> bool:
    """Return whether y² + y = m has a solution in the completion, by removing poles one after another."""
    while m.num != 0 and (order := at.valuation(m)) <= 0:
        lead = at.reduce(m * at.uniformiser**-order)
        if order == 0:
            return at.artin_schreier(lead) is not None
        root = at.sqrt(lead)
        if order % 2:
            return False
        assert root is not None, "the residue field is perfect"
        y = at.lift(root) * at.inverse_uniformiser ** (-order // 2)
        m = m + y * y + y
    return True


def of_trace_one(field: FunctionField, form: NormalForm, m: RationalFunction) -> Coordinates:
    """Return x in the basis of the division algebra [a, b) with x² + x = m, unless a place excludes it."""
    a, b = form.constants
    algebra, rest = Constants(a, field.one, b), a + m
    y = artin_schreier(field, rest)
    if y is not None:
        return y, field.one, field.zero, field.zero
    for y, z in _pairs(field):
        s = b * norm(algebra, (y, z, field.zero, field.zero))
        conic = Constants(rest, field.one, s)
        if ramified_places_functions(field, normal_form(field, conic)):
            continue
        w, x, r = solve_conic_functions(field, conic)
        if x.num != 0:
            scale = field.inverse(x)
            return scale * w, field.one, scale * r * y, scale * r * z
    raise UndecidedError(
        f"x² + x = {shorten(field.text(m))} has a solution in an algebra over {field}, but none was found"
    )


def _pairs(field: FunctionField) -> Iterator[tuple[RationalFunction, RationalFunction]]:
    """Yield random pairs of polynomials, not both 0, of increasing degree."""
    rng, t = Random(1), field.gen

    def polynomial(size: int) -> RationalFunction:
        total = field.zero
        for _ in range(size):
            total = total * t + field.constant(field.base.random(rng))
        return total

    yield field.one, field.zero
    for n in range(TRIALS):
        pair = polynomial(1 + n // 100), polynomial(1 + n // 100)
        if any(p.num != 0 for p in pair):
            yield pair


def embed_even(
    field: FunctionField, outer: Constants, inner: Constants
) -> tuple[Coordinates, Coordinates]:
    """Return I and J in the division algebra ``inner`` with ``I² = a + I, J² = b, JI = (1 + I)J``.

    J is a square root of b. The element i is corrected first by a multiple of k, so that it satisfies the
    relation with J, and then by u + v·J, which commutes with J, so that its norm is right; the latter
    requires solving a conic.
    """
    w, s = as_norm(field, outer.b, inner.b)
    big_j = w, field.zero, s, field.zero
    start = field.zero, field.one, field.zero, field.divide(w, s * inner.b)
    m, n, r = solve_conic_functions(
        field, Constants(outer.a + norm(inner, start), field.one, outer.b)
    )
    scale = field.inverse(n)
    p, q, x, y = (u + scale * r * v for u, v in zip(start, big_j, strict=True))
    return (p + scale * m, q, x, y), big_j


def square_parts(
    field: FunctionField, x: RationalFunction
) -> tuple[RationalFunction, RationalFunction]:
    """Return ``(u, v)`` with ``x = u² + g·v²``, where g is the variable, over a finite field of
    characteristic 2.
    """
    whole = x.num * x.den
    parts = []
    for start in (0, 1):
        root = field.zero
        for n in range(start, int(whole.degree()) + 1, 2):
            c = field.constant(field.base.sqrt(field.base(whole[n])))
            root = root + c * field.power(field.gen, n // 2)
        parts.append(field.divide(root, field.quotient(x.den, field.one.num)))
    return parts[0], parts[1]


def as_norm(
    field: FunctionField, x: RationalFunction, s: RationalFunction
) -> tuple[RationalFunction, RationalFunction]:
    """Return ``(w, r)`` with ``x = w² + s·r²``, for an s that is not a square."""
    (x0, x1), (s0, s1) = square_parts(field, x), square_parts(field, s)
    r = field.divide(x1, s1)
    return x0 + r * s0, r


def artin_schreier(field: FunctionField, x: RationalFunction) -> RationalFunction | None:
    """Return y with ``y² + y = x``, or None.

    The denominator must be a square d², and y = m/d with ``m² + m·d = n``; the terms of m are determined by
    the leading terms of n, from the highest degree downwards.
    """
    root = field.sqrt(field.quotient(x.den, field.one.num))
    if root is None:
        return None
    d, n, m = root.num, x.num, field.zero.num
    kappa, k = ResidueField(field, field.gen.num), int(d.degree())
    while n != 0:
        size = int(n.degree())
        c = field.constant(field.base(n.leading_coefficient())).num
        power = size // 2
        if size > 2 * k:
            c = None if size % 2 else kappa.sqrt(c)
        elif size == 2 * k:
            c = kappa.artin_schreier(c)
        else:
            c, power = (c, size - k) if size >= k else (None, 0)
        if c is None:
            return None
        term = c * field.gen.num**power
        m, n = m + term, n + term * term + term * d
    return field.quotient(m, d)
