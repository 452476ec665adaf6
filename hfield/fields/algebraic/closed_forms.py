"""Closed forms: numbers given by sympy expressions, with a test for 0 that never guesses."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cached_property
from math import ceil, log
from typing import TYPE_CHECKING

import flint

from hfield.errors import CoercionError, TooLargeError, UndecidedError, shorten
from hfield.fields.algebraic.radicals import FUNCTIONS, check_size, surd_of, times
from hfield.fields.algebraic.radicands import is_long
from hfield.fields.algebraic.surds import ONE, Surd, as_surd, from_rational, sympy_of
from hfield.fields.base.balls import MAX_BITS, fingerprint, precision

if TYPE_CHECKING:
    import sympy

    from hfield.fields.algebraic.heights import Bounds


LARGEST_EXPONENT = 10**6
SIMPLIFIED = 200  # expressions of up to so many operations are given to sympy's simplify
TRANSCENDENTAL_BITS = 1_000  # a transcendental number that small must simplify to 0, or is refused
RECOGNISED = 500.0  # rational numbers of a height up to this are recognised
HIDDEN_BITS = 400  # and the bits for forms such as cos(1)^2+sin(1)^2


class Closed:
    """An immutable number given by a sympy expression in radicals, cosines, π, exponentials and the like.

    Equality is decided (see :mod:`.heights`) and is consistent with that of ``Surd``; equal numbers have
    equal hashes. The expression is built, and sympy loaded, when it is first needed.
    """

    def __init__(self, make: Callable[[], sympy.Expr]) -> None:
        self._make = make

    @cached_property
    def expr(self) -> sympy.Expr:
        """The sympy expression."""
        return self._make()

    @cached_property
    def bounds(self) -> Bounds | None:
        """Bounds for the degree and the height; None if the number is not recognised as algebraic."""
        from hfield.fields.algebraic.heights import bounds

        return bounds(self.expr)

    def __reduce__(self) -> tuple[object, ...]:
        return number, (self.expr,)

    # --- arithmetic ----------------------------------------------------------------------------

    def _combine(
        self, other: object, operation: Callable[[sympy.Expr, sympy.Expr], sympy.Expr]
    ) -> Surd | Closed:
        o = to_sympy(other)
        return NotImplemented if o is None else number(operation(self.expr, o))

    def __add__(self, other: object) -> Surd | Closed:
        return self._combine(other, lambda x, y: x + y)

    __radd__ = __add__

    def __sub__(self, other: object) -> Surd | Closed:
        return self._combine(other, lambda x, y: x - y)

    def __rsub__(self, other: object) -> Surd | Closed:
        return self._combine(other, lambda x, y: y - x)

    def __mul__(self, other: object) -> Surd | Closed:
        return self._combine(other, times)

    __rmul__ = __mul__

    def __neg__(self) -> Surd | Closed:
        return number(-self.expr)

    def __pos__(self) -> Closed:
        return self

    def __truediv__(self, other: object) -> Surd | Closed:
        o = other if isinstance(other, Closed) else as_surd(other)
        return NotImplemented if o is None else self * o.inverse()

    def __rtruediv__(self, other: object) -> Surd | Closed:
        return self.inverse() * other

    def __pow__(self, n: int) -> Surd | Closed:
        from hfield.fields.base.powers import power

        # a power of a closed form may be a surd
        return power(ONE, self if n >= 0 else self.inverse(), abs(n))  # type: ignore[type-var]

    def inverse(self) -> Surd | Closed:
        """Return 1/self; the caller has checked that it is not 0."""
        return number(1 / self.expr)

    # --- equality ------------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        if other is self:
            return True
        o = to_sympy(other)
        if o is None:
            return NotImplemented
        difference = Closed(lambda: self.expr - o)
        return difference.is_zero()

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        # a rational number has the hash of Python's and flint's, in every representation
        value = self._fraction(HIDDEN_BITS) if self.bounds is None else self.rational(float("inf"))
        return hash(fingerprint(self.ball) if value is None else value)

    def ball(self, bits: int) -> flint.acb:
        """Return a complex ball of flint around the number, computed with ``bits`` bits."""
        from hfield.fields.algebraic.evaluate import evaluate

        expr = self.expr
        with precision(bits):
            return evaluate(expr)

    def is_zero(self) -> bool:
        """Return whether the number is 0. Raises :class:`UndecidedError` for some transcendental numbers."""
        known = self.bounds
        need = None if known is None else known.degree * known.height
        return bool(self.expr == 0) or self._vanishes(need)

    def is_real(self) -> bool:
        """Return whether the number is real. Raises :class:`UndecidedError`, as :meth:`is_zero` does."""
        if self.expr.is_real:
            return True
        known = self.bounds
        # im(x) = (x − conj(x))/2i has at most twice the height and 2·log 2 more, in a field that i and
        # the conjugates of all parts generate.
        need = None if known is None else 2 * known.degree**2 * (2 * known.height + 2 * log(2))
        return self._vanishes(need, imaginary=True)

    def _vanishes(self, need: float | None, imaginary: bool = False) -> bool:
        """Return whether the number, or its imaginary part, is 0, given that otherwise its absolute value is
        at least exp(−need).
        """
        if need is not None and need / log(2) > MAX_BITS:
            need = None  # a proof of 0 would take too long, but it may turn out nonzero
        small = TRANSCENDENTAL_BITS if need is None else ceil(need / log(2)) + 2
        bits = 64
        while bits <= 4 * small + 4096:
            value = self.ball(bits).imag if imaginary else self.ball(bits)
            if not value.contains(0):
                return False
            if bits == 64 and not imaginary and value.is_finite() and self._is_identity():
                return True
            if value.abs_upper() < flint.arb(2) ** -small:
                if need is not None or _simplifies_to_zero(self.expr, imaginary):
                    return True
                break
            bits *= 2
        raise UndecidedError(
            f"whether {shorten(self)} is 0, or real, is not decided: it is below 2^-{small} and not seen "
            "to vanish; expected algebraic numbers of small degree, or numbers that differ clearly"
        )

    def _is_identity(self) -> bool:
        from hfield.fields.algebraic.identities import vanishes_identically

        return vanishes_identically(self.expr)

    def sign(self) -> int:
        """Return the sign of a real number."""
        if self.is_zero():
            return 0
        bits = 64
        while not ((value := self.ball(bits).real) > 0 or value < 0):
            bits *= 2  # ends, for is_zero has separated the number from 0
        return 1 if value > 0 else -1

    def rational(self, greatest: float = RECOGNISED) -> Fraction | None:
        """Return the number as a Fraction if it is rational and of height at most ``greatest``; else None."""
        known = self.bounds
        if known is None or known.height > greatest:
            return None
        return self._fraction(ceil(known.height / log(2)) + 1)

    def _fraction(self, bits: int) -> Fraction | None:
        """Return the number as a Fraction if numerator and denominator have at most ``bits`` bits;
        else None.
        """
        wide = 2 * bits + 64
        if wide > MAX_BITS:
            return None
        z = self.ball(wide)
        if not (z.imag.contains(0) and z.is_finite()):
            return None
        middle = z.real.mid().fmpq()
        near = Fraction(int(middle.p), int(middle.q)).limit_denominator(2**bits)
        with precision(wide):
            # the enclosure of the fraction need not be contained in that of the number
            if not z.real.overlaps(flint.arb(flint.fmpq(near.numerator, near.denominator))):
                return None
        return near if self == near else None

    def text(self, style: str = "plain") -> str:
        """Write the number; RR and CC read the style ``plain`` back."""
        from hfield.fields.algebraic.text import closed_text

        return closed_text(self.expr, style)

    def __repr__(self) -> str:
        return self.text()

    def _sympy_(self) -> sympy.Expr:
        return self.expr


def _pi() -> sympy.Expr:
    import sympy

    return sympy.pi


PI = Closed(_pi)


def number(expr: sympy.Expr) -> Surd | Closed:
    """Return a sympy number in its simplest form: a surd if possible, else a closed form.

    Raises :class:`CoercionError` for infinite or undefined values, and :class:`TooLargeError`.
    """
    import sympy

    check_size(expr)
    expr = sympy.expand(expr)
    check_size(expr)
    if expr.has(sympy.zoo, sympy.oo, -sympy.oo, sympy.nan):  # is_finite may take minutes
        raise CoercionError(f"the expression is {shorten(expr)}, not a number")
    surd = surd_of(expr)
    if surd is not None:
        return surd

    from hfield.fields.algebraic.evaluate import is_known

    if not is_known(expr):
        known = ", ".join(FUNCTIONS)
        raise CoercionError(f"{shorten(expr)} has an unknown part; expected {known}")
    closed = Closed(lambda: expr)
    value = closed.rational()
    return closed if value is None else from_rational(value)


def to_sympy(x: object) -> sympy.Expr:
    """Return a number as a sympy expression; None if it is not a number."""
    if isinstance(x, Closed):
        return x.expr
    surd = as_surd(x)
    return None if surd is None else sympy_of(surd)


def from_sympy(x: object) -> Surd | Closed | None:
    """Return a sympy number that can be tested for 0; None if x has symbols, floats or unknown parts.

    Raises :class:`UndecidedError` for a transcendental number that cannot be tested.
    """
    import sympy

    from hfield.fields.algebraic.evaluate import is_known

    if not isinstance(x, sympy.Expr) or not is_known(x):
        return None
    try:
        value = number(x)
    except OverflowError:
        raise TooLargeError("the number is too large to compute with") from None
    if isinstance(value, Closed) and value.bounds is None and value.is_zero():
        return from_rational(0)
    return value


def root(x: Surd | Closed, n: int) -> Surd | Closed:
    """Return the principal n-th root, with nested square roots simplified if sympy can."""
    import sympy

    expr = to_sympy(x)
    if expr == 0 or (isinstance(x, Closed) and x.is_zero()):
        return from_rational(0)
    if isinstance(x, Surd) and len(x.terms) > 1 and is_long(x.terms):  # sympy would factor them
        raise TooLargeError(
            "the numbers are too large for a root of a sum of roots; compute in parts"
        )
    taken = sympy.root(expr, n)
    return number(sympy.sqrtdenest(taken) if n == 2 and expr.is_real else taken)


def function(name: str) -> Callable[[Surd | Closed], Surd | Closed]:
    """Return one of ``FUNCTIONS`` as a function of numbers."""

    def call(x: Surd | Closed) -> Surd | Closed:
        import sympy

        if name in ("exp", "cosh", "sinh") and not x.ball(64).abs_upper() < LARGEST_EXPONENT:
            raise TooLargeError(f"{name}({shorten(x)}) is too large; at most {name}(10^6) is taken")
        return number(getattr(sympy, name)(to_sympy(x)))

    return call


def _simplifies_to_zero(expr: sympy.Expr, imaginary: bool) -> bool:
    import sympy

    if imaginary:
        expr = sympy.im(expr)
    return bool(expr.count_ops() <= SIMPLIFIED and sympy.simplify(expr) == 0)
