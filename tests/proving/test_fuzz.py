"""Random statements: the prover against an evaluator that tries every case."""

import random

import pytest

from hfield.errors import HFieldError
from hfield.proving.decide import decide
from tests.proving.oracle import Generator, holds_at_random, holds_everywhere, true_at, unknowns

PRIMES = {"QQ": 0, "GF(2)": 2, "GF(3)": 3, "GF(5)": 5, "GF(7)": 7}
POSITIVE = ("proved", "vacuous")


def cases(text):
    return sum(4 if name in "pqruvw" else 1 for name in unknowns(text))


@pytest.mark.parametrize("seed", range(8))
def test_verdicts_agree_with_all_cases(seed):
    generator, rng = Generator(100 + seed), random.Random(seed)
    for _ in range(30):
        statement = generator.statement()
        for field, p in (("GF(2)", 2), ("GF(3)", 3), ("QQ", 0), (None, 0)):
            decision = decide(statement, field, timeout=2)
            assert p == 0 or decision.verdict != "undecided", statement
            if decision.verdict == "undecided" or (p == 3 and cases(statement) > 8):
                continue
            assert decision.evidence is not None, statement
            positive = decision.verdict in POSITIVE
            if p:
                assert positive == holds_everywhere(statement, p), (statement, field)
            elif positive and "exists" not in statement:
                assert holds_at_random(statement, rng), (statement, field)
            if positive and field is None:
                assert holds_everywhere(statement, 2), statement
            if decision.verdict == "refuted" and "exists" not in statement:
                place = decision.witness.get("F", [field])[0]
                if place in PRIMES:
                    assert not true_at(statement, PRIMES[place], decision.witness), statement


def test_statements_in_three_unknowns_over_gf2():
    generator = Generator(5, quaternions="pqr", scalars="sz")
    for _ in range(40):
        statement = generator.statement()
        verdict = decide(statement, "GF(2)", timeout=2).verdict
        assert (verdict in POSITIVE) == holds_everywhere(statement, 2), statement


SIGNS = "pqrs01e ijk()*+-=!<>/[]. ,normtaceivxhdby"


def test_mutated_statements_never_break_the_prover():
    generator, rng = Generator(9), random.Random(9)
    for _ in range(400):
        text = list(generator.statement())
        for _ in range(rng.randint(1, 3)):
            at = rng.randrange(len(text))
            text[at : at + rng.randint(0, 1)] = rng.choice(SIGNS)
        try:
            decision = decide(
                "".join(text), rng.choice(["GF(2)", "QQ", "GF(9)", None]), timeout=0.3
            )
        except HFieldError:
            continue
        assert decision.verdict in ("proved", "refuted", "vacuous", "undecided")
