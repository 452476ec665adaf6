"""Compile Python loops with numba, cache the machine code on disk, and run it without numba.

The loops of `anim` branch on computed values, point by point, which formula tracing does not support.
Importing numba takes a second, so it is imported only for code that is not in `hfield.compiling.disk_cache`.
A kernel writes into given arrays, allocates none and raises no errors, so its code does not need numba's
runtime.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Sequence
from ctypes import CFUNCTYPE, c_double, c_int64, c_void_p
from pathlib import Path
from types import FunctionType
from typing import Any, Generic, TypeAlias, TypeVar, TypeVarTuple

import numpy as np

from hfield.compiling import machine_code
from hfield.compiling.memory import address

F = TypeVar("F", bound=Callable[..., object])
R = TypeVar("R")
Arguments = TypeVarTuple("Arguments")
Kind: TypeAlias = "str | tuple[Any, ...]"
"""What machine code depends on of an argument: see `_kind`."""

# FMA is allowed. Reassociation would change results, and assuming finite numbers would lose NaN, so
# `fastmath=True` is out of the question. "numpy": a division by zero gives inf, no exception.
OPTIONS: dict[str, object] = {"fastmath": {"contract"}, "error_model": "numpy"}

_called: dict[Callable[..., object], bool] = {}  # whether numba knows it
_announce = machine_code.Announcer("hfield: compiling a loop by numba, once on this machine")


def called(function: F) -> F:
    """Mark a function that kernels call, and return it unchanged; it is compiled together with them."""
    _called.setdefault(function, False)
    return function


class CompiledFunction(Generic[*Arguments, R]):
    """A compiled function of contiguous arrays, numbers and tuples of these; it returns a float or None."""

    def __init__(self, function: Callable[[*Arguments], R]) -> None:
        assert isinstance(function, FunctionType)
        self.plain: FunctionType = function
        self.__doc__ = function.__doc__
        self._entries: dict[tuple[Kind, ...], Callable[..., R]] = {}

    def __call__(self, *arguments: *Arguments) -> R:
        """Run the machine code for arguments of these kinds; without LLVM, the Python function."""
        values: list[float] = []
        kinds = tuple([_kind(argument, values) for argument in arguments])
        entry = self._entries.get(kinds)
        if entry is None:
            if not machine_code.available():
                found: R = self.plain(*arguments)
                return found
            entry = self._entries[kinds] = self._linked(kinds)
        return entry(*values)

    def _linked(self, kinds: tuple[Kind, ...]) -> Callable[..., R]:
        files = sorted({part.__code__.co_filename for part in _parts(self.plain)})
        seen = [hashlib.sha256(Path(file).read_bytes()).hexdigest() for file in files]
        text = f"{self.plain.__qualname__} {kinds} {sorted(OPTIONS.items())} {seen}"
        address = machine_code.compiled(
            text, "entry", True, _announce, lambda: written(self.plain, kinds)
        )
        returned = c_double if _returns(self.plain) else None
        return CFUNCTYPE(returned, *(_C[type_] for kind in kinds for type_ in _types(kind)))(
            address
        )


kernel = CompiledFunction
_C = {"pointer": c_void_p, "int64": c_int64, "float64": c_double}


def _kind(value: Any, values: list[float]) -> Kind:
    """Return the kind of a value, which determines the machine code, and append its machine words.

    The kind is ("u1", 2) for an array, "int64" or "float64" for a number, (class, …) for a tuple.
    """
    if isinstance(value, np.ndarray):
        if not value.flags.c_contiguous:
            raise ValueError("a kernel takes C-contiguous arrays")
        values.append(address(value))
        values.extend(value.shape)
        return value.dtype, value.ndim
    if isinstance(value, tuple):
        return (type(value), *[_kind(part, values) for part in value])
    if isinstance(value, float):
        values.append(float(value))
        return "float64"
    values.append(int(value))
    return "int64"


def _types(kind: Kind) -> list[str]:
    if isinstance(kind, str):
        return [kind]
    if isinstance(kind[0], np.dtype):
        return ["pointer", *["int64"] * kind[1]]
    return [type_ for part in kind[1:] for type_ in _types(part)]


def _returns(function: FunctionType) -> bool:
    return function.__annotations__["return"] in (float, "float")


def _parts(function: FunctionType) -> set[FunctionType]:
    """Return a function and all functions that it calls."""
    found, waiting = set(), [function]
    while waiting:
        part = waiting.pop()
        if part not in found:
            found.add(part)
            names = (part.__globals__.get(name) for name in part.__code__.co_names)
            waiting += [
                other for other in names if isinstance(other, FunctionType) and other in _called
            ]
    return found


def written(function: FunctionType, kinds: Sequence[Kind]) -> str:
    """Return a kernel for arguments of these kinds as LLVM code made by numba; its name is ``entry``."""
    from numba import carray, cfunc, njit, types
    from numba.extending import register_jitable

    for part in _parts(function) - {function}:
        if not _called[part]:
            register_jitable(part)
            _called[part] = True
    names_of_entry = {"carray": carray, "kernel": njit(**OPTIONS)(function)}
    names: list[str] = []
    signature: list[object] = []

    def taken(kind: Kind) -> str:
        """Return code for an argument, built from the machine words in which it is passed."""
        here = len(names)
        if isinstance(kind, str):
            names.append(f"x{here}")
            signature.append(getattr(types, kind))
            return names[here]
        if isinstance(kind[0], np.dtype):
            names.extend(f"x{here + n}" for n in range(kind[1] + 1))
            item = getattr(types, kind[0].name)
            signature.extend([types.CPointer(item), *[types.int64] * kind[1]])
            return f"carray({names[here]}, ({', '.join(names[here + 1 :])},))"
        parts = ", ".join(map(taken, kind[1:]))
        names_of_entry[kind[0].__name__] = kind[0]
        return f"({parts},)" if kind[0] is tuple else f"{kind[0].__name__}({parts})"

    words = ", ".join(map(taken, kinds))
    exec(f"def entry({', '.join(names)}):\n    return kernel({words})", names_of_entry)
    returned = types.float64 if _returns(function) else types.void
    made = cfunc(returned(*signature), **OPTIONS)(names_of_entry["entry"])
    text = made.inspect_llvm().replace(made.native_name, "entry")
    # Nothing else needs to be visible from outside, so code that is not called, such as numba's
    # errors, is removed.
    return re.sub(r"^define (?:linkonce_odr )?(?!.*@entry\()", "define internal ", text, flags=re.M)
