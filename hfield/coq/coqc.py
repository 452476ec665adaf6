"""Running ``coqc``: what stands in every file is compiled once, then each theorem by itself."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from hfield.coq.export import Export, library
from hfield.coq.theorem import Theorem
from hfield.errors import HFieldError

CLOSED = "Closed under the global context"
LIBRARY = "HFieldJudge"
MAX_MESSAGE = 600


class CoqMissingError(HFieldError, OSError):
    """There is no ``coqc``."""


class Coqc:
    """``coqc`` in a folder of its own, as a context: the library is compiled when it is first needed."""

    def __init__(self) -> None:
        program = shutil.which("coqc")
        if program is None:
            raise CoqMissingError(
                "coqc is not installed (Debian: apt-get install --no-install-recommends coq)"
            )
        self.program = program
        self._folder: TemporaryDirectory[str] | None = None

    def __enter__(self) -> Coqc:
        self._folder = TemporaryDirectory(prefix="hfield-coq-")
        self.folder = Path(self._folder.name)
        return self

    def __exit__(self, *_: object) -> None:
        if self._folder is not None:
            self._folder.cleanup()

    def _run(self, name: str, text: str) -> subprocess.CompletedProcess[str]:
        (self.folder / f"{name}.v").write_text(text, encoding="utf-8")
        return subprocess.run(
            [self.program, "-q", f"{name}.v"],
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=False,
        )

    def compile_library(self) -> None:
        """Compile what stands in every file, once. Raises :class:`HFieldError` where Coq rejects it."""
        if (self.folder / f"{LIBRARY}.vo").exists():
            return
        done = self._run(LIBRARY, library())
        if done.returncode:
            raise HFieldError(f"coqc does not read its own library: {_message(done.stderr)}")

    def reject(self, theorems: Sequence[Theorem]) -> str | None:
        """Compile theorems; return None if Coq accepts them all without an axiom, else why not."""
        if any(t.place for t in theorems):  # they stand in sections, which are not compiled ahead
            done = self._run("Judged", Export(tuple(theorems)).text)
        else:
            self.compile_library()
            used = "".join(f"  let _ := @{t.name} in\n" for t in theorems)
            ending = f"Definition judged : True :=\n{used}  I.\nPrint Assumptions judged.\n"
            done = self._run("Judged", "\n\n".join([opening(), *map(str, theorems), ending]))
        if done.returncode:
            return _message(done.stderr)
        if done.stdout.strip() != CLOSED:
            return f"Coq says what it rests on: {_message(done.stdout)}"
        return None


def opening() -> str:
    """Return what a file begins with that uses the compiled library."""
    imports = next(
        line for line in library().splitlines() if line.startswith("From Coq Require Import")
    )
    return (
        f"{imports}\nRequire Import {LIBRARY}.\nImport ListNotations.\nOpen Scope scalar_scope.\n"
    )


def _message(text: str) -> str:
    short = " ".join(text.split())
    return (
        short
        if len(short) <= MAX_MESSAGE
        else f"{short[: MAX_MESSAGE // 2]} … {short[-MAX_MESSAGE // 2 :]}"
    )
