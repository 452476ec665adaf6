from fractions import Fraction

from hypothesis import assume, given
from hypothesis import strategies as st

from hfield.structure.conic import solve_conic
from hfield.structure.hilbert import ramified_places_q

nonzero = st.integers(-(10**6), 10**6).filter(bool)


@given(nonzero, nonzero, st.integers(1, 50))
def test_conics_with_a_point_are_solved(a, b, d):
    b = Fraction(b, d)
    if ramified_places_q(a, b):
        return
    x, y, z = solve_conic(a, b)
    assert a * x * x + b * y * y == z * z
    assert (x, y, z) != (0, 0, 0)


@given(nonzero, st.integers(1, 10**6), st.integers(1, 10**6))
def test_norms_are_found_to_be_norms(a, u, v):
    b = u * u - a * v * v
    assume(b)
    x, y, z = solve_conic(a, b)
    assert a * x * x + b * y * y == z * z
    assert (x, y, z) != (0, 0, 0)


def test_large_coefficients_given_their_primes():
    p, q = 2**127 - 1, 2**89 - 1
    pairs = ((p * m, -q * n) for m in range(1, 40) for n in range(1, 40))
    a, b = next((a, b) for a, b in pairs if not ramified_places_q(a, b, [p, q]))
    x, y, z = solve_conic(a, b, [p, q])
    assert a * x * x + b * y * y == z * z
    assert (x, y, z) != (0, 0, 0)
