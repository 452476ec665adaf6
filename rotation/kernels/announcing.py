"""A word to who waits for a compiler."""

import sys
from pathlib import Path
from typing import Any

_said = False


def announce(kernel: Any) -> None:
    """Say on a terminal's stderr, once a process, that a kernel is compiled, unless it is kept on disk."""
    global _said
    if _said or sys.stderr is None or not sys.stderr.isatty():
        return
    place, name = kernel.stats.cache_path, kernel.py_func.__name__
    if place is not None and any(Path(place).glob(f"{name}.{name}-*.nbi")):
        return
    _said = True
    print(
        "rotation: compiling the loops for many points, once on this machine "
        "(rotation.warm_up() does it beforehand)",
        file=sys.stderr,
    )
