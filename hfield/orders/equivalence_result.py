"""The answer to the question whether two ideals are equivalent, or two orders isomorphic."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

from hfield.evidence import Certified, CertifiedClaim

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion


@dataclass(frozen=True)
class EquivalenceResult(Certified):
    """True or false in an ``if``; ``element`` proves a true answer, ``reason`` says how it was decided.

    ``theorem`` names the theorem that decided where nothing was enumerated; then a true answer may come
    without its element, which was not found within a bound.
    """

    holds: bool
    reason: str
    element: Quaternion | None = None
    theorem: str | None = None
    make_claim: Callable[[EquivalenceResult], CertifiedClaim] | None = field(
        default=None, compare=False, repr=False
    )
    """Makes the statement and its evidence of this answer."""

    @cached_property
    def claim(self) -> CertifiedClaim:
        """The answer as a statement with its evidence."""
        assert self.make_claim is not None, "whoever compares ideals or orders gives the statement"
        return self.make_claim(self)

    @property
    def why_no_certificate(self) -> str | None:
        """Why there is no certificate, in a line; None where there is one."""
        return self.claim.why_no_certificate

    def __bool__(self) -> bool:
        """Tell whether it holds."""
        return self.holds

    def __repr__(self) -> str:
        shown = "" if self.element is None else f" with {self.element}"
        return f"{'yes' if self.holds else 'no'}{shown}: {self.reason}"
