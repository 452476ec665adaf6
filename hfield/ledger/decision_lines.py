"""One decision as lines of text: verdict, steps, assumptions, and the evaluated witness."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from hfield.checker.glossary import ALGEBRA, PRESENTATION
from hfield.core.product import Scalar
from hfield.errors import HFieldError, shorten
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring
from hfield.ledger.claim import NO_FIELD, UNIVERSAL
from hfield.ledger.claims_table import TerminalStyle
from hfield.ledger.wording import STATED_FIELD, over, pretty, witness_text
from hfield.notation import element_text
from hfield.presenting import hanging
from hfield.prover.decision import FIELD, NOT_APPLICABLE, REFUTED, Decision
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.ordered import OrderedEvaluator
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.evaluation.searcher import read_back
from hfield.prover.problem import Problem
from hfield.prover.statements.language import Statement, read_statement
from hfield.prover.statements.printing import to_unicode
from hfield.prover.statements.setting import Setting, read_setting
from hfield.prover.statements.trees import taken_apart, walk
from hfield.prover.statements.words import is_about_order
from hfield.syntax import Compare, Node, weight

_MAX_STEP_LENGTH = (
    600  # characters of a step; cofactors can fill pages, and are complete in JSON and certificates
)
_LABEL = 12
_FALSE = {"==": "≠", "!=": "=", ">=": "<", ">": "≤", "<=": ">", "<": "≥"}  # the true statement


def decision_text(
    statement: str, decision: Decision, algebra: str, field: str | None, style: TerminalStyle
) -> str:
    """Return a statement in ``algebra``, and its decision, as text; if ``field`` is None, over all fields."""
    every = "for every ordered F" if is_about_order(statement) else "for every F"
    where = every if field is None else f"{over(field)}, {ring(field).in_words()}"
    if decision.method in (PRESENTATION, ALGEBRA):
        whole = "in every ring with identity" if field is None else "in every algebra with identity"
        said = whole if field is None else f"{whole} {where}"
    else:
        said = f"in the algebra {algebra}, {where}"
    place = textwrap.wrap(said, style.width, subsequent_indent="  ")
    lines = [style.bold(pretty(statement)), *place, ""]
    shown = decision_lines(statement, decision, field or UNIVERSAL, style, algebra)
    return "\n".join([*lines, *shown])


def decision_lines(
    text: str, decision: Decision, field: str, style: TerminalStyle, algebra: str | None = None
) -> Iterator[str]:
    """Yield verdict, steps, witness and the assumptions or methods tried, each wrapped beside its label."""
    mark = replace(style, colour=False).mark(decision.verdict)
    verdict = f"{mark} {decision.verdict.replace('-', ' ')}"
    if decision.verdict != NOT_APPLICABLE:
        verdict += f"  (by {decision.method}{scope_text(decision)})"
    first, *rest = wrapped("verdict", verdict, style)
    yield from (first.replace(mark, style.mark(decision.verdict), 1), *rest)
    for n, step in enumerate(decision.steps, 1):
        indent = len(step) - len(step.lstrip())
        shown = shorten(step.strip(), _MAX_STEP_LENGTH)
        yield from wrapped(f"{n}. ".rjust(_LABEL), shown, style, indent=indent)
    witness = witness_text(decision.witness, field)
    if witness:
        yield from wrapped("witness", witness, style)
    if decision.verdict == REFUTED:
        for n, line in enumerate(worked_out(text, decision.witness, field, algebra)):
            yield from wrapped("" if n else "there", line, style)
    for theorem in decision.assumes:
        yield from wrapped("assumes", theorem, style)
    for attempt in decision.tried:
        yield from wrapped("tried", attempt, style)


def scope_text(decision: Decision) -> str:
    """Return where the statement holds, beyond the field over which it was decided."""
    scope = decision.scope
    if scope is None or scope == FIELD:
        return ""
    if scope.primes:
        many = "s" if len(scope.primes) > 1 else ""
        return f"; it holds exactly in characteristic{many} {', '.join(map(str, scope.primes))}"
    return f", over all {scope}"


def wrapped(label: str, text: str, style: TerminalStyle, indent: int = 0) -> list[str]:
    """Return the label with the text beside it, wrapped to the width of the terminal."""
    return hanging(f"  {label:<{_LABEL}}" + " " * indent, text, style.width)


MAX_LINES = 3
MAX_WEIGHT = 2_000


def worked_out(
    text: str,
    witness: Mapping[str, Sequence[str]] | None,
    field: str,
    algebra: str | None = None,
) -> list[str]:
    """Evaluate the comparisons of a statement that fail at a witness: ``p·q = k ≠ −k = q·p``.

    ``algebra`` is H if None. Returns nothing for a claim in words, or a statement with ``exists``.
    """
    witness = witness or {}
    name = witness[STATED_FIELD][0] if STATED_FIELD in witness else field
    if name in (UNIVERSAL, NO_FIELD):
        return []
    try:
        F = ring(name)
        setting = read_setting(F, algebra)
        read = read_statement(text, F, (), setting.letters, setting.constants, setting.table)
        if read.exists or weight(read.node) > MAX_WEIGHT:
            return []
        return list(_failures(_world(read, setting, F, witness), read, F))[:MAX_LINES]
    except (HFieldError, KeyError):  # in words, or with unknowns that the witness lacks
        return []


def _world(
    statement: Statement,
    setting: Setting,
    F: Ring,
    witness: Mapping[str, Sequence[str]],
) -> Evaluator[Scalar, bool, bool]:
    """Assign the values of the witness to the unknowns. Raises KeyError for one without a value."""
    own = {name: witness[name] for name, _ in statement.unknowns if name not in statement.helpers}
    if statement.ordered is not None:
        reals = Problem(statement, setting).over(ring("RR"))
        ordered = OrderedEvaluator(reals, RingScalars(reals.ring))
        ordered.bind(read_back(reals.ring, own))
        return ordered
    fixed = {text: F(text) for text in statement.constants}
    values = read_back(F, own)
    world = Evaluator(RingScalars(F), setting.trees, statement.sorts, fixed)
    world.bind(values)
    return world


def _failures(world: Evaluator[Scalar, bool, bool], statement: Statement, F: Ring) -> Iterator[str]:
    """Write the comparisons of the conclusion that are false."""
    conclusion = statement.conclusion
    if statement.ordered is not None:
        conclusion, F = taken_apart(statement.ordered)[1], ring("RR")
    for node in walk(conclusion):
        if isinstance(node, Compare) and not world.truth(node):
            sides = [_side(world, x, F) for x in (node.left, node.right)]
            if not all(value for _, value in sides):
                shown = next(text for text, value in sides if not value)
                yield f"{shown} is not defined"
            else:
                (left, x), (right, y) = sides
                yield _chain(left, x, _FALSE[node.op], y, right)


def _side(world: Evaluator[Scalar, bool, bool], node: Node, F: Ring) -> tuple[str, str]:
    """Return the text of a term and of its value; '' if it has no value."""
    value, defined = world.term(node)
    if not defined:
        return to_unicode(node), ""
    return to_unicode(node), element_text(F, world.embed(value), "unicode")


def _chain(left: str, x: str, sign: str, y: str, right: str) -> str:
    """Join two terms and their values without repeating equal texts: ``p·q = k ≠ −k = q·p``."""
    if sign == "=":
        return " = ".join(dict.fromkeys((left, x, right)))
    right = y if right == "e" else right
    return f" {sign} ".join(" = ".join(dict.fromkeys(side)) for side in ((left, x), (y, right)))
