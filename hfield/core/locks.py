"""Locks and imports that are safe when a process forks.

A fork waits for this package's locks. A thread may acquire a lock twice, as a signal handler may do. Data
read on every call is published under a lock and read without one. A child process drops Python's import locks
of modules that other threads were importing.
"""

import functools
import os
import sys
from importlib import _bootstrap
from importlib.machinery import ExtensionFileLoader
from threading import RLock, get_ident

PACKAGES = ("hfield", "rotation", "anim")


def lock() -> RLock:
    """Return a new lock."""
    made = RLock()
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(
            before=made.acquire, after_in_parent=made.release, after_in_child=made.release
        )
    return made


def _forget_imports() -> None:
    """Drop, in a child process, imports that other threads of the parent had started.

    Each module has a lock, which its importer holds until the module is complete. In the child nobody would
    complete it, so the next import starts again. A package of another project is imported again with all its
    modules, since the incomplete ones may have changed them.
    """
    locks = getattr(_bootstrap, "_module_locks", {})
    for name, reference in tuple(locks.items()):
        module_lock = reference()
        if getattr(module_lock, "owner", None) in (None, get_ident()):
            continue
        del locks[name]
        spec = getattr(sys.modules.get(name), "__spec__", None)
        if getattr(spec, "_initializing", False):
            del sys.modules[name]
            if name.partition(".")[0] not in PACKAGES:
                _forget_modules_of(name)


def _forget_modules_of(package: str) -> None:
    for name, module in tuple(sys.modules.items()):
        loader = getattr(getattr(module, "__spec__", None), "loader", None)
        # numpy and others refuse to load machine code twice
        if name.startswith(f"{package}.") and not isinstance(loader, ExtensionFileLoader):
            del sys.modules[name]


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_imports)


def _free_properties() -> None:
    """Give cached properties new locks in a child process."""
    for name, module in tuple(sys.modules.items()):
        if name.partition(".")[0] in PACKAGES:
            for kind in tuple(vars(module).values()):
                for value in tuple(vars(kind).values()) if isinstance(kind, type) else ():
                    if isinstance(value, functools.cached_property):
                        value.lock = RLock()  # type: ignore[attr-defined]


if sys.version_info < (3, 12) and hasattr(os, "register_at_fork"):  # later ones have no locks
    os.register_at_fork(after_in_child=_free_properties)
