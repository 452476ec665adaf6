"""Check ``multilinear``: maps linear in each argument agree on all basis tuples."""

from collections.abc import Mapping
from itertools import product

from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.evaluate import Quaternion
from hfield.checker.evidence.exhaustion import evaluator_at
from hfield.checker.glossary import COMMUTATIVE_RINGS, MULTILINEAR
from hfield.checker.language import Tree
from hfield.checker.over_field import reach
from hfield.checker.rejection import a_list, an_integer, an_object, reject, texts
from hfield.checker.scalars.place import E
from hfield.checker.scalars.rationals import ZZ
from hfield.checker.scalars.ring import Ring
from hfield.checker.statement import Setting, Statement

MAX_TUPLES = 4**6

Degrees = set[tuple[int, ...]]


def check_multilinear(statement: Statement, setting: Setting, data: Mapping[str, object]) -> None:
    """Check the values of both sides at all tuples of basis vectors, over ℤ if no field is named."""
    tree, names = statement.conclusion, [name for name, _ in statement.unknowns]
    if tree[0] != "==" or statement.hypotheses or any(s != "q" for _, s in statement.unknowns):
        reject("the statement is not an equation between multilinear maps")
    if texts(data["unknowns"], "unknowns") != names or setting.letters or not names:
        reject("the unknowns are not those of the statement")
    if not all(_degrees(side, names) <= {(1,) * len(names)} for side in tree[1:]):
        reject("a side of the equation is not linear in each unknown")
    if setting.field is None:
        _check_tuples(statement, setting, ZZ, tree[1:], data)
    else:
        _check_tuples(statement, setting, setting.field, tree[1:], data)


def _check_tuples(
    statement: Statement,
    setting: Setting,
    ring: Ring[E],
    sides: tuple[Tree, Tree],
    data: Mapping[str, object],
) -> None:
    """Check the values of both sides of the equation at all tuples of basis vectors, over a ring."""
    names = [name for name, _ in statement.unknowns]
    listed: dict[str, list[E]] = {}
    for entry in a_list(data["tuples"], "tuples", 1):
        if not isinstance(entry, list) or len(entry) != 2 or not isinstance(entry[0], str):
            reject("an entry of 'tuples' is not a word with four coordinates")
        if entry[0] in listed:
            reject(f"the word {entry[0]!r} comes twice")
        value = a_list(entry[1], "coordinates", 4)
        listed[entry[0]] = [ring.number(an_integer(c, "a coordinate")) for c in value]
    if 4 ** len(names) > MAX_TUPLES or len(listed) != 4 ** len(names):
        reject("the list of tuples of basis vectors is not complete")
    for word in map("".join, product("eijk", repeat=len(names))):
        spend(1_000)
        if word not in listed or len(listed[word]) != 4:
            reject("the list of tuples of basis vectors is not complete")
        values = {
            name: Quaternion([ring.one if u == letter else ring.zero for u in "eijk"])
            for name, letter in zip(names, word, strict=True)
        }
        evaluator = evaluator_at(ring, setting, statement, values)
        for side in sides:
            found = evaluator.quaternion(evaluator.value(side))  # without division it is defined
            pairs = zip(found, listed[word], strict=True)
            if evaluator.conditions or not all(ring.equal(u, v) for u, v in pairs):
                reject(f"the sides at {word} are not what the list says")


def _degrees(tree: Tree, names: list[str]) -> Degrees:
    """Return the degree of the terms in each unknown; reject terms that are not multilinear."""
    if tree[0] == "num" and isinstance(tree[1], int):
        return {(0,) * len(names)} if tree[1] else set()
    if tree[0] == "name":
        return {tuple(int(tree[1] == name) for name in names)}
    if tree[0] in ("neg", "index"):
        return _degrees(tree[1], names)
    if tree[0] == "call" and tree[1] in ("conj", "trace", "scalar", "vector"):
        return _degrees(tree[2][0], names)
    spend(5)
    if tree[0] in ("+", "-"):
        return _degrees(tree[1], names) | _degrees(tree[2], names)
    if tree[0] == "*" or (tree[0] == "call" and tree[1] == "comm"):
        left, right = (_degrees(x, names) for x in (tree[1:] if tree[0] == "*" else tree[2]))
        if len(left) * len(right) > MAX_TUPLES:
            reject("a side of the equation has too many degrees")
        spend(len(left) * len(right))
        return {tuple(a + b for a, b in zip(u, v, strict=True)) for u in left for v in right}
    reject("a side of the equation is not linear in each unknown")


def multilinear(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove an equation by its values at tuples of basis vectors."""
    data = an_object(evidence, "kind unknowns tuples", "the evidence")
    check_multilinear(statement, setting, data)
    return CheckResult(COMMUTATIVE_RINGS, MULTILINEAR).within(reach(statement, setting))


CHECKS = {("proved", False, "multilinear"): multilinear}
