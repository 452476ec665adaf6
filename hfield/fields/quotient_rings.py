"""R[x]/(f) for a monic f over ℤ, ℚ or GF(p), possibly reducible: dual numbers, Gaussian integers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from hfield.errors import NotInvertibleError, RingError, UndecidedError, shorten
from hfield.fields.base.printing import blackboard
from hfield.fields.base.ring import Fact, Ring, shared
from hfield.fields.base.to_sympy import polynomial_in, symbol
from hfield.fields.function_fields.extensions import (
    MAX_DEGREE,
    ExtensionElement,
    SimpleExtension,
    read_polynomial,
)
from hfield.fields.linear_algebra.echelon import null_space, solution

if TYPE_CHECKING:
    import sympy

    from hfield.fields.base.flint_types import Coefficient


class QuotientRing(SimpleExtension):
    """R[x]/(f); ``gen`` is the class of x.

    >>> from hfield import H, ring
    >>> R = ring("QQ[x]/(x^2)")
    >>> R("(1 + 3*x)^5"), R("1/(2 + x)"), ring("ZZ[I]")("(1+I)^2")
    (15*x+1, -1/4*x+1/2, 2*I)
    >>> H(R)("x*i").is_zero_divisor()
    True
    """

    is_field = False

    def __init__(self, base: Ring, gen_name: str, modulus: Sequence[Coefficient]) -> None:
        nameless = SimpleExtension("", "", base, gen_name, modulus)
        shown = nameless.text(ExtensionElement(nameless, modulus))
        self._modulus_text = shown
        gaussian = base.name == "ZZ" and gen_name == "I"
        name = "ZZ[I]" if gaussian else f"{base.name}[{gen_name}]/({shown})"
        super().__init__(name, blackboard(name), base, gen_name, modulus)

    def __reduce__(self) -> tuple[object, ...]:
        return build, (self.base, self.gen_name, self._modulus_text)

    @property
    def data(self) -> dict[str, object]:
        """The base ring, the polynomial (low degree first) and the name of the class of x, as JSON data."""
        return {**super().data, "kind": "quotient ring"}

    @property
    def variables(self) -> tuple[str, ...]:  # type: ignore[override]
        """None: x can only take roots of f as values."""
        return ()

    @property
    def fractions(self) -> Ring | None:
        """ℚ(I), for the Gaussian integers."""
        if self.name != "ZZ[I]":
            return None
        from hfield.fields.number_fields.quadratic.ring import build as build_quadratic

        return build_quadratic("-1")

    def generators(self) -> dict[str, ExtensionElement]:
        """Return the class of x, unless it is the number I."""
        return {} if self.gen_name == "I" else self.names()

    def closed_form(self, x: sympy.Expr) -> ExtensionElement:
        """Return the element of a closed form: I if the ring contains it, or a rational number. Raises
        :class:`CoercionError`.
        """
        import sympy

        if x is sympy.I and self.gen_name == "I":
            return self.gen
        return self.from_below(self.base.closed_form(x))

    def to_sympy(self, x: ExtensionElement, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return x as a polynomial in the generator."""
        import sympy

        gen = sympy.I if self.gen_name == "I" else symbol(str(self.gen_name), symbols)
        return polynomial_in(gen, (self.base.to_sympy(c, symbols) for c in x.coefficients))

    def _rows(self, x: ExtensionElement) -> list[list[Coefficient]]:
        """Return the matrix of multiplication by x over the fractions of R; its columns are x·genⁿ."""
        F, out = self.base.fractions or self.base, []
        for _ in range(self.degree):
            out.append([F(c) for c in x.coefficients])
            x = x * self.gen
        return [list(row) for row in zip(*out, strict=True)]

    def inverse(self, x: ExtensionElement) -> ExtensionElement:
        """Return 1/x. Raises :class:`NotInvertibleError`."""
        F = self.base.fractions or self.base
        found = solution(F, self._rows(x), [[F(c)] for c in self.one.coefficients])
        values = (_back(self.base, row[0]) for row in found or [])
        inverse = [c for c in values if c is not None]
        if len(inverse) < self.degree:
            raise NotInvertibleError(f"{shorten(self.text(x))} has no inverse in {self.name}")
        return ExtensionElement(self, inverse)

    def annihilator(self, x: ExtensionElement) -> ExtensionElement | None:
        """Return some nonzero y with x·y = 0, or None."""
        F = self.base.fractions or self.base
        found = null_space(F, self._rows(x), self.degree)
        if not found:
            return None
        y = found[0]
        if F is not self.base:
            common = 1
            for c in y:
                common = common * int(c.q) // _gcd(common, int(c.q))
            y = [c * common for c in y]
        return ExtensionElement(self, [self.base(c) for c in y])

    @property
    def level(self) -> Fact:
        """The level: 1 if −1 is a square in the base ring or x² = −1, else unknown."""
        if self.name == "ZZ[I]":
            return Fact(1, "−1 = I^2")
        return super().level

    def minus_one_as_squares(self) -> tuple[ExtensionElement, ...]:
        """Return a known square root of −1."""
        return (self.gen,) if self.name == "ZZ[I]" else super().minus_one_as_squares()

    def sqrt(self, x: ExtensionElement) -> ExtensionElement | None:
        """Raise :class:`UndecidedError`: there may be many roots, or none."""
        raise UndecidedError(f"square roots in {self.name} are not decided")


def _gcd(a: int, b: int) -> int:
    while b:
        a, b = b, a % b
    return a


def _back(base: Ring, c: Coefficient) -> Coefficient | None:
    """Return an element of the field of fractions as an element of R, or None."""
    if base.is_field:
        return c
    return base(int(c.p)) if c.q == 1 else None


def build(base: Ring, variable: str, text: str) -> QuotientRing:
    """Return R[x]/(f). Raises :class:`RingError` unless f is monic of positive degree."""
    what = f"{base}[{variable}]/({shorten(text)})"
    f = read_polynomial(base, variable, text, what)
    if not 2 <= len(f) - 1 <= MAX_DEGREE:
        raise RingError(f"{what}: expected a polynomial of a degree from 2 to {MAX_DEGREE}")
    if not base.is_unit(f[-1]):
        raise RingError(f"{what}: the leading coefficient has no inverse in {base}")
    scale = base.inverse(f[-1])
    return shared(QuotientRing, base, variable, tuple(scale * c for c in f))
