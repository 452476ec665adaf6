"""F(t) over ℚ, a number field or a finite field: fractions of polynomials, compared by cross-multiplication.

Over GF(q) the places are the prime polynomials and infinity.
"""

from collections.abc import Callable, Hashable, Mapping
from typing import NoReturn

from hfield.checker.budget import spend
from hfield.checker.glossary import reads_like_a_constant
from hfield.checker.language import Tree
from hfield.checker.rejection import a_list, an_integer, an_object, keyed, reject, shown
from hfield.checker.scalars.finite import Finite
from hfield.checker.scalars.names import blackboard, plain, polynomial_text, variables
from hfield.checker.scalars.place import AnyPlace, E
from hfield.checker.scalars.polynomials import MAX_DEGREE, Poly, PolynomialRing, dense
from hfield.checker.scalars.quotients import QuotientField
from hfield.checker.scalars.residues import OverFiniteField
from hfield.checker.scalars.ring import AnyRing, Kind, ReadRing, Ring

Fraction = tuple[Poly[E], Poly[E]]


class Functions(Ring[Fraction[E]]):
    """``base(variable)``, the rational functions in one variable over a field."""

    is_field = True

    def __init__(self, base: Ring[E], variable: str) -> None:
        self.base, self.variable = base, variable
        self.polynomials = PolynomialRing(base, (variable,))
        strange = reads_like_a_constant(variable)
        self.name = f"Frac({self.polynomials.name})" if strange else f"{base.name}({variable})"
        self.words = f"the rational functions in {variable} over {blackboard(base.name)}"
        self.characteristic = base.characteristic
        self.zero: Fraction[E] = ((), self.polynomials.one)
        self.one: Fraction[E] = (self.polynomials.one, self.polynomials.one)

    def number(self, n: int) -> Fraction[E]:
        """Return n·1."""
        return self._fraction(self.polynomials.number(n), self.polynomials.one)

    def add(self, x: Fraction[E], y: Fraction[E]) -> Fraction[E]:
        """Return x + y."""
        p = self.polynomials
        if x[1] == y[1]:
            return self._fraction(p.add(x[0], y[0]), x[1])
        return self._fraction(p.add(p.mul(x[0], y[1]), p.mul(y[0], x[1])), p.mul(x[1], y[1]))

    def neg(self, x: Fraction[E]) -> Fraction[E]:
        """Return −x."""
        return (self.polynomials.neg(x[0]), x[1])

    def mul(self, x: Fraction[E], y: Fraction[E]) -> Fraction[E]:
        """Return x·y."""
        p = self.polynomials
        return self._fraction(p.mul(x[0], y[0]), p.mul(x[1], y[1]))

    def inverse(self, x: Fraction[E]) -> Fraction[E] | None:
        """Return 1/x, None for 0."""
        return self._fraction(x[1], x[0]) if x[0] else None

    def is_zero(self, x: Fraction[E]) -> bool:
        """Return whether x is 0."""
        return not x[0]

    def constant(self, tree: Tree) -> Fraction[E] | None:
        """Return the variable, or a constant of the base."""
        x = self.polynomials.constant(tree)
        return None if x is None else (x, self.polynomials.one)

    def sign(self, x: Fraction[E]) -> int | None:
        """Return the sign for large values of the variable, if the base is ordered."""
        if self.base.sign(self.base.one) is None:
            return None
        if not x[0]:
            return 0
        signs = [self.base.sign(part[-1][1]) for part in x]
        return None if None in signs else (signs[0] or 0) * (signs[1] or 0)

    def signs(self, x: Fraction[E]) -> tuple[int | None, ...]:
        """Return the signs for large and for small values of the variable, positive and negative."""
        sign = self.sign(x)
        if sign is None or not x[0]:
            return (sign,) * 4
        out = []
        for end in (-1, 0):
            terms = [part[end] for part in x]
            plus = (self.base.sign(terms[0][1]) or 0) * (self.base.sign(terms[1][1]) or 0)
            odd = (terms[0][0][0] + terms[1][0][0]) % 2
            out += [plus, -plus if odd else plus]
        return tuple(out)

    def is_square(self, x: Fraction[E]) -> bool:
        """Return whether x = f/g is a square: f·g must have a square leading coefficient and a root as
        polynomial.

        In characteristic 2 this is not decided.
        """
        if not x[0]:
            return True
        if self.characteristic == 2:
            return super().is_square(x)
        base, polynomials = self.base, self.polynomials
        f = dict(polynomials.mul(*x))
        degree = max(f)[0]
        if degree > MAX_DEGREE:
            reject(f"squares are not recognised above the degree {MAX_DEGREE}")
        spend(5 * degree**2)
        lead = f[(degree,)]
        if degree % 2 or not base.is_square(lead):
            return False
        scale = base.need_inverse(lead)
        monic = {m: base.mul(c, scale) for m, c in f.items()}
        half = degree // 2
        below_two = base.need_inverse(base.number(2))
        root = [base.zero] * half + [base.one]
        for n in range(half - 1, -1, -1):  # the coefficient of degree half + n determines root[n]
            total = monic.get((half + n,), base.zero)
            for m in range(n + 1, half):
                total = base.add(total, base.neg(base.mul(root[m], root[half + n - m])))
            root[n] = base.mul(total, below_two)
        found = tuple(((n,), c) for n, c in enumerate(root) if not base.is_zero(c))
        return bool(dict(polynomials.mul(found, found)) == monic)

    def level_above(self, bound: int) -> bool:
        """Use the field F of constants: a constant that is a sum of squares in F(t) is one in F."""
        return self.base.level_above(bound)

    def is_fraction_field_of(self, ring: AnyRing) -> bool:
        """Return whether these are the fractions of polynomials, over the same field or over ℤ."""
        if not isinstance(ring, PolynomialRing) or ring.names != (self.variable,):
            return False
        return self.base.name == ring.base.name or self.base.is_fraction_field_of(ring.base)

    def place(self, data: object) -> AnyPlace[Fraction[E]]:
        """Return a place of GF(q)(t), of the kind ``prime polynomial`` or ``infinity``."""
        kind = keyed(data, "a place").get("kind")
        if not isinstance(self.base, Finite) or kind not in ("prime polynomial", "infinity"):
            return super().place(data)
        if kind == "infinity":
            an_object(data, "kind", "a place")
            return Infinity(self, self.base)
        found = an_object(data, "kind coefficients", "a place")["coefficients"]
        return PrimePolynomial(self, self.base, a_list(found, "a prime polynomial", 2))

    def at(self, point: str) -> tuple[Ring[E], Callable[[Fraction[E]], E]]:
        """Return F, and the value of a fraction at an element of F."""
        base, at = self.base, self.base.read(point)

        def part(f: Poly[E]) -> E:
            total = base.zero
            for coefficient in reversed(dense(f, base)):
                total = base.add(base.mul(total, at), coefficient)
            return total

        def value(x: Fraction[E]) -> E:
            below = base.inverse(part(x[1]))
            if below is None:
                reject(f"a constant has no value at {shown(point)}")
            return base.mul(part(x[0]), below)

        return base, value

    def _fraction(self, top: Poly[E], below: Poly[E]) -> Fraction[E]:
        """Divide by the greatest common divisor, to keep fractions small."""
        if not top:
            return self.zero
        if len(below) == 1 and not any(below[0][0]):
            return (self._scaled(top, below[0][1]), self.polynomials.one)
        divisor = self._gcd(dense(top, self.base), dense(below, self.base))
        f, g = (self.divided(dense(x, self.base), divisor)[0] for x in (top, below))
        lead = self.base.need_inverse(g[-1])
        return self._sparse(f, lead), self._sparse(g, lead)

    def _scaled(self, f: Poly[E], c: E) -> Poly[E]:
        inverse = self.base.need_inverse(c)
        return tuple((m, self.base.mul(d, inverse)) for m, d in f)

    def _sparse(self, f: list[E], scale: E) -> Poly[E]:
        return tuple(
            ((n,), self.base.mul(c, scale)) for n, c in enumerate(f) if not self.base.is_zero(c)
        )

    def divided(self, f: list[E], g: list[E]) -> tuple[list[E], list[E]]:
        """Return quotient and remainder; low degree first, no leading zeros."""
        b, f = self.base, list(f)
        lead = b.need_inverse(g[-1])
        quotient = [b.zero] * max(len(f) - len(g) + 1, 0)
        spend(len(f) + len(g))
        while len(f) >= len(g):
            spend(10 * len(g))
            shift, c = len(f) - len(g), b.mul(f[-1], lead)
            quotient[shift] = c
            for k, v in enumerate(g, shift):
                f[k] = b.add(f[k], b.neg(b.mul(c, v)))
            while f and b.is_zero(f[-1]):
                f.pop()
        return quotient, f

    def _gcd(self, f: list[E], g: list[E]) -> list[E]:
        while g:
            f, g = g, self.divided(f, g)[1]
        return f


class SeveralVariables(Functions[Hashable]):
    """``base(names)``: function fields over function fields, one variable after another."""

    def __init__(self, base: AnyRing, names: tuple[str, ...]) -> None:
        *first, last = names
        field = base
        for name in first:
            field = Functions(field, name)
        super().__init__(field, last)
        self.constants, self.names, listed = base, names, ",".join(names)
        strange = any(map(reads_like_a_constant, names))
        self.name = f"Frac({base.name}[{listed}])" if strange else f"{base.name}({listed})"
        self.words = f"the rational functions in {', '.join(names)} over {blackboard(base.name)}"

    def is_fraction_field_of(self, ring: AnyRing) -> bool:
        """Return whether these are the fractions of polynomials, over the same field or over ℤ."""
        if not isinstance(ring, PolynomialRing) or ring.names != self.names:
            return False
        below = self.constants
        return below.name == ring.base.name or below.is_fraction_field_of(ring.base)

    def at(self, point: str) -> NoReturn:
        """Reject the point: functions of several variables are not evaluated."""
        reject(f"the elements of {self.name} have no values at points here")


class PrimePolynomial(OverFiniteField[Fraction[E], tuple[E, ...]]):
    """GF(q)(t) at a prime polynomial P; fractions whose denominator P does not divide are integral.

    P is monic, with reduced coefficients, low degree first: integers, or lists of integers over GF(pⁿ).
    """

    def __init__(self, field: Functions[E], base: Finite[E], coefficients: list[object]) -> None:
        self.base = base
        top, texts = zip(*(_coefficient(base, c) for c in coefficients), strict=True)
        if not base.equal(top[-1], base.one):
            reject("a prime polynomial is monic")
        self.residues: QuotientField[E] = QuotientField(base, top)
        self.name = f"({polynomial_text(texts, field.variable)})"
        powers = tuple(((n,), c) for n, c in enumerate(top) if not base.is_zero(c))
        self.odd: Fraction[E] = (powers, field.polynomials.one)

    def residue(self, x: Fraction[E]) -> tuple[E, ...] | None:
        """Return numerator over denominator modulo P."""
        k = self.residues
        top, below = (k.reduce(dense(part, self.base)) for part in x)
        inverse = k.inverse(below)
        return None if inverse is None else k.mul(top, inverse)


class Infinity(OverFiniteField[Fraction[E], E]):
    """GF(q)(t) at infinity: a fraction is integral if its degree is not positive."""

    def __init__(self, field: Functions[E], base: Finite[E]) -> None:
        self.residues, self.base, self.name = base, base, "inf"
        one = field.polynomials.one
        self.odd: Fraction[E] = (one, (((1,), base.one),))

    def residue(self, x: Fraction[E]) -> E | None:
        """Return the quotient of the coefficients at the degree of the denominator."""
        base = self.base
        top, below = (dense(part, base) for part in x)
        if len(top) > len(below):
            return None
        residue = base.zero
        return residue if len(top) < len(below) else base.mul(top[-1], base.need_inverse(below[-1]))


def _coefficient(base: Finite[E], value: object) -> tuple[E, str]:
    """Read an element of a finite field, an integer or a list of coefficients; return its text as well."""
    p, degree = base.characteristic, base.digits
    digits = [value] if degree == 1 else a_list(value, "a coefficient")
    found = [an_integer(c, "a coefficient", 0) for c in digits]
    if len(found) != degree or max(found) >= p:
        reject(f"a coefficient in {base.name} has {degree} entries from 0 to {p - 1}")
    return base.from_digits(found), polynomial_text(found, "x")


def _functions(data: Mapping[str, object], ring: ReadRing) -> AnyRing:
    base = ring(plain(data, "base variables")["base"])
    need_constants(base)
    names = variables(data["variables"], base)
    return Functions(base, names[0]) if len(names) == 1 else SeveralVariables(base, names)


def need_constants(base: AnyRing) -> None:
    """Reject constant fields other than QQ, a number field or a finite field."""
    known = base.name == "QQ" or base.is_number_field or base.order is not None
    if not (known and base.is_field):
        reject(
            f"functions are over QQ, a number field or a finite field, not over {shown(base.name)}"
        )


KINDS: dict[str, Kind] = {"rational functions": _functions}
