"""Finite fields: GF(p) on flint's residues, GF(pⁿ) on flint's ``fq_default``."""

import random
from collections.abc import Hashable, Iterator
from fractions import Fraction
from itertools import product
from typing import Any

import flint

from hfield import syntax
from hfield.errors import (
    HFieldError,
    NotationError,
    NotInvertibleError,
    RingError,
    TooLargeError,
    shorten,
)
from hfield.rings.base import Known, Ring
from hfield.rings.modular import WORD, Modular, factored, is_prime, prime_power
from hfield.rings.printing import from_unicode, sum_text
from hfield.rings.rational import rational, unwrap

MAX_BITS = 4096
MAX_DEGREE = 512
CONWAY_BELOW = 2**32  # every pⁿ below, n > 1, has its Conway polynomial in flint's and galois's tables
NAME = "x"


class PrimeField(Modular):
    """GF(p): elements are flint's ``nmod`` or ``fmpz_mod``, arrays galois's."""

    degree = 1

    def __init__(self, p: int) -> None:
        super().__init__(f"GF({p})", p, True)

    def __call__(self, x: Any) -> Any:
        """Turn an int n into n·1, a Fraction a/b into a·b⁻¹; read a text or a galois scalar."""
        if is_galois(x):
            return _arrays().from_galois(self, x)
        return super().__call__(x)

    def array(self, values: Any) -> Any:
        """Return an array of galois, or of flint's elements if the field is too large for galois."""
        return _arrays().array(self, values)

    def scalar(self, x: Any) -> Any:
        """Turn an entry of ``array`` back into an element."""
        return _arrays().scalar(self, x)

    def array_units(self, values: Any) -> Any:
        """Return a bool array: which entries are not 0."""
        return _arrays().units(self, values)

    def array_inverse(self, values: Any) -> Any:
        """Invert an array of nonzero entries elementwise."""
        return _arrays().inverse(self, values)

    def label(self, x: Any) -> int:
        """Return galois's integer label of x."""
        return int(x)

    def from_label(self, n: int) -> Any:
        """Return the element with galois's integer label n."""
        return self._make(n)


class ExtensionField(Ring):
    """GF(pⁿ), n > 1, as polynomials in x modulo an irreducible one; elements are ``fq_default``.

    ``modulus`` is its text, ``gen`` the class of x. A modulus is part of the name unless it is the
    one that flint takes by default: Conway's, wherever it is tabulated (every order below 2³² and
    many above), else a sparse irreducible polynomial; ``modulus_origin`` says which.
    """

    is_field = True
    gen_name = NAME

    def __init__(self, p: int, n: int, coefficients: list[int] | None = None) -> None:
        self.characteristic, self.degree, self.order = p, n, p**n
        default = flint.fq_default_ctx(p, n, NAME)
        self.context = default
        self.name = f"GF({p**n})"
        if coefficients is not None:
            modulus = flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(p))(coefficients)
            self.context = flint.fq_default_ctx(modulus=modulus, var=NAME)
        self.coefficients = [int(c) for c in self.context.modulus().coeffs()]
        self.modulus = _text(self.coefficients)
        self.is_default = self.coefficients == [int(c) for c in default.modulus().coeffs()]
        if not self.is_default:
            self.name = f"GF({p**n}, {self.modulus})"
        self._gen = self.context.gen()

    @property
    def modulus_origin(self) -> str:
        """Where the modulus comes from: ``given``, ``Conway`` or ``sparse``.

        Above 2³² the tables have gaps, and galois is asked (and imported).
        """
        if not self.is_default:
            return "given"
        if self.order is not None and self.order < CONWAY_BELOW:
            return "Conway"
        conway = _arrays().conway(self.characteristic, self.degree)
        return "Conway" if conway == self.coefficients else "sparse"

    @property
    def gen(self) -> Any:
        """The class of x."""
        return self._gen

    def __call__(self, x: Any) -> Any:
        """Turn an int n into n·1, a Fraction a/b into a·b⁻¹; read a text or a galois scalar.

        Raises :class:`CoercionError` for an element of another field or of another modulus.
        """
        if is_galois(x):
            return _arrays().from_galois(self, x)
        x = unwrap(x)
        if isinstance(x, flint.fq_default):
            # Adding is how flint tells whose element it is: an element has no public parent.
            try:
                return x + self.context.zero()
            except ValueError:
                mend = f"elements of different fields do not mix; the modulus here is {self.modulus}"
                raise self.refuse(x, shorten(mend, 120)) from None
        if isinstance(x, str):
            return self.parse(x)
        number = rational(x)
        if number is None:
            raise self.refuse(x)
        if isinstance(number, Fraction):
            top, bottom = (self._integer(m) for m in (number.numerator, number.denominator))
            return self.divide(top, bottom)
        return self._integer(number)

    def _integer(self, n: int) -> Any:
        return self.context(n % self.characteristic)

    def is_zero(self, x: Any) -> bool:
        """Tell whether x is 0."""
        return bool(x.is_zero())

    def equal(self, x: Any, y: Any) -> bool:
        """Tell whether x = y."""
        return bool(x == y)

    def key(self, x: Any) -> Hashable:
        """Return x itself: flint's elements are hashable."""
        return x

    def inverse(self, x: Any) -> Any:
        """Return 1/x. Raises :class:`NotInvertibleError` for 0."""
        if x.is_zero():  # flint itself aborts the whole process on inverse() of 0
            raise NotInvertibleError(f"cannot divide by 0 in {shorten(self.name)}")
        return x.inverse()

    def sqrt(self, x: Any) -> Any:
        """Return some y with y² = x, or None; in characteristic 2 the only one."""
        return x.sqrt() if x.is_zero() or x.is_square() else None

    @property
    def level(self) -> Known:
        """1 when −1 is a square, else 2."""
        squares = self.minus_one_as_squares()
        shown = " + ".join(f"({self.text(y)})^2" for y in squares)
        more = "" if len(squares) == 1 else ", and −1 itself is no square"
        return Known(len(squares), f"−1 = {shown} in {self.name}{more}")

    def minus_one_as_squares(self) -> tuple[Any, ...]:
        """Return one or two elements whose squares add up to −1: first 0, then every x is tried."""
        for x in self.elements():
            y = self.sqrt(self.context(-1) - x * x)
            if y is not None:
                return (y,) if x.is_zero() else (x, y)
        raise AssertionError("in a finite field −1 is a sum of two squares")

    def elements(self) -> Iterator[Any]:
        """Run through the pⁿ elements, 0 and 1 first, in the order of galois's labels."""
        digits = range(self.characteristic)
        for reversed_digits in product(digits, repeat=self.degree):
            yield self.context(list(reversed(reversed_digits)))

    def random(self, rng: random.Random) -> Any:
        """Return a random element; the same for the same seed."""
        return self.context([rng.randrange(self.characteristic) for _ in range(self.degree)])

    def power(self, x: Any, n: int) -> Any:
        """Return xⁿ; n < 0 inverts first. Exponents of any size are quick."""
        return (x if n >= 0 else self.inverse(x)) ** abs(n)

    def text(self, x: Any, style: str = "plain") -> str:
        """Write x as a polynomial in x, such as ``2*x+1``."""
        return _text([int(c) for c in x.to_list()], style)

    def array(self, values: Any) -> Any:
        """Return an array of galois, or of flint's elements if the field is too large for galois."""
        return _arrays().array(self, values)

    def scalar(self, x: Any) -> Any:
        """Turn an entry of ``array`` back into an element."""
        return _arrays().scalar(self, x)

    def array_units(self, values: Any) -> Any:
        """Return a bool array: which entries are not 0."""
        return _arrays().units(self, values)

    def array_inverse(self, values: Any) -> Any:
        """Invert an array of nonzero entries elementwise."""
        return _arrays().inverse(self, values)

    def label(self, x: Any) -> int:
        """Return galois's integer label of x: its coefficients as digits in base p."""
        n = 0
        for c in reversed(x.to_list()):
            n = n * self.characteristic + int(c)
        return n

    def from_label(self, n: int) -> Any:
        """Return the element with galois's integer label n."""
        digits = []
        for _ in range(self.degree):
            n, digit = divmod(n, self.characteristic)
            digits.append(digit)
        return self.context(digits)


def GF(q: Any, modulus: Any = None) -> PrimeField | ExtensionField:
    """Return the field of q elements; ``modulus`` is an irreducible polynomial in x, as text.

    q is an int or a text such as ``"3^2"``. Without a modulus it is Conway's. Raises
    :class:`RingError` when q is no prime power or the modulus does not fit.
    """
    from hfield.rings import ring

    p, n = _order(q)
    spec = f"GF({p**n})"
    if modulus is None:
        return ring(spec)  # type: ignore[no-any-return,unused-ignore]
    return _with_modulus(p, n, modulus)


def build(q: str, modulus: str | None) -> PrimeField | ExtensionField:
    """Make the field from the texts of its order and its modulus. Raises :class:`RingError`."""
    p, n = _order(q)
    if modulus is not None:
        return _with_modulus(p, n, modulus)
    return PrimeField(p) if n == 1 else ExtensionField(p, n)


def _order(q: Any) -> tuple[int, int]:
    """Read the order of a field as (p, n). Raises :class:`RingError`."""
    number = rational(q)
    if isinstance(number, int):
        return _split(number)
    text = str(q).replace(" ", "").replace("**", "^").replace("−", "-")
    base, caret, exponent = from_unicode(text).partition("^")
    exponent = exponent.removeprefix("(").removesuffix(")")
    digits = [part.removeprefix("-") for part in (base, *([exponent] if caret else []))]
    if not isinstance(q, str) or not all(d.isdecimal() and d.isascii() for d in digits):
        raise RingError(
            f"GF({shorten(q, 30)}): expected the number of elements, as in GF(9) or GF(3^2)"
        )
    if max(map(len, digits)) > 1300:
        raise RingError(_too_large(f"of {max(map(len, digits))} digits"))
    if not caret:
        return _split(int(base))
    p, n = int(base), int(exponent)
    if n < 1 or p < 2:
        raise RingError(f"GF({text}): expected a prime power such as GF(9) or GF(3^2)")
    if n > MAX_BITS or n * p.bit_length() > MAX_BITS + n:
        raise RingError(_too_large(f"{text}"))
    return _split(p**n)


def _split(q: int) -> tuple[int, int]:
    """Return (p, n) with q = pⁿ within the bounds. Raises :class:`RingError`."""
    if q.bit_length() > MAX_BITS:
        raise RingError(_too_large(f"of {q.bit_length()} bits"))
    try:
        pair = prime_power(q)
    except TooLargeError as error:
        raise RingError(f"GF({shorten(q, 30)}): {error}") from None
    if pair is None:
        raise RingError(f"GF({shorten(q, 30)}): {_not_a_prime_power(q)}")
    if pair[1] > MAX_DEGREE:
        raise RingError(_too_large(f"{pair[0]}^{pair[1]}"))
    return pair


def _too_large(what: str) -> str:
    return (
        f"GF(q) with q {what} is too large; at most {MAX_BITS} bits and degree {MAX_DEGREE} are taken"
    )


def _not_a_prime_power(q: int) -> str:
    """Say why there is no field of q elements, and which ones are near."""
    expected = "a field has p^n elements, p prime"
    if q < 2:
        return f"{shorten(q, 30)} is no prime power; {expected}, the smallest is GF(2)"
    if q > 10**9:
        return f"{shorten(q, 30)} is no prime power; {expected}"
    factors = " * ".join(f"{p}^{e}" if e > 1 else f"{p}" for p, e in factored(q) or [])
    below = next(m for m in range(q - 1, 1, -1) if prime_power(m))
    above = next(m for m in range(q + 1, 2 * q) if prime_power(m))
    return f"{q} = {factors} is no prime power; {expected}, the nearest are GF({below}) and GF({above})"


def _with_modulus(p: int, n: int, modulus: Any) -> PrimeField | ExtensionField:
    """Make GF(pⁿ) with the modulus of that text. Raises :class:`RingError` if it does not fit."""
    field = f"GF({shorten(p**n, 24)})"
    x = _polynomial(p, [0, 1])
    functions = {"**": _power, "/": _quotient}
    what = f"the polynomials in x over GF({shorten(p, 24)})"
    reader = syntax.Reader(lambda c: _constant(p, c), {NAME: x}, functions, what, MAX_BITS)
    try:
        m = reader.read(from_unicode(str(modulus)))
    except HFieldError as error:
        raise RingError(f"the modulus of {field} cannot be read: {error}") from error
    given = shorten(modulus)
    if n == 1:
        raise RingError(f"{field} is a prime field and takes no modulus: write {field}")
    if m.degree() != n:
        shown = "the zero polynomial" if m.degree() < 0 else f"of degree {m.degree()}"
        raise RingError(
            f"{field} needs a modulus of degree {n} over GF({p}); {given} is {shown} there"
        )
    m = m * _constant(p, pow(int(m.leading_coefficient()), -1, p))
    factors = m.factor()[1]
    if len(factors) > 1 or factors[0][1] > 1:
        parts = "*".join(
            f"({_text([int(c) for c in f.coeffs()])})" + (f"^{e}" if e > 1 else "") for f, e in factors
        )
        example = ExtensionField(p, n).modulus
        raise RingError(
            f"{given} = {shorten(parts)} is reducible over GF({p}), so it makes no field; "
            f"an irreducible modulus of {field} is {shorten(example)}"
        )
    return ExtensionField(p, n, [int(c) for c in m.coeffs()])


def _polynomial(p: int, coefficients: list[int]) -> Any:
    """Return flint's polynomial over GF(p), low degree first."""
    if p < WORD:
        return flint.nmod_poly([c % p for c in coefficients], p)
    return flint.fmpz_mod_poly_ctx(flint.fmpz_mod_ctx(p))(coefficients)


def _constant(p: int, c: int | Fraction) -> Any:
    if isinstance(c, Fraction):
        raise NotationError(f"the coefficient {c} is not an integer")
    return _polynomial(p, [c])


def _quotient(x: Any, y: Any) -> Any:
    raise NotationError("its coefficients must be integers, without a division")


def _power(x: Any, n: int) -> Any:
    if n < 0:
        raise NotationError(f"a polynomial has no terms of degree {n}")
    return x**n


def _text(coefficients: list[int], style: str = "plain") -> str:
    """Write a polynomial in x with coefficients given low degree first."""
    terms = [(str(c), [(NAME, n)]) for n, c in enumerate(coefficients) if c]
    return sum_text(reversed(terms), style)


def is_galois(x: Any) -> bool:
    """Tell whether x is a galois array or scalar, without importing galois."""
    return hasattr(type(x), "irreducible_poly")


def _arrays() -> Any:
    """Import the galois side only when an array is asked for."""
    from hfield.rings import galois_arrays

    return galois_arrays


__all__ = ["GF", "ExtensionField", "PrimeField", "build", "is_galois", "is_prime"]
