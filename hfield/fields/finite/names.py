"""Find the finite field that a text names: the order and the modulus are read and checked, with messages for
errors.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import flint

from hfield import syntax
from hfield.core.factorisation import factorise
from hfield.core.primality import prime_power
from hfield.errors import HFieldError, NotationError, RingError, TooLargeError, shorten
from hfield.fields.base.coercion import rational, whole_number
from hfield.fields.base.printing import from_unicode
from hfield.fields.base.residue_polynomials import coefficients, residues
from hfield.fields.base.ring import shared
from hfield.fields.finite.ring import NAME, ExtensionField, FiniteField, PrimeField, modulus_text

if TYPE_CHECKING:
    from hfield.fields.base.flint_types import Polynomial

MAX_BITS = 4096
MAX_DEGREE = 512


def GF(q: object, modulus: object = None) -> FiniteField:
    """Return the field of q elements; ``modulus`` is an irreducible polynomial in x, as text.

    q is an int or a text such as ``"3^2"``. By default the modulus is Conway's polynomial. Raises
    :class:`RingError` if q is not a prime power or the modulus does not fit.

    >>> GF(9).order, GF(7)(3) ** 2
    (9, 2)
    """
    p, n = _order(q)
    given = None if modulus is None else _modulus(p, n, modulus)
    if n == 1:
        return shared(PrimeField, p)
    field = shared(ExtensionField, p, n)
    if given is None or given == field.coefficients:
        return field
    return shared(ExtensionField, p, n, tuple(given))


def _order(q: object) -> tuple[int, int]:
    """Read the order of a field as (p, n). Raises :class:`RingError`."""
    number = rational(q)
    if isinstance(number, int):
        return _split(number)
    text = str(q).replace(" ", "").replace("**", "^").replace("−", "-")
    base, caret, exponent = from_unicode(text).partition("^")
    exponent = exponent.removeprefix("(").removesuffix(")")
    digits = [part.removeprefix("-") for part in (base, *([exponent] if caret else []))]
    if not isinstance(q, str) or not all(d.isdecimal() and d.isascii() for d in digits):
        value = whole_number(from_unicode(text)) if isinstance(q, str) else None
        if value is None:
            raise RingError(
                f"GF({shorten(q, 30)}): expected the number of elements, as in GF(9) or GF(3^2)"
            )
        return _split(value)
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
    return f"GF(q) with q {what} is too large; at most {MAX_BITS} bits and degree {MAX_DEGREE} are taken"


def _not_a_prime_power(q: int) -> str:
    """Return the message that no field of q elements exists, with the nearest orders."""
    expected = "a field has p^n elements, p prime"
    if q < 2:
        return f"{shorten(q, 30)} is not a prime power; {expected}, the smallest is GF(2)"
    if q > 10**9:
        return f"{shorten(q, 30)} is not a prime power; {expected}"
    factors = " * ".join(f"{p}^{e}" if e > 1 else f"{p}" for p, e in factorise(q).items())
    below = next(m for m in range(q - 1, 1, -1) if prime_power(m))
    above = next(m for m in range(q + 1, 2 * q) if prime_power(m))
    return f"{q} = {factors} is not a prime power; {expected}, the nearest are GF({below}) and GF({above})"


def _modulus(p: int, n: int, modulus: object) -> list[int]:
    """Read the modulus of GF(pⁿ), low degree first. Raises :class:`RingError` if it does not fit."""
    field = f"GF({shorten(p**n, 24)})"
    x = residues(p, [0, 1])
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
            f"({modulus_text(coefficients(f))})" + (f"^{e}" if e > 1 else "") for f, e in factors
        )
        example = ExtensionField(p, n).modulus
        raise RingError(
            f"GF({shorten(p**n, 24)}, {given}): {given} = {shorten(parts)} is reducible over GF({p}), so it "
            f"does not define a field; an irreducible modulus of {field} is {shorten(example)}"
        )
    return coefficients(m)


def _constant(p: int, c: int | Fraction) -> Polynomial:
    if isinstance(c, Fraction):
        raise NotationError(f"the coefficient {c} is not an integer")
    return residues(p, [c])


def _quotient(x: flint.nmod_poly, y: flint.nmod_poly) -> flint.nmod_poly:
    raise NotationError("its coefficients must be integers, without a division")


def _power(x: flint.nmod_poly, n: int) -> flint.nmod_poly:
    if n < 0:
        raise NotationError(f"a polynomial has no terms of degree {n}")
    return x**n
