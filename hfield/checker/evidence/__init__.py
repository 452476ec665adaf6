"""Check evidence for statements of the language; each module of this folder checks some kinds of evidence.

``CHECKS`` of a module maps a verdict, whether the statement has "exists", and a kind of evidence to the
function that checks it. A new kind is a new module. docs/explanation/trust.md proves for each kind that the
evidence is sufficient.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from hfield.checker.check_result import CheckResult
from hfield.checker.language import Tree
from hfield.checker.real_closure import in_real_closure
from hfield.checker.rejection import kind_of, reject, shown
from hfield.checker.statement import Setting, Statement, read_tree

Check = Callable[[Statement, Setting, object], CheckResult]
# The verdict, whether the statement says "exists", the kind of evidence.
Shown = tuple[str, bool, str]


@cache
def checks() -> Mapping[Shown, Check]:
    """Return the check for each kind of evidence and verdict; no kind has two checks."""
    found: dict[Shown, Check] = {}
    for name in sorted(module.name for module in iter_modules(__path__)):
        own: Mapping[Shown, Check] = import_module(f"{__name__}.{name}").CHECKS
        assert not found.keys() & own.keys(), f"{name}: {found.keys() & own.keys()}"
        found |= own
    return found


def establish(
    statement: Statement, setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check the evidence for a verdict on a statement; return the result."""
    kind = kind_of(evidence)
    if verdict != "refuted" and setting.field is not None and not setting.field.is_exact:
        reject("nothing is proved over floats")
    limit = None
    if statement.ordered is not None and (verdict != "refuted"):
        setting, limit = in_real_closure(statement, setting, kind)
    check = checks().get((verdict, bool(statement.exists), kind))
    if check is None:
        reject(
            f"evidence of the kind {shown(kind)!r} does not show that the statement is {verdict}"
        )
    found = check(statement, setting, evidence)
    return found if limit is None else replace(found, scope=limit)


def prove(tree: Tree, setting: Setting, evidence: object) -> CheckResult:
    """Check that the evidence proves the statement with this tree."""
    return establish(read_tree(tree, setting), setting, "proved", evidence)
