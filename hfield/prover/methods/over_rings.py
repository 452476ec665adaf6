"""Decide a statement over a ring that is not a field.

An integral domain is contained in its field of fractions. So a statement without division that holds for all
elements of the field holds for those of the domain. Statements with division do not carry over, because more
elements are invertible in the field.
"""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import product
from math import gcd

from hfield.checker.glossary import EXHAUSTION
from hfield.errors import HFieldError, UndecidedError
from hfield.evidence import Evidence, Kind
from hfield.fields import ZZ
from hfield.fields.base.ring import Ring
from hfield.prover.attempts import Attempts
from hfield.prover.counterexamples.search import PLACES_BETWEEN, search_counterexample
from hfield.prover.decision import FIELD, PROVED, UNDECIDED, Decision
from hfield.prover.evaluation.all_cases import FEW_CASES, coordinates
from hfield.prover.evaluation.evaluator import Evaluator
from hfield.prover.evaluation.scalars import RingScalars
from hfield.prover.methods import one_field
from hfield.prover.methods.decisions import identity, implied, refuted, scope_of_identity
from hfield.prover.methods.implications import prove_clauses
from hfield.prover.methods.one_field import exhaust, used_variables
from hfield.prover.polynomials.expansion import Expanded, expand
from hfield.prover.polynomials.vanishing import prime_factors, vanishes
from hfield.prover.problem import Problem
from hfield.prover.statements.printing import to_text
from hfield.prover.statements.setting import put_letters
from hfield.prover.statements.trees import FALSE, divides_in, substitute, walk
from hfield.prover.steps import say
from hfield.syntax import Binary, Call, Index, Logic, Name, Node, Not, Number, Power

RING_ORDERS_TRIED = (2, 3, 4, 5, 7, 8, 9, 11, 13)
MAX_MODULI = 16
MAX_UNITS = 4


def decide(problem: Problem) -> Decision:
    """Decide over a ring that is not a field, by the first method that answers."""
    field, statement = problem.ring, problem.statement
    attempts, tried = Attempts(), [f"{PLACES_BETWEEN} small places over {field.name}"]
    found = attempts.answer(search_counterexample, problem, PLACES_BETWEEN)
    if found is not None:
        return refuted(problem, found)
    x = attempts.answer(expand, problem)
    divided = any(map(divides_in, (*statement.hypotheses, statement.conclusion)))
    if x is not None and not divided:
        proved = attempts.first([partial(_proved, problem, x)])
        if proved is not None:
            return proved
        tried.append("ideal membership of the conclusion")
    if field.order is not None:
        decision = exhaust(problem, x)
        if decision.verdict == UNDECIDED and x is not None and not divided:
            decision = attempts.decide([partial(_modulo, problem, x), lambda: decision])
        return decision
    if divided:
        proved = attempts.first([partial(_proved_with_numerals, problem)])
        if proved is not None:
            return proved
        tried.append(
            f"where something divides, what holds over fields says nothing of {field.name}"
        )
    return attempts.decide([partial(_at_units, problem)], *tried)


def _at_units(problem: Problem) -> Decision | None:
    """Prove over ℤ, without certificate, for letters 1 and −1 by which the structure constants divide."""
    statement, letters = problem.statement, sorted(problem.letters)
    below = [x for tree in problem.setting.trees for n in walk(tree) for x in _divisors(n)]
    factors = {name for x in below for name in _factors(x)}
    units = [name for name in letters if name in factors][:MAX_UNITS]
    if problem.ring != ZZ or not units:
        return None
    names = tuple(name for name, _ in statement.unknowns if name not in units)
    for values in product((1, -1), repeat=len(units)):
        chosen: dict[str, Node] = {name: Number(n) for name, n in zip(units, values, strict=True)}
        there = problem.for_formula(substitute(statement.node, chosen), names)
        one = decide(replace(there, setting=put_letters(problem.setting, chosen)))
        if one.verdict != PROVED:
            return None
    steps = (say("units", letters=", ".join(units)),)
    return Decision(PROVED, EXHAUSTION, steps=steps, scope=FIELD)


def _factors(node: Node) -> tuple[str, ...]:
    """Return names of factors of a product; x**0 is 1, whatever x is."""
    match node:
        case Name(name=name):
            return (name,)
        case Binary("*", x, y):
            return (*_factors(x), *_factors(y))
        case Power(x, exponent) if exponent:
            return _factors(x)
    return ()


def _divisors(node: Node) -> tuple[Node, ...]:
    """Return the divisors in a node."""
    match node:
        case Binary("/", _, right):
            return (right,)
        case Power(base, exponent) if exponent < 0:
            return (base,)
        case Call("inv", (base,)):
            return (base,)
    return ()


def _proved(problem: Problem, x: Expanded) -> Decision | None:
    """Prove a statement without division."""
    field, statement = problem.ring, problem.statement
    if all(any(all(vanishes(p, x, field) for p in g) for g in c.goals) for c in x.clauses):
        return identity(statement, x, field, scope_of_identity(statement, x))
    proof = prove_clauses(problem, 0)
    p = field.characteristic
    if proof and (proof.is_direct or field.is_domain) and (not p or proof.denominator % p):
        return implied(proof, problem)
    above = field.fractions
    if above is not None:
        decision = one_field.decide(problem.over(above))
        if decision.verdict == PROVED:
            evidence = Evidence(Kind.FRACTIONS, ring=above.data, proof=decision.evidence)
            step = say("in-fractions", R=field.name, F=above.name)
            return replace(decision, steps=(*decision.steps, step), evidence=evidence)
    return _modulo(problem, x) if not p else None


def _proved_with_numerals(problem: Problem) -> Decision | None:
    """Prove over a domain a statement whose divisors are numerals; comparisons with a non-unit divisor are
    false.
    """
    field, statement = problem.ring, problem.statement
    above = field.fractions
    if above is None:
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
    decision = one_field.decide(problem.with_statement(there).over(above))
    if decision.verdict != PROVED:
        return None
    evidence = Evidence(Kind.FRACTIONS, ring=above.data, proof=decision.evidence)
    step = say("divides-by-units", R=field.name)
    return replace(decision, steps=(*decision.steps, step), evidence=evidence if same else None)


def settled(node: Node, field: Ring) -> Node:
    """Replace each comparison that divides by a numeral by false, if the numeral is not a unit.

    Raises UndecidedError for other divisors.
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
        case _:
            found = _divisors(node)
            if not found:
                return True
            (below,) = found
    if any(isinstance(n, Name | Call | Index) for n in walk(below)):
        raise UndecidedError("the statement divides by more than numerals")
    x, defined = Evaluator(RingScalars(field)).term(below)
    return defined and field.is_unit(x)


def _modulo(problem: Problem, x: Expanded) -> Decision | None:
    """Prove that polynomials have no common zero in ℤ or ℤ/m, because they have none modulo n (a divisor of
    m).
    """
    field = problem.ring
    if any(c.goals for c in x.clauses):
        return None
    for n in _moduli(x, field.characteristic):
        if problem.is_late:
            return None
        residues = field.modulo(n)
        if residues is None:
            continue
        there = problem.over(residues).within(1.0)
        cases = n ** len(coordinates(problem.statement, used_variables(x)))
        if not residues.is_field and cases > FEW_CASES * 40:
            continue
        try:
            decision = (
                one_field.decide(there) if residues.is_field else exhaust(there, expand(there))
            )
        except HFieldError:
            continue
        if decision.verdict == PROVED:
            evidence = Evidence(Kind.REDUCTION, modulus=n, proof=decision.evidence)
            step = say("modulo", R=field.name, n=n)
            return replace(decision, scope=FIELD, steps=(*decision.steps, step), evidence=evidence)
    return None


def _moduli(x: Expanded, m: int) -> Iterator[int]:
    """Yield moduli for which a contradiction may occur, over ℤ or (for m > 0) ℤ/m."""
    seen: dict[int, None] = {}
    zeros = [z for clause in x.clauses for z in clause.zeros]
    for z in zeros:  # modulo the common divisor of all other coefficients, only a constant is left
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
    for n in RING_ORDERS_TRIED:
        seen.setdefault(n)
    yield from [n for n in seen if not m or m % n == 0][:MAX_MODULI]
