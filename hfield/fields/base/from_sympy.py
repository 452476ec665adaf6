"""Read sympy's expressions, and elements of sympy's domains, as elements of a ring.

A symbol stands for the ring's generator of the same name, whatever its assumptions. Numbers are read exactly;
the ring's method ``closed_form`` interprets roots, roots of unity and cosines.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Generic, TypeAlias, TypeGuard, TypeVar

from hfield.core.product import Scalar
from hfield.errors import CoercionError, shorten
from hfield.fields.base.registry import REGISTRY

if TYPE_CHECKING:
    import sympy
    from sympy.polys.domains.domainelement import DomainElement
    from sympy.polys.polyclasses import ANP

    from hfield.fields.base.ring import Ring

    Foreign: TypeAlias = sympy.Expr | sympy.Poly | DomainElement | ANP

E = TypeVar("E", bound=Scalar)
T = TypeVar("T")


def is_of_sympy(x: object) -> bool:
    """Return whether x is an object of sympy: an expression, a matrix, an element of a domain."""
    return type(x).__module__.partition(".")[0] == "sympy"


def is_expression(x: object) -> TypeGuard[sympy.Expr]:
    """Return whether x is a sympy expression other than a quaternion."""
    if not is_of_sympy(x):
        return False
    import sympy

    return isinstance(x, sympy.Expr) and not isinstance(x, sympy.Quaternion)


def read_foreign(ring: Ring[E], x: object) -> E:
    """Return the ring element that a sympy object represents.

    Raises :class:`CoercionError` for objects that are not in the ring.
    """
    expression = _as_expression(ring, x)
    check_symbols([expression])
    return _Expression(ring, x).read(expression)


def check_symbols(values: Iterable[object]) -> None:
    """Raise :class:`CoercionError` if two different sympy symbols in one call have the same name."""
    found: dict[str, object] = {}
    for symbol in _symbols_of(values):
        known = found.setdefault(symbol.name, symbol)
        if known != symbol:
            raise CoercionError(
                f"two different symbols are called {symbol.name}, one with "
                f"{_assumptions(known)}, one with {_assumptions(symbol)}: use one of them"
            )


def _symbols_of(values: Iterable[object]) -> Iterator[sympy.Symbol]:
    for x in values:
        if isinstance(x, (list, tuple)):
            yield from _symbols_of(x)
        elif hasattr(x, "ravel") and getattr(getattr(x, "dtype", None), "kind", "") == "O":
            yield from _symbols_of(x.ravel())
        elif is_of_sympy(x):
            yield from (s for s in getattr(x, "free_symbols", ()) if hasattr(s, "name"))


def _assumptions(symbol: object) -> str:
    given = symbol.assumptions0 if hasattr(symbol, "assumptions0") else {}
    shown = [name for name in ("positive", "real", "integer", "complex") if given.get(name)]
    return f"the assumption {shown[0]}" if shown else "no assumptions"


def coefficients_in(x: object, variable: str) -> list[sympy.Expr]:
    """Return the coefficients of an expression as a polynomial in a variable, low degree first.

    Raises :class:`CoercionError` if it is not a polynomial.
    """
    import sympy

    expression = sympy.sympify(x)
    check_symbols([expression])
    symbol = next(
        (s for s in expression.free_symbols if s.name == variable), sympy.Symbol(variable)
    )
    try:
        return list(reversed(sympy.Poly(expression, symbol).all_coeffs()))
    except sympy.PolynomialError:
        raise CoercionError(f"{shorten(x)} is not a polynomial in {variable}") from None


def _as_expression(ring: Ring, x: Foreign) -> sympy.Expr:
    """Return a sympy object as an expression. Raises :class:`CoercionError` if its characteristic differs
    from the ring's.
    """
    kind = type(x).__name__
    if kind == "ANP":
        return _of_number_field(ring, x)
    if kind in ("PolyElement", "FracElement", "Poly"):
        domain = (
            x.get_domain()
            if kind == "Poly"
            else (x.ring if kind == "PolyElement" else x.field).domain
        )
        characteristic = int(domain.characteristic())
        if characteristic not in (0, ring.characteristic):
            raise CoercionError(
                f"{shorten(x)} has coefficients modulo {characteristic}, which {shorten(ring.name)} has not"
            )
        expression: sympy.Expr = x.as_expr()
        return expression
    if kind in ("GaussianInteger", "GaussianRational"):
        x = x.parent().to_sympy(x)
    if not is_expression(x):
        raise ring.refuse(x)
    return x


def _of_number_field(ring: Ring, x: ANP) -> sympy.Expr:
    """Return an element of a sympy number field in terms of the ring's generator, which has the same minimal
    polynomial.
    """
    import sympy

    modulus = [Fraction(int(c.numerator), int(c.denominator)) for c in x.mod_to_list()]
    generator = ring.generator_of(modulus[::-1])
    if generator is None:
        raise CoercionError(
            f"{shorten(x)} knows its minimal polynomial and no root of it, so {shorten(ring.name)} cannot "
            "tell which number it is: write K.to_sympy(x), for the sympy domain K"
        )
    coefficients = (sympy.Rational(int(c.numerator), int(c.denominator)) for c in x.to_list())
    expression: sympy.Expr = sympy.Integer(0)
    for c in coefficients:
        expression = expression * generator + c
    return expression


class _Expression(Generic[E]):
    """The conversion of one expression; each repeated part is read once."""

    def __init__(self, ring: Ring[E], whole: object) -> None:
        self.ring, self.whole = ring, whole
        self.generators = ring.generators()
        self.known: dict[sympy.Expr, E] = {}

    def read(self, x: sympy.Expr) -> E:
        """Return the element that an expression represents. Raises :class:`CoercionError`."""
        if x not in self.known:
            self.known[x] = self._read(x)
        return self.known[x]

    def _read(self, x: sympy.Expr) -> E:
        ring = self.ring
        if x.is_Rational:
            return ring(Fraction(int(x.p), int(x.q)) if x.q != 1 else int(x.p))
        if x.is_Symbol:
            if x.name in self.generators:
                return self.generators[x.name]
            raise self._refused(x, _named_generators([*self.generators]))
        if not x.free_symbols:
            return self._number(x)
        if x.is_Add:
            constant, rest = x.as_independent(*x.free_symbols, as_Add=True)
            parts = [self.read(y) for y in (rest.args if rest.is_Add else (rest,))]
            return _balanced(parts + [self.read(constant)] * bool(constant), lambda y, z: y + z)
        if x.is_Mul:
            constant, rest = x.as_independent(*x.free_symbols, as_Add=False)
            if constant != 1:
                return self.read(constant) * self.read(rest)
            above = [self.read(y) for y in x.args if not _is_reciprocal(y)]
            below = [self.read(1 / y) for y in x.args if _is_reciprocal(y)]
            numerator = _balanced(above or [ring.one], lambda y, z: y * z)
            return (
                ring.divide(numerator, _balanced(below, lambda y, z: y * z)) if below else numerator
            )
        if x.is_Pow and x.exp.is_Integer:
            return ring.power(self.read(x.base), int(x.exp))
        value = ring.function_of_symbols(x, self.read)
        if value is None:
            raise self._refused(x, "")
        return value

    def _number(self, x: sympy.Expr) -> E:
        """Return a number, composed of its parts, or read as a whole if the parts are not in the ring."""
        ring = self.ring
        if ring.closure or x.has(*_infinite()):  # nothing is gained by its parts
            return ring.closed_form(x)
        try:
            if x.is_Add:
                return _balanced([self.read(y) for y in x.args], lambda y, z: y + z)
            if x.is_Mul:
                return _balanced([self.read(y) for y in x.args], lambda y, z: y * z)
            if x.is_Pow and x.exp.is_Integer:
                return ring.power(self.read(x.base), int(x.exp))
        except CoercionError:
            pass
        return ring.closed_form(x)

    def _refused(self, part: sympy.Expr, why: str) -> CoercionError:
        name = shorten(self.ring.name)
        shown = f"{shorten(self.whole)} is not an element of {name}"
        if part is self.whole or str(part) == str(self.whole):
            return CoercionError(f"{shown}: {why or 'the ring has no such function'}")
        return CoercionError(
            f"{shown}: {shorten(part)} is none; {why or 'the ring has no such function'}"
        )


def _named_generators(names: list[str]) -> str:
    return f"the generators are {', '.join(names)}" if names else "the ring has no generators"


def _infinite() -> tuple[sympy.Expr, ...]:
    import sympy

    return sympy.zoo, sympy.oo, -sympy.oo, sympy.nan


def _is_reciprocal(x: sympy.Expr) -> bool:
    return bool(x.is_Pow and x.exp.is_Integer and x.exp < 0)


def _balanced(parts: list[T], combine: Callable[[T, T], T]) -> T:
    """Combine parts in a balanced tree, so that large ones are combined last."""
    while len(parts) > 1:
        pairs = [combine(x, y) for x, y in zip(parts[::2], parts[1::2], strict=False)]
        parts = pairs + parts[len(parts) // 2 * 2 :]
    return parts[0]


def closed_form(ring: Ring[E], x: sympy.Expr) -> E:
    """Return a number without symbols as an element of a ring that contains the rational numbers.

    Raises :class:`CoercionError` for other numbers.
    """
    import sympy

    if x.has(*_infinite()):
        raise CoercionError(f"{shorten(x)} is not a number")
    if x.has(sympy.Float):
        raise ring.refuse(float(x) if x.is_real else complex(x))
    if ring.characteristic == 0 and (value := REGISTRY.functions.rational_number(x)) is not None:
        return ring(value)
    larger = "" if ring.characteristic else "; CC has roots and other numbers"
    raise CoercionError(f"{shorten(x)} is not an element of {shorten(ring.name)}{larger}")
