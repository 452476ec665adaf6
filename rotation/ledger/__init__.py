"""Chapters 2, 3.1 and 3.2 of the thesis, and its introduction, as claims of the ledger."""

from hfield.ledger.claim import Claim
from rotation.ledger import (
    complex_numbers,
    euler,
    introduction,
    letter,
    matrix_functions,
    orthogonal,
    performance,
    plane,
    quaternion_functions,
    reflections,
    space,
    theorem5,
    theorem6,
)

CLAIMS: tuple[Claim, ...] = (
    *introduction.CLAIMS,
    *plane.CLAIMS,
    *letter.CLAIMS,
    *reflections.CLAIMS,
    *complex_numbers.CLAIMS,
    *space.CLAIMS,
    *euler.CLAIMS,
    *orthogonal.CLAIMS,
    *theorem5.CLAIMS,
    *theorem6.CLAIMS,
    *quaternion_functions.CLAIMS,
    *matrix_functions.CLAIMS,
    *performance.CLAIMS,
)
