"""The certificates of all decisions, packed into the page: a line of JSON each, compressed together."""

from __future__ import annotations

import json
import zlib
from base64 import b64encode
from collections.abc import Callable, Sequence

from hfield.ledger.certificate import certificate
from hfield.ledger.claim import Row

Key = tuple[str, str, bool]
"""A claim's id, a field, and whether it is the correction that is certified."""


class Certificates:
    """Certificates by their place in the pack, a number from 0."""

    def __init__(
        self, rows: Sequence[Row], progress: Callable[[int, int, str], None] | None = None
    ) -> None:
        self._numbers: dict[Key, int] = {}
        self._lines: list[str] = []
        for done, row in enumerate(rows):
            if progress:
                progress(done, len(rows), "certificates")
            claim = row.claim
            pairs = ((claim.as_printed, row.as_printed), (claim.corrected, row.as_corrected))
            for corrected, (proposition, decision) in enumerate(pairs):
                data = certificate(proposition, decision, row.field)
                if data is not None:
                    self._numbers[claim.id, row.field, bool(corrected)] = len(self._lines)
                    self._lines.append(json.dumps(data, ensure_ascii=False, separators=(",", ":")))

    def __len__(self) -> int:
        return len(self._lines)

    def number(self, row: Row, corrected: bool = False) -> int | None:
        """Return the place of a row's certificate, or of its correction's; None where there is none."""
        return self._numbers.get((row.claim.id, row.field, corrected))

    def packed(self) -> str:
        """Return all of them, lines joined, deflated (RFC 1950), in base64."""
        return b64encode(zlib.compress("\n".join(self._lines).encode(), 9)).decode()
