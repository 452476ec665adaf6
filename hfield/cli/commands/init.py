"""``hfield init``: write a small commented ledger to begin with."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from importlib.resources import files
from pathlib import Path

from hfield.cli.output import note, open_output
from hfield.cli.parser import UsageError
from hfield.errors import shorten

HELP = (
    "Write a small commented ledger, which `hfield verify` can decide, as a start for your "
    "own. An existing file is not replaced."
)
EXAMPLES = ("hfield init sheet.toml", "hfield init week-3.toml")


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "file", metavar="FILE", help="the new ledger, such as sheet.toml; - writes to the terminal"
    )


def run(args: Namespace) -> int:
    """Write the ledger, unless the file exists."""
    if args.file not in ("-", "") and Path(args.file).exists():
        raise UsageError(
            f"{shorten(args.file)!r} exists already and was not changed: name another file"
        )
    name = "sheet.toml" if args.file == "-" else args.file
    ledger = (files("hfield.cli.commands") / "init.toml").read_text(encoding="utf-8")
    with open_output(args.file) as out:
        out.write(
            ledger.replace("sheet.toml", name).replace(
                "sheet.html", str(Path(name).with_suffix(".html"))
            )
        )
    if args.file != "-":
        note(f"wrote {args.file}; `hfield verify {args.file}` decides it")
    return 0
