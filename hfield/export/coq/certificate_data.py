"""Types of the JSON data of certificates, as far as they are exported (docs/reference/certificates.md).

The types say what a certificate should have. Data from a file may have other values; what reads them raises
an error then, which :func:`hfield.export.coq.theorem.theorem` reports.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias, TypedDict

Polynomial: TypeAlias = str
RingData: TypeAlias = Mapping[str, object]
Cofactor: TypeAlias = tuple[int, str, int, str]
"""A term c·left·relations[n]·right, as the list of c, left, n and right."""


class StepData(TypedDict, total=False):
    """A step of a proof by contradiction; each kind of step has some of the keys."""

    step: str
    cofactors: list[Polynomial]
    denominator: int
    algebra: str
    terms: list[Polynomial]
    coefficients: list[int]
    factors: list[Polynomial]
    powers: list[int]
    branches: list[list[StepData]]


class ItemData(TypedDict, total=False):
    """An item of an implication: a polynomial of an ideal, or a list of steps to a contradiction."""

    characteristic: int
    zero: list[Polynomial]
    relations: list[Polynomial]
    member: Polynomial
    cofactors: list[Polynomial]
    denominator: int
    nonzero: list[Polynomial]
    steps: list[StepData]


class FactData(TypedDict, total=False):
    """A rule of the field that steps use."""

    form: str
    by: str
    algebra: str


class CaseData(TypedDict):
    """A case of an existence: its condition, and terms that work there."""

    when: str
    terms: dict[str, str]
    proof: EvidenceData


class PartData(TypedDict):
    """The verdict and the evidence of a part of a compound statement."""

    verdict: str
    evidence: EvidenceData


class WordProofData(TypedDict):
    """The proof of a goal about associative algebras."""

    cofactors: list[Cofactor]
    denominator: int


class EvidenceData(TypedDict, total=False):
    """Evidence; each kind has some of the keys."""

    kind: str
    ring: RingData
    rings: list[RingData]
    evidence: EvidenceData
    proof: EvidenceData
    items: list[ItemData]
    facts: list[FactData]
    terms: dict[str, str]
    cases: list[CaseData]
    cover: EvidenceData
    values: dict[str, list[str]]
    unknowns: list[str]
    tuples: list[tuple[str, list[int]]]
    parts: list[PartData]
    part: int
    left: PartData
    right: PartData
    characteristic: int
    identity: bool
    proofs: list[WordProofData]
    table: dict[str, list[int]]
    goal: int
    value: list[int]


class CertificateData(TypedDict):
    """A certificate."""

    schema: str
    statement: str
    algebra: str
    field: str | None
    ring: RingData | None
    verdict: str
    method: str
    assumes: list[str]
    evidence: EvidenceData
