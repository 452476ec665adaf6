"""Expand the words ``dot``, ``cross``, ``abs`` and ``>= > <= <`` by their definitions.

In a real closed field ``abs(q)`` is the only number m² with m⁴ = norm(q). So a statement with moduli is
equivalent to the statement for all values of its unknowns and all m with m⁴ = norm(q). As a claim, ``x >= 0``
means ``x == 0 or x != -z**2`` for all z; as a hypothesis, ``x == z**2`` for some z. ``x > 0`` is treated
similarly.
"""

from collections.abc import Callable
from fractions import Fraction

from hfield.checker.budget import spend
from hfield.checker.language import ORDER, Operator, Tree, walk, with_parts
from hfield.checker.matrices import ENTRIES
from hfield.checker.rejection import reject, shown
from hfield.checker.scalars.ring import AnyRing

ARGUMENTS = {"dot": 2, "cross": 2, "abs": 1}


def has_order_words(tree: Tree) -> bool:
    """Return whether a statement has a comparison or a modulus, which need an ordered field."""
    return any(node[0] in ORDER or node[:2] == ("call", "abs") for node in walk(tree))


def without_words(
    tree: Tree, field: AnyRing | None, hamilton: bool, is_scalar: Callable[[Tree], bool]
) -> Tree:
    """Return an equivalent statement without these words, over the real closure of the field.

    Moduli are defined if the norm is never negative, as in H. ``is_scalar`` tests whether a term without
    these words is a scalar.
    """
    nodes = walk(tree)
    if not any(node[0] in ORDER or (node[0] == "call" and node[1] in ARGUMENTS) for node in nodes):
        return tree
    used = {node[1] for node in nodes if node[0] == "name"}
    free = [
        name
        for name in ENTRIES
        if name not in used and (field is None or field.constant(("name", name)) is None)
    ]
    writer = _Writer(hamilton, free, any(node[0] == "exists" for node in nodes), is_scalar)
    written = writer.statement(tree, True)
    for hypothesis in reversed(writer.hypotheses):
        written = ("=>", hypothesis, written)
    return written


class _Writer:
    def __init__(
        self, hamilton: bool, free: list[str], quantified: bool, is_scalar: Callable[[Tree], bool]
    ) -> None:
        self.hamilton, self.free, self.quantified = hamilton, free, quantified
        self.is_scalar = is_scalar
        self.moduli: dict[Tree, Tree] = {}
        self.hypotheses: list[Tree] = []

    def statement(self, tree: Tree, claimed: bool) -> Tree:
        """Rewrite a statement, as a claim or, unless ``claimed``, as a hypothesis."""
        spend(5)
        if tree[0] == "exists":
            return ("exists", tree[1], self.statement(tree[2], claimed))
        if tree[0] == "not":
            return ("not", self.statement(tree[1], not claimed))
        if tree[0] == "<=>" and any(node[0] in ORDER for node in walk(tree)):
            first: Tree = (
                "=>",
                self.statement(tree[1], not claimed),
                self.statement(tree[2], claimed),
            )
            second: Tree = (
                "=>",
                self.statement(tree[2], not claimed),
                self.statement(tree[1], claimed),
            )
            return ("and", first, second)
        if tree[0] in ("and", "or", "=>", "<=>"):
            left = self.statement(tree[1], claimed != (tree[0] == "=>"))
            return (tree[0], left, self.statement(tree[2], claimed))
        if tree[0] in ORDER:
            return self.order(tree[0], self.write(tree[1]), self.write(tree[2]), claimed)
        return self.write(tree)

    def order(self, kind: Operator, left: Tree, right: Tree, claimed: bool) -> Tree:
        """Rewrite a comparison: x is nonnegative if it is a square, negative if −x is a square and x ≠ 0."""
        if self.quantified:
            reject("a statement cannot have both a comparison and 'exists'")
        if not (self.is_scalar(left) and self.is_scalar(right)):
            reject(f"{kind} compares scalars")
        x: Tree = ("-", left, right) if kind in (">=", ">") else ("-", right, left)
        z = self.helper()
        square: Tree = ("pow", z, 2)
        zero: Tree = ("num", 0)
        if claimed:
            positive: Tree = ("!=", x, ("neg", square))
            return positive if kind in (">", "<") else ("or", ("==", x, zero), positive)
        squared: Tree = ("==", x, square)
        return squared if kind in (">=", "<=") else ("and", squared, ("!=", z, zero))

    def write(self, tree: Tree) -> Tree:
        """Rewrite a term, or a comparison by == or !=."""
        spend(5)
        if tree[0] != "call":
            return with_parts(tree, self.write)
        arguments = tuple(map(self.write, tree[2]))
        function = tree[1]
        if function not in ARGUMENTS:
            return ("call", function, arguments)
        if len(arguments) != ARGUMENTS[function]:
            reject(f"{shown(function)} does not take {len(arguments)} arguments")
        if function == "abs":
            return self.modulus(arguments[0])
        vectors: list[Tree] = [("call", "vector", (x,)) for x in arguments]
        product: Tree = ("*", vectors[0], vectors[1])
        if function == "cross":
            return ("call", "vector", (product,))
        return ("neg", ("call", "scalar", (product,)))

    def modulus(self, x: Tree) -> Tree:
        """Return m² for a new m with m⁴ = norm(x)."""
        if not self.hamilton:
            reject("abs is about H over ordered fields")
        if self.quantified:
            reject("a statement cannot have both abs and 'exists'")
        for node in walk(x):
            undefined = node[0] == "/" or (node[0] == "pow" and node[2] < 0)
            if undefined or node[:2] == ("call", "inv") or _is_fraction(node):
                reject("the argument of abs may be undefined")
        if x not in self.moduli:
            m = self.helper()
            self.moduli[x] = ("pow", m, 2)
            self.hypotheses.append(("==", ("pow", m, 4), ("call", "norm", (x,))))
        return self.moduli[x]

    def helper(self) -> Tree:
        """Return a scalar that does not occur in the statement."""
        if not self.free:
            reject("there are too many moduli and comparisons")
        return ("index", ("name", self.free.pop(0)), 0)


def _is_fraction(node: Tree) -> bool:
    return node[0] == "num" and isinstance(node[1], Fraction)
