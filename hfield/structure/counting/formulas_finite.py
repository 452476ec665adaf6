"""How many elements of an algebra over GF(q) or ℤ/n have norm n, are nilpotent, idempotent, roots, units.

Everything follows from how many elements have a given norm, alone or with trace 0 or 1, because an
element satisfies ``x² = tr(x)·x − N(x)``: it is nilpotent when both are 0, idempotent when it is 0, 1 or has
trace 1 and norm 0, and squares to s when it is a scalar root of s or has trace 0 and norm −s.
The formulas cover every (a, t, b), degenerate ones and characteristic 2 included. Over ℤ/n they are put
together from those over its residue fields and prime powers, by ``formulas_residue_rings``.
"""

from math import prod
from typing import Any, NamedTuple

from hfield.errors import CoercionError, NotFiniteError
from hfield.product import Constants, Scalar
from hfield.rings.base import Ring
from hfield.rings.finite import PrimeField
from hfield.rings.modular import Modular
from hfield.structure.counting.formulas_residue_rings import count_residues
from hfield.structure.forms import discriminant, normal_form

KINDS = ("elements", "norm", "nilpotent", "idempotent", "square roots", "units")


class Count(NamedTuple):
    """A number and the formula in q that gave it."""

    value: int
    formula: str


class _Shape(NamedTuple):
    """What the norm form looks like: ``split``, ``binary+``, ``binary-``, ``line`` or ``additive``."""

    kind: str
    slot: Any = None  # for a binary form in odd characteristic, the a of w² − a·x²


def count(ring: Ring, c: Constants, kind: str, value: Any = None) -> Count:
    """Return how many elements there are of one of the :data:`KINDS`, by closed formula.

    ``value`` is the norm (default 0) or the scalar whose square roots are counted (default 1). Raises
    :class:`NotFiniteError` unless the ring is a finite field or ℤ/n, :class:`CoercionError` for a kind that
    does not exist, and :class:`UndecidedError` for an n that cannot be factored.
    """
    if not has_formulas(ring):
        raise NotFiniteError(
            f"{ring.name} is not a finite field, nor ZZ/n: counting formulas are for these"
        )
    if kind not in KINDS:
        raise CoercionError(f"there is no count of {kind!r}: expected one of {', '.join(KINDS)}")
    assert ring.order is not None
    q = int(ring.order)
    if kind == "elements":
        return Count(q**4, "q^4" if ring.is_field else "n^4")
    if not ring.is_field:
        value = ring((kind == "square roots") if value is None else value)
        parts = count_residues(ring, c, kind, value, lambda p, kind: _over_prime(c, p, kind))
        return Count(prod(parts), "*".join(map(str, parts)))
    shape = _shape(ring, c)
    if kind == "norm":
        return _norm(ring, shape, q, ring(0 if value is None else value))
    if kind == "units":
        zero = _norm(ring, shape, q, ring.zero)
        return Count(q**4 - zero.value, f"q^4-({zero.formula})")
    if kind == "nilpotent":
        return _traceless(ring, shape, q, ring.zero)
    if kind == "idempotent":
        return _idempotents(shape, q)
    return _square_roots(ring, shape, q, ring(1 if value is None else value))


def has_formulas(ring: Ring) -> bool:
    """Tell whether there are closed formulas: over a finite field and over ℤ/n."""
    return ring.order is not None and (ring.is_field or isinstance(ring, Modular))


def _over_prime(c: Constants, p: int, kind: str) -> int:
    """Count modulo a prime divisor p of n."""
    field = PrimeField(p)
    return count(field, Constants(*(field(int(x)) for x in c)), kind).value


def _shape(ring: Ring, c: Constants) -> _Shape:
    if not ring.is_zero(discriminant(c)):
        return _Shape("split")
    if ring.characteristic == 2:
        if ring.is_zero(c.t):
            return _Shape("additive")
        root = _artin_schreier(ring, normal_form(ring, c).a)
        return _Shape("binary+" if root else "binary-")
    slot = next((x for x in normal_form(ring, c).constants if not ring.is_zero(x)), None)
    if slot is None:
        return _Shape("line")
    return _Shape("binary-" if ring.sqrt(slot) is None else "binary+", slot)


def _artin_schreier(ring: Ring, a: Scalar) -> bool:
    """Tell whether y² + y = a is solvable in GF(2ⁿ): whether the trace of a is 0."""
    assert ring.order is not None
    total = x = a
    for _ in range(ring.order.bit_length() - 2):
        x = x * x
        total = total + x
    return ring.is_zero(total)


def _norm(ring: Ring, shape: _Shape, q: int, n: Scalar) -> Count:
    """Count the elements of norm n."""
    zero = ring.is_zero(n)
    if shape.kind == "split":
        return Count(q**3 + q**2 - q, "q^3+q^2-q") if zero else Count(q**3 - q, "q^3-q")
    if shape.kind == "additive":
        return Count(q**3, "q^3")
    if shape.kind == "line":
        if zero:
            return Count(q**3, "q^3")
        return Count(0, "0") if ring.sqrt(n) is None else Count(2 * q**3, "2*q^3")
    if shape.kind == "binary+":
        return (
            Count((2 * q - 1) * q**2, "(2*q-1)*q^2") if zero else Count((q - 1) * q**2, "(q-1)*q^2")
        )
    return Count(q**2, "q^2") if zero else Count((q + 1) * q**2, "(q+1)*q^2")


def _traceless(ring: Ring, shape: _Shape, q: int, s: Scalar) -> Count:
    """Count the elements of trace 0 and norm −s."""
    zero, even = ring.is_zero(s), ring.characteristic == 2
    if shape.kind == "additive" or (shape.kind == "line" and zero):
        return Count(q**3, "q^3")
    if shape.kind == "line":
        return Count(0, "0")
    if zero or even:
        return Count(q**2, "q^2")
    if shape.kind == "split":
        # a ternary form of discriminant a square: −s is a norm of trace 0 in q² + q or q² − q ways
        return Count(q**2 + q, "q^2+q") if ring.sqrt(s) is not None else Count(q**2 - q, "q^2-q")
    return Count(0, "0") if ring.sqrt(s * shape.slot) is None else Count(2 * q**2, "2*q^2")


def _idempotents(shape: _Shape, q: int) -> Count:
    if shape.kind == "split":
        return Count(q**2 + q + 2, "q^2+q+2")
    return Count(2 * q**2 + 2, "2*q^2+2") if shape.kind == "binary+" else Count(2, "2")


def _square_roots(ring: Ring, shape: _Shape, q: int, s: Scalar) -> Count:
    traceless = _traceless(ring, shape, q, s)
    if ring.characteristic == 2 or ring.is_zero(s) or ring.sqrt(s) is None:
        return traceless
    return Count(traceless.value + 2, "2" if not traceless.value else f"{traceless.formula}+2")
