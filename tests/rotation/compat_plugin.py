"""A plugin of pytest: scipy's tests meet `rotation.compat` where they ask for scipy's rotations."""

import json
import os
from typing import Any

from rotation import compat

_failed: list[str] = []
_passed: list[str] = []


def pytest_collection_modifyitems(items: list[Any]) -> None:
    """Bind the names of the classes to ours, in every module that asks for them."""
    for module in {item.module for item in items}:
        for name in compat.__all__:
            if hasattr(module, name):
                setattr(module, name, getattr(compat, name))


def pytest_runtest_logreport(report: Any) -> None:
    """Note what passes and what does not."""
    if report.failed:
        _failed.append(report.nodeid.rpartition("/")[2])
    elif report.when == "call" and report.passed:
        _passed.append(report.nodeid.rpartition("/")[2])


def pytest_sessionfinish() -> None:
    """Write that down, where the environment says."""
    place = os.environ.get("COMPAT_RESULTS")
    if place:
        with open(place, "w") as file:
            json.dump({"passed": _passed, "failed": _failed}, file)
