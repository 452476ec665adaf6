"""Quadratic extensions of the base field inside a quaternion algebra."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from typing import Any

from hfield.algebra.brauer import BOUND, pure_elements, pure_form
from hfield.algebra.embedding import embedding
from hfield.algebra.quaternion import Parent, Quaternion
from hfield.algebra.structure import is_central_simple
from hfield.algebra.structure.elements.trace_and_norm import element_of, obstruction
from hfield.core.product import Scalar
from hfield.errors import CoercionError, HFieldError, RingError, UndecidedError, shorten
from hfield.fields.base.ring import E, Ring
from hfield.fields.names import ring as read_ring
from hfield.fields.quadratic_forms.global_field import global_field
from hfield.fields.quadratic_forms.norm_forms.residue_forms import no_zero
from hfield.syntax import plain_element
from hfield.verdicts import Verdict

EXPECTED = "a quadratic extension of {}, its polynomial, as in 'x^2+x+3', or d for F(√d)"


@dataclass(frozen=True, eq=False, repr=False)
class Embedding(Verdict[Quaternion]):
    """Whether x² − trace·x + norm has a root in the algebra, ``element``.

    If it has no root, ``place`` is a place with no root locally, if the field has places.
    """

    trace: Scalar | None = None
    norm: Scalar | None = None
    place: Hashable | None = None


def embed(A: Parent, extension: object) -> Embedding:
    """Return an embedding of a quadratic extension into a central simple algebra over the field F.

    The extension is given as a field, as a polynomial (a text, three coefficients, low degree first, or a
    polynomial), or as d for F(√d). It embeds if and only if no ramified place of A splits in it (Voight,
    *Quaternion Algebras*, 14.6.7). Raises :class:`RingError` for anything but a quadratic extension, and
    :class:`UndecidedError`.
    """
    F = A.ring
    if not is_central_simple(F, A.constants):
        raise CoercionError(f"{A} is not central simple")
    if not F.is_exact:
        raise UndecidedError(f"{F.name} is inexact: use an exact field")
    t, n = _trace_and_norm(A, extension)
    place = None if F.order is not None else obstruction(F, A.constants, t, n)
    if place is not None:
        why = f"{_shown(A, t, n)}, not even over the completion at {place}"
        return Embedding(False, why, trace=t, norm=n, place=place)
    try:
        q = element_of(F, A.constants, t, n)
    except UndecidedError:
        found = _by_search(A, t, n)
        if found is None:
            raise
        return found
    if q is None:
        return Embedding(False, _shown(A, t, n), trace=t, norm=n)
    return Embedding(True, witness=A(*q), trace=t, norm=n)


def _shown(A: Parent, t: Scalar, n: Scalar) -> str:
    return f"{A.polynomials('x')([n, -t, 1])} has no root in {A}"


def _by_search(A: Parent[E], t: E, n: E) -> Embedding | None:
    """Search for an embedding by small pure elements, and for an obstruction by residues; None if
    both fail.
    """
    F = A.ring
    if F.characteristic == 2:
        return None
    half = F.divide(t, F(2))
    d = half * half - n
    for x in pure_elements(A, BOUND):
        square = -x.norm()
        root = None if F.is_zero(square) else F.sqrt(F.divide(d, square))
        if root is not None:
            return Embedding(True, witness=x * root + A.scalar(half), trace=t, norm=n)
    reason = no_zero(F, [*pure_form(F, A.constants), -d])
    if reason is None:
        return None
    return Embedding(False, f"{_shown(A, t, n)}: {reason}", trace=t, norm=n)


def _trace_and_norm(A: Parent[E], given: object) -> tuple[E, E]:
    """Return t and n such that x² − t·x + n has no root in F and defines the extension."""
    F = A.ring
    if isinstance(given, str):
        given = _read(A, given)
    if isinstance(given, Ring):
        c = _relative(F, given)
    elif (listed := _coefficients(given)) is not None:
        c = [F(x) for x in listed]
    else:
        c = [-F(given), F.zero, F.one]
    if len(c) != 3 or F.is_zero(c[2]):
        raise RingError(
            f"{shorten(given)} is not a polynomial of degree 2; expected {EXPECTED.format(F.name)}"
        )
    t, n = -F.divide(c[1], c[2]), F.divide(c[0], c[2])
    if _has_root(F, t, n):
        what = f"x^2 - ({F.text(t)})*x + {F.text(n)} has a root"
        if F.is_zero(t):
            what = f"{F.text(-n)} is a square"
        raise RingError(f"{shorten(what)} in {F.name}, and adjoins nothing")
    return t, n


def _read(A: Parent, text: str) -> object:
    """Return the value of a text: an element of F, a field, or a polynomial in another variable."""
    F, typed, text = A.ring, text, plain_element(text)
    words = {*re.findall(r"[^\W\d]\w*", text)} - {*F.names(), *F.functions()}
    if not words:
        return F(text)
    try:
        return read_ring(typed)
    except HFieldError as error:
        if len(words) != 1:
            raise RingError(
                f"{shorten(text)!r} is not a quadratic extension: expected {EXPECTED.format(F.name)}"
            ) from error
    (x,) = words
    return A.polynomials(x).parse(text)


def _coefficients(given: object) -> list[object] | None:
    """Return the coefficients, low degree first, of a polynomial of hfield or flint, or of a list."""
    if isinstance(given, list | tuple):
        return list(given)
    if hasattr(given, "coeffs"):
        return list(given.coeffs())
    found = getattr(given, "coefficients", None)
    if not isinstance(found, Iterable):
        return None
    listed = list(found)
    if any(not isinstance(q, Quaternion) or q.vector_part for q in listed):
        raise RingError(f"{shorten(given)} has coefficients outside the base field")
    return [q.coordinates[0] for q in listed]


def _has_root(F: Ring[E], t: E, n: E) -> bool:
    if F.characteristic != 2:
        return bool(F.is_square(t * t - n * F(4)))
    if F.is_zero(t):
        return F.sqrt(n) is not None
    field = global_field(F)
    if F.order is None and field is not None:
        return field.artin_schreier(F.divide(n, t * t)) is not None
    return bool(F.roots([n, -t, F.one]))


def _relative(F: Ring[E], L: Ring) -> list[E]:
    """Return the quadratic polynomial over F of the generator of an extension L."""
    refusal = RingError(f"{shorten(L.name)} is not a quadratic extension of {F.name}")
    if F.characteristic != L.characteristic:
        raise refusal
    if F.closure == "real closed" and L.closure == "algebraically closed":
        return [F.one, F.zero, F.one]
    base, modulus = getattr(L, "base", None), getattr(L, "modulus_coefficients", None)
    if base == F and modulus is not None:
        return list(modulus)
    if base is not None and base != F and getattr(F, "base", None) is not None:
        embedding(F, L)
        functions: Any = F  # a field of functions, as L
        return [functions.constant(x) for x in _relative(functions.base, base)]
    try:
        into = embedding(F, L)
        absolute = _absolute(L)
    except CoercionError as error:
        raise refusal from error
    for f in F.irreducible_factors([F(x) for x in absolute] if absolute else []):
        value = L.zero
        for c in reversed(f):
            value = value * L.gen + into(c)
        if len(f) == 3 and L.is_zero(value):
            return list(f)
    raise refusal


def _absolute(L: Ring) -> list[object]:
    """Return the coefficients over the prime field of the generator's polynomial, () if it is not known."""
    if hasattr(L, "polynomial"):
        return list(L.polynomial.coeffs())
    if (
        getattr(L, "degree", None) == 2
        and not L.characteristic
        and hasattr(L, "norm")
        and hasattr(L, "trace")
    ):
        return [L.norm(L.gen), -L.trace(L.gen), 1]
    return list(getattr(L, "coefficients", ()))
