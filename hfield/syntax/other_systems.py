"""Read algebras in the notation of Magma, Sage and PARI; write algebras, elements and lattices for them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import lcm
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from hfield.core.product import Constants, Scalar
from hfield.errors import RingError, shorten

if TYPE_CHECKING:
    from flint import fmpq_poly

    from hfield.fields.base.ring import Ring

RATIONALS = ("Rationals()", "RationalField()", "QQ", "y")
WRITTEN = {  # over ℚ or GF(q); over ℚ[s]/(f), with the letter that represents s
    "magma": (
        "QuaternionAlgebra<{F} | {a}, {b}>",
        "QuaternionAlgebra<K | {a}, {b}> where K is NumberField(Polynomial([{c}]))",
        "K.1",
    ),
    "sage": (
        "QuaternionAlgebra({F}, {a}, {b})",
        "K.<s> = NumberField(QQ['s']([{c}])); QuaternionAlgebra(K, {a}, {b})",
        "s",
    ),
    "pari": ("alginit(nfinit({F}), [{a}, {b}])", "alginit(nfinit({f}), [{a}, {b}])", "y"),
}
_READ = (
    re.compile(
        r"QuaternionAlgebra<(?P<F>[^|]*)\|(?P<a>[^,]*),(?P<b>[^>]*)>"
        r"(?:whereKisNumberField\(Polynomial\(\[(?P<c>[^]]*)\]\)\))?"
    ),
    re.compile(
        r"(?:K\.<(?P<s>\w+)>=NumberField\((?:QQ\['\w+'\]\(\[(?P<c>[^]]*)\]\)|(?P<f>[^;]*))\);)?"
        r"QuaternionAlgebra\((?P<F>\w+(?:\(\w*\))?),(?P<a>.*),(?P<b>[^,]*)\)"
    ),
    re.compile(r"alginit\(nfinit\((?P<f>[^,]*)\),\[(?P<a>.*),(?P<b>.*)\]\)"),
)


@runtime_checkable
class _WithPolynomial(Protocol):
    """A number field ℚ[x]/(f) with its f."""

    @property
    def polynomial(self) -> fmpq_poly: ...


def written(F: Ring, c: Constants, system: str) -> str:
    """Write an algebra in the notation of a system.

    Raises :class:`RingError` for algebras with t ≠ 0, and over other fields.
    """
    name = system.lower()
    if name not in WRITTEN:
        raise RingError(f"expected one of {', '.join(WRITTEN)}, not {shorten(system)}")
    whole, extended, letter = WRITTEN[name]
    kind = _kind(F)
    a, b = (F.text(x if name != "pari" else x * F(pari_scale(F, x) ** 2)) for x in (c.a, c.b))
    if F.is_zero(c.t) and kind == "rationals":
        return whole.format(F={"magma": "Rationals()", "sage": "QQ", "pari": "y"}[name], a=a, b=b)
    if F.is_zero(c.t) and F.order is not None and F.order == F.characteristic and name != "pari":
        return whole.format(F=f"GF({F.order})", a=a, b=b)
    known = F.is_zero(c.t) and kind in ("number field", "quadratic field", "cyclotomic field")
    if not known or not isinstance(F, _WithPolynomial) or F.gen_name is None:
        raise RingError(f"an algebra with t ≠ 0, or over {F.name}, is not written for {system}")
    modulus = F.polynomial.coeffs()
    a, b = (x.replace(F.gen_name, letter) for x in (a, b))
    f = "+".join(f"({x})*{letter}^{n}" for n, x in enumerate(modulus) if x)
    return extended.format(a=a, b=b, f=f, c=", ".join(map(str, modulus)))


def _kind(F: Ring) -> object:
    """Return the kind of field by its data, None if it has none."""
    return None if F.data is None else F.data["kind"]


def pari_scale(F: Ring, x: Scalar) -> int:
    """Return a denominator of an element: PARI's constants must be integral, and i and j are multiplied by
    it.
    """
    return lcm(*map(int, re.findall(r"/(\d+)", F.text(x))))


Coordinates = Sequence[Scalar]
"""The coordinates of an element over 1, i, j, k."""
SIDES = {"left": "lideal", "right": "rideal", "two-sided": "ideal"}
"""Magma's constructors of ideals."""


class OtherSystemWriter:
    """Writes elements of an algebra, and lattices by their bases, as code for another system.

    For Sage and Magma these are expressions that name the algebra. For PARI, elements are columns ``[u, v]~``
    over the field of x with x² = a, for u + j·v, and lattices are vectors of columns. Raises
    :class:`RingError` as :func:`written` does.
    """

    def __init__(self, F: Ring, constants: Constants, system: str) -> None:
        self.algebra = written(F, constants, system)
        self.ring, self.constants, self.system = F, constants, system.lower()
        self._letter = WRITTEN[self.system][2]

    def element(self, q: Coordinates) -> str:
        """Write an element."""
        if self.system == "sage":
            return f"{self.algebra}({self._row(q)})"
        return self._named(self._part(q))

    def lattice(self, basis: Sequence[Coordinates]) -> str:
        """Write a lattice: for Sage as a fractional ideal, for others as the list of its basis."""
        if self.system == "sage":
            return f"{self.algebra}.ideal({self._list(basis)})"
        return self._named(self._list(basis))

    def order(self, basis: Sequence[Coordinates]) -> str:
        """Write an order."""
        return self._named(self._order(basis))

    def ideal(self, order: Sequence[Coordinates], basis: Sequence[Coordinates], side: str) -> str:
        """Write an ideal of an order, ``"left"``, ``"right"`` or ``"two-sided"``."""
        return self._named(self._ideal(self._order(order), basis, side))

    def ideals(
        self, order: Sequence[Coordinates], bases: Sequence[Sequence[Coordinates]], side: str
    ) -> str:
        """Write a list of ideals of one order."""
        name = "O" if self.system == "magma" else self._order(order)
        whole = f"[{', '.join(self._ideal(name, basis, side) for basis in bases)}]"
        if self.system == "magma":
            whole = f"{whole} where O is {self._order(order)}"
        return self._named(whole)

    def _named(self, text: str) -> str:
        """Write which algebra A is, in Magma's notation."""
        return f"{text} where A is {self.algebra}" if self.system == "magma" else text

    def _scalar(self, x: Scalar) -> str:
        text = self.ring.text(x)
        name = self.ring.gen_name
        return text.replace(name, self._letter) if name else text

    def _row(self, q: Coordinates) -> str:
        return f"[{', '.join(map(self._scalar, q))}]"

    def _part(self, q: Coordinates) -> str:
        """Write an element as part of a list."""
        if self.system != "pari":
            return f"A!{self._row(q)}" if self.system == "magma" else self._row(q)
        F = self.ring
        i, j = (F(pari_scale(F, x)) for x in (self.constants.a, self.constants.b))
        w, x, y, z = q[0], F.divide(q[1], i), F.divide(q[2], j), F.divide(q[3], i * j)
        return f"[{self._over_x(w, x)}, {self._over_x(y, F.zero - z)}]~"

    def _over_x(self, u: Scalar, v: Scalar) -> str:
        """Write u + v·x."""
        if self.ring.is_zero(v):
            return self._scalar(u)
        factor = self._scalar(v)
        times_x = f"{factor}*x" if factor.isalnum() else f"({factor})*x"
        return times_x if self.ring.is_zero(u) else f"{self._scalar(u)} + {times_x}"

    def _list(self, basis: Sequence[Coordinates]) -> str:
        return f"[{', '.join(map(self._part, basis))}]"

    def _order(self, basis: Sequence[Coordinates]) -> str:
        if self.system == "sage" and _kind(self.ring) != "rationals":
            # over number fields Sage's check fails; without it nothing is coerced
            definitions, algebra = self.algebra.split("; ")
            elements = ", ".join(f"B({self._row(q)})" for q in basis)
            return f"{definitions}; B = {algebra}; B.quaternion_order([{elements}], check=False)"
        if self.system == "sage":
            return f"{self.algebra}.quaternion_order({self._list(basis)})"
        if self.system == "pari":
            return self._list(basis)
        function = "QuaternionOrder" if _kind(self.ring) == "rationals" else "Order"
        return f"{function}({self._list(basis)})"

    def _ideal(self, order: str, basis: Sequence[Coordinates], side: str) -> str:
        if self.system == "pari":
            return self._list(basis)
        if self.system == "magma":
            return f"{SIDES[side]}<{order} | {self._list(basis)[1:-1]}>"
        if side != "two-sided":
            return f"{order}.{side}_ideal({self._list(basis)}, is_basis=True)"
        return f"{self.algebra}.ideal({self._list(basis)}, left_order={order}, right_order={order})"


def read(text: str) -> str | None:
    """Convert an algebra in the notation of Magma, Sage or PARI to hfield's; None for any other text.

    >>> read("QuaternionAlgebra< RationalField() | -1, -3 >"), read("alginit(nfinit(y^2-5), [-1, y])")
    ('(-1,-3|QQ)', '(-1,s|QQ[s]/(s^2-5))')
    """
    for pattern in _READ:
        found = pattern.fullmatch("".join(text.split()))
        if found is not None:
            break
    else:
        return None
    parts = {"s": None, "c": None, "f": None, "F": None, **found.groupdict()}
    letter = parts["s"] or ("K.1" if "<" in text else "y")
    field, f = parts["F"], parts["f"]
    if parts["c"]:
        f = "+".join(f"({x})*s^{n}" for n, x in enumerate(parts["c"].split(",")))
    if f is None or f in RATIONALS:
        field = "QQ" if field is None or field in RATIONALS else field.replace("FiniteField", "GF")
        return f"({parts['a']},{parts['b']}|{field})"
    a, b, f = (
        re.sub(rf"(?<!\w){re.escape(letter)}(?!\w)", "s", str(x))
        for x in (parts["a"], parts["b"], f)
    )
    f = re.sub(r"(?<!\w)x(?!\w)", "s", f)
    return f"({a},{b}|QQ[s]/({f}))"
