"""``hfield check --coq``: check accepted certificates with Coq as well."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from hfield.checker.check import Established
from hfield.checker.glossary import COMMUTATIVE_RINGS
from hfield.checker.rejection import one_line
from hfield.cli.parser import seconds, whole
from hfield.cli.status import Waiting
from hfield.errors import HFieldError
from hfield.export.coq.coqc_process import MEMORY, SECONDS

if TYPE_CHECKING:
    from hfield.export.coq.coqc import Coqc


ACCEPTED, REJECTED, NOT_COVERED, NOT_JUDGED = "accepted", "rejected", "not covered", "not judged"
NOT_CONFIRMED = 4  # the exit status if Coq did not check a certificate that the checker accepts
MAX_MEMORY = 1 << 24  # MiB


@dataclass(frozen=True)
class CoqVerdict:
    """Coq's verdict on one certificate: status, reason, and the accepted proposition as Coq prints it."""

    word: str
    reason: str
    proposition: str = ""

    def lines(self) -> list[str]:
        """Return the verdict as lines."""
        theorem = [f"Coq's theorem: {self.proposition}"] if self.proposition else []
        return [f"Coq: {self.word}: {self.reason}", *theorem]

    def json(self) -> dict[str, str | None]:
        """Return the verdict as JSON data."""
        return {
            "verdict": self.word,
            "reason": self.reason,
            "proposition": self.proposition or None,
        }


Judge = Callable[[str, Established, object], CoqVerdict]
"""What asks Coq about a certificate: its name, what the checker established, the data that it checked."""


def add_coq(parser: ArgumentParser) -> None:
    """Declare ``--coq`` and its limits."""
    parser.add_argument(
        "--coq",
        action="store_true",
        help="check accepted certificates with Coq too: each becomes a theorem with the evidence as its "
        "proof. Exit status 1 if Coq rejects one; 4 if Coq did not judge one, because the translation does "
        "not cover it or coqc is missing, failed or was stopped",
    )
    parser.add_argument(
        "--coq-timeout",
        type=seconds,
        default=SECONDS,
        metavar="S",
        help=f"time limit of one run of coqc in seconds (default: {SECONDS:g})",
    )
    parser.add_argument(
        "--coq-memory",
        type=whole(1, MAX_MEMORY, "number of MiB"),
        default=MEMORY,
        metavar="MIB",
        help=f"memory limit of coqc in MiB (default: {MEMORY})",
    )


@contextmanager
def judge_by_coq(args: Namespace) -> Iterator[Judge]:
    """Check certificates one by one with ``coqc`` inside the ``with`` block."""
    from hfield.export.coq.coqc import Coqc

    with Coqc(args.coq_timeout, args.coq_memory) as coq:
        yield partial(_judge, coq)


def _judge(coq: Coqc, name: str, found: Established, data: object) -> CoqVerdict:
    from hfield.export.coq.base_rings import FIELDS
    from hfield.export.coq.cofactors import MismatchError
    from hfield.export.coq.coqc import NotJudgedError
    from hfield.export.coq.theorem import theorem

    Waiting.at(f"Coq judges {one_line(name)}")
    try:
        one = theorem("certificate", data)
        judged = coq.judge([one])
    except NotJudgedError as error:
        return CoqVerdict(NOT_JUDGED, str(error))
    except MismatchError as error:
        return CoqVerdict(NOT_JUDGED, f"no theorem can be made of it: {error}")
    except HFieldError as error:
        return CoqVerdict(NOT_COVERED, str(error))
    if judged.rejected:
        return CoqVerdict(REJECTED, judged.rejected)
    (proposition,) = judged.propositions
    if found.scope == COMMUTATIVE_RINGS and FIELDS.opening in one.text:
        return CoqVerdict(NOT_COVERED, "Coq's theorem is about fields only", proposition)
    return CoqVerdict(ACCEPTED, "a theorem without axioms", proposition)


def exit_status(verdicts: Iterable[CoqVerdict | None], status: int) -> int:
    """Return the exit status, given the status of the checker."""
    words = {v.word for v in verdicts if v is not None}
    if status in (1, 2) or not words:
        return status
    if REJECTED in words:
        return 1
    return NOT_CONFIRMED if words & {NOT_COVERED, NOT_JUDGED} else status
