"""Elements of quaternion algebras: one quaternion or an array of them, with the same methods."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from typing import (
    TYPE_CHECKING,
    Any,
    Generic,
    NamedTuple,
    NoReturn,
    Protocol,
    TypeAlias,
    TypeGuard,
    TypeVar,
    overload,
)

from hfield.algebra import structure
from hfield.algebra.embedding import embedding
from hfield.algebra.structure.elements import analysis
from hfield.core import product
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import (
    CoercionError,
    MixedParentsError,
    NotFiniteError,
    NotInvertibleError,
    shorten,
)
from hfield.fields.base.coefficients import Coefficients
from hfield.fields.base.coercion import rational
from hfield.fields.base.ring import E, Ring
from hfield.fields.base.storage.base import BatchStorage, Storage
from hfield.hints import ELEMENT, Hinted
from hfield.notation import element_text
from hfield.symbols import OfSympy, Substitution, element_to_sympy, values_given, variable_name
from hfield.sympy_printing import PrintedBySympy
from hfield.syntax.other_systems import OtherSystemWriter
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    import numpy as np
    import sympy

    from hfield.algebra.maps import Isomorphism
    from hfield.algebra.structure.elements.square_roots import RootCoordinates as Found
    from hfield.fields.base.arrays import Index
    from hfield.orders.lattice import Order
    from hfield.polynomials.polynomial import Polynomials
    from hfield.polynomials.roots import Roots

L = TypeVar("L", bound=Scalar)  # an element of another ring
Number: TypeAlias = int | float | Fraction | str
"""What every ring reads as one scalar, besides its own elements."""

_blank: Callable[[type[Quaternion]], Quaternion] = object.__new__
# The methods that numpy's functions call, and the methods for operators whose left operand is a
# numpy array.
_UFUNCS = {
    "absolute": "__abs__", "exp": "exp", "log": "log", "sqrt": "sqrt", "conjugate": "conjugate",
    "negative": "__neg__", "positive": "__pos__",
}  # fmt: skip
_REFLECTED = {
    "add": "__radd__", "subtract": "__rsub__", "multiply": "__rmul__", "divide": "__rtruediv__",
    "equal": "__eq__", "not_equal": "__ne__",
}  # fmt: skip


class Parent(Protocol[E]):
    """The interface of :class:`hfield.algebra.QuaternionAlgebra` that its elements use."""

    ring: Ring[E]
    constants: Constants[E]

    @property
    def storage(self) -> Storage: ...  # noqa: D102
    @property
    def array_storage(self) -> BatchStorage: ...  # noqa: D102
    @property
    def basis(self) -> Coordinates[Quaternion[E]]: ...  # noqa: D102
    @overload
    def __call__(self, x: E | Number | Quaternion[E], /) -> Quaternion[E]: ...
    @overload
    def __call__(
        self, w: E | Number, x: E | Number, y: E | Number, z: E | Number, /
    ) -> Quaternion[E]: ...
    @overload
    def __call__(self, *coordinates: object) -> Quaternion: ...
    def __hash__(self) -> int: ...
    @property
    def one(self) -> Quaternion[E]: ...  # noqa: D102
    @property
    def zero(self) -> Quaternion[E]: ...  # noqa: D102
    @overload
    def scalar(self, x: E | Number | Quaternion[E]) -> Quaternion[E]: ...
    @overload
    def scalar(self, x: object) -> Quaternion: ...
    def elements(self) -> Iterator[Quaternion[E]]: ...  # noqa: D102
    def random_element(self, seed: int | None = ...) -> Quaternion[E]: ...  # noqa: D102
    def from_array(self, values: object, axis: int = ...) -> Quaternion: ...  # noqa: D102
    @overload
    def change_ring(self, ring: Ring[L]) -> Parent[L]: ...
    @overload
    def change_ring(self, ring: str) -> Parent: ...
    def _common(self, other: Parent) -> Parent | None: ...
    def _include(self, q: Quaternion) -> Quaternion: ...
    def _substituted(
        self, values: Mapping[str, object]
    ) -> tuple[Parent, Callable[[E], Scalar]]: ...
    def count(self, kind: str = ..., *, norm: object = ..., square: object = ...) -> int: ...  # noqa: D102
    def latex(self) -> str: ...  # noqa: D102
    def is_central_simple(self) -> bool: ...  # noqa: D102
    def isomorphism(self, other: Parent) -> Isomorphism | None: ...  # noqa: D102
    def order_from_basis(self, elements: Iterable[object]) -> Order: ...  # noqa: D102
    def polynomials(self, name: str = ...) -> Polynomials: ...  # noqa: D102
    def to_matrix(self, q: Quaternion) -> tuple[tuple[E, E], tuple[E, E]]: ...  # noqa: D102


class Quaternion(Hinted, PrintedBySympy, Generic[E]):
    """An immutable element of a quaternion algebra: ``w·e + x·i + y·j + z·k``.

    Call the algebra to make its elements. The four coordinates are elements of the base ring, or four arrays
    of one shape; operations on arrays are elementwise. Ints, Fractions and elements of the base ring are
    converted to multiples of e. Elements of two different algebras never mix: arithmetic raises
    :class:`MixedParentsError`, and ``==`` is False.

    >>> from hfield import H
    >>> q = H("QQ")(1, 2, 0, 1)
    >>> q * q.conjugate() == q.norm(), q.inverse()
    (True, 1/6 - 1/3*i - 1/6*k)
    """

    # Only the storage _how reads _stored; coordinates are computed when they are read. The class
    # has no __setattr__ or __delattr__ of its own, because they would make every new element
    # slower.
    __slots__ = ("_algebra", "_how", "_stored")
    foreign_names = ELEMENT
    _op_priority = 20.0  # for x * q with a sympy x, for which q is not a quaternion

    _algebra: Parent[E]
    _how: Storage[object, E]
    _stored: object

    def __init__(self, algebra: Parent[E], coordinates: Coordinates[E]) -> None:
        self._algebra = algebra
        self._how = algebra.storage
        if is_array(coordinates[0]):
            how: Storage = algebra.array_storage  # whose norms are arrays
            self._how = how
            arrays: Coordinates = coordinates
            w, x, y, z = (c.copy() for c in arrays)
            coordinates = w, x, y, z
        self._stored = self._how.encode(coordinates)

    @property
    def algebra(self) -> Parent[E]:
        """The algebra of this element."""
        return self._algebra

    @algebra.setter
    def algebra(self, value: object) -> NoReturn:
        _refuse_change()

    @algebra.deleter
    def algebra(self) -> NoReturn:
        _refuse_change()

    @property
    def coordinates(self) -> Coordinates[E]:
        """The four coordinates over ``(e, i, j, k)``: elements of the base ring, or read-only arrays."""
        how = self._how
        return (
            how.read_only_coordinates(self._stored)
            if isinstance(how, BatchStorage)
            else how.coordinates(self._stored)
        )

    @coordinates.setter
    def coordinates(self, value: object) -> NoReturn:
        _refuse_change()

    @coordinates.deleter
    def coordinates(self) -> NoReturn:
        _refuse_change()

    # --- shape ---------------------------------------------------------------------------------

    @property
    def ring(self) -> Ring[E]:
        """The base ring."""
        return self._algebra.ring

    @property
    def is_batch(self) -> bool:
        """Whether this is an array of quaternions."""
        return self._how.is_batch

    def _new(self, w: E, x: E, y: E, z: E) -> Quaternion[E]:
        return Quaternion(self._algebra, (w, x, y, z))

    def _computed(self, coordinates: Coordinates) -> Quaternion[E]:
        """Return an element with newly computed coordinates, without copying them."""
        how = self._how
        return from_stored(self._algebra, how, how.encode(coordinates))

    def _alike(self, stored: object) -> Quaternion[E]:
        """Return an element in the same storage with another stored value."""
        return from_stored(self._algebra, self._how, stored)

    def _operand(self, other: object, operation: str) -> Quaternion[E]:
        """Convert the other operand to this algebra."""
        if isinstance(other, str):
            raise CoercionError(
                f"cannot {operation} a quaternion and a text; read it first: A({other!r})"
            )
        q = other if isinstance(other, Quaternion) else self.algebra.scalar(other)
        if (
            q.algebra is not self.algebra
            and q.algebra != self.algebra
            and self.algebra._common(q.algebra) is None
        ):
            raise MixedParentsError(
                f"cannot {operation} an element of {self.algebra} and one of {q.algebra}: different "
                f"algebras never mix; if one ring contains the other, use q.change_ring(L) first"
            )
        return q

    def _join(
        self, other: object, operation: str
    ) -> tuple[Parent[E], Storage[object, E], object, object]:
        """Convert both operands to one algebra and one storage, single or array."""
        p, q = self, self._operand(other, operation)
        if p._algebra is not q._algebra and p._algebra != q._algebra:
            common = p._algebra._common(q._algebra)
            assert common is not None, "_operand has seen that there is one"
            p, q = common._include(p), common._include(q)
        A = p._algebra
        if p._how.is_batch == q._how.is_batch:
            return A, p._how, p._stored, q._stored
        batch = A.array_storage
        how: Storage = batch  # whose norms are arrays
        left, right = (x._stored if x.is_batch else batch.lift(x.coordinates) for x in (p, q))
        return A, how, left, right

    # --- arithmetic ----------------------------------------------------------------------------
    # Two elements of one storage, the usual case, skip every check and every call.

    @overload
    def __add__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __add__(self, other: object) -> Quaternion: ...
    def __add__(self, other: object) -> Quaternion:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            result: Quaternion[E] = _blank(Quaternion)
            result._algebra = self._algebra
            result._how = how
            add = how.sum
            result._stored = add(self._stored, other._stored)
            return result
        if hasattr(other, "added_to_elements"):  # a polynomial: it adds
            return NotImplemented
        A, how, p, q = self._join(other, "add")
        return from_stored(A, how, how.sum(p, q))

    __radd__ = __add__

    @overload
    def __sub__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __sub__(self, other: object) -> Quaternion: ...
    def __sub__(self, other: object) -> Quaternion:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            return from_stored(self._algebra, how, how.difference(self._stored, other._stored))
        if hasattr(other, "added_to_elements"):
            return NotImplemented
        A, how, p, q = self._join(other, "subtract")
        return from_stored(A, how, how.difference(p, q))

    @overload
    def __rsub__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __rsub__(self, other: object) -> Quaternion: ...
    def __rsub__(self, other: object) -> Quaternion:
        A, how, p, q = self._join(other, "subtract")
        return from_stored(A, how, how.difference(q, p))

    def __neg__(self) -> Quaternion[E]:
        how = self._how
        return from_stored(self._algebra, how, how.negative(self._stored))

    def __pos__(self) -> Quaternion[E]:
        return self

    @overload
    def __mul__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __mul__(self, other: object) -> Quaternion: ...
    def __mul__(self, other: object) -> Quaternion:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            result: Quaternion[E] = _blank(Quaternion)
            result._algebra = self._algebra
            result._how = how
            multiply = how.product
            result._stored = multiply(self._stored, other._stored)
            return result
        if hasattr(other, "multiplied_by_elements"):  # a lattice or a matrix: it multiplies itself
            return NotImplemented
        if how.is_unique and not isinstance(other, (Quaternion, str)) and not is_many(other):
            return from_stored(
                self._algebra, how, how.scaled(self._stored, self._algebra.ring(other))
            )
        A, how, p, q = self._join(other, "multiply")
        return from_stored(A, how, how.product(p, q))

    @overload
    def __rmul__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __rmul__(self, other: object) -> Quaternion: ...
    def __rmul__(self, other: object) -> Quaternion:
        how = self._how
        if how.is_unique and not isinstance(other, (Quaternion, str)) and not is_many(other):
            return from_stored(
                self._algebra, how, how.scaled(self._stored, self._algebra.ring(other))
            )
        A, how, p, q = self._join(other, "multiply")
        return from_stored(A, how, how.product(q, p))

    @overload
    def __truediv__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __truediv__(self, other: object) -> Quaternion: ...
    def __truediv__(self, other: object) -> Quaternion:
        """Return ``self · other⁻¹``."""
        how = self._how
        if how.is_unique and not isinstance(other, (Quaternion, str)) and not is_many(other):
            stored = how.divided(self._stored, self._algebra.ring(other))
            if stored is not None:
                return from_stored(self._algebra, how, stored)
        return self * self._operand(other, "divide").inverse()

    @overload
    def __rtruediv__(self, other: Quaternion[E] | E | Number) -> Quaternion[E]: ...
    @overload
    def __rtruediv__(self, other: object) -> Quaternion: ...
    def __rtruediv__(self, other: object) -> Quaternion:
        return self._operand(other, "divide") * self.inverse()

    def __pow__(self, n: float | Fraction) -> Quaternion[E]:
        if isinstance(n, (float, Fraction)):
            return self._real_power(n)
        if not isinstance(n, int):
            exponent = rational(n)  # flint's, numpy's, or a norm
            if exponent is None:
                raise CoercionError(f"the exponent {n!r} is not a number")
            return self**exponent
        base = self if n >= 0 else self.inverse()
        return self._alike(self._how.power(base._stored, abs(n)))

    def _real_power(self, n: float | Fraction) -> Quaternion[E]:
        """Return the principal power, with any exponent over RDF and a rational one over functions of angles.

        Over other exact rings the exponent is a multiple of 1/2.
        """
        if not self.ring.is_exact:
            found = analysis.power(self.ring, self.algebra.constants, self.coordinates, n)
            return self._computed(found)
        if analysis.has_angles(self.ring):
            return self._computed(analysis.power_with_angles(*self._single(), exponent=Fraction(n)))
        twice = 2 * Fraction(n)
        if twice.denominator != 1:
            raise CoercionError(
                f"the exponent {n!r} is not a multiple of 1/2: over {self.ring} all n-th roots are q.roots(n)"
            )
        base = self if twice.numerator % 2 == 0 else self.sqrt()
        return base ** (twice.numerator // (1 if base is not self else 2))

    def __xor__(self, other: object) -> NoReturn:
        raise CoercionError("powers are written q**2; to Python q^2 + 1 would be q^(2 + 1)")

    def __eq__(self, other: object) -> Any:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            if how.is_unique:
                return self._stored == other._stored
            return how.equal(self._stored, other._stored)
        if isinstance(other, str):
            return NotImplemented
        if not isinstance(other, Quaternion):
            try:
                other = self.algebra.scalar(other)
            except (CoercionError, NotInvertibleError):
                return NotImplemented
        if other.algebra != self.algebra and self.algebra._common(other.algebra) is None:
            return False
        _, how, p, q = self._join(other, "compare")
        return how.equal(p, q)

    def __hash__(self) -> int:
        if self.is_batch or not self.ring.is_exact:
            what = "an array of quaternions" if self.is_batch else "a quaternion of floats"
            raise TypeError(f"{what} cannot be hashed; single ones over an exact ring can")
        return hash((self._algebra, self._how.key(self._stored)))

    def __bool__(self) -> bool:
        if self.is_batch:
            raise ValueError(
                "the truth value of an array of quaternions is ambiguous; compare first"
            )
        return not self.is_zero()

    # --- what the algebra knows of it ----------------------------------------------------------

    def __array_ufunc__(
        self, ufunc: np.ufunc, method: str, *inputs: object, **options: object
    ) -> Any:
        """Support numpy's ``abs``, ``exp``, ``log``, ``sqrt``, and ``array * q`` as a product of
        quaternions.

        Otherwise numpy would multiply each entry of the array by q separately.
        """
        if method == "__call__" and not options:
            if len(inputs) == 1 and ufunc.__name__ in _UFUNCS:
                return getattr(self, _UFUNCS[ufunc.__name__])()
            if len(inputs) == 2 and inputs[1] is self and ufunc.__name__ in _REFLECTED:
                return getattr(self, _REFLECTED[ufunc.__name__])(inputs[0])
        return NotImplemented

    def conjugate(self) -> Quaternion[E]:
        """Return the standard involution; ``w − x·i − y·j − z·k`` when t = 0 (Definition 3)."""
        how = self._how
        return from_stored(self._algebra, how, how.conjugate(self._stored))

    conj = conjugate  # as the language calls it

    def norm(self) -> E:
        """Return the reduced norm, an element (or array) of the base ring (Definition 2)."""
        norm = self._how.norm
        return norm(self._stored)

    def trace(self) -> E:
        """Return the reduced trace, an element (or array) of the base ring."""
        return self._how.trace(self._stored)

    def inverse(self) -> Quaternion[E]:
        """Return ``q⁻¹ = conj(q)/N(q)`` (Definition 4).

        Raises :class:`NotInvertibleError`, a ZeroDivisionError, if the norm is not a unit; the message shows
        some y ≠ 0 with q·y = 0 if there is one.
        """
        how = self._how
        stored = how.inverse(self._stored)
        if stored is not None:
            return from_stored(self._algebra, how, stored)
        if not isinstance(how, BatchStorage):
            raise NotInvertibleError(self._why_no_inverse())
        where = _first(~how.units(self._stored))
        q = self._new(*how.single(how.part(self._stored, where)))
        raise NotInvertibleError(f"at index {where} of the array: {q._why_no_inverse()}")

    inv = inverse

    @overload
    def is_zero(self: Quaternion[np.ndarray]) -> Any: ...
    @overload
    def is_zero(self) -> bool: ...
    def is_zero(self) -> Any:
        """Return whether the quaternion is 0; for an array, a bool array with one entry for each
        quaternion.
        """
        return self._how.is_zero(self._stored)

    def _single(self) -> tuple[Ring[E], Constants[E], Coordinates[E]]:
        """Return the arguments that functions of ``structure`` expect."""
        if self.is_batch:
            raise CoercionError(
                "expected a single quaternion, found an array: take one, q[n], or loop"
            )
        return self.ring, self.algebra.constants, self.coordinates

    # --- parts ---------------------------------------------------------------------------------

    @property
    def scalar_part(self) -> E:
        """The coordinate of e, in the base ring (thesis 1.4.2)."""
        return self.coordinates[0]

    @property
    def vector_part(self) -> Quaternion[E]:
        """The element without its scalar part, ``x·i + y·j + z·k`` (thesis 1.4.2)."""
        w, x, y, z = self.coordinates
        return self._new(w - w, x, y, z)

    @property
    def vector(self) -> tuple[E, E, E]:
        """The coordinates of i, j, k: three elements (or arrays) of the base ring."""
        _, x, y, z = self.coordinates
        return x, y, z

    def dot(self, other: object) -> E:
        """Return the scalar product of the vector parts: minus the scalar part of their product.

        In Hamilton's algebra it is ``x₁x₂ + y₁y₂ + z₁z₂`` (thesis 1.4.2).

        >>> from hfield import H
        >>> A = H("QQ")
        >>> p, q = A(0, 1, 2, 3), A(0, 4, 5, 6)
        >>> p.dot(q), p.cross(q), p * q == p.cross(q) - p.dot(q)
        (32, -3*i + 6*j - 3*k, True)
        """
        product: Quaternion[E] = self.vector_part * self._operand(other, "multiply").vector_part
        return -product.scalar_part

    def cross(self, other: object) -> Quaternion[E]:
        """Return the vector product of the vector parts: the vector part of their product (thesis 1.4.2)."""
        return (self.vector_part * self._operand(other, "multiply").vector_part).vector_part

    def matrix(
        self, side: str = "left", over: Ring | str | None = None
    ) -> tuple[tuple[E, ...], ...]:
        """Return the 4 × 4 matrix of ``p ↦ q·p``: column n holds the coordinates of q·(basis n).

        ``side="right"`` returns the matrix of ``p ↦ p·q``. ``over``, a field that contains the base ring and
        splits the algebra, returns the 2 × 2 matrix of q over it (thesis 1.4.3). Raises
        :class:`CoercionError` if the algebra stays a division algebra over that field.

        >>> from hfield import H
        >>> H("QQ")(1, 2, 3, 4).matrix(over="QQ(I)")
        ((1+2*I, -3-4*I), (3-4*I, 1-2*I))
        """
        if over is not None:
            q = self.change_ring(over)
            return q.algebra.to_matrix(q)
        if side not in ("left", "right"):
            raise CoercionError(f"side={side!r}: expected 'left' or 'right'")
        images = (self * b if side == "left" else b * self for b in self.algebra.basis)
        return tuple(zip(*(image.coordinates for image in images), strict=True))

    def rotation_matrix(self) -> tuple[tuple[E, ...], ...]:
        """Return the 3 × 3 matrix of ``v ↦ q·v·q⁻¹`` on i, j, k, for i² = a and j² = b: columns are images.

        The matrix M is exact, with MᵀGM = G for the diagonal matrix G of −a, −b, ab, and det M = 1. Raises
        :class:`NotInvertibleError` unless q is a unit. Raises :class:`CoercionError` if i² = a + t·i with t ≠
        0, because conjugation by q then does not preserve the span of i, j, k.

        >>> from hfield import H
        >>> H("QQ(t)")("1 + t*k").rotation_matrix()[0]
        ((-t^2+1)/(t^2+1), -2*t/(t^2+1), 0)
        """
        if not self.ring.is_zero(self.algebra.constants.t):
            raise CoercionError(
                f"in {self.algebra} i has the trace t ≠ 0, and i, j, k span no space that q·v·q⁻¹ keeps"
            )
        inverse = self.inverse()
        columns = [(self * b * inverse).coordinates[1:] for b in self.algebra.basis[1:]]
        return tuple(zip(*columns, strict=True))

    # --- variables -----------------------------------------------------------------------------

    def subs(self, values: Substitution | None = None, /, **named: object) -> Quaternion:
        """Return q with values substituted for variables, simultaneously, also in the structure constants.

        Variables are sympy symbols or names; values are anything that the ring can read. If every variable
        has a value, the result lies over the ring of constants, or over RR or CC if a value is algebraic;
        otherwise over the same ring. Raises :class:`CoercionError` for other names and values, and
        :class:`NotInvertibleError`, a ZeroDivisionError, at a pole.

        >>> from hfield import H
        >>> q = H("QQ(a,b)")("a + i/b")
        >>> q.subs(a=1, b="1/2"), q.subs(a="b", b="a"), q.subs(a=1, b=2).algebra
        (1 + 2*i, b + (1/a)*i, (-1,-1|QQ))
        """
        algebra, value = self.algebra._substituted(values_given(values, named))
        return self._mapped(algebra, value)

    def diff(self, variable: object) -> Quaternion[E]:
        """Return the derivative of the coordinates by a variable, a symbol of sympy or a name.

        Raises :class:`CoercionError` for anything but a variable of the ring, and if a structure constant
        depends on the variable, because the result would not be a derivation.

        >>> from hfield import H
        >>> H("QQ(t)")("t^2 + i/t").diff("t")
        2*t + (-1/t^2)*i
        """
        name, ring = variable_name(variable), self.ring
        if any(not ring.is_zero(ring.derivative(c, name)) for c in self.algebra.constants):
            raise CoercionError(
                f"the structure constants of {self.algebra} depend on {name}, so the derivatives of "
                "coordinates are not a derivation"
            )
        return self._mapped(self.algebra, lambda x: ring.derivative(x, name))

    @property
    def free_symbols(self) -> set[sympy.Symbol]:
        """The variables that occur in the coordinates, as symbols of sympy.

        >>> from hfield import H
        >>> H("QQ(x,y)")("x + 2*i").free_symbols
        {x}
        """
        import sympy

        ring = self.ring
        coordinates: Coordinates = self.coordinates
        scalars = (x for c in coordinates for x in c.ravel()) if self.is_batch else coordinates
        names = {name for x in scalars for name in ring.variables_in(ring.scalar(x))}
        return set(map(sympy.Symbol, names))

    def _mapped(self, algebra: Parent, change: Callable[[E], Scalar]) -> Quaternion:
        """Return the element of an algebra with the mapped coordinates of this one."""
        if not self.is_batch:
            return algebra(*map(change, self.coordinates))
        scalar = self.ring.scalar
        arrays: Coordinates = self.coordinates
        rows = ([change(scalar(x)) for x in c.ravel()] for c in arrays)
        return algebra(*rows).reshape(self.shape)

    def _in_sympy(self, symbols: Mapping[str, sympy.Symbol]) -> OfSympy:
        """Return q as :func:`hfield.to_sympy` does, with symbols by name; an array as nested tuples."""
        import sympy

        if self.shape:
            return sympy.Tuple(*(q._in_sympy(symbols) for q in self))
        return element_to_sympy(self.ring, self.algebra.constants, self.coordinates, symbols)

    def _sympy_(self) -> OfSympy:
        return self._in_sympy({})

    @overload
    def change_ring(self, ring: Ring[L]) -> Quaternion[L]: ...
    @overload
    def change_ring(self, ring: str) -> Quaternion: ...
    def change_ring(self, ring: Ring | str) -> Quaternion:
        """Return q in the algebra with the same constants over ``ring``, which must contain the base ring's
        constants.
        """
        A = self.algebra.change_ring(ring)
        if not (self.ring.is_exact or A.ring.is_exact):
            return A(*self.coordinates)  # floats are floats, of arrays too
        return self._mapped(A, embedding(self.ring, A.ring))

    # --- modulus, exponential, roots -----------------------------------------------------------

    @overload
    def __abs__(self: Quaternion[np.ndarray]) -> Any: ...
    @overload
    def __abs__(self) -> E: ...
    def __abs__(self) -> object:
        """Return the modulus ``√N(q)``, the nonnegative root (thesis 1.3.1); elementwise on arrays.

        Over functions of angles the result is the root that is positive for all small positive angles.

        Raises :class:`NoSolutionError` where the base ring has no such root, and :class:`RingError` over
        rings without an ordering.
        """
        if self.is_batch and self.ring.is_exact:
            return self.ring.array([abs(q) for q in self.reshape(-1)]).reshape(self.shape)
        return analysis.modulus(self.ring, self.algebra.constants, self.coordinates)

    def unit(self) -> Quaternion[E]:
        """Return ``q/|q|``. Raises :class:`NotInvertibleError` where the norm is 0."""
        return self.__truediv__(abs(self))

    def polar(self) -> Polar[E]:
        """Return the modulus r, the axis n and the angle θ with ``q = r·(cos θ + n·sin θ)``, ``n² = −1``.

        The angle is in radians, in [0, π]; :meth:`QuaternionAlgebra.from_polar` is the inverse. The form is
        computed over RDF (also of arrays), and over RR if the angle is a rational multiple of π (thesis
        1.4.4). Over functions of angles, θ is a rational combination of the angles and π, with a positive
        first coefficient. Raises :class:`NoSolutionError` if the trace-0 part has no negative square or the
        ring has no root of it, and :class:`CoercionError` for other angles.

        >>> from hfield import H
        >>> H("RR")(1, 1, 1, 1).polar()
        Polar(modulus=2, axis=(1/3*sqrt(3))*i + (1/3*sqrt(3))*j + (1/3*sqrt(3))*k, angle=1/3*pi)
        >>> H("QQ(cos(t),sin(t))")("3*cos(2*t) + 3*sin(2*t)*k").polar()
        Polar(modulus=3, axis=k, angle=2*t)
        """
        r, n, theta = analysis.polar(self.ring, self.algebra.constants, self.coordinates)
        return Polar(r, self._computed(n), theta)

    def exp(self) -> Quaternion[E]:
        """Return the sum of ``qⁿ/n!``, over RDF (also of arrays) and exactly over RR.

        Over functions of angles it is defined for products n·t of an axis n with ``ring.angle("t")``. Raises
        :class:`RingError` over other rings.

        >>> from hfield import H
        >>> H("RR").parse("pi/3*k").exp()
        1/2 + (1/2*sqrt(3))*k
        """
        return self._computed(analysis.exp(self.ring, self.algebra.constants, self.coordinates))

    def log(self) -> Any:  # a Quaternion, over functions of angles an AxisAngle
        """Return the principal logarithm, ``log|q| + n·θ`` with θ in [0, π), over the rings of :meth:`exp`.

        Over functions of angles, for q of modulus 1, it is the product n·θ of the axis and angle from
        :meth:`polar`. This product has ``exp()`` and multiples, but is not an element of the algebra. Raises
        :class:`NoSolutionError` for 0, for negative scalars, and if q has a negative real eigenvalue.

        >>> from hfield import H
        >>> H("RDF")(0, 0, 0, 1).log().coordinates[3]
        1.5707963267948966
        """
        if analysis.has_angles(self.ring):
            r, n, angle = self.polar()
            if not self.ring.is_zero(r - self.ring.one):
                raise CoercionError(
                    f"log |q| is not in {self.ring}, where |q| = {shorten(self.ring.text(r))}; "
                    "q.unit() has modulus 1"
                )
            return n * angle
        return self._computed(analysis.log(self.ring, self.algebra.constants, self.coordinates))

    def sqrt(self) -> Quaternion[E]:
        """Return the square root of positive trace, or 0 for 0; :meth:`square_roots` returns all roots.

        Raises :class:`NoSolutionError` if there is no such root.

        >>> from hfield import H
        >>> H("QQ").parse("2*i").sqrt(), H("RR").parse("i") ** 0.5
        (1 + i, 1/2*sqrt(2) + (1/2*sqrt(2))*i)
        """
        if self.is_batch and self.ring.is_exact:
            raise CoercionError("roots of arrays are computed over RDF: q.change_ring('RDF')")
        return self._computed(analysis.sqrt(self.ring, self.algebra.constants, self.coordinates))

    @overload
    def roots(self: Quaternion[np.ndarray], n: int) -> Any: ...
    @overload
    def roots(self, n: int) -> Roots: ...
    def roots(self, n: int) -> Any:
        """Return all x with ``xⁿ = q``, as the :class:`Roots` of a polynomial.

        For an array over RDF, return an array of shape ``(n, *shape)``: the roots in the plane of 1 and each
        entry's axis. Raises :class:`CoercionError` unless n is a positive int.

        >>> from hfield import H
        >>> H("RR").parse("-1").roots(2).spheres      # all q of trace 0 and norm 1
        ((0, 1),)
        """
        if isinstance(n, bool) or not isinstance(n, int) or n < 1:
            raise CoercionError(f"{n!r} is not the degree of a root: expected a positive int")
        if not self.is_batch:
            return self.algebra.polynomials("x")([-self, *[0] * (n - 1), 1]).roots()
        if self.ring.is_exact:
            raise CoercionError("roots of arrays are computed over RDF: q.change_ring('RDF')")
        import numpy as np

        polar: Polar = self.polar()  # arrays
        r, axis, angle = polar
        turned = (angle + 2 * np.pi * np.arange(n).reshape(-1, *[1] * len(self.shape))) / n
        length = r ** (1 / n)
        return axis * (length * np.sin(turned)) + length * np.cos(turned)

    # --- units and zero divisors ---------------------------------------------------------------

    def is_unit(self) -> bool:
        """Return whether q has an inverse: its norm is a unit of the base ring."""
        return structure.is_unit(*self._single())

    def is_zero_divisor(self) -> bool:
        """Return whether q·y = 0 for some y ≠ 0. By this definition 0 is a zero divisor."""
        ring, c, q = self._single()
        return ring.annihilator(product.norm(c, q)) is not None

    def annihilator(self) -> Quaternion[E] | None:
        """Return some nonzero y with ``q·y = 0``, or None if q is not a zero divisor.

        q is a zero divisor if and only if its norm is 0 or a zero divisor of the base ring. Then ``conj(q)``
        times an annihilator of the norm works, unless it is 0; in that case an annihilator of all coordinates
        of ``conj(q)`` works.
        """
        ring, c, q = self._single()
        s = ring.annihilator(product.norm(c, q))
        if s is None:
            return None
        y = self.algebra(*(s * x for x in product.conjugate(c, q)))
        # If s·conj(q) = 0, then s·q = 0: the scalar s itself annihilates q.
        return self.algebra.scalar(s) if y.is_zero() else y

    def _why_no_inverse(self) -> str:
        """Return the reason why this single quaternion has no inverse."""
        ring, c, q = self._single()
        if all(map(ring.is_zero, q)):
            return f"cannot invert 0 in {self.algebra}"
        norm, y = shorten(ring.text(product.norm(c, q))), self.annihilator()
        start = f"cannot invert q = {shorten(self)} in {self.algebra}: its norm"
        if y is None:
            return f"{start} {norm} is not a unit of {ring}"
        return f"{start} is {norm}, and q·y = 0 for y = {shorten(y)}"

    def order(self) -> int | None:
        """Return the least n > 0 with ``qⁿ = 1``, or None if there is none.

        Raises :class:`NotInvertibleError` unless q is a unit. Raises :class:`UndecidedError` if the order is
        not known: for some transcendental numbers, over user-defined infinite rings, over RDF, and if a
        factorisation is out of reach.

        >>> from hfield import H
        >>> H("RR").parse("cos(2*pi/7) + sin(2*pi/7)*k").order(), H("RR")(1, 1, 1, 1).order()
        (7, None)
        """
        return structure.multiplicative_order(*self._single())

    # --- polynomials and equations -------------------------------------------------------------

    def minimal_polynomial(self) -> Coefficients:
        """Return the coefficients, low degree first, monic: ``(−w, 1)`` or ``(N(q), −tr(q), 1)``.

        The result is a tuple that is displayed as a polynomial in X.

        >>> from hfield import H
        >>> H("QQ")(1, 2, 0, 1).minimal_polynomial()
        X²−2·X+6
        """
        ring, _, q = self._single()
        if all(ring.is_zero(x) for x in q[1:]):
            return Coefficients(ring, (-q[0], ring.one))
        return self.characteristic_polynomial()

    def characteristic_polynomial(self) -> Coefficients:
        """Return the coefficients of the reduced characteristic polynomial ``x² − tr(q)·x + N(q)``, low
        degree first.
        """
        ring, constants, q = self._single()
        return Coefficients(ring, structure.characteristic_polynomial(ring, constants, q))

    def is_nilpotent(self) -> bool:
        """Return whether some power of q is 0."""
        return structure.is_nilpotent(*self._single())

    def is_idempotent(self) -> bool:
        """Return whether ``q² = q``."""
        return structure.is_idempotent(*self._single())

    def square_roots(self) -> SquareRoots[E]:
        """Return all x with ``x² = q``, verified by squaring. The base ring must be a field.

        Raises :class:`UndecidedError` if the base ring does not decide square roots, or does not decide
        whether an element of given trace and norm exists.

        >>> from hfield import H
        >>> list(H("QQ").parse("2*i").square_roots())
        [1 + i, -1 - i]
        """
        return SquareRoots(self, structure.square_roots(*self._single()))

    def conjugacy(self, other: object) -> Verdict[Quaternion[E]]:
        """Return whether ``x·q·x⁻¹ = other`` is solvable; ``element`` is a solution x, ``reason`` says why
        there is none.

        Raises :class:`MixedParentsError` for elements of two algebras, and :class:`UndecidedError`
        over a ring that is not a field.
        """
        ring, c, q = self._single()
        if not isinstance(other, Quaternion):
            other = self.algebra(other)
        if other.algebra != self.algebra:
            raise MixedParentsError(
                f"{shorten(self)} is an element of {self.algebra} and {shorten(other)} one of "
                f"{other.algebra}: only elements of one algebra can be conjugate"
            )
        found = structure.conjugacy(ring, c, q, other._single()[2])
        x = None if found.element is None else self.algebra(*found.element)
        return Verdict(found.value, found.reason, x)

    def conjugator(self, other: object) -> Quaternion[E] | None:
        """Return a unit x with ``x·q·x⁻¹ = other``, or None; :meth:`conjugacy` also returns the reason.

        In a central simple algebra a unit exists if and only if both have the same minimal polynomial (Skolem
        and Noether).
        """
        return self.conjugacy(other).element

    # --- arrays --------------------------------------------------------------------------------

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of an array of quaternions; ``()`` for a single one."""
        return self._how.shape(self._stored) if isinstance(self._how, BatchStorage) else ()

    def __len__(self) -> int:
        if not self.shape:
            raise CoercionError(
                "a single quaternion has no length; its coordinates are .coordinates"
            )
        return self.shape[0]

    def __getitem__(self, index: Index) -> Quaternion[E]:
        """Index an array of quaternions as numpy does."""
        how = self._how
        if not isinstance(how, BatchStorage) or not how.shape(self._stored):
            raise CoercionError("a single quaternion cannot be indexed; use q.coordinates[n]")
        return self._one_or_many(how, how.part(self._stored, index))

    def _one_or_many(self, how: BatchStorage, stored: object) -> Quaternion[E]:
        """Return the array with this stored value, or a single element if it has no dimension."""
        return self._alike(stored) if how.shape(stored) else self._new(*how.single(stored))

    def __iter__(self) -> Iterator[Quaternion[E]]:
        return (self[n] for n in range(len(self)))

    def _array(self, what: str) -> BatchStorage:
        if not isinstance(self._how, BatchStorage):
            raise CoercionError(f"a single quaternion has no {what}; arrays of quaternions have")
        return self._how

    def units(self) -> np.ndarray:
        """Return a bool array that marks the entries with an inverse."""
        return self._array("entries").units(self._stored)

    def sum(self, axis: int | None = None) -> Quaternion[E]:
        """Return the sum along an axis, or of all entries.

        >>> from hfield import H
        >>> H("GF(7)")([1, 2, 3], 1, 0, [4, 4, 4]).sum()
        6 + 3*i + 5*k
        """
        how = self._array("sum")
        return self._one_or_many(how, how.total(self._stored, axis))

    def product(self, axis: int | None = None) -> Quaternion[E]:
        """Return the product along an axis, or of all entries, from left to right.

        Neighbouring pairs are multiplied until one element is left, so an array of length n takes about log₂
        n calls.

        >>> from hfield import H
        >>> H("QQ")(0, [1, 0, 0], [0, 1, 0], [0, 0, 1]).product()  # i·j·k
        -1
        """
        how = self._array("product")
        return self._one_or_many(how, how.ordered_product(self._stored, axis))

    def reshape(self, *shape: int | tuple[int, ...]) -> Quaternion[E]:
        """Return the same entries in another shape, as in numpy. Raises :class:`CoercionError`."""
        how = self._array("shape")
        sizes: Any = shape[0] if len(shape) == 1 else shape
        try:
            return self._one_or_many(how, how.reshaped(self._stored, sizes))
        except (ValueError, TypeError) as error:
            raise CoercionError(
                f"an array of quaternions of shape {self.shape} has no shape {shape}: {error}"
            ) from None

    def to_array(self, axis: int = 0) -> np.ndarray:
        """Return all coordinates as one numpy array; ``A.from_array`` converts it back.

        The shape is ``(4, *shape)``, or ``(*shape, 4)`` with ``axis=-1``. Over RDF and CDF the entries are
        real and complex floats. Over ℤ/n they are residues, over GF(pⁿ) labels (the base-p digits of an
        element, as in galois), and over ℤ int64, whatever the width of the stored numbers. Over ℚ there are
        five entries per element: four numerators and a common denominator last, in a basis that is scaled to
        integral structure constants. The result is read-only; it is not copied if the array was computed or
        contains floats. Raises :class:`CoercionError` over other rings, for another axis, and for numbers of
        more than 64 bits.

        >>> from hfield import H
        >>> H("GF(9)")([1, 2], "x", 0, 0).to_array().tolist()
        [[1, 2], [3, 3], [0, 0], [0, 0]]
        >>> H("RDF")([1, 2], 0, 0, 0.5).to_array(axis=-1)
        array([[1. , 0. , 0. , 0.5],
               [2. , 0. , 0. , 0.5]])
        """
        import numpy as np

        check_axis(axis)
        block = self._array("array form").to_array(self._stored)
        return np.moveaxis(block, 0, axis)

    # --- text ----------------------------------------------------------------------------------

    def text(self, style: str = "plain") -> str:
        """Write q in the style ``plain`` (which the algebra reads back), ``unicode`` or ``latex``."""
        if not self.is_batch:
            return element_text(self.ring, self.coordinates, style)
        shown = (
            ", ".join(self[n].text(style) for n in range(min(len(self), 3))) if self.shape else ""
        )
        more = ", …" if self.shape and len(self) > 3 else ""
        return f"<array of shape {self.shape} over {self.algebra}: {shown}{more}>"

    def text_for(self, system: str) -> str:
        """Write q as code for ``"sage"``, ``"magma"`` or ``"pari"``; ``A.read(text)`` reads it.

        For PARI, elements are columns over the algebra ``A.text_for("pari")``. Raises :class:`RingError` as
        :meth:`QuaternionAlgebra.text_for` does, and :class:`CoercionError` for an array.

        >>> from hfield import H
        >>> q = H("QQ")("1/2 + 1/2*k"); q.text_for("sage"), q.text_for("pari")
        ('QuaternionAlgebra(QQ, -1, -1)([1/2, 0, 0, 1/2])', '[1/2, (-1/2)*x]~')
        >>> q.text_for("magma")
        'A![1/2, 0, 0, 1/2] where A is QuaternionAlgebra<Rationals() | -1, -1>'
        """
        if self.is_batch:
            raise CoercionError(
                "text_for writes one element, and this is an array of them: write q[n].text_for(system)"
            )
        writer = OtherSystemWriter(self.ring, self.algebra.constants, system)
        return writer.element(self.coordinates)

    def __str__(self) -> str:
        return self.text("plain")

    def __repr__(self) -> str:
        return str(self)

    def __format__(self, spec: str) -> str:
        return self.text(spec) if spec in ("plain", "unicode", "latex") else format(str(self), spec)

    def __float__(self) -> float:
        if self.is_batch or not self.vector_part.is_zero():
            raise TypeError(f"{shorten(self)} is not a scalar: float(q) is for multiples of 1")
        scalar: Any = self.scalar_part  # one that has no float raises a TypeError
        return float(scalar)

    def _latex(self, printer: object) -> str:
        if not self.shape:
            return self.text("latex")
        entries = r", \ ".join(q._latex(printer) for q in self)
        return rf"\left[ {entries}\right]"

    def _repr_latex_(self) -> str | None:
        return None if self.is_batch else f"${self.text('latex')}$"  # an array has its repr

    def __reduce__(self) -> tuple[object, ...]:
        state = self.ring.state
        if not self.is_batch:
            return self.algebra, tuple(map(state, self.coordinates))
        try:
            return self.algebra.from_array, (self.to_array(),)
        except CoercionError:
            coordinates: Coordinates = self.coordinates
        if coordinates[0].dtype != object:  # numpy's arrays pickle as they are
            return type(self), (self.algebra, coordinates)
        rows = tuple([state(x) for x in c.ravel().tolist()] for c in coordinates)
        return _from_states, (type(self), self.algebra, self.shape, rows)


class Polar(NamedTuple, Generic[E]):
    """``q = modulus·(cos(angle) + axis·sin(angle))``, ``axis² = −1``, the angle in [0, π] in radians."""

    modulus: E
    axis: Quaternion[E]
    angle: Any  # an element or array as the modulus, over functions of angles a SymbolicAngle


class TooManyError(NotFiniteError, OverflowError):
    """The number of elements exceeds ``sys.maxsize``; this error is also a TypeError, which
    ``list`` ignores.
    """


class SquareRoots(Generic[E]):
    """The square roots of ``element``: ``x in roots`` tests x, iteration yields the listed roots.

    If there are finitely many, all are listed. Over an infinite field a scalar s may have infinitely many
    roots: the quadric of elements of trace 0 and norm −s. Then ``is_finite`` is False, and only one root of
    the quadric and its negative are listed.
    """

    def __init__(self, element: Quaternion[E], found: Found) -> None:
        A = element.algebra
        self.element = element
        self.isolated = tuple(A(*x) for x in found.isolated)
        self.quadric = None if found.quadric is None else A(*found.quadric)

    @property
    def is_finite(self) -> bool:
        """Whether there are finitely many roots, so that iteration yields all of them."""
        return self.quadric is None or self.element.ring.order is not None

    def __bool__(self) -> bool:
        return bool(self.isolated) or self.quadric is not None

    def __contains__(self, x: Scalar) -> bool:
        return bool(x * x == self.element)

    def __iter__(self) -> Iterator[Quaternion[E]]:
        yield from self.isolated
        if self.quadric is None:
            return
        if self.is_finite:
            yield from self._quadric()
        else:
            yield self.quadric
            if self.quadric != -self.quadric:
                yield -self.quadric

    def _quadric(self) -> Iterator[Quaternion[E]]:
        """Yield the elements of trace 0 and norm −s over a finite field."""
        A = self.element.algebra
        return (A(*x) for x in structure.quadric(A.ring, A.constants, self.element.scalar_part))

    def __len__(self) -> int:
        """Return the number of roots.

        Raises :class:`NotFiniteError`, also an OverflowError, if there are infinitely many or more than
        ``len`` can return; over finite fields ``A.count(square=s)`` returns any number.
        """
        if not self.is_finite:
            raise TooManyError(f"{shorten(self.element)} has infinitely many square roots")
        if self.quadric is None:
            return len(self.isolated)
        n = self.element.algebra.count(square=self.element.scalar_part)
        if n > sys.maxsize:
            raise TooManyError(
                f"{shorten(self.element)} has {n} square roots, too many for len(): use A.count(square=…)"
            )
        return n

    def __repr__(self) -> str:
        shown = ", ".join(str(x) for _, x in zip(range(6), self, strict=False))
        more = "" if self.is_finite else ", … (all elements of trace 0 and this norm)"
        return f"SquareRoots({shown}{more})"


def product_plus(p: Quaternion[E], q: Quaternion[E], r: Quaternion[E]) -> Quaternion[E]:
    """Return ``p * q + r``; arrays over a finite ring are computed in one loop."""
    together: Callable[[object, object, object], object] | None = getattr(
        p._how, "product_plus", None
    )
    if together is None or not p._how is q._how is r._how:
        return p * q + r
    return from_stored(p._algebra, p._how, together(p._stored, q._stored, r._stored))


def from_stored(algebra: Parent[E], how: Storage[object, E], stored: object) -> Quaternion[E]:
    """Return the element of this algebra with the value ``stored`` in the storage ``how``."""
    q: Quaternion[E] = _blank(Quaternion)
    q._algebra = algebra
    q._how = how
    q._stored = stored
    return q


def _refuse_change() -> NoReturn:
    raise AttributeError("quaternions are immutable; build a new one with the algebra")


def check_axis(axis: object) -> None:
    """Raise CoercionError unless the axis of coordinates is the first or the last."""
    if axis not in (0, -1):
        raise CoercionError(
            f"axis={axis!r}: the coordinates lie along the first axis, 0, or along the last, -1"
        )


def _first(flags: np.ndarray) -> tuple[int, ...]:
    """Return the index of the first true entry of a bool array."""
    import numpy as np

    return tuple(map(int, np.argwhere(flags)[0]))


def is_array(x: object) -> TypeGuard[np.ndarray]:
    """Return whether a coordinate is an array; a 0-dimensional one counts."""
    return hasattr(x, "dtype") and hasattr(x, "ndim")


def is_many(value: object) -> TypeGuard[list[object] | tuple[object, ...] | np.ndarray]:
    """Return whether a coordinate is an array."""
    if type(value) is int:
        return False
    return isinstance(value, (list, tuple)) or (is_array(value) and value.ndim > 0)


def _from_states(
    element: type[Quaternion],
    algebra: Parent,
    shape: tuple[int, ...],
    rows: tuple[list[object], ...],
) -> Quaternion:
    """Rebuild an array of quaternions from its pickled state."""
    w, x, y, z = (algebra.ring.array(row).reshape(shape) for row in rows)
    return element(algebra, (w, x, y, z))
