"""Chapters 2, 3.1 and 3.2 of the thesis, and its introduction, as claims of the ledger."""

from hfield.ledger.claim import Claim
from hfield.ledger.document import load
from rotation.ledger import (
    complex_numbers,
    euler,
    letter_t,
    matrix_functions,
    orthogonal,
    performance,
    plane,
    quaternion_functions,
    reflections,
    theorem5,
    theorem6,
)

CLAIMS: tuple[Claim, ...] = (
    *load(__name__, "introduction.toml", {}),
    *load(
        __name__,
        "chapter2.toml",
        plane.COMPUTED
        | letter_t.COMPUTED
        | reflections.COMPUTED
        | complex_numbers.COMPUTED
        | euler.COMPUTED
        | orthogonal.COMPUTED
        | theorem5.COMPUTED
        | theorem6.COMPUTED,
    ),
    *load(
        __name__,
        "chapter3_rotations.toml",
        quaternion_functions.COMPUTED | matrix_functions.COMPUTED | performance.COMPUTED,
    ),
)
