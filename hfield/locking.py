"""Locks that a fork waits for: no child begins with one that a thread it does not have would free.

A thread may take one twice, as the handler of a signal that comes in between does. What is read on every call
is published under a lock and read without.
"""

import functools
import os
import sys
from threading import RLock

PACKAGES = ("hfield", "rotation", "anim")


def lock() -> RLock:
    """Return a new lock."""
    made = RLock()
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(
            before=made.acquire, after_in_parent=made.release, after_in_child=made.release
        )
    return made


def _free_properties() -> None:
    """Give our cached properties new locks, in a child: each class has one for all its instances."""
    for name, module in tuple(sys.modules.items()):
        if name.partition(".")[0] in PACKAGES:
            for kind in tuple(vars(module).values()):
                for value in tuple(vars(kind).values()) if isinstance(kind, type) else ():
                    if isinstance(value, functools.cached_property):
                        value.lock = RLock()  # type: ignore[attr-defined]


if sys.version_info < (3, 12) and hasattr(os, "register_at_fork"):  # later ones have no locks
    os.register_at_fork(after_in_child=_free_properties)
