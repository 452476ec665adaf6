"""What is true of a ring, computed from its data by elementary number theory, without prover and checker."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise
from math import comb, isqrt
from typing import Any

import sympy

from tests.adversary.names.arithmetic import (
    QQ,
    Galois,
    Poly,
    factors_modulo,
    monic,
    plus,
    rational,
    real_roots,
    squarefree_kernel,
    times,
)
from tests.adversary.names.numbers import Data, generator, modulus_of
from tests.adversary.names.places import NUMBER_FIELDS, galois_field

ASKED = (-1, 2, 3, 5)


@dataclass(frozen=True)
class Facts:
    """Texts in ``zero`` are 0 in the ring, those in ``nonzero`` are not; ``signs`` are those of the place.

    ``order`` is None for an infinite ring, ``degree`` that of a finite or a number field; ``squares`` tell
    which of −1, 2, 3, 5 are squares, None where that is not computed. At a place, ``residues`` counts the
    residue field, ``within`` have a positive valuation and ``units`` none.
    """

    characteristic: int
    order: int | None
    degree: int | None
    squares: tuple[bool | None, ...]
    zero: tuple[str, ...] = ()
    nonzero: tuple[str, ...] = ()
    residues: int | None = None
    within: tuple[str, ...] = ()
    units: tuple[str, ...] = ()
    signs: tuple[tuple[str, int], ...] = ()


def facts(data: Data) -> Facts:
    """Return the facts about a ring. Raises ``Unsure``."""
    kind = data["kind"]
    if kind == "residues":
        return _of_residues(data["modulus"])
    if kind == "finite field":
        return _of_finite_field(data)
    if kind == "completion":
        return _of_completion(data["of"], data["place"])
    squares = tuple(_is_square(n, data) for n in ASKED)
    if kind in ("rational functions", "polynomials", "extension"):
        below = facts(data["base"])
        if kind == "extension":
            return Facts(below.characteristic, None, None, (None,) * 4, below.zero)
        nonzero = tuple(text for v in data["variables"] for text in _relations(v))
        return Facts(below.characteristic, None, None, squares, below.zero, nonzero)
    zero, nonzero, degree = _constants(data)
    return Facts(0, None, degree, squares, zero, (*nonzero, "2", "3", "5"))


def _relations(v: str) -> list[str]:
    """Relations that numbers satisfy which a variable might be taken for."""
    unity = [f"{v}^{n}-1" for n in (1, 2, 3, 5, 7, 8, 9, 12)]
    return [v, *unity, *(f"{v}^2-{n}" for n in (2, 3, 5, 7, 8)), f"{v}^2+1", f"{v}^3-2"]


def polynomial(f: Sequence[Any], name: str) -> str:
    """Write a polynomial for the rings to read."""
    return "+".join(f"({c})*({name})^{n}" for n, c in enumerate(f) if c) or "0"


def _constants(data: Data) -> tuple[tuple[str, ...], tuple[str, ...], int | None]:
    """Return relations of the constants of a field of numbers, what is none, and the degree."""
    kind = data["kind"]
    if kind == "reals":
        return ("sqrt(2)*sqrt(3)-sqrt(6)", "sqrt(8)-2*sqrt(2)"), ("sqrt(2)+sqrt(3)",), None
    if kind == "complexes":
        return ("I^2+1", "sqrt(-2)-I*sqrt(2)"), ("I+1",), None
    if kind == "multiquadratic field":
        roots = [root(n) for n in data["d"]]
        zero = tuple(f"({r})^2-({n})" for r, n in zip(roots, data["d"], strict=True))
        return zero, (f"{roots[0]}+2*{roots[1]}",), 2 ** len(_independent(tuple(data["d"])))
    if kind not in (*NUMBER_FIELDS, "quadratic field"):
        return (), (), None
    f, name = modulus_of(data), generator(data)
    smaller = [polynomial(f[1:], name), *(f"({name})^2-({n})" for n in (2, -1) if len(f) > 3)]
    return (polynomial(f, name),), tuple(smaller), len(f) - 1


def root(n: int) -> str:
    """Write the square root of a whole number."""
    return "I" if n == -1 else f"sqrt({n})"


def _of_residues(n: int) -> Facts:
    squares = {x * x % n for x in range(n)} if n < 3000 else None
    known = tuple(None if squares is None else m % n in squares for m in ASKED)
    p = min(sympy.primefactors(n)) if n < 10**12 else 1
    return Facts(n, n, None, known, (str(n),), (str(n // p if p < n else 1),))


def _of_finite_field(data: Data) -> Facts:
    p, n = data["characteristic"], data["degree"]
    squares = tuple(_in_finite(m, p, n) for m in ASKED)
    zero, nonzero = [str(p)], ["1"]
    if data["modulus"] is not None:
        zero.append(polynomial(data["modulus"], "x"))
        nonzero += [f"x^{p ** (n // r)}-x" for r in sympy.primefactors(n) if p**n <= 4096]
    return Facts(p, p**n, n, squares, tuple(zero), tuple(nonzero))


def _in_finite(m: int, p: int, n: int) -> bool:
    return p == 2 or n % 2 == 0 or m % p == 0 or pow(m, (p - 1) // 2, p) == 1


def _rational_square(x: Fraction) -> bool:
    return x >= 0 and all(isqrt(n) ** 2 == n for n in (x.numerator, x.denominator))


def _independent(numbers: tuple[int, ...]) -> list[set[int]]:
    """Return square classes, as sets of primes and −1, that generate those of all numbers."""
    found: list[set[int]] = []
    for n in numbers:
        rest = _class(n)
        for known in found:
            rest = min(rest, rest ^ known, key=lambda s: sorted(s, reverse=True))
        if rest:
            found.append(rest)
    return found


def _class(n: int) -> set[int]:
    d = squarefree_kernel(n)
    return {*sympy.primefactors(d), *([-1] if d < 0 else [])}


@cache
def _over(m: int, f: Poly) -> bool:
    """Tell whether √m is in ℚ[X]/(f): whether f is reducible over ℚ(√m), by Trager's norm of f(X − k·√m)."""
    for k in range(1, 50):
        a, b = _shifted(f, k, m)
        whole = plus(QQ, times(QQ, a, a), tuple(-m * c for c in times(QQ, b, b)))
        factors = rational(whole).factor_list()[1]
        if all(e == 1 for _, e in factors):
            return len(factors) > 1
    raise AssertionError("some shift is squarefree")


def _shifted(f: Poly, k: int, m: int) -> tuple[Poly, Poly]:
    """Return (a, b) with f(X − k√m) = a + b·√m."""
    parts = [[Fraction(0)] * len(f) for _ in range(2)]
    for n, c in enumerate(f):
        for j in range(n + 1):
            parts[j % 2][n - j] += c * comb(n, j) * (-k) ** j * m ** (j // 2)
    a, b = (plus(QQ, tuple(part), ()) for part in parts)
    return a, b


def _is_square(m: int, data: Data) -> bool | None:
    """Tell whether m is a square in a ring of characteristic 0, or in functions over any."""
    kind, x = data["kind"], Fraction(m)
    if kind in ("rationals", "integers"):
        return _rational_square(x)
    if kind in ("reals", "complexes"):
        return kind == "complexes" or m >= 0
    if kind == "finite field":
        return _in_finite(m, data["characteristic"], data["degree"])
    if kind == "residues":
        return None
    if kind in ("rational functions", "polynomials"):
        return _is_square(m, data["base"])
    if kind == "quadratic field":
        return _rational_square(x) or _rational_square(x / data["d"])
    if kind == "multiquadratic field":
        known = _independent(tuple(data["d"]))
        return len(_independent((*data["d"], m))) == len(known)
    if kind in ("cyclotomic field", "real cyclotomic field"):
        conductor = {-1: 4, 2: 8, 3: 12, 5: 5}[m]
        return data["order"] % conductor == 0 and (kind[0] == "c" or m > 0)
    if kind in NUMBER_FIELDS:
        f = modulus_of(data)
        return _over(m, f) if len(f) < 12 else None
    return None


# --- places --------------------------------------------------------------------------------------


def _of_completion(field: Data, place: Data) -> Facts:
    whole, kind = facts(field), place["kind"]
    if kind == "complex":
        return _changed(whole, (True,) * 4)
    if kind == "real":
        return _changed(whole, tuple(m > 0 for m in ASKED), signs=_signs(field, place["number"]))
    if field["kind"] == "rational functions":
        return _of_functions(whole, field, place)
    if kind == "prime ideal":
        return _at_ideal(whole, field, place)
    return _above_number(whole, field, place)


def _changed(whole: Facts, squares: tuple[bool | None, ...], **more: Any) -> Facts:
    return Facts(whole.characteristic, None, None, squares, whole.zero, whole.nonzero, **more)


def _signs(field: Data, number: int) -> tuple[tuple[str, int], ...]:
    """Return signs of the generator less some numbers, those between the roots first of all."""
    name = generator(field)
    roots = real_roots(modulus_of(field))
    between = [Fraction(int(1000 * (a + b) / 2), 1000) for a, b in pairwise(roots)]
    at = roots[number]
    far = [c for c in (*between, Fraction(0), Fraction(1), Fraction(-2)) if abs(c - at) > 1e-3]
    return tuple((f"{name}-({c})", 1 if at > c else -1) for c in far)


def _of_functions(whole: Facts, field: Data, place: Data) -> Facts:
    (v,), K = field["variables"], galois_field(field["base"])
    if place["kind"] == "infinity":
        squares = tuple(_in_finite(m, K.p, K.degree) for m in ASKED)
        return _changed(
            whole, squares, residues=K.order, within=(f"1/{v}",), units=(f"({v}+1)/{v}", "1")
        )
    coefficients = place["coefficients"]
    degree = len(coefficients) - 1
    texts = [f"({polynomial(c, 'x') if isinstance(c, list) else c})" for c in coefficients]
    text = "+".join(f"{c}*{v}^{n}" for n, c in enumerate(texts))
    squares = tuple(_in_finite(m, K.p, K.degree * degree) for m in ASKED)
    inside = (text, f"({text})*({v}+1)")
    return _changed(
        whole, squares, residues=K.order**degree, within=inside, units=(f"{text}+1", "1")
    )


def _p_adic_square(x: Fraction, p: int) -> bool:
    """Tell whether x ≠ 0 is a square in ℚ_p."""
    n, order = x.numerator * x.denominator, 0
    while n % p == 0:
        n, order = n // p, order + 1
    unit = n % 8 == 1 if p == 2 else pow(n, (p - 1) // 2, p) == 1
    return order % 2 == 0 and unit


def _above_number(whole: Facts, field: Data, place: Data) -> Facts:
    """A place of ℚ or ℚ(√d): where p does not split, the completion is ℚ_p(√d)."""
    p = place["n"]
    squares: list[bool | None] = [_p_adic_square(Fraction(m), p) for m in ASKED]
    if field["kind"] == "rationals":
        return _changed(
            whole, tuple(squares), residues=p, within=(str(p),), units=(str(p + 1), f"1/{p - 1}")
        )
    d, name = field["d"], generator(field)
    if place["kind"] == "split":
        r = place["root"]
        signs = [f"({name}{sign}{r})/{1 + (p == 2)}" for sign in "-+"]
        return _changed(
            whole, tuple(squares), residues=p, within=(signs[0], str(p)), units=(signs[1], "1")
        )
    squares = [s or _p_adic_square(Fraction(m, d), p) for s, m in zip(squares, ASKED, strict=True)]
    ramified = d % 4 != 1 if p == 2 else d % p == 0
    inside, unit = [str(p)] + [f"{name}-({d})"] * ramified, f"{name}*{p}+1"
    return _changed(
        whole,
        tuple(squares),
        residues=p if ramified else p * p,
        within=tuple(inside),
        units=(unit,) if ramified else (unit, name),
    )


def _at_ideal(whole: Facts, field: Data, place: Data) -> Facts:
    """A prime ideal (p, g(s)), where ℤ[s] is maximal: residues of degree f, ramified e times."""
    p, f, name = place["p"], modulus_of(field), generator(field)
    K = Galois(p)
    given = f if place["element"] is None else tuple(map(Fraction, place["element"]))
    reduced = plus(K, tuple(K.number(c) for c in given), ())
    g = tuple(c[0] for c in monic(K, reduced))
    factors = dict(factors_modulo(f, p))
    residues, e = len(g) - 1, factors[g]
    squares = [_in_local_field(m, p, e, residues) for m in ASKED]
    others = [polynomial(h, name) for h in factors if h != g]
    return _changed(
        whole,
        tuple(squares),
        residues=p**residues,
        within=(str(p), *([polynomial(g, name)] if place["element"] else [])),
        units=("1", *others),
    )


def _in_local_field(m: int, p: int, e: int, f: int) -> bool | None:
    """Tell whether m is a square in a field over ℚ_p, ramified e times, with residues of degree f."""
    if _p_adic_square(Fraction(m), p):
        return True
    if e * f % 2:
        return False  # √m would generate a field of degree 2
    if m % p == 0:
        return False if e % 2 else None
    if p > 2:
        return f % 2 == 0
    # Over ℚ₂ the unramified extension of degree 2 is that by √5; the other ones are ramified.
    if e == 1:
        return m % 8 == 5
    return None
