"""What a group of units of norm 1 is, and what its domain is, as certificates ``hfield-cert/2``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Quaternion
from hfield.certificates.glossary import BY_AREA, POINCARE, SHIMIZU
from hfield.evidence import Claim
from hfield.fuchsian.split_order import RationalOrder
from hfield.lattices.certificates import element_json, text

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain, NormOneGroup


def of_domain(domain: Domain) -> Claim:
    """Return that the domain around its centre has these sides, by the units across them."""
    parts = [_joined([domain.center_element]), _joined(domain.polygon.units)]
    return _claim(domain.group, "dirichlet-domain", parts, {}, SHIMIZU)


def of_group(group: NormOneGroup, domain: Domain) -> Claim:
    """Return the signature and the presentation of a group; the domain shows them."""
    genus, orders, cusps = group.signature
    relations = ", ".join(" ".join(map(str, word)) for word in group.relations)
    parts = [
        *(str(genus), ",".join(map(str, orders)) or "none", str(cusps)),
        *(_joined(group.generators), relations or "none"),
    ]
    shown = {
        "center": element_json(domain.center_element),
        "units": [element_json(g) for g in domain.polygon.units],
    }
    return _claim(group, "norm-one-group", parts, shown, SHIMIZU, POINCARE)


def _claim(
    group: NormOneGroup, word: str, parts: list[str], shown: dict[str, object], *cited: str
) -> Claim:
    order = group.order
    if not isinstance(order, RationalOrder):
        why = "groups of units are certified over QQ alone"
        return Claim(order.algebra, word, {}, BY_AREA, refusal=why)
    statement = f"{word}{{{'; '.join([text(order.order), *parts])}}}"
    return Claim(order.algebra, statement, {"kind": word, **shown}, BY_AREA, assumes=cited)


def _joined(elements: Iterable[Quaternion]) -> str:
    return " | ".join(",".join(element_json(g)) for g in elements)
