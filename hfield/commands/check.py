"""``hfield check``: re-check certificates, and say what each of them establishes."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Sequence
from pathlib import Path

from hfield.certificates.check import Established, Pin, check_text
from hfield.certificates.json_text import MAX_BYTES
from hfield.certificates.rejection import Rejected, one_line
from hfield.commands.many import LINES, Lines, add_inputs, check_given, texts
from hfield.commands.output import open_output
from hfield.commands.parser import UsageError, add_output
from hfield.commands.second_judge import FLAG_HELP, Verdict, coq_verdicts, exit_status
from hfield.errors import HFieldError, shorten

HELP = (
    "Check certificates by a program that shares nothing with the prover, and say what each one "
    "establishes: the whole statement, each theorem that it cites, each assumption it makes. With "
    "--claim or --statement a certificate of anything else is rejected; a statement without --field is "
    "one about all fields. Exit status: 0 all accepted, 1 some rejected, 3 some accepted under an "
    "assumption only that --allow-assumptions does not allow, 2 bad usage or a file that cannot be read."
)
DOING = "checking"
EXAMPLES = (
    "hfield check anisotropic.json",
    "hfield check --statement 'norm(q) == 0 => q == 0' --field Q anisotropic.json",
    "hfield check *.json --coq",
)
MANY = ".jsonl"  # a file of many, one a line
COLUMNS = (
    *("file", "accepted", "statement", "algebra", "field", "verdict", "scope"),
    *("theorems", "assumptions", "vacuous", "reason"),
)
UNIVERSAL = ("universal", "-")
ASSUMING = 3  # the exit status where an assumption is left


class UnreadableError(HFieldError, OSError):
    """A file that cannot be read."""


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(
        parser, "FILE", f"certificates, hfield-cert/1; in a {MANY} one a line", "plain", "json"
    )
    parser.add_argument("--claim", metavar="ID", help="they must be of this claim, such as C1.2-a")
    parser.add_argument("--statement", metavar="S", help="they must be of this statement")
    parser.add_argument(
        "--given",
        action="append",
        default=[],
        metavar="H",
        help="with these hypotheses in front of S",
    )
    parser.add_argument("--field", metavar="F", help="over this field (or `universal`)")
    parser.add_argument("--algebra", metavar="A", help="in this algebra (default: H)")
    parser.add_argument(
        "--allow-assumptions",
        action="store_true",
        help="exit with 0 also where a certificate assumes what it does not prove",
    )
    parser.add_argument("--coq", action="store_true", help=FLAG_HELP)
    add_output(parser)


def run(args: Namespace) -> int:
    """Check every file, report, and return the exit status."""
    pin = _pin(args)
    check_given(args)
    names = list(texts(args))
    if args.coq and any(name.endswith(MANY) for name in names):
        raise UsageError(f"--coq takes files of one certificate each, no {MANY}")
    outcomes = [found for name in names for found in _checked(name, pin)]
    accepted = [name for name, outcome in outcomes if isinstance(outcome, Established)]
    coq = coq_verdicts(accepted) if args.coq else {}
    with open_output(args.output) as out:
        results = [_json(name, outcome, coq.get(name)) for name, outcome in outcomes]
        if args.format in LINES:
            lines = Lines(out, args.format, COLUMNS)
            for result in results:
                lines.write(result)
        elif args.format == "json":
            out.write_json({"schema": "hfield-check/1", "results": results})
        else:
            told = (_told(name, outcome, coq.get(name)) for name, outcome in outcomes)
            out.write_lines([line for each in told for line in each], "    ")
    return exit_status(coq, _exit_status(outcomes, args.allow_assumptions))


def _exit_status(outcomes: Sequence[tuple[str, Outcome]], allow_assumptions: bool) -> int:
    if any(isinstance(outcome, UnreadableError) for _, outcome in outcomes):
        return 2
    if any(isinstance(outcome, Rejected) for _, outcome in outcomes):
        return 1
    assuming = any(isinstance(x, Established) and x.assumptions for _, x in outcomes)
    return ASSUMING if assuming and not allow_assumptions else 0


Outcome = Established | Rejected | UnreadableError


def _checked(name: str, pin: Pin | None) -> Iterator[tuple[str, Outcome]]:
    """Yield a file, or each line of one that has many, with what came out."""
    try:
        with Path(name).open("rb") as stream:
            if not name.endswith(MANY):
                yield name, _check(stream.read(MAX_BYTES + 1), pin)
                return
            lines = iter(lambda: stream.readline(MAX_BYTES + 1), b"")
            for number, line in enumerate(lines, 1):
                if line.strip():
                    yield f"{name}:{number}", _check(line, pin)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        yield name, UnreadableError(f"cannot read {shorten(name)!r}: {reason}")


def _check(content: bytes, pin: Pin | None) -> Outcome:
    try:
        return check_text(_decoded(content), pin)
    except Rejected as error:
        return error


def _decoded(content: bytes) -> str:
    if len(content) > MAX_BYTES:
        raise Rejected(f"the file is larger than {MAX_BYTES} bytes")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        raise Rejected("the file is not text in UTF-8") from None


def _pin(args: Namespace) -> Pin | None:
    """Return what the certificates have to be about. Raises :class:`HFieldError` for bad usage."""
    if args.claim is not None and (args.statement is not None or args.algebra is not None):
        raise UsageError("--claim names the statement and the algebra; give one or the other")
    everywhere = args.field is not None and args.field.strip().lower() in UNIVERSAL
    if args.claim is not None:
        from hfield.ledger.findings import Computed
        from hfield.ledger.registry import find
        from hfield.rings import ring

        claim = find(args.claim)
        if not claim.checkable:
            raise UsageError(f"{claim.id} is no claim that a program can check: {claim.note}")
        propositions = [
            p
            for p in (claim.as_printed, claim.corrected)
            if p is not None and not isinstance(p, Computed)
        ]
        if not propositions:
            raise UsageError(
                f"{claim.id} is decided by running something, and has no certificate; "
                f"`hfield explain {claim.id}` runs it again"
            )
        field = None if args.field is None or everywhere else ring(args.field).name
        statements = tuple(p.statement for p in propositions)
        return Pin(statements, field, any_field=args.field is None)
    if args.statement is None:
        if args.field is not None or args.algebra is not None or args.given:
            raise UsageError(
                "--given, --field and --algebra go with --statement, or --field with --claim"
            )
        return None
    from hfield.proving.statements.setting import read_setting

    setting = read_setting(None if everywhere else args.field, args.algebra)
    name = None if setting.field is None else setting.field.name
    from hfield.syntax import plain

    statement = plain(args.statement)
    if args.given:
        statement = " => ".join(f"({plain(text)})" for text in (*args.given, statement))
    try:
        return Pin((statement,), name, setting.algebra).readable()
    except Rejected as error:
        raise UsageError(f"--statement: {error}") from None


def _told(name: str, outcome: Outcome, coq: Verdict | None) -> list[str]:
    """Return the lines on a file, those after the first set in."""
    if isinstance(outcome, Established):
        first, *rest = [*outcome.lines(), *([str(coq)] if coq else [])]
        return [f"{one_line(name)}: {first}", *(f"  {line}" for line in rest)]
    word = "rejected: " if isinstance(outcome, Rejected) else ""
    return [f"{one_line(name)}: {word}{' '.join(str(outcome).split())}"]


def _json(name: str, outcome: Outcome, coq: Verdict | None) -> dict[str, object]:
    if not isinstance(outcome, Established):
        return {"file": name, "accepted": False, "reason": str(outcome)}
    return {
        "file": name,
        "accepted": True,
        "statement": outcome.statement,
        "algebra": outcome.algebra,
        "field": outcome.field,
        "verdict": outcome.verdict,
        "scope": outcome.scope,
        "assumes": list(outcome.assumes),
        "theorems": list(outcome.theorems),
        "assumptions": list(outcome.assumptions),
        "vacuous": list(outcome.vacuous),
        **({"coq": {"verdict": coq.word, "reason": coq.reason}} if coq else {}),
    }
