"""Count the elliptic points of the group of an Eichler order over ℤ_K, by Eichler's embedding numbers.

An elliptic point of order q is fixed by the units of norm 1 of an optimally embedded quadratic order S. The
order S has 2q roots of unity and generates L = K(ζ), with ζ of order 2q. At some real place the algebra
splits and L is complex, so S has the same number of embeddings in all orders of the genus. Let C be
h(L)/(h(K)·Q·w), where Q is Hasse's unit index and w is the number of roots of unity of L. The number of
elliptic points of order q is

    2q·C·Σ_S [Ô_L^×:Ŝ^×]·∏_P m_P(S)

(J. Voight, *Quaternion Algebras*, theorems 30.4.7 and 31.1.7 and section 39.4). Units of K and of S cancel.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from math import prod
from typing import TYPE_CHECKING

import flint

from hfield.core.properties import cached_property
from hfield.errors import TooLargeError
from hfield.fields.names import ring
from hfield.fields.number_fields.classes.class_groups import class_group
from hfield.fields.number_fields.classes.unit_groups import unit_group
from hfield.fields.number_fields.ideals import integers
from hfield.fields.number_fields.residues import local_place
from hfield.fields.number_fields.sums import roots_in, sums_of_roots
from hfield.fields.number_fields.symbols import DyadicPrime
from hfield.orders.base import number_field_integers
from hfield.orders.invariants import level
from hfield.orders.lattice_values import LatticeValue

if TYPE_CHECKING:
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.prime_ideals import PrimeIdeal
    from hfield.fields.number_fields.ring import NumberField
    from hfield.orders.base import NumberFieldIntegers

MAX_RESIDUES = 10_000
"""At primes whose square divides the level, roots of polynomials are listed modulo primes up to this norm."""


def elliptic_points(order: LatticeValue) -> dict[int, int]:
    """Return the number of elliptic points of each order, for an Eichler order.

    The algebra must be a division algebra over a totally real field that splits at exactly one real place.
    """
    base = number_field_integers(order.ambient.base)
    found = [_Rotations(order, base, q, t) for q, t in _traces(base.field)]
    counts = {x.q: x.count([y for y in found if y.q % x.q == 0 and y.q > x.q]) for x in found}
    return {q: n for q, n in counts.items() if n}


def _traces(field: NumberField) -> Iterator[tuple[int, FieldElement]]:
    """Yield each q such that the field contains a trace of a root of unity of order 2q, with one
    such trace.
    """
    yield 2, field.zero
    yield 3, field.one
    n = field.degree
    for q in range(4, 4 * n * n + 4):
        if n % (int(flint.fmpz(2 * q).euler_phi()) // 2) == 0:
            roots = roots_in(field, flint.fmpq_poly(flint.fmpz_poly.cos_minpoly(2 * q)))
            yield from ((q, t) for t in roots[:1])


class _Rotations:
    """The embeddings of the orders that contain a root of unity of order 2q and trace t."""

    def __init__(
        self, order: LatticeValue, base: NumberFieldIntegers, q: int, t: FieldElement
    ) -> None:
        ambient = order.ambient
        self.ambient, self.q, self.d = ambient, q, t * t - 4
        self.base = base
        several = [P for P, e in self.base.principal(self.d).factorisation() if e > 1]
        self.level = dict(ambient.base.factorisation(level(order)))
        primes = map(self.base.prime, [*ambient.ramified, *self.level, *several])
        self.primes = {P: _LocalField(base, P, self.d) for P in primes}

    def count(self, larger: list[_Rotations]) -> int:
        """Return the number of points of exactly this order, excluding those of the larger orders."""
        ranges = [range(v.conductor + 1) for v in self.primes.values()]
        total = Fraction(0)
        for exponents in product(*ranges):
            conductor = dict(zip(self.primes, exponents, strict=True))
            if not any(x._contains(conductor) for x in larger):
                total += prod((self._local(P, k) for P, k in conductor.items()), start=Fraction(1))
        if not total:
            return 0
        found = 2 * self.q * total * relative_class_number(self.base.field, self.q, self.d)
        if found.denominator > 1:
            raise ArithmeticError("the number of elliptic points is not an integer")
        return int(found)

    def _contains(self, conductor: dict[PrimeIdeal, int]) -> bool:
        """Return whether the root of unity lies in the order with a given conductor."""
        return all(
            k <= (self.primes[P].conductor if P in self.primes else 0) for P, k in conductor.items()
        )

    def _local(self, P: PrimeIdeal, k: int) -> Fraction:
        """Return the index of local units times the number of local embeddings, for a conductor Pᵏ."""
        local = self.primes[P]
        index = P.norm() ** k * (1 - Fraction(local.symbol, P.norm())) if k else Fraction(1)
        if P in self.ambient.ramified:
            return Fraction(0 if k else 1 - local.symbol)
        e = self.level.get(P, 0)
        if e < 2:
            return index * (1 + (1 if k else local.symbol) if e else 1)
        return index * local.embeddings(k, e)


class _LocalField:
    """The local algebra K_P(√d); ``symbol`` is 1, −1 or 0 if P splits, is inert or ramifies.

    The order of discriminant d has the conductor P^``conductor``.
    """

    def __init__(self, base: NumberFieldIntegers, P: PrimeIdeal, d: FieldElement) -> None:
        self.base, self.P, self.d = base, P, d
        v, unit = P.unit_part(d)
        e = self.e = P.e if P.p == 2 else 0
        exponent = 2 * e + 1  # of the discriminant of the field
        if v % 2:
            self.symbol = 0
        elif e:
            defect, _ = DyadicPrime(P).defect(P.integral(unit))
            self.symbol = {2 * e: -1, 2 * e + 1: 1}.get(defect, 0)
            exponent = 0 if self.symbol else 2 * e + 1 - defect
        else:
            place = local_place(P)
            root = place.quadratic_root(place.one, place.zero, place.zero - P.residue_of(unit))
            self.symbol, exponent = -1 if root is None else 1, 0
        self.conductor = (v - exponent) // 2

    @cached_property
    def representatives(self) -> list[FieldElement]:
        return self.base.residues(self.P)

    def embeddings(self, k: int, e: int) -> int:
        """Return the number of classes of optimal embeddings of conductor Pᵏ in the Eichler order of level
        Pᵉ.

        They correspond to roots of x² − tx + n modulo Pᵉ (Hijikata; Voight, proposition 30.6.12).
        """
        P = self.P
        if P.norm() > MAX_RESIDUES:
            raise TooLargeError(
                f"elliptic points are counted by residues modulo {P}, and there are over {MAX_RESIDUES}"
            )
        d = self.d * P.inverse_uniformiser ** (2 * (self.conductor - k))
        trace = next(t for t in self._residues(self.e) if self._is_root(t, d, 2 * self.e))
        roots = [[self.base.field.zero]]  # modulo P⁰, P¹, …
        for s in range(e + 1):
            step = P.uniformiser**s
            roots.append(
                [
                    y
                    for x in roots[-1]
                    for r in self.representatives
                    for y in [x + r * step]
                    if self._is_root(y * 2 - trace, d, s + 1 + 2 * self.e)
                ]
            )
        if P.valuation(d) == 0:
            return len(roots[e])
        images = [x for x in roots[e] if any(self._agree(x, y, e) for y in roots[e + 1])]
        return len(roots[e]) + len(images)

    def _residues(self, count: int) -> Iterator[FieldElement]:
        """Yield one number from each residue class modulo P^count."""
        steps = [self.P.uniformiser**s for s in range(count)]
        for digits in product(self.representatives, repeat=count):
            pairs = zip(digits, steps, strict=True)
            yield sum((r * step for r, step in pairs), self.base.field.zero)

    def _is_root(self, x: FieldElement, d: FieldElement, count: int) -> bool:
        """Return whether x² ≡ d modulo P^count."""
        rest = x * x - d
        return not rest or self.P.valuation(rest) >= count

    def _agree(self, x: FieldElement, y: FieldElement, count: int) -> bool:
        """Return whether x ≡ y modulo P^count."""
        return x == y or self.P.valuation(x - y) >= count


def relative_class_number(field: NumberField, q: int, d: FieldElement) -> Fraction:
    """Return h(L)/(h(K)·Q·w) for L = K(√d), generated over K by the roots of unity of order 2q.

    Q is the index, in the units of L, of the group generated by the roots of unity and the units of K; w is
    the number of roots of unity. If K is quadratic and L contains the square root of −1 or −3, the value
    follows from imaginary quadratic fields.
    """
    D = field.discriminant()
    for m in (1, 3):
        if field.degree == 2 and (d * -m).sqrt() is not None:
            both = [ring(f"QQ(sqrt({-n}))") for n in (m, m * int(D))]
            return prod(
                (Fraction(class_group(k).order, unit_group(k).torsion_order) for k in both),
                start=Fraction(1),
            )
    larger = _with_roots_of_unity(field, 2 * q)
    below, above = unit_group(field), unit_group(larger)
    quotient = 2 ** (field.degree - 1) * below.regulator / above.regulator
    index = int((quotient + flint.arb("0.5")).floor().unique_fmpz())
    classes = Fraction(class_group(larger).order, class_group(field).order)
    return classes / (index * above.torsion_order)


def _with_roots_of_unity(field: NumberField, m: int) -> NumberField:
    """Return the field generated by roots of unity of order m over a field of half its degree."""
    unity = flint.fmpq_poly(flint.fmpz_poly.cyclotomic(m))
    for scale in range(1, 100):
        whole = sums_of_roots(unity, field.polynomial, scale)
        if whole.gcd(whole.derivative()).degree() == 0:
            break
    f = next(g for g, _ in whole.factor()[1] if g.degree() == 2 * field.degree)
    found = ring(f"QQ[s]/({str(f).replace('x', 's')})")
    return integers(found).field
