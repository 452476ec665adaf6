"""Zeros of diagonal quadratic forms over ℚ in four and more variables.

Four variables: ``a·x² + b·y² = t = −(c·z² + d·w²)`` for a t that both sides represent; the local
classes such a t may have are found place by place, and Dirichlet's theorem gives a t = (bad
primes)·(one new prime), at which reciprocity takes care of itself: Serre, *A Course in
Arithmetic*, chapter IV, §3, proof of theorem 8 (Hasse and Minkowski). Five and more: fix the first
two variables so that the rest becomes isotropic.
"""

import itertools
import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from hfield.errors import UndecidedError
from hfield.factorisation import factorise, remove
from hfield.fields.rationals.conics import solve_conic
from hfield.fields.rationals.places import INFINITE, Place
from hfield.fields.rationals.symbols import hilbert_symbol_q
from hfield.primality import is_prime
from hfield.rings.whole_numbers import crt, squarefree

Zero = list[Fraction]


def isotropic_vector(form: Sequence[int | Fraction]) -> Zero | None:
    """Return a nontrivial rational zero of ``Σ form[i]·x[i]²``, at least four terms, or None."""
    classes, scale = [], []
    for f in form:
        if not f:
            return _unit(len(form), form.index(f))
        m, s, _ = squarefree(f.numerator * f.denominator)
        classes.append(m)
        scale.append(Fraction(f.denominator, s))  # f·(x·scale)² = m·x²
    found = _zero(classes)
    return None if found is None else [x * s for x, s in zip(found, scale, strict=True)]


def _unit(size: int, index: int) -> Zero:
    return [Fraction(int(i == index)) for i in range(size)]


def _zero(form: list[int]) -> Zero | None:
    for i, j in itertools.combinations(range(len(form)), 2):
        if form[i] == -form[j]:  # squarefree: opposite classes are opposite numbers
            found = [Fraction(0)] * len(form)
            found[i] = found[j] = Fraction(1)
            return found
    if all(f > 0 for f in form) or all(f < 0 for f in form):
        return None
    if len(form) == 4:
        return _four(form)
    return _more(form)


def _four(form: list[int]) -> Zero | None:
    a, b, c, d = form
    places = _bad_places(form)
    t = _common_value(form, places)
    if t is None:
        return None
    primes = {p for p in places if isinstance(p, int)} | set(
        factorise(t, [p for p in places if isinstance(p, int)])
    )
    x, y, r = _represent(a, b, t, primes)
    z, w, s = _represent(c, d, -t, primes)
    return [x * s, y * s, z * r, w * r]


def _represent(a: int, b: int, t: int, primes: set[int]) -> tuple[Fraction, Fraction, Fraction]:
    """Return ``(x, y, r)`` with ``a·x² + b·y² = t·r²``."""
    # a·t·(x/t)² + b·t·(y/t)² = r²
    x, y, r = solve_conic(a * t, b * t, primes)
    return x * t, y * t, r


def _bad_places(form: Sequence[int]) -> list[Place]:
    primes = {2}.union(*(factorise(f) for f in form))
    return [INFINITE, *sorted(primes)]


def _common_value(form: list[int], places: list[Place]) -> int | None:
    """Return a t that ⟨a, b⟩ and ⟨−c, −d⟩ both represent over ℚ, or None when there is none."""
    local = [_local_classes(form, v) for v in places]
    if not all(local):
        return None
    for t in _small_values(places):
        if all(_fits(form, t, v) for v in places) and all(
            _fits(form, t, p) for p in factorise(t) if p not in places
        ):
            return t
    # one class at each place, one new prime to fit them all
    signs, *classes = [choices[0] for choices in local]
    primes = [p for p in places if isinstance(p, int)]
    t = signs * math.prod(p for p, u in zip(primes, classes, strict=True) if remove(u, p)[0])
    conditions = []
    for p, u in zip(primes, classes, strict=True):
        modulus = 8 if p == 2 else p
        rest, unit = remove(t, p)[1], remove(u, p)[1]
        conditions.append((unit * pow(rest, -1, modulus) % modulus, modulus))
    start, step = crt(conditions)
    q = start
    while not (is_prime(q) and q not in primes):
        q += step
    return t * q


def _small_values(places: list[Place]) -> Iterator[int]:
    primes = [p for p in places if isinstance(p, int)][:6]
    for q in (1, 3, 5, 7, 11, 13, 17, 19, 23, 29):
        if q == 1 or q not in primes:
            for size in range(len(primes) + 1):
                for chosen in itertools.combinations(primes, size):
                    t = q * math.prod(chosen)
                    yield from (t, -t)


def _fits(form: list[int], t: int, v: Place) -> bool:
    """Tell whether ⟨a, b⟩ represents t and ⟨c, d⟩ represents −t over the completion at v."""
    a, b, c, d = form
    return hilbert_symbol_q(t, -a * b, v) == hilbert_symbol_q(a, b, v) and hilbert_symbol_q(
        -t, -c * d, v
    ) == hilbert_symbol_q(c, d, v)


def _local_classes(form: list[int], v: Place) -> list[int]:
    """Return representatives of the square classes at v that a common value may have."""
    if v == INFINITE:
        classes = [1, -1]
    elif v == 2:
        classes = [1, 3, 5, 7, 2, 6, 10, 14]
    else:
        assert isinstance(v, int)
        n = next(r for r in range(2, v) if pow(r, (v - 1) // 2, v) != 1)
        classes = [1, n, v, n * v]
    return [t for t in classes if _fits(form, t, v)]


def _more(form: list[int]) -> Zero:
    """Solve an indefinite form in at least five variables: it has a zero (Meyer)."""
    order = sorted(range(len(form)), key=lambda i: form[i])
    for chosen, xs in _heads(form, order):
        value = sum(form[i] * x * x for i, x in zip(chosen, xs, strict=True))
        tail = [i for i in range(len(form)) if i not in chosen]
        solution = isotropic_vector([value, *(form[i] for i in tail)])
        if solution is not None:
            found = [Fraction(0)] * len(form)
            for i, n in zip(chosen, xs, strict=True):
                found[i] = solution[0] * n
            for i, y in zip(tail, solution[1:], strict=True):
                found[i] = y
            return found
    raise UndecidedError(f"no zero of the form {form} was found by fixing small values")


def _heads(form: list[int], order: list[int]) -> Iterator[tuple[list[int], list[int]]]:
    """Run through indices, with the least coefficient among them, and small values for these.

    The least variable is taken small, so large that the value becomes negative, and divisible by a
    prime of the coefficients, where a local condition may ask for that.
    """
    least = order[0]
    choices = list(itertools.combinations(order[1:-1], len(form) - 4))
    primes = [1, *sorted(set().union(*(factorise(f) for f in form)))]
    for k in range(1, 25):
        for heads in choices:
            for xs in itertools.product(range(4), repeat=len(heads)):
                value = sum(form[i] * x * x for i, x in zip(heads, xs, strict=True))
                balance = math.isqrt(max(value, 0) // -form[least])
                for p in primes[: 1 + k // 2]:
                    for shift in {0, balance // p * p}:
                        yield [*heads, least], [*xs, k * p + shift]


def diagonalise(gram: list[list[Fraction]]) -> tuple[list[Fraction], list[Zero]]:
    """Return the diagonal of a nondegenerate symmetric matrix and the rows of an orthogonal basis."""
    n = len(gram)

    def pair(u: Zero, v: Zero) -> Fraction:
        return sum((u[i] * gram[i][j] * v[j] for i in range(n) for j in range(n)), Fraction(0))

    rest = [_unit(n, i) for i in range(n)]
    values: list[Fraction] = []
    basis: list[Zero] = []
    while rest:
        for i, j in itertools.combinations(range(len(rest)), 2):
            if not any(pair(u, u) for u in rest):
                rest[i] = [x + y for x, y in zip(rest[i], rest[j], strict=True)]
        v = next(u for u in rest if pair(u, u))
        size = pair(v, v)
        rest.remove(v)
        rest = [[x - pair(u, v) / size * y for x, y in zip(u, v, strict=True)] for u in rest]
        values.append(size)
        basis.append(v)
    return values, basis
