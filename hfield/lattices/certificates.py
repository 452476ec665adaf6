"""What the answers about lattices say, as certificates ``hfield-cert/2`` that the checker accepts."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from hfield.certificates.glossary import MASS
from hfield.evidence import Evidence, certificate, why_rejected
from hfield.lattices import enumeration
from hfield.lattices.as_json import basis_json, element_json
from hfield.lattices.order_invariants import OrderInvariants

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Parent
    from hfield.lattices.answers import Answer
    from hfield.lattices.classes import ClassSet
    from hfield.lattices.ideal import Ideal
    from hfield.lattices.lattice import Lattice
    from hfield.lattices.order import Order
    from hfield.lattices.quadratic_orders import Embeddings

DOUBLINGS = 6
MOST = 10**5
"""So many elements, about, are counted to tell two orders apart."""


@dataclass(frozen=True)
class Claim:
    """A statement about lattices with its evidence."""

    algebra: Parent
    statement: str
    evidence: dict[str, Any]
    method: str
    verdict: str = "proved"
    assumes: tuple[str, ...] = ()

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate as JSON data, or None where the checker does not follow."""
        return self._data if self.why_no_certificate is None else None

    @cached_property
    def why_no_certificate(self) -> str | None:
        """Why there is no certificate, in a line; None where there is one."""
        return why_rejected(self._data)

    @property
    def _data(self) -> dict[str, object]:
        ring, shown = {"kind": "rationals"}, (self.verdict, self.method, self.assumes)
        evidence = Evidence(**self.evidence)
        return certificate(self.statement, str(self.algebra), "QQ", ring, *shown, evidence)


class Certified:
    """What makes a claim that can be certified."""

    @property
    @abstractmethod
    def claim(self) -> Claim:
        """What there is to certify, as a statement with its evidence."""

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/2`` as JSON data, one that the checker accepts, or None.

        There is none where the checker would have to do too much, nor for an ideal that is not invertible;
        ``claim.why_no_certificate`` tells.
        """
        return self.claim.certificate


def of_order(order: Order) -> Claim:
    """Return that this is an order of this discriminant; and maximal, if the checker can tell."""
    whole = f"order{{{text(order)}; {order.discriminant()}"
    if order.is_maximal():
        claim = Claim(order.algebra, whole + "; maximal}", {"kind": "order"}, "order")
        if claim.certificate is not None:
            return claim
    return Claim(order.algebra, whole + "}", {"kind": "order"}, "order")


def of_ideal(ideal: Ideal) -> Claim:
    """Return that this is a locally principal ideal of its order, and its norm."""
    side = "right" if ideal.side == "right" else "left"
    statement = f"ideal{{{text(ideal)}; {side}; {text(ideal.order)}; {ideal.norm()}}}"
    return Claim(ideal.algebra, statement, {"kind": "ideal"}, "ideal")


def of_class_set(classes: ClassSet) -> Claim:
    """Return how many right ideal classes an order has, with one ideal of each."""
    order = classes.order
    statement = f"class-set{{{text(order)}; {len(classes)}}}"
    rows = [basis_json(I) for I in classes._lattices]
    evidence = {"kind": "class-set", "classes": rows}
    return Claim(order.algebra, statement, evidence, "mass", assumes=(MASS,))


def of_answer(answer: Answer) -> Claim | None:
    """Return what an answer says, or None where it has nothing to show."""
    kind = answer.evidence["kind"]
    first, second, *between = answer.lattices
    about = f"{text(first)}; {text(second)}}}"
    if kind == "equivalent":
        side = "right" if answer.evidence["side"] == "right" else "left"
        about = f"{side}; {about}"
    statement = f"{kind}{{{about}"
    if answer.element is not None:
        shown = {"kind": kind, "element": element_json(answer.element)}
        return Claim(first.algebra, statement, shown, "element")
    if answer.holds:
        return None
    found = (
        _none_carries(between[0], answer.evidence.get("norm"))
        if kind == "equivalent"
        else _told_apart(first, second)
    )
    if found is None:
        return None
    method, evidence = found
    return Claim(first.algebra, statement, {"kind": kind, **evidence}, method, "refuted")


def _none_carries(between: Lattice, size: str | None) -> tuple[str, dict[str, object]]:
    """Return the method and the evidence that no element of a lattice has a norm."""
    if size is None or (Fraction(size) / between._norm).denominator != 1:
        return "norm", {}
    return "enumeration", {"between": basis_json(between)}


def _told_apart(first: Lattice, second: Lattice) -> tuple[str, dict[str, object]] | None:
    """Return the method and the evidence that two orders are not isomorphic: what one has more elements of.

    Ternary theta series tell all orders apart (Schiemann, *Math. Ann.* 308, 1997), if one goes far enough.
    """
    orders = [x for x in (first, second) if isinstance(x, OrderInvariants)]
    if len({order.discriminant() for order in orders}) == 2:
        return "discriminant", {}
    if not first._regular.definite:
        return None
    grams = [order._reduced_ternary[2] for order in orders]
    reach = min(gram[n][n] for gram in grams for n in range(3)) // 2
    for _ in range(DOUBLINGS):
        if max(enumeration.volume(gram, 2 * reach, 3) for gram in grams) > MOST:
            return None
        both = zip(*(order.ternary_theta_series(reach) for order in orders), strict=True)
        for m, (one, other) in enumerate(both):
            if one != other:  # x of trace 0 or 1 and discriminant −m
                bases = [basis_json(order) for order in orders]
                data = {"trace": m % 2, "norm": (m + m % 2) // 4, "bases": bases}
                return "enumeration", data
        reach *= 2
    return None


def of_embeddings(found: Embeddings) -> Claim:
    """Return that a quadratic order is, or is not, optimally embedded."""
    order = found.order
    statement = f"embedding{{{text(order)}; {found.discriminant}}}"
    evidence: dict[str, Any] = {"kind": "embedding"}
    if found.element is None:
        evidence["basis"] = basis_json(order)
        return Claim(order.algebra, statement, evidence, "enumeration", "refuted")
    evidence["element"] = element_json(found.element)
    return Claim(order.algebra, statement, evidence, "element")


def text(lattice: Lattice) -> str:
    """Write the Hermite form of a lattice as statements do."""
    den, rows = lattice.hnf
    return " | ".join(",".join(str(Fraction(x, den)) for x in row) for row in rows)
