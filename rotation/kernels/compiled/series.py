"""Coefficients of Taylor's series, which the plain formulas and the compiled ones share."""

import math

# sin x = x + x³·Σ SINE[k]·x²ᵏ and 1 − cos x = x²/2 + x⁴·Σ VERSINE[k]·x²ᵏ: without their first terms,
# which are carried in twice the precision. They reach below 2⁻⁶⁰ up to π/8.
SINE = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 9))
VERSINE = tuple((-1.0) ** (k + 1) / math.factorial(2 * k) for k in range(2, 10))
