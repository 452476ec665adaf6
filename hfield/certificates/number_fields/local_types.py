"""An order over ℤ_K prime by prime: its Eichler symbols, and the mass that they give."""

from fractions import Fraction

from hfield.certificates.number_fields.factoring import factored
from hfield.certificates.number_fields.integers import Factors, Prime
from hfield.certificates.number_fields.lattices import Lattice, Row
from hfield.certificates.number_fields.modular import echelon, remainder
from hfield.certificates.number_fields.zeta import zeta_minus_one
from hfield.certificates.rejection import reject


def mass(order: Lattice, factors: Factors) -> Fraction:
    """Return the mass of all classes over h_K, by ζ_K(−1) and Eichler symbols; both formulas are cited."""
    base = order.base
    found: Fraction = (
        abs(zeta_minus_one(base.integers, factors)) / 2 ** (base.n - 1) * order.discriminant
    )
    for q, symbol in symbols(order, factors):
        found *= 1 - Fraction(1, q**2) if symbol == 0 else 1 + Fraction(symbol, q)
    return found


def symbols(order: Lattice, factors: Factors) -> list[tuple[int, int]]:
    """Return the norms of the prime ideals of the discriminant, and the Eichler symbols there."""
    found = []
    for p in factored(order.discriminant):
        if p not in factors.above:
            reject(f"the prime ideals above {p} are missing")
        above = [factors.primes[k] for k in factors.above[p]]
        found += [(P.norm, _eichler_symbol(order, P)) for P in above if _divides(order, P)]
    return found


def _entry(order: Lattice, a: int, b: int) -> Row:
    """Return tr(x·conj(y)) of two rows of an order, an integer of the field."""
    return tuple(g[a][b] // order.unit for g in order.gram)


def _divides(order: Lattice, P: Prime) -> bool:
    """Tell whether a prime divides the discriminant: the trace form is degenerate there."""
    size = range(order.base.size)
    rows = [[c for b in size for c in remainder(_entry(order, a, b), P.span, P.p)] for a in size]
    return len(echelon(rows, P.p)) < 4 * P.degree


def _eichler_symbol(order: Lattice, P: Prime) -> int:
    """Return the Eichler symbol: that of the polynomial of some basis element with two roots, or 0."""
    base, p, q = order.base, P.p, P.norm
    integers = base.integers
    den = base.scale * base.conjugate_scale * order.den
    for a, row in enumerate(order.rows):
        trace = tuple(
            sum(c * t for c, t in zip(row, traces, strict=True)) // den for traces in base.traces
        )
        norm = tuple(c // 2 for c in _entry(order, a, a))

        def power(x: Row, e: int) -> list[int]:
            return remainder(integers.power_modulo(x, e, p), P.span, p)

        one_row = remainder(integers.one, P.span, p)
        if p > 2:
            square = integers.mul(trace, trace)
            delta = tuple(s - 4 * c for s, c in zip(square, norm, strict=True))
            found = power(delta, (q - 1) // 2)
            if any(found):
                return 1 if found == one_row else -1
        elif any(remainder(trace, P.span, p)):
            below = integers.power_modulo(trace, 2 * (q - 2) if q > 2 else 1, p)
            term = integers.mul(norm, below)
            total = [0] * base.n
            for e in range(P.degree):
                total = [
                    s + c for s, c in zip(total, integers.power_modulo(term, 2**e, p), strict=True)
                ]
            return -1 if any(remainder(total, P.span, p)) else 1
    return 0
