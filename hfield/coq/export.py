"""The file for Coq: definitions, what is proved by hand there, the ledger, a session's statements.

Nothing here needs Coq. What the file claims is worth something only once ``coqc`` has read it, and
``Print Assumptions`` at its end shows what each theorem rests on.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import files

from hfield.coq.facts import NoProofError
from hfield.coq.theorems import ASSOCIATIVE, FIELDS, RINGS, Theorem, theorem
from hfield.errors import HFieldError, shorten
from hfield.proving.decision import PROVED, VACUOUS
from hfield.proving.prove import Answer, prove

# Each section of the file: what stands in it by hand, and the theorems over these rings.
SECTIONS = (
    ("rings.v", RINGS, "Commutative_rings"),
    ("fields.v", FIELDS, "Fields"),
    ("multilinear.v", "", "Multilinear_maps"),
    ("presentations.v", ASSOCIATIVE, "Associative_rings"),
)
HEADER = """\
Quaternion algebras: theorems for Coq, written by `hfield export --coq`. Check them with
`coqc FILE.v` (Coq 8.16 or later). They are about any commutative ring, any field, any associative
ring. The last line prints what all of them rest on: "Closed under the global context", no axiom."""


@dataclass(frozen=True)
class Left:
    """What is not in the file, and why."""

    name: str
    text: str
    reason: str


@dataclass(frozen=True)
class Export:
    """The theorems found, and what was left out; ``text`` is the file.

    ``by_hand`` maps claims that are no statement of the language to theorems that stand in every
    file.
    """

    theorems: tuple[Theorem, ...]
    left: tuple[Left, ...] = ()
    by_hand: tuple[tuple[str, str], ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all theorems and lemmas of the file, in its order."""
        return tuple(re.findall(r"^(?:Theorem|Lemma) (\w+)", self.body, re.MULTILINE))

    @cached_property
    def body(self) -> str:
        """The file without its last lines, which print the assumptions."""
        parts = [_comment(HEADER), _piece("definitions.v")]
        for file, room, section in SECTIONS:
            parts += [_piece(file), *(f"{t}\n" for t in self.theorems if t.room == room)]
            parts.append(f"End {section}.\n")
        if self.by_hand:
            lines = (f"{claim}: {theorem}" for claim, theorem in self.by_hand)
            parts.append(_comment("\n".join(["Claims proved by hand, under these names:", *lines])))
        if self.left:
            lines = (f"{x.name}: {shorten(x.text, 90)}\n  {x.reason}" for x in self.left)
            parts.append(_comment("\n".join(["Not in this file:", *lines])))
        return "\n".join(parts)

    @property
    def text(self) -> str:
        """The file: its last command prints what all theorems together assume."""
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


def export_statements(statements: Sequence[str], algebra: str | None = None) -> Export:
    """Prove statements for all fields and export those that are proved.

    Raises :class:`NotationError` for what cannot be read.
    """
    return export_session(prove(text, algebra=algebra) for text in statements)


def export_session(answers: Iterable[Answer]) -> Export:
    """Export the answers of :func:`hfield.prove` that are proved for all fields."""
    theorems: list[Theorem] = []
    left: list[Left] = []
    for number, answer in enumerate(answers, 1):
        name = f"statement_{number}"
        try:
            theorems.append(theorem_of(name, answer))
        except HFieldError as error:
            left.append(Left(name, answer.text, str(error)))
    return Export(tuple(theorems), tuple(left))


def theorem_of(name: str, answer: Answer, words: str = "") -> Theorem:
    """Return one answer as a theorem. Raises :class:`NoProofError` or :class:`TooLargeError`."""
    if answer.field is not None:
        raise NoProofError(f"decided over {answer.field} only, not for all fields")
    if answer.verdict not in (PROVED, VACUOUS):
        raise NoProofError(f"{answer.verdict}, so this is no theorem")
    where = "" if answer.setting.is_hamilton else f", in {answer.setting.algebra}"
    scope = f" [proved over {answer.decision.scope}]" if answer.decision.scope else ""
    comment = comment_text(f"{words}{answer.text}{where}{scope}")
    return theorem(name, comment, answer.statement, answer.setting, answer.decision)


def comment_text(text: str) -> str:
    """Return a text that can stand in a comment of Coq."""
    return text.replace("(*", "( *").replace("*)", "* )").replace('"', "'")


def _piece(file: str) -> str:
    """Return a file of this folder that stands in every export."""
    return (files("hfield.coq") / file).read_text(encoding="utf-8").lstrip("\n")


def _comment(text: str) -> str:
    return f"(* {comment_text(text)} *)".replace("\n", "\n   ")
