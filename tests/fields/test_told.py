"""Rings tell of themselves what they told before, word for word."""

import json

from tests.fields.told import FILE, RINGS, told
from tests.subcases import subcases

BEFORE = json.loads(FILE.read_text(encoding="utf-8"))


def test_all_rings_are_asked() -> None:
    assert tuple(BEFORE) == RINGS


@subcases("name", RINGS)
def test_what_a_ring_says_of_itself(name: str) -> None:
    assert told(name) == BEFORE[name]
