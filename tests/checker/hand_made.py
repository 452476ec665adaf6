"""Evidence as a hand writes it, for the tests of the checker's core."""

from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.rejection import (
    Rejected,
)
from hfield.checker.statement import Setting, read_setting
from tests.checker.cases import Certificate
from tests.checker.ring_data import read_field

IDENTITY = {"kind": "identity"}


def setting(algebra: str = "(-1,-1|F)", field: str | None = None) -> Setting:
    return read_setting(algebra, None if field is None else read_field(field))


def implication(items: list[Any], facts: list[Any] | None = None) -> dict[str, Any]:
    return {"kind": "implication", "facts": facts or [], "items": items}


def direct(zero: list[str], member: str, cofactors: list[str], d: int = 1, **more: Any) -> Any:
    item = {"characteristic": 0, "zero": zero, "relations": [], "member": member}
    return {**item, "cofactors": cofactors, "denominator": d, **more}


def opposite(zero: list[str], nonzero: list[str], steps: list[Any], **more: Any) -> Any:
    item = {"characteristic": 0, "zero": zero, "relations": [], "nonzero": nonzero, "steps": steps}
    return {**item, **more}


def ends(*cofactors: str, d: int = 1) -> dict[str, Any]:
    return {"step": "contradiction", "cofactors": list(cofactors), "denominator": d}


def rejects(data: Certificate, why: str) -> None:
    with pytest.raises(Rejected, match=why):
        check(data)
