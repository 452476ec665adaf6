"""The roots of a polynomial in one variable, coefficients from low to high: over ℤ, ℚ, GF(q) and ℤ/n."""

from collections.abc import Sequence
from itertools import product
from math import prod

import flint

from hfield.errors import UndecidedError
from hfield.factorisation import factor, remove
from hfield.product import Scalar

MAX_DEGREE = 2_000
MAX_LIFTS = 10_000


def rational_roots(coefficients: Sequence[flint.fmpq]) -> list[flint.fmpq]:
    """Return the rational roots, as ``fmpq``, of a polynomial over ℚ that is not 0.

    >>> from hfield import ring
    >>> rational_roots([ring("QQ")(n) for n in (1, -3, 2)])
    [1, 1/2]
    """
    return [-g[0] for g in irreducible_factors(coefficients) if g.degree() == 1]


def irreducible_factors(coefficients: Sequence[flint.fmpq]) -> list[flint.fmpq_poly]:
    """Return the monic irreducible factors of a polynomial over ℚ that is not 0, each once."""
    _need_small(coefficients)
    factors = flint.fmpq_poly(list(coefficients)).factor()[1]
    return [g / g.leading_coefficient() for g, _ in factors]


def integral(g: flint.fmpq_poly) -> flint.fmpz_poly:
    """Return the monic polynomial over ℤ of a whole multiple of the roots of a monic polynomial over ℚ."""
    n, scale = int(g.degree()), int(g.denom())
    return flint.fmpz_poly([int((c * scale ** (n - k)).p) for k, c in enumerate(g.coeffs())])


def near_root(f: flint.fmpz_poly, p: int, digits: int = 0) -> int | None:
    """Return an r near a root in ℚ_p of a monic irreducible polynomial over ℤ; None where it has no root.

    So many ``digits`` are those of the root. Near means v(f(r)) > 2·v(f′(r)), whence Newton's steps lead to a
    root (Hensel's lemma). With v the order of the discriminant, a root modulo p^(2v + 1) is near one, for
    v(f′(r)) ≤ v wherever v(f(r)) > v. Raises :class:`UndecidedError` where there are too many.
    """
    v, _ = remove(int(f.discriminant()), p)
    roots = residue_roots([int(c) for c in f.coeffs()], p ** (2 * v + 1 + digits))
    return roots[0] if roots else None


def residue_roots(coefficients: Sequence[int], n: int) -> list[int]:
    """Return the roots modulo n, sorted: modulo primes by flint, lifted to their powers, put together.

    Raises :class:`UndecidedError` where n has no known factors, or there are too many roots.

    >>> residue_roots([-1, 0, 1], 24)
    [1, 5, 7, 11, 13, 17, 19, 23]
    """
    _need_small(coefficients)
    found = factor(n)
    if found.rest:
        raise UndecidedError(f"roots modulo {n} need its factors, and some are not known")
    powers = [(p, k, _power_roots(list(coefficients), p, k)) for p, k in found.primes.items()]
    if prod(len(roots) for _, _, roots in powers) > MAX_LIFTS:
        raise UndecidedError(f"there are more than {MAX_LIFTS} roots modulo {n}")
    idempotents = [(n // p**k) * pow(n // p**k, -1, p**k) for p, k, _ in powers]
    choices = product(*(roots for _, _, roots in powers))
    return sorted(sum(r * e for r, e in zip(c, idempotents, strict=True)) % n for c in choices)


def _power_roots(c: list[int], p: int, k: int) -> list[int]:
    """Return the roots modulo pᵏ: modulo p first, then what lies above each, one power at a time."""
    if all(x % p == 0 for x in c):
        if p > MAX_LIFTS:
            raise UndecidedError(f"every number is a root modulo {p}")
        roots = list(range(p))
    else:
        over_p = flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(p))
        roots = [int(r) for r, _ in over_p([x % p for x in c]).roots()]
    q, derivative = p, [n * a for n, a in enumerate(c)][1:]
    for _ in range(1, k):
        above = q * p
        lifted: list[int] = []
        for r in roots:
            value, slope = _value(c, r) // q % p, _value(derivative, r) % p
            if slope:  # Hensel: one root above
                lifted.append((r - value * pow(slope, -1, p) * q) % above)
            elif value == 0:  # all p numbers above, or none
                if len(lifted) + p > MAX_LIFTS:
                    raise UndecidedError(f"there are more than {MAX_LIFTS} roots modulo {above}")
                lifted.extend(r + q * n for n in range(p))
        roots, q = lifted, above
    return roots


def _value(c: Sequence[int], x: int) -> int:
    total = 0
    for a in reversed(c):
        total = total * x + a
    return total


def _need_small(coefficients: Sequence[Scalar]) -> None:
    if len(coefficients) > MAX_DEGREE + 1:
        raise UndecidedError(f"roots are not computed above the degree {MAX_DEGREE}")
