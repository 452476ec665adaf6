"""``hfield check --coq``: what Coq says of the same certificates."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.commands.status import Waiting

if TYPE_CHECKING:
    from hfield.coq.coqc import Coqc

ACCEPTED, REJECTED, NOT_COVERED, NOT_JUDGED = "accepted", "rejected", "not covered", "not judged"
NOT_CONFIRMED = 4  # the exit status where Coq has not seen a certificate that the checker accepts
FLAG_HELP = (
    "let Coq judge the accepted ones too: each becomes a theorem, proved by its evidence. Exit "
    "status 1 if Coq rejects one, 4 if it did not judge one, since the translation does not cover it "
    "or there is no coqc"
)


@dataclass(frozen=True)
class Verdict:
    """What became of one certificate, and why."""

    word: str
    reason: str = ""

    def __str__(self) -> str:
        return f"Coq: {self.word}" + (f": {self.reason}" if self.reason else "")


def coq_verdicts(files: Sequence[str]) -> dict[str, Verdict]:
    """Translate certificates that were read before, and let ``coqc`` judge them one by one."""
    from hfield.coq.coqc import Coqc, CoqMissingError

    if not files:
        return {}
    try:
        with Coqc() as coq:
            out = {}
            for file in files:
                Waiting.at(f"Coq judges {file}")
                out[file] = _judged(file, coq)
            return out
    except CoqMissingError as error:
        return {file: Verdict(NOT_JUDGED, str(error)) for file in files}


def _judged(file: str, coq: Coqc) -> Verdict:
    from hfield.coq.cofactors import MismatchError
    from hfield.coq.theorem import theorem
    from hfield.errors import HFieldError

    try:
        one = theorem("certificate", json.loads(Path(file).read_text(encoding="utf-8")))
    except MismatchError as error:
        return Verdict(REJECTED, str(error))
    except HFieldError as error:
        return Verdict(NOT_COVERED, str(error))
    except (OSError, ValueError) as error:
        return Verdict(NOT_JUDGED, str(error))
    reason = coq.reject([one])
    if reason is None:
        return Verdict(ACCEPTED, "a theorem without axioms")
    return Verdict(REJECTED, reason)


def exit_status(verdicts: Mapping[str, Verdict], status: int) -> int:
    """Return the exit status, ``status`` being that of the checker."""
    words = {v.word for v in verdicts.values()}
    if status in (1, 2) or not words:
        return status
    if REJECTED in words:
        return 1
    return NOT_CONFIRMED if words & {NOT_COVERED, NOT_JUDGED} else status
