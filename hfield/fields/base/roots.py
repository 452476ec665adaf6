"""Polynomials in one variable, as lists of coefficients from low to high: their roots and factors."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, product, zip_longest
from math import prod
from typing import TYPE_CHECKING

import flint

from hfield.core.factorisation import factor, remove
from hfield.core.product import S, Scalar
from hfield.errors import UndecidedError

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Coefficient, Polynomial
    from hfield.fields.base.ring import Core, E, WithSquares

MAX_DEGREE = 2_000
MAX_LIFTS = 10_000


def rational_roots(coefficients: Sequence[flint.fmpq]) -> list[flint.fmpq]:
    """Return the rational roots, as ``fmpq``, of a nonzero polynomial over ℚ.

    >>> from hfield import ring
    >>> rational_roots([ring("QQ")(n) for n in (1, -3, 2)])
    [1, 1/2]
    """
    return [-g[0] for g in irreducible_factors(coefficients) if g.degree() == 1]


def irreducible_factors(coefficients: Sequence[flint.fmpq]) -> list[flint.fmpq_poly]:
    """Return the distinct monic irreducible factors of a nonzero polynomial over ℚ."""
    _need_small(coefficients)
    factors = flint.fmpq_poly(list(coefficients)).factor()[1]
    return [g / g.leading_coefficient() for g, _ in factors]


def integral(g: flint.fmpq_poly, scale: int | None = None) -> flint.fmpz_poly:
    """Return a monic polynomial over ℤ whose roots are a multiple of those of a monic polynomial over ℚ.

    By default the multiple is by the common denominator, which always suffices.
    """
    n, scale = int(g.degree()), scale or int(g.denom())
    return flint.fmpz_poly([int((c * scale ** (n - k)).p) for k, c in enumerate(g.coeffs())])


def near_root(f: flint.fmpz_poly, p: int, digits: int = 0) -> int | None:
    """Return an r near a root in ℚ_p of a monic irreducible polynomial over ℤ; None if it has no root there.

    r agrees with the root in ``digits`` digits. Near means v(f(r)) > 2·v(f′(r)); then Newton's iteration
    converges to a root (Hensel's lemma). If v is the order of the discriminant, a root modulo p^(2v + 1) is
    near a root, because v(f′(r)) ≤ v whenever v(f(r)) > v. Raises :class:`UndecidedError` if there are too
    many candidates.
    """
    v, _ = remove(int(f.discriminant()), p)
    roots = residue_roots([int(c) for c in f.coeffs()], p ** (2 * v + 1 + digits))
    return roots[0] if roots else None


def residue_roots(coefficients: Sequence[int], n: int) -> list[int]:
    """Return the roots modulo n, sorted. They are found modulo primes by flint, lifted to prime powers, and
    combined.

    Raises :class:`UndecidedError` if the factors of n are not known, or there are too many roots.

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
    """Return the roots modulo pᵏ: modulo p first, then lifted one power at a time."""
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
            value, slope = horner(c, r, 0) // q % p, horner(derivative, r, 0) % p
            if slope:  # Hensel: one root above
                lifted.append((r - value * pow(slope, -1, p) * q) % above)
            elif value == 0:  # all p numbers above, or none
                if len(lifted) + p > MAX_LIFTS:
                    raise UndecidedError(f"there are more than {MAX_LIFTS} roots modulo {above}")
                lifted.extend(r + q * n for n in range(p))
        roots, q = lifted, above
    return roots


def horner(coefficients: Sequence[S], x: S, zero: S) -> S:
    """Return Σ cₙ·xⁿ, for coefficients from low to high."""
    total = zero
    for c in reversed(coefficients):
        total = total * x + c
    return total


def _need_small(coefficients: Sequence[Scalar]) -> None:
    if len(coefficients) > MAX_DEGREE + 1:
        raise UndecidedError(f"roots are not computed above the degree {MAX_DEGREE}")


def by_square_roots(ring: WithSquares[E], coefficients: Sequence[E]) -> list[list[E]]:
    """Factor a polynomial of degree 1 or 2, or of degree 4 in x², over a field in which square roots can be
    computed.

    In characteristic 0 the condition applies to the squarefree part of the polynomial.

    Raises :class:`UndecidedError` for others, and in characteristic 2 if roots are not computed.
    """
    *c, _ = monic(ring, coefficients)
    one, zero = ring.one, ring.zero
    if len(c) < 2:
        return [[*c, one]] if c else []
    if len(c) == 2 and ring.characteristic == 2 and not ring.is_zero(c[1]):
        roots = ring.roots([*c, one])
        return [[-x, one] for x in roots] or [[*c, one]]
    if len(c) == 2:
        n, p = c
        if ring.characteristic == 2:
            root = ring.sqrt(n)
            return [[*c, one]] if root is None else [[-root, one]]
        root = ring.sqrt(p * p - ring(4) * n)
        if root is None:
            return [[*c, one]]
        half = ring.inverse(ring(2))
        return distinct(ring, [[(p - root) * half, one], [(p + root) * half, one]])
    if ring.characteristic == 2 or len(c) != 4 or not all(map(ring.is_zero, c[1::2])):
        whole = [*c, one]
        if not ring.characteristic:
            slope = [ring(n) * x for n, x in enumerate(whole)][1:]
            multiple = common_divisor(ring, whole, slope)
            if len(multiple) > 1:
                return by_square_roots(ring, divided(ring, whole, multiple)[0])
        raise UndecidedError(
            f"a polynomial of degree {len(c)} over {ring.name} is not factored here: over others than number "
            "fields, fields of functions and finite fields, those of degree 2, and of degree 4 in x^2, are"
        )
    squares = by_square_roots(ring, [c[0], c[2], one])
    if all(len(f) == 2 for f in squares):  # (x² − y)·(x² − z)
        return [g for f in squares for g in by_square_roots(ring, [f[0], zero, one])]
    w = ring.sqrt(c[0])
    for n in () if w is None else (w, -w):  # (x² − t·x + n)·(x² + t·x + n)
        t = ring.sqrt(n + n - c[2])
        if t is not None:
            return [[n, -t, one], [n, t, one]]
    return [[*c, one]]


def monic(ring: Core[E], coefficients: Sequence[E]) -> list[E]:
    """Return the coefficients of a nonzero polynomial, divided by the leading coefficient."""
    c = stripped(ring, coefficients)
    back = ring.inverse(c[-1])
    return [x * back for x in c[:-1]] + [ring.one]


def distinct(ring: Core[E], factors: list[list[E]]) -> list[list[E]]:
    """Return factors without repetitions."""
    found: list[list[E]] = []
    for f in factors:
        if not any(len(f) == len(g) and all(map(ring.equal, f, g)) for g in found):
            found.append(f)
    return found


def of_flint(
    ring: Core[E], polynomial: Polynomial, read: Callable[[Coefficient], E]
) -> list[list[E]]:
    """Return the factors of a polynomial that flint finds, with coefficients converted to ring elements."""
    return [
        monic(ring, [read(factor[n]) for n in range(factor.degree() + 1)])
        for factor, _ in polynomial.factor()[1]
    ]


def divided(ring: Core[E], f: Sequence[E], g: Sequence[E]) -> tuple[list[E], list[E]]:
    """Return the quotient and the remainder, [] for 0, on division by a polynomial g with nonzero last
    coefficient.
    """
    rest, back = list(f), ring.inverse(g[-1])
    quotient: list[E] = []
    while len(rest) >= len(g):
        quotient.append(rest[-1] * back)
        for k, x in enumerate(g, len(rest) - len(g)):
            rest[k] = rest[k] - quotient[-1] * x
        rest.pop()
    return quotient[::-1], stripped(ring, rest)


def multiplied(ring: Core[E], f: Sequence[E], g: Sequence[E]) -> list[E]:
    """Return the product of two polynomials."""
    out = [ring.zero] * max(len(f) + len(g) - 1, 0)
    for m, x in enumerate(f):
        for n, y in enumerate(g, m):
            out[n] = out[n] + x * y
    return out


def added(ring: Core[E], f: Sequence[E], g: Sequence[E]) -> list[E]:
    """Return f + g."""
    return stripped(ring, [x + y for x, y in zip_longest(f, g, fillvalue=ring.zero)])


def quadratic_divisors(ring: WithSquares[E], f: Sequence[E]) -> Iterator[tuple[E, E]]:
    """Yield, each once, the (t, n) for which x² − t·x + n divides a nonzero polynomial over a field."""
    factors = ring.irreducible_factors(f)
    yield from ((-g[1], g[0]) for g in factors if len(g) == 3)
    roots = [-g[0] for g in factors if len(g) == 2]
    yield from ((r + s, r * s) for r, s in combinations(roots, 2))
    for r in roots:
        slope: E = ring.zero
        for n, c in reversed(list(enumerate(f))[1:]):
            slope = slope * r + c * ring(n)
        if ring.is_zero(slope):
            yield r + r, r * r


def substituted(ring: Core[E], f: Sequence[E], shift: E) -> list[E]:
    """Return f(x + shift)."""
    line, out = [shift, ring.one], [ring.zero]
    for c in reversed(f):
        out = multiplied(ring, out, line)
        out[0] = out[0] + c
    return stripped(ring, out)


def stripped(ring: Core[E], f: Sequence[E]) -> list[E]:
    """Return the coefficients without zeros at the end."""
    out = list(f)
    while out and ring.is_zero(out[-1]):
        out.pop()
    return out


def common_divisor(ring: Core[E], f: Sequence[E], g: Sequence[E]) -> list[E]:
    """Return the monic greatest common divisor; [] if both polynomials are 0."""
    one, two = stripped(ring, f), stripped(ring, g)
    while two:
        one, two = two, divided(ring, one, two)[1]
    return monic(ring, one) if one else []


def monic_root(field: Core[E], f: Sequence[E]) -> list[E] | None:
    """Return the monic g with g² = f for a monic f over a field, low degree first, or None.

    The characteristic is not 2. Starting from the highest, each coefficient of f determines one of g.
    """
    size, rest = divmod(len(f) - 1, 2)
    if rest:
        return None
    g, half = [field.zero] * size + [field.one], field.inverse(field(2))
    for k in range(size - 1, -1, -1):
        known = sum((g[n] * g[size + k - n] for n in range(k + 1, size)), field.zero)
        g[k] = half * (f[size + k] - known)
    product = multiplied(field, g, g)
    return g if all(map(field.equal, product, f)) else None
