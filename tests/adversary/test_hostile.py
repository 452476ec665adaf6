"""Dear certificates exercise what they mean: each kind occurs, none is rejected for its form, few take long.

scripts/hostile_certificates.py measures them where they are as dear as the format allows.
"""

import json
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest

from hfield.checker.anisotropy import KEYS
from hfield.checker.budget import Budget, bounded
from hfield.checker.check import check_text
from hfield.checker.evidence import checks
from hfield.checker.orders.words import OVER_Q
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import KINDS, read_ring
from hfield.checker.vocabulary.logic import LOGIC, SPECIAL
from tests.adversary.hostile.files import HOSTILE
from tests.adversary.hostile.reasons import is_meant
from tests.adversary.hostile.rings import long_modulus
from tests.subcases import first_quick
from tests.thorough import part

LITTLE = 0.3  # million units
FILES = [name for name in HOSTILE if not name.startswith("file:")]
PLACES = {
    "number", "split", "prime ideal", "other generator", "prime polynomial", "infinity", "real",
}  # fmt: skip


@cache
def certificate(name: str) -> dict[str, Any]:
    """Return a small file as data."""
    make, small, _ = HOSTILE[name]
    found: dict[str, Any] = json.loads(make(small))
    return found


def objects(value: Any) -> Iterator[dict[str, Any]]:
    """Run through all objects inside."""
    if isinstance(value, dict):
        yield value
    for x in value.values() if isinstance(value, dict) else value:
        if isinstance(x, (dict, list)):
            yield from objects(x)


def everything() -> list[dict[str, Any]]:
    return [x for name in FILES for x in objects(certificate(name))]


def rejection(name: str) -> str:
    """Return why a small file is rejected, '' if it is not."""
    make, small, _ = HOSTILE[name]
    try:
        check_text(make(small), budget=Budget(LITTLE))
    except Rejected as error:
        return str(error)
    return ""


@pytest.mark.parametrize("start", first_quick(part(range(16), 2), 1))
def test_only_for_what_it_says(start: int) -> None:
    for name in list(HOSTILE)[start::16]:
        said = rejection(name)
        assert not said or is_meant(name, said), (name, said)


def test_every_kind_of_evidence_is_there() -> None:
    said = {x.get("kind") for x in everything()}
    assert {kind for _, _, kind in checks()} <= said
    shown = {
        (_word(c["statement"]), c["verdict"])
        for c in map(certificate, FILES)
        if c["evidence"]["kind"] == _word(c["statement"])
    }
    assert OVER_Q.keys() <= shown


def test_every_word_is_there() -> None:
    said = {
        word for name in FILES for word in re.findall("[a-z-]+", certificate(name)["statement"])
    }
    assert LOGIC.keys() | SPECIAL.keys() <= said


def test_every_kind_of_ring_and_of_place_is_there() -> None:
    rings = [x["ring"] for x in everything() if x.get("ring")]
    rings += [ring for x in everything() for ring in x.get("rings", ())]
    assert KINDS.keys() <= {x.get("kind") for x in objects(rings)}
    places = [x["place"] for x in everything() if isinstance(x.get("place"), dict)]
    assert {x["kind"] for x in places} == PLACES


def test_every_step_and_fact_is_there() -> None:
    steps = {x.get("step") for x in everything()}
    assert {"contradiction", "norm", "squares", "binary form", "no root", "cases"} <= steps
    facts = [x for x in everything() if "form" in x]
    assert {x["form"] for x in facts} == {"norm", "squares", "roots"}
    assert {x["by"] for x in facts} >= {*KEYS, "factors"}


def test_work_that_ends_where_a_prime_is_tried_is_said_to_end() -> None:
    with pytest.raises(Rejected, match="takes more work"), bounded(Budget(0.001)):
        read_ring(long_modulus(1))


def _word(statement: str) -> str:
    return str(statement.partition("{")[0])
