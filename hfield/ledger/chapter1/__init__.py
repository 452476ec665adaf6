"""Chapter 1 of the thesis: the 92 claims of sections 1 to 1.4.4, in the order of the text."""

from hfield.ledger.chapter1 import (
    associativity,
    forms,
    inverses,
    matrices,
    multiplication,
    norms,
    presentation,
    trigonometric,
)
from hfield.ledger.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *multiplication.CLAIMS,
    *associativity.CLAIMS,
    *presentation.CLAIMS,
    *norms.CLAIMS,
    *inverses.CLAIMS,
    *forms.CLAIMS,
    *matrices.CLAIMS,
    *trigonometric.CLAIMS,
)
