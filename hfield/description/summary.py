"""Collect the invariants of an algebra, for ``hfield info``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from html import escape
from typing import TypeVar

from hfield.algebra import H, QuaternionAlgebra
from hfield.algebra.maps import Division, Splitting
from hfield.algebra.quaternion import Quaternion
from hfield.core.factorisation import Factors, known_primes
from hfield.core.product import Scalar
from hfield.errors import RingError, TooLargeError, UndecidedError
from hfield.fields import quadratic_forms
from hfield.fields.base.ring import INFINITY, Ring, WithIntegers
from hfield.fields.names import RingName
from hfield.fields.quadratic_forms.global_field import global_field
from hfield.notation import element_text, generic
from hfield.orders.lattice import Order

T = TypeVar("T")
SCHEMA = "hfield-info/1"
ORDERS_UP_TO = 4  # maximal orders over fields up to this degree take a tenth of a second


@dataclass(repr=False)
class Description:
    """Everything known about ``algebra``, as :func:`info` returns it; it is displayed as ``hfield info``
    prints it.

    An attribute that is None was not decided, or has no meaning for this algebra. ``undecided`` maps the
    names of the undecided ones to the reasons.

    >>> from hfield import info
    >>> info("H(GF(7))").division
    False
    """

    algebra: QuaternionAlgebra
    relations: tuple[str, ...] = ()
    normal_form: str | None = None
    substitution: str = ""
    commutative: bool | None = None
    center: tuple[Quaternion, ...] | None = None
    radical: tuple[Quaternion, ...] | None = None
    central_simple: bool | None = None
    derivations: int | None = None
    division: bool | None = None
    reason: str = ""
    assumes: tuple[str, ...] = ()
    zero_norm: Quaternion | None = None
    splitting: Splitting | None = None
    ramified: tuple[object, ...] | None = None
    discriminant: object = None
    order: Order | None = None
    units: int | None = None
    integers: Sequence[Scalar] | None = None
    undecided: dict[str, str] = field(default_factory=dict)

    def ask(self, name: str, question: Callable[[], T]) -> T | None:
        """Return the answer, or None after noting why the question was not decided."""
        try:
            return question()
        except (UndecidedError, TooLargeError) as error:
            self.undecided[name] = str(error)
        return None

    def __str__(self) -> str:
        from hfield.description.page import WIDTH, parts
        from hfield.presenting import page

        return page(parts(self), WIDTH)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"

    def to_json(self) -> dict[str, object]:
        """Return the summary as JSON data, with scalars as texts and elements as four scalars."""
        A, F = self.algebra, self.algebra.ring
        a, t, b = (F.text(c) for c in A.constants)
        level = "inf" if F.level.value == INFINITY else F.level.value
        return {
            "schema": SCHEMA,
            "algebra": A.name,
            "field": F.name,
            "field_in_words": F.in_words(),
            "characteristic": F.characteristic,
            "order_of_field": F.order,
            "level": level,
            "level_reason": F.level.reason,
            "constants": {"a": a, "t": t, "b": b},
            "relations": list(self.relations),
            "normal_form": self.normal_form,
            "table": [
                [element_text(F, q.coordinates, "plain", "e") for q in row]
                for row in A.multiplication_table()
            ],
            "commutative": self.commutative,
            "center": self._elements(self.center),
            "radical": self._elements(self.radical),
            "central_simple": self.central_simple,
            "derivations": self.derivations,
            "division": self.division,
            "reason": self.reason or None,
            "assumes": list(self.assumes),
            "zero_norm_element": None if self.zero_norm is None else self._texts(self.zero_norm),
            "splitting": self.splitting
            and {
                name: [[F.text(x) for x in row] for row in matrix]
                for name, matrix in (("i", self.splitting.i), ("j", self.splitting.j))
            },
            "ramified_places": None
            if self.ramified is None
            else [place_json(v) for v in self.ramified],
            "discriminant": self.discriminant_json(),
            "integers": None if self.integers is None else [F.text(x) for x in self.integers],
            "maximal_order": self.order
            and {
                "basis": [self._texts(q) for q in self.order.basis],
                "discriminant": self.discriminant_json(),
                "units": self.units,
            },
            "undecided": self.undecided,
        }

    def discriminant_json(self) -> object:
        """Return the discriminant: an int over ℚ, the text of a polynomial, or the texts of prime ideals."""
        if self.discriminant is None or isinstance(self.discriminant, int):
            return self.discriminant
        if isinstance(self.discriminant, tuple):
            return [str(v) for v in self.discriminant]
        return self.algebra.ring.text(self.discriminant)

    def _texts(self, q: Quaternion) -> list[str]:
        return [self.algebra.ring.text(x) for x in q.coordinates]

    def _elements(self, elements: tuple[Quaternion, ...] | None) -> list[list[str]] | None:
        return None if elements is None else [self._texts(q) for q in elements]


def place_json(place: object) -> object:
    """Return a prime as a number, and any other place as a text that can be read back."""
    return place if isinstance(place, int) else str(place)


def info(A: QuaternionAlgebra | Ring | int | str, factors: Factors | None = None) -> Description:
    """Return everything known about an algebra, as an object that is displayed as ``hfield info`` prints it.

    ``A`` is an algebra or its text, such as ``"(-1,-3|QQ)"``, the discriminant of an algebra over ℚ, or a
    ring or its text for H(F). ``factors`` may list primes of a and b if they are too hard to factor.
    Undecided questions do not raise an error; see ``undecided``. Raises :class:`NotationError` for a text
    that does not name an algebra.

    >>> from hfield import info
    >>> about = info("(-1,-3|QQ)")
    >>> about.division, about.discriminant, about.ramified
    (True, 3, (3, 'inf'))
    """
    with known_primes(factors):
        return _describe(algebra_named(A))


def algebra_named(by: QuaternionAlgebra | RingName) -> QuaternionAlgebra:
    """Return an algebra from an algebra, its text, a ring F or its text (for H(F)), or a discriminant.

    ``(a,b|F)``, for a general field F, is the algebra with variables as constants, over ``QQ(a,b)``.
    """
    if isinstance(by, QuaternionAlgebra):
        return by
    if isinstance(by, str):
        with suppress(RingError):
            return H(by)
        by = generic(by)
    return QuaternionAlgebra(by) if isinstance(by, (int, str)) else H(by)


def _describe(A: QuaternionAlgebra) -> Description:
    F, c = A.ring, A.constants
    d = Description(A, relations(A))
    d.commutative = d.ask("commutative", A.is_commutative)
    d.center = d.ask("center", A.center)
    if F.is_exact:
        d.radical = d.ask("radical", A.radical)
    if F.is_field and F.is_exact:
        d.central_simple = d.ask("central simple", A.is_central_simple)
    d.normal_form, d.substitution = d.ask("normal form", lambda: _normal_form(A)) or (None, "")
    derivations = d.ask("derivations", A.derivations)
    d.derivations = None if derivations is None else len(derivations)
    if d.central_simple:
        _ramify(d)
        _divide_or_split(d)
    else:
        d.division = d.ask("division", A.is_division_algebra)
        found = d.ask("zero_norm_element", lambda: quadratic_forms.zero_norm(F, c))
        if found is not None:
            d.zero_norm = None if found.element is None else A(*found.element)
            d.reason = "" if found.method == "search" else found.reason
            d.assumes = found.assumes
    return d


def _normal_form(A: QuaternionAlgebra) -> tuple[str | None, str]:
    """Return the algebra's name as (t² + 4a, b) or [a/t², b), and the element that replaces i."""
    F, (a, t, b) = A.ring, A.constants
    if not (F.is_field and F.is_exact) or F.is_zero(t):
        return None, ""
    if F.characteristic != 2:
        i = A(-t, 2, 0, 0)
        return QuaternionAlgebra(F, t * t + 4 * a, b).name, f"with {i.text('unicode')} for i"
    if F.is_zero(t - F.one):
        return None, ""
    s = F.inverse(t)
    i = A(0, s, 0, 0)
    return QuaternionAlgebra(F, a * s * s, b, 1).name, f"with {i.text('unicode')} for i"


def _divide_or_split(d: Description) -> None:
    answer = d.ask("division", d.algebra.division_or_splitting)
    if isinstance(answer, Division):
        d.division, d.reason, d.assumes = True, answer.reason, answer.assumes
    elif answer is not None:
        d.division, d.splitting, d.zero_norm = False, answer, answer.zero_divisor
        d.reason = answer.reason
    elif d.ramified:
        d.division, d.reason = True, f"it ramifies at {', '.join(map(str, d.ramified))}"
        del d.undecided["division"]
    elif (known := _known_division(d)) is not None:
        d.division = known
        d.undecided["splitting"] = d.undecided.pop("division")


def _known_division(d: Description) -> bool | None:
    """Return whether the algebra is a division algebra, if no splitting was found."""
    places = None if d.ramified is None else global_field(d.algebra.ring)
    if places is not None and places.splits_if_unramified:
        return False
    return d.ask("division", d.algebra.is_division_algebra)


def _ramify(d: Description) -> None:
    A, F = d.algebra, d.algebra.ring
    if F.order is not None or F.closure is not None:  # no places there
        return
    d.ramified = d.ask("ramified_places", A.ramified_places)
    if d.ramified is None:
        return
    d.discriminant = A.discriminant()
    if not isinstance(F, WithIntegers):
        return
    if F.degree > 1:
        d.integers = d.ask("integers", F.integral_basis)
    if F.degree > ORDERS_UP_TO:
        d.undecided["maximal_order"] = (
            f"not asked for here in degree {F.degree}, for it may take seconds: `maximal_order()` tells"
        )
        return
    d.order = order = d.ask("maximal_order", A.maximal_order)
    if order is not None and not A.is_over_number_field and "inf" in d.ramified:
        d.units = d.ask("units", lambda: len(order.units()))


def relations(A: QuaternionAlgebra) -> tuple[str, ...]:
    """Return the relations that define the product, in Unicode: ``i² = −1`` and so on."""
    _, i, j, _ = A.basis

    def text(q: Quaternion, unit: str = "") -> str:
        return element_text(A.ring, q.coordinates, "unicode", unit)

    return f"i² = {text(i * i)}", f"j² = {text(j * j)}", "ij = k", f"ji = {text(j * i, 'e')}"
