"""With a wrong product the ledger turns red: prover, structure and witnesses rest on the one formula."""

import pkgutil
import sys
from importlib import import_module
from typing import Any

import pytest

import hfield
from hfield.core import product
from hfield.errors import HFieldError
from hfield.ledger.claim import Claim, decide
from hfield.ledger.registry import claims

CHAPTER = [claim for claim in claims() if claim.id.startswith("C1")]
CHECKABLE = [claim for claim in CHAPTER if claim.checkable]


@pytest.mark.slow
def test_a_broken_product_turns_rows_red(monkeypatch: Any) -> None:
    """With i·j = −k the prover, the structure package and the witnesses disagree with the thesis."""
    true = product.multiply

    def wrong(c: Any, p: Any, q: Any) -> Any:
        w, x, y, z = true(c, p, q)
        return w, x, y, z - p[1] * q[2] - p[1] * q[2]

    for info in pkgutil.walk_packages(hfield.__path__, "hfield."):
        if not info.name.endswith("__main__"):
            import_module(info.name)  # now, or it would keep the broken product it found
    green = [c for c in CHECKABLE if verdict(c) == "proved"]
    for name, module in list(sys.modules.items()):
        if name.startswith("hfield") and getattr(module, "multiply", None) is true:
            monkeypatch.setattr(module, "multiply", wrong)
    forget()
    red = {c.id for c in green if verdict(c) != "proved"}
    monkeypatch.undo()
    forget()
    assert red >= {"C1-a", "C1-e", "C1.1.3-q", "C1.3.1-i", "C1.3.1-q", "C1.4.2-i"}
    assert [c for c in green if verdict(c) != "proved"] == []


def verdict(claim: Claim) -> str:
    """The verdict in the first column; a self-check of the product that fails counts as red."""
    try:
        return decide(claim, claim.fields[0]).as_printed.verdict
    except (AssertionError, HFieldError) as error:
        return f"{type(error).__name__}: {error}"


def forget() -> None:
    """Empty every cache of the package, which remembers what the true product decided."""
    for name, module in list(sys.modules.items()):
        if name.startswith("hfield"):
            for value in vars(module).values():
                is_cache = hasattr(value, "cache_clear") and not isinstance(value, type)
                if is_cache and value is not claims:
                    value.cache_clear()
