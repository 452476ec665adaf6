"""Check evidence for and against "exists": terms, cases with terms, refutations."""

from collections.abc import Mapping
from dataclasses import replace

from hfield.checker.check_result import CheckResult, together
from hfield.checker.evidence import prove
from hfield.checker.glossary import FIELD, FIELDS, WITNESS
from hfield.checker.language import Tree, parse, substitute
from hfield.checker.rejection import (
    a_list,
    a_text,
    an_object,
    kind_of,
    reject,
)
from hfield.checker.scalars.fields import read_ring
from hfield.checker.statement import Setting, Statement, read_tree, sort_of
from hfield.checker.values import trees_of_values

MAX_CASES = 64


def terms(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove existence by terms: the statement with these terms is true for all given values."""
    data = an_object(evidence, "kind terms proof", "the evidence")
    instance = _put_in(data["terms"], statement, setting)
    return prove(instance, setting, data["proof"]).within(_reach(setting)).by(WITNESS)


def cases(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove existence by cases, one of which always holds; each case has its own terms."""
    data = an_object(evidence, "kind cases cover", "the evidence")
    entries = a_list(data["cases"], "cases", 1)
    if len(entries) > MAX_CASES:
        reject(f"there are {len(entries)} cases; at most {MAX_CASES} are read")
    given, findings = {name for name, _ in statement.given}, list[CheckResult]()
    cover: Tree | None = None
    for entry in entries:
        case = an_object(entry, "when terms proof", "a case")
        when: Tree = parse(a_text(case["when"], "the condition of a case"))
        condition = read_tree(when, setting)
        if condition.exists or not {name for name, _ in condition.unknowns} <= given:
            reject("the condition of a case is not about the unknowns that are given")
        instance = _put_in(case["terms"], statement, setting)
        findings.append(prove(("=>", when, instance), setting, case["proof"]))
        cover = when if cover is None else ("or", cover, when)
    assert cover is not None, "there is a case"
    for h in reversed(statement.hypotheses):
        cover = ("=>", h, cover)
    findings.append(prove(cover, setting, data["cover"]))
    return together(findings).within(_reach(setting)).by(WITNESS)


def _put_in(raw: object, statement: Statement, setting: Setting) -> Tree:
    """Return the statement with the names bound by "exists" replaced by terms.

    Every comparison with an undefined term is false. So a term that may be undefined is allowed if the
    conclusion is built from comparisons by "and" and "or" alone. Otherwise the statement gets the further
    claim that the term is equal to itself, hence defined.
    """
    data = an_object(raw, " ".join(statement.exists), "the terms")
    given, sorts = {name for name, _ in statement.given}, dict(statement.unknowns)
    chosen: dict[str, Tree] = {}
    partial: list[Tree] = []
    for name in statement.exists:
        tree = parse(a_text(data[name], f"the term for {name}"))
        sort, unknowns, divides = sort_of(tree, setting)
        if not unknowns <= given or (sort == "q" and sorts[name] == "s"):
            reject(f"the term for {name} does not fit")
        if divides and not _is_monotone(statement.conclusion):
            partial.append(tree)
        chosen[name] = tree
    conclusion = substitute(statement.conclusion, chosen)
    for tree in partial:
        conclusion = ("and", ("==", tree, tree), conclusion)
    return replace(statement, conclusion=conclusion).matrix


def _reach(setting: Setting) -> str:
    return FIELDS if setting.field is None else FIELD


def _is_monotone(tree: Tree) -> bool:
    """Return whether a statement is built from comparisons by "and" and "or" only."""
    return tree[0] in ("==", "!=") or (
        tree[0] in ("and", "or") and _is_monotone(tree[1]) and _is_monotone(tree[2])
    )


def none_exists(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Refute existence: the statement is false for all values. All other unknowns must have values."""
    here, data = _somewhere(statement, setting, evidence, "kind proof")
    if statement.given:
        reject("nothing is said about the unknowns that are given")
    return prove(("not", statement.matrix), here, data["proof"]).within(FIELD)


def place(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Refute existence at values of the other unknowns, which include letters of the algebra."""
    here, data = _somewhere(statement, setting, evidence, "kind values proof")
    assert here.field is not None
    values = trees_of_values(here.field, data["values"], statement.given)
    there = here.with_letters({name: values[name] for name in setting.letters})
    matrix = substitute(statement.matrix, values)
    if kind_of(data["proof"]) != "none exists":
        reject("a place refutes by evidence of the kind 'none exists'")
    inner = an_object(data["proof"], "kind proof", "the evidence")
    return prove(("not", matrix), there, inner["proof"]).within(FIELD)


def _somewhere(
    statement: Statement, setting: Setting, evidence: object, keys: str
) -> tuple[Setting, Mapping[str, object]]:
    """Return the setting over one field: that of the certificate, or one that the evidence names."""
    if setting.field is not None:
        return setting, an_object(evidence, keys, "the evidence")
    data = an_object(evidence, f"{keys} ring", "the evidence")
    ring = read_ring(data["ring"])
    if not ring.is_field:
        reject(f"{ring.name} is not a field")
    if any(ring.constant(("name", name)) is not None for name in statement.exists):
        reject(f"what 'exists' binds means an element of {ring.name} there")
    return replace(setting, field=ring), data


CHECKS = {
    ("proved", True, "terms"): terms,
    ("proved", True, "cases"): cases,
    ("refuted", True, "none exists"): none_exists,
    ("refuted", True, "place"): place,
}
