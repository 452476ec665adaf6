"""Local fields as rings: ℚ_p, GF(q)((t)), and every completion of a global field at a finite place.

What the completions of a global field share: their elements are elements of that field, first of all.

Square roots in local fields, by Hensel's lemma, and −1 as a sum of squares.

Where 2 is not invertible among the residues, a unit is first brought as near to 1 as squares bring it (its
quadratic defect: O'Meara, *Introduction to Quadratic Forms*, §63A).
"""

from __future__ import annotations

import itertools
from abc import abstractmethod
from collections.abc import Callable, Hashable, Iterator, Sequence
from functools import cached_property
from random import Random
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import CoercionError, HFieldError, UndecidedError
from hfield.fields.local.element import LocalElement
from hfield.product import Scalar
from hfield.rings.base import E, Known, Ring, shared
from hfield.rings.operators import Overfield
from hfield.rings.printing import is_sum, parentheses, power_text
from hfield.rings.roots import integral, irreducible_factors, near_root
from hfield.syntax import Binary, Call, Node, Number, Reader, children, parse, rebuild, weight

if TYPE_CHECKING:
    from collections.abc import Hashable

    from hfield.fields.function_fields.quotients import Quotient


class Completion(Overfield[E]):
    """The completion of a global field at a place; ``global_field`` and ``place`` say of what and where.

    Elements are :class:`~hfield.rings.operators.Element` with a ``value`` in the global field, and texts mean
    what they mean there.
    """

    def __init__(self, name: str, words: str, global_field: Ring, place: Hashable) -> None:
        self.name, self._words = name, words
        self.global_field, self.place = global_field, place
        self.characteristic = global_field.characteristic
        self.gen_name = global_field.gen_name
        self.parse_limit = global_field.parse_limit

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (self.global_field.completion, "".join(str(self.place).split()))

    @property
    def data(self) -> dict[str, Any]:
        """The field by the one that is completed, and the place."""
        at = self.place_data(self.place)
        return {"kind": "completion", "of": self.global_field.data, "place": at}

    def place_data(self, place: Any) -> dict[str, Any]:
        """Return the place of the global field as JSON data."""
        return self.global_field.place_data(place)

    def in_words(self) -> str:
        """Say what the field is."""
        return self._words

    def from_below(self, x: object) -> E:
        """Turn a number or an element of the global field into an exact element.

        Raises :class:`CoercionError`.
        """
        return self.exact(self.global_field(x))

    def embed_from(self, source: Ring) -> Callable[[Any], E] | None:
        """Return the inclusion of the global field."""
        return self if source == self.global_field else None

    @abstractmethod
    def exact(self, value: Scalar) -> E:
        """Return an element of the global field as one of this field."""

    @property
    def gen(self) -> E:
        """The generator of the global field."""
        return self.exact(self.global_field.gen) if self.gen_name else super().gen

    def names(self) -> dict[str, E]:
        """What names mean in the global field."""
        return {name: self.exact(x) for name, x in self.global_field.names().items()}

    def functions(self) -> dict[str, Callable[..., E]]:
        """What functions mean in the global field."""
        return {name: self._lifted(f) for name, f in self.global_field.functions().items()}

    def _lifted(self, f: Callable[..., Scalar]) -> Callable[..., E]:
        """Return a function of the global field as one of exact elements."""

        def lifted(*xs: Any) -> E:
            for x in xs:
                if not self.is_known(x):
                    raise UndecidedError(
                        f"a function of {self.text(x)} hangs on digits that are not known"
                    )
            return self(f(*(x.value for x in xs)))

        return lifted

    def places(self) -> Iterator[Hashable]:
        """Run through the places: there is one."""
        yield self.place

    def random(self, rng: Random) -> E:
        """Return a small random exact element; the same for the same seed."""
        return self.exact(self.global_field.random(rng))


DIGITS = 20  # to so many digits roots are found that no element of the global field is


class LocalField(Completion[LocalElement]):
    """The completion of a global field at a finite place, such as ℚ₅ or GF(9)((t)).

    ``global_field`` and ``place`` say of what and where, ``residues`` is the place with its residue field
    (:mod:`hfield.structure.finite_places`). Elements are :class:`LocalElement`: elements of the global
    field, exact or up to O(πⁿ). Every decision hangs on a square class, hence on few digits; where they are
    not known, :class:`UndecidedError` names how many are needed.

    >>> from hfield import ring
    >>> F = ring("Qp(5)")
    >>> F("3/10"), F("2 + 3*5 + O(5^2)"), F.sqrt(F(-1))
    (3/10, 17+O(5^2), 79753541295807+O(5^20))
    """

    theory = "local field"

    def __init__(
        self, name: str, words: str, global_field: Ring, place: Hashable, residues: Any
    ) -> None:
        super().__init__(name, words, global_field, place)
        self.residues = residues
        self.pi = global_field(residues.uniformiser)
        if self.characteristic == 0 and residues.index == 1:
            self.pi = global_field(residues.below)

    # --- what the place knows --------------------------------------------------------------------

    @property
    def doubling(self) -> int:
        """The valuation of 2, 0 unless the residue field has characteristic 2; 0 in characteristic 2, too."""
        return int(self.residues.index) if self.residues.even and not self.characteristic else 0

    @property
    def square_digits(self) -> int:
        """How many digits of a nonzero element tell its square class, where the characteristic is not 2."""
        return 2 * self.doubling + 1

    def order_of(self, x: Scalar) -> int:
        """Return the valuation of a nonzero element of the global field."""
        return int(self.residues.valuation(x))

    def pole(self, x: LocalElement) -> int:
        """Return the greatest order of a pole that x may have, 0 for none."""
        return max(0, -(x.least_valuation() or 0))

    def truncated(self, x: Scalar, n: int) -> Scalar:
        """Return the standard element of the global field that is x up to πⁿ."""
        if self.global_field.is_zero(x):
            return x
        standard: Scalar = self.global_field(self.residues.truncated(x, n))
        return standard

    @cached_property
    def uniformiser(self) -> LocalElement:
        """An element of valuation 1."""
        return LocalElement(self, self.pi)

    def exact(self, value: Scalar) -> LocalElement:
        """Return an element of the global field."""
        return LocalElement(self, value)

    # --- elements --------------------------------------------------------------------------------

    def up_to(self, x: Scalar, n: int) -> LocalElement:
        """Return ``x + O(πⁿ)``."""
        return self(x) + LocalElement(self, self.global_field.zero, n)

    def functions(self) -> dict[str, Callable[..., LocalElement]]:
        """Return the functions of the global field, ``sqrt``, and O: ``O(v, x)`` is ``v + O(x)``."""
        return {**super().functions(), "O": self._big_o, "sqrt": self._sqrt_here}

    def _big_o(self, x: LocalElement, divisor: LocalElement | None = None) -> LocalElement:
        if divisor is not None:
            return x + self._big_o(divisor)
        precision = x.least_valuation()
        return x if precision is None else LocalElement(self, self.global_field.zero, precision)

    def named_constants(self, node: Node) -> Node:
        """Return a tree in which each number that is written up to an O(…) is ``O(v, πⁿ)``, v its digits.

        Only ``v + O(x)`` and ``O(x)`` with exact v write a number. Two of the same digits are the same; but
        ``v + O(x)`` with digits 0 alone is ``O(πⁿ, πⁿ)``, and O(x) is ``O(0, πⁿ)``. What is computed from
        numbers, as in ``2*(v + O(x))``, stays as it is.
        """
        return _NamedConstants(self).tree(node)

    def spelled_constants(self, node: Node) -> Node:
        """Return a tree with ``v + O(x)``, or ``O(x)`` where v is 0, for each ``O(v, x)``."""
        below = [self.spelled_constants(x) for x in children(node)]
        match node:
            case Call("O", (v, _)):
                rest = Call("O", (below[1],))
                return rest if v == Number(0) else Binary("+", below[0], rest)
        return rebuild(node, below) if below else node

    def _sqrt_here(self, x: LocalElement) -> LocalElement:
        y = self.sqrt(x)
        if y is None:
            raise CoercionError(f"{self.text(x)} has no square root in {self.name}")
        return y

    def is_zero(self, x: LocalElement) -> bool:
        """Tell whether x is 0. Raises :class:`UndecidedError` for O(πⁿ), which may be 0."""
        if x.has_value:
            return False
        if x.precision is None:
            return True
        raise UndecidedError(
            f"whether {x} is 0 is not decided: all digits that are known are 0, and more are needed, up to "
            f"{self.big_o(x.precision + 1)} at least"
        )

    def is_known(self, x: LocalElement) -> bool:
        """Tell whether x is one element, without an O(…)."""
        return x.is_exact

    def vanishes(self, x: LocalElement) -> bool:
        """Tell whether x is 0 as far as its digits are known."""
        return not x.has_value

    def inverse(self, x: LocalElement) -> LocalElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0, :class:`UndecidedError` for O(πⁿ)."""
        return x.inverse()

    def is_square(self, x: LocalElement) -> bool:
        """Tell whether x is a square. Raises :class:`UndecidedError` naming the digits that it takes."""
        return square_root(self, x, 1) is not None

    def sqrt(self, x: LocalElement) -> LocalElement | None:
        """Return a square root, exact where the global field has it, else to some digits (Hensel's lemma).

        None where there is none. Raises :class:`UndecidedError` naming the digits that it takes.
        """
        return square_root(self, x, DIGITS)

    def roots(self, coefficients: Sequence[LocalElement]) -> list[LocalElement]:
        """Return all roots of a polynomial over ℚ in ℚ_p, if these are rational.

        Raises :class:`UndecidedError` where there are others, and over other fields.
        """
        if not all(x.is_exact and isinstance(x.value, flint.fmpq) for x in coefficients):
            return super().roots(coefficients)
        factors = irreducible_factors([x.value for x in coefficients])
        for g in factors:
            if g.degree() > 1 and near_root(integral(g), self.residues.below) is not None:
                raise UndecidedError(f"{g} has roots in {self} that are no rational numbers")
        return [self(-g[0]) for g in factors if g.degree() == 1]

    def check_digits(self, x: LocalElement, needed: int, what: str) -> None:
        """Raise :class:`UndecidedError`, naming the digits, where fewer than ``needed`` are known of x."""
        known = x.digits()
        if known is None or (known >= needed and x.has_value):
            return
        start = x.least_valuation() or 0
        raise UndecidedError(
            f"{what} hangs on {needed} digit{'s' * (needed > 1)} of {x} from the first that is not 0, and "
            f"{known if x.has_value else 0} are known: give it up to {self.big_o(start + needed)} at least"
        )

    @cached_property
    def level(self) -> Known:
        """1, 2 or 4: 4 only above 2, in odd degree over ℚ₂ (Lam, *Introduction to Quadratic Forms*, XI.2)."""
        squares = self.minus_one_as_squares()
        if len(squares) < 4:
            return self.level_of(squares)
        return self.level_of(squares, "fewer squares do not do, for the degree over ℚ₂ is odd")

    def minus_one_as_squares(self) -> tuple[LocalElement, ...]:
        """Return as few elements as possible, not all of them exact, whose squares add up to −1."""
        return minus_one(self)

    def key(self, x: LocalElement) -> Hashable:
        """Return the key of the value, and the precision."""
        return self.global_field.key(x.value), x.precision

    def text(self, x: LocalElement, style: str = "plain") -> str:
        """Write x, such as ``2+O(5^4)``."""
        shown = self.global_field.text(x.value, style)
        if x.precision is None:
            return shown
        return (
            f"{shown}+{self.big_o(x.precision, style)}"
            if x.has_value
            else self.big_o(x.precision, style)
        )

    def big_o(self, n: int, style: str = "plain") -> str:
        """Write O(πⁿ)."""
        pi = self.global_field.text(self.pi, style)
        if n not in (0, 1) and (is_sum(pi) or not pi.replace("_", "").isalnum()):
            pi = parentheses(pi, style)
        inside = "1" if n == 0 else power_text(pi, n, style)
        return rf"O\left({inside}\right)" if style == "latex" else f"O({inside})"


class _NamedConstants:
    """Puts ``O(v, πⁿ)`` for numbers with unknown digits into one tree, whose nodes may be shared."""

    def __init__(self, field: LocalField) -> None:
        self.field = field
        functions: dict[str, Callable[..., LocalElement]]
        functions = {"/": field.divide, "**": field.power, **field.functions()}
        self.reader = Reader(field, field.names(), functions, field.name, field.parse_limit)
        self.named: dict[int, tuple[Node, Node]] = {}  # with the node, so that no id is used twice

    def tree(self, node: Node) -> Node:
        """Return the tree with these names."""
        if id(node) not in self.named:
            below = children(node)
            made = self.number(node) or (
                rebuild(node, list(map(self.tree, below))) if below else node
            )
            self.named[id(node)] = node, made
        return self.named[id(node)][1]

    def number(self, node: Node) -> Node | None:
        """Return the name of the number that a node writes up to an O(…), None where it writes none."""
        match node:
            case (
                Call("O", (v, x))
                | Binary("+", v, Call("O", (x,)))
                | Binary("+", Call("O", (x,)), v)
            ):
                pass
            case Call("O", (x,)):
                v = Number(0)
            case _:
                return None
        value, rest = self.value(v), self.value(Call("O", (x,)))
        if value is None or rest is None or not value.is_exact or rest.precision is None:
            return None
        known = LocalElement(self.field, value.value, rest.precision)
        (above,) = children(parse(self.field.big_o(rest.precision)))
        digits = parse(self.field.global_field.text(known.value))
        # 5 + O(5) may stand in 5 + O(5) − O(5), where O(5) would cancel: it is not the number O(5)
        return Call("O", (digits if known.has_value or not value.has_value else above, above))

    def value(self, node: Node) -> LocalElement | None:
        """Return the value of a term, None where it is no element of the field."""
        if weight(node) > self.field.parse_limit:
            return None
        try:
            value: LocalElement = self.reader.evaluate(node)
        except HFieldError:
            return None
        return value


TRIES = 5_000


def square_root(F: LocalField, x: LocalElement, digits: int) -> LocalElement | None:
    """Return a square root of x, or None where there is none.

    It is exact if x is and its root is in the global field, else known to ``digits`` digits, or to as many as
    x allows. Raises :class:`UndecidedError` naming the digits of x that it takes.
    """
    if x.is_exact:
        root = F.global_field.sqrt(x.value)
        if root is not None or not x.has_value:
            return LocalElement(F, x.value if root is None else root)
    elif F.characteristic != 2 and not x.has_value:
        F.check_digits(x, F.square_digits, "its square class")
    if F.characteristic == 2:
        return _even_root(F, x)
    n = x.valuation()
    if n % 2:
        return None
    known = x.digits()
    wanted = digits if known is None else min(digits, known - F.doubling)
    scale = F.global_field.power(F.pi, n // 2)
    unit = F.global_field.divide(x.value, scale * scale)
    start = _near_root(F, F.truncated(unit, max(wanted, 0) + 2 * F.doubling + 1), known)
    if start is None:
        return None
    F.check_digits(x, F.square_digits, f"whether {x} is a square")
    root = hensel(F, (-unit, F.global_field.zero, F.global_field.one), start, wanted)
    return LocalElement(F, root * scale, wanted + n // 2)


def _even_root(F: LocalField, x: LocalElement) -> LocalElement | None:
    """Answer in characteristic 2 for what has no root among the rational functions."""
    if x.is_exact:
        return None  # k is perfect, so that x = u² + t·v² is a square only if v = 0
    slope = _derivative(x.value)
    shift = F.order_of(_derivative(F.pi))
    if slope.num != 0 and x.precision is not None and F.order_of(slope) - shift < x.precision - 1:
        return None  # a term of odd degree is known
    raise UndecidedError(
        f"whether {x} is a square in {F} is not decided by any number of digits: it must be given exactly"
    )


def _derivative(x: Quotient) -> Quotient:
    """Return dx/dt for a rational function in characteristic 2."""
    n, d = x.num, x.den
    slope: Quotient = x.field.quotient(n.derivative() * d + n * d.derivative(), d * d)
    return slope


def _near_root(F: LocalField, unit: Scalar, known: int | None) -> Scalar | None:
    """Return y with v(y² − u) > 2·v(2) for a unit u of the global field, or None if u is no square.

    Where only ``known`` digits of u count, y² has them, too; None says that no unit with them is a square.
    """
    K: Ring[Scalar] = F.global_field
    k, e = F.residues, F.doubling
    if not e:
        root = k.sqrt(k.reduce(unit))
        return None if root is None else K(k.lift(root))
    y, digits = K(k.lift(k.sqrt(k.reduce(unit)))), 2 * e + 2
    while True:
        rest = K.divide(unit, y * y) - K.one
        n = digits if K.is_zero(rest) else F.order_of(rest)
        if n > 2 * e or (known is not None and n >= known):
            return y
        if n % 2:
            return None
        # (1 + π^m·d)² = 1 + 2π^m·d + π^2m·d², where 2π^m is smaller than π^2m, or as small for n = 2e
        step = K.power(F.pi, n // 2)
        leading = k.reduce(K.divide(rest, step * step))
        if n < 2 * e:
            factor = K.one + step * K(k.lift(k.sqrt(leading)))
        else:
            # (1 + 2z)² = 1 + 4(z² + z)
            found = k.quadratic_root(k.one, k.one, k.reduce(K.divide(rest, K(4))))
            if found is None:
                return None
            z = k.multiply(found[0], k.inverse(found[1]))
            factor = K.one + K(2) * K(k.lift(z))
        y = F.truncated(y * factor, digits)


def hensel(F: LocalField, f: tuple[Scalar, Scalar, Scalar], x: Scalar, digits: int) -> Scalar:
    """Return a root of ``f₀ + f₁·X + f₂·X²`` up to π^digits, from an x with v(f(x)) > 2·v(f′(x)).

    All are elements of the global field. Newton's steps double the digits of the root near x, of which there
    is one (Hensel's lemma).
    """
    K: Ring[Scalar] = F.global_field
    while True:
        value, slope = f[0] + x * (f[1] + x * f[2]), f[1] + x * (f[2] + f[2])
        n = F.order_of(slope)
        if K.is_zero(value) or F.order_of(value) - n >= digits:
            return F.truncated(x, digits)
        reached = F.order_of(value) - n  # the valuation of x less the root
        x = F.truncated(x - K.divide(value, slope), min(2 * reached - n, max(digits, n + 1)))


def minus_one(F: LocalField) -> tuple[LocalElement, ...]:
    """Return as few elements as the level says whose squares add up to −1."""
    root = F.sqrt(-F.one)
    if root is not None:
        return (root,)
    if F.doubling and F.doubling * (F.residues.order.bit_length() - 1) % 2:
        root = F.sqrt(F(-7))
        assert root is not None  # −7 is 1 modulo 8
        return F.one, F.one, F(2), root
    rng = Random(1)
    for n in itertools.islice(itertools.count(), TRIES):
        x = F(n) if n < 10 else F(sum((F.random(rng).value * F.pi**m for m in range(4)), F.pi * 0))
        root = F.sqrt(-F.one - x * x)
        if root is not None:
            return x, root
    raise UndecidedError(f"−1 is a sum of two squares in {F}, but none were found in {TRIES} tries")
