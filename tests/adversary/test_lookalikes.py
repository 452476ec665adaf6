"""Forgeries by meaning: certificates about one field where a reader sees another; none says a falsehood."""

from collections import Counter

import pytest

from hfield.checker.check import check
from tests.adversary.names.facts import ASKED, facts
from tests.adversary.names.lookalikes import (
    ALWAYS,
    GROUPS,
    forged,
    genuine,
    over,
    verdict,
    wrong_in,
)
from tests.adversary.names.reader import read
from tests.subcases import subcases


@pytest.mark.slow
@subcases("group", range(len(GROUPS)))
def test_no_field_passes_for_another(group: int) -> None:
    tally: Counter[tuple[str, bool]] = Counter()
    for how, data in forged(group):
        wrong = wrong_in(data)
        assert not wrong, (how, data)
        tally[how, wrong is None] += 1
    passed = {how for how, rejected in tally if not rejected}
    assert passed <= {"the other's field", "the other's field, the evidence as it was"}
    assert sum(tally.values()) > 50


@pytest.mark.slow
@subcases("group", range(len(GROUPS)))
def test_what_is_forged_is_genuine(group: int) -> None:
    """So are the certificates before they are forged, with ``over`` too, and their verdicts are facts."""
    found = list(genuine(group))
    assert len(found) > 2
    for name, claim, data in found:
        assert check(data).verdict == data["verdict"] == verdict(claim, name)
        again = over(data, name, data["ring"])
        assert wrong_in(again) == "", again
        if claim in ALWAYS:
            square = facts(read(name)).squares[ASKED.index(int(claim.split()[-1]))]
            assert square is None or data["verdict"] == ("refuted" if square else "proved"), (
                name,
                claim,
            )
