"""Check statements with moduli and comparisons, in the real closure of an ordered field.

The constants of a statement must be sums of square roots of rational numbers, ordered as real numbers.
Evidence is then read over RR. Identities and implications proved there hold over every real closed field, for
three reasons: products with cofactors are the same in every field; in an ordered field a sum of squares is 0
only if every square is 0; and a rational number is a square in all real closed fields or in none.
"""

from collections.abc import Mapping
from dataclasses import replace

from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.glossary import FIELD, ORDERED_FIELDS
from hfield.checker.language import ORDER, Tree, children
from hfield.checker.rejection import reject
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.scalars.surds import Reals, Surd
from hfield.checker.statement import Setting, Statement
from hfield.checker.values import read_values
from hfield.checker.words import ARGUMENTS

Value = Surd | Quaternion[Surd]
REALS = Reals()
KINDS = ("identity", "implication", "unsatisfiable", "witness")
EVALUATION_COST = 400  # of evaluating a statement once


def in_real_closure(statement: Statement, setting: Setting, kind: str) -> tuple[Setting, str]:
    """Return the setting in which evidence of a kind is read, and the scope of the conclusion."""
    field = setting.field
    if field is None:
        scope = ORDERED_FIELDS
    else:
        scope = FIELD
        if not (field.is_domain and field.sign(field.one) == 1):
            reject(f"{field.name} is not known to have an order")
        if field.name == REALS.name:
            return setting, scope
        if statement.divides and not field.is_field:
            reject(
                f"comparisons of quotients are not shown over {field.name}, which is not a field"
            )
    if kind not in KINDS:
        reject(f"evidence of the kind {kind!r} is not about all real closed fields")
    if any(REALS.constant(tree) is None for tree in statement.constants):
        reject("a statement with comparisons has a constant that is not a sum of square roots")
    return replace(setting, field=REALS), scope


def names_of_unknowns(statement: Statement) -> set[str]:
    """Return the unknowns of a statement as typed."""
    return {name for name, _ in _unknowns(statement)}


def _unknowns(statement: Statement) -> tuple[tuple[str, str], ...]:
    assert statement.ordered is not None
    used = _names(statement.ordered)
    structure = {name for name, sort in statement.unknowns if len(name) == 1}
    return tuple((name, sort) for name, sort in statement.unknowns if name in used | structure)


def _names(tree: Tree) -> set[str]:
    out, stack = set[str](), [tree]
    while stack:
        node = stack.pop()
        if node[0] == "name":
            out.add(node[1])
        stack.extend(children(node))
    return out


def is_false_at(statement: Statement, setting: Setting, ring: AnyRing, values: object) -> bool:
    """Return whether a statement is false at values in a ring, which are also read as real numbers."""
    assert statement.ordered is not None
    read_values(ring, values, _unknowns(statement))
    found = read_values(REALS, values, _unknowns(statement))
    known: dict[Tree, Value] = {**REALS.named_elements(statement.constants)}
    known.update((("name", name), value) for name, value in found.items())
    world = _InOrder(setting.constants, known)
    return not world.conditions and not world.truth(statement.ordered)


class _InOrder(Evaluator[Surd, bool]):
    """Evaluates statements with all words of the language at real numbers."""

    def __init__(self, constants: tuple[Tree, Tree, Tree], values: Mapping[Tree, Value]) -> None:
        super().__init__(RingScalars(REALS), constants, values)

    def truth(self, tree: Tree) -> bool:
        """Return the truth value of a quantifier-free statement."""
        if tree[0] not in ORDER:
            return super().truth(tree)
        self.needed = ()
        x, y = (self._scalar(self.value(side)) for side in tree[1:])
        if self.needed:
            return False
        sign = REALS.sign(REALS.add(x, REALS.neg(y))) or 0
        return {">=": sign >= 0, ">": sign > 0, "<=": sign <= 0, "<": sign < 0}[tree[0]]

    def value(self, tree: Tree) -> Value:
        """Return the value of a term."""
        if tree[0] != "call" or tree[1] not in ARGUMENTS:
            return super().value(tree)
        if len(tree[2]) != ARGUMENTS[tree[1]]:
            reject(f"{tree[1]} does not take {len(tree[2])} arguments")
        arguments = [self.quaternion(self.value(x)) for x in tree[2]]
        if tree[1] == "abs":
            return self._modulus(self.norm(arguments[0]))
        zero = REALS.zero
        x, y = (Quaternion((zero, *q[1:])) for q in arguments)
        product = self.product(x, y)
        return REALS.neg(product[0]) if tree[1] == "dot" else Quaternion((zero, *product[1:]))

    def _modulus(self, norm: Surd) -> Surd:
        """Return the square root of a nonnegative rational number."""
        if any(key for key, _ in norm) or REALS.sign(norm) == -1:
            reject("the modulus of a witness is not a square root of a rational number")
        number = norm[0][1] if norm else 0
        root = REALS.constant(("call", "sqrt", (("num", number),)))
        if root is None:
            reject("a modulus is not a real number")
        return root
