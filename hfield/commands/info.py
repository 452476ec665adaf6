"""``hfield info``: the page about an algebra."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from functools import partial

from hfield.commands.many import add_inputs, answer_all
from hfield.commands.output import Sink
from hfield.commands.parser import UsageError, add_output, add_standalone
from hfield.commands.status import Waiting
from hfield.errors import shorten

HELP = (
    "Show what is known of an algebra: its table, centre, radical, whether it is a division algebra or "
    "split (with the isomorphism or the reason), where it ramifies, a maximal order, or counts."
)
DOING = "describing"
EXAMPLES = (
    "hfield info '(-1,-3|QQ)'",
    "hfield info 'H(GF(9))' '[1,t|GF(4)(t))'",
    "hfield info --from algebras.txt --format jsonl",
)
COLUMNS = (
    *("algebra", "field", "commutative", "central_simple", "division", "reason"),
    *("ramified_places", "discriminant", "undecided", "error"),
)


def configure(parser: ArgumentParser) -> None:
    """Declare the arguments."""
    what = "such as '(-1,-3|QQ)', '[1,t|GF(4)(t))' or 'H(GF(9))'"
    add_inputs(parser, "ALGEBRA", what, "plain", "json", "latex")
    add_standalone(parser)
    parser.add_argument(
        "--factors",
        metavar="P,…",
        help="primes of a and b (or of their norms) that you know, separated by commas",
    )
    add_output(parser)


def run(args: Namespace) -> int:
    """Ask everything, and print the pages."""
    from hfield.factorisation import known_primes

    with known_primes(_primes(args.factors), "--factors"):
        return answer_all(args, partial(_describe, args), COLUMNS)


def _describe(args: Namespace, text: str) -> tuple[int, dict[str, object], Callable[[Sink], None]]:
    from hfield.algebra import QuaternionAlgebra
    from hfield.commands.count import count_latex, count_lines, counts
    from hfield.description import info
    from hfield.description.page import page, page_latex

    Waiting.at(f"describing {text}")
    A = QuaternionAlgebra.from_text(text)
    description = info(A)
    counted = counts(A, quick=True) if A.ring.order is not None else None
    data = {**description.to_json(), "counts": counted and counted.to_json()}

    def show(out: Sink) -> None:
        if args.format == "json":
            out.write_json(data)
            return
        if args.format == "latex":
            parts = [page_latex(description), *([count_latex(counted)] if counted else [])]
            out.write_latex("\n\n".join(parts), args.standalone)
            return
        lines = page(description, out.style().width)
        if counted is not None:
            lines += ["", "Counts", *count_lines(counted)]
        out.write("\n".join(lines))

    return 0, data, show


def _primes(text: str | None) -> list[int] | None:
    """Read ``--factors``. Raises :class:`UsageError`; that they are primes is found out later."""
    if text is None:
        return None
    words = [word.strip() for word in text.split(",")]
    if not all(word.isdecimal() and word.isascii() for word in words):
        raise UsageError(f"--factors {shorten(text)!r}: expected primes such as 3,5,1000003")
    return [int(word) for word in words]
