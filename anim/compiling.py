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
    keep = compiled._cache.save_overload

    def save(signature: Any, code: Any) -> None:
        with suppress(OSError):
            keep(signature, code)

    compiled._cache.save_overload = save
    return compiled  # type: ignore[no-any-return]


def called(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` for use by kernels outside their inner loops."""
    return njit(**PART)(function)  # type: ignore[no-any-return]
