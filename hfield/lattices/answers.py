"""What a question about equivalence or isomorphism is answered with: the element, or the reason."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from hfield.algebra.quaternion import Quaternion
from hfield.lattices import certificates

if TYPE_CHECKING:
    from hfield.lattices.certificates import Claim
    from hfield.lattices.lattice import Lattice


@dataclass(frozen=True)
class Answer:
    """True or false in an ``if``; ``element`` proves a true answer, ``reason`` says how it was decided.

    ``theorem`` names the theorem that decided where nothing was enumerated; then a true answer may come
    without its element, which was not found within a bound. ``evidence`` is what a program needs to check it.
    """

    holds: bool
    reason: str
    element: Quaternion | None = None
    theorem: str | None = None
    evidence: dict[str, Any] = field(default_factory=dict, compare=False)
    lattices: tuple[Lattice, ...] = field(default=(), compare=False, repr=False)
    """The two that were compared, and that which was run through, if any."""

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/2`` as JSON data, one that the checker accepts, or None.

        There is none where a theorem decided and the element is missing, nor where the checker would have to
        do too much; :attr:`why_no_certificate` says which.
        """
        claim = self._claim
        return None if claim is None else claim.certificate

    @property
    def why_no_certificate(self) -> str | None:
        """Why there is no certificate, in a line; None where there is one."""
        claim = self._claim
        if claim is None:
            return (
                "the element is missing"
                if self.holds
                else "nothing was found that tells them apart"
            )
        return claim.why_no_certificate

    @cached_property
    def _claim(self) -> Claim | None:
        return certificates.of_answer(self)

    def __bool__(self) -> bool:
        """Tell whether it holds."""
        return self.holds

    def __repr__(self) -> str:
        shown = "" if self.element is None else f" with {self.element}"
        return f"{'yes' if self.holds else 'no'}{shown}: {self.reason}"


STRONG_APPROXIMATION = (
    "Eichler's theorem, from strong approximation: in an indefinite algebra over QQ an order whose local "
    "units have all unit norms has one ideal class (Voight, Quaternion Algebras, chapter 28)"
)
