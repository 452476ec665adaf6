"""``hfield survey``: compute class sets or unit groups over a range; an interrupted survey can be resumed."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.cli.output import OutputError, note, open_output
from hfield.cli.parser import UsageError, add_jobs, add_repeated
from hfield.cli.status import Progress
from hfield.errors import shorten

if TYPE_CHECKING:
    from types import ModuleType

    from hfield.core.journal import Journal
    from hfield.surveys import Plan

HELP = (
    "Tabulate class numbers, masses, type numbers and units of the Eichler orders with "
    "discriminants and levels in given ranges. With --field the levels are given by their "
    "norms. With --groups the rows are signatures, presentations and systoles of unit "
    "groups in indefinite algebras. Rows are written as they are found: as a table on a terminal, "
    "otherwise as JSON objects. With -o, an interrupted run continues after its last row."
)
DOING = "surveying"
EXAMPLES = (
    "hfield survey 2..100 --levels 1..5 -o rows.jsonl",
    "hfield survey --field 'QQ(sqrt(5))' --field 'QQ(sqrt(2))' --levels 1..50",
    "hfield survey 6..100 --groups",
)
DEFAULT_CLASSES = 5000
AREA = 100
MAX_PAIRS = 10**6
SUFFIXES = (".jsonl", ".parquet")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "discriminants",
        metavar="D",
        nargs="?",
        help="discriminants over QQ, such as 2..100 or 11,30,42",
    )
    add_repeated(parser, "--field", "F", "over the integers of this totally real field")
    parser.add_argument(
        "--groups",
        action="store_true",
        help="survey unit groups of indefinite algebras over QQ instead",
    )
    parser.add_argument(
        "--levels",
        metavar="N",
        default="1",
        help="levels, such as 1..20; with --field, norms of levels (default: 1)",
    )
    parser.add_argument(
        "--most",
        metavar="H",
        help="bound of the enumeration: H classes, or with --groups an area of 2πH "
        f"(default: {DEFAULT_CLASSES}; with --groups {AREA})",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="FILE.jsonl with one JSON object per line, or FILE.parquet (needs pyarrow)",
    )
    add_jobs(parser, "use the Dask cluster at ADDRESS")


def run(args: Namespace) -> int:
    """Compute the missing rows, and write them."""
    from hfield.core.executors import open_executor
    from hfield.core.journal import Journal

    plan = _asked(args)
    survey, pairs = plan.survey, plan.pairs
    (most,) = numbers(args.most or str(AREA if args.groups else DEFAULT_CLASSES), "--most")[:1]
    if args.output is None:
        with open_output(None) as out, open_executor(args.jobs, args.dask) as executor:
            table = Columns() if out.stream.isatty() else None
            for found in plan.run(executor, most, set()):
                lines = map(json.dumps, found) if table is None else table.lines(found)
                out.write("\n".join(lines))
        return 0
    path = Path(args.output)
    parquet = path.suffix == ".parquet"
    if path.suffix not in SUFFIXES:
        raise UsageError(
            f"-o {shorten(args.output)!r}: a survey is written as JSON lines or as Parquet; expected a name "
            "that ends in .jsonl or .parquet"
        )
    if parquet:
        _pyarrow()
    journal = Journal(path.with_name(path.name + ".jsonl") if parquet else path)
    number = 0
    try:
        done = _done(journal, survey.names)
        number = len(done & set(pairs))
        with open_executor(args.jobs, args.dask) as executor, Progress("pairs", number) as progress:
            for found in plan.run(executor, most, done):
                journal.append(found)
                number += len(found)
                progress(
                    number, len(pairs), " ".join(str(found[-1][name]) for name in survey.names)
                )
        if parquet:
            _to_parquet(journal, path, survey.names)
    except KeyboardInterrupt:
        note(f"{number} of {len(pairs)} rows are in {journal.path}; the same command goes on there")
        raise
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(f"cannot write {shorten(args.output)!r}: {reason}") from error
    return 0


class Columns:
    """The rows of a survey as aligned text; the first rows determine the column widths."""

    def __init__(self) -> None:
        self._widths: list[int] = []

    def lines(self, rows: Sequence[Mapping[str, object]]) -> Iterator[str]:
        """Yield the rows as lines, after a header."""
        cells = [[_cell(value) for value in row.values()] for row in rows]
        if rows and not self._widths:
            cells.insert(0, [name.replace("_", " ") for name in rows[0]])
            self._widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
        for line in cells:
            padded = zip(line, self._widths, strict=True)
            yield "  ".join(f"{cell:<{width}}" for cell, width in padded).rstrip()


def _cell(value: object) -> str:
    """Format a value of a row: a table such as ``{"24": 1}`` as ``24: 1``."""
    if isinstance(value, dict):
        return ", ".join(f"{name}: {number}" for name, number in value.items())
    return value if isinstance(value, str) else json.dumps(value)


def numbers(text: str, name: str) -> list[int]:
    """Read ``2..100``, ``2,3,5``, or a mixture. Raises :class:`UsageError`."""
    found: list[int] = []
    for word in text.split(","):
        low, dots, high = word.strip().partition("..")
        ends = [low, high] if dots else [low]
        if not all(x.strip().isascii() and x.strip().isdecimal() and len(x) < 12 for x in ends):
            raise UsageError(
                f"{name} {shorten(text)!r}: expected numbers such as 2..100 or 11,30,42"
            )
        first, last = int(ends[0]), int(ends[-1])
        if first < 1 or last < first or last - first >= MAX_PAIRS:
            raise UsageError(
                f"{name} {shorten(text)!r}: expected positive numbers, in ascending ranges, at most "
                f"{MAX_PAIRS} of them"
            )
        found += range(first, last + 1)
    return list(dict.fromkeys(found))


def _asked(args: Namespace) -> Plan[int] | Plan[str]:
    """Return the survey described by the arguments, and its pairs."""
    from hfield import surveys
    from hfield.surveys import Plan

    levels = numbers(args.levels, "--levels")
    if args.field:
        if args.discriminants or args.groups:
            raise UsageError("--field surveys class sets over that field: leave D and --groups out")
        return Plan(surveys.FIELDS, surveys.field_pairs(args.field, levels))
    if not args.discriminants:
        raise UsageError("expected discriminants D such as 2..100, or --field F")
    wanted = numbers(args.discriminants, "D")
    if len(wanted) * len(levels) > MAX_PAIRS:
        raise UsageError(
            f"{len(wanted)} discriminants times {len(levels)} levels are more than {MAX_PAIRS} pairs: "
            "survey a part at a time"
        )
    kind, count = ("an indefinite", "even") if args.groups else ("a definite", "odd")
    pairs = (surveys.indefinite_pairs if args.groups else surveys.definite_pairs)(wanted, levels)
    if not pairs:
        raise UsageError(
            f"these ranges contain no pair of {kind} discriminant, a product of an {count} number of primes, "
            "and a level prime to it"
        )
    return Plan(surveys.GROUPS if args.groups else surveys.CLASSES, pairs)


def _done(journal: Journal, names: tuple[str, str]) -> set[tuple[object, object]]:
    try:
        return {(row[names[0]], row[names[1]]) for row in journal.read()}
    except (ValueError, KeyError, TypeError):
        raise OutputError(
            f"{shorten(journal.path)} is not a survey that can be resumed: move it away, or name another file"
        ) from None


def _pyarrow() -> ModuleType:
    try:
        import pyarrow.parquet
    except ImportError:
        raise UsageError(
            "a .parquet file needs pyarrow, which is not installed: run `pip install 'hfield[survey]'`, "
            "or write to a .jsonl file"
        ) from None
    module: ModuleType = pyarrow
    return module


def _to_parquet(journal: Journal, path: Path, names: tuple[str, str]) -> None:
    """Write the rows of the journal as one Parquet file, atomically, and delete the journal."""
    pyarrow = _pyarrow()
    rows = sorted(journal.read(), key=lambda row: (row[names[0]], row[names[1]]))
    for row in rows:
        for name in {"units", "orders", "generators", "relations"} & row.keys():
            row[name] = None if row[name] is None else json.dumps(row[name])
    part = path.with_name(path.name + ".part")
    pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows), part)
    part.replace(path)
    journal.path.unlink()
