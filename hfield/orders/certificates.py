"""Answers about lattices, and what they and other claims say as certificates ``hfield-cert/2``."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

from hfield.algebra.quaternion import Quaternion
from hfield.checker.glossary import MASS
from hfield.evidence import Claim
from hfield.orders import enumeration
from hfield.orders.hermite import tuples
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.z_order import ZOrder

DOUBLINGS = 6
MOST = 10**5
"""So many elements, about, are counted to tell two orders apart."""


def of_order(order: ZOrder) -> Claim:
    """Return that this is an order of this discriminant; and maximal, if the checker can tell."""
    whole = f"order{{{text(order)}; {order.discriminant}"
    if order.level == 1:
        claim = Claim(order.algebra, whole + "; maximal}", {"kind": "order"}, "order")
        if claim.certificate is not None:
            return claim
    return Claim(order.algebra, whole + "}", {"kind": "order"}, "order")


def of_ideal(ideal: LatticeValue, side: str, order: ZOrder) -> Claim:
    """Return that this is a locally principal ideal of its order, and its norm."""
    statement = f"ideal{{{text(ideal)}; {_side(side)}; {text(order)}; {ideal.norm}}}"
    return Claim(ideal.algebra, statement, {"kind": "ideal"}, "ideal")


def _side(side: str) -> str:
    """Return the side on which a statement is made; a two-sided ideal is a left one."""
    return "right" if side == "right" else "left"


def of_class_set(order: ZOrder, classes: list[LatticeValue]) -> Claim:
    """Return how many right ideal classes an order has, with one ideal of each."""
    statement = f"class-set{{{text(order)}; {len(classes)}}}"
    evidence = {"kind": "class-set", "classes": [basis_json(I) for I in classes]}
    return Claim(order.algebra, statement, evidence, "mass", assumes=(MASS,))


def of_answer(answer: Answer) -> Claim | None:
    """Return what an answer says, or None where it has nothing to show."""
    kind = answer.evidence["kind"]
    first, second, *between = answer.lattices
    about = f"{text(first)}; {text(second)}}}"
    if kind == "equivalent":
        about = f"{_side(answer.evidence['side'])}; {about}"
    statement = f"{kind}{{{about}"
    if answer.element is not None:
        shown = {"kind": kind, "element": element_json(answer.element)}
        return Claim(first.algebra, statement, shown, "element")
    if answer.holds:
        return None
    found = (
        _none_carries(between[0], answer.evidence.get("norm"))
        if kind == "equivalent"
        else _different_invariants(first, second)
    )
    if found is None:
        return None
    method, evidence = found
    return Claim(first.algebra, statement, {"kind": kind, **evidence}, method, "refuted")


def _none_carries(between: LatticeValue, size: str | None) -> tuple[str, dict[str, object]]:
    """Return the method and the evidence that no element of a lattice has a norm."""
    if size is None or (Fraction(size) / between.norm).denominator != 1:
        return "norm", {}
    return "enumeration", {"between": basis_json(between)}


def _different_invariants(*orders: LatticeValue) -> tuple[str, dict[str, object]] | None:
    """Return the method and the evidence that two orders are not isomorphic: what one has more elements of.

    Ternary theta series tell all orders apart (Schiemann, *Math. Ann.* 308, 1997), if one goes far enough.
    """
    rings = [order for order in orders if isinstance(order, ZOrder)]
    if len({order.discriminant for order in rings}) == 2:
        return "discriminant", {}
    if not orders[0].ambient.definite:
        return None
    grams = [order.reduced_ternary[2] for order in rings]
    reach = min(gram[n][n] for gram in grams for n in range(3)) // 2
    for _ in range(DOUBLINGS):
        if max(enumeration.volume(gram, 2 * reach, 3) for gram in grams) > MOST:
            return None
        both = zip(*(enumeration.theta_series(gram, reach) for gram in grams), strict=True)
        for m, (one, other) in enumerate(both):
            if one != other:  # x of trace 0 or 1 and discriminant −m
                bases = [basis_json(order) for order in orders]
                data = {"trace": m % 2, "norm": (m + m % 2) // 4, "bases": bases}
                return "enumeration", data
        reach *= 2
    return None


def of_embedding(order: ZOrder, d: int, element: Quaternion | None) -> Claim:
    """Return that a quadratic order is, or is not, optimally embedded."""
    statement = f"embedding{{{text(order)}; {d}}}"
    evidence: dict[str, Any] = {"kind": "embedding"}
    if element is None:
        evidence["basis"] = basis_json(order)
        return Claim(order.algebra, statement, evidence, "enumeration", "refuted")
    evidence["element"] = element_json(element)
    return Claim(order.algebra, statement, evidence, "element")


def text(lattice: LatticeValue) -> str:
    """Write the Hermite form of a lattice as statements do."""
    den, rows = lattice.hnf
    return " | ".join(",".join(str(Fraction(x, den)) for x in row) for row in rows)


@dataclass(frozen=True)
class Answer:
    """True or false in an ``if``; ``element`` proves a true answer, ``reason`` says how it was decided.

    ``theorem`` names the theorem that decided where nothing was enumerated; then a true answer may come
    without its element, which was not found within a bound. ``evidence`` is what a program needs to check it.
    """

    holds: bool
    reason: str
    element: Quaternion | None = None
    theorem: str | None = None
    evidence: dict[str, Any] = field(default_factory=dict, compare=False)
    lattices: tuple[LatticeValue, ...] = field(default=(), compare=False, repr=False)
    """The two that were compared, and that which was run through, if any: as values."""

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/2`` as JSON data, one that the checker accepts, or None.

        There is none where a theorem decided and the element is missing, nor where the checker would have to
        do too much; :attr:`why_no_certificate` says which.
        """
        claim = self._claim
        return None if claim is None else claim.certificate

    @property
    def why_no_certificate(self) -> str | None:
        """Why there is no certificate, in a line; None where there is one."""
        claim = self._claim
        if claim is None:
            return (
                "the element is missing"
                if self.holds
                else "nothing was found that tells them apart"
            )
        return claim.why_no_certificate

    @cached_property
    def _claim(self) -> Claim | None:
        return of_answer(self)

    def __bool__(self) -> bool:
        """Tell whether it holds."""
        return self.holds

    def __repr__(self) -> str:
        shown = "" if self.element is None else f" with {self.element}"
        return f"{'yes' if self.holds else 'no'}{shown}: {self.reason}"


STRONG_APPROXIMATION = (
    "Eichler's theorem, from strong approximation: in an indefinite algebra over QQ an order whose local "
    "units have all unit norms has one ideal class (Voight, Quaternion Algebras, chapter 28)"
)


def element_json(q: Quaternion) -> list[str]:
    """Return an element as four texts."""
    return [q.ring.text(x) for x in q.coordinates]


def basis_json(lattice: LatticeValue) -> dict[str, object]:
    """Return a reduced basis of a lattice: what is run through quickly."""
    rows, _ = lattice.reduced
    return {"den": lattice.den, "rows": [list(row) for row in tuples(rows)]}
