"""Check that an equation in one unknown has a root in ℝ or ℂ, by a cited theorem."""

from dataclasses import replace

from hfield.checker.budget import spend
from hfield.checker.check_result import CheckResult
from hfield.checker.clauses import expand
from hfield.checker.glossary import (
    COMPLEX_ROOT,
    FIELD,
    ODD_DEGREE,
    REAL_ROOTS,
    SIGN_CHANGE,
    WITNESS,
)
from hfield.checker.over_field import EvaluationContext
from hfield.checker.polynomials import Poly, is_constant
from hfield.checker.rejection import an_object, reject, shown, texts
from hfield.checker.scalars.rationals import QQ
from hfield.checker.statement import Setting, Statement

MAX_DEGREE = 1_000


def real_root(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove ``exists s: f == g`` over RR, for all values of the given unknowns."""
    by = evidence.get("by") if isinstance(evidence, dict) else None
    own = "between" if by == "sign change" else ""
    data = an_object(evidence, f"kind by {own}", "the evidence")
    c = _coefficients(statement, setting, "RR")
    lead = c.get(max(c), {})
    if by == "odd degree":
        if max(c) % 2 == 0 or not is_constant(lead):
            reject("the degree is not odd, or the leading coefficient no number")
        return CheckResult(FIELD, WITNESS).citing(ODD_DEGREE)
    if by == "square":
        sign = 1 if is_constant(lead) and lead[()] > 0 else -1
        rest = {m: -sign * n for m, n in c.get(0, {}).items()}  # lead·s² = ± rest
        squares = all(n > 0 and all(e % 2 == 0 for _, e in m) for m, n in rest.items())
        if not set(c) <= {0, 2} or not is_constant(lead) or not squares:
            reject("the equation does not say that a square is a sum of squares")
        return CheckResult(FIELD, WITNESS).citing(REAL_ROOTS)
    if by == "sign change":
        ends = [QQ.read(text) for text in texts(data["between"], "between", 2)]
        if len(ends) != 2 or not all(set(f) <= {()} for f in c.values()):
            reject("a change of sign is that of a polynomial with numbers for coefficients")
        values = [QQ.zero, QQ.zero]
        for n, x in enumerate(ends):
            for k, f in c.items():
                values[n] = QQ.add(values[n], QQ.mul(QQ.number(f[()]), QQ.power(x, k)))
        if values[0] * values[1] > 0:
            reject("the sign does not change")
        return CheckResult(FIELD, WITNESS).citing(SIGN_CHANGE)
    reject(f"there is no reason {shown(by)!r} for a real root")


def complex_root(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Prove ``exists s: f == g`` over CC: a polynomial whose leading coefficient is a number has a root."""
    an_object(evidence, "kind", "the evidence")
    c = _coefficients(statement, setting, "CC")
    if not is_constant(c[max(c)]):
        reject("the leading coefficient is not a nonzero number")
    return CheckResult(FIELD, WITNESS).citing(COMPLEX_ROOT)


def _coefficients(statement: Statement, setting: Setting, name: str) -> dict[int, Poly]:
    """Return the coefficients of f − g in the single existential scalar; the degree must be positive."""
    sorts = dict(statement.unknowns)
    if setting.field is None or setting.field.name != name or statement.divides:
        reject(f"roots are found over {name}, where nothing divides")
    if (
        len(statement.exists) != 1
        or sorts[statement.exists[0]] != "s"
        or statement.conclusion[0] != "=="
    ):
        reject("a root is that of one equation in one scalar")
    equation = replace(statement, exists=(), hypotheses=())
    expansion = expand(equation, setting)
    context = EvaluationContext(expansion, setting.field)
    if (
        len(expansion.clauses) != 1
        or expansion.clauses[0].zeros
        or len(expansion.clauses[0].goals) != 1
    ):
        reject("the equation is not an equation between polynomials")
    left = [f for goal in expansion.clauses[0].goals for f in goal if not context.vanishes(f)]
    if len(left) != 1:
        reject("more than one coordinate of the equation does not vanish")
    s = expansion.names.place["name", statement.exists[0]]
    out: dict[int, Poly] = {}
    for m, n in left[0]:
        spend(5)
        exponents = dict(m)
        k = exponents.pop(s, 0)
        out.setdefault(k, {})[tuple(exponents.items())] = n
    if not 0 < max(out) <= MAX_DEGREE:
        reject("the degree in what is sought is 0, or too large")
    return out


CHECKS = {
    ("proved", True, "real root"): real_root,
    ("proved", True, "complex root"): complex_root,
}
