"""``hfield check``: check certificates and print what each establishes."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from hfield.checker.budget import MILLIONS, Budget, bounded
from hfield.checker.check import Established, ExpectedClaim, check
from hfield.checker.json_text import MAX_BYTES, read_json
from hfield.checker.rejection import Rejected, one_line
from hfield.cli.batch import LINES, Lines, add_inputs, check_given, texts
from hfield.cli.commands.check_with_coq import CoqVerdict, Judge, add_coq, exit_status, judge_by_coq
from hfield.cli.output import note, open_output
from hfield.cli.parser import UsageError, add_output, add_repeated, positive
from hfield.errors import HFieldError, shorten

if TYPE_CHECKING:
    pass


HELP = (
    "Check certificates with a program that is independent of the prover. For each one it "
    "prints the statement, the theorems cited and the assumptions made. With --claim or "
    "--statement, certificates of anything else are rejected. A --statement without --field "
    "is about every field. Exit status: 0 all accepted; 1 some rejected; 2 bad usage or an "
    "unreadable file; 3 some accepted only under an assumption, without "
    "--allow-assumptions; 4 with --coq, some that Coq did not judge."
)
DOING = "checking"
EXAMPLES = (
    "hfield check anisotropic.json",
    "hfield check --statement 'norm(q) == 0 => q == 0' --field Q anisotropic.json",
    "hfield check *.json --coq",
)
LINES_SUFFIX = ".jsonl"  # a file with one certificate per line
ABOUT = ("statement", "algebra", "field", "verdict", "scope")
LISTS = ("assumes", "theorems", "assumptions", "vacuous", "left_out", "rings")
COLUMNS = ("file", "accepted", *ABOUT, *LISTS[1:], "reason")
UNIVERSAL = ("universal", "-")
ASSUMING = 3  # the exit status if an assumption remains


class UnreadableError(HFieldError, OSError):
    """A file that cannot be read."""


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(
        parser,
        "FILE",
        f"certificates (hfield-cert/2); a {LINES_SUFFIX} file has one per line",
        "plain",
        "json",
    )
    parser.add_argument(
        "--claim", metavar="ID", help="require certificates of this claim, such as C1.2-a"
    )
    parser.add_argument("--statement", metavar="S", help="require certificates of this statement")
    add_repeated(parser, "--given", "H", "add a hypothesis to S; may be repeated")
    parser.add_argument(
        "--field", metavar="F", help="the field of the required claim or statement, or `universal`"
    )
    parser.add_argument(
        "--algebra", metavar="A", help="the algebra of the required statement (default: H)"
    )
    parser.add_argument(
        "--allow-assumptions",
        action="store_true",
        help="exit with 0 even if a certificate rests on assumptions",
    )
    parser.add_argument(
        "--work",
        type=positive(1e9, "positive number"),
        default=float(MILLIONS),
        metavar="N",
        help="limit for one file, in millions of units of work; a unit takes at most a microsecond and "
        f"100 bytes (default: {MILLIONS})",
    )
    add_coq(parser)
    add_output(parser)


Outcome = Established | Rejected | UnreadableError


@dataclass(frozen=True)
class Checked:
    """The result of checking one certificate, and Coq's verdict on an accepted one."""

    name: str
    outcome: Outcome
    coq: CoqVerdict | None = None


def run(args: Namespace) -> int:
    """Check every file, report, and return the exit status."""
    expected = _expected(args)
    if expected is not None:
        note(_in_words(expected, args.claim))
    check_given(args)
    names = list(texts(args))
    with judge_by_coq(args) if args.coq else nullcontext() as judge:
        checked = [each for name in names for each in _checked(name, expected, judge, args.work)]
    with open_output(args.output) as out:
        results = [_json(each) for each in checked]
        if args.format in LINES:
            lines = Lines(out, args.format, (*COLUMNS, "coq") if args.coq else COLUMNS)
            for result in results:
                lines.write(result)
        elif args.format == "json":
            out.write_json({"schema": "hfield-check/1", "results": results})
        else:
            out.write_lines([line for each in checked for line in _told(each)], "    ")
    status = _exit_status([each.outcome for each in checked], args.allow_assumptions)
    return exit_status([each.coq for each in checked], status)


def _exit_status(outcomes: Sequence[Outcome], allow_assumptions: bool) -> int:
    if any(isinstance(outcome, UnreadableError) for outcome in outcomes):
        return 2
    if any(isinstance(outcome, Rejected) for outcome in outcomes):
        return 1
    assuming = any(isinstance(x, Established) and x.assumptions for x in outcomes)
    return ASSUMING if assuming and not allow_assumptions else 0


def _checked(
    name: str, expected: ExpectedClaim | None, judge: Judge | None, work: float
) -> Iterator[Checked]:
    """Yield the result for a file, or for each line of a file with many certificates."""
    for each, content in _contents(name):
        if isinstance(content, UnreadableError):
            yield Checked(each, content)
        else:
            yield _check(each, content, expected, judge, work)


def _contents(name: str) -> Iterator[tuple[str, bytes | UnreadableError]]:
    """Open a file once, and yield its certificate, or one certificate per line, with names."""
    try:
        with Path(name).open("rb") as stream:
            if not name.endswith(LINES_SUFFIX):
                yield name, stream.read(MAX_BYTES + 1)
                return
            lines = iter(lambda: stream.readline(MAX_BYTES + 1), b"")
            for number, line in enumerate(lines, 1):
                if line.strip():
                    yield f"{name}:{number}", line
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        yield name, UnreadableError(f"cannot read {shorten(name)!r}: {reason}")


def _check(
    name: str, content: bytes, expected: ExpectedClaim | None, judge: Judge | None, work: float
) -> Checked:
    """Check the data that was read, and pass the same data to Coq."""
    most = Budget(work)
    try:
        with bounded(most):
            data = read_json(_decoded(content))
        found = check(data, expected, most)
    except Rejected as error:
        return Checked(name, error)
    return Checked(name, found, judge(name, found, data) if judge else None)


def _decoded(content: bytes) -> str:
    if len(content) > MAX_BYTES:
        raise Rejected(f"the file is larger than {MAX_BYTES} bytes")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        raise Rejected("the file is not UTF-8 text") from None


def _expected(args: Namespace) -> ExpectedClaim | None:
    """Return the claim that the certificates must establish. Raises :class:`HFieldError` for bad usage."""
    if args.claim is not None and (args.statement is not None or args.algebra is not None):
        raise UsageError("--claim names the statement and the algebra; give one or the other")
    everywhere = args.field is not None and args.field.strip().lower() in UNIVERSAL
    if args.claim is not None:
        from hfield.fields.names import ring
        from hfield.ledger.claim import Computed
        from hfield.ledger.registry import find

        claim = find(args.claim)
        if not claim.checkable:
            raise UsageError(f"{claim.id} is not a claim that a program can check: {claim.note}")
        propositions = [
            p
            for p in (claim.as_printed, claim.corrected)
            if p is not None and not isinstance(p, Computed)
        ]
        if not propositions:
            raise UsageError(
                f"{claim.id} is decided by a computation and has no certificate; `hfield explain {claim.id}` "
                "runs it again"
            )
        field = None if args.field is None or everywhere else ring(args.field).name
        statements = tuple(p.statement for p in propositions)
        return ExpectedClaim(statements, field, any_field=args.field is None, claim=True)
    if args.statement is None:
        if args.field is not None or args.algebra is not None or args.given:
            raise UsageError(
                "--given, --field and --algebra go with --statement, or --field with --claim"
            )
        return None
    from hfield.prover.statements.language import statement_words
    from hfield.prover.statements.setting import read_setting
    from hfield.syntax import Typed, spell

    setting = read_setting(None if everywhere else args.field, args.algebra)
    name = None if setting.field is None else setting.field.name
    words = statement_words(setting.field, setting.letters, setting.table)
    statement = Typed.implication([spell(x, words) for x in (*args.given, args.statement)]).text
    try:
        return ExpectedClaim((statement,), name, setting.algebra).readable()
    except Rejected as error:
        raise UsageError(f"--statement: {error}") from None


def _in_words(expected: ExpectedClaim, claim: str | None) -> str:
    """Describe the claim that the certificates must establish."""
    from hfield.fields.names import ring

    what = f"claim {claim}" if claim else one_line(expected.statements[0])
    if expected.any_field:
        return f"asked for {what} over any field: each certificate says below over which"
    where = "all fields"
    if isinstance(expected.field, str):
        where = f"{expected.field}, {ring(expected.field).in_words()}"
    return f"asked for {what} over {where}" + (
        f", in {expected.algebra}" if expected.algebra else ""
    )


def _told(each: Checked) -> list[str]:
    """Return the lines about a file; all but the first are indented."""
    outcome = each.outcome
    if isinstance(outcome, Established):
        first, *rest = [*outcome.lines(), *(each.coq.lines() if each.coq else [])]
        return [f"{one_line(each.name)}: {first}", *(f"  {line}" for line in rest)]
    word = "rejected: " if isinstance(outcome, Rejected) else ""
    return [f"{one_line(each.name)}: {word}{' '.join(str(outcome).split())}"]


def _json(each: Checked) -> dict[str, object]:
    outcome = each.outcome
    if not isinstance(outcome, Established):
        return {"file": each.name, "accepted": False, "reason": str(outcome)}
    shown = {name: getattr(outcome, name) for name in (*ABOUT, *LISTS)}
    return {
        "file": each.name,
        "accepted": True,
        **{name: list(value) if name in LISTS else value for name, value in shown.items()},
        **({"coq": each.coq.json()} if each.coq else {}),
    }
