"""Turn one certificate into one Coq theorem with its proof."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeGuard

from hfield.checker.first_schema import current
from hfield.checker.glossary import CERTIFIED, KEYS, SCHEMA
from hfield.errors import HFieldError, TooLargeError, shorten
from hfield.evidence import Kind
from hfield.export.coq.certificate_data import CertificateData
from hfield.export.coq.cofactors import MismatchError
from hfield.export.coq.compound_statements import judge
from hfield.export.coq.sentences import Proved
from hfield.fields.names import ring, ring_of_data
from hfield.notation import UNNAMED, split_algebra
from hfield.prover.statements.setting import read_setting

MAX_PROOF = 3_000_000


@dataclass(frozen=True)
class Theorem:
    """A theorem of Coq with its proof."""

    name: str
    comment: str
    proved: Proved

    @property
    def place(self) -> str:
        """The section of the file that contains the theorem, if any."""
        return self.proved.place

    @property
    def text(self) -> str:
        """The proposition."""
        return self.proved.text

    def __str__(self) -> str:
        return f"(* {self.comment} *)\n{self.proved.lemma(self.name, 'Theorem')}"


def theorem(name: str, data: object, words: str = "") -> Theorem:
    """Translate a certificate.

    Raises :class:`NotCoveredError` if there is no translation, :class:`MismatchError` if the evidence cannot
    belong to the statement, and :class:`TooLargeError`.
    """
    data = current(data)
    if not _is_certificate(data):
        raise MismatchError(f"this is not a certificate {SCHEMA}")
    if data["verdict"] not in CERTIFIED:
        raise MismatchError(f"there is no verdict {shorten(str(data['verdict']))!r}")
    try:
        proved = _proved(name, data)
    except (KeyError, TypeError, AttributeError, ValueError, IndexError) as error:
        if isinstance(error, HFieldError):
            raise
        raise MismatchError(
            f"the evidence is not of the form that its kind has: {error!r}"
        ) from error
    except RecursionError:
        raise TooLargeError("the statement nests too deeply") from None
    where = data["field"] or "all fields"
    comment = f"{words}{data['statement']}, in {data['algebra']} [{data['verdict']}, {where}]"
    out = Theorem(name, comment_text(comment), proved)
    if len(str(out)) > MAX_PROOF:
        raise TooLargeError(f"the theorem has more than {MAX_PROOF} characters")
    return out


def _is_certificate(data: object) -> TypeGuard[CertificateData]:
    """Return whether data have the keys of a certificate; the types of the values are not checked."""
    return isinstance(data, Mapping) and set(data) == set(KEYS) and data["schema"] == SCHEMA


def _proved(name: str, data: CertificateData) -> Proved:
    setting = read_setting(data["field"], data["algebra"])
    field = None if setting.field is None else setting.field.name
    a, t, b, inside = split_algebra(data["algebra"])
    if field != data["field"] or (UNNAMED if field is None else field) != inside:
        raise MismatchError("the algebra and the field do not agree")
    a, t, b = ("".join(text.split()) for text in (a, t, b))
    setting = replace(
        setting, constants=(a, t, b)
    )  # as they were written, not as the field writes them
    evidence, rings = data["evidence"], {data["field"]: data["ring"]}
    if evidence["kind"] == Kind.RINGS:
        rings |= {ring_of_data(x).name: x for x in evidence["rings"]}
        evidence = evidence["evidence"]
    if any((None if name is None else ring(name).data) != x for name, x in rings.items()):
        raise MismatchError("the data of a ring are not those of its name")
    return judge(name, data["statement"], setting, data["verdict"], evidence)


def comment_text(text: str) -> str:
    """Return a text for a Coq comment: invisible characters, and those that would end the comment, are
    replaced.
    """
    text = "".join(c if c.isprintable() or c == "\n" else "?" for c in text)
    return text.replace("(*", "( *").replace("*)", "* )").replace('"', "'")
