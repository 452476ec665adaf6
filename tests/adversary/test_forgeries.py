"""1 500 forged certificates: no false claim passes, and no file breaks the checker.

HFIELD_THOROUGH=1 forges 7 500, scripts/forge_certificates.py as many as one likes.
"""

from functools import lru_cache

import pytest

from hfield.checker.check import check
from tests.adversary.forging.campaign import run
from tests.adversary.forging.kinds import KINDS
from tests.adversary.forging.mutants import QUICK, genuine
from tests.adversary.forging.spelling import SPELLINGS
from tests.subcases import first_quick
from tests.thorough import cases

CHUNKS, SIZE = cases(15), 500


@lru_cache(maxsize=1)
def pool() -> tuple[dict[str, object], ...]:
    """Return genuine certificates."""
    return tuple(genuine(QUICK, (None, "QQ", "GF(3)", "ZZ/6", "GF(4)")))


def test_genuine_certificates_pass() -> None:
    assert len(pool()) > 40
    for data in pool():
        assert check(data).verdict == data["verdict"]


@pytest.mark.parametrize("chunk", first_quick(range(CHUNKS), 1))
def test_no_false_claim_passes(chunk: int) -> None:
    out = run(SIZE, 2_000 + chunk, pool())
    assert out.breaks == []
    assert out.tally["rejected"] > 0.9 * SIZE
    drawn = {f.__name__ for f in (*KINDS, *SPELLINGS)} - {"lie"}
    missing = [name for name in (*drawn, "wholes", "mutants", "pins") if not out.tally[name]]
    assert len(missing) <= 2, missing
