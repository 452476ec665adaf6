"""Check ``exhaustion``: try all cases over a finite ring."""

from collections.abc import Hashable, Iterator, Mapping
from functools import partial
from itertools import product

from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.clauses import Expansion, expand
from hfield.checker.evaluate import Evaluator, Quaternion, RingScalars
from hfield.checker.glossary import EXHAUSTION, FIELD
from hfield.checker.language import Tree
from hfield.checker.over_field import EvaluationContext
from hfield.checker.polynomials import ONE, Monomial, variables, width
from hfield.checker.rejection import an_integer, an_object, reject
from hfield.checker.scalars.place import E
from hfield.checker.scalars.ring import AnyRing, Ring
from hfield.checker.statement import Setting, Statement

MAX_REPEATED_CASES = 5_000
COST = 200  # the cost of evaluating a statement once
MAX_ORDER = 5_000

Coefficients = dict[Monomial, Hashable]
Case = tuple[list[Coefficients], list[list[Coefficients]]]


def evaluator_at(
    ring: Ring[E],
    setting: Setting,
    statement: Statement,
    values: Mapping[str, E | Quaternion[E]],
) -> Evaluator[E, bool]:
    """Return the evaluator with these values of the unknowns."""
    known: dict[Tree, E | Quaternion[E]] = {**ring.named_elements(statement.constants)}
    known.update((("name", name), value) for name, value in values.items())
    return Evaluator(RingScalars(ring), setting.constants, known)


def truth_at(
    ring: Ring[E],
    setting: Setting,
    statement: Statement,
    values: Mapping[str, E | Quaternion[E]],
) -> bool | None:
    """Return whether the statement is true at these values; None if the algebra does not exist."""
    spend(COST)
    evaluator = evaluator_at(ring, setting, statement, values)
    return None if evaluator.conditions else bool(evaluator.truth(statement.matrix))


def coordinates(unknowns: tuple[tuple[str, str], ...]) -> int:
    """Return the number of coordinates of unknowns."""
    return sum(1 if sort == "s" else 4 for _, sort in unknowns)


def check_all(statement: Statement, setting: Setting, cases: int) -> None:
    """Check a quantifier-free statement for all values of its unknowns."""
    ring, order = _finite(setting)
    total, by_clauses = (
        order ** coordinates(statement.unknowns),
        ring.is_field or not statement.divides,
    )
    if by_clauses and (total > MAX_REPEATED_CASES or cases != total):
        tree = _Tree(expand(statement, setting), ring)
        if cases not in (total, order ** len(tree.used)):
            reject("the number of cases is wrong")
        tree.check()
        return
    if cases != total:
        reject("the number of cases is wrong")
    truths = {
        truth_at(ring, setting, statement, values) for values in places(ring, statement.unknowns)
    }
    if False in truths:
        reject("the statement is false in one of the cases")
    if True not in truths:
        reject("the structure constants of the algebra are defined nowhere")


def check_exists(statement: Statement, setting: Setting, cases: int) -> None:
    """Check that for all given values there are values of the variables bound by ``exists``."""
    ring, order = _finite(setting)
    if cases != order ** coordinates(statement.given):
        reject("the number of cases is wrong")
    bound = tuple((name, sort) for name, sort in statement.unknowns if name in statement.exists)
    defined = False
    for values in places(ring, statement.given):
        for more in places(ring, bound):
            truth = truth_at(ring, setting, statement, {**values, **more})
            if truth is not False:  # true; or there is no algebra for these letters
                defined |= truth is True
                break
        else:
            reject("for some values nothing exists")
    if not defined:
        reject("the structure constants of the algebra are defined nowhere")


def _finite(setting: Setting) -> tuple[AnyRing, int]:
    ring = setting.field
    if ring is None or ring.order is None:
        reject("all cases can be tried over a finite ring only")
    if ring.order > MAX_ORDER:
        reject("the ring has too many elements to try them all")
    return ring, ring.order


def places(
    ring: Ring[E], unknowns: tuple[tuple[str, str], ...]
) -> Iterator[dict[str, E | Quaternion[E]]]:
    """Yield all values of the unknowns."""
    elements = list(ring.elements())
    for values in product(elements, repeat=coordinates(unknowns)):
        rest = iter(values)
        out: dict[str, E | Quaternion[E]] = {}
        for name, sort in unknowns:
            out[name] = next(rest) if sort == "s" else Quaternion([next(rest) for _ in range(4)])
        yield out


class _Tree:
    """A search tree over the values of the coordinates, pruned at nodes at which all clauses are decided."""

    def __init__(self, expansion: Expansion, ring: AnyRing) -> None:
        self.ring = ring
        context = EvaluationContext(expansion, ring)
        context.need_algebra()
        self.elements = list(ring.elements())
        self.cases: list[Case] = []
        used: set[int] = set()
        for clause in expansion.clauses:
            for f in clause.zeros.union(*clause.goals):
                used |= {v for v in variables(dict(f)) if v < expansion.unknowns}
            zeros = [context.coefficients(dict(f), True) for f in clause.zeros]
            goals = [[context.coefficients(dict(f), True) for f in goal] for goal in clause.goals]
            self.cases.append((zeros, goals))
        self.used = sorted(used)
        self.powers: dict[tuple[Hashable, int], Hashable] = {}

    def check(self) -> None:
        """Check a statement by evaluating it at all values of its unknowns."""
        self._try(0, [case for case in self.cases if not self._settled(case)])

    def _try(self, depth: int, cases: list[Case]) -> None:
        if not cases:
            return
        if depth == len(self.used):
            reject("the statement is false in one of the cases")
        put = partial(self._put, self.used[depth])
        for value in self.elements:
            rest = []
            for zeros, goals in cases:
                case = [put(value, f) for f in zeros], [[put(value, f) for f in g] for g in goals]
                if not self._settled(case):
                    rest.append(case)
            self._try(depth + 1, rest)

    def _settled(self, case: Case) -> bool:
        """Return whether a clause is true for all values of the other coordinates."""
        zeros, goals = case
        return any(set(z) == {ONE} for z in zeros) or any(not any(goal) for goal in goals)

    def _put(self, variable: int, value: Hashable, f: Coefficients) -> Coefficients:
        ring = self.ring
        spend(2 * len(f) + width(f) // 4 + 1)
        out: Coefficients = {}
        for m, c in f.items():
            e = dict(m).get(variable, 0)
            if e:
                c = ring.mul(c, self._power(value, e))
                m = tuple(pair for pair in m if pair[0] != variable)
            out[m] = ring.add(out[m], c) if m in out else c
        return {m: c for m, c in out.items() if not ring.is_zero(c)}

    def _power(self, value: Hashable, e: int) -> Hashable:
        if (value, e) not in self.powers:
            spend(5)
            self.powers[value, e] = self.ring.power(value, e)
        return self.powers[value, e]


def exhaustion(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove a statement over a finite ring by trying all cases."""
    data = an_object(evidence, "kind cases", "the evidence")
    check = check_exists if statement.exists else check_all
    check(statement, setting, an_integer(data["cases"], "cases", 1))
    return CheckResult(FIELD, EXHAUSTION)


CHECKS = {
    ("proved", False, "exhaustion"): exhaustion,
    ("proved", True, "exhaustion"): exhaustion,
}
