"""``hfield survey``: class numbers, masses and type numbers over ranges, resumable and in parallel."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from hfield.commands.output import OutputError, open_output
from hfield.commands.parser import UsageError, add_jobs
from hfield.commands.status import Progress
from hfield.errors import shorten

HELP = (
    "Tell class numbers, masses, type numbers and units for all Eichler orders with a discriminant and a "
    "level in given ranges. Rows are written as they are found; a run that was killed goes on where it was."
)
EXAMPLES = ("hfield survey 2..100 --levels 1..5 -o rows.jsonl",)
MOST = 5000
SUFFIXES = (".jsonl", ".parquet")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("discriminants", metavar="D", help="such as 2..100, or 11,30,42")
    parser.add_argument("--levels", metavar="N", default="1", help="such as 1..20 (default: 1)")
    parser.add_argument(
        "--most",
        metavar="H",
        default=str(MOST),
        help=f"enumerate at most H classes (default: {MOST})",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="FILE.jsonl, an object of JSON a line, or FILE.parquet (needs pyarrow)",
    )
    add_jobs(parser, "use the Dask cluster at ADDRESS")


def run(args: Namespace) -> int:
    """Compute what is missing, and write it."""
    from hfield import census
    from hfield.executors import open_executor

    pairs = census.definite_pairs(
        numbers(args.discriminants, "D"), numbers(args.levels, "--levels")
    )
    (most,) = numbers(args.most, "--most")[:1]
    if not pairs:
        raise UsageError(
            "in these ranges lies no pair of a definite discriminant, a product of an odd number of primes, "
            "and a level prime to it"
        )
    if args.output is None:
        with open_output(None) as out, open_executor(args.jobs, args.dask) as executor:
            for found in census.run(executor, pairs, most, set()):
                out.write("\n".join(json.dumps(row) for row in found))
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
    journal = census.Journal(path.with_name(path.name + ".jsonl") if parquet else path)
    try:
        done = _done(journal)
        with open_executor(args.jobs, args.dask) as executor, Progress("pairs") as progress:
            number = len(done & set(pairs))
            for found in census.run(executor, pairs, most, done):
                journal.append(found)
                number += len(found)
                progress(number, len(pairs), f"D = {found[-1]['discriminant']}")
        if parquet:
            _to_parquet(journal, path)
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(f"cannot write {shorten(args.output)!r}: {reason}") from error
    return 0


def numbers(text: str, name: str) -> list[int]:
    """Read ``2..100``, or ``2,3,5``, or both mixed. Raises :class:`UsageError`."""
    found: list[int] = []
    for word in text.split(","):
        low, dots, high = word.strip().partition("..")
        ends = [low, high] if dots else [low]
        if not all(x.strip().isascii() and x.strip().isdecimal() and len(x) < 12 for x in ends):
            raise UsageError(
                f"{name} {shorten(text)!r}: expected numbers such as 2..100 or 11,30,42"
            )
        first, last = int(ends[0]), int(ends[-1])
        if first < 1 or last < first or last - first > 10**6:
            raise UsageError(
                f"{name} {shorten(text)!r}: expected positive numbers, in ascending ranges"
            )
        found += range(first, last + 1)
    return list(dict.fromkeys(found))


def _done(journal: Any) -> set[tuple[int, int]]:
    try:
        return {(row["discriminant"], row["level"]) for row in journal.read()}
    except (ValueError, KeyError, TypeError):
        raise OutputError(
            f"{shorten(journal.path)} is not a survey that could go on: move it away, or name another file"
        ) from None


def _pyarrow() -> Any:
    try:
        import pyarrow.parquet
    except ImportError:
        raise UsageError(
            "a .parquet file needs pyarrow, which is not installed: run `pip install 'hfield[survey]'`, "
            "or write to a .jsonl file"
        ) from None
    return pyarrow


def _to_parquet(journal: Any, path: Path) -> None:
    """Write the rows of the journal as one Parquet file, whole or not at all, and drop the journal."""
    pyarrow = _pyarrow()
    rows = sorted(journal.read(), key=lambda row: (row["discriminant"], row["level"]))
    for row in rows:
        row["units"] = None if row["units"] is None else json.dumps(row["units"])
    part = path.with_name(path.name + ".part")
    pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows), part)
    part.replace(path)
    journal.path.unlink()
