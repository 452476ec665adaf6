"""Write files and folders completely or not at all."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import stat
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

PART = "part"
TERMINATED = 128 + signal.SIGTERM
"""The exit status of a shell's command that SIGTERM has ended."""
STEM = 40  # letters of the name that the name beside it begins with


@contextmanager
def whole_file(path: Path, replace: bool | None = None) -> Iterator[Path]:
    """Yield a hidden name beside ``path``; the file written there is renamed to ``path`` at the end.

    ``replace`` says whether an existing file may be replaced; with None, a file that exists at the start may
    be replaced, but not one that appears later. If ``path`` is a link, its target is replaced and keeps its
    permissions. After an error or SIGTERM no temporary file remains, and if nothing was written nothing is
    replaced. Raises OSError.
    """
    target = path.resolve()
    part = _beside(target)
    may_replace = target.exists() if replace is None else replace
    with _ended_by_sigterm():
        try:
            yield part
            if part.exists():
                if may_replace:
                    with suppress(FileNotFoundError):
                        part.chmod(stat.S_IMODE(target.stat().st_mode))
                    part.replace(target)
                else:
                    _take_name(part, target)
        finally:
            with suppress(OSError):
                part.unlink(missing_ok=True)


@contextmanager
def whole_folder(path: Path, replace: bool) -> Iterator[Path]:
    """Yield a hidden new folder beside ``path``; it is renamed to ``path`` at the end.

    Without ``replace`` it can replace only an empty folder. Raises OSError.
    """
    target = path.resolve()
    part = _beside(target)
    with _ended_by_sigterm():
        part.mkdir()
        try:
            yield part
            if replace and target.exists():
                shutil.rmtree(target)
            with suppress(FileNotFoundError, NotADirectoryError):
                target.rmdir()  # raises OSError unless it is empty
            part.rename(target)
        finally:
            shutil.rmtree(part, ignore_errors=True)


def _take_name(part: Path, target: Path) -> None:
    """Rename the file ``part`` to ``target``. Raises FileExistsError if ``target`` exists."""
    try:
        try:
            os.link(part, target)
        except FileExistsError:
            raise
        except OSError:
            # This file system has no hard links: an empty file of our own reserves the name.
            os.close(os.open(target, os.O_CREAT | os.O_EXCL | os.O_WRONLY))
            part.replace(target)
    except FileExistsError:
        reason = "a file of this name appeared in the meantime"
        raise FileExistsError(errno.EEXIST, reason, str(target)) from None


@contextmanager
def _ended_by_sigterm() -> Iterator[None]:
    """Let SIGTERM raise SystemExit so that partial files are removed; handlers set elsewhere are kept."""
    if (
        threading.current_thread() is not threading.main_thread()
        or signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL
    ):
        yield
        return

    def leave(number: int, frame: object) -> None:
        raise SystemExit(TERMINATED)

    signal.signal(signal.SIGTERM, leave)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)


def sweep(path: Path) -> None:
    """Remove temporary files beside ``path`` left by killed processes. Raises OSError."""
    target = path.resolve()
    start = _prefix(target)
    for old in target.parent.iterdir():
        number, _, rest = old.name.removeprefix(start).partition(".")
        if not (old.name.startswith(start) and rest.split(".")[0] == PART):
            continue
        # In containers process ids are reused: a folder with our own id belongs to an ended run.
        if number.isdecimal() and (int(number) == os.getpid() or not _alive(int(number))):
            if old.is_dir():
                shutil.rmtree(old, ignore_errors=True)
            else:
                old.unlink(missing_ok=True)


def _prefix(target: Path) -> str:
    return f".{target.stem[:STEM]}."


def _beside(target: Path) -> Path:
    return target.with_name(f"{_prefix(target)}{os.getpid()}.{PART}{target.suffix[:STEM]}")


def _alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True
    return True
