"""Run one command on many inputs: arguments, lines of a file, or standard input."""

from __future__ import annotations

import io
import json
import re
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import nullcontext

from hfield.cli.answer_formats import OutputDocument
from hfield.cli.output import Sink, encodable, note, open_output
from hfield.cli.parser import UsageError, add_format
from hfield.errors import HFieldError, shorten

_SIGN = re.compile(r"[+*/^=<>!]+")
LINES = ("jsonl", "csv")  # the formats that write an answer a line
WORST = (0, 1, 3, 2)  # exit statuses; a later one overrides an earlier one


def add_inputs(parser: ArgumentParser, metavar: str, help: str, *formats: str) -> None:
    """Declare the inputs, ``--from`` and ``--format``."""
    parser.add_argument(
        "inputs", nargs="*", metavar=metavar, help=f"{help}; several, or - for standard input"
    )
    parser.add_argument(
        "--from",
        dest="source",
        metavar="FILE",
        help="also read FILE, one input per line; blank lines and # comments are skipped",
    )
    add_format(parser, *formats, *LINES)
    parser.set_defaults(wanted=metavar)


def answer_all(
    args: Namespace,
    answer: Callable[[str], OutputDocument],
    columns: Sequence[str],
    apart: bool = True,
) -> int:
    """Answer each input in turn and return the largest exit status.

    The first of ``columns``, the JSON keys that ``--format csv`` writes, names the input. The errors of a
    single input are raised. With several inputs an error becomes an answer with status 2, and the remaining
    inputs are answered. If ``apart``, answers are separated by an empty line. Raises :class:`UsageError` if
    there is no input.
    """
    check_given(args)
    with open_output(args.output) as out:
        if len(args.inputs) == 1 and args.inputs != ["-"] and args.source is None:
            found = answer(args.inputs[0])
            if args.format in LINES:
                Lines(out, args.format, columns).write(found.data())
            else:
                found.write(out, args)
            return found.status
        if args.format not in (*LINES, "plain", "unicode", "latex"):
            raise UsageError(
                f"--format {args.format} shows a single answer; use jsonl or csv for several"
            )
        return _answer_many(out, args, answer, columns, apart)


def check_given(args: Namespace) -> None:
    """Raise :class:`UsageError` if there is no input, or if the shell has split an unquoted one."""
    if any(_SIGN.fullmatch(word) for word in args.inputs):
        whole = " ".join(args.inputs)
        raise UsageError(
            f"the shell has split the input at its blanks: quote it, as in '{shorten(whole)}'"
        )
    if not args.inputs and args.source is None:
        raise UsageError(f"expected {args.wanted}, --from FILE, or - for standard input")


def _answer_many(
    out: Sink,
    args: Namespace,
    answer: Callable[[str], OutputDocument],
    columns: Sequence[str],
    apart: bool,
) -> int:
    lines = Lines(out, args.format, columns) if args.format in LINES else None
    worst, first = 0, True
    for text in texts(args):
        if lines is None and apart and not first:
            out.write("")
        try:
            found = answer(text)
            if lines is not None:
                lines.write(found.data())
            else:
                found.write(out, args)
            status = found.status
        except HFieldError as error:
            status, message = 2, " ".join(str(error).split())
            if lines is not None:
                lines.write({columns[0]: text, "error": message})
            else:
                line = f"hfield: error: {shorten(' '.join(text.split()))}: {message}"
                print(encodable(line, sys.stderr), file=sys.stderr)
        first = False
        worst = max(worst, status, key=WORST.index)
        out.stream.flush()
    return worst


def texts(args: Namespace) -> Iterator[str]:
    """Yield the inputs in order, reading files lazily. Raises :class:`UsageError`."""
    for word in args.inputs:
        yield from _lines_of(word) if word == "-" else (word,)
    if args.source is not None:
        yield from _lines_of(args.source)


def _lines_of(name: str) -> Iterator[str]:
    found = False
    try:
        with nullcontext(sys.stdin) if name == "-" else open(name, encoding="utf-8-sig") as stream:
            for line in stream:
                text = line.strip()
                if text and not text.startswith("#"):
                    found = True
                    yield text
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"cannot read {shorten(name)!r}: {reason}") from error
    if not found:
        note(f"{'standard input' if name == '-' else shorten(name)} has no inputs")


class Lines:
    """Writes answers as JSON lines, or as CSV with a header."""

    def __init__(self, out: Sink, format: str, columns: Sequence[str]) -> None:
        self.out, self.format, self.columns = (out, format, columns)
        if format == "csv":
            self._row(self.columns)

    def write(self, data: Mapping[str, object]) -> None:
        """Write one answer."""
        if self.format == "csv":
            self._row([_cell(data.get(name)) for name in self.columns])
        else:
            self.out.write(json.dumps(data, ensure_ascii=False))

    def _row(self, cells: Sequence[str]) -> None:
        import csv

        text = io.StringIO()
        csv.writer(text, lineterminator="").writerow(cells)
        self.out.write(text.getvalue())


def _cell(value: object) -> str:
    """Format a CSV cell: empty for None, a list of texts joined by blanks, anything else as JSON."""
    if value is None or isinstance(value, str):
        return value or ""
    if isinstance(value, list) and all(isinstance(x, str | int) for x in value):
        return " ".join(map(str, value))
    return json.dumps(value, ensure_ascii=False)
