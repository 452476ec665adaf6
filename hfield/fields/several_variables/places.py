"""Prime polynomials of k[x, y, …], and residues of rational functions modulo them.

If P is linear in some variable, P = c·v + d, the residue field is k(…) in the other variables, with v
replaced by −d/c. Otherwise the norm down to the other variables may show that a residue is not a square. At
infinity of a variable, the leading coefficient plays the role of the residue.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.function_fields.rational_functions import rational_functions
from hfield.fields.function_fields.residues import multiplicity
from hfield.fields.several_variables.ring import RationalFunctions

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import SparsePolynomial
    from hfield.fields.function_fields.quotients import RationalFunction


@dataclass(frozen=True)
class PolynomialPlace:
    """A prime polynomial of k[x, y, …], as a flint polynomial, or infinity of the variable with a given
    index.
    """

    name: str
    poly: SparsePolynomial | None = field(default=None, hash=False)
    infinite: int | None = None

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return self.name


@dataclass(frozen=True)
class ResidueFieldElement:
    """An element of the residue field at a place, or its norm down to the given field."""

    field: Ring
    value: RationalFunction
    is_norm: bool = False

    def is_square(self) -> bool:
        """Return whether it is a square. Raises :class:`UndecidedError`."""
        root = self.field.sqrt(self.value)
        if root is not None and self.is_norm:
            raise UndecidedError("the norm of the residue is a square, which does not decide")
        return root is not None


def places_of(F: RationalFunctions, *elements: RationalFunction) -> list[PolynomialPlace]:
    """Return the prime polynomials in elements of k(x, y, …), and infinity of each variable."""
    found = {}
    for x in elements:
        for poly in (x.num, x.den):
            for p, _ in poly.factor()[1]:
                p = F.quotient(F.polynomials.one, p).den
                found[F.polynomials.text(p)] = p
    order = sorted(found.items(), key=lambda item: (int(item[1].total_degree()), item[0]))
    finite = [PolynomialPlace(name, p) for name, p in order]
    return finite + [PolynomialPlace(f"1/{name}", None, n) for n, name in enumerate(F.variables)]


def valuation(F: RationalFunctions, x: RationalFunction, place: PolynomialPlace) -> int:
    """Return the valuation of a nonzero rational function at a place."""
    if place.infinite is not None:
        over, under = (int(p.degrees()[place.infinite]) for p in (x.num, x.den))
        return under - over
    return multiplicity(x.num, place.poly) - multiplicity(x.den, place.poly)


def unit_part(
    F: RationalFunctions, x: RationalFunction, place: PolynomialPlace
) -> RationalFunction:
    """Return x times a power of the prime, or of 1/v, so that it has no zero or pole at the place."""
    n = valuation(F, x, place)
    if place.infinite is not None:
        return x * F.power(F.names()[F.variables[place.infinite]], n)
    return x * F.power(F.quotient(place.poly, F.polynomials.one), -n)


def residue(
    F: RationalFunctions, unit: RationalFunction, place: PolynomialPlace
) -> ResidueFieldElement:
    """Return the residue of a unit at a place, or a norm of it. Raises :class:`UndecidedError`."""
    if place.infinite is not None:
        target = _without(F, place.infinite)
        over, under = (_leading(F, p, place.infinite, target) for p in (unit.num, unit.den))
        return ResidueFieldElement(target, target.divide(over, under))
    poly = place.poly
    assert poly is not None, "a place is infinite or has a polynomial"
    for n in range(len(F.variables)):
        if int(poly.degrees()[n]) == 1:
            target = _without(F, n)
            slope, rest = (_coefficient(F, poly, n, e, target) for e in (1, 0))
            at = target.zero - target.divide(rest, slope)
            over, under = (_value(F, p, n, at, target) for p in (unit.num, unit.den))
            return ResidueFieldElement(target, target.divide(over, under))
    return ResidueFieldElement(F, unit) if F.sqrt(unit) is not None else _norm(F, unit, poly)


def _norm(
    F: RationalFunctions, unit: RationalFunction, poly: SparsePolynomial
) -> ResidueFieldElement:
    """Return the norm of a residue down to the other variables, up to squares, by resultants."""
    degrees = {m: int(e) for m, e in enumerate(poly.degrees()) if int(e)}
    n = max(degrees, key=lambda m: degrees[m] % 2)  # in odd degree the norm of a constant decides
    target = _without(F, n)
    lead = _leading(F, poly, n, target)
    total = target.one
    for p in (unit.num, unit.den):
        size = _coefficient(F, poly.resultant(p, F.variables[n]), n, 0, target)
        total = total * size * (lead if int(p.degrees()[n]) % 2 else target.one)
    return ResidueFieldElement(target, total, is_norm=True)


def _without(F: RationalFunctions, n: int) -> Ring[RationalFunction]:
    """Return the rational functions in the variables other than the n-th."""
    return rational_functions(F.base, F.variables[:n] + F.variables[n + 1 :])


def _coefficient(
    F: RationalFunctions,
    poly: SparsePolynomial,
    n: int,
    exponent: int,
    target: Ring[RationalFunction],
) -> RationalFunction:
    """Return the coefficient of a power of the n-th variable."""
    gens = target.names()
    total = target.zero
    for exponents, c in poly.terms():
        if exponents[n] == exponent:
            term = target(F.base(int(c) if F.characteristic else c))
            for m, e in enumerate(exponents):
                if m != n and e:
                    term = term * target.power(gens[F.variables[m]], int(e))
            total = total + term
    return total


def _leading(
    F: RationalFunctions, poly: SparsePolynomial, n: int, target: Ring[RationalFunction]
) -> RationalFunction:
    return _coefficient(F, poly, n, int(poly.degrees()[n]), target)


def _value(
    F: RationalFunctions,
    poly: SparsePolynomial,
    n: int,
    at: RationalFunction,
    target: Ring[RationalFunction],
) -> RationalFunction:
    """Return the value with an element of the target for the n-th variable."""
    total = target.zero
    for e in range(int(poly.degrees()[n]), -1, -1):
        total = total * at + _coefficient(F, poly, n, e, target)
    return total
