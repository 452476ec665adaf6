"""Decide whether the known digits of local numbers determine a Hilbert symbol, and how many digits suffice.

All numbers in x + O(πⁿ) have the same symbol if the products of x with a few factors do, because the symbol
is bilinear. The factors 1 + r·πᵐ, with r in a basis of the residue field over GF(2), generate 1 + O(πⁿ) up to
elements on which every symbol is 1. These elements are squares, which include 1 + O(4π), and in
characteristic 2 also norms, which include 1 + O(πᵐ) for m above the order of the pole of a. In characteristic
2, a stands for its class in F/{y² + y}, and r·π⁻ᵐ is added to it. (O'Meara, *Introduction to Quadratic
Forms*, 63:1 to 63:11; Serre, *Local Fields*, XIV.5.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, NoReturn

from hfield.core.product import Scalar
from hfield.errors import UndecidedError

if TYPE_CHECKING:
    from hfield.fields.local.element import LocalElement
    from hfield.fields.local.field import LocalField

SYMBOL = "whether the algebra is split"


def check_refinements(
    F: LocalField, a: LocalElement, b: LocalElement, is_division: Callable[[Scalar, Scalar], bool]
) -> None:
    """Raise :class:`UndecidedError`, with the number of digits, unless all numbers with the known digits of a
    and b have the same symbol.

    ``is_division`` returns whether the symbol of two elements of the global field is −1. In characteristic 2
    it is the symbol of [a, b | F), where a may be 0.
    """
    even = F.characteristic == 2
    F.check_digits(b, 1, SYMBOL)
    if even:
        first, second = list(_added(F, a)), list(_multiplied(F, b, F.pole(a) + 1))
    else:
        F.check_digits(a, 1, SYMBOL)
        first, second = (list(_multiplied(F, x, F.square_digits)) for x in (a, b))
    with_b = [b.value, *(y for _, y in second)]
    open_a = [n for n, x in first if any(is_division(x, y) for y in with_b)]
    open_b = [n for n, y in second if is_division(a.value, y)]
    if open_a and even:
        _refuse(F, a, max(open_a))
    for x, digits in ((a, open_a), (b, open_b)):
        if digits:
            F.check_digits(x, max(digits), SYMBOL)


def _multiplied(F: LocalField, x: LocalElement, digits: int) -> Iterator[tuple[int, Scalar]]:
    """Yield factors that map x to all numbers with its digits, each with the precision that excludes it."""
    known = x.digits()
    if known is not None:
        for m in range(known, digits):
            for r in F.residues.over_prime_field():
                yield m + 1, F.global_field.one + F.global_field(F.residues.lift(r)) * _power(F, m)


def _added(F: LocalField, x: LocalElement) -> Iterator[tuple[int, Scalar]]:
    """Yield summands, modulo y² + y, that map x to all numbers with its digits, each with the precision that
    excludes it.
    """
    if x.precision is not None:
        for m in range(x.precision, 1):
            for r in F.residues.over_prime_field():
                yield m + 1, F.global_field(F.residues.lift(r)) * _power(F, m)


def _power(F: LocalField, m: int) -> Scalar:
    power: Scalar = F.global_field.power(F.pi, m)
    return power


def _refuse(F: LocalField, x: LocalElement, n: int) -> NoReturn:
    raise UndecidedError(
        f"{SYMBOL} depends on digits of {x} that are not known: give it up to {F.big_o(n)} at least"
    )
