"""Facts found by running or inspecting something: how many, within which bounds, which outcome."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from hfield.proving.decision import PROVED, REFUTED, Decision
from hfield.rings.base import Ring


@dataclass(frozen=True)
class Finding:
    """What a computation found: whether the proposition holds, and lines that show it.

    ``witness`` holds the values at which it fails, where there are any to name.
    """

    holds: bool
    steps: tuple[str, ...]
    witness: Mapping[str, list[str]] | None = None


@dataclass(frozen=True)
class Computed:
    """A proposition about no field, decided by ``compute``, which runs each time it is asked.

    There is no certificate for it: who doubts it runs it again.
    """

    text: str
    compute: Callable[[], Finding]
    method: str = "computation"

    @property
    def statement(self) -> str:
        """The proposition in words; no certificate states it."""
        return self.text

    def decide(self, field: Ring | None) -> Decision:
        """Compute it; the field plays no part."""
        found = self.compute()
        verdict = PROVED if found.holds else REFUTED
        witness = None if found.holds else dict(found.witness or {})
        return Decision(verdict, self.method, witness=witness, steps=found.steps)
