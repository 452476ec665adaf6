"""Zero norms over rings that are not fields: ℤ, ℤ/n, and polynomial rings."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from hfield.core.factorisation import factorise
from hfield.core.product import Constants, norm
from hfield.errors import UndecidedError
from hfield.fields.base.modular import Modular
from hfield.fields.base.ring import E, Ring, shared
from hfield.fields.polynomial_rings import PolynomialRing
from hfield.fields.quadratic_forms.norm_forms.zero_norm_answer import ZeroNorm, found, none
from hfield.fields.quadratic_forms.normal_forms import discriminant, root_if_known
from hfield.fields.rationals.ring import ZZ
from hfield.fields.rationals.whole_numbers import fraction

if TYPE_CHECKING:
    import flint

    from hfield.fields.base.flint_types import SparsePolynomial
    from hfield.fields.function_fields.quotients import FractionField, RationalFunction


Decide = Callable[[Ring, Constants], ZeroNorm]
MAX_TERMS = 40
POINTS = (1, 2, -1, 3, 0, -2, 5, -3)


def zero_norm_integral(ring: Ring, c: Constants, decide: Decide) -> ZeroNorm:
    """Decide over a ring that is not a field, by its residue fields or its field of fractions."""
    if isinstance(ring, Modular):
        return _residues(ring, c, decide)
    if ring == ZZ:
        return _integers(ring, c, decide)
    if isinstance(ring, PolynomialRing):
        return _polynomials(ring, c, decide)
    raise UndecidedError(f"{ring.no_field}: zero norms are not decided there")


def _residues(ring: Ring, c: Constants, decide: Decide) -> ZeroNorm:
    """Answer over ℤ/n: for a prime p | n, n/p times an element of norm 0 modulo p, because n divides
    p·(n/p)².
    """
    from hfield.fields.finite.names import GF

    n = ring.characteristic
    p = min(factorise(n))
    field = GF(p)
    answer = decide(field, Constants(*(field(int(x)) for x in c)))
    assert answer.element is not None, "over a finite field there always is a zero norm"
    q = [ring(n // p) * ring(int(x)) for x in answer.element]
    return found(ring, c, q, "residue field", f"{n // p} times an element of norm 0 modulo {p}")


def _integers(ring: Ring, c: Constants, decide: Decide) -> ZeroNorm:
    """Answer over ℤ as over ℚ, clearing denominators."""
    from hfield.fields.rationals.ring import QQ

    answer = decide(QQ, Constants(*(QQ(fraction(x)) for x in c)))
    if answer.element is None:
        return answer
    q = [fraction(x) for x in answer.element]
    m = math.lcm(*(x.denominator for x in q))
    whole = [int(x * m) for x in q]
    g = math.gcd(*whole)
    return found(ring, c, [ring(x // g) for x in whole], answer.method, answer.reason)


def _polynomials(ring: PolynomialRing, c: Constants, decide: Decide) -> ZeroNorm:
    """Decide over R[x, y, …] by specialising all variables but one.

    An element of norm 0 with coprime polynomial coordinates keeps norm 0 and stays nonzero if one variable
    takes a value at which (t² + 4a)·b is not 0. So an algebra that is a division algebra at one point is a
    division algebra.
    """
    easy = _roots(ring, c) or _monomials(ring, c)
    if easy:
        return easy
    used = [
        i for i in range(len(ring.variables)) if any(e[i] for x in c for e, _ in x.terms())
    ] or [0]
    for keep, point in itertools.islice(_points(used), 60):
        field: Any  # a field of a higher layer, whose elements are fractions of polynomials
        field = shared(PolynomialRing, ring.base, ring.variables[keep : keep + 1]).fractions
        special = Constants(*(_specialise(x, field, keep, point) for x in c))
        if field.is_zero(discriminant(field, special)):
            continue
        answer = decide(field, special)
        if answer.element is None:
            where = ", ".join(f"{ring.variables[i]} = {v}" for i, v in point.items())
            reason = (
                f"over {field.name}" + (f", at {where}" if where else "") + f": {answer.reason}"
            )
            return none(answer.method, reason, answer.places, *answer.assumes)
        if len(used) == 1:
            lifted = _lift(ring, field, keep, answer.element)
            return found(ring, c, lifted, answer.method, answer.reason)
    raise UndecidedError(
        f"whether a norm over {ring.name} can be 0 is not decided; tried: square roots; coordinates 0, ±1, "
        "± a variable; values for all variables but one"
    )


def _points(used: list[int]) -> Iterator[tuple[int, dict[int, int]]]:
    """Yield the variable to keep and values for the others."""
    for values in itertools.product(POINTS, repeat=len(used) - 1):
        for keep in used:
            yield keep, dict(zip((i for i in used if i != keep), values, strict=True))


def _specialise(x: SparsePolynomial, field: Ring[E], index: int, point: dict[int, int]) -> E:
    """Return x with the variable ``index`` kept and values substituted for those in ``point``."""
    total = field.zero
    for exponents, c in x.terms():
        scale = math.prod(v ** int(exponents[i]) for i, v in point.items())
        constant = int(c) if field.characteristic else c
        total = total + field(constant) * field(scale) * field.power(
            field.gen, int(exponents[index])
        )
    return total


def _lift(
    ring: PolynomialRing, field: FractionField, index: int, q: Sequence[RationalFunction]
) -> list[flint.nmod_mpoly]:
    """Clear the denominators of four rational functions, and convert them to the polynomial ring."""
    common = field.one
    for x in q:
        common = common * field.quotient((x * common).den, field.one.num)
    polys = [(x * common).num for x in q]
    rows = [list(p.coeffs()) for p in polys]
    scale = 1
    if field.characteristic == 0:
        scale = math.lcm(*(fraction(c).denominator for row in rows for c in row))
    gen = ring(ring.variables[index])
    lifted = []
    for row in rows:
        total = ring.zero
        for n, c in enumerate(row):
            value = int(c) if field.characteristic else int(fraction(c) * scale)
            total = total + ring(value) * ring.power(gen, n)
        lifted.append(total)
    return lifted


def _roots(ring: PolynomialRing, c: Constants) -> ZeroNorm | None:
    """Use a square root of ``(2i − t)²``, ``j²`` or ``(2k − tj)²``; in characteristic 2 of i², j², k²."""
    a, t, b = c
    zero, one, two = ring.zero, ring.one, ring(2)
    square = t * t + two * two * a
    if ring.characteristic == 2:
        if not ring.is_zero(t):
            return None
        trials = [
            (a, (zero, one, zero, zero)),
            (b, (zero, zero, one, zero)),
            (a * b, (zero, zero, zero, one)),
        ]
    else:
        trials = [
            (square, (zero - t, two, zero, zero)),
            (b, (zero, zero, one, zero)),
            (zero - square * b, (zero, zero, zero - t, two)),
        ]
    for x, (w, *vector) in trials:
        root = root_if_known(ring, x)
        if root is not None:
            reason = f"{ring.text(x)} is a square in {ring.name}"
            return found(ring, c, (w + root, *vector), "square root", reason)
    return None


def _monomials(ring: PolynomialRing, c: Constants) -> ZeroNorm | None:
    """Search among the elements with coordinates 0, ±1 and ± a variable."""
    if sum(len(x) for x in c) > MAX_TERMS:
        return None
    gens = [ring(v) for v in ring.variables][:3]
    values = [
        ring.zero,
        ring.one,
        *gens,
        *(-x for x in (ring.one, *gens) if ring.characteristic != 2),
    ]
    for q in itertools.product(values, repeat=4):
        if any(q) and norm(c, q) == 0:
            return found(ring, c, q, "search", "found among the coordinates 0, ±1 and ± a variable")
    return None
