"""Rings tell of themselves what they told before, word for word."""

import json

import pytest

from tests.rings.told import FILE, RINGS, told

BEFORE = json.loads(FILE.read_text(encoding="utf-8"))


def test_all_rings_are_asked() -> None:
    assert tuple(BEFORE) == RINGS


@pytest.mark.parametrize("name", RINGS)
def test_what_a_ring_says_of_itself(name: str) -> None:
    assert told(name) == BEFORE[name]
