"""``hfield verify``: decide claims over fields and report the results."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from hfield.cli.answer_formats import OutputDocument
from hfield.cli.output import note, open_output, writing
from hfield.cli.parser import (
    UsageError,
    add_format,
    add_jobs,
    add_output,
    add_repeated,
    add_standalone,
)
from hfield.cli.status import Progress
from hfield.errors import shorten

if TYPE_CHECKING:
    from hfield.ledger.claim import Claim, Row

HELP = (
    "Decide every claim of the thesis, or of your own ledger FILE.toml (docs/how-to/ledgers.md), "
    "over a panel of fields. A claim that is refuted as printed is decided once more as "
    "corrected. The last line says whether all is as expected. Exit status: 0 all is as "
    "expected; 1 a row is undecided, or two rows contradict each other; 2 bad usage."
)
OTHER_FILES = (".json", ".yaml", ".yml", ".txt", ".csv", ".md")
EXAMPLES = (
    "hfield verify",
    "hfield verify --section 1.3.1 --field QQ,GF9",
    "hfield verify sheet.toml --jobs 2 --format markdown",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "claims",
        nargs="*",
        metavar="CLAIM",
        help="id or name of a claim, such as C1.2-a or centre, or a ledger FILE.toml",
    )
    add_repeated(
        parser,
        "--field",
        "F",
        "a field, such as GF9, Q or 'QQ(sqrt(2))'; `universal` for every ring at once; `-` for claims "
        "about no field. Repeat the option, or separate fields by commas",
    )
    parser.add_argument("--section", metavar="S", help="only claims of this section, such as 1.3.1")
    parser.add_argument("--all", action="store_true", help="also list every row")
    add_format(parser, "table", "json", "markdown", "latex")
    add_standalone(parser)
    add_jobs(parser, "use the Dask cluster at tcp://HOST:PORT")
    parser.add_argument(
        "--certificates", metavar="DIR", help="write a certificate for every decided row to DIR"
    )
    add_output(parser)


def run(args: Namespace) -> int:
    """Decide, report, and return the exit status."""
    from hfield.core.executors import collecting_rarely

    with collecting_rarely():
        return _verify(args)


def _verify(args: Namespace) -> int:
    """Read the claims and fields, decide them and report."""
    from hfield.core.executors import open_executor
    from hfield.ledger.columns import split_columns
    from hfield.ledger.registry import find
    from hfield.ledger.run import as_expected, contradictions, decide_rows
    from hfield.ledger.selection import in_section, rows_to_decide

    ledger, names = _ledger(args.claims)
    named = [find(name, ledger) for name in names]
    section = [] if args.section is None else in_section(args.section, ledger)
    chosen = list(dict.fromkeys([*named, *section]))
    fields = split_columns(args.field)
    pieces = rows_to_decide(chosen or ledger, fields, strict=bool(named) and not section)
    own = len(names) < len(args.claims)
    _remark(fields)
    with open_output(args.output) as out:
        with open_executor(args.jobs, args.dask) as executor, Progress("rows") as progress:
            rows = decide_rows(pieces, executor, progress)
        paths = _certificates(rows, args.certificates)
        _answer(rows, paths, args.all, own or bool(chosen)).write(out, args)
    for clash in contradictions(rows) if args.format == "json" else ():
        note(f"contradiction: {clash}")
    return int(not as_expected(rows))


def _answer(
    rows: Sequence[Row], paths: Mapping[tuple[str, str], str], everything: bool, chosen: bool
) -> OutputDocument:
    from hfield import __version__
    from hfield.ledger.report import report

    def data() -> dict[str, object]:
        results = [row.to_json(paths.get((row.claim.id, row.field))) for row in rows]
        return {"schema": "hfield-verify/1", "version": __version__, "results": results}

    def markdown() -> str:
        from hfield.ledger import markdown

        return markdown.markdown(rows, everything=everything)

    def latex() -> str:
        from hfield.ledger import paper

        return paper.report(rows, everything=everything)

    return OutputDocument(
        data,
        lambda style: report(rows, style, chosen=chosen, everything=everything),
        {"markdown": markdown, "latex": latex},
    )


def _ledger(arguments: Sequence[str]) -> tuple[Sequence[Claim], list[str]]:
    """Return the claims of the named files, or of the ledger, and the other arguments."""
    from hfield.ledger.document import read_ledgers
    from hfield.ledger.registry import claims

    paths = [text for text in arguments if text.lower().endswith(".toml")]
    names = [text for text in arguments if text not in paths]
    for text in names:
        if text.lower().endswith(OTHER_FILES):
            raise UsageError(
                f"{shorten(text)!r} is not a ledger: verify reads ledgers in files FILE.toml, and "
                "hfield check reads certificates in files FILE.json"
            )
    return (read_ledgers(paths) if paths else claims()), names


def _certificates(rows: Sequence[Row], directory: str | None) -> dict[tuple[str, str], str]:
    """Write the certificates if requested; return their paths by claim and field."""
    if directory is None:
        return {}
    from pathlib import Path

    from hfield.ledger.certificate import write_certificates

    with writing(f"certificates to {shorten(directory)!r}", "directory"):
        return write_certificates(rows, Path(directory))


def _remark(fields: list[str]) -> None:
    """Return a remark on verdicts over a ring that is not an exact field."""
    from hfield.fields.names import ring
    from hfield.ledger.claim import NO_FIELD, UNIVERSAL

    for name in fields:
        if name in (UNIVERSAL, NO_FIELD):
            continue
        F = ring(name)
        if not F.is_exact:
            note(f"{name} is inexact: floats give evidence, never a proof")
        elif not F.is_field:
            note(f"{name} is not a field; the claims are read over this ring as they stand")
