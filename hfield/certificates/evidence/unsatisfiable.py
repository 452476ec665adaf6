"""Evidence of the kind ``unsatisfiable``: the hypotheses are never true together."""

from hfield.certificates.finding import Finding
from hfield.certificates.kinds import prove
from hfield.certificates.rejection import an_object, reject
from hfield.certificates.statement import Setting, Statement


def unsatisfiable(statement: Statement, setting: Setting, evidence: object) -> Finding:
    """Show that a statement is vacuous."""
    data = an_object(evidence, "kind proof", "the evidence")
    if not statement.hypotheses:
        reject("there are no hypotheses")
    tree = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        tree = ("and", tree, h)
    return prove(("not", tree), setting, data["proof"])


CHECKS = {
    ("vacuous", False, "unsatisfiable"): unsatisfiable,
    ("vacuous", True, "unsatisfiable"): unsatisfiable,
}
