"""The prover asked many random statements, its answers and certificates judged."""

from collections import Counter
from dataclasses import dataclass, field

from hfield.errors import HFieldError
from hfield.prover.prove import prove
from tests.adversary.judgement import judge, judge_certificate
from tests.adversary.statement_generator import Case, cases


@dataclass
class Findings:
    """What was answered, and what was wrong with it."""

    tally: Counter[str] = field(default_factory=Counter)
    complaints: list[str] = field(default_factory=list)


def ask(case: Case, timeout: float, seed: int) -> tuple[str, list[str]]:
    """Return the verdict, and what is wrong with the answer."""
    try:
        answer = prove(case.statement, case.field, (), case.algebra, timeout)
    except HFieldError as error:
        return f"error: {str(error)[:60]}", []
    found = answer.to_json()
    # Of its algebra a scope speaks as the answer shows it: constants of a finite field are reduced.
    wrong = judge(case.statement, case.field, found["algebra"], found, seed)
    if case.true and answer.verdict == "refuted":
        wrong.append("refuted, but true by construction")
    own, scope = judge_certificate(
        answer.certificate, answer.verdict, answer.text, answer.field, found["algebra"]
    )
    wrong += own
    verdict = answer.verdict
    if answer.certificate is None and verdict in ("proved", "refuted", "vacuous"):
        verdict = f"{verdict}, without a certificate"
    if scope not in (None, "field", found["scope"]) and answer.verdict != "refuted":
        again = {"verdict": answer.verdict, "scope": scope, "witness": None}
        said = judge(case.statement, case.field, found["algebra"], again, seed)
        wrong += [f"the checker: {text}" for text in said]
    return verdict, wrong


def interrogate(seed: int, count: int, timeout: float) -> Findings:
    """Ask so many statements."""
    out = Findings()
    for n, case in enumerate(cases(seed, count)):
        verdict, wrong = ask(case, timeout, n)
        out.tally[verdict] += 1
        where = f"{case.statement!r}, field {case.field}, algebra {case.algebra}"
        out.complaints += [f"{where}: {text}" for text in wrong]
    return out
