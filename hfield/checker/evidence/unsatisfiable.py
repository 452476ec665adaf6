"""Check ``unsatisfiable``: the hypotheses are never true together."""

from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.evidence import prove
from hfield.checker.language import Tree
from hfield.checker.over_field import evaluation_context
from hfield.checker.rejection import Rejected, an_object, reject
from hfield.checker.statement import Setting, Statement, read_tree


def unsatisfiable(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Show that a statement is vacuous."""
    data = an_object(evidence, "kind proof", "the evidence")
    if not statement.hypotheses:
        reject("there are no hypotheses")
    return prove(_denial(statement), setting, data["proof"])


def need_hypotheses(statement: Statement, setting: Setting) -> None:
    """Reject ``proved`` if the expansion shows that the statement is vacuous."""
    if not statement.hypotheses:
        return
    try:
        over = evaluation_context(read_tree(_denial(statement), setting), setting)
        never = all(map(over.is_identity, over.expansion.clauses))
    except Rejected:  # it is not shown by expanding; or there was no work left
        spend(0)
        return
    if never:
        reject("the hypotheses are never true together: the statement is vacuous and not proved")


def _denial(statement: Statement) -> Tree:
    tree = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        tree = ("and", tree, h)
    return ("not", tree)


CHECKS = {
    ("vacuous", False, "unsatisfiable"): unsatisfiable,
    ("vacuous", True, "unsatisfiable"): unsatisfiable,
}
