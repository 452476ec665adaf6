"""``hfield prove``: prove or refute a statement."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial

from hfield.cli.answer_formats import OutputDocument
from hfield.cli.batch import add_inputs, answer_all
from hfield.cli.output import note, open_output
from hfield.cli.parser import UsageError, add_output, add_repeated, add_standalone, seconds
from hfield.cli.status import Waiting

HELP = (
    "Prove or refute a statement about quaternions p q r u v w and scalars s t x y z, such "
    "as 'norm(q) != 0 => q*inv(q) == e'. Without --field the statement is about every "
    "field, or every ordered field where it has abs, >= or <. "
    "Exit status: 0 proved or vacuous; 1 refuted; 3 undecided; 2 bad usage."
)
DOING = "proving"
EXAMPLES = (
    "hfield prove 'p*q == q*p' --field GF4",
    "hfield prove 'norm(q) == 0 => q == 0' --field 'QQ(sqrt(-7))' --certificate anisotropic.json",
    "hfield prove 'i*j == k' --relations 'i*i == j*j == k*k == i*j*k == -1'",
    "hfield prove 'dot(p,q)**2 <= norm(p)*norm(q)' --certificate cauchy-schwarz.json",
    "hfield prove --from statements.txt --format csv",
)
COLUMNS = (
    "statement",
    "algebra",
    "field",
    "verdict",
    "scope",
    "method",
    "witness",
    "assumes",
    "error",
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    add_inputs(parser, "STATEMENT", "the statement, in quotes", "plain", "json", "latex")
    parser.add_argument("--field", metavar="F", help="the field, such as GF(9) or QQ(sqrt(2))")
    parser.add_argument(
        "--algebra",
        metavar="A",
        help="the algebra, such as '(-1,-3|QQ)' or '(a,b|F)', or a discriminant such as 6 (default: H)",
    )
    add_repeated(parser, "--given", "H", "assume H; may be repeated")
    add_repeated(
        parser,
        "--relations",
        "R",
        "ask what follows in every ring with identity whose elements i, j, k satisfy R, such as "
        "'i*i == j*j == -1'; may be repeated",
    )
    parser.add_argument(
        "--timeout",
        type=seconds,
        default=30.0,
        metavar="S",
        help="time limit in seconds of processor time (default: 30)",
    )
    parser.add_argument("--certificate", metavar="FILE", help="write the certificate to FILE")
    add_standalone(parser)
    add_output(parser)


def run(args: Namespace) -> int:
    """Decide the statements, show the decisions, return the exit status."""
    if args.certificate is not None and (len(args.inputs) != 1 or args.source is not None):
        raise UsageError("--certificate FILE takes one certificate: give one statement")
    return answer_all(args, partial(_decide, args), COLUMNS)


def _decide(args: Namespace, statement: str) -> OutputDocument:
    from hfield.ledger.decision_lines import decision_text
    from hfield.prover.prove import prove

    Waiting.at(f"proving {statement}")
    with open_output(args.certificate) as file:
        where = (args.field, args.given, args.algebra, args.timeout, args.relations)
        answer = prove(statement, *where)
        certificate = answer.certificate if args.certificate is not None else None
        if certificate is not None:
            file.write_json(certificate)
        elif args.certificate is not None:
            note(f"no certificate is written: {answer.why_no_certificate}")
    path = None if certificate is None else args.certificate
    said = {} if args.given or args.relations else {"statement": statement}
    shown, inside, field = (answer.text, answer.decision), answer.setting.algebra, answer.field

    def latex() -> str:
        from hfield.ledger.claim import UNIVERSAL
        from hfield.ledger.paper import decision

        return decision(*shown, field or UNIVERSAL, inside)

    return OutputDocument(
        lambda: answer.to_json(path) | said,
        lambda style: decision_text(*shown, inside, field, style),
        {"latex": latex},
        answer.exit_status,
    )
