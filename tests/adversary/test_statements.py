"""250 random statements: no verdict, scope, witness or certificate is wrong.

HFIELD_THOROUGH=1 asks 2 500, scripts/try_statements.py as many as one likes.
"""

import random

import pytest

from hfield.errors import HFieldError
from hfield.prover.prove import prove
from tests.adversary.interrogation import interrogate
from tests.adversary.statement_generator import plain_statements
from tests.subcases import first_quick
from tests.thorough import part

CHUNKS, SIZE = part(range(50), 10), 50


@pytest.mark.parametrize("chunk", first_quick(CHUNKS, 1))
def test_answers(chunk: int) -> None:
    found = interrogate(1_000 + chunk, SIZE, timeout=1.0)
    assert found.complaints == []
    assert found.tally["proved"] >= 5
    assert found.tally["refuted"] >= 5
    assert found.tally["undecided"] <= SIZE // 4
    assert sum(n for text, n in found.tally.items() if "without" in text) <= SIZE // 8
    assert not [text for text in found.tally if text.startswith("error")]


SIGNS = "pqrs01e ijk()*+-=!<>/[]. ,normtaceivxhdby"


def test_misspelt_statements_never_break_the_prover() -> None:
    rng = random.Random(9)
    for text in plain_statements(9, 300):
        spoilt = list(text)
        for _ in range(rng.randint(1, 3)):
            at = rng.randrange(len(spoilt))
            spoilt[at : at + rng.randint(0, 1)] = rng.choice(SIGNS)
        try:
            answer = prove("".join(spoilt), rng.choice(["GF(2)", "QQ", "GF(9)", None]), timeout=0.3)
        except HFieldError:
            continue
        assert answer.verdict in ("proved", "refuted", "vacuous", "undecided")
