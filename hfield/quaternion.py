"""The element: one quaternion, or an array of them, with the same methods."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn, Protocol

from hfield.batches import raised
from hfield.element_text import ElementText
from hfield.elements import ElementFacts
from hfield.errors import CoercionError, MixedParentsError, NotInvertibleError
from hfield.product import Constants, Coordinates, Scalar
from hfield.rings.base import Ring
from hfield.rings.holding import Batch, Holding
from hfield.rings.powers import power

if TYPE_CHECKING:
    import numpy as np


_blank: Any = object.__new__


class Parent(Protocol):
    """What an element asks of its algebra: :class:`hfield.algebra.QuaternionAlgebra`."""

    ring: Ring
    constants: Constants

    @property
    def holding(self) -> Holding: ...  # noqa: D102
    @property
    def array_holding(self) -> Batch: ...  # noqa: D102
    @property
    def basis(self) -> tuple[Quaternion, Quaternion, Quaternion, Quaternion]: ...  # noqa: D102
    def __call__(self, *coordinates: object) -> Quaternion: ...  # noqa: D102
    def scalar(self, x: object) -> Quaternion: ...  # noqa: D102
    def change_ring(self, ring: Ring | str) -> Parent: ...  # noqa: D102
    def latex(self) -> str: ...  # noqa: D102


class Quaternion(ElementFacts, ElementText):
    """An immutable element of a quaternion algebra: ``w·e + x·i + y·j + z·k``.

    Elements are made by calling their algebra. The four coordinates are elements of the base ring,
    or four arrays of one shape, and then every operation is elementwise. Ints and Fractions mix in
    as multiples of e, elements of the base ring too. Elements of two algebras never mix:
    arithmetic raises :class:`MixedParentsError`, and ``==`` between them is False.

    >>> from hfield import H
    >>> q = H("QQ")(1, 2, 0, 1)
    >>> q * q.conjugate() == q.norm(), q.inverse()
    (True, 1/6 − 1/3i − 1/6k)
    """

    # What is kept is _held, which only the holding _how reads; coordinates are made when asked for.
    # No __setattr__ or __delattr__ of its own: they would make every new element slower.
    __slots__ = ("_algebra", "_held", "_how")
    __array_ufunc__ = None  # or numpy would distribute ``array * q`` over the array's entries

    _algebra: Parent
    _how: Holding
    _held: Any

    def __init__(self, algebra: Parent, coordinates: Coordinates) -> None:
        self._algebra = algebra
        self._how = algebra.holding
        if is_array(coordinates[0]):
            self._how = algebra.array_holding
            w, x, y, z = (c.copy() for c in coordinates)
            coordinates = w, x, y, z
        self._held = self._how.hold(coordinates)

    @property
    def algebra(self) -> Parent:
        """The algebra of which it is an element."""
        return self._algebra

    @algebra.setter
    def algebra(self, value: object) -> NoReturn:
        _refuse_change()

    @algebra.deleter
    def algebra(self) -> NoReturn:
        _refuse_change()

    @property
    def coordinates(self) -> Coordinates:
        """The four coordinates over ``(e, i, j, k)``: elements of the base ring, or read-only arrays."""
        how = self._how
        return how.handed_out(self._held) if isinstance(how, Batch) else how.coordinates(self._held)

    @coordinates.setter
    def coordinates(self, value: object) -> NoReturn:
        _refuse_change()

    @coordinates.deleter
    def coordinates(self) -> NoReturn:
        _refuse_change()

    # --- shape ---------------------------------------------------------------------------------

    @property
    def ring(self) -> Ring:
        """The base ring."""
        return self._algebra.ring

    @property
    def is_batch(self) -> bool:
        """Whether this is an array of quaternions."""
        return self._how.is_batch

    def _new(self, w: Scalar, x: Scalar, y: Scalar, z: Scalar) -> Quaternion:
        return Quaternion(self._algebra, (w, x, y, z))

    def _alike(self, held: Any) -> Quaternion:
        """Return another element of this algebra, held as this one is."""
        return held_by(self._algebra, self._how, held)

    def _operand(self, other: object, operation: str) -> Quaternion:
        """Bring the other operand into this algebra."""
        if isinstance(other, str):
            raise CoercionError(
                f"cannot {operation} a quaternion and a text; read it first: A({other!r})"
            )
        q = other if isinstance(other, Quaternion) else self.algebra.scalar(other)
        if q.algebra is not self.algebra and q.algebra != self.algebra:
            raise MixedParentsError(
                f"cannot {operation} an element of {self.algebra} and one of {q.algebra}: different "
                f"algebras never mix; if one ring contains the other, use q.change_ring(L) first"
            )
        return q

    def _join(self, other: object, operation: str) -> tuple[Holding, Any, Any]:
        """Bring the other operand into this algebra, both to one kind (single or array), and hold both."""
        q = self._operand(other, operation)
        if self._how.is_batch == q._how.is_batch:
            return self._how, self._held, q._held
        batch = self._algebra.array_holding
        p, q = (x._held if x.is_batch else batch.lift(x.coordinates) for x in (self, q))
        return batch, p, q

    # --- arithmetic ----------------------------------------------------------------------------
    # Two elements that are held alike, which is nearly always so, skip every question and every call.

    def __add__(self, other: object) -> Quaternion:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            result: Quaternion = _blank(Quaternion)
            result._algebra = self._algebra
            result._how = how
            add = how.sum
            result._held = add(self._held, other._held)
            return result
        how, p, q = self._join(other, "add")
        return held_by(self._algebra, how, how.sum(p, q))

    __radd__ = __add__

    def __sub__(self, other: object) -> Quaternion:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            return held_by(self._algebra, how, how.difference(self._held, other._held))
        how, p, q = self._join(other, "subtract")
        return held_by(self._algebra, how, how.difference(p, q))

    def __rsub__(self, other: object) -> Quaternion:
        how, p, q = self._join(other, "subtract")
        return held_by(self._algebra, how, how.difference(q, p))

    def __neg__(self) -> Quaternion:
        how = self._how
        return held_by(self._algebra, how, how.negative(self._held))

    def __pos__(self) -> Quaternion:
        return self

    def __mul__(self, other: object) -> Quaternion:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            result: Quaternion = _blank(Quaternion)
            result._algebra = self._algebra
            result._how = how
            multiply = how.product
            result._held = multiply(self._held, other._held)
            return result
        if hasattr(other, "multiplied_by_elements"):  # a lattice: it multiplies itself
            return NotImplemented
        if how.is_unique and not isinstance(other, (Quaternion, str)) and not is_many(other):
            return held_by(self._algebra, how, how.scaled(self._held, self._algebra.ring(other)))
        how, p, q = self._join(other, "multiply")
        return held_by(self._algebra, how, how.product(p, q))

    def __rmul__(self, other: object) -> Quaternion:
        how = self._how
        if how.is_unique and not isinstance(other, (Quaternion, str)) and not is_many(other):
            return held_by(self._algebra, how, how.scaled(self._held, self._algebra.ring(other)))
        how, p, q = self._join(other, "multiply")
        return held_by(self._algebra, how, how.product(q, p))

    def __truediv__(self, other: object) -> Quaternion:
        """Return ``self · other⁻¹``."""
        how = self._how
        if how.is_unique and not isinstance(other, (Quaternion, str)) and not is_many(other):
            held = how.divided(self._held, self._algebra.ring(other))
            if held is not None:
                return held_by(self._algebra, how, held)
        return self * self._operand(other, "divide").inverse()

    def __rtruediv__(self, other: object) -> Quaternion:
        return self._operand(other, "divide") * self.inverse()

    def __pow__(self, n: int) -> Quaternion:
        if not isinstance(n, int):
            raise CoercionError(f"the exponent {n!r} is not an int; only integer powers exist")
        base: Quaternion = self if n >= 0 else self.inverse()
        if isinstance(self._how, Batch):
            return held_by(self._algebra, self._how, raised(self._how, base._held, abs(n)))
        result: Quaternion = power(self._algebra.basis[0], base, abs(n))
        return result

    def __xor__(self, other: object) -> NoReturn:
        raise CoercionError("powers are written q**2; to Python q^2 + 1 would be q^(2 + 1)")

    def __eq__(self, other: object) -> Any:
        how = self._how
        if type(other) is Quaternion and other._how is how:
            if how.is_unique:
                return self._held == other._held
            return how.equal(self._held, other._held)
        if isinstance(other, str):
            return NotImplemented
        if not isinstance(other, Quaternion):
            try:
                other = self.algebra.scalar(other)
            except (CoercionError, NotInvertibleError):
                return NotImplemented
        if other.algebra != self.algebra:
            return False
        how, p, q = self._join(other, "compare")
        return how.equal(p, q)

    def __hash__(self) -> int:
        if self.is_batch or not self.ring.is_exact:
            what = "an array of quaternions" if self.is_batch else "a quaternion of floats"
            raise TypeError(f"{what} cannot be hashed; single ones over an exact ring can")
        return hash((self._algebra, self._how.key(self._held)))

    def __bool__(self) -> bool:
        if self.is_batch:
            raise ValueError(
                "the truth value of an array of quaternions is ambiguous; compare first"
            )
        return not self.is_zero()

    # --- what the algebra knows of it ----------------------------------------------------------

    def conjugate(self) -> Quaternion:
        """Return the standard involution; ``w − x·i − y·j − z·k`` when t = 0 (Definition 3)."""
        how = self._how
        return held_by(self._algebra, how, how.conjugate(self._held))

    conj = conjugate  # as the language calls it

    def norm(self) -> Any:
        """Return the reduced norm, an element (or array) of the base ring (Definition 2)."""
        norm = self._how.norm
        return norm(self._held)

    def trace(self) -> Any:
        """Return the reduced trace, an element (or array) of the base ring."""
        return self._how.trace(self._held)

    def inverse(self) -> Quaternion:
        """Return ``q⁻¹ = conj(q)/N(q)`` (Definition 4).

        Raises :class:`NotInvertibleError`, a ZeroDivisionError, where the norm is not a unit; the
        message shows some y ≠ 0 with q·y = 0 where there is one.
        """
        how = self._how
        held = how.inverse(self._held)
        if held is not None:
            return held_by(self._algebra, how, held)
        if not isinstance(how, Batch):
            raise NotInvertibleError(self._why_no_inverse())
        where = _first(~how.units(self._held))
        q = self._new(*how.single(how.part(self._held, where)))
        raise NotInvertibleError(f"at index {where} of the array: {q._why_no_inverse()}")

    inv = inverse

    def is_zero(self) -> Any:
        """Tell whether the quaternion is 0; of an array, which entries are, as a bool array."""
        return self._how.is_zero(self._held)


def held_by(algebra: Parent, how: Holding, held: Any) -> Quaternion:
    """Return the element that ``how``, a holding of this algebra, holds as ``held``."""
    q: Quaternion = _blank(Quaternion)
    q._algebra = algebra
    q._how = how
    q._held = held
    return q


def _refuse_change() -> NoReturn:
    raise AttributeError("quaternions are immutable; build a new one with the algebra")


def _first(flags: np.ndarray) -> tuple[int, ...]:
    """Return the index of the first true entry of a bool array."""
    import numpy as np

    return tuple(map(int, np.argwhere(flags)[0]))


def is_array(x: object) -> bool:
    """Tell whether a coordinate is an array; a 0-dimensional one counts."""
    return hasattr(x, "dtype") and hasattr(x, "ndim")


def is_many(value: Any) -> bool:
    """Tell whether a coordinate stands for many."""
    if type(value) is int:
        return False
    return isinstance(value, (list, tuple)) or (is_array(value) and value.ndim > 0)
