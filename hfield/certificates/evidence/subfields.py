"""Over ℚ_p: elements of a subfield ℚ(√d), whose root Hensel's lemma finds in ℚ_p.

Where v(r² − d) > 2·v(2r), Newton's steps from r lead to a root of X² − d in ℚ_p, so that ℚ(√d) lies in ℚ_p. A
term has the same value in both. So what is false for elements of ℚ(√d) is false over ℚ_p, and what they show
to exist exists there.
"""

from dataclasses import replace
from fractions import Fraction
from functools import partial

from hfield.certificates.evidence.witnesses import counterexample, example
from hfield.certificates.finding import Finding
from hfield.certificates.kinds import Check
from hfield.certificates.rejection import a_text, an_object, reject
from hfield.certificates.scalars.completions import AtPrime
from hfield.certificates.scalars.fields import read_field
from hfield.certificates.scalars.quadratic import Quadratic
from hfield.certificates.scalars.rationals import QQ
from hfield.certificates.statement import Setting, Statement
from hfield.certificates.work import charge


def subfield(
    check: Check,
    statement: Statement,
    setting: Setting,
    evidence: object,
) -> Finding:
    """Check a witness with coordinates in ℚ(√d) for a statement over ℚ_p."""
    data = an_object(evidence, "kind field root witness", "the evidence")
    local = setting.field
    if not isinstance(local, AtPrime) or local.base is not QQ:
        reject("subfields are known of the p-adic numbers only")
    inner = read_field(a_text(data["field"], "the field of the witness"))
    if not isinstance(inner, Quadratic):
        reject(f"{inner.name} is no quadratic field")
    _lift(QQ.read(a_text(data["root"], "a root")), inner.d, int(local.place_name))
    return check(statement, replace(setting, field=inner), data["witness"])


def _lift(r: Fraction, d: int, p: int) -> None:
    """Let a root of X² − d lie near r."""
    if not r or (r * r != d and _order(r * r - d, p) <= 2 * _order(2 * r, p)):
        reject(f"{r} is not so near a root of {d} in Qp({p}) that Hensel's lemma finds one")


def _order(x: Fraction, p: int) -> int:
    """Return the valuation of a number other than 0."""
    n, top, below = 0, x.numerator, x.denominator
    while top % p == 0:
        charge(5 + top.bit_length() // 100)
        n, top = n + 1, top // p
    while below % p == 0:
        charge(5 + below.bit_length() // 100)
        n, below = n - 1, below // p
    return n


CHECKS = {
    ("proved", True, "subfield"): partial(subfield, example),
    ("refuted", False, "subfield"): partial(subfield, counterexample),
}
