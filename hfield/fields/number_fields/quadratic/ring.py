"""Quadratic number fields QQ(sqrt(d)) and QQ(I); elements are :class:`Surd` numbers a + b·√d."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import CoercionError, HFieldError, NotInvertibleError, RingError, shorten
from hfield.factorisation import UnfactoredError, factorise
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.with_ideals import WithIdeals
from hfield.primality import is_prime
from hfield.product import Constants
from hfield.rings.base import INFINITY, Known, Ring, shared
from hfield.rings.closed_fields.radicands import reduced
from hfield.rings.closed_fields.surds import Surd, from_rational, sympy_of
from hfield.rings.holding import Holding
from hfield.rings.integers import QQ
from hfield.rings.rational import rational, unwrap
from hfield.rings.roots import irreducible_factors
from hfield.rings.squares import minus_one
from hfield.rings.values import ValueRing

if TYPE_CHECKING:
    import sympy

    from hfield.fields.number_fields.quadratic.places import QuadraticPlace


class QuadraticField(WithIdeals, ValueRing[Surd]):
    """ℚ(√d) for a squarefree integer d ≠ 1; ``gen`` is √d, or I for d = −1.

    >>> from hfield import ring
    >>> F = ring("QQ(sqrt(2))")
    >>> F.inverse(1 + F.gen)
    -1+sqrt(2)
    """

    characteristic = 0
    is_field = True
    theory = "quadratic field"

    def __init__(self, d: int) -> None:
        self.d = d
        self.gen_name = "I" if d == -1 else f"sqrt({d})"
        self.name = f"QQ({self.gen_name})"

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (type(self), self.d)

    @property
    def data(self) -> dict[str, Any]:
        """The field by the number under the root."""
        return {"kind": "quadratic field", "d": self.d}

    def in_words(self) -> str:
        """Say what the field is."""
        root = "i), i² = −1" if self.d == -1 else f"√{self.d})".replace("-", "−")
        return f"the quadratic number field ℚ({root}"

    @property
    def gen(self) -> Surd:
        """The square root of d, the principal one."""
        return Surd({self.d: flint.fmpq(1)})

    def names(self) -> dict[str, Surd]:
        """The imaginary unit I, in QQ(I)."""
        return {"I": self.gen} if self.d == -1 else {}

    def images_in(self, target: Ring) -> dict[str, Any]:
        """Return what I is in a number field that has no such name."""
        if self.d != -1 or not isinstance(target, NumberField):
            return {}
        root = target.sqrt(target(-1))
        return {} if root is None else {"I": root}

    def functions(self) -> dict[str, Callable[..., Surd]]:
        """The square root of what has one in the field, so that ``1/2+3*sqrt(2)`` can be read."""
        return {"sqrt": self._sqrt_here}

    def _sqrt_here(self, x: Surd) -> Surd:
        y = self.sqrt(x)
        if y is None:
            raise CoercionError(
                f"{shorten(self.text(x))} has no square root in {self.name}; "
                "RR has one of every x ≥ 0, CC of all"
            )
        return y

    def __call__(self, x: object) -> Surd:
        """Turn a rational number or a surd in ℚ(√d) into an element, read a text.

        Raises :class:`CoercionError`.
        """
        x = unwrap(x)
        if isinstance(x, Surd):
            if x.terms.keys() <= {1, self.d}:
                return x
            same = x.over(self.d)
            if same is None:
                raise self.refuse(x, f"{self.name} has only the numbers a+b*{self.gen_name}")
            return same
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        return self.foreign(x) if number is None else from_rational(number)

    def generators(self) -> dict[str, Surd]:
        """Return nothing: I is a number."""
        return {}

    def generator_of(self, polynomial: Sequence[Fraction]) -> sympy.Expr | None:
        """Return the square root of d if this is its minimal polynomial, or None."""
        return sympy_of(self.gen) if list(polynomial) == [-self.d, 0, 1] else None

    def modulus_over_rationals(self) -> list[int]:
        """Return the minimal polynomial of √d, low degree first."""
        return [-self.d, 0, 1]

    def coefficients_of(self, x: Surd) -> list[flint.fmpq]:
        """Return the two rational coordinates of x."""
        return list(self.key(x))

    def of_coefficients(self, values: Sequence[flint.fmpq]) -> Surd:
        """Return the element with these coordinates."""
        return Surd({n: c for n, c in zip((1, self.d), values, strict=True) if c})

    def monomials(self) -> tuple[list[list[int]], list[tuple[int, ...]]]:
        """Return the powers of √d, which elements are written in, by themselves, and their exponents."""
        return [[1, 0], [0, 1]], [(0,), (1,)]

    def number_texts(self, style: str) -> list[str]:
        """Return the text of √d."""
        return [self.text(self.gen, style)]

    def closed_form(self, x: sympy.Expr) -> Surd:
        """Return the number that a sympy expression without symbols is."""
        from hfield.rings.closed_fields.closed_forms import from_sympy

        value = from_sympy(x)
        if isinstance(value, Surd):
            return self(value)
        from hfield.fields.number_fields.closed_forms import element_of
        from hfield.fields.number_fields.quadratic import as_number_field as same

        try:
            return same.from_number_field(self, element_of(same.as_number_field(self), x))
        except CoercionError:
            raise self.refuse(x, f"{self.name} has only the numbers a+b*{self.gen_name}") from None

    def to_sympy(self, x: Surd, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return the number as sympy has it."""
        return sympy_of(x)

    def is_zero(self, x: Surd) -> bool:
        """Tell whether x is 0."""
        return not x.terms

    def key(self, x: Surd) -> tuple[flint.fmpq, flint.fmpq]:
        """Return the two rational coordinates of x."""
        return x.terms.get(1, flint.fmpq(0)), x.terms.get(self.d, flint.fmpq(0))

    def inverse(self, x: Surd) -> Surd:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        if not x.terms:
            raise NotInvertibleError(f"cannot divide by 0 in {self.name}")
        return x.inverse()

    def sqrt(self, x: Surd) -> Surd | None:
        """Return the principal root, or None when it is not in the field."""
        return x.sqrt(within=self.d)

    def roots(self, coefficients: Sequence[Surd]) -> list[Surd]:
        """Return all roots of a polynomial with rational coefficients. Raises :class:`UndecidedError`."""
        rationals = [x.terms.get(1, flint.fmpq(0)) for x in coefficients if set(x.terms) <= {1}]
        if len(rationals) < len(coefficients):
            return super().roots(coefficients)
        out: list[Surd] = []
        for g in irreducible_factors(rationals):
            if g.degree() == 1:
                out.append(self(-g[0]))
            elif g.degree() == 2:
                root = self.sqrt(self(g[1] * g[1] - 4 * g[0]))
                if root is not None:
                    out += [self.divide(y - self(g[1]), self(2)) for y in (root, -root)]
        return out

    def irreducible_factors(self, coefficients: Sequence[Surd]) -> list[list[Surd]]:
        """Return the monic irreducible factors of a polynomial that is not 0, each once."""
        from hfield.fields.number_fields.quadratic import as_number_field as same

        inside = [same.into_number_field(self, x) for x in coefficients]
        found = same.as_number_field(self).irreducible_factors(inside)
        return [[same.from_number_field(self, x) for x in f] for f in found]

    @property
    def level(self) -> Known:
        """∞ for d > 0; else 1 for d = −1, 4 where −d ≡ 7 mod 8, and 2 for all others."""
        if self.d > 0:
            return Known(INFINITY, f"{self.name} is a field of real numbers, so it has an ordering")
        squares = self.minus_one_as_squares()
        if len(squares) < 4:
            return self.level_of(squares)
        return self.level_of(squares, f"fewer squares do not do, for {-self.d} ≡ 7 mod 8")

    def minus_one_as_squares(self) -> tuple[Surd, ...]:
        """Return as few elements as possible whose squares add up to −1."""
        if self.d > 0:
            return ()
        return (self.gen,) if self.d == -1 else minus_one(-self.d, self.gen)

    @property
    def orderings(self) -> Known:
        """Two for d > 0, in which √d is positive or negative; none for d < 0."""
        if self.d < 0:
            return super().orderings
        return Known(2, f"{self.gen_name} may be positive (ordering 0) or negative (ordering 1)")

    def sign(self, x: Surd, ordering: int = 0) -> int:
        """Return the sign of x with √d positive (ordering 0) or negative (ordering 1)."""
        if self.d < 0:
            return super().sign(x, ordering)
        self.check_ordering(ordering)
        return int(x.sign(self.d if ordering else 0))

    def random(self, rng: Random) -> Surd:
        """Return a small random element; the same for the same seed."""
        a, b = (from_rational(rational(QQ.random(rng)) or 0) for _ in range(2))
        return a + b * self.gen

    def holding(self, constants: Constants) -> Holding:
        """Elements are held as eight ints over one denominator."""
        from hfield.rings.held.fractions import Fractions

        return Fractions(self, constants, (self.d, 0), self.key, self._element)

    def _element(self, a: int, b: int, denominator: int = 1) -> Surd:
        """Return (a + b·√d)/denominator for integers."""
        terms = {1: flint.fmpq(a, denominator), self.d: flint.fmpq(b, denominator)}
        return Surd({n: c for n, c in terms.items() if c})

    degree = 2

    def norm(self, x: object) -> flint.fmpq:
        """Return the norm of x down to ℚ."""
        a, b = self.key(self(x))
        return a * a - self.d * b * b

    def trace(self, x: object) -> flint.fmpq:
        """Return the trace of x down to ℚ."""
        return 2 * self.key(self(x))[0]

    def discriminant(self) -> int:
        """Return the discriminant of the field: d, or 4d unless d ≡ 1 mod 4."""
        return self.d if self.d % 4 == 1 else 4 * self.d

    def integral_basis(self) -> tuple[Surd, Surd]:
        """Return a basis over ℤ of the integers of the field, 1 first."""
        from hfield.fields.number_fields.quadratic.places import integers_basis

        return integers_basis(self.d)

    def primes_above(self, p: object) -> tuple[QuadraticPlace, ...]:
        """Return the one or two prime ideals above a prime number. Raises :class:`RingError`.

        >>> from hfield import ring
        >>> [(P, P.e, P.f, P.generators) for P in ring("QQ(I)").primes_above(5)]
        [((5, I-2), 1, 1, (5, -2+I)), ((5, I-3), 1, 1, (5, -3+I))]
        """
        from hfield.fields.number_fields.quadratic.places import places_above

        number = rational(p)
        if not isinstance(number, int) or not is_prime(number):
            raise RingError(f"{shorten(p)} is no prime number; expected one, such as 5")
        return places_above(self, number)

    def real_places(self) -> tuple[QuadraticPlace, ...]:
        """Return the real places, √d negative first; each has ``index`` and ``sign(x)``."""
        from hfield.fields.number_fields.quadratic.places import places_above

        return places_above(self, 0)[::-1] if self.d > 0 else ()

    def places(self) -> Iterator[Hashable]:
        """Run through the places: the infinite ones, then prime by prime."""
        from hfield.fields.number_fields.quadratic.places import all_places

        return all_places(self)

    def text(self, x: Surd, style: str = "plain") -> str:
        """Write x, such as ``1/2+3*sqrt(2)``."""
        return str(x.text(style, imaginary=self.d == -1))


def build(text: str) -> QuadraticField:
    """Return ℚ(√d) for the text of a rational number d. Raises :class:`RingError`."""
    try:
        d = rational(QQ(text))
        if d is None:  # pragma: no cover - QQ gives rational numbers only
            raise AssertionError
        _, free = reduced(d.numerator * d.denominator) if d else (0, 1)
        factorise(free)  # that it is squarefree is proved, or nothing is known of the field
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
    """Return ℚ(√d) for numbers with one root, or None without any; raises RingError for several."""
    roots = {n for x in elements if isinstance(x, Surd) for n in x.terms if n != 1}
    if len(roots) > 1:
        shown = " and ".join(map(shorten, elements))
        raise RingError(f"{shown} lie in no common quadratic field")
    if not roots:
        return None
    d = roots.pop()
    factorise(d)  # the theory of places asks for a squarefree d
    return QuadraticField(d)
