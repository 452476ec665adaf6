"""2 000 random statements: no verdict, scope, witness or certificate is wrong.

scripts/try_statements.py asks as many as one likes.
"""

import pytest

from tests.adversary.interrogation import interrogate

CHUNKS, SIZE = 40, 50
VERDICTS = {"proved", "refuted", "vacuous", "undecided", "not-applicable"}


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_answers(chunk: int) -> None:
    found = interrogate(1_000 + chunk, SIZE, timeout=1.0)
    assert found.complaints == []
    assert set(found.tally) <= VERDICTS
    assert found.tally["proved"] >= 5
    assert found.tally["refuted"] >= 5
    assert found.tally["undecided"] <= SIZE // 4
