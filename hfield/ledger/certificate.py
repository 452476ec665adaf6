"""Certificates of the ledger: a file for every row that is proved, refuted or vacuous."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from hfield.core.files import whole_file
from hfield.evidence import why_rejected
from hfield.fields.names import ring
from hfield.ledger.claim import NO_FIELD, UNIVERSAL, Proposition, Row
from hfield.prover.decision import Decision


def certificate(
    proposition: Proposition | None, decision: Decision | None, field: str
) -> dict[str, object] | None:
    """Return the certificate ``hfield-cert/2`` of a decision, or None if there is none.

    A certificate that the checker would reject, also because of its citations, is not returned.
    """
    if proposition is None or decision is None:
        return None
    named = None if field in (UNIVERSAL, NO_FIELD) else field
    over = None if named is None else ring(named)
    data = decision.certificate(proposition.statement, f"(-1,-1|{named or 'F'})", over)
    return None if data is None or why_rejected(data) else data


def write_certificates(rows: Sequence[Row], directory: Path) -> dict[tuple[str, str], str]:
    """Write the certificates of all rows and corrections; return their paths by id and field.

    The directory is created if necessary. Raises OSError if it or a file cannot be written.
    """
    directory.mkdir(parents=True, exist_ok=True)
    paths = {}
    for row in rows:
        name = f"{row.claim.id}.{re.sub(r'[^0-9A-Za-z-]+', '_', row.field).rstrip('_')}"
        corrected = certificate(row.claim.corrected, row.as_corrected, row.field)
        if corrected is not None:
            write_certificate(directory / f"{name}.corrected.json", corrected)
        printed = certificate(row.claim.as_printed, row.as_printed, row.field)
        if printed is not None:
            path = directory / f"{name}.json"
            write_certificate(path, printed)
            paths[row.claim.id, row.field] = str(path)
    return paths


def write_certificate(path: Path, data: Mapping[str, object]) -> None:
    """Write a certificate to a file, completely or not at all. Raises OSError."""
    with whole_file(path) as part:
        part.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
