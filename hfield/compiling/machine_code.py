"""Compile LLVM's notation to machine code for this processor.

Machine code is never freed: an address stays valid in every thread as long as the process lives. All calls of
LLVM are made under one `lock` and publish their results; callers read them without a lock.
"""

from __future__ import annotations

import ctypes
import hashlib
import itertools
import os
import sys
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

from hfield.compiling.disk_cache import keep, kept
from hfield.core import locks

if TYPE_CHECKING:
    import llvmlite.binding as llvm

Function = Callable[[int, int], int]
lock = locks.lock()
_addresses: dict[str, int] = {}  # of what is linked
_symbols: dict[str, int] = {}  # the names under which programs call functions, and their addresses
_numbers = itertools.count()


@cache
def available() -> bool:
    """Return whether LLVM is available and plain Python is not requested."""
    if os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return False
    with lock:
        try:
            _linker()
        except Exception:  # no LLVM here, or an unsuitable version
            return False
    return True


def machine() -> llvm.TargetMachine:
    """Return LLVM's description of this processor."""
    import llvmlite.binding as llvm

    _introduce()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=_features().flatten(),
        opt=2,
        reloc="pic",
        codemodel="small",
    )


@cache
def _introduce() -> None:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


@cache
def _features() -> llvm.FeatureMap:
    import llvmlite.binding as llvm

    return llvm.get_host_cpu_features()


@cache
def _linker() -> llvm.LLJIT:
    """Return the linker, which reports errors instead of aborting."""
    import llvmlite.binding as llvm

    return llvm.create_lljit_compiler(machine(), suppress_errors=True)


@cache
def _made_by() -> str:
    """Return everything that machine code depends on besides the program."""
    import llvmlite
    import llvmlite.binding as llvm

    versions = f"{llvmlite.__version__} {llvm.llvm_version_info} {machine().triple}"
    return f"{versions} {llvm.get_host_cpu_name()} {_features().flatten()}"


def processor_has(feature: str) -> bool:
    """Return whether the processor has a set of instructions, given by LLVM's name."""
    with lock:
        return bool(_features().get(feature))


def register_symbols(name: str, address: int) -> None:
    """Register a system function for programs compiled from now on."""
    _symbols[name] = address


def compiled(
    text: str,
    name: str,
    vectorise: bool = False,
    announce: Callable[[], None] | None = None,
    write_program: Callable[[], str] | None = None,
) -> int:
    """Return the address of the function ``name`` of a program, valid as long as the process lives.

    Parameters
    ----------
    text : str
        The program; or, if ``write_program`` is given, which returns the program unless it is cached on disk,
        everything that determines the program.
    vectorise : bool
        Whether LLVM vectorises the scalar loops; otherwise the text is compiled nearly unchanged.
    announce : callable, optional
        Called before a compilation, but not if the code is cached on disk.
    """
    with lock:
        key = hashlib.sha256(f"{_made_by()} {vectorise} {name} {text}".encode()).hexdigest()
        if key not in _addresses:
            _addresses[key] = _kept(key, name) or _compiled(
                key, write_program or (lambda: text), name, vectorise, announce
            )
        return _addresses[key]


def _kept(key: str, name: str) -> int | None:
    """Return the address of the code cached on disk, or None if there is none that can be linked."""
    code = kept(key)
    if code is None:
        return None
    try:
        return _linked(code, name)
    except RuntimeError:
        return None


def _compiled(
    key: str,
    write_program: Callable[[], str],
    name: str,
    vectorise: bool,
    announce: Callable[[], None] | None,
) -> int:
    import llvmlite.binding as llvm

    if announce is not None:
        announce()
    target, module = machine(), llvm.parse_assembly(write_program())
    options = llvm.create_pipeline_tuning_options(speed_level=3 if vectorise else 0)
    if vectorise:
        options.loop_vectorization = options.loop_interleaving = options.loop_unrolling = True
    builder = llvm.create_pass_builder(target, options)
    builder.getModulePassManager().run(module, builder)
    code = target.emit_object(module)
    address = _linked(code, name)
    keep(key, code)  # code on disk was linked before
    return address


def _linked(code: bytes, name: str) -> int:
    """Load machine code into memory; return the address of its function. Raises RuntimeError."""
    import llvmlite.binding as llvm

    library = llvm.JITLibraryBuilder().add_object_img(code).add_current_process()
    for symbol, address in _symbols.items():
        library.import_symbol(symbol, address)
    linked = library.export_symbol(name).link(_linker(), f"hfield {next(_numbers)}")
    linked.detach()  # the engine keeps the code and its linker, and is never freed from now on
    return int(linked[name])


class Announcer:
    """A notice that code is being compiled, printed once per process on a terminal's stderr."""

    def __init__(self, message: str) -> None:
        self.message = message
        self._said = False

    def __call__(self) -> None:
        """Print the notice once, on a terminal only."""
        if self._said or sys.stderr is None or not sys.stderr.isatty():
            return
        self._said = True
        print(self.message, file=sys.stderr)


def function(address: int) -> Function:
    """Return code at an address as a function of two 64-bit integers that releases the interpreter lock."""
    made: Function = ctypes.CFUNCTYPE(ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)(address)
    return made
