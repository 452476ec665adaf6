"""Write the Coq file: definitions, lemmas proved by hand, and a theorem for each certificate.

This module does not need Coq. The file proves something only when ``coqc`` has accepted it; ``Print
Assumptions`` at its end shows what each theorem depends on.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import files

from hfield.errors import HFieldError, shorten
from hfield.export.coq.terms import NotCoveredError
from hfield.export.coq.theorem import Theorem, comment_text, theorem
from hfield.prover.decision import PROVED, VACUOUS
from hfield.prover.prove import Answer, prove

# The beginning of every file; theorems of the first kind are in the section that rings.v opens.
BY_HAND = ("rings.v", "fields.v", "multilinear.v")
ENDS = {
    "rings.v": "End Commutative_rings.",
    "fields.v": "End Fields.",
    "multilinear.v": "End Multilinear_maps.",
}
JUDGE = (
    "statements.v",
    "evidence.v",
    "values.v",
    "over_rings.v",
    "over_fields.v",
    "models.v",
    "soundness.v",
    "words.v",
)
HEADER = """\
Quaternion algebras: theorems for Coq, written by `hfield export --coq`. Check them with
`coqc FILE.v` (Coq 8.16 or later). The last line prints what all of them rest on: "Closed under the
global context", no axiom. The theorems of certificates stand at the end; what comes before are
definitions, theorems about any commutative ring and any field that were proved by hand, and the
proof that the computations with evidence are right."""


@dataclass(frozen=True)
class Left:
    """A theorem that is not in the file, and the reason."""

    name: str
    text: str
    reason: str


@dataclass(frozen=True)
class Export:
    """The theorems, and those left out; ``text`` is the file.

    ``by_hand`` maps claims that are not statements of the language to theorems that every file contains.
    """

    theorems: tuple[Theorem, ...]
    left: tuple[Left, ...] = ()
    by_hand: tuple[tuple[str, str], ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all theorems and lemmas about quaternions, in the order of the file."""
        hand = "\n".join(_piece(file) for file in BY_HAND)
        stated = re.findall(r"^(?:Theorem|Lemma) (\w+)", hand, re.MULTILINE)
        return (*stated, *(t.name for t in self.theorems))

    @cached_property
    def body(self) -> str:
        """The file without its last lines, which print the assumptions."""
        parts = [_comment(HEADER), library(self.theorems)]
        parts += [f"{t}\n" for t in self.theorems if not t.place]
        if self.by_hand:
            lines = (f"{claim}: {theorem}" for claim, theorem in self.by_hand)
            parts.append(_comment("\n".join(["Claims proved by hand, under these names:", *lines])))
        if self.left:
            lines = (f"{x.name}: {shorten(x.text, 90)}\n  {x.reason}" for x in self.left)
            parts.append(_comment("\n".join(["Not in this file:", *lines])))
        return "\n".join(parts)

    @property
    def text(self) -> str:
        """The file; its last command prints the assumptions of all theorems."""
        used = "".join(f"  let _ := @{name} in\n" for name in self.names)
        everything = (
            f"Definition all_theorems : True :=\n{used}  I.\nPrint Assumptions all_theorems.\n"
        )
        return f"{self.body}\n\n{everything}"

    def __add__(self, other: "Export") -> "Export":
        return Export(
            (*self.theorems, *other.theorems),
            (*self.left, *other.left),
            (*self.by_hand, *other.by_hand),
        )


def library(theorems: Iterable[Theorem] = ()) -> str:
    """Return the common part of all files, with the theorems in its sections."""
    placed = [t for t in theorems if t.place]
    parts = [_piece("definitions.v")]
    for file in BY_HAND:
        parts.append(_piece(file))
        parts += [f"{t}\n" for t in placed if t.place == file]
        parts.append(ENDS[file] + "\n")
    parts += [_piece(file) for file in JUDGE]
    return "\n".join(parts)


def export_statements(statements: Sequence[str], algebra: str | None = None) -> Export:
    """Prove statements for all fields and export those that are proved.

    Raises :class:`NotationError` for unreadable statements.
    """
    return export_session(prove(text, algebra=algebra) for text in statements)


def export_session(answers: Iterable[Answer]) -> Export:
    """Export the answers of :func:`hfield.prove` that are proved."""
    theorems: list[Theorem] = []
    left: list[Left] = []
    for number, answer in enumerate(answers, 1):
        name = f"statement_{number}"
        try:
            theorems.append(theorem_of(name, answer))
        except HFieldError as error:
            left.append(Left(name, answer.text, str(error)))
    return Export(tuple(theorems), tuple(left))


def export_certificates(certificates: Mapping[str, object]) -> Export:
    """Export certificates, given by theorem name."""
    theorems: list[Theorem] = []
    left: list[Left] = []
    for name, data in certificates.items():
        try:
            theorems.append(theorem(name, data))
        except HFieldError as error:
            text = data.get("statement") if isinstance(data, dict) else None
            left.append(Left(name, text if isinstance(text, str) else "?", str(error)))
    return Export(tuple(theorems), tuple(left))


def theorem_of(name: str, answer: Answer) -> Theorem:
    """Return one answer as a theorem. Raises :class:`NotCoveredError` or :class:`TooLargeError`."""
    if answer.verdict not in (PROVED, VACUOUS):
        raise NotCoveredError(f"{answer.verdict}, so this is not a theorem")
    if answer.certificate is None:
        raise NotCoveredError(f"there is no certificate: {answer.why_no_certificate}")
    return theorem(name, answer.certificate)


def _piece(file: str) -> str:
    """Return a file of this folder that is part of every export."""
    return (files("hfield.export.coq") / file).read_text(encoding="utf-8").lstrip("\n")


def _comment(text: str) -> str:
    return f"(* {comment_text(text)} *)".replace("\n", "\n   ")
