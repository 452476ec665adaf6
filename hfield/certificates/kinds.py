"""Evidence for statements of the language: which kinds show what, and the plainest of them.

What each kind proves, and why, is written in docs/trust.md.
"""

from collections.abc import Callable, Hashable
from functools import partial

from hfield.certificates.clauses import expand
from hfield.certificates.exhaustion import check_all, check_exists, truth_at
from hfield.certificates.existence import cases, none_exists, place, terms
from hfield.certificates.finding import Finding
from hfield.certificates.glossary import (
    COMMUTATIVE_RINGS,
    COUNTEREXAMPLE,
    EXHAUSTION,
    FIELD,
    FIELDS,
    FLOATS_EXACT,
    IDENTITY,
    MULTILINEAR,
    WITNESS,
)
from hfield.certificates.implication import check_implication
from hfield.certificates.language import Tree
from hfield.certificates.multilinear import check_multilinear
from hfield.certificates.over_field import Place
from hfield.certificates.quaternion_roots import quaternion_root
from hfield.certificates.rejection import (
    a_text,
    an_integer,
    an_object,
    kind_of,
    reject,
    shown,
)
from hfield.certificates.roots import complex_root, real_root
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.statement import Setting, Statement, read_tree
from hfield.certificates.subfields import subfield
from hfield.certificates.transfer import fractions, reduction
from hfield.certificates.values import read_values


def establish(statement: Statement, setting: Setting, verdict: str, evidence: object) -> Finding:
    """Check the evidence for a verdict on a statement; return what it shows."""
    kind = kind_of(evidence)
    if verdict != "refuted" and setting.field is not None and not setting.field.is_exact:
        reject("nothing is proved over floats")
    check = KINDS.get((verdict, bool(statement.exists), kind))
    if check is None:
        reject(
            f"evidence of the kind {shown(kind)!r} does not show that the statement is {verdict}"
        )
    return check(statement, setting, evidence)


def prove(tree: Tree, setting: Setting, evidence: object) -> Finding:
    """Check that the evidence proves the statement with this tree."""
    return establish(read_tree(tree, setting), setting, "proved", evidence)


def _identity(statement: Statement, setting: Setting, evidence: object) -> Finding:
    an_object(evidence, "kind", "the evidence")
    over = _place(statement, setting)
    if not all(map(over.is_identity, over.expansion.clauses)):
        reject("the statement does not hold by expanding")
    return Finding(COMMUTATIVE_RINGS, IDENTITY).within(_reach(statement, setting))


def _implication(statement: Statement, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind facts items", "the evidence")
    expansion = _place(statement, setting).expansion
    return check_implication(expansion, setting, data).within(_reach(statement, setting))


def _place(statement: Statement, setting: Setting) -> Place:
    """Expand the statement; the algebra must exist somewhere, and "not 0" mean what has an inverse."""
    ring = setting.field
    if ring is not None and not ring.is_field and statement.divides:
        reject(f"a statement that divides is shown over {ring.name} by all cases only")
    over = Place(expand(statement, setting), ring)
    over.need_algebra()
    return over


def _reach(statement: Statement, setting: Setting) -> str:
    """Return the widest scope that a statement has by its form."""
    if setting.field is not None:
        return FIELD
    return FIELDS if statement.divides or statement.compares_unequal else COMMUTATIVE_RINGS


def _exhaustion(statement: Statement, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind cases", "the evidence")
    check = check_exists if statement.exists else check_all
    check(statement, setting, an_integer(data["cases"], "cases", 1))
    return Finding(FIELD, EXHAUSTION)


def _multilinear(statement: Statement, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind unknowns tuples", "the evidence")
    check_multilinear(statement, setting, data)
    return Finding(COMMUTATIVE_RINGS, MULTILINEAR).within(_reach(statement, setting))


def _counterexample(statement: Statement, setting: Setting, evidence: object) -> Finding:
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


def _example(statement: Statement, setting: Setting, evidence: object) -> Finding:
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
    data = an_object(evidence, "kind values field", "the evidence")
    ring = read_field(a_text(data["field"], "the field of the evidence"))
    if setting.field is None and not ring.is_field:
        reject(f"{ring.name} is no field")
    if setting.field is not None and setting.field.name != ring.name:
        reject("the field of the evidence is not that of the certificate")
    return ring, read_values(ring, data["values"], statement.unknowns)


def _unsatisfiable(statement: Statement, setting: Setting, evidence: object) -> Finding:
    data = an_object(evidence, "kind proof", "the evidence")
    if not statement.hypotheses:
        reject("there are no hypotheses")
    tree = statement.hypotheses[0]
    for h in statement.hypotheses[1:]:
        tree = ("and", tree, h)
    return prove(("not", tree), setting, data["proof"])


# By the verdict, and whether the statement says "exists".
Check = Callable[[Statement, Setting, object], Finding]
KINDS: dict[tuple[str, bool, str], Check] = {
    ("proved", False, "identity"): _identity,
    ("proved", False, "implication"): _implication,
    ("proved", False, "exhaustion"): _exhaustion,
    ("proved", False, "multilinear"): _multilinear,
    ("proved", True, "exhaustion"): _exhaustion,
    ("proved", True, "witness"): _example,
    ("proved", True, "subfield"): partial(subfield, _example),
    ("proved", True, "terms"): partial(terms, prove),
    ("proved", True, "cases"): partial(cases, prove),
    ("proved", True, "real root"): real_root,
    ("proved", True, "complex root"): complex_root,
    ("proved", True, "quaternion root"): quaternion_root,
    ("proved", False, "fractions"): partial(fractions, prove),
    ("proved", False, "reduction"): partial(reduction, prove),
    ("refuted", False, "witness"): _counterexample,
    ("refuted", False, "subfield"): partial(subfield, _counterexample),
    ("refuted", True, "none exists"): partial(none_exists, prove),
    ("refuted", True, "place"): partial(place, prove),
    ("vacuous", False, "unsatisfiable"): _unsatisfiable,
    ("vacuous", True, "unsatisfiable"): _unsatisfiable,
}
