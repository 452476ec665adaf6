"""Algebraic numbers as polynomials over ℚ in one root α of an irreducible polynomial.

Numbers of one field ℚ(α) are added, multiplied, divided and compared with 0 modulo the polynomial of α. Each
is also a root of its own minimal polynomial, given by its number among the roots. That form is used for
writing it and for comparing it with numbers of other fields. All other operations between fields use the
expressions of :mod:`.closed_forms`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import flint

from hfield.fields.algebraic.closed_forms import Closed, number
from hfield.fields.algebraic.polynomial_roots import Root, read
from hfield.fields.algebraic.surds import Surd, as_surd, from_rational, sqrt_rational, sympy_of
from hfield.fields.base.balls import Enclosure, fingerprint, precision
from hfield.fields.base.isolated_roots import isolated_roots

if TYPE_CHECKING:
    import sympy

Numbered = tuple[int, ...]  # (n, c₀, …, c_d), the n-th root of Σ cₖ·xᵏ, as rootof counts


class NumberInField(Closed):
    """An immutable number of ℚ(α), not in ℚ: a polynomial ``value`` in α; ``root`` is α, of degree 3 or more.

    ``spelled`` is an expression shorter than the minimal polynomial, for linear combinations of roots and for
    sums and products of conjugate roots.
    """

    def __init__(
        self, root: Numbered, value: flint.fmpq_poly, spelled: sympy.Expr | None = None
    ) -> None:
        super().__init__(lambda: self._of_own() if spelled is None else spelled)
        self.root, self.value, self.spelled = root, value, spelled

    @cached_property
    def own(self) -> Numbered:
        """The number as a root of its minimal polynomial."""
        if self.value == [0, 1]:
            return self.root
        return located([_minimal_polynomial(tuple(self.value.coeffs()), self.root[1:])], self.ball)

    def _of_own(self) -> sympy.Expr:
        return sympy_of(_quadratic(self.own)) if len(self.own) == 4 else Root(*self.own)

    def __reduce__(self) -> tuple[object, ...]:
        value = [(int(c.p), int(c.q)) for c in self.value.coeffs()]
        return _restored, (self.root, value, self.spelled)

    # --- arithmetic ----------------------------------------------------------------------------

    def _operand(self, other: object) -> tuple[flint.fmpq_poly, sympy.Expr | None] | None:
        """Return the value and the spelling of another number of the field, or None."""
        if isinstance(other, NumberInField):
            return (other.value, other.spelled) if other.root == self.root else None
        surd = as_surd(other)
        if surd is None or not surd.is_rational():
            return None
        return flint.fmpq_poly([surd.terms.get(1, 0)]), sympy_of(surd)

    def _combine(
        self,
        other: object,
        operation: Callable[
            [sympy.Expr | flint.fmpq_poly, sympy.Expr | flint.fmpq_poly],
            sympy.Expr | flint.fmpq_poly,
        ],
    ) -> Surd | Closed:
        operand = self._operand(other)
        if operand is None:
            return super()._combine(other, operation)
        value, other_spelled = operand
        spelled = None
        if self.spelled is not None and other_spelled is not None:
            spelled = operation(self.spelled, other_spelled)
        return at(self.root, operation(self.value, value), spelled)

    def __mul__(self, other: object) -> Surd | Closed:
        operand = self._operand(other)
        if operand is None:
            return super().__mul__(other)
        value, factor = operand
        spelled = None
        if self.spelled is not None and value.degree() < 1:
            spelled = (self.spelled * factor).expand()
        return at(self.root, self.value * value % monic(self.root[1:]), spelled)

    __rmul__ = __mul__

    def __neg__(self) -> Surd | Closed:
        return self * -1

    def inverse(self) -> Surd | Closed:
        """Return 1/self."""
        return at(self.root, inverse_modulo(tuple(self.value.coeffs()), self.root[1:]))

    # --- equality ------------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        operand = self._operand(other)
        if operand is not None:
            return bool(self.value == operand[0])
        if isinstance(other, NumberInField):
            return self.ball(64).overlaps(other.ball(64)) and self.own == other.own
        return super().__eq__(other)

    __hash__ = Closed.__hash__

    @cached_property
    def _hash(self) -> int:
        return hash(fingerprint(self.ball))

    def is_zero(self) -> bool:
        """Return False: the number is not 0."""
        return False

    def is_real(self) -> bool:
        """Return whether the number is real."""
        is_real_field = self.root[0] < isolated_roots(self.root[1:]).real_count
        return is_real_field or self.own[0] < isolated_roots(self.own[1:]).real_count

    def ball(self, bits: int) -> flint.acb:
        """Return a complex ball of flint around the number, accurate to ``bits`` bits."""
        return enclosed(self.root, self.value, bits)


def _restored(
    root: Numbered, value: list[tuple[int, int]], spelled: sympy.Expr | None
) -> NumberInField:
    return NumberInField(root, flint.fmpq_poly([flint.fmpq(*c) for c in value]), spelled)


def at(root: Numbered, value: flint.fmpq_poly, spelled: sympy.Expr | None = None) -> Surd | Closed:
    """Return the value of a polynomial at a root, as a surd if the field is ℚ or quadratic."""
    if value.degree() < 1:
        return from_rational(value[0])
    if len(root) == 4:
        return from_rational(value[1]) * _quadratic(root) + from_rational(value[0])
    return NumberInField(root, value, spelled)


def _quadratic(root: Numbered) -> Surd:
    n, c, b, a = root
    square = b * b - 4 * a * c
    difference = sqrt_rational(flint.fmpq(square)) * (1 if (n == 0) == (square < 0) else -1)
    return (difference - b) * from_rational(Fraction(1, 2 * a))


def root_by_number(name: str, *arguments: Surd | Closed) -> Surd | Closed:
    """Return the value of one of the functions in ``ROOTS``, which texts may call."""
    numbers = (
        x.terms.get(1, flint.fmpq(0)) if isinstance(x, Surd) and x.is_rational() else None
        for x in arguments
    )
    found = read(name, [int(c.p) if c is not None and c.q == 1 else None for c in numbers])
    if not isinstance(found, Root):
        return number(found)
    return at(tuple(map(int, found.args)), flint.fmpq_poly([0, 1]), found)


def enclosed(root: Numbered, value: flint.fmpq_poly, bits: int) -> flint.acb:
    """Return a ball, accurate to ``bits`` bits, around the nonzero value of a polynomial at a root."""
    work = bits + 16
    while True:
        z = isolated_roots(root[1:]).numbered(root[0], work)
        with precision(work):
            found = flint.acb(0)
            for c in reversed(value.coeffs()):
                found = found * z + flint.arb(c)
        if found.rel_accuracy_bits() >= bits:
            return found
        work *= 2


def located(polynomials: Sequence[tuple[int, ...]], ball: Enclosure) -> Numbered:
    """Return the root, of one of several coprime polynomials, that ``ball`` encloses."""
    bits = 64
    while True:
        z = ball(bits)
        found = [
            (n, *c)
            for c in polynomials
            for n in range(len(c) - 1)
            if isolated_roots(c).numbered(n, bits).overlaps(z)
        ]
        if len(found) == 1:
            return found[0]
        bits *= 2


def coefficients(f: flint.fmpq_poly) -> tuple[int, ...]:
    """Return the coefficients of the primitive multiple over ℤ; the last is positive."""
    whole = f.numer()
    whole //= whole.content()
    return tuple(map(int, (whole if whole.leading_coefficient() > 0 else -whole).coeffs()))


@lru_cache(maxsize=256)
def monic(c: tuple[int, ...]) -> flint.fmpq_poly:
    """Return the monic polynomial with the roots of Σ cₖ·xᵏ."""
    return flint.fmpq_poly(list(c), c[-1])


@lru_cache(maxsize=64)  # conjugate numbers are one polynomial at several roots
def inverse_modulo(value: tuple[flint.fmpq, ...], c: tuple[int, ...]) -> flint.fmpq_poly:
    """Return y with y·value = 1 modulo Σ cₖ·xᵏ, the solution of a linear system, found by lifting."""
    modulus, column, rows = monic(c), flint.fmpq_poly(list(value)), []
    d = modulus.degree()
    for _ in range(d):
        rows.append([column[n] for n in range(d)])
        column = column.left_shift(1) % modulus
    one = flint.fmpq_mat(d, 1, [1, *[0] * (d - 1)])
    return flint.fmpq_poly(flint.fmpq_mat(rows).transpose().solve(one).entries())


@lru_cache(maxsize=64)
def _minimal_polynomial(value: tuple[flint.fmpq, ...], c: tuple[int, ...]) -> tuple[int, ...]:
    """Return the primitive minimal polynomial over ℤ, computed from the traces of powers."""
    modulus, x, power = monic(c), flint.fmpq_poly(list(value)), flint.fmpq_poly([1])
    of_basis, sums = traces(modulus), [flint.fmpq(modulus.degree())]
    for _ in range(modulus.degree()):
        power = power * x % modulus
        sums.append(trace(power, of_basis))
    characteristic = of_power_sums(sums)  # a power of it
    return coefficients(characteristic / characteristic.gcd(characteristic.derivative()))


def traces(f: flint.fmpq_poly) -> flint.fmpq_poly:
    """Return the traces of 1, x, … modulo a monic polynomial: the power sums of its roots (Newton)."""
    d, sums = f.degree(), [flint.fmpq(f.degree())]
    for k in range(1, d):
        sums.append(-sum((f[d - j] * sums[k - j] for j in range(1, k)), k * f[d - k]))
    return flint.fmpq_poly(sums)


def trace(f: flint.fmpq_poly, of_basis: flint.fmpq_poly) -> flint.fmpq:
    """Return the trace of a polynomial, given those of 1, x, …"""
    pairs = zip(f.numer().coeffs(), of_basis.numer().coeffs(), strict=False)
    return flint.fmpq(sum((a * b for a, b in pairs), flint.fmpz(0)), f.denom() * of_basis.denom())


def of_power_sums(sums: Sequence[flint.fmpq]) -> flint.fmpq_poly:
    """Return the monic polynomial whose roots have these power sums; there are as many sums as roots."""
    down = [flint.fmpq(1)]
    for k in range(1, len(sums)):
        total = sum((sums[j] * down[k - j] for j in range(1, k + 1)), flint.fmpq(0))
        down.append(-total / k)
    return flint.fmpq_poly(down[::-1])
