"""Angles: sums of rational multiples of named angles and of π, read from texts, trees and sympy.

:class:`SymbolicAngle` is such a sum as a value: the angle of a polar form. Multiplied by an axis n, n² = −1,
it is an :class:`AxisAngle`: the logarithm n·θ of cos θ + n·sin θ. It is not in the algebra, because θ is not
in the ring.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, TypeGuard, overload

from hfield import syntax
from hfield.errors import CoercionError, HFieldError, shorten
from hfield.fields.base.coercion import rational
from hfield.fields.base.printing import number_text, sum_text
from hfield.fields.base.ring import E, Ring
from hfield.sympy_printing import PrintedBySympy

if TYPE_CHECKING:
    import sympy

    from hfield.algebra.quaternion import Quaternion

PI = "pi"
Angle = Mapping[str, Fraction]  # the multiple of each named angle, and of π


def angle_of(x: object) -> Angle:
    """Return an angle from a text, a tree, an expression of sympy or 0. Raises :class:`CoercionError`."""
    if isinstance(x, SymbolicAngle):
        return x.multiples
    if not isinstance(x, (syntax.Number, syntax.Name, syntax.Negate, syntax.Binary, syntax.Power)):
        try:
            x = syntax.parse(str(x).replace("π", PI))
        except HFieldError:
            raise CoercionError(f"{shorten(x)} is not an angle such as 2*t + pi/3") from None
    found = _read(x)
    if isinstance(found, Fraction):
        if found:
            raise CoercionError(
                f"the angle {found} is not a rational multiple of π: its cosine is transcendental"
            )
        return {}
    return {name: c for name, c in found.items() if c}


def _read(node: object) -> Fraction | dict[str, Fraction]:
    """Return the node as a Fraction, or as a linear combination of angles."""
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


def _scaled(x: Fraction | dict[str, Fraction], c: Fraction) -> Fraction | dict[str, Fraction]:
    return x * c if isinstance(x, Fraction) else {name: c * y for name, y in x.items()}


def angle_text(name: str, parts: int) -> str:
    """Write the angle ``name/parts``."""
    return name if parts == 1 else f"{name}/{parts}"


class SymbolicAngle(PrintedBySympy):
    """An immutable sum of rational multiples of angles and of π; rings with angles read it.

    >>> from hfield import ring
    >>> t = ring("QQ(cos(t),sin(t))").angle("t")
    >>> 2*t + "pi/3", (2*t)/2 == t
    (2*t+1/3*pi, True)
    """

    multiplied_by_elements = True  # so that n·θ is left to it

    def __init__(self, multiples: Angle) -> None:
        self.multiples = {name: c for name, c in multiples.items() if c}

    def __add__(self, other: object) -> SymbolicAngle:
        found = angle_of(other)
        names = {**self.multiples, **found}
        zero = Fraction(0)
        return SymbolicAngle({n: self.multiples.get(n, zero) + found.get(n, zero) for n in names})

    __radd__ = __add__

    def __neg__(self) -> SymbolicAngle:
        return SymbolicAngle({name: -c for name, c in self.multiples.items()})

    def __sub__(self, other: object) -> SymbolicAngle:
        return self + -SymbolicAngle(angle_of(other))

    def __rsub__(self, other: object) -> SymbolicAngle:
        return -self + other

    @overload
    def __mul__(self, other: int | Fraction) -> SymbolicAngle: ...
    @overload
    def __mul__(self, other: object) -> SymbolicAngle | AxisAngle: ...
    def __mul__(self, other: object) -> SymbolicAngle | AxisAngle:
        factor = rational(other)
        if factor is not None:
            return SymbolicAngle({n: c * factor for n, c in self.multiples.items()})
        return AxisAngle(other, self) if _is_quaternion(other) else NotImplemented

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> SymbolicAngle:
        factor = rational(other)
        return NotImplemented if not factor else self * Fraction(1, factor)

    def __eq__(self, other: object) -> bool:
        try:
            return self.multiples == angle_of(other)
        except CoercionError:
            return NotImplemented

    def __hash__(self) -> int:
        return hash(frozenset(self.multiples.items()))

    def __repr__(self) -> str:
        return sum_text(
            ((number_text(c, "plain"), [(name, 1)]) for name, c in self.multiples.items()), "plain"
        )

    def _repr_latex_(self) -> str:
        import sympy

        return f"${sympy.latex(self._sympy_())}$"

    def _sympy_(self) -> sympy.Expr:
        import sympy

        known = {PI: sympy.pi}
        return sympy.Add(
            *(
                sympy.Rational(c.numerator, c.denominator) * known.get(name, sympy.Symbol(name))
                for name, c in self.multiples.items()
            )
        )


def _is_quaternion(x: object) -> TypeGuard[Quaternion]:
    return hasattr(x, "algebra")


class AxisAngle:
    """The product n·θ of an axis n, n² = −1, and an angle θ: a logarithm. Immutable.

    >>> from hfield import H
    >>> A = H("QQ(cos(t),sin(t))"); q = A("cos(t) + sin(t)*k")
    >>> q.log(), (3*q.log()).exp() == q**3, (A.k * A.ring.angle("pi/2 - t")).exp()
    (k·(t), True, sin(t) + cos(t)*k)
    """

    def __init__(self, axis: Quaternion, angle: SymbolicAngle) -> None:
        if not (axis * axis + 1).is_zero():
            raise CoercionError(
                f"the square of the axis {shorten(axis)} is not −1, so that axis·angle has no exponential"
            )
        self.axis, self.angle = axis, angle

    def exp(self) -> Quaternion:
        """Return ``cos θ + n·sin θ``. Raises :class:`CoercionError` if the ring has no such cosine."""
        cosine, sine = self.axis.ring.cosine_and_sine_of(self.angle)
        value: Quaternion = self.axis * sine + cosine
        return value

    def __mul__(self, factor: object) -> AxisAngle:
        scaled = self.angle * factor
        return AxisAngle(self.axis, scaled) if isinstance(scaled, SymbolicAngle) else NotImplemented

    __rmul__ = __mul__

    def __neg__(self) -> AxisAngle:
        return self * -1

    def __truediv__(self, divisor: object) -> AxisAngle:
        return AxisAngle(self.axis, self.angle / divisor)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, AxisAngle):
            return NotImplemented
        pairs = (self.axis, self.angle), (other.axis, other.angle), (-other.axis, -other.angle)
        return not (self.angle.multiples or other.angle.multiples) or pairs[0] in pairs[1:]

    def __hash__(self) -> int:
        return hash(frozenset((name, abs(c)) for name, c in self.angle.multiples.items()))

    def __repr__(self) -> str:
        return f"{self.axis!r}·({self.angle!r})" if self.angle.multiples else "0"


class WithAngles(Ring[E]):
    """A field that has cosines and sines of angles."""

    @abstractmethod
    def cosine_and_sine(self, angle: Angle) -> tuple[E, E]:
        """Return the cosine and sine of an angle. Raises :class:`CoercionError` if the field does not contain
        them.
        """

    @abstractmethod
    def tangent(self, angle: Angle) -> E:
        """Return the tangent of an angle. Raises :class:`CoercionError` if the field does not contain it."""

    @abstractmethod
    def sign_near_zero(self, x: E) -> int:
        """Return the sign of x if all angles are positive and small, each much smaller than the one
        before.
        """

    def angle(self, text: object) -> SymbolicAngle:
        """Return an angle such as ``"2*t + pi/3"`` as a value. Raises :class:`CoercionError`."""
        return SymbolicAngle(angle_of(text))

    def angle_of_point(self, cosine: E, sine: E) -> SymbolicAngle:
        """Return the angle with this cosine and sine, where cos² + sin² = 1.

        It is a sum Σ m·a of multiples of the angles a, and a multiple of π; here m = cos·sin′ − sin·cos′ with
        derivatives by a. Raises :class:`CoercionError` if it is not such a sum.
        """
        found: dict[str, Fraction] = {}
        for name in self.variable_names:
            x, y = (self.derivative(z, name) for z in (cosine, sine))
            slope = self.text(cosine * y - sine * x)
            try:
                found[name] = Fraction(slope)
            except ValueError:
                raise self._no_angle(cosine, sine) from None
        c, s = self.cosine_and_sine({name: -m for name, m in found.items()})
        return SymbolicAngle(found) + self._constant_angle(
            cosine * c - sine * s, cosine * s + sine * c
        )

    def _constant_angle(self, cosine: E, sine: E) -> SymbolicAngle:
        import sympy

        x, y = (self.to_sympy(z, {}) for z in (cosine, sine))
        turn = sympy.simplify(sympy.atan2(y, x) / sympy.pi)
        if not turn.is_Rational:
            raise self._no_angle(cosine, sine)
        return SymbolicAngle({PI: Fraction(int(turn.p), int(turn.q))})

    def _no_angle(self, cosine: E, sine: E) -> CoercionError:
        shown = shorten(f"({self.text(cosine)}, {self.text(sine)})")
        return CoercionError(
            f"the angle of the point {shown} is not a sum of rational multiples of π and of the angles of "
            f"{self}"
        )

    def functions(self) -> dict[str, Callable[..., E]]:
        """Cosine, sine and tangent of integer combinations of the angles, and the other functions."""
        circular = {name: syntax.OfTrees(self._function(name)) for name in ("cos", "sin", "tan")}
        return {**super().functions(), **circular}

    def _function(self, name: str) -> Callable[..., E]:
        def value(*trees: object) -> E:
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
        """Return a circular function of angles, or exp(I·angle) if the field contains I; else None."""
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


def rotated(ring: Ring[E], pair: tuple[E, E], angle: Angle) -> tuple[E, E]:
    """Return the cosine and sine of an angle, given those of the angle without its multiple of π."""
    turn = angle.get(PI)
    if not turn:
        return pair
    (cosine, sine), (c, s) = pair, cosine_and_sine_of_pi(ring, turn)
    return cosine * c - sine * s, cosine * s + sine * c


def cosine_and_sine_of_pi(ring: Ring[E], turn: Fraction) -> tuple[E, E]:
    """Return the cosine and sine of turn·π. Raises :class:`CoercionError` if the ring does not
    contain them.
    """
    if (2 * turn).denominator == 1:
        quarter = int(2 * turn) % 4
        return ring((1, 0, -1, 0)[quarter]), ring((0, 1, 0, -1)[quarter])
    import sympy

    angle = sympy.pi * sympy.Rational(turn.numerator, turn.denominator)
    return ring(sympy.cos(angle)), ring(sympy.sin(angle))


def cosine_and_sine_in(ring: Ring[E], angle: Angle) -> tuple[E, E]:
    """Return the cosine and sine of an angle in a ring. Raises :class:`CoercionError` if the ring does not
    contain them.
    """
    if isinstance(ring, WithAngles):
        return ring.cosine_and_sine(angle)
    others = [name for name in angle if name != PI]
    if others:
        raise CoercionError(f"{others[0]} is not an angle of {ring}")
    return cosine_and_sine_of_pi(ring, angle.get(PI, Fraction(0)))


def cosine_and_sine_of(ring: Ring[E], angle: object, parts: int) -> tuple[E, E]:
    """Return the cosine and sine of an angle divided into equal parts. Raises :class:`CoercionError`."""
    return cosine_and_sine_in(ring, {name: c / parts for name, c in angle_of(angle).items()})
