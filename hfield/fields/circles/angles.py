"""Angles: sums of rational multiples of named angles and of π, read from texts, trees and sympy."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from hfield import syntax
from hfield.errors import CoercionError, HFieldError, shorten
from hfield.rings.base import E, Ring

if TYPE_CHECKING:
    import sympy

PI = "pi"
Angle = Mapping[str, Fraction]  # the multiple of each named angle, and of π


def angle_of(x: object) -> Angle:
    """Return an angle from a text, a tree, an expression of sympy or 0. Raises :class:`CoercionError`."""
    if not isinstance(x, (syntax.Number, syntax.Name, syntax.Negate, syntax.Binary, syntax.Power)):
        try:
            x = syntax.parse(str(x).replace("π", PI))
        except HFieldError:
            raise CoercionError(f"{shorten(x)} is not an angle such as 2*t + pi/3") from None
    found = _read(x)
    if isinstance(found, Fraction):
        if found:
            raise CoercionError(
                f"the angle {found} is no rational multiple of π: its cosine is transcendental"
            )
        return {}
    return {name: c for name, c in found.items() if c}


def _read(node: Any) -> Any:
    """Return a Fraction, or the multiples of angles in a linear combination of them."""
    match node:
        case syntax.Number(value):
            return Fraction(value)
        case syntax.Name(name):
            return {name: Fraction(1)}
        case syntax.Negate(operand):
            return _scaled(_read(operand), Fraction(-1))
        case syntax.Binary("+" | "-" as op, left, right):
            x, y = _read(left), _scaled(_read(right), Fraction(1 if op == "+" else -1))
            if isinstance(x, Fraction) and isinstance(y, Fraction):
                return x + y
            first, second = ({} if z == 0 else z for z in (x, y))
            if isinstance(first, dict) and isinstance(second, dict):
                return {
                    n: first.get(n, Fraction(0)) + second.get(n, Fraction(0))
                    for n in {**first, **second}
                }
        case syntax.Binary("*", left, right):
            x, y = _read(left), _read(right)
            if isinstance(x, Fraction):
                return _scaled(y, x)
            if isinstance(y, Fraction):
                return _scaled(x, y)
        case syntax.Binary("/", left, right):
            x, y = _read(left), _read(right)
            if isinstance(y, Fraction) and y:
                return _scaled(x, 1 / y)
    raise CoercionError(
        "expected an angle: a sum of rational multiples of angles and of pi, such as 2*t - u + pi/2"
    )


def _scaled(x: Fraction | dict[str, Fraction], c: Fraction) -> Any:
    return x * c if isinstance(x, Fraction) else {name: c * y for name, y in x.items()}


def angle_text(name: str, parts: int) -> str:
    """Write the angle ``name/parts``."""
    return name if parts == 1 else f"{name}/{parts}"


class WithAngles(Ring[E]):
    """A field that has cosines and sines of angles."""

    @abstractmethod
    def cosine_and_sine(self, angle: Angle) -> tuple[E, E]:
        """Return cosine and sine of an angle. Raises :class:`CoercionError` where the field has none."""

    @abstractmethod
    def tangent(self, angle: Angle) -> E:
        """Return the tangent of an angle. Raises :class:`CoercionError` where the field has none."""

    def functions(self) -> dict[str, Callable[..., E]]:
        """Cosine, sine and tangent of sums of multiples of the angles, besides the other functions."""
        circular = {name: syntax.OfTrees(self._function(name)) for name in ("cos", "sin", "tan")}
        return {**super().functions(), **circular}

    def _function(self, name: str) -> Callable[..., E]:
        def value(*trees: Any) -> E:
            if len(trees) != 1:
                raise CoercionError(f"{name} takes one angle, not {len(trees)} arguments")
            return self.function_of_angle(name, angle_of(trees[0]))

        return value

    def function_of_angle(self, name: str, angle: Angle) -> E:
        """Return cos, sin or tan of an angle."""
        if name == "tan":
            return self.tangent(angle)
        return self.cosine_and_sine(angle)[name == "sin"]

    def function_of_symbols(self, x: sympy.Expr, read: Callable[[sympy.Expr], E]) -> E | None:
        """Return a circular function of angles, or exp(I·angle) where the field has an I, else None."""
        import sympy

        names = {sympy.cos: "cos", sympy.sin: "sin", sympy.tan: "tan"}
        if x.func in names:
            return self.function_of_angle(names[x.func], angle_of(x.args[0]))
        inverse = {sympy.sec: "cos", sympy.csc: "sin", sympy.cot: "tan"}
        if x.func in inverse:
            return self.inverse(self.function_of_angle(inverse[x.func], angle_of(x.args[0])))
        if isinstance(x, sympy.exp):
            cosine, sine = self.cosine_and_sine(angle_of(sympy.expand(x.args[0] / sympy.I)))
            return cosine + read(sympy.I) * sine
        return None


def rotated(ring: Any, pair: tuple[Any, Any], angle: Angle) -> tuple[Any, Any]:
    """Return cosine and sine of an angle, given those of the angle without its multiple of π."""
    turn = angle.get(PI)
    if not turn:
        return pair
    (cosine, sine), (c, s) = pair, cosine_and_sine_of_pi(ring, turn)
    return cosine * c - sine * s, cosine * s + sine * c


def cosine_and_sine_of_pi(ring: Ring, turn: Fraction) -> tuple[Any, Any]:
    """Return cosine and sine of turn·π. Raises :class:`CoercionError` where the ring does not have them."""
    if (2 * turn).denominator == 1:
        quarter = int(2 * turn) % 4
        return ring((1, 0, -1, 0)[quarter]), ring((0, 1, 0, -1)[quarter])
    import sympy

    angle = sympy.pi * sympy.Rational(turn.numerator, turn.denominator)
    return ring(sympy.cos(angle)), ring(sympy.sin(angle))


def cosine_and_sine_in(ring: Ring, angle: Angle) -> tuple[Any, Any]:
    """Return cosine and sine of an angle in a ring. Raises :class:`CoercionError` where it has none."""
    if isinstance(ring, WithAngles):
        return ring.cosine_and_sine(angle)
    others = [name for name in angle if name != PI]
    if others:
        raise CoercionError(f"{others[0]} is no angle of {ring}")
    return cosine_and_sine_of_pi(ring, angle.get(PI, Fraction(0)))


def cosine_and_sine_of(ring: Ring, angle: object, parts: int) -> tuple[Any, Any]:
    """Return cosine and sine of an angle that is divided into equal parts. Raises :class:`CoercionError`."""
    return cosine_and_sine_in(ring, {name: c / parts for name, c in angle_of(angle).items()})
