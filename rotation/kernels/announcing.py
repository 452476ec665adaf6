"""A word to who waits for a compiler."""

from pathlib import Path
from typing import Any

from hfield.native.compiling import Announcer

_say = Announcer(
    "rotation: compiling the loops for many points, once on this machine "
    "(rotation.warm_up() does it beforehand)"
)


def announce(kernel: Any) -> None:
    """Say on a terminal's stderr, once a process, that a kernel is compiled, unless it is kept on disk."""
    place, name = kernel.stats.cache_path, kernel.py_func.__name__
    if place is None or not any(Path(place).glob(f"{name}.{name}-*.nbi")):
        _say()
