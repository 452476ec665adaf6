"""Write groups of units of norm 1 and their domains as certificates ``hfield-cert/2``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from hfield.algebra.quaternion import Quaternion
from hfield.checker.glossary import POINCARE
from hfield.evidence import CertifiedClaim

if TYPE_CHECKING:
    from hfield.fuchsian.group import Domain, NormOneGroup


def of_domain(domain: Domain) -> CertifiedClaim:
    """Return the certified claim that a domain has these sides, given by the units that pair them."""
    parts = [_joined([domain.center_element]), _joined(domain.polygon.units)]
    return domain.group.order.claim("dirichlet-domain", parts, {})


def of_group(group: NormOneGroup, domain: Domain) -> CertifiedClaim:
    """Return the signature and the presentation of a group; the domain is the evidence."""
    genus, orders, cusps = group.signature
    relations = ", ".join(" ".join(map(str, word)) for word in group.relations)
    parts = [
        *(str(genus), ",".join(map(str, orders)) or "none", str(cusps)),
        *(_joined(group.generators), relations or "none"),
    ]
    written = group.order.written
    shown = {
        "center": written(domain.center_element),
        "units": [written(g) for g in domain.polygon.units],
    }
    return group.order.claim("norm-one-group", parts, shown, POINCARE)


def _joined(elements: Iterable[Quaternion]) -> str:
    return " | ".join(",".join(map(g.ring.text, g.coordinates)) for g in elements)
