"""``class-group{2,4}`` and ``unit-group{2; 1+s; …}``: ideal classes and units of a number field.

S is a set of prime ideals that generates the class group: every class has an ideal of norm up to a cited
bound, and each prime ideal up to that bound is reduced to S by an element. The given S-units are proved to
generate all S-units. The class group is ℤ^S modulo their exponents, and the units are the S-units with
exponents 0 (docs/explanation/trust.md).
"""

from collections.abc import Sequence
from fractions import Fraction
from math import factorial, gcd, isqrt, prod

from hfield.checker.budget import spend, spend_products
from hfield.checker.check_result import CheckResult
from hfield.checker.glossary import (
    ARTIN,
    BY_S_UNITS,
    CUSICK,
    FIELD,
    FRIEDMAN,
    HERMITE,
    MINKOWSKI,
    REDUCED_FORMS,
    ZIMMERT,
)
from hfield.checker.number_fields.bounds import ZIMMERT_FACTORS
from hfield.checker.number_fields.integers import Factors, RingOfIntegers, coefficients, field_of
from hfield.checker.number_fields.logarithms import DIGITS, Interval, Places, log, volume
from hfield.checker.number_fields.modular import echelon
from hfield.checker.number_fields.regulator import ShortUnits
from hfield.checker.rejection import a_list, an_integer, an_object, reject
from hfield.checker.scalars.finite import is_prime
from hfield.checker.scalars.names import a_rational
from hfield.checker.scalars.number_fields import Element, NumberField
from hfield.checker.scalars.rationals import over_one_denominator
from hfield.checker.statement import Setting

ONE = 1 << DIGITS
MAX_ROWS = 60
MAX_SATURATED = 20_000
PI = Fraction(314159265358979323846264338327950288, 10**35)
"""A little less than π."""


def class_group(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check that the class group is a product of cyclic groups of these orders, each dividing the next."""
    stated = [int(d) for d in parts[0].split(",")]
    _expect_proved(verdict)
    shown = SUnits(field_of(setting), evidence)
    if stated != (shown.invariants or [1]):
        reject("the class group is another one")
    return CheckResult(FIELD, BY_S_UNITS).citing(*shown.cites)


def unit_group(
    parts: tuple[str, ...], setting: Setting, verdict: str, evidence: object
) -> CheckResult:
    """Check the number of roots of unity, and that together with these units they generate the unit group."""
    _expect_proved(verdict)
    shown = SUnits(field_of(setting), evidence)
    assert setting.field is not None
    units = [coefficients(setting.field, setting.field.read(text)) for text in parts[1:]]
    if int(parts[0]) != shown.torsion_order:
        reject("there are not so many roots of unity")
    shown.need_fundamental(units)
    return CheckResult(FIELD, BY_S_UNITS).citing(*shown.cites)


def _expect_proved(verdict: str) -> None:
    if verdict != "proved":
        reject(f"evidence of S-units does not show that this is {verdict}")


class SUnits:
    """The S-units of the evidence, proved to generate all S-units."""

    KEYS = "kind basis primes S reductions generators torsion saturated"

    def __init__(self, field: NumberField, evidence: object) -> None:
        data = an_object(evidence, self.KEYS, "the evidence")
        if data["kind"] != "S-units":
            reject("what shows a class group, or units, is evidence of the kind 'S-units'")
        self.field, n = field, field.degree
        rows = [list(self.given(x)) for x in a_list(data["basis"], "the integral basis")]
        if len(rows) != n:
            reject(f"an integral basis has {n} elements")
        self.integers = RingOfIntegers(field, rows)
        self.places = Places(field.whole)
        self.cites: tuple[str, ...] = ()
        self.factors = Factors(self.integers, data["primes"])
        self.S = [an_integer(k, "the number of a prime ideal", 0) for k in a_list(data["S"], "S")]
        if len(set(self.S)) < len(self.S) or max(self.S, default=-1) >= len(self.factors.primes):
            reject("S has a prime ideal twice, or one that is not given")
        self._need_generators(data["reductions"])
        self.generators = [self.given(x) for x in a_list(data["generators"], "generators")]
        self.rows = [self._exponents(x) for x in self.generators]
        size = len(self.S) + self.places.rank
        if len(self.generators) != size or size > MAX_ROWS:
            reject(f"there are {size} generators of S-units, and at most {MAX_ROWS} are read")
        self._read_torsion(data["torsion"])
        self.volume = volume(self.rows, [self.logarithms(x) for x in self.generators])
        self.invariants = smith(self.rows, len(self.S))
        self._need_saturated(data["saturated"])

    def given(self, value: object) -> Element:
        """Read an element: the coefficients of 1, s, s², …"""
        found = tuple(a_rational(c, "a coefficient") for c in a_list(value, "an element"))
        if len(found) != self.field.degree:
            reject(f"an element has {self.field.degree} coefficients")
        return found

    def need_fundamental(self, units: Sequence[Element]) -> None:
        """Reject unless these units and the roots of unity generate all units."""
        if len(units) != self.places.rank:
            reject(f"the rank of the units is {self.places.rank}")
        for x in units:
            den, row = self.integers.coordinates(x)
            if den != 1 or abs(self.integers.norm(row)) != 1:
                reject("an element is not a unit")
        if units:
            low, high = volume([()] * len(units), [self.logarithms(x) for x in units])
            least = self.volume[0]
            spend_products([high], [least])
            if low <= 0 or high * prod(self.invariants) >= 2 * least:
                reject("these units do not generate all")

    # --- the primes ----------------------------------------------------------------------------------

    def _bounds(self) -> list[tuple[int, str]]:
        """Return bounds for the norms of primes that generate the class group, with the theorems, least bound
        last.
        """
        n, size, complex_ = self.field.degree, abs(self.integers.discriminant), self.places.complex
        if n == 2:
            return [(isqrt(size // (3 if complex_ else 5)), REDUCED_FORMS)]
        factor = Fraction(factorial(n), n**n) * (4 / PI) ** complex_
        found = [(isqrt(int(factor * factor * size)), MINKOWSKI)]
        if n in ZIMMERT_FACTORS:
            factor = ZIMMERT_FACTORS[n][complex_]
            found.append((isqrt(int(factor * factor * size)), ZIMMERT))
        return found

    def _need_generators(self, data: object) -> None:
        """Reject unless the primes in S generate the class group."""
        known = set(self.S)
        for entry in a_list(data, "reductions"):
            pair_ = a_list(entry, "a reduction", 2)
            k, x = an_integer(pair_[0], "the number of a prime ideal", 0), self.given(pair_[1])
            found = self.factors.exponents(x)
            if (
                len(pair_) != 2
                or k in known
                or abs(found.pop(k, 0)) != 1
                or not known >= found.keys()
            ):
                reject("a prime ideal is not reduced to those before")
            known.add(k)
        for bound, theorem in self._bounds():
            missing = self._missing(bound, known)
            if missing is None:
                self.cites += (theorem,)
                return
        assert missing is not None
        reject(missing)

    def _missing(self, bound: int, known: set[int]) -> str | None:
        """Describe the missing prime ideals of norm up to a bound; None if none is missing."""
        spend(bound)
        for p in range(2, bound + 1):
            if p not in self.factors.above and is_prime(p):
                return f"the prime ideals above {p} are missing"
        for k, P in enumerate(self.factors.primes):
            if P.norm <= bound and k not in known:
                return f"a prime ideal of norm {P.norm} is neither in S nor reduced"
        return None

    def _exponents(self, x: Element) -> list[int]:
        found = self.factors.exponents(x)
        row = [found.pop(k, 0) for k in self.S]
        if found:
            reject("an S-unit has a prime ideal that is not in S")
        return row

    def logarithms(self, x: Element) -> list[Interval]:
        """Return the logarithms of x at all infinite places except the last."""
        c, den = over_one_denominator([a / self.field.scale**k for k, a in enumerate(x)])
        return self.places.logarithms(c, den)[: self.places.rank] if self.places.rank else []

    # --- roots of unity ------------------------------------------------------------------------------

    def _read_torsion(self, value: object) -> None:
        """Read a root of unity of order w, and primes of degree one modulo which the roots of unity are
        distinct.
        """
        data = an_object(value, "order generator residues", "the torsion")
        w = self.torsion_order = an_integer(data["order"], "the number of roots of unity", 2)
        self.torsion = self.given(data["generator"])
        if w > 1_000:
            reject("a field of this degree has no root of unity of so large an order")
        if not self._is_one(self._power(self.torsion, w)) or any(
            self._is_one(self._power(self.torsion, w // p)) for p in range(2, w + 1) if w % p == 0
        ):
            reject("the root of unity has another order")
        if self.places.real and w != 2:
            reject("a field with a real place has two roots of unity")
        found = 0
        for entry in a_list(data["residues"], "residues"):
            found = gcd(found, self._degree_one(entry, self.field.degree + 2)[0] - 1)
        if not self.places.real and found != w:
            reject("it is not shown that there are no more roots of unity")

    def _power(self, x: Element, e: int) -> Element:
        out: Element = self.field.one
        for bit in bin(e)[2:]:
            out = self.field.mul(out, out)
            if bit == "1":
                out = self.field.mul(out, x)
        return out

    def _is_one(self, x: Element) -> bool:
        return x == self.field.one

    # --- saturation ----------------------------------------------------------------------------------

    def _degree_one(self, value: object, least: int) -> tuple[int, int]:
        """Read a prime q and a simple root r of f modulo q; then the field embeds in ℚ_q with s ≡ r
        modulo q.
        """
        pair_ = a_list(value, "a residue", 2)
        q, r = an_integer(pair_[0], "a prime", least), an_integer(pair_[1], "a root", 0)
        if len(pair_) != 2 or not is_prime(q) or self.field.scale % q == 0:
            reject("a residue is given by a prime number and a root")
        f, top = over_one_denominator(self.field.modulus)
        slope = [k * c for k, c in enumerate(f)][1:]
        if r >= q or top % q == 0 or _at(f, r, q) or not _at(slope, r, q):
            reject(f"{r} is not a simple root of the modulus modulo {q}")
        return q, r

    def _need_saturated(self, value: object) -> None:
        """Reject unless the given S-units generate all S-units, that is, no prime divides the index.

        The index is h'/h times the index of units, where h' is the order of ℤ^S modulo the exponents of the
        generators.
        """
        if self.volume[0] <= 0:
            reject("the S-units are not shown to be independent")
        given: set[int] = set()
        for entry in a_list(value, "saturated"):
            pair_ = a_list(entry, "a prime with residues", 2)
            ell = an_integer(pair_[0], "a prime", 2)
            if len(pair_) != 2 or ell in given or ell > MAX_SATURATED or not is_prime(ell):
                reject(f"expected primes up to {MAX_SATURATED}, each once and with residues alone")
            self._need_saturated_at(ell, pair_[1])
            given.add(ell)
        rest = prod(self.invariants)
        for ell in given:
            while rest % ell == 0:
                rest //= ell
        if rest > 1:
            spend(MAX_SATURATED // 10)
            ell = next((p for p in range(2, MAX_SATURATED) if rest % p == 0), rest)
            reject(f"it is not shown that the S-units are saturated at {ell}")
        if self.places.rank:
            self._need_units(given)

    def _need_units(self, given: set[int]) -> None:
        """Reject unless a regulator bound shows that no prime other than the given ones divides the index of
        the units.
        """
        least, source = self._least_volume()
        missing = self._missing_below(least, given)
        if missing and self.field.degree > 2:
            powers = [self.field.one]
            for _ in range(self.torsion_order - 1):
                powers.append(self.field.mul(powers[-1], self.torsion))
            least, source = ShortUnits(self.integers, self.places).least_volume(powers), HERMITE
            missing = self._missing_below(least, given) if least else missing
        if missing:
            reject(f"it is not shown that the S-units are saturated at {missing}")
        if source:
            self.cites += (source,)

    def _missing_below(self, least: int, given: set[int]) -> int:
        """Return a prime that may divide the index of the units but is not given, or 0."""
        limit = self.volume[1] // (prod(self.invariants) * least)
        spend(min(limit, MAX_SATURATED))
        for ell in range(2, min(limit, MAX_SATURATED) + 1):
            if ell not in given and is_prime(ell):
                return ell
        return limit if limit > MAX_SATURATED else 0

    def _need_saturated_at(self, ell: int, value: object) -> None:
        """Reject unless characters show that a product of the S-units is an ℓ-th power only if it is one in
        the span.
        """
        elements = list(self.generators)
        if self.torsion_order % ell == 0:
            elements.append(self.torsion)
        columns = []
        for entry in a_list(value, "residues", 1):
            q, r = self._degree_one(entry, 2)
            if q % ell != 1:
                reject(f"{q} is not 1 modulo {ell}")
            columns.append(_characters(ell, q, [self._residue(x, q, r) for x in elements]))
        if len(echelon(columns, ell)) < len(elements):
            reject(f"it is not shown that the S-units are saturated at {ell}")

    def _residue(self, x: Element, q: int, r: int) -> int:
        c, den = over_one_denominator(x)
        if den % q == 0 or not _at(c, r, q):
            reject(f"an S-unit is not a unit at the prime above {q}")
        return _at(c, r, q) * pow(den, -1, q) % q

    def _least_volume(self) -> tuple[int, str]:
        """Return a lower bound for the regulator, scaled by 2^(DIGITS·rank), and its source."""
        n, size, rank = self.field.degree, abs(self.integers.discriminant), self.places.rank
        if (
            n == 2
        ):  # a unit > 1 is at least (√(D − 4) + √D)/2, with the square (D − 2 + √(D² − 4D))/2
            root = isqrt(size * (size - 4) << 2 * DIGITS)
            return (log((size - 2 << DIGITS) + root)[0] - log(2 << DIGITS)[1]) // 2, ""
        least, source = ONE * 2052 // 10_000, FRIEDMAN
        if n == 3 and rank == 1 and size > 28:
            other = (log(size - 24)[0] - log(4)[1]) // 3
            if other > least:
                least, source = other, ARTIN
        if n == 3 and rank == 2:
            other = (log(size)[0] - log(4)[1]) ** 2 // 16 >> DIGITS
            if other > least:
                least, source = other, CUSICK
        return least << DIGITS * (rank - 1), source


def _at(f: Sequence[int], r: int, q: int) -> int:
    total = 0
    for c in reversed(f):
        spend(1 + c.bit_length() // 2_000)
        total = (total * r + c) % q
    return total


def _characters(ell: int, q: int, values: list[int]) -> list[int]:
    """Return the logarithms of x^((q − 1)/ℓ) modulo ℓ, to a common base."""
    power = (q - 1) // ell
    few = min(ell, 4 * isqrt(ell) + 1)
    spend(few + (20 + ell // few) * len(values))
    for b in range(2, q):
        omega = pow(b, power, q)
        if omega != 1:
            break
    table, w = {}, 1
    for k in range(few):
        table[w] = k
        w = w * omega % q
    back, found = pow(w, -1, q), []
    for x in values:
        w, k = pow(x, power, q), 0
        while w not in table:  # a power of omega, so that this ends
            w, k = w * back % q, k + few
        found.append(table[w] + k)
    return found


def smith(rows: Sequence[Sequence[int]], k: int) -> list[int]:
    """Return the orders other than 1 of the cyclic factors of ℤᵏ modulo rows, each dividing the next."""
    m = [list(row) for row in rows]
    found: list[int] = []
    for t in range(k):
        while True:
            spend(len(m) * k)
            entries = [
                (abs(m[r][c]), r, c) for r in range(t, len(m)) for c in range(t, k) if m[r][c]
            ]
            if not entries:
                reject("the exponents of the S-units are dependent")
            _, r, c = min(entries)
            m[t], m[r] = m[r], m[t]
            for row in m:
                row[t], row[c] = row[c], row[t]
            d = m[t][t]
            for r in range(t + 1, len(m)):
                f = m[r][t] // d
                if f:
                    m[r] = [x - f * y for x, y in zip(m[r], m[t], strict=True)]
            for c in range(t + 1, k):
                f = m[t][c] // d
                if f:
                    for row in m:
                        row[c] -= f * row[t]
            if any(m[r][t] for r in range(t + 1, len(m))) or any(m[t][t + 1 :]):
                continue
            bad = next((r for r in range(t + 1, len(m)) if any(x % d for x in m[r])), None)
            if bad is None:
                found.append(abs(d))
                break
            m[t] = [x + y for x, y in zip(m[t], m[bad], strict=True)]
    return [d for d in found if d != 1]


CHECKS = {"class-group": class_group, "unit-group": unit_group}
FORMS = {
    "class-group": "[1-9][0-9]{0,9}(,[1-9][0-9]{0,9}){0,9}",
    "unit-group": "[1-9][0-9]{0,3}(;[^;]+)*",
}
