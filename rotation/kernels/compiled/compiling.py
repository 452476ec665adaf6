"""One way to compile: serial machine code that frees the interpreter lock, kept on disk where possible."""

from collections.abc import Callable
from pathlib import Path
from typing import Any
from zlib import crc32

from numba import njit
from numba.extending import intrinsic

# FMA is allowed. Reassociation would undo the range reduction, and assuming finite numbers would lose
# NaN, so `fastmath=True` is out of the question. "numpy": a division by zero gives inf, no exception.
OPTIONS: dict[str, Any] = {
    "fastmath": {"contract"},
    "error_model": "numpy",
    "nogil": True,
}
# Parts are never called from Python: without the wrappers a kernel compiles in two thirds of the time.
PART = {**OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}

# numba asks only the file of a kernel itself whether its cache is stale. Every kernel therefore has a
# last parameter whose default is this number: the default is part of the signature it is kept under.
SOURCES = crc32(b"".join(f.read_bytes() for f in sorted(Path(__file__).parent.glob("*.py"))))


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` compiled at its first call for each set of argument types.

    The machine code is cached in the first place that can be written: ``NUMBA_CACHE_DIR``, beside
    the source, the user's cache directory. Where there is none it is compiled anew in each process.
    """
    try:
        return njit(cache=True, **OPTIONS)(function)  # type: ignore[no-any-return]
    except RuntimeError:  # numba found no place for its cache
        return njit(**OPTIONS)(function)  # type: ignore[no-any-return]


def inlined(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` for use inside kernels, where its literal arguments become constants."""
    return njit(forceinline=True, **PART)(function)  # type: ignore[no-any-return]


def strict(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` as `inlined` does, but each operation rounded by itself, as numpy does."""
    return njit(forceinline=True, **{**PART, "fastmath": False})(function)  # type: ignore[no-any-return]


def called(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function`` for use by kernels outside their inner loops."""
    return njit(**PART)(function)  # type: ignore[no-any-return]


def primitive(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return ``function``, which writes machine instructions itself, as a part of kernels."""
    return intrinsic(function)  # type: ignore[no-any-return]
