"""Check evidence over ℚ_p with values in a number field that Hensel's lemma embeds in ℚ_p.

Let f be monic, let p divide no denominator of r and f, and let v(f(r)) > 2·v(f′(r)). Then Newton's steps from
r converge to a root of f in ℚ_p, so ℚ[s]/(f) can be embedded in ℚ_p (ℚ(√d) with f = X² − d). A term has the
same value in both fields. So elements of ℚ[s]/(f) at which a statement is false refute it over ℚ_p, and
elements with a stated property exist in ℚ_p.
"""

from dataclasses import replace
from fractions import Fraction
from functools import partial

from hfield.checker.budget import spend_products
from hfield.checker.check_result import CheckResult
from hfield.checker.evidence import Check
from hfield.checker.evidence.witnesses import counterexample, example
from hfield.checker.rejection import a_text, an_object, reject
from hfield.checker.scalars.completions import AtPrime
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.number_fields import NumberField
from hfield.checker.scalars.quadratic import Quadratic
from hfield.checker.scalars.rationals import QQ, RationalPlace
from hfield.checker.statement import Setting, Statement


def subfield(
    check: Check,
    statement: Statement,
    setting: Setting,
    evidence: object,
) -> CheckResult:
    """Check a witness with coordinates in a number field for a statement over ℚ_p."""
    data = an_object(evidence, "kind ring root witness", "the evidence")
    local = setting.field
    if not (isinstance(local, AtPrime) and isinstance(local.only, RationalPlace)):
        reject("subfields are known of the p-adic numbers only")
    inner = read_ring(data["ring"])
    if isinstance(inner, Quadratic):
        f = [Fraction(-inner.d), Fraction(0), Fraction(1)]
    elif isinstance(inner, NumberField):
        f = inner.modulus
    else:
        reject(f"{inner.name} is not a number field with a generator")
    _lift(QQ.read(a_text(data["root"], "a root")), f, local.only.n)
    return check(statement, replace(setting, field=inner), data["witness"])


def _lift(r: Fraction, f: list[Fraction], p: int) -> None:
    """Show that f has a root near r."""
    if any(c.denominator % p == 0 for c in (r, *f)):
        reject(f"Hensel's lemma asks for numbers without {p} in a denominator")
    slope = _value([n * c for n, c in enumerate(f)][1:], r)
    value = _value(f, r)
    if not slope or (value and _order(value, p) <= 2 * _order(slope, p)):
        reject(f"the number given is not so near a root in Qp({p}) that Hensel's lemma finds one")


def _value(f: list[Fraction], r: Fraction) -> Fraction:
    """Return f(r)."""
    total = Fraction(0)
    for c in reversed(f):
        total = QQ.add(QQ.mul(total, r), c)
    return total


def _order(x: Fraction, p: int) -> int:
    """Return the valuation of a number other than 0."""
    n, top, below = 0, x.numerator, x.denominator
    while top % p == 0:
        spend_products([p], [top])
        n, top = n + 1, top // p
    while below % p == 0:
        spend_products([p], [below])
        n, below = n - 1, below // p
    return n


CHECKS = {
    ("proved", True, "subfield"): partial(subfield, example),
    ("refuted", False, "subfield"): partial(subfield, counterexample),
}
