"""Galois orbits of newforms: eigenvalues, the field they generate, Atkin–Lehner signs.

Let the newforms of an orbit be the eigenvectors v of T for the roots α of an irreducible polynomial g of
degree d, with coordinate 1 at one class i. Then an eigenvalue a is Σ tⱼ·vⱼ, where t is row i of the Hecke
operator. It is an integer of ℚ(α), so a = N(α)/g′(α) for an integral polynomial N of degree below d.
Deligne's bound for the conjugates of a bounds the coefficients of N, so residues modulo primes determine
them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import count, islice
from typing import TYPE_CHECKING

from flint import fmpq_poly, fmpz_poly, nmod_mat, nmod_poly

from hfield.core.factorisation import factorise
from hfield.core.primality import is_prime
from hfield.core.properties import cached_property
from hfield.fields.number_fields.elements import FieldElement
from hfield.fields.rationals.ring import QQ
from hfield.orders.base_values import Prime
from hfield.orders.eigenvalue_fields import EigenvalueField
from hfield.orders.residues_modulo_primes import lifted
from hfield.orders.validation import positive

if TYPE_CHECKING:
    from flint import fmpq

    from hfield.fields.number_fields.ring import NumberField
    from hfield.fields.rationals.ring import Rationals
    from hfield.orders.eigensystems import Combination, Level, Module

SHORT_EIGENVALUES = 10
"""The number of eigenvalues that help to find a small polynomial of the field."""
PRIMES_SHOWN = 5


class Newform:
    """A Galois orbit of newforms; the attributes describe one form of the orbit.

    >>> from hfield import QuaternionAlgebra
    >>> f, g = QuaternionAlgebra(37).maximal_order().class_set().newforms()
    >>> f.degree, f.field, f[2], f.eigenvalues(3)
    (1, QQ, -2, {2: -2, 3: -3, 5: -2})
    >>> f, g = QuaternionAlgebra(43).maximal_order().class_set().newforms(); g
    <newform of degree 2, traces a_2 = 0, a_3 = 0, a_5 = 4, a_7 = -4, a_11 = -2, …>
    >>> g.field, g.eigenvalue(2), g.minimal_polynomial(7), g.signs
    (QQ[s]/(s^2-2), s, [2, 4, 1], {43: -1})
    """

    def __init__(self, module: Module, operator: Combination, polynomial: fmpz_poly) -> None:
        self._module = module
        self.operator = operator
        """A combination of Hecke operators with different eigenvalues on all newforms of the level."""
        self.polynomial = polynomial
        """The polynomial of its eigenvalues on the orbit, irreducible over ℚ."""
        self._systems: dict[int, nmod_mat | None] = {}
        self._coordinate = -1
        self._numerators: dict[Prime, list[int]] = {}

    @property
    def degree(self) -> int:
        """The number of newforms in the orbit: the degree of the field."""
        return int(self.polynomial.degree())

    @property
    def weight(self) -> int:
        """The weight."""
        return self._module.weight

    @property
    def level(self) -> Level:
        """The level away from the discriminant of the algebra, as pairs (prime, exponent)."""
        return self._module.level

    @property
    def field(self) -> Rationals | NumberField:
        """The field of the eigenvalues: ℚ, or a number field given by a small polynomial."""
        return QQ if self.degree == 1 else self._field.field

    @cached_property
    def _field(self) -> EigenvalueField:
        primes = islice(self._module.good_primes(), SHORT_EIGENVALUES)
        return EigenvalueField(self.polynomial, [self._numerator(P) for P in primes])

    @cached_property
    def _signs(self) -> dict[Prime, int]:
        """The signs, by primes of the base."""
        p, system = next(self._reductions())
        one = nmod_poly(self.polynomial.derivative().coeffs(), p)
        found = {}
        primes = [*((Q, 1) for Q, _ in self.level), *((Q, -1) for Q in self._module.ramified)]
        for Q, factor in primes:
            row = self._module.exchange_row(Q, self._coordinate, p)
            value = nmod_poly(_applied(system, row, p), p)
            if value not in (one, -one):
                raise AssertionError("an involution is 1 or −1 on a newform")
            found[Q] = factor if value == one else -factor
        return found

    @property
    def signs(self) -> dict[Prime, int]:
        """The Atkin–Lehner signs at the primes of the level and of the discriminant."""
        return {self._module.shown(P): sign for P, sign in self._signs.items()}

    @property
    def _exponents(self) -> Level:
        """The primes of the level and of the discriminant, with their exponents."""
        return (*self.level, *((P, 1) for P in self._module.ramified))

    # --- eigenvalues -----------------------------------------------------------------------------------

    def eigenvalue(self, prime: object) -> fmpq | FieldElement:
        """Return the eigenvalue at a prime, an element of the field.

        At a prime P of the level it is −sign·N(P)^(k/2−1) if P divides the level exactly once, and 0 if P²
        divides it. Raises :class:`LatticeError` unless the argument is a prime.
        """
        P = self._module.prime(prime)
        known = self._at_level(P)
        if known is not None:
            return self.field(known)
        if self.degree == 1:
            return self.field(self._numerator(P)[0])
        return self._field.element(self._numerator(P))

    def eigenvalue_polynomial(self, prime: object) -> fmpq_poly:
        """Return the polynomial x with x(α) the eigenvalue at a prime, for a root α of :attr:`polynomial`.

        The small polynomial of :attr:`field` is not computed, which takes long where the degree is large.

        >>> from hfield import QuaternionAlgebra
        >>> f, g = QuaternionAlgebra(43).maximal_order().class_set().newforms()
        >>> g.polynomial, g.eigenvalue_polynomial(5)
        (x^2 + (-2), (-1)*x + 2)
        """
        P = self._module.prime(prime)
        known = self._at_level(P)
        if known is not None:
            return fmpq_poly([known])
        g = fmpq_poly(self.polynomial)
        return fmpq_poly(self._numerator(P)) * g.derivative().xgcd(g)[1] % g

    def __getitem__(self, prime: object) -> int | FieldElement:
        """Return the eigenvalue at a prime; an int if the field is ℚ."""
        found = self.eigenvalue(prime)
        return found if isinstance(found, FieldElement) else int(found.p)

    def trace(self, prime: object) -> int:
        """Return the trace of the eigenvalue at a prime down to ℚ."""
        P = self._module.prime(prime)
        known = self._at_level(P)
        return self._numerator(P)[-1] if known is None else known * self.degree

    def minimal_polynomial(self, prime: object) -> list[int]:
        """Return the minimal polynomial of the eigenvalue at a prime over ℤ, low degree first, monic."""
        P = self._module.prime(prime)
        known = self._at_level(P)
        if known is not None:
            return [-known, 1]
        numerator = self._numerator(P)
        polynomials = ((p, self._characteristic(numerator, p)) for p in self._module.primes())
        bound = (1 + self._module.bound(P)) ** self.degree
        found = fmpz_poly(lifted(((p, f) for p, f in polynomials if f), bound))
        return [int(c) for c in (found // found.gcd(found.derivative())).coeffs()]

    def _characteristic(self, numerator: list[int], p: int) -> list[int]:
        """Return the characteristic polynomial of N(α)/g′(α) modulo p, or [] if p is not suitable for it."""
        g = nmod_poly(self.polynomial.coeffs(), p)
        common, inverse, _ = g.derivative().xgcd(g)
        if common.degree():
            return []
        matrix = _multiplication(nmod_poly(numerator, p) * inverse, g)
        return [int(c) for c in matrix.charpoly().coeffs()]

    def _at_level(self, P: Prime) -> int | None:
        """Return the eigenvalue at a prime of the level or the discriminant, None at other primes."""
        exponents = dict(self._exponents)
        if P not in exponents:
            return None
        if exponents[P] > 1:
            return 0
        norm = self._module.absolute_norm(P)
        return -self._signs[P] * int(norm ** (self.weight // 2 - 1))

    def _numerator(self, P: Prime) -> list[int]:
        """Return the coefficients of N, low degree first, for the eigenvalue N(α)/g′(α) at a good prime."""
        if P not in self._numerators:
            d, module = self.degree, self._module
            size = module.bound(P)
            bound = d * size * (1 + module.radius(self.operator)) ** (d - 1)
            residues = (
                (p, _applied(system, module.row(P, self._coordinate, p), p))
                for p, system in self._reductions()
            )
            self._numerators[P] = lifted(residues, bound)
        return self._numerators[P]

    # --- q-expansions ------------------------------------------------------------------------------------

    def coefficient(self, n: int) -> fmpq | FieldElement:
        """Return the coefficient of qⁿ, n ≥ 1, an element of the field.

        Raises :class:`LatticeError` over fields other than ℚ, where forms have no q-expansion.

        >>> from hfield import QuaternionAlgebra
        >>> f = QuaternionAlgebra(11).maximal_order().class_set().newforms()[0]
        >>> [f.coefficient(n) for n in range(1, 11)], f.q_expansion(6)
        ([1, -2, -1, 2, 1, 2, -2, 0, -2, -2], 'q - 2*q^2 - q^3 + 2*q^4 + q^5 + O(q^6)')
        """
        self._module.expect_rational()
        found = self.field(1)
        for p, e in factorise(positive(n, "number of a coefficient")).items():
            a = self.eigenvalue(p)
            is_good = self._at_level(self._module.prime(p)) is None
            weight = p ** (self.weight - 1) if is_good else 0
            before, power = self.field(0), self.field(1)
            for _ in range(e):
                before, power = power, a * power - before * weight
            found = found * power
        return found

    def q_expansion(self, number: int = 10) -> str:
        """Return the q-expansion up to O(qⁿ) as a text. Raises as :meth:`coefficient` does."""
        text = "q"
        for n in range(2, number):
            c = self.coefficient(n)
            if c:
                shown = self.field.text(c)
                is_sum = "+" in shown[1:] or "-" in shown[1:]
                size = f"({shown})" if is_sum else shown.removeprefix("-")
                sign = "-" if not is_sum and shown.startswith("-") else "+"
                text += f" {sign} {'' if size == '1' else size + '*'}q^{n}"
        return f"{text} + O(q^{number})"

    def traces(self) -> Iterator[int]:
        """Yield the traces of the coefficients of q², q³, …; over other fields, of the eigenvalues at good
        primes.

        >>> from itertools import islice
        >>> from hfield import QuaternionAlgebra
        >>> (f,) = QuaternionAlgebra(23).maximal_order().class_set().newforms()
        >>> list(islice(f.traces(), 6)), f.named_eigenvalues(2)
        ([-1, 0, -1, -2, -5, 2], 'a_2 = -1+s, a_3 = 1-2*s, …')
        """
        if not self._module.has_expansions:
            yield from map(self.trace, self._module.good_primes())
            return
        for n in count(2):
            if is_prime(n):
                yield self.trace(n)
            else:
                a = self.coefficient(n)
                yield int((a.trace() if isinstance(a, FieldElement) else a).p)

    @property
    def label(self) -> str | None:
        """The label in the LMFDB, such as ``389.2.a.e``; None over fields other than ℚ.

        All newforms of weight k and level D·N come from an algebra of discriminant D if D is prime to N, so
        the position of an orbit among them is known. They are ordered by the traces of coefficients.
        """
        if not self._module.has_expansions:
            return None
        level = math.prod(self._module.absolute_norm(P) ** e for P, e in self._exponents)
        number = self._module.newforms.index(self)
        letters = chr(ord("a") + number % 26)
        while number := number // 26:
            letters = chr(ord("a") + number % 26) + letters
        return f"{level}.{self.weight}.a.{letters}"

    # --- modulo primes -----------------------------------------------------------------------------------

    def _reductions(self) -> Iterator[tuple[int, nmod_mat]]:
        """Yield primes p, with a matrix whose column j is g′(α)·vⱼ modulo p."""
        for p in self._module.primes():
            if p not in self._systems:
                self._systems[p] = self._reduction(p)
            found = self._systems[p]
            if found is not None:
                yield p, found

    def _reduction(self, p: int) -> nmod_mat | None:
        """Return g′(α)·vⱼ modulo p in column j; None if p is not suitable, for instance if vᵢ is
        not a unit.
        """
        g = nmod_poly(self.polynomial.coeffs(), p)
        vector = self._module.eigenvectors(self.operator, self.polynomial, p)
        if vector is None:
            return None
        numbers = range(vector.ncols()) if self._coordinate < 0 else [self._coordinate]
        for i in numbers:
            column = [vector[k, i] for k in range(self.degree)]
            common, inverse, _ = nmod_poly(column, p).xgcd(g)
            if not common.degree():
                self._coordinate = i
                return _multiplication(inverse * g.derivative(), g).transpose() * vector
        return None

    # --- several -----------------------------------------------------------------------------------------

    def eigenvalues(self, number: int) -> dict[Prime, int | FieldElement]:
        """Return the eigenvalues at the first primes that divide neither the level nor the discriminant."""
        primes = islice(self._module.good_primes(), number)
        return {self._module.shown(P): self[P] for P in primes}

    def eigenvalues_up_to(self, norm: int) -> dict[Prime, int | FieldElement]:
        """Return the eigenvalues at all primes of norm up to a bound, including those of the level."""
        return {self._module.shown(P): self[P] for P in self._module.primes_up_to(norm)}

    def traces_up_to(self, norm: int) -> dict[Prime, int]:
        """Return the traces of the eigenvalues at all primes of norm up to a bound."""
        return {self._module.shown(P): self.trace(P) for P in self._module.primes_up_to(norm)}

    def named_eigenvalues(self, number: int) -> str:
        """Return the first eigenvalues as a text, such as ``a_2 = 1, a_5 = -2, …``."""
        return ", ".join([*(f"a_{P} = {a}" for P, a in self.eigenvalues(number).items()), "…"])

    def __repr__(self) -> str:
        if self.degree == 1:
            return f"<newform {self.named_eigenvalues(PRIMES_SHOWN)}>"
        primes = islice(self._module.good_primes(), PRIMES_SHOWN)
        traces = ", ".join(f"a_{self._module.shown(P)} = {self.trace(P)}" for P in primes)
        return f"<newform of degree {self.degree}, traces {traces}, …>"


def _applied(system: nmod_mat, row: dict[int, int], p: int) -> list[int]:
    """Return the combination of the columns of a matrix given by a row of an operator."""
    column = [0] * system.ncols()
    for j, times in row.items():
        column[j] = times % p
    return [int(x) for x in (system * nmod_mat(system.ncols(), 1, column, p)).entries()]


def _multiplication(x: nmod_poly, g: nmod_poly) -> nmod_mat:
    """Return the matrix of multiplication by x modulo g, on rows of coefficients."""
    d, p = int(g.degree()), int(g.modulus())
    step, rows = nmod_poly([0, 1], p), []
    x = x % g
    for _ in range(d):
        coefficients = x.coeffs()
        rows.append(coefficients + [0] * (d - len(coefficients)))
        x = x * step % g
    return nmod_mat(rows, p)
