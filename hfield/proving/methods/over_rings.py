"""Deciding over rings that are no fields: by what holds in all rings, in a larger field, or modulo a number.

An integral domain lies in its field of fractions, and what holds for all elements of the field holds for
those of the domain, as long as nothing is divided by: over the field there is more that divides.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from math import gcd
from time import monotonic

from hfield.errors import HFieldError, TooLargeError, UndecidedError
from hfield.proving.counterexamples.refuting import FEW, exhaust, look, used_variables
from hfield.proving.decision import FIELD, PROVED, UNDECIDED, Decision
from hfield.proving.evaluation.all_cases import FEW_CASES, coordinates
from hfield.proving.evaluation.interpretation import RingInterpretation
from hfield.proving.methods.answers import identity, implied, refuted, scope_of_identity
from hfield.proving.methods.implications import prove_clauses
from hfield.proving.polynomials.expansion import Expanded, expand
from hfield.proving.polynomials.vanishing import prime_factors, vanishes
from hfield.proving.statements.language import Statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.setting import Setting
from hfield.proving.statements.trees import divides_in, walk
from hfield.rings import ring
from hfield.rings.base import Ring
from hfield.syntax import Binary, Call, Compare, Index, Logic, Name, Node, Not, Number, Power

FALSE = Compare("==", Number(0), Number(1))
SMALL = (2, 3, 4, 5, 7, 8, 9, 11, 13)
MAX_MODULI = 16

Decide = Callable[[Statement, Setting, float], Decision]


def decide(
    statement: Statement, setting: Setting, deadline: float, decide_over_field: Decide
) -> Decision:
    """Decide over a ring that is no field."""
    field = setting.field
    assert field is not None
    found = look(statement, setting, FEW, deadline)
    if found is not None:
        return refuted(field, found, statement)
    tried = [f"{FEW} small places over {field.name}"]
    try:
        x = expand(statement, setting.constants)
    except TooLargeError as error:
        x = None
        tried.append(str(error))
    divided = any(map(divides_in, (*statement.hypotheses, statement.conclusion)))
    if x is not None and not divided:
        proved = _proved(statement, setting, x, deadline, decide_over_field)
        if proved is not None:
            return proved
        tried.append("ideal membership of the conclusion")
    if field.order is not None:
        decision = exhaust(statement, setting, x, deadline)
        if decision.verdict == UNDECIDED and x is not None and not divided:
            decision = _modulo(statement, setting, x, deadline, decide_over_field) or decision
        return decision
    if divided:
        proved = _proved_with_numerals(statement, setting, deadline, decide_over_field)
        if proved is not None:
            return proved
        tried.append(
            f"where something divides, what holds over fields says nothing of {field.name}"
        )
    return Decision(UNDECIDED, "none", tried=tuple(tried))


def _proved(
    statement: Statement, setting: Setting, x: Expanded, deadline: float, decide_over_field: Decide
) -> Decision | None:
    """Prove a statement in which nothing divides."""
    field = setting.field
    assert field is not None
    if all(any(all(vanishes(p, x, field) for p in g) for g in c.goals) for c in x.clauses):
        return identity(statement, x, field, scope_of_identity(statement, x))
    proof = prove_clauses(statement, setting, 0, deadline)
    p = field.characteristic
    everywhere = proof.complete and (proof.is_direct or is_domain(field))
    if everywhere and (not p or proof.denominator % p):
        return implied(proof, statement, setting)
    above = fractions_of(field)
    if above is not None:
        there = replace(setting, field=above)
        decision = decide_over_field(statement, there, deadline)
        if decision.verdict == PROVED:
            evidence = {"kind": "fractions", "field": above.name, "proof": decision.evidence}
            step = f"{field.name} lies in {above.name}, where this holds"
            return replace(decision, steps=(*decision.steps, step), evidence=evidence)
    return _modulo(statement, setting, x, deadline, decide_over_field) if not p else None


def _proved_with_numerals(
    statement: Statement, setting: Setting, deadline: float, decide_over_field: Decide
) -> Decision | None:
    """Prove over a domain what divides by numerals alone: each is a unit, or its comparison is false."""
    field = setting.field
    above = None if field is None else fractions_of(field)
    if field is None or above is None:
        return None
    try:
        parts = [settled(n, field) for n in (*statement.hypotheses, statement.conclusion)]
    except HFieldError:
        return None
    same = parts == [*statement.hypotheses, statement.conclusion]
    *hypotheses, conclusion = parts
    there = replace(
        statement,
        text=" => ".join(f"({to_text(n)})" for n in parts),
        hypotheses=tuple(hypotheses),
        conclusion=conclusion,
    )
    decision = decide_over_field(there, replace(setting, field=above), deadline)
    if decision.verdict != PROVED:
        return None
    evidence = {"kind": "fractions", "field": above.name, "proof": decision.evidence}
    step = f"what it divides by are units of {field.name}, or the comparison is false"
    return replace(decision, steps=(*decision.steps, step), evidence=evidence if same else None)


def settled(node: Node, field: Ring) -> Node:
    """Return a statement whose comparisons divide by units of the ring, in which those that divide by
    other numerals are false. Raises UndecidedError where something else divides.
    """
    match node:
        case Not(x):
            return Not(settled(x, field))
        case Logic(op, x, y):
            return Logic(op, settled(x, field), settled(y, field))
    return node if all(_is_unit(n, field) for n in walk(node)) else FALSE


def _is_unit(node: Node, field: Ring) -> bool:
    match node:
        case Number(Fraction() as value):
            below: Node = Number(value.denominator)
        case Binary("/", _, right):
            below = right
        case Power(base, exponent) if exponent < 0:
            below = base
        case Call("inv", (base,)):
            below = base
        case _:
            return True
    if any(isinstance(n, Name | Call | Index) for n in walk(below)):
        raise UndecidedError("something divides that is no numeral")
    value, defined = RingInterpretation(field).term(below)
    return bool(defined) and field.is_unit(value)


def is_domain(field: Ring) -> bool:
    """Tell whether the ring is known to be an integral domain."""
    from hfield.rings.polynomials import PolynomialRing

    return field.name == "ZZ" or isinstance(field, PolynomialRing)


def fractions_of(field: Ring) -> Ring | None:
    """Return the field of fractions of an integral domain, if there is a name for it."""
    from hfield.rings.polynomials import PolynomialRing

    if field.name == "ZZ":
        return ring("QQ")
    if isinstance(field, PolynomialRing) and len(field.variables) == 1:
        base = "QQ" if field.base.name == "ZZ" else field.base.name
        return ring(f"{base}({field.variables[0]})")
    return None


def _modulo(
    statement: Statement, setting: Setting, x: Expanded, deadline: float, decide_over_field: Decide
) -> Decision | None:
    """Prove that polynomials have no common zero in ℤ or ℤ/m: they have none modulo a number (dividing m)."""
    field = setting.field
    if field is None or any(c.goals for c in x.clauses):
        return None
    if field.name != "ZZ" and field.residues_of is None:
        return None
    for n in _moduli(x, field.characteristic):
        if monotonic() > deadline:
            return None
        residues = ring(f"ZZ/{n}")
        there = replace(setting, field=residues)
        cases = n ** len(coordinates(statement, used_variables(x)))
        if not residues.is_field and cases > FEW_CASES * 40:
            continue
        try:
            decide_one = decide_over_field if residues.is_field else _exhausted
            decision = decide_one(statement, there, min(deadline, monotonic() + 1.0))
        except HFieldError:
            continue
        if decision.verdict == PROVED:
            evidence = {"kind": "reduction", "modulus": n, "proof": decision.evidence}
            step = f"so in {field.name} too there is nothing else: it would stay true modulo {n}"
            return replace(decision, scope=FIELD, steps=(*decision.steps, step), evidence=evidence)
    return None


def _exhausted(statement: Statement, setting: Setting, deadline: float) -> Decision:
    return exhaust(statement, setting, expand(statement, setting.constants), deadline)


def _moduli(x: Expanded, m: int) -> Iterator[int]:
    """Run through numbers modulo which a contradiction may show: primes in the coefficients first.

    With m > 0, those that divide m.
    """
    seen: dict[int, None] = {}
    zeros = [z for clause in x.clauses for z in clause.zeros]
    for z in zeros:  # modulo what divides all else in it a constant is left
        n = gcd(m, *(int(c) for exponents, c in z.terms() if any(exponents)))
        if n > 1:
            seen.setdefault(n)
    if m:
        seen.update(dict.fromkeys(prime_factors(m) or ()))
    numbers = {abs(int(c)) for z in zeros for _, c in z.terms()}
    for c in sorted(numbers):
        for p in (prime_factors(c) or ()) if c > 1 else ():
            seen.setdefault(p)
            power = p * p
            while c % power == 0 and power < 100:
                seen.setdefault(power)
                power *= p
    for n in SMALL:
        seen.setdefault(n)
    yield from [n for n in seen if not m or m % n == 0][:MAX_MODULI]
