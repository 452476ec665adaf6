"""Algebras given by their multiplication tables, of any finite dimension, associative or not."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import gcd

from hfield import notation
from hfield.core.product import Scalar
from hfield.errors import (
    CoercionError,
    MixedParentsError,
    NotationError,
    NotInvertibleError,
    UndecidedError,
    shorten,
)
from hfield.fields.base.modular import Modular
from hfield.fields.linear_algebra.kernels import kernel
from hfield.fields.linear_algebra.syzygies import Row
from hfield.fields.names import RingName
from hfield.fields.names import ring as read_ring
from hfield.syntax import Reader
from hfield.syntax.brackets import split
from hfield.verdicts import Verdict

Vector = tuple[Scalar, ...]
KEYWORDS = frozenset(("and", "or", "not", "exists"))


Triple = tuple["AlgebraElement", "AlgebraElement", "AlgebraElement"]


@dataclass(frozen=True, eq=False, repr=False)
class Associativity(Verdict[Triple]):
    """Whether an algebra is associative.

    If not, ``triple`` is the first triple of basis vectors with (xy)z ≠ x(yz), and ``left`` and ``right`` are
    the two products. It suffices to test triples of basis vectors (Lemma 1 of the thesis).
    """

    left: AlgebraElement | None = None
    right: AlgebraElement | None = None

    @property
    def triple(self) -> Triple | None:
        """The first triple of basis vectors that is not associative, if any."""
        return self.witness

    def __str__(self) -> str:
        if self.triple is None:
            return "associative: (x·y)·z = x·(y·z) for all triples of basis vectors"
        x, y, z = self.triple
        return (
            f"not associative: ({x}·{y})·{z} = {self.left:unicode}, "
            f"{x}·({y}·{z}) = {self.right:unicode}"
        )

    __repr__ = __str__


class StructureAlgebra:
    """The algebra over a commutative ring with a basis whose products are given by a table.

    ``ring`` is a ring or its text. ``table[m][n]`` is the product of the basis vectors m and n: a row of
    coordinates, or a text such as ``"-e"`` or ``"2*i + j"``. ``names`` are the names of the basis vectors,
    separated by blanks; the default is ``e0 e1 …``. The algebra need not be associative or commutative, nor
    have a unit.

    Call the algebra to make elements from coordinates, a text, or a scalar if there is a unit. Raises
    :class:`NotationError` for names or texts that cannot be read, :class:`CoercionError` for a table of
    another shape.

    >>> B = StructureAlgebra("QQ", [["e", "i", "j", "k"], ["i", "-e", "k", "-j"],
    ...                             ["j", "-k", "-e", "i"], ["k", "j", "i", "-e"]], names="e i j k")
    >>> B.is_associative()  # Table 1.1 of the thesis with one sign changed
    not associative: (i·j)·j = i, i·(j·j) = −i
    """

    def __init__(
        self,
        ring: RingName,
        table: Sequence[Sequence[str | Sequence[object]]],
        names: str | Sequence[str] | None = None,
    ) -> None:
        self.ring = read_ring(ring)
        self.dimension = len(table)
        self.names = self._read_names(names)
        if not self.dimension or any(len(row) != self.dimension for row in table):
            lengths = ", ".join(str(len(row)) for row in table)
            raise CoercionError(
                f"a table has as many columns as rows; here {self.dimension} rows have the lengths "
                f"{lengths or 'none'}"
            )
        products = [[self._entry(entry) for entry in row] for row in table]
        self.table: tuple[tuple[Vector, ...], ...] = tuple(map(tuple, products))
        zero = self.ring.is_zero
        self._sparse = [
            [[(n, c) for n, c in enumerate(v) if not zero(c)] for v in row] for row in products
        ]

    def _read_names(self, names: str | Sequence[str] | None) -> tuple[str, ...]:
        n = self.dimension
        if names is None:
            found = tuple(f"e{m}" for m in range(n))
        else:
            found = tuple(re.split(r"[\s,]+", names.strip()) if isinstance(names, str) else names)
        if len(found) != n or len(set(found)) != n:
            raise NotationError(
                f"{n} basis vectors need {n} different names, as in names='e i j k', not {found}"
            )
        for name in found:
            if not re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII) or name in KEYWORDS:
                raise NotationError(f"{name!r} is not a name of a basis vector: letters and digits")
            if name in self.ring.names():
                raise NotationError(
                    f"{name!r} is an element of {self.ring.name}: give the basis vector another name"
                )
        return found

    def _entry(self, entry: str | Sequence[object]) -> Vector:
        if isinstance(entry, str):
            term = self._read(entry, products=False)
            if not self.ring.is_zero(term.number):
                raise NotationError(
                    f"{entry!r} is not a combination of {', '.join(self.names)}: a number has to stand "
                    f"before a basis vector, as in {entry}*{self.names[0]}"
                )
            return term.vector
        return self._coordinates(entry)

    def _coordinates(self, values: Sequence[object]) -> Vector:
        if len(values) != self.dimension:
            raise CoercionError(
                f"an element has {self.dimension} coordinates, not {len(values)}: {shorten(str(values))}"
            )
        return tuple(map(self.ring, values))

    def _read(self, text: str, products: bool = True) -> _Term:
        ring, n = self.ring, self.dimension
        basis = [tuple(ring.one if m == k else ring.zero for m in range(n)) for k in range(n)]
        nothing = (ring.zero,) * n

        def number(value: int | Fraction) -> _Term:
            return _Term(self, products, ring(value), nothing)

        names = {name: _Term(self, products, x, nothing) for name, x in ring.names().items()}
        names |= {
            name: _Term(self, products, ring.zero, v)
            for name, v in zip(self.names, basis, strict=True)
        }

        def constant(f: Callable[..., Scalar]) -> Callable[..., _Term]:
            def apply(*arguments: object) -> _Term:
                values = [x.scalar() if isinstance(x, _Term) else x for x in arguments]
                return _Term(self, products, f(*values), nothing)

            return apply

        functions: dict[str, Callable[..., _Term]] = {
            name: constant(f) for name, f in ring.functions().items()
        }
        functions |= {"/": _Term.divided_by, "**": _Term.power}
        term: _Term = Reader(number, names, functions, f"this algebra over {ring.name}").read_typed(
            text
        )
        return term

    # --- products --------------------------------------------------------------------------------

    def product(self, x: Vector, y: Vector) -> Vector:
        """Return the coordinates of the product of two elements given by coordinates."""
        zero = self.ring.is_zero
        out = [self.ring.zero] * self.dimension
        right = [(n, d) for n, d in enumerate(y) if not zero(d)]
        for m, c in enumerate(x):
            if zero(c):
                continue
            for n, d in right:
                if entries := self._sparse[m][n]:
                    factor = c * d
                    for at, coefficient in entries:
                        out[at] = out[at] + factor * coefficient
        return tuple(out)

    def __call__(self, x: object) -> AlgebraElement:
        """Return an element from coordinates, a text, an element, or a scalar if there is a unit.

        Raises :class:`CoercionError` or :class:`NotationError` for other values.
        """
        if isinstance(x, AlgebraElement):
            if x.parent == self:
                return x
            raise MixedParentsError(f"{x} is an element of {x.parent!r}, not of {self!r}")
        if isinstance(x, str):
            term = self._read(x)
            return AlgebraElement(self, self._sum(self._multiple_of_one(term.number), term.vector))
        if isinstance(x, Sequence):
            return AlgebraElement(self, self._coordinates(x))
        return AlgebraElement(self, self._multiple_of_one(self.ring(x)))

    def _multiple_of_one(self, x: Scalar) -> Vector:
        if self.ring.is_zero(x):
            return (self.ring.zero,) * self.dimension
        if self.one is None:
            raise CoercionError(
                f"{self.ring.text(x)} is not an element: the algebra has no unit; write coordinates"
            )
        return tuple(x * c for c in self.one.coordinates)

    @staticmethod
    def _sum(x: Vector, y: Vector) -> Vector:
        return tuple(c + d for c, d in zip(x, y, strict=True))

    @cached_property
    def basis(self) -> tuple[AlgebraElement, ...]:
        """The basis vectors, in the order of their names."""
        ring, n = self.ring, self.dimension
        return tuple(
            AlgebraElement(self, tuple(ring.one if m == k else ring.zero for m in range(n)))
            for k in range(n)
        )

    @property
    def zero(self) -> AlgebraElement:
        """The element 0."""
        return AlgebraElement(self, (self.ring.zero,) * self.dimension)

    def elements(self) -> Iterator[AlgebraElement]:
        """Yield all elements over a finite ring. Raises :class:`NotFiniteError`."""
        values = list(self.ring.elements())
        return (AlgebraElement(self, v) for v in itertools.product(values, repeat=self.dimension))

    def multiplication_table(self) -> tuple[tuple[AlgebraElement, ...], ...]:
        """Return the products of the basis vectors, row times column."""
        return tuple(tuple(AlgebraElement(self, v) for v in row) for row in self.table)

    def table_text(self, style: str = "plain") -> str:
        """Lay out the multiplication table in the style ``plain``, ``unicode`` or ``latex``."""
        rows = [[format(x, style) for x in row] for row in self.multiplication_table()]
        return notation.table_text(self.names, rows, style)

    # --- what the algebra is ---------------------------------------------------------------------

    def is_associative(self) -> Associativity:
        """Return whether the algebra is associative, with the first basis triple that fails.

        Both (xy)z and x(yz) are trilinear, so it suffices to test basis vectors (Lemma 1 of the thesis).
        """
        return self._associativity

    @cached_property
    def _associativity(self) -> Associativity:
        for x, y, z in itertools.product(self.basis, repeat=3):
            left, right = (x * y) * z, x * (y * z)
            if left != right:
                return Associativity(False, witness=(x, y, z), left=left, right=right)
        return Associativity(True)

    def is_commutative(self) -> bool:
        """Return whether x·y = y·x for all x and y, that is, whether the table is symmetric."""
        pairs = itertools.combinations(self.basis, 2)
        return all(x * y == y * x for x, y in pairs)

    @cached_property
    def one(self) -> AlgebraElement | None:
        """The unit, with 1·x = x = x·1 for all x, or None if there is none.

        The unit is found by linear algebra. Raises :class:`UndecidedError` over rings over which that fails
        to decide.

        >>> StructureAlgebra("ZZ", [["2*a"]], names="a").one is None
        True
        """
        ring, n = self.ring, self.dimension
        rows: list[Row] = []  # on (coordinates of x, c): b·x = c·b = x·b for each basis vector b
        for m, at in itertools.product(range(n), repeat=2):
            last = -ring.one if m == at else ring.zero
            rows.append([*(self.table[m][k][at] for k in range(n)), last])
            rows.append([*(self.table[k][m][at] for k in range(n)), last])
        # If u is the unit, the solutions are the multiples of (u, 1).
        found = [v for v in kernel(ring, rows, n + 1) if not all(map(ring.is_zero, v))]
        candidate = self._with_last_one(found)
        if candidate is None:
            return None
        return AlgebraElement(self, candidate)

    def _with_last_one(self, vectors: list[Row]) -> Vector | None:
        """Return the combination of these vectors whose last entry is 1, without that entry."""
        ring = self.ring
        vectors = [v for v in vectors if not ring.is_zero(v[-1])]
        for v in vectors:
            try:
                scale = ring.inverse(v[-1])
            except NotInvertibleError:
                continue
            return tuple(scale * x for x in v[:-1])
        if not vectors:
            return None
        if isinstance(ring, Modular):
            modulus, total, sums = ring.modulus, 0, [ring.zero] * len(vectors[0])
            for v in vectors:
                last = int(v[-1])
                d = gcd(total, last)
                # d = s·total + r·last, so that sums keeps d as its last entry
                r = pow(last // d, -1, total // d) if total else 1
                s = (d - r * last) // total if total else 0
                sums = [ring(s) * x + ring(r) * y for x, y in zip(sums, v, strict=True)]
                total = d
            if gcd(total, modulus) != 1:
                return None
            scale = ring.inverse(ring(total))
            return tuple(scale * x for x in sums[:-1])
        if len(vectors) == 1:
            return None  # all solutions are multiples of one whose last entry is not a unit
        raise UndecidedError(f"whether there is a unit over {shorten(ring.name)} is not decided")

    def center(self) -> tuple[AlgebraElement, ...]:
        """Return a basis of the centre: the elements that commute and associate with all others.

        If the centre is not free over the ring, these are generators. In an associative algebra only
        commutation is tested. Raises :class:`UndecidedError` over rings over which kernels cannot be
        computed.

        >>> [str(x) for x in StructureAlgebra("QQ", [["a", "b"], ["0*a", "0*a"]], names="a b").center()]
        []
        """
        conditions = []
        for x in self.basis:
            column: Row = []
            for y in self.basis:
                column += (x * y - y * x).coordinates
            if not self.is_associative():
                for y, z in itertools.product(self.basis, repeat=2):
                    for a, b, c in ((x, y, z), (y, x, z), (y, z, x)):
                        column += ((a * b) * c - a * (b * c)).coordinates
            conditions.append(column)
        rows = [list(row) for row in zip(*conditions, strict=True)]
        found = kernel(self.ring, rows, self.dimension)
        return tuple(AlgebraElement(self, tuple(v)) for v in found)

    centre = center

    def zero_divisors(self) -> Iterator[AlgebraElement]:
        """Yield the zero divisors over a finite ring, including 0. Raises :class:`NotFiniteError`.

        >>> B = StructureAlgebra("GF(3)", [["a", "0*a"], ["0*a", "b"]], names="a b")
        >>> list(B.zero_divisors())
        [0, b, -b, a, -a]
        """
        return (x for x in self.elements() if x.is_zero_divisor())

    # --- texts and comparison --------------------------------------------------------------------

    def __str__(self) -> str:
        one = "" if self.one is None else f"; 1 = {self.one}"
        rows = "; ".join(", ".join(map(str, row)) for row in self.multiplication_table())
        return f"table({', '.join(self.names)}{one}: {rows}|{self.ring.name})"

    def __repr__(self) -> str:
        shown = ", ".join(self.names)
        return f"StructureAlgebra over {self.ring.name} with the basis {shorten(shown)}"

    def _repr_latex_(self) -> str:
        return f"${self.table_text('latex')}$"

    @classmethod
    def from_text(cls, text: str) -> StructureAlgebra:
        """Read an algebra as :func:`str` writes it; ``; 1 = …`` may be left out.

        Raises :class:`NotationError` for a text of another form, or if the given unit is not one.

        >>> StructureAlgebra.from_text("table(a, b: a, b; b, -a|QQ)").one
        a
        """
        m = re.fullmatch(r"\s*table\((.*)\|([^|]*)\)\s*", text, re.DOTALL)
        head, colon, body = m[1].partition(":") if m else ("", "", "")
        if m is None or not colon:
            raise NotationError(
                f"{shorten(text)!r} is not a table: expected one such as 'table(a, b: a, b; b, -a|QQ)'"
            )
        names, _, unit = head.partition(";")
        rows = [[x.strip() for x in split(row, ",")] for row in split(body, ";")]
        found = cls(m[2].strip(), rows, names)
        said = re.fullmatch(r"\s*1\s*=(.*)", unit, re.DOTALL)
        if unit and (said is None or found.one != found(said[1])):
            raise NotationError(f"{unit.strip()!r} does not give the unit, which is {found.one}")
        return found

    @cached_property
    def _key(self) -> Hashable:
        entries = tuple(self.ring.key(c) for row in self.table for v in row for c in v)
        return self.ring.name, self.names, entries

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, StructureAlgebra) and self._key == other._key)

    def __hash__(self) -> int:
        return hash(self._key)

    def __reduce__(self) -> tuple[object, ...]:
        texts = [[[self.ring.text(c) for c in v] for v in row] for row in self.table]
        return StructureAlgebra, (self.ring, texts, self.names)


class AlgebraElement:
    """An element of a :class:`StructureAlgebra`; ``coordinates`` are elements of its ring."""

    __slots__ = ("coordinates", "parent")

    def __init__(self, parent: StructureAlgebra, coordinates: Vector) -> None:
        self.parent, self.coordinates = parent, coordinates

    def _other(self, x: object) -> AlgebraElement | None:
        if isinstance(x, AlgebraElement):
            return self.parent(x)
        try:
            return self.parent(x) if not isinstance(x, str | Sequence) else None
        except CoercionError:
            return None

    def __add__(self, x: object) -> AlgebraElement:
        other = self._other(x)
        if other is None:
            return NotImplemented
        pairs = zip(self.coordinates, other.coordinates, strict=True)
        return AlgebraElement(self.parent, tuple(c + d for c, d in pairs))

    __radd__ = __add__

    def __sub__(self, x: object) -> AlgebraElement:
        other = self._other(x)
        return NotImplemented if other is None else self + -other

    def __rsub__(self, x: object) -> AlgebraElement:
        return -self + x

    def __neg__(self) -> AlgebraElement:
        return AlgebraElement(self.parent, tuple(-c for c in self.coordinates))

    def __pos__(self) -> AlgebraElement:
        return self

    def __mul__(self, x: object) -> AlgebraElement:
        if isinstance(x, AlgebraElement):
            y = self.parent(x)
            return AlgebraElement(self.parent, self.parent.product(self.coordinates, y.coordinates))
        try:
            scalar = self.parent.ring(x)
        except CoercionError:
            return NotImplemented
        return AlgebraElement(self.parent, tuple(c * scalar for c in self.coordinates))

    __rmul__ = __mul__  # only by scalars, which commute with all

    def __pow__(self, n: int) -> AlgebraElement:
        """Return the power of x with exponent n, multiplied from the left: ``x**3`` is (x·x)·x.

        Raises :class:`CoercionError` for n = 0 if there is no unit, ValueError for negative n.
        """
        if n < 0:
            raise ValueError(f"expected an exponent of at least 0, not {n}")
        if n == 0:
            return self.parent(1)
        out = self
        for _ in range(n - 1):
            out = out * self
        return out

    def is_zero_divisor(self) -> bool:
        """Return whether x·y = 0 or y·x = 0 for some y ≠ 0; true for x = 0.

        Raises :class:`UndecidedError` over rings over which kernels cannot be computed.
        """
        ring = self.parent.ring
        for products in (
            [self * b for b in self.parent.basis],
            [b * self for b in self.parent.basis],
        ):
            rows = [list(row) for row in zip(*(p.coordinates for p in products), strict=True)]
            found = kernel(ring, rows, self.parent.dimension)
            if any(not ring.is_zero(c) for v in found for c in v):
                return True
        return False

    def __eq__(self, x: object) -> bool:
        if isinstance(x, AlgebraElement) and x.parent != self.parent:
            return False
        other = self._other(x)
        if other is None:
            return NotImplemented
        pairs = zip(self.coordinates, other.coordinates, strict=True)
        return all(self.parent.ring.equal(c, d) for c, d in pairs)

    def __hash__(self) -> int:
        return hash((self.parent, *map(self.parent.ring.key, self.coordinates)))

    def __bool__(self) -> bool:
        return not all(map(self.parent.ring.is_zero, self.coordinates))

    def __getitem__(self, n: int) -> Scalar:
        return self.coordinates[n]

    def __format__(self, style: str) -> str:
        return notation.combination_text(
            self.parent.ring, self.coordinates, self.parent.names, style or "plain"
        )

    def __str__(self) -> str:
        return format(self, "plain")

    def __repr__(self) -> str:
        return str(self)

    def _repr_latex_(self) -> str:
        return f"${self:latex}$"

    def __reduce__(self) -> tuple[object, ...]:
        return self.parent, ([self.parent.ring.text(c) for c in self.coordinates],)


class _Term:
    """A part of an expression being read: a scalar (which needs no unit) plus a vector."""

    def __init__(
        self, algebra: StructureAlgebra, products: bool, number: Scalar, vector: Vector
    ) -> None:
        self.algebra, self.products, self.number, self.vector = algebra, products, number, vector

    def like(self, number: Scalar, vector: Vector) -> _Term:
        """Return a term of the same expression, with this value."""
        return _Term(self.algebra, self.products, number, vector)

    def scalar(self) -> Scalar:
        """Return the term as a scalar. Raises :class:`NotationError` if it is not one."""
        if not all(map(self.algebra.ring.is_zero, self.vector)):
            raise NotationError("functions and denominators take scalars only")
        return self.number

    def __add__(self, other: _Term) -> _Term:
        vector = StructureAlgebra._sum(self.vector, other.vector)
        return self.like(self.number + other.number, vector)

    def __neg__(self) -> _Term:
        return self.like(-self.number, tuple(-c for c in self.vector))

    def __sub__(self, other: _Term) -> _Term:
        return self + -other

    def __mul__(self, other: _Term) -> _Term:
        mixed = tuple(
            self.number * d + other.number * c
            for c, d in zip(self.vector, other.vector, strict=True)
        )
        zero = self.algebra.ring.is_zero
        if all(map(zero, self.vector)) or all(map(zero, other.vector)):
            return self.like(self.number * other.number, mixed)
        if not self.products:
            raise NotationError(
                "an entry of a table is a combination of basis vectors, without products of them"
            )
        product = self.algebra.product(self.vector, other.vector)
        return self.like(self.number * other.number, StructureAlgebra._sum(mixed, product))

    def divided_by(self, other: _Term) -> _Term:
        """Return the quotient by a scalar."""
        ring = self.algebra.ring
        scale = ring.inverse(other.scalar())
        return self.like(self.number * scale, tuple(c * scale for c in self.vector))

    def power(self, n: int) -> _Term:
        """Return a power: any power of a scalar, or one with an exponent of at least 1."""
        if all(map(self.algebra.ring.is_zero, self.vector)):
            return self.like(self.algebra.ring.power(self.number, n), self.vector)
        if n < 1:
            raise NotationError("an element has powers with exponents of at least 1 here")
        out = self
        for _ in range(n - 1):
            out = out * self
        return out


__all__ = ["AlgebraElement", "Associativity", "StructureAlgebra"]
