"""Ranks, kernels, inverses and norms over many fields; scripts/try_matrices.py takes larger matrices."""

from random import Random

from tests.matrices.matrix_checks import ALGEBRAS, Case
from tests.subcases import subcases


@subcases("text", ALGEBRAS)
def test_against_the_regular_representation(text):
    case = Case(text, Random(text))
    for n in (1, 2, 2, 3):
        case.check(n)


def test_twelve_rows():
    for text in ("(-1,-1|GF(7))", "(0,-1|QQ)"):
        Case(text, Random(text)).check(12)
