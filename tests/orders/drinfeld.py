"""Supersingular Drinfeld modules of rank 2 over an extension of 𝔽_q[t]/P, by their own equations.

A module is φ_t = t + g·τ + Δ·τ², with j = g^(q+1)/Δ; it is supersingular where the Hasse invariant is 0
(E.-U. Gekeler, "Zur Arithmetik von Drinfeld-Moduln", Math. Ann. 262, 1983). A root c of Δ·c^(q+1) + g·c + t
gives the isogeny τ − c, of which the kernel has q elements that t kills.
"""

from __future__ import annotations

import flint

Polynomial = flint.fq_default_poly


class SupersingularModules:
    """The j-invariants, and how many isogenies with a kernel 𝔽_q[t]/t lead from one to another."""

    def __init__(self, q: int, d: int, P: list[int], field: tuple[int, int]) -> None:
        """``P`` has coefficients in the prime field, low degree first; ``field`` is p and n with q = pⁿ."""
        p, n = field
        self.q = q
        self.k = flint.fq_default_ctx(p, 2 * n * d)
        self.ring = flint.fq_default_poly_ctx(self.k)
        self.t = self.ring(P).roots()[0][0]
        self.j = self._supersingular(d)

    def _supersingular(self, d: int) -> list[flint.fq_default]:
        """The roots of the Hasse invariant H_d(g, 1) as a polynomial in j = g^(q+1)."""
        q, g = self.q, self.ring([0, 1])
        before, current = self.ring([1]), g
        for k in range(2, d + 1):
            bracket = self.t ** (q ** (k - 1)) - self.t
            before, current = current, g ** (q ** (k - 1)) * current - before * bracket
        coefficients = current.coeffs()
        shift = 1 if d % 2 else 0  # g divides it where the degree is odd
        polynomial = self.ring(coefficients[shift :: q + 1])
        assert len(coefficients) == (q + 1) * polynomial.degree() + shift + 1
        roots = [c for c, _ in polynomial.roots()]
        assert len(roots) == polynomial.degree(), (
            "it has different roots, all of them over this field"
        )
        return ([self.k.zero()] if shift else []) + roots

    def isogenies(self) -> list[list[int]]:
        """The number of isogenies τ − c from each module to each."""
        return [self._row(j) for j in self.j]

    def _row(self, j: flint.fq_default) -> list[int]:
        q, c = self.q, self.ring([0, 1])
        g, delta = (self.k.zero(), self.k.one()) if j == 0 else (self.k.one(), 1 / j)
        f = c ** (q + 1) * delta + c * g + self.t
        a = (c**q * delta + g) % f
        image = (a**q - c * delta) ** (q + 1) * (1 / delta**q) % f
        return [int(f.gcd(image - self.ring([other])).degree()) for other in self.j]
