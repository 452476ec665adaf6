"""Orders over ℤ in quaternion algebras over ℚ: the lattices that are rings."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any

import flint
from flint import fmpz_mat

from hfield.errors import LatticeError, shorten
from hfield.factorisation import factorise, is_prime
from hfield.lattices import enumeration, hermite
from hfield.lattices.answers import rows_json
from hfield.lattices.lattice import Lattice, checked_side, element_row, listed
from hfield.lattices.reduction import kronecker
from hfield.lattices.regular import Regular, regular
from hfield.lattices.short_vectors import natural
from hfield.quaternion import Parent, Quaternion
from hfield.rings.rational import rational

if TYPE_CHECKING:
    from hfield.lattices.answers import Answer
    from hfield.lattices.certified import Claim
    from hfield.lattices.classes import ClassSet
    from hfield.lattices.ideal import Ideal
    from hfield.lattices.quadratic_orders import Embeddings

UNIT_GROUPS = {2: "C2", 4: "C4", 6: "C6", 8: "Q8", 12: "Dic3", 24: "SL(2,3)"}
"""Which group the units are, by their number, in a definite algebra over ℚ (Voight, section 11.5)."""


class Order(Lattice):
    """A lattice that is a ring with 1: ``q in O`` asks for membership.

    >>> from hfield import QuaternionAlgebra
    >>> O = QuaternionAlgebra("QQ", -1, -11).maximal_order()
    >>> O.discriminant(), O.is_maximal(), O.unit_count()
    (11, True, 4)
    """

    @classmethod
    def generated(cls, algebra: Parent, elements: Iterable[Any]) -> Order:
        """Return the ring that elements generate.

        Raises :class:`LatticeError` when it has a rank below 4, or is no lattice, because it contains
        elements that are not integral.
        """
        r = regular(algebra)
        found = [element_row(algebra, x) for x in (1, *listed(elements))]
        den = math.lcm(*(d for d, _ in found))
        letters = fmpz_mat([[x * (den // d) for x in row] for d, row in found])
        span = hermite.span(den, letters)
        while True:
            words_den, words = span
            _check_integral(algebra, r, words_den, words)
            longer = r.products(words, letters)
            scale = den * r.scale
            rows = (words * scale).entries() + longer.entries()
            wider = hermite.span(words_den * scale, fmpz_mat(len(rows) // 4, 4, rows))
            if wider == span:
                break
            span = wider
        if words.nrows() < 4:
            raise LatticeError(
                f"these elements generate a ring of rank {words.nrows()}, and orders have rank 4: give "
                "elements that lie in no smaller algebra, such as two that do not commute"
            )
        return cls(algebra, words_den, words)

    @classmethod
    def from_basis(cls, algebra: Parent, elements: Iterable[object]) -> Order:
        """Return the order with the given ℤ-basis.

        Raises :class:`LatticeError` unless they are four that span a ring with 1; the message names
        the product that is missing.
        """
        basis = listed(elements)
        if len(basis) != 4:
            raise LatticeError(
                f"a basis of an order has four elements, and {len(basis)} were given"
            )
        return cls.from_lattice(Lattice.spanned(algebra, basis))

    @classmethod
    def from_lattice(cls, lattice: Lattice) -> Order:
        """Return a lattice as an order. Raises :class:`LatticeError` unless it is a ring with 1."""
        order = cls(lattice.algebra, lattice._den, lattice._matrix)
        if 1 not in order:
            raise LatticeError("this lattice is no order: 1 is not in it")
        for p, q in product(order.basis, repeat=2):
            if p * q not in order:
                raise LatticeError(
                    f"this lattice is no order: the product of {shorten(p)} and {shorten(q)} is not in "
                    "it; A.order(elements) returns the ring that they generate"
                )
        return order

    # --- what it is ------------------------------------------------------------------------------

    def discriminant(self) -> int:
        """Return the reduced discriminant; for a maximal order it is that of the algebra."""
        return self._discriminant

    @cached_property
    def _discriminant(self) -> int:
        c = self._regular.constants
        volume = abs((c.t * c.t + 4 * c.a) * c.b) * hermite.determinant(self._matrix)
        return int(volume / self._den**4)

    @property
    def level(self) -> int:
        """The index in a maximal order: the reduced discriminant over that of the algebra."""
        return self._discriminant // self._regular.discriminant

    def is_maximal(self) -> bool:
        """Tell whether no larger order contains this one: whether its discriminant is that small."""
        return self._discriminant == self._regular.discriminant

    def is_eichler(self) -> bool:
        """Tell whether this is an intersection of two maximal orders (Voight, section 24.3)."""
        level = self.level
        return math.gcd(level, self._regular.discriminant) == 1 and all(
            self.eichler_symbol(p) == 1 for p in factorise(level)
        )

    def eichler_symbol(self, p: int) -> int | None:
        """Return the Eichler symbol (O | p): 1, 0 or −1; None where the order is M₂(ℤₚ).

        It tells the residue algebra: split, ramified or inert (Voight, definition 24.3.2).
        """
        if self._discriminant % prime(p):
            return None
        # the discriminant of x changes by a square unit, or stays 0, when x changes modulo p
        symbols = {kronecker(self._x_discriminant(x), p) for x in product((0, 1), repeat=4)} - {0}
        return symbols.pop() if symbols else 0

    def _x_discriminant(self, x: tuple[int, ...]) -> int:
        """Return ``tr(q)² − 4·N(q)`` for the element with these coordinates."""
        t, n = self._trace_and_norm(x)
        return t * t - 4 * n

    def _trace_and_norm(self, x: Iterable[int]) -> tuple[int, int]:
        v = list(x)
        gram = self._integral_gram
        norm = sum(v[m] * v[n] * gram[m][n] for m in range(4) for n in range(4)) // 2
        return sum(a * b for a, b in zip(v, self._traces, strict=True)), norm

    @cached_property
    def _integral_gram(self) -> list[list[int]]:
        """The matrix of ``tr(x·conj(y))`` on the basis; the norm of an order is 1."""
        return [list(row) for row in hermite.tuples(self._even)]

    @cached_property
    def _traces(self) -> tuple[int, ...]:
        r = self._regular
        column = (self._matrix * r.form).entries()[::4]
        return tuple(int(x) // (r.scale * self._den) for x in column)

    @cached_property
    def _table(self) -> list[list[tuple[int, ...]]]:
        """The products of the basis in coordinates of the basis."""
        r = self._regular
        m, d = hermite.inverse(self._matrix)
        scale = self._den * r.scale * d
        e = [int(x) // scale for x in (r.products(self._matrix, self._matrix) * m).entries()]
        return [[tuple(e[16 * i + 4 * j : 16 * i + 4 * j + 4]) for j in range(4)] for i in range(4)]

    @cached_property
    def _one(self) -> tuple[int, ...]:
        """The coordinates of 1."""
        found = hermite.coordinates(self._matrix, (self._den, 0, 0, 0))
        return tuple(int(x) for x in found)

    def _from_coordinates(self, x: Iterable[int]) -> list[int]:
        """Return the row, over the denominator of the order, of an element with these coordinates."""
        rows = self.hnf[1]
        v = list(x)
        return [sum(v[m] * rows[m][n] for m in range(4)) for n in range(4)]

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/1`` as JSON data, one that the checker accepts, or None.

        There is none where the checker would have to do too much; ``claim.why_no_certificate`` tells.
        """
        return self.claim.certificate

    @cached_property
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""
        from hfield.lattices import certified

        return certified.of_order(self)

    @property
    def evidence(self) -> dict[str, object]:
        """What a program needs to check the order: its rows, closed under products, and its discriminant."""
        return {
            "kind": "order",
            "algebra": str(self.algebra),
            **rows_json(self),
            "discriminant": self._discriminant,
            "discriminant_of_algebra": self._regular.discriminant,
        }

    # --- larger and smaller orders ---------------------------------------------------------------

    def maximal_overorder(self) -> Order:
        """Return a maximal order that contains this one, always the same."""
        from hfield.lattices.maximal import overorder

        return overorder(self)

    def conductor(self) -> int:
        """Return the largest f with O = ℤ + f·G for an order G; 1 for a Gorenstein order."""
        _, _, gram = self._ternary
        m, d = hermite.inverse(fmpz_mat(gram))
        # the norm times the discriminant on the trace-0 part of the codifferent (Voight, 24.2)
        form = [[4 * self._discriminant * int(x) // d for x in row] for row in m.tolist()]
        return math.gcd(*(form[r][c] // (2 if r == c else 1) for r in range(3) for c in range(3)))

    def gorenstein_closure(self) -> Order:
        """Return the Gorenstein order G with O = ℤ + f·G, f the conductor (Voight, section 24.2)."""
        f = self.conductor()
        den, rows, gram = self._ternary
        # ℤ + 2G has the trace-0 part of ℤ + 2O, divided by f
        found = [[2 * f * den, 0, 0, 0]]
        for n, row in enumerate(hermite.tuples(rows)):
            odd = gram[n][n] // 2 // f**2 % 2
            found.append([row[0] + odd * f * den, *row[1:]])
        return Order.from_lattice(self._make(2 * f * den, fmpz_mat(found)))

    @cached_property
    def _ternary(self) -> tuple[int, Any, list[list[int]]]:
        """The trace-0 part of ℤ + 2O: a denominator, three rows, and their matrix of tr(x·conj(y))."""
        r, t = self._regular, self._regular.constants.t
        vectors = fmpz_mat([row[1:] for row in self.hnf[1]]).hnf()
        # 2x − tr(x) has the coordinates −t·x₁, 2x₁, 2x₂, 2x₃
        d = t.denominator
        rows = fmpz_mat(
            [
                [-t.numerator * int(vectors[n, 0]), *(2 * d * int(vectors[n, m]) for m in range(3))]
                for n in range(3)
            ]
        )
        den = self._den * d
        scale = r.scale * den * den
        entries = [int(x) // scale for x in r.gram(rows).entries()]
        return den, rows, [entries[0:3], entries[3:6], entries[6:9]]

    @cached_property
    def _reduced_ternary(self) -> tuple[int, Any, list[list[int]]]:
        den, rows, gram = self._ternary
        reduced, steps = fmpz_mat(gram).lll(transform=True, rep="gram")
        entries = [int(x) for x in reduced.entries()]
        return den, steps * rows, [entries[0:3], entries[3:6], entries[6:9]]

    def ternary_theta_series(self, n: int) -> list[int]:
        """Return [r(0), …, r(n)], where r(m) elements of norm m are in the trace-0 part of ℤ + 2O.

        Raises :class:`IndefiniteError`. It is Gross's ternary lattice ("Heights and the special values
        of L-series", 1987).
        """
        self._definite("ternary_theta_series()")
        natural(n)
        counts = enumeration.count_by_length(self._reduced_ternary[2], 2 * n)
        return [counts.get(2 * m, 0) for m in range(n + 1)]

    # --- units -------------------------------------------------------------------------------------

    def units(self) -> tuple[Quaternion, ...]:
        """Return all units of an order in a definite algebra.

        Raises :class:`NotFiniteError` for an indefinite algebra, whose orders have infinitely many.
        """
        self._definite("units()")
        return self.elements_of_norm(1)

    def unit_count(self) -> int:
        """Return how many units there are; at most 24. Raises as :meth:`units` does."""
        self._definite("unit_count()")
        return 2 * sum(1 for _, m in self._short(1))

    def unit_group(self) -> str:
        """Return the name of the group of units: ``C2 C4 C6 Q8 Dic3`` or ``SL(2,3)``.

        Of an indefinite algebra, ``"infinite"``: a finitely presented group that is not written down.
        """
        return UNIT_GROUPS[self.unit_count()] if self._regular.definite else "infinite"

    # --- ideals ------------------------------------------------------------------------------------

    def left_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the left ideal ``O·gens``. Raises :class:`LatticeError` when its rank is below 4."""
        from hfield.lattices.ideal import Ideal

        return Ideal.generated(self, generators, "left")

    def right_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the right ideal ``gens·O``. Raises :class:`LatticeError` when its rank is below 4."""
        from hfield.lattices.ideal import Ideal

        return Ideal.generated(self, generators, "right")

    def two_sided_ideal(self, generators: Iterable[object]) -> Ideal:
        """Return the ideal ``O·gens·O``. Raises :class:`LatticeError` for a rank below 4."""
        from hfield.lattices.ideal import Ideal

        return Ideal.generated(self, generators, "two-sided")

    def two_sided_prime(self, p: int) -> Ideal:
        """Return the two-sided ideal at a prime that generates, with the numbers, all those there.

        Its square is pᵉ·O, the part of the discriminant at p; it is p·O where p does not divide that.
        Raises :class:`LatticeError` where the order is neither maximal nor Eichler at p.
        """
        from hfield.lattices.twosided import two_sided_prime

        return two_sided_prime(self, p)

    def ideals_of_norm(self, n: int, side: str = "left") -> list[Ideal]:
        """Return all invertible integral ideals of norm n on a side: p + 1 where p is off the discriminant.

        Raises :class:`LatticeError`, and :class:`TooLargeError` for more than 10⁵.
        """
        from hfield.lattices.subideals import ideals_of_norm

        return ideals_of_norm(self, positive(n, "norm"), checked_side(side))

    def random_ideal(self, n: int, side: str = "left", seed: int | None = None) -> Ideal:
        """Return a random ideal of norm n, prime to the discriminant, which no integer divides.

        The same for the same seed. Raises :class:`LatticeError`.
        """
        from hfield.lattices.subideals import random_ideal

        return random_ideal(self, positive(n, "norm"), checked_side(side), random.Random(seed))

    def connecting_ideal(self, other: Order) -> Ideal:
        """Return the primitive integral ideal with this left order and the right order ``other``.

        Raises :class:`LatticeError` unless both are Eichler orders of one level.
        """
        from hfield.lattices.isomorphic_orders import connecting_ideal

        return connecting_ideal(self, self._order_like(other))

    def isomorphism(self, other: Order) -> Answer:
        """Return an answer with an ``element`` x, x·O·x⁻¹ being the other order, or the ``reason`` why none.

        Decided for all orders of definite algebras, and for ℤ + f·Eichler orders of indefinite ones, where
        the element may be missing. Raises :class:`UndecidedError`.
        """
        from hfield.lattices.isomorphic_orders import isomorphism

        return isomorphism(self, self._order_like(other))

    def _order_like(self, other: object) -> Order:
        """Return an order of the same algebra, perhaps given as a lattice, ``x * O * x.inverse()``."""
        found = self._same(other, "compare")
        return found if isinstance(found, Order) else Order.from_lattice(found)

    def is_isomorphic(self, other: Order) -> bool:
        """Tell whether two orders are isomorphic. Raises as :meth:`isomorphism` does."""
        return bool(self.isomorphism(other))

    # --- elements ----------------------------------------------------------------------------------

    def represent_integer(self, n: int, seed: int | None = None) -> Quaternion | None:
        """Return an element of norm n, or None where there is none; n may have hundreds of digits.

        Raises :class:`IndefiniteError`, and :class:`UndecidedError` for a large n in an order without small
        quadratic orders.
        """
        from hfield.lattices.represent import represent_integer

        return represent_integer(self, positive(n, "norm"), seed)

    def embeddings(self, discriminant: int) -> Embeddings:
        """Return the optimal embeddings of the quadratic order of a negative discriminant.

        Raises :class:`LatticeError` for what is no such discriminant, :class:`IndefiniteError`.
        """
        from hfield.lattices.quadratic_orders import embeddings

        return embeddings(self, integer(discriminant, "discriminant"))

    # --- classes -----------------------------------------------------------------------------------

    def class_set(self) -> ClassSet:
        """Return the right ideal classes, enumerated and checked by the mass, in a definite algebra.

        Raises :class:`IndefiniteError`; there the number of classes is 1 for an Eichler order.
        """
        from hfield.lattices.classes import ClassSet

        return ClassSet(self)

    def mass(self) -> Fraction:
        """Return ``Σ 1/[O_L(I)^× : ±1]`` over the right ideal classes, by a formula."""
        from hfield.lattices.class_number import mass

        return mass(self)


def positive(n: object, what: str) -> int:
    """Return a positive integer. Raises :class:`LatticeError` for anything else."""
    value = rational(n)
    if isinstance(n, bool) or not isinstance(value, int) or value < 1:
        raise LatticeError(f"the {what} {shorten(repr(n))} is no positive integer")
    return value


def integer(n: object, what: str) -> int:
    """Return an integer. Raises :class:`LatticeError` for anything else."""
    value = rational(n)
    if not isinstance(value, int):
        raise LatticeError(f"the {what} {shorten(repr(n))} is no integer")
    return value


def prime(p: object) -> int:
    """Return a prime as an int. Raises :class:`LatticeError` for what is none."""
    if not isinstance(p, (int, flint.fmpz)) or isinstance(p, bool) or not is_prime(int(p)):
        raise LatticeError(f"{shorten(repr(p))} is not a prime number")
    return int(p)


def _check_integral(algebra: Parent, r: Regular, den: int, rows: Any) -> None:
    """Raise :class:`LatticeError` unless all combinations of the rows have integral trace and norm."""
    gram = r.gram(rows)
    traces = (rows * r.form).entries()[::4]
    scale = r.scale * den * den
    for n in range(rows.nrows()):
        whole = int(traces[n]) % (r.scale * den) == 0 and int(gram[n, n]) % (2 * scale) == 0
        if not whole:
            q = algebra(*(Fraction(int(rows[n, m]), den) for m in range(4)))
            raise LatticeError(
                f"these elements generate no order: {shorten(q)} has trace {q.trace()} and norm "
                f"{q.norm()}, which are not both integers"
            )
        for m in range(n):
            if int(gram[n, m]) % scale:
                p, q = (
                    algebra(*(Fraction(int(rows[x, c]), den) for c in range(4))) for x in (m, n)
                )
                raise LatticeError(
                    f"these elements generate no order: the sum of {shorten(p)} and {shorten(q)} has a "
                    "norm that is no integer"
                )
