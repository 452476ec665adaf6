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


class Step(TypedDict, total=False):
    """A step of a proof by contradiction; each kind of step has some of the keys."""

    step: str
    cofactors: list[Polynomial]
    denominator: int
    algebra: str
    terms: list[Polynomial]
    coefficients: list[int]
    factors: list[Polynomial]
    powers: list[int]
    branches: list[list[Step]]


class Item(TypedDict, total=False):
    """An item of an implication: a polynomial of an ideal, or a list of steps to a contradiction."""

    characteristic: int
    zero: list[Polynomial]
    relations: list[Polynomial]
    member: Polynomial
    cofactors: list[Polynomial]
    denominator: int
    nonzero: list[Polynomial]
    steps: list[Step]


class FieldFact(TypedDict, total=False):
    """A rule of the field that steps use."""

    form: str
    by: str
    algebra: str


class Case(TypedDict):
    """A case of an existence: its condition, and terms that work there."""

    when: str
    terms: dict[str, str]
    proof: EvidenceData


class Part(TypedDict):
    """The verdict and the evidence of a part of a compound statement."""

    verdict: str
    evidence: EvidenceData


class WordProof(TypedDict):
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
    items: list[Item]
    facts: list[FieldFact]
    terms: dict[str, str]
    cases: list[Case]
    cover: EvidenceData
    values: dict[str, list[str]]
    unknowns: list[str]
    tuples: list[tuple[str, list[int]]]
    parts: list[Part]
    part: int
    left: Part
    right: Part
    characteristic: int
    identity: bool
    proofs: list[WordProof]
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
