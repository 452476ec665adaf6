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
from hfield.ledger.document import load

CLAIMS: tuple[Claim, ...] = (
    *load(
        __name__,
        "chapter3_top.toml",
        shape.COMPUTED
        | samples.COMPUTED
        | precession.COMPUTED
        | optimised.COMPUTED
        | euler_angles.COMPUTED
        | quaternion_matrix.COMPUTED
        | summaries.COMPUTED,
    ),
    *load(__name__, "chapter4.toml", summaries.CONCLUSION),
)
