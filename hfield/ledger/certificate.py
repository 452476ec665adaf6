"""Certificates of the ledger: a file for every row that is proved, refuted or vacuous."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from hfield.atomic import whole_file
from hfield.certificates.check import cited
from hfield.certificates.rejection import Rejected
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Proposition, Row
from hfield.proving.decision import PROVED, REFUTED, VACUOUS, Decision


def certificate(
    proposition: Proposition | None, decision: Decision | None, field: str
) -> dict[str, Any] | None:
    """Return the certificate ``hfield-cert/1`` of a decision, None where there is none to give.

    What it assumes is what the checker finds cited in the evidence; a certificate that the checker
    would reject is not given.
    """
    if proposition is None or decision is None or decision.evidence is None:
        return None
    if decision.verdict not in (PROVED, REFUTED, VACUOUS):
        return None
    named = None if field in (UNIVERSAL, NO_FIELD) else field
    data: dict[str, Any] = {
        "schema": "hfield-cert/1",
        "statement": proposition.statement,
        "algebra": f"(-1,-1|{named or 'F'})",
        "field": named,
        "verdict": decision.verdict,
        "method": decision.method,
        "assumes": [],
        "evidence": dict(decision.evidence),
    }
    try:
        data["assumes"] = cited(data)
    except Rejected:
        return None
    return data


def write_certificates(rows: Sequence[Row], directory: Path) -> dict[tuple[str, str], str]:
    """Write the certificates of all rows, of corrections too; return their paths by id and field.

    The directory is made if need be. Raises OSError where that or a file cannot be written.
    """
    directory.mkdir(parents=True, exist_ok=True)
    paths = {}
    for row in rows:
        name = f"{row.claim.id}.{re.sub(r'[^0-9A-Za-z-]+', '_', row.field).rstrip('_')}"
        corrected = certificate(row.claim.corrected, row.as_corrected, row.field)
        if corrected is not None:
            _write(directory / f"{name}.corrected.json", corrected)
        printed = certificate(row.claim.as_printed, row.as_printed, row.field)
        if printed is not None:
            path = directory / f"{name}.json"
            _write(path, printed)
            paths[row.claim.id, row.field] = str(path)
    return paths


def _write(path: Path, data: dict[str, Any]) -> None:
    with whole_file(path) as part:
        part.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
