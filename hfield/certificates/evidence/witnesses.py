"""Evidence of the kind ``witness``: values for which a statement is false, or what exists is there."""

from collections.abc import Hashable

from hfield.certificates.evidence.exhaustion import truth_at
from hfield.certificates.finding import Finding
from hfield.certificates.glossary import (
    COUNTEREXAMPLE,
    FIELD,
    FLOATS_EXACT,
    IDENTITY,
    WITNESS,
)
from hfield.certificates.language import Tree
from hfield.certificates.rejection import an_object, reject
from hfield.certificates.scalars.fields import read_ring
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.statement import Setting, Statement
from hfield.certificates.values import read_values


def counterexample(statement: Statement, setting: Setting, evidence: object) -> Finding:
    """Refute by values for which the statement is false."""
    ring, values = _witness(statement, setting, evidence)
    if truth_at(ring, setting, statement, values) is not False:
        reject("the statement is true for the values of the witness, or the algebra not defined")
    if not ring.is_exact:
        return Finding(FIELD, FLOATS_EXACT)
    return Finding(FIELD, _refuted(statement.matrix, ring.order is None))


def _refuted(tree: Tree, infinite: bool) -> str:
    """Name the method of a refutation by what is refuted: an identity, or that equations have no solution."""
    if _is_identity(tree, True, infinite):
        return IDENTITY
    return WITNESS if _is_identity(tree, False, infinite) else COUNTEREXAMPLE


def _is_identity(tree: Tree, said: bool, infinite: bool) -> bool:
    """Tell whether what is said (or denied) is an identity: equations, joined by "and".

    Joined by "or" as well where a product of polynomials is 0 everywhere only if one of them is.
    """
    kind = tree[0]
    if kind in ("==", "!="):
        return bool((kind == "==") == said)
    if kind == "not":
        return _is_identity(tree[1], not said, infinite)
    if kind == "<=>" or not (infinite or (kind == "and") == said):
        return False
    left = _is_identity(tree[1], said != (kind == "=>"), infinite)
    return left and _is_identity(tree[2], said, infinite)


def example(statement: Statement, setting: Setting, evidence: object) -> Finding:
    """Show existence by values for which the statement is true."""
    if statement.given or setting.field is None:
        reject("one element shows that something exists only for one field, and no other unknowns")
    ring, values = _witness(statement, setting, evidence)
    if truth_at(ring, setting, statement, values) is not True:
        reject("the statement is false for the values of the witness, or the algebra not defined")
    return Finding(FIELD, WITNESS)


def _witness(
    statement: Statement, setting: Setting, evidence: object
) -> tuple[Ring, dict[str, Hashable]]:
    """Return the ring of a witness and its values."""
    data = an_object(evidence, "kind values ring", "the evidence")
    ring = read_ring(data["ring"])
    if setting.field is None and not ring.is_field:
        reject(f"{ring.name} is no field")
    if setting.field is not None and setting.field.name != ring.name:
        reject("the field of the evidence is not that of the certificate")
    return ring, read_values(ring, data["values"], statement.unknowns)


CHECKS = {
    ("proved", True, "witness"): example,
    ("refuted", False, "witness"): counterexample,
}
