"""What the group of an order is computed from: the order, and its field at the real place where it splits."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import arb, fmpq, fmpq_mat

from hfield.algebra.quaternion import Quaternion
from hfield.checker.glossary import BY_AREA, SHIMIZU
from hfield.core.factorisation import factorise
from hfield.errors import IndefiniteError, LatticeError
from hfield.evidence import Claim
from hfield.fuchsian import area
from hfield.orders import lattice_values
from hfield.orders.certificates import element_json, text
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.z_order import ZOrder

TwoSided = tuple[Sequence[Quaternion], Any]
"""A basis over ℤ of a two-sided ideal, and an exact number that generates its norm."""


class SplitOrder(ABC):
    """An order in an algebra that splits at one real place and at no other infinite one.

    Exact numbers of the field are scalars with ``+ − × /`` and equality; here are their values at that place.
    """

    algebra: Any
    basis: tuple[Quaternion, ...]
    """A basis over ℤ."""
    title: str
    """Such as "maximal order"."""
    level: Any
    degree: int
    """The degree of the field."""

    def __str__(self) -> str:
        article = "an" if self.title[0] in "aeio" else "a"
        return f"{article} {self.title} in {self.algebra}"

    @abstractmethod
    def __contains__(self, x: Quaternion) -> bool:
        """Tell whether an element of the algebra lies in the order."""

    @abstractmethod
    def area(self) -> Fraction:
        """Return the area of the plane modulo the units of norm 1, in units of 2π."""

    @abstractmethod
    def elliptic_points(self) -> dict[int, int] | None:
        """Return how many elliptic points there are of each order, where a formula tells."""

    def cusps(self) -> int | None:
        """Return how many cusps there are, where a formula tells."""
        return 0

    @abstractmethod
    def scalar(self, x: Any) -> Any:
        """Return a number of the base field as an exact number."""

    @abstractmethod
    def sign(self, x: Any) -> int:
        """Return the sign of an exact number at the place, −1, 0 or 1."""

    @abstractmethod
    def real(self, x: Any) -> float:
        """Return about the value of an exact number at the place."""

    @abstractmethod
    def ball(self, x: Any) -> arb:
        """Return a ball around the value, with flint's present precision."""

    def elsewhere(self, x: Any) -> list[float]:
        """Return about the values at the other real places, where the norm is definite."""
        return []

    @abstractmethod
    def root(self, x: Any) -> Any:
        """Return a square root of an exact number, as one of the base ring, or None."""

    @abstractmethod
    def primitive(self, x: Quaternion) -> Quaternion:
        """Return a multiple, by a number, that lies in the order, without what divides it."""

    @abstractmethod
    def normalising(self, norms: Sequence[object]) -> list[TwoSided]:
        """Return two-sided ideals and norms whose generators, with numbers and units of norm 1, generate
        all elements of totally positive norm that normalise the order; or those with some norms.

        Raises :class:`LatticeError`, and :class:`TooLargeError`.
        """

    @abstractmethod
    def flat(self, q: Quaternion) -> list[fmpq]:
        """Return rational coordinates of an element."""

    @abstractmethod
    def written(self, g: Quaternion) -> Any:
        """Return an element as evidence has it."""

    @abstractmethod
    def claim(self, word: str, parts: list[str], shown: dict[str, Any], *cited: str) -> Claim:
        """Return a statement about the order that begins with a word, with its evidence."""

    @cached_property
    def inverse(self) -> fmpq_mat:
        """The matrix from these coordinates to those with respect to the basis."""
        return fmpq_mat([self.flat(x) for x in self.basis]).inv()

    def rows(self, elements: list[Quaternion]) -> list[list[int]]:
        """Return the coordinates of elements of the order with respect to the basis."""
        found = fmpq_mat([self.flat(x) for x in elements]) * self.inverse
        return [[int(c.p) for c in row] for row in found.tolist()]

    @cached_property
    def bars(self) -> list[list[int]]:
        """The conjugates of the basis."""
        return self.rows([x.conjugate() for x in self.basis])

    @cached_property
    def products(self) -> list[list[int]]:
        """The products of each element of the basis by each, row after row."""
        return self.rows([x * y for x in self.basis for y in self.basis])

    def traces_elsewhere(self, basis: tuple[Quaternion, ...]) -> list[list[float]]:
        """Return about the values of tr(x·conj(y)) at the other real places, for all x and y of a basis."""
        bars = [x.conjugate() for x in basis]
        return [self.elsewhere(self.scalar((x * y).trace())) for x in basis for y in bars]

    def element(self, row: list[int]) -> Quaternion:
        """Return the element with these coordinates with respect to the basis."""
        terms = [x * c for x, c in zip(self.basis, row, strict=True) if c]
        return sum(terms, self.algebra(0))


class RationalOrder(SplitOrder):
    """An order over ℤ in an indefinite algebra over ℚ."""

    degree = 1

    def __init__(self, order: ZOrder) -> None:
        if order.ambient.definite:
            raise IndefiniteError(
                f"the units of an order in {order.algebra}, which is definite, are finitely many: "
                "norm_one_group() asks for an algebra that splits at the real place, units() lists these"
            )
        self.order, self.algebra, self.basis, self.level = (
            order, order.algebra, order.basis, order.level,
        )  # fmt: skip
        self.title = "maximal order" if self.level == 1 else f"order of level {self.level}"

    def __contains__(self, x: Quaternion) -> bool:
        return lattice_values.contains(self.order, x)

    def area(self) -> Fraction:
        return area.area(self.order)

    def elliptic_points(self) -> dict[int, int] | None:
        return area.elliptic_points(self.order)

    def cusps(self) -> int | None:
        return area.cusps(self.order)

    def scalar(self, x: Any) -> fmpq:
        return x if isinstance(x, fmpq) else fmpq(int(x.numerator), int(x.denominator))

    def sign(self, x: fmpq) -> int:
        return int(x > 0) - int(x < 0)

    def real(self, x: fmpq) -> float:
        return int(x.p) / int(x.q)

    def ball(self, x: fmpq) -> arb:
        return arb(x)

    def root(self, x: fmpq) -> Fraction | None:
        p, q = int(x.p), int(x.q)
        r, s = math.isqrt(max(p, 0)), math.isqrt(q)
        return Fraction(r, s) if r * r == p and s * s == q else None

    def primitive(self, x: Quaternion) -> Quaternion:
        row = fmpq_mat([self.flat(x)]) * self.inverse
        whole, denominator = row.numer_denom()
        return x * Fraction(int(denominator), math.gcd(*map(int, whole.entries())))

    def normalising(self, norms: Sequence[object]) -> list[TwoSided]:
        """Return for each norm m, or each pᵉ, the product of the two-sided primes (Atkin and Lehner)."""
        order, whole, found = self.order, self.order.discriminant, []
        for m in norms or [p**e for p, e in factorise(whole).items()]:
            if not isinstance(m, int) or m < 1 or whole % m or math.gcd(m, whole // m) != 1:
                raise LatticeError(
                    f"{m} is no exact divisor of {whole}, the discriminant of the order: "
                    "an involution belongs to a divisor that is coprime to its cofactor"
                )
            ideal: Any = order
            for p in factorise(m) if m > 1 else ():
                ideal = lattice_values.meet(ideal, two_sided_prime(order, p))
            found.append((ideal.basis, self.scalar(Fraction(m))))
        return found

    def flat(self, q: Quaternion) -> list[fmpq]:
        return [self.scalar(x) for x in q.coordinates]

    def written(self, g: Quaternion) -> list[str]:
        return element_json(g)

    def claim(self, word: str, parts: list[str], shown: dict[str, Any], *cited: str) -> Claim:
        statement = f"{word}{{{'; '.join([text(self.order), *parts])}}}"
        return Claim(
            self.algebra, statement, {"kind": word, **shown}, BY_AREA, assumes=(SHIMIZU, *cited)
        )
