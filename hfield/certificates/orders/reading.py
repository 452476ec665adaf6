"""How the lattices and elements of a certificate are read: texts of the statement, JSON of the evidence."""

import re
from fractions import Fraction

from hfield.certificates.number_fields.matrices import rational_rows
from hfield.certificates.orders.algebra import Algebra
from hfield.certificates.orders.lattice import Element, Lattice
from hfield.certificates.orders.local_types import need_order
from hfield.certificates.rejection import (
    MAX_DIGITS,
    a_list,
    an_integer,
    an_object,
    reject,
    shown,
    texts,
)

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


def rows_of(text: str) -> tuple[tuple[Fraction, ...], ...]:
    """Read four rows of four rational numbers. Raises :class:`Rejected`."""
    rows = tuple(tuple(a_rational(x) for x in row.split(",")) for row in text.split("|"))
    if len(rows) != 4 or any(len(row) != 4 for row in rows):
        reject("a lattice is written as four rows of four numbers")
    return rows


def elements_of(text: str, count: int | None = None) -> list[Element]:
    """Read elements of four rational numbers. Raises :class:`Rejected`."""
    found = []
    for entry in text.split("|"):
        values = [a_rational(x) for x in entry.split(",")]
        if len(values) != 4:
            reject("an element is written as four numbers")
        den, rows = rational_rows([values])
        found.append(Element(den, rows[0]))
    if count not in (None, len(found)):
        reject(f"expected {count} elements, found {len(found)}")
    return found


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


def a_lattice(algebra: Algebra, text: str) -> Lattice:
    """Read a lattice of a statement. Raises :class:`Rejected`."""
    found = Lattice(algebra, *rational_rows(rows_of(text)))
    _ = found.key  # of rank 4
    return found


def an_order(algebra: Algebra, text: str) -> Lattice:
    """Read a lattice that has to be an order. Raises :class:`Rejected`."""
    order = a_lattice(algebra, text)
    need_order(order)
    return order


def a_side(text: str) -> str:
    """Read a side. Raises :class:`Rejected`."""
    if text not in SIDES:
        reject(f"the side must be left or right, found {shown(text)!r}")
    return text


def given_lattice(value: object, algebra: Algebra) -> Lattice:
    """Read a lattice of the evidence, ``den`` and ``rows``."""
    data = an_object(value, "den rows", "a lattice")
    rows = [
        tuple(an_integer(x, "an entry") for x in a_list(row, "a row"))
        for row in a_list(data["rows"], "rows")
    ]
    if len(rows) != 4 or any(len(row) != 4 for row in rows):
        reject("a lattice has four rows of four integers")
    return Lattice(algebra, an_integer(data["den"], "a denominator", 1), tuple(rows))


def another_basis(lattice: Lattice, value: object) -> Lattice:
    """Read another basis of a lattice."""
    found = given_lattice(value, lattice.algebra)
    if found.key != lattice.key:
        reject("these rows are no basis of the lattice that is run through")
    return found


def an_element(value: object) -> Element:
    """Read an element of the evidence. Raises :class:`Rejected`."""
    found = [a_rational(x) for x in texts(value, "an element")]
    if len(found) != 4:
        reject("an element has four coordinates")
    den, rows = rational_rows([found])
    return Element(den, rows[0])
