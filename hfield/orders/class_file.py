"""A file of classes and rows of neighbours, from which an interrupted run resumes.

The first JSON line describes the order. Each further line has a block of rows and the new classes in them,
with a digest of the line and of the order. Damaged or edited lines, and lines of other orders, are rejected.
A digest does not protect against forgery; a certificate of the class set proves the classes independently.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.core.journal import Journal, Row
from hfield.core.packed_integers import pack, unpack
from hfield.errors import LatticeError, shorten
from hfield.orders.base_values import Prime
from hfield.orders.class_store import PackedClass
from hfield.orders.lattice_values import rows_json

if TYPE_CHECKING:
    from hfield.orders.base import Base
    from hfield.orders.classes import Classes

SCHEMA = "hfield-class-rows/1"
DIGITS = 16
"""The hexadecimal digits of a digest."""


class ClassFile:
    """A file that keeps classes and rows of neighbours of one order as they are found."""

    def __init__(self, path: str | Path) -> None:
        self._journal = Journal(Path(path))
        self._head: Row = {}

    def read(self, classes: Classes) -> None:
        """Add the classes and rows of the file, or begin a new file.

        Raises :class:`LatticeError` for a file of another order or of another kind, or a damaged file.
        """
        try:
            lines = self._journal.read()
            if lines and lines[0]["schema"] != SCHEMA:
                raise ValueError(f"its schema is not {SCHEMA}")
        except (ValueError, KeyError, TypeError):
            raise self._unreadable() from None
        head = self._head = _head(classes)
        if not lines:
            self._journal.append([head])
        elif lines[0] != head:
            raise LatticeError(
                f"{shorten(self._journal.path)} has the classes of another order: name another file"
            )
        try:
            for line in lines[1:]:
                if line.pop("digest") != self._digest(line):
                    raise ValueError("a line has another digest")
                _restore(classes, line)
        except (AttributeError, ValueError, KeyError, TypeError, OverflowError):
            raise self._unreadable() from None

    def _unreadable(self) -> LatticeError:
        return LatticeError(
            f"{shorten(self._journal.path)} is not a file of classes that can be resumed, or is damaged: "
            "move it away, or name another file"
        )

    def append(
        self,
        base: Base,
        prime: Prime,
        first: int,
        rows: Sequence[Mapping[int, int]],
        new: Sequence[tuple[int, int | None, PackedClass]],
    ) -> None:
        """Append the rows of a prime, from row ``first``, and the new classes in them.

        Each new class comes with its number and the number of the class that is exchanged with it.
        """
        line = {
            "prime": base.ideal_text(base.prime_ideal(prime)),
            "first": first,
            "rows": [[x for pair in sorted(row.items()) for x in pair] for row in rows],
            "classes": [
                {
                    "number": number,
                    "exchanged": exchanged,
                    "record": unpack(found.record),
                    "units": found.units,
                    "keys": list(map(unpack, found.keys)),
                }
                for number, exchanged, found in new
            ],
        }
        self._journal.append([{**line, "digest": self._digest(line)}])

    def _digest(self, line: Row) -> str:
        """Return a digest of a line and of the order that it belongs to."""
        return hashlib.sha256(json.dumps([self._head, line]).encode()).hexdigest()[:DIGITS]


def _head(classes: Classes) -> Row:
    order = classes.order
    return {"schema": SCHEMA, "algebra": str(order.algebra), "order": rows_json(order)}


def _restore(classes: Classes, line: Row) -> None:
    """Add the classes and rows of a line."""
    base = classes.ambient.base
    for found in line["classes"]:
        keys = tuple(map(pack, found["keys"]))
        packed = PackedClass(pack(found["record"]), int(found["units"]), keys)
        classes.restore_class(found["number"], found["exchanged"], packed)
    rows = [dict(zip(row[::2], row[1::2], strict=True)) for row in line["rows"]]
    classes.restore_rows(base.prime(line["prime"]), line["first"], rows)
