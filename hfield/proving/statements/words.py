"""Words of the language that others define: ``dot``, ``cross``, and ``abs`` over the real numbers.

They are written out before anything is decided, so that methods and checker do not know of them. The
modulus is the number m² with m⁴ = norm(q), of which there is exactly one over a real closed field; m is a
coordinate of an unknown that does not stand in the statement.
"""

from __future__ import annotations

from typing import NoReturn

from hfield.errors import NotationError
from hfield.proving.statements.matrices import ENTRIES
from hfield.proving.statements.trees import divides_in, implication, names_in, walk_once
from hfield.rings.base import Ring
from hfield.syntax import Call, Compare, Exists, Index, Name, Node, Power, children, rebuild

ARGUMENTS = {"dot": 2, "cross": 2, "abs": 1}
HELPERS = tuple(name for own in ENTRIES.values() for name in own)


def without_words(node: Node, field: Ring | None, hamilton: bool, text: str) -> Node:
    """Return a statement that says the same without these words.

    There are moduli where the norm has no negative values: in H, as ``hamilton`` says, over the real
    numbers. Raises :class:`NotationError`.
    """
    if not any(isinstance(n, Call) and n.function in ARGUMENTS for n in walk_once(node)):
        return node
    quantified = any(isinstance(n, Exists) for n in walk_once(node))
    taken = names_in(node).union(() if field is None else field.names())
    free = [name for name in HELPERS if name not in taken]
    writer = _Writer(field, hamilton, text, quantified, free)
    written = writer.write(node)
    return implication(tuple(writer.hypotheses), written)


class _Writer:
    def __init__(
        self, field: Ring | None, hamilton: bool, text: str, quantified: bool, free: list[str]
    ) -> None:
        self.field, self.hamilton, self.text = field, hamilton, text
        self.quantified, self.free = quantified, free
        self.moduli: dict[Node, Node] = {}
        self.hypotheses: list[Node] = []

    def fail(self, message: str, node: Node) -> NoReturn:
        raise NotationError(message, self.text, node.position)

    def write(self, node: Node) -> Node:
        """Write out a term or a statement."""
        written = rebuild(node, [self.write(x) for x in children(node)])
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
        if self.field is None or self.field.closure != "real closed":
            where = "no field is named" if self.field is None else f"{self.field.name} is none"
            self.fail(f"abs is decided over the real numbers, RR, and {where}", node)
        if not self.hamilton:
            self.fail("abs is decided in H, where no norm is negative", node)
        if self.quantified:
            self.fail("abs and 'exists' do not stand in one statement", node)
        if divides_in(x):
            self.fail("the argument of abs has no quotient and no inverse here", node)
        if x not in self.moduli:
            if not self.free:
                self.fail(f"a statement has at most {len(HELPERS)} moduli", node)
            m = Index(Name(self.free.pop(0)), 0)
            self.moduli[x] = Power(m, 2)
            self.hypotheses.append(Compare("==", Power(m, 4), Call("norm", (x,))))
        return self.moduli[x]


__all__ = ["ARGUMENTS", "HELPERS", "without_words"]
