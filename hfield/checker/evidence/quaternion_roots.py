"""Check that an equation in one quaternion has a root over ℝ, by a cited theorem.

A polynomial in a quaternion q is a sum of monomials a₀·q·a₁·q⋯q·aₙ. It has a root if a single monomial has
the highest degree, this degree is positive, and the aₙ of this monomial are not 0 (Eilenberg and Niven).
"""

from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import FIELD, QUATERNION_ROOT, WITNESS
from hfield.checker.language import Tree, walk
from hfield.checker.rejection import an_object, reject
from hfield.checker.statement import HAMILTON, Setting, Statement

MAX_DEGREE = 1_000
Top = tuple[int, bool]  # at most this degree; a single nonzero monomial decides whether exactly


def quaternion_root(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove ``exists q: f == g`` over RR for one quaternion q, for all values of the given unknowns."""
    an_object(evidence, "kind", "the evidence")
    if setting.field is None or setting.field.name != "RR" or setting.constants != HAMILTON:
        reject("polynomials in a quaternion have roots over RR, in (-1,-1|RR)")
    sorts = dict(statement.unknowns)
    if len(statement.exists) != 1 or sorts[statement.exists[0]] != "q" or statement.divides:
        reject("a root is that of one equation in one quaternion, in which nothing divides")
    if statement.conclusion[0] != "==":
        reject("a root is that of one equation")
    _, left, right = statement.conclusion
    degree, single = _sum(_top(left, statement.exists[0]), _top(right, statement.exists[0]))
    if not 1 <= degree <= MAX_DEGREE or not single:
        reject("no single monomial has the highest degree, which is positive")
    return CheckResult(FIELD, WITNESS).citing(QUATERNION_ROOT)


def _top(tree: Tree, name: str) -> Top:
    """Return the leading part of a polynomial in the name."""
    if ("name", name) not in walk(tree):
        return 0, _is_not_zero(tree)
    if tree[0] == "name":
        return 1, True
    if tree[0] == "neg":
        return _top(tree[1], name)
    if tree[0] in ("+", "-"):
        return _sum(_top(tree[1], name), _top(tree[2], name))
    if tree[0] == "*":
        (m, first), (n, second) = _top(tree[1], name), _top(tree[2], name)
        return m + n, first and second
    if tree[0] == "pow" and tree[2] >= 0:
        degree, single = _top(tree[1], name)
        return degree * tree[2], single
    reject(f"{name} stands where no polynomial in it has it")


def _sum(left: Top, right: Top) -> Top:
    (m, first), (n, second) = left, right
    return (m, first) if m > n else (n, second) if n > m else (m, False)


def _is_not_zero(tree: Tree) -> bool:
    """Return whether a term is certainly nonzero: a product of numbers and of e, i, j, k."""
    if tree[0] == "num":
        return bool(tree[1] != 0)
    if tree[0] == "name":
        return tree[1] in ("e", "i", "j", "k")
    if tree[0] == "neg":
        return _is_not_zero(tree[1])
    return tree[0] == "*" and _is_not_zero(tree[1]) and _is_not_zero(tree[2])


CHECKS = {("proved", True, "quaternion root"): quaternion_root}
