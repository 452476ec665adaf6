"""Random polynomials over nine fields; scripts/try_polynomials.py tries as many as one likes."""

from random import Random

import pytest

from tests.polynomials.polynomial_checks import ALGEBRAS, Case


@pytest.mark.parametrize("field", ALGEBRAS)
def test_roots_and_factors(field):
    rng = Random(field)
    for text in ALGEBRAS[field]:
        case = Case(text, rng, most=16)
        decided = [case.check(*case.polynomial()) for _ in range(6)]
        assert any(decided)
