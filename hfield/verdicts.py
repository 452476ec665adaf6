"""The result type of yes-or-no questions: the value, the reason, and a witness."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from hfield.evidence import CertifiedClaim

W = TypeVar("W")


@dataclass(frozen=True, eq=False, repr=False)
class Verdict(Generic[W]):
    """The answer to a yes-or-no question, with a reason; true or false in an ``if``, and equal to True or
    False.

    ``witness`` is the evidence, such as an element or a matrix, or None. ``theorem`` names the theorem that
    decided if no witness was computed. ``make_claim`` returns the statement with its evidence for the
    certificate; it is called on first use.

    >>> answer = Verdict(False, "their norms differ: 1 and 2")
    >>> bool(answer), answer == False, answer.element, answer.certificate
    (False, True, None, None)
    >>> answer
    no: their norms differ: 1 and 2
    """

    value: bool
    reason: str = ""
    witness: W | None = None
    theorem: str | None = None
    make_claim: Callable[[], CertifiedClaim | None] | None = field(
        default=None, kw_only=True, compare=False
    )

    @property
    def holds(self) -> bool:
        """The value."""
        return self.value

    @property
    def element(self) -> W | None:
        """The witness, if it is an element."""
        return self.witness

    @cached_property
    def claim(self) -> CertifiedClaim | None:
        """The claim with its evidence; None if there is no certificate."""
        return None if self.make_claim is None else self.make_claim()

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/2`` as JSON data, accepted by the checker, or None."""
        return None if self.claim is None else self.claim.certificate

    @property
    def why_no_certificate(self) -> str | None:
        """The reason, on one line, why there is no certificate; None if there is one."""
        if self.claim is None:
            return "certificates have no statement about this"
        return self.claim.why_no_certificate

    def __bool__(self) -> bool:
        return self.value

    def __eq__(self, other: object) -> bool:
        if isinstance(other, bool):
            return self.value == other
        return type(other) is type(self) and self._key() == other._key()

    def _key(self) -> tuple[object, ...]:
        return tuple(getattr(self, entry.name) for entry in fields(self) if entry.compare)

    def __hash__(self) -> int:
        return hash(self.value)  # like those of True and False, to which it may be equal

    def __repr__(self) -> str:
        shown = "" if self.witness is None else f" with {self.witness}"
        because = f": {self.reason}" if self.reason else ""
        return f"{'yes' if self.value else 'no'}{shown}{because}"
