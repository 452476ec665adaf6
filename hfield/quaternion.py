"""The element: one quaternion, or an array of them, with the same methods."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from typing import Any, Protocol

from hfield import product
from hfield.elements import ElementFacts
from hfield.embedding import embedding
from hfield.errors import CoercionError, MixedParentsError, NotInvertibleError, shorten
from hfield.notation import element_text
from hfield.product import Coordinates
from hfield.rings.base import Ring, power


class Parent(Protocol):
    """What an element asks of its algebra: :class:`hfield.algebra.QuaternionAlgebra`."""

    ring: Ring
    constants: product.Constants

    @property
    def batch_constants(self) -> product.Constants: ...  # noqa: D102
    @property
    def basis(self) -> tuple[Quaternion, Quaternion, Quaternion, Quaternion]: ...  # noqa: D102
    def __call__(self, *coordinates: Any) -> Quaternion: ...  # noqa: D102
    def scalar(self, x: Any) -> Quaternion: ...  # noqa: D102
    def change_ring(self, ring: Ring | str) -> Parent: ...  # noqa: D102


class Quaternion(ElementFacts):
    """An immutable element of a quaternion algebra: ``w·e + x·i + y·j + z·k``.

    Elements are made by calling their algebra. The four coordinates are elements of the base ring,
    or four arrays of one shape, and then every operation is elementwise. Ints and Fractions mix in
    as multiples of e, elements of the base ring too. Elements of two algebras never mix:
    arithmetic raises :class:`MixedParentsError`, and ``==`` between them is False.
    """

    __slots__ = ("algebra", "coordinates")
    __array_ufunc__ = None  # or numpy would distribute ``array * q`` over the array's entries

    algebra: Parent
    coordinates: Coordinates

    def __init__(self, algebra: Parent, coordinates: Coordinates) -> None:
        object.__setattr__(self, "algebra", algebra)
        object.__setattr__(self, "coordinates", coordinates)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("quaternions are immutable; build a new one with the algebra")

    def __delattr__(self, name: str) -> None:
        raise AttributeError("quaternions are immutable")

    # --- shape ---------------------------------------------------------------------------------

    @property
    def ring(self) -> Ring:
        """The base ring."""
        return self.algebra.ring

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of an array of quaternions; ``()`` for a single one."""
        return self.coordinates[0].shape if self.is_batch else ()

    @property
    def is_batch(self) -> bool:
        """Whether this is an array of quaternions."""
        return is_array(self.coordinates[0])

    def __len__(self) -> int:
        if not self.shape:
            raise TypeError("a single quaternion has no length; its coordinates are .coordinates")
        return self.shape[0]

    def __getitem__(self, index: Any) -> Quaternion:
        """Take elements out of an array of quaternions, as numpy indexes arrays."""
        if not self.shape:
            raise TypeError("a single quaternion cannot be indexed; use q.coordinates[n]")
        parts = [c[index] for c in self.coordinates]
        if not getattr(parts[0], "shape", ()):
            parts = [self.ring.scalar(c) for c in parts]
        return self._new(*parts)

    def __iter__(self) -> Iterator[Quaternion]:
        return (self[n] for n in range(len(self)))

    def _new(self, w: Any, x: Any, y: Any, z: Any) -> Quaternion:
        return Quaternion(self.algebra, (w, x, y, z))

    def _operand(self, other: Any, operation: str) -> Quaternion:
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

    def _join(self, other: Any, operation: str) -> tuple[Quaternion, Quaternion]:
        """Bring the two operands into one algebra and one kind (single or array)."""
        q = self._operand(other, operation)
        if not self.is_batch and not q.is_batch:
            return self, q
        if self.shape != q.shape and self.shape and q.shape:
            _check_shapes(self.shape, q.shape, operation)
        return self._as_batch(), q._as_batch()

    def _as_batch(self) -> Quaternion:
        if self.is_batch:
            return self
        return self._new(*(self.ring.array(c) for c in self.coordinates))

    # --- arithmetic ----------------------------------------------------------------------------

    def __add__(self, other: Any) -> Quaternion:
        p, q = self._join(other, "add")
        return self._new(*(x + y for x, y in zip(p.coordinates, q.coordinates, strict=True)))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Quaternion:
        p, q = self._join(other, "subtract")
        return self._new(*(x - y for x, y in zip(p.coordinates, q.coordinates, strict=True)))

    def __rsub__(self, other: Any) -> Quaternion:
        p, q = self._join(other, "subtract")
        return q - p

    def __neg__(self) -> Quaternion:
        return self._new(*(-x for x in self.coordinates))

    def __pos__(self) -> Quaternion:
        return self

    def __mul__(self, other: Any) -> Quaternion:
        if hasattr(other, "multiplied_by_elements"):  # a lattice: it multiplies itself
            return NotImplemented
        p, q = self._join(other, "multiply")
        return self._new(*product.multiply(p._constants, p.coordinates, q.coordinates))

    def __rmul__(self, other: Any) -> Quaternion:
        return self._join(other, "multiply")[1] * self

    def __truediv__(self, other: Any) -> Quaternion:
        """Return ``self · other⁻¹``."""
        return self * self._operand(other, "divide").inverse()

    def __rtruediv__(self, other: Any) -> Quaternion:
        return self._operand(other, "divide") * self.inverse()

    def __pow__(self, n: int) -> Quaternion:
        if not isinstance(n, int):
            raise CoercionError(f"the exponent {n!r} is not an int; only integer powers exist")
        one = self - self + 1 if self.is_batch else self.algebra.basis[0]
        result: Quaternion = power(one, self if n >= 0 else self.inverse(), abs(n))
        return result

    def __eq__(self, other: object) -> Any:
        if isinstance(other, str):
            return NotImplemented
        if not isinstance(other, Quaternion):
            try:
                other = self.algebra.scalar(other)
            except (CoercionError, NotInvertibleError):
                return NotImplemented
        if other.algebra != self.algebra:
            return False
        p, q = self._join(other, "compare")
        pairs = list(zip(p.coordinates, q.coordinates, strict=True))
        if not p.is_batch:
            return all(self.ring.equal(x, y) for x, y in pairs)
        import numpy as np

        return np.logical_and.reduce([np.asarray(x == y, dtype=bool) for x, y in pairs])

    def __hash__(self) -> int:
        if self.is_batch or not self.ring.is_exact:
            what = "an array of quaternions" if self.is_batch else "a quaternion of floats"
            raise TypeError(f"{what} cannot be hashed; single ones over an exact ring can")
        return hash((self.algebra, self._keys()))

    def _keys(self) -> tuple[Hashable, ...]:
        return tuple(self.ring.key(x) for x in self.coordinates)

    def __bool__(self) -> bool:
        if self.is_batch:
            raise ValueError(
                "the truth value of an array of quaternions is ambiguous; compare first"
            )
        return not self.is_zero()

    # --- what the algebra knows of it ----------------------------------------------------------

    @property
    def _constants(self) -> product.Constants:
        return self.algebra.batch_constants if self.is_batch else self.algebra.constants

    @property
    def scalar_part(self) -> Any:
        """The coordinate of e, in the base ring (thesis 1.4.2)."""
        return self.coordinates[0]

    @property
    def vector_part(self) -> Quaternion:
        """The element without its scalar part, ``x·i + y·j + z·k`` (thesis 1.4.2)."""
        w, x, y, z = self.coordinates
        return self._new(w - w, x, y, z)

    def conjugate(self) -> Quaternion:
        """Return the standard involution; ``w − x·i − y·j − z·k`` when t = 0 (Definition 3)."""
        return self._new(*product.conjugate(self._constants, self.coordinates))

    def norm(self) -> Any:
        """Return the reduced norm, an element (or array) of the base ring (Definition 2)."""
        return product.norm(self._constants, self.coordinates)

    def trace(self) -> Any:
        """Return the reduced trace, an element (or array) of the base ring."""
        return product.trace(self._constants, self.coordinates)

    def inverse(self) -> Quaternion:
        """Return ``q⁻¹ = conj(q)/N(q)`` (Definition 4).

        Raises :class:`NotInvertibleError`, a ZeroDivisionError, where the norm is not a unit; the
        message shows some y ≠ 0 with q·y = 0 where there is one.
        """
        n = self.norm()
        if self.is_batch:
            import numpy as np

            units = self.ring.array_units(n)
            if not units.all():
                where = tuple(map(int, np.argwhere(~units)[0]))
                parts = (self.ring.scalar(c[where]) for c in self.coordinates)
                raise NotInvertibleError(
                    f"at index {where} of the array: {self._new(*parts)._failure()}"
                )
            return self.conjugate() * self.algebra.scalar(self.ring.array_inverse(n))
        if not self.ring.is_unit(n):
            raise NotInvertibleError(self._failure())
        return self.conjugate() * self.algebra.scalar(self.ring.inverse(n))

    def _failure(self) -> str:
        """Say why this single quaternion has no inverse."""
        if self.is_zero():
            return f"cannot invert 0 in {self.algebra}"
        n, y = self.norm(), self.annihilator()
        if y is None:
            return (
                f"cannot invert q = {shorten(self)} in {self.algebra}: its norm "
                f"{shorten(self.ring.text(n))} is not a unit of {self.ring}"
            )
        return (
            f"cannot invert q = {shorten(self)} in {self.algebra}: its norm is "
            f"{shorten(self.ring.text(n))}, and q·y = 0 for y = {shorten(y)}"
        )

    def is_zero(self) -> Any:
        """Tell whether the quaternion is 0; of an array, which entries are, as a bool array."""
        if self.is_batch:
            return self == 0
        return all(self.ring.is_zero(x) for x in self.coordinates)

    def matrix(self) -> tuple[tuple[Any, ...], ...]:
        """Return the 4 × 4 matrix of ``p ↦ q·p``: column n holds the coordinates of q·(basis n)."""
        columns = [(self * b).coordinates for b in self.algebra.basis]
        return tuple(zip(*columns, strict=True))

    def change_ring(self, ring: Ring | str) -> Quaternion:
        """Return q in the algebra with the same constants over ``ring``, which must contain them."""
        A = self.algebra.change_ring(ring)
        return A(*map(embedding(self.ring, A.ring), self.coordinates))

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

    def __str__(self) -> str:
        return self.text("plain")

    def __repr__(self) -> str:
        return self.text("unicode")

    def _repr_latex_(self) -> str:
        return f"${self.text('latex')}$" if not self.is_batch else ""

    def __reduce__(self) -> Any:
        state = self.ring.state
        if not self.is_batch:
            return self.algebra, tuple(map(state, self.coordinates))
        if self.coordinates[0].dtype != object:  # numpy's and galois's arrays pickle as they are
            return Quaternion, (self.algebra, self.coordinates)
        rows = tuple([state(x) for x in c.ravel().tolist()] for c in self.coordinates)
        return _unpickled, (self.algebra, self.shape, rows)


def _check_shapes(left: tuple[int, ...], right: tuple[int, ...], operation: str) -> None:
    import numpy as np

    try:
        np.broadcast_shapes(left, right)
    except ValueError:
        raise CoercionError(
            f"cannot {operation} arrays of quaternions of the shapes {left} and {right}: expected one shape "
            "for both, or shapes that broadcast as numpy's do"
        ) from None


def _unpickled(algebra: Parent, shape: tuple[int, ...], rows: tuple[list[Any], ...]) -> Quaternion:
    """Make an array of quaternions again from what stood for its entries."""
    w, x, y, z = (algebra.ring.array(row).reshape(shape) for row in rows)
    return Quaternion(algebra, (w, x, y, z))


def is_array(x: object) -> bool:
    """Tell whether a coordinate is an array; a 0-dimensional one counts."""
    return hasattr(x, "dtype") and hasattr(x, "ndim")
