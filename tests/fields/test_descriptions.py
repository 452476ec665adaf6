"""Rings describe themselves word for word as they did before."""

import json

from tests.fields.descriptions import FILE, RINGS, description
from tests.subcases import subcases

BEFORE = json.loads(FILE.read_text(encoding="utf-8"))


def test_all_rings_are_described() -> None:
    assert tuple(BEFORE) == RINGS


@subcases("name", RINGS)
def test_how_a_ring_describes_itself(name: str) -> None:
    assert description(name) == BEFORE[name]
