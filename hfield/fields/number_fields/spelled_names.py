"""Number fields named after numbers: ``QQ(root(2,3))``, ``QQ(sqrt(2),I)``, ``QQ(zeta5)``, ``QQ(zeta7)+``.

Each number is known by its minimal polynomial and its complex value. A field with several is generated
by a sum θ = Σ cₙ·αₙ of small multiples; elements are polynomials in θ, and are written and read in the αₙ.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import flint

from hfield.errors import CoercionError, HFieldError, RingError, shorten
from hfield.fields.base.balls import precision
from hfield.fields.base.coercion import rational
from hfield.fields.base.printing import number_text, rational_json, sum_text
from hfield.fields.base.ring import Ring, shared
from hfield.fields.number_fields.elements import FieldElement, coefficients
from hfield.fields.number_fields.ring import NumberField
from hfield.fields.number_fields.sums import Value, common_root, evaluate, factor_at, sums_of_roots
from hfield.fields.number_fields.texts import (
    LARGEST_DEGREE,
    MAX_CONDUCTOR,
    MAX_DEGREE,
    NUMBER,
    power_sum,
)
from hfield.fields.rationals.ring import QQ
from hfield.syntax.brackets import is_balanced, split

if TYPE_CHECKING:
    import sympy

_POLYNOMIAL = "for another one write its polynomial, as in QQ[s]/(s^4-2*s^2-1)"


@dataclass(frozen=True)
class NamedNumber:
    """A named algebraic number: its text, its minimal polynomial over ℚ, and its value to any precision."""

    text: str
    polynomial: flint.fmpq_poly
    value: Value
    radicand: tuple[flint.fmpq, int] | None = None  # (r, n) for the n-th root of r


class SpelledField(NumberField):
    """ℚ(α, β, …) for numbers that have names; ``parts`` maps them to their images in powers of θ.

    >>> from hfield import ring
    >>> K = ring("QQ(sqrt(2),sqrt(3))")
    >>> K("(sqrt(2)+sqrt(3))^2"), K.degree, K.sqrt(K(6))
    (5+2*sqrt(2)*sqrt(3), 4, sqrt(2)*sqrt(3))
    """

    def __init__(self, name: str, numbers: list[NamedNumber]) -> None:
        self.name = name
        self.polynomial, self._value = numbers[0].polynomial, numbers[0].value
        self._numbers = numbers
        images, self._degrees = [flint.fmpq_poly([0, 1])], [int(numbers[0].polynomial.degree())]
        for number in numbers[1:]:
            images = self._adjoin(images, number)
        if self.degree < 2:
            raise RingError(f"{shorten(name)} is QQ itself: write QQ")
        if self.degree > LARGEST_DEGREE:
            raise RingError(
                f"{shorten(name)} has degree {self.degree}; at most {LARGEST_DEGREE} is taken"
            )
        self._images = images
        self.gen_name = self.text(self.gen)

    def __reduce__(self) -> tuple[object, ...]:
        return shared, (spelled, self.name)

    @property
    def data(self) -> dict[str, object]:
        """The field by the numbers in its name; ζₙ and the roots are the principal ones."""
        texts, radicands = [n.text for n in self._numbers], [n.radicand for n in self._numbers]
        if len(texts) == 1 and radicands[0] is not None:
            radicand, order = radicands[0]
            return {"kind": "root field", "radicand": rational_json(radicand), "order": order}
        if len(texts) == 1:
            kind = "real cyclotomic field" if self.name.endswith("+") else "cyclotomic field"
            return {"kind": kind, "order": int(re.sub(r"\D", "", texts[0]))}
        if all(r is not None and r[1] == 2 and r[0].denominator == 1 for r in radicands):
            return {
                "kind": "multiquadratic field",
                "d": [int(r[0].numerator) for r in radicands if r],
            }
        return {"kind": "field of numbers", "numbers": texts}

    def _adjoin(self, images: list[flint.fmpq_poly], number: NamedNumber) -> list[flint.fmpq_poly]:
        """Make θ a generator of the field with one more number; return the images of all numbers."""
        f = number.polynomial
        for scale in itertools.chain.from_iterable((n, -n) for n in itertools.count(1)):
            whole = sums_of_roots(self.polynomial, f, scale)
            if whole.gcd(whole.derivative()).degree() == 0:
                break
        old, value = self._value, number.value
        together: Value = lambda bits: old(bits) + scale * value(bits)  # noqa: E731
        factor = factor_at(whole, together)
        if factor.degree() > MAX_DEGREE:
            raise RingError(
                f"{shorten(self.name)} has degree {factor.degree()}; at most {MAX_DEGREE} is taken"
            )
        degree = int(self.polynomial.degree())
        larger = NumberField(factor, "s")
        beta = common_root(larger, f, self.polynomial, scale)
        alpha = larger.gen - beta * scale
        self.polynomial, self._value = larger.polynomial, together
        self._degrees.append(int(larger.degree) // degree)
        return [*(evaluate(larger, image, alpha).poly for image in images), beta.poly]

    @property
    def gen(self) -> FieldElement:
        """The number in the name, or the sum θ of multiples of them that generates the field."""
        return FieldElement(self, flint.fmpq_poly([0, 1]))

    @cached_property
    def parts(self) -> dict[str, FieldElement]:
        """The numbers in the name, as elements of the field: text to element."""
        return {
            n.text: FieldElement(self, image)
            for n, image in zip(self._numbers, self._images, strict=True)
        }

    @cached_property
    def principal(self) -> int:
        """The index of the embedding that gives the named numbers their values, up to complex conjugation."""
        bits = 64
        while True:
            value = self._value(bits)
            roots = self.embeddings.at(bits)
            near = [
                n for n, z in enumerate(roots) if z.overlaps(value) or z.overlaps(value.conjugate())
            ]
            if len(near) == 1:
                return near[0]
            bits *= 2

    def names(self) -> dict[str, FieldElement]:
        """The numbers with names: zeta5, I."""
        return {text: x for text, x in self.parts.items() if text.isidentifier()}

    def functions(self) -> dict[str, Callable[..., FieldElement]]:
        """Square roots, and the roots in the name."""
        return {
            "sqrt": self._sqrt_here,
            "root": self._root_here,
            "cbrt": lambda x: self._root_here(x, 3),
        }

    def _root_here(self, x: FieldElement, n: FieldElement | int) -> FieldElement:
        exponent = (
            rational(n.poly[0]) if isinstance(n, FieldElement) and n.is_rational() else rational(n)
        )
        x = self(x)
        for number, image in zip(self._numbers, self._images, strict=True):
            if number.radicand is not None and number.radicand[1] == exponent:
                ratio = x * self(number.radicand[0]).inverse()  # cⁿ for a rational c?
                c = (
                    _rational_root(ratio.poly[0], number.radicand[1])
                    if ratio.is_rational()
                    else None
                )
                if c is not None:
                    root: FieldElement = FieldElement(self, image) * c
                    return root
        if exponent == 2:
            return self._sqrt_here(x)
        raise CoercionError(
            f"root({shorten(x)},{shorten(n)}) is not known to lie in {shorten(self.name)}"
        )

    def generators(self) -> dict[str, FieldElement]:
        """Return nothing: zeta5 and I are numbers."""
        return {}

    def monomials(self) -> tuple[list[list[flint.fmpq]], list[tuple[int, ...]]]:
        """Return the powers of θ as combinations of products of the named numbers, and their exponents."""
        change, exponents = self._monomials
        n = self.degree
        return [[change[k, m] for m in range(n)] for k in range(n)], exponents

    def number_texts(self, style: str) -> list[str]:
        """Return the texts of the numbers in the name."""
        return [_in_style(n.text, style) for n in self._numbers]

    def value_near(self, x: FieldElement, bits: int) -> flint.acb:
        """Return the complex value of x where the numbers in the name have theirs."""
        with precision(bits + 16):
            generator, value = self._value(bits), flint.acb(0)
            for c in reversed(x.poly.coeffs()):
                value = value * generator + flint.acb(c)
        return value

    def to_sympy(self, x: FieldElement, symbols: Mapping[str, sympy.Symbol]) -> sympy.Expr:
        """Return x in sympy, as a combination of products of powers of the named numbers."""
        import sympy

        numbers = [_number_of_sympy(n) for n in self._numbers]
        return sympy.Add(
            *(
                sympy.Mul(
                    QQ.to_sympy(c, symbols),
                    *(y**n for y, n in zip(numbers, powers, strict=True)),
                )
                for c, powers in self.products(x)
            )
        )

    def products(self, x: FieldElement) -> Iterator[tuple[flint.fmpq, tuple[int, ...]]]:
        """Yield the terms of x as a polynomial in the named numbers: nonzero coefficients, and exponents."""
        change, exponents = self._monomials
        row = flint.fmpq_mat(1, self.degree, coefficients(x))
        return (
            (c, powers)
            for c, powers in zip((row * change).entries(), exponents, strict=True)
            if c != 0
        )

    @cached_property
    def _monomials(self) -> tuple[flint.fmpq_mat, list[tuple[int, ...]]]:
        """Return the matrix from powers of θ to products of powers of the numbers, and their exponents."""
        exponents = list(itertools.product(*(range(d) for d in self._degrees)))
        rows = []
        for powers in exponents:
            x = self.one
            for part, n in zip(self.parts.values(), powers, strict=True):
                x = x * self.power(part, n)
            rows += coefficients(x)
        return flint.fmpq_mat(self.degree, self.degree, rows).inv(), exponents

    def text(self, x: FieldElement, style: str = "plain") -> str:
        """Write x as a combination of products of powers of the named numbers."""
        shown = self.number_texts(style)
        return sum_text(
            (
                (number_text(c, style), [*zip(shown, powers, strict=True)])
                for c, powers in sorted(
                    self.products(x), key=lambda term: (sum(term[1]), [-n for n in term[1]])
                )
            ),
            style,
        )


def spelled(name: str) -> Ring:
    """Return the field of a text, ``QQ(sqrt(2),I)`` or ``QQ(zeta7)+``. Raises :class:`RingError`."""
    if name.endswith("+"):
        return real_cyclotomic(int(re.sub(r"\D", "", name)))
    return adjoined(name, name[name.index("(") + 1 : -1])


def adjoined(s: str, inner: str) -> NumberField:
    """Return ℚ(α, β, …) for the texts of numbers. Raises :class:`RingError`."""
    texts = split(inner, ",")
    if len(texts) == 1 and not _is_number(inner):
        return _generated(s, inner)
    once = {n.text: n for n in (read_number(s, text) for text in texts)}
    numbers = list(once.values())
    quadratic = [n.radicand for n in numbers if n.radicand is not None and n.radicand[1] == 2]
    if len(numbers) == 1 and quadratic:
        from hfield.fields.number_fields.quadratic.ring import build

        return build(number_text(quadratic[0][0]))
    numbers.sort(key=lambda n: n.text.isidentifier())  # roots first
    name = f"QQ({','.join(n.text for n in numbers)})"
    return SpelledField(name, numbers)


def _is_number(text: str) -> bool:
    """Return whether a text is one number with a name."""
    m = re.fullmatch(r"(?:sqrt|cbrt|root)\((.*)\)", text)
    return is_balanced(m[1]) if m else not re.search("[-+*/^]", text)


def _generated(s: str, text: str) -> NumberField:
    """Return the field that a text such as ``sqrt(2)+sqrt(3)`` generates, as that of the numbers in it.

    Raises :class:`RingError` for what cannot be read, and where these generate more.
    """
    whole = adjoined(s, ",".join(dict.fromkeys(re.findall(NUMBER, text))))
    try:
        x = whole(text)
    except HFieldError as error:
        raise RingError(f"{shorten(s)}: {error}; {_POLYNOMIAL}") from error
    found = x.minimal_polynomial()
    if len(found) == 2:
        raise RingError(f"{shorten(s)} is QQ itself: write QQ")
    if len(found) - 1 < whole.degree:
        shown = f"QQ[s]/({power_sum(found, 's')})"
        raise RingError(f"{shorten(s)} is smaller than {whole}: write {shown}")
    return whole


def real_cyclotomic(n: int) -> Ring:
    """Return the greatest real subfield of ℚ(ζₙ), generated by cₙ = ζₙ + ζₙ⁻¹ = 2·cos(2π/n)."""
    name = f"QQ(zeta{n})+"
    _check_conductor(name, n)
    value: Value = lambda bits: flint.acb(2 * (2 * flint.arb.pi() / n).cos())  # noqa: E731
    cyclotomic = flint.fmpz_poly.cyclotomic(n).coeffs()
    half = len(cyclotomic) // 2
    # Φ(z)·z^(−φ/2) in c = z + 1/z: the z^k + z^(−k) are Chebyshev polynomials
    c, polynomial = flint.fmpq_poly([0, 1]), flint.fmpq_poly([cyclotomic[half]])
    before, now = flint.fmpq_poly([2]), c
    for k in range(1, half + 1):
        polynomial = polynomial + now * flint.fmpq(cyclotomic[half - k])
        before, now = now, c * now - before
    if polynomial.degree() < 2:
        raise RingError(f"{name} is QQ itself: write QQ")
    return SpelledField(name, [NamedNumber(f"c{n}", polynomial, _precise(value))])


def read_number(field: str, text: str) -> NamedNumber:
    """Read ``sqrt(2)``, ``root(2,3)``, ``cbrt(2)``, ``zeta5`` or ``I``. Raises :class:`RingError`."""
    if text == "I":
        return NamedNumber(
            "I", flint.fmpq_poly([1, 0, 1]), lambda bits: flint.acb(0, 1), (flint.fmpq(-1), 2)
        )
    if m := re.fullmatch(r"zeta_?(\d+|\(\d+\))", text):
        n = int(m[1].strip("()"))
        _check_conductor(field, n)
        if n < 3:
            raise RingError(
                f"{shorten(field)}: zeta{n} is rational; expected zeta3, zeta4, zeta5, …"
            )
        polynomial = flint.fmpq_poly(flint.fmpz_poly.cyclotomic(n))
        turn: Value = lambda bits: flint.acb(2 * flint.arb.pi() / n * flint.acb(0, 1)).exp()  # noqa: E731
        return NamedNumber(f"zeta{n}", polynomial, _precise(turn))
    m = re.fullmatch(r"(sqrt|cbrt)\((.+)\)|(root)\((.+),(\d+)\)", text)
    if m is None:
        raise RingError(
            f"{shorten(field)}: {shorten(text)!r} is not one of the numbers that define a field here: "
            f"sqrt(2), root(2,3), zeta5, I; {_POLYNOMIAL}"
        )
    n = int(m[5]) if m[3] else {"sqrt": 2, "cbrt": 3}[m[1]]
    try:
        radicand = QQ(m[4] or m[2])
    except HFieldError as error:
        raise RingError(
            f"{shorten(field)}: expected a rational number under the root: {error}"
        ) from error
    if not 2 <= n <= MAX_DEGREE or radicand == 0:
        raise RingError(
            f"{shorten(field)}: expected a root of order 2 to {MAX_DEGREE} of a number other than 0"
        )
    sign = (
        -1 if radicand < 0 and n % 2 else 1
    )  # the real root of a number that has one, as RR and CC read it
    root: Value = lambda bits: sign * flint.acb(flint.arb(sign * radicand)).root(n)  # noqa: E731
    shown = number_text(radicand)
    polynomial = factor_at(flint.fmpq_poly([-radicand, *[0] * (n - 1), 1]), _precise(root))
    if polynomial.degree() < 2:
        raise RingError(f"{shorten(field)}: {shorten(text)} is rational; leave it out")
    name = f"root({shown},{n})" if n > 2 else "I" if radicand == -1 else f"sqrt({shown})"
    return NamedNumber(name, polynomial, _precise(root), (radicand, n))


def _number_of_sympy(number: NamedNumber) -> sympy.Expr:
    """Return a number in the name of a field as sympy has it."""
    import sympy

    if number.radicand is not None:
        radicand, n = number.radicand
        value = sympy.Rational(int(radicand.p), int(radicand.q))
        return -sympy.root(-value, n) if value < 0 and n % 2 else sympy.root(value, n)
    n = int(re.sub(r"\D", "", number.text))
    turn = sympy.exp(2 * sympy.pi * sympy.I / n)
    return turn if number.text.startswith("zeta") else 2 * sympy.cos(2 * sympy.pi / n)


def _check_conductor(field: str, n: int) -> None:
    if not 1 <= n <= MAX_CONDUCTOR:
        raise RingError(f"{shorten(field)}: roots of unity of order 3 to {MAX_CONDUCTOR} are taken")


def _precise(value: Value) -> Value:
    def at(bits: int) -> flint.acb:
        with precision(bits + 16):
            return value(bits)

    return at


def _rational_root(x: flint.fmpq, n: int) -> flint.fmpq:
    """Return the rational n-th root of x, positive unless x is negative, or None."""
    if x <= 0:
        root = _rational_root(-x, n) if x and n % 2 else None
        return None if root is None else -root
    p, q = x.p.root(n), x.q.root(n)
    return flint.fmpq(p, q) if flint.fmpq(p, q) ** n == x else None


def _in_style(text: str, style: str) -> str:
    if style == "latex":
        text = re.sub(r"^sqrt\((.*)\)$", r"\\sqrt{\1}", text)
        text = re.sub(r"^root\((.*),(\d+)\)$", r"\\sqrt[\2]{\1}", text)
        return re.sub(r"^zeta(\d+)$", r"\\zeta_{\1}", re.sub(r"^c(\d+)$", r"c_{\1}", text))
    return re.sub(r"^sqrt\((\d+)\)$", r"√\1", text) if style == "unicode" else text
