"""Run ``coqc`` with time and memory limits, one theorem at a time."""

from __future__ import annotations

import os
import re
import shutil
import signal
import stat
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from secrets import token_hex
from tempfile import TemporaryDirectory, TemporaryFile, gettempdir
from typing import IO

from hfield.errors import HFieldError
from hfield.export.coq.coqc_process import MEMORY, SECONDS
from hfield.export.coq.export import Export, library
from hfield.export.coq.theorem import Theorem

CLOSED = "Closed under the global context"
LIBRARY = "HFieldJudge"
MAX_OUTPUT = 1 << 24  # limit for the bytes of its output that are read
MAX_MESSAGE = 600
# The one error that is about the evidence: Coq computed a judgement, and it is not `true`.
_NOT_TRUE = re.compile(
    r'Error: .*has type "true = true" while it is expected to have type ".* = true"\.$'
)
_TYPED = 'Notation "x = y :> A" := (@eq A x y) (only printing) : type_scope.'
_TYPED += ' Notation "x <> y :> A" := (~ @eq A x y) (only printing) : type_scope.'


class NotJudgedError(HFieldError, RuntimeError):
    """Coq gave no verdict on a theorem; the message says why."""


class CoqMissingError(NotJudgedError, OSError):
    """There is no ``coqc`` program."""


@dataclass(frozen=True)
class Judged:
    """Coq's verdict on theorems: their propositions as printed, or the reason why one was ``rejected``."""

    propositions: tuple[str, ...] = ()
    rejected: str = ""


class Coqc:
    """Runs ``coqc`` in its own folder, as a context manager; the library is compiled on first use.

    Each run may take ``seconds``, and ``memory`` MiB.
    """

    def __init__(self, seconds: float = SECONDS, memory: int = MEMORY) -> None:
        self.seconds, self.memory = seconds, memory
        self._folder: TemporaryDirectory[str] | None = None
        self._has_library = False

    def __enter__(self) -> Coqc:
        return self

    def __exit__(self, *_: object) -> None:
        if self._folder is not None:
            self._folder.cleanup()

    @cached_property
    def folder(self) -> Path:
        """The folder in which ``coqc`` runs. Raises OSError, and NotJudgedError if others can write there."""
        above = Path(gettempdir()).resolve()
        for parent in (above, *above.parents):
            mode = parent.stat().st_mode
            if mode & stat.S_IWOTH and not mode & stat.S_ISVTX:
                raise NotJudgedError(
                    f"anyone may rename what is in {parent}; set TMPDIR to a folder of your own"
                )
        self._folder = TemporaryDirectory(
            prefix="hfield-coq-", dir=above, ignore_cleanup_errors=True
        )
        return Path(self._folder.name)

    @property
    def program(self) -> str:
        """The path of ``coqc``. Raises :class:`CoqMissingError`."""
        found = shutil.which("coqc")
        if found is None:
            raise CoqMissingError(
                "coqc is not installed (Debian: apt-get install --no-install-recommends coq)"
            )
        return os.path.abspath(found)

    @property
    def environment(self) -> dict[str, str]:
        """This process's environment without Coq's search paths, so that Coq finds only its own libraries."""
        nowhere = str(self.folder / "none")
        return {**os.environ, "COQPATH": "", "XDG_DATA_HOME": nowhere, "XDG_DATA_DIRS": nowhere}

    def compile_library(self) -> None:
        """Compile the common part of all files, once. Raises :class:`NotJudgedError` if that fails."""
        if self._has_library:
            return
        status, _, errors = self._run(LIBRARY, library())
        if status:
            raise self._failed(_ending(status, errors))
        self._has_library = True

    def judge(self, theorems: Sequence[Theorem]) -> Judged:
        """Compile theorems, and let Coq print them with the axioms that they use.

        Raises :class:`NotJudgedError` if Coq neither accepts the theorems nor finds that the evidence proves
        nothing.
        """
        bare = tuple(replace(t, comment="") for t in theorems)  # no text of a certificate
        if any(t.place for t in bare):  # they are in sections, which are not compiled in advance
            head = Export(bare).body
        else:
            self.compile_library()
            head = "\n\n".join([opening(), *map(str, bare)])
        mark = token_hex(16)  # Coq's output for a theorem cannot contain this text
        status, said, errors = self._run("Judged", f"{head}\n{_asking(bare, mark)}")
        if status == 1 and _NOT_TRUE.search(" ".join(errors.split())):
            return Judged(rejected=_short(errors))
        if status:
            raise self._failed(_ending(status, errors))
        *printed, rest = said.split(f"{mark}\n")
        heads = [
            re.match(rf"@?{t.name}\s+: ", text) for t, text in zip(bare, printed, strict=False)
        ]
        if len(printed) != len(bare) or not all(heads):
            raise NotJudgedError(f"coqc does not print the theorem: {_short(said)!r}")
        if rest.strip() != CLOSED:
            raise NotJudgedError(f"Coq says what the theorem rests on: {_short(rest)}")
        pairs = zip(printed, heads, strict=True)
        return Judged(tuple(" ".join(text[m.end() :].split()) for text, m in pairs if m))

    def _run(self, name: str, text: str) -> tuple[int, str, str]:
        """Run ``coqc`` on a text; return its exit status and its output, including errors.

        Raises :class:`NotJudgedError` if it cannot be started or does not finish.
        """
        bounds = [os.getpid(), int(self.seconds) + 1, self.memory]
        command = [sys.executable, "-I", "-S", str(Path(__file__).with_name("coqc_process.py"))]
        command += [*map(str, bounds), self.program, "-q", f"{name}.v"]
        try:
            (self.folder / f"{name}.v").write_text(text, encoding="ascii")
            with TemporaryFile() as said, TemporaryFile() as errors:
                process = subprocess.Popen(
                    command,
                    cwd=self.folder,
                    env=self.environment,
                    stdin=subprocess.DEVNULL,
                    stdout=said,
                    stderr=errors,
                    start_new_session=True,
                )
                try:
                    status = process.wait(self.seconds)
                finally:  # also ends processes that it started, even if this process is to end
                    with suppress(ProcessLookupError):
                        os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
                return status, _read(said), _read(errors)
        except subprocess.TimeoutExpired:
            raise self._failed("did not end in time") from None
        except (OSError, UnicodeError) as error:
            raise self._failed(f"could not be run: {error}") from error

    def _failed(self, what: str) -> NotJudgedError:
        bounds = f"{self.seconds:g} s (--coq-timeout), {self.memory} MiB (--coq-memory)"
        return NotJudgedError(f"coqc {what}; it had {bounds}")


def opening() -> str:
    """Return the first lines of a file that uses the compiled library."""
    imports = next(
        line for line in library().splitlines() if line.startswith("From Coq Require Import")
    )
    return (
        f"{imports}\nRequire Import {LIBRARY}.\nImport ListNotations.\nOpen Scope scalar_scope.\n"
    )


def _asking(theorems: Sequence[Theorem], mark: str) -> str:
    """Return the commands that print each theorem, followed by ``mark`` on a line, and its axioms.

    If the ring is not visible elsewhere in a proposition, Coq is set to print it after each equation.
    """
    lines = ["Set Printing Depth 1000000."]
    lines += [_TYPED] if any(" :> " in t.text for t in theorems) else []
    for one in theorems:
        lines.append(f'Check @{one.name}. Goal True. idtac "{mark}". Abort.')
    used = "".join(f"  let _ := @{t.name} in\n" for t in theorems)
    lines.append(f"Definition all_asked : True :=\n{used}  I.\nPrint Assumptions all_asked.\n")
    return "\n".join(lines)


def _read(stream: IO[bytes]) -> str:
    stream.seek(0)
    return stream.read(MAX_OUTPUT).decode("utf-8", "replace")


def _ending(status: int, errors: str) -> str:
    """Describe how an unsuccessful run of ``coqc`` ended."""
    how = f"with status {status}"
    if status < 0:
        how = f"by signal {-status} ({signal.strsignal(-status)})"
    return f"ended {how}: {_short(errors) or 'without a word'}"


def _short(text: str) -> str:
    short = " ".join(text.split())
    half = MAX_MESSAGE // 2
    return short if len(short) <= MAX_MESSAGE else f"{short[:half]} … {short[-half:]}"
