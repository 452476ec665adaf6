"""Check evidence from another ring: the field of fractions, or residues."""

from dataclasses import replace

from hfield.checker.check_result import CheckResult
from hfield.checker.clauses import expand
from hfield.checker.evidence import prove
from hfield.checker.glossary import FIELD
from hfield.checker.rejection import an_integer, an_object, reject
from hfield.checker.scalars.fields import read_ring
from hfield.checker.statement import Setting, Statement


def fractions(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """A statement without division that holds over the field of fractions holds over the ring."""
    data = an_object(evidence, "kind ring proof", "the evidence")
    field = read_ring(data["ring"])
    if statement.divides or setting.field is None or not field.is_fraction_field_of(setting.field):
        reject("a ring takes from its field of fractions what is said without division")
    return prove(statement.matrix, replace(setting, field=field), data["proof"]).within(FIELD)


def reduction(statement: Statement, setting: Setting, evidence: object) -> CheckResult:
    """Polynomials without a common zero modulo n have none in ℤ, or modulo a multiple of n."""
    data = an_object(evidence, "kind modulus proof", "the evidence")
    ring, n = setting.field, an_integer(data["modulus"], "the modulus", 2)
    if ring is None or statement.divides or not ring.maps_modulo(n):
        reject(
            "what is said without division over ZZ or ZZ/m is reduced modulo n, or a divisor of m"
        )
    if any(clause.goals for clause in expand(statement, setting).clauses):
        reject("only that polynomials have no common zero is shown modulo n")
    there = replace(setting, field=read_ring({"kind": "residues", "modulus": n}))
    return prove(statement.matrix, there, data["proof"]).within(FIELD)


CHECKS = {
    ("proved", False, "fractions"): fractions,
    ("proved", False, "reduction"): reduction,
}
