"""One way to compile by numba: serial machine code that frees the interpreter lock, kept where possible."""

from collections.abc import Callable
from typing import Any

from numba import njit

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

    The machine code is cached in the first place that can be written: ``NUMBA_CACHE_DIR``, beside
    the source, the user's cache directory. Where there is none it is compiled anew in each process.
    """
    try:
        return njit(cache=True, **OPTIONS)(function)  # type: ignore[no-any-return]
    except RuntimeError:  # numba found no place for its cache
        return njit(**OPTIONS)(function)  # type: ignore[no-any-return]


def called(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` for use by kernels outside their inner loops."""
    return njit(**PART)(function)  # type: ignore[no-any-return]
