"""The type of an implementation in the benchmark."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

from rotation.array_types import ArrayLike
from rotation.bench.tasks import Kind, Task

FrameFunction = Callable[[int], ArrayLike]
"""Compute one frame and return the points, (n, 3) or a list of lists."""
Role = Literal["floor", "ours", "peer", "thesis", "own"]


@dataclass(frozen=True)
class Way:
    """One implementation; ``makes`` maps each supported kind of task to its preparation.

    ``module`` and ``distribution`` are the names under which the library is imported and installed.
    ``writes`` says whether a frame is written to existing memory or to a new array. ``slow`` implementations
    are timed on a subset of the points.
    """

    name: str
    role: Role
    module: str
    distribution: str
    writes: Literal["out", "new"]
    makes: Mapping[Kind, Callable[[Task], FrameFunction]] = field(repr=False)
    slow: bool = False
    rotates: bool = True
