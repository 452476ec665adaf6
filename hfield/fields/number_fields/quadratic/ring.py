"""Quadratic number fields QQ(sqrt(d)) and QQ(I); elements are those of number fields, a + b·√d."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from random import Random
from typing import TYPE_CHECKING, Any

import flint

from hfield.core.factorisation import UnfactoredError, factorise
from hfield.core.product import Constants
from hfield.errors import CoercionError, HFieldError, RingError, shorten
from hfield.fields.algebraic.radicands import reduced
from hfield.fields.algebraic.surds import Surd, sympy_of
from hfield.fields.base.coercion import rational, unwrap
from hfield.fields.base.ring import INFINITY, Fact, Ring, shared
from hfield.fields.base.roots import irreducible_factors
from hfield.fields.base.storage.base import Storage
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.squares import minus_one

if TYPE_CHECKING:
    from fractions import Fraction

    import sympy

    from hfield.fields.base.ring import S
    from hfield.fields.number_fields.places import Place
    from hfield.fields.number_fields.quadratic.places import (
        QuadraticComplexPlace,
        QuadraticPrime,
        QuadraticRealPlace,
    )


class QuadraticField(NumberField):
    """ℚ(√d) for a squarefree integer d ≠ 1; ``gen`` is √d, or I for d = −1.

    >>> from hfield import ring
    >>> F = ring("QQ(sqrt(2))")
    >>> F.inverse(1 + F.gen)
    -1+sqrt(2)
    """

    theory = "quadratic field"

    def __init__(self, d: int) -> None:
        self.d = d
        self.polynomial = flint.fmpq_poly([-d, 0, 1])
        self.gen_name = "I" if d == -1 else f"sqrt({d})"
        self.name = f"QQ({self.gen_name})"

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.d)

    @property
    def data(self) -> dict[str, object]:
        """The number under the root, as JSON data."""
        return {"kind": "quadratic field", "d": self.d}

    def in_words(self) -> str:
        """Return a description of the field."""
        root = "i), i² = −1" if self.d == -1 else f"√{self.d})".replace("-", "−")
        return f"the quadratic number field ℚ({root}"

    # --- texts and numbers of other rings ----------------------------------------------------------

    def names(self) -> dict[str, FieldElement]:
        """The imaginary unit I, in QQ(I)."""
        return {"I": self.gen} if self.d == -1 else {}

    def generators(self) -> dict[str, FieldElement]:
        """Return nothing: I is a number."""
        return {}

    def images_in(self, target: Ring[S]) -> dict[str, S]:
        """Return the image of I in a number field without a name for it; functions with constants in this
        field need it.
        """
        is_number_field = isinstance(target, NumberField)
        if self.d != -1 or not is_number_field:
            return {}
        root = target.sqrt(target(-1))
        return {} if root is None else {"I": root}

    def __call__(self, x: object) -> FieldElement:
        """Convert a rational number, an element or a surd in ℚ(√d) to an element; read a text.

        Raises :class:`CoercionError`.
        """
        x = unwrap(x)
        return self._from_surd(x) if isinstance(x, Surd) else super().__call__(x)

    def _from_surd(self, x: Surd) -> FieldElement:
        same = x if x.terms.keys() <= {1, self.d} else x.over(self.d)
        if same is None:
            raise self.refuse(x, f"{self.name} has only the numbers a+b*{self.gen_name}")
        zero = flint.fmpq(0)
        terms = [same.terms.get(1, zero), same.terms.get(self.d, zero)]
        return FieldElement(self, flint.fmpq_poly(terms))

    def as_surd(self, x: FieldElement) -> Surd:
        """Return x as the number a + b·√d of RR or CC."""
        return Surd({n: c for n, c in zip((1, self.d), (x.poly[0], x.poly[1]), strict=True) if c})

    def text(self, x: FieldElement, style: str = "plain") -> str:
        """Write x, such as ``1/2+3*sqrt(2)``."""
        return self.as_surd(x).text(style, imaginary=self.d == -1)

    def number_texts(self, style: str) -> list[str]:
        """Return the text of √d."""
        return [self.text(self.gen, style)]

    def generator_of(self, polynomial: Sequence[Fraction]) -> sympy.Expr | None:
        """Return the square root of d if this is its minimal polynomial, or None."""
        return sympy_of(self.as_surd(self.gen)) if list(polynomial) == [-self.d, 0, 1] else None

    def closed_form(self, x: sympy.Expr) -> FieldElement:
        """Return the number that a sympy expression without symbols represents."""
        from hfield.fields.algebraic.closed_forms import from_sympy

        value = from_sympy(x)
        if isinstance(value, Surd):
            return self(value)
        try:
            return super().closed_form(x)
        except CoercionError:
            raise self.refuse(x, f"{self.name} has only the numbers a+b*{self.gen_name}") from None

    def to_sympy(self, x: FieldElement, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the number as a sympy expression."""
        return sympy_of(self.as_surd(x))

    def embed_from(self, source: Ring) -> Callable[[Any], FieldElement] | None:
        """Return the map of a field of degree 2 into this one; None for others, which are mapped by their
        texts.
        """
        if isinstance(source, NumberField) and source.degree == 2:
            return super().embed_from(source)
        return None

    # --- arithmetic --------------------------------------------------------------------------------

    def sqrt(self, x: FieldElement) -> FieldElement | None:
        """Return the principal root, or None if it is not in the field."""
        root = self.as_surd(x).sqrt(within=self.d)
        return None if root is None else self._from_surd(root)

    def roots(self, coefficients: Sequence[FieldElement]) -> list[FieldElement]:
        """Return all roots of a polynomial with rational coefficients. Raises :class:`UndecidedError`."""
        if not all(x.is_rational() for x in coefficients):
            return super().roots(coefficients)
        out: list[FieldElement] = []
        for g in irreducible_factors([x.poly[0] for x in coefficients]):
            if g.degree() == 1:
                out.append(self(-g[0]))
            elif g.degree() == 2:
                root = self.sqrt(self(g[1] * g[1] - 4 * g[0]))
                if root is not None:
                    out += [self.divide(y - self(g[1]), self(2)) for y in (root, -root)]
        return out

    def storage(self, constants: Constants) -> Storage:
        """Return the storage of elements as eight ints over one denominator."""
        from hfield.fields.base.storage.fractions import FractionStorage

        return FractionStorage(self, constants, (self.d, 0), self._vector, self._element)

    @staticmethod
    def _vector(x: FieldElement) -> tuple[flint.fmpq, flint.fmpq]:
        return x.poly[0], x.poly[1]

    def _element(self, a: int, b: int, denominator: int = 1) -> FieldElement:
        """Return (a + b·√d)/denominator for integers."""
        return FieldElement(self, flint.fmpq_poly([a, b], denominator))

    def random(self, rng: Random) -> FieldElement:
        """Return a small random element; the same for the same seed."""
        return FieldElement(self, flint.fmpq_poly([QQ.random(rng), QQ.random(rng)]))

    # --- squares and orderings ---------------------------------------------------------------------

    @property
    def level(self) -> Fact:
        """∞ for d > 0; else 1 for d = −1, 4 if −d ≡ 7 mod 8, and 2 for all others."""
        if self.d > 0:
            return Fact(INFINITY, f"{self.name} is a field of real numbers, so it has an ordering")
        squares = self.minus_one_as_squares()
        if len(squares) < 4:
            return self.level_of(squares)
        return self.level_of(squares, f"fewer squares do not do, for {-self.d} ≡ 7 mod 8")

    def minus_one_as_squares(self) -> tuple[FieldElement, ...]:
        """Return as few elements as possible whose squares add up to −1."""
        if self.d > 0:
            return ()
        if self.d == -1:
            return (self.gen,)
        return tuple(map(self, minus_one(-self.d, self.gen)))

    @property
    def orderings(self) -> Fact:
        """Two for d > 0, one with √d positive and one with √d negative; none for d < 0."""
        if self.d < 0:
            return super().orderings
        return Fact(2, f"{self.gen_name} may be positive (ordering 0) or negative (ordering 1)")

    def check_ordering(self, ordering: int) -> None:
        """Raise an error for the number of an ordering that the field does not have."""
        Ring.check_ordering(self, ordering)

    def sign(self, x: FieldElement, ordering: int = 0) -> int:
        """Return the sign of x with √d positive (ordering 0) or negative (ordering 1)."""
        self.check_ordering(ordering)
        return self.sign_at(self(x), 1 - ordering)

    def sign_at(self, x: FieldElement, index: int) -> int:
        """Return the sign of x at a real place; place 0 is the one at which √d is negative."""
        return int(self.as_surd(x).sign(0 if index else self.d))

    # --- integers and places -----------------------------------------------------------------------

    def discriminant(self) -> int:
        """Return the discriminant of the field: d, or 4d unless d ≡ 1 mod 4."""
        return self.d if self.d % 4 == 1 else 4 * self.d

    def integral_basis(self) -> tuple[FieldElement, FieldElement]:
        """Return a basis over ℤ of the integers of the field, 1 first."""
        half = flint.fmpq(1, 2)
        omega = [half, half] if self.d % 4 == 1 else [0, 1]
        return self.one, FieldElement(self, flint.fmpq_poly(omega))

    @property
    def signature(self) -> tuple[int, int]:
        """The numbers of real and of complex places."""
        return (2, 0) if self.d > 0 else (0, 1)

    def known_primes_above(self, p: int) -> tuple[QuadraticPrime, ...]:
        """Return the one or two prime ideals above a prime number.

        >>> from hfield import ring
        >>> [(P, P.e, P.f, P.generators) for P in ring("QQ(I)").primes_above(5)]
        [((5, I-2), 1, 1, (5, -2+I)), ((5, I-3), 1, 1, (5, -3+I))]
        """
        from hfield.fields.number_fields.quadratic.places import quadratic_primes_above

        return quadratic_primes_above(self, p)

    def real_places(self) -> tuple[QuadraticRealPlace, ...]:
        """Return the real places, √d negative first; each has ``index`` and ``sign(x)``."""
        from hfield.fields.number_fields.quadratic.places import QuadraticRealPlace

        return tuple(QuadraticRealPlace(self, n) for n in range(self.signature[0]))

    def infinite_places(self) -> tuple[QuadraticRealPlace | QuadraticComplexPlace, ...]:
        """Return the two real places, or the complex one."""
        from hfield.fields.number_fields.quadratic.places import QuadraticComplexPlace

        return self.real_places() or (QuadraticComplexPlace(self, 0),)

    def places(self) -> Iterator[Place]:
        """Yield the places: the infinite ones, √d positive first, then prime by prime."""
        from hfield.fields.number_fields.places import finite_places

        yield from reversed(self.infinite_places())
        yield from finite_places(self)


def build(text: str) -> QuadraticField:
    """Return ℚ(√d) for the text of a rational number d. Raises :class:`RingError`."""
    try:
        d = rational(QQ(text))
        if d is None:  # pragma: no cover - QQ gives rational numbers only
            raise AssertionError
        _, free = reduced(d.numerator * d.denominator) if d else (0, 1)
        factorise(free)  # either it is proved squarefree, or nothing is known about the field
    except UnfactoredError as error:
        raise RingError(
            f"QQ(sqrt({shorten(text)})) needs the primes of the discriminant, and factoring it failed: "
            f"{error}; ring(text, factors=[p]) takes those that you know"
        ) from error
    except HFieldError as error:
        raise RingError(
            f"QQ(sqrt({shorten(text)})): expected an integer under the root, as in QQ(sqrt(2)): {error}"
        ) from error
    if free == 1:
        raise RingError(
            f"QQ(sqrt({shorten(text)})): {shorten(d)} is a square in QQ, so this is QQ itself: write QQ"
        )
    return shared(QuadraticField, free)


def common_quadratic_field(*elements: object) -> Ring | None:
    """Return ℚ(√d) for numbers with one square root, None for numbers without; raises RingError for several
    roots.
    """
    roots = {n for x in elements if isinstance(x, Surd) for n in x.terms if n != 1}
    if len(roots) > 1:
        shown = " and ".join(map(shorten, elements))
        raise RingError(f"{shown} lie in no common quadratic field")
    if not roots:
        return None
    d = roots.pop()
    factorise(d)  # the theory of places asks for a squarefree d
    return shared(QuadraticField, d)
