"""Machine code kept on disk, so that a process need not compile what another one has.

It lies in ``NUMBA_CACHE_DIR``, else in the user's cache directory; where nothing can be written nothing is
kept. A file begins with the checksum of the rest; what does not fit it is not used.
"""

import contextlib
import hashlib
import os
import sys
from pathlib import Path

FOLDER = "hfield-machine-code"


def directory() -> Path:
    """Return where the files lie."""
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


def kept(key: str) -> bytes | None:
    """Return the machine code kept under the key, or None."""
    try:
        data = (directory() / key).read_bytes()
    except (OSError, RuntimeError):
        return None
    code = data[32:]
    return code if hashlib.sha256(code).digest() == data[:32] else None


def keep(key: str, code: bytes) -> None:
    """Keep machine code under the key, if that can be done; readers see all of it or nothing."""
    with contextlib.suppress(OSError, RuntimeError):
        place = directory()
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        part = place / f"{key}.{os.getpid()}"
        try:
            part.write_bytes(hashlib.sha256(code).digest() + code)
            os.replace(part, place / key)
        finally:  # of a full disk, or where something else stands in the place
            part.unlink(missing_ok=True)
