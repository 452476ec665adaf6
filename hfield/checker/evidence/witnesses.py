"""Check ``witness``: values that refute a statement or prove existence."""

from collections.abc import Hashable

from hfield.checker.check_result import CheckResult
from hfield.checker.evidence.exhaustion import truth_at
from hfield.checker.glossary import (
    COUNTEREXAMPLE,
    FIELD,
    FLOATS_EXACT,
    IDENTITY,
    WITNESS,
)
from hfield.checker.language import Tree
from hfield.checker.real_closure import REALS, in_real_closure, is_false_at, names_of_unknowns
from hfield.checker.rejection import an_object, reject
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.ring import AnyRing
from hfield.checker.statement import Setting, Statement
from hfield.checker.values import read_values


def counterexample(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Refute by values for which the statement is false."""
    if statement.ordered is not None and not _has_helpers(statement, setting, evidence):
        return refute_with_order(statement, setting, evidence)
    ring, values = _witness(statement, setting, evidence)
    if truth_at(ring, setting, statement, values) is not False:
        reject(
            "the statement is true at the values of the witness, or the algebra is not defined there"
        )
    if not ring.is_exact:
        return CheckResult(FIELD, FLOATS_EXACT)
    return CheckResult(FIELD, _refuted(statement.matrix, ring.order is None))


def _has_helpers(statement: Statement, setting: Setting, evidence: object) -> bool:
    """Return whether the evidence gives real values of the unknowns that define moduli and comparisons."""
    if setting.field is None or setting.field.name != REALS.name:
        return False
    values = evidence.get("values") if isinstance(evidence, dict) else None
    return isinstance(values, dict) and values.keys() > names_of_unknowns(statement)


def refute_with_order(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Refute a statement with moduli and comparisons by values at which it is false."""
    data = an_object(evidence, "kind values ring", "the evidence")
    ring = read_ring(data["ring"])
    if setting.field is None and ring.name != "QQ":
        reject("a statement about all ordered fields is refuted by rational numbers")
    if setting.field is not None and setting.field.name != ring.name:
        reject("the field of the evidence is not that of the certificate")
    there, _ = in_real_closure(statement, setting, "witness")
    if is_false_at(statement, there, ring, data["values"]):
        return CheckResult(FIELD, COUNTEREXAMPLE)
    reject(
        "the statement is true at the values of the witness, or the algebra is not defined there"
    )


def _refuted(tree: Tree, infinite: bool) -> str:
    """Return the name of the method: the refutation of an identity, or of unsolvable equations."""
    if _is_identity(tree, True, infinite):
        return IDENTITY
    return WITNESS if _is_identity(tree, False, infinite) else COUNTEREXAMPLE


def _is_identity(tree: Tree, said: bool, infinite: bool) -> bool:
    """Return whether the statement (or its negation) is an identity: equations joined by "and".

    Equations joined by "or" count too, if a product of polynomials vanishes everywhere only if one of them
    does.
    """
    if tree[0] in ("==", "!="):
        return bool((tree[0] == "==") == said)
    if tree[0] == "not":
        return _is_identity(tree[1], not said, infinite)
    if tree[0] not in ("and", "or", "=>") or not (infinite or (tree[0] == "and") == said):
        return False
    left = _is_identity(tree[1], said != (tree[0] == "=>"), infinite)
    return left and _is_identity(tree[2], said, infinite)


def example(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove existence by values for which the statement is true."""
    if statement.given or setting.field is None:
        reject("one element shows that something exists only for one field, and no other unknowns")
    ring, values = _witness(statement, setting, evidence)
    if truth_at(ring, setting, statement, values) is not True:
        reject(
            "the statement is false at the values of the witness, or the algebra is not defined there"
        )
    return CheckResult(FIELD, WITNESS)


def _witness(
    statement: Statement, setting: Setting, evidence: object
) -> tuple[AnyRing, dict[str, Hashable]]:
    """Return the ring of a witness and its values."""
    data = an_object(evidence, "kind values ring", "the evidence")
    ring = read_ring(data["ring"])
    if setting.field is None and not ring.is_field:
        reject(f"{ring.name} is not a field")
    if setting.field is not None and setting.field.name != ring.name:
        reject("the field of the evidence is not that of the certificate")
    return ring, read_values(ring, data["values"], statement.unknowns)


CHECKS = {
    ("proved", True, "witness"): example,
    ("refuted", False, "witness"): counterexample,
}
