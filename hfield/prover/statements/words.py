"""Expand the words ``dot``, ``cross``, ``abs`` and the comparisons ``>= > <= <`` by their definitions.

They are expanded before a statement is decided, so the methods need not know them. Comparisons and moduli are
interpreted in the real closure of the ordered field, where the nonnegative elements are the squares:

* ``abs(q)`` is the only number m² with m⁴ = norm(q).
* ``x >= 0``, as a claim, means: x = 0, or x ≠ −z² for all z. As a hypothesis it means x = z² for some z.
* ``x > 0``, as a claim, means: x ≠ −z² for all z. As a hypothesis it means x = z² for some z ≠ 0.

m and z are coordinates of new unknowns, which are universally quantified.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NoReturn

from hfield.errors import NotationError
from hfield.fields.base.ring import INFINITY, Ring
from hfield.prover.statements.matrices import ENTRIES
from hfield.prover.statements.trees import divides_in, implication, names_in, walk_once
from hfield.syntax import (
    ORDER,
    Call,
    Compare,
    Exists,
    Index,
    Logic,
    Name,
    Node,
    Not,
    Number,
    Power,
    children,
    parse,
    rebuild,
)

ARGUMENTS = {"dot": 2, "cross": 2, "abs": 1}
HELPERS = tuple(name for own in ENTRIES.values() for name in own)
ZERO = Number(0)


def order_word(node: Node) -> Node | None:
    """Return a comparison or modulus in a statement; None if it has neither."""
    for n in walk_once(node):
        if isinstance(n, Compare) and n.op in ORDER:
            return n
        if isinstance(n, Call) and n.function == "abs":
            return n
    return None


def is_about_order(text: str) -> bool:
    """Return whether a text is a statement with a comparison or a modulus."""
    try:
        return order_word(parse(text)) is not None
    except NotationError:
        return False


def has_order(field: Ring) -> bool:
    """Return whether a ring is known to be an ordered one, of characteristic 0."""
    return not field.characteristic and (not field.is_exact or field.level.value == INFINITY)


def need_order(node: Node, field: Ring | None, text: str) -> None:
    """Raise :class:`NotationError` for a word that needs an ordering, if the field has none."""
    word = order_word(node)
    if word is None or field is None or has_order(field):
        return
    name = word.op if isinstance(word, Compare) else "abs"
    raise NotationError(
        f"{name} needs an ordered field, such as QQ, QQ(sqrt(2)) or RR, and {field.name} is not known to "
        "have an order",
        text,
        word.position,
    )


def without_words(
    node: Node,
    field: Ring | None,
    hamilton: bool,
    text: str,
    is_scalar: Callable[[Node], bool],
) -> Node:
    """Return an equivalent statement without these words.

    Moduli are defined if the norm is never negative: in H, if ``hamilton``. ``is_scalar`` tests whether a
    term without these words is a scalar. Raises :class:`NotationError`.
    """
    need_order(node, field, text)
    if not any(
        (isinstance(n, Call) and n.function in ARGUMENTS)
        or (isinstance(n, Compare) and n.op in ORDER)
        for n in walk_once(node)
    ):
        return node
    quantified = any(isinstance(n, Exists) for n in walk_once(node))
    taken = names_in(node).union(() if field is None else field.names())
    free = [name for name in HELPERS if name not in taken]
    writer = _StatementWriter(hamilton, text, quantified, free, is_scalar)
    written = writer.statement(node, True)
    return implication(tuple(writer.hypotheses), written)


class _StatementWriter:
    def __init__(
        self,
        hamilton: bool,
        text: str,
        quantified: bool,
        free: list[str],
        is_scalar: Callable[[Node], bool],
    ) -> None:
        self.hamilton, self.text = hamilton, text
        self.quantified, self.free, self.is_scalar = quantified, free, is_scalar
        self.moduli: dict[Node, Node] = {}
        self.hypotheses: list[Node] = []

    def fail(self, message: str, node: Node) -> NoReturn:
        raise NotationError(message, self.text, node.position)

    def statement(self, node: Node, claimed: bool) -> Node:
        """Expand a statement, as a claim or, unless ``claimed``, as a hypothesis."""
        match node:
            case Compare(op, left, right):
                x, y = self.term(left), self.term(right)
                return self.order(node, x, y, claimed) if op in ORDER else rebuild(node, [x, y])
            case Not(x):
                return rebuild(node, [self.statement(x, not claimed)])
            case Logic("<=>", left, right) if _compares(node):
                there, back = (
                    Logic("=>", self.statement(x, not claimed), self.statement(y, claimed))
                    for x, y in ((left, right), (right, left))
                )
                return Logic("and", there, back, position=node.position)
            case Logic(op, left, right):
                first = self.statement(left, claimed != (op == "=>"))
                return rebuild(node, [first, self.statement(right, claimed)])
            case Exists():
                return rebuild(node, [self.statement(node.body, claimed)])
        return self.term(node)

    def order(self, node: Compare, left: Node, right: Node, claimed: bool) -> Node:
        """Expand a comparison of scalars, by squares."""
        self.need_no_quantifier(node.op, node)
        for side in (left, right):
            if not self.is_scalar(side):
                self.fail(f"{node.op} compares scalars, and this is a quaternion", side)
        large, small = (left, right) if node.op in (">=", ">") else (right, left)
        x = large if small == ZERO else large - small
        z = self.helper(node)
        if not claimed:
            positive = Compare("==", x, Power(z, 2))
            if node.op in (">=", "<="):
                return positive
            return Logic("and", positive, Compare("!=", z, ZERO))
        not_negative = Compare("!=", x, -Power(z, 2))
        if node.op in (">", "<"):
            return not_negative
        return Logic("or", Compare("==", x, ZERO), not_negative)

    def term(self, node: Node) -> Node:
        """Expand a term."""
        written = rebuild(node, [self.term(x) for x in children(node)])
        if not isinstance(written, Call) or written.function not in ARGUMENTS:
            return written
        wanted, x = ARGUMENTS[written.function], written.arguments
        if len(x) != wanted:
            self.fail(f"{written.function} takes {wanted} argument{'s'[: wanted - 1]}", node)
        if written.function == "abs":
            return self.modulus(x[0], node)
        product = Call("vector", (x[0],)) * Call("vector", (x[1],))
        if written.function == "cross":
            return Call("vector", (product,), position=node.position)
        return -Call("scalar", (product,), position=node.position)

    def modulus(self, x: Node, node: Node) -> Node:
        """Return m² for a new m with m⁴ = norm(x)."""
        if not self.hamilton:
            self.fail("abs is decided in H, where no norm is negative", node)
        self.need_no_quantifier("abs", node)
        if divides_in(x):
            self.fail("the argument of abs has no quotient and no inverse here", node)
        if x not in self.moduli:
            m = self.helper(node)
            self.moduli[x] = Power(m, 2)
            self.hypotheses.append(Compare("==", Power(m, 4), Call("norm", (x,))))
        return self.moduli[x]

    def need_no_quantifier(self, word: str, node: Node) -> None:
        if self.quantified:
            self.fail(f"a statement cannot have both {word} and 'exists'", node)

    def helper(self, node: Node) -> Node:
        """Return a new scalar unknown."""
        if not self.free:
            self.fail(f"a statement has at most {len(HELPERS)} moduli and comparisons", node)
        return Index(Name(self.free.pop(0)), 0)


def _compares(node: Node) -> bool:
    """Return whether a statement has a comparison."""
    return any(isinstance(n, Compare) and n.op in ORDER for n in walk_once(node))


__all__ = [
    "ARGUMENTS",
    "HELPERS",
    "has_order",
    "is_about_order",
    "need_order",
    "order_word",
    "without_words",
]
