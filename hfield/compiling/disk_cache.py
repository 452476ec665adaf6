"""Cache machine code on disk for later processes.

The cache is in ``NUMBA_CACHE_DIR``, else in the user's cache directory; if that is read-only nothing is
cached. A file that another user owns or may write is not read. Each file begins with a stamp: a checksum of
its name and content with a secret of this user. So a file whose stamp is correct was written by a process of
this user; any other file is ignored, and its code compiled again.
"""

import contextlib
import hashlib
import os
import stat
import sys
from pathlib import Path

FOLDER = "hfield-machine-code"
SECRET = "secret"
SIZE = 32  # bytes of the secret, and of a stamp


def directory() -> Path:
    """Return the cache directory."""
    given = os.environ.get("NUMBA_CACHE_DIR")
    if given:
        return Path(given) / FOLDER
    if sys.platform == "win32":
        base = os.environ.get("LOCALAPPDATA", "~")
    elif sys.platform == "darwin":
        base = "~/Library/Caches"
    else:
        base = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    return Path(base).expanduser() / FOLDER


def private_directory() -> Path | None:
    """Return the private cache directory, created if needed; None if it is not private or not writable."""
    with contextlib.suppress(OSError, RuntimeError):
        place = directory()
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        if _is_own(place.stat()) and os.access(place, os.W_OK):
            return place
    return None


def kept(key: str) -> bytes | None:
    """Return the machine code cached under the key, or None."""
    with contextlib.suppress(OSError, RuntimeError):
        place = directory()
        data = _own(place / key)
        stamp, code = data[:SIZE], data[SIZE:]
        if stamp == _stamp(_secret(place), key, code):
            return code
    return None


def keep(key: str, code: bytes) -> None:
    """Store linked machine code, atomically, if the directory is writable."""
    with contextlib.suppress(OSError, RuntimeError):
        place = directory()
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        try:
            secret = _secret(place)
        except OSError:
            _write(place / SECRET, os.urandom(SIZE))
            secret = _secret(place)  # another process may have been quicker
        _write(place / key, _stamp(secret, key, code) + code)


def _stamp(secret: bytes, key: str, code: bytes) -> bytes:
    return hashlib.blake2b(key.encode() + code, key=secret, digest_size=SIZE).digest()


def _secret(place: Path) -> bytes:
    secret = _own(place / SECRET)
    if len(secret) != SIZE:
        raise OSError(f"{place / SECRET} has {len(secret)} bytes; expected {SIZE}")
    return secret


def _own(path: Path) -> bytes:
    """Read a file that only this user can have written. Raises OSError."""
    with open(path, "rb", opener=_without_waiting) as file:
        found = os.fstat(file.fileno())
        if not stat.S_ISREG(found.st_mode):
            raise PermissionError(f"{path} is not a plain file")
        if not _is_own(found):
            raise PermissionError(f"{path} is another user's, or may be written by others")
        return file.read()


def _is_own(found: os.stat_result) -> bool:
    if not hasattr(os, "geteuid"):
        return True
    return found.st_uid == os.geteuid() and not found.st_mode & 0o022


def _write(path: Path, data: bytes) -> None:
    """Write a file that only this user can read, completely or not at all. Raises OSError."""
    part = path.with_name(f"{path.name}.{os.urandom(8).hex()}")
    try:
        with open(part, "xb", opener=_for_us) as file:
            file.write(data)
        os.replace(part, path)
    finally:  # left by a full disk, or if another file has the target's name
        part.unlink(missing_ok=True)


def _without_waiting(path: str, flags: int) -> int:
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))  # as for the writer of a pipe


def _for_us(path: str, flags: int) -> int:
    return os.open(path, flags, 0o600)
