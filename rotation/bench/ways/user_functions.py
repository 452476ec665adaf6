"""Read a user's functions from a file and wrap them as implementations."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib.util import decode_source
from pathlib import Path
from traceback import extract_tb
from types import ModuleType

from hfield.errors import shorten
from rotation.array_types import ArrayLike
from rotation.bench.tasks import Array, Kind, Task
from rotation.bench.ways.ours import Z
from rotation.bench.ways.way import FrameFunction, Way
from rotation.errors import RotationError

Function = Callable[..., ArrayLike]
AXIS, EULER = ("points", "axis", "angle"), ("points", "angles")
KINDS: dict[tuple[str, ...], tuple[Kind, ...]] = {AXIS: ("one axis", "own axis"), EULER: ("euler",)}
PARAMETERS = "(points, axis, angle) or (points, angles)"


class OwnFunctionError(RotationError):
    """A function of a user that fails or returns wrong points."""


class OwnFileError(RotationError):
    """A file of functions cannot be read or run."""


def own_way(name: str, function: Function) -> Way:
    """Return an implementation that calls a user's function; see :func:`rotation.benchmark`.

    A function with the parameters ``points, angles`` does the matrix test; other functions do the tests with
    axes.
    """
    kinds = KINDS.get(_parameters(function), KINDS[AXIS])
    return Way(name, "own", "rotation", "", "new", dict.fromkeys(kinds, partial(_frames, function)))


def _frames(function: Function, task: Task) -> FrameFunction:
    points, axes, angles = (_read_only(a) for a in (task.points, task.axes, task.angles))
    length = len(points)
    if task.kind == "euler":
        return lambda n: function(points, points)
    if task.kind == "one axis":
        axis = _read_only(Z)
        return lambda n: function(points, axis, float(angles[n]))
    return lambda n: function(points, axes, angles[n : n + length])


def _read_only(array: Array) -> Array:
    """Return a read-only view, because other implementations read the same memory."""
    view = array.view()
    view.flags.writeable = False
    return view


def _parameters(function: Function) -> tuple[str, ...]:
    """Return the names of the required parameters."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):  # a builtin
        return ()
    return tuple(p.name for p in parameters if p.default is p.empty)


def functions_of(path: Path) -> dict[str, Function]:
    """Run a file and return, by name, its functions with the parameters of an implementation.

    Raises :class:`OwnFileError`, which names the line.
    """
    name = shorten(path)
    module = ModuleType(f"functions_of_{path.stem}")
    module.__file__ = str(path)
    sys.modules[module.__name__] = module  # as numba, dataclasses and pickle expect
    try:
        source = decode_source(path.read_bytes())
        exec(compile(source, str(path), "exec", dont_inherit=True), vars(module))
    except OSError as error:
        if error.filename != str(path):
            raise OwnFileError(failure(error, str(path))) from error
        raise OwnFileError(f"{name!r} could not be read: {error.strerror or error}") from error
    except SyntaxError as error:
        line = "" if error.lineno is None else f", line {error.lineno}"
        raise OwnFileError(f"{shorten(error.filename or path)}{line}: {error.msg}") from error
    except (Exception, SystemExit) as error:
        raise OwnFileError(failure(error, str(path))) from error
    defined = {
        word: value
        for word, value in vars(module).items()
        if callable(value)
        and not word.startswith("_")
        and getattr(value, "__module__", None) == module.__name__
    }
    found = {word: value for word, value in defined.items() if _parameters(value) in KINDS}
    if not found:
        others = ", ".join(f"{word}({', '.join(_parameters(f))})" for word, f in defined.items())
        raise OwnFileError(
            f"{name} defines no function with the parameters {PARAMETERS}"
            + (f"; it defines {shorten(others)}" if others else "")
        )
    return found


@contextmanager
def importing_from(folder: Path) -> Iterator[None]:
    """Add a folder to the end of the import path."""
    place = str(folder.resolve())
    sys.path.append(place)
    try:
        yield
    finally:
        sys.path.remove(place)


def definition_of(function: Function) -> tuple[str, int]:
    """Return the file and the line in which a function is defined; no file for one in C."""
    code = getattr(inspect.unwrap(function), "__code__", None)
    return ("", 0) if code is None else (code.co_filename, code.co_firstlineno)


def failure(error: BaseException, file: str, what: str = "") -> str:
    """Return the text of an error, with the last line of ``file`` in its traceback, or else with the last
    line.
    """
    frames = extract_tb(error.__traceback__)
    frame = ([frame for frame in frames if frame.filename == file] or frames)[-1]
    said = "".join(f": {line}" for line in str(error).splitlines()[:1])
    return f"{shorten(frame.filename)}, line {frame.lineno}: {what}{type(error).__name__}{said}"
