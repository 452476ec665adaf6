"""Local fields as rings: ℚ_p, GF(q)((t)), and every completion of a global field at a finite place."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import flint

from hfield.core.product import Scalar
from hfield.errors import CoercionError, HFieldError, UndecidedError
from hfield.fields.base.finite_places import FinitePlace, is_above_prime
from hfield.fields.base.printing import is_sum, parentheses, power_text
from hfield.fields.base.ring import Fact, Ring
from hfield.fields.base.roots import integral, irreducible_factors, near_root
from hfield.fields.local.completion import Completion
from hfield.fields.local.element import LocalElement
from hfield.fields.local.square_roots import minus_one, square_root
from hfield.syntax import Binary, Call, Node, Number, Reader, children, parse, rebuild, weight

if TYPE_CHECKING:
    from collections.abc import Hashable


DIGITS = 20  # to so many digits roots are found that no element of the global field is


class LocalField(Completion[LocalElement]):
    """The completion of a global field at a finite place, such as ℚ₅ or GF(9)((t)).

    ``global_field`` and ``place`` are the completed field and the place; ``residues`` is the place with its
    residue field (:mod:`hfield.fields.base.finite_places`). Elements are :class:`LocalElement`: elements of
    the global field, exact or up to O(πⁿ). Every decision depends on a square class, hence on few digits; if
    these are not known, the message of :class:`UndecidedError` gives the number of digits needed.

    >>> from hfield import ring
    >>> F = ring("Qp(5)")
    >>> F("3/10"), F("2 + 3*5 + O(5^2)"), F.sqrt(F(-1))
    (3/10, 17+O(5^2), 79753541295807+O(5^20))
    """

    theory = "local field"

    def __init__(
        self, name: str, words: str, global_field: Ring, place: Hashable, residues: FinitePlace
    ) -> None:
        super().__init__(name, words, global_field, place)
        self.residues = residues
        self.pi = global_field(residues.uniformiser)
        if is_above_prime(residues) and residues.index == 1:
            self.pi = global_field(residues.below)

    # --- what the place knows --------------------------------------------------------------------

    @property
    def doubling(self) -> int:
        """The valuation of 2; 0 unless the residue field has characteristic 2, and 0 if the field itself has
        characteristic 2.
        """
        at = self.residues
        return at.index if at.even and is_above_prime(at) else 0

    @property
    def square_digits(self) -> int:
        """The number of digits of a nonzero element that determine its square class, in characteristic not
        2.
        """
        return 2 * self.doubling + 1

    def order_of(self, x: Scalar) -> int:
        """Return the valuation of a nonzero element of the global field."""
        return int(self.residues.valuation(x))

    def pole(self, x: LocalElement) -> int:
        """Return the greatest order of a pole that x may have, 0 for none."""
        return max(0, -(x.least_valuation() or 0))

    def truncated(self, x: Scalar, n: int) -> Scalar:
        """Return the standard element of the global field that agrees with x up to πⁿ."""
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
        """Return the functions of the global field, ``sqrt``, and O; ``O(v, x)`` stands for ``v + O(x)``."""
        return {**super().functions(), "O": self._big_o, "sqrt": self._sqrt_here}

    def _big_o(self, x: LocalElement, divisor: LocalElement | None = None) -> LocalElement:
        if divisor is not None:
            return x + self._big_o(divisor)
        precision = x.least_valuation()
        return x if precision is None else LocalElement(self, self.global_field.zero, precision)

    def named_constants(self, node: Node) -> Node:
        """Return a tree in which each number written with an O(…) is replaced by ``O(v, πⁿ)``, where v
        contains its digits.

        Only ``v + O(x)`` and ``O(x)`` with exact v denote a number. Two with the same digits are replaced by
        the same call; but ``v + O(x)`` whose known digits are all 0 becomes ``O(πⁿ, πⁿ)``, and O(x) becomes
        ``O(0, πⁿ)``. Expressions in numbers, such as ``2*(v + O(x))``, stay unchanged.
        """
        return _NamedConstants(self).tree(node)

    def spelled_constants(self, node: Node) -> Node:
        """Return a tree in which ``O(v, x)`` is replaced by ``v + O(x)``, or by ``O(x)`` if v is 0."""
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
        """Return whether x is 0. Raises :class:`UndecidedError` for O(πⁿ), which may be 0."""
        if x.has_value:
            return False
        if x.precision is None:
            return True
        raise UndecidedError(
            f"whether {x} is 0 is not decided: all digits that are known are 0, and more are needed, up to "
            f"{self.big_o(x.precision + 1)} at least"
        )

    def is_known(self, x: LocalElement) -> bool:
        """Return whether x is exact, without an O(…)."""
        return x.is_exact

    def vanishes(self, x: LocalElement) -> bool:
        """Return whether all known digits of x are 0."""
        return not x.has_value

    def inverse(self, x: LocalElement) -> LocalElement:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0, :class:`UndecidedError` for O(πⁿ)."""
        return x.inverse()

    def is_square(self, x: LocalElement) -> bool:
        """Return whether x is a square. Raises :class:`UndecidedError`, whose message gives the precision
        needed.
        """
        return square_root(self, x, 1) is not None

    def sqrt(self, x: LocalElement) -> LocalElement | None:
        """Return a square root, exact if the global field contains it, else to some digits (Hensel's lemma).

        None if there is none. Raises :class:`UndecidedError`, whose message gives the number of digits
        needed.
        """
        return square_root(self, x, DIGITS)

    def roots(self, coefficients: Sequence[LocalElement]) -> list[LocalElement]:
        """Return all roots of a polynomial over ℚ in ℚ_p, if these are rational.

        Raises :class:`UndecidedError` if there are others, and over other fields.
        """
        at = self.residues
        rational = all(x.is_exact and isinstance(x.value, flint.fmpq) for x in coefficients)
        if not (rational and is_above_prime(at)):
            return super().roots(coefficients)
        factors = irreducible_factors([x.value for x in coefficients])
        for g in factors:
            if g.degree() > 1 and near_root(integral(g), at.below) is not None:
                raise UndecidedError(f"{g} has roots in {self} that are not rational numbers")
        return [self(-g[0]) for g in factors if g.degree() == 1]

    def check_digits(self, x: LocalElement, needed: int, what: str) -> None:
        """Raise :class:`UndecidedError`, with the number of digits, if fewer than ``needed`` digits of x are
        known.
        """
        known = x.digits()
        if known is None or (known >= needed and x.has_value):
            return
        start = x.least_valuation() or 0
        raise UndecidedError(
            f"{what} depends on {needed} digit{'s' * (needed > 1)} of {x} from the first that is not 0, and "
            f"{known if x.has_value else 0} are known: give it up to {self.big_o(start + needed)} at least"
        )

    @cached_property
    def level(self) -> Fact:
        """1, 2 or 4; 4 only for extensions of ℚ₂ of odd degree (Lam, *Introduction to Quadratic Forms*,
        XI.2).
        """
        squares = self.minus_one_as_squares()
        if len(squares) < 4:
            return self.level_of(squares)
        return self.level_of(squares, "fewer squares do not do, for the degree over ℚ₂ is odd")

    def minus_one_as_squares(self) -> tuple[LocalElement, ...]:
        """Return as few elements as possible whose squares add up to −1; not all of them are exact."""
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
    """Replace numbers with unknown digits by ``O(v, πⁿ)`` in a tree with shared nodes."""

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
        """Return the node ``O(v, πⁿ)`` for a number written with a precision O(…); None for other nodes."""
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
        # 5 + O(5) may occur in 5 + O(5) − O(5), from which O(5) must not be cancelled: it is not
        # the number O(5)
        return Call("O", (digits if known.has_value or not value.has_value else above, above))

    def value(self, node: Node) -> LocalElement | None:
        """Return the value of a term; None if it is not an element of the field."""
        if weight(node) > self.field.parse_limit:
            return None
        try:
            value: LocalElement = self.reader.evaluate(node)
        except HFieldError:
            return None
        return value
