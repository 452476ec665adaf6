"""Elements with variables: convert to and from sympy, and substitute values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, TypeAlias, TypeGuard

from hfield.algebra.embedding import embedding
from hfield.core.product import Constants, Scalar
from hfield.errors import CoercionError, HFieldError, shorten
from hfield.fields.algebraic.ring import CC, RR
from hfield.fields.base.coefficients import Coefficients
from hfield.fields.base.from_sympy import is_of_sympy
from hfield.fields.base.to_sympy import polynomial_in, scalar_to_sympy, symbol

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.ring import Ring

Substitution: TypeAlias = "Mapping[str, object] | Mapping[sympy.Symbol, object]"
"""Values for variables, by their names or symbols."""

OfQuaternion: TypeAlias = "sympy.Quaternion | sympy.MutableDenseMatrix"
OfSympy: TypeAlias = "sympy.Basic | sympy.MutableDenseMatrix | tuple[OfSympy, ...] | list[OfSympy]"
"""An object of sympy, or a tuple or list of some."""


def to_sympy(x: object, symbols: Iterable[sympy.Symbol] = ()) -> OfSympy:
    """Return x as a sympy object: a scalar as an expression, an element as a ``sympy.Quaternion``.

    Elements of algebras other than (−1, −1 | F) become 4 × 1 matrices of their coordinates. A matrix over an
    algebra becomes a sympy matrix, or a 3-dimensional array of coordinates; a polynomial over an algebra
    becomes an element with polynomials as coordinates; rows of scalars become a matrix; other tuples and
    lists become tuples and lists of expressions. Residues are represented by 0 … n − 1. ``symbols`` are used
    for the variables with their names, with their assumptions. Reading the result back gives an equal
    element. Raises :class:`CoercionError` for values that sympy cannot express, such as p-adic numbers.

    >>> from hfield import H
    >>> A = H("QQ(a,b)")
    >>> to_sympy(A("a + 2*b*i").inverse())
    a/(a**2 + 4*b**2) + (-2*b/(a**2 + 4*b**2))*i + 0*j + 0*k
    >>> A(to_sympy(A("a + i")))
    a + i
    """
    given: dict[str, sympy.Symbol] = {s.name: s for s in symbols}
    return _out(x, given)


def _out(x: object, symbols: Mapping[str, sympy.Symbol]) -> OfSympy:
    import sympy

    if hasattr(x, "_in_sympy"):
        return x._in_sympy(symbols)
    if isinstance(x, Coefficients):
        return polynomial_in(symbol("X", symbols), (x.ring.to_sympy(c, symbols) for c in x))
    if hasattr(x, "tolist") and hasattr(x, "ndim"):
        return _out(x.tolist(), symbols)
    if isinstance(x, (tuple, list)):
        parts = [_out(y, symbols) for y in x]
        rows = [y for y in parts if isinstance(y, (tuple, list))]
        if rows and len(rows) == len(parts) and len({len(row) for row in rows}) == 1:
            return sympy.Matrix(rows) if isinstance(rows[0][0], sympy.Expr) else sympy.Array(rows)
        return type(x)(parts)
    return scalar_to_sympy(x, symbols)


def element_to_sympy(
    ring: Ring,
    constants: Constants,
    coordinates: Iterable[Scalar],
    symbols: Mapping[str, sympy.Symbol],
) -> OfQuaternion:
    """Return the element with these coordinates, as a sympy quaternion or a 4 × 1 matrix."""
    return of_coordinates(ring, constants, [ring.to_sympy(x, symbols) for x in coordinates])


def of_coordinates(ring: Ring, constants: Constants, coordinates: list[sympy.Expr]) -> OfQuaternion:
    """Return the sympy quaternion, or 4 × 1 matrix, with these coordinates."""
    import sympy

    if is_hamilton(ring, constants):
        return sympy.Quaternion(*coordinates, real_field=ring.level.value != 1)
    return sympy.Matrix(4, 1, coordinates)


def is_hamilton(ring: Ring, constants: Constants) -> bool:
    """Return whether the structure constants are −1 and −1, as for sympy's quaternions."""
    minus_one = ring(-1)
    return (
        ring.equal(constants.a, minus_one)
        and ring.equal(constants.b, minus_one)
        and ring.is_zero(constants.t)
    )


def coordinates_in(x: object) -> tuple[object, ...] | None:
    """Return the four coordinates of a sympy quaternion, 4 × 1 matrix or 4-tuple, or None."""
    if not is_of_sympy(x):
        return None
    if is_quaternion(x):
        return x.a, x.b, x.c, x.d
    found: sympy.Basic = x
    if hasattr(found, "tolist") and found.shape in ((4, 1), (1, 4), (4,)):
        return tuple(found)
    if type(found).__name__ == "Tuple" and len(found) == 4:
        return tuple(found)
    return None


def is_quaternion(x: object) -> TypeGuard[sympy.Quaternion]:
    """Return whether x is a quaternion of sympy."""
    return is_of_sympy(x) and type(x).__name__ == "Quaternion"


def as_list(x: object) -> object:
    """Return a sympy array or matrix as nested lists, and anything else unchanged."""
    return x.tolist() if is_of_sympy(x) and hasattr(x, "tolist") else x


def variable_name(x: object) -> str:
    """Return the name of a variable: a text or a symbol of sympy. Raises :class:`CoercionError`."""
    name = x if isinstance(x, str) else getattr(x, "name", None)
    if not isinstance(name, str):
        raise CoercionError(
            f"{shorten(repr(x))} is not a variable: expected a symbol of sympy, or a name such as 't'"
        )
    return name


def values_given(values: Substitution | None, named: Mapping[str, object]) -> dict[str, object]:
    """Return the values of variables by name. Raises :class:`CoercionError` for unclear ones."""
    if values is not None and not isinstance(values, Mapping):
        raise CoercionError(
            f"expected values of variables, as in subs({{x: 1}}) or subs(x=1), not {shorten(repr(values))}"
        )
    given = [(variable_name(x), y) for x, y in (values or {}).items()]
    given += named.items()
    found = dict(given)
    if len(found) < len(given):
        twice = next(name for n, (name, _) in enumerate(given) if name in dict(given[:n]))
        raise CoercionError(f"the variable {twice} is given two values")
    return found


def substitution(
    ring: Ring, values: Mapping[str, object]
) -> tuple[Ring, Callable[[Scalar], Scalar]]:
    """Return the ring that contains the values of variables, and the homomorphism into it.

    If every variable has a value, it is the ring of constants, or RR or CC for algebraic numbers, provided
    that it contains the values; otherwise it is the ring itself. Raises :class:`CoercionError` for anything
    but a variable, and for values in none of these rings.
    """
    for name in values:
        if name not in ring.variable_names:
            shown = ", ".join(ring.variable_names) or "none"
            raise CoercionError(f"{name} is not a variable of {ring}; its variables: {shown}")
    candidates: list[Ring] = [ring]
    constants = ring.values_ring
    if set(values) >= set(ring.variable_names) and constants is not None:
        candidates.insert(0, constants)
        if ring.characteristic == 0:
            candidates += [RR, CC]
    failures = []
    for target in candidates:
        try:
            images = ring.images_of(values, target)
            return target, ring.evaluation(target, images, embedding)
        except ZeroDivisionError:
            raise
        except HFieldError as error:
            failures.append(error)
    raise failures[candidates.index(ring)]
