"""The words ``dot``, ``cross`` and ``abs``, written out by their definitions in docs/language.md.

``abs(q)`` is the number m² with m⁴ = norm(q): over the real numbers there is exactly one. A statement about
all values of its unknowns, with moduli, is the statement about all these and all m with m⁴ = norm(q).
"""

from fractions import Fraction

from hfield.certificates.language import Tree, walk
from hfield.certificates.matrices import ENTRIES
from hfield.certificates.rejection import reject, shown
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.scalars.surds import Reals
from hfield.certificates.work import charge

ARGUMENTS = {"dot": 2, "cross": 2, "abs": 1}


def without_words(tree: Tree, field: Ring | None, hamilton: bool) -> Tree:
    """Return a statement that says the same without these words.

    There are moduli where the norm has no negative values: in H over the real numbers.
    """
    nodes = walk(tree)
    if not any(node[0] == "call" and node[1] in ARGUMENTS for node in nodes):
        return tree
    used = {node[1] for node in nodes if node[0] == "name"}
    free = [
        name
        for name in ENTRIES
        if name not in used and (field is None or field.constant(("name", name)) is None)
    ]
    ordered = hamilton and isinstance(field, Reals)
    writer = _Writer(ordered, free, any(node[0] == "exists" for node in nodes))
    written = writer.write(tree)
    for hypothesis in reversed(writer.hypotheses):
        written = ("=>", hypothesis, written)
    return written


class _Writer:
    def __init__(self, ordered: bool, free: list[str], quantified: bool) -> None:
        self.ordered, self.free, self.quantified = ordered, free, quantified
        self.moduli: dict[Tree, Tree] = {}
        self.hypotheses: list[Tree] = []

    def write(self, tree: Tree) -> Tree:
        """Write out a term or a statement."""
        charge(5)
        if tree[0] == "exists":
            return ("exists", tree[1], self.write(tree[2]))
        if tree[0] != "call":
            return (tree[0], *(self.write(x) if isinstance(x, tuple) else x for x in tree[1:]))
        arguments = tuple(map(self.write, tree[2]))
        function = tree[1]
        if function not in ARGUMENTS:
            return ("call", function, arguments)
        if len(arguments) != ARGUMENTS[function]:
            reject(f"{shown(function)} does not take {len(arguments)} arguments")
        if function == "abs":
            return self.modulus(arguments[0])
        x, y = (("call", "vector", (z,)) for z in arguments)
        if function == "cross":
            return ("call", "vector", (("*", x, y),))
        return ("neg", ("call", "scalar", (("*", x, y),)))

    def modulus(self, x: Tree) -> Tree:
        """Return m² for a new m with m⁴ = norm(x)."""
        if not self.ordered:
            reject("abs is about H over the real numbers")
        if self.quantified:
            reject("abs and 'exists' do not stand in one statement")
        for node in walk(x):
            undefined = node[0] == "/" or (node[0] == "pow" and node[2] < 0)
            if undefined or node[:2] == ("call", "inv") or _is_fraction(node):
                reject("the argument of abs may be undefined")
        if x not in self.moduli:
            if not self.free:
                reject("there are too many moduli")
            m = ("index", ("name", self.free.pop(0)), 0)
            self.moduli[x] = ("pow", m, 2)
            self.hypotheses.append(("==", ("pow", m, 4), ("call", "norm", (x,))))
        return self.moduli[x]


def _is_fraction(node: Tree) -> bool:
    return node[0] == "num" and isinstance(node[1], Fraction)
