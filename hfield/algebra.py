"""The parent: the quaternion algebra with ``i² = a + t·i, j² = b, ij = k, ji = t·j − k``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Any

from hfield import notation, syntax
from hfield.array_makers import ArrayMakers
from hfield.embedding import embedding
from hfield.errors import (
    CoercionError,
    MixedParentsError,
    NotFiniteError,
    RingError,
    shorten,
)
from hfield.factorisation import factorise
from hfield.fields.names import ring as read_ring
from hfield.fields.rationals.symbols import from_ramification_q
from hfield.invariants import Invariants
from hfield.notation import BASIS
from hfield.order_makers import OrderMakers
from hfield.product import Constants
from hfield.quaternion import Quaternion, held_by, is_many
from hfield.rings.base import Ring
from hfield.rings.holding import Batch, Holding
from hfield.rings.integers import QQ
from hfield.structure.global_field import field_named_by

LISTED = 10_000


class QuaternionAlgebra(Invariants, OrderMakers, ArrayMakers):
    """The quaternion algebra ``(a,b|R)``, with t = 1 the Artin–Schreier algebra ``[a,b|R)``.

    ``ring`` is a base ring or its text; ``a, b, t`` are whatever the ring can read. Without a ring a and b
    are rational numbers, or elements of one number field; a text names the algebra, and an int alone is the
    discriminant of a definite algebra over ℚ. Raises :class:`RingError` for what is none of these.

    Calling the algebra makes elements: ``A(1, 2, 0, 1)``, ``A("1 + 2*i + k")``, ``A(3)``; four coordinates
    may be arrays of one shape. Any a and b are allowed, 0 too (a degenerate algebra).

    >>> A = QuaternionAlgebra("QQ", -1, -1)
    >>> e, i, j, k = A.basis
    >>> i*j == k, j*i == -k
    (True, True)
    >>> QuaternionAlgebra(-1, -11), QuaternionAlgebra("(-1,-11|QQ)"), QuaternionAlgebra(11)
    ((-1,-11|QQ), (-1,-11|QQ), (-1,-11|QQ))
    """

    def __init__(
        self, ring: Ring | str | object, a: object = None, b: object = None, t: object = 0
    ) -> None:
        if b is None:
            ring, a, b, t = _constants(ring, a, t)
        self.ring = F = ring if isinstance(ring, Ring) else read_ring(ring)  # type: ignore[arg-type]
        self.constants = Constants(F(a), F(t), F(b))

    @classmethod
    def from_text(cls, text: str) -> QuaternionAlgebra:
        """Read ``(a,b|F)``, ``[a,b|F)``, ``[a,b,t|F)`` or ``H(F)``. Raises :class:`NotationError`."""
        ring, (a, t, b) = notation.parse_algebra(text)
        return cls(ring, a, b, t)

    @classmethod
    def from_ramification(
        cls, ring: Ring | str, primes: Iterable[object], infinite: bool | None = None
    ) -> QuaternionAlgebra:
        """Return an algebra over ℚ or a number field that ramifies exactly at these places.

        Over ℚ they are primes and ``"inf"``, which may be left out or said by ``infinite``, as places ramify
        in even number; over a number field they are its places or their texts. Raises :class:`RingError` for
        what is no such place or comes twice, for an odd number of places, and for another field, and
        :class:`UndecidedError` where no constants were found.

        >>> QuaternionAlgebra.from_ramification("QQ", [2, 3]).discriminant()
        6
        >>> A = QuaternionAlgebra.from_ramification("QQ[s]/(s^3-2)", ["(2, s)", "inf0"])
        >>> A.ramified_places()
        ((2, s), inf0)
        """
        F = read_ring(ring)
        named = list(primes)
        if F.name != "QQ":
            from hfield.structure.global_field import global_field

            field = global_field(F)
            if field is None or infinite is not None:
                raise RingError(
                    f"algebras over {shorten(F.name)} are not made from ramified primes and a flag: expected "
                    "QQ, or a number field and its places, infinite ones too"
                )
            return cls(F, *field.with_ramification(named))
        a, b = from_ramification_q(named, infinite)
        return cls(F, a, b)

    @cached_property
    def holding(self) -> Holding:
        """How a single element is held, and what computes with it."""
        return self.ring.holding(self.constants)

    @cached_property
    def array_holding(self) -> Batch:
        """How an array of elements is held, and what computes with it."""
        return self.ring.array_holding(self.constants)

    # --- elements ------------------------------------------------------------------------------

    def __call__(self, *coordinates: object) -> Quaternion:
        """Make an element from four coordinates, or from one scalar, text, quaternion or 4-tuple.

        Raises :class:`CoercionError` for anything else, :class:`NotationError` for unreadable text.
        """
        if len(coordinates) == 4:
            return self._element(coordinates)
        if len(coordinates) == 1:
            (x,) = coordinates
            if isinstance(x, Quaternion):
                if x.algebra != self:
                    raise MixedParentsError(
                        f"{shorten(x)} is an element of {x.algebra}, not of {self}; "
                        "if the rings allow it, use q.change_ring(L)"
                    )
                return x
            if isinstance(x, str):
                return self.parse(x)
            if isinstance(x, (tuple, list)) and len(x) == 4:
                return self._element(tuple(x))
            return self.scalar(x)
        raise CoercionError(
            f"an element of {self} takes 4 coordinates (or one scalar or text), "
            f"{len(coordinates)} were given"
        )

    def _element(self, values: tuple[object, ...]) -> Quaternion:
        how: Holding = self.array_holding if any(map(is_many, values)) else self.holding
        return held_by(self, how, how.read(values))

    def scalar(self, x: Any) -> Quaternion:
        """Return ``x·e`` for a scalar x, or an array of them. Raises :class:`CoercionError`."""
        if isinstance(x, Quaternion):
            return self(x)
        if type(x) is int or is_many(x):
            return self._element((x, 0, 0, 0))
        return held_by(self, self.holding, self.holding.scalar(self.ring(x)))

    def parse(self, text: str) -> Quaternion:
        """Read an expression such as ``(1+i)*(j-k)**-1``: the basis, the ring's generators and
        ``conj norm trace inv scalar vector comm``. Raises :class:`NotationError`.
        """
        names = {name: self(x) for name, x in self.ring.names().items()}
        names |= dict(zip(BASIS, self.basis, strict=True))
        functions = {
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
        }
        reader = syntax.Reader(self.scalar, names, functions, str(self), self.ring.parse_limit)
        element: Quaternion = reader.read(syntax.plain_element(text))
        return element

    def _lift(self, name: str, function: Any) -> Any:
        """Let a function of the ring, such as sqrt, act on scalar multiples of e."""

        def lifted(*arguments: Quaternion) -> Quaternion:
            for q in arguments:
                if not q.vector_part.is_zero():
                    raise CoercionError(f"{name} takes scalars, found {shorten(q)}")
            return self.scalar(function(*(q.scalar_part for q in arguments)))

        return lifted

    @cached_property
    def basis(self) -> tuple[Quaternion, Quaternion, Quaternion, Quaternion]:
        """The basis ``(e, i, j, k)``."""
        rows = [[int(m == n) for m in range(4)] for n in range(4)]
        e, i, j, k = (self(*row) for row in rows)
        return e, i, j, k

    @property
    def one(self) -> Quaternion:
        """The identity e."""
        return self.basis[0]

    @cached_property
    def zero(self) -> Quaternion:
        """The element 0."""
        return self(0, 0, 0, 0)

    def elements(self) -> Iterator[Quaternion]:
        """Run through all q⁴ elements over a finite ring. Raises :class:`NotFiniteError`."""
        if self.ring.order is None:
            raise NotFiniteError(f"{self} is infinite, so its elements cannot be listed")
        F = self.ring
        # a few are kept, many made anew again and again
        few = list(F.elements()) if int(F.order or 0) <= LISTED else None
        return (
            Quaternion(self, (w, x, y, z))
            for w in few or F.elements()
            for x in few or F.elements()
            for y in few or F.elements()
            for z in few or F.elements()
        )

    def random_element(self, seed: int | None = None) -> Quaternion:
        """Return a random element; the same one for the same seed."""
        from random import Random

        rng = Random(seed)
        w, x, y, z = (self.ring.random(rng) for _ in range(4))
        return Quaternion(self, (w, x, y, z))

    # --- what it is ----------------------------------------------------------------------------

    def multiplication_table(self) -> tuple[tuple[Quaternion, ...], ...]:
        """Return the products of the basis, row times column, in the order e, i, j, k (Table 1.1)."""
        return tuple(tuple(p * q for q in self.basis) for p in self.basis)

    def change_ring(self, ring: Ring | str) -> QuaternionAlgebra:
        """Return the algebra with the same constants over another ring, which must contain them.

        Raises :class:`CoercionError` where the base ring does not map into the other one.

        >>> H("QQ").change_ring("GF(7)")
        (-1,-1|GF(7))
        """
        L = read_ring(ring)
        a, t, b = map(embedding(self.ring, L), self.constants)
        return QuaternionAlgebra(L, a, b, t)

    def explain_product(self) -> None:
        """Print the function that multiplies two elements: the one formula with these constants put in.

        >>> QuaternionAlgebra("GF(7)", -1, -3).explain_product()
        # Elements over ℤ/n as four ints between 0 and n − 1, flint's where n is large.
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
        print(self.holding.explain("product"))

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

    def latex(self) -> str:
        """Write the symbol of the algebra, its constants over its field, in LaTeX."""
        F = self.ring
        constants = ",".join(notation.constants_text(F, self.constants, "latex"))
        symbol = rf"\frac{{{constants}}}{{{F.latex_name}}}"
        bracket = "(" if F.key(self.constants.t) == F.key(F(0)) else "["
        return rf"\left{bracket}{symbol}\right)"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}\\qquad {self.table_text('latex')}$"

    def __reduce__(self) -> tuple[object, ...]:
        a, t, b = map(self.ring.state, self.constants)
        return QuaternionAlgebra, (self.ring, a, b, t)


def _constants(a: object, b: object, t: object) -> tuple[Ring, object, object, object]:
    """Return the ring and the constants a, b, t of an algebra that is named by less than all of them."""
    if b is not None and not isinstance(a, Ring):
        return field_named_by(a, b) or QQ, a, b, t
    if b is None and isinstance(a, str):
        F, c = notation.parse_algebra(a)
        return F, c.a, c.b, c.t
    if b is None and isinstance(a, int) and not isinstance(a, bool):
        primes = factorise(a) if a > 1 else {}
        if len(primes) % 2 == 0 or max(primes.values()) > 1:
            raise RingError(
                f"{shorten(a)} is not the discriminant of a definite algebra over QQ: expected a product of "
                "an odd number of different primes, or an algebra such as '(-1,-11|QQ)'"
            )
        return QQ, *from_ramification_q(primes, True), 0
    raise RingError(
        f"an algebra is named by a ring and two constants, as in QuaternionAlgebra('QQ', -1, -11), by a text "
        f"such as '(-1,-11|QQ)', or by a discriminant such as 11; found {shorten(repr(a))}"
    )


def H(ring: Ring | str) -> QuaternionAlgebra:
    """Return Hamilton's algebra over ``ring``: ``i² = j² = −1``, Table 1.1 of the thesis.

    >>> H("GF(7)").zero_norm_element().norm()
    0
    """
    return QuaternionAlgebra(ring, -1, -1)
