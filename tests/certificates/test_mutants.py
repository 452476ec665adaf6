"""No mutant passes, pinned to the original, unless an independent evaluation says that it may."""

from importlib import import_module
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[2] / "scripts"


def test_mutants(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(SCRIPTS)
    survey = import_module("mutate_certificates").survey
    outcomes, passed, slowest = survey(3_000, seed=3, number_of_claims=12)
    assert [(original, mutant) for reason, original, mutant in passed if not reason] == []
    assert outcomes["rejected"] > 2_000
    assert slowest < 20
