"""``hfield init``: a small ledger to begin with, commented, that runs at once."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from hfield.commands.output import note, open_output
from hfield.commands.parser import UsageError
from hfield.errors import shorten

HELP = "Write a small ledger, commented, for `hfield verify` to decide. A file that is there stays."
EXAMPLES = ("hfield init sheet.toml", "hfield init week-3.toml")

LEDGER = """\
# A ledger: claims on quaternions, each decided over every field that it speaks of.
#   hfield verify sheet.toml                          decides it
#   hfield report sheet.toml -o sheet.html            makes a page of it
#   hfield verify sheet.toml --certificates proofs    keeps what `hfield check` re-checks
# Quaternions are p q r u v w, numbers s t x y z; e, i, j, k the basis; the language: docs/language.md.

title = "Exercises"

# A claim needs `holds` alone; it is called E1, E2, … by its place.
[[claims]]
holds = "N(p*q) = N(p)*N(q)"

# What else it may have: a name, words, fields (without them, the 17 of the thesis).
[[claims]]
id = "commuting"
statement = "The product of quaternions is commutative"
holds = "p*q = q*p"
fields = ["QQ", "GF(2)", "GF(9)", "universal"]

# A slip in print, and what was meant: `corrected` is decided where `holds` is refuted.
[[claims]]
id = "additive-norm"
statement = "The norm is additive"
holds = "N(p+q) = N(p) + N(q)"
corrected = "N(p+q) + N(p-q) = 2*N(p) + 2*N(q)"
note = "The parallelogram law is meant."

# Another algebra than Hamilton's; its field is the only column.
[[claims]]
id = "no-zero-divisors"
statement = "(-1,-3|QQ) is a division algebra"
algebra = "(-1,-3|QQ)"
holds = "p*q = 0 => p = 0 or q = 0"
"""


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "file", metavar="FILE", help="where the ledger goes, such as sheet.toml; - is the terminal"
    )


def run(args: Namespace) -> int:
    """Write the ledger, unless the file is there."""
    if args.file != "-" and Path(args.file).exists():
        raise UsageError(
            f"{shorten(args.file)!r} is there already, and stays as it is: name another file"
        )
    name = "sheet.toml" if args.file == "-" else args.file
    with open_output(args.file) as out:
        out.write(
            LEDGER.replace("sheet.toml", name).replace(
                "sheet.html", str(Path(name).with_suffix(".html"))
            )
        )
    if args.file != "-":
        note(f"wrote {args.file}; `hfield verify {args.file}` decides it")
    return 0
