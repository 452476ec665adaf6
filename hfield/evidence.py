"""Evidence and certificates of claims.

The meaning of each kind is described in docs/reference/certificates.md. The checker imports nothing from this
module; it reads the JSON on its own.
"""

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import Protocol

from hfield.checker.glossary import SCHEMA


class Kind(StrEnum):
    """Every kind of evidence that a certificate may have."""

    # about a statement of the language
    CASES = "cases"
    COMPLEX_ROOT = "complex root"
    EXHAUSTION = "exhaustion"
    FRACTIONS = "fractions"
    IDENTITY = "identity"
    IMPLICATION = "implication"
    MULTILINEAR = "multilinear"
    NONE_EXISTS = "none exists"
    PLACE = "place"
    QUATERNION_ROOT = "quaternion root"
    REAL_ROOT = "real root"
    REDUCTION = "reduction"
    RINGS = "rings"
    SUBFIELD = "subfield"
    TERMS = "terms"
    UNSATISFIABLE = "unsatisfiable"
    WITNESS = "witness"
    # about algebras with relations
    ALGEBRA = "algebra"
    PRESENTATION = "presentation"
    # about a field, and logic between closed statements
    ALL_CHOICES = "all choices"
    ANISOTROPIC = "anisotropic"
    BASIS_TUPLES = "basis tuples"
    BOTH = "both"
    CLOSED = "closed"
    CONCLUSION = "conclusion"
    COUNT = "count"
    DETERMINANT = "determinant"
    HYPOTHESIS = "hypothesis"
    LEFT_OUT = "left out"
    LEMMAS = "lemmas"
    LEVEL = "level"
    MINOR = "minor"
    NO_ROOT = "no root"
    ORDERING = "ordering"
    OVER = "over"
    PART = "part"
    PARTS = "parts"
    PURE_SUBGROUP = "pure subgroup"
    SQUARE_ROOTS = "square roots"
    SQUARES = "squares"
    UNIQUE_ROOTS = "unique roots"
    ZERO_NORM = "zero norm"
    # about a number field
    S_UNITS = "S-units"
    # about lattices
    CLASS_SET = "class-set"
    DIRICHLET_DOMAIN = "dirichlet-domain"
    DIRICHLET_DOMAIN_OVER_INTEGERS = "dirichlet-domain-over-integers"
    EMBEDDING = "embedding"
    EMBEDDING_ORBITS = "embedding-orbits"
    EQUIVALENT = "equivalent"
    IDEAL = "ideal"
    IDEAL_CLASSES = "ideal-classes"
    EQUIVALENT_OVER_INTEGERS = "equivalent-over-integers"
    IDEAL_OVER_INTEGERS = "ideal-over-integers"
    ISOMORPHIC_OVER_INTEGERS = "isomorphic-over-integers"
    ORDER_OVER_INTEGERS = "order-over-integers"
    UNIT_INDEX = "unit-index"
    ISOMORPHIC_ORDERS = "isomorphic-orders"
    NORM_ONE_GROUP = "norm-one-group"
    NEWFORMS = "newforms"
    NEWFORMS_OVER_INTEGERS = "newforms-over-integers"
    NORM_ONE_GROUP_OVER_INTEGERS = "norm-one-group-over-integers"
    ORDER = "order"
    CLASS_SET_OVER_POLYNOMIALS = "class-set-over-polynomials"
    EQUIVALENT_OVER_POLYNOMIALS = "equivalent-over-polynomials"
    IDEAL_OVER_POLYNOMIALS = "ideal-over-polynomials"
    ISOMORPHIC_OVER_POLYNOMIALS = "isomorphic-over-polynomials"
    ORDER_OVER_POLYNOMIALS = "order-over-polynomials"
    UNIT_INDEX_OVER_POLYNOMIALS = "unit-index-over-polynomials"


@dataclass(init=False)
class Evidence:
    """Evidence of a kind: its values by name, in the order of the JSON data."""

    kind: Kind
    values: Mapping[str, object]

    def __init__(self, kind: str, **values: object) -> None:
        self.kind, self.values = Kind(kind), values

    def __getitem__(self, name: str) -> object:
        return self.values[name]

    def over(self, ring: Mapping[str, object] | None) -> "Evidence":
        """Return the evidence extended by its ring, for a statement about all rings."""
        return Evidence(self.kind, **{**self.values, "ring": ring})

    def to_json(self) -> dict[str, object]:
        """Return the evidence as JSON data."""
        values = {name: _plain(x) for name, x in self.values.items()}
        return {"kind": self.kind.value, **values}


def _plain(x: object) -> object:
    match x:
        case Evidence():
            return x.to_json()
        case dict():
            return {name: _plain(y) for name, y in x.items()}
        case list():
            return [_plain(y) for y in x]
    return x


def is_complete(evidence: object) -> bool:
    """Return whether there is evidence, including for the claims that it uses."""
    match evidence:
        case Evidence(values=values) | ({} as values):
            return all(
                is_complete(values[name]) for name in ("proof", "cover", "cases") if name in values
            )
        case list():
            return all(map(is_complete, evidence))
    return evidence is not None


def certificate(
    statement: str,
    algebra: str,
    field: str | None,
    ring: Mapping[str, object] | None,
    verdict: str,
    method: str,
    assumes: Sequence[str],
    evidence: Evidence,
) -> dict[str, object]:
    """Return a certificate as JSON data, without asking the checker."""
    return {
        "schema": SCHEMA,
        "statement": statement,
        "algebra": algebra,
        "field": field,
        "ring": ring,
        "verdict": verdict,
        "method": method,
        "assumes": list(assumes),
        "evidence": evidence.to_json(),
    }


def why_rejected(data: dict[str, object]) -> str | None:
    """Return the reason why the checker rejects a certificate, or None if it accepts it."""
    from hfield.checker.check import Rejected, check

    try:
        check(data)
    except Rejected as error:
        return f"the checker does not follow: {error}"
    return None


class NamedRing(Protocol):
    """A ring as certificates name it; ``data`` is None for a ring that they cannot."""

    name: str

    @property
    def data(self) -> Mapping[str, object] | None:
        """The data from which the checker makes the ring."""


class NamedAlgebra(Protocol):
    """An algebra as certificates name it: by its text, over its ring."""

    @property
    def ring(self) -> NamedRing:
        """The ring."""


@dataclass(frozen=True)
class CertifiedClaim:
    """A statement with its evidence; ``algebra`` is an algebra, or a text together with ``ring``."""

    algebra: NamedAlgebra | str
    statement: str
    evidence: dict[str, object]
    method: str
    verdict: str = "proved"
    assumes: tuple[str, ...] = ()
    ring: NamedRing | None = None
    refusal: str | None = None
    """Why the checker is not asked, where it cannot know what this is about."""

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate as JSON data, or None if the checker cannot check this result."""
        return self._data if self.why_no_certificate is None else None

    @cached_property
    def why_no_certificate(self) -> str | None:
        """The reason, on one line, why there is no certificate; None if there is one."""
        return self.refusal or why_rejected(self._data)

    @property
    def _data(self) -> dict[str, object]:
        ring = self.ring
        if ring is None:
            assert not isinstance(self.algebra, str), "a text has its ring beside it"
            ring = self.algebra.ring
        values = {name: x for name, x in self.evidence.items() if name != "kind"}
        evidence = Evidence(str(self.evidence["kind"]), **values)
        shown = (self.verdict, self.method, self.assumes, evidence)
        return certificate(self.statement, str(self.algebra), ring.name, ring.data, *shown)


class Certified:
    """The protocol of objects that can be certified."""

    @property
    @abstractmethod
    def claim(self) -> CertifiedClaim:
        """The claim of a certificate: a statement with its evidence."""

    @property
    def certificate(self) -> dict[str, object] | None:
        """The certificate ``hfield-cert/2`` as JSON data, accepted by the checker, or None.

        There is none if checking it would take too long, or for an ideal that is not invertible;
        ``claim.why_no_certificate`` gives the reason.
        """
        return self.claim.certificate
