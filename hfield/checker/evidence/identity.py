"""Check ``identity``: both sides expand to the same polynomials."""

from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import COMMUTATIVE_RINGS, IDENTITY
from hfield.checker.over_field import evaluation_context, reach
from hfield.checker.rejection import an_object, reject
from hfield.checker.statement import Setting, Statement


def identity(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove a statement by expanding its clauses."""
    an_object(evidence, "kind", "the evidence")
    over = evaluation_context(statement, setting)
    if not all(map(over.is_identity, over.expansion.clauses)):
        reject("the statement does not hold by expanding")
    return CheckResult(COMMUTATIVE_RINGS, IDENTITY).within(reach(statement, setting))


CHECKS = {("proved", False, "identity"): identity}
