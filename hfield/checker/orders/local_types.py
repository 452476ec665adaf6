"""The local types of an order: its Eichler symbols, and the mass computed from them."""

from fractions import Fraction

from hfield.checker.number_fields.factoring import factored
from hfield.checker.number_fields.integers import Prime, Primes
from hfield.checker.number_fields.matrices import Row
from hfield.checker.number_fields.modular import echelon, remainder
from hfield.checker.number_fields.zeta import zeta_minus_one
from hfield.checker.orders.lattice import Lattice


def mass(order: Lattice, primes: Primes) -> Fraction:
    """Return Σ 1/[O_L(I)ˣ : ℤ_Kˣ] over the right ideal classes, divided by the class number of the field.

    It is computed from ζ_K(−1) and Eichler symbols; both formulas are cited.
    """
    algebra = order.algebra
    found: Fraction = (
        abs(zeta_minus_one(algebra.integers, primes)) / 2 ** (algebra.n - 1) * order.discriminant
    )
    for P, symbol in symbols(order, primes):
        found *= 1 - Fraction(1, P.norm**2) if symbol == 0 else 1 + Fraction(symbol, P.norm)
    return found


def symbols(order: Lattice, primes: Primes) -> list[tuple[Prime, int]]:
    """Return the prime ideals of the discriminant, and the Eichler symbols there: 1, 0 or −1."""
    above = [P for p in factored(order.discriminant) for P in primes.at(p)]
    return [(P, _eichler_symbol(order, P)) for P in above if _divides(order, P)]


def _entry(order: Lattice, a: int, b: int) -> Row:
    """Return tr(x·conj(y)) of two rows of an order, an integer of the field."""
    return tuple(g[a][b] // order.unit for g in order.gram)


def _divides(order: Lattice, P: Prime) -> bool:
    """Return whether a prime divides the discriminant, that is, the trace form is degenerate modulo it."""
    size = range(order.algebra.size)
    rows = [[c for b in size for c in remainder(_entry(order, a, b), P.span, P.p)] for a in size]
    return len(echelon(rows, P.p)) < 4 * P.degree


def _eichler_symbol(order: Lattice, P: Prime) -> int:
    """Return the Eichler symbol: the symbol of the polynomial of some basis element with distinct roots, or
    0.

    The symbol says whether the roots lie in the residue field (docs/explanation/trust.md).
    """
    algebra, p, q = order.algebra, P.p, P.norm
    integers, den = algebra.integers, algebra.scale * order.den

    def power(x: Row, e: int) -> list[int]:
        return remainder(integers.power_modulo(x, e, p), P.span, p)

    for a, row in enumerate(order.rows):
        trace = tuple(c // den for c in algebra.trace(row))
        norm = tuple(c // 2 for c in _entry(order, a, a))
        if p > 2:
            square = integers.mul(trace, trace)
            found = power(tuple(s - 4 * c for s, c in zip(square, norm, strict=True)), (q - 1) // 2)
            if any(found):
                return 1 if found == remainder(integers.one, P.span, p) else -1
        elif any(remainder(trace, P.span, p)):
            below = integers.power_modulo(trace, 2 * (q - 2) if q > 2 else 1, p)
            term = integers.mul(norm, below)
            total = [0] * algebra.n
            for e in range(P.degree):
                conjugate = integers.power_modulo(term, 2**e, p)
                total = [s + c for s, c in zip(total, conjugate, strict=True)]
            return -1 if any(remainder(total, P.span, p)) else 1
    return 0
