"""``hfield report``: write the decided ledger as a page or a paper."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import PurePath
from typing import TYPE_CHECKING

from hfield.cli.output import Sink, open_output
from hfield.cli.parser import UsageError, add_jobs, add_output, add_repeated
from hfield.cli.status import Progress
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.ledger.claim import Row

HELP = (
    "Decide a ledger and write it as one self-contained web page: a summary, filters by "
    "claim and field, each decision with its certificate, the errata, and chapters of other "
    "packages. A file name that ends in .tex gives a paper for LaTeX instead. Exit status: "
    "as for `hfield verify`."
)
EXAMPLES = (
    "hfield report -o report.html",
    "hfield report -o raport.html --lang pl",
    "hfield report sheet.toml -o sheet.tex",
)
SUFFIXES = (".html", ".htm", ".tex")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument("ledgers", nargs="*", metavar="FILE.toml", help="ledgers of your own")
    parser.add_argument("--section", metavar="S", help="only claims of this section, such as 1.3.1")
    add_repeated(parser, "--field", "F", "only these fields, as for `verify`")
    parser.add_argument(
        "--lang", choices=("en", "pl"), default="en", help="language of the page (default: en)"
    )
    parser.add_argument(
        "--chapters",
        metavar="NAME,…",
        help="chapters of other packages, such as figures,benchmark,top; or all, or none (default: all "
        "for the thesis, none for your own ledger)",
    )
    add_jobs(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Decide, write, and return the exit status."""
    from hfield.core.executors import open_executor
    from hfield.ledger.columns import split_columns
    from hfield.ledger.document import read_ledgers, read_title
    from hfield.ledger.registry import claims
    from hfield.ledger.run import as_expected, decide_rows
    from hfield.ledger.selection import in_section, rows_to_decide

    suffix = PurePath(args.output or "").suffix.lower()
    if suffix not in SUFFIXES:
        found = "none" if not args.output else shorten(args.output)
        raise UsageError(f"expected -o FILE.html or -o FILE.tex, found {found}")
    ledger = read_ledgers(args.ledgers) if args.ledgers else claims()
    chosen = ledger if args.section is None else in_section(args.section, ledger)
    pieces = rows_to_decide(chosen, split_columns(args.field))
    wanted = _chapters(args)
    title = ", ".join(map(read_title, args.ledgers)) or None
    with open_output(args.output) as out:
        with open_executor(args.jobs) as executor, Progress("rows") as progress:
            rows = decide_rows(pieces, executor, progress)
        if suffix == ".tex":
            from hfield.report.paper import paper

            out.write(paper(rows, args.lang, title))
        else:
            _write_page(out, rows, args.lang, wanted, title)
    return int(not as_expected(rows))


def _write_page(
    out: Sink, rows: list[Row], language: str, wanted: list[str], title: str | None
) -> None:
    from hfield.report.chapters import chapters
    from hfield.report.page import Certificates, page

    with Progress("rows") as progress:
        certificates = Certificates(rows, progress)
    with Progress("chapters") as progress:
        made = chapters(wanted, language, progress)
    out.write(page(rows, certificates, language, made, title))


def _chapters(args: Namespace) -> list[str]:
    """Return the names of the chapters that are wanted. Raises :class:`ChapterError`."""
    from hfield.report.chapters import names, require

    requested = args.chapters or ("none" if args.ledgers else "all")
    if requested in ("all", "none"):
        return names() if requested == "all" else []
    wanted = list(dict.fromkeys(word.strip() for word in requested.split(",") if word.strip()))
    require(wanted)
    return wanted
