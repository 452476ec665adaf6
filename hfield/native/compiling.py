"""From a text in LLVM's notation to machine code for this processor, compiled once on this machine."""

import ctypes
import hashlib
import os
import sys
from collections.abc import Callable
from functools import cache
from typing import Any

from hfield.native.keeping import keep, kept

Function = Callable[[int, int], int]
_engines: dict[str, Any] = {}  # what the machine code lies in, as long as the process


@cache
def available() -> bool:
    """Tell whether there is an LLVM to compile with, and nobody asked for plain Python."""
    if os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return False
    try:
        machine()
    except Exception:  # no LLVM here, or one of another age
        return False
    return True


def machine() -> Any:
    """Return LLVM's description of this processor; an engine takes it into its keeping."""
    import llvmlite.binding as llvm

    _introduce()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=_features().flatten(), opt=2
    )


@cache
def _introduce() -> None:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


@cache
def _features() -> Any:
    import llvmlite.binding as llvm

    return llvm.get_host_cpu_features()


def processor_has(feature: str) -> bool:
    """Tell whether the processor has a set of instructions, by LLVM's name for it."""
    return bool(_features().get(feature))


def compiled(
    text: str, name: str, vectorise: bool = False, announce: Callable[[], None] | None = None
) -> int:
    """Return the address of the function ``name`` of a program.

    Parameters
    ----------
    vectorise : bool
        Whether LLVM is to make its scalar loops run over several numbers at a time; else the text is
        taken nearly as it stands.
    announce : callable, optional
        Called before a compilation, not where the code is kept on disk.
    """
    import llvmlite
    import llvmlite.binding as llvm

    target = machine()
    made = f"{llvmlite.__version__} {llvm.llvm_version_info} {target.triple} {vectorise} "
    made += llvm.get_host_cpu_name() + _features().flatten()
    key = hashlib.sha256((made + text).encode()).hexdigest()
    if key in _engines:
        return int(_engines[key].get_function_address(name))
    module = llvm.parse_assembly(text)
    code = kept(key)
    if code is None:
        if announce is not None:
            announce()
        options = llvm.create_pipeline_tuning_options(speed_level=3 if vectorise else 0)
        if vectorise:
            options.loop_vectorization = options.loop_interleaving = options.loop_unrolling = True
        builder = llvm.create_pass_builder(target, options)
        builder.getModulePassManager().run(module, builder)
    engine = llvm.create_mcjit_compiler(module, target)
    engine.set_object_cache(
        notify_func=lambda module, code: keep(key, code), getbuffer_func=lambda module: code
    )
    engine.finalize_object()
    _engines[key] = engine
    return int(engine.get_function_address(name))


class Announcer:
    """A word to who waits for a compiler: said once a process, on a terminal's stderr."""

    def __init__(self, message: str) -> None:
        self.message = message
        self._said = False

    def __call__(self) -> None:
        """Say it, unless it was said or nobody watches."""
        if self._said or sys.stderr is None or not sys.stderr.isatty():
            return
        self._said = True
        print(self.message, file=sys.stderr)


def function(address: int) -> Function:
    """Return the machine code at an address as a function of two 64-bit integers; it frees the lock."""
    made: Function = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)(address)
    return made
