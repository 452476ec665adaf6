"""Formulas over GF(q) and ℤ/n for the numbers of units, nilpotents, idempotents, roots and elements of norm
n.

All counts follow from the number of elements with a given norm, alone or with trace 0 or 1, because an
element satisfies ``x² = tr(x)·x − N(x)``. It is nilpotent if trace and norm are 0. It is idempotent if it is
0 or 1, or has trace 1 and norm 0. Its square is s if it is a scalar root of s, or has trace 0 and norm −s.
The formulas hold for every (a, t, b), including degenerate algebras and characteristic 2.

Over ℤ/n the counts are products over the prime powers of n, by the Chinese remainder theorem. Modulo pᵏ, the
numbers of units and nilpotents are those over GF(p) times ``p⁴⁽ᵏ⁻¹⁾``. An idempotent other than 0 and 1 has
``p²⁽ᵏ⁻¹⁾`` lifts, all conjugate, because its centraliser has rank 2. Solutions of quadratic equations are
counted by Hensel's lemma if some coordinate with a unit coefficient is a unit; otherwise both sides are
divided by p. Only residues modulo 8 are enumerated.
"""

from collections.abc import Sequence
from math import prod
from typing import NamedTuple

import flint

from hfield.algebra.structure.counting.counted_kinds import counted_kind
from hfield.core.factorisation import factorise
from hfield.core.product import Constants, Scalar
from hfield.errors import NotFiniteError, TooLargeError
from hfield.fields.base.modular import Modular
from hfield.fields.base.ring import Ring
from hfield.fields.finite.ring import PrimeField
from hfield.fields.quadratic_forms.normal_forms import discriminant, normal_form


class Count(NamedTuple):
    """A number, and the formula in q from which it was computed."""

    value: int
    formula: str


class _Shape(NamedTuple):
    """The type of the norm form: ``split``, ``binary+``, ``binary-``, ``line`` or ``additive``."""

    kind: str
    slot: Scalar | None = None  # for a binary form in odd characteristic, the a of w² − a·x²


def count(ring: Ring, c: Constants, kind: str, value: object = None) -> Count:
    """Return the number of elements of one of the kinds in ``counted_kinds``, by closed formula.

    ``value`` is the norm (default 0) or the scalar whose square roots are counted (default 1). Raises
    :class:`NotFiniteError` unless the ring is a finite field or ℤ/n, :class:`CoercionError` for an unknown
    kind, and :class:`UndecidedError` for an n that cannot be factored.
    """
    if not has_formulas(ring):
        raise NotFiniteError(
            f"{ring.name} is neither a finite field nor ZZ/n: expected one, such as GF(9) or ZZ/6"
        )
    kind = counted_kind(kind).name
    assert ring.order is not None
    q = int(ring.order)
    if kind == "elements":
        return Count(q**4, "q^4" if ring.is_field else "n^4")
    if not ring.is_field:
        n = ring((kind == "square roots") if value is None else value)
        parts = _modulo_prime_powers(ring, c, kind, int(n))
        return Count(prod(parts), "*".join(map(str, parts)))
    shape = _shape(ring, c)
    if kind == "norm":
        return _norm(ring, shape, q, ring(0 if value is None else value))
    if kind == "units":
        zero = _norm(ring, shape, q, ring.zero)
        return Count(q**4 - zero.value, f"q^4-({zero.formula})")
    if kind == "nilpotent":
        return _traceless(ring, shape, q, ring.zero)
    if kind == "idempotent":
        return _idempotents(shape, q)
    assert kind == "square roots", kind
    return _square_roots(ring, shape, q, ring(1 if value is None else value))


def has_formulas(ring: Ring) -> bool:
    """Return whether there are closed formulas: over a finite field and over ℤ/n."""
    return ring.order is not None and (ring.is_field or isinstance(ring, Modular))


def _over_prime(c: Constants, p: int, kind: str) -> int:
    """Count modulo a prime divisor p of n."""
    field = PrimeField(p)
    return count(field, Constants(*(field(int(x)) for x in c)), kind).value


def _shape(ring: Ring, c: Constants) -> _Shape:
    if not ring.is_zero(discriminant(ring, c)):
        return _Shape("split")
    if ring.characteristic == 2:
        if ring.is_zero(c.t):
            return _Shape("additive")
        root = _artin_schreier(ring, normal_form(ring, c).a)
        return _Shape("binary+" if root else "binary-")
    slot = next((x for x in normal_form(ring, c).constants if not ring.is_zero(x)), None)
    if slot is None:
        return _Shape("line")
    return _Shape("binary-" if ring.sqrt(slot) is None else "binary+", slot)


def _artin_schreier(ring: Ring, a: Scalar) -> bool:
    """Return whether y² + y = a is solvable in GF(2ⁿ): whether the trace of a is 0."""
    assert ring.order is not None
    total = x = a
    for _ in range(ring.order.bit_length() - 2):
        x = x * x
        total = total + x
    return ring.is_zero(total)


def _norm(ring: Ring, shape: _Shape, q: int, n: Scalar) -> Count:
    """Count the elements of norm n."""
    zero = ring.is_zero(n)
    if shape.kind == "split":
        return Count(q**3 + q**2 - q, "q^3+q^2-q") if zero else Count(q**3 - q, "q^3-q")
    if shape.kind == "additive":
        return Count(q**3, "q^3")
    if shape.kind == "line":
        if zero:
            return Count(q**3, "q^3")
        return Count(0, "0") if ring.sqrt(n) is None else Count(2 * q**3, "2*q^3")
    if shape.kind == "binary+":
        return (
            Count((2 * q - 1) * q**2, "(2*q-1)*q^2") if zero else Count((q - 1) * q**2, "(q-1)*q^2")
        )
    return Count(q**2, "q^2") if zero else Count((q + 1) * q**2, "(q+1)*q^2")


def count_trace_and_norm(ring: Ring, c: Constants, t: Scalar, n: Scalar) -> int:
    """Return the number of elements of trace t and norm n in an algebra over a finite field."""
    assert ring.order is not None
    shape, q = _shape(ring, c), int(ring.order)
    if ring.characteristic != 2:
        half = ring.divide(t, ring(2))
        return _traceless(ring, shape, q, half * half - n).value
    if ring.is_zero(t):
        return _traceless(ring, shape, q, n).value
    if shape.kind == "additive":
        return 0
    m = ring.divide(n, t * t)  # t times a root of y² + y = m
    if shape.kind == "split":
        return q**2 + q if _artin_schreier(ring, m) else q**2 - q
    return 2 * q**2 if _artin_schreier(ring, m + normal_form(ring, c).a) else 0


def _traceless(ring: Ring, shape: _Shape, q: int, s: Scalar) -> Count:
    """Count the elements of trace 0 and norm −s."""
    zero, even = ring.is_zero(s), ring.characteristic == 2
    if shape.kind == "additive" or (shape.kind == "line" and zero):
        return Count(q**3, "q^3")
    if shape.kind == "line":
        return Count(0, "0")
    if zero or even:
        return Count(q**2, "q^2")
    if shape.kind == "split":
        # a ternary form of discriminant a square: −s is a norm of trace 0 in q² + q or q² − q ways
        return Count(q**2 + q, "q^2+q") if ring.sqrt(s) is not None else Count(q**2 - q, "q^2-q")
    assert shape.slot is not None, "the norm form is binary"
    return Count(0, "0") if ring.sqrt(s * shape.slot) is None else Count(2 * q**2, "2*q^2")


def _idempotents(shape: _Shape, q: int) -> Count:
    if shape.kind == "split":
        return Count(q**2 + q + 2, "q^2+q+2")
    return Count(2 * q**2 + 2, "2*q^2+2") if shape.kind == "binary+" else Count(2, "2")


def _square_roots(ring: Ring, shape: _Shape, q: int, s: Scalar) -> Count:
    traceless = _traceless(ring, shape, q, s)
    if ring.characteristic == 2 or ring.is_zero(s) or ring.sqrt(s) is None:
        return traceless
    return Count(traceless.value + 2, "2" if not traceless.value else f"{traceless.formula}+2")


LARGEST_EXPONENT = 64
"""The greatest k for which square roots modulo pᵏ are counted: the work grows like k²."""


class CountingFormula(NamedTuple):
    """The form ``Σ d·x² + Σ c·(y² + t·yz − a·z²)`` modulo pᵏ; the second sum only for p = 2 and odd t."""

    p: int
    unary: tuple[int, ...]
    binary: tuple[int, ...] = ()
    t: int = 0
    a: int = 0

    @property
    def variables(self) -> int:
        """The number of variables."""
        return len(self.unary) + 2 * len(self.binary)

    def over(self, unary: Sequence[int], binary: Sequence[int]) -> "CountingFormula":
        """Return the form with other coefficients."""
        return CountingFormula(self.p, tuple(unary), tuple(binary), self.t, self.a)


def solutions(form: CountingFormula, k: int, v: int) -> int:
    """Return the number of representations of v by the form modulo pᵏ.

    A solution lifts from p to pᵏ (from 8 to 2ᵏ) in ``p^((k−1)(r−1))`` ways, for r variables, if some variable
    with a unit coefficient is a unit. In the other solutions all these variables are multiples of p, and so
    is v; then everything is divided by p.
    """
    p, r = form.p, form.variables
    start = 3 if p == 2 else 1
    total: int = 0
    scale: int = 1
    while k > 0:
        modulus = p**k
        v %= modulus
        form = form.over([d % modulus for d in form.unary], [c % modulus for c in form.binary])
        if k < start:
            return total + scale * _values(form, modulus)[v]
        total += scale * _smooth(form, v % p**start) * p ** ((k - start) * (r - 1))
        if v % p:
            return total
        free = sum(d % p == 0 for d in form.unary) + 2 * sum(c % p == 0 for c in form.binary)
        scale *= p**free
        divided = [[d * p if d % p else d // p for d in part] for part in (form.unary, form.binary)]
        form, v, k = form.over(*divided), v // p, k - 1
    return total + scale


def _smooth(form: CountingFormula, v: int) -> int:
    """Count the solutions modulo p, or 8, in which some variable with a unit coefficient is a unit."""
    p = form.p
    if p == 2:
        even = form.over(
            [4 * d if d % 2 else d for d in form.unary],
            [4 * c if c % 2 else c for c in form.binary],
        )
        # of 8 values of a variable 4 are even, and 4·d·y² takes each of its values for two y modulo 4
        odd = sum(d % 2 for d in form.unary) + 2 * sum(c % 2 for c in form.binary)
        return _values(form, 8)[v] - (_values(even, 8)[v] >> odd)
    units = [d for d in form.unary if d % p]
    found = _field_solutions(p, units, v) - (v % p == 0)
    return found * int(p ** (len(form.unary) - len(units)))


def _field_solutions(p: int, units: list[int], v: int) -> int:
    """Count the solutions of ``Σ d·x² = v`` over GF(p), p odd (Lidl, Niederreiter, 6.26 and 6.27)."""
    r, half = len(units), len(units) // 2
    if r == 0:
        return int(v % p == 0)
    sign = prod(units) * (-1) ** half
    if r % 2:
        return int(p ** (r - 1) + p**half * _legendre(sign * v, p))
    excess = p**half - p ** (half - 1) if v % p == 0 else -(p ** (half - 1))
    return int(p ** (r - 1) + excess * _legendre(sign, p))


def _legendre(x: int, p: int) -> int:
    return int(flint.fmpz(x % p).jacobi(p))


def _values(form: CountingFormula, modulus: int) -> list[int]:
    """Return the number of times that each residue is a value of the form, modulo 2, 4 or 8."""
    parts = []
    for d in form.unary:
        parts.append([d * x * x for x in range(modulus)])
    for c in form.binary:
        t, a = form.t, form.a
        parts.append(
            [c * (y * y + t * y * z - a * z * z) for y in range(modulus) for z in range(modulus)]
        )
    total = [1] + [0] * (modulus - 1)
    for values in parts:
        counts = [0] * modulus
        for value in values:
            counts[value % modulus] += 1
        total = [
            sum(total[u] * counts[(w - u) % modulus] for u in range(modulus))
            for w in range(modulus)
        ]
    return total


def _modulo_prime_powers(ring: Ring, c: Constants, kind: str, value: int) -> list[int]:
    """Return the counts modulo the prime powers of n, whose product is the count over ℤ/n.

    Raises :class:`UndecidedError` if n cannot be factored, and :class:`TooLargeError` for square roots modulo
    pᵏ with k beyond :data:`LARGEST_EXPONENT`.
    """
    a, t, b = (int(x) for x in c)
    parts = []
    for p, k in factorise(ring.characteristic).items():
        if kind == "norm":
            parts.append(solutions(_norm_form(p, k, a, t, b), k, value))
        elif kind == "square roots":
            if k > LARGEST_EXPONENT:
                raise TooLargeError(
                    f"square roots modulo {p}^{k} are not counted: exponents up to {LARGEST_EXPONENT} are"
                )
            roots = _roots_odd_trace if p == 2 and t % 2 else _roots
            parts.append(roots(p, k, a, t, b, value))
        elif kind == "idempotent":
            parts.append(2 + (_over_prime(c, p, kind) - 2) * p ** (2 * (k - 1)))
        else:
            assert kind in ("units", "nilpotent"), kind
            parts.append(_over_prime(c, p, kind) * p ** (4 * (k - 1)))
    return parts


def _norm_form(p: int, k: int, a: int, t: int, b: int) -> CountingFormula:
    """Return the norm form, diagonal if the square of i − t/2 can be completed."""
    if p == 2 and t % 2:
        return CountingFormula(p, (), (1, -b), t, a)
    a = _completed(p, k, a, t)
    return CountingFormula(p, (1, -a, -b, a * b))


def _completed(p: int, k: int, a: int, t: int) -> int:
    """Return the square of ``i − t/2``, for t even or p odd."""
    half = t // 2 if p == 2 else t * pow(2, -1, p**k)
    return a + half * half


def _roots(p: int, k: int, a: int, t: int, b: int, s: int) -> int:
    """Count the square roots of s modulo pᵏ, for t even or p odd, where t = 0 may be assumed.

    ``(w + v)² = w² + v² + 2w·v`` for a vector v of trace 0. If v is pᵐ times a primitive vector, then pʰ
    divides w with ``h = k − m``, or one less for p = 2. Vectors that are not primitive are pᵐ⁺¹ times
    arbitrary ones.
    """
    a = _completed(p, k, a, t)
    total = 0
    for m in range(k + 1):
        h = max(k - m - (p == 2), 0)
        for n, sign in ((m, 1), (m + 1, -1)):
            if n <= k:
                q = p ** (2 * n)
                form = CountingFormula(p, (p ** (2 * h), q * a, q * b, -q * a * b))
                total += sign * (solutions(form, k, s) // p ** (h + 3 * n))
    return total


def _roots_odd_trace(p: int, k: int, a: int, t: int, b: int, s: int) -> int:
    """Count the square roots of s modulo 2ᵏ for odd t.

    For ``q = w + xi + β·j`` with trace ``T = 2w + tx``, the equation q² = s means ``Tβ = 0``, ``T(T − 2w) =
    0`` and ``D·w² − a·T² + t²b·N(β) = t²s`` with ``D = t² + 4a``. With T = 2ʲτ, τ odd, this gives ``β =
    2ᵏ⁻ʲγ`` and ``w = 2ʲ⁻¹τ + 2ᵏ⁻ʲ⁻¹u``, and the only mixed term of the last equation is ``2ᵏ⁻¹u``.
    """
    d, u, goal = t * t + 4 * a, t * t, t * t * s
    total = solutions(CountingFormula(p, (d,), (u * b,), t, a), k, goal)  # T = 0
    for j in range(1, k):
        rest = k - j
        taus = ((u * 4 ** (j - 1), j, 1), (u * 4**j, j + 1, -1))  # all τ less the even ones
        some = (
            (d * 4**rest, rest, 1, 0),  # u even
            (d * 4 ** (rest - 1), rest - 1, 1, 2 ** (k - 1)),  # u odd: all u less the even ones
            (d * 4**rest, rest, -1, 2 ** (k - 1)),
        )
        for x, m, sign in taus:
            for y, n, other, shift in some:
                form = CountingFormula(p, (x, y), (4**rest * u * b,), t, a)
                found = solutions(form, k, goal - shift)
                total += sign * other * (found // 2 ** (m + n + 2 * rest))
    return total
