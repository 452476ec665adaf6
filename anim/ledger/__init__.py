"""Sections 3.3 and 3.4 of the thesis, its summaries and chapter 4, as claims of the ledger."""

from anim.ledger import (
    euler_angles,
    optimised,
    precession,
    quaternion_matrix,
    samples,
    shape,
    summaries,
)
from hfield.ledger.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *shape.CLAIMS,
    *samples.CLAIMS,
    *precession.CLAIMS,
    *optimised.CLAIMS,
    *euler_angles.CLAIMS,
    *quaternion_matrix.CLAIMS,
    *summaries.CLAIMS,
)
