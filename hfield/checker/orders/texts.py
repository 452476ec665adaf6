"""Read the parts of statements about orders: rational numbers, rows, sides, words of a group."""

import re
from fractions import Fraction

from hfield.checker.language import split
from hfield.checker.rejection import MAX_DIGITS, reject, shown

SIDES = ("left", "right")


def a_rational(text: str) -> Fraction:
    """Read a rational number. Raises :class:`Rejected`."""
    m = re.fullmatch(r"\s*(-?[0-9]+)(?:/([0-9]+))?\s*", text, re.ASCII)
    if m is None or max(len(m[1]), len(m[2] or "")) > MAX_DIGITS:
        reject(f"{shown(text)!r} is no rational number that is read")
    denominator = int(m[2] or 1)
    if not denominator:
        reject(f"{shown(text)!r} divides by 0")
    return Fraction(int(m[1]), denominator)


def a_whole_number(text: str, what: str) -> int:
    """Read an integer. Raises :class:`Rejected`."""
    x = a_rational(text)
    if x.denominator != 1:
        reject(f"{what} must be an integer")
    return x.numerator


def a_side(text: str) -> str:
    """Read a side. Raises :class:`Rejected`."""
    if text not in SIDES:
        reject(f"the side must be left or right, found {shown(text)!r}")
    return text


def numbers_of(text: str) -> tuple[int, ...]:
    """Read integers between commas, or ``none``. Raises :class:`Rejected`."""
    if text.strip() == "none":
        return ()
    return tuple(a_whole_number(x, "an order") for x in text.split(","))


def words_of(text: str) -> tuple[tuple[int, ...], ...]:
    """Read words, integers between blanks, separated by commas; or ``none``. Raises :class:`Rejected`."""
    if text.strip() == "none":
        return ()
    return tuple(
        tuple(a_whole_number(x, "a letter") for x in word.split()) for word in text.split(",")
    )


def orbits_of(text: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Read ``field: a, a, …`` between bars, or ``none``, as texts. Raises :class:`Rejected`."""
    if text.strip() == "none":
        return ()
    found = []
    for orbit in split(text, "|"):
        field, colon, numbers = orbit.partition(":")
        if not colon:
            reject("an orbit is written as a field, a colon and eigenvalues")
        found.append((field.strip(), tuple(x.strip() for x in split(numbers, ","))))
    return tuple(found)


def signs_of(text: str) -> tuple[tuple[int, ...], ...]:
    """Read numbers 1 and −1 between commas, for each orbit, between bars; or ``none``."""
    if text.strip() == "none":
        return ()
    found = tuple(numbers_of(own) for own in text.split("|"))
    if not {x for own in found for x in own} <= {1, -1}:
        reject("a sign is 1 or -1")
    return found


def elements_of(
    text: str, why: str = "an element is written as four numbers"
) -> tuple[tuple[Fraction, ...], ...]:
    """Read elements between bars, of four rational numbers each. Raises :class:`Rejected`."""
    rows = tuple(tuple(a_rational(x) for x in row.split(",")) for row in text.split("|"))
    if any(len(row) != 4 for row in rows):
        reject(why)
    return rows


def rows_of(text: str) -> tuple[tuple[Fraction, ...], ...]:
    """Read four such elements, a basis. Raises :class:`Rejected`."""
    why = "a lattice is written as four rows of four numbers"
    rows = elements_of(text, why)
    if len(rows) != 4:
        reject(why)
    return rows
