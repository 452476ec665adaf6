"""``hfield export``: write certificates and theorems as a file for Coq."""

from __future__ import annotations

import json
import re
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from hfield.cli.output import encodable, note, open_output
from hfield.cli.parser import UsageError, add_repeated
from hfield.cli.status import Progress, Waiting
from hfield.errors import shorten

HELP = (
    "Write what is proved for every field as theorems for Coq or Lean: the ledger, your own "
    "statements, or certificates. The theorem of a certificate is its statement, and its "
    "proof is the evidence. Coq and Lean are not needed for writing; `coqc FILE` or `lean "
    "FILE` checks the file. Exit status: 0 everything named is in the file; 1 something is "
    "not; 2 bad usage."
)
DOING = "writing theorems"
EXAMPLES = ("hfield export --coq theorems.v",)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    parser.add_argument(
        "--coq", metavar="FILE", help="write theorems for Coq to FILE; - writes to the terminal"
    )
    parser.add_argument(
        "--lean",
        metavar="FILE",
        help="write theorems for Lean 4 to FILE: those that hold over every commutative ring",
    )
    add_repeated(
        parser,
        "--statement",
        "S",
        "add a statement that is proved for every field; may be repeated",
    )
    parser.add_argument(
        "--algebra", metavar="A", help="the algebra of the statements, such as '(a,b|F)'"
    )
    add_repeated(
        parser, "--claim", "ID", "only this claim of the ledger, by id or name; may be repeated"
    )
    parser.add_argument(
        "--certificate",
        nargs="+",
        action="extend",
        default=[],
        metavar="CERT",
        help="write the theorems of these certificates, and of the ledger only the claims of --claim",
    )


def run(args: Namespace) -> int:
    """Write the file; report the number of theorems and what was omitted."""
    from hfield.export.coq.export import Export, export_certificates, export_statements
    from hfield.export.coq.ledger import export_ledger
    from hfield.ledger.registry import find

    if args.lean:
        return _lean(args)
    if not args.coq:
        raise UsageError("expected --coq FILE or --lean FILE, the file to write")
    if args.algebra is not None and not args.statement:
        raise UsageError("--algebra is about statements: add --statement S")
    chosen = list(dict.fromkeys(find(name) for name in args.claim))
    certificates = _certificates(args.certificate)
    with open_output(args.coq) as out:
        own = export_certificates(certificates) + export_statements(args.statement, args.algebra)
        ledger = Export(())
        if chosen or not certificates:
            with Progress("claims") as progress:
                ledger = export_ledger(chosen, progress)
        whole = ledger + own
        out.write(whole.text)
    named = own.left if not chosen else whole.left
    for left in whole.left:
        note(f"not exported: {left.name}, {left.text}: {left.reason}")
    found, kept = len(whole.theorems), len(whole.names) - len(whole.theorems)
    summary = (
        f"{found} theorem{'s' * (found != 1)} exported and {kept} proved by hand, "
        f"{len(whole.left)} not exported"
    )
    _summarise(args.coq, summary)
    return int(bool(named))


def _summarise(file: str, summary: str) -> None:
    """Report the file that was written, on stderr if the output is stdout."""
    if file == "-":
        note(summary)
    else:
        print(encodable(f"{file}: {summary}", sys.stdout))


def _lean(args: Namespace) -> int:
    """Write a file for Lean; report the number of theorems and what was omitted."""
    from hfield.export.lean import lean_file, lean_theorems
    from hfield.prover.prove import prove

    if args.coq or args.claim or not (args.certificate or args.statement):
        raise UsageError("--lean FILE takes --certificate CERT or --statement S, and no --coq")
    certificates = _certificates(args.certificate)
    for number, text in enumerate(args.statement, 1):
        Waiting.at(f"proving {text}")
        certificates[f"statement_{number}"] = prove(text, algebra=args.algebra).certificate
    with open_output(args.lean) as out:
        theorems, left = lean_theorems(certificates)
        out.write(lean_file(theorems))
    for name, reason in left.items():
        note(f"not exported: {name}: {reason}")
    summary = (
        f"{len(theorems)} theorem{'s' * (len(theorems) != 1)} exported, {len(left)} not exported"
    )
    _summarise(args.lean, summary)
    return int(bool(left))


def _certificates(files: list[str]) -> dict[str, object]:
    """Read certificates, by theorem name. Raises UsageError for a file that is not JSON."""
    out: dict[str, object] = {}
    for file in files:
        base = name = "certificate_" + re.sub(r"[^0-9A-Za-z]+", "_", Path(file).stem)
        number = 1
        while name in out:
            number += 1
            name = f"{base}_{number}"
        try:
            out[name] = json.loads(Path(file).read_text(encoding="utf-8"))
        except (OSError, ValueError, RecursionError) as error:
            raise UsageError(f"--certificate {shorten(file)}: {shorten(str(error))}") from error
    return out
