"""The parent: the quaternion algebra with ``i² = a + t·i, j² = b, ij = k, ji = t·j − k``."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, Protocol, overload

from hfield import notation, syntax
from hfield.algebra import structure
from hfield.algebra.embedding import embedding
from hfield.algebra.quaternion import (
    L,
    Number,
    Parent,
    Quaternion,
    check_axis,
    from_stored,
    is_many,
)
from hfield.algebra.structure.counting.counted_kinds import counted_kind
from hfield.algebra.structure.elements import analysis
from hfield.core.factorisation import Factors, known_primes
from hfield.core.product import Constants, Coordinates, Scalar
from hfield.errors import (
    CoercionError,
    HFieldError,
    MixedParentsError,
    NotFiniteError,
    RingError,
    TooLargeError,
    UndecidedError,
    shorten,
)
from hfield.fields import quadratic_forms
from hfield.fields.adjoining import adjoin_variables
from hfield.fields.base.from_sympy import check_symbols, is_of_sympy
from hfield.fields.base.ring import E, Ring, WithIntegers
from hfield.fields.base.storage.base import BatchStorage, Storage
from hfield.fields.floats import CDF
from hfield.fields.names import RingName
from hfield.fields.names import ring as read_ring
from hfield.fields.quadratic_forms.global_field import (
    field_named_by,
    global_field,
    no_flag,
)
from hfield.fields.rationals.ring import QQ
from hfield.hints import ALGEBRA, Hinted
from hfield.notation import BASIS
from hfield.symbols import (
    Substitution,
    as_list,
    coordinates_in,
    is_hamilton,
    is_quaternion,
    substitution,
    values_given,
)
from hfield.sympy_printing import PrintedBySympy
from hfield.syntax.other_systems import written

if TYPE_CHECKING:
    import numpy as np

    from hfield.algebra.brauer import Corestriction, TensorProduct
    from hfield.algebra.maps import Division, Isomorphism, LinearMap, Splitting
    from hfield.algebra.quadratic_fields import Embedding
    from hfield.algebra.quotients import AlgebraQuotient
    from hfield.exploring.automorphisms import AutomorphismGroup
    from hfield.exploring.conjugacy_classes import ConjugacyClass
    from hfield.exploring.elements import Elements
    from hfield.exploring.ideals import AlgebraIdeal
    from hfield.exploring.subalgebras import Subalgebra
    from hfield.exploring.unit_groups import FiniteUnitGroup
    from hfield.matrices.equations import LinearSolutions, SystemSolutions
    from hfield.matrices.matrix import Matrix
    from hfield.orders.foreign_texts import Value
    from hfield.orders.hurwitz_order import HurwitzOrder
    from hfield.orders.lattice import Lattice, Order
    from hfield.orders.ternary_forms import TernaryForm
    from hfield.polynomials.polynomial import Polynomials

LISTED = 10_000  # elements of a ring that are stored, to be iterated again
MAX_LISTED_ELEMENTS = 10**8  # elements of an array that lists all


class SupportsQuaternions(Protocol):
    """The method of rotations, ours and scipy's, that gives their unit quaternions."""

    def as_quat(self, *, scalar_first: bool) -> np.ndarray: ...  # noqa: D102


class Opposite(NamedTuple, Generic[E]):
    """The opposite algebra, in which the product of p and q is q·p, and the isomorphism onto it.

    ``isomorphism`` maps the given algebra onto ``algebra`` and reverses products: φ(pq) = φ(q)·φ(p).
    """

    algebra: QuaternionAlgebra[E]
    isomorphism: Isomorphism[E]


class QuaternionAlgebra(Hinted, PrintedBySympy, Generic[E]):
    """The quaternion algebra ``(a,b|R)``; with t = 1, the Artin–Schreier algebra ``[a,b|R)``.

    ``ring`` is a base ring or its text; ``a, b, t`` are values that the ring can read. Without a ring, a and
    b are rational numbers or elements of one number field. A single text names the algebra, and a single
    integer is the reduced discriminant of an algebra over ℚ. Raises :class:`RingError` for other arguments.

    Calling the algebra makes elements: ``A(1, 2, 0, 1)``, ``A("1 + 2*i + k")``, ``A(3)``; four coordinates
    may be arrays of one shape. Any a and b are allowed; if one is 0 the algebra is degenerate.

    >>> A = QuaternionAlgebra("QQ", -1, -1)
    >>> e, i, j, k = A.basis
    >>> i*j == k, j*i == -k
    (True, True)
    >>> QuaternionAlgebra(-1, -11), QuaternionAlgebra("(-1,-11|QQ)"), QuaternionAlgebra(11)
    ((-1,-11|QQ), (-1,-11|QQ), (-1,-11|QQ))
    """

    foreign_names = ALGEBRA

    ring: Ring[E]
    constants: Constants[E]

    @overload
    def __init__(self, ring: Ring[E], a: object, b: object, t: object = 0) -> None: ...
    @overload
    def __init__(
        self: QuaternionAlgebra,
        ring: object,
        a: object = None,
        b: object = None,
        t: object = 0,
    ) -> None: ...
    def __init__(
        self, ring: RingName | object, a: object = None, b: object = None, t: object = 0
    ) -> None:
        if b is None:
            ring, a, b, t = _constants(ring, a, t)
        self.ring = F = ring if isinstance(ring, Ring) else read_ring(ring)
        self.constants = Constants(F(a), F(t), F(b))
        self._base: QuaternionAlgebra | None = None  # of an algebra with unknowns, the one without
        self._names: tuple[str, ...] = ()
        self._unknowns: dict[str, Quaternion] = {}
        self._with_unknowns: dict[tuple[str, ...], QuaternionAlgebra] = {}

    @classmethod
    def from_text(cls, text: str) -> QuaternionAlgebra:
        """Read ``(a,b|F)``, ``[a,b|F)``, ``[a,b,t|F)``, ``H(F)``, or a discriminant over ℚ.

        Raises :class:`NotationError`.
        """
        ring, (a, t, b) = notation.parse_algebra(text)
        return cls(ring, a, b, t)

    @classmethod
    def from_ramification(
        cls, ring: RingName, primes: Iterable[object], infinite: bool | None = None
    ) -> QuaternionAlgebra:
        """Return an algebra over ℚ, a number field or GF(q)(t) that ramifies exactly at these places.

        Over ℚ the places are primes and ``"inf"``. The infinite place may be omitted, as its ramification
        follows from the parity, or given by ``infinite``. Over other fields they are places or their texts.
        Raises :class:`RingError` for anything but a place, for a repeated place, for an odd number of places,
        and for another field; and :class:`UndecidedError` if no constants were found.

        >>> QuaternionAlgebra.from_ramification("QQ", [2, 3]).discriminant()
        6
        >>> A = QuaternionAlgebra.from_ramification("QQ[s]/(s^3-2)", ["(2, s)", "inf0"])
        >>> A.ramified_places()
        ((2, s), inf0)
        >>> QuaternionAlgebra.from_ramification("GF(2)(t)", ["t^2+t+1", "inf"])
        [t,t^2+t+1|GF(2)(t))
        """
        F = read_ring(ring)
        field = global_field(F)
        if field is None:
            raise no_flag(F)
        if isinstance(primes, str) or not isinstance(primes, Iterable):
            raise CoercionError(
                f"the places must be a list such as [2, 3], found {shorten(primes)}"
            )
        return cls(F, *field.with_ramification(list(primes), infinite))

    @cached_property
    def storage(self) -> Storage[object, E]:
        """The storage of single elements, which computes with them."""
        return self.ring.storage(self.constants)

    @cached_property
    def array_storage(self) -> BatchStorage[object]:
        """The storage of arrays of elements, which computes with them."""
        return self.ring.array_storage(self.constants)

    # --- elements ------------------------------------------------------------------------------

    def _here(self) -> tuple[Ring[E], Constants[E]]:
        """Return the arguments that functions of ``structure`` expect."""
        return self.ring, self.constants

    @overload
    def __call__(self, x: E | Number | Quaternion[E], /) -> Quaternion[E]: ...
    @overload
    def __call__(
        self, w: E | Number, x: E | Number, y: E | Number, z: E | Number, /
    ) -> Quaternion[E]: ...
    @overload
    def __call__(self, *coordinates: object) -> Quaternion: ...
    def __call__(self, *coordinates: object) -> Quaternion:
        """Make an element from four coordinates, a scalar, a text, a quaternion or a list of four scalars.

        Each of four coordinates may be an array. A rotation of rotation or scipy becomes its unit quaternion
        over RDF. Other lists and arrays are rejected, since their entries could be scalars or quaternions;
        :meth:`from_array` makes arrays of quaternions, and :meth:`scalar` arrays of scalars. Raises
        :class:`CoercionError` for anything else, and :class:`NotationError` for unreadable text.
        """
        if len(coordinates) == 4:
            return self._element(coordinates)
        if len(coordinates) == 1:
            (x,) = coordinates
            if isinstance(x, Quaternion):
                if x.algebra != self:
                    if self._common(x.algebra) == self:
                        return self._include(x)
                    raise MixedParentsError(
                        f"{shorten(x)} is an element of {x.algebra}, not of {self}; "
                        "if the rings allow it, use q.change_ring(L)"
                    )
                return x
            if isinstance(x, str):
                return self.parse(x)
            if isinstance(x, tuple) and len(x) == 4:
                return self._element(x)
            if hasattr(x, "as_quat"):
                return self._of_rotation(x)
            if is_many(x):
                return self._of_list(x)
            if (found := coordinates_in(x)) is not None:
                return self._of_sympy(x, found)
            return self.scalar(x)
        raise CoercionError(
            f"an element of {self} takes 4 coordinates (or one scalar or text), "
            f"{len(coordinates)} were given"
        )

    def _of_list(self, x: list[object] | tuple[object, ...] | np.ndarray) -> Quaternion[E]:
        """Make an element from a list or an array of four scalars."""
        if len(x) == 4 and not any(map(is_many, x)):
            return self._element(tuple(x))
        shape = getattr(x, "shape", None)
        what = f"a list of {len(x)}" if shape is None else f"an array of shape {tuple(shape)}"
        raise CoercionError(
            f"{what} is not an element of {self}: an element is a list of four scalars; arrays of "
            "quaternions are A.from_array(x, axis=-1) with four coordinates in each row, or A(w, x, y, z) "
            "with an array for each coordinate; an array of scalars is A.scalar(x)"
        )

    def _of_sympy(self, x: object, coordinates: tuple[object, ...]) -> Quaternion[E]:
        if is_quaternion(x) and not is_hamilton(*self._here()):
            raise CoercionError(
                f"a quaternion of sympy has i² = j² = −1, and {self} other products: give four coordinates, "
                f"A(q.a, q.b, q.c, q.d), if these are meant"
            )
        return self._element(coordinates)

    def _of_rotation(self, x: SupportsQuaternions) -> Quaternion:
        """Return the unit quaternions of a rotation with scipy's method ``as_quat``."""
        if self.ring.is_exact or not is_hamilton(*self._here()):
            raise CoercionError(
                f"a rotation has unit quaternions of floats, in Hamilton's algebra, not in {self}: "
                "write H('RDF')(r)"
            )
        return self.from_array(x.as_quat(scalar_first=True), axis=-1)

    def _element(self, values: tuple[object, ...]) -> Quaternion[E]:
        if any(map(is_of_sympy, values)):
            values = tuple(map(as_list, values))
        check_symbols(values)
        how: Storage = self.array_storage if any(map(is_many, values)) else self.storage
        return from_stored(self, how, how.read(values))

    @overload
    def scalar(self, x: E | Number | Quaternion[E]) -> Quaternion[E]: ...
    @overload
    def scalar(self, x: object) -> Quaternion: ...
    def scalar(self, x: object) -> Quaternion:
        """Return ``x·e`` for a scalar x, or an array of them. Raises :class:`CoercionError`."""
        if isinstance(x, Quaternion):
            return self(x)
        if type(x) is int or is_many(x):
            return self._element((x, 0, 0, 0))
        return from_stored(self, self.storage, self.storage.scalar(self.ring(x)))

    def parse(
        self,
        text: str,
        *,
        names: Mapping[str, Quaternion[E]] | None = None,
        functions: Mapping[str, Callable[..., Quaternion]] | None = None,
    ) -> Quaternion[E]:
        """Read an expression such as ``(1+i)*(j-k)**-1``: the basis, the ring's generators and ``conj norm
        trace inv scalar vector comm``; ``names`` and ``functions`` add others. Raises :class:`NotationError`.
        """
        known = {name: self(x) for name, x in self.ring.names().items()}
        known |= dict(zip(BASIS, self.basis, strict=True)) | dict(names or {})
        calls: dict[str, Callable[..., Quaternion]] = {
            "/": lambda x, y: x / y,
            "**": lambda x, n: x**n,
            "[]": lambda q, n: self.scalar(q.coordinates[n]),
            "conj": Quaternion.conjugate,
            "norm": lambda q: self.scalar(q.norm()),
            "trace": lambda q: self.scalar(q.trace()),
            "inv": Quaternion.inverse,
            "scalar": lambda q: self.scalar(q.scalar_part),
            "vector": lambda q: q.vector_part,
            "comm": lambda p, q: p * q - q * p,
            **{name: self._lift(name, f) for name, f in self.ring.functions().items()},
            **(functions or {}),
        }
        reader = syntax.Reader(self.scalar, known, calls, str(self), self.ring.parse_limit)
        element: Quaternion[E] = reader.read_typed(text)
        return element

    def _lift(
        self, name: str, function: Callable[..., E] | syntax.OfTrees
    ) -> Callable[..., Quaternion]:
        """Apply a function of the ring, such as sqrt, to scalar multiples of e."""
        if isinstance(function, syntax.OfTrees):
            return function.then(self.scalar)

        def lifted(*arguments: Quaternion) -> Quaternion:
            for q in arguments:
                if not q.vector_part.is_zero():
                    raise CoercionError(f"{name} takes scalars, found {shorten(q)}")
            return self.scalar(function(*(q.scalar_part for q in arguments)))

        return lifted

    @cached_property
    def basis(self) -> Coordinates[Quaternion[E]]:
        """The basis ``(e, i, j, k)``."""
        rows = [[int(m == n) for m in range(4)] for n in range(4)]
        e, i, j, k = (self(*row) for row in rows)
        return e, i, j, k

    @property
    def one(self) -> Quaternion[E]:
        """The identity e."""
        return self.basis[0]

    @property
    def i(self) -> Quaternion[E]:
        """The basis element i.

        >>> A = H("GF(7)"); A.i * A.j == A.k, A.k**2
        (True, 6)
        """
        return self.basis[1]

    @property
    def j(self) -> Quaternion[E]:
        """The basis element j."""
        return self.basis[2]

    @property
    def k(self) -> Quaternion[E]:
        """The basis element k, the product of i and j."""
        return self.basis[3]

    @cached_property
    def zero(self) -> Quaternion[E]:
        """The element 0."""
        return self(0, 0, 0, 0)

    def elements(self) -> Iterator[Quaternion[E]]:
        """Yield all q⁴ elements over a finite ring. Raises :class:`NotFiniteError`."""
        F = self.ring
        # a few are kept, many made anew again and again
        few = list(F.elements()) if self._order_of_ring() <= LISTED else None
        return (
            Quaternion(self, (w, x, y, z))
            for w in few or F.elements()
            for x in few or F.elements()
            for y in few or F.elements()
            for z in few or F.elements()
        )

    def _order_of_ring(self) -> int:
        if self.ring.order is None:
            raise NotFiniteError(f"{self} is infinite, so its elements cannot be listed")
        return self.ring.order

    def random_element(self, seed: int | None = None) -> Quaternion[E]:
        """Return a random element; the same one for the same seed."""
        from random import Random

        rng = Random(seed)
        w, x, y, z = (self.ring.random(rng) for _ in range(4))
        return Quaternion(self, (w, x, y, z))

    # --- arrays --------------------------------------------------------------------------------

    def from_array(self, values: object, axis: int = 0, copy: bool = True) -> Quaternion:
        """Return the array of quaternions with these numbers, in the format of :meth:`Quaternion.to_array`.

        The coordinates lie along the first axis, or along the last with ``axis=-1``: an array of shape (N, 4)
        has N quaternions. The numbers of a single element return that element. Numbers are copied; with
        ``copy=False`` an array of the ring's float type is shared and must not be changed afterwards. Raises
        :class:`CoercionError` for an array that does not represent elements.

        >>> import numpy as np
        >>> H("GF(7)").from_array(np.array([[1, 2], [0, 6], [0, 0], [5, 0]]))[0]
        1 + 5*k
        >>> H("RDF").from_array(np.array([[1.0, 0.5, 0, 0], [0, 0, 0, 2.0]]), axis=-1)[0]
        1.0 + 0.5*i
        """
        import numpy as np

        check_axis(axis)
        given = np.asarray(values)
        how = self.array_storage
        rows = how.from_array(np.moveaxis(given, axis, 0) if given.ndim else given, copy)
        return from_stored(self, how, rows) if how.shape(rows) else self(*how.single(rows))

    def product(
        self, values: Quaternion[E] | Iterable[object], axis: int | None = None
    ) -> Quaternion[E]:
        """Return the ordered product of an array, or of a list of elements, from left to right.

        An array is multiplied along an axis, or as a whole in order, in a balanced tree of neighbouring
        products.

        >>> H("QQ").product(["i", "j", "k"])
        -1
        """
        if isinstance(values, Quaternion) and values.shape:
            return self(values).product(axis)
        parts = [self(x) for x in values] or [self.basis[0]]
        while len(parts) > 1:  # factors of equal size multiply fastest
            pairs = zip(parts[::2], parts[1::2], strict=False)
            parts = [p * q for p, q in pairs] + parts[len(parts) // 2 * 2 :]
        return parts[0]

    def element_array(self) -> Quaternion:
        """Return all q⁴ elements over a finite ring as one array, in the order of :meth:`elements`.

        Raises :class:`NotFiniteError`, and :class:`TooLargeError` beyond 10⁸ elements.

        >>> p = H("GF(3)").element_array()
        >>> int(p.units().sum()), int((p * p == -1).sum())
        (48, 6)
        """
        if self._order_of_ring() ** 4 > MAX_LISTED_ELEMENTS:
            raise TooLargeError(
                f"{self} has more than 10^8 elements; A.elements() runs through them"
            )
        import numpy as np

        scalars = self(list(self.ring.elements()), 0, 0, 0)
        w, x, y, z = (scalars[n.ravel()] for n in np.indices((len(scalars),) * 4, np.uint32))
        _, i, j, k = self.basis
        return w + x * i + y * j + z * k

    # --- its product, and the same over another ring -------------------------------------------

    def multiplication_table(self) -> tuple[tuple[Quaternion[E], ...], ...]:
        """Return the products of the basis, row times column, in the order e, i, j, k (Table 1.1)."""
        return tuple(tuple(p * q for q in self.basis) for p in self.basis)

    @overload
    def change_ring(self, ring: Ring[L]) -> QuaternionAlgebra[L]: ...
    @overload
    def change_ring(self, ring: object) -> QuaternionAlgebra: ...
    def change_ring(self, ring: RingName) -> QuaternionAlgebra:
        """Return the algebra with the same constants over another ring, which must contain them.

        Raises :class:`CoercionError` where the base ring does not map into the other one.

        >>> H("QQ").change_ring("GF(7)")
        (-1,-1|GF(7))
        """
        L = read_ring(ring)
        a, t, b = map(embedding(self.ring, L), self.constants)
        return QuaternionAlgebra(L, a, b, t)

    def euler(self, sequence: str, angles: Iterable[object]) -> Quaternion[E]:
        """Return the product of rotations about i, j, k by Euler angles, in Hamilton's algebra.

        ``sequence`` consists of the letters XYZ (intrinsic: about the already rotated axes) or xyz
        (extrinsic), one for each angle. Angles are symbols, texts such as ``"2*t + pi/2"``, or multiples of
        π. The ring must have cosines and sines of the half angles. ``.rotation_matrix()`` of the result is
        the matrix.

        Raises :class:`CoercionError` for an invalid sequence, and if the ring lacks these cosines.

        >>> A = H("QQ(cos(t/2),sin(t/2))")
        >>> A.euler("Z", ["t"]), A.euler("ZX", ["pi", "t"])
        (cos(t/2) + sin(t/2)*k, sin(t/2)*j + cos(t/2)*k)
        """
        found = list(angles)
        case = sequence in (sequence.upper(), sequence.lower())
        if (
            not sequence
            or not case
            or {*sequence.lower()} - {*"xyz"}
            or len(found) != len(sequence)
        ):
            raise CoercionError(
                f"expected letters such as 'ZYX' or 'zyx' and one angle for each, not {shorten(sequence)!r} "
                f"and {len(found)} angles"
            )
        if not is_hamilton(*self._here()):
            raise CoercionError(
                f"Euler angles are of rotations, in Hamilton's algebra; this is {self}"
            )
        turns = []
        for letter, angle in zip(sequence.lower(), found, strict=True):
            cosine, sine = self.ring.cosine_and_sine_of(angle, 2)
            turns.append(self.scalar(cosine) + self.basis[1 + "xyz".index(letter)] * sine)
        return self.product(turns if sequence.isupper() else turns[::-1])

    # --- variables -----------------------------------------------------------------------------

    def _substituted(
        self, values: Mapping[str, object]
    ) -> tuple[QuaternionAlgebra, Callable[[E], Scalar]]:
        """Return the algebra with values substituted in its constants, and the map of scalars."""
        ring, value = substitution(self.ring, values)
        a, t, b = map(value, self.constants)
        return QuaternionAlgebra(ring, a, b, t), value

    def subs(self, values: Substitution | None = None, /, **named: object) -> QuaternionAlgebra:
        """Return the algebra with values substituted for variables of its constants, as
        :meth:`Quaternion.subs`.

        >>> QuaternionAlgebra("QQ(a,b)", "a", "b").subs(a=-1, b=-3)
        (-1,-3|QQ)
        """
        return self._substituted(values_given(values, named))[0]

    def unknowns(self, names: str) -> Quaternion | tuple[Quaternion[E], ...]:
        """Return a quaternion with unknown coordinates p0 … p3 for each name; a single name returns one
        element.

        The result lies in the algebra over the ring of polynomials in the coordinates of all names given to
        this algebra so far. Elements of this algebra and earlier unknowns are converted to it automatically.
        Over fields of functions the coordinates are variables of the field. Raises :class:`RingError` for an
        invalid name, and over rings without such polynomials.

        >>> A = H("QQ"); e, i, j, k = A.basis
        >>> p, q = A.unknowns("p q")
        >>> (p*q).norm() == p.norm()*q.norm(), i*p*i - j*q == i*(p*i) - j*q, p*q == q*p
        (True, True, False)
        """
        wanted = tuple(names.replace(",", " ").split()) if isinstance(names, str) else ()
        if not wanted or len({*wanted}) < len(wanted):
            raise RingError(
                f"{shorten(repr(names))}: expected different names of unknowns, as in unknowns('p q')"
            )
        base = self._base or self
        fresh = [name for name in wanted if name not in base._unknowns]
        if fresh:
            base._join_unknowns(fresh)
        found = tuple(base._unknowns[name] for name in wanted)
        return found if len(found) > 1 else found[0]

    def _join_unknowns(self, fresh: Iterable[str]) -> None:
        joined = self._with_unknowns_named((*self._unknowns, *fresh))
        known = joined.ring.names()
        for name in fresh:
            self._unknowns[name] = joined(*(known[f"{name}{n}"] for n in range(4)))

    def _with_unknowns_named(self, names: tuple[str, ...]) -> QuaternionAlgebra:
        """Return the algebra in which the quaternions with these names have unknown coordinates."""
        if names not in self._with_unknowns:
            variables = tuple(f"{name}{n}" for name in names for n in range(4))
            ring = adjoin_variables(self.ring, variables)
            a, t, b = map(self._into(ring), self.constants)
            found = QuaternionAlgebra(ring, a, b, t)
            found._base, found._names = self, names
            self._with_unknowns[names] = found
        return self._with_unknowns[names]

    def _into(self, ring: Ring) -> Callable[[E], Scalar]:
        """Return the map of scalars into a ring with more variables."""
        if not self.ring.variables:
            return ring
        return self.ring.evaluation(ring, ring.names(), embedding)

    def _common(self, other: Parent) -> QuaternionAlgebra | None:
        """Return the algebra of unknowns that contains both algebras, or None if they have
        different bases.
        """
        if not isinstance(other, QuaternionAlgebra) or (self._base is None and other._base is None):
            return None
        base = self._base or self
        if base != (other._base or other):
            return None
        names = tuple(dict.fromkeys((*self._names, *other._names)))
        if names in (self._names, other._names):
            return self if names == self._names else other
        return base._with_unknowns_named(names)

    def _include(self, q: Quaternion) -> Quaternion[E]:
        """Convert an element of the algebra with fewer or none of these unknowns to this algebra."""
        A = q.algebra
        assert isinstance(A, QuaternionAlgebra), "there is a common algebra"
        return q if self == A else self(*map(A._into(self.ring), q.coordinates))

    def explain_product(self) -> None:
        """Print the function that multiplies two elements: the general formula with this algebra's constants.

        >>> QuaternionAlgebra("GF(7)", -1, -3).explain_product()
        # Storage of elements over ℤ/n as four ints between 0 and n − 1, of flint for large n.
        # b = 4, n = 7
        def product(p, q):
            w1, x1, y1, z1 = p
            w2, x2, y2, z2 = q
            w = w1*w2 - x1*x2 + b*(y1*y2 + z1*z2)
            x = w1*x2 + x1*w2 + b*(z1*y2 - y1*z2)
            y = w1*y2 + y1*w2 - (x1*z2 - z1*x2)
            z = w1*z2 + z1*w2 + x1*y2 - y1*x2
            return w % n, x % n, y % n, z % n
        """
        print(self.storage.explain("product"))

    # --- linear algebra ------------------------------------------------------------------------

    def center(self) -> tuple[Quaternion[E], ...]:
        """Return a basis of the centre, e first, found by linear algebra in the base ring (thesis 1.1.2).

        If the centre is not free over the ring, the result is an irredundant list of generators: every
        central element is a combination of them, with coefficients that are not unique. Over ℤ/n the centre
        is the direct sum of the cyclic modules that they generate. Raises :class:`UndecidedError` over
        infinite rings that are not domains, and over user-defined rings if elimination finds no unit pivots.

        >>> H("QQ").center(), H("ZZ/4").center()
        ((1,), (1, 2*i, 2*j, 2*k))
        """
        return tuple(self(*c) for c in structure.centre(*self._here()))

    centre = center

    def is_commutative(self) -> bool:
        """Return whether p·q = q·p for all p and q; for H(F) if and only if 2 = 0 in F (thesis 1.1.2)."""
        return structure.is_commutative(*self._here())

    def radical(self) -> tuple[Quaternion[E], ...]:
        """Return a basis of the Jacobson radical; () if it is 0, as for a semisimple algebra over a field.

        If the radical is not free over the ring, the result is a list of generators, as in :meth:`center`.
        Raises :class:`UndecidedError` over infinite rings other than fields, ℤ and polynomial rings; over
        finite rings, other than ℤ/n, that are too large to enumerate; and over ℤ/n if n cannot be factored.

        >>> H("GF(2)").radical(), H("ZZ/9").radical()
        ((1 + i, 1 + j, 1 + k), (3, 3*i, 3*j, 3*k))
        """
        return tuple(self(*c) for c in structure.radical(*self._here()))

    def quotient(self, elements: Iterable[object]) -> AlgebraQuotient:
        """Return the quotient by the two-sided ideal generated by elements, over a field, and the map to it.

        The quotient is a :class:`StructureAlgebra`. Its basis consists of the images of those of e, i, j, k
        that are independent of the earlier ones. ``projection(q)`` is the image of q, and
        ``projection.lift(x)`` an element with image x. Raises :class:`RingError` over a ring that is not a
        field, :class:`CoercionError` if the quotient is 0.

        >>> A = QuaternionAlgebra("GF(3)", -1, 0)
        >>> B, phi = A.quotient(A.radical()); A.radical(), B.basis, phi("1 + i + j"), B("i")**2
        ((j, k), (e, i), e + i, -e)
        """
        from hfield.algebra.quotients import quotient

        return quotient(self, elements)

    def is_central_simple(self) -> bool:
        """Return whether the algebra is central simple; over a field, whether ``(t² + 4a)·b ≠ 0``."""
        return structure.is_central_simple(*self._here())

    def derivations(self) -> tuple[LinearMap[E], ...]:
        """Return a basis of the derivations, the linear maps with D(pq) = D(p)·q + p·D(q).

        A central simple algebra has only the inner derivations ``q ↦ xq − qx``, a space of dimension 3. If
        they are not free over the ring, the result is a list of generators, as in :meth:`center`.
        """
        from hfield.algebra.maps import LinearMap

        matrices = structure.derivations(*self._here())
        return tuple(LinearMap(self, self, list(zip(*m, strict=True))) for m in matrices)

    def opposite(self) -> Opposite[E]:
        """Return the opposite algebra and an isomorphism with it.

        It has the same constants: the linear map that fixes i and j and sends k = ij to ji reverses products.
        (Conjugation is another such map.)

        >>> B, phi = H("QQ").opposite()
        >>> e, i, j, k = B.basis
        >>> phi(i*j) == phi(j)*phi(i)
        True
        """
        from hfield.algebra.maps import Isomorphism

        images = [structure.to_opposite(self.constants, q.coordinates) for q in self.basis]
        return Opposite(self, Isomorphism(self, self, images, reverses=True))

    # --- division or splitting -----------------------------------------------------------------

    # ``factors`` may contain primes of the constants (over ℚ) or of their norms, if these are too
    # hard to factor; each is proved prime, or :class:`RingError` is raised.

    def zero_norm_element(self, factors: Factors | None = None) -> Quaternion[E] | None:
        """Return a nonzero element of norm 0, or None if it is proved that there is none.

        Raises :class:`UndecidedError` if neither is known; the message lists the methods that were tried.
        """
        with known_primes(factors):
            found = quadratic_forms.zero_norm(*self._here()).element
        return None if found is None else self(*found)

    def is_division_algebra(self, factors: Factors | None = None) -> bool:
        """Return whether every nonzero element is invertible. Raises :class:`UndecidedError`."""
        with known_primes(factors):
            return quadratic_forms.is_division(*self._here())

    def division_or_splitting(self, factors: Factors | None = None) -> Splitting[E] | Division:
        """Return an isomorphism with M₂(F), or the reason why the algebra is a division algebra.

        The isomorphism is true in an ``if``, the reason is false. Raises :class:`CoercionError` for a
        degenerate algebra, for which there is neither, and :class:`UndecidedError`.
        """
        with known_primes(factors):
            return self._split_or_not

    @cached_property
    def _split_or_not(self) -> Splitting[E] | Division:
        from hfield.algebra.maps import Division, Splitting
        from hfield.fields.quadratic_forms.isomorphisms.splitting import (
            CoordinateSplitting as Found,
        )

        if not self.ring.is_exact:
            raise UndecidedError(
                f"{self.ring} is inexact, so splitting is not decided: use {self.ring.exact_ring}"
            )
        answer = quadratic_forms.division_or_splitting(*self._here())
        if isinstance(answer, Found):
            return Splitting.of(self, answer)
        return Division.of(self, answer)

    def split(self, factors: Factors | None = None) -> Splitting[E] | None:
        """Return an isomorphism with M₂(F), or None for a division algebra; errors as
        :meth:`division_or_splitting`.

        >>> I, J = H("GF(3)").split()
        """
        from hfield.algebra.maps import Splitting

        answer = self.division_or_splitting(factors)
        return answer if isinstance(answer, Splitting) else None

    @cached_property
    def _numeric_splitting(self) -> Splitting[E]:
        """The splitting from a rounded square root of a."""
        from hfield.algebra.maps import Splitting
        from hfield.fields.quadratic_forms.isomorphisms.splitting import CoordinateSplitting

        found = quadratic_forms.division_or_splitting(*self._here())
        assert isinstance(found, CoordinateSplitting), "CDF has all square roots"
        return Splitting.of(self, found)

    def _splitting(self) -> Splitting[E]:
        if self.ring == CDF:  # matrices of floats are computed, but decide nothing
            return self._numeric_splitting
        answer = self.split()
        if answer is None:
            raise CoercionError(
                f"{self} has no matrices over {self.ring}, for it is a division algebra: "
                f"{self._split_or_not.reason}"
            )
        return answer

    def from_polar(self, modulus: object, axis: object, angle: object) -> Quaternion:
        """Return ``modulus·(cos(angle) + axis·sin(angle))``, the angle in radians (thesis 1.4.4).

        The axis is an element with square −1, or its three coordinates; over RDF all may be arrays. Raises
        :class:`CoercionError` for another axis, and :class:`RingError` over rings without cosines.

        >>> A = H("RR")
        >>> A.from_polar(2, (0, 0, 1), "pi/6")
        sqrt(3) + k
        """
        if isinstance(axis, (tuple, list)) and len(axis) == 3:
            axis = self(0, *axis)
        n: Quaternion = self.scalar(0) + axis  # an array, perhaps
        off = n * n + 1
        fits = off.is_zero() if self.ring.is_exact else abs(off) < 1e-9
        if not (fits.all() if n.is_batch else fits):
            raise CoercionError(
                f"the square of the axis {shorten(n)} is not −1: divide it by its modulus"
            )
        cos, sin = analysis.cosine_and_sine(self.ring, angle)
        return (n * sin + cos) * modulus

    def to_matrix(self, q: object) -> tuple[tuple[E, E], tuple[E, E]]:
        """Return the 2 × 2 matrix of q under :meth:`split`. Raises CoercionError if there is none."""
        return self._splitting().to_matrix(q)

    def from_matrix(self, matrix: Sequence[Sequence[object]]) -> Quaternion[E]:
        """Return the element of a 2 × 2 matrix under :meth:`split`. Raises CoercionError if none."""
        return self._splitting().from_matrix(matrix)

    # --- ramification --------------------------------------------------------------------------

    def ramified_places(self, factors: Factors | None = None) -> tuple[Hashable, ...]:
        """Return the places where the algebra stays a division algebra, finite ones first.

        Raises :class:`RingError` for a degenerate algebra, and :class:`UndecidedError` over a field without a
        theory of places.
        """
        return quadratic_forms.ramified_places(self.ring, self.constants, factors)

    def discriminant(self, factors: Factors | None = None) -> Any:  # by the field
        """Return the product of the finite ramified places: an int over ℚ, a polynomial over k(t).

        Over a quadratic field it is an ideal, returned as the tuple of its prime ideals.
        """
        return quadratic_forms.reduced_discriminant(*self._here(), factors)

    # --- isomorphism ---------------------------------------------------------------------------

    def _comparable(self, other: object) -> Constants:
        if not isinstance(other, QuaternionAlgebra):
            raise CoercionError(
                f"{shorten(repr(other))} is not a quaternion algebra to compare {self} with; "
                "expected one, such as QuaternionAlgebra.from_text('(-1,-3|QQ)')"
            )
        if other.ring != self.ring:
            raise MixedParentsError(
                f"{self} is over {self.ring} and {other} over {other.ring}: algebras are compared over "
                "one field; use A.change_ring(L) first"
            )
        return other.constants

    def is_isomorphic(self, other: object, factors: Factors | None = None) -> bool:
        """Return whether two algebras over the same field are isomorphic.

        Raises :class:`MixedParentsError` for different fields, and :class:`UndecidedError`.
        """
        with known_primes(factors):
            return quadratic_forms.is_isomorphic(*self._here(), self._comparable(other))

    def isomorphism(
        self, other: Parent[E], factors: Factors | None = None
    ) -> Isomorphism[E] | None:
        """Return an isomorphism onto ``other``, a callable, or None if there is none.

        The relations and the determinant are checked. Raises as :meth:`is_isomorphic` does.
        """
        from hfield.algebra.maps import Isomorphism

        with known_primes(factors):
            found = quadratic_forms.isomorphism(*self._here(), self._comparable(other))
        return None if found is None else Isomorphism(self, other, found.images)

    # --- finite fields -------------------------------------------------------------------------

    def count(self, kind: str = "elements", *, norm: object = None, square: object = None) -> int:
        """Return the number of elements of a kind, over a finite ring.

        ``kind`` is ``elements``, ``units``, ``nilpotent`` or ``idempotent``; ``norm=n`` counts the elements
        of norm n, and ``square=s`` those with square s. Over finite fields and ℤ/n closed formulas are used
        (:func:`hfield.algebra.structure.confirm` checks them), over other finite rings enumeration. Raises
        :class:`NotFiniteError`, :class:`CoercionError` for an unknown kind, :class:`UndecidedError` over ℤ/n
        if n cannot be factored, and :class:`TooLargeError` if there are too many elements to enumerate.

        >>> A = H("GF(9)"); A.count(norm=0), A.count("idempotent"), A.count(square=-1)
        (801, 92, 92)
        >>> H("ZZ/1000").count(norm=0)
        299600000
        """
        if sum((kind != "elements", norm is not None, square is not None)) > 1:
            raise CoercionError("count one thing at a time: a kind, or norm=…, or square=…")
        ring, c = self._here()
        value = square if norm is None else norm
        if value is not None:
            kind = "norm" if square is None else "square roots"
        chosen = counted_kind(kind)
        if chosen.needs and value is None:
            raise CoercionError(f"say which {kind}: A.count({chosen.needs})")
        if ring.order is not None and not structure.has_formulas(ring):
            text = ring.text(ring(value)) if chosen.needs else ""
            return structure.tally(ring, c).number(chosen.name, text)
        return structure.count(ring, c, chosen.name, value).value

    # --- exploring: its elements, groups, ideals: the package is imported on use ----------------

    def _collection(self, name: str, value: Scalar | None = None) -> Elements:
        from hfield.exploring.elements import Elements
        from hfield.exploring.properties import Condition

        return Elements(self, Condition(name, value))

    def units(self) -> Elements:
        """Return the collection of units, with ``len``, ``in``, iteration, ``.array()`` and ``.formula``.

        Over an infinite field ``.condition`` describes the collection and ``.sample(n)`` draws random
        elements.

        >>> S = H("GF(3)").units()
        >>> len(S), S.formula, H("GF(3)")(1, 1, 0, 0) in S, next(iter(S))
        (48, 'q^4-q^3-q^2+q', True, k)
        """
        return self._collection("units")

    def zero_divisors(self) -> Elements:
        """Return the collection of zero divisors, including 0, as :meth:`units` does.

        >>> S = H("GF(7)").zero_divisors(); len(S), S.formula, S[1]
        (385, 'q^3+q^2-q', i + 2*j + 3*k)
        """
        return self._collection("zero divisors")

    def idempotents(self) -> Elements:
        """Return the collection of all q with q² = q, including 0 and 1, as :meth:`units` does.

        >>> len(H("GF(3)").idempotents()), list(H("ZZ/6").idempotents())[:3]
        (14, [0, 1, 2 + 2*j + 2*k])
        """
        return self._collection("idempotents")

    def nilpotents(self) -> Elements:
        """Return the collection of nilpotent elements, as :meth:`units` does.

        >>> list(H("GF(2)").nilpotents())[:4]
        [0, j + k, i + k, i + j]
        """
        return self._collection("nilpotents")

    def elements_of_norm(self, n: object) -> Elements:
        """Return the collection of elements of norm n, as :meth:`units` does.

        >>> len(H("GF(3)").elements_of_norm(1)), H("QQ").elements_of_norm(2).condition
        (24, 'norm(q) == 2')
        """
        from hfield.exploring.elements import check_scalar

        return self._collection("norm", check_scalar(self, n))

    def elements_of_trace(self, s: object) -> Elements:
        """Return the collection of elements of trace s, as :meth:`units` does.

        >>> len(H("GF(3)").elements_of_trace(1)), len(H("GF(2)").elements_of_trace(1))
        (27, 0)
        """
        from hfield.exploring.elements import check_scalar

        return self._collection("trace", check_scalar(self, s))

    def unit_group(self) -> FiniteUnitGroup:
        """Return the group of units over a finite ring: order, structure, centre, generators, classes.

        Raises :class:`NotFiniteError` over an infinite ring.

        >>> G = H("GF(3)").unit_group()
        >>> G.order, G.structure, G.exponent, G.generators, len(G.conjugacy_classes)
        (48, 'GL(2,3)', 24, (j + k, 1 + 2*i + 2*j + 2*k), 8)
        """
        from hfield.exploring.unit_groups import unit_group

        return unit_group(self)

    def special_unit_group(self) -> FiniteUnitGroup:
        """Return the group of elements of norm 1 over a finite ring, as :meth:`unit_group` does.

        ``maximal_order().norm_one_group()`` of an indefinite order is taken modulo ±1; this group is not.

        >>> H("GF(3)").special_unit_group().structure
        'SL(2,3)'
        """
        from hfield.exploring.unit_groups import unit_group

        return unit_group(self, special=True)

    def conjugacy_classes(self) -> tuple[ConjugacyClass, ...]:
        """Return the conjugacy classes of all elements under the units, over a finite ring.

        In a split algebra they are the single scalars, and one class of nonscalar elements for each
        characteristic polynomial. Raises :class:`NotFiniteError` over an infinite ring,
        :class:`TooLargeError`.

        >>> [len(c) for c in H("GF(3)").conjugacy_classes()]
        [1, 1, 1, 8, 6, 12, 12, 8, 6, 12, 8, 6]
        """
        from hfield.exploring.conjugacy_classes import conjugacy_classes, split_classes

        if self.ring.order is not None and self.is_central_simple():
            return split_classes(self)
        return conjugacy_classes(self, self.unit_group().generators)

    def automorphism_group(self) -> AutomorphismGroup:
        """Return the group of automorphisms that fix the scalars, as maps, over a finite ring.

        Raises :class:`NotFiniteError` over an infinite ring, :class:`TooLargeError`.

        >>> G = H("GF(2)").automorphism_group(); G.order, G.structure, len(G.generators)
        (24, 'S4', 2)
        """
        from hfield.exploring.automorphisms import AutomorphismGroup

        return AutomorphismGroup(self)

    def left_ideals(self) -> tuple[AlgebraIdeal, ...]:
        """Return all left ideals over a finite field or ℤ/n, by size, from 0 to the whole algebra.

        In a split algebra over GF(q) there are q + 1 proper nonzero ones, the points of a projective line.
        Over ℤ/n they are computed modulo the prime powers of n. Over an infinite field a division algebra has
        the ideals 0 and itself; other algebras raise :class:`NotFiniteError`. Raises :class:`RingError` over
        other rings, and :class:`TooLargeError`.

        >>> [I.dimension for I in H("GF(3)").left_ideals()], len(H("QQ").left_ideals())
        ([0, 2, 2, 2, 2, 4], 2)
        >>> [I.cardinality() for I in H("ZZ/4").left_ideals()]
        [1, 2, 4, 4, 4, 8, 16, 16, 16, 32, 64, 64, 64, 128, 256]
        """
        from hfield.exploring.ideals import ideals

        return ideals(self, "left")

    def right_ideals(self) -> tuple[AlgebraIdeal, ...]:
        """Return all right ideals over a finite field or ℤ/n, as :meth:`left_ideals` does.

        >>> I, J = H("GF(2)").right_ideals()[1:3]; I < J, I.generator, J.basis
        (True, 1 + i + j + k, (1 + i, j + k))
        """
        from hfield.exploring.ideals import ideals

        return ideals(self, "right")

    def two_sided_ideals(self) -> tuple[AlgebraIdeal, ...]:
        """Return all two-sided ideals, as :meth:`left_ideals` does; a central simple algebra has 0 and
        itself.

        >>> len(H("QQ").two_sided_ideals()), len(H("GF(2)").two_sided_ideals())
        (2, 7)
        """
        from hfield.exploring.ideals import ideals

        return ideals(self, "two-sided")

    def subalgebras(self, dimension: int = 2) -> tuple[Subalgebra, ...]:
        """Return the subalgebras that contain 1, over a finite field or ℤ/n, up to conjugation by units.

        ``dimension`` is the dimension over the field; over ℤ/n it is the least number of generators as a
        module. Raises :class:`NotFiniteError`, :class:`RingError` over other rings, :class:`TooLargeError`,
        and :class:`CoercionError` unless the dimension is between 1 and 4.

        >>> [(S.kind, len(S.conjugates)) for S in H("GF(5)").subalgebras(dimension=2)]
        [('split', 15), ('field', 10), ('dual numbers', 6)]
        """
        from hfield.exploring.subalgebras import subalgebras

        return subalgebras(self, dimension)

    def is_simple(self) -> bool:
        """Return whether 0 and the algebra are the only two-sided ideals.

        Over a field this is equivalent to :meth:`is_semisimple`: a degenerate algebra has a nonzero radical,
        or it is a purely inseparable field extension of degree 4. Over a ring that is not a field no algebra
        is simple, because the ideals of the ring give two-sided ideals.

        >>> H("GF(3)").is_simple(), H("GF(2)").is_simple(), H("ZZ/6").is_simple()
        (True, False, False)
        """
        if structure.is_central_simple(*self._here()):
            return True
        return bool(self.ring.is_field) and not structure.radical(*self._here())

    def is_semisimple(self) -> bool:
        """Return whether every left ideal is a direct summand. Raises :class:`UndecidedError`.

        >>> H("GF(3)").is_semisimple(), H("GF(2)").is_semisimple(), H("ZZ/15").is_semisimple()
        (True, False, True)
        """
        return structure.is_semisimple(*self._here())

    def is_local(self) -> bool:
        """Return whether the elements that are not units form an ideal. Raises :class:`UndecidedError`.

        >>> H("QQ").is_local(), H("GF(3)").is_local(), H("GF(2)").is_local(), H("ZZ/8").is_local()
        (True, False, True, True)
        """
        return structure.is_local(*self._here())

    def graph(self, kind: str) -> list[tuple[Quaternion, Quaternion]]:
        """Return the edges of a graph on the nonzero elements over a finite ring, for networkx.

        In the ``"commuting"`` graph p and q are joined if ``p·q = q·p``, in the ``"zero-divisors"`` graph if
        ``p·q = 0`` or ``q·p = 0``. Raises :class:`CoercionError` for another kind, :class:`NotFiniteError`,
        and :class:`TooLargeError` beyond 2500 elements.

        >>> edges = H("GF(2)").graph("zero-divisors"); len(edges), edges[0]
        (9, (j + k, 1 + i))
        """
        from hfield.exploring.graphs import edges

        return edges(self, kind)

    def draw(self, path: object, *, what: str = "product", dark: bool = False) -> None:
        """Draw a picture of the algebra over a finite ring to a .svg, .png or .pdf file.

        ``what`` is ``"product"``, the table of all products as coloured squares, with rows and columns sorted
        by norm; ``"norm"``, the norms of all elements; ``"ideals"``, a Hasse diagram of the left ideals (also
        ``"right-ideals"`` and ``"two-sided-ideals"``); or a graph, ``"commuting"`` or ``"zero-divisors"``.

        >>> import tempfile, os
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     H("GF(2)").draw(os.path.join(folder, "ideals.svg"), what="ideals", dark=True)

        Raises :class:`CoercionError` for an unknown picture, :class:`NotFiniteError`, :class:`TooLargeError`
        if the picture would be too large to read, and ``OSError`` if the file cannot be written.
        """
        from hfield.exploring.pictures import draw

        draw(self, path, what, dark)

    # --- the Brauer group --------------------------------------------------------------------------

    def tensor(self, other: QuaternionAlgebra) -> TensorProduct:
        """Return ``A ⊗ B``: ``.brauer_class``, ``.index`` (1, 2 or 4) with ``.reason``, ``.common_slot``.

        Raises :class:`MixedParentsError` for different fields, :class:`CoercionError` for degenerate
        algebras.

        >>> T = H("QQ").tensor(QuaternionAlgebra(-1, -3))
        >>> T.brauer_class, T.index, T.common_slot
        ((2, 3), 2, (-1, k, i))
        """
        from hfield.algebra.brauer import TensorProduct

        if not isinstance(other, QuaternionAlgebra):
            raise CoercionError(f"expected an algebra over {self.ring}, found {shorten(other)}")
        return TensorProduct(self, other)

    def corestriction(self, base: Ring | str = "QQ") -> Corestriction:
        """Return the corestriction to a subfield: ``.algebra``, ``.brauer_class``, and the places ``.above``.

        It ramifies at the places of the base that lie below an odd number of ramified places. Raises
        :class:`RingError` for fields of another kind, :class:`CoercionError` for a base that is not a
        subfield.

        >>> found = QuaternionAlgebra("QQ(sqrt(3))", -1, "1 + sqrt(3)").corestriction()
        >>> found.algebra, found.above
        ((-1,-2|QQ), {2: ((2, 1+sqrt(3)),), 'inf': (inf-,)})
        """
        from hfield.algebra.brauer import corestriction

        return corestriction(self, base if isinstance(base, Ring) else read_ring(base))

    def embed(self, extension: object) -> Embedding:
        """Return an embedding of a quadratic extension: true with ``.element``, or false with ``.place``.

        ``extension`` is d for F(√d), a field, or a polynomial such as ``"x^2+x+3"``; ``.element`` is a root
        of x² − d or of the polynomial. In characteristic 2, x² − d is inseparable. Raises :class:`RingError`
        for anything but a quadratic extension, and :class:`UndecidedError`.

        >>> A = QuaternionAlgebra(-1, -3)
        >>> A.embed(-7).element ** 2, A.embed(7).place, A.embed("QQ(zeta3)").element
        (-7, 3, -1/2 + 1/2*j)
        >>> B = QuaternionAlgebra.from_text("[1,t|GF(2)(t))")
        >>> x = B.embed("y^2 + y + (t+1)/t").element; x*x + x
        (t+1)/t
        """
        from hfield.algebra.quadratic_fields import embed

        return embed(self, extension)

    # --- matrices and equations, imported on first use ---------------------------------

    def matrix(self, rows: Iterable[Iterable[object]] | Quaternion | str) -> Matrix:
        """Return the matrix with these rows of elements, or the matrix of a text. Raises
        :class:`CoercionError`.

        In an array of quaternions the last two axes are rows and columns; the others index an array of
        matrices.

        >>> H("GF(3)").matrix([["1", "i"], ["j", "1"]]).rank()
        2
        >>> H("QQ").matrix("inv([[1, i], [j, k]])"), H("QQ").matrix("[[1, i], [j, k]] * [[2], [comm(i, j)]]")
        ([[1/2, -1/2*j], [-1/2*i, -1/2*k]], [[2 - 2*j], [-2 + 2*j]])
        """
        if isinstance(rows, str):
            from hfield.matrices.texts import read_matrix

            return read_matrix(self, rows)
        from hfield.matrices.matrix import Matrix

        return Matrix(self, rows)

    def polynomials(self, variable: str = "x") -> Polynomials:
        """Return the polynomials over the algebra in a central variable, coefficients on the left.

        >>> A = H("RR"); e, i, j, k = A.basis
        >>> P = A.polynomials("x"); f = P([1, i, 1])
        >>> f, len(f.roots().isolated), all(not f(q) for q in f.roots().isolated)
        (x^2 + i*x + 1, 2, True)

        Raises :class:`RingError` for an invalid name.
        """
        from hfield.polynomials.polynomial import Polynomials

        if not (isinstance(variable, str) and variable.isidentifier()):
            raise RingError(f"{shorten(variable)!r} is not the name of a variable such as x")
        return Polynomials(self, variable)

    def sylvester(self, a: object, b: object, c: object) -> LinearSolutions:
        """Return all x with ``a·x − x·b = c``: ``.particular`` and ``.kernel``; if there is none, false with
        ``.reason``.

        >>> A = H("QQ"); e, i, j, k = A.basis
        >>> found = A.sylvester(i, j, i - j)
        >>> i*found.particular - found.particular*j == i - j, found.kernel
        (True, (i + j, -1 + k))
        >>> A.sylvester(i, j, k).reason
        '(-1, 0, 0, 1) times the coordinates of the left side is 0 for every x, but 1 for c = k'
        """
        from hfield.matrices.equations import solve_linear

        return solve_linear(self, [(a, 1), (-self(1), b)], c)

    def solve_linear(self, terms: Iterable[tuple[object, object]], c: object) -> LinearSolutions:
        """Return all x with ``Σ aₙ·x·bₙ = c`` for pairs (aₙ, bₙ), as :meth:`sylvester` does.

        >>> A = H("GF(3)"); e, i, j, k = A.basis
        >>> found = A.solve_linear([(i, j), (j, i)], k)     # i·x·j + j·x·i = k
        >>> bool(found), len(found.kernel)
        (False, 2)
        """
        from hfield.matrices.equations import solve_linear

        return solve_linear(self, list(terms), c)

    def solve(self, *equations: str, unknowns: str | None = None) -> SystemSolutions:
        """Return all solutions of equations that are linear over the field, by the names of the unknowns.

        The result has ``.particular`` and ``.kernel``; if there is no solution it is false, with ``.reason``.
        ``unknowns``, such as ``"x, y"``, are by default those letters from p to z that have no other meaning.
        ``conj``, ``trace``, ``scalar`` and ``vector`` of an unknown count as linear. Raises
        :class:`NotationError`.

        >>> found = H("QQ").solve("i*x + y = j", "x - y*i = 0")
        >>> found.particular, found.kernel[0], bool(H("QQ").solve("i*x + y = j", "x - y*i = 1"))
        ({'x': -1/2*k, 'y': 1/2*j}, {'x': i, 'y': 1}, False)
        """
        from hfield.matrices.equations import read_system, unknowns_in

        names = unknowns_in(self, equations) if unknowns is None else unknowns.split(",")
        return read_system(self, equations, [x.strip() for x in names])

    # --- lattices and orders, imported on first use ------------------------------------

    @property
    def is_over_number_field(self) -> bool:
        """Whether the base is a number field other than ℚ; then orders are over its ring of integers.

        >>> H("QQ").is_over_number_field, H("QQ(sqrt(2))").is_over_number_field
        (False, True)
        """
        return isinstance(self.ring, WithIntegers) and self.ring != QQ

    def lattice(self, elements: Iterable[object]) -> Lattice:
        """Return the lattice spanned by elements over ℤ, or over the ring of integers of a number field.

        Pairs (ideal, element), as in a pseudo-basis, are also accepted. Raises :class:`LatticeError` if the
        rank is below 4, :class:`RingError` over another field.
        """
        from hfield.orders.lattice import Lattice

        return Lattice.spanned(self, elements)

    def order(self, elements: Iterable[object]) -> Order:
        """Return the order generated by elements as a ring, over ℤ or the integers of a number field.

        Raises :class:`LatticeError` if the ring they generate has lower rank, or is not a lattice.

        >>> O = QuaternionAlgebra("QQ(sqrt(10))", -1, -1).order(["i", "j"])
        >>> O.discriminant(), O.maximal_overorder().index(O)
        (ideal(4), ideal(4))
        """
        from hfield.orders.lattice import Order

        return Order.generated(self, elements)

    def order_from_basis(self, elements: Iterable[object]) -> Order:
        """Return the order with a basis of four elements; over ℤ_K, the order spanned by elements or a
        pseudo-basis.

        Raises :class:`LatticeError` unless they span a ring with 1.
        """
        from hfield.orders.lattice import Order

        return Order.from_basis(self, elements)

    def maximal_order(self, factors: Factors | None = None) -> Order:
        """Return a maximal order of a nondegenerate algebra; always the same one for the same algebra.

        Over ℚ it is an order over ℤ. Over another number field it is an order over the ring of integers, with
        ``basis`` over ℤ, ``pseudo_basis()`` and ``discriminant()``.

        >>> from hfield import QuaternionAlgebra
        >>> O = QuaternionAlgebra("QQ(sqrt(5))", -1, -1).maximal_order()
        >>> O.discriminant(), len(O.basis)
        (ideal(1), 8)
        """
        from hfield.orders import standard_orders
        from hfield.orders.lattice import Order

        with known_primes(factors):
            return Order(standard_orders.maximal_order(self))

    def eichler_order(self, level: object, factors: Factors | None = None) -> Order:
        """Return an Eichler order of the given level; always the same one for the same algebra and level.

        Over a number field the level is a number, an ideal, or pairs (prime ideal, exponent).
        Raises :class:`LatticeError` for a level that is not prime to the discriminant.

        >>> A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1); P, Q = A.ring.primes_above(31)
        >>> O = A.eichler_order([(P, 2), (Q, 1)])
        >>> O.norm_of_discriminant() == 31**3, O.local_index(P)
        (True, 2)
        """
        from hfield.orders import standard_orders
        from hfield.orders.lattice import Order

        with known_primes(factors):
            return Order(standard_orders.eichler_order(self, level))

    def extremal_order(self, q: int | None = None) -> Order:
        """Return the maximal order with anticommuting roots of −q and −p, for a prime discriminant p.

        KLPT starts from such a p-extremal order. For a prime q > 2 there are two up to isomorphism
        (Ibukiyama, 1982). This method returns the one that contains (1 + √−p)/2 if p ≡ 3 modulo 4, as in
        SQIsign, and the one that contains (1 + √−q)/2 if p ≡ 1 modulo 4. By default q = 1 for p ≡ 3 modulo 4,
        q = 2 for p ≡ 5 modulo 8, and otherwise q is the least admissible one with q ≡ 3 modulo 4. A composite
        q leaves a choice at each of its prime factors; one of these orders is returned. Raises
        :class:`LatticeError` for an indefinite algebra, a composite discriminant, or an inadmissible q, with
        the reason.

        >>> A = QuaternionAlgebra(419); O = A.extremal_order(13)
        >>> O.is_maximal(), len(O.embeddings(-52)), O.is_isomorphic(A.extremal_order())
        (True, 2, False)
        """
        from hfield.orders.lattice import Order
        from hfield.orders.standard_orders import extremal_order

        return Order(extremal_order(self, q))

    def lipschitz_order(self) -> Order:
        """Return the order ``ℤ⟨e, i, j, k⟩``, for integer constants over ℚ."""
        from hfield.orders.lattice import Order
        from hfield.orders.standard_orders import lipschitz_order

        return Order(lipschitz_order(self))

    def hurwitz_order(self) -> HurwitzOrder:
        """Return ``ℤ⟨e, i, j, (e+i+j+k)/2⟩`` in (−1,−1|ℚ). Raises :class:`CoercionError` elsewhere."""
        from hfield.orders.hurwitz_order import HurwitzOrder
        from hfield.orders.standard_orders import hurwitz_order

        return HurwitzOrder(hurwitz_order(self))

    def read(self, text: str) -> Value:
        """Read an element, lattice, order or ideal written by another system, or a list of these.

        It reads the output of ``text_for`` for elements, lattices, orders, ideals and class sets; orders and
        fractional ideals as Sage prints them; lists of elements, as Magma prints a basis; columns of PARI;
        and rows of coordinates. A list of elements is read as the lattice they span. Raises
        :class:`NotationError` with the position of the unreadable part, :class:`MixedParentsError` for a text
        about another algebra, and :class:`RingError` for lattices over other rings.

        >>> A = QuaternionAlgebra(11)
        >>> O = A.read("Order of Quaternion Algebra (-1, -11) with base ring Rational Field "
        ...            "with basis (1/2 + 1/2*j, 1/2*i + 1/2*k, j, k)")
        >>> O.is_maximal().holds, A.read("[ 1, i, 1/2 + 1/2*j, 1/2*i + 1/2*k ]") == O
        (True, True)
        >>> A.read("[1, 2, 0, 1/2]"), A.read("[1/2, x]~")
        (1 + 2*i + 1/2*k, 1/2 - k)
        """
        from hfield.orders.foreign_texts import read

        return read(self, text)

    def order_from_label(self, text: str) -> Order:
        """Return an order with the label that ``O.label()`` returned; always the same one.

        Raises :class:`NotationError` for an invalid label, :class:`MixedParentsError` for the label of an
        order in another algebra, and :class:`UndecidedError` over a field other than ℚ.

        >>> A = QuaternionAlgebra(11); O = A.order_from_label("x^2+y^2+3*z^2+y*z")
        >>> O.is_maximal().holds, O.is_isomorphic(A.maximal_order())
        (True, True)
        """
        from hfield.orders.labels import order_of_label
        from hfield.orders.lattice import Order

        return Order(order_of_label(self, text))

    def class_number(self, level: object = 1) -> int:
        """Return the number of ideal classes of an Eichler order, over QQ by Eichler's formula.

        Over other fields the classes are enumerated. In an indefinite algebra the number follows from strong
        approximation; over QQ it is 1. Raises :class:`LatticeError` for a level that is not prime to the
        discriminant.

        >>> QuaternionAlgebra("QQ(sqrt(3))", -1, 1).class_number()
        1
        """
        if self.ring != QQ:
            order = self.eichler_order(level)
            return len(order.class_set() if order.is_definite() else order.classes_by_norm())
        from hfield.orders.standard_orders import class_number

        return class_number(self, level)

    # --- identity and text ---------------------------------------------------------------------

    @cached_property
    def _key(self) -> tuple[object, ...]:
        return (self.ring, *(self.ring.key(c) for c in self.constants))

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, QuaternionAlgebra) and self._key == other._key)

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        return hash(self._key)

    def __contains__(self, x: object) -> bool:
        return isinstance(x, Quaternion) and x.algebra == self

    @cached_property
    def name(self) -> str:
        """The text that :meth:`from_text` reads back."""
        return notation.algebra_text(self.ring, self.constants)

    def __str__(self) -> str:
        return self.name

    __repr__ = __str__

    def table_text(self, style: str = "plain") -> str:
        """Lay out the multiplication table in the style ``plain``, ``unicode`` or ``latex``."""
        rows = [
            [notation.element_text(self.ring, q.coordinates, style, unit="e") for q in row]
            for row in self.multiplication_table()
        ]
        return notation.table_text(BASIS, rows, style)

    def text_for(self, system: str) -> str:
        """Write the algebra for ``"magma"``, ``"sage"`` or ``"pari"``; the constructor reads these texts.

        This works over ℚ, prime fields, and number fields with one generator. Raises :class:`RingError` for
        others.

        >>> H("QQ").text_for("magma"), QuaternionAlgebra("QQ[s]/(s^3-2)", "s", -1).text_for("pari")
        ('QuaternionAlgebra<Rationals() | -1, -1>', 'alginit(nfinit((-2)*y^0+(1)*y^3), [y, -1])')
        >>> QuaternionAlgebra("QuaternionAlgebra< RationalField() | -1, -3 >")
        (-1,-3|QQ)
        """
        return written(self.ring, self.constants, system)

    def latex(self) -> str:
        """Return the symbol of the algebra in LaTeX: its constants over its field."""
        F = self.ring
        constants = ",".join(notation.constants_text(F, self.constants, "latex"))
        symbol = rf"\frac{{{constants}}}{{{F.latex_name}}}"
        bracket = "(" if F.key(self.constants.t) == F.key(F(0)) else "["
        return rf"\left{bracket}{symbol}\right)"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}\\qquad {self.table_text('latex')}$"

    def _repr_html_(self) -> str | None:
        """Return the page of ``info`` for a notebook, or None if some fact on it is undecided."""
        try:
            # which stands above, and is found by its name
            page: str = import_module("hfield.description").info(self)._repr_html_()
        except HFieldError:
            return None
        return page

    def __reduce__(self) -> tuple[object, ...]:
        if self._base is not None:
            return QuaternionAlgebra._with_unknowns_named, (self._base, self._names)
        a, t, b = map(self.ring.state, self.constants)
        return QuaternionAlgebra, (self.ring, a, b, t)


def _names_a_ring(text: str) -> bool:
    try:
        read_ring(text)
    except HFieldError:
        return False
    return True


def _constants(a: object, b: object, t: object) -> tuple[Ring, object, object, object]:
    """Return the ring and the constants a, b, t of an algebra given by fewer arguments."""
    if b is not None and isinstance(a, str) and "|" not in a and _names_a_ring(a):
        raise RingError(
            f"an algebra has two constants, and over {a} the one given is {shorten(b)}: write "
            f"QuaternionAlgebra({a!r}, {shorten(b)}, -1)"
        )
    if b is not None and not isinstance(a, Ring):
        return field_named_by(a, b) or QQ, a, b, t
    if b is None and isinstance(a, str):
        F, c = notation.parse_algebra(a)
        return F, c.a, c.b, c.t
    if b is None and isinstance(a, int) and not isinstance(a, bool):
        return QQ, *notation.constants_of_discriminant(a), 0
    raise RingError(
        f"an algebra is named by a ring and two constants, as in QuaternionAlgebra('QQ', -1, -11), by a text "
        f"such as '(-1,-11|QQ)', or by a discriminant such as 11; found {shorten(repr(a))}"
    )


@overload
def H(ring: Ring[E]) -> QuaternionAlgebra[E]: ...
@overload
def H(ring: object) -> QuaternionAlgebra: ...
def H(ring: RingName) -> QuaternionAlgebra:
    """Return Hamilton's algebra over ``ring``: ``i² = j² = −1``, Table 1.1 of the thesis.

    >>> H("GF(7)").zero_norm_element().norm()
    0
    """
    return QuaternionAlgebra(ring, -1, -1)


def ternary_form(coefficients: Iterable[object] | str, ring: RingName = "QQ") -> TernaryForm:
    """Return the form ``a·x² + b·y² + c·z² + r·yz + s·xz + t·xy`` with the coefficients [a, b, c, r, s, t].

    The coefficients are integers or elements of a number field; a text such as ``"x^2+y^2+3*z^2+y*z"`` is
    also read. ``order()`` of a form is its even Clifford algebra, and ``O.ternary_form()`` is the inverse.
    Raises :class:`LatticeError` for an invalid or degenerate form, and :class:`NotationError`.

    >>> f = ternary_form([1, 1, 3, 1, 0, 1])
    >>> f, f.discriminant(), f.order().is_maximal(), f.automorphism_count()
    (x²+y²+3·z²+y·z+x·y, 8, False, 12)
    """
    from hfield.orders.ternary_forms import TernaryForm, read_form

    F = ring if isinstance(ring, Ring) else read_ring(ring)
    if isinstance(coefficients, str):
        return read_form(coefficients, F, QuaternionAlgebra)
    return TernaryForm(F, coefficients, QuaternionAlgebra)
