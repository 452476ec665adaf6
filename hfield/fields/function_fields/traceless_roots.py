"""Square roots of trace 0 in a division algebra (a, b) over ℚ(x): zeros of ``a·X² + b·Y² − ab·Z² = s·W²``.

If there is no zero at some rational point of the line, there is none. Over the completion ℚ((x − c)) at such
a point, a form splits into two forms over ℚ, given by the coefficients of even and of odd order, and it has a
zero exactly if one of these has (Springer). At a place where the algebra ramifies, the extension by √s must
remove its residue. For a constant algebra and an s of degree at most 2 the answer is complete: ``s = m·(x +
h)² + n`` has a root exactly if the algebra is (m, n), because the conic ``y² = s(x)`` splits no other
division algebra (Amitsur). In all other cases values of X are tried, and a conic remains to be solved.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TYPE_CHECKING

from hfield.core.product import Constants
from hfield.errors import UndecidedError, shorten
from hfield.fields.function_fields.conics import RamifiedError, solve_conic_functions
from hfield.fields.function_fields.places import FunctionPlace, prime_divisors
from hfield.fields.function_fields.residues import residues_at
from hfield.fields.function_fields.ring import FunctionField
from hfield.fields.function_fields.symbols import (
    ramified_places_functions,
    tame_residue,
)
from hfield.fields.quadratic_forms.isomorphisms.isomorphic import isomorphism
from hfield.fields.quadratic_forms.normal_forms import NormalForm
from hfield.fields.rationals.embedding import traceless_root_rational
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.symbols import is_isotropic

if TYPE_CHECKING:
    import flint

    from hfield.fields.function_fields.quotients import RationalFunction


TRIALS = 150
PATTERNS = 12


def traceless_root_functions(
    field: FunctionField, form: NormalForm, s: RationalFunction
) -> tuple[RationalFunction, RationalFunction, RationalFunction] | None:
    """Return (X, Y, Z) with ``(X·i + Y·j + Z·k)² = s``, or None.

    The algebra is a division algebra, and s is not a square. Raises :class:`UndecidedError`.
    """
    a, b = form.constants
    square, free = _squarefree(field, s)
    if _obstruction(field, form, free) is not None:
        return None
    found = _quadratic(field, a, b, free) if _is_constant(a) and _is_constant(b) else None
    if found == ():
        return None
    found = found or _searched(field, a, b, free)
    if found is None:
        raise UndecidedError(
            f"whether {shorten(field.text(s))} has a square root of trace 0 over {field.name} is undecided; "
            "tried: rational points of the line that may rule one out; roots with one small coordinate"
        )
    x, y, z = (square * u for u in found)
    return x, y, z


def _is_constant(x: RationalFunction) -> bool:
    return bool(x.num.degree() <= 0 and x.den.degree() <= 0)


def _squarefree(
    field: FunctionField, s: RationalFunction
) -> tuple[RationalFunction, RationalFunction]:
    """Return (r, f) with ``s = r²·f`` and f a squarefree polynomial."""
    one = field.one.num
    poly = s.num * s.den
    lead = poly.leading_coefficient()
    free, root = field.constant(lead), field.one
    for p, e in poly.factor()[1]:
        monic = field.quotient(p, one) * field.constant(1 / p.leading_coefficient())
        root = root * field.power(monic, e // 2)
        if e % 2:
            free = free * monic
    return field.divide(root, field.quotient(s.den, one)), free


# --- obstructions ---------------------------------------------------------------------------------


def _obstruction(
    field: FunctionField, form: NormalForm, f: RationalFunction
) -> FunctionPlace | None:
    """Return a place such that no element of trace 0 over the completion there has the square f, if one is
    found; else None.
    """
    a, b = form.constants
    coefficients = [a, b, field.zero - a * b, field.zero - f]
    polynomials = (poly for x in (a, b, f) for poly in (x.num, x.den))
    special = (v for v in prime_divisors(field, polynomials) if v.degree == 1)
    for place in dict.fromkeys((FunctionPlace(field), *special, *_points(field, PATTERNS))):
        if not _isotropic_at(coefficients, place):
            return place
    for place in ramified_places_functions(field, form):
        if place.poly is None or place.poly.degree() == 1 or f.num % place.poly == 0:
            continue
        kappa, residue = tame_residue(a, b, place)
        # the residue, which is not a square, must become one in the extension by the root of f
        if not kappa.is_square(kappa.multiply(residue, kappa.reduce(f))):
            return place
    return None


def _points(field: FunctionField, count: int) -> Iterator[FunctionPlace]:
    """Yield the points 0, 1, −1, 2, … of the line, as places."""
    for n in range(count):
        for c in (n, -n)[: 1 + (n > 0)]:
            yield FunctionPlace(field, (field.gen - field(c)).num)


def _isotropic_at(coefficients: list[RationalFunction], point: FunctionPlace) -> bool:
    """Return whether the diagonal form has a zero over the completion at a rational point, ℚ((π))."""
    at = residues_at(point)
    parts: tuple[list[flint.fmpq], list[flint.fmpq]] = [], []
    for x in coefficients:
        order, lead = at.leading(x)
        parts[order % 2].append(lead[0])
    return any(map(is_isotropic, parts))


# --- roots ----------------------------------------------------------------------------------------


def _quadratic(
    field: FunctionField, a: RationalFunction, b: RationalFunction, f: RationalFunction
) -> tuple[RationalFunction, ...] | None:
    """Solve for a constant algebra and an f of degree at most 2: return (X, Y, Z), or () if there is none;
    None in other cases.
    """
    if f.num.degree() > 2:
        return None
    n, linear, m = (QQ(f.num[k]) for k in range(3))
    if m == 0 and linear != 0:
        return ()  # ℚ(x, √f) is purely transcendental over ℚ
    inner = Constants(QQ(a.num[0]), QQ.zero, QQ(b.num[0]))
    if m == 0:
        root = traceless_root_rational(QQ, inner, n)
        return () if root is None else tuple(field(x) for x in root[1:])
    h = linear / (2 * m)
    n = n - m * h * h
    found = isomorphism(QQ, Constants(m, QQ.zero, n), inner)
    if found is None:
        return ()
    _, i, j, _ = found.images
    return tuple(
        field(u) * (field.gen + field(h)) + field(v) for u, v in zip(i[1:], j[1:], strict=True)
    )


def _searched(
    field: FunctionField, a: RationalFunction, b: RationalFunction, f: RationalFunction
) -> tuple[RationalFunction, RationalFunction, RationalFunction] | None:
    """Try small coordinates X of i, j or k, and solve ``f − p·X² = q·(Y² − p·Z²)`` for the others."""
    o = field.zero
    for u in itertools.islice(_candidates(field, f), TRIALS):
        for p, q, third in ((a, b, o), (b, a, o), (o - a * b, b, b)):
            rest = field.divide(f - p * u * u, q)
            if field.is_zero(rest) or not _may_be_norm(field, p, rest):
                continue
            try:
                y, z, w = solve_conic_functions(field, Constants(p, o, rest))
            except (RamifiedError, UndecidedError):
                continue
            if field.is_zero(w):
                continue
            y, z = field.divide(y, w), field.divide(z, w)
            if not field.is_zero(third):
                return third * z, y, u  # u·k + y·j, and k·j = b·i up to its sign
            return (u, y, z) if p is a else (y, u, z)
    return None


def _candidates(field: FunctionField, f: RationalFunction) -> Iterator[RationalFunction]:
    """Yield polynomials of at most half the degree of f with small coefficients, simple ones first."""
    size = max(1, int(f.num.degree()) // 2) + 1
    for bound in (0, 1, 2, 3):
        for coefficients in itertools.product(range(-bound, bound + 1), repeat=size):
            lead = next((c for c in coefficients if c), 0)
            if max(map(abs, coefficients)) == bound and lead >= 0:
                total = field.zero
                for c in coefficients:
                    total = total * field.gen + field(c)
                yield total


def _may_be_norm(field: FunctionField, p: RationalFunction, rest: RationalFunction) -> bool:
    """Return whether ``rest`` may be a norm from the field of √p, judging by some rational points."""
    form = [field.one, field.zero - p, field.zero - rest]
    return all(_isotropic_at(form, c) for c in (FunctionPlace(field), *_points(field, 3)))
