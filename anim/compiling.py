"""One way to compile by numba: serial machine code that frees the interpreter lock, kept where possible.

The loops of `anim` branch on what they compute, point by point, which a tracer of formulas cannot follow.
"""

from collections.abc import Callable
from contextlib import suppress
from typing import Any

from numba import njit
from numba.core import config

from hfield.compiling import disk_cache as keeping
from hfield.compiling.machine_code import lock

# FMA is allowed. Reassociation would change results, and assuming finite numbers would lose NaN, so
# `fastmath=True` is out of the question. "numpy": a division by zero gives inf, no exception.
OPTIONS: dict[str, Any] = {
    "fastmath": {"contract"},
    "error_model": "numpy",
    "nogil": True,
}
# Parts are never called from Python: without the wrappers a kernel compiles in two thirds of the time.
PART = {**OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` compiled at its first call for each set of argument types.

    The machine code is kept where `hfield.compiling.disk_cache` keeps its own, if that folder is this user's
    alone: numba reads pickles, whoever wrote them. Else, and on a full disk, each process compiles it anew.
    """
    place = keeping.private_directory()
    with lock:
        given, config.CACHE_DIR = config.CACHE_DIR, str(place)
        try:
            compiled: Any = njit(cache=place is not None, **OPTIONS)(function)
        finally:
            config.CACHE_DIR = given
    if place is not None:
        compiled._cache = _Cache(compiled._cache)
    return compiled  # type: ignore[no-any-return]


class _Cache:
    """numba's cache of a function on disk, where what cannot be written or is for other types is left alone.

    Two processes that compile for different types at once may number their files alike, so that the index
    names the code of the other: run, it would take a float for an integer.
    """

    def __init__(self, own: Any) -> None:
        self._own = own

    def load_overload(self, signature: Any, context: Any) -> Any:
        found = self._own.load_overload(signature, context)
        wanted = getattr(signature, "args", signature)
        return found if found is not None and found.signature.args == tuple(wanted) else None

    def save_overload(self, signature: Any, code: Any) -> None:
        with suppress(OSError):
            self._own.save_overload(signature, code)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._own, name)


def called(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` for use by kernels outside their inner loops."""
    return njit(**PART)(function)  # type: ignore[no-any-return]
